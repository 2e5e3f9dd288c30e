// The rotations of the cube as a group, the nearest one, and distances of frames, against searches over all 24.
#include "quaternion/cube_group.h"

#include <set>

#include "quaternion/batch.h"
#include "quaternion/frame_distance.h"
#include "quaternion/rotation.h"
#include "samples.h"

using namespace orbicube;
using namespace orbicube::test;
using namespace orbicube::quaternion;

TEST_CASE("The elements are 24 different rotations that permute the axes, as their matrices say exactly") {
  std::set<std::array<std::int8_t, 9>> matrices;
  for (std::uint32_t a = 0; a < cube_order; ++a) {
    const Quaternion& q = cube_group.element[a];
    CHECK(std::abs(length(q) - 1) <= ulp);
    const Matrix m = to_matrix(q);
    for (std::size_t k = 0; k < 9; ++k)
      CHECK(std::abs(m[k] - cube_group.matrix[a][k]) <= 2 * ulp);  // the square of 1 / sqrt 2 is half an ulp off
    matrices.insert(cube_group.matrix[a]);
  }
  CHECK(matrices.size() == 24);
}

TEST_CASE("The tables are those of the group of the matrices") {
  const auto product = [](const std::array<std::int8_t, 9>& a, const std::array<std::int8_t, 9>& b) {
    std::array<std::int8_t, 9> c{};
    for (std::size_t k = 0; k < 9; ++k) {
      int sum = 0;
      for (std::size_t inner = 0; inner < 3; ++inner)
        sum += a[3 * (k / 3) + inner] * b[3 * inner + k % 3];
      c[k] = static_cast<std::int8_t>(sum);
    }
    return c;
  };
  for (std::uint32_t a = 0; a < cube_order; ++a) {
    for (std::uint32_t b = 0; b < cube_order; ++b) {
      CHECK(cube_group.matrix[cube_group.product[a][b]] == product(cube_group.matrix[a], cube_group.matrix[b]));
    }
    CHECK(cube_group.product[a][cube_group.inverse[a]] == 0);
    CHECK(cube_group.product[cube_group.inverse[a]][a] == 0);
  }
}

TEST_CASE("The conjugacy classes are the orbits of conjugation, of 1, 3, 6, 6 and 8 elements, each with its angle") {
  const double pi = std::acos(-1.0);
  const double angle[] = {0, pi, pi / 2, pi, 2 * pi / 3};
  std::array<int, 5> size{};
  for (std::uint32_t a = 0; a < cube_order; ++a) {
    const auto which = cube_group.conjugacy_class[a];
    ++size[static_cast<std::size_t>(which)];
    CHECK(to_axis_angle(cube_group.element[a]).angle ==
          doctest::Approx(angle[static_cast<std::size_t>(which)]).epsilon(1e-15));
    std::set<std::uint32_t> orbit;
    for (std::uint32_t g = 0; g < cube_order; ++g)
      orbit.insert(cube_group.product[cube_group.product[g][a]][cube_group.inverse[g]]);
    for (std::uint32_t b = 0; b < cube_order; ++b)
      CHECK((orbit.count(b) == 1) == (cube_group.conjugacy_class[b] == which));
  }
  CHECK(size == std::array{1, 3, 6, 6, 8});
}

TEST_CASE("The nearest element is the one that a search over all 24 finds, of any length and sign") {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 20000; ++trial) {
    const Quaternion r = random_rotation(random);
    double best = 0;
    for (const Quaternion& g : cube_group.element)
      best = std::max(best, std::abs(dot(r, g)));
    const std::uint32_t nearest = nearest_cube_rotation(r);
    REQUIRE(nearest < cube_order);
    CHECK(std::abs(dot(r, cube_group.element[nearest])) >= best - 4 * ulp);
    CHECK(nearest_cube_rotation(-r) == nearest);
    CHECK(nearest_cube_rotation({8 * r.w, 8 * r.x, 8 * r.y, 8 * r.z}) == nearest);
  }
  for (std::uint32_t a = 0; a < cube_order; ++a)
    CHECK(nearest_cube_rotation(cube_group.element[a]) == a);
}

TEST_CASE("The distance of frames is the smallest angle over the group") {
  std::mt19937_64 random(12);
  const auto searched = [](const Quaternion& p, const Quaternion& q) {
    double least = 10;
    for (const Quaternion& g : cube_group.element) {
      const Quaternion r = multiply(relative(q, p), g);
      least = std::min(least, 2 * std::atan2(std::hypot(r.x, r.y, r.z), std::abs(r.w)));
    }
    return least;
  };
  for (int trial = 0; trial < 5000; ++trial) {
    const Quaternion p = random_rotation(random), q = random_rotation(random);
    const double distance = symmetric_distance(p, q);
    CHECK(std::abs(distance - searched(p, q)) < 8 * ulp);
    CHECK(distance < 62.8 * std::acos(-1.0) / 180);
    const double sine = std::sin(distance / 2);
    CHECK(std::abs(symmetric_sine_square(p, q) - sine * sine) < 4 * ulp);
    CHECK(symmetric_distance(p, p) == 0);
    CHECK(symmetric_distance(p, -p) == 0);
  }
  // Small distances keep their digits, near each of the 24.
  for (const double angle : {1e-12, 1e-7, 1e-3, 0.3}) {
    for (const Quaternion& g : cube_group.element) {
      const Quaternion p = random_rotation(random);
      const Quaternion q = multiply(multiply(p, from_axis_angle({1, -2, 0.5}, angle)), g);
      CHECK(std::abs(symmetric_distance(p, q) - angle) < 8 * ulp);
    }
  }
}

TEST_CASE("The farthest frames are 62.8 degrees apart") {
  // Equally near to elements of all three kinds: a1 = (a1 + a2) / sqrt 2 = (a1 + a2 + a3 + a4) / 2.
  const double root = std::sqrt(2.0);
  const Quaternion far{(2 + root) / 4, root / 4, root / 4, (2 - root) / 4};
  const double farthest = 2 * std::acos((2 + root) / 4);
  CHECK(std::abs(symmetric_distance({1, 0, 0, 0}, far) - farthest) < 8 * ulp);
  CHECK(farthest * 180 / std::acos(-1.0) == doctest::Approx(62.7994).epsilon(1e-6));
  std::mt19937_64 random(13);
  double largest = 0;
  for (int trial = 0; trial < 200000; ++trial)
    largest = std::max(largest, symmetric_distance({1, 0, 0, 0}, random_rotation(random)));
  CHECK(largest < farthest + 8 * ulp);
  CHECK(largest > 0.98 * farthest);
}

TEST_CASE("Equal frames and common rotations do not change distance; matchings compose with them") {
  std::mt19937_64 random(14);
  for (int trial = 0; trial < 200; ++trial) {
    const Quaternion p = random_rotation(random), q = random_rotation(random), r = random_rotation(random);
    const double distance = symmetric_distance(p, q);
    CHECK(std::abs(symmetric_distance(q, p) - distance) < 8 * ulp);
    CHECK(std::abs(symmetric_distance(multiply(r, p), multiply(r, q)) - distance) < 8 * ulp);
    const std::uint32_t g = symmetric_matching(p, q);
    const Quaternion matched = multiply(p, cube_group.element[g]);
    CHECK(std::abs(2 * std::acos(std::min(1.0, std::abs(dot(matched, q)))) - distance) < 1e-7);  // acos near 1
    CHECK(symmetric_matching(q, p) == cube_group.inverse[g]);
    for (std::uint32_t h = 0; h < cube_order; ++h) {
      const Quaternion other = multiply(p, cube_group.element[h]);
      CHECK(std::abs(symmetric_distance(other, q) - distance) < 8 * ulp);
      CHECK(cube_group.product[h][symmetric_matching(other, q)] == g);
    }
  }
}

TEST_CASE("Arrays of any length get the bits of one entry at a time") {
  std::mt19937_64 random(15);
  const std::size_t most = 67;
  std::vector<double> p, q, t, vectors;
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < 4 * most; ++i) {
    p.push_back(normal(random));
    q.push_back(normal(random));
    t.push_back(normal(random));
    vectors.push_back(normal(random));
  }
  p[12] = std::nan("");
  normalize(p.data(), most, p.data());
  normalize(q.data(), most, q.data());
  const auto at = [](const std::vector<double>& a, std::size_t i) {
    return Quaternion{a[4 * i], a[4 * i + 1], a[4 * i + 2], a[4 * i + 3]};
  };
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  const auto same_quaternion = [&](const Quaternion& a, const Quaternion& b) {
    return same(a.w, b.w) && same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
  };
  for (std::size_t count = 0; count <= most; ++count) {
    std::vector<double> distance(count), sine(count), product(4 * count), middle(4 * count), turned(3 * count),
        matrices(9 * count), back(4 * count);
    std::vector<std::uint8_t> matching(count), nearest(count);
    symmetric_distance(p.data(), q.data(), count, distance.data());
    symmetric_sine_square(p.data(), q.data(), count, sine.data());
    symmetric_matching(p.data(), q.data(), count, matching.data());
    nearest_cube_rotation(q.data(), count, nearest.data());
    multiply(p.data(), q.data(), count, product.data());
    slerp(p.data(), q.data(), t.data(), count, middle.data());
    rotate(q.data(), vectors.data(), count, turned.data());
    to_matrix(q.data(), count, matrices.data());
    from_matrix(matrices.data(), count, back.data());
    bool equal = true;
    for (std::size_t i = 0; i < count; ++i) {
      equal = equal && same(distance[i], symmetric_distance(at(p, i), at(q, i)));
      equal = equal && same(sine[i], symmetric_sine_square(at(p, i), at(q, i)));
      equal = equal && matching[i] == symmetric_matching(at(p, i), at(q, i));
      equal = equal && nearest[i] == nearest_cube_rotation(at(q, i));
      equal = equal && same_quaternion(at(product, i), multiply(at(p, i), at(q, i)));
      equal = equal && same_quaternion(at(middle, i), slerp(at(p, i), at(q, i), t[i]));
      const Vector v = rotate(at(q, i), {vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]});
      equal = equal && turned[3 * i] == v.x && turned[3 * i + 1] == v.y && turned[3 * i + 2] == v.z;
      equal = equal && apart(at(back, i), at(q, i)) < 4 * ulp;
    }
    CHECK(equal);
  }
  CHECK(std::isnan(symmetric_distance(at(p, 3), at(q, 3))));
}
