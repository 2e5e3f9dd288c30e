// Features that are met: points and curves exactly where they must be, ties by their weights, sharp edges on edges of
// the polycube, and refusals that leave the map as it was.
#include "polycube/features/features.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "mesh/search/nearest.h"
#include "polycube/map/construction.h"
#include "polycube/outputs/patch_graph.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;
using test::shape;

namespace {

// A box's map of a ball, once for all tests.
const SurfaceMap& ball() {
  static const SurfaceMap map = [] {
    const mesh::Mesh m = shape("sphere", 1200);
    return construct(m.positions, m.triangles, {.method = Method::voxels, .corners = 8}, host).made.map;
  }();
  return map;
}

struct Box {
  Vector3 low, high;
};

Box box_of(const SurfaceMap& map) {
  Box box{map.polycube[map.triangles[0][0]], map.polycube[map.triangles[0][0]]};
  for (const Triangle& t : map.triangles)
    for (const Index v : t) {
      box.low = box.low.cwiseMin(map.polycube[v]);
      box.high = box.high.cwiseMax(map.polycube[v]);
    }
  return box;
}

// Parts of the way along each axis.
Vector3 place_in(const SurfaceMap& map, double x, double y, double z) {
  const Box box = box_of(map);
  Vector3 result;
  for (int k = 0; k < 3; ++k) {
    const double part = k == 0 ? x : k == 1 ? y : z;
    result[k] = part == 0 ? box.low[k] : part == 1 ? box.high[k] : box.low[k] + part * (box.high[k] - box.low[k]);
  }
  return result;
}

Index vertex_near(const SurfaceMap& map, const Vector3& place) {
  return mesh::VertexSearch(map.polycube, host).nearest(place);
}

void check_same_polycube(const SurfaceMap& before, SurfaceMap after) {
  const Certificate certificate = certify(after, host);
  CHECK(certificate.reason.empty());
  const PatchGraph was = make_patch_graph(before, host), is = make_patch_graph(after, host);
  CHECK(is.patches() == was.patches());
  for (const Vector3& corner : was.corners)
    CHECK(std::find(is.corners.begin(), is.corners.end(), corner) != is.corners.end());
}

}  // namespace

TEST_CASE("Points that must be somewhere are mapped there to the bit, in faces, on edges and at corners") {
  SurfaceMap map = ball();
  std::vector<FeaturePoint> points;
  const auto pull = [&](const Vector3& from, const Vector3& to) { points.push_back({vertex_near(map, from), to}); };
  pull(place_in(map, 0.5, 0.5, 1), place_in(map, 0.62, 0.41, 1));
  pull(place_in(map, 0.4, 0, 0.6), place_in(map, 0.3, 0, 0.7));
  pull(place_in(map, 1, 0.35, 0.9), place_in(map, 1, 0.4, 1));   // onto an edge
  pull(place_in(map, 0.8, 0.1, 0), place_in(map, 0.8, 0, 0.1));  // around an edge
  pull(place_in(map, 0.12, 0.9, 1), place_in(map, 0, 1, 1));     // to a corner
  const FeatureFit fit = align_features(map, {.points = points}, host);
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(map.polycube[points[i].vertex] == points[i].place);
    CHECK(fit.distances_before[i] > 0);
    CHECK(fit.distances[i] == 0);
  }
  check_same_polycube(ball(), map);
  CHECK(fit.distortion.angle_mean < 1.5);
  CHECK(std::equal(map.positions.begin(), map.positions.begin() + 600, ball().positions.begin()));
}

TEST_CASE("Features are met on a very small and on a very large polycube") {
  const FeaturePoint to_face{vertex_near(ball(), place_in(ball(), 0.5, 0.5, 1)), place_in(ball(), 0.62, 0.41, 1)};
  for (const double scale : {0x1p-32, 0x1p32}) {
    SurfaceMap map = ball();
    for (Vector3& p : map.positions)
      p *= scale;
    for (Vector3& p : map.polycube)
      p *= scale;
    const FeaturePoint scaled{to_face.vertex, scale * to_face.place};
    align_features(map, {.points = {&scaled, 1}}, host);
    CHECK(map.polycube[scaled.vertex] == scaled.place);
    CHECK(certify(map, host).reason.empty());
  }
}

TEST_CASE("A tie draws a point the nearer to its place the more it weighs, and the sum is less than without it") {
  const Vector3 place = place_in(ball(), 0.7, 0.6, 1);
  const Index vertex = vertex_near(ball(), place_in(ball(), 0.5, 0.5, 1));
  double last = (ball().polycube[vertex] - place).norm();
  for (const double weight : {0.1, 3.0, 100.0}) {
    SurfaceMap map = ball();
    const FeaturePoint point{vertex, place, weight};
    const FeatureFit fit = align_features(map, {.points = {&point, 1}}, host);
    CHECK(fit.distances[0] < last);
    CHECK(fit.distances[0] > 0);
    last = fit.distances[0];
    check_same_polycube(ball(), map);
  }
  CHECK(last < 0.1 * (ball().polycube[vertex] - place).norm());
}

TEST_CASE("Curves are mapped to lines in faces and to edges of the polycube, in their order") {
  const SurfaceMap& before = ball();
  for (const bool on_edge : {false, true}) {
    CAPTURE(on_edge);
    SurfaceMap map = before;
    // Vertices nearest to places along a line that is bent against the target.
    std::vector<Index> vertices;
    const double side = on_edge ? 0.93 : 0.5;
    for (double part = 0.1; part < 0.95; part += 0.2) {
      const Index v = vertex_near(map, place_in(map, part, side - 0.1 * part, 1));
      if (vertices.empty() || vertices.back() != v) vertices.push_back(v);
    }
    const double there = on_edge ? 1 : 0.5;
    const FeatureCurve curve{vertices, place_in(map, 0.1, there, 1), place_in(map, 0.9, there, 1)};
    const FeatureFit fit = align_features(map, {.curves = {&curve, 1}}, host);
    CHECK(fit.distances_before[0] > 0);
    CHECK(fit.distances[0] == 0);
    CHECK(map.polycube[vertices.front()] == curve.from);
    CHECK(map.polycube[vertices.back()] == curve.to);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      CHECK(map.polycube[vertices[i]][1] == curve.from[1]);
      CHECK(map.polycube[vertices[i]][2] == curve.from[2]);
      if (i > 0) CHECK(map.polycube[vertices[i]][0] > map.polycube[vertices[i - 1]][0]);
    }
    check_same_polycube(before, map);
  }
}

TEST_CASE("Sharp edges come to edges of the polycube") {
  const mesh::Mesh m = shape("bracket", 1500);
  SurfaceMap map = construct(m.positions, m.triangles, {.corners = 60}, host).made.map;
  const SurfaceMap before = map;
  const FeatureFit fit = align_features(map, {.feature_angle = 60}, host);
  MESSAGE(fit.sharp_length, " sharp, on edges ", fit.sharp_before, ", then ", fit.sharp, "; angle ",
          fit.distortion_before.angle_mean, " ", fit.distortion.angle_mean);
  CHECK(fit.sharp_length > 0);
  CHECK(fit.sharp >= fit.sharp_before);
  CHECK(fit.sharp > 0.7 * fit.sharp_length);
  check_same_polycube(before, map);
}

TEST_CASE("What cannot be met is refused, and the map stays") {
  const Vector3 top = place_in(ball(), 0.5, 0.5, 1);
  const Index v = vertex_near(ball(), top);
  const auto refused = [&](const FeatureOptions& options, const char* words) {
    SurfaceMap map = ball();
    CHECK_THROWS_WITH(align_features(map, options, host), doctest::Contains(words));
    CHECK(map.polycube == ball().polycube);
    CHECK(map.triangles == ball().triangles);
  };
  const auto points = [&](std::initializer_list<FeaturePoint> list) { return std::vector<FeaturePoint>(list); };
  refused({.points = points({{v, place_in(ball(), 0.5, 0.5, 0.5)}})}, "not on the polycube");
  for (const double far : {1e150, 1e200, 1e300})
    refused({.points = points({{v, Vector3(far, 0, 0)}})}, "not on the polycube");
  refused({.points = points({{v, top}, {v, top}})}, "two places");
  refused({.points = points({{no_index, top}})}, "does not exist");
  refused({.points = points({{v, top, -1}})}, "must not be negative");
  const std::vector<Index> two = {v, vertex_near(ball(), place_in(ball(), 0.8, 0.5, 1))};
  const FeatureCurve slanted{two, place_in(ball(), 0.2, 0.2, 1), place_in(ball(), 0.8, 0.7, 1)};
  refused({.curves = {&slanted, 1}}, "not along an axis");
  // Two vertices of a triangle that change places.
  const Triangle& t = *std::find_if(ball().triangles.begin(), ball().triangles.end(), [&](const Triangle& triangle) {
    return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
  });
  const Index other = t[0] == v ? t[1] : t[0];
  const Vector3 here = ball().polycube[v], there = ball().polycube[other];
  const std::vector<FeaturePoint> swapped = {
      {v, there}, {other, here}, {t[0] + t[1] + t[2] - v - other, ball().polycube[t[0] + t[1] + t[2] - v - other]}};
  refused({.points = swapped}, "comes no nearer");
}
