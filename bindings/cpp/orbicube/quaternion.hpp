// Unit quaternions, rotations and the 24 rotations of the cube; wraps orbicube/quaternion.h.
#ifndef ORBICUBE_QUATERNION_HPP
#define ORBICUBE_QUATERNION_HPP

#include <array>

#include <orbicube/quaternion.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace quaternion {

using Quaternion = std::array<double, 4>;  // w x y z
using Vector = std::array<double, 3>;
using Matrix = std::array<double, 9>;  // by rows

namespace detail {
using namespace orbicube::detail;
template <class Out, class F, class... In>
Out made(F&& f, const In&... in) {
  Out out{};
  f(in.data()..., out.data());
  return out;
}
template <class Out, class F>
Out checked(F&& f) {
  Out out{};
  call(nullptr, [&](obc_error* error) { return f(out.data(), error); });
  return out;
}
inline std::uint32_t numbered(std::uint32_t number) {
  if (number >= OBC_QUATERNION_CUBE_ORDER)
    throw Error(OBC_INVALID_ARGUMENT, "the cube's rotations have the numbers 0 to 23");
  return number;
}
}  // namespace detail

inline Quaternion multiply(const Quaternion& p, const Quaternion& q) {  // turns by q first
  return detail::made<Quaternion>(obc_quaternion_multiply, p, q);
}
inline Quaternion inverse(const Quaternion& q) {
  return detail::made<Quaternion>(obc_quaternion_inverse, q);
}
inline Quaternion normalize(const Quaternion& q) {
  return detail::made<Quaternion>(obc_quaternion_normalize, q);
}
inline Quaternion exponential(const Quaternion& q) {
  return detail::made<Quaternion>(obc_quaternion_exponential, q);
}
inline Quaternion logarithm(const Quaternion& q) {
  return detail::made<Quaternion>(obc_quaternion_logarithm, q);
}
inline Vector rotate(const Quaternion& q, const Vector& v) {
  return detail::made<Vector>(obc_quaternion_rotate, q, v);
}
inline Quaternion from_rotation_vector(const Vector& v) {
  return detail::made<Quaternion>(obc_quaternion_from_rotation_vector, v);
}
inline Vector to_rotation_vector(const Quaternion& q) {
  return detail::made<Vector>(obc_quaternion_to_rotation_vector, q);
}
inline Matrix to_matrix(const Quaternion& q) {
  return detail::made<Matrix>(obc_quaternion_to_matrix, q);
}

inline Quaternion slerp(const Quaternion& p, const Quaternion& q, double t) {
  Quaternion out;
  obc_quaternion_slerp(p.data(), q.data(), t, out.data());
  return out;
}
inline Quaternion from_axis_angle(const Vector& axis, double angle) {
  return detail::checked<Quaternion>(
      [&](double* out, obc_error* error) { return obc_quaternion_from_axis_angle(axis.data(), angle, out, error); });
}
inline std::pair<Vector, double> to_axis_angle(const Quaternion& q) {
  std::pair<Vector, double> out;
  obc_quaternion_to_axis_angle(q.data(), out.first.data(), &out.second);
  return out;
}
inline Quaternion from_matrix(const Matrix& matrix) {
  return detail::checked<Quaternion>(
      [&](double* out, obc_error* error) { return obc_quaternion_from_matrix(matrix.data(), out, error); });
}
inline Quaternion nearest_to_matrix(const Matrix& matrix) {
  return detail::checked<Quaternion>(
      [&](double* out, obc_error* error) { return obc_quaternion_nearest_to_matrix(matrix.data(), out, error); });
}
// The mean rotation, and how much they agree (1: all). weights: one each, or none.
inline std::pair<Quaternion, double> average(View<const Quaternion> q, Doubles weights = {}) {
  if (!weights.empty()) detail::check_size(weights.size(), q.size(), "weights");
  std::pair<Quaternion, double> out{};
  detail::call(nullptr, [&](obc_error* error) {
    return obc_quaternion_average(q.empty() ? nullptr : q.data()->data(), weights.data(), q.size(), out.first.data(),
                                  &out.second, error);
  });
  return out;
}

inline Quaternion cube_element(std::uint32_t number) {
  return detail::checked<Quaternion>(
      [&](double* out, obc_error* error) { return obc_quaternion_cube_element(number, out, error); });
}
inline Matrix cube_matrix(std::uint32_t number) {
  return detail::checked<Matrix>(
      [&](double* out, obc_error* error) { return obc_quaternion_cube_matrix(number, out, error); });
}
// The number of a b, b first; of the inverse; OBC_QUATERNION_IDENTITY, ... Throw when a number is 24 or more.
inline std::uint32_t cube_product(std::uint32_t a, std::uint32_t b) {
  return detail::numbered(obc_quaternion_cube_product(a, b));
}
inline std::uint32_t cube_inverse(std::uint32_t a) {
  return detail::numbered(obc_quaternion_cube_inverse(a));
}
inline std::int32_t cube_class(std::uint32_t number) {
  detail::numbered(number);
  return obc_quaternion_cube_class(number);
}
inline std::uint32_t cube_nearest(const Quaternion& r) {
  return obc_quaternion_cube_nearest(r.data());
}

// Between frames: up to the 24 rotations of the cube.
inline double symmetric_distance(const Quaternion& p, const Quaternion& q) {
  return obc_quaternion_symmetric_distance(p.data(), q.data());
}
// sin^2 of half of the distance.
inline double symmetric_sine_square(const Quaternion& p, const Quaternion& q) {
  return obc_quaternion_symmetric_sine_square(p.data(), q.data());
}
inline std::uint32_t symmetric_matching(const Quaternion& from, const Quaternion& to) {
  return obc_quaternion_symmetric_matching(from.data(), to.data());
}

}  // namespace quaternion
}  // namespace api
}  // namespace orbicube

#endif
