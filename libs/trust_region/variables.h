// The unknowns as the method sees them: those whose bounds leave room, divided by their scale, and without bounds in
// coordinates u that the run may change, x / scale = T u. Turning them back gives values within the caller's bounds to
// the bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "trust_region/problem.h"
#include "trust_region/tridiagonal.h"

namespace orbicube::trust_region {

class Variables {
 public:
  // Throws invalid-argument.
  Variables(const Problem& problem, std::pmr::memory_resource* memory);

  std::size_t size() const { return full_lower_.size(); }
  std::size_t free_size() const { return free_.size(); }
  bool bounded() const { return bounded_; }
  const double* lower() const { return lower_.data(); }  // of the free unknowns, scaled
  const double* upper() const { return upper_.data(); }

  void to_free(std::span<const double> x, double* u) const;  // before T changes
  void from_free(const double* u, std::span<double> x);
  void clip(double* u) const;
  bool within_bounds(std::span<const double> x) const;
  // T becomes T `inverse`; only without bounds.
  void transform(const double* inverse);
  // The largest stretch |T u| / |u|; T is divided by it. work: free_size() entries.
  double normalise(Tridiagonal& solver, double* work);
  std::uint64_t fingerprint() const { return fingerprint_; }

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(&self.turned_, 1));
    visit(std::span(self.turn_));
  }

 private:
  base::Array<double> full_lower_, full_upper_, full_scale_;
  base::Array<std::uint32_t> free_;
  base::Array<double> lower_, upper_, scale_;
  bool bounded_ = false;
  std::uint64_t turned_ = 0;              // 1 once T is not the identity
  base::Array<double> turn_, turn_work_;  // T (free x free by rows), empty with bounds
  std::uint64_t fingerprint_ = 0;
};

}  // namespace orbicube::trust_region
