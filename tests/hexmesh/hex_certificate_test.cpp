// The determinant of a hexahedron: its Bernstein coefficients against the definition, signs, and what is measured.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/certificate/hex_tetrahedra.h"

using namespace orbicube;
using namespace orbicube::hexmesh;

namespace {

constexpr std::array<std::array<int, 3>, 8> corners = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
constexpr Hexahedron whole = {0, 1, 2, 3, 4, 5, 6, 7};

std::vector<Vector3> cube(double push, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-push, push);
  std::vector<Vector3> result;
  for (const auto& c : corners)
    result.push_back(Vector3(c[0] + uniform(random), c[1] + uniform(random), c[2] + uniform(random)));
  return result;
}

// Of the trilinear map, by differences of its definition.
double determinant(const std::vector<Vector3>& p, const Vector3& at) {
  Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < 8; ++k) {
    for (Eigen::Index d = 0; d < 3; ++d) {
      double slope = 1;
      for (Eigen::Index e = 0; e < 3; ++e) {
        const bool high = corners[k][static_cast<std::size_t>(e)] == 1;
        slope *= e == d ? (high ? 1 : -1) : (high ? at[e] : 1 - at[e]);
      }
      j.col(d) += slope * p[k];
    }
  }
  return j.determinant();
}

}  // namespace

TEST_CASE("Bernstein coefficients are those of the trilinear map's determinant") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 20; ++run) {
    const auto p = cube(0.4, random);
    const auto f = bezier_coefficients(p, whole);
    const Vector3 at(uniform(random), uniform(random), uniform(random));
    const auto bernstein = [](int i, double t) {
      return i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t;
    };
    double sum = 0;
    for (int i = 0; i < 27; ++i)
      sum += f[static_cast<std::size_t>(i)] * bernstein(i % 3, at[0]) * bernstein(i / 3 % 3, at[1]) *
             bernstein(i / 9, at[2]);
    CHECK(sum == doctest::Approx(determinant(p, at)).epsilon(1e-12));
  }
}

TEST_CASE(
    "The tetrahedra at corners and along edges are boxes in a box, and have the determinant's coefficients there") {
  std::mt19937_64 random(5);
  const std::array<double, 3> lengths = {2, 0.5, 3};
  std::vector<Vector3> box;
  for (const auto& c : corners)
    box.push_back(Vector3(lengths[0] * c[0], lengths[1] * c[1], lengths[2] * c[2]));
  for (const HexTetrahedron& t : hex_tetrahedra) {
    Element element = t.element(whole);
    t.set_shape(lengths, element);
    const Eigen::Matrix3d jacobian = element.jacobian(box);
    CHECK((jacobian.transpose() * jacobian - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(jacobian.determinant() == doctest::Approx(1));
    CHECK(t.scaled_jacobian(box, element) == doctest::Approx(1));
  }
  // In a cube of edges 1 determinants are those of the target shape's map.
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Vector3> p = cube(0.7, random);
    const auto coefficients = bezier_coefficients(p, whole);
    std::array<double, 27> means{};
    for (std::size_t k = 0; k < hex_tetrahedra.size(); ++k) {
      Element element = hex_tetrahedra[k].element(whole);
      hex_tetrahedra[k].set_shape({1, 1, 1}, element);
      const double determinant = element.jacobian(p).determinant();
      // A corner's, or half-way between those of the first two vertices.
      const auto& a = corners[element.corner[0]];
      const auto& b = corners[element.corner[k < corner_tetrahedra ? 0 : 1]];
      const int place = (a[0] + b[0]) + 3 * (a[1] + b[1]) + 9 * (a[2] + b[2]);
      means[static_cast<std::size_t>(place)] += k < corner_tetrahedra ? determinant : determinant / 2;
      if (k < corner_tetrahedra)
        CHECK(hex_tetrahedra[k].scaled_jacobian(p, element) == doctest::Approx(corner_jacobian(p, whole, k)));
    }
    std::size_t compared = 0;
    for (std::size_t i = 0; i < 27; ++i) {
      if ((i % 3 == 1) + (i / 3 % 3 == 1) + (i / 9 == 1) > 1) continue;  // on faces and inside
      ++compared;
      CHECK(means[i] == doctest::Approx(coefficients[i]).epsilon(1e-10));
    }
    CHECK(compared == 20);
  }
}

TEST_CASE("What is called certainly positive is so, and what is not has a reason") {
  std::mt19937_64 random(2);
  int positive = 0;
  for (int run = 0; run < 1000; ++run) {
    const auto p = cube(0.45, random);
    double least = 1;
    constexpr int steps = 10;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        for (int k = 0; k <= steps; ++k)
          least = std::min(least, determinant(p, Vector3(i, j, k) / steps));
      }
    }
    const bool certain = certainly_positive(p, whole);
    if (certain) CHECK(least > 0);
    if (least > 0.05) CHECK(certain);
    positive += certain;
  }
  CHECK(positive > 30);
}

TEST_CASE("Measures of a box and of what is inverted") {
  std::mt19937_64 random(3);
  auto p = cube(0, random);
  const std::vector<Hexahedron> cells = {whole};
  HexQuality q = measure_hexahedra(p, cells, base::Host());
  CHECK(q.valid());
  CHECK(q.min_scaled_jacobian == 1);
  CHECK(q.mean_scaled_jacobian == 1);
  CHECK(q.volume == doctest::Approx(1));
  CHECK(min_bezier(p, whole) == doctest::Approx(1));
  p[6] = Vector3(0.1, 0.1, 0.1);
  q = measure_hexahedra(p, cells, base::Host());
  CHECK(!q.valid());
  CHECK(q.inverted == 1);
  CHECK(q.first_bad == 0);
}
