// The proportions of a polycube that distort least (the dissertation's section 4.3): positions alpha of its planes and
// lengths beta between them, by the projected Barzilai-Borwein method with the total area as a penalty.
//
// Each rectangle's energies are constants times powers of its two lengths (eq. 4.5 to 4.7), as if its map were
// stretched with it. A rectangle over several lengths is as long as their sum.
#pragma once

#include "polycube/dissertation/patch_map.h"

namespace orbicube::polycube::dissertation {

// The objective of section 4.3.1, E + lambda (area - area0)^2 over area0, as a function of alpha and beta in units of
// the root of area0.
class DomainEnergy {
 public:
  DomainEnergy(const Layout& layout, std::span<const PatchEnergy> energy, double area_weight, const base::Host& host);

  std::size_t lengths() const { return lengths_; }       // N1 + N2 + N3
  std::size_t unknowns() const { return 2 * lengths_; }  // all alpha, then all beta; axis by axis
  std::size_t first(std::size_t axis) const { return first_[axis]; }
  double unit() const { return unit_; }
  std::span<const double> start() const { return start_; }

  // Without the penalty where `penalty` is 0.
  double evaluate(std::span<const double> x, double penalty, std::span<double> gradient) const;
  // Of all rectangles, in the unit.
  double area(std::span<const double> x) const;

 private:
  // From one length to another, exclusive, of the two axes of a rectangle, with the constants of eq. 4.5 and 4.7.
  struct Term {
    std::array<std::size_t, 2> begin, end;
    std::array<double, 2> harmonic;
    double stretch;
  };
  double length(const Term& term, std::size_t side, std::span<const double> x) const;

  std::array<std::size_t, 4> first_{};
  std::size_t lengths_ = 0;
  double unit_ = 0;
  Array<double> start_;
  Array<Term> terms_;
};

struct DomainShape {
  explicit DomainShape(std::pmr::memory_resource* memory)
      : planes{Array<double>(memory), Array<double>(memory), Array<double>(memory)} {}

  std::array<Array<double>, 3> planes;   // as in the layout, with exactly its area but for rounding
  double energy_before = 0, energy = 0;  // E over the area
  std::uint64_t evaluations = 0;
  bool converged = false;
};

// Throws Error "cancelled".
DomainShape optimize_domain_shape(const Layout& layout, std::span<const PatchEnergy> energy, double area_weight,
                                  const base::Host& host);

}  // namespace orbicube::polycube::dissertation
