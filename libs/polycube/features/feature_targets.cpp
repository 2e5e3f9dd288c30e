#include "polycube/features/feature_targets.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "polycube/features/sharp_edges.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {
namespace {

void check_weight(double weight) {
  base::require(std::isfinite(weight) && weight >= 0, "the weight of a feature must not be negative");
}

class TargetGathering {
 public:
  TargetGathering(const SurfaceMap& map, const UnfoldedMap& unfolded, const FeatureOptions& options,
                  const base::Host& host)
      : map_(map),
        unfolded_(unfolded),
        options_(options),
        host_(host),
        result_(host.memory),
        pull_of_(map.positions.size(), no_index, host.memory) {
    constexpr double rounding = 1e-9;
    for (const auto& corner : unfolded.corners)
      tolerance_ = std::max(tolerance_, rounding * corner.place.norm());
  }

  FeatureTargets run() {
    for (const FeaturePoint& point : options_.points)
      gather(point);
    for (const FeatureCurve& curve : options_.curves)
      gather(curve);
    if (options_.feature_angle > 0) add_sharp();
    return std::move(result_);
  }

 private:
  void require_used(Index v) const {
    require_vertex(map_, v);
    base::require(unfolded_.surface.outgoing(v) != no_index, "the vertex of a feature is in no triangle");
  }

  void gather(const FeaturePoint& point) {
    require_used(point.vertex);
    check_weight(point.weight);
    base::require(point.place.allFinite(), "the place of a feature is not finite");
    base::require(pull_of_[point.vertex] == no_index && !is_walked(point.vertex), "a vertex has two places");
    add_point(point);
  }

  void gather(const FeatureCurve& curve) {
    check_weight(curve.weight);
    base::require(curve.vertices.size() >= 2, "the curve of a feature has fewer than two vertices");
    base::require(curve.from.allFinite() && curve.to.allFinite(), "the line of a feature is not finite");
    const int axis = axis_between(curve.from, curve.to);
    double whole = 0, length = 0;
    for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
      require_used(curve.vertices[i]);
      if (i > 0) whole += (map_.positions[curve.vertices[i]] - map_.positions[curve.vertices[i - 1]]).norm();
    }
    base::require(whole > 0, "the curve of a feature has no length");
    for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
      if (i > 0) length += (map_.positions[curve.vertices[i]] - map_.positions[curve.vertices[i - 1]]).norm();
      if (is_walked(curve.vertices[i]) || pull_of_[curve.vertices[i]] != no_index) continue;
      if (i == 0 || i + 1 == curve.vertices.size()) {
        add_point({curve.vertices[i], i == 0 ? curve.from : curve.to, curve.weight});
        continue;
      }
      const double part = length / whole;
      FeaturePull pull{.vertex = curve.vertices[i], .weight = curve.weight, .in_space = curve.from, .axis = axis};
      pull.in_space[axis] = curve.from[axis] + part * (curve.to[axis] - curve.from[axis]);
      pull.begin = curve.from[axis] - pull.in_space[axis];
      pull.end = curve.to[axis] - pull.in_space[axis];
      add(pull);
    }
  }

  void add_point(const FeaturePoint& point) {
    const Index corner = corner_at(point.place);
    if (corner == no_index || point.weight > 0) {
      add({.vertex = point.vertex, .weight = point.weight, .in_space = point.place});
      return;
    }
    base::require(!has_walk(corner), "a corner of the polycube has two vertices");
    result_.walks.push_back({corner, point.vertex});
  }

  bool is_walked(Index vertex) const {
    return std::any_of(result_.walks.begin(), result_.walks.end(),
                       [&](const CornerWalk& w) { return w.vertex == vertex; });
  }
  bool has_walk(Index corner) const {
    return std::any_of(result_.walks.begin(), result_.walks.end(),
                       [&](const CornerWalk& w) { return w.corner == corner; });
  }

  Index corner_at(const Vector3& place) const {
    for (Index c = 0; c < unfolded_.corners.size(); ++c)
      if ((unfolded_.corners[c].place - place).norm() <= tolerance_) return c;
    return no_index;
  }

  void add(const FeaturePull& pull) {
    base::require(pull_of_[pull.vertex] == no_index, "a vertex has two places");
    pull_of_[pull.vertex] = static_cast<Index>(result_.pulls.size());
    result_.pulls.push_back(pull);
  }

  void add_sharp() {
    const PatchGraph graph = make_patch_graph(map_, host_);
    const SharpEdges sharp = find_sharp_edges(map_, graph, options_.feature_angle, host_);
    result_.sharp_length = sharp.length;
    for (const SharpVertex& s : sharp.vertices) {
      if (pull_of_[s.vertex] != no_index || is_walked(s.vertex)) continue;
      if (s.corner == no_index && unfolded_.is_corner(s.vertex)) continue;
      if (s.corner != no_index) {
        const Index corner = corner_at(graph.corners[s.corner]);
        if (!has_walk(corner)) result_.walks.push_back({corner, s.vertex, true});
        continue;
      }
      const Vector3 &from = graph.corners[graph.origin(2 * s.edge)], &to = graph.corners[graph.target(2 * s.edge)];
      const int axis = axis_between(from, to);
      FeaturePull pull{.vertex = s.vertex, .optional = true, .in_space = from, .axis = axis};
      const auto [low, high] = std::minmax(from[axis], to[axis]);
      // At a corner there is no line.
      const double inset = 1e-3 * (high - low);
      pull.in_space[axis] = std::clamp(map_.polycube[s.vertex][axis], low + inset, high - inset);
      pull.begin = from[axis] - pull.in_space[axis];
      pull.end = to[axis] - pull.in_space[axis];
      add(pull);
    }
  }

  const SurfaceMap& map_;
  const UnfoldedMap& unfolded_;
  const FeatureOptions& options_;
  const base::Host& host_;
  FeatureTargets result_;
  Array<Index> pull_of_;  // of each vertex
  double tolerance_ = 0;  // of places that are corners
};

}  // namespace

int axis_between(const Vector3& from, const Vector3& to) {
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    if (from[k] == to[k]) continue;
    base::require(axis < 0, "the line of a feature is not along an axis");
    axis = k;
  }
  base::require(axis >= 0, "the line of a feature has no length");
  return axis;
}

void require_vertex(const SurfaceMap& map, Index vertex) {
  base::require(vertex < map.positions.size(), "the vertex of a feature does not exist");
}

FeatureTargets gather_targets(const SurfaceMap& map, const UnfoldedMap& unfolded, const FeatureOptions& options,
                              const base::Host& host) {
  return TargetGathering(map, unfolded, options, host).run();
}

}  // namespace orbicube::polycube
