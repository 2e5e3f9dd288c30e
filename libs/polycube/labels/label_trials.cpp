#include "polycube/labels/label_trials.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "polycube/labels/label_repair.h"
#include "polycube/labels/label_search.h"
#include "polycube/labels/normal_flow.h"
#include "polycube/labels/normal_turning.h"
#include "polycube/map/labelled_target.h"
#include "polycube/surface/distortion.h"
#include "polycube/surface/range_text.h"
#include "polycube/surface/refinement.h"
#include "polycube/unfolded/map_improvement.h"

namespace orbicube::polycube {
namespace {

constexpr std::array coarse_to_fine = {0.08, 0.04, 0.028, 0.02, 0.014, 0.01};
constexpr std::array all_normals = {LabelNormals::plain, LabelNormals::smoothed, LabelNormals::turned};
constexpr int smoothing_steps = 2;
constexpr double turning_length = 0.03;
constexpr std::array when_none_is_valid = {0.03, 0.015, 0.007, 0.0035};
constexpr double first_smoothing_time = 1e-4;
constexpr int sweeps = 5;
constexpr int repair_passes = 60;

// What the best polycube has no room for is labeled again by itself, with a compactness of this at its rim and still
// less inside.
constexpr double protrusion_compactness = 0.003;
constexpr int max_protrusions = 12;
constexpr std::size_t max_protrusion_changes = 100, max_protrusion_steps = 1000;

// What all labelings together may cost: changes of labels that have no signs of arcs, and steps of Gauss-Newton for
// their maps. What works takes few of either.
constexpr std::size_t max_changes = 150, max_map_steps = 1500;

// The product of both means over the surface; what has less is not compared with more.
constexpr double nearly_isometric = 1.03;

// What more corners than preferred cost.
constexpr double many_corners = 1.03;

// The part of the area in which labels may differ that are not tried beside others with as many corners.
constexpr double alike_below = 0.03;

// Maps in which a few triangles stay flipped are drawn on the surface instead.
constexpr std::size_t max_flipped = 60;
constexpr int rounds_after_drawing = 4;

bool has_better_labels(const LabelCandidate& a, const LabelCandidate& b) {
  return a.score < b.score;
}

std::string name_of(double compactness, LabelNormals normals, std::size_t corners) {
  const char* const kind = normals == LabelNormals::plain      ? ""
                           : normals == LabelNormals::smoothed ? "smoothed, "
                                                               : "turned, ";
  return "compactness " + std::to_string(compactness) + ", " + kind + base::counted(corners, "corner") + ": ";
}

// Returns the largest region that is not for the most part one that was tried.
Index next_region(const DistortedRegions& regions, Array<std::uint8_t>& tried) {
  for (Index r = 0; r < regions.count; ++r) {
    std::size_t count = 0, known = 0;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (regions.of_triangle[i] != r) continue;
      ++count;
      known += tried[i];
    }
    if (2 * known > count) continue;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (regions.of_triangle[i] == r) tried[i] = 1;
    }
    return r;
  }
  return no_index;
}

}  // namespace

void LabelFailures::add(double compactness, LabelNormals normals, std::size_t corners, const std::string& reason,
                        const std::string& detail) {
  host_.log(name_of(compactness, normals, corners) + reason + (detail.empty() ? "" : ", " + detail));
  auto same = std::find_if(failures_.begin(), failures_.end(), [&](const Failure& f) { return f.reason == reason; });
  if (same == failures_.end()) same = failures_.insert(failures_.end(), {reason, corners, corners, 0});
  ++same->count;
  same->fewest = std::min(same->fewest, corners);
  same->most = std::max(same->most, corners);
}

std::string LabelFailures::text() const {
  std::string reasons;
  for (const Failure& failure : failures_)
    reasons += (reasons.empty() ? "" : "; ") + failure.reason + ": " + std::to_string(failure.count) + " (" +
               range_text(failure.fewest, failure.most) + " corners)";
  return reasons;
}

LabelTrials::LabelTrials(const SearchSurface& search, const Frame& frame, const LabelConstructionOptions& options,
                         LabelFailures& failures, const base::Host& host)
    : search_(search),
      frame_(frame),
      options_(options),
      failures_(failures),
      host_(host),
      coarse_(framed(search.positions, search.triangles, frame, host)),
      smoothed_(host.memory),
      turned_(host.memory),
      candidates_(host.memory),
      changes_left_(max_changes),
      steps_left_(max_map_steps) {}

Array<LabelCandidate> LabelTrials::run() {
  for (const double compactness : coarse_to_fine) {
    for (const LabelNormals normals : all_normals)
      if (!good_enough()) try_labels(compactness, normals);
  }
  for (const double compactness : when_none_is_valid) {
    for (const LabelNormals normals : all_normals) {
      if (candidates_.empty()) try_labels(compactness, normals);
    }
  }
  if (!candidates_.empty() && !good_enough()) pull_out_protrusions();
  std::stable_sort(candidates_.begin(), candidates_.end(), has_better_labels);
  return std::move(candidates_);
}

bool LabelTrials::good_enough() const {
  return std::any_of(candidates_.begin(), candidates_.end(),
                     [](const LabelCandidate& c) { return c.score < nearly_isometric; });
}

std::span<const Vector3> LabelTrials::normals_for(LabelNormals kind) {
  if (kind == LabelNormals::plain) return coarse_.normals;
  Array<Vector3>& known = kind == LabelNormals::turned ? turned_ : smoothed_;
  if (known.empty() && kind == LabelNormals::turned) known = turned_normals(coarse_, turning_length, host_);
  if (known.empty()) {
    Array<Vector3> flowed(coarse_.positions, host_.memory);
    flow(coarse_, first_smoothing_time, smoothing_steps, flowed, host_);
    known = unit_normals(flowed, coarse_.triangles, host_);
  }
  return known;
}

// Returns whether these are the labels of one polycube, most likely.
bool LabelTrials::alike(std::span<const AxisLabel> a, std::span<const AxisLabel> b) const {
  double different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) different += coarse_.areas[i];
  return different <= alike_below * coarse_.area;
}

void LabelTrials::try_labels(double compactness, LabelNormals normals) {
  LabelCosts costs = label_costs(coarse_, normals_for(normals), compactness, host_);
  Array<AxisLabel> labels(coarse_.triangles.size(), host_.memory);
  for (Index i = 0; i < labels.size(); ++i)
    labels[i] = best_label(costs, i);
  expand_labels(coarse_, costs, {}, sweeps, labels, host_);
  try_map(costs, std::move(labels), compactness, normals);
}

// Makes boxes for what the best polycube has no room for, one at a time.
void LabelTrials::pull_out_protrusions() {
  Array<std::uint8_t> tried(coarse_.triangles.size(), 0, host_.memory);
  changes_left_ += max_protrusion_changes;
  steps_left_ += max_protrusion_steps;
  for (int protrusion = 0; protrusion < max_protrusions; ++protrusion) {
    const std::size_t best = static_cast<std::size_t>(
        std::min_element(candidates_.begin(), candidates_.end(), has_better_labels) - candidates_.begin());
    const DistortedRegions regions = find_distorted_regions(coarse_, candidates_[best].map, host_);
    const Index region = next_region(regions, tried);
    if (region == no_index) return;
    const double before = candidates_[best].score;
    for (const LabelNormals normals : all_normals) {
      pull_out(regions, region, best, normals);
      if (std::any_of(candidates_.begin(), candidates_.end(),
                      [&](const LabelCandidate& c) { return c.score < before; }))
        break;
    }
  }
}

// Labels the region again, where boundaries of patches cost less there.
void LabelTrials::pull_out(const DistortedRegions& regions, Index region, std::size_t candidate, LabelNormals normals) {
  const double compactness = candidates_[candidate].compactness;
  LabelCosts costs = label_costs(coarse_, normals_for(normals), compactness, host_);
  Array<AxisLabel> labels(candidates_[candidate].labels, host_.memory);
  Array<std::uint8_t> free(labels.size(), 0, host_.memory);
  for (Index i = 0; i < labels.size(); ++i) {
    if (regions.of_triangle[i] != region) continue;
    free[i] = 1;
    labels[i] = best_label(costs, i);
    for (Index h = 3 * i; h < 3 * i + 3; ++h) {
      // Inside once from either side.
      costs.boundary[h] = protrusion_compactness / compactness * costs.boundary[h];
      costs.boundary[coarse_.opposite(h)] = costs.boundary[h];
    }
  }
  expand_labels(coarse_, costs, free, sweeps, labels, host_);
  try_map(costs, std::move(labels), compactness, normals);
}

// Adds a candidate if there is a map with about these labels.
void LabelTrials::try_map(LabelCosts& costs, Array<AxisLabel> labels, double compactness, LabelNormals normals) {
  ++tried_;
  LabelFaults faults = repair_labels(coarse_, costs, repair_passes, labels, host_);
  const auto refuse = [&](const std::string& reason, const std::string& detail = {}) {
    failures_.add(compactness, normals, faults.corners, reason, detail);
  };
  if (faults.total() > 0) return refuse("faults of labels could not be repaired");
  // What is changed in the search loses corners, but not that many.
  const auto far_above = [&] { return options_.corners > 0 && faults.corners > 2 * options_.corners; };
  if (far_above()) return refuse("more corners than the budget");
  const double conflict = search_labels(coarse_, costs, options_.corners, options_.seed, changes_left_, labels, host_);
  faults = find_faults(coarse_, find_patches(coarse_, labels, host_));
  if (options_.corners > 0 && faults.corners > options_.corners) return refuse("more corners than the budget");
  if (conflict > 0) return refuse("no signs of arcs make the labels those of a polycube");
  const auto same = [&](const LabelCandidate& c) {
    return c.certificate.corners == faults.corners && alike(c.labels, labels);
  };
  if (std::any_of(candidates_.begin(), candidates_.end(), same)) return;
  SurfaceMap map = unrefined(search_.positions, search_.triangles, labels, host_);
  LabelledMapOptions map_options;
  map_options.seed = options_.seed;
  map_options.enough = max_flipped;
  if (steps_left_ == 0) return refuse("not tried: the budget of steps is used up");
  map_options.untangling_steps =
      static_cast<int>(std::min<std::size_t>(steps_left_, static_cast<std::size_t>(map_options.untangling_steps)));
  LabelledMapOutcome outcome = make_labelled_map(map, frame_, map_options, {}, host_);
  steps_left_ -= std::min(steps_left_, outcome.steps);
  const bool drawn = !outcome.valid();
  if (drawn && !draw(map, outcome)) return refuse("triangles stay flipped or parts meet", outcome.reason);
  const Distortion d = measure_distortion(map, host_);
  host_.log(name_of(compactness, normals, faults.corners) + "angle " + std::to_string(d.angle_weighted_mean) +
            ", area " + std::to_string(d.area_weighted_mean));
  const bool many = options_.preferred_corners > 0 && faults.corners > options_.preferred_corners;
  candidates_.push_back({(many ? many_corners : 1) * d.angle_weighted_mean * d.area_weighted_mean, compactness, normals,
                         drawn, std::move(labels), std::move(map), std::move(outcome.certificate)});
}

// Puts a valid map in place of one with some triangles flipped; returns whether there is one.
bool LabelTrials::draw(SurfaceMap& map, LabelledMapOutcome& outcome) const {
  if (outcome.flipped > max_flipped) return false;
  try {
    Construction made = draw_labelled(search_.positions, search_.triangles, map, host_);
    improve_map(made.map, made.certificate, {.rounds = rounds_after_drawing}, host_);
    map = std::move(made.map);
    outcome.certificate = std::move(made.certificate);
    return true;
  } catch (const base::Error& error) {
    // Faces may meet, and where triangles are flipped points of the polycube may be found on none.
    if (error.status() != base::Status::no_valid_result && error.status() != base::Status::unsupported &&
        error.status() != base::Status::invalid_argument)
      throw;
    outcome.reason += "; drawn: " + std::string(error.what());
    return false;
  }
}

}  // namespace orbicube::polycube
