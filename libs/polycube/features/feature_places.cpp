#include "polycube/features/feature_places.h"

#include <algorithm>

#include "base/error.h"
#include "base/infinity.h"

namespace orbicube::polycube {

FeaturePlaces::FeaturePlaces(const SurfaceMap& map, const UnfoldedMap& unfolded, const base::Host& host)
    : map_(map),
      unfolded_(unfolded),
      host_(host),
      search_(map.polycube, map.triangles, host),
      distance_(map.triangles.size(), base::infinity, host.memory),
      motion_(map.triangles.size(), host.memory),
      reached_(host.memory),
      heap_(host.memory) {
  constexpr double rounding = 1e-6;  // of places that were written as text
  mesh::Box box;
  for (const Triangle& t : map.triangles)
    for (const Index v : t)
      box.add(map.polycube[v]);
  tolerance_ = rounding * (box.high - box.low).norm();
}

Vector3 FeaturePlaces::centre(Index face) const {
  const Triangle& t = map_.triangles[face];
  return (map_.polycube[t[0]] + map_.polycube[t[1]] + map_.polycube[t[2]]) / 3;
}

void FeaturePlaces::reach(Index face, double distance, const PlaneMotion& motion) {
  if (!(distance < distance_[face])) return;
  if (distance_[face] == base::infinity) reached_.push_back(Index{face});
  distance_[face] = distance;
  motion_[face] = motion;
  heap_.push({distance, face});
}

FeaturePlaces::InPlane FeaturePlaces::find(Index vertex, const Vector3& place, int axis) {
  const mesh::SurfacePoint target = search_.nearest(place);
  base::require(target.distance <= tolerance_, "the place of a feature is not on the polycube");
  const EditableSurface& surface = unfolded_.surface;
  for (const Index f : reached_)
    distance_[f] = base::infinity;
  reached_.clear();
  heap_.clear();
  const Vector3& from = map_.polycube[vertex];
  surface.for_each_outgoing(vertex, [&](Index h) { reach(h / 3, (centre(h / 3) - from).norm(), unfolded_.motion[h]); });
  for (std::size_t popped = 0; !heap_.empty(); ++popped) {
    if (popped % 4096 == 0) host_.report("features", 0, 0);
    const Entry entry = heap_.pop();
    const Index f = entry.face;
    if (entry.distance > distance_[f]) continue;
    if (f == target.triangle) break;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index beyond = surface.opposite(h) / 3;
      reach(beyond, entry.distance + (centre(beyond) - centre(f)).norm(), unfolded_.across(h).after(motion_[f]));
    }
  }
  InPlane result{Vector2d::Zero()};
  for (Index k = 0; k < 3; ++k)
    result.place += target.weights[k] * unfolded_.at(3 * target.triangle + k);
  const PlaneMotion back = motion_[target.triangle].inverse();
  result.place = back(result.place);
  if (axis >= 0) {
    const AxisLabel label = map_.labels[target.triangle];
    base::require(axis_of(label) != axis, "the line of a feature is not in a patch of the polycube");
    const UnfoldedPatch facet{label, 0};
    result.along = turned_by(facet.flat(Vector3::Unit(axis)), back.quarters);
  }
  return result;
}

}  // namespace orbicube::polycube
