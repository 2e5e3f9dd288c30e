#include "polycube/features/features.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "polycube/features/feature_places.h"
#include "polycube/features/sharp_edges.h"
#include "polycube/outputs/patch_graph.h"
#include "polycube/surface/unit_size.h"
#include "polycube/unfolded/polycube_edges.h"
#include "polycube/unfolded/unfolded_corners.h"
#include "polycube/unfolded/unfolded_newton.h"
#include "polycube/unfolded/unfolded_smoothing.h"

namespace orbicube::polycube {
namespace {

// A vertex and where it is drawn, in its plane.
struct Pull {
  Index vertex;
  Vector2d place = Vector2d::Zero();
  Vector2d along = Vector2d::Zero();  // of the line that it may slide on, or zero for a point
  double begin = 0, end = 0;          // of the line, from the place on
  double weight = 0;                  // 0: it must get there
  bool optional = false;              // whether that may fail
  bool pinned = false;
  Vector3 in_space = Vector3::Zero();  // the place, on the polycube
  int axis = -1;                       // of the line

  bool on_line() const { return axis >= 0; }
  // Coordinates that are fixed when it is where it should be.
  std::uint8_t mask() const {
    if (!on_line()) return 3;
    return along.x() != 0 ? 2 : 1;
  }
  // The nearest that will do.
  Vector2d target(const Vector2d& at) const {
    return on_line() ? Vector2d(place + along.dot(at - place) * along) : place;
  }
};

// A sharp edge is not worth a triangle that is as distorted as that, 2 being an isometry.
constexpr double most_distorted = 3000;

class Fit {
 public:
  Fit(SurfaceMap& map, const FeatureOptions& options, const base::Host& host)
      : map_(map),
        options_(options),
        host_(host),
        result_(host.memory),
        pull_of_(map.positions.size(), no_index, host.memory),
        star_(host.memory) {}

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
  static int axis_between(const Vector3& from, const Vector3& to) {
    int axis = -1;
    for (int k = 0; k < 3; ++k) {
      if (from[k] == to[k]) continue;
      base::require(axis < 0, "the line of a feature is not along an axis");
      axis = k;
    }
    base::require(axis >= 0, "the line of a feature has no length");
    return axis;
  }

  void check_vertex(Index v) const {
    base::require(v < map_.positions.size(), "the vertex of a feature does not exist");
  }
  void check_weight(double weight) const {
    base::require(std::isfinite(weight) && weight >= 0, "the weight of a feature must not be negative");
  }

  // Corners walk to their targets; others are ties in planes. Curves first, so that points on them hold them.
  void gather(UnfoldedMap& unfolded) {
    weights_.emplace(unfolded);
    Array<std::array<Index, 2>> walks(host_.memory);  // corner and vertex
    const auto take = [&](Index v) {
      check_vertex(v);
      base::require(unfolded.surface.outgoing(v) != no_index, "the vertex of a feature is in no triangle");
    };
    for (const FeaturePoint& point : options_.points) {
      take(point.vertex);
      check_weight(point.weight);
      base::require(point.place.allFinite(), "the place of a feature is not finite");
      base::require(pull_of_[point.vertex] == no_index && !is_walked(walks, point.vertex), "a vertex has two places");
      add_point(unfolded, point, walks);
    }
    for (const FeatureCurve& curve : options_.curves) {
      check_weight(curve.weight);
      base::require(curve.vertices.size() >= 2, "the curve of a feature has fewer than two vertices");
      base::require(curve.from.allFinite() && curve.to.allFinite(), "the line of a feature is not finite");
      const int axis = axis_between(curve.from, curve.to);
      double whole = 0, length = 0;
      for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
        take(curve.vertices[i]);
        if (i > 0) whole += (map_.positions[curve.vertices[i]] - map_.positions[curve.vertices[i - 1]]).norm();
      }
      base::require(whole > 0, "the curve of a feature has no length");
      for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
        if (i > 0) length += (map_.positions[curve.vertices[i]] - map_.positions[curve.vertices[i - 1]]).norm();
        if (is_walked(walks, curve.vertices[i]) || pull_of_[curve.vertices[i]] != no_index) continue;
        if (i == 0 || i + 1 == curve.vertices.size()) {
          add_point(unfolded, {curve.vertices[i], i == 0 ? curve.from : curve.to, curve.weight}, walks);
          continue;
        }
        const double part = length / whole;
        Pull pull{.vertex = curve.vertices[i], .weight = curve.weight, .in_space = curve.from, .axis = axis};
        pull.in_space[axis] = curve.from[axis] + part * (curve.to[axis] - curve.from[axis]);
        pull.begin = curve.from[axis] - pull.in_space[axis];
        pull.end = curve.to[axis] - pull.in_space[axis];
        add(pull);
      }
    }
    if (options_.feature_angle > 0) add_sharp(unfolded, walks);
    find_places(unfolded);
    tie(unfolded, 0, false);  // corners keep off what is tied
    for (const auto& [corner, vertex] : walks) {
      const bool there = walk_corner(unfolded, *weights_, corner, vertex, host_);
      unfolded.corners[corner].held = there;
      if (!there && !optional_corner(walks, corner))
        throw base::Error("no-valid-result",
                          "a corner of the polycube does not come to vertex " + std::to_string(vertex));
    }
  }

  void add_point(const UnfoldedMap& unfolded, const FeaturePoint& point, Array<std::array<Index, 2>>& walks) {
    const Index corner = corner_at(unfolded, point.place);
    if (corner == no_index || point.weight > 0) {
      add({.vertex = point.vertex, .weight = point.weight, .in_space = point.place});
      return;
    }
    base::require(std::none_of(walks.begin(), walks.end(), [&](const auto& w) { return w[0] == corner; }),
                  "a corner of the polycube has two vertices");
    walks.push_back({corner, point.vertex});
  }

  static bool is_walked(std::span<const std::array<Index, 2>> walks, Index vertex) {
    return std::any_of(walks.begin(), walks.end(), [&](const auto& w) { return w[1] == vertex; });
  }
  bool optional_corner(std::span<const std::array<Index, 2>> walks, Index corner) const {
    for (std::size_t i = 0; i < first_optional_walk_ && i < walks.size(); ++i)
      if (walks[i][0] == corner) return false;
    return true;
  }

  static Index corner_at(const UnfoldedMap& unfolded, const Vector3& place) {
    constexpr double rounding = 1e-9;
    for (Index c = 0; c < unfolded.corners.size(); ++c)
      if ((unfolded.corners[c].place - place).norm() <= rounding * (1 + place.norm())) return c;
    return no_index;
  }

  void add(const Pull& pull) {
    base::require(pull_of_[pull.vertex] == no_index, "a vertex has two places");
    pull_of_[pull.vertex] = static_cast<Index>(pulls_.size());
    pulls_.push_back(pull);
  }

  void add_sharp(const UnfoldedMap& unfolded, Array<std::array<Index, 2>>& walks) {
    const PatchGraph graph = make_patch_graph(map_, host_);
    const SharpEdges sharp = find_sharp_edges(map_, graph, options_.feature_angle, host_);
    result_.sharp_length = sharp.length;
    first_optional_walk_ = walks.size();
    for (const SharpVertex& s : sharp.vertices) {
      if (pull_of_[s.vertex] != no_index || is_walked(walks, s.vertex)) continue;
      if (s.corner == no_index && unfolded.is_corner(s.vertex)) continue;
      if (s.corner != no_index) {
        const Index corner = corner_at(unfolded, graph.corners[s.corner]);
        const bool taken = std::any_of(walks.begin(), walks.end(), [&](const auto& w) { return w[0] == corner; });
        if (!taken) walks.push_back({corner, s.vertex});
        continue;
      }
      const Vector3 &from = graph.corners[graph.origin(2 * s.edge)], &to = graph.corners[graph.target(2 * s.edge)];
      const int axis = axis_between(from, to);
      Pull pull{.vertex = s.vertex, .optional = true, .in_space = from, .axis = axis};
      const auto [low, high] = std::minmax(from[axis], to[axis]);
      // At a corner there is no line.
      const double inset = 1e-3 * (high - low);
      pull.in_space[axis] = std::clamp(map_.polycube[s.vertex][axis], low + inset, high - inset);
      pull.begin = from[axis] - pull.in_space[axis];
      pull.end = to[axis] - pull.in_space[axis];
      add(pull);
    }
  }

  void find_places(UnfoldedMap& unfolded) {
    // A corner has no plane of its own: it leaves vertices that are to be elsewhere. That changes what the map is, so
    // places are looked for on what it is then.
    bool left = false;
    tie(unfolded, 0, false);  // nor do they go to such vertices
    for (const Pull& pull : pulls_) {
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
    for (Pull& pull : pulls_) {
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
    for (const Pull& pull : pulls_) {
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
    for (Pull& pull : pulls_) {
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
      worst = std::max(worst, distortion(jacobian(t.rest, place, t.a, t.b)));
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
    for (const Pull& pull : pulls_) {
      if (pull.pinned || pull.weight > 0 || pull.optional) continue;
      const Vector2d at = unfolded.image[pull.vertex];
      throw base::Error("no-valid-result", "vertex " + std::to_string(pull.vertex) +
                                               " comes no nearer to its place than " +
                                               std::to_string((at - pull.target(at)).norm()));
    }
    // What cannot be met is let go.
    std::erase_if(pulls_, [](const Pull& p) { return p.optional && !p.pinned; });
    tie(unfolded, 0, true);
  }

  // Vertices of sharp edges that have slid past the end of their line belong elsewhere.
  bool let_go(UnfoldedMap& unfolded) {
    return std::erase_if(pulls_, [&](const Pull& pull) {
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
    for (const Pull& pull : pulls_) {
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
      check_vertex(point.vertex);
      distances.push_back((map.polycube[point.vertex] - point.place).norm());
    }
    for (const FeatureCurve& curve : options_.curves) {
      const int axis = axis_between(curve.from, curve.to);
      const auto [low, high] = std::minmax(curve.from[axis], curve.to[axis]);
      double farthest = 0;
      for (const Index v : curve.vertices) {
        check_vertex(v);
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
  Array<Pull> pulls_{host_.memory};
  Array<Index> pull_of_;  // of each vertex
  std::size_t first_optional_walk_ = no_index;
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
