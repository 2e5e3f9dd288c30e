// Extracts surfaces of 200 generated label images, maps each to the sphere, and prints a table: what must hold, and how
// far the surface is from the sides of the voxels.
//
//   bench-labels [--images N] [--files FOLDER]
//
// --files also writes each image as KIND-NUMBER.mha, for other programs.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

#include "base/error.h"
#include "base/host.h"
#include "sphere_map/sphere_map.h"
#include "tests/repair/label_images.h"

using namespace orbicube;

namespace {

struct Kind {
  const char* name;
  test::LabelVolume (*make)(base::Random&);
};

constexpr Kind kinds[] = {{"blobs", test::blob},
                          {"tubes with noise", test::ventricle},
                          {"loose voxels", test::loose_voxels},
                          {"handles of one voxel", test::handles}};

struct Row {
  std::size_t images = 0, good = 0, spheres = 0, changed = 0, voxels = 0, triangles = 0;
  double distance = 0, volume = 0, seconds = 0;
};

void write_image(const std::string& path, const test::LabelVolume& v) {
  std::ofstream file(path, std::ios::binary);
  file << "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = " << v.size[0] << ' ' << v.size[1] << ' '
       << v.size[2] << "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  for (const std::int32_t label : v.labels)
    file.put(static_cast<char>(label));
}

bool maps_to_sphere(const repair::LabelSurface& surface) {
  try {
    sphere_map::compute(surface.positions, surface.triangles, {}, base::Host());
    return true;
  } catch (const base::Error&) {
    return false;
  }
}

void run(const test::LabelVolume& v, Row& row) {
  const auto start = std::chrono::steady_clock::now();
  const repair::LabelSurface s = repair::surface_of_label(v.image(), {}, base::Host());
  row.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const repair::Certificate& c = s.report.certificate;
  ++row.images;
  row.good += c.is_solid() && c.parts == 1 && c.genus == 0 && c.self_intersections == 0;
  row.spheres += maps_to_sphere(s);
  const repair::LabelVoxels object = test::object_of(v, base::Host());
  row.distance = std::max(row.distance, test::largest_distance_from_sides(object, s));
  std::size_t voxels = 0;
  for (const std::uint8_t in : object.voxels.in)
    voxels += in;
  row.volume = std::max(row.volume, std::abs(c.volume / static_cast<double>(voxels) - 1));
  row.changed += s.report.added_voxels + s.report.removed_voxels;
  row.voxels += voxels;
  row.triangles += s.triangles.size();
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t images = 200;
  std::string folder;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--images") == 0) images = std::strtoull(argv[i + 1], nullptr, 10);
    if (std::strcmp(argv[i], "--files") == 0) folder = argv[i + 1];
  }
  std::printf(
      "| images | | solid, genus 0, no intersection | mapped to the sphere | voxels | changed for the topology | "
      "triangles | largest distance "
      "from the sides of voxels | seconds an image |\n|---|---|---|---|---|---|---|---|---|\n");
  bool all_good = true;
  for (const Kind& kind : kinds) {
    base::Random random(1);
    Row row;
    for (std::size_t i = 0; i < images / std::size(kinds); ++i) {
      const test::LabelVolume v = kind.make(random);
      if (!folder.empty()) {
        std::string name = kind.name;
        name = name.substr(0, name.find(' '));
        write_image(folder + "/" + name + "-" + std::to_string(i) + ".mha", v);
      }
      run(v, row);
    }
    std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %.3f | %.3f |\n", kind.name, row.images, row.good,
                row.spheres, row.voxels, row.changed, row.triangles, row.distance,
                row.seconds / static_cast<double>(row.images));
    std::fflush(stdout);
    all_good = all_good && row.good == row.images && row.spheres == row.images && row.distance <= 0.5;
  }
  return all_good ? 0 : 1;
}
