#include "polycube/dense_system.h"

#include <Eigen/LU>

namespace orbicube::polycube {

Eigen::MatrixXd solve_dense(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.partialPivLu().solve(right);
}

}  // namespace orbicube::polycube
