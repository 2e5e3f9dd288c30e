#include "frame_field/smoothing/smoothing.h"

#include <algorithm>
#include <cmath>

#include "base/backtracking.h"
#include "frame_field/graph/graph_solver.h"
#include "frame_field/smoothing/energy.h"
#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

using quaternion::conjugate;
using quaternion::cube_group;
using quaternion::multiply;
using quaternion::normalized;
using Solver = GraphSolver<3>;

// The frame `other` written so that it is nearest to `frame`: other g with the cube's rotation g.
Quaternion matched(const Quaternion& frame, const Quaternion& other) {
  const std::uint32_t g = quaternion::symmetric_matching(frame, other);
  return multiply(other, conjugate(cube_group.element[g]));
}

// Energy of the links and pulls of each node and minus twice its gradient by the rotation vector of the node.
double energy_and_force(const DualGraph& graph, const Constraints& constraints, const Field& field,
                        const base::Host& host, std::span<Solver::Value> force, Array<double>& partial) {
  for_each_chunk(host, graph.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Quaternion& q = field[i];
      double x = 0, y = 0, z = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const Index other = graph.others[i][k];
        if (other == i) continue;
        // From frame i to frame j in space: its vector part is sin(angle / 2) times the axis.
        const Quaternion r = multiply(matched(q, field[other]), conjugate(q));
        const double w = static_cast<double>(graph.weights[i][k]);
        x += w * (r.w * r.x);
        y += w * (r.w * r.y);
        z += w * (r.w * r.z);
        sum += w * (r.x * r.x + r.y * r.y + r.z * r.z);
      }
      force[i].at = {static_cast<float>(2 * x), static_cast<float>(2 * y), static_cast<float>(2 * z), 0};
    }
    partial[chunk] = 0.5 * sum;
  });
  double total = 0;
  for (const double p : partial)
    total += p;
  for (const Pull& pull : constraints.pulls) {
    const Quaternion r = multiply(target(pull, field[pull.node]), conjugate(field[pull.node]));
    const double w = 2 * pull.weight * r.w;
    auto& at = force[pull.node].at;
    at[0] += static_cast<float>(w * r.x);
    at[1] += static_cast<float>(w * r.y);
    at[2] += static_cast<float>(w * r.z);
    total += pull.weight * (r.x * r.x + r.y * r.y + r.z * r.z);
  }
  return total;
}

// Tetrahedra with several boundary faces keep the direction that the field has, or take the one nearest to it: a field
// that was smoothed before is one for the directions that were chosen then.
void adopt_directions(Constraints& constraints, const Field& field) {
  for (Constraints::Alternative& alternative : constraints.alternatives) {
    Constraint& constraint = constraints.list[alternative.constraint];
    const auto cosine = [&](const Vector& direction) {
      const Vector local = quaternion::rotate(conjugate(field[constraint.node]), direction);
      return std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)});
    };
    if (cosine(alternative.direction) > cosine(constraint.direction) + 1e-9) {
      std::swap(constraint.direction, alternative.direction);
      constraint.frame = aligned(constraint.frame, constraint.direction);
    }
  }
}

// Gives tetrahedra with several boundary faces the one of their directions for which their links are worth least.
bool choose_normals(const DualGraph& graph, Constraints& constraints, Field& field) {
  bool changed = false;
  for (Constraints::Alternative& alternative : constraints.alternatives) {
    Constraint& constraint = constraints.list[alternative.constraint];
    const Index node = constraint.node;
    const auto best_for = [&](const Vector& n, Quaternion& best) {
      // The angle about n that minimizes sum w (1 - (q . p_k)^2) over q = cos a q0 + sin a (n q0): the dominant
      // eigenvector of a 2 x 2 matrix; matchings and angle take turns.
      best = aligned(field[node], n);
      double value = 0;
      for (int turn = 0; turn < 3; ++turn) {
        const Quaternion across = multiply({0, n.x, n.y, n.z}, best);
        double aa = 0, ab = 0, bb = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          const Index other = graph.others[node][k];
          if (other == node) continue;
          const Quaternion p = matched(best, field[other]);
          const double w = static_cast<double>(graph.weights[node][k]), a = dot(p, best), b = dot(p, across);
          aa += w * (a * a);
          ab += w * (a * b);
          bb += w * (b * b);
        }
        best = turned(best, n, std::atan2(2 * ab, aa - bb));
        best = aligned(best, n);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        const Index other = graph.others[node][k];
        if (other != node)
          value += static_cast<double>(graph.weights[node][k]) * quaternion::symmetric_sine_square(best, field[other]);
      }
      return value;
    };
    Quaternion kept, tried;
    const double value = best_for(constraint.direction, kept);
    const double other_value = best_for(alternative.direction, tried);
    if (other_value < value * (1 - 1e-9)) {
      std::swap(constraint.direction, alternative.direction);
      constraint.frame = aligned(constraint.frame, constraint.direction);
      field[node] = tried;
      changed = true;
    }
  }
  return changed;
}

Array<Solver::Tangent> axes_of(const Constraints& constraints, std::pmr::memory_resource* memory) {
  Array<Solver::Tangent> tangents(memory);
  tangents.reserve(constraints.list.size());
  for (const Constraint& c : constraints.list) {
    Solver::Tangent tangent{c.node, {}};
    if (!c.fixed) {
      tangent.direction[0].at = {static_cast<float>(c.direction.x), static_cast<float>(c.direction.y),
                                 static_cast<float>(c.direction.z), 0};
    }
    tangents.push_back(tangent);
  }
  return tangents;
}

void turn_all(const Field& from, std::span<const Solver::Value> turn, double length, const Constraints& constraints,
              const base::Host& host, Field& to) {
  for_each_chunk(host, from.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto& t = turn[i].at;
      const double half = 0.5 * length;
      to[i] = normalized(multiply(
          {1, half * static_cast<double>(t[0]), half * static_cast<double>(t[1]), half * static_cast<double>(t[2])},
          from[i]));
    }
  });
  satisfy(constraints, to);
}

}  // namespace

double energy(const DualGraph& graph, const Field& field, const base::Host& host) {
  Array<double> partial(chunk_count(graph.size()), 0.0, host.memory);
  for_each_chunk(host, graph.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Index other = graph.others[i][k];
        if (other > i)
          sum += static_cast<double>(graph.weights[i][k]) * quaternion::symmetric_sine_square(field[i], field[other]);
      }
    }
    partial[chunk] = sum;
  });
  double total = 0;
  for (const double p : partial)
    total += p;
  return total;
}

double pull_energy(const Constraints& constraints, const Field& field) {
  double sum = 0;
  for (const Pull& pull : constraints.pulls)
    sum += worth(pull, field[pull.node]);
  return sum;
}

SmoothingResult smooth(const DualGraph& graph, std::span<const CoarseGraph> hierarchy, Constraints& constraints,
                       const SmoothingOptions& options, const base::Host& host, Field& field) {
  const std::size_t n = graph.size();
  SmoothingResult result;
  if (n == 0) return result;
  Array<Solver::Value> force(n, host.memory), turn(n, host.memory);
  Array<double> partial(chunk_count(n), 0.0, host.memory);
  Field trial(n, host.memory);
  if (options.choose_normals) adopt_directions(constraints, field);
  Array<Solver::Tangent> tangents = axes_of(constraints, host.memory);
  Solver solver(graph, hierarchy, tangents, host);
  Array<float> mass(host.memory);
  if (!constraints.pulls.empty()) {
    mass.assign(n, 0.0F);
    for (const Pull& pull : constraints.pulls)
      mass[pull.node] += static_cast<float>(pull.weight);
  }
  satisfy(constraints, field);
  result.energy = energy_and_force(graph, constraints, field, host, force, partial);
  while (result.steps < options.max_steps) {
    host.report("smoothing", result.steps, 0, result.energy);
    std::ranges::fill(turn, Solver::Value{});
    result.solver_iterations +=
        solver.solve({.mass = mass, .tolerance = 0.1, .max_iterations = 200, .phase = "smoothing"}, force, turn)
            .iterations;
    const auto energy_after = [&](double length) {
      turn_all(field, turn, length, constraints, host, trial);
      return energy(graph, trial, host) + pull_energy(constraints, trial);
    };
    const base::Backtracking any_decrease{.max_trials = 6, .decrease = 0, .strict = true};
    const auto taken = base::backtrack(result.energy, 0, any_decrease, energy_after);
    ++result.steps;
    if (!taken) break;
    const double gain = result.energy - taken->value;
    std::swap(field, trial);
    if (options.choose_normals && choose_normals(graph, constraints, field)) {
      const auto changed = axes_of(constraints, host.memory);
      std::ranges::copy(changed, tangents.begin());  // the solver sees them where they are
    }
    result.energy = energy_and_force(graph, constraints, field, host, force, partial);
    if (gain < options.relative_gain * result.energy) break;
  }
  return result;
}

}  // namespace orbicube::frame_field
