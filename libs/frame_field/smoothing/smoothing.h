// Brings a field to a local minimum of the energy.
//
// Each step turns every frame q to exp(t / 2) q by a rotation vector t in space. There the matchings, which act on the
// other side, do not matter, and near a minimum the energy is a quarter of sum w |t_j - t_i + d_ij|^2, where d_ij is
// the rotation from frame i to frame j: the steps of Gauss and Newton are three graph Laplacians (graph_solver.h),
// solved roughly, with the exact gradient on the right. Matchings are found again in every step. Boundary frames turn
// about their normals.
#pragma once

#include <cstdint>

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"
#include "frame_field/graph/hierarchy.h"

namespace orbicube::frame_field {

struct SmoothingOptions {
  double relative_gain = 1e-5;  // ends when a step lowers the energy by less than this part of it
  std::uint32_t max_steps = 50;
  bool choose_normals = true;  // tetrahedra with several boundary faces may change the direction of their axis
};

struct SmoothingResult {
  double energy = 0;  // with that of the pulls
  std::uint32_t steps = 0;
  std::uint32_t solver_iterations = 0;
};

// `field` satisfies the constraints, and does so to rounding afterwards. With choose_normals, constraints change places
// with their alternatives. O(n) a step. Throws Error "cancelled".
SmoothingResult smooth(const DualGraph& graph, std::span<const CoarseGraph> hierarchy, Constraints& constraints,
                       const SmoothingOptions& options, const base::Host& host, Field& field);

}  // namespace orbicube::frame_field
