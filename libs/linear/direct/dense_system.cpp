#include "linear/direct/dense_system.h"

#include <Eigen/LU>

namespace orbicube::linear {

Eigen::MatrixXd solve_dense(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

}  // namespace orbicube::linear
