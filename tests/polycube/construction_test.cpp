// The choice between constructions: certified maps, the better one, budgets, the same bits for any number of threads.
#include "polycube/map/construction.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "base/error.h"
#include "mesh/topology/topology.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;
using test::shape;

namespace {

BestConstruction best_construction(const mesh::Mesh& m, Method method, std::size_t corners,
                                   const base::Host& on = host) {
  return polycube::construct(m.positions, m.triangles, {.method = method, .corners = corners, .seed = 0}, on);
}

void check_map(const mesh::Mesh& m, const BestConstruction& best) {
  const SurfaceMap& map = best.made.map;
  const Certificate certificate = certify(map.polycube, map.triangles, host);
  CHECK(certificate.valid());
  CHECK(certificate.corners == best.made.certificate.corners);
  CHECK(certificate.genus == *mesh::topology(m.positions, m.triangles, host).genus);
  CHECK(std::equal(m.positions.begin(), m.positions.end(), map.positions.begin()));
  CHECK(best.method != Method::automatic);
  CHECK(best.made.valid >= 1);
  CHECK(best.made.valid <= best.made.tried);
  const Distortion d = measure_distortion(map, host);
  CHECK(d.angle_mean == best.made.distortion.angle_mean);
  CHECK(d.area_mean == best.made.distortion.area_mean);
}

double score(const BestConstruction& best) {
  return best.made.distortion.angle_mean + best.made.distortion.area_mean;
}

}  // namespace

TEST_CASE("The map kept is no worse than that of either construction, and within the budget" *
          doctest::test_suite("long")) {
  struct Case {
    const char* name;
    std::size_t corners;
  };
  for (const Case& c : {Case{"creature", 16}, Case{"blob", 8}}) {
    CAPTURE(c.name);
    const mesh::Mesh m = shape(c.name, 700);
    const BestConstruction best = best_construction(m, Method::automatic, c.corners);
    check_map(m, best);
    CHECK(best.made.certificate.corners <= c.corners);
    for (const Method method : {Method::labels, Method::voxels}) {
      try {
        const BestConstruction alone = best_construction(m, method, c.corners);
        check_map(m, alone);
        CHECK(alone.method == method);
        CHECK(alone.made.certificate.corners <= c.corners);
        // Fewer corners may cost 2 percent.
        CHECK(score(best) <= 1.02 * score(alone));
      } catch (const base::Error& error) {
        CHECK(error.status() == base::Status::no_valid_result);
        CHECK(best.method != method);
      }
    }
  }
}

TEST_CASE("The same bits for any number of threads, by both constructions") {
  const mesh::Mesh m = shape("creature", 500);
  base::Host alone = host, crowd = host;
  alone.thread_count = 1;
  crowd.thread_count = 3;
  const BestConstruction one = best_construction(m, Method::automatic, 16, alone),
                         other = best_construction(m, Method::automatic, 16, crowd);
  CHECK(one.method == other.method);
  CHECK(one.made.tried == other.made.tried);
  CHECK(one.made.valid == other.made.valid);
  CHECK(one.made.map.triangles == other.made.map.triangles);
  CHECK(std::equal(one.made.map.polycube.begin(), one.made.map.polycube.end(), other.made.map.polycube.begin(),
                   other.made.map.polycube.end()));
}

TEST_CASE("Surfaces with handles get the corners that they need, all others the budget") {
  const mesh::Mesh torus = shape("torus", 800);
  for (const Method method : {Method::automatic, Method::labels, Method::voxels}) {
    const BestConstruction best = best_construction(torus, method, 8);
    check_map(torus, best);
    CHECK(best.made.certificate.corners <= 16);
  }
  const mesh::Mesh sphere = shape("sphere", 400);
  for (const Method method : {Method::automatic, Method::labels, Method::voxels}) {
    try {
      best_construction(sphere, method, 7);
      FAIL("a polycube of 7 corners");
    } catch (const base::Error& error) {
      CHECK(error.kind() == std::string("no-valid-result"));
      CHECK(error.what() == std::string("a polycube has at least 8 corners"));
    }
  }
}

TEST_CASE("A failure says of which construction it was, and automatic needs one that works") {
  // Thinner than any voxel.
  mesh::Mesh plate = shape("cube", 400);
  for (Vector3& p : plate.positions)
    p.z() *= 1e-5;
  check_map(plate, best_construction(plate, Method::automatic, 8));
  try {
    best_construction(plate, Method::voxels, 8);
    FAIL("voxels have no place in it");
  } catch (const base::Error& error) {
    CHECK(error.kind() == std::string("no-valid-result"));
    CHECK(std::string(error.what()).starts_with("grid-based: no polycube of "));
  }
}

TEST_CASE("Surfaces that are not closed are refused for what they are") {
  mesh::Mesh open = shape("sphere", 400);
  open.triangles.pop_back();
  for (const std::size_t corners : {std::size_t{0}, std::size_t{60}}) {
    for (const Method method : {Method::automatic, Method::labels, Method::voxels}) {
      try {
        best_construction(open, method, corners);
        FAIL("a polycube of an open surface");
      } catch (const base::Error& error) {
        CHECK(error.status() == base::Status::not_closed);
      }
    }
  }
}

TEST_CASE("Cancelling at the beginning of any phase ends the construction, whatever the phases are called") {
  const mesh::Mesh m = shape("creature", 500);
  // The first report of each phase is always passed on, so that a run has the same number of them each time.
  const auto stopped_at = [&](std::size_t limit, std::size_t& begun) {
    base::Host stopping;
    std::string last;
    std::size_t after = 0;
    begun = 0;
    stopping.on_progress = [&](const base::Progress& progress) {
      after += begun >= limit;
      begun += progress.phase != last;
      last = progress.phase;
      return begun < limit;
    };
    bool stopped = false;
    try {
      best_construction(m, Method::automatic, 16, stopping);
    } catch (const base::Error& error) {
      stopped = error.status() == base::Status::cancelled;
    }
    CHECK(after == 0);
    return stopped;
  };
  std::size_t phases = 0;
  REQUIRE_FALSE(stopped_at(std::numeric_limits<std::size_t>::max(), phases));
  REQUIRE(phases > 10);
  constexpr std::size_t rounds = 16;
  for (std::size_t round = 1; round <= rounds; ++round) {
    const std::size_t limit = std::max<std::size_t>(1, round * phases / rounds);
    CAPTURE(limit);
    std::size_t begun = 0;
    CHECK(stopped_at(limit, begun));
    CHECK(begun == limit);
  }
}
