// Sums of integer multiples of unknown integers, and the lattice of the solutions of equations between them.
#pragma once

#include <span>

#include "base/host.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

struct IntegerTerm {
  Index unknown;
  int factor;
  bool operator==(const IntegerTerm&) const = default;
};

// Forms by number, in one flat array. Number 0 is nothing.
class IntegerForms {
 public:
  explicit IntegerForms(std::pmr::memory_resource* memory) : terms_(memory), begin_(2, 0, memory) {}

  std::span<const IntegerTerm> terms(Index form) const {
    return {terms_.data() + begin_[form], begin_[form + 1] - begin_[form]};
  }
  std::size_t size() const { return begin_.size() - 1; }
  bool is_zero(Index form) const { return terms(form).empty(); }
  Index of_unknown(Index unknown);
  // factor_a a + factor_b b. Unknowns in each form are in ascending order. Throws Error "no-valid-result" for factors
  // beyond 2^30.
  Index sum(Index a, int factor_a, Index b, int factor_b);
  // With terms in ascending order of unknowns, and no factor 0.
  Index add(std::span<const IntegerTerm> terms);

 private:
  Array<IntegerTerm> terms_;
  Array<std::size_t> begin_;
};

// All integer solutions z = N c of homogeneous equations, c any integers: N stays a basis of them.
class SolutionLattice {
 public:
  SolutionLattice(std::size_t unknowns, std::pmr::memory_resource* memory);

  // From now on the form is 0. Euclid's steps on the columns of N leave one with a factor, which goes. Throws Error
  // "no-valid-result" where entries grow beyond 2^30. O(unknowns^2) at most for equations of few terms.
  void require_zero(std::span<const IntegerTerm> form);

  std::size_t dimension() const { return dimension_; }
  // The form in the coefficients c, which are numbered in the order of what is left of the unknowns. Throws the same.
  void express(std::span<const IntegerTerm> form, Array<IntegerTerm>& result) const;

 private:
  std::size_t unknowns_, dimension_;
  Array<std::int64_t> columns_;  // one after another
  Array<std::int64_t> product_;
};

}  // namespace orbicube::volume_map
