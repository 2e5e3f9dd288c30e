// Where vertices and corners of an unfolded map have to go for the features that are requested: points, curves, and
// sharp edges of the surface.
#pragma once

#include "polycube/features/features.h"
#include "polycube/unfolded/unfolded_map.h"

namespace orbicube::polycube {

// A vertex and where it is drawn, in its plane.
struct FeaturePull {
  Index vertex;
  Vector2d place = Vector2d::Zero();
  Vector2d along = Vector2d::Zero();  // of the line that it may slide on, or zero for a point
  double begin = 0, end = 0;          // of the line, from the place on
  double weight = 0;                  // 0: it must get there
  bool optional = false;              // whether that may fail
  bool pinned = false;
  Vector3 in_space = Vector3::Zero();  // the place, on the polycube
  int axis = -1;                       // of the line

  bool on_line() const { return axis >= 0; }
  // Coordinates that are fixed when it is where it should be.
  std::uint8_t mask() const {
    if (!on_line()) return 3;
    return along.x() != 0 ? 2 : 1;
  }
  // Returns the nearest that will do.
  Vector2d target(const Vector2d& at) const {
    return on_line() ? Vector2d(place + along.dot(at - place) * along) : place;
  }
};

// A corner of the polycube that belongs to a vertex of the map.
struct CornerWalk {
  Index corner, vertex;
  bool optional = false;  // whether it may stay away
};

struct FeatureTargets {
  explicit FeatureTargets(std::pmr::memory_resource* memory) : pulls(memory), walks(memory) {}

  Array<FeaturePull> pulls;  // `place` and `along` not set; a vertex at most once
  Array<CornerWalk> walks;
  double sharp_length = 0;  // of sharp edges on the surface
};

// Throws Error "invalid-argument" for features that cannot be (features.h).
FeatureTargets gather_targets(const SurfaceMap& map, const UnfoldedMap& unfolded, const FeatureOptions& options,
                              const base::Host& host);

// Returns the axis of the line between two points. Throws Error "invalid-argument" where it is not along one.
int axis_between(const Vector3& from, const Vector3& to);
// Throws Error "invalid-argument" for a vertex that the map does not have.
void require_vertex(const SurfaceMap& map, Index vertex);

}  // namespace orbicube::polycube
