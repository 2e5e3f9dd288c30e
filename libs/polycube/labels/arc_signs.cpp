#include "polycube/labels/arc_signs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/grouping.h"
#include "base/random.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::polycube {
namespace {

constexpr double corner_weight = 2;
constexpr double turn_weight = 1.5;
constexpr int rounds = 3;
constexpr int steps_a_round = 20000;
constexpr double hot = 0.5;
constexpr double cold = 0.03;

class Problem {
 public:
  Problem(const Patches& patches, const Surface& surface, const ArcNetwork& network, std::span<const double> wanted,
          const base::Host& host)
      : patches_(patches),
        network_(network),
        wanted_(wanted),
        host_(host),
        group_(network.arcs.size(), host.memory),
        sign_(host.memory),
        cost_(host.memory),
        saddles_(host.memory),
        loop_at_(network.corners.size(), host.memory),
        turn_(patches.loop_count(), host.memory),
        loop_groups_(patches.loop_count(), host.memory),
        move_(host.memory) {
    join_arcs();
    find_loops_at_corners(surface);
    evaluate();
  }

  bool satisfied() const { return violation_ < 1e-9; }

  void anneal(std::uint64_t seed) {
    base::Random random(seed);
    Array<std::uint8_t> best(sign_);
    double best_energy = energy();
    for (int round = 0; round < rounds; ++round) {
      for (int step = 0; step < steps_a_round; ++step) {
        if (step % 1024 == 0) host_.report("arc signs", 0, 0);
        const double temperature = hot * std::pow(cold / hot, static_cast<double>(step) / steps_a_round);
        choose_move(random);
        const double before = energy();
        flip_move();
        const double after = energy();
        if (after > before && std::exp((before - after) / temperature) <= random.unit()) {
          flip_move();
        } else if (after < best_energy - 1e-12) {
          best_energy = after;
          best = sign_;
        }
      }
      sign_ = best;
      evaluate();
    }
  }

  ArcSigns result() const {
    ArcSigns r(host_.memory);
    r.convex.resize(group_.size());
    for (std::size_t i = 0; i < group_.size(); ++i) {
      r.convex[i] = sign_[group_[i]];
      r.changed += (wanted_[i] > 0) != (r.convex[i] != 0);
    }
    for (Index k = 0; k < network_.corners.size(); ++k) {
      if (is_saddle(k) && reflex(k) == 3) r.bad_corners.push_back(k);
    }
    r.violation = static_cast<double>(r.bad_corners.size());
    for (Index c = 0; c < patches_.count(); ++c) {
      const double v = patch_violation(c);
      if (v > 0) r.bad_patches.push_back(c);
      r.violation += v;
    }
    return r;
  }

 private:
  bool is_saddle(std::size_t k) const { return network_.corners[k].chirality < 0; }
  std::uint8_t convex(Index arc) const { return sign_[group_[arc]]; }

  // Arcs at corners with chi = 1 are one group, with the sign of larger weight.
  void join_arcs() {
    mesh::DisjointSets sets(group_.size(), host_.memory);
    for (const Corner& corner : network_.corners) {
      if (corner.chirality < 0) continue;
      sets.unite(corner.arc[0], corner.arc[1]);
      sets.unite(corner.arc[0], corner.arc[2]);
    }
    for (Index i = 0; i < group_.size(); ++i) {
      const Index root = sets.find(i);
      if (root == i) {
        group_[i] = static_cast<Index>(cost_.size());
        cost_.push_back({0, 0});
      } else {
        group_[i] = group_[root];
      }
      cost_[group_[i]][wanted_[i] > 0 ? 0 : 1] += std::abs(wanted_[i]);
    }
    sign_.resize(cost_.size());
    for (std::size_t g = 0; g < cost_.size(); ++g)
      sign_[g] = cost_[g][1] <= cost_[g][0];
    // The corners with chi = -1 at the arcs of each group.
    saddles_.assign(cost_.size(), [&](const auto& visit) {
      for (Index k = 0; k < network_.corners.size(); ++k) {
        if (!is_saddle(k)) continue;
        const auto& arc = network_.corners[k].arc;
        const std::array<Index, 3> g = {group_[arc[0]], group_[arc[1]], group_[arc[2]]};
        visit(g[0], k);
        if (g[1] != g[0]) visit(g[1], k);
        if (g[2] != g[0] && g[2] != g[1]) visit(g[2], k);
      }
    });
  }

  void find_loops_at_corners(const Surface& surface) {
    for (Index l = 0; l < patches_.loop_count(); ++l) {
      for (const Index h : patches_.loop(l)) {
        const Index k = network_.corner_of_vertex[surface.start(h)];
        if (k == no_index) continue;
        for (std::size_t i = 0; i < 3; ++i) {
          if (network_.corners[k].patch[i] == patches_.loop_patch[l]) loop_at_[k][i] = l;
          loop_groups_[l].push_back(group_[network_.corners[k].arc[i]]);
        }
      }
    }
  }

  // The position of the patch with the reflex angle at a corner with chi = -1: opposite to the arc that differs. 3 when
  // none does.
  std::size_t reflex(std::size_t k) const {
    const auto& arc = network_.corners[k].arc;
    const std::array<std::uint8_t, 3> s = {convex(arc[0]), convex(arc[1]), convex(arc[2])};
    if (s[0] == s[1] && s[1] == s[2]) return 3;
    const std::size_t odd = s[0] == s[1] ? 2 : (s[0] == s[2] ? 1 : 0);
    return (odd + 2) % 3;  // arc i lies between patches i and i + 1
  }

  double patch_violation(std::size_t c) const {
    const std::size_t begin = patches_.patch_loops[c], end = patches_.patch_loops[c + 1];
    double best = begin == end ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t outer = begin; outer < end; ++outer) {
      double sum = 0;
      for (std::size_t l = begin; l < end; ++l)
        sum += 0.5 * std::abs(turn_[l] - (l == outer ? 4 : -4));
      best = std::min(best, sum);
    }
    return best;
  }

  double energy() const { return violation_ + preference_; }

  void evaluate() {
    std::fill(turn_.begin(), turn_.end(), 0);
    std::size_t bad = 0;
    for (std::size_t k = 0; k < network_.corners.size(); ++k) {
      for (const Index l : loop_at_[k])
        ++turn_[l];
      if (!is_saddle(k)) continue;
      const std::size_t r = reflex(k);
      if (r == 3)
        ++bad;
      else
        turn_[loop_at_[k][r]] -= 2;
    }
    violation_ = corner_weight * static_cast<double>(bad);
    for (std::size_t c = 0; c < patches_.count(); ++c)
      violation_ += turn_weight * patch_violation(c);
    preference_ = 0;
    for (std::size_t g = 0; g < sign_.size(); ++g)
      preference_ += cost_[g][sign_[g] ? 1 : 0];
  }

  // One group, two at a corner with chi = -1, or all at the corners of a loop: the last turns bumps into pits.
  void choose_move(base::Random& random) {
    move_.clear();
    const auto add = [&](Index g) {
      if (std::find(move_.begin(), move_.end(), g) == move_.end()) move_.push_back(g);
    };
    const std::size_t kind = random.below(10);
    if (kind < 5 || saddles_.all().empty()) {
      add(static_cast<Index>(random.below(sign_.size())));
    } else if (kind < 8) {
      const auto& arc = network_.corners[saddles_.all()[random.below(saddles_.all().size())]].arc;
      const std::size_t i = random.below(3);
      add(group_[arc[i]]);
      add(group_[arc[(i + 1) % 3]]);
    } else {
      for (const Index g : loop_groups_[random.below(loop_groups_.size())])
        add(g);
    }
  }

  void flip_move() {
    for (const Index g : move_)
      flip(g);
  }

  // Changes the sign of a group, and with it the corners with chi = -1 at it and their loops.
  void flip(std::size_t g) {
    preference_ -= cost_[g][sign_[g] ? 1 : 0];
    const auto count = [&](int way) {
      for (const std::size_t k : saddles_[g]) {
        const std::size_t r = reflex(k);
        if (r == 3) {
          violation_ += way * corner_weight;
          continue;
        }
        const Index l = loop_at_[k][r];
        const std::size_t c = patches_.loop_patch[l];
        violation_ -= turn_weight * patch_violation(c);
        turn_[l] -= 2 * way;
        violation_ += turn_weight * patch_violation(c);
      }
    };
    count(-1);
    sign_[g] ^= 1U;
    count(1);
    preference_ += cost_[g][sign_[g] ? 1 : 0];
  }

  const Patches& patches_;
  const ArcNetwork& network_;
  std::span<const double> wanted_;
  const base::Host& host_;
  Array<Index> group_;                   // of each arc
  Array<std::uint8_t> sign_;             // of each group: 1 for convex
  Array<std::array<double, 2>> cost_;    // of each group, of being concave or convex
  base::Groups<Index, Index> saddles_;   // corners with chi = -1 of each group
  Array<std::array<Index, 3>> loop_at_;  // of each corner: the loop of each of its patches
  Array<int> turn_;                      // of each loop, in quarters
  double violation_ = 0, preference_ = 0;
  Array<Array<Index>> loop_groups_;  // of each loop: the groups of all arcs at its corners, with repetitions
  Array<Index> move_;
};

}  // namespace

ArcSigns find_arc_signs(const Patches& patches, const Surface& surface, const ArcNetwork& network,
                        std::span<const double> wanted, std::uint64_t seed, const base::Host& host) {
  Problem problem(patches, surface, network, wanted, host);
  if (!problem.satisfied() && !network.arcs.empty()) problem.anneal(seed);
  return problem.result();
}

}  // namespace orbicube::polycube
