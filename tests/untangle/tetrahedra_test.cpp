// Inverted meshes of every kind end positive, with what is fixed and tied as it should be.
#include "untangle/tetrahedra/untangle_tetrahedra.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "tangled_cases.h"

using namespace orbicube;
using namespace orbicube::untangle;
using std::numbers::pi;

namespace {

void check(const test::TangledCase& c) {
  CAPTURE(c.name);
  std::vector<Vector3> first;
  for (const unsigned threads : {1U, 3U}) {
    base::Host host;
    host.thread_count = threads;
    const Untangled result = untangle_tetrahedra(c.mesh(), {}, host);
    CHECK(result.inverted_before > 0);
    CHECK(result.inverted == 0);
    CHECK(result.first_inverted == no_index);
    CHECK(result.min_determinant > 0);
    CHECK(result.energy >= 5);
    for (const Tetrahedron& t : c.tetrahedra) {
      const auto& p = result.positions;
      CHECK(mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) == 1);
    }
    std::map<Index, double> group;
    for (std::size_t i = 0; i < 3 * c.start.size(); ++i) {
      const double x = result.positions[i / 3][static_cast<Eigen::Index>(i % 3)];
      if (!c.fixed.empty() && c.fixed[i] != 0) CHECK(x == c.start[i / 3][static_cast<Eigen::Index>(i % 3)]);
      if (!c.ties.empty() && c.ties[i] != no_index) CHECK(group.try_emplace(c.ties[i], x).first->second == x);
    }
    if (first.empty()) first.assign(result.positions.begin(), result.positions.end());
    CHECK(std::equal(first.begin(), first.end(), result.positions.begin(), result.positions.end()));
  }
}

std::string refusal(const UntangleProblem& mesh, const UntangleOptions& options = {}) {
  try {
    untangle_tetrahedra(mesh, options, base::Host());
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("Random vertices in a box are untangled") {
  check(test::strewn(2, 4, 1, 1));
}

TEST_CASE("A folded box unfolds") {
  check(test::folded(4, 3, 1, false));
  check(test::folded(4, 3, 1.3, true));
}

TEST_CASE("A twisted bar keeps its ends") {
  check(test::twisted(4, 3, 0.9 * pi));
}

TEST_CASE("Boundary faces of a bent solid become planes at free positions") {
  check(test::polycube_start({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 3, 0.8, 0.4, 0.6));
}

TEST_CASE("Regular tetrahedra are the targets where no shapes are given") {
  test::TangledCase c = test::strewn(1, 4, 1, 2);
  c.rest.clear();
  check(c);
}

TEST_CASE("A positive mesh is only polished, and without steps stays as it is") {
  test::TangledCase c = test::twisted(2, 2, 0.5);
  const base::Host host;
  const Untangled polished = untangle_tetrahedra(c.mesh(), {}, host);
  CHECK(polished.steps == 0);
  const Untangled same = untangle_tetrahedra(c.mesh(), {.polish_steps = 0}, host);
  CHECK(std::equal(c.start.begin(), c.start.end(), same.positions.begin()));
  CHECK(polished.energy < same.energy);
}

TEST_CASE("What cannot be untangled is reported, not returned as if it were") {
  test::TangledCase c = test::strewn(1, 2, 1, 3);
  c.fixed.assign(c.fixed.size(), 1);
  c.start[0] = Vector3(0.9, 0.9, 0.9);
  const Untangled result = untangle_tetrahedra(c.mesh(), {}, base::Host());
  CHECK(result.inverted > 0);
  CHECK(result.first_inverted < c.tetrahedra.size());
  CHECK(result.inverted == result.inverted_before);
  CHECK_THROWS_AS(require_untangled(result, c.tetrahedra.size(), "tetrahedron stays", "tetrahedra stay"), base::Error);
}

TEST_CASE("Shapes at any scale and place untangle alike") {
  for (const double scale : {1e-60, 1e40}) {
    test::TangledCase c = test::folded(3, 2, 1, false);
    for (Vector3& p : c.start)
      p *= scale;
    const Untangled result = untangle_tetrahedra(c.mesh(), {}, base::Host());
    CHECK(result.inverted == 0);
  }
}

TEST_CASE("Wrong input is refused with its kind") {
  const test::TangledCase good = test::strewn(1, 2, 1, 3);
  CHECK(refusal(good.mesh()) == "");
  auto c = good;
  c.tetrahedra[3][1] = static_cast<Index>(c.start.size());
  CHECK(refusal(c.mesh()) == "index-range");
  c = good;
  c.tetrahedra[3][1] = c.tetrahedra[3][0];
  CHECK(refusal(c.mesh()) == "degenerate-cell");
  c = good;
  std::swap(c.tetrahedra[2][0], c.tetrahedra[2][1]);
  CHECK(refusal(c.mesh()) == "inverted-cell");
  c = good;
  for (Vector3& p : c.rest)
    p[2] = 0;
  CHECK(refusal(c.mesh()) == "degenerate-geometry");
  c = good;
  c.tetrahedra.clear();
  CHECK(refusal(c.mesh()) == "no-cells");
  c = good;
  c.rest[1][1] = std::numeric_limits<double>::infinity();
  CHECK(refusal(c.mesh()) == "invalid-argument");
  c.rest.pop_back();
  CHECK(refusal(c.mesh()) == "invalid-argument");
  CHECK(refusal(good.mesh(), {.steps = -1}) == "invalid-argument");
  CHECK(refusal(good.mesh(), {.volume_weight = 0}) == "invalid-argument");
}
