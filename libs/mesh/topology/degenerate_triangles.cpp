#include "mesh/topology/degenerate_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace orbicube::mesh {
namespace {

// Whether the last 29 of the 53 digits are zero.
bool has_float_digits(double x) {
  constexpr std::uint64_t beyond_float = (std::uint64_t{1} << 29U) - 1;
  return (std::bit_cast<std::uint64_t>(x) & beyond_float) == 0;
}

bool has_float_digits(const Vector3& p) {
  return has_float_digits(p.x()) && has_float_digits(p.y()) && has_float_digits(p.z());
}

constexpr double float_rounding = 0x1p-24, double_rounding = 0x1p-53;

// Of edges whose squares neither overflow nor vanish.
bool is_flat(const Vector3& pq, const Vector3& pr, double min_height) {
  const double longest_square = std::max({pq.squaredNorm(), pr.squaredNorm(), (pr - pq).squaredNorm()});
  const double twice_area = pq.cross(pr).norm();
  return twice_area <= degenerate_height_ratio * longest_square || twice_area <= min_height * std::sqrt(longest_square);
}

}  // namespace

double rounding_unit(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      if (!has_float_digits(positions[v])) return double_rounding;
    }
  }
  return float_rounding;
}

double rounding_unit(std::span<const Vector3> positions) {
  const bool all =
      std::all_of(positions.begin(), positions.end(), [](const Vector3& p) { return has_float_digits(p); });
  return all ? float_rounding : double_rounding;
}

bool is_degenerate(const Vector3& p, const Vector3& q, const Vector3& r, double rounding) {
  // Halves, since differences can overflow.
  const Vector3 pq = 0.5 * q - 0.5 * p, pr = 0.5 * r - 0.5 * p;
  const double size = std::max(pq.cwiseAbs().maxCoeff(), pr.cwiseAbs().maxCoeff());
  if (!(size > 0)) return true;
  const double farthest = std::max({p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), r.cwiseAbs().maxCoeff()});
  const double min_height = degenerate_height_roundings * rounding * (0.5 * farthest);
  constexpr double smallest = 1e-70, largest = 1e70;
  if (size > smallest && size < largest) return is_flat(pq, pr, min_height);
  const int exponent = -std::ilogb(size);
  const auto scaled = [&](double x) { return std::scalbn(x, exponent); };
  return is_flat(pq.unaryExpr(scaled), pr.unaryExpr(scaled), scaled(min_height));
}

std::size_t count_degenerate(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  const double rounding = rounding_unit(positions, triangles);
  return static_cast<std::size_t>(std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return is_degenerate(positions[t[0]], positions[t[1]], positions[t[2]], rounding);
  }));
}

}  // namespace orbicube::mesh
