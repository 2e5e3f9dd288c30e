// The polycube map that a labeled surface stands for, or why there is none.
#pragma once

#include <limits>

#include "polycube/map/certificate.h"
#include "polycube/surface/surface.h"

namespace orbicube::polycube {

// How positions in space are seen while a map is made: turned so that labels fit, at the origin, of about unit area.
// The scale is a power of two, so that a map scaled back is the same map exactly.
struct Frame {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vector3 centre = Vector3::Zero();
  double scale = 1;

  Vector3 operator()(const Vector3& p) const { return rotation * (scale * (p - centre)); }
};

// A frame without rotation for the surface.
Frame unit_frame(std::span<const Vector3> positions, std::span<const Triangle> triangles);

// The surface as it is seen in the frame. Throws what Surface does.
Surface framed(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Frame& frame,
               const base::Host& host);

struct LabelledMapOptions {
  int untangling_steps = 150;
  int polishing_steps = 25;
  double area_weight = 1;  // how much changes of area count beside those of angles
  // A map with no more triangles flipped than that is left as it is, rather than started from elsewhere.
  std::size_t enough = 0;
  std::uint64_t seed = 0;
};

struct LabelledMapOutcome {
  explicit LabelledMapOutcome(std::pmr::memory_resource* memory) : certificate(memory) {}

  bool valid() const { return reason.empty(); }

  std::string reason;  // why there is no map
  // In the map that is left when none is valid: the one with the fewest.
  std::size_t flipped = std::numeric_limits<std::size_t>::max();
  std::size_t steps = 0;    // of Gauss-Newton that it took
  Certificate certificate;  // of the map
};

// Makes the map from map.positions, triangles and labels, which must obey the rules of patches.h. Splits edges where
// that is needed, fills in positions on the polycube, of the size of the surface, and certifies them.
// `planes`, unless it is empty, says for each triangle where its patch is likely to lie along the patch's axis, in the
// frame (not a number where that is not known): the first place to start from.
LabelledMapOutcome make_labelled_map(SurfaceMap& map, const Frame& frame, const LabelledMapOptions& options,
                                     std::span<const double> planes, const base::Host& host);

}  // namespace orbicube::polycube
