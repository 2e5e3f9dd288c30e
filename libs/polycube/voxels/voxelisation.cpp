#include "polycube/voxels/voxelisation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace orbicube::polycube {
namespace {

constexpr const char* voxelisation_phase = "voxels";
constexpr int outer_layers = 2;  // of empty cells on each side

// A grid of `cells` along the longest axis over the occupancy, with nothing inside yet.
Voxelisation make_grid(const Occupancy& occupancy, int cells, const base::Host& host) {
  std::array<int, 3> counts{};
  std::array<Array<double>, 3> planes = {Array<double>(host.memory), Array<double>(host.memory),
                                         Array<double>(host.memory)};
  // The grid's planes are among those of the occupancy.
  const auto fine_plane = [&](std::size_t axis, int plane) {
    return static_cast<int>(std::lround(static_cast<double>(occupancy.count(axis)) * plane / counts[axis]));
  };
  for (std::size_t a = 0; a < 3; ++a) {
    counts[a] = std::clamp(
        static_cast<int>(std::lround(static_cast<double>(occupancy.count(a)) * cells / occupancy.resolution())), 1,
        occupancy.count(a));
    const double step = occupancy.cell_size() * occupancy.count(a) / counts[a];
    for (int i = -outer_layers; i <= counts[a] + outer_layers; ++i) {
      const bool within = i >= 0 && i <= counts[a];
      planes[a].push_back(occupancy.low()[static_cast<Eigen::Index>(a)] +
                          (within ? fine_plane(a, i) * occupancy.cell_size() : i * step));
    }
  }
  Voxelisation grid(VoxelSolid(std::move(planes), host.memory), host.memory);
  grid.cells = cells;
  grid.fraction.assign(grid.solid.size(), 0);
  for (int x = 0; x < counts[0]; ++x) {
    host.report(voxelisation_phase, 0, 0);
    for (int y = 0; y < counts[1]; ++y) {
      for (int z = 0; z < counts[2]; ++z) {
        const std::array<int, 3> begin = {fine_plane(0, x), fine_plane(1, y), fine_plane(2, z)};
        const std::array<int, 3> end = {fine_plane(0, x + 1), fine_plane(1, y + 1), fine_plane(2, z + 1)};
        const double volume = static_cast<double>(end[0] - begin[0]) * (end[1] - begin[1]) * (end[2] - begin[2]);
        grid.fraction[grid.solid.place({x + outer_layers, y + outer_layers, z + outer_layers})] =
            static_cast<float>(static_cast<double>(occupancy.inside(begin, end)) / volume);
      }
    }
  }
  return grid;
}

// Flips cells around vertices that are not manifold, the one of eight that leaves the fewest such vertices and is
// least wrong by its fraction. Where that goes in circles, a little chance (a fixed sequence) breaks them.
void repair(Voxelisation& grid, const base::Host& host) {
  constexpr int rounds = 60, quiet_rounds = 5;
  VoxelSolid& solid = grid.solid;
  std::uint64_t random = 1;
  for (int round = 0; round < rounds; ++round) {
    bool repaired = true;
    for (int x = 1; x < solid.count(0); ++x) {
      host.report(voxelisation_phase, 0, 0);
      for (int y = 1; y < solid.count(1); ++y) {
        for (int z = 1; z < solid.count(2); ++z) {
          if (VoxelSolid::manifold(solid.configuration({x, y, z}))) continue;
          repaired = false;
          double best = std::numeric_limits<double>::infinity();
          std::size_t chosen = solid.size();
          for (int b = 0; b < 8; ++b) {
            const Cell c = {x - 1 + (b & 1), y - 1 + (b >> 1 & 1), z - 1 + (b >> 2 & 1)};
            if (solid.in_outermost_layer(c)) continue;
            const std::size_t here = solid.place(c);
            solid.set(here, !solid.inside(here));
            double cost = solid.bad_vertices(c);
            solid.set(here, !solid.inside(here));
            const double wrong = std::abs(grid.fraction[here] - 0.5F);
            cost += wrong * (round < rounds / 2 ? 1.5 : 0.5);
            random = random * 6364136223846793005U + 1442695040888963407U;
            if (round > quiet_rounds) cost += 0.05 * round * static_cast<double>(random >> 40) / (1 << 24);
            if (cost < best) {
              best = cost;
              chosen = here;
            }
          }
          if (chosen < solid.size()) solid.set(chosen, !solid.inside(chosen));
        }
      }
    }
    if (repaired) return;
  }
}

// The distance of the farthest vertex from an inside cell, in cells, up to `most`: by layers grown around the inside.
double farthest_vertex(const VoxelSolid& solid, std::span<const Vector3> positions, std::span<const Triangle> triangles,
                       const base::Host& host) {
  Array<std::int16_t> layer(solid.size(), -1, host.memory);
  Array<std::size_t> front(host.memory), next(host.memory);
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (!solid.inside(i)) continue;
    layer[i] = 0;
    front.push_back(i);
  }
  for (std::int16_t distance = 1; !front.empty(); ++distance) {
    host.report(voxelisation_phase, 0, 0);
    next.clear();
    for (const std::size_t here : front) {
      solid.for_each_neighbor(here, [&](std::size_t there) {
        if (layer[there] >= 0) return;
        layer[there] = distance;
        next.push_back(there);
      });
    }
    std::swap(front, next);
  }
  int farthest = 0;
  for (const Triangle& t : triangles) {
    const Vector3& p = positions[t[0]];
    Cell c{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto planes = solid.planes(a);
      const auto above =
          std::upper_bound(planes.begin(), planes.end(), p[static_cast<Eigen::Index>(a)]) - planes.begin();
      c[a] = std::clamp(static_cast<int>(above) - 1, 0, solid.count(a) - 1);
    }
    farthest = std::max<int>(farthest, layer[solid.place(c)]);
  }
  return farthest;
}

bool right_topology(const VoxelSolid& solid, std::int64_t genus, std::size_t cavities, const base::Host& host) {
  const VoxelTopology topology = solid.topology(host);
  // Each part of the surface adds 2 - 2 genus to Euler's number, from which that of the solid follows.
  return topology.bad_vertices == 0 && topology.genus == genus - static_cast<std::int64_t>(cavities) &&
         topology.inside_components == 1 && topology.outside_components == 1 + cavities;
}

}  // namespace

std::optional<Voxelisation> voxelise_by_grid(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                             std::int64_t genus, std::size_t cavities, const Occupancy& occupancy,
                                             int cells, double far, const base::Host& host) {
  // From what is most often right to what keeps the thinnest protrusions.
  constexpr std::array thresholds = {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.1, 0.03};
  Voxelisation grid = make_grid(occupancy, cells, host);
  VoxelSolid& solid = grid.solid;
  const auto keep_largest = [&] {
    solid.keep_largest(true, host);
    if (cavities == 0) solid.keep_largest(false, host);
  };
  Array<std::uint8_t> best(host.memory);
  for (const double threshold : thresholds) {
    host.report(voxelisation_phase, 0, 0);
    for (std::size_t i = 0; i < solid.size(); ++i)
      solid.set(i, grid.fraction[i] > threshold);
    keep_largest();
    repair(grid, host);
    keep_largest();
    if (!right_topology(solid, genus, cavities, host)) continue;
    const double farthest = farthest_vertex(solid, positions, triangles, host) / cells;
    if (!best.empty() && farthest >= grid.farthest) continue;
    grid.threshold = threshold;
    grid.farthest = farthest;
    best.resize(solid.size());
    for (std::size_t i = 0; i < best.size(); ++i)
      best[i] = solid.inside(i);
    if (farthest <= far) break;
  }
  if (best.empty()) return std::nullopt;
  for (std::size_t i = 0; i < best.size(); ++i)
    solid.set(i, best[i] != 0);
  return grid;
}

Voxelisation voxelise(std::span<const Vector3> positions, std::span<const Triangle> triangles, std::int64_t genus,
                      const Occupancy& occupancy, const VoxelisationOptions& options, const base::Host& host) {
  constexpr std::array cell_counts = {12, 16, 20, 24, 30, 40, 48, 60, 72, 84, 100, 120, 140};
  std::optional<Voxelisation> best;
  const auto attempt = [&](int cells) {
    auto grid = voxelise_by_grid(positions, triangles, genus, 0, occupancy, cells, options.far, host);
    if (grid && (!best || grid->farthest < best->farthest)) best = std::move(grid);
    return best && best->farthest <= options.far;
  };
  for (const int cells : cell_counts)
    if (cells >= options.min_cells && cells <= options.max_cells && attempt(cells)) return std::move(*best);
  if (best) return std::move(*best);
  for (auto cells = cell_counts.rbegin(); cells != cell_counts.rend(); ++cells) {
    if (*cells >= options.min_cells) continue;
    attempt(*cells);
    if (best) return std::move(*best);
  }
  throw base::Error("no-valid-result",
                    "no grid of voxels has the genus of the surface, which is " + std::to_string(genus));
}

}  // namespace orbicube::polycube
