// Small systems without structure. They are solved in one place, since the code of Eigen's factors takes long to
// compile.
#pragma once

#include <Eigen/Core>

namespace orbicube::linear {

// The x of matrix x = right, by Gauss's elimination with pivots among the rows. The matrix is square and regular.
Eigen::MatrixXd solve_dense(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

}  // namespace orbicube::linear
