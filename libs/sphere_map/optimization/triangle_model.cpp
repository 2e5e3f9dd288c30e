#include "sphere_map/optimization/triangle_model.h"

namespace orbicube::sphere_map {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Bases = Eigen::Matrix<double, 3, 2>;  // two tangent vectors as columns

// What the distance d of the triangle from the origin adds to the gradient.
void add_distance(const SphericalTriangle& t, const EnergyPartials& e, const std::array<Bases, 3>& basis,
                  const std::array<Vector3, 3>& edge, TriangleModel& m) {
  const double d2 = t.inverse_d_square();
  const double factor = d2 * d2 * e.inside_d;
  const std::array<double, 3> square = {t.square_p, t.square_q, t.square_r};
  const double longest = std::max({square[0], square[1], square[2]});
  for (std::size_t c = 0; c < 3; ++c) {
    Vector3 g = Vector3::Zero();
    for (std::size_t k = 1; k < 3; ++k) {
      const std::size_t other = (c + k) % 3;  // its opposite edge ends at corner c
      const Vector3 square_gradient = (k == 1 ? -2 : 2) * edge[other];
      if (t.acute) {
        g += t.circumradius_square / square[other] * square_gradient;
      } else if (square[other] == longest) {
        g += 0.25 * square_gradient;
      }
    }
    if (t.acute) g -= t.circumradius_square / t.N * 2 * edge[c].cross(t.normal);
    m.gradient[c] += factor * (basis[c].transpose() * g);
  }
}

}  // namespace

TriangleModel triangle_model(const Energy& energy, const TriangleShape& shape, const std::array<Vector3, 3>& p) {
  const SphericalTriangle t(p[0], p[1], p[2]);
  const EnergyPartials e = energy_partials(energy, shape, t);
  const std::array<double, 3> cot = {shape.cot_p, shape.cot_q, shape.cot_r};
  const std::array<Vector3, 3> edge = {t.edge_p, t.edge_q, -t.edge_r};  // of each corner, the opposite one
  const Vector3& n = t.normal;
  const double by_det = 2 * t.determinant * e.by_M;
  const double by_det_det = 2 * e.by_M + 4 * t.determinant * t.determinant * e.by_MM;
  const double by_D_det = 2 * t.determinant * e.by_DM;

  TriangleModel m;
  m.value = e.value;
  std::array<Bases, 3> basis;
  std::array<Bases, 3> turn;  // derivative of the normal
  std::array<Vector2d, 3> D, det;
  std::array<double, 3> radial;
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const std::size_t last = (c + 2) % 3;
    const TangentBasis b(p[c]);
    basis[c].col(0) = b.first;
    basis[c].col(1) = b.second;
    turn[c].col(0) = b.first.cross(edge[c]);
    turn[c].col(1) = b.second.cross(edge[c]);
    const Vector3 gradient_D = 2 * cot[next] * (p[c] - p[last]) + 2 * cot[last] * (p[c] - p[next]);
    const Vector3 gradient_N = 2 * edge[c].cross(n);
    const Vector3 gradient_det = n - p[c].cross(edge[c]);
    const Vector3 gradient = e.by_D * gradient_D + e.by_N * gradient_N + by_det * gradient_det;
    D[c] = basis[c].transpose() * gradient_D;
    det[c] = basis[c].transpose() * gradient_det;
    m.gradient[c] = basis[c].transpose() * gradient;
    radial[c] = gradient.dot(p[c]);
  }
  // Second derivatives of value(D, N, det): the products of first derivatives, then what D, N and det have themselves.
  const auto products = [&](std::size_t i, std::size_t j) -> Matrix2d {
    const Vector2d of_D = e.by_DD * D[j] + by_D_det * det[j];
    const Vector2d of_det = by_det_det * det[j] + by_D_det * D[j];
    Matrix2d block = 2 * e.by_N * (turn[i].transpose() * turn[j]);
    block += D[i] * of_D.transpose() + det[i] * of_det.transpose();
    return block;
  };
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const std::size_t last = (c + 2) % 3;
    m.diagonal[c] = products(c, c);
    m.diagonal[c].diagonal().array() += 2 * e.by_D * (cot[next] + cot[last]) - radial[c];
    // Between this corner and the next: -2 cot of the third I, and the bilinear parts of N and det.
    const Vector3 w = 2 * e.by_N * n + by_det * p[last];
    m.next[c] = products(c, next) - 2 * e.by_D * cot[last] * (basis[c].transpose() * basis[next]);
    for (int a = 0; a < 2; ++a) {
      const Vector3 across = w.cross(basis[c].col(a));
      for (int k = 0; k < 2; ++k)
        m.next[c](a, k) += across.dot(basis[next].col(k));
    }
  }
  if (t.circumradius_square > 1e-6) add_distance(t, e, basis, edge, m);
  return m;
}

}  // namespace orbicube::sphere_map
