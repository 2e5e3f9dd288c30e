// Hexahedral meshes of closed surfaces with one setting, by their polycubes (or cells of a grid in space, where these
// do not serve) and by cells of a grid in space alone: cells, scaled Jacobians, distances to the surface both ways in
// percent of the diagonal, error of the volume, and seconds on the clock, beside published figures.
//
//     bench-hexahedra FOLDER [cells [solid.obj ...]]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "hexmesh/hexmesh.h"
#include "mesh/files/read.h"
#include "mesh/topology/orient.h"

using namespace orbicube;

namespace {

const std::vector<std::string> solids = {"bunny.ply",       "hand.off",        "rocker-arm.obj",   "fertility.off",
                                         "bumpy-torus.off", "three-torus.off", "double-torus.off", "rod.obj",
                                         "joint.obj",       "hanger.off",      "kitten.ply",       "fandisk.obj",
                                         "b0.obj",          "anchor.off",      "torus.obj",        "block.off"};

// Scaled Jacobians, minimum and mean, of the best published mesh of the shape.
const char* published(const std::string& name) {
  if (name == "bunny") return ".606 / .972";
  if (name == "joint") return ".778";
  if (name == "rod") return ".418";
  return "";
}

struct Solid {
  std::string name;
  mesh::Mesh surface;
};

// Whether there is a mesh that is near to the surface.
bool print_row(const Solid& solid, hexmesh::Method method, std::size_t cells) {
  const auto start = std::chrono::steady_clock::now();
  const char* const asked = method == hexmesh::Method::grid ? "grid" : "auto";
  try {
    const base::Host host;
    volume_map::InputFindings findings;
    hexmesh::Options options;
    options.method = method;
    options.cells = cells;
    options.features = hexmesh::Features::off;  // bench-features prints those
    const hexmesh::HexResult result = hexmesh::make_hexahedra(solid.surface, options, findings, host).result;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%-14s %-7s %-9s %7zu %9.3f %9.3f %8.2f%% %8.2f%% %8.1f  %s\n", solid.name.c_str(), asked,
                result.grid_based ? "grid" : "polycube", result.mesh.hexahedra.size(),
                result.quality.min_scaled_jacobian, result.quality.mean_scaled_jacobian, result.distance,
                result.volume_error, seconds, published(solid.name));
    return result.distance < 1 && result.volume_error < 1;
  } catch (const base::Error& error) {
    std::printf("%-14s %-7s %s: %s\n", solid.name.c_str(), asked, error.kind(), error.what());
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::printf("bench-hexahedra FOLDER [cells [solid ...]]\n"), 2;
  const std::size_t cells = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 11000;
  const std::vector<std::string> names = argc > 3 ? std::vector<std::string>(argv + 3, argv + argc) : solids;
  std::printf("%-14s %-7s %-9s %7s %9s %9s %9s %9s %8s  %s\n", "solid", "method", "cells of", "cells", "SJ min",
              "SJ mean", "distance", "volume", "seconds", "published");
  int near = 0, near_by_grid = 0;
  for (const std::string& file : names) {
    Solid solid;
    solid.name = std::filesystem::path(file).stem().string();
    try {
      solid.surface = mesh::read_mesh(std::filesystem::path(argv[1]) / file, {}, {});
      mesh::orient(solid.surface.positions, solid.surface.triangles, {});
    } catch (const base::Error& error) {
      std::printf("%-14s %s: %s\n", solid.name.c_str(), error.kind(), error.what());
      continue;
    }
    near += print_row(solid, hexmesh::Method::automatic, cells);
    std::fflush(stdout);
    near_by_grid += print_row(solid, hexmesh::Method::grid, cells);
    std::fflush(stdout);
  }
  std::printf("%d of %zu valid with distance and volume within a percent; %d grid-based\n", near, names.size(),
              near_by_grid);
}
