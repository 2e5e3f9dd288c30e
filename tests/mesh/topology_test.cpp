// Topology of small surfaces whose figures are known.
#include "mesh/topology.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/orient.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

struct Surface {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
};

Topology topology_of(const Surface& s) {
  return topology(s.positions, s.triangles, base::Host());
}

std::string refusal(const Surface& s) {
  try {
    require_closed_genus_zero(topology_of(s));
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

Surface tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Surface octahedron() {
  return {{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// A grid of m x n squares closed to a torus, or with a half turn in one direction to a Klein bottle.
Surface torus(Index m, Index n, bool half_turn) {
  Surface s;
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double a = 2 * M_PI * i / m;
      const double b = 2 * M_PI * j / n;
      s.positions.emplace_back((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b));
    }
  }
  const auto at = [&](Index i, Index j) {
    if (half_turn && i == m) j = (n - j) % n;
    return (i % m) * n + j % n;
  };
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

// Both surfaces as one, the vertices of the second moved by `shift`.
Surface both(Surface a, const Surface& b, const Vector3& shift) {
  const auto first = static_cast<Index>(a.positions.size());
  for (const Vector3& p : b.positions)
    a.positions.push_back(p + shift);
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

}  // namespace

TEST_CASE("Counts, area and volume of an octahedron") {
  const Topology t = topology_of(octahedron());
  CHECK(t.vertices == 6);
  CHECK(t.edges == 12);
  CHECK(t.euler_characteristic == 2);
  CHECK(t.genus == 0);
  CHECK(t.components == 1);
  CHECK(t.closed());
  CHECK(t.manifold());
  CHECK(t.volume == doctest::Approx(4.0 / 3));
  CHECK(t.area == doctest::Approx(4 * std::sqrt(3.0)));
  CHECK(refusal(octahedron()) == "");
}

TEST_CASE("A torus has genus 1 and a Klein bottle is not orientable") {
  const Topology t = topology_of(torus(9, 7, false));
  CHECK(t.genus == 1);
  CHECK(t.orientable);
  CHECK(refusal(torus(9, 7, false)) == "wrong-genus");
  const Topology k = topology_of(torus(9, 7, true));
  CHECK(k.euler_characteristic == 0);
  CHECK_FALSE(k.orientable);
  CHECK_FALSE(k.genus.has_value());
  CHECK(refusal(torus(9, 7, true)) == "non-orientable");
}

TEST_CASE("Holes are counted with their lengths") {
  Surface s = torus(9, 8, false);
  // A hole of one square and one of a triangle, apart from each other.
  s.triangles.erase(s.triangles.begin() + 61);
  s.triangles.erase(s.triangles.begin(), s.triangles.begin() + 2);
  const Topology t = topology_of(s);
  CHECK(t.boundary_loops == 2);
  CHECK(t.boundary_edges == 7);
  CHECK(t.longest_boundary_loop == 4);
  CHECK(refusal(s) == "not-closed");
}

TEST_CASE("Parts that share nothing, a vertex or an edge") {
  const Surface apart = both(tetrahedron(), octahedron(), Vector3(9, 0, 0));
  CHECK(topology_of(apart).components == 2);
  CHECK(refusal(apart) == "not-connected");

  Surface bowtie = both(tetrahedron(), tetrahedron(), Vector3(9, 0, 0));
  for (Triangle& t : bowtie.triangles) {
    for (Index& v : t)
      v = v == 4 ? 0 : v;
  }
  CHECK(topology_of(bowtie).non_manifold_vertices == 1);
  CHECK(topology_of(bowtie).first_non_manifold_vertex == 0);
  CHECK(topology_of(bowtie).unreferenced_vertices == 1);
  CHECK(refusal(bowtie) == "non-manifold-vertex");

  Surface hinge = bowtie;
  for (Triangle& t : hinge.triangles) {
    for (Index& v : t)
      v = v == 5 ? 1 : v;
  }
  CHECK(topology_of(hinge).non_manifold_edges == 1);
  CHECK(refusal(hinge) == "non-manifold-edge");
}

TEST_CASE("Faces that are repeated, degenerate or flat") {
  Surface s = octahedron();
  s.triangles.push_back({4, 0, 2});
  CHECK(topology_of(s).duplicate_faces == 1);
  CHECK(refusal(s) == "duplicate-face");
  s = octahedron();
  s.triangles.push_back({4, 0, 4});
  CHECK(topology_of(s).degenerate_faces == 1);
  CHECK(topology_of(s).first_degenerate_face == 8);
  CHECK(refusal(s) == "degenerate-face");
  s = tetrahedron();
  s.positions[3] = 0.25 * s.positions[1];  // on the edge from vertex 0 to vertex 1, exactly
  CHECK(topology_of(s).zero_area_faces == 1);
  s.positions.assign(4, Vector3(1, 2, 3));
  CHECK(refusal(s) == "degenerate-geometry");
  s.triangles.clear();
  CHECK(refusal(s) == "empty-mesh");
}

TEST_CASE("Turned triangles are seen, counted and turned back, whichever they are") {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Surface s = octahedron();
    std::size_t turned = 0;
    for (Triangle& t : s.triangles) {
      if (random() % 2 == 0) continue;
      std::swap(t[0], t[1]);
      ++turned;
    }
    const bool mixed = turned != 0 && turned != 8;
    CHECK((topology_of(s).inconsistent_edges > 0) == mixed);
    CHECK(refusal(s) == (mixed ? "inconsistent-orientation" : ""));
    const OrientReport report = orient(s.positions, s.triangles, base::Host());
    CHECK(report.triangles_turned == std::min(turned, 8 - turned));
    CHECK(report.turned_outward == (turned > 4 || (turned == 4 && report.turned_outward)));
    CHECK(refusal(s) == "");
    CHECK(topology_of(s).volume == doctest::Approx(4.0 / 3));
  }
}

TEST_CASE("Figures do not depend on the order of vertices, nor on where a surface is and how large") {
  std::mt19937 random(5);
  const Surface original = torus(12, 9, false);
  const Topology expected = topology_of(original);
  std::vector<Index> place(original.positions.size());
  for (Index i = 0; i < place.size(); ++i)
    place[i] = i;
  std::shuffle(place.begin(), place.end(), random);
  Surface shuffled = original;
  const Vector3 shift(1e6, -3e6, 2e6);
  for (Index i = 0; i < place.size(); ++i)
    shuffled.positions[place[i]] = 4 * original.positions[i] + shift;
  for (Triangle& t : shuffled.triangles)
    t = {place[t[1]], place[t[2]], place[t[0]]};
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  const Topology found = topology_of(shuffled);
  CHECK(found.edges == expected.edges);
  CHECK(found.genus == expected.genus);
  CHECK(found.area == doctest::Approx(16 * expected.area).epsilon(1e-8));
  CHECK(found.volume == doctest::Approx(64 * expected.volume).epsilon(1e-8));
}

TEST_CASE("Indices out of range and positions that are not finite are refused") {
  Surface s = octahedron();
  s.triangles[3][1] = 6;
  CHECK(refusal(s) == "invalid-argument");
  s = octahedron();
  s.positions[2].y() = std::nan("");
  CHECK(refusal(s) == "invalid-argument");
}
