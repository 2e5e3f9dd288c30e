// Points and curves of a surface that are mapped to target positions of its polycube, and sharp edges that are mapped
// to edges of it.
//
// On the unfolded map (unfolded_map.h) a place is a point in the plane of a vertex, along a way over the polycube that
// is short. First vertices are drawn to their target positions by ever stronger ties, with all other vertices following
// and no triangle flipped; where that has brought them near, those that must be there are put there exactly and fixed,
// and the rest of the map is smoothed. A corner of the polycube that belongs to a vertex is walked there from vertex to
// vertex.
#pragma once

#include <span>
#include <string>

#include "polycube/map/certificate.h"
#include "polycube/surface/distortion.h"

namespace orbicube::polycube {

// Weights are those of squared distances, in parts of the polycube's area, beside a distortion that is 2 for an
// isometry; with 0 the feature is met exactly, or there is no result.
struct FeaturePoint {
  Index vertex;   // of the map
  Vector3 place;  // on its polycube
  double weight = 0;
};

// Vertices, in their order, along the straight line between two points of one patch of the polycube, or of one edge:
// the first goes to the one point, the last to the other, and those between slide on the line.
struct FeatureCurve {
  std::span<const Index> vertices;
  Vector3 from, to;  // differ in one coordinate
  double weight = 0;
};

struct FeatureOptions {
  std::span<const FeaturePoint> points = {};
  std::span<const FeatureCurve> curves = {};
  // Edges of the surface that bends by at least the given angle in degrees are brought to the polycube's edges that
  // they are near and along, as far as that goes; 0: none.
  double feature_angle = 0;
  int newton_steps = 100;  // of all vertices, for the smoothing at the end
};

struct FeatureFit {
  explicit FeatureFit(std::pmr::memory_resource* memory)
      : distances_before(memory), distances(memory), certificate(memory) {}

  // On the polycube, of points from their target positions and then of curves from their lines, the farthest vertex of
  // each.
  Array<double> distances_before, distances;
  // What of the length of sharp edges is on edges of the polycube.
  double sharp_before = 0, sharp = 0;
  double sharp_length = 0;  // on the surface
  Certificate certificate;
  Distortion distortion_before, distortion;
};

// The map must be certified, and is again afterwards, to the very same polycube; its vertices keep their numbers up to
// those of the surface. Throws Error "invalid-argument" (places that are not on the polycube, vertices that do not
// exist or have two places, curves that are not along an axis), "no-valid-result" when something cannot be met, with
// the map as it was, "cancelled".
FeatureFit align_features(SurfaceMap& map, const FeatureOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
