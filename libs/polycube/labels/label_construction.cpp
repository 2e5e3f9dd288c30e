#include "polycube/labels/label_construction.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/topology/topology.h"
#include "polycube/labels/label_repair.h"
#include "polycube/labels/label_search.h"
#include "polycube/labels/label_smoothing.h"
#include "polycube/labels/normal_flow.h"
#include "polycube/labels/normal_turning.h"
#include "polycube/map/distorted_regions.h"
#include "polycube/map/labelled_map.h"
#include "polycube/map/labelled_target.h"
#include "polycube/map/map_refinement.h"
#include "polycube/surface/alignment.h"
#include "polycube/surface/decimation.h"
#include "polycube/surface/range_text.h"
#include "polycube/surface/refinement.h"
#include "polycube/unfolded/map_improvement.h"

namespace orbicube::polycube {
namespace {

constexpr std::array coarse_to_fine = {0.08, 0.04, 0.028, 0.02, 0.014, 0.01};
// Normals that labels agree with: as they are, of the surface smoothed, or turned towards the axes where it bends.
enum class Normals { plain, smoothed, turned };
constexpr std::array all_normals = {Normals::plain, Normals::smoothed, Normals::turned};
constexpr int smoothing_steps = 2;
constexpr double turning_length = 0.03;
constexpr std::array when_none_is_valid = {0.03, 0.015, 0.007, 0.0035};
constexpr double first_smoothing_time = 1e-4;
constexpr int sweeps = 5;
constexpr int repair_passes = 60;

// What the best polycube has no room for is labeled again by itself, with a compactness of this at its rim and still
// less inside.
constexpr double limb_compactness = 0.003;
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

// Labelings are tried on a surface of this number of triangles, when the input has more than is coarse enough.
constexpr std::size_t search_triangles = 5000;
constexpr std::size_t coarse_enough = 7000;
constexpr std::size_t map_triangles = 5000;
constexpr int smoothing_sweeps = 30;
constexpr int final_polishing_steps = 40;
constexpr int final_sweeps = 6;

// The surface that labelings are tried on: the input's, or a coarse one made of some of its triangles.
struct SearchSurface {
  SearchSurface(std::span<const Vector3> p, std::span<const Triangle> t, const base::Host& host)
      : decimation(host.memory),
        positions(p.begin(), p.end(), host.memory),
        triangles(t.begin(), t.end(), host.memory),
        source(host.memory) {}

  Decimation decimation;
  Array<Vector3> positions;  // in space
  Array<Triangle> triangles;
  Array<Index> source;  // of each triangle, when it is a coarse one: its number in the input
};

Surface framed(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Frame& frame,
               const base::Host& host) {
  Array<Vector3> seen(positions.size(), host.memory);
  std::transform(positions.begin(), positions.end(), seen.begin(), frame);
  return {std::move(seen), Array<Triangle>(triangles.begin(), triangles.end(), host.memory), host};
}

class LabelConstruction {
 public:
  LabelConstruction(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                    const LabelConstructionOptions& options, const base::Host& host)
      : positions_(positions),
        triangles_(triangles),
        options_(options),
        host_(host),
        frame_(unit_frame(positions, triangles)),
        fine_(framed(positions, triangles, frame_, host)),
        search_(positions, triangles, host),
        coarse_(fine_is_coarse() ? framed(positions, triangles, frame_, host) : decimated()),
        smoothed_(host.memory),
        turned_(host.memory),
        candidates_(host.memory) {
    frame_.rotation = best_alignment(fine_, options.seed, host);
    fine_ = framed(positions_, triangles_, frame_, host);
    coarse_ = framed(search_.positions, search_.triangles, frame_, host);
  }

  Construction run() {
    for (const double compactness : coarse_to_fine) {
      for (const Normals normals : all_normals)
        if (!good_enough()) try_labels(compactness, normals);
    }
    for (const double compactness : when_none_is_valid) {
      for (const Normals normals : all_normals) {
        if (candidates_.empty()) try_labels(compactness, normals);
      }
    }
    if (!candidates_.empty() && !good_enough()) pull_out_protrusions();
    std::stable_sort(candidates_.begin(), candidates_.end(), better);
    for (Candidate& candidate : candidates_) {
      Construction result(host_.memory);
      result.tried = tried_;
      result.valid = candidates_.size();
      if (finish(candidate, result)) return result;
    }
    std::string reasons;
    for (const Failure& failure : failures_)
      reasons += (reasons.empty() ? "" : "; ") + failure.reason + ": " + std::to_string(failure.count) + " (" +
                 range_text(failure.fewest, failure.most) + " corners)";
    throw base::Error("no-valid-result",
                      "none of " + std::to_string(tried_) + " labelings has a valid map within the budget. " + reasons);
  }

 private:
  struct Candidate {
    double score;  // less is better
    double compactness;
    Normals normals;
    bool drawn;
    Array<AxisLabel> labels;  // of the search surface
    SurfaceMap map;
    Certificate certificate;
  };

  static bool better(const Candidate& a, const Candidate& b) { return a.score < b.score; }

  // One reason, how many labelings met it, and their numbers of corners.
  struct Failure {
    std::string reason;
    std::size_t fewest, most;  // corners of the polycubes that met it
    std::size_t count;
  };

  bool good_enough() const {
    return std::any_of(candidates_.begin(), candidates_.end(),
                       [](const Candidate& c) { return c.score < nearly_isometric; });
  }

  bool fine_is_coarse() const { return triangles_.size() <= coarse_enough; }

  Surface decimated() {
    search_.decimation = decimate(fine_, {}, search_triangles, host_);
    search_.source = search_.decimation.left;
    Array<Index> vertices(host_.memory);
    take_left(search_.decimation, positions_, search_.positions, search_.triangles, vertices, host_);
    return framed(search_.positions, search_.triangles, frame_, host_);
  }

  // Made when they are first requested.
  std::span<const Vector3> normals_for(Normals kind) {
    if (kind == Normals::plain) return coarse_.normals;
    Array<Vector3>& known = kind == Normals::turned ? turned_ : smoothed_;
    if (known.empty() && kind == Normals::turned) known = turned_normals(coarse_, turning_length, host_);
    if (known.empty()) {
      Array<Vector3> flowed(coarse_.positions, host_.memory);
      flow(coarse_, first_smoothing_time, smoothing_steps, flowed, host_);
      known = unit_normals(flowed, coarse_.triangles, host_);
    }
    return known;
  }

  // `detail` goes to the log only.
  void fail(double compactness, Normals normals, std::size_t corners, const std::string& reason,
            const std::string& detail) {
    host_.log(name_of(compactness, normals, corners) + reason + (detail.empty() ? "" : ", " + detail));
    auto same = std::find_if(failures_.begin(), failures_.end(), [&](const Failure& f) { return f.reason == reason; });
    if (same == failures_.end()) same = failures_.insert(failures_.end(), {reason, corners, corners, 0});
    ++same->count;
    same->fewest = std::min(same->fewest, corners);
    same->most = std::max(same->most, corners);
  }

  static std::string name_of(double compactness, Normals normals, std::size_t corners) {
    const char* const kind = normals == Normals::plain ? "" : normals == Normals::smoothed ? "smoothed, " : "turned, ";
    return "compactness " + std::to_string(compactness) + ", " + kind + std::to_string(corners) + " corners: ";
  }

  // Labels of one polycube, most likely.
  bool alike(std::span<const AxisLabel> a, std::span<const AxisLabel> b) const {
    double different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i]) different += coarse_.areas[i];
    return different <= alike_below * coarse_.area;
  }

  void try_labels(double compactness, Normals normals) {
    LabelCosts costs = label_costs(coarse_, normals_for(normals), compactness, host_);
    Array<AxisLabel> labels(coarse_.triangles.size(), host_.memory);
    for (Index i = 0; i < labels.size(); ++i)
      labels[i] = best_label(costs, i);
    expand_labels(coarse_, costs, {}, sweeps, labels, host_);
    try_map(costs, std::move(labels), compactness, normals);
  }

  // Boxes for what the best polycube has no room for, one at a time.
  void pull_out_protrusions() {
    Array<std::uint8_t> tried(coarse_.triangles.size(), 0, host_.memory);
    changes_left_ += max_protrusion_changes;
    steps_left_ += max_protrusion_steps;
    for (int protrusion = 0; protrusion < max_protrusions; ++protrusion) {
      const std::size_t best = static_cast<std::size_t>(
          std::min_element(candidates_.begin(), candidates_.end(), better) - candidates_.begin());
      const DistortedRegions regions = find_distorted_regions(coarse_, candidates_[best].map, host_);
      const Index region = next_region(regions, tried);
      if (region == no_index) return;
      const double before = candidates_[best].score;
      for (const Normals normals : all_normals) {
        pull_out(regions, region, best, normals);
        if (std::any_of(candidates_.begin(), candidates_.end(), [&](const Candidate& c) { return c.score < before; }))
          break;
      }
    }
  }

  // The largest region that is not for the most part one that was tried.
  static Index next_region(const DistortedRegions& regions, Array<std::uint8_t>& tried) {
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

  // Labels the region again, where boundaries of patches cost less there.
  void pull_out(const DistortedRegions& regions, Index region, std::size_t candidate, Normals normals) {
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
        costs.boundary[h] = limb_compactness / compactness * costs.boundary[h];
        costs.boundary[coarse_.opposite(h)] = costs.boundary[h];
      }
    }
    expand_labels(coarse_, costs, free, sweeps, labels, host_);
    try_map(costs, std::move(labels), compactness, normals);
  }

  // Adds a candidate if there is a map with about these labels.
  void try_map(LabelCosts& costs, Array<AxisLabel> labels, double compactness, Normals normals) {
    ++tried_;
    LabelFaults faults = repair_labels(coarse_, costs, repair_passes, labels, host_);
    const auto refuse = [&](const std::string& reason, const std::string& detail = {}) {
      fail(compactness, normals, faults.corners, reason, detail);
    };
    if (faults.total() > 0) return refuse("faults of labels could not be repaired");
    // What is changed in the search loses corners, but not that many.
    const auto far_above = [&] { return options_.corners > 0 && faults.corners > 2 * options_.corners; };
    if (far_above()) return refuse("more corners than the budget");
    const double conflict =
        search_labels(coarse_, costs, options_.corners, options_.seed, changes_left_, labels, host_);
    faults = find_faults(coarse_, find_patches(coarse_, labels, host_));
    if (options_.corners > 0 && faults.corners > options_.corners) return refuse("more corners than the budget");
    if (conflict > 0) return refuse("no signs of arcs make the labels those of a polycube");
    const auto same = [&](const Candidate& c) {
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
    candidates_.push_back({(many ? many_corners : 1) * d.angle_weighted_mean * d.area_weighted_mean, compactness,
                           normals, drawn, std::move(labels), std::move(map), std::move(outcome.certificate)});
  }

  // A valid map instead of one with some triangles flipped; whether there is one.
  bool draw(SurfaceMap& map, LabelledMapOutcome& outcome) const {
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

  // Where the candidate's map has the planes of the given triangles of the whole surface's map.
  Array<double> planes_of(const Candidate& candidate, const SurfaceMap& map, std::span<const Index> triangles) const {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Array<double> plane(triangles_.size(), unknown, host_.memory);
    Array<AxisLabel> label(triangles_.size(), label_count, host_.memory);
    for (std::size_t i = 0; i < candidate.map.triangles.size(); ++i) {
      const Index source = search_.source[candidate.map.triangle_sources[i]];
      label[source] = candidate.map.labels[i];
      plane[source] = frame_.scale * candidate.map.polycube[candidate.map.triangles[i][0]][axis_of(label[source])];
    }
    Array<double> result(host_.memory);
    for (const Index t : triangles) {
      const Index source = map.triangle_sources[t];
      result.push_back(label[source] == map.labels[t] ? plane[source] : unknown);
    }
    return result;
  }

  void fail_whole(const Candidate& candidate, const std::string& detail) {
    fail(candidate.compactness, candidate.normals, candidate.certificate.corners, "lost on the whole surface", detail);
  }

  // On the polycube of the candidate, drawn along its map.
  void draw_whole(const Candidate& candidate, Construction& result) {
    const PatchGraph target = make_patch_graph(candidate.map, host_);
    DrawingOptions drawing;
    drawing.model = &candidate.map;
    drawing.redrawings = 0;
    drawing.smoothing_rounds = 0;
    Construction made = construct_on(positions_, triangles_, target, candidate.certificate.genus, drawing, host_);
    result.map = std::move(made.map);
    result.certificate = std::move(made.certificate);
    result.distortion = made.distortion;
  }

  // The map of the whole surface.
  bool finish(Candidate& candidate, Construction& result) {
    try {
      return make_whole(candidate, result);
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      fail_whole(candidate, error.what());
      return false;
    }
  }

  bool make_whole(Candidate& candidate, Construction& result) {
    if (search_.source.empty()) {
      result.map = std::move(candidate.map);
      result.certificate = std::move(candidate.certificate);
      result.distortion = measure_distortion(result.map, host_);
      return true;
    }
    if (candidate.drawn) {
      draw_whole(candidate, result);
      return true;
    }
    const LabelCosts costs = label_costs(fine_, fine_.normals, candidate.compactness, host_);
    Array<AxisLabel> labels(triangles_.size(), host_.memory);
    for (std::size_t i = 0; i < search_.source.size(); ++i)
      labels[search_.source[i]] = candidate.labels[i];
    undo_labels(search_.decimation, costs.data, labels);
    smooth_labels(fine_, costs, smoothing_sweeps, labels, host_);
    SurfaceMap map = unrefined(positions_, triangles_, labels, host_);
    split_chords(map, host_);

    // Solved on a coarse surface that keeps the patches, then brought to the fine one.
    const Surface refined = framed(map.positions, map.triangles, frame_, host_);
    Decimation decimation = decimate(refined, map.labels, map_triangles, host_);
    SurfaceMap small(host_.memory);
    Array<Index> vertices(host_.memory);
    take_left(decimation, map.positions, small.positions, small.triangles, vertices, host_);
    for (const Index t : decimation.left)
      small.labels.push_back(AxisLabel{map.labels[t]});
    set_unrefined(small);
    LabelledMapOptions map_options;
    map_options.seed = options_.seed;
    map_options.polishing_steps = final_polishing_steps;
    const LabelledMapOutcome outcome =
        make_labelled_map(small, frame_, map_options, planes_of(candidate, map, decimation.left), host_);
    if (!outcome.valid()) {
      fail_whole(candidate, outcome.reason);
      return false;
    }
    map.polycube.resize(map.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      map.polycube[vertices[i]] = frame_.scale * small.polycube[i];
    refine_map(refined, map.labels, decimation, map_options.area_weight, final_sweeps, map.polycube, host_);
    for (Vector3& p : map.polycube)
      p /= frame_.scale;
    result.certificate = certify(map, host_);
    if (!result.certificate.valid()) {
      fail_whole(candidate, result.certificate.reason);
      return false;
    }
    result.map = std::move(map);
    result.distortion = measure_distortion(result.map, host_);
    return true;
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const LabelConstructionOptions& options_;
  const base::Host& host_;
  Frame frame_;
  Surface fine_;
  SearchSurface search_;
  Surface coarse_;
  Array<Vector3> smoothed_, turned_;  // normals of the coarse surface
  Array<Candidate> candidates_;
  std::size_t tried_ = 0;
  std::size_t changes_left_ = max_changes, steps_left_ = max_map_steps;
  std::vector<Failure> failures_;
};

}  // namespace

Construction construct_by_labels(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const LabelConstructionOptions& options, const base::Host& host) {
  return LabelConstruction(positions, triangles, options, host).run();
}

}  // namespace orbicube::polycube
