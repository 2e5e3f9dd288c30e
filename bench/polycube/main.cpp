// Polycubes of surfaces in one fixed setting: whether there is a certified map, its corners and distortion, and the
// seconds of the processor that it took.
//
//     bench-polycube [-v] [-c CORNERS] [-o FOLDER] [surface files...]
//
// Without files, shapes made by the project. -v prints what became of each labelling, -o keeps NAME.surface.ply and
// NAME.polycube.ply for judging.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "bench/measuring.h"
#include "mesh/make_shape.h"
#include "mesh/orient.h"
#include "mesh/read.h"
#include "mesh/write.h"
#include "polycube/label_construction.h"

using namespace orbicube;

namespace {

struct Counts {
  std::size_t shapes = 0, valid = 0, low = 0;  // low: both means at most 2
};

void row(const std::string& name, mesh::Mesh surface, std::size_t corners, const std::string& folder,
         const base::Host& host, Counts& counts) {
  const double start = bench::cpu_seconds();
  ++counts.shapes;
  try {
    mesh::orient(surface.positions, surface.triangles, host);
    const polycube::Construction made =
        polycube::construct_by_labels(surface.positions, surface.triangles, {.corners = corners}, host);
    ++counts.valid;
    counts.low += made.distortion.angle_mean <= 2 && made.distortion.area_mean <= 2;
    std::printf("%-18s %8zu %3ld %5zu %8.3f %7.3f %7.1f\n", name.c_str(), surface.triangles.size(),
                static_cast<long>(made.certificate.genus), made.certificate.corners, made.distortion.angle_mean,
                made.distortion.area_mean, bench::cpu_seconds() - start);
    if (!folder.empty()) {
      mesh::Mesh out;
      out.triangles = made.map.triangles;
      out.positions = made.map.positions;
      mesh::write_mesh(std::filesystem::path(folder) / (name + ".surface.ply"), out, {}, host);
      out.positions = made.map.polycube;
      mesh::write_mesh(std::filesystem::path(folder) / (name + ".polycube.ply"), out, {}, host);
    }
  } catch (const base::Error& error) {
    std::printf("%-18s %8zu   -     - %s after %.1f s: %s\n", name.c_str(), surface.triangles.size(), error.kind(),
                bench::cpu_seconds() - start, error.what());
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  base::Host host;
  std::size_t corners = 0;
  std::string folder;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "-v")
      host.on_log = [](const std::string& line) { std::printf("  %s\n", line.c_str()); };
    else if (word == "-c" && i + 1 < argc)
      corners = static_cast<std::size_t>(std::strtoul(argv[++i], nullptr, 10));
    else if (word == "-o" && i + 1 < argc)
      folder = argv[++i];
    else
      files.push_back(word);
  }
  std::printf("%-18s %8s %3s %5s %8s %7s %7s\n", "shape", "faces", "g", "corn.", "angle", "area", "s");
  Counts counts;
  if (files.empty()) {
    for (const mesh::ShapeDescription& shape : mesh::shapes())
      row(shape.name, mesh::make_shape(shape.name, {.triangles = 20'000}, host), corners, folder, host, counts);
  }
  for (const std::string& file : files) {
    try {
      row(std::filesystem::path(file).filename().string(), mesh::read_mesh(file, {}, host), corners, folder, host,
          counts);
    } catch (const base::Error& error) {
      std::printf("%s: %s: %s\n", file.c_str(), error.kind(), error.what());
    }
  }
  std::printf("%zu of %zu valid, %zu with both means at most 2\n", counts.valid, counts.shapes, counts.low);
}
