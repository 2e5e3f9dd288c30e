// Intersections of triangles against the separating axis theorem in integers, and of surfaces that are made to meet.
#include "mesh/search/intersections.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

using Integers = std::array<std::int64_t, 3>;

Integers operator-(const Integers& a, const Integers& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
std::int64_t dot(const Integers& a, const Integers& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Integers cross(const Integers& a, const Integers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Two triangles are apart if and only if they are so along a normal, a product of two edges, or, in parallel planes, a
// product of a normal and an edge.
bool meet(const std::array<Integers, 3>& p, const std::array<Integers, 3>& q) {
  std::vector<Integers> axes;
  std::array<Integers, 6> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = p[(k + 1) % 3] - p[k];
    edges[k + 3] = q[(k + 1) % 3] - q[k];
  }
  const Integers p_normal = cross(edges[0], edges[1]), q_normal = cross(edges[3], edges[4]);
  axes = {p_normal, q_normal};
  for (std::size_t i = 0; i < 6; ++i) {
    axes.push_back(cross(p_normal, edges[i]));
    axes.push_back(cross(q_normal, edges[i]));
    for (std::size_t j = 3; i < 3 && j < 6; ++j)
      axes.push_back(cross(edges[i], edges[j]));
  }
  return std::none_of(axes.begin(), axes.end(), [&](const Integers& axis) {
    const auto range = [&](const std::array<Integers, 3>& t) {
      return std::minmax({dot(axis, t[0]), dot(axis, t[1]), dot(axis, t[2])});
    };
    const auto [p_low, p_high] = range(p);
    const auto [q_low, q_high] = range(q);
    return p_high < q_low || q_high < p_low;
  });
}

// A sphere of latitudes and longitudes with its vertices moved by `shift`, appended to the arrays.
void add_sphere(std::vector<Vector3>& positions, std::vector<Triangle>& triangles, const Vector3& shift) {
  const auto first = static_cast<Index>(positions.size());
  constexpr Index rings = 7, sectors = 12;
  for (Index i = 0; i < rings; ++i) {
    for (Index j = 0; j < sectors; ++j) {
      const double latitude = M_PI * (i + 1) / (rings + 1), longitude = 2 * M_PI * j / sectors;
      positions.push_back(shift + Vector3(std::sin(latitude) * std::cos(longitude),
                                          std::sin(latitude) * std::sin(longitude), std::cos(latitude)));
    }
  }
  const auto top = static_cast<Index>(positions.size());
  positions.push_back(shift + Vector3(0, 0, 1));
  positions.push_back(shift + Vector3(0, 0, -1));
  const auto at = [&](Index i, Index j) { return first + i * sectors + j % sectors; };
  for (Index j = 0; j < sectors; ++j) {
    triangles.push_back({top, at(0, j), at(0, j + 1)});
    triangles.push_back({top + 1, at(rings - 1, j + 1), at(rings - 1, j)});
    for (Index i = 0; i + 1 < rings; ++i) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

}  // namespace

TEST_CASE("Triangles on a coarse grid meet as the separating axis theorem says, in any order of their corners") {
  std::mt19937_64 engine(41);
  std::size_t meeting = 0, tried = 0;
  while (tried < 20000) {
    std::array<std::array<Integers, 3>, 2> t;
    std::vector<Vector3> positions;
    const std::uint64_t size = 3 + tried % 3;
    for (auto& triangle : t) {
      for (Integers& corner : triangle) {
        for (std::int64_t& x : corner)
          x = static_cast<std::int64_t>(engine() % size);
        positions.emplace_back(static_cast<double>(corner[0]), static_cast<double>(corner[1]),
                               static_cast<double>(corner[2]));
      }
    }
    const auto flat = [](const std::array<Integers, 3>& c) { return cross(c[1] - c[0], c[2] - c[0]) == Integers{}; };
    if (flat(t[0]) || flat(t[1])) continue;
    ++tried;
    const bool expected = meet(t[0], t[1]);
    meeting += expected;
    REQUIRE(triangles_intersect(positions, {0, 1, 2}, {3, 4, 5}) == expected);
    REQUIRE(triangles_intersect(positions, {4, 3, 5}, {2, 0, 1}) == expected);
  }
  CHECK(meeting > 4000);
  CHECK(meeting < 16000);
}

TEST_CASE("Triangles that share a vertex or an edge meet only where they have more in common") {
  const std::vector<Vector3> x = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0},  {0, 0, 4},  {1, 1, 0},
                                  {1, 1, 1}, {2, 2, 2}, {2, 2, -2}, {-4, 0, 0}, {0, -4, 0}};
  CHECK_FALSE(triangles_intersect(x, {0, 1, 2}, {0, 1, 3}));  // an edge
  CHECK_FALSE(triangles_intersect(x, {0, 1, 2}, {1, 0, 9}));  // in one plane, on both sides of it
  CHECK(triangles_intersect(x, {0, 1, 2}, {0, 1, 4}));        // in one plane, on the same side
  CHECK(triangles_intersect(x, {0, 1, 2}, {2, 0, 1}));        // the same
  CHECK_FALSE(triangles_intersect(x, {0, 1, 2}, {0, 8, 9}));  // a vertex, in one plane
  CHECK_FALSE(triangles_intersect(x, {0, 1, 2}, {0, 5, 6}));  // a vertex and nothing else
  CHECK_FALSE(triangles_intersect(x, {0, 1, 2}, {0, 8, 6}));
  CHECK(triangles_intersect(x, {0, 1, 2}, {0, 6, 7}));  // a vertex, and through it up to the opposite edge
  CHECK(triangles_intersect(x, {0, 1, 2}, {0, 4, 6}));  // along a segment from the vertex on
}

TEST_CASE("A sphere does not meet itself; two spheres meet as testing all pairs says, whatever the threads") {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
  add_sphere(positions, triangles, Vector3::Zero());
  CHECK(intersecting_triangles(positions, triangles, base::Host()).empty());
  add_sphere(positions, triangles, Vector3(0.7, 0.3, 0.2));
  std::vector<std::array<Index, 2>> expected;
  for (Index i = 0; i < triangles.size(); ++i) {
    for (Index j = i + 1; j < triangles.size(); ++j) {
      if (triangles_intersect(positions, triangles[i], triangles[j])) expected.push_back({i, j});
    }
  }
  CHECK(expected.size() > 30);
  for (const unsigned threads : {1U, 4U}) {
    base::Host host;
    host.thread_count = threads;
    const auto found = intersecting_triangles(positions, triangles, host);
    CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
    const auto some = intersecting_triangles(positions, triangles, host, 5);
    CHECK(std::equal(some.begin(), some.end(), expected.begin(), expected.begin() + 5));
  }
  // The same place twice: every triangle meets its copy.
  std::vector<Vector3> copies = positions;
  copies.resize(positions.size() / 2);
  std::vector<Triangle> twice(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2));
  const std::size_t half = twice.size();
  for (std::size_t t = 0; t < half; ++t)
    twice.push_back({twice[t][0], twice[t][1], twice[t][2]});
  CHECK(intersecting_triangles(copies, twice, base::Host()).size() >= half);
}

TEST_CASE("Quads intersect when a half by either diagonal does, beyond the vertices that they share") {
  using Quad = std::array<Index, 4>;
  // A unit square in z = 0, one beside it, one folded onto it, and others.
  std::vector<Vector3> x = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},    {0, 1, 0},
                            {2, 0, 0}, {2, 1, 0}, {0.25, 0, 0}, {0.25, 1, 0}};
  const Quad square = {0, 1, 2, 3};
  CHECK_FALSE(quads_intersect(x, square, {1, 4, 5, 2}));
  CHECK(quads_intersect(x, square, {1, 6, 7, 2}));  // neighbors that lie over each other in one plane
  CHECK(quads_intersect(x, square, {2, 1, 0, 3}));  // three vertices in common
  // Vertical beside the edge: apart, touching it, and through the square.
  for (const double height : {0.01, 0.0, -0.01}) {
    x.resize(8);
    x.insert(x.end(), {{0.5, -1, height}, {0.5, 2, height}, {0.5, 2, height + 1}, {0.5, -1, height + 1}});
    CHECK(quads_intersect(x, square, {8, 9, 10, 11}) == (height <= 0));
    CHECK(quads_intersect(x, {11, 10, 9, 8}, {3, 2, 1, 0}) == (height <= 0));
  }
  // A bent quad is on both sides of its bilinear patch: what is between its halves meets one of them.
  x = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}, {0.4, 0.5, 0.4}, {0.6, 0.5, 0.4}, {0.6, 0.5, 2}, {0.4, 0.5, 2}};
  CHECK(quads_intersect(x, {0, 1, 2, 3}, {4, 5, 6, 7}));
  // Between the halves by one diagonal, which are below, and those by the other: the rest of a closed surface that goes
  // on from there has to come out through one of them.
  x = {{0, 0, 0},        {1, 0, 1},        {1, 1, 0},        {0, 1, 1},
       {0.45, 0.2, 0.5}, {0.55, 0.2, 0.5}, {0.55, 0.8, 0.5}, {0.45, 0.8, 0.5}};
  CHECK_FALSE(quads_intersect(x, {0, 1, 2, 3}, {4, 5, 6, 7}));
}

TEST_CASE("Pairs of intersecting quads are found as by all pairs, folded quads too, whatever the threads") {
  using Quad = std::array<Index, 4>;
  // Two sheets of squares, one through the other at a slant, and the first with a quad that folds over itself.
  std::vector<Vector3> x;
  std::vector<Quad> quads;
  constexpr Index n = 12;
  for (const double slope : {0.0, 0.3}) {
    const auto first = static_cast<Index>(x.size());
    for (Index i = 0; i <= n; ++i) {
      for (Index k = 0; k <= n; ++k)
        x.emplace_back(i, k, slope * (i - 5.37));
    }
    for (Index i = 0; i < n; ++i) {
      for (Index k = 0; k < n; ++k) {
        const Index at = first + i * (n + 1) + k;
        quads.push_back({at, at + n + 1, at + n + 2, at + 1});
      }
    }
  }
  CHECK(intersecting_quads(x, std::span(quads).first(n * n), base::Host()).empty());
  std::vector<std::array<Index, 2>> expected;
  for (Index i = 0; i < quads.size(); ++i) {
    for (Index k = i + 1; k < quads.size(); ++k) {
      if (quads_intersect(x, quads[i], quads[k])) expected.push_back({i, k});
    }
  }
  CHECK(expected.size() >= n);
  for (const unsigned threads : {1U, 4U}) {
    base::Host host;
    host.thread_count = threads;
    const auto found = intersecting_quads(x, quads, host);
    CHECK(std::equal(found.begin(), found.end(), expected.begin(), expected.end()));
  }
  x = {{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}};
  CHECK(intersecting_quads(x, std::vector<Quad>{{0, 1, 2, 3}}, base::Host()).size() == 1);
  x[2] = {2, 2, 0};
  CHECK(intersecting_quads(x, std::vector<Quad>{{0, 1, 2, 3}}, base::Host()).empty());
}
