// Hexahedra along frame fields with one setting, of solids that the project makes itself: tetrahedra, singular edges
// and integers of the map, hexahedra, inner edges with other than four of them, scaled Jacobians, error of the volume,
// fields tried, and seconds of the fields and of the rest.
//
//     bench-frames [cells [shape ...]]
#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"
#include "hexmesh/strategies/frame_hexes.h"
#include "mesh/search/measures.h"
#include "mesh/shapes/make_shape.h"
#include "tetrahedra/tetrahedra.h"

using namespace orbicube;

int main(int argc, char** argv) {
  const std::size_t cells = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 3000;
  std::vector<std::string> names = {"cube", "l-shape", "three-holes", "cylinder", "vase", "torus", "bracket", "sphere"};
  if (argc > 2) names.assign(argv + 2, argv + argc);
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto seconds = [](auto from, auto to) { return std::chrono::duration<double>(to - from).count(); };
  std::printf("%-12s %7s %7s %9s %9s %7s %9s %7s %8s %8s %8s %6s %7s %7s\n", "solid", "tets", "singular", "integers",
              "inverted", "cells", "irregular", "patches", "SJ min", "SJ mean", "volume", "fields", "field s",
              "hexes s");
  std::size_t valid = 0;
  for (const std::string& name : names) {
    const base::Host host;
    try {
      const mesh::Mesh surface = mesh::make_shape(name, {.triangles = 2500}, host);
      const double volume = mesh::measures(surface.positions, surface.triangles, host).volume;
      const auto start = now();
      const tetrahedra::Solid filled =
          tetrahedra::fill(surface.positions, surface.triangles, {.max_volume = volume / 6000}, host);
      const hexmesh::FrameHexes made = hexmesh::make_hexahedra_along_frames(filled.positions, filled.tetrahedra, 0,
                                                                            {.cells = cells, .distance = 0}, host);
      const auto& q = made.result.quality;
      ++valid;
      std::printf("%-12s %7zu %8zu %9zu %9zu %7zu %9zu %7zu %8.3f %8.3f %7.2f%% %6zu %7.1f %7.1f\n", name.c_str(),
                  made.map.solid.tetrahedra.size(), made.map.singular_edges, made.map.integers,
                  made.map.inverted_at_start, made.result.mesh.hexahedra.size(), made.inner_irregular_edges,
                  made.map.patches, q.min_scaled_jacobian, q.mean_scaled_jacobian,
                  100 * std::abs(q.volume / volume - 1), made.fields, made.field_seconds,
                  seconds(start, now()) - made.field_seconds);
    } catch (const base::Error& error) {
      std::printf("%-12s %s: %s\n", name.c_str(), error.kind(), error.what());
    }
    std::fflush(stdout);
  }
  std::printf("%zu of %zu valid\n", valid, names.size());
}
