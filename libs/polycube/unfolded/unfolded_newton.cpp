#include "polycube/unfolded/unfolded_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/backtracking.h"
#include "linear/iterative/block_solver.h"
#include "untangle/flip_bound.h"

namespace orbicube::polycube {
namespace {

constexpr const char* unfolded_newton_phase = "smoothing";

// Not an untangle::PlanarNewton: its triangles share coordinates but for signs. Here those of a vertex are turned and
// shifted for each triangle, and ties add to the energy.
class System {
  using Block = linear::BlockMatrix<2>::Block;

 public:
  struct Element {
    RestTriangle rest;
    double weight;
    std::array<Index, 3> variable;  // pairs; no_index at corners of the polycube
    std::array<PlaneMotion, 3> motion;
    std::array<Vector2d, 3> fixed;
    // Of the block of corners k and k + 1 below the diagonal of the matrix.
    std::array<Index, 3> place = {no_index, no_index, no_index};
  };

  struct Tie {
    Index variable;
    PlaneTie tie;
  };

  System(Array<Element> elements, Array<Vector2d> place, Array<std::uint8_t> held, Array<Tie> ties,
         const base::Host& host)
      : elements_(std::move(elements)),
        place_(std::move(place)),
        held_(std::move(held)),
        ties_(std::move(ties)),
        host_(host),
        matrix_(host.memory),
        solver_(host),
        gradient_(2 * place_.size(), host.memory),
        change_(2 * place_.size(), host.memory),
        direction_(place_.size(), host.memory),
        trial_(place_.size(), host.memory) {
    make_pattern();
  }

  // Returns by which part of itself the energy fell; 0 when no step lowers it.
  double step() {
    // A direction this close to Newton's takes as many steps as his own.
    constexpr double tolerance = 0.03;
    constexpr int max_inner_steps = 300;
    const double before = assemble();
    host_.report(unfolded_newton_phase, 0, 0);
    solver_.factor(matrix_);
    solver_.solve(gradient_, max_inner_steps, tolerance, change_);
    double slope = 0;
    for (std::size_t i = 0; i < gradient_.size(); ++i)
      slope -= gradient_[i] * change_[i];
    if (!std::isfinite(slope) || !(slope < 0)) return 0;
    for (std::size_t i = 0; i < place_.size(); ++i)
      direction_[i] = -Vector2d(change_[2 * i], change_[2 * i + 1]);
    const auto energy_after = [&](double length) {
      host_.report(unfolded_newton_phase, 0, 0);
      for (std::size_t k = 0; k < place_.size(); ++k)
        trial_[k] = place_[k] + length * direction_[k];
      return energy(trial_);
    };
    const auto taken = base::backtrack(before, slope, {.first_length = longest_step(), .max_trials = 20}, energy_after);
    if (!taken) return 0;
    std::swap(place_, trial_);
    return (before - taken->value) / before;
  }

  std::span<const Vector2d> places() const { return place_; }

 private:
  static constexpr std::array<Index, 3> next = {1, 2, 0};

  void make_pattern() {
    Array<std::pair<Index, Index>> pairs(host_.memory);
    pairs.reserve(3 * elements_.size());
    const auto pair_of = [](const Element& e, std::size_t k) {
      return std::minmax(e.variable[k], e.variable[next[k]]);  // no_index is above all others
    };
    for (const Element& e : elements_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [column, row] = pair_of(e, k);
        if (row != no_index) pairs.emplace_back(row, column);
      }
    }
    host_.report(unfolded_newton_phase, 0, 0);
    linear::make_rows(pairs, place_.size(), matrix_.row_begin, matrix_.column);
    matrix_.lower.resize(matrix_.column.size());
    matrix_.diagonal.resize(place_.size());
    matrix_.own.resize(place_.size());
    for (std::size_t i = 0; i < place_.size(); ++i)
      matrix_.own[i] = static_cast<std::uint8_t>(~held_[i] & 3);
    for (Element& e : elements_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [column, row] = pair_of(e, k);
        if (row == no_index) continue;
        const auto first = matrix_.column.begin();
        const auto at = std::lower_bound(first + matrix_.row_begin[row], first + matrix_.row_begin[row + 1], column);
        e.place[k] = static_cast<Index>(at - first);
      }
    }
  }

  bool is_held(Index variable, int axis) const { return (held_[variable] >> axis & 1) != 0; }

  Vector2d at(const Element& e, std::size_t k, std::span<const Vector2d> place) const {
    return e.variable[k] == no_index ? e.fixed[k] : e.motion[k](place[e.variable[k]]);
  }
  Eigen::Matrix2d jacobian_of(const Element& e, std::span<const Vector2d> place) const {
    return jacobian(e.rest, at(e, 0, place), at(e, 1, place), at(e, 2, place));
  }

  double energy(std::span<const Vector2d> place) const {
    double sum = 0;
    for (const Element& e : elements_)
      sum += e.weight * untangle::barrier(jacobian_of(e, place));
    for (const Tie& t : ties_)
      sum += t.tie.energy(place[t.variable]);
    return sum;
  }

  double assemble() {
    std::fill(gradient_.begin(), gradient_.end(), 0.0);
    std::fill(matrix_.lower.begin(), matrix_.lower.end(), Block::Zero());
    std::fill(matrix_.diagonal.begin(), matrix_.diagonal.end(), Block::Zero());
    double sum = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (i % 4096 == 0) host_.report(unfolded_newton_phase, 0, 0);
      sum += add(elements_[i]);
    }
    for (const auto& [variable, tie] : ties_) {
      sum += tie.energy(place_[variable]);
      for (Index k = 0; k < 2; ++k) {
        gradient_[2 * variable + k] += 2 * tie.weight[k] * (place_[variable][k] - tie.place[k]);
        matrix_.diagonal[variable](k, k) += 2 * tie.weight[k];
      }
    }
    hold();
    return sum;
  }

  // Adds the energy's derivatives to gradient and matrix; returns the energy.
  double add(const Element& e) {
    const Eigen::Matrix2d j = jacobian_of(e, place_);
    const untangle::BarrierDerivatives of(j);
    // Columns: coordinates of each corner in its own plane.
    Eigen::Matrix<double, 4, 6> b;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int s = 0; s < 2; ++s) {
        const Vector2d way = turned_by(Vector2d::Unit(s), e.motion[k].quarters);
        auto column = b.col(static_cast<Eigen::Index>(2 * k) + s);
        column.head<2>() = way.x() * e.rest.hat[k];
        column.tail<2>() = way.y() * e.rest.hat[k];
      }
    }
    const Eigen::Matrix<double, 6, 1> slope = e.weight * (b.transpose() * of.gradient);
    const Eigen::Matrix<double, 6, 6> block = e.weight * (b.transpose() * of.block * b);
    const auto part = [&](std::size_t row, std::size_t column) {
      return block.block<2, 2>(static_cast<Eigen::Index>(2 * row), static_cast<Eigen::Index>(2 * column));
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = e.variable[k];
      if (v == no_index) continue;
      matrix_.diagonal[v] += part(k, k);
      gradient_[2 * v] += slope[static_cast<Eigen::Index>(2 * k)];
      gradient_[2 * v + 1] += slope[static_cast<Eigen::Index>(2 * k + 1)];
      if (e.place[k] != no_index)
        matrix_.lower[e.place[k]] += v > e.variable[next[k]] ? part(k, next[k]) : part(next[k], k);
    }
    return e.weight * untangle::barrier(j);
  }

  // Rows and columns of what stays get nothing but their diagonal.
  void hold() {
    for (Index v = 0; v < matrix_.rows(); ++v) {
      for (Index i = matrix_.row_begin[v]; i < matrix_.row_begin[v + 1]; ++i) {
        const Index w = matrix_.column[i];
        for (int k = 0; k < 2; ++k) {
          if (is_held(v, k)) matrix_.lower[i].row(k).setZero();
          if (is_held(w, k)) matrix_.lower[i].col(k).setZero();
        }
      }
      for (int k = 0; k < 2; ++k) {
        if (!is_held(v, k)) continue;
        matrix_.diagonal[v].row(k).setZero();
        matrix_.diagonal[v].col(k).setZero();
        matrix_.diagonal[v](k, k) = 1;
        gradient_[2 * v + static_cast<Index>(k)] = 0;
      }
    }
  }

  // Nine tenths of the way to where the first triangle becomes flat, but at most 1.
  double longest_step() const {
    double longest = 1;
    for (const Element& e : elements_) {
      const Eigen::Matrix2d j = jacobian_of(e, place_);
      Eigen::Matrix2d k = Eigen::Matrix2d::Zero();
      for (std::size_t i = 0; i < 3; ++i) {
        if (e.variable[i] == no_index) continue;
        k += turned_by(direction_[e.variable[i]], e.motion[i].quarters) * e.rest.hat[i].transpose();
      }
      longest = std::min(longest, 0.9 * untangle::first_degenerate_step(j, k));
    }
    return longest;
  }

  Array<Element> elements_;
  Array<Vector2d> place_;  // of each variable vertex, in its plane
  Array<std::uint8_t> held_;
  Array<Tie> ties_;
  const base::Host& host_;
  linear::BlockMatrix<2> matrix_;
  linear::BlockSolver<2> solver_;
  Array<double> gradient_, change_;
  Array<Vector2d> direction_, trial_;
};

}  // namespace

int move_all(UnfoldedMap& map, const TriangleWeights& weights, int steps, double min_gain, const base::Host& host) {
  if (steps <= 0) return 0;
  const EditableSurface& surface = map.surface;
  Array<Index> number(surface.vertices(), no_index, host.memory);
  Array<Vector2d> place(host.memory);
  Array<std::uint8_t> held(host.memory);
  Array<System::Tie> ties(host.memory);
  for (Index v = 0; v < surface.vertices(); ++v) {
    if (surface.outgoing(v) == no_index || map.is_corner(v)) continue;
    number[v] = static_cast<Index>(place.size());
    if (map.tie_at[v] != no_index) ties.push_back({number[v], map.ties[map.tie_at[v]]});
    place.push_back(map.image[v]);
    held.push_back(std::uint8_t{map.held[v]});
  }
  Array<System::Element> elements(host.memory);
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f)) continue;
    const Triangle& t = surface.triangle[f];
    System::Element e{weights.rest(surface, t[0], t[1], t[2]), 0, {}, {}, {}};
    e.weight = weights.weight(e.rest);
    for (Index k = 0; k < 3; ++k) {
      e.variable[k] = number[t[k]];
      e.motion[k] = map.motion[3 * f + k];
      e.fixed[k] = map.at(3 * f + k);
    }
    elements.push_back(e);
  }
  System system(std::move(elements), std::move(place), std::move(held), std::move(ties), host);
  int taken = 0;
  for (double gain = 1; taken < steps && gain >= min_gain; ++taken) {
    gain = system.step();
    for (Index v = 0; v < number.size(); ++v)
      if (number[v] != no_index) map.image[v] = system.places()[number[v]];
    map.follow_corners();
  }
  return taken;
}

}  // namespace orbicube::polycube
