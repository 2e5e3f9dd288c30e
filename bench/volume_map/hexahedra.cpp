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
#include "mesh/files/read.h"
#include "mesh/topology/orient.h"
#include "polycube/map/construction.h"
#include "volume_map/meshing/coarse_surface.h"
#include "volume_map/meshing/hex_meshing.h"

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

volume_map::HexResult filled(const Solid& solid, volume_map::HexMethod method, std::size_t cells,
                             const base::Host& host) {
  constexpr std::size_t triangles = 6000;
  const mesh::Mesh& surface = solid.surface;
  const bool coarser = surface.triangles.size() > 2 * triangles, by_polycube = method != volume_map::HexMethod::grid;
  polycube::SurfaceMap map;
  if (by_polycube) {
    const auto coarse = volume_map::coarse_surface(surface.positions, surface.triangles,
                                                   coarser ? triangles : surface.triangles.size(), host);
    try {
      map = polycube::construct(coarse.positions, coarse.triangles, {.corners = 100, .preferred_corners = 60}, host)
                .made.map;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
    }
  }
  volume_map::PolycubeSurface mapped{map};
  if (coarser || map.triangles.empty()) {
    mapped.fine_positions = surface.positions;
    mapped.fine_triangles = surface.triangles;
  }
  return volume_map::make_hexahedra(mapped, {.method = method, .cells = cells}, host);
}

// Whether there is a mesh that is near to the surface.
bool print_row(const Solid& solid, volume_map::HexMethod method, std::size_t cells) {
  const auto start = std::chrono::steady_clock::now();
  const char* const asked = method == volume_map::HexMethod::grid ? "grid" : "auto";
  try {
    const auto result = filled(solid, method, cells, {});
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
    near += print_row(solid, volume_map::HexMethod::automatic, cells);
    std::fflush(stdout);
    near_by_grid += print_row(solid, volume_map::HexMethod::grid, cells);
    std::fflush(stdout);
  }
  std::printf("%d of %zu valid with distance and volume within a percent; %d grid-based\n", near, names.size(),
              near_by_grid);
}
