#include "repair/holes/triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::repair {
namespace {

// Points of a loop that dynamic programming takes at once. Larger: O(n^3) time, better patches of large holes.
constexpr std::size_t max_points = 150;
// Points of the coarse loop that divides a larger one.
constexpr std::size_t coarse_points = 75;

struct Weight {
  std::size_t avoided = 0;  // triangles that should not be there
  double angle = 0;         // 1 - cosine of the largest dihedral angle
  double area = 0;
  bool operator<(const Weight& o) const {
    if (avoided != o.avoided) return avoided < o.avoided;
    return angle != o.angle ? angle < o.angle : area < o.area;
  }
};
constexpr Weight impossible{std::numeric_limits<std::size_t>::max(), std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::infinity()};

class Triangulation {
 public:
  Triangulation(const Loop& loop, std::span<const Index> chosen, std::span<const Vector3> apexes,
                const base::Host& host)
      : loop_(loop),
        chosen_(chosen),
        apexes_(apexes),
        n_(chosen.size()),
        weight_(n_ * n_, host.memory),
        middle_(n_ * n_, 0, host.memory),
        normal_(n_ * n_, Vector3::Zero(), host.memory),
        host_(host) {}

  // Appends triangles of numbers of points of the loop; returns whether there is a way.
  bool run(Array<Triangle>& triangles) {
    for (std::size_t i = 0; i + 1 < n_; ++i)
      normal_[at(i, i + 1)] = side(i, i + 1, apexes_[i]);
    for (std::size_t length = 2; length < n_; ++length) {
      host_.report("filling holes", length, n_);
      for (std::size_t i = 0; i + length < n_; ++i)
        choose(i, i + length);
    }
    if (!std::isfinite(weight_[at(0, n_ - 1)].angle)) return false;
    collect(triangles);
    return true;
  }

 private:
  std::size_t at(std::size_t i, std::size_t k) const { return i * n_ + k; }
  const Vector3& point(std::size_t i) const { return loop_.points[chosen_[i]]; }

  // The normal of the triangle across edge i, k, that passes it from k to i; zero where there is none.
  Vector3 side(std::size_t i, std::size_t k, const Vector3& apex) const {
    if (!apex.allFinite()) return Vector3::Zero();
    return unit((point(i) - point(k)).cross(apex - point(k)));
  }
  static Vector3 unit(const Vector3& n) {
    const double length = n.norm();
    return length > 0 ? Vector3(n / length) : Vector3::Zero();
  }
  // Of two normals; one that is not known is as good as none.
  static double bend(const Vector3& a, const Vector3& b) {
    return a.isZero(0) || b.isZero(0) ? 0 : 1 - std::clamp(a.dot(b), -1.0, 1.0);
  }

  bool is_connected(std::size_t i, std::size_t k) const {
    const Index a = std::min(chosen_[i], chosen_[k]), b = std::max(chosen_[i], chosen_[k]);
    return std::binary_search(loop_.connected.begin(), loop_.connected.end(), std::array<Index, 2>{a, b});
  }

  void choose(std::size_t i, std::size_t k) {
    Weight best = impossible;
    const bool whole = i == 0 && k == n_ - 1;
    if (whole || !is_connected(i, k)) {
      for (std::size_t m = i + 1; m < k; ++m) {
        const Weight& left = weight_[at(i, m)];
        const Weight& right = weight_[at(m, k)];
        const double bound = std::max(left.angle, right.angle);
        if (!std::isfinite(bound)) continue;
        const std::size_t avoided = left.avoided + right.avoided;
        if (avoided > best.avoided || (avoided == best.avoided && bound > best.angle)) continue;
        const Vector3 cross = (point(m) - point(i)).cross(point(k) - point(i));
        const double twice_area = cross.norm();
        const Vector3 n = twice_area > 0 ? Vector3(cross / twice_area) : Vector3::Zero();
        Weight w;
        w.avoided = avoided;
        w.angle = std::max({bound, bend(n, normal_[at(i, m)]), bend(n, normal_[at(m, k)])});
        if (whole) w.angle = std::max(w.angle, bend(n, side(k, i, apexes_[k])));
        // Flat triangles only where nothing else is possible.
        if (!(twice_area > 0)) w.angle = 3;
        w.area = left.area + right.area + 0.5 * twice_area;
        if (!(w < best)) continue;
        if (loop_.avoids && loop_.avoids({chosen_[i], chosen_[m], chosen_[k]})) {
          ++w.avoided;
          if (!(w < best)) continue;
        }
        best = w;
        middle_[at(i, k)] = static_cast<Index>(m);
        normal_[at(i, k)] = n;
      }
    }
    weight_[at(i, k)] = best;
  }

  void collect(Array<Triangle>& triangles) const {
    Array<std::array<std::size_t, 2>> open(1, {0, n_ - 1}, host_.memory);
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k < i + 2) continue;
      const std::size_t m = middle_[at(i, k)];
      triangles.push_back({chosen_[i], chosen_[m], chosen_[k]});
      open.push_back({m, k});
      open.push_back({i, m});
    }
  }

  const Loop& loop_;
  std::span<const Index> chosen_;
  std::span<const Vector3> apexes_;
  std::size_t n_;
  Array<Weight> weight_;
  Array<Index> middle_;
  Array<Vector3> normal_;
  const base::Host& host_;
};

// Points of the loop that follow each other, closed by one edge from the last to the first.
struct Piece {
  std::size_t begin, end;  // its first and last points
  Vector3 apex;            // across the closing edge
};

// Triangulates pieces of any size: large ones through a coarse loop, whose edges close smaller pieces.
bool triangulate_pieces(const Loop& loop, const base::Host& host, Array<Triangle>& triangles) {
  const std::size_t n = loop.points.size();
  const Vector3 none = Vector3::Constant(std::numeric_limits<double>::quiet_NaN());
  Array<Piece> open(host.memory);
  open.push_back({0, n - 1, loop.apexes[n - 1]});
  Array<Index> chosen(host.memory);
  Array<Vector3> apexes(host.memory);
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const std::size_t edges = piece.end - piece.begin;
    const std::size_t steps = edges + 1 <= max_points ? edges : coarse_points;
    chosen.clear(), apexes.clear();
    for (std::size_t s = 0; s <= steps; ++s)
      chosen.push_back(static_cast<Index>(piece.begin + s * edges / steps));
    for (std::size_t s = 0; s < steps; ++s)
      apexes.push_back(chosen[s + 1] == chosen[s] + 1 ? loop.apexes[chosen[s]] : none);
    apexes.push_back(piece.apex);
    const std::size_t first = triangles.size();
    if (!Triangulation(loop, chosen, apexes, host).run(triangles)) return false;
    if (steps == edges) continue;
    for (std::size_t s = 0; s < steps; ++s) {
      if (chosen[s + 1] == chosen[s] + 1) continue;
      // The corner of the coarse triangle across the closing edge.
      Vector3 apex = none;
      for (std::size_t t = first; t < triangles.size(); ++t) {
        const Triangle& c = triangles[t];
        const auto has = [&](Index v) { return c[0] == v || c[1] == v || c[2] == v; };
        if (!has(chosen[s]) || !has(chosen[s + 1])) continue;
        for (const Index v : c) {
          if (v != chosen[s] && v != chosen[s + 1]) apex = loop.points[v];
        }
      }
      open.push_back({chosen[s], chosen[s + 1], apex});
    }
  }
  return true;
}

}  // namespace

Array<Triangle> triangulate(const Loop& loop, const base::Host& host) {
  Array<Triangle> triangles(host.memory);
  if (!triangulate_pieces(loop, host, triangles)) triangles.clear();
  return triangles;
}

}  // namespace orbicube::repair
