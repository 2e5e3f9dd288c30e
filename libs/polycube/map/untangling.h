// Tied maps made positive, and then less distorted.
//
// Minimizes the sum over triangles of area / 2 [(|J|^2 + lambda (D^2 + 1)) / chi(D, eps)], with D = det J, over all
// variables of a tied map at once: patches, arcs and insides move together. chi(D, eps) = (D + sqrt(eps^2 + D^2)) / 2
// makes the energy finite where triangles are flipped; eps falls until none is (Garanzha, Kaporin, Kudryavtseva,
// Protais, Ray and Sokolov 2021, "Foldover-free maps in 50 lines of code"). With eps = 0 it is a barrier that keeps
// them positive. The steps are Gauss-Newton's: with t = chi' / chi, c = vec cof J and a = vec J, the block
// (1/chi) {I - t (c a^T + a c^T) + (t^2 |a|^2 + lambda [(1 - D t)^2 + t^2]) c c^T} is positive semidefinite.
#pragma once

#include "linear/sparse_system.h"
#include "polycube/map/tied_map.h"

namespace orbicube::polycube {

struct UntanglingLimits {
  int steps = 150;         // of Gauss-Newton until every triangle is positive
  double first_eps = 0;    // 0: from the worst determinant
  double area_weight = 1;  // lambda: how much changes of area count beside those of angles
};

class Untangling {
 public:
  Untangling(TiedMap& map, const base::Host& host);

  // Whether every triangle is positive, in floating point, at the end.
  bool untangle(const UntanglingLimits& limits);

  // Lowers the energy of a positive map in at most the given number of steps, and keeps it positive.
  void polish(int steps, double area_weight);

  std::size_t flipped() const { return flipped_; }
  // Of Gauss-Newton, by both.
  std::size_t steps_taken() const { return steps_taken_; }

 private:
  double min_determinant();
  double energy(std::span<const double> value) const;
  double assemble();
  double longest_positive_step() const;
  double step();
  double chi(double determinant, double* derivative) const;

  TiedMap& map_;
  const base::Host& host_;
  TiedTriangles triangles_;
  linear::SparseSystem system_;
  Array<std::array<std::uint32_t, 21>> places_;  // of the lower triangle of each triangle's 6 by 6 block
  Array<std::uint32_t> diagonal_;
  Eigen::VectorXd gradient_;
  Array<double> direction_;
  Array<double> trial_, longer_;
  double eps_ = 0;
  double lambda_ = 1;
  std::size_t flipped_ = 0, steps_taken_ = 0;
};

}  // namespace orbicube::polycube
