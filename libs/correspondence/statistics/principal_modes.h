// Mean and principal modes of a population of shapes on one triangulation, by the eigenvectors of the Gram matrix of
// the centered coordinates (Cootes et al. 1995, "Active shape models").
#pragma once

#include <Eigen/Core>

#include "base/host.h"

namespace orbicube::correspondence {

// One row a subject, of x y z a point.
using Population = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct PrincipalModes {
  Eigen::VectorXd mean;       // 3 a point
  Eigen::VectorXd variances;  // of the modes, decreasing, over subjects minus one
  Eigen::MatrixXd modes;      // a column a mode: a unit vector whose largest entry is positive
  Eigen::MatrixXd scores;     // a row a subject, a column a mode
};

// Computes the modes whose variance is more than rounding. Throws Error "invalid-argument" for less than two subjects
// or values that are not finite, "cancelled".
PrincipalModes principal_modes(const Population& subjects, const base::Host& host);

}  // namespace orbicube::correspondence
