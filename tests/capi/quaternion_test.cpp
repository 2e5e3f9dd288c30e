// The C interface of quaternion: conventions as the header states them, arguments, and that nothing is allocated.
#include "orbicube/quaternion.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "failing_allocations.h"

using namespace orbicube;

namespace {

using Four = std::array<double, 4>;
using Nine = std::array<double, 9>;
constexpr double rounding = 1e-15;

bool close(const Four& a, const Four& b) {
  for (std::size_t k = 0; k < 4; ++k) {
    if (!(std::abs(a[k] - b[k]) < rounding)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("The functions keep the conventions that the header states") {
  const Four i{0, 1, 0, 0}, j{0, 0, 1, 0};
  Four out;
  obc_quaternion_multiply(i.data(), j.data(), out.data());
  CHECK(out == Four{0, 0, 0, 1});
  const double z[] = {0, 0, 2}, x[] = {1, 0, 0};
  double v[3];
  REQUIRE(obc_quaternion_from_axis_angle(z, std::acos(-1.0) / 2, out.data(), nullptr) == OBC_OK);
  obc_quaternion_rotate(out.data(), x, v);
  CHECK(std::abs(v[1] - 1) < rounding);  // counter-clockwise: x goes to y
  double axis[3], angle;
  obc_quaternion_to_axis_angle(out.data(), axis, &angle);
  CHECK(std::abs(angle - std::acos(0.0)) < rounding);
  CHECK(axis[2] == 1);
  Nine matrix;
  obc_quaternion_to_matrix(out.data(), matrix.data());
  CHECK(std::abs(matrix[3] - 1) < rounding);  // by rows: row y, column x
  Four back;
  REQUIRE(obc_quaternion_from_matrix(matrix.data(), back.data(), nullptr) == OBC_OK);
  CHECK(close(back, out));
  REQUIRE(obc_quaternion_nearest_to_matrix(matrix.data(), back.data(), nullptr) == OBC_OK);
  CHECK(close(back, out));
  obc_quaternion_to_rotation_vector(out.data(), v);
  CHECK(std::abs(v[2] - std::acos(0.0)) < rounding);
  obc_quaternion_from_rotation_vector(v, back.data());
  CHECK(close(back, out));
  Four logarithm;
  obc_quaternion_logarithm(out.data(), logarithm.data());
  CHECK(close(logarithm, {0, 0, 0, std::acos(0.0) / 2}));
  obc_quaternion_exponential(logarithm.data(), back.data());
  CHECK(close(back, out));
  const Four one{1, 0, 0, 0};
  obc_quaternion_slerp(one.data(), out.data(), 0.5, back.data());
  CHECK(close(back, {std::cos(std::acos(0.0) / 4), 0, 0, std::sin(std::acos(0.0) / 4)}));
  Four twice{2 * out[0], 0, 0, 2 * out[3]};
  obc_quaternion_inverse(twice.data(), back.data());
  CHECK(close(back, {out[0] / 2, 0, 0, -out[3] / 2}));
  obc_quaternion_normalize(twice.data(), twice.data());
  CHECK(close(twice, out));
  CHECK(obc_quaternion_version() >= 100);
}

TEST_CASE("The numbers of the cube's rotations are those of the header's list") {
  // The axis of each, as listed; and the angle in quarter turns or thirds.
  const double axis[24][3] = {{0, 0, 0},  {1, 0, 0},   {0, 1, 0},  {0, 0, 1},   {1, 0, 0},   {-1, 0, 0},
                              {0, 1, 0},  {0, -1, 0},  {0, 0, 1},  {0, 0, -1},  {1, 1, 0},   {1, -1, 0},
                              {1, 0, 1},  {1, 0, -1},  {0, 1, 1},  {0, 1, -1},  {1, 1, 1},   {-1, 1, 1},
                              {1, -1, 1}, {-1, -1, 1}, {1, 1, -1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, -1}};
  const double pi = std::acos(-1.0);
  const double angle[] = {0, pi, pi / 2, pi, 2 * pi / 3};
  for (std::uint32_t number = 0; number < 24; ++number) {
    Four element, listed{1, 0, 0, 0};
    REQUIRE(obc_quaternion_cube_element(number, element.data(), nullptr) == OBC_OK);
    const std::int32_t which = obc_quaternion_cube_class(number);
    if (number > 0) {
      REQUIRE(obc_quaternion_from_axis_angle(axis[number], angle[which], listed.data(), nullptr) == OBC_OK);
    }
    CHECK(close(element, listed));
    CHECK(obc_quaternion_cube_nearest(element.data()) == number);
    CHECK(obc_quaternion_cube_product(number, obc_quaternion_cube_inverse(number)) == 0);
    Nine exact, rounded;
    REQUIRE(obc_quaternion_cube_matrix(number, exact.data(), nullptr) == OBC_OK);
    obc_quaternion_to_matrix(element.data(), rounded.data());
    for (std::size_t k = 0; k < 9; ++k) {
      CHECK(std::abs(exact[k] - rounded[k]) < rounding);
      CHECK(exact[k] == std::round(exact[k]));
    }
  }
  CHECK(obc_quaternion_cube_class(0) == OBC_QUATERNION_IDENTITY);
  CHECK(obc_quaternion_cube_class(3) == OBC_QUATERNION_FACE_HALF);
  CHECK(obc_quaternion_cube_class(9) == OBC_QUATERNION_FACE_QUARTER);
  CHECK(obc_quaternion_cube_class(15) == OBC_QUATERNION_EDGE_HALF);
  CHECK(obc_quaternion_cube_class(23) == OBC_QUATERNION_CORNER_THIRD);
}

TEST_CASE("Numbers out of range and arguments that cannot be are refused") {
  Four out;
  obc_error error;
  CHECK(obc_quaternion_cube_element(24, out.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(error.message[0] != '\0');
  CHECK(obc_quaternion_cube_matrix(255, out.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_quaternion_cube_product(24, 0) == OBC_QUATERNION_CUBE_NONE);
  CHECK(obc_quaternion_cube_product(0, 4000000000U) == OBC_QUATERNION_CUBE_NONE);
  CHECK(obc_quaternion_cube_inverse(24) == OBC_QUATERNION_CUBE_NONE);
  CHECK(obc_quaternion_cube_class(24) == -1);
  CHECK(obc_quaternion_average(nullptr, nullptr, 1, out.data(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_quaternion_from_matrix(nullptr, out.data(), &error) == OBC_INVALID_ARGUMENT);
  const Nine mirror{1, 0, 0, 0, 1, 0, 0, 0, -1};
  CHECK(obc_quaternion_from_matrix(mirror.data(), out.data(), &error) == OBC_INVALID_ARGUMENT);
  const Nine reflection{-1, 0, 0, 0, -1, 0, 0, 0, -1};
  CHECK(obc_quaternion_nearest_to_matrix(reflection.data(), out.data(), &error) == OBC_NO_VALID_RESULT);
  const double zero[3] = {0, 0, 0};
  CHECK(obc_quaternion_from_axis_angle(zero, 1, out.data(), &error) == OBC_INVALID_ARGUMENT);
  const double opposite[] = {1, 0, 0, 0, 0, 1, 0, 0};
  CHECK(obc_quaternion_average(opposite, nullptr, 2, out.data(), nullptr, &error) == OBC_NO_VALID_RESULT);
  // The message of an array says which entry.
  std::array<double, 18> matrices{1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<double, 8> many;
  CHECK(obc_quaternion_from_matrix_array(matrices.data(), 2, many.data(), &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::strstr(error.message, "matrix 1") != nullptr);
}

TEST_CASE("Arrays agree with the functions for one, and nothing is allocated") {
  const std::size_t count = 1001;
  std::vector<double> p(4 * count), q(4 * count), t(count), v(3 * count), out(4 * count), turned(3 * count),
      matrices(9 * count), distance(count), sine(count), back(4 * count);
  std::vector<std::uint8_t> matching(count), nearest(count);
  for (std::size_t k = 0; k < 4 * count; ++k) {
    p[k] = std::sin(1.0 + 3.0 * static_cast<double>(k));
    q[k] = std::cos(2.0 + 5.0 * static_cast<double>(k * k % 1013));
    t[k / 4] = std::sin(static_cast<double>(k));
    v[3 * k / 4] = std::cos(static_cast<double>(k));
  }
  const std::size_t before = test::allocation_count();
  obc_quaternion_normalize_array(p.data(), count, p.data());
  obc_quaternion_normalize_array(q.data(), count, q.data());
  obc_quaternion_symmetric_distance_array(p.data(), q.data(), count, distance.data());
  obc_quaternion_symmetric_sine_square_array(p.data(), q.data(), count, sine.data());
  obc_quaternion_symmetric_matching_array(p.data(), q.data(), count, matching.data());
  obc_quaternion_cube_nearest_array(p.data(), count, nearest.data());
  obc_quaternion_rotate_array(q.data(), v.data(), count, turned.data());
  obc_quaternion_to_matrix_array(q.data(), count, matrices.data());
  const obc_status status = obc_quaternion_from_matrix_array(matrices.data(), count, back.data(), nullptr);
  obc_quaternion_slerp_array(p.data(), q.data(), t.data(), count, out.data());
  Four mean;
  double agreement;
  const obc_status averaged = obc_quaternion_average(p.data(), nullptr, count, mean.data(), &agreement, nullptr);
  CHECK(test::allocation_count() == before);
  CHECK(status == OBC_OK);
  CHECK(averaged == OBC_OK);
  CHECK(agreement > 0.25);  // the largest eigenvalue of a matrix with trace 1
  CHECK(agreement <= 1);
  bool same = true;
  for (std::size_t i = 0; i < count; ++i) {
    const double *a = &p[4 * i], *b = &q[4 * i];
    Four one;
    double w[3];
    same = same && distance[i] == obc_quaternion_symmetric_distance(a, b);
    same = same && sine[i] == obc_quaternion_symmetric_sine_square(a, b);
    same = same && matching[i] == obc_quaternion_symmetric_matching(a, b);
    same = same && nearest[i] == obc_quaternion_cube_nearest(a);
    obc_quaternion_rotate(b, &v[3 * i], w);
    same = same && std::memcmp(w, &turned[3 * i], sizeof w) == 0;
    obc_quaternion_slerp(a, b, t[i], one.data());
    same = same && std::memcmp(one.data(), &out[4 * i], sizeof one) == 0;
    // The same rotation after the matrix, of either sign.
    const double along = back[4 * i] * b[0] + back[4 * i + 1] * b[1] + back[4 * i + 2] * b[2] + back[4 * i + 3] * b[3];
    same = same && std::abs(std::abs(along) - 1) < 1e-14;
  }
  CHECK(same);
  obc_quaternion_multiply_array(p.data(), q.data(), count, p.data());  // in place
  obc_quaternion_symmetric_distance_array(p.data(), q.data(), 0, nullptr);
}

TEST_CASE("Functions without a status do nothing where a pointer is NULL") {
  const Four q{1, 0, 0, 0};
  Four out{7, 7, 7, 7};
  const double* const none = nullptr;
  obc_quaternion_multiply(q.data(), none, out.data());
  obc_quaternion_multiply(q.data(), q.data(), nullptr);
  obc_quaternion_rotate(none, q.data(), out.data());
  obc_quaternion_slerp(none, q.data(), 0.5, out.data());
  obc_quaternion_to_matrix(none, out.data());
  obc_quaternion_multiply_array(none, none, SIZE_MAX, out.data());
  obc_quaternion_slerp_array(q.data(), q.data(), none, SIZE_MAX, out.data());
  obc_quaternion_cube_nearest_array(q.data(), SIZE_MAX, nullptr);
  CHECK(out == Four{7, 7, 7, 7});
  CHECK(std::isnan(obc_quaternion_symmetric_distance(q.data(), none)));
  CHECK(std::isnan(obc_quaternion_symmetric_sine_square(none, q.data())));
  CHECK(obc_quaternion_symmetric_matching(q.data(), none) == OBC_QUATERNION_CUBE_NONE);
  CHECK(obc_quaternion_cube_nearest(none) == OBC_QUATERNION_CUBE_NONE);
}
