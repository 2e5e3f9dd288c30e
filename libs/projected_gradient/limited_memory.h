// The limited-memory BFGS model of the Hessian in its compact form (Byrd, Nocedal, Schnabel 1994),
//   B = sigma I - W N^-1 W',  W = [sigma S, Y],  N = [sigma S'S, L; L', -D],
// with L the strictly lower and D the diagonal part of S'Y, and the minimizer of a quadratic with this Hessian in a
// face.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "projected_gradient/hessian_model.h"

namespace orbicube::projected_gradient {

class LimitedMemory final : public HessianModel {
 public:
  // Room for `capacity` pairs of n entries, 2 capacity n numbers, and for faces with m rows.
  LimitedMemory(std::size_t n, std::size_t m, std::size_t capacity, std::pmr::memory_resource* memory);

  void clear() override {
    count_ = 0;
    newest_ = 0;
  }
  // Drops the oldest pair when full.
  bool push(std::span<const double> s, std::span<const double> y, double sigma) override;
  // By the compact form of B^-1 (theorem 2.2 there).
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
    visit(std::span(self.table_));
    visit(std::span(self.step_products_));
    visit(std::span(self.mixed_products_));
    visit(std::span(self.change_products_));
    visit(std::span(&self.sigma_, 1));
    visit(std::span(&self.count_, 1));
    visit(std::span(&self.newest_, 1));
  }

 private:
  // The matrices that follow from the products; false when N is singular.
  bool rebuild();
  // Slot of the pair added `age` pushes before the newest.
  std::size_t slot_of_age(std::size_t age) const { return (newest_ + capacity_ - age) % capacity_; }
  std::size_t age_of_slot(std::size_t slot) const { return (newest_ + capacity_ - slot) % capacity_; }
  // products_ = [S, Y]'v.
  void multiply_table(std::span<const double> v, const base::Host& host) const;
  // out = [S, Y] products_.
  void multiply_by_table(std::span<double> out, const base::Host& host) const;
  // products_ <- diag(sigma, 1) M^-1 diag(sigma, 1) products_, with M by its factors.
  void solve_middle(std::span<const double> factors, std::span<const std::uint32_t> pivots) const;

  std::size_t n_, capacity_;
  std::uint64_t newest_ = 0;
  base::Array<double> table_;            // n rows of [s_0 .. s_c-1, y_0 .. y_c-1], each pair scaled to |s| = 1
  base::Array<double> step_products_;    // S'S, capacity x capacity
  base::Array<double> mixed_products_;   // S'Y: row s, column y
  base::Array<double> change_products_;  // Y'Y
  base::Array<double> plain_middle_, middle_, face_middle_;  // N, its LU, and that of N - U'U / sigma with U = P W
  base::Array<std::uint32_t> middle_pivots_, face_pivots_;
  base::Array<double> gram_;                       // (2 capacity)^2
  base::Array<double> row_products_, row_column_;  // A_F [S Y], m x 2 capacity; one of its columns
  mutable base::Array<double> products_, dense_;   // 2 capacity: as wide as the table; packed
};

}  // namespace orbicube::projected_gradient
