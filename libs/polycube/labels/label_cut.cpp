#include "polycube/labels/label_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::polycube {
namespace {

constexpr double banned = 1e3;  // far above any cost: data and boundaries are relative to the whole area

// Minimum cut of the graph whose nodes are triangles and whose arcs are half-edges, from a triangle to its neighbor.
// `terminal` of a node is what it may take from the source, or, negative, what it may give to the sink.
class MinimumCut {
 public:
  explicit MinimumCut(const Surface& surface, const base::Host& host)
      : terminal(surface.triangles.size(), host.memory),
        capacity(3 * surface.triangles.size(), host.memory),
        surface_(surface),
        host_(host),
        level_(surface.triangles.size(), host.memory),
        next_arc_(surface.triangles.size(), host.memory),
        queue_(host.memory),
        path_(host.memory) {
    queue_.reserve(surface.triangles.size());
  }

  void run() {
    while (find_levels()) {
      std::fill(next_arc_.begin(), next_arc_.end(), std::uint8_t{0});
      for (std::size_t i = 0; i < sources_; ++i) {
        if (i % 256 == 0) host_.report("labels", 0, 0);
        push_from(queue_[i]);
      }
    }
  }

  // After run(): whether the node is on the side of the sink.
  bool at_sink(Index node) const { return level_[node] < 0; }

  Array<double> terminal;
  Array<double> capacity;

 private:
  static constexpr double least = 1e-13;  // what rounding leaves of a saturated arc

  // Breadth first from the nodes that still have something to give; whether a sink was reached.
  bool find_levels() {
    host_.report("labels", 0, 0);
    std::fill(level_.begin(), level_.end(), -1);
    queue_.clear();
    for (Index i = 0; i < terminal.size(); ++i) {
      if (terminal[i] <= least) continue;
      level_[i] = 0;
      queue_.push_back(i);
    }
    sources_ = queue_.size();
    bool reached = false;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Index node = queue_[i];
      reached = reached || terminal[node] < -least;
      for (Index h = 3 * node; h < 3 * node + 3; ++h) {
        const Index other = surface_.neighbor(h);
        if (capacity[h] <= least || level_[other] >= 0) continue;
        level_[other] = level_[node] + 1;
        queue_.push_back(other);
      }
    }
    return reached;
  }

  // Depth first along levels, until the node has nothing left to give or no way.
  void push_from(Index source) {
    path_.clear();
    Index node = source;
    while (terminal[source] > least) {
      if (terminal[node] < -least) {
        double amount = std::min(terminal[source], -terminal[node]);
        for (const Index h : path_)
          amount = std::min(amount, capacity[h]);
        terminal[source] -= amount;
        terminal[node] += amount;
        std::size_t keep = path_.size();
        for (std::size_t i = path_.size(); i-- > 0;) {
          capacity[path_[i]] -= amount;
          capacity[surface_.opposite(path_[i])] += amount;
          if (capacity[path_[i]] <= least) keep = i;
        }
        path_.resize(keep);
        node = keep == 0 ? source : surface_.neighbor(path_.back());
        continue;
      }
      bool advanced = false;
      for (std::uint8_t& k = next_arc_[node]; k < 3; ++k) {
        const Index h = 3 * node + k;
        const Index other = surface_.neighbor(h);
        if (capacity[h] <= least || level_[other] != level_[node] + 1) continue;
        path_.push_back(h);
        node = other;
        advanced = true;
        break;
      }
      if (advanced) continue;
      if (path_.empty()) return;
      path_.pop_back();
      node = path_.empty() ? source : surface_.neighbor(path_.back());
      ++next_arc_[node];
    }
  }

  const Surface& surface_;
  const base::Host& host_;
  Array<int> level_;
  Array<std::uint8_t> next_arc_;
  Array<Index> queue_;
  Array<Index> path_;
  std::size_t sources_ = 0;
};

}  // namespace

void LabelCosts::ban(Index triangle, AxisLabel label) {
  auto& costs = data[triangle];
  costs[label] += banned;
  if (std::all_of(costs.begin(), costs.end(), [](double c) { return c >= banned; })) {
    for (double& c : costs)
      c = std::fmod(c, banned);
  }
}

LabelCosts label_costs(const Surface& surface, std::span<const Vector3> normals, double compactness,
                       const base::Host& host) {
  LabelCosts costs(host.memory);
  costs.data.resize(surface.triangles.size());
  costs.boundary.resize(3 * surface.triangles.size());
  const double unit = std::sqrt(surface.area);
  for (Index i = 0; i < surface.triangles.size(); ++i) {
    for (AxisLabel label = 0; label < label_count; ++label)
      costs.data[i][label] = surface.areas[i] / surface.area * (1 - normals[i].dot(direction_of(label)));
    for (Index h = 3 * i; h < 3 * i + 3; ++h) {
      const double agreement = std::max(0.0, normals[i].dot(normals[surface.neighbor(h)]));
      costs.boundary[h] = compactness * surface.length(h) / unit * (0.25 + 0.75 * agreement);
    }
  }
  return costs;
}

double label_energy(const Surface& surface, const LabelCosts& costs, std::span<const AxisLabel> labels) {
  double result = 0;
  for (Index i = 0; i < labels.size(); ++i) {
    result += costs.data[i][labels[i]];
    for (Index h = 3 * i; h < 3 * i + 3; ++h) {
      if (h < surface.opposite(h)) result += costs.boundary[h] * label_distance(labels[i], labels[surface.neighbor(h)]);
    }
  }
  return result;
}

AxisLabel best_label(const LabelCosts& costs, Index triangle) {
  const auto& c = costs.data[triangle];
  return static_cast<AxisLabel>(std::min_element(c.begin(), c.end()) - c.begin());
}

void expand_labels(const Surface& surface, const LabelCosts& costs, std::span<const std::uint8_t> free, int sweeps,
                   std::span<AxisLabel> labels, const base::Host& host) {
  MinimumCut cut(surface, host);
  Array<std::uint8_t> active(labels.size(), host.memory);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool changed = false;
    for (AxisLabel alpha = 0; alpha < label_count; ++alpha) {
      // A node at the sink takes the label alpha, one at the source keeps its own (Kolmogorov and Zabih 2004).
      std::fill(cut.terminal.begin(), cut.terminal.end(), 0.0);
      std::fill(cut.capacity.begin(), cut.capacity.end(), 0.0);
      bool any = false;
      for (Index i = 0; i < labels.size(); ++i) {
        active[i] = (free.empty() || free[i] != 0) && labels[i] != alpha;
        any = any || active[i];
      }
      if (!any) continue;
      for (Index i = 0; i < labels.size(); ++i) {
        if (!active[i]) continue;
        cut.terminal[i] += costs.data[i][alpha] - costs.data[i][labels[i]];
        for (Index h = 3 * i; h < 3 * i + 3; ++h) {
          const Index other = surface.neighbor(h);
          const double weight = costs.boundary[h];
          if (!active[other]) {
            cut.terminal[i] +=
                weight * (label_distance(alpha, labels[other]) - label_distance(labels[i], labels[other]));
          } else if (i < other) {
            const double keep = weight * label_distance(labels[i], labels[other]);
            const double first_keeps = weight * label_distance(labels[i], alpha);
            const double second_keeps = weight * label_distance(alpha, labels[other]);
            cut.terminal[i] += second_keeps - keep;
            cut.terminal[other] -= second_keeps;
            cut.capacity[h] += std::max(0.0, first_keeps + second_keeps - keep);
          }
        }
      }
      cut.run();
      for (Index i = 0; i < labels.size(); ++i) {
        if (!active[i] || !cut.at_sink(i)) continue;
        labels[i] = alpha;
        changed = true;
      }
    }
    if (!changed) break;
  }
}

}  // namespace orbicube::polycube
