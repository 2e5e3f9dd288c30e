#include "polycube/unfolded/unfolded_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/backtracking.h"
#include "linear/sparse_system.h"
#include "untangle/flip_bound.h"

namespace orbicube::polycube {
namespace {

constexpr const char* unfolded_newton_phase = "smoothing";

// Not an untangle::PlanarNewton: its triangles share coordinates but for signs. Here those of a vertex are turned and
// shifted for each triangle, and ties add to the energy.
class System {
 public:
  struct Element {
    RestTriangle rest;
    double weight;
    std::array<Index, 3> variable;  // pairs; no_index at corners of the polycube
    std::array<PlaneMotion, 3> motion;
    std::array<Vector2d, 3> fixed;
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
        system_(make_system()),
        places_(elements_.size(), host.memory),
        diagonal_(2 * place_.size(), host.memory),
        gradient_(static_cast<Eigen::Index>(2 * place_.size())),
        direction_(place_.size(), host.memory),
        trial_(place_.size(), host.memory) {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      std::size_t n = 0;
      for_each_entry(elements_[i], [&](Index row, Index column) {
        places_[i][n++] = row >= column ? static_cast<std::uint32_t>(system_.place(row, column)) : no_index;
      });
    }
    for (Index i = 0; i < diagonal_.size(); ++i)
      diagonal_[i] = static_cast<std::uint32_t>(system_.place(i, i));
  }

  // Returns by which part of itself the energy fell; 0 when no step lowers it.
  double step() {
    const double before = assemble();
    for (Index i = 0; i < diagonal_.size(); ++i) {
      double& entry = system_.values()[diagonal_[i]];
      entry = is_held(i) ? 1 : entry * (1 + 1e-9);
    }
    host_.report(unfolded_newton_phase, 0, 0);
    if (!system_.factorize()) return 0;
    const Eigen::VectorXd x = -system_.solve(gradient_);
    const double slope = gradient_.dot(x);
    if (!x.allFinite() || !(slope < 0)) return 0;
    for (std::size_t i = 0; i < place_.size(); ++i)
      direction_[i] = x.segment<2>(static_cast<Eigen::Index>(2 * i));
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
  // Rows and columns of an element's block of the matrix, no_index where corners are.
  template <class Visit>
  static void for_each_entry(const Element& e, const Visit& visit) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const Index p = e.variable[i / 2], q = e.variable[j / 2];
        if (p == no_index || q == no_index)
          visit(0, no_index);
        else
          visit(2 * p + static_cast<Index>(i % 2), 2 * q + static_cast<Index>(j % 2));
      }
    }
  }

  linear::SparseSystem make_system() {
    linear::SparseSystem::Triplets triplets(host_.memory);
    triplets.reserve(21 * elements_.size());
    for (const Element& e : elements_) {
      for_each_entry(e, [&](Index row, Index column) {
        if (column != no_index && row >= column)
          triplets.emplace_back(static_cast<int>(row), static_cast<int>(column), 0.0);
      });
    }
    host_.report(unfolded_newton_phase, 0, 0);
    return linear::SparseSystem(2 * place_.size(), triplets);
  }

  // Of a coordinate, whose row and column of the matrix are those of the identity then.
  bool is_held(Index coordinate) const { return (held_[coordinate / 2] >> (coordinate % 2) & 1) != 0; }

  Vector2d at(const Element& e, std::size_t k, std::span<const Vector2d> place) const {
    return e.variable[k] == no_index ? e.fixed[k] : e.motion[k](place[e.variable[k]]);
  }
  Eigen::Matrix2d jacobian_of(const Element& e, std::span<const Vector2d> place) const {
    return jacobian(e.rest, at(e, 0, place), at(e, 1, place), at(e, 2, place));
  }

  double energy(std::span<const Vector2d> place) const {
    double sum = 0;
    for (const Element& e : elements_)
      sum += e.weight * distortion(jacobian_of(e, place));
    for (const Tie& t : ties_)
      sum += t.tie.energy(place[t.variable]);
    return sum;
  }

  double assemble() {
    gradient_.setZero();
    std::fill_n(system_.values(), system_.value_count(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (i % 4096 == 0) host_.report(unfolded_newton_phase, 0, 0);
      const Element& e = elements_[i];
      const Eigen::Matrix2d j = jacobian_of(e, place_);
      sum += e.weight * distortion(j);
      const Derivatives of(j);
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
      const Eigen::Matrix<double, 6, 1> slope = e.weight * (b.transpose() * of.first);
      const Eigen::Matrix<double, 6, 6> block = e.weight * (b.transpose() * of.second * b);
      for (std::size_t r = 0; r < 6; ++r) {
        const auto row = static_cast<Eigen::Index>(r);
        const Index coordinate = 2 * e.variable[r / 2] + static_cast<Index>(r % 2);
        if (e.variable[r / 2] == no_index || is_held(coordinate)) continue;
        gradient_[coordinate] += slope[row];
        for (std::size_t c = 0; c < 6; ++c) {
          const std::uint32_t place = places_[i][6 * r + c];
          if (place == no_index || is_held(2 * e.variable[c / 2] + static_cast<Index>(c % 2))) continue;
          system_.values()[place] += block(row, static_cast<Eigen::Index>(c));
        }
      }
    }
    for (const auto& [variable, tie] : ties_) {
      sum += tie.energy(place_[variable]);
      for (Index k = 0; k < 2; ++k) {
        const Index coordinate = 2 * variable + k;
        if (is_held(coordinate)) continue;
        gradient_[coordinate] += 2 * tie.weight[k] * (place_[variable][k] - tie.place[k]);
        system_.values()[diagonal_[coordinate]] += 2 * tie.weight[k];
      }
    }
    return sum;
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
  linear::SparseSystem system_;
  Array<std::array<std::uint32_t, 36>> places_;
  Array<std::uint32_t> diagonal_;
  Eigen::VectorXd gradient_;
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
