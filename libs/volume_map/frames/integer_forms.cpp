#include "volume_map/frames/integer_forms.h"

#include <algorithm>
#include <cstdlib>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::volume_map {
namespace {

// Factors beyond this are of no use, and sums of two of them are still integers.
constexpr std::int64_t max_factor = std::int64_t{1} << 30;

int small(std::int64_t factor) {
  if (std::abs(factor) > max_factor)
    throw base::Error("no-valid-result", "the equations between singular curves have no small solution");
  return static_cast<int>(factor);
}

}  // namespace

Index IntegerForms::of_unknown(Index unknown) {
  const IntegerTerm term{unknown, 1};
  return add({&term, 1});
}

Index IntegerForms::add(std::span<const IntegerTerm> terms) {
  if (terms.empty()) return 0;
  terms_.insert(terms_.end(), terms.begin(), terms.end());
  begin_.push_back(terms_.size());
  return static_cast<Index>(size() - 1);
}

Index IntegerForms::sum(Index a, int factor_a, Index b, int factor_b) {
  if (is_zero(b) && factor_a == 1) return a;
  if (is_zero(a) && factor_b == 1) return b;
  const std::size_t start = terms_.size();
  std::size_t i = begin_[a], j = begin_[b];
  const std::size_t end_a = begin_[a + 1], end_b = begin_[b + 1];
  while (i < end_a || j < end_b) {
    const bool from_a = j == end_b || (i < end_a && terms_[i].unknown <= terms_[j].unknown);
    const bool from_b = i == end_a || (j < end_b && terms_[j].unknown <= terms_[i].unknown);
    const Index unknown = from_a ? terms_[i].unknown : terms_[j].unknown;
    std::int64_t factor = 0;
    if (from_a) factor += std::int64_t{factor_a} * terms_[i++].factor;
    if (from_b) factor += std::int64_t{factor_b} * terms_[j++].factor;
    if (factor != 0) terms_.push_back({unknown, small(factor)});
  }
  if (terms_.size() == start) return 0;
  begin_.push_back(terms_.size());
  return static_cast<Index>(size() - 1);
}

SolutionLattice::SolutionLattice(std::size_t unknowns, std::pmr::memory_resource* memory)
    : unknowns_(unknowns), dimension_(unknowns), columns_(memory), product_(memory) {
  constexpr std::size_t most = 6000;
  if (unknowns > most) {
    throw base::Error("no-valid-result", "the field has " + base::counted(unknowns, "integer unknown") +
                                             ": more singular curves than can be laid on a grid");
  }
  columns_.assign(unknowns * unknowns, 0);
  for (std::size_t i = 0; i < unknowns; ++i)
    columns_[i * unknowns + i] = 1;
}

void SolutionLattice::require_zero(std::span<const IntegerTerm> form) {
  product_.assign(dimension_, 0);
  for (std::size_t c = 0; c < dimension_; ++c) {
    for (const IntegerTerm& term : form)
      product_[c] += term.factor * columns_[c * unknowns_ + term.unknown];
  }
  while (true) {
    // The minimum factor divides the others, until it is alone.
    std::size_t pivot = dimension_, others = 0;
    for (std::size_t c = 0; c < dimension_; ++c) {
      if (product_[c] == 0) continue;
      ++others;
      if (pivot == dimension_ || std::abs(product_[c]) < std::abs(product_[pivot])) pivot = c;
    }
    if (others == 0) return;
    if (others == 1) {
      // Out with it; the last takes its place.
      --dimension_;
      const auto column = [&](std::size_t c) { return columns_.begin() + static_cast<std::ptrdiff_t>(c * unknowns_); };
      std::copy(column(dimension_), column(dimension_) + static_cast<std::ptrdiff_t>(unknowns_), column(pivot));
      return;
    }
    for (std::size_t c = 0; c < dimension_; ++c) {
      if (c == pivot || product_[c] == 0) continue;
      const std::int64_t q = product_[c] / product_[pivot];
      product_[c] -= q * product_[pivot];
      for (std::size_t u = 0; u < unknowns_; ++u) {
        std::int64_t& entry = columns_[c * unknowns_ + u];
        entry -= q * columns_[pivot * unknowns_ + u];
        small(entry);
      }
    }
  }
}

void SolutionLattice::express(std::span<const IntegerTerm> form, Array<IntegerTerm>& result) const {
  result.clear();
  for (std::size_t c = 0; c < dimension_; ++c) {
    std::int64_t sum = 0;
    for (const IntegerTerm& term : form)
      sum += term.factor * columns_[c * unknowns_ + term.unknown];
    if (sum != 0) result.push_back({static_cast<Index>(c), small(sum)});
  }
}

}  // namespace orbicube::volume_map
