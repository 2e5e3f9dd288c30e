#include "hexmesh/grid/voxel_hexes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/threads/pieces.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/padding.h"
#include "mesh/search/measures.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/topology.h"
#include "polycube/voxels/voxelisation.h"
#include "volume_map/solid/gap_widening.h"

namespace orbicube::hexmesh {
namespace {

constexpr double max_boxes = 40e6;  // of the box of the surface, for the parts of cells that are inside

// Of the box, by the number along its longest axis.
double boxes(const Vector3& size, double along) {
  return size.prod() * std::pow(along / size.maxCoeff(), 3);
}

// Cells along the longest axis are cut into this number, for the parts of them that are inside.
int occupancy_of(const Vector3& size, int along) {
  constexpr int least = 240;
  int parts = (least + along - 1) / along;
  while (parts > 1 && boxes(size, along * parts) > max_boxes)
    --parts;
  return along * parts;
}

std::optional<polycube::Voxelisation> voxels(std::span<const Vector3> positions,
                                             std::span<const mesh::Triangle> triangles, const mesh::Topology& topology,
                                             const Vector3& size, int along, const base::Host& host) {
  constexpr double near = 1.5;  // cells
  const auto parts = static_cast<std::int64_t>(topology.components);
  const polycube::Occupancy occupancy(positions, triangles, occupancy_of(size, along), host);
  return polycube::voxelise_by_grid(positions, triangles, parts - topology.euler_characteristic / 2,
                                    topology.components - 1, occupancy, along, near / along, host);
}

HexMesh hexahedra_of(const polycube::VoxelSolid& solid, const base::Host& host) {
  Array<std::uint8_t> inside(solid.size(), 0, host.memory);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    if (i % 1048576 == 0) host.report("grid", 0, 0);
    inside[i] = solid.inside(i);
  }
  HexMesh mesh = hexahedra_of_cells({solid.count(0), solid.count(1), solid.count(2)}, inside, host);
  for (Vector3& p : mesh.positions)
    p = solid.position({static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])});
  return mesh;
}

}  // namespace

namespace {

// No mesh where no grid of cells has the topology of the surface.
VoxelHexes cells_inside(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                        std::size_t cells, const base::Host& host) {
  const mesh::Measures measures = mesh::measures(positions, triangles, host);
  const Vector3 size = measures.high - measures.low;
  const double longest = size.maxCoeff(), most = longest * std::cbrt(max_boxes / size.prod());
  const mesh::Topology topology = mesh::topology(positions, triangles, host);
  const auto target = static_cast<double>(cells);
  // What the layer takes is seen once there is one.
  constexpr int max_rounds = 4;
  constexpr double about = 0.15;
  VoxelHexes best(host.memory);
  double best_error = 0;
  int before = 0;
  double along = longest / std::cbrt(measures.volume / target);
  for (int round = 0; round < max_rounds; ++round) {
    const int count = static_cast<int>(std::lround(std::clamp(along, 3.0, most)));
    if (count == before) break;
    before = count;
    const auto found = voxels(positions, triangles, topology, size, count, host);
    // Where a grid is not right another may be.
    if (!found) {
      along = 1.07 * count + 1;
      continue;
    }
    HexMesh mesh = hexahedra_of(found->solid, host);
    const std::size_t inner = mesh.hexahedra.size();
    const double all = static_cast<double>(inner + mesh.quads.size()), error = std::abs(std::log(all / target));
    if (best.mesh.hexahedra.empty() || error < best_error) {
      best.scale = count / longest;
      for (Vector3& p : mesh.positions)
        p *= best.scale;
      constexpr std::array<std::uint8_t, 1> everywhere = {1};
      pad(mesh, everywhere, 1, host);
      best.padding = mesh.hexahedra.size() - inner;
      best.mesh = std::move(mesh);
      best_error = error;
    }
    if (error < about) break;
    along *= std::pow(target / all, 1.0 / 3);
  }
  return best;
}

// How far the surface is from the boundary of the cells, in cells, at samples.
double farthest(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles, const VoxelHexes& found,
                const base::Host& host) {
  constexpr std::size_t max_samples = 30000, piece = 64;
  const Array<mesh::Triangle> outer = halves_of(found.mesh.quads, host.memory);
  const mesh::SurfaceSearch search(found.mesh.positions, outer, host);
  const std::size_t stride = (triangles.size() + max_samples - 1) / max_samples;
  Array<double> distances((triangles.size() + stride - 1) / stride, 0, host.memory);
  base::parallel_pieces(host, "grid", distances.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const mesh::Triangle& t = triangles[i * stride];
      const Vector3 center = (positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3;
      distances[i] = search.nearest(found.scale * center).distance;
    }
  });
  host.report("grid", 0, 0);
  return *std::max_element(distances.begin(), distances.end());
}

}  // namespace

VoxelHexes voxel_hexahedra(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                           std::size_t cells, const base::Host& host) {
  VoxelHexes found = cells_inside(positions, triangles, cells, host);
  // Walls of a gap in one cell are one solid: of another topology, or, where a gap has an end, with the gap filled.
  constexpr std::array cells_between = {1.5, 2.5};
  constexpr double filled = 2, clearly = 0.5;  // cells that the surface is away from the boundary; of that
  const double cell = std::cbrt(mesh::measures(positions, triangles, host).volume / static_cast<double>(cells));
  for (const double between : cells_between) {
    const bool any = !found.mesh.hexahedra.empty();
    const double away = any ? farthest(positions, triangles, found, host) : 0;
    if (any && away <= filled) return found;
    const Array<Vector3> wider = volume_map::widened_gaps(positions, triangles, between * cell, host);
    if (wider.empty()) continue;
    VoxelHexes now = cells_inside(wider, triangles, cells, host);
    if (now.mesh.hexahedra.empty()) continue;
    if (!any || farthest(positions, triangles, now, host) < clearly * away) found = std::move(now);
  }
  if (found.mesh.hexahedra.empty())
    throw base::Error("no-valid-result", "no grid of cells has the genus and the cavities of the surface");
  return found;
}

}  // namespace orbicube::hexmesh
