// The limited-memory BFGS model of the Hessian as a full matrix, for few unknowns in a box: cheaper than the compact
// form where there are as many pairs as unknowns. Its minimizer in a face is by a Cholesky factor, that without bounds
// by the pairs alone (the two loops of Nocedal 1980).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "projected_gradient/hessian_model.h"

namespace orbicube::projected_gradient {

class DenseModel final : public HessianModel {
 public:
  // Room for `capacity` pairs of n entries: 2 n (n + capacity) numbers.
  DenseModel(std::size_t n, std::size_t capacity, std::pmr::memory_resource* memory);

  std::size_t size() const { return n_; }
  void clear() override { count_ = 0; }
  bool push(std::span<const double> s, std::span<const double> y, double sigma) override;
  bool minimise(std::span<const double> gradient, std::span<double> d, const base::Host& host) override;
  void prepare() override;
  void multiply(std::span<const double> v, std::span<double> out, const base::Host& host) const override;
  bool enter_face(const FeasibleSet& set, const base::Host& host) override;
  void minimise_in_face(const FeasibleSet& set, std::span<const double> gradient, std::span<double> d,
                        const base::Host& host) const override;

  // Shows every part of the state to `visit` as spans of numbers, for saving and loading; then prepare() when it is
  // needed.
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(self.steps_));
    visit(std::span(self.changes_));
    visit(std::span(self.curvatures_));
    visit(std::span(&self.sigma_, 1));
    visit(std::span(&self.count_, 1));
    visit(std::span(&self.next_, 1));
  }

 private:
  bool rebuild();
  bool add_pair(std::size_t slot);
  void multiply_matrix(const double* v) const;

  std::size_t n_, capacity_;
  std::uint64_t next_ = 0;               // the slot of the next pair
  base::Array<double> steps_, changes_;  // a ring of pairs, n each, scaled to |s| = 1
  base::Array<double> curvatures_;       // s'y of the pairs
  base::Array<double> parts_;            // of the pairs, for minimise()
  base::Array<double> matrix_;           // B by rows, where the model is prepared and not empty
  base::Array<double> factor_;           // upper Cholesky factor of B in the face, rows of n_
  base::Array<std::uint32_t> in_face_;   // the free unknowns
  std::size_t face_size_ = 0;
  mutable base::Array<double> product_;  // n
};

}  // namespace orbicube::projected_gradient
