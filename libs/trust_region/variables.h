// The unknowns as the method sees them: those whose bounds leave room, divided by their scale, and without bounds in
// coordinates u that the run may change, x / scale = T u. Turning them back gives values within the caller's bounds to
// the bit. Where the caller gives no scale and the unknowns are of unlike units, the scale is that of their boxes, or
// of their start.
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
  // Radii for more unknowns stay round: T needs eigenvectors, which take a while.
  static constexpr std::size_t max_turned = 200;

  // `start` (empty for a run that is loaded: its scale is part of its state) and whether the caller gave the first
  // radius choose the scale where the problem has none. Throws invalid-argument.
  Variables(const Problem& problem, std::span<const double> start, bool radius_given,
            std::pmr::memory_resource* memory);
  // Makes room for T.
  void allow_turns();

  std::size_t size() const { return full_lower_.size(); }
  std::size_t free_size() const { return free_.size(); }
  bool bounded() const { return bounded_; }
  // Whether the scale is that of boxes and start, where lengths of 1 are whole boxes.
  bool scaled_by_boxes() const { return scaled_by_boxes_; }
  double scale(std::size_t k) const { return scale_[k]; }  // of free unknown k
  const double* lower() const { return lower_.data(); }    // of the free unknowns, scaled
  const double* upper() const { return upper_.data(); }

  void to_free(std::span<const double> x, double* u) const;  // before T changes
  void from_free(const double* u, std::span<double> x);
  void clip(double* u) const;
  bool within_bounds(std::span<const double> x) const;
  // T becomes T `inverse`; only without bounds.
  void transform(const double* inverse);
  // The largest stretch |T u| / |u|; T is divided by it. work: free_size() entries.
  double normalize(Tridiagonal& solver, double* work);
  std::uint64_t fingerprint() const { return fingerprint_; }

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(&self.turned_, 1));
    for (auto* array : {&self.turn_, &self.scale_, &self.lower_, &self.upper_})
      visit(std::span(*array));
  }

 private:
  void choose_scale(const Problem& problem, std::span<const double> start, bool radius_given);

  base::Array<double> full_lower_, full_upper_;
  base::Array<std::uint32_t> free_;
  base::Array<double> lower_, upper_, scale_;
  bool bounded_ = false, scaled_by_boxes_ = false;
  std::uint64_t turned_ = 0;              // 1 once T is not the identity
  base::Array<double> turn_, turn_work_;  // T (free x free by rows), empty with bounds
  std::uint64_t fingerprint_ = 0;
};

}  // namespace orbicube::trust_region
