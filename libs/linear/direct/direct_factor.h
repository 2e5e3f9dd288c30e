// Factors L D L' of sparse symmetric positive definite matrices, by one of several engines.
#pragma once

#include <memory>
#include <span>

#include "linear/types.h"

namespace orbicube::linear {

enum class DirectMethod {
  automatic,           // CHOLMOD's supernodal ones for patterns that make them faster, where the program provides them
  eigen,               // Eigen's simplicial factors, part of this library
  cholmod_simplicial,  // Chen, Davis, Hager and Rajamanickam 2008
  cholmod_supernodal,  // blocks of columns, by BLAS
};

class DirectFactor {
 public:
  DirectFactor() = default;
  virtual ~DirectFactor() = default;
  DirectFactor(const DirectFactor&) = delete;
  DirectFactor& operator=(const DirectFactor&) = delete;

  // Orders the unknowns and finds the pattern of L. Later matrices have the same pattern.
  virtual void analyze(const SparseMatrix& matrix) = 0;
  // Returns whether all pivots are other than zero (simplicial) or positive (supernodal).
  virtual bool factorize(const SparseMatrix& matrix) = 0;
  // Solves for each of `columns` right sides, one behind the other. `solution` may be `right`.
  virtual void solve(std::span<const double> right, std::size_t columns, std::span<double> solution) const = 0;

  // Changes row and column `row` of the factorized matrix to those of the identity, in time of the entries that L has
  // behind them (Davis and Hager 2005, "Row modifications of a sparse Cholesky factorization").
  virtual void remove_row(Index row) = 0;
  // Adds `sign` (1 or -1) times w w' to the factorized matrix, for the w with these entries (Davis and Hager 1999,
  // "Modifying a sparse Cholesky factorization"). All pairs of `rows` must be entries of the pattern. Returns whether
  // the result is positive definite; where it is not, the factor must be computed again.
  virtual bool update(std::span<const Index> rows, std::span<const double> values, int sign) = 0;

  // Returns whether all pivots are positive, as they are of a positive definite matrix.
  virtual bool is_positive() const = 0;
  // Entries of L below its diagonal.
  virtual std::size_t entries() const = 0;
  // Floating-point operations of a factorization over the entries of L, known once the pattern is analyzed; 0 where the
  // engine does not count them.
  virtual double operations_per_entry() const { return 0; }
};

// Throws Error "unsupported" for a method of CHOLMOD where the program does not provide it.
std::unique_ptr<DirectFactor> make_direct_factor(DirectMethod method);

// A program that links CHOLMOD calls this before its first factor (cholmod_factor.h). The library itself never links
// CHOLMOD unless built to: its license covers programs that contain it.
using MakeFactor = std::unique_ptr<DirectFactor> (*)(DirectMethod method);
void provide_cholmod(MakeFactor make);
bool has_cholmod();

}  // namespace orbicube::linear
