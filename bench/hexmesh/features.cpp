// Sharp edges of machined parts in hexahedral meshes: with the option `features` off and automatic, by the method
// automatic: cells, scaled Jacobians with the bound that the features set, the captured part of the length of curves
// and corners, distance to the surface in percent of the diagonal, and seconds of the processor. What stopped an
// embedding goes to standard error.
//
//     bench-features CELLS [auto|off] FILE ...
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <utility>

#include "base/error.h"
#include "hexmesh/captured/feature_choice.h"
#include "hexmesh/hexmesh.h"
#include "mesh/files/read.h"
#include "tetrahedra/tetrahedra.h"

using namespace orbicube;

namespace {

constexpr const char* names[] = {"auto", "polycube", "grid", "frames"};  // by the numbers of hexmesh::Method

struct Part {
  std::string name;
  mesh::Mesh solid;
  mesh::FeatureTags tags;
};

hexmesh::Options options_of(const Part& part, std::size_t cells, hexmesh::Features features) {
  hexmesh::Options options;
  options.cells = cells;
  options.features = features;
  options.tagged_edges = part.tags.edges;
  options.tagged_vertices = part.tags.vertices;
  options.fill = tetrahedra::filled_mesh;
  return options;
}

void print_row(const Part& part, std::size_t cells, hexmesh::Features features) {
  const bool off = features == hexmesh::Features::off;
  const char* const asked = off ? "off" : "auto";
  base::Host host;
  host.on_log = [&](const std::string& line) { std::fprintf(stderr, "%s: %s\n", part.name.c_str(), line.c_str()); };
  host.thread_count = 1;
  const std::clock_t start = std::clock();
  try {
    volume_map::InputFindings findings;
    hexmesh::Options options = options_of(part, cells, features);
    hexmesh::Hexahedra made = hexmesh::make_hexahedra(part.solid, options, findings, host);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (off) {
      hexmesh::FeatureKeeper keeper(
          part.solid, {.request = {hexmesh::Features::automatic, 40, options.tagged_edges, options.tagged_vertices}},
          host);
      keeper.offer(made.result, false, nullptr);
      made.features = keeper.figures();
    }
    const hexmesh::FeatureFigures& f = *made.features;
    std::printf("%-14s %-5s %-9s %7zu %7.3f %7.3f %7.3f %9.3f %5zu/%-5zu %7.2f%% %7.1f\n", part.name.c_str(), asked,
                f.replaced ? "features" : names[static_cast<std::size_t>(made.method)],
                made.result.mesh.hexahedra.size(), made.result.quality.min_scaled_jacobian,
                made.result.quality.mean_scaled_jacobian, f.bound, f.captured, f.corners - f.missing_corners(),
                f.corners, made.result.distance, seconds);
  } catch (const base::Error& error) {
    std::printf("%-14s %-5s %s: %s\n", part.name.c_str(), asked, error.kind(), error.what());
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::printf("bench-features CELLS [auto|off] FILE ...\n"), 2;
  const std::size_t cells = std::strtoul(argv[1], nullptr, 10);
  std::printf("%-14s %-5s %-9s %7s %7s %7s %7s %9s %-11s %8s %7s\n", "part", "asked", "cells of", "cells", "SJ min",
              "SJ mean", "bound", "captured", "corners", "distance", "seconds");
  const std::string only = argv[2];
  const int first = only == "auto" || only == "off" ? 3 : 2;
  for (int i = first; i < argc; ++i) {
    Part part;
    part.name = std::filesystem::path(argv[i]).stem().string();
    try {
      mesh::ReadReport report;
      part.solid = mesh::read_mesh(argv[i], {.feature_tags = true}, {}, &report);
      if (report.tags) part.tags = *report.tags;
    } catch (const base::Error& error) {
      std::printf("%-14s %s: %s\n", part.name.c_str(), error.kind(), error.what());
      continue;
    }
    if (only != "auto") print_row(part, cells, hexmesh::Features::off);
    if (only != "off") print_row(part, cells, hexmesh::Features::automatic);
  }
}
