#include "sphere_map/correspondence.h"

#include <string>

#include "base/error.h"
#include "sphere_map/measure.h"
#include "sphere_map/pieces.h"
#include "sphere_map/rounding.h"
#include "sphere_map/sampling.h"

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
  result.turned_over = count_not_positive(common_triangles, result.directions);
  return result;
}

Array<Vector3> place(std::span<const Triangle> triangles, std::span<const Vector3> directions,
                     const Alignment& alignment, const base::Host& host) {
  Array<Vector3> placed(directions.size(), Vector3::Zero(), host.memory);
  for_each_in_pieces(directions.size(), "placing the map", host, [&](std::size_t v) {
    require_direction(directions[v], "direction", v);
    placed[v] = alignment.to_common(directions[v]);
  });
  if (count_not_positive(triangles, placed) > 0) {
    const Store as_it_is = [](Index, const Vector3& direction) { return direction; };
    placed = round_and_repair(triangles, placed, as_it_is, 0, host).directions;
  }
  if (const std::size_t bad = count_not_positive(triangles, placed); bad > 0) {
    throw base::Error("no-valid-result",
                      std::to_string(bad) + " triangles of the map are turned over by its alignment");
  }
  return placed;
}

}  // namespace orbicube::sphere_map
