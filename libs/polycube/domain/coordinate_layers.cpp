#include "polycube/domain/coordinate_layers.h"

#include <algorithm>

namespace orbicube::polycube {

CoordinateLayers find_layers(const SurfaceMap& map, const base::Host& host) {
  host.report("layers", 0, 0);
  CoordinateLayers result(host.memory);
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    const int axis = axis_of(map.labels[i]);
    Array<double>& along = result.positions[static_cast<std::size_t>(axis)];
    const double position = map.polycube[map.triangles[i][0]][axis];
    // Neighbors in a file are mostly in one face.
    if (along.empty() || along.back() != position) along.push_back(position);
  }
  for (Array<double>& along : result.positions) {
    std::sort(along.begin(), along.end());
    along.erase(std::unique(along.begin(), along.end()), along.end());
  }
  result.places.resize(map.polycube.size());
  for (Index v = 0; v < map.polycube.size(); ++v) {
    if (v % 4096 == 0) host.report("layers", v, map.polycube.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Array<double>& along = result.positions[axis];
      const double x = std::clamp(map.polycube[v][static_cast<Eigen::Index>(axis)], along.front(), along.back());
      const auto above = std::upper_bound(along.begin(), along.end(), x);
      const double below = *(above - 1);
      result.places[v][axis] = {static_cast<Index>(above - 1 - along.begin()),
                                x == below ? 0.0 : (x - below) / (*above - below)};
    }
  }
  return result;
}

void place_vertices(const CoordinateLayers& layers, const std::array<Array<double>, 3>& positions,
                    std::span<Vector3> vertices) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [layer, fraction] = layers.places[v][axis];
      const double below = positions[axis][layer];
      vertices[v][static_cast<Eigen::Index>(axis)] =
          fraction > 0 ? below + fraction * (positions[axis][layer + 1] - below) : below;
    }
  }
}

}  // namespace orbicube::polycube
