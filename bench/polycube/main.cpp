// Polycubes of surfaces in one fixed setting: whether there is a certified map, its corners and distortion, and the
// seconds of the processor.
//
//     bench-polycube [-v] [--construct METHOD] [--corners N] [-o FOLDER] [surface files...]
//     bench-polycube domain [--corners N] files...
//     bench-polycube corners [--corners N] files...
//     bench-polycube common [--corners N] files...
//     bench-polycube factors [--corners N] files...
//     bench-polycube tables FILE:CORNERS...
//
// Without files, shapes made by the project. METHOD: auto, labels or voxels. -v prints what became of each attempt, -o
// keeps NAME.surface.ply and NAME.polycube.ply for judging. `domain` is about proportions, see domain.h, `corners`
// about corners, see corners.h, `common` about one polycube for all files, `factors` about systems of equations,
// factors.h, and `tables` is for tables.py.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "bench/measuring.h"
#include "common.h"
#include "corners.h"
#include "domain.h"
#include "factors.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/orient.h"
#include "polycube/map/construction.h"
#include "tables.h"

using namespace orbicube;

namespace {

struct Counts {
  std::size_t shapes = 0, valid = 0, low = 0;  // low: both means at most 2
};

void row(const std::string& name, mesh::Mesh surface, const polycube::ConstructionOptions& options,
         const std::string& folder, const base::Host& host, Counts& counts) {
  const double start = bench::cpu_seconds();
  ++counts.shapes;
  try {
    mesh::orient(surface.positions, surface.triangles, host);
    const auto [made, method, printed] = polycube::construct(surface.positions, surface.triangles, options, host);
    ++counts.valid;
    counts.low += made.distortion.angle_mean <= 2 && made.distortion.area_mean <= 2;
    std::printf("%-18s %8zu %3ld %5zu %8.3f %7.3f %7.1f  %s, %zu of %zu\n", name.c_str(), surface.triangles.size(),
                static_cast<long>(made.certificate.genus), made.certificate.corners, made.distortion.angle_mean,
                made.distortion.area_mean, bench::cpu_seconds() - start,
                method == polycube::Method::labels ? "labels" : "voxels", made.valid, made.tried);
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

polycube::Method method_named(const std::string& name) {
  if (name == "labels") return polycube::Method::labels;
  if (name == "voxels") return polycube::Method::voxels;
  if (name == "auto") return polycube::Method::automatic;
  std::fprintf(stderr, "no construction %s: auto, labels or voxels\n", name.c_str());
  std::exit(2);
}

}  // namespace

int main(int argc, char** argv) {
  base::Host host;
  polycube::ConstructionOptions options;
  std::string folder;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "-v")
      host.on_log = [](const std::string& line) { std::printf("  %s\n", line.c_str()); };
    else if (word == "--corners" && i + 1 < argc)
      options.corners = static_cast<std::size_t>(std::strtoul(argv[++i], nullptr, 10));
    else if (word == "--construct" && i + 1 < argc)
      options.method = method_named(argv[++i]);
    else if (word == "-o" && i + 1 < argc)
      folder = argv[++i];
    else
      files.push_back(word);
  }
  if (!files.empty() && files.front() == "domain") {
    bench::measure_domains(std::span(files).subspan(1), options.corners, host);
    return 0;
  }
  if (!files.empty() && files.front() == "common") {
    bench::compare_common(std::span(files).subspan(1), options.corners, host);
    return 0;
  }
  if (!files.empty() && files.front() == "tables") {
    bench::measure_tables(std::span(files).subspan(1), host);
    return 0;
  }
  if (!files.empty() && files.front() == "factors") {
    bench::measure_factors(std::span(files).subspan(1), options.corners, host);
    return 0;
  }
  if (!files.empty() && files.front() == "corners") {
    bench::measure_corners(std::span(files).subspan(1), options.corners, host);
    return 0;
  }
  std::printf("%-18s %8s %3s %5s %8s %7s %7s\n", "shape", "faces", "g", "corn.", "angle", "area",
              "s");  // then the construction, its valid maps and attempts
  Counts counts;
  if (files.empty()) {
    for (const mesh::ShapeDescription& shape : mesh::shapes())
      row(shape.name, mesh::make_shape(shape.name, {.triangles = 20'000}, host), options, folder, host, counts);
  }
  for (const std::string& file : files) {
    try {
      row(std::filesystem::path(file).filename().string(), mesh::read_mesh(file, {}, host), options, folder, host,
          counts);
    } catch (const base::Error& error) {
      std::printf("%s: %s: %s\n", file.c_str(), error.kind(), error.what());
    }
  }
  std::printf("%zu of %zu valid, %zu with both means at most 2\n", counts.valid, counts.shapes, counts.low);
}
