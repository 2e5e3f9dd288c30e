#include "linear/direct/direct_factor.h"

#include <atomic>

#include "base/error.h"
#include "linear/direct/simplicial_factor.h"

namespace orbicube::linear {
namespace {

std::atomic<MakeFactor> make_by_cholmod{nullptr};

// Chooses the engine by the pattern.
class AutomaticFactor : public DirectFactor {
 public:
  explicit AutomaticFactor(MakeFactor make) : make_(make) {}

  void analyze(const SparseMatrix& matrix) override {
    // bench-linear: with the slowest BLAS supernodal factors are 1.3 times as fast from some 300 operations an entry
    // on, half as fast at 100. Small systems take less than the analysis.
    constexpr double enough_operations = 200;
    constexpr int min_rows = 5000;
    if (matrix.rows() >= min_rows) {
      factor_ = make_(DirectMethod::cholmod_supernodal);
      factor_->analyze(matrix);
      if (factor_->operations_per_entry() >= enough_operations) return;
    }
    factor_ = std::make_unique<SimplicialFactor>();
    factor_->analyze(matrix);
  }
  bool factorize(const SparseMatrix& matrix) override { return factor_->factorize(matrix); }
  void solve(std::span<const double> right, std::size_t columns, std::span<double> solution) const override {
    factor_->solve(right, columns, solution);
  }
  void remove_row(Index row) override { factor_->remove_row(row); }
  bool update(std::span<const Index> rows, std::span<const double> values, int sign) override {
    return factor_->update(rows, values, sign);
  }
  bool is_positive() const override { return factor_->is_positive(); }
  std::size_t entries() const override { return factor_->entries(); }
  double operations_per_entry() const override { return factor_->operations_per_entry(); }

 private:
  MakeFactor make_;
  std::unique_ptr<DirectFactor> factor_;
};

}  // namespace

void provide_cholmod(MakeFactor make) {
  make_by_cholmod = make;
}

bool has_cholmod() {
  return make_by_cholmod != nullptr;
}

std::unique_ptr<DirectFactor> make_direct_factor(DirectMethod method) {
  const MakeFactor make = make_by_cholmod;
  if (method == DirectMethod::automatic && make != nullptr) return std::make_unique<AutomaticFactor>(make);
  if (method == DirectMethod::automatic || method == DirectMethod::eigen) return std::make_unique<SimplicialFactor>();
  if (make == nullptr)
    throw base::Error("unsupported",
                      "CHOLMOD is not part of this build; use the method Eigen, or build with "
                      "-Dcholmod_in_libraries=true");
  return make(method);
}

}  // namespace orbicube::linear
