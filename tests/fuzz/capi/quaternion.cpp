// The C functions of quaternions on any numbers.
#include "orbicube/quaternion.h"
#include "entries.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  const std::size_t n = in.below(6);
  const auto p = in.numbers(4 * n + 4), q = in.numbers(4 * n + 4), v = in.numbers(9 * n + 9), t = in.numbers(n + 1);
  std::vector<double> out(9 * n + 9);
  std::vector<std::uint8_t> elements(n + 1);
  double agreement = 0, axis[3], angle;

  obc_quaternion_multiply(p.data(), q.data(), out.data());
  obc_quaternion_inverse(q.data(), out.data());
  obc_quaternion_normalize(q.data(), out.data());
  obc_quaternion_exponential(q.data(), out.data());
  obc_quaternion_logarithm(q.data(), out.data());
  obc_quaternion_slerp(p.data(), q.data(), t[0], out.data());
  obc_quaternion_rotate(q.data(), v.data(), out.data());
  obc_quaternion_to_axis_angle(q.data(), axis, &angle);
  obc_quaternion_from_rotation_vector(v.data(), out.data());
  obc_quaternion_to_rotation_vector(q.data(), out.data());
  obc_quaternion_to_matrix(q.data(), out.data());
  if (ok([&](obc_error* e) {
        return obc_quaternion_average(q.data(), in.one_in(2) ? t.data() : nullptr, n, out.data(), &agreement, e);
      }))
    require_finite({out.data(), 4}, "a mean that is not finite");
  if (ok([&](obc_error* e) { return obc_quaternion_from_axis_angle(v.data(), t[0], out.data(), e); }))
    require_finite({out.data(), 4}, "a rotation that is not finite");
  if (ok([&](obc_error* e) { return obc_quaternion_from_matrix(v.data(), out.data(), e); }))
    require_finite({out.data(), 4}, "a quaternion that is not finite");
  if (ok([&](obc_error* e) { return obc_quaternion_nearest_to_matrix(v.data(), out.data(), e); }))
    require_finite({out.data(), 4}, "a nearest rotation that is not finite");

  const std::uint32_t a = in.index(24), b = in.index(24);
  const bool are = a < 24 && b < 24;
  require(ok([&](obc_error* e) { return obc_quaternion_cube_element(a, out.data(), e); }) == (a < 24),
          "a number of no element");
  require(ok([&](obc_error* e) { return obc_quaternion_cube_matrix(a, out.data(), e); }) == (a < 24),
          "a number of no matrix");
  require((obc_quaternion_cube_product(a, b) < 24) == are, "a product of no elements");
  require((obc_quaternion_cube_inverse(a) < 24) == (a < 24), "an inverse of no element");
  obc_quaternion_cube_class(a);
  require(obc_quaternion_cube_nearest(q.data()) < 24, "no element is nearest");
  require(obc_quaternion_symmetric_matching(p.data(), q.data()) < 24, "no matching");
  obc_quaternion_symmetric_distance(p.data(), q.data());
  obc_quaternion_symmetric_sine_square(p.data(), q.data());

  obc_quaternion_multiply_array(p.data(), q.data(), n, out.data());
  obc_quaternion_normalize_array(q.data(), n, out.data());
  obc_quaternion_rotate_array(q.data(), v.data(), n, out.data());
  obc_quaternion_slerp_array(p.data(), q.data(), t.data(), n, out.data());
  obc_quaternion_to_matrix_array(q.data(), n, out.data());
  ok([&](obc_error* e) { return obc_quaternion_from_matrix_array(v.data(), n, out.data(), e); });
  obc_quaternion_symmetric_distance_array(p.data(), q.data(), n, out.data());
  obc_quaternion_symmetric_sine_square_array(p.data(), q.data(), n, out.data());
  obc_quaternion_symmetric_matching_array(p.data(), q.data(), n, elements.data());
  obc_quaternion_cube_nearest_array(q.data(), n, elements.data());
  for (std::size_t i = 0; i < n; ++i)
    require(elements[i] < 24, "no element of an array is nearest");
  return 0;
}
