// Generalized Procrustes analysis (Gower 1975): all shapes of a group translated and rotated to their own mean, and
// scaled to one size if requested. Each point of a shape counts the same; robust_placement.h weights points.
#pragma once

#include <vector>

#include "base/host.h"
#include "correspondence/pose.h"
#include "correspondence/statistics/principal_modes.h"

namespace orbicube::correspondence {

struct GroupPose {
  std::vector<Similarity> moved;  // what each shape was moved by
  std::size_t rounds = 0;         // until the mean stayed
  bool converged = true;          // the mean stayed before the limit of rounds
};

// Moves the shapes so that the sum of squared distances to their mean is minimum. With Pose::scaled, each has the mean
// of all sizes (root mean square distance from the center) afterwards. The mean stands where the first shape stood.
// Throws Error "invalid-argument" for no shape or values that are not finite, "degenerate-geometry" for a shape whose
// points are all in one place, "cancelled".
GroupPose place_group(Pose pose, Population& shapes, const base::Host& host);

// Moves shape i by x -> rotation * x + shift, and adds that to what it was moved by.
void move_shape(Population& shapes, Eigen::Index i, const Eigen::Matrix3d& rotation, const mesh::Vector3& shift,
                Similarity& moved);

// Returns the distance between each two shapes: the root mean square of that between their points.
Eigen::MatrixXd distances_between(const Population& shapes, const base::Host& host);

}  // namespace orbicube::correspondence
