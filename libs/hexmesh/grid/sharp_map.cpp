#include "hexmesh/grid/sharp_map.h"

#include "base/error.h"
#include "mesh/topology/connectivity.h"
#include "polycube/features/features.h"

namespace orbicube::hexmesh {
namespace {

// In space, of the edges of the polycube.
double length_of_edges(const polycube::SurfaceMap& map, const base::Host& host) {
  const mesh::Connectivity connectivity(map.positions.size(), map.triangles, host);
  double length = 0;
  for (Index h = 0; h < 3 * map.triangles.size(); ++h) {
    const Index other = connectivity.opposite(h);
    if (other == no_index || other < h || map.patches[h / 3] == map.patches[other / 3]) continue;
    length += (map.positions[connectivity.end(h)] - map.positions[connectivity.start(h)]).norm();
  }
  return length;
}

}  // namespace

std::optional<polycube::SurfaceMap> map_with_sharp_edges(const polycube::SurfaceMap& map, double degrees,
                                                         const base::Host& host) {
  // Of the edges of the polycube those that are sharp, and of the sharp edges those that are met: where much is left
  // within faces, hexahedra along the rest end badly.
  constexpr double least = 0.2, least_met = 0.6;
  polycube::SurfaceMap sharp(host.memory);
  sharp = map;
  try {
    const polycube::FeatureFit fit = polycube::align_features(sharp, {.feature_angle = degrees}, host);
    if (fit.sharp < least_met * fit.sharp_length || fit.sharp < least * length_of_edges(sharp, host))
      return std::nullopt;
    return sharp;
  } catch (const base::Error& error) {
    if (error.status() != base::Status::no_valid_result) throw;
    return std::nullopt;
  }
}

}  // namespace orbicube::hexmesh
