#include "linear/direct/cholmod_factor.h"

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

namespace orbicube::linear {
namespace {

class CholmodFactor : public DirectFactor {
 public:
  explicit CholmodFactor(bool supernodal) {
    cholmod_start(&common_);
    common_.supernodal = supernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    common_.final_ll = supernodal ? 1 : 0;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
    common_.print = 0;
  }
  ~CholmodFactor() override {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }

  void analyze(const SparseMatrix& matrix) override {
    cholmod_sparse view = view_of(matrix);
    cholmod_free_factor(&factor_, &common_);
    factor_ = cholmod_analyze(&view, &common_);
    require_memory();
    operations_per_entry_ = common_.lnz > 0 ? common_.fl / common_.lnz : 0;
  }

  bool factorize(const SparseMatrix& matrix) override {
    cholmod_sparse view = view_of(matrix);
    cholmod_factorize(&view, factor_, &common_);
    require_memory();
    return common_.status == CHOLMOD_OK && factor_->minor == factor_->n;
  }

  void solve(std::span<const double> right, std::size_t columns, std::span<double> solution) const override {
    if (right.empty()) return;
    cholmod_dense view{};
    view.nrow = view.d = right.size() / columns;
    view.ncol = columns;
    view.nzmax = right.size();
    view.x = const_cast<double*>(right.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* found = cholmod_solve(CHOLMOD_A, factor_, &view, &common_);
    require_memory();
    std::copy_n(static_cast<const double*>(found->x), right.size(), solution.begin());
    cholmod_free_dense(&found, &common_);
  }

  void remove_row(Index row) override {
    make_simplicial();
    cholmod_rowdel(place_of(row), nullptr, factor_, &common_);
    require_memory();
  }

  bool update(std::span<const Index> rows, std::span<const double> values, int sign) override {
    make_simplicial();
    const std::size_t count = rows.size();
    std::vector<std::pair<int, double>> sorted(count);
    for (std::size_t i = 0; i < count; ++i)
      sorted[i] = {static_cast<int>(place_of(rows[i])), values[i]};
    std::sort(sorted.begin(), sorted.end());
    cholmod_sparse* w = cholmod_allocate_sparse(factor_->n, 1, count, 1, 1, 0, CHOLMOD_REAL, &common_);
    require_memory();
    for (std::size_t i = 0; i < count; ++i) {
      static_cast<int*>(w->i)[i] = sorted[i].first;
      static_cast<double*>(w->x)[i] = sorted[i].second;
    }
    static_cast<int*>(w->p)[1] = static_cast<int>(count);
    cholmod_updown(sign > 0 ? 1 : 0, w, factor_, &common_);
    cholmod_free_sparse(&w, &common_);
    require_memory();
    return common_.status == CHOLMOD_OK && is_positive();
  }

  bool is_positive() const override {
    if (factor_->is_ll != 0) return true;  // else there is no factor
    const int* const begin = static_cast<const int*>(factor_->p);
    for (std::size_t j = 0; j < factor_->n; ++j) {
      if (!(static_cast<const double*>(factor_->x)[begin[j]] > 0)) return false;
    }
    return true;
  }

  std::size_t entries() const override {
    if (factor_->is_super != 0) return factor_->xsize;
    const int* const counts = static_cast<const int*>(factor_->ColCount);
    std::size_t sum = 0;
    for (std::size_t j = 0; j < factor_->n; ++j)
      sum += static_cast<std::size_t>(counts[j]) - 1;
    return sum;
  }

  double operations_per_entry() const override { return operations_per_entry_; }

 private:
  static cholmod_sparse view_of(const SparseMatrix& matrix) {
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

  // CHOLMOD changes L D L' factors only.
  void make_simplicial() {
    cholmod_change_factor(CHOLMOD_REAL, 0, 0, 0, 0, factor_, &common_);
    require_memory();
  }

  std::size_t place_of(Index row) const {
    const int* const permutation = static_cast<const int*>(factor_->Perm);
    return static_cast<std::size_t>(std::find(permutation, permutation + factor_->n, static_cast<int>(row)) -
                                    permutation);
  }

  void require_memory() const {
    if (common_.status == CHOLMOD_OUT_OF_MEMORY || common_.status == CHOLMOD_TOO_LARGE) throw std::bad_alloc();
  }

  mutable cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  double operations_per_entry_ = 0;
};

}  // namespace

std::unique_ptr<DirectFactor> make_cholmod_factor(DirectMethod method) {
  return std::make_unique<CholmodFactor>(method == DirectMethod::cholmod_supernodal);
}

std::string cholmod_version_text() {
  int version[3];
  cholmod_version(version);
  return std::to_string(version[0]) + "." + std::to_string(version[1]) + "." + std::to_string(version[2]);
}

}  // namespace orbicube::linear
