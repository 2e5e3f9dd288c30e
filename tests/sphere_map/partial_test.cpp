// What is kept of a map whose computation is stopped, at every moment.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "shapes.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using namespace orbicube::sphere_map;
using test::Surface;

namespace {

struct Stopped {
  Partial partial{std::pmr::get_default_resource()};
  std::size_t phases = 0;  // that began; the first report of each is always passed on
  bool finished = false;
};

// Stops when this many phases have begun. Levels take turns between a few, so that there are many.
Stopped stopped(const Surface& s, const Options& options, std::size_t phases) {
  Stopped result;
  const char* last = nullptr;
  base::Host host;
  host.thread_count = 1;
  host.on_progress = [&](const base::Progress& progress) {
    if (progress.phase != last) ++result.phases;
    last = progress.phase;
    return result.phases < phases;
  };
  try {
    compute(s.positions, s.triangles, options, host, &result.partial);
    result.finished = true;
  } catch (const base::Error& e) {
    REQUIRE(std::string(e.kind()) == "cancelled");
  }
  return result;
}

void check_partial(const Surface& s, const Partial& partial) {
  REQUIRE(partial.directions.size() == s.positions.size());
  CHECK(std::all_of(partial.directions.begin(), partial.directions.end(),
                    [](const Vector3& direction) { return std::abs(direction.norm() - 1) < 4e-16; }));
  std::size_t positive = 0;
  std::size_t flipped = 0;
  for (const Triangle& t : s.triangles) {
    const int sign =
        mesh::orientation_from_origin(partial.directions[t[0]], partial.directions[t[1]], partial.directions[t[2]]);
    positive += sign > 0;
    flipped += sign < 0;
  }
  CHECK(flipped == 0);
  // Those of the mesh as it is refined so far. The others have two vertices at one place.
  CHECK(positive == 2 * partial.placed - 4);
}

}  // namespace

TEST_CASE("What is kept of a map that is stopped has no triangle flipped, and is a bijection once all are placed") {
  const Surface s = test::creature(4);
  for (const Method method : {Method::balanced, Method::dissertation}) {
    Options options;
    options.method = method;
    const Stopped whole = stopped(s, options, 1'000'000);
    REQUIRE(whole.finished);
    CHECK(whole.partial.directions.empty());  // the map itself is the result
    std::size_t placed = 0;
    bool partly = false;
    for (std::size_t i = 1; i <= 12; ++i) {
      const Stopped at = stopped(s, options, i * whole.phases / 12);
      REQUIRE(!at.finished);
      CHECK(at.partial.placed >= placed);
      placed = at.partial.placed;
      if (placed == 0) continue;
      check_partial(s, at.partial);
      partly = partly || placed < s.positions.size();
    }
    CHECK(partly);
    CHECK(placed == s.positions.size());
  }
}

TEST_CASE("A partial map gives vertices in no triangle a direction too") {
  Surface s = test::creature(3);
  s.positions.push_back({3, 4, 5});
  const Stopped whole = stopped(s, {}, 1'000'000);
  const Stopped at = stopped(s, {}, whole.phases);
  REQUIRE(!at.finished);
  REQUIRE(!at.partial.directions.empty());
  CHECK(at.partial.directions.back().norm() == doctest::Approx(1));
  CHECK(at.partial.placed == s.positions.size() - 1);
}
