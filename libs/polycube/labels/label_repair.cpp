#include "polycube/labels/label_repair.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace orbicube::polycube {
namespace {

constexpr double forbidden = 100;  // above any difference of costs, below a ban
constexpr int sweeps_of_a_recut = 3;
constexpr double small_region = 0.003;  // of the whole area: not worth cutting again
constexpr int passes_before_strip_bans = 4;
constexpr int passes_before_fan_bans = 6;

class Repair {
 public:
  Repair(const Surface& surface, LabelCosts& costs, std::span<AxisLabel> labels, const base::Host& host)
      : surface_(surface),
        costs_(costs),
        labels_(labels),
        host_(host),
        patches_(host.memory),
        free_(labels.size(), host.memory),
        before_(host.memory),
        component_(surface.positions.size(), host.memory),
        open_(host.memory),
        members_(host.memory),
        in_strip_(labels.size(), host.memory),
        fans_(host.memory),
        touched_(host.memory),
        inside_(host.memory),
        recut_(host.memory) {}

  LabelFaults run(int passes) {
    LabelFaults faults;
    for (pass_ = 0; pass_ < passes; ++pass_) {
      last_half_ = pass_ > passes / 2;
      remove_ears();
      if (separate_opposites()) remove_ears();
      lower_valences();
      patches_ = find_patches(surface_, labels_, host_);
      faults = find_faults(surface_, patches_);
      if (faults.total() == 0 || faults.missing > 0) return faults;
      change_bad_patches();
    }
    patches_ = find_patches(surface_, labels_, host_);
    return find_faults(surface_, patches_);
  }

 private:
  AxisLabel across(Index h) const { return labels_[surface_.neighbor(h)]; }

  // A triangle with two neighbors of one other label takes it.
  void remove_ears() {
    for (int round = 0; round < 4; ++round) {
      bool changed = false;
      for (Index i = 0; i < labels_.size(); ++i) {
        const std::array<AxisLabel, 3> around = {across(3 * i), across(3 * i + 1), across(3 * i + 2)};
        const AxisLabel majority = around[0] == around[1] || around[0] == around[2] ? around[0] : around[1];
        if (std::count(around.begin(), around.end(), majority) < 2 || majority == labels_[i]) continue;
        if (std::find(around.begin(), around.end(), opposite(majority)) != around.end()) continue;
        labels_[i] = majority;
        changed = true;
      }
      if (!changed) return;
    }
  }

  // Along each connected line between opposite labels, the triangles at it take the best label of another axis.
  bool separate_opposites() {
    const auto between_opposites = [&](Index h) { return before_[h / 3] == opposite(before_[surface_.neighbor(h)]); };
    before_.assign(labels_.begin(), labels_.end());
    std::fill(component_.begin(), component_.end(), std::uint8_t{0});
    bool any = false;
    for (Index first = 0; first < 3 * before_.size(); ++first) {
      if (!between_opposites(first) || component_[surface_.start(first)]) continue;
      any = true;
      const int axis = axis_of(before_[first / 3]);
      members_.clear();
      open_.assign(1, surface_.start(first));
      component_[open_[0]] = 1;
      while (!open_.empty()) {
        const Index v = open_.back();
        open_.pop_back();
        surface_.connectivity.for_each_outgoing(v, [&](Index h) {
          if (axis_of(labels_[h / 3]) == axis && !in_strip_[h / 3]) {
            in_strip_[h / 3] = 1;
            members_.push_back(h / 3);
          }
          const Index end = surface_.end(h);
          if (!between_opposites(h) || component_[end]) return;
          component_[end] = 1;
          open_.push_back(end);
        });
      }
      relabel_strip(axis);
    }
    return any;
  }

  void relabel_strip(int axis) {
    double best = std::numeric_limits<double>::infinity();
    AxisLabel chosen = 0;
    for (AxisLabel label = 0; label < label_count; ++label) {
      if (axis_of(label) == axis) continue;
      double cost = 0;
      for (const Index i : members_) {
        cost += costs_.data[i][label];
        for (Index h = 3 * i; h < 3 * i + 3; ++h) {
          const Index other = surface_.neighbor(h);
          if (in_strip_[other]) continue;
          cost += costs_.boundary[h] * (labels_[other] == opposite(label) ? 20 : (labels_[other] == label ? 0 : 1));
        }
      }
      if (cost >= best) continue;
      best = cost;
      chosen = label;
    }
    for (const Index i : members_) {
      labels_[i] = chosen;
      in_strip_[i] = 0;
      if (pass_ <= passes_before_strip_bans) continue;
      costs_.ban(i, label_of(axis, 1));
      costs_.ban(i, label_of(axis, -1));
    }
  }

  // Triangles around a vertex, counter-clockwise, in runs of one label.
  void find_fans(Index vertex) {
    fans_.clear();
    fan_begin_count_ = 0;
    const Index any = surface_.connectivity.outgoing(vertex);
    if (any == no_index) return;
    Index first = any;
    do {
      if (labels_[first / 3] != across(first)) break;
      first = surface_.turned(first);
    } while (first != any);
    Index h = first;
    do {
      if (h == first || labels_[h / 3] != labels_[fans_.back().second])
        fans_.push_back({++fan_begin_count_, h / 3});
      else
        fans_.push_back({fan_begin_count_, h / 3});
      h = surface_.turned(h);
    } while (h != first);
  }

  void lower_valences() {
    patches_ = find_patches(surface_, labels_, host_);
    for (Index v = 0; v < surface_.positions.size(); ++v) {
      if (patches_.valence[v] <= 3) continue;
      find_fans(v);  // labels may have changed since
      if (fan_begin_count_ > 3) lower_valence();
    }
  }

  AxisLabel label_of_fan(Index fan) const {
    for (const auto& [number, triangle] : fans_) {
      if (number == fan) return labels_[triangle];
    }
    return 0;
  }

  // The fan that is cheapest to give away takes the label before or after it; if none can, all take one label.
  void lower_valence() {
    double best = std::numeric_limits<double>::infinity();
    Index best_fan = 0;
    AxisLabel best_label_found = 0;
    const Index count = fan_begin_count_;
    for (Index fan = 1; fan <= count; ++fan) {
      for (const Index beside : {fan == 1 ? count : fan - 1, fan == count ? 1 : fan + 1}) {
        const AxisLabel label = label_of_fan(beside);
        double cost = 0;
        for (const auto& [number, i] : fans_) {
          if (number != fan) continue;
          cost += costs_.data[i][label] - costs_.data[i][labels_[i]] + 1e-3;
          for (Index h = 3 * i; h < 3 * i + 3; ++h)
            cost += across(h) == opposite(label) ? forbidden : 0;
        }
        if (cost >= best) continue;
        best = cost;
        best_fan = fan;
        best_label_found = label;
      }
    }
    if (best < forbidden) {
      for (const auto& [number, i] : fans_) {
        if (number != best_fan) continue;
        if (pass_ > passes_before_fan_bans) costs_.ban(i, labels_[i]);
        labels_[i] = best_label_found;
      }
      return;
    }
    best = std::numeric_limits<double>::infinity();
    for (AxisLabel label = 0; label < label_count; ++label) {
      double cost = 0;
      for (const auto& [number, i] : fans_) {
        cost += costs_.data[i][label];
        for (Index h = 3 * i; h < 3 * i + 3; ++h)
          cost += across(h) == opposite(label) ? 10 : 0;
      }
      if (cost >= best) continue;
      best = cost;
      best_label_found = label;
    }
    for (const auto& [number, i] : fans_)
      labels_[i] = best_label_found;
  }

  // Patches with handles or short loops, the smallest first, none beside one that has just changed.
  void change_bad_patches() {
    Array<std::pair<double, Index>> bad(host_.memory);
    for (Index c = 0; c < patches_.count(); ++c) {
      bool is_bad = patches_.has_handles(c);
      for (Index l = patches_.patch_loops[c]; l < patches_.patch_loops[c + 1]; ++l)
        is_bad = is_bad || corners_of_loop(surface_, patches_, l) < 4;
      if (is_bad) bad.emplace_back(patches_.areas[c], c);
    }
    std::sort(bad.begin(), bad.end());
    touched_.assign(patches_.count(), 0);
    for (const auto& [area, c] : bad) {
      if (touched_[c] || beside_touched(c)) continue;
      if (patches_.loops_of(c) > 1 && !patches_.has_handles(c) && change_within_hole(c)) continue;
      change_label(c);
    }
  }

  template <class Visit>
  void for_each_boundary(Index patch, const Visit& visit) const {
    for (Index l = patches_.patch_loops[patch]; l < patches_.patch_loops[patch + 1]; ++l) {
      for (const Index h : patches_.loop(l))
        visit(h, patches_.patch[surface_.neighbor(h)]);
    }
  }

  bool beside_touched(Index patch) const {
    bool result = false;
    for_each_boundary(patch, [&](Index, Index other) { result = result || touched_[other]; });
    return result;
  }

  // What lies beyond a short loop of a patch, when it is the smaller side, is cut again with less compactness, once, or
  // joins the patch.
  bool change_within_hole(Index patch) {
    for (Index l = patches_.patch_loops[patch]; l < patches_.patch_loops[patch + 1]; ++l) {
      if (corners_of_loop(surface_, patches_, l) >= 4) continue;
      inside_.assign(patches_.count(), 0);
      inside_[patch] = 1;
      open_.clear();
      double area = 0;
      bool waits = false;
      const auto enter = [&](Index c) {
        if (inside_[c]) return;
        inside_[c] = 1;
        open_.push_back(c);
        area += patches_.areas[c];
        waits = waits || touched_[c];
      };
      for (const Index h : patches_.loop(l))
        enter(patches_.patch[surface_.neighbor(h)]);
      while (!open_.empty()) {
        const Index c = open_.back();
        open_.pop_back();
        for_each_boundary(c, [&](Index, Index other) { enter(other); });
      }
      inside_[patch] = 0;
      if (area >= 0.5 * (surface_.area - area)) continue;
      if (waits) return true;
      change_region(patch, area);
      return true;
    }
    return false;
  }

  void change_region(Index patch, double area) {
    std::uint64_t key = 0;
    for (Index i = 0; i < labels_.size(); ++i) {
      free_[i] = inside_[patches_.patch[i]];
      if (free_[i]) key = key * 31 + i;
    }
    if (area > small_region * surface_.area && std::find(recut_.begin(), recut_.end(), key) == recut_.end()) {
      recut_.push_back(key);
      LabelCosts looser(host_.memory);
      looser.data = costs_.data;
      looser.boundary = costs_.boundary;
      for (double& w : looser.boundary)
        w *= 0.35;
      expand_labels(surface_, looser, free_, sweeps_of_a_recut, labels_, host_);
    } else {
      for (Index i = 0; i < labels_.size(); ++i) {
        if (!free_[i]) continue;
        costs_.ban(i, labels_[i]);
        labels_[i] = patches_.labels[patch];
      }
    }
    touched_[patch] = 1;
    for (Index c = 0; c < patches_.count(); ++c)
      touched_[c] = touched_[c] || inside_[c];
  }

  // The patch's label is banned there; late in the work the whole patch joins a neighbor.
  void change_label(Index patch) {
    const AxisLabel label = patches_.labels[patch];
    for (Index i = 0; i < labels_.size(); ++i) {
      free_[i] = patches_.patch[i] == patch;
      if (free_[i]) costs_.ban(i, label);
    }
    if (last_half_) {
      std::array<double, label_count> length{};
      for_each_boundary(patch, [&](Index h, Index other) { length[patches_.labels[other]] += surface_.length(h); });
      std::array<double, label_count> score = length;
      for (AxisLabel l = 0; l < label_count; ++l)
        score[l] *= length[opposite(l)] > 0 ? 0.1 : 1;
      const auto chosen = static_cast<AxisLabel>(std::max_element(score.begin(), score.end()) - score.begin());
      for (Index i = 0; i < labels_.size(); ++i)
        labels_[i] = free_[i] ? chosen : labels_[i];
    } else {
      for (Index i = 0; i < labels_.size(); ++i)
        labels_[i] = free_[i] ? best_label(costs_, i) : labels_[i];
      expand_labels(surface_, costs_, free_, sweeps_of_a_recut, labels_, host_);
    }
    touched_[patch] = 1;
    for_each_boundary(patch, [&](Index, Index other) { touched_[other] = 1; });
  }

  const Surface& surface_;
  LabelCosts& costs_;
  std::span<AxisLabel> labels_;
  const base::Host& host_;
  int pass_ = 0;
  bool last_half_ = false;
  Patches patches_;
  Array<std::uint8_t> free_;
  Array<AxisLabel> before_;
  Array<std::uint8_t> component_;
  Array<Index> open_;
  Array<Index> members_;
  Array<std::uint8_t> in_strip_;
  Array<std::pair<Index, Index>> fans_;  // number of the fan, from 1, and triangle
  Index fan_begin_count_ = 0;
  Array<std::uint8_t> touched_;
  Array<std::uint8_t> inside_;
  Array<std::uint64_t> recut_;
};

}  // namespace

LabelFaults repair_labels(const Surface& surface, LabelCosts& costs, int passes, std::span<AxisLabel> labels,
                          const base::Host& host) {
  return Repair(surface, costs, labels, host).run(passes);
}

}  // namespace orbicube::polycube
