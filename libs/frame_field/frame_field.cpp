#include "frame_field/frame_field.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

#include "base/error.h"
#include "frame_field/graph/boundary_stars.h"
#include "frame_field/graph/canonical_solid.h"
#include "frame_field/graph/features.h"
#include "frame_field/graph/hierarchy.h"
#include "frame_field/singularities/curve_search.h"
#include "frame_field/smoothing/diffusion.h"
#include "frame_field/smoothing/dissertation_method.h"
#include "frame_field/smoothing/energy.h"
#include "frame_field/smoothing/recombination.h"
#include "frame_field/smoothing/smoothing.h"
#include "frame_field/smoothing/starts.h"

namespace orbicube::frame_field {
namespace {

// Maximum number of nodes of the coarsest graph.
constexpr std::size_t smallest_graph = 60;
// Times of Start::diffusion, in mean squared edges: wide enough for curves to cross a solid.
constexpr std::initializer_list<double> falling_times = {64, 32, 16, 8};
// Then ever finer, and slowly, so that curves settle between the tetrahedra as in a metal that is annealed. With less
// time than the last they do not leave the edges where they are.
constexpr double first_fine_time = 4, last_fine_time = 0.25, fine_factor = 1.4142135623730951;
constexpr int fine_repeats = 3;
// What a round of improvement tries from the best field so far.
constexpr std::initializer_list<double> long_times = {128, 32, 8, 2}, middle_times = {8, 8, 2, 1},
                                        short_times = {1, 0.5};
// Frames that differ by less are no reason to take one rather than the other.
constexpr double recombination_angle = 0.1;
// Smoothing of candidates need not be thorough.
constexpr double rough_gain = 1e-3;
// Longer diffusions change the whole field, others what is around singular curves.
constexpr double whole_from = 10;
// How many links around what is not smooth such a diffusion changes the field, which grows with the way that it
// spreads.
int rings_of(double time) {
  return 1 + static_cast<int>(1.5 * std::sqrt(time));
}
// A round that gains less than this fraction of the energy is the last.
constexpr double round_gain = 5e-3;
// Over the singular curves, moving them edge by edge.
constexpr std::uint32_t curve_passes = 3;

class Search {
 public:
  Search(const DualGraph& graph, Constraints& constraints, const Options& options, const base::Host& host)
      : graph_(graph),
        constraints_(constraints),
        options_(options),
        host_(host),
        hierarchy_(make_hierarchy(graph, smallest_graph, host)),
        diffusion_(graph, hierarchy_, constraints, host),
        best_(host.memory) {}

  Outcome run(const CanonicalSolid& solid, const Given& given) {
    Outcome outcome(host_.memory);
    outcome.start = options_.start;
    switch (options_.start) {
      case Start::automatic:
        outcome.start = search();
        break;
      case Start::identity:
        best_ = constant_start(graph_, constraints_, solid.turned(Quaternion{1, 0, 0, 0}), host_);
        break;
      case Start::propagated:
        best_ = propagated_start(graph_, constraints_, solid.turned(Quaternion{1, 0, 0, 0}), host_);
        break;
      case Start::harmonic:
        best_ = diffusion_.harmonic_start();
        break;
      case Start::diffusion:
        best_ = annealed(diffusion_.harmonic_start());
        break;
      case Start::given:
        best_.reserve(graph_.size());
        for (const Index t : solid.tetrahedron)
          best_.push_back(solid.turned(given.start[t]));
        break;
    }
    outcome.energy = smoothed(best_, options_.relative_gain, constraints_);
    if (!constraints_.pulls.empty()) outcome.energy = energy(graph_, best_, host_);
    outcome.solver_iterations = iterations_ + diffusion_.iterations() + active_iterations_;
    outcome.smoothing_steps = steps_;
    outcome.field = std::move(best_);
    return outcome;
  }

 private:
  // Returns the energy.
  double smoothed(Field& field, double gain, Constraints& constraints) {
    const SmoothingResult result = smooth(graph_, hierarchy_, constraints, {.relative_gain = gain}, host_, field);
    iterations_ += result.solver_iterations;
    steps_ += result.steps;
    return result.energy;
  }

  Field diffused(const Field& from, std::initializer_list<double> times) {
    Field field(from, host_.memory);
    for (const double time : times) {
      if (time > whole_from)
        diffusion_.diffuse(time, field);
      else
        active_iterations_ += diffuse_active(graph_, constraints_, time, 1, rings_of(time), host_, field);
    }
    return field;
  }

  Field annealed(const Field& from) {
    Field field = diffused(from, falling_times);
    for (double time = first_fine_time; time > 0.99 * last_fine_time; time /= fine_factor) {
      active_iterations_ += diffuse_active(graph_, constraints_, time, fine_repeats, rings_of(time), host_, field);
    }
    return field;
  }

  // Smooths a candidate and takes over what is better in it. True when it is better as a whole.
  bool offer(Field candidate) {
    Constraints own(constraints_, host_.memory);
    double energy = smoothed(candidate, rough_gain, own);
    const bool better = best_.empty() || energy < best_energy_;
    if (better) {
      std::swap(best_, candidate);
      std::swap(best_energy_, energy);
    }
    if (candidate.empty()) return better;
    if (take_better_regions(graph_, constraints_, candidate, recombination_angle, host_, best_) > 0) {
      Constraints again(constraints_, host_.memory);
      best_energy_ = smoothed(best_, rough_gain, again);
    }
    return better;
  }

  Start search() {
    Start from = Start::diffusion;
    const Quaternion axes{1, 0, 0, 0};  // of the solid
    Field harmonic = diffusion_.harmonic_start();
    offer(annealed(harmonic));
    if (offer(std::move(harmonic))) from = Start::harmonic;
    if (offer(constant_start(graph_, constraints_, axes, host_))) from = Start::identity;
    if (offer(propagated_start(graph_, constraints_, axes, host_))) from = Start::propagated;
    for (std::uint32_t round = 0; round < options_.rounds; ++round) {
      const double before = best_energy_;
      for (const auto& times : {long_times, middle_times, short_times}) {
        if (offer(diffused(best_, times))) from = Start::diffusion;
      }
      if (before - best_energy_ <= round_gain * best_energy_) break;
    }
    return from;
  }

  const DualGraph& graph_;
  Constraints& constraints_;
  const Options& options_;
  const base::Host& host_;
  Array<CoarseGraph> hierarchy_;
  Diffusion diffusion_;
  Field best_;
  double best_energy_ = 0;
  std::uint32_t iterations_ = 0, active_iterations_ = 0, steps_ = 0;
};

// Moves curves to where they cost less, which smoothing does not, and repairs. Tetrahedra are numbered as nodes are.
void improve_structure(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                       const DualGraph& graph, Constraints& constraints, const Options& options, const base::Host& host,
                       Outcome& outcome) {
  Field& field = outcome.field;
  const auto hierarchy = make_hierarchy(graph, smallest_graph, host);

  if (options.start == Start::automatic && options.rounds > 0) {
    double gain = 0;
    {
      const mesh::EdgeRings rings(connectivity, host);
      gain = CurveSearch(graph, constraints, connectivity, rings, host).run(curve_passes, field);
    }
    if (gain > 0) {
      const SmoothingResult result =
          smooth(graph, hierarchy, constraints, {.relative_gain = options.relative_gain}, host, field);
      outcome.smoothing_steps += result.steps;
      outcome.solver_iterations += result.solver_iterations;
    }
  }
  if (options.repairs != Repairs::none) {
    Repair repair(positions, connectivity, graph, hierarchy, constraints, host);
    outcome.repair = options.repairs == Repairs::places ? repair.repair(field) : repair.search_about_single_axes(field);
  }
  outcome.energy = energy(graph, field, host);
}

// Of the canonical solid, in its axes; normals from the positions as they are given, whose digits turning would cost.
Constraints constraints_of(const CanonicalSolid& solid, std::span<const Vector3> positions,
                           const mesh::TetrahedralConnectivity& connectivity, const DualGraph& graph,
                           const Options& options, const Given& given, const base::Host& host) {
  Array<Vector3> ordered(host.memory);
  ordered.reserve(positions.size());
  for (const Index v : solid.vertex)
    ordered.push_back(positions[v]);
  Array<GivenAxis> axes(given.axes.begin(), given.axes.end(), host.memory);
  Array<GivenFrame> frames(given.frames.begin(), given.frames.end(), host.memory);
  if (!axes.empty() || !frames.empty()) {
    Array<Index> number(graph.size(), host.memory);
    for (Index t = 0; t < number.size(); ++t)
      number[solid.tetrahedron[t]] = t;
    for (GivenAxis& axis : axes)
      axis.tetrahedron = number[axis.tetrahedron];
    for (GivenFrame& frame : frames)
      frame.tetrahedron = number[frame.tetrahedron];
  }
  if (options.feature_angle > 0) follow_features(ordered, connectivity, options.feature_angle, host, frames, axes);
  if (options.align_boundary && options.align_stars) follow_boundary_stars(ordered, connectivity, host, frames, axes);
  Constraints constraints = make_constraints(graph, ordered, connectivity, options.align_boundary, frames, axes, host);
  solid.turn(constraints);
  return constraints;
}

bool is_unit(double square) {
  return std::abs(square - 1) < 1e-6;
}

void check(std::size_t count, const Options& options, const Given& given) {
  const auto require = [](bool condition, const char* message) {
    if (!condition) throw base::Error("invalid-argument", message);
  };
  if (count == 0) throw base::Error("empty-mesh", "no tetrahedra");
  const auto in_range = [](auto value, auto last) { return static_cast<std::int32_t>(value) >= 0 && value <= last; };
  require(in_range(options.start, Start::given), "no such start");
  require(in_range(options.method, Method::dissertation), "no such method");
  require(in_range(options.weighting, Weighting::geometric), "no such weighting");
  require(in_range(options.repairs, Repairs::single_axis), "no such repairs");
  require(options.repairs == Repairs::none || options.method == Method::smooth,
          "method `dissertation` knows no repairs");
  require(options.method == Method::smooth || options.start == Start::automatic || options.start == Start::identity,
          "method `dissertation` starts from identity");
  require(options.feature_angle >= 0 && options.feature_angle < 4, "the feature angle is not in [0, pi]");
  require(options.relative_gain > 0 && options.relative_gain < 1, "the relative gain is not between 0 and 1");
  for (const GivenFrame& g : given.frames) {
    require(g.tetrahedron < count, "a given frame of a tetrahedron that does not exist");
    require(is_unit(quaternion::dot(g.frame, g.frame)), "a given frame is no unit quaternion");
    require(g.weight > 0, "the weight of a given frame is not positive");
  }
  for (const GivenAxis& g : given.axes) {
    require(g.tetrahedron < count, "a given axis of a tetrahedron that does not exist");
    const Vector& d = g.direction;
    require(is_unit(d.x * d.x + d.y * d.y + d.z * d.z), "a given axis is no unit vector");
    require(g.weight > 0, "the weight of a given axis is not positive");
  }
  if (options.start != Start::given) return;
  require(given.start.size() == count, "the field to start from has not one frame a tetrahedron");
  for (const Quaternion& q : given.start)
    require(is_unit(quaternion::dot(q, q)), "the field to start from has a frame that is no unit quaternion");
}

}  // namespace

const char* start_name(Start start) {
  switch (start) {
    case Start::automatic:
      return "auto";
    case Start::identity:
      return "identity";
    case Start::propagated:
      return "propagated";
    case Start::harmonic:
      return "harmonic";
    case Start::diffusion:
      return "diffusion";
    case Start::given:
      return "given";
  }
  return "unknown";
}

Outcome compute(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra, const Options& options,
                const Given& given, const base::Host& host) {
  check(tetrahedra.size(), options, given);
  const CanonicalSolid solid = [&] {
    const mesh::TetrahedralConnectivity connectivity(positions.size(), tetrahedra, host);
    return make_canonical(positions, connectivity, host);
  }();
  const mesh::TetrahedralConnectivity connectivity(positions.size(), solid.tetrahedra, host);
  const DualGraph graph = make_dual_graph(solid.positions, connectivity, options.weighting, host);
  Constraints constraints = constraints_of(solid, positions, connectivity, graph, options, given, host);
  Outcome outcome(host.memory);
  if (options.method == Method::dissertation) {
    outcome = dissertation_method(graph, constraints, solid.turned(Quaternion{1, 0, 0, 0}), host);
  } else {
    {
      const base::Stage stage(host, 0.6);
      outcome = Search(graph, constraints, options, host).run(solid, given);
    }
    if ((options.start == Start::automatic && options.rounds > 0) || options.repairs != Repairs::none)
      improve_structure(solid.positions, connectivity, graph, constraints, options, host, outcome);
  }
  Field field(tetrahedra.size(), host.memory);
  for (std::size_t i = 0; i < field.size(); ++i)
    field[solid.tetrahedron[i]] = solid.turned_back(outcome.field[i]);
  outcome.field = std::move(field);
  return outcome;
}

}  // namespace orbicube::frame_field
