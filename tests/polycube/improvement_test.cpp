// Maps smoothed across edges of the polycube: unfolding and folding change nothing, motions agree around every vertex,
// smoothing keeps the polycube and the surface, and a cube's map becomes an isometry.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "mesh/topology/topology.h"
#include "polycube/outputs/patch_graph.h"
#include "polycube/unfolded/map_improvement.h"
#include "polycube/unfolded/polycube_edges.h"
#include "polycube/unfolded/unfolded_smoothing.h"
#include "polycube/voxels/voxel_construction.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::area_of;
using test::host;
using test::shape;

namespace {

// As the construction leaves it, before it is improved.
Construction grid_based(const mesh::Mesh& m, std::size_t corners) {
  return construct_by_voxels(m.positions, m.triangles, {.corners = corners}, host);
}

// What a map of the surface must be, whatever polycube it goes to.
void check_surface(const mesh::Mesh& m, const SurfaceMap& map) {
  CHECK(std::equal(m.positions.begin(), m.positions.end(), map.positions.begin()));
  // Sums of as many triangles round to about that.
  CHECK(area_of(map.positions, map.triangles) == doctest::Approx(area_of(m.positions, m.triangles)).epsilon(1e-10));
  double farthest = 0;
  for (Index v = 0; v < map.positions.size(); ++v) {
    Vector3 p = Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      if (map.vertex_sources[v].corner[k] != no_index)
        p += map.vertex_sources[v].weight[k] * m.positions[map.vertex_sources[v].corner[k]];
    farthest = std::max(farthest, (p - map.positions[v]).norm());
  }
  CHECK(farthest < 1e-12);  // positions are about 1
}

}  // namespace

TEST_CASE("Motions of the plane compose, and their inverses undo them") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<int> quarters(0, 3), place(-1000, 1000);
  const auto any = [&] { return Vector2d(place(random), place(random)); };
  for (int i = 0; i < 200; ++i) {
    // Whole numbers, so that nothing is rounded.
    const PlaneMotion a{quarters(random), any()}, b{quarters(random), any()};
    const Vector2d p = any();
    CHECK(a.after(b)(p) == a(b(p)));
    CHECK(a.inverse()(a(p)) == p);
    CHECK(a(a.inverse()(p)) == p);
  }
}

TEST_CASE("Triangles beside each other see their edge in one place, and angles at corners are those of the polycube") {
  for (const char* name : {"creature", "torus"}) {
    CAPTURE(name);
    const Construction made = grid_based(shape(name, 700), 40);
    const UnfoldedMap map(made.map, host);
    for (Index h = 0; h < 3 * map.surface.faces(); ++h) {
      const PlaneMotion across = map.across(h);
      const Index other = map.surface.opposite(h);
      // Coordinates are about 1.
      CHECK((across(map.at(h)) - map.at(EditableSurface::next(other))).norm() < 1e-13);
      CHECK((across(map.at(EditableSurface::next(h))) - map.at(other)).norm() < 1e-13);
    }
    CHECK(map.corners.size() == made.certificate.corners);
    // Gauss and Bonnet: four quarters less at each corner than all around.
    int missing = 0;
    for (const UnfoldedCorner& corner : map.corners)
      missing += 4 - corner.quarters;
    CHECK(missing == 8 * (1 - made.certificate.genus));
    for (const UnfoldedDart& dart : map.darts) {
      const Vector3 way = map.corners[dart.target].place - map.corners[dart.corner].place;
      CHECK(way.dot(dart.direction) > 0);
      CHECK(way.cross(dart.direction).norm() == 0);
    }
  }
}

TEST_CASE("Unfolded and folded at once, a map is what it was") {
  for (const char* name : {"creature", "torus"}) {
    CAPTURE(name);
    const mesh::Mesh m = shape(name, 700);
    const Construction made = grid_based(m, 40);
    UnfoldedMap unfolded(made.map, host);
    SurfaceMap folded = fold(unfolded, host);
    const Certificate certificate = certify(folded, host);
    CHECK(certificate.reason.empty());
    CHECK(certificate.corners == made.certificate.corners);
    CHECK(certificate.patch_count == made.certificate.patch_count);
    CHECK(folded.triangles.size() == made.map.triangles.size());
    double farthest = 0;
    for (Index v = 0; v < folded.polycube.size(); ++v)
      farthest = std::max(farthest, (folded.polycube[v] - made.map.polycube[v]).norm());
    CHECK(farthest < 1e-12);
    check_surface(m, folded);
  }
}

TEST_CASE("Smoothing keeps the polycube, to the bit, and lowers the distortion") {
  for (const char* name : {"creature", "torus"}) {
    CAPTURE(name);
    const mesh::Mesh m = shape(name, 700);
    const Construction made = grid_based(m, 40);
    UnfoldedMap unfolded(made.map, host);
    smooth_unfolded(unfolded, {}, host);
    SurfaceMap folded = fold(unfolded, host);
    const Certificate certificate = certify(folded, host);
    CHECK(certificate.reason.empty());
    CHECK(certificate.corners == made.certificate.corners);
    CHECK(certificate.patch_count == made.certificate.patch_count);
    check_surface(m, folded);
    // Planes of the faces, of which there is a corner on each.
    for (const UnfoldedCorner& corner : unfolded.corners)
      CHECK(std::find(made.map.polycube.begin(), made.map.polycube.end(), corner.place) != made.map.polycube.end());
    CHECK(area_of(folded.polycube, folded.triangles) ==
          doctest::Approx(area_of(made.map.polycube, made.map.triangles)).epsilon(1e-10));
    const Distortion before = measure_distortion(made.map, host), after = measure_distortion(folded, host);
    CHECK(after.angle_weighted_mean + after.area_weighted_mean <
          before.angle_weighted_mean + before.area_weighted_mean);
  }
}

TEST_CASE("A cube's map becomes an isometry") {
  const mesh::Mesh m = shape("cube", 600);
  Construction made = grid_based(m, 8);
  // Every vertex within a face somewhere else, as far as triangles stay positive.
  REQUIRE(made.certificate.corners == 8);
  const Distortion after = improve_map(made.map, made.certificate, {}, host);
  CHECK(certify(made.map, host).valid());
  check_surface(m, made.map);
  // The minimum is 1 for both; the steps end when they gain less than 1e-4 of that.
  CHECK(after.angle_mean == doctest::Approx(1).epsilon(1e-3));
  CHECK(after.area_mean == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("Improving never makes a map worse, and its proof is that of the map") {
  for (const char* name : {"creature", "bracket"}) {
    CAPTURE(name);
    const mesh::Mesh m = shape(name, 700);
    Construction made = grid_based(m, 60);
    const Distortion before = made.distortion;
    const Distortion after = improve_map(made.map, made.certificate, {}, host);
    CHECK(after.angle_mean + after.area_mean <= before.angle_mean + before.area_mean);
    const Distortion measured = measure_distortion(made.map, host);
    CHECK(measured.angle_mean == after.angle_mean);
    CHECK(measured.area_mean == after.area_mean);
    const Certificate certificate = certify(made.map.polycube, made.map.triangles, host);
    CHECK(certificate.reason.empty());
    CHECK(certificate.corners == made.certificate.corners);
    CHECK(certificate.genus == made.certificate.genus);
    CHECK(certificate.labels == made.map.labels);
    CHECK(certificate.patches == made.map.patches);
    check_surface(m, made.map);
  }
}

TEST_CASE(
    "Without other proportions the polycube stays to the bit, and corners that are fixed stay at their vertices") {
  const mesh::Mesh m = shape("creature", 700);
  const Construction made = grid_based(m, 24);
  const auto vertex_at = [](const SurfaceMap& map, const Vector3& place) {
    return std::find(map.polycube.begin(), map.polycube.end(), place) - map.polycube.begin();
  };
  const PatchGraph graph = make_patch_graph(made.map, host);
  std::size_t moved = 0;
  for (const bool held : {false, true}) {
    Construction next = made;
    const Distortion after = improve_map(
        next.map, next.certificate,
        {.domain = false, .held_corners = held ? std::span<const Vector3>(graph.corners) : std::span<const Vector3>()},
        host);
    CHECK(after.angle_weighted_mean + after.area_weighted_mean <
          made.distortion.angle_weighted_mean + made.distortion.area_weighted_mean);
    CHECK(certify(next.map.polycube, next.map.triangles, host).valid());
    const PatchGraph now = make_patch_graph(next.map, host);
    CHECK(now.corners.size() == graph.corners.size());
    for (const Vector3& corner : graph.corners) {
      const auto before = vertex_at(made.map, corner), here = vertex_at(next.map, corner);
      REQUIRE(here < static_cast<std::ptrdiff_t>(next.map.polycube.size()));
      const bool same =
          made.map.positions[static_cast<std::size_t>(before)] == next.map.positions[static_cast<std::size_t>(here)];
      if (held)
        CHECK(same);
      else
        moved += !same;
    }
  }
  CHECK(moved > 0);
}
