#include "sphere_map/newton.h"

#include <Eigen/Geometry>
#include <cmath>

namespace orbicube::sphere_map {
namespace {

using Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix36 = Eigen::Matrix<double, 3, 6>;

// A triangle of the level by places, with its three edges: edges[i] joins corners i and i + 1.
struct LevelTriangle {
  std::array<Index, 3> corner;
  std::array<Index, 3> edge;
  TriangleShape shape;
};

// Symmetric, with a 2 x 2 block for each vertex and each edge: block(low, high) in tangent coordinates.
struct BlockMatrix {
  explicit BlockMatrix(std::pmr::memory_resource* memory) : diagonal(memory), off_diagonal(memory), ends(memory) {}

  void multiply(std::span<const Vector2d> x, std::span<Vector2d> y) const {
    for (std::size_t i = 0; i < diagonal.size(); ++i)
      y[i] = diagonal[i] * x[i];
    for (std::size_t e = 0; e < ends.size(); ++e) {
      const auto [low, high] = ends[e];
      y[low] += off_diagonal[e] * x[high];
      y[high] += off_diagonal[e].transpose() * x[low];
    }
  }

  Array<Matrix2> diagonal;
  Array<Matrix2> off_diagonal;
  Array<std::array<Index, 2>> ends;
};

// A triangle's energy and its derivatives in the tangent coordinates of its corners, two each. The curvature of the
// sphere takes the radial derivative g . p of each corner off the diagonal.
struct TriangleModel {
  double value;
  Vector6 gradient;
  Matrix6 hessian;
};

double dot(std::span<const Vector2d> a, std::span<const Vector2d> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i].dot(b[i]);
  return sum;
}

class Newton {
 public:
  Newton(const Energy& energy, const Level& level, std::span<const Index> place, std::span<Vector3> directions,
         const base::Host& host)
      : energy_(energy),
        level_(level),
        host_(host),
        directions_(directions),
        points_(level.vertices.size(), host.memory),
        trial_(level.vertices.size(), host.memory),
        triangles_(host.memory),
        matrix_(host.memory),
        gradient_(level.vertices.size(), host.memory),
        step_(level.vertices.size(), host.memory) {
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[i] = directions[level.vertices[i]];
    build(place);
  }

  double run(const NewtonLimits& limits) {
    double value = assemble();
    for (int step = 0; step < limits.steps; ++step) {
      solve(limits.solver_steps);
      const double reached = search(value);
      if (!(reached < value)) break;
      const bool done = value - reached < limits.relative_gain * value;
      value = reached;
      if (done || step + 1 == limits.steps) break;
      assemble();
    }
    for (std::size_t i = 0; i < points_.size(); ++i)
      directions_[level_.vertices[i]] = points_[i];
    return value;
  }

 private:
  // Edges are numbered where the star of their lower place meets them.
  void build(std::span<const Index> place) {
    const std::size_t count = level_.vertices.size();
    Array<Index> first(count + 1, 0, host_.memory);
    triangles_.reserve(2 * count);
    matrix_.ends.reserve(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
      first[i] = static_cast<Index>(matrix_.ends.size());
      for (const StarTriangle& s : level_.star(i)) {
        if (i < place[s.q]) matrix_.ends.push_back({static_cast<Index>(i), place[s.q]});
      }
    }
    first[count] = static_cast<Index>(matrix_.ends.size());
    const auto edge = [&](Index a, Index b) {
      if (a > b) std::swap(a, b);
      Index e = first[a];
      while (matrix_.ends[e][1] != b)
        ++e;
      return e;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 16384 == 0) host_.report("final optimisation", 0, 0);
      for (const StarTriangle& s : level_.star(i)) {
        const Index a = static_cast<Index>(i);
        const Index b = place[s.q];
        const Index c = place[s.r];
        if (a < b && a < c) triangles_.push_back({{a, b, c}, {edge(a, b), edge(b, c), edge(c, a)}, s.shape});
      }
    }
    matrix_.diagonal.resize(count);
    matrix_.off_diagonal.resize(matrix_.ends.size());
  }

  // The energy with its gradient and Hessian at points_.
  double assemble() {
    std::fill(matrix_.diagonal.begin(), matrix_.diagonal.end(), Matrix2::Zero());
    std::fill(matrix_.off_diagonal.begin(), matrix_.off_diagonal.end(), Matrix2::Zero());
    std::fill(gradient_.begin(), gradient_.end(), Vector2d::Zero());
    double value = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const LevelTriangle& triangle = triangles_[t];
      const TriangleModel m = model(triangle);
      value += m.value;
      for (int i = 0; i < 3; ++i) {
        const auto corner = static_cast<std::size_t>(i);
        gradient_[triangle.corner[corner]] += m.gradient.segment<2>(2 * i);
        matrix_.diagonal[triangle.corner[corner]] += m.hessian.block<2, 2>(2 * i, 2 * i);
        const int j = (i + 1) % 3;
        const bool ascending = triangle.corner[corner] < triangle.corner[(corner + 1) % 3];
        matrix_.off_diagonal[triangle.edge[corner]] +=
            ascending ? m.hessian.block<2, 2>(2 * i, 2 * j) : m.hessian.block<2, 2>(2 * j, 2 * i);
      }
      if (t % 4096 == 0) host_.report("final optimisation", 0, 0, value);
    }
    return value;
  }

  TriangleModel model(const LevelTriangle& triangle) const {
    const std::array<Vector3, 3> p = {points_[triangle.corner[0]], points_[triangle.corner[1]],
                                      points_[triangle.corner[2]]};
    const TriangleShape& shape = triangle.shape;
    const SphericalTriangle t(p[0], p[1], p[2]);
    const EnergyPartials e = energy_partials(energy_, shape, t);
    const std::array<double, 3> cot = {shape.cot_p, shape.cot_q, shape.cot_r};
    const std::array<Vector3, 3> edge = {t.edge_p, t.edge_q, -t.edge_r};  // of each corner, the opposite one
    const Vector3& n = t.normal;
    const double by_det = 2 * t.determinant * e.by_M;

    Eigen::Matrix<double, 3, 2> basis[3];
    Vector6 D, N, det;
    Matrix36 J;  // derivative of the normal
    TriangleModel m;
    m.value = e.value;
    std::array<double, 3> radial;
    for (int i = 0; i < 3; ++i) {
      const auto c = static_cast<std::size_t>(i);
      const std::size_t next = (c + 1) % 3;
      const std::size_t last = (c + 2) % 3;
      const TangentBasis b(p[c]);
      basis[i].col(0) = b.first;
      basis[i].col(1) = b.second;
      const Vector3 gradient_D = 2 * cot[next] * (p[c] - p[last]) + 2 * cot[last] * (p[c] - p[next]);
      const Vector3 gradient_N = 2 * edge[c].cross(n);
      const Vector3 gradient_det = n - p[c].cross(edge[c]);
      D.segment<2>(2 * i) = basis[i].transpose() * gradient_D;
      N.segment<2>(2 * i) = basis[i].transpose() * gradient_N;
      det.segment<2>(2 * i) = basis[i].transpose() * gradient_det;
      J.col(2 * i) = b.first.cross(edge[c]);
      J.col(2 * i + 1) = b.second.cross(edge[c]);
      radial[c] = (e.by_D * gradient_D + e.by_N * gradient_N + by_det * gradient_det).dot(p[c]);
    }
    const Vector6 M = 2 * t.determinant * det;
    m.gradient = e.by_D * D + e.by_N * N + e.by_M * M;
    m.hessian.noalias() = 2 * e.by_N * (J.transpose() * J);
    m.hessian += 2 * e.by_M * det * det.transpose() + e.by_DD * D * D.transpose() + e.by_MM * M * M.transpose() +
                 e.by_DM * (D * M.transpose() + M * D.transpose());
    for (int i = 0; i < 3; ++i) {
      const auto c = static_cast<std::size_t>(i);
      const std::size_t next = (c + 1) % 3;
      const std::size_t last = (c + 2) % 3;
      const int j = (i + 1) % 3;
      m.hessian.block<2, 2>(2 * i, 2 * i) += (2 * e.by_D * (cot[next] + cot[last]) - radial[c]) * Matrix2::Identity();
      // Between this corner and the next: -2 cot of the third I, and the bilinear parts of N and det.
      const Vector3 w = 2 * e.by_N * n + by_det * p[last];
      Matrix2 block = -2 * e.by_D * cot[last] * basis[i].transpose() * basis[j];
      for (int a = 0; a < 2; ++a) {
        for (int k = 0; k < 2; ++k)
          block(a, k) += w.dot(basis[i].col(a).cross(basis[j].col(k)));
      }
      m.hessian.block<2, 2>(2 * i, 2 * j) += block;
      m.hessian.block<2, 2>(2 * j, 2 * i) += block.transpose();
    }
    if (t.circumradius_square > 1e-6) add_distance(t, e, basis, edge, n, m);
    return m;
  }

  // What the distance d of the triangle from the origin adds to the gradient.
  void add_distance(const SphericalTriangle& t, const EnergyPartials& e, const Eigen::Matrix<double, 3, 2> (&basis)[3],
                    const std::array<Vector3, 3>& edge, const Vector3& n, TriangleModel& m) const {
    const double d2 = t.inverse_d_square();
    const double factor = d2 * d2 * e.inside_d;
    const std::array<double, 3> square = {t.square_p, t.square_q, t.square_r};
    const double longest = std::max({square[0], square[1], square[2]});
    for (int i = 0; i < 3; ++i) {
      const auto c = static_cast<std::size_t>(i);
      Vector3 g = Vector3::Zero();
      for (int k = 1; k < 3; ++k) {
        const std::size_t other = (c + static_cast<std::size_t>(k)) % 3;  // its opposite edge ends at corner c
        const Vector3 square_gradient = (k == 1 ? -2 : 2) * edge[other];
        if (t.acute) {
          g += t.circumradius_square / square[other] * square_gradient;
        } else if (square[other] == longest) {
          g += 0.25 * square_gradient;
        }
      }
      if (t.acute) g -= t.circumradius_square / t.N * 2 * edge[c].cross(n);
      m.gradient.segment<2>(2 * i) += factor * (basis[i].transpose() * g);
    }
  }

  void solve(int most_steps) {
    constexpr double tolerance = 0.03;
    const std::size_t count = points_.size();
    Array<Matrix2> inverse(count, host_.memory);
    for (std::size_t i = 0; i < count; ++i) {
      const Matrix2& d = matrix_.diagonal[i];
      // Made positive, as the step of a single vertex is.
      const double mean = 0.5 * d.trace();
      const double spread = std::hypot(0.5 * (d(0, 0) - d(1, 1)), d(0, 1));
      const double least = std::max(1e-3 * (std::abs(mean) + spread), std::numeric_limits<double>::min());
      const double shift = std::max(0.0, least - (mean - spread));
      inverse[i] = (d + shift * Matrix2::Identity()).inverse();
    }
    Array<Vector2d> residual(count, host_.memory), preconditioned(count, host_.memory), along(count, host_.memory),
        product(count, host_.memory);
    for (std::size_t i = 0; i < count; ++i) {
      step_[i].setZero();
      residual[i] = -gradient_[i];
      preconditioned[i] = inverse[i] * residual[i];
      along[i] = preconditioned[i];
    }
    double rz = dot(residual, preconditioned);
    const double goal = tolerance * tolerance * rz;
    for (int k = 0; k < most_steps && rz > goal; ++k) {
      matrix_.multiply(along, product);
      const double curvature = dot(along, product);
      if (!(curvature > 0)) {
        if (k == 0) step_.assign(along.begin(), along.end());
        return;
      }
      const double alpha = rz / curvature;
      for (std::size_t i = 0; i < count; ++i) {
        step_[i] += alpha * along[i];
        residual[i] -= alpha * product[i];
        preconditioned[i] = inverse[i] * residual[i];
      }
      const double next = dot(residual, preconditioned);
      const double beta = next / rz;
      rz = next;
      for (std::size_t i = 0; i < count; ++i)
        along[i] = preconditioned[i] + beta * along[i];
      host_.report("final optimisation", static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(most_steps));
    }
  }

  // Halves the step until it lowers the energy enough and all triangles are safely positive. Answers the energy
  // reached.
  double search(double value) {
    const double slope = dot(gradient_, step_);
    if (!(slope < 0)) return value;
    double length = 1;
    for (int attempt = 0; attempt < 12; ++attempt, length *= 0.5) {
      for (std::size_t i = 0; i < points_.size(); ++i) {
        const TangentBasis basis(points_[i]);
        const Vector2d s = length * step_[i];
        trial_[i] = (points_[i] + s.x() * basis.first + s.y() * basis.second).normalized();
      }
      double reached = 0;
      for (std::size_t t = 0; t < triangles_.size() && reached < value; ++t) {
        if (t % 65536 == 0) host_.report("final optimisation", 0, 0, value);
        const auto& [a, b, c] = triangles_[t].corner;
        if (!safely_positive(trial_[a], trial_[b], trial_[c])) {
          reached = std::numeric_limits<double>::infinity();
        } else {
          reached += triangle_energy(energy_, triangles_[t].shape, SphericalTriangle(trial_[a], trial_[b], trial_[c]));
        }
      }
      host_.report("final optimisation", 0, 0, value);
      if (reached <= value + 1e-4 * length * slope) {
        std::swap(points_, trial_);
        return reached;
      }
    }
    return value;
  }

  const Energy& energy_;
  const Level& level_;
  const base::Host& host_;
  std::span<Vector3> directions_;
  Array<Vector3> points_, trial_;
  Array<LevelTriangle> triangles_;
  BlockMatrix matrix_;
  Array<Vector2d> gradient_, step_;
};

}  // namespace

double newton(const Energy& energy, const Level& level, const NewtonLimits& limits, std::span<const Index> place,
              std::span<Vector3> directions, const base::Host& host) {
  return Newton(energy, level, place, directions, host).run(limits);
}

}  // namespace orbicube::sphere_map
