#include "sphere_map/correspondence/correspondence.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "mesh/search/bounding_volume_tree.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/optimization/pieces.h"
#include "sphere_map/sampling/sampling.h"

namespace orbicube::sphere_map {

CarriedShape carry_over(const Locator& map, std::span<const Vector3> positions, const Alignment& alignment,
                        std::span<const Vector3> common, std::span<const Triangle> common_triangles,
                        std::span<const Index> own_vertex, const base::Host& host) {
  if (positions.size() != map.directions().size() || (!own_vertex.empty() && own_vertex.size() != common.size()))
    throw base::Error("invalid-argument", "positions or vertices have a wrong size");
  CarriedShape result(host.memory);
  result.directions.assign(common.size(), Vector3::Zero());
  const auto own = [&](std::size_t v) { return own_vertex.empty() ? mesh::no_index : own_vertex[v]; };
  for_each_in_pieces(common.size(), "correspondence", host, [&](std::size_t v) {
    require_direction(common[v], "direction", v);
    result.directions[v] = own(v) < positions.size() ? map.directions()[own(v)] : alignment.from_common(common[v]);
  });
  result.positions = sample_vectors(map, result.directions, positions, Interpolation::linear, host);
  result.flipped = count_not_positive(common_triangles, result.directions);
  return result;
}

Array<Vector3> place(std::span<const Vector3> directions, const Alignment& alignment, const base::Host& host) {
  Array<Vector3> placed(directions.size(), Vector3::Zero(), host.memory);
  for_each_in_pieces(directions.size(), "placing the map", host, [&](std::size_t v) {
    require_direction(directions[v], "direction", v);
    placed[v] = alignment.to_common(directions[v]);
  });
  return placed;
}

EdgeError::EdgeError(std::span<const Shape> shapes, double tolerance) : shapes_(shapes.begin(), shapes.end()) {
  for (const Shape& shape : shapes) {
    mesh::Box box;
    for (const Triangle& t : shape.map->triangles()) {
      for (const Index v : t)
        box.add(shape.positions[v]);
    }
    const double diagonal = (box.high - box.low).norm();
    scale_.push_back(diagonal > 0 ? 1 / (tolerance * diagonal) : 0);
  }
}

double EdgeError::operator()(const Vector3& a, const Vector3& b) const {
  constexpr std::array shares = {0.0, 0.25, 0.5, 0.75, 1.0};
  double largest = 0;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    std::array<Vector3, shares.size()> at;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const Vector3 d = k == 0                   ? a
                        : k + 1 == shares.size() ? b
                                                 : Vector3(((1 - shares[k]) * a + shares[k] * b).normalized());
      const Location found = shape.map->locate(shape.alignment->from_common(d));
      const Triangle& t = shape.map->triangles()[found.triangle];
      at[k] = found.weights[0] * shape.positions[t[0]] + found.weights[1] * shape.positions[t[1]] +
              found.weights[2] * shape.positions[t[2]];
    }
    const Vector3 along = at.back() - at.front();
    const double square = along.squaredNorm();
    for (std::size_t k = 1; k + 1 < shares.size(); ++k) {
      const double share = square > 0 ? std::clamp((at[k] - at[0]).dot(along) / square, 0.0, 1.0) : 0.0;
      largest = std::max(largest, scale_[i] * (at[k] - at[0] - share * along).norm());
    }
  }
  return largest;
}

}  // namespace orbicube::sphere_map
