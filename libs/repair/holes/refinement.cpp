#include "repair/holes/refinement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <numbers>
#include <unordered_set>

#include "mesh/topology/edge_table.h"

namespace orbicube::repair {
namespace {

using mesh::next_in_triangle;

// Liepa's alpha: larger makes denser patches.
constexpr double density = std::numbers::sqrt2;
constexpr int max_refinements = 40;
constexpr int max_flip_passes = 20;
constexpr std::size_t max_points_per_loop_point = 100;

class Refinement {
 public:
  Refinement(Patch& patch, std::span<const std::array<Index, 2>> connected, const base::Host& host)
      : patch_(patch), connected_(connected), opposite_(host.memory), edges_(host.memory), host_(host) {
    opposite_.assign(3 * patch.triangles.size(), no_index);
    const mesh::EdgeTable table(patch.points.size(), patch.triangles, host);
    for (std::size_t e = 0; e < table.size(); ++e) {
      const auto h = table.half_edges(e);
      edges_.insert(key(start(h[0]), end(h[0])));
      if (h.size() != 2) continue;
      opposite_[h[0]] = h[1];
      opposite_[h[1]] = h[0];
    }
  }

  void run() {
    const std::size_t limit = patch_.loop_size * (1 + max_points_per_loop_point);
    relax();
    for (int round = 0; round < max_refinements; ++round) {
      if (!split_large(limit)) break;
      relax();
    }
  }

 private:
  Index start(Index h) const { return mesh::start_of(patch_.triangles, h); }
  Index end(Index h) const { return mesh::end_of(patch_.triangles, h); }
  Index apex(Index h) const { return start(next_in_triangle(next_in_triangle(h))); }
  static std::uint64_t key(Index a, Index b) { return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b); }

  bool split_large(std::size_t limit) {
    bool any = false;
    const std::size_t count = patch_.triangles.size();
    for (Index t = 0; t < count; ++t) {
      if (t % 256 == 0) host_.report("refining patches", t, count);
      if (patch_.points.size() >= limit) return any;
      const Triangle c = patch_.triangles[t];
      const Vector3 center = (patch_.points[c[0]] + patch_.points[c[1]] + patch_.points[c[2]]) / 3;
      const double scale = (patch_.scales[c[0]] + patch_.scales[c[1]] + patch_.scales[c[2]]) / 3;
      const bool large = std::all_of(c.begin(), c.end(), [&](Index v) {
        const double scaled = density * (patch_.points[v] - center).norm();
        return scaled > scale && scaled > patch_.scales[v];
      });
      if (!large) continue;
      split(t, center, scale);
      any = true;
    }
    return any;
  }

  void link(Index h, Index g) {
    opposite_[h] = g;
    if (g != no_index) opposite_[g] = h;
  }

  void split(Index t, const Vector3& center, double scale) {
    const auto v = static_cast<Index>(patch_.points.size());
    patch_.points.push_back(center);
    patch_.scales.push_back(scale);
    const Triangle c = patch_.triangles[t];
    const auto second = static_cast<Index>(patch_.triangles.size());
    const Index third = second + 1;
    const Index across_second = opposite_[3 * t + 1], across_third = opposite_[3 * t + 2];
    patch_.triangles[t] = {c[0], c[1], v};
    patch_.triangles.push_back({c[1], c[2], v});
    patch_.triangles.push_back({c[2], c[0], v});
    opposite_.resize(3 * patch_.triangles.size(), no_index);
    link(3 * second, across_second);
    link(3 * third, across_third);
    link(3 * t + 1, 3 * second + 2);
    link(3 * second + 1, 3 * third + 2);
    link(3 * third + 1, 3 * t + 2);
    for (const Index corner : c)
      edges_.insert(key(corner, v));
  }

  // Flips while edges are not locally Delaunay, a bounded number of times.
  void relax() {
    for (int pass = 0; pass < max_flip_passes; ++pass) {
      bool any = false;
      for (Index h = 0; h < opposite_.size(); ++h) {
        if (h % 1024 == 0) host_.report("refining patches", h, opposite_.size());
        if (opposite_[h] != no_index && h < opposite_[h] && should_flip(h)) {
          flip(h);
          any = true;
        }
      }
      if (!any) return;
    }
  }

  Vector3 normal(Index a, Index b, Index c) const {
    return (patch_.points[b] - patch_.points[a]).cross(patch_.points[c] - patch_.points[a]);
  }
  double angle(Index at, Index from, Index to) const {
    const Vector3 a = patch_.points[from] - patch_.points[at], b = patch_.points[to] - patch_.points[at];
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  bool should_flip(Index h) const {
    const Index a = start(h), b = end(h), c = apex(h), d = apex(opposite_[h]);
    constexpr double margin = 1e-9;  // so that no flip is undone by rounding
    if (angle(c, a, b) + angle(d, a, b) <= std::numbers::pi + margin) return false;
    if (c == d || edges_.contains(key(c, d)) || is_connected_outside(c, d)) return false;
    // The new triangles do not fold.
    return normal(a, d, c).dot(normal(d, b, c)) > 0;
  }
  bool is_connected_outside(Index c, Index d) const {
    return std::max(c, d) < patch_.loop_size &&
           std::binary_search(connected_.begin(), connected_.end(), std::array{std::min(c, d), std::max(c, d)});
  }

  void flip(Index h) {
    const Index g = opposite_[h], t = h / 3, o = g / 3;
    const Index a = start(h), b = end(h), c = apex(h), d = apex(g);
    const Index bc = opposite_[next_in_triangle(h)], ca = opposite_[next_in_triangle(next_in_triangle(h))];
    const Index ad = opposite_[next_in_triangle(g)], db = opposite_[next_in_triangle(next_in_triangle(g))];
    patch_.triangles[t] = {a, d, c};
    patch_.triangles[o] = {d, b, c};
    link(3 * t, ad);
    link(3 * t + 1, 3 * o + 2);
    link(3 * t + 2, ca);
    link(3 * o, db);
    link(3 * o + 1, bc);
    edges_.erase(key(a, b));
    edges_.insert(key(c, d));
  }

  Patch& patch_;
  std::span<const std::array<Index, 2>> connected_;
  Array<Index> opposite_;
  std::pmr::unordered_set<std::uint64_t> edges_;
  const base::Host& host_;
};

}  // namespace

void refine(Patch& patch, std::span<const std::array<Index, 2>> connected, const base::Host& host) {
  Refinement(patch, connected, host).run();
}

}  // namespace orbicube::repair
