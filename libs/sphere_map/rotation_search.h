// The rotation of one shape's sphere that brings it best into line with that of another: the one of greatest
// correlation between the positions that both have at a direction. Found by trying rotations all over SO(3), evenly,
// and refining the best of them.
#pragma once

#include <Eigen/Core>
#include <span>

#include "base/host.h"
#include "sphere_map/locator.h"

namespace orbicube::sphere_map {

struct CorrelatedRotation {
  Eigen::Matrix3d rotation;  // directions d of the moving shape go to rotation * d
  double correlation;        // from -1 to 1, which is reached when the shapes are similar, as they stand
};

// Positions are taken relative to their mean over the sphere, at any size: shapes should stand alike in space. On the
// threads of the host, the same bits for any number of them. About a tenth of a second of one core.
// Throws Error "invalid-argument" for sizes, "no-valid-result" when a shape is a single point, "cancelled".
CorrelatedRotation correlated_rotation(const Locator& moving, std::span<const Vector3> moving_positions,
                                       const Locator& fixed, std::span<const Vector3> fixed_positions,
                                       const base::Host& host);

}  // namespace orbicube::sphere_map
