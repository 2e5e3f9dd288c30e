// Starts and large rearrangements of a field through its harmonics (harmonic_frame.h), which average where quaternions
// cannot: the harmonic start (Ray, Sokolov, Levy 2016), and the diffusion-generated method of Merriman, Bence and Osher
// as Palmer, Bommes and Solomon (2020, "Algebraic representations for volumetric frame fields") use it: diffuse the
// coefficients for a while, bring each back to the nearest frame, again and again with ever shorter times.
#pragma once

#include <cstdint>
#include <span>

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"
#include "frame_field/graph/graph_solver.h"
#include "frame_field/graph/hierarchy.h"
#include "frame_field/smoothing/active_region.h"

namespace orbicube::frame_field {

class Diffusion {
 public:
  // All arguments must outlive it. `outside`, an entry a node or empty: links to frames that are fixed.
  Diffusion(const DualGraph& graph, std::span<const CoarseGraph> hierarchy, const Constraints& constraints,
            const base::Host& host, std::span<const OutsideLinks> outside = {});

  // The field nearest to the coefficients that satisfy Laplace's equation, where boundary frames may be of any size in
  // the plane of their two coefficients.
  Field harmonic_start();

  // Diffuses for `time` (in mean squared edge lengths of the dual graph) and projects.
  void diffuse(double time, Field& field);

  std::uint32_t iterations() const { return iterations_; }  // of the solver, so far

 private:
  using Solver = GraphSolver<9>;
  // With from_field, the frames that are there are guesses.
  void project(bool from_field, Field& field) const;
  void pull(double tau, const Field* field);

  const DualGraph& graph_;
  const Constraints& constraints_;
  const base::Host& host_;
  std::span<const OutsideLinks> outside_;
  Array<AxisCircle> circles_;
  Array<Solver::Tangent> tangents_;
  Solver solver_;
  Array<Solver::Value> x_, right_;
  Array<float> mass_;
  std::uint32_t iterations_ = 0;
};

// Diffuses `repeats` times for `time` where the field is not smooth (active_region.h), `rings` links around. Returns
// the iterations of the solver.
std::uint32_t diffuse_active(const DualGraph& graph, const Constraints& constraints, double time, int repeats,
                             int rings, const base::Host& host, Field& field);

}  // namespace orbicube::frame_field
