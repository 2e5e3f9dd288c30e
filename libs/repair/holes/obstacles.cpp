#include "repair/holes/obstacles.h"

#include "mesh/search/intersections.h"
#include "mesh/search/nearest.h"
#include "mesh/search/predicates.h"

namespace orbicube::repair {
namespace {

bool has_area(std::span<const Vector3> positions, const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&](Index v) {
      return Eigen::Vector2d(positions[v][(axis + 1) % 3], positions[v][(axis + 2) % 3]);
    };
    if (mesh::orientation_2d(along(t[0]), along(t[1]), along(t[2])) != 0) return true;
  }
  return false;
}

Array<Triangle> chosen_with_area(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 std::span<const std::uint8_t> chosen, const base::Host& host) {
  Array<Triangle> result(host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (chosen[t] != 0 && has_area(positions, triangles[t])) result.push_back(triangles[t]);
  }
  return result;
}

}  // namespace

Obstacles::Obstacles(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                     std::span<const std::uint8_t> chosen, const base::Host& host)
    : positions_(positions),
      triangles_(chosen_with_area(positions, triangles, chosen, host)),
      boxes_(mesh::boxes_of(positions, triangles_, host)),
      tree_(boxes_, host) {}

bool Obstacles::meet(const Triangle& triangle) const {
  if (!has_area(positions_, triangle)) return true;
  mesh::Box box;
  for (const Index v : triangle)
    box.add(positions_[v]);
  bool found = false;
  tree_.for_each_near(box, [&](Index t) {
    found = found || (box.overlaps(boxes_[t]) && mesh::triangles_intersect(positions_, triangle, triangles_[t]));
  });
  return found;
}

}  // namespace orbicube::repair
