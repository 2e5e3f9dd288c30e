// Half-edges and walks round vertices of closed and open surfaces.
#include "mesh/topology/connectivity.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

// A grid of m x n squares, each cut in two; `closed` joins opposite sides to a torus.
std::vector<Triangle> grid_of_squares(Index m, Index n, bool closed) {
  const Index rows = closed ? m : m + 1, columns = closed ? n : n + 1;
  const auto at = [&](Index i, Index j) { return i % rows * columns + j % columns; };
  std::vector<Triangle> triangles;
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return triangles;
}

std::string refusal(std::size_t vertices, const std::vector<Triangle>& triangles) {
  try {
    Connectivity(vertices, triangles, base::Host());
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

}  // namespace

TEST_CASE(
    "Opposite half-edges join the same vertices the other way, and walks see every triangle of a vertex in turn") {
  for (const bool closed : {true, false}) {
    const auto triangles = grid_of_squares(5, 4, closed);
    const std::size_t vertices = closed ? 20 : 30;
    const Connectivity c(vertices + 1, triangles, base::Host());
    std::size_t boundary = 0;
    for (Index h = 0; h < 3 * triangles.size(); ++h) {
      CHECK(c.next(c.previous(h)) == h);
      CHECK(c.end(h) == c.start(c.next(h)));
      const Index g = c.opposite(h);
      boundary += g == no_index;
      if (g == no_index) continue;
      CHECK(c.opposite(g) == h);
      CHECK(c.start(g) == c.end(h));
      CHECK(c.end(g) == c.start(h));
    }
    CHECK(boundary == (closed ? 0 : 18));
    std::size_t corners = 0;
    for (Index v = 0; v < vertices; ++v) {
      std::set<Index> expected;
      for (const Triangle& t : triangles) {
        if (std::count(t.begin(), t.end(), v) > 0) expected.insert(t.begin(), t.end());
      }
      expected.erase(v);
      std::vector<Index> ring;
      c.for_each_neighbor(v, [&](Index w) { ring.push_back(w); });
      CHECK(std::set<Index>(ring.begin(), ring.end()) == expected);
      CHECK(ring.size() == expected.size());
      std::size_t outgoing = 0;
      c.for_each_outgoing(v, [&](Index h) {
        CHECK(c.start(h) == v);
        // Counter-clockwise: each triangle has the vertex and two neighbors that follow each other.
        CHECK(c.end(h) == ring[outgoing]);
        CHECK(c.start(c.previous(h)) == ring[(outgoing + 1) % ring.size()]);
        ++outgoing;
      });
      CHECK(c.on_boundary(v) == (outgoing + 1 == ring.size()));
      corners += outgoing;
    }
    CHECK(corners == 3 * triangles.size());
    CHECK(c.outgoing(static_cast<Index>(vertices)) == no_index);
    c.for_each_neighbor(static_cast<Index>(vertices), [](Index) { FAIL("a vertex in no triangle has no neighbors"); });
  }
}

TEST_CASE("What is no oriented manifold is refused with its kind") {
  CHECK(refusal(5, {{0, 1, 2}, {1, 0, 3}}) == "");
  CHECK(refusal(5, {{0, 1, 1}}) == "degenerate-face");
  CHECK(refusal(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}) == "non-manifold-edge");
  CHECK(refusal(5, {{0, 1, 2}, {0, 1, 3}}) == "inconsistent-orientation");
  CHECK(refusal(5, {{0, 1, 2}, {0, 3, 4}}) == "non-manifold-vertex");
}
