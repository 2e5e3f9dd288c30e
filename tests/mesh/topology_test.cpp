// Topology of small surfaces whose figures are known.
#include "mesh/topology/topology.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/features/handle_place.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/place_text.h"

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
  CHECK(topology_of(apart).first_vertex_apart == 4);
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
  CHECK(topology_of(s).first_zero_area_face == 1);
  CHECK(topology_of(s).coincident_vertices == 0);
  CHECK(refusal(s) == "");
  s.positions.push_back(s.positions[0]);  // in no triangle
  CHECK(topology_of(s).coincident_vertices == 0);
  s.positions[3] = s.positions[1];
  CHECK(topology_of(s).coincident_vertices == 1);
  CHECK(topology_of(s).first_coincident_vertices == std::array<Index, 2>{1, 3});
  CHECK(topology_of(s).zero_area_faces == 2);
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
    CHECK(report.reversed_triangles == std::min(turned, 8 - turned));
    CHECK(report.inward_oriented == (turned > 4 || (turned == 4 && report.inward_oriented)));
    CHECK(refusal(s) == "");
    CHECK(topology_of(s).volume == doctest::Approx(4.0 / 3));
  }
}

TEST_CASE("What was done to orient a surface is said in sentences, of one triangle in the singular") {
  Surface s = octahedron();
  CHECK(orient(s.positions, s.triangles, base::Host()).notes().empty());
  std::swap(s.triangles[3][0], s.triangles[3][1]);
  using Notes = std::vector<std::string>;
  CHECK(orient(s.positions, s.triangles, base::Host()).notes() ==
        Notes{"1 triangle was reversed to agree with its neighbors"});
  for (const std::size_t kept : std::array<std::size_t, 2>{0, 1}) {
    s = octahedron();
    for (std::size_t t = kept; t < s.triangles.size(); ++t)
      std::swap(s.triangles[t][0], s.triangles[t][1]);
    const Notes notes = orient(s.positions, s.triangles, base::Host()).notes();
    CHECK(notes.size() == 1 + kept);
    CHECK(notes.back() == "the surface was inward-oriented; all triangles were reversed");
  }
}

TEST_CASE("A surface with a cavity keeps its inner wall, and is turned as a whole when it is inward-oriented") {
  Surface inner = octahedron();
  for (Triangle& t : inner.triangles)
    std::swap(t[0], t[1]);
  Surface outer = octahedron();
  for (Vector3& p : outer.positions)
    p *= 3;
  const Surface hollow = both(outer, inner, Vector3::Zero());
  Surface s = hollow;
  OrientReport report = orient(s.positions, s.triangles, base::Host());
  CHECK(report.reversed_triangles == 0);
  CHECK_FALSE(report.inward_oriented);
  for (Triangle& t : s.triangles)
    std::swap(t[0], t[1]);
  report = orient(s.positions, s.triangles, base::Host());
  CHECK(report.inward_oriented);
  CHECK(topology_of(s).volume == doctest::Approx(4.0 / 3 * (27 - 1)));

  Surface open = inner;
  open.triangles.pop_back();
  CHECK_FALSE(orient(open.positions, open.triangles, base::Host()).inward_oriented);
  Surface one_sided = torus(5, 5, true);
  CHECK_THROWS_AS(orient(one_sided.positions, one_sided.triangles, base::Host()), base::Error);
}

TEST_CASE("Any set of triangles on few vertices has the figures that their definitions give") {
  std::mt19937 random(11);
  for (int trial = 0; trial < 3000; ++trial) {
    Surface s;
    const Index n = 4 + static_cast<Index>(random() % 4);
    for (Index v = 0; v < n; ++v)
      s.positions.emplace_back(v, v * v, v * v * v);
    const std::size_t faces = 1 + random() % 9;
    for (std::size_t t = 0; t < faces; ++t) {
      const auto any = [&] { return static_cast<Index>(random() % n); };
      s.triangles.push_back({any(), any(), any()});
    }
    const Topology found = topology_of(s);

    std::vector<Triangle> proper;
    std::map<std::set<Index>, std::vector<std::size_t>> faces_of_edge;  // numbers in `proper`
    std::map<std::set<Index>, std::size_t> copies;
    for (const Triangle& t : s.triangles) {
      const std::set<Index> corners(t.begin(), t.end());
      if (corners.size() < 3) continue;
      ++copies[corners];
      for (std::size_t k = 0; k < 3; ++k)
        faces_of_edge[{t[k], t[(k + 1) % 3]}].push_back(proper.size());
      proper.push_back(t);
    }
    REQUIRE(found.degenerate_faces == s.triangles.size() - proper.size());
    REQUIRE(found.duplicate_faces == proper.size() - copies.size());
    REQUIRE(found.edges == faces_of_edge.size());

    const auto passes = [](const Triangle& t, Index from, Index to) {
      return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
    };
    // Whether the two faces of an edge go along it in the same direction, with the given ones turned round.
    const auto disagree = [&](const std::set<Index>& edge, const std::vector<std::size_t>& f, std::size_t turned) {
      const Index a = *edge.begin(), b = *edge.rbegin();
      const bool first = passes(proper[f[0]], a, b) != ((turned >> f[0] & 1U) != 0);
      return first == (passes(proper[f[1]], a, b) != ((turned >> f[1] & 1U) != 0));
    };
    std::size_t boundary = 0, crowded = 0, inconsistent = 0;
    std::map<Index, std::set<Index>> boundary_of;
    for (const auto& [edge, f] : faces_of_edge) {
      boundary += f.size() == 1;
      crowded += f.size() > 2;
      inconsistent += f.size() == 2 && disagree(edge, f, 0);
      if (f.size() != 1) continue;
      boundary_of[*edge.begin()].insert(*edge.rbegin());
      boundary_of[*edge.rbegin()].insert(*edge.begin());
    }
    REQUIRE(found.boundary_edges == boundary);
    REQUIRE(found.non_manifold_edges == crowded);
    REQUIRE(found.inconsistent_edges == inconsistent);

    bool orientable = false;
    for (std::size_t turned = 0; turned < std::size_t{1} << proper.size() && !orientable; ++turned) {
      orientable = std::none_of(faces_of_edge.begin(), faces_of_edge.end(), [&](const auto& e) {
        return e.second.size() == 2 && disagree(e.first, e.second, turned);
      });
    }
    REQUIRE(found.orientable == orientable);

    // Number of connected parts of a graph given by its neighbors.
    const auto parts = [](const auto& neighbors) {
      std::size_t count = 0;
      std::set<Index> seen;
      for (const auto& [start, unused] : neighbors) {
        if (!seen.insert(start).second) continue;
        ++count;
        std::vector<Index> open{start};
        while (!open.empty()) {
          const Index at = open.back();
          open.pop_back();
          for (const Index other : neighbors.at(at)) {
            if (seen.insert(other).second) open.push_back(other);
          }
        }
      }
      return count;
    };
    REQUIRE(found.boundary_loops == parts(boundary_of));
    std::size_t pinched = 0;
    for (Index v = 0; v < n; ++v) {
      std::map<Index, std::set<Index>> fan;  // faces at v, neighbors over edges at v
      for (std::size_t f = 0; f < proper.size(); ++f) {
        if (std::count(proper[f].begin(), proper[f].end(), v) > 0) fan[static_cast<Index>(f)];
      }
      for (const auto& [edge, f] : faces_of_edge) {
        if (edge.count(v) == 0) continue;
        for (const std::size_t a : f) {
          for (const std::size_t b : f)
            fan[static_cast<Index>(a)].insert(static_cast<Index>(b));
        }
      }
      pinched += parts(fan) > 1;
    }
    REQUIRE(found.non_manifold_vertices == pinched);
    std::map<Index, std::set<Index>> whole;
    for (const Triangle& t : s.triangles) {
      for (const Index v : t)
        whole[v].insert(t.begin(), t.end());
    }
    REQUIRE(found.components == parts(whole));
    REQUIRE(found.unreferenced_vertices == n - whole.size());
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

TEST_CASE("Huge and tiny surfaces are measured as far as doubles reach") {
  for (const double scale : {1e-100, 1e100, 0x1p-500, 0x1p1000}) {
    Surface s = octahedron();
    for (Vector3& p : s.positions)
      p *= scale;
    const Topology t = topology_of(s);
    // A few roundings of each of the eight triangles; infinite is equal to infinite.
    const auto near = [](double a, double b) { return a == b || std::abs(a - b) <= 1e-14 * b; };
    CHECK(near(t.area, 4 * std::sqrt(3.0) * scale * scale));
    // What is too small for double is the smallest number, which keeps the sign.
    CHECK(near(t.volume, std::max(4.0 / 3 * scale * scale * scale, std::numeric_limits<double>::denorm_min())));
    CHECK(t.zero_area_faces == 0);
    std::swap(s.triangles[0][0], s.triangles[0][1]);
    CHECK(orient(s.positions, s.triangles, base::Host()).reversed_triangles == 1);
  }
}

TEST_CASE("Indices out of range and positions that are not finite are refused") {
  Surface s = octahedron();
  s.triangles[3][1] = 6;
  CHECK(refusal(s) == "invalid-argument");
  s = octahedron();
  s.positions[2].y() = std::nan("");
  CHECK(refusal(s) == "invalid-argument");
}

TEST_CASE("The place of a handle is on it, wherever the surface begins, and a surface without handles has none") {
  const Surface ball = octahedron();
  CHECK(!handle_place(ball.positions, ball.triangles, base::Host()));
  // A plate of cells along x with a hole near its end.
  std::vector<std::vector<int>> solid(12, std::vector<int>(5, 1));
  solid[10][2] = 0;
  Surface s;
  std::map<std::array<int, 3>, Index> numbers;
  const auto corner = [&](int x, int y, int z) {
    const auto [at, is_new] = numbers.try_emplace({x, y, z}, static_cast<Index>(s.positions.size()));
    if (is_new) s.positions.emplace_back(x, y, z);
    return at->second;
  };
  const auto filled = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < 12 && y < 5 && solid[static_cast<std::size_t>(x)][static_cast<std::size_t>(y)] == 1;
  };
  const auto quad = [&](Index a, Index b, Index c, Index d) {
    s.triangles.push_back({a, b, c});
    s.triangles.push_back({a, c, d});
  };
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 5; ++y) {
      if (!filled(x, y)) continue;
      quad(corner(x, y, 1), corner(x + 1, y, 1), corner(x + 1, y + 1, 1), corner(x, y + 1, 1));
      quad(corner(x, y, 0), corner(x, y + 1, 0), corner(x + 1, y + 1, 0), corner(x + 1, y, 0));
      if (!filled(x - 1, y)) quad(corner(x, y, 0), corner(x, y, 1), corner(x, y + 1, 1), corner(x, y + 1, 0));
      if (!filled(x + 1, y))
        quad(corner(x + 1, y, 0), corner(x + 1, y + 1, 0), corner(x + 1, y + 1, 1), corner(x + 1, y, 1));
      if (!filled(x, y - 1)) quad(corner(x, y, 0), corner(x + 1, y, 0), corner(x + 1, y, 1), corner(x, y, 1));
      if (!filled(x, y + 1))
        quad(corner(x, y + 1, 0), corner(x, y + 1, 1), corner(x + 1, y + 1, 1), corner(x + 1, y + 1, 0));
    }
  }
  REQUIRE(topology_of(s).genus == 1);
  const auto place = handle_place(s.positions, s.triangles, base::Host());
  REQUIRE(place.has_value());
  // At the hole or at what is around it.
  CHECK(s.positions[*place].x() >= 9);
}

TEST_CASE("places in refusals of work on a scaled shape are those of the caller") {
  const Vector3 from(1.5, -2.25e-7, 0), to(1e100, 3, -4);
  const std::string text = "gap (2, of 3) between " + place_text(from) + " and " + place_text(to) + "; request more";
  CHECK(scaled_places(text, 0) == text);
  CHECK(scaled_places(text, -30) ==
        "gap (2, of 3) between (1.39698386e-09, -2.09547579e-16, 0) and (9.31322575e+90, "
        "2.79396772e-09, -3.7252903e-09); request more");
  CHECK(scaled_places(scaled_places(text, 40), -40) == text);
  CHECK(scaled_places("at (1, 2", 3) == "at (1, 2");
  CHECK(scaled_places("at (1, 2, x)", 3) == "at (1, 2, x)");
  CHECK(scaled_places("", 3).empty());
  const auto refused = [](int exponent) {
    try {
      with_places_of_caller(exponent, [] { throw base::Error("not-closed", "an edge at (1, 2, 3)"); });
    } catch (const base::Error& error) {
      return std::string(error.kind()) + ": " + error.what();
    }
    return std::string();
  };
  CHECK(refused(0) == "not-closed: an edge at (1, 2, 3)");
  CHECK(refused(-2) == "not-closed: an edge at (4, 8, 12)");
  CHECK(with_places_of_caller(5, [] { return 7; }) == 7);
}
