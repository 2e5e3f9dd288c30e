#include "frame_field/smoothing/diffusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbicube::frame_field {
namespace {

using Value = GraphSolver<9>::Value;

Value stored(const Harmonic& h) {
  Value v;
  for (std::size_t k = 0; k < 9; ++k)
    v.at[k] = static_cast<float>(h[k]);
  return v;
}

Harmonic loaded(const Value& v) {
  Harmonic h;
  for (std::size_t k = 0; k < 9; ++k)
    h[k] = static_cast<double>(v.at[k]);
  return h;
}

Array<AxisCircle> circles_of(const Constraints& constraints, std::pmr::memory_resource* memory) {
  Array<AxisCircle> circles(memory);
  circles.reserve(constraints.list.size());
  for (const Constraint& c : constraints.list)
    circles.push_back(c.fixed ? AxisCircle{harmonic_of(c.frame), {}, {}} : axis_circle(c.frame, c.direction));
  return circles;
}

Array<GraphSolver<9>::Tangent> tangents_of(const Constraints& constraints, const Array<AxisCircle>& circles,
                                           std::pmr::memory_resource* memory) {
  const double scale = 1 / std::sqrt(circle_radius_square);
  Array<GraphSolver<9>::Tangent> tangents(memory);
  tangents.reserve(circles.size());
  for (std::size_t c = 0; c < circles.size(); ++c) {
    GraphSolver<9>::Tangent tangent{constraints.list[c].node, {}};
    for (std::size_t k = 0; k < 9; ++k) {
      tangent.direction[0].at[k] = static_cast<float>(scale * circles[c].first[k]);
      tangent.direction[1].at[k] = static_cast<float>(scale * circles[c].second[k]);
    }
    tangents.push_back(tangent);
  }
  return tangents;
}

}  // namespace

Diffusion::Diffusion(const DualGraph& graph, std::span<const CoarseGraph> hierarchy, const Constraints& constraints,
                     const base::Host& host, std::span<const OutsideLinks> outside)
    : graph_(graph),
      constraints_(constraints),
      host_(host),
      outside_(outside),
      circles_(circles_of(constraints, host.memory)),
      tangents_(tangents_of(constraints, circles_, host.memory)),
      solver_(graph, hierarchy, tangents_, host),
      x_(graph.size(), host.memory),
      right_(host.memory),
      mass_(host.memory) {}

void Diffusion::project(bool from_field, Field& field) const {
  for_each_chunk(host_, graph_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Harmonic a = loaded(x_[i]);
      if (const Index c = constraints_.of_node[i]; c != no_index) {
        const AxisCircle& circle = circles_[c];
        const Constraint& constraint = constraints_.list[c];
        const double angle = std::atan2(dot(a, circle.second), dot(a, circle.first)) / 4;
        field[i] = constraint.fixed ? constraint.frame : turned(constraint.frame, constraint.direction, angle);
      } else {
        field[i] = from_field ? nearest_frame(a, field[i]) : nearest_frame(a);
      }
    }
  });
}

Field Diffusion::harmonic_start() {
  mass_.clear();
  right_.clear();
  std::ranges::fill(x_, Value{});
  for (std::size_t c = 0; c < circles_.size(); ++c)
    x_[constraints_.list[c].node] = stored(circles_[c].centre);
  pull(1, nullptr);
  iterations_ += solver_.solve({.mass = mass_, .tolerance = 1e-3, .phase = "harmonic start"}, right_, x_).iterations;
  Field field(graph_.size(), Quaternion{1, 0, 0, 0}, host_.memory);
  project(false, field);
  return field;
}

// Adds the pulls to the mass and the right side, which are empty or those of diffusion.
void Diffusion::pull(double tau, const Field* field) {
  if (constraints_.pulls.empty()) return;
  mass_.resize(graph_.size(), 0.0F);
  right_.resize(graph_.size(), Solver::Value{});
  for (const Pull& pull : constraints_.pulls) {
    // An axis alone leaves the turn about it free: its frames are about their mean.
    const Harmonic wanted = pull.whole         ? harmonic_of(pull.frame)
                            : field != nullptr ? harmonic_of(target(pull, (*field)[pull.node]))
                                               : axis_circle(pull.frame, pull.direction).centre;
    const double weight = tau * pull.weight;
    mass_[pull.node] += static_cast<float>(weight);
    for (std::size_t k = 0; k < 9; ++k)
      right_[pull.node].at[k] += static_cast<float>(weight * wanted[k]);
  }
}

void Diffusion::diffuse(double time, Field& field) {
  mass_.assign(graph_.size(), 1.0F);
  right_.resize(graph_.size());
  for_each_chunk(host_, graph_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i)
      x_[i] = right_[i] = stored(harmonic_of(field[i]));
  });
  for (std::size_t i = 0; i < outside_.size(); ++i) {
    mass_[i] += static_cast<float>(time) * outside_[i].weight;
    for (std::size_t k = 0; k < 9; ++k)
      right_[i].at[k] += static_cast<float>(time * outside_[i].sum[k]);
  }
  pull(time, &field);
  iterations_ +=
      solver_
          .solve({.tau = static_cast<float>(time), .mass = mass_, .tolerance = 1e-2, .phase = "diffusion"}, right_, x_)
          .iterations;
  project(true, field);
}

std::uint32_t diffuse_active(const DualGraph& graph, const Constraints& constraints, double time, int repeats,
                             int rings, const base::Host& host, Field& field) {
  // Neighbors that differ by more are no part of a smooth field.
  constexpr double rough_angle = 14 * std::numbers::pi / 180;
  const ActiveRegion region = active_region(graph, constraints, field, rough_angle, rings, host);
  if (region.nodes.empty()) return 0;
  Field part(host.memory);
  part.reserve(region.nodes.size());
  for (const Index node : region.nodes)
    part.push_back(field[node]);
  Diffusion diffusion(region.graph, {}, region.constraints, host, region.outside);
  for (int repeat = 0; repeat < repeats; ++repeat)
    diffusion.diffuse(time, part);
  for (std::size_t i = 0; i < part.size(); ++i)
    field[region.nodes[i]] = part[i];
  return diffusion.iterations();
}

}  // namespace orbicube::frame_field
