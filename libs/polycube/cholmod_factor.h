// CHOLMOD's simplicial factors (Chen, Davis, Hager and Rajamanickam 2008) in place of Eigen's, where the option
// `cholmod` asks for them. What links CHOLMOD as it is usually built is bound by the GPL, of which some of its modules
// are.
#pragma once

#include <suitesparse/cholmod.h>

#include <Eigen/SparseCore>
#include <cstring>
#include <new>

namespace orbicube::polycube {

// What SparseSystem needs of a solver: L D L' of the lower triangle of a symmetric matrix whose pattern is analysed
// once.
class CholmodFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  CholmodFactor() {
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SIMPLICIAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    common_.print = 0;
  }
  ~CholmodFactor() {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  void analyzePattern(const Matrix& matrix) {
    cholmod_sparse view = view_of(matrix);
    cholmod_free_factor(&factor_, &common_);
    factor_ = cholmod_analyze(&view, &common_);
    require_memory();
  }
  void factorize(const Matrix& matrix) {
    cholmod_sparse view = view_of(matrix);
    cholmod_factorize(&view, factor_, &common_);
    require_memory();
    solvable_ = common_.status == CHOLMOD_OK;
  }
  Eigen::ComputationInfo info() const { return solvable_ ? Eigen::Success : Eigen::NumericalIssue; }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    cholmod_dense view{};
    view.nrow = view.nzmax = view.d = static_cast<std::size_t>(right.size());
    view.ncol = 1;
    view.x = const_cast<double*>(right.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor_, &view, &common_);
    require_memory();
    Eigen::VectorXd result(right.size());
    std::memcpy(result.data(), solution->x, static_cast<std::size_t>(right.size()) * sizeof(double));
    cholmod_free_dense(&solution, &common_);
    return result;
  }

  // Row and column become those of the identity, for what is known from then on.
  void remove_row(int row) {
    const int* const permutation = static_cast<const int*>(factor_->Perm);
    int place = 0;
    while (permutation[place] != row)
      ++place;
    cholmod_rowdel(static_cast<std::size_t>(place), nullptr, factor_, &common_);
    require_memory();
  }

 private:
  static cholmod_sparse view_of(const Matrix& matrix) {
    cholmod_sparse view{};
    view.nrow = static_cast<std::size_t>(matrix.rows());
    view.ncol = static_cast<std::size_t>(matrix.cols());
    view.nzmax = static_cast<std::size_t>(matrix.nonZeros());
    view.p = const_cast<int*>(matrix.outerIndexPtr());
    view.i = const_cast<int*>(matrix.innerIndexPtr());
    view.x = const_cast<double*>(matrix.valuePtr());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
  }
  void require_memory() const {
    if (common_.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  }

  mutable cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  bool solvable_ = false;
};

}  // namespace orbicube::polycube
