// Flat meshes with flipped triangles of every kind end positive, with what is fixed and tied as it should be.
#include "untangle/triangles/untangle_triangles.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "flat_cases.h"
#include "mesh/search/predicates.h"
#include "untangle/foldover.h"

using namespace orbicube;
using namespace orbicube::untangle;
using std::numbers::pi;

namespace {

UntangledTriangles check(const test::FlatCase& c) {
  CAPTURE(c.name);
  const UntangledTriangles result = untangle_triangles(c.mesh(), {}, base::Host());
  CHECK(result.inverted_before > 0);
  CHECK(result.inverted == 0);
  CHECK(result.first_inverted == no_index);
  CHECK(result.min_determinant > 0);
  CHECK(result.energy >= 4 - 1e-12);
  const auto& p = result.positions;
  for (const Triangle& t : c.triangles)
    CHECK(mesh::orientation_2d(p[t[0]], p[t[1]], p[t[2]]) == 1);
  std::map<Index, double> group;
  for (std::size_t i = 0; i < 2 * c.start.size(); ++i) {
    const double x = p[i / 2][static_cast<Eigen::Index>(i % 2)];
    if (!c.fixed.empty() && c.fixed[i] != 0) CHECK(x == c.start[i / 2][static_cast<Eigen::Index>(i % 2)]);
    if (!c.ties.empty() && c.ties[i] != no_index) CHECK(group.try_emplace(c.ties[i], x).first->second == x);
  }
  return result;
}

std::string refusal(const TriangleProblem& mesh, const UntangleOptions& options = {}) {
  try {
    untangle_triangles(mesh, options, base::Host());
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("Vertices anywhere in a square are untangled, whatever the random numbers") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    check(test::strewn(3 + static_cast<int>(seed % 9), seed));
}

TEST_CASE("Without distortion in reach the target shapes are found") {
  const test::FlatCase c = test::strewn(8, 4);
  const UntangledTriangles result = untangle_triangles(c.mesh(), {.polish_steps = 100, .tolerance = 0}, base::Host());
  CHECK(result.energy == doctest::Approx(4).epsilon(1e-12));
  for (std::size_t v = 0; v < c.start.size(); ++v)
    CHECK((result.positions[v] - c.rest[v].head<2>()).norm() < 1e-6);
}

TEST_CASE("Strips that are bent far are untangled within their boundary") {
  check(test::bent(30, 4, 1.9 * pi, 2, 1));
  check(test::bent(40, 6, pi, 0.3, 2));
}

TEST_CASE("A surface keeps its bump in a map to a square") {
  check(test::bump(12, 0.5, 3));
  check(test::bump(12, 3, 4));
}

TEST_CASE("A swirl unwinds") {
  check(test::swirled(12, 2.5 * pi));
}

TEST_CASE("Equilateral triangles are the targets where no shapes are given") {
  test::FlatCase c = test::strewn(9, 5);
  c.rest.clear();
  check(c);
}

TEST_CASE("Tied coordinates move together to the length that distorts least") {
  test::FlatCase c = test::grid(6, 3);
  c.ties.assign(c.fixed.size(), no_index);
  std::size_t right = 0;
  for (std::size_t v = 0; v < c.start.size(); ++v) {
    // The right side is a vertical line anywhere; all other sides keep their lines only.
    const Vector2d p = c.start[v];
    c.fixed[2 * v] = p.x() == 0;
    c.fixed[2 * v + 1] = p.y() == 0 || p.y() == 3;
    if (p.x() == 6) c.ties[2 * v] = 5, right = v;
    if (p.x() > 0) c.start[v].x() = -0.3 * p.x();
  }
  const UntangledTriangles result = check(c);
  // Target shapes have the area of the start, 0.3 times theirs. In a box the energy is the product of a function of
  // each side: whatever the height, the length is that of the target.
  CHECK(result.positions[right].x() == doctest::Approx(6 * std::sqrt(0.3)).epsilon(1e-3));
}

TEST_CASE("A free boundary takes the target shapes as they are") {
  test::FlatCase c = test::swirled(6, pi);
  c.fixed.clear();
  const UntangledTriangles result = untangle_triangles(c.mesh(), {.polish_steps = 200, .tolerance = 0}, base::Host());
  CHECK(result.inverted == 0);
  CHECK(result.energy == doctest::Approx(4).epsilon(1e-9));
}

TEST_CASE("A positive flat mesh is only polished, and without steps stays as it is") {
  test::FlatCase c = test::swirled(6, 0.4);
  const UntangledTriangles polished = untangle_triangles(c.mesh(), {}, base::Host());
  CHECK(polished.inverted_before == 0);
  CHECK(polished.steps == 0);
  const UntangledTriangles same = untangle_triangles(c.mesh(), {.polish_steps = 0}, base::Host());
  CHECK(std::equal(c.start.begin(), c.start.end(), same.positions.begin()));
  CHECK(polished.energy < same.energy);
}

TEST_CASE("What has no solution is reported with the best that was found") {
  test::FlatCase c = test::strewn(4, 3);
  std::swap(c.start[0], c.start[1]);  // the boundary intersects itself
  const UntangledTriangles result = untangle_triangles(c.mesh(), {.steps = 60}, base::Host());
  CHECK(result.inverted > 0);
  CHECK(result.inverted <= result.inverted_before);
  CHECK(result.first_inverted < c.triangles.size());
  CHECK_THROWS_AS(require_untangled(result, c.triangles.size(), "triangle stays", "triangles stay"), base::Error);
  c.fixed.assign(c.fixed.size(), 1);
  CHECK(untangle_triangles(c.mesh(), {}, base::Host()).inverted > 0);
}

TEST_CASE("Flat meshes at any scale untangle alike") {
  const test::FlatCase c = test::strewn(5, 7);
  const UntangledTriangles as_is = untangle_triangles(c.mesh(), {}, base::Host());
  for (const double scale : {0x1p-200, 0x1p140}) {
    test::FlatCase scaled = c;
    for (Vector2d& p : scaled.start)
      p *= scale;
    const UntangledTriangles result = untangle_triangles(scaled.mesh(), {}, base::Host());
    for (std::size_t v = 0; v < c.start.size(); ++v)
      CHECK(result.positions[v] == scale * as_is.positions[v]);
  }
}

TEST_CASE("Wrong flat meshes are refused with their kind") {
  const test::FlatCase good = test::strewn(3, 3);
  CHECK(refusal(good.mesh()) == "");
  auto c = good;
  c.triangles[3][1] = static_cast<Index>(c.start.size());
  CHECK(refusal(c.mesh()) == "index-range");
  c = good;
  c.triangles[3][1] = c.triangles[3][0];
  CHECK(refusal(c.mesh()) == "degenerate-face");
  c = good;
  std::swap(c.triangles[2][0], c.triangles[2][1]);
  CHECK(refusal(c.mesh()) == "inconsistent-orientation");
  c = good;
  c.triangles.push_back({c.triangles[0][2], c.triangles[0][0], 12});
  CHECK(refusal(c.mesh()) == "non-manifold-edge");
  c = good;
  for (Vector3& p : c.rest)
    p.x() = 0;
  CHECK(refusal(c.mesh()) == "degenerate-geometry");
  c = good;
  c.rest[5] = c.rest[6];
  CHECK(refusal(c.mesh()) == "degenerate-face");
  c = good;
  c.triangles.clear();
  CHECK(refusal(c.mesh()) == "no-cells");
  c = good;
  c.start[1].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(c.mesh()) == "invalid-argument");
  c = good;
  c.rest[1].y() = std::numeric_limits<double>::infinity();
  CHECK(refusal(c.mesh()) == "invalid-argument");
  c = good;
  c.fixed.pop_back();
  CHECK(refusal(c.mesh()) == "invalid-argument");
  c = good;
  c.ties.assign(c.fixed.size(), static_cast<Index>(c.fixed.size()));
  CHECK(refusal(c.mesh()) == "invalid-argument");
  CHECK(refusal(good.mesh(), {.steps = -1}) == "invalid-argument");
}

TEST_CASE("Derivatives of the energy of a triangle are those of its differences") {
  base::Random random(3);
  for (const double eps : {0.0, 0.3, 2.0}) {
    for (int k = 0; k < 20; ++k) {
      Eigen::Matrix2d j;
      for (int i = 0; i < 4; ++i)
        j(i / 2, i % 2) = 2 * random.unit() - 1;
      if (eps == 0 && j.determinant() < 0.05) continue;
      const double lambda = 0.7;
      const auto energy = [&](const Eigen::Matrix2d& at) {
        const double d = at.determinant();
        return 0.5 * (at.squaredNorm() + lambda * (d * d + 1)) / chi_of(d, eps).value;
      };
      const TriangleDerivatives of = differentiate(j, eps, lambda);
      constexpr double h = 1e-6;
      for (int i = 0; i < 4; ++i) {
        Eigen::Matrix2d change = Eigen::Matrix2d::Zero();
        change(i / 2, i % 2) = h;
        CHECK(of.gradient[i] == doctest::Approx((energy(j + change) - energy(j - change)) / (2 * h)).epsilon(1e-6));
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> spectrum(of.block);
      CHECK(spectrum.eigenvalues().minCoeff() > -1e-12 * spectrum.eigenvalues().maxCoeff());
    }
  }
}
