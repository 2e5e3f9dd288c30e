// The filters evaluate determinants of differences and accept a sign when it stands clear of the rounding error. What
// they leave open is computed in integers of any length: every finite double is an integer times a power of two.
#include "mesh/search/predicates.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace orbicube::mesh {
namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr double unit_roundoff = 0x1p-53;
constexpr int undecided = 2;

int sign(double x) {
  return (x > 0) - (x < 0);
}

// Sign of p . (e x f) when it is certain, whatever p, e, f are within a relative rounding error a coordinate each.
//
// Each of the six terms p_i e_j f_k carries at most three roundings of its factors, one of e_j f_k, one of the
// subtraction, one of the product with p_i and two of the sums: its relative error is below (1 + u)^8 - 1 < 8.1 u,
// where u is 2^-53. The terms' absolute values add up to `magnitude`, computed with a relative error below 8.1 u too,
// so that 12 u magnitude is beyond the error of the determinant, as far as nothing underflows. An underflow adds at
// most 2^-1074 to each of the products e_j f_k, hence 2^-1073 |p_i| to the sum, and 2^-1074 to each product with p_i:
// both are covered by `tiny` many times over. After an overflow `magnitude` is no number below infinity, and nothing is
// certain.
int certain_sign(const Vector3& p, const Vector3& e, const Vector3& f) {
  const double yz = e.y() * f.z(), zy = e.z() * f.y();
  const double zx = e.z() * f.x(), xz = e.x() * f.z();
  const double xy = e.x() * f.y(), yx = e.y() * f.x();
  const double determinant = p.x() * (yz - zy) + p.y() * (zx - xz) + p.z() * (xy - yx);
  const double magnitude = std::abs(p.x()) * (std::abs(yz) + std::abs(zy)) +
                           std::abs(p.y()) * (std::abs(zx) + std::abs(xz)) +
                           std::abs(p.z()) * (std::abs(xy) + std::abs(yx));
  const double tiny = 0x1p-1000 * (1 + std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()));
  if (std::abs(determinant) > 12 * unit_roundoff * magnitude + tiny &&
      magnitude < std::numeric_limits<double>::infinity())
    return sign(determinant);
  // Differences of doubles are 0 only when they are equal, so a row or a column of zeros is exactly one: equal points,
  // and points in one plane along two axes.
  for (int k = 0; k < 3; ++k) {
    if (p[k] == 0 && e[k] == 0 && f[k] == 0) return 0;
  }
  return e.isZero(0) || f.isZero(0) ? 0 : undecided;
}

// The exponent of the last bit of a finite x, or a large number for 0.
int last_exponent(double x) {
  if (x == 0) return std::numeric_limits<int>::max();
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent - 53;
}

// x * 2^-exponent, which is an integer for exponent <= last_exponent(x).
Integer scaled(double x, int exponent) {
  if (x == 0) return 0;
  int own = 0;
  const double mantissa = std::frexp(x, &own);
  Integer result(static_cast<long long>(std::ldexp(mantissa, 53)));
  result <<= own - 53 - exponent;
  return result;
}

// Points as integers, all times one power of two: signs of determinants stay what they are.
template <int dimension, std::size_t count>
auto integers(const std::array<const Eigen::Matrix<double, dimension, 1>*, count>& points) {
  int exponent = std::numeric_limits<int>::max();
  for (const auto* point : points) {
    for (const double x : *point) {
      if (!std::isfinite(x)) throw base::Error("no-valid-result", "a coordinate has overflowed: it is not finite");
      exponent = std::min(exponent, last_exponent(x));
    }
  }
  std::array<std::array<Integer, dimension>, count> result;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < dimension; ++k)
      result[i][k] = scaled((*points[i])[static_cast<int>(k)], exponent);
  }
  return result;
}

using IntegerVector = std::array<Integer, 3>;

int determinant_sign(const IntegerVector& p, const IntegerVector& q, const IntegerVector& r) {
  const Integer determinant =
      p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  return determinant.sign();
}

}  // namespace

int orientation_from_origin(const Vector3& p, const Vector3& q, const Vector3& r) {
  const int found = certain_sign(p, q - p, r - p);
  if (found != undecided) return found;
  const auto x = integers<3, 3>({&p, &q, &r});
  return determinant_sign(x[0], x[1], x[2]);
}

int orientation_3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const int found = certain_sign(b - a, c - a, d - a);
  if (found != undecided) return found;
  auto x = integers<3, 4>({&a, &b, &c, &d});
  for (std::size_t i = 1; i < 4; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      x[i][k] -= x[0][k];
  }
  return determinant_sign(x[1], x[2], x[3]);
}

int orientation_2d(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  // Two differences, a product and a subtraction: a relative error of each term below 4.1 u.
  const Eigen::Vector2d e = b - a;
  const Eigen::Vector2d f = c - a;
  const double left = e.x() * f.y();
  const double right = e.y() * f.x();
  const double magnitude = std::abs(left) + std::abs(right);
  if (std::abs(left - right) > 6 * unit_roundoff * magnitude + 0x1p-1000 &&
      magnitude < std::numeric_limits<double>::infinity()) {
    return sign(left - right);
  }
  // As above: points on one line along an axis.
  if ((e.x() == 0 && f.x() == 0) || (e.y() == 0 && f.y() == 0)) return 0;
  const auto x = integers<2, 3>({&a, &b, &c});
  const Integer exact = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
  return exact.sign();
}

}  // namespace orbicube::mesh
