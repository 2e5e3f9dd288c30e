#include "sphere_map/correspondence/overlay.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/connectivity.h"
#include "sphere_map/optimization/distortion.h"
#include "sphere_map/sampling/locator.h"
#include "sphere_map/sampling/triangle_walk.h"

namespace orbicube::sphere_map {
namespace {

// A triangulation of the sphere that grows. Half-edge 3 t + k goes from corner k of triangle t to the next.
class Triangulation {
 public:
  Triangulation(const PlacedMap& map, const mesh::Connectivity& connectivity, const base::Host& host)
      : directions_(map.directions.begin(), map.directions.end(), host.memory),
        triangles_(map.triangles.begin(), map.triangles.end(), host.memory),
        opposite_(host.memory),
        edges_(3 * map.triangles.size(), EdgeFacts{true, unknown}, host.memory),
        pending_(host.memory) {
    opposite_.reserve(3 * triangles_.size());
    for (Index h = 0; h < 3 * triangles_.size(); ++h)
      opposite_.push_back(connectivity.opposite(h));
  }

  // The vertex at the direction, a new one if there is none. `near` is a triangle to start the search from.
  Index insert(const Vector3& direction, Index near) {
    const auto side = [&](Index h) {
      return mesh::orientation_from_origin(directions_[start(h)], directions_[end(h)], direction);
    };
    const std::size_t longest = 1000 + 8 * static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles_.size())));
    auto found = walk_to(near, longest, side, [&](Index h) { return opposite_[h]; });
    if (!found) found = scan_for(triangles_.size(), side);
    if (!found) throw base::Error("internal", "a direction is in no triangle of a bijection");
    if (const unsigned corner = found->corner(); corner < 3) return triangles_[found->triangle][corner];
    const auto vertex = static_cast<Index>(directions_.size());
    directions_.push_back(direction);
    if (found->on_edges == 0) {
      split_triangle(found->triangle, vertex);
    } else {
      split_edge(3 * found->triangle + static_cast<Index>(std::countr_zero(found->on_edges)), vertex);
    }
    make_delaunay();
    return vertex;
  }

  // Halves the edge, fixed or free, unless that would make a triangle that is not safely positive.
  bool halve(Index h) {
    const Index g = opposite_[h];
    const Vector3 A = directions_[start(h)], B = directions_[end(h)];
    const Vector3 &C = directions_[apex(h)], &D = directions_[apex(g)];
    const Vector3 V = (A + B).normalized();
    if (!safely_positive(V, C, A) || !safely_positive(V, B, C) || !safely_positive(V, D, B) ||
        !safely_positive(V, A, D))
      return false;
    directions_.push_back(V);
    split_edge(h, static_cast<Index>(directions_.size() - 1));
    make_delaunay();
    return true;
  }

  // Flips the edge of a half-edge if it is free and the two triangles are convex together, with room for rounding:
  // three vertices on what was one edge must not become a triangle. Its half-edges are then those between the corners
  // that were opposite of it.
  bool flip(Index h) {
    if (edges_[h].fixed) return false;
    const Index g = opposite_[h];
    const Index a = start(h), b = end(h), c = apex(h), d = apex(g);
    const Vector3 &A = directions_[a], &B = directions_[b], &C = directions_[c], &D = directions_[d];
    if (!safely_positive(A, D, C) || !safely_positive(D, B, C)) return false;
    const Index t = h / 3, s = g / 3;
    const Outer bc = outer(next(h)), ca = outer(previous(h)), ad = outer(next(g)), db = outer(previous(g));
    set(t, {a, d, c});
    set(s, {d, b, c});
    attach(3 * t, ad);
    join(3 * t + 1, 3 * s + 2);
    attach(3 * t + 2, ca);
    attach(3 * s, db);
    attach(3 * s + 1, bc);
    return true;
  }

  std::size_t vertex_count() const { return directions_.size(); }
  const Vector3& direction(Index vertex) const { return directions_[vertex]; }
  // What is remembered of an edge for as long as it is there; not a number at first.
  float error(Index h) const { return edges_[h].error; }
  void set_error(Index h, float error) { edges_[h].error = edges_[opposite_[h]].error = error; }
  std::size_t half_edge_count() const { return opposite_.size(); }
  bool is_fixed(Index h) const { return edges_[h].fixed; }
  Index opposite(Index h) const { return opposite_[h]; }
  Index start(Index h) const { return triangles_[h / 3][h % 3]; }
  Index end(Index h) const { return triangles_[h / 3][(h % 3 + 1) % 3]; }
  Index apex(Index h) const { return triangles_[h / 3][(h % 3 + 2) % 3]; }

  void take(Overlay& result) {
    result.directions = std::move(directions_);
    result.triangles = std::move(triangles_);
  }

 private:
  static constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
  // Of an edge, kept for both of its half-edges.
  struct EdgeFacts {
    bool fixed;
    float error;
  };
  // What is on the other side of an edge that stays while its triangle is replaced.
  struct Outer {
    Index opposite;
    EdgeFacts facts;
  };

  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Outer outer(Index h) const { return {opposite_[h], edges_[h]}; }
  void set(Index t, const Triangle& corners) { triangles_[t] = corners; }
  Index add() {
    triangles_.push_back({0, 0, 0});
    opposite_.insert(opposite_.end(), 3, mesh::no_index);
    edges_.insert(edges_.end(), 3, EdgeFacts{false, unknown});
    return static_cast<Index>(triangles_.size() - 1);
  }
  void attach(Index h, const Outer& other) {
    opposite_[h] = other.opposite;
    opposite_[other.opposite] = h;
    edges_[h] = other.facts;
  }
  void join(Index h, Index g, bool fixed = false) {
    opposite_[h] = g;
    opposite_[g] = h;
    edges_[h] = edges_[g] = {fixed, unknown};
  }

  void split_triangle(Index t, Index v) {
    const auto [a, b, c] = triangles_[t];
    const Outer ab = outer(3 * t), bc = outer(3 * t + 1), ca = outer(3 * t + 2);
    const Index s = add(), r = add();
    set(t, {a, b, v});
    set(s, {b, c, v});
    set(r, {c, a, v});
    attach(3 * t, ab);
    attach(3 * s, bc);
    attach(3 * r, ca);
    join(3 * t + 1, 3 * s + 2);
    join(3 * s + 1, 3 * r + 2);
    join(3 * r + 1, 3 * t + 2);
    pending_ = {3 * t, 3 * s, 3 * r};
  }

  // The vertex lies on the edge of h, from a to b, between the corners c and d.
  void split_edge(Index h, Index v) {
    const Index g = opposite_[h];
    const Index a = start(h), b = end(h), c = apex(h), d = apex(g);
    const Outer bc = outer(next(h)), ca = outer(previous(h)), ad = outer(next(g)), db = outer(previous(g));
    const bool fixed = edges_[h].fixed;
    const Index t = h / 3, s = g / 3, p = add(), q = add();
    set(t, {v, c, a});
    set(p, {v, b, c});
    set(s, {v, d, b});
    set(q, {v, a, d});
    attach(3 * t + 1, ca);
    attach(3 * p + 1, bc);
    attach(3 * s + 1, db);
    attach(3 * q + 1, ad);
    join(3 * t, 3 * p + 2);
    join(3 * s, 3 * q + 2);
    join(3 * p, 3 * s + 2, fixed);
    join(3 * q, 3 * t + 2, fixed);
    pending_ = {3 * t + 1, 3 * p + 1, 3 * s + 1, 3 * q + 1};
  }

  // Flips free edges with a vertex beyond them above the plane of the triangle. Each flip adds to the volume below, so
  // that there is an end to it.
  void make_delaunay() {
    while (!pending_.empty()) {
      const Index h = pending_.back();
      pending_.pop_back();
      if (edges_[h].fixed) continue;
      const Index g = opposite_[h];
      if (mesh::orientation_3d(directions_[start(h)], directions_[end(h)], directions_[apex(h)],
                               directions_[apex(g)]) <= 0 ||
          !flip(h))
        continue;
      const Index t = h / 3, s = g / 3;
      for (const Index outside : {3 * t, 3 * t + 2, 3 * s, 3 * s + 1})
        pending_.push_back(outside);
    }
  }

  Array<Vector3> directions_;
  Array<Triangle> triangles_;
  Array<Index> opposite_;
  Array<EdgeFacts> edges_;
  Array<Index> pending_;
};

// Edges as sorted pairs of vertices.
class EdgeSet {
 public:
  explicit EdgeSet(std::pmr::memory_resource* memory) : edges_(memory) {}
  void add(Index a, Index b) { edges_.push_back(key(a, b)); }
  void finish() {
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  }
  bool has(Index a, Index b) const { return std::binary_search(edges_.begin(), edges_.end(), key(a, b)); }
  std::size_t size() const { return edges_.size(); }

 private:
  static std::uint64_t key(Index a, Index b) { return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b); }
  Array<std::uint64_t> edges_;
};

EdgeSet edges_of(std::span<const PlacedMap> others, const Array<Array<Index>>& vertex_of, const base::Host& host) {
  EdgeSet edges(host.memory);
  for (std::size_t i = 0; i < others.size(); ++i) {
    for (const Triangle& t : others[i].triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = vertex_of[i][t[k]], b = vertex_of[i][t[(k + 1) % 3]];
        if (a != b) edges.add(a, b);
      }
    }
  }
  edges.finish();
  return edges;
}

// Each flip gains an edge of the others and loses none, so that there is an end to it.
void flip_towards(Triangulation& triangulation, const EdgeSet& edges, const base::Host& host) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Index h = 0; h < triangulation.half_edge_count(); ++h) {
      if (h % 16384 == 0) host.report("edges of the other maps", h, triangulation.half_edge_count());
      if (triangulation.is_fixed(h) || edges.has(triangulation.start(h), triangulation.end(h)) ||
          !edges.has(triangulation.apex(h), triangulation.apex(triangulation.opposite(h))))
        continue;
      changed |= triangulation.flip(h);
    }
  }
}

// Halves edges, those that miss most first: the limit falls to 1 by quarters. An edge that cannot be halved stays.
void refine(Triangulation& triangulation, const Refinement& refinement, const base::Host& host) {
  constexpr double shortest = 1e-7;  // of edges that are halved: directions are exact to 1e-16
  for (const double limit : {64.0, 16.0, 4.0, 1.0}) {
    for (bool changed = true; changed;) {
      changed = false;
      const std::size_t count = triangulation.half_edge_count();  // new ones wait for the next pass
      for (Index h = 0; h < count; ++h) {
        if (h % 1024 == 0) host.report("refining the common mesh", h, count);
        if (triangulation.vertex_count() >= refinement.max_vertices) return;
        if (std::isnan(triangulation.error(h))) {
          const Vector3& a = triangulation.direction(triangulation.start(h));
          const Vector3& b = triangulation.direction(triangulation.end(h));
          const bool short_edge = (a - b).squaredNorm() < shortest * shortest;
          triangulation.set_error(h, short_edge ? 0 : static_cast<float>(refinement.error(a, b)));
        }
        if (!(triangulation.error(h) > limit)) continue;
        if (triangulation.halve(h)) {
          changed = true;
        } else {
          triangulation.set_error(h, 0);
        }
      }
    }
  }
}

}  // namespace

Overlay overlay(const PlacedMap& first, std::span<const PlacedMap> others, const base::Host& host,
                const Refinement* refinement) {
  Overlay result(host.memory);
  const Locator locator(first.triangles, first.directions, host);
  if (!locator.positive()) throw base::Error("invalid-argument", "the first map is mirrored");
  Triangulation triangulation(first, mesh::Connectivity(first.directions.size(), first.triangles, host), host);
  for (const PlacedMap& map : others) {
    Array<Index>& places = result.vertex_of.emplace_back(Array<Index>(host.memory));
    places.assign(map.directions.size(), mesh::no_index);
    // Triangle by triangle: neighbors come soon after each other.
    for (std::size_t t = 0; t < map.triangles.size(); ++t) {
      if (t % 1024 == 0) host.report("inserting vertices", t, map.triangles.size());
      for (const Index v : map.triangles[t]) {
        if (v >= places.size())
          throw base::Error("invalid-argument", "triangle " + std::to_string(t) + " has a vertex that does not exist");
        if (places[v] != mesh::no_index) continue;
        require_direction(map.directions[v], "the direction of vertex", v);
        places[v] = triangulation.insert(map.directions[v], locator.locate(map.directions[v]).triangle);
      }
    }
  }
  const EdgeSet edges = edges_of(others, result.vertex_of, host);
  flip_towards(triangulation, edges, host);
  if (refinement != nullptr) {
    refine(triangulation, *refinement, host);
    flip_towards(triangulation, edges, host);
  }
  result.edges_of_others = edges.size();
  for (Index h = 0; h < triangulation.half_edge_count(); ++h) {
    const Index a = triangulation.start(h), b = triangulation.end(h);
    result.edges_present += a < b && edges.has(a, b);
  }
  triangulation.take(result);
  return result;
}

}  // namespace orbicube::sphere_map
