// Surfaces that cannot be filled are refused for the reason that they have, before TetGen runs.
#include "tetrahedra/input_check.h"

#include <limits>

#include "mesh/search/intersections.h"
#include "shapes.h"

using namespace orbicube;
using namespace orbicube::test;
using mesh::Vector3;

TEST_CASE("What is no closed manifold is refused with its kind") {
  const Surface sphere = made("sphere", 100);
  CHECK(refusal(Surface()) == "empty-mesh");
  Surface bad = sphere;
  bad.triangles.pop_back();
  CHECK(refusal(bad) == "not-closed");
  bad = sphere;
  bad.triangles.push_back(sphere.triangles[0]);
  CHECK(refusal(bad) == "duplicate-face");
  bad = sphere;
  bad.triangles[0][1] = bad.triangles[0][0];
  CHECK(refusal(bad) == "degenerate-face");
  bad = sphere;
  bad.triangles[0][1] = static_cast<mesh::Index>(bad.positions.size());
  CHECK(refusal(bad) == "invalid-argument");
  bad = sphere;
  bad.positions[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(bad) == "invalid-argument");
  bad = sphere;
  std::fill(bad.positions.begin(), bad.positions.end(), Vector3(1, 2, 3));
  CHECK(refusal(bad) == "degenerate-geometry");

  // Two tetrahedra with an edge in common, and two with a vertex in common.
  Surface touching;
  touching.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
  touching.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {0, 5, 4}};
  CHECK(refusal(touching) == "non-manifold-edge");
  touching.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  touching.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}};
  CHECK(refusal(touching) == "non-manifold-vertex");
}

TEST_CASE("A triangle without area is refused") {
  Surface flat = box({0, 0, 0}, {1, 1, 1});
  // The middle of the edge 0-1, in the two triangles beside it, one of which is cut so that a part has no area.
  flat.positions.push_back({0.5, 0, 0});
  std::erase(flat.triangles, mesh::Triangle{0, 1, 4});
  flat.triangles.push_back({0, 8, 4});
  flat.triangles.push_back({8, 1, 4});
  flat.triangles.push_back({0, 1, 8});
  CHECK(refusal(flat) == "degenerate-face");
}

TEST_CASE("Self-intersections come back as the pairs of triangles that meet") {
  Surface crossing;
  crossing.add(made("sphere", 60), 1, Vector3::Zero());
  crossing.add(made("sphere", 60), 1, {1.3, 0.1, 0.2});
  CHECK(refusal(crossing) == "self-intersection");
  const auto pairs = tetrahedra::self_intersections(crossing.positions, crossing.triangles, host);
  std::vector<tetrahedra::FacePair> expected;
  for (mesh::Index a = 0; a < crossing.triangles.size(); ++a) {
    for (mesh::Index b = a + 1; b < crossing.triangles.size(); ++b) {
      if (mesh::triangles_intersect(crossing.positions, crossing.triangles[a], crossing.triangles[b]))
        expected.push_back({a, b});
    }
  }
  CHECK(!expected.empty());
  CHECK(std::vector<tetrahedra::FacePair>(pairs.begin(), pairs.end()) == expected);
}

TEST_CASE("Surfaces that only touch are refused as well") {
  Surface touching = box({0, 0, 0}, {1, 1, 1});
  touching.add(box({1, 0.25, 0.25}, {2, 0.75, 0.75}), 1, Vector3::Zero());
  CHECK(refusal(touching) == "self-intersection");
}

TEST_CASE("A closed surface with one side is refused") {
  // Six vertices of the projective plane.
  Surface plane;
  plane.positions = {{0, 0, 1}, {1, 0, 0}, {0.3, 1, 0}, {-0.8, 0.6, 0}, {-0.8, -0.6, 0.1}, {0.3, -1, 0.2}};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                     {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  CHECK(refusal(plane) == "non-orientable");
}
