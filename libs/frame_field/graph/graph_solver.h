// Solves (mass + tau L) x = b on the dual graph for one short vector a node, where L is the graph's Laplacian and some
// nodes may move in a few directions only: conjugate gradients, preconditioned by a multigrid cycle over the hierarchy
// (or by the diagonal when the mass is what counts). Nothing is factorized; float32 storage, sums in double.
//
// Not a linear::Multigrid, whose matrices have a block of doubles a link: here one float a link serves all components,
// which makes a sweep a pass over the vectors alone.
//
// The coarse grids treat all components alike and hold the constrained nodes by a penalty on the directions in which
// these cannot move: a preconditioner may be inexact, and this one needs a matrix only where a group has such nodes.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "frame_field/graph/dual_graph.h"
#include "frame_field/graph/hierarchy.h"

namespace orbicube::frame_field {

// components: 9 for harmonics, 3 for rotations; stored with a stride of 12 and 4 floats.
template <std::size_t components>
class GraphSolver {
 public:
  static constexpr std::size_t stride = (components + 3) / 4 * 4;
  static constexpr std::size_t directions = components == 9 ? 2 : 1;
  struct alignas(16) Value {
    std::array<float, stride> at{};
  };
  // The directions, of length 1 and orthogonal, in which a node can move; zero where it has fewer.
  struct Tangent {
    Index node;
    std::array<Value, directions> direction;
  };
  struct Equation {
    float tau = 1;                     // factor of the Laplacian
    std::span<const float> mass = {};  // by node; empty for zero everywhere
    double tolerance = 1e-3;           // relative, of the residual in the preconditioner's norm
    std::uint32_t max_iterations = 500;
    const char* phase = "";  // for progress
  };
  struct Outcome {
    std::uint32_t iterations = 0;
    double reduction = 1;  // of the residual
  };

  // `tangents` in ascending order of nodes; all three must outlive the solver. Memory: 5 vectors a node and a fifth of
  // that for the coarse graphs.
  GraphSolver(const DualGraph& graph, std::span<const CoarseGraph> hierarchy, std::span<const Tangent> tangents,
              const base::Host& host);

  // `x` is the start, and satisfies the constraints; it moves along the tangents only. `right` is empty for zero.
  Outcome solve(const Equation& equation, std::span<const Value> right, std::span<Value> x);

 private:
  struct System;
  struct Level {
    explicit Level(std::pmr::memory_resource* memory)
        : penalty_of(memory),
          penalty(memory),
          penalty_size(memory),
          mass(memory),
          right(memory),
          x(memory),
          residual(memory) {}

    Index rows_of(Index group);

    Array<Index> penalty_of;    // by node; no_index where there is none
    Array<Value> penalty;       // `components` rows of a matrix each
    Array<float> penalty_size;  // upper bound of the largest eigenvalue
    Array<float> mass;
    Array<Value> right, x, residual;
  };

  void add_tangents(const CoarseGraph& coarse, Level& level) const;
  static void add_penalties(const Level& finer, const CoarseGraph& coarse, Level& level);
  void project(std::span<Value> v, std::size_t begin, std::size_t end) const;
  // body(begin, end, chunk), on threads where the graph is large.
  template <class Body>
  void sweep(const Body& body) const {
    for_each_chunk(host_, graph_.size(), body, least_of_little);
  }
  // y = (mass + tau L) x, projected; returns x . y.
  double apply(const Equation& e, std::span<const Value> x, std::span<Value> y);
  // z = about A^-1 r, where z holds the first Jacobi step already; returns r . z.
  double precondition(const Equation& e, std::span<const Value> r, std::span<Value> z);
  void cycle(const Equation& e, std::size_t level);
  void coarse_residual(const Equation& e, std::size_t level);
  void coarse_smooth(const Equation& e, std::size_t level);
  void restrict_mass(const Equation& e);
  float diagonal(const Equation& e, std::size_t node) const;
  double sum_chunks() const;

  const DualGraph& graph_;
  std::span<const CoarseGraph> hierarchy_;
  std::span<const Tangent> tangents_;
  const base::Host& host_;
  Array<Level> levels_;
  Array<std::size_t> tangent_begin_;  // by chunk
  Array<Value> residual_, search_, image_, correction_;
  Array<double> partial_;  // sums by chunk
  bool multigrid_ = true;
};

extern template class GraphSolver<3>;
extern template class GraphSolver<9>;

}  // namespace orbicube::frame_field
