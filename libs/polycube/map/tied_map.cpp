#include "polycube/map/tied_map.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace orbicube::polycube {

TiedMap::TiedMap(const Surface& of, const Patches& with, const base::Host& host)
    : surface(&of), patches(&with), variable(of.positions.size(), host.memory), value(host.memory) {
  std::fill(variable.begin(), variable.end(), std::array<Index, 3>{no_index, no_index, no_index});
  for (Index i = 0; i < of.triangles.size(); ++i) {
    for (const Index v : of.triangles[i])
      variable[v][static_cast<std::size_t>(axis_of(label(i)))] = with.patch[i];
  }
  auto next = static_cast<Index>(with.count());
  for (auto& of_vertex : variable) {
    for (Index& x : of_vertex) {
      if (x == no_index) x = next++;
    }
  }
  value.assign(next, 0);
}

untangle::PlanarTriangles triangles_of(const TiedMap& map, const base::Host& host) {
  const Surface& surface = *map.surface;
  untangle::PlanarTriangles result(host.memory);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const auto& t = surface.triangles[i];
    const AxisLabel label = map.label(static_cast<Index>(i));
    const auto u = static_cast<std::size_t>((axis_of(label) + 1) % 3);
    const auto v = static_cast<std::size_t>((axis_of(label) + 2) % 3);
    std::array<Index, 6> variables{};
    std::array<double, 6> signs{};
    for (std::size_t k = 0; k < 3; ++k) {
      variables[2 * k] = map.variable[t[k]][u];
      variables[2 * k + 1] = map.variable[t[k]][v];
      signs[2 * k] = sign_of(label);
      signs[2 * k + 1] = 1;
    }

    // Slivers are widened a little, so that gradients stay finite.
    constexpr double min_height = 1e-7;
    const Vector3 e = surface.positions[t[1]] - surface.positions[t[0]];
    const Vector3 g = surface.positions[t[2]] - surface.positions[t[0]];
    const double scale = std::max(e.norm(), g.norm());
    const double length = std::max(e.norm(), min_height * scale);
    const Vector3 along = length > 0 ? Vector3(e / length) : Vector3::UnitX();
    const double x = g.dot(along);
    const double y = std::max((g - x * along).norm(), min_height * scale);
    const std::array<Eigen::Vector2d, 3> corner = {Eigen::Vector2d(0, 0), Eigen::Vector2d(length, 0),
                                                   Eigen::Vector2d(x, y)};
    const double twice_area = length * y;
    std::array<Eigen::Vector2d, 3> hats;
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2d edge = corner[(k + 2) % 3] - corner[(k + 1) % 3];
      hats[k] = Eigen::Vector2d(-edge.y(), edge.x()) / twice_area;
    }
    result.variables.push_back(variables);
    result.signs.push_back(signs);
    result.hats.push_back(hats);
    result.weights.push_back(0.5 * twice_area / surface.area);
  }
  return result;
}

}  // namespace orbicube::polycube
