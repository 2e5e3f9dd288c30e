#include "polycube/labels/label_search.h"

#include <algorithm>
#include <utility>

#include "polycube/labels/label_repair.h"
#include "polycube/labels/patch_order.h"
#include "polycube/map/starts.h"

namespace orbicube::polycube {
namespace {

constexpr int label_steps = 8;
constexpr std::size_t changes_a_step = 8;
constexpr double max_patch = 0.06;             // of the whole area: larger ones keep their labels
constexpr double energy_weight = 4;            // what worse labels cost beside conflicts
constexpr double order_weight = 0.2;           // and an arc that runs in a circle
constexpr double excess_corner_weight = 0.25;  // and a corner above the budget
constexpr int trial_rounds = 4;
constexpr int trial_sweeps = 2;
constexpr int trial_repair_passes = 25;

struct Conflict {
  explicit Conflict(std::pmr::memory_resource* memory) : patches(memory) {}

  double size = 0;
  Array<Index> patches;  // where it is, and beside
};

Conflict find_conflict(const Surface& surface, std::span<const AxisLabel> labels, std::size_t max_corners,
                       std::uint64_t seed, const base::Host& host) {
  const Patches patches = find_patches(surface, labels, host);
  TiedMap map(surface, patches, host);
  poisson_start(map, trial_rounds, host);
  const ArcNetwork network(surface, patches, host);
  const ArcSigns signs = find_arc_signs(patches, surface, network, target_signs(map, network, host), seed, host);
  Conflict result(host.memory);
  result.size = signs.violation;
  Array<std::uint8_t> near(patches.count(), 0, host.memory);
  for (const Index k : signs.bad_corners) {
    for (const Index c : network.corners[k].patch)
      near[c] = 2;
  }
  for (const Index c : signs.bad_patches)
    near[c] = 2;
  if (signs.consistent()) {
    for (const Index a : arcs_without_order(patches, network, signs, host)) {
      const Arc& arc = network.arcs[a];
      result.size += order_weight;
      for (const Index v : {arc.first, arc.last})
        for (const Index c : network.corners[network.corner_of_vertex[v]].patch)
          near[c] = 2;
    }
  }
  for (const Arc& arc : network.arcs) {
    if (near[arc.left] == 2 && near[arc.right] == 0) near[arc.right] = 1;
    if (near[arc.right] == 2 && near[arc.left] == 0) near[arc.left] = 1;
  }
  if (max_corners > 0 && network.corners.size() > max_corners) {
    if (result.size == 0) std::fill(near.begin(), near.end(), std::uint8_t{2});
    result.size += excess_corner_weight * static_cast<double>(network.corners.size() - max_corners);
  }
  Array<std::pair<double, Index>> order(host.memory);
  for (Index c = 0; c < near.size(); ++c) {
    if (near[c] > 0 && patches.areas[c] < max_patch * surface.area)
      order.emplace_back(patches.areas[c] * (near[c] == 2 ? 1 : 3), c);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [size, patch] : order)
    result.patches.push_back(Index{patch});
  return result;
}

// The labels without those of one patch; whether the rules of patches.h could be kept.
bool drop_patch(const Surface& surface, const Patches& patches, Index patch, LabelCosts& costs,
                std::span<AxisLabel> labels, const base::Host& host) {
  Array<std::uint8_t> free(labels.size(), 0, host.memory);
  for (Index i = 0; i < labels.size(); ++i) {
    if (patches.patch[i] != patch) continue;
    free[i] = 1;
    costs.ban(i, labels[i]);
    labels[i] = best_label(costs, i);
  }
  expand_labels(surface, costs, free, trial_sweeps, labels, host);
  return repair_labels(surface, costs, trial_repair_passes, labels, host).total() == 0;
}

}  // namespace

double search_labels(const Surface& surface, LabelCosts& costs, std::size_t max_corners, std::uint64_t seed,
                     std::size_t& max_changes, std::span<AxisLabel> labels, const base::Host& host) {
  Conflict now = find_conflict(surface, labels, max_corners, seed, host);
  const double energy = label_energy(surface, costs, labels);
  double reached = now.size;
  for (int step = 0; step < label_steps && now.size > 0; ++step) {
    const Patches patches = find_patches(surface, labels, host);
    LabelCosts best_costs(host.memory);
    Array<AxisLabel> best_labels(host.memory);
    Conflict best(host.memory);
    double least = reached - 1e-9;
    for (std::size_t i = 0; i < std::min(now.patches.size(), changes_a_step) && max_changes > 0; ++i) {
      --max_changes;
      LabelCosts trial_costs(host.memory);
      trial_costs.data = costs.data;
      trial_costs.boundary = costs.boundary;
      Array<AxisLabel> trial(labels.begin(), labels.end(), host.memory);
      if (!drop_patch(surface, patches, now.patches[i], trial_costs, trial, host)) continue;
      Conflict found = find_conflict(surface, trial, max_corners, seed, host);
      // Bans do not count: energies are those of the labels themselves.
      const double score = found.size + energy_weight * (label_energy(surface, costs, trial) - energy);
      if (score >= least) continue;
      least = score;
      best_costs = std::move(trial_costs);
      best_labels = std::move(trial);
      best = std::move(found);
    }
    if (best_labels.empty()) break;
    std::copy(best_labels.begin(), best_labels.end(), labels.begin());
    costs = std::move(best_costs);
    now = std::move(best);
    reached = least;
  }
  return now.size;
}

}  // namespace orbicube::polycube
