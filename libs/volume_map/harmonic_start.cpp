#include "volume_map/harmonic_start.h"

#include <algorithm>

namespace orbicube::volume_map {

void make_harmonic(std::span<const Element> elements, std::span<const std::uint8_t> held, std::span<Vector3> positions,
                   const base::Host& host) {
  constexpr int most_iterations = 1000;
  constexpr double tolerance = 1e-8;
  const std::size_t count = positions.size();
  Array<double> diagonal(count, 0, host.memory);
  for (const Element& e : elements) {
    for (std::size_t k = 0; k < 4; ++k)
      diagonal[e.corner[k]] += e.weight * e.gradient[k].squaredNorm();
  }
  const auto multiply = [&](std::span<const Vector3> x, std::span<Vector3> y) {
    std::fill(y.begin(), y.end(), Vector3::Zero());
    for (std::size_t i = 0; i < elements.size(); ++i) {
      if (i % 16384 == 0) host.report("start", 0, 0);
      const Element& e = elements[i];
      const Eigen::Matrix3d j = e.weight * e.jacobian(x);
      for (std::size_t k = 0; k < 4; ++k)
        y[e.corner[k]].noalias() += j * e.gradient[k];
    }
    for (std::size_t v = 0; v < count; ++v) {
      if (held[v] != 0) y[v].setZero();
    }
  };
  Array<Vector3> residual(count, host.memory), preconditioned(count, host.memory), search(count, host.memory),
      product(count, host.memory);
  multiply(positions, residual);
  double rz = 0;
  for (std::size_t v = 0; v < count; ++v) {
    residual[v] = -residual[v];
    preconditioned[v] = residual[v] / std::max(diagonal[v], 1e-300);
    rz += residual[v].dot(preconditioned[v]);
  }
  search = preconditioned;
  const double enough = tolerance * tolerance * rz;
  for (int k = 0; k < most_iterations && rz > enough; ++k) {
    multiply(search, product);
    double curvature = 0;
    for (std::size_t v = 0; v < count; ++v)
      curvature += search[v].dot(product[v]);
    if (!(curvature > 0)) break;
    const double length = rz / curvature;
    double next = 0;
    for (std::size_t v = 0; v < count; ++v) {
      positions[v] += length * search[v];
      residual[v] -= length * product[v];
      preconditioned[v] = residual[v] / std::max(diagonal[v], 1e-300);
      next += residual[v].dot(preconditioned[v]);
    }
    for (std::size_t v = 0; v < count; ++v)
      search[v] = preconditioned[v] + next / rz * search[v];
    rz = next;
  }
}

}  // namespace orbicube::volume_map
