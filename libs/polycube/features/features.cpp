#include "polycube/features/features.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "polycube/features/feature_places.h"
#include "polycube/features/feature_targets.h"
#include "polycube/features/sharp_edges.h"
#include "polycube/surface/unit_size.h"
#include "polycube/unfolded/polycube_edges.h"
#include "polycube/unfolded/unfolded_corners.h"
#include "polycube/unfolded/unfolded_newton.h"
#include "polycube/unfolded/unfolded_smoothing.h"

namespace orbicube::polycube {
namespace {

// A sharp edge is not worth a triangle that is as distorted as that, 2 being an isometry.
constexpr double most_distorted = 3000;

class Fit {
 public:
  Fit(SurfaceMap& map, const FeatureOptions& options, const base::Host& host)
      : map_(map), options_(options), host_(host), result_(host.memory), star_(host.memory) {}

  FeatureFit run() {
    Certificate before = certify(map_.polycube, map_.triangles, host_);
    base::require(before.valid() && map_.labels.size() == map_.triangles.size(), "the map is not certified");
    base::require(options_.feature_angle >= 0 && options_.feature_angle < 180, "feature_angle must be from 0 to 180");
    result_.distortion_before = measure_distortion(map_, host_);
    measure(map_, result_.distances_before);
    if (options_.feature_angle > 0) result_.sharp_before = length_on_edges(map_, options_.feature_angle, host_);
    UnfoldedMap unfolded(map_, host_);
    gather(unfolded);
    if (pulls_.empty()) {
      result_.certificate = std::move(before);
      result_.distortion = result_.distortion_before;
      result_.distances = result_.distances_before;
      result_.sharp = result_.sharp_before;
      return std::move(result_);
    }
    draw_near(unfolded);
    settle(unfolded);
    SurfaceMap made = fold(unfolded, host_);
    result_.certificate = certify(made, host_);
    if (result_.certificate.valid() && put_exactly(made)) result_.certificate = certify(made, host_);
    if (!result_.certificate.valid()) throw base::Error("no-valid-result", result_.certificate.reason);
    result_.distortion = measure_distortion(made, host_);
    measure(made, result_.distances);
    if (options_.feature_angle > 0) result_.sharp = length_on_edges(made, options_.feature_angle, host_);
    std::swap(map_, made);
    return std::move(result_);
  }

 private:
  // Corners walk to their targets; other vertices are tied in planes.
  void gather(UnfoldedMap& unfolded) {
    weights_.emplace(unfolded);
    FeatureTargets targets = gather_targets(map_, unfolded, options_, host_);
    pulls_ = std::move(targets.pulls);
    result_.sharp_length = targets.sharp_length;
    find_places(unfolded);
    tie(unfolded, 0, false);  // corners keep off what is tied
    for (const CornerWalk& walk : targets.walks) {
      const bool there = walk_corner(unfolded, *weights_, walk.corner, walk.vertex, host_);
      unfolded.corners[walk.corner].held = there;
      if (!there && !walk.optional)
        throw base::Error("no-valid-result",
                          "a corner of the polycube does not come to vertex " + std::to_string(walk.vertex));
    }
  }

  void find_places(UnfoldedMap& unfolded) {
    // A corner has no plane of its own: it leaves vertices that are to be elsewhere. That changes what the map is, so
    // places are looked for on what it is then.
    bool left = false;
    tie(unfolded, 0, false);  // nor do they go to such vertices
    for (const FeaturePull& pull : pulls_) {
      if (!unfolded.is_corner(pull.vertex)) continue;
      if (!leave_vertex(unfolded, *weights_, unfolded.corner_at[pull.vertex], host_))
        throw base::Error("no-valid-result",
                          "a corner of the polycube cannot leave vertex " + std::to_string(pull.vertex));
      left = true;
    }
    if (left) {
      SurfaceMap moved = fold(unfolded, host_);
      const Certificate certificate = certify(moved, host_);
      if (!certificate.valid()) throw base::Error("no-valid-result", certificate.reason);
      map_ = std::move(moved);
      unfolded = UnfoldedMap(map_, host_);
    }
    FeaturePlaces finder(map_, unfolded, host_);
    for (FeaturePull& pull : pulls_) {
      Vector3 at = pull.in_space;
      if (pull.axis >= 0) {
        // Within the line, where it is plain in which face it lies.
        constexpr double inset = 1e-6;
        const auto [low, high] = std::minmax(pull.begin, pull.end);
        at[pull.axis] += std::clamp(0.0, low + inset * (high - low), high - inset * (high - low));
      }
      const auto found = finder.find(pull.vertex, at, pull.axis);
      pull.place = found.place;
      pull.along = found.along;
      if (pull.axis >= 0) pull.place += (pull.in_space[pull.axis] - at[pull.axis]) * found.along;
    }
  }

  // Ties of all that is not pinned; those that must be met have this weight.
  void tie(UnfoldedMap& unfolded, double weight, bool sliding) const {
    unfolded.ties.clear();
    std::fill(unfolded.tie_at.begin(), unfolded.tie_at.end(), no_index);
    for (const FeaturePull& pull : pulls_) {
      if (pull.pinned) continue;
      const double w = (pull.weight > 0 ? pull.weight : weight) / weights_->area;
      PlaneTie t{pull.place, {w, w}};
      // Along its line a vertex is drawn a little while it is on its way, so that vertices stay in their order.
      constexpr double along_line = 1e-3;
      if (pull.on_line()) t.weight[pull.along.x() != 0 ? 0 : 1] = sliding ? 0 : along_line * w;
      unfolded.tie_at[pull.vertex] = static_cast<Index>(unfolded.ties.size());
      unfolded.ties.push_back(t);
    }
  }

  // Puts what is near its place there, where triangles stay positive and sound. Returns how many are still to be put.
  std::size_t pin(UnfoldedMap& unfolded, double most_worse, bool optional) {
    std::size_t left = 0;
    for (FeaturePull& pull : pulls_) {
      if (pull.pinned || pull.weight > 0 || (pull.optional && !optional)) continue;
      const Index v = pull.vertex;
      star_.gather(unfolded, *weights_, v);
      star_.tie = nullptr;
      const Vector2d there = pull.target(unfolded.image[v]);
      const bool sound = star_.positive(there) && star_.energy(there) <= most_worse * star_.energy(unfolded.image[v]);
      if (sound && !(pull.optional && worst_at(there) > most_distorted)) {
        unfolded.image[v] = there;
        unfolded.held[v] = pull.mask();
        unfolded.tie_at[v] = no_index;
        pull.pinned = true;
      } else {
        ++left;
      }
    }
    unfolded.follow_corners();
    return left;
  }

  // Of the triangles around the vertex that was gathered.
  double worst_at(const Vector2d& place) const {
    double worst = 0;
    for (const UnfoldedStar::Corner& t : star_.triangles)
      worst = std::max(worst, untangle::barrier(jacobian(t.rest, place, t.a, t.b)));
    return worst;
  }

  void draw_near(UnfoldedMap& unfolded) {
    constexpr int steps = 20;
    constexpr double min_gain = 1e-4, last = 1e7;
    std::size_t left = 1;
    for (double weight = 1; weight <= last && left > 0; weight *= 10) {
      tie(unfolded, weight, false);
      *weights_ = TriangleWeights(unfolded);
      move_all(unfolded, *weights_, steps, min_gain, host_);
      left = pin(unfolded, 1.5, true);
    }
    if (left > 0) pin(unfolded, 1e3, false);
    for (const FeaturePull& pull : pulls_) {
      if (pull.pinned || pull.weight > 0 || pull.optional) continue;
      const Vector2d at = unfolded.image[pull.vertex];
      throw base::Error("no-valid-result", "vertex " + std::to_string(pull.vertex) +
                                               " comes no nearer to its place than " +
                                               std::to_string((at - pull.target(at)).norm()));
    }
    // What cannot be met is let go.
    std::erase_if(pulls_, [](const FeaturePull& p) { return p.optional && !p.pinned; });
    tie(unfolded, 0, true);
  }

  // Vertices of sharp edges that have slid past the end of their line belong elsewhere.
  bool let_go(UnfoldedMap& unfolded) {
    return std::erase_if(pulls_, [&](const FeaturePull& pull) {
             if (!pull.optional) return false;
             const double part = pull.along.dot(unfolded.image[pull.vertex] - pull.place);
             const auto [low, high] = std::minmax(pull.begin, pull.end);
             if (part >= low && part <= high) return false;
             unfolded.held[pull.vertex] = 0;
             return true;
           }) > 0;
  }

  void settle(UnfoldedMap& unfolded) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
      smooth_unfolded(unfolded, {.newton_steps = options_.newton_steps}, host_);
      if (!let_go(unfolded)) return;
    }
  }

  // What is met in the plane of a vertex is met on the polycube but for rounding, which goes here. Whether anything
  // did.
  bool put_exactly(SurfaceMap& made) const {
    bool changed = false;
    const double rounding = 1e-9 * std::sqrt(weights_->area);
    Array<std::uint8_t> in_plane(made.positions.size(), 0, host_.memory);  // by axes of the faces at a vertex
    for (std::size_t t = 0; t < made.triangles.size(); ++t)
      for (const Index v : made.triangles[t])
        in_plane[v] |= static_cast<std::uint8_t>(1U << axis_of(made.labels[t]));
    for (const FeaturePull& pull : pulls_) {
      // On edges of the polycube folding has put vertices exactly; sharp edges are nowhere else.
      if (!pull.pinned || pull.optional) continue;
      for (int k = 0; k < 3; ++k) {
        double& now = made.polycube[pull.vertex][k];
        if ((in_plane[pull.vertex] >> k & 1) != 0 || (pull.on_line() && k == pull.axis) || now == pull.in_space[k])
          continue;
        if (std::abs(now - pull.in_space[k]) > rounding)
          throw base::Error("no-valid-result", "vertex " + std::to_string(pull.vertex) +
                                                   " comes to its place on the wrong side of a corner of the polycube");
        now = pull.in_space[k];
        changed = true;
      }
    }
    return changed;
  }

  void measure(const SurfaceMap& map, Array<double>& distances) const {
    distances.clear();
    for (const FeaturePoint& point : options_.points) {
      require_vertex(map_, point.vertex);
      distances.push_back((map.polycube[point.vertex] - point.place).norm());
    }
    for (const FeatureCurve& curve : options_.curves) {
      const int axis = axis_between(curve.from, curve.to);
      const auto [low, high] = std::minmax(curve.from[axis], curve.to[axis]);
      double farthest = 0;
      for (const Index v : curve.vertices) {
        require_vertex(map_, v);
        Vector3 nearest = curve.from;
        nearest[axis] = std::clamp(map.polycube[v][axis], low, high);
        farthest = std::max(farthest, (nearest - map.polycube[v]).norm());
      }
      distances.push_back(farthest);
    }
  }

  SurfaceMap& map_;
  const FeatureOptions& options_;
  const base::Host& host_;
  FeatureFit result_;
  std::optional<TriangleWeights> weights_;
  Array<FeaturePull> pulls_{host_.memory};
  UnfoldedStar star_;
};

}  // namespace

FeatureFit align_features(SurfaceMap& map, const FeatureOptions& options, const base::Host& host) {
  SurfaceMap trial(host.memory);
  trial = map;
  FeatureFit result = [&] {
    const AtUnitSize unit(trial);
    base::require(unit.exponent() == 0 || (options.points.empty() && options.curves.empty()),
                  "points and curves of a surface below 1e-30 or above 1e30; scale both first");
    FeatureFit found = Fit(trial, options, host).run();
    for (double* length : {&found.sharp, &found.sharp_before, &found.sharp_length})
      *length = std::ldexp(*length, -unit.exponent());
    return found;
  }();
  std::swap(map, trial);
  return result;
}

}  // namespace orbicube::polycube
