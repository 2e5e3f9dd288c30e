#include "hexmesh/strategies/polycube_grids.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/padding.h"
#include "polycube/surface/distortion.h"

namespace orbicube::hexmesh {

PaddedFaces::PaddedFaces(const HexMesh& mesh, Array<std::uint8_t> chosen) : faces(std::move(chosen)) {
  double count = 0;
  for (const Index patch : mesh.quad_patches)
    count += faces[patch];
  part = count / static_cast<double>(mesh.quads.size());
}

bool has_lost_limbs(const polycube::SurfaceMap& map, const base::Host& host) {
  constexpr double most = 2;
  return polycube::measure_distortion(map, host).angle_mean > most;
}

void add_strategies(Array<Strategy>& strategies, const Guide& guide, const HexOptions& options, std::size_t cells,
                    int across, const base::Host& host) {
  const polycube::SurfaceMap& map = guide.surface.map;
  const HexMesh mesh = sample_hexahedra(domain_of_cells(guide.graph, cells, 0, host, across), map, host);
  const std::size_t count = 1 + *std::max_element(map.patches.begin(), map.patches.end());
  int choices = 0;
  const auto add = [&](Array<std::uint8_t> faces) {
    strategies.push_back({&guide, choices++, PaddedFaces(mesh, std::move(faces))});
  };
  const auto add_all = [&](std::uint8_t value) { add(Array<std::uint8_t>(count, value, host.memory)); };
  if (options.padding == Padding::with) add_all(1);
  if (options.padding == Padding::without) add_all(0);
  if (options.padding != Padding::automatic) return;
  add(choose_padding(mesh, host));
  // Where what was chosen turns out bad: none, or all.
  add_all(strategies.back().padded.part > 0 ? 0 : 1);
}

PolycubeGrid::PolycubeGrid(const Strategy& strategy, std::size_t cells, int across, const base::Host& host)
    : mesh(sample_hexahedra(domain_of_cells(strategy.guide->graph, cells, strategy.padded.part, host, across),
                            strategy.guide->surface.map, host)) {
  const polycube::SurfaceMap& map = strategy.guide->surface.map;
  const std::size_t inner = mesh.hexahedra.size();
  double volume = 0;
  Vector3 low = map.positions[map.triangles[0][0]], high = low;
  for (const mesh::Triangle& t : map.triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(map.positions[v]);
      high = high.cwiseMax(map.positions[v]);
    }
  }
  const Vector3 origin = near_origin(low, high);
  const auto at = [&](Index v) { return Vector3(map.positions[v] - origin); };
  for (const mesh::Triangle& t : map.triangles)
    volume += at(t[0]).dot(at(t[1]).cross(at(t[2]))) / 6;
  scale = std::cbrt(static_cast<double>(inner) / std::abs(volume));
  for (Vector3& p : mesh.positions)
    p *= scale;
  pad(mesh, strategy.padded.faces, 1, host);
  padding = mesh.hexahedra.size() - inner;
}

}  // namespace orbicube::hexmesh
