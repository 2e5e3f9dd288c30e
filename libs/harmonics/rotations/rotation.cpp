#include "harmonics/rotations/rotation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "harmonics/rotations/wigner.h"

namespace orbicube::harmonics {
namespace {

// R = Rz(alpha) Ry(beta) Rz(gamma).
struct EulerAngles {
  double alpha = 0, beta = 0, gamma = 0;
};

Matrix3 about_z(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

EulerAngles euler_angles(const Matrix3& r) {
  EulerAngles angles;
  const double flat = std::hypot(r(0, 2), r(1, 2));
  angles.beta = std::atan2(flat, r(2, 2));
  angles.alpha = flat > 0 ? std::atan2(r(1, 2), r(0, 2)) : 0;
  // What is left, so that the product is right also where alpha and gamma alone are not determined.
  const Matrix3 rest = Eigen::AngleAxisd(-angles.beta, Eigen::Vector3d::UnitY()) * (about_z(-angles.alpha) * r);
  angles.gamma = std::atan2(rest(1, 0), rest(0, 0));
  return angles;
}

void turn_about_z(Coefficients& g, double angle) {
  for (std::uint32_t m = 1; m <= g.degree; ++m) {
    const double c = std::cos(m * angle), s = std::sin(m * angle);
    const auto order = static_cast<std::int32_t>(m);
    for (std::uint32_t l = m; l <= g.degree; ++l) {
      for (std::size_t k = 0; k < g.channels; ++k) {
        double& cosine = g.at(l, order, k);
        double& sine = g.at(l, -order, k);
        const double turned = c * cosine - s * sine;
        sine = s * cosine + c * sine;
        cosine = turned;
      }
    }
  }
}

}  // namespace

Coefficients rotate(const Coefficients& g, const Matrix3& rotation, const base::Host& host) {
  constexpr double tolerance = 1e-9;
  if (!((rotation * rotation.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < tolerance) ||
      !(rotation.determinant() > 0))
    throw base::Error("invalid-argument", "the matrix is no rotation");
  const EulerAngles angles = euler_angles(rotation);
  Coefficients turned(g.degree, g.channels, host.memory);
  turned.values = g.values;
  turn_about_z(turned, angles.gamma);
  Coefficients result(g.degree, g.channels, host.memory);
  Array<double> even(g.degree + std::size_t{1}, host.memory), odd(g.degree + std::size_t{1}, host.memory);
  for (std::uint32_t m = 0; m <= g.degree; ++m) {
    host.report("rotating", m, g.degree + std::uint64_t{1});
    for (std::uint32_t n = 0; n <= m; ++n) {
      rotation_about_y(angles.beta, m, n, g.degree, even.data(), odd.data());
      const double sign = (m + n) % 2 == 0 ? 1 : -1;  // of the transposed entries
      const auto i = static_cast<std::int32_t>(m), j = static_cast<std::int32_t>(n);
      for (std::uint32_t l = m; l <= g.degree; ++l) {
        for (std::size_t k = 0; k < g.channels; ++k) {
          result.at(l, i, k) += even[l - m] * turned.at(l, j, k);
          if (n > 0) result.at(l, -i, k) += odd[l - m] * turned.at(l, -j, k);
          if (n == m) continue;
          result.at(l, j, k) += sign * even[l - m] * turned.at(l, i, k);
          if (n > 0) result.at(l, -j, k) += sign * odd[l - m] * turned.at(l, -i, k);
        }
      }
    }
  }
  turn_about_z(result, angles.alpha);
  return result;
}

void rotate_values(Coefficients& g, const Matrix3& rotation) {
  for (std::size_t k = 0; k + 3 <= g.values.size(); k += 3) {
    Eigen::Map<Eigen::Vector3d> value(g.values.data() + k);
    value = (rotation * value).eval();
  }
}

}  // namespace orbicube::harmonics
