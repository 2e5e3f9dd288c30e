// The limited-memory BFGS direction on a product of spheres (Huang, Gallivan, Absil 2015, "A Broyden class of
// quasi-Newton methods for Riemannian optimization"): steps and changes of the gradient are tangent vectors, carried
// along with the iterate by parallel transport, which keeps their products.
#pragma once

#include <cstdint>
#include <functional>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "sphere_optimizer/problem.h"

namespace orbicube::sphere_optimizer {

class LimitedMemory {
 public:
  LimitedMemory(const Shape& shape, std::size_t capacity, std::pmr::memory_resource* memory);

  std::size_t count() const { return count_; }
  void clear() { count_ = 0; }

  // Called between passes over the unknowns, so that a host can cancel; may throw.
  using Tick = std::function<void()>;

  // Carries every pair from the tangent space at `from` to that at `to`.
  void transport(std::span<const double> from, std::span<const double> to, const Tick& tick);
  // Adds step and change of gradient, dropping the oldest pair when full; nothing happens when their product is not
  // safely positive.
  void push(std::span<const double> step, std::span<const double> change);
  // direction = -H gradient, by the two loops over the pairs (Nocedal 1980), around the inverse of `curvature` (one
  // number a block) times whatever fits the newest pair. There must be pairs.
  void descend(std::span<const double> gradient, std::span<const double> curvature, std::span<double> direction,
               const Tick& tick);

  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(self.steps_));
    visit(std::span(self.changes_));
    visit(std::span(self.products_));
    visit(std::span(&self.count_, 1));
    visit(std::span(&self.newest_, 1));
  }

 private:
  std::size_t slot_of_age(std::size_t age) const { return (newest_ + capacity_ - age) % capacity_; }
  std::span<double> row(base::Array<double>& table, std::size_t slot) const {
    return {table.data() + slot * shape_.size(), shape_.size()};
  }

  Shape shape_;
  std::size_t capacity_;
  std::uint64_t count_ = 0, newest_ = 0;
  base::Array<double> steps_, changes_;  // capacity rows of N d numbers
  base::Array<double> products_;         // s'y of each pair
  base::Array<double> coefficients_;     // of the first loop
};

}  // namespace orbicube::sphere_optimizer
