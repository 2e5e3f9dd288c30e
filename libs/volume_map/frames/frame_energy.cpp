#include "volume_map/frames/frame_energy.h"

#include <Eigen/Dense>
#include <cmath>

#include "base/error.h"

namespace orbicube::volume_map {
namespace {

// Gradients of the four barycentric coordinates, by row, and the volume.
double shape_of(const std::array<Vector3, 4>& p, Eigen::Matrix<double, 4, 3>& gradients) {
  Eigen::Matrix3d edges;
  edges << p[1] - p[0], p[2] - p[0], p[3] - p[0];
  gradients.bottomRows<3>() = edges.inverse();
  gradients.row(0) = -gradients.bottomRows<3>().colwise().sum();
  return edges.determinant() / 6;
}

}  // namespace

Eigen::Matrix3d matrix_of(const quaternion::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}

double frame_energy(const std::array<Vector3, 4>& corners, const Eigen::Matrix3d& frame, double cell_length,
                    const Eigen::Matrix<double, 4, 3>& coordinates, Eigen::Matrix<double, 4, 3>* derivative) {
  Eigen::Matrix<double, 4, 3> gradients;
  const double volume = shape_of(corners, gradients);
  const Eigen::Matrix3d rest = gradients.transpose() * coordinates - frame / cell_length;  // a column a coordinate
  if (derivative != nullptr) *derivative = 2 * volume * gradients * rest;
  return volume * rest.squaredNorm();
}

// What the energy of one tetrahedron depends on: for each corner a coordinate's free variable (or -1), sign and
// integers.
struct FrameEnergy::Corners {
  std::array<int, 4> variable{};
  std::array<double, 4> sign{};
  std::array<std::span<const IntegerTerm>, 4> terms;
};

void FrameEnergy::add(const Corners& corners, const Eigen::Matrix4d& square, const Eigen::Vector4d& target,
                      linear::SparseSystem::Triplets& mixed, Eigen::VectorXd& integer_right) {
  const auto& [variable, sign, terms] = corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    if (variable[k] >= 0) right_[variable[k]] += sign[k] * target[row];
    for (const IntegerTerm& term : terms[k])
      integer_right[term.unknown] += term.factor * target[row];
    for (std::size_t l = 0; l < 4; ++l) {
      const double entry = square(row, static_cast<Eigen::Index>(l));
      if (variable[k] >= 0 && variable[l] >= 0 && variable[k] >= variable[l])
        triplets_.emplace_back(variable[k], variable[l], sign[k] * sign[l] * entry);
      if (variable[k] >= 0) {
        for (const IntegerTerm& term : terms[l])
          mixed.emplace_back(variable[k], static_cast<int>(term.unknown), sign[k] * term.factor * entry);
      }
      for (const IntegerTerm& x : terms[k]) {
        for (const IntegerTerm& y : terms[l])
          curvature_(x.unknown, y.unknown) += x.factor * y.factor * entry;
      }
    }
  }
}

FrameEnergy::FrameEnergy(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                         const FrameCut& cut, const SeamlessSystem& system, double cell_length, const base::Host& host)
    : system_(system), triplets_(host.memory) {
  const auto free = static_cast<Eigen::Index>(system.variables), whole = static_cast<Eigen::Index>(system.integers);
  right_ = Eigen::VectorXd::Zero(free);
  Eigen::VectorXd integer_right = Eigen::VectorXd::Zero(whole);
  curvature_ = Eigen::MatrixXd::Zero(whole, whole);
  linear::SparseSystem::Triplets mixed(host.memory);
  double diagonal = 0;
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    if (t % 1024 == 0) host.report("parameterise", t, tetrahedra.size());
    std::array<Vector3, 4> p;
    for (std::size_t k = 0; k < 4; ++k)
      p[k] = positions[tetrahedra[t][k]];
    Eigen::Matrix<double, 4, 3> gradients;
    const double volume = shape_of(p, gradients);
    const Eigen::Matrix4d square = volume * gradients * gradients.transpose();
    const Eigen::Matrix<double, 4, 3> target = volume / cell_length * gradients * matrix_of(cut.frames[t]);
    for (Eigen::Index a = 0; a < 3; ++a) {
      Corners corners;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t i = 3 * std::size_t{cut.copies[t][k]} + static_cast<std::size_t>(a);
        corners.variable[k] = system.variable[i] == no_index ? -1 : static_cast<int>(system.variable[i]);
        corners.sign[k] = system.sign[i];
        corners.terms[k] = system.forms.terms(system.form[i]);
      }
      add(corners, square, target.col(a), mixed, integer_right);
      diagonal += square.trace();
    }
  }
  // A coordinate that nothing holds, as that along a ring, stays where it is.
  const double little = 1e-10 * diagonal / static_cast<double>(12 * tetrahedra.size());
  for (int i = 0; i < static_cast<int>(free); ++i)
    triplets_.emplace_back(i, i, little);
  mixed_.resize(free, whole);
  mixed_.setFromTriplets(mixed.begin(), mixed.end());
  host.report("factorise", 0, 0);
  solver_.emplace(system.variables, triplets_);
  triplets_.clear();
  if (!solver_->factorize())
    throw base::Error("degenerate-geometry", "the system of the parameterisation cannot be factorized");
  for (Eigen::Index j = 0; j < whole; ++j) {
    host.report("parameterise", static_cast<std::uint64_t>(j), static_cast<std::uint64_t>(whole));
    if (free == 0) break;
    const Eigen::VectorXd column = solver_->solve(Eigen::VectorXd(mixed_.col(j)));
    curvature_.col(j) -= mixed_.transpose() * column;
    integer_right[j] -= column.dot(right_);
  }
  curvature_ = (0.5 * (curvature_ + curvature_.transpose())).eval();
  // Where the whole lies is nobody's business.
  shift_ = 1e-6 * std::max(curvature_.trace(), little) / static_cast<double>(whole + 1);
  curvature_.diagonal().array() += shift_;
  best_ = curvature_.ldlt().solve(integer_right);
}

Eigen::VectorXd FrameEnergy::minimum() const {
  // Iterative refinement, which leaves alone the directions that have no energy.
  constexpr int max_steps = 50;
  const Eigen::LDLT<Eigen::MatrixXd> factor = curvature_.ldlt();
  const Eigen::VectorXd right = curvature_ * best_;
  Eigen::VectorXd c = best_;
  for (int step = 0; step < max_steps; ++step) {
    const Eigen::VectorXd next = factor.solve(right + shift_ * c);
    const double change = (next - c).norm();
    c = next;
    if (change <= 1e-14 * c.norm()) break;
  }
  return c;
}

Eigen::VectorXd FrameEnergy::free_variables(const Eigen::VectorXd& integers) const {
  if (system_.variables == 0) return {};
  return solver_->solve(right_ - mixed_ * integers);
}

void expand(const SeamlessSystem& system, const Eigen::VectorXd& free, const Eigen::VectorXd& integers,
            std::span<double> coordinates) {
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    double sum = system.variable[i] == no_index ? 0 : system.sign[i] * free[system.variable[i]];
    for (const IntegerTerm& term : system.forms.terms(system.form[i]))
      sum += term.factor * integers[term.unknown];
    coordinates[i] = sum;
  }
}

}  // namespace orbicube::volume_map
