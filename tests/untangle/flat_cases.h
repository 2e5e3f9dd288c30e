// Flat meshes with flipped triangles for tests and bench: squares whose vertices are strewn, strips that are bent until
// they nearly meet, and maps of bumpy surfaces.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "untangle/triangles/untangle_triangles.h"

namespace orbicube::untangle::test {

struct FlatCase {
  std::string name;
  std::vector<Triangle> triangles;
  std::vector<Vector2d> start;
  std::vector<Vector3> rest;
  std::vector<std::uint8_t> fixed;  // an entry a coordinate
  std::vector<Index> ties;

  TriangleProblem mesh() const {
    return {.triangles = triangles, .start = start, .rest = rest, .fixed = fixed, .ties = ties};
  }
  bool is_fixed(std::size_t vertex) const { return fixed[2 * vertex] != 0; }
};

// A grid of `columns` by `rows` squares of edge 1, each cut in two along alternating diagonals; its boundary is fixed.
inline FlatCase grid(int columns, int rows) {
  FlatCase c;
  const auto at = [&](int x, int y) { return static_cast<Index>(y * (columns + 1) + x); };
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      c.start.emplace_back(x, y);
      c.rest.emplace_back(x, y, 0);
      c.fixed.insert(c.fixed.end(), 2, x == 0 || y == 0 || x == columns || y == rows);
      if (x == columns || y == rows) continue;
      const Index p = at(x, y), q = at(x + 1, y), r = at(x + 1, y + 1), s = at(x, y + 1);
      if ((x + y) % 2 == 0)
        c.triangles.insert(c.triangles.end(), {{p, q, r}, {p, r, s}});
      else
        c.triangles.insert(c.triangles.end(), {{p, q, s}, {q, r, s}});
    }
  }
  return c;
}

// Inner vertices move to random places of the box around the boundary.
inline void strew(FlatCase& c, std::uint64_t seed) {
  base::Random random(seed);
  Vector2d low = c.start[0], high = low;
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    if (!c.is_fixed(v)) continue;
    low = low.cwiseMin(c.start[v]);
    high = high.cwiseMax(c.start[v]);
  }
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    for (int a = 0; a < 2 && !c.is_fixed(v); ++a)
      c.start[v][a] = low[a] + random.unit() * (high[a] - low[a]);
  }
}

inline FlatCase strewn(int edge, std::uint64_t seed) {
  FlatCase c = grid(edge, edge);
  c.name = "strewn";
  strew(c, seed);
  return c;
}

// A strip whose fixed boundary is bent by `angle` about a point `gap` rows beyond its inner side; the inner vertices
// are strewn. For an angle below 2 pi the bent grid is positive, so that there is a solution.
inline FlatCase bent(int columns, int rows, double angle, double gap, std::uint64_t seed) {
  FlatCase c = grid(columns, rows);
  c.name = "bent";
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    const double turn = -angle * c.start[v].x() / columns, radius = gap + c.start[v].y();
    c.start[v] = radius * Vector2d(std::cos(turn), std::sin(turn));
  }
  strew(c, seed);
  return c;
}

// A map to a square of a surface with a bump of that height, whose inner vertices are strewn.
inline FlatCase bump(int edge, double height, std::uint64_t seed) {
  FlatCase c = strewn(edge, seed);
  c.name = "bump";
  for (Vector3& p : c.rest) {
    const double x = std::numbers::pi * p.x() / edge, y = std::numbers::pi * p.y() / edge;
    p.z() = height * edge * std::pow(std::sin(x) * std::sin(y), 4);
  }
  return c;
}

// A square whose vertices are all turned about its middle, the more the nearer they are: up to `angle` there.
inline FlatCase swirled(int edge, double angle) {
  FlatCase c = grid(edge, edge);
  c.name = "swirled";
  const Vector2d middle(0.5 * edge, 0.5 * edge);
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    if (c.is_fixed(v)) continue;
    const Vector2d p = c.start[v] - middle;
    const double turn = angle * (1 - 2 * p.cwiseAbs().maxCoeff() / edge);
    c.start[v] = middle + Vector2d(std::cos(turn) * p.x() - std::sin(turn) * p.y(),
                                   std::sin(turn) * p.x() + std::cos(turn) * p.y());
  }
  return c;
}

}  // namespace orbicube::untangle::test
