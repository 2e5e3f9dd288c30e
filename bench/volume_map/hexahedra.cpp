// Hexahedral meshes of closed surfaces with one setting: cells, scaled Jacobians, distances to the surface both ways
// in percent of the diagonal, error of the volume, and seconds on the clock, beside published figures.
//
//     bench-hexahedra FOLDER [cells [solid.obj ...]]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/orient.h"
#include "mesh/read.h"
#include "polycube/construction.h"
#include "volume_map/coarse_surface.h"
#include "volume_map/hex_meshing.h"

using namespace orbicube;

namespace {

const std::vector<std::string> solids = {"bunny.ply",       "hand.off",        "rocker-arm.obj",   "fertility.off",
                                         "bumpy-torus.off", "three-torus.off", "double-torus.off", "rod.obj",
                                         "joint.obj",       "hanger.off",      "kitten.ply",       "fandisk.obj",
                                         "b0.obj",          "anchor.off",      "torus.obj",        "block.off"};

// Scaled Jacobians, least and mean, of the best published mesh of the shape.
const char* published(const std::string& name) {
  if (name == "bunny") return ".606 / .972";
  if (name == "joint") return ".778";
  if (name == "rod") return ".418";
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::printf("bench-hexahedra FOLDER [cells [solid ...]]\n"), 2;
  const std::size_t cells = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 11000;
  const std::vector<std::string> names = argc > 3 ? std::vector<std::string>(argv + 3, argv + argc) : solids;
  std::printf("%-14s %7s %7s %9s %9s %9s %9s %8s  %s\n", "solid", "cells", "padded", "SJ min", "SJ mean", "distance",
              "volume", "seconds", "published");
  int valid = 0;
  for (const std::string& file : names) {
    const std::string name = std::filesystem::path(file).stem().string();
    const auto start = std::chrono::steady_clock::now();
    try {
      const base::Host host;
      constexpr std::size_t triangles = 6000;
      mesh::Mesh surface = mesh::read_mesh(std::filesystem::path(argv[1]) / file, {}, host);
      mesh::orient(surface.positions, surface.triangles, host);
      const bool coarser = surface.triangles.size() > 2 * triangles;
      const auto coarse = volume_map::coarse_surface(surface.positions, surface.triangles,
                                                     coarser ? triangles : surface.triangles.size(), host);
      const auto best =
          polycube::construct(coarse.positions, coarse.triangles, {.corners = 100, .preferred_corners = 60}, host);
      volume_map::PolycubeSurface mapped{best.made.map};
      if (coarser) {
        mapped.fine_positions = surface.positions;
        mapped.fine_triangles = surface.triangles;
      }
      const auto result = volume_map::make_hexahedra(mapped, {.cells = cells}, host);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      valid += result.distance < 1 && result.volume_error < 1;
      std::printf("%-14s %7zu %7s %9.3f %9.3f %8.2f%% %8.2f%% %8.1f  %s\n", name.c_str(), result.mesh.hexahedra.size(),
                  result.padded ? "yes" : "no", result.quality.least_scaled_jacobian,
                  result.quality.mean_scaled_jacobian, result.distance, result.volume_error, seconds, published(name));
    } catch (const base::Error& error) {
      std::printf("%-14s %s: %s\n", name.c_str(), error.kind(), error.what());
    }
    std::fflush(stdout);
  }
  std::printf("%d of %zu valid with distance and volume within a percent\n", valid, names.size());
}
