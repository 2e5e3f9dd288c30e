// A peer of untangle_triangles: the total content (TLC) of triangles in a space of more dimensions (Du, Aigerman, Zhou,
// Kovalsky, Yan, Kaufman and Ju 2020, ACM Transactions on Graphics 39(4), 120), whose global minima are injective for a
// small alpha, minimized by limited-memory BFGS with backtracking until every triangle is positive, as their program
// does.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <deque>
#include <utility>

#include "tests/untangle/flat_cases.h"

namespace orbicube::untangle::bench {

struct PeerResult {
  std::size_t inverted = 0, steps = 0;
};

class PeerContent {
 public:
  explicit PeerContent(const test::FlatCase& mesh) : mesh_(mesh) {
    x_ = Eigen::VectorXd(static_cast<Eigen::Index>(2 * mesh.start.size()));
    double area = 0;
    for (std::size_t v = 0; v < mesh.start.size(); ++v)
      x_.segment<2>(static_cast<Eigen::Index>(2 * v)) = mesh.start[v];
    for (const Triangle& t : mesh.triangles) {
      Eigen::Matrix<double, 3, 2> e;
      for (std::size_t k = 0; k < 2; ++k)
        e.col(static_cast<Eigen::Index>(k)) = mesh.rest[t[k + 1]] - mesh.rest[t[0]];
      rest_.push_back(e.transpose() * e);
      area += std::abs(edges(x_, t).determinant());
    }
    // Their alpha, 1e-6, is relative to the areas of target and image.
    double rest = 0;
    for (const Eigen::Matrix2d& g : rest_)
      rest += std::sqrt(g.determinant());
    for (Eigen::Matrix2d& g : rest_)
      g *= 1e-6 * area / rest;
  }

  PeerResult minimize(std::size_t max_steps) {
    PeerResult result{count_inverted(), 0};
    Eigen::VectorXd gradient, next_gradient;
    double value = evaluate(x_, gradient);
    std::deque<std::pair<Eigen::VectorXd, Eigen::VectorXd>> pairs;
    for (; result.inverted > 0 && result.steps < max_steps; ++result.steps) {
      Eigen::VectorXd direction = -direction_of(pairs, gradient);
      if (!(direction.dot(gradient) < 0)) pairs.clear(), direction = -gradient;
      double length = pairs.empty() ? 1 / std::max(direction.cwiseAbs().maxCoeff(), 1e-300) : 1, after = 0;
      Eigen::VectorXd next;
      for (int k = 0; k < 40; ++k, length *= 0.5) {
        next = x_ + length * direction;
        after = evaluate(next, next_gradient);
        if (after <= value + 1e-4 * length * direction.dot(gradient)) break;
      }
      if (!(after < value)) break;
      if ((next - x_).dot(next_gradient - gradient) > 0) pairs.emplace_back(next - x_, next_gradient - gradient);
      if (pairs.size() > 10) pairs.pop_front();
      x_ = next, gradient = next_gradient, value = after;
      result.inverted = count_inverted();
    }
    return result;
  }

 private:
  static Eigen::Matrix2d edges(const Eigen::VectorXd& x, const Triangle& t) {
    Eigen::Matrix2d e;
    for (std::size_t k = 0; k < 2; ++k) {
      e.col(static_cast<Eigen::Index>(k)) =
          x.segment<2>(static_cast<Eigen::Index>(2 * t[k + 1])) - x.segment<2>(static_cast<Eigen::Index>(2 * t[0]));
    }
    return e;
  }
  std::size_t count_inverted() const {
    std::size_t count = 0;
    for (const Triangle& t : mesh_.triangles)
      count += !(edges(x_, t).determinant() > 0);
    return count;
  }
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
    gradient = Eigen::VectorXd::Zero(x.size());
    double sum = 0;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Triangle& t = mesh_.triangles[i];
      const Eigen::Matrix2d e = edges(x, t), g = e.transpose() * e + rest_[i];
      const double content = 0.5 * std::sqrt(g.determinant());
      sum += content;
      const Eigen::Matrix2d slope = content * e * g.inverse();
      for (std::size_t k = 0; k < 2; ++k) {
        gradient.segment<2>(static_cast<Eigen::Index>(2 * t[k + 1])) += slope.col(static_cast<Eigen::Index>(k));
        gradient.segment<2>(static_cast<Eigen::Index>(2 * t[0])) -= slope.col(static_cast<Eigen::Index>(k));
      }
    }
    for (std::size_t i = 0; i < mesh_.fixed.size(); ++i)
      if (mesh_.fixed[i] != 0) gradient[static_cast<Eigen::Index>(i)] = 0;
    return sum;
  }
  static Eigen::VectorXd direction_of(const std::deque<std::pair<Eigen::VectorXd, Eigen::VectorXd>>& pairs,
                                      Eigen::VectorXd q) {
    std::vector<double> factor(pairs.size());
    for (std::size_t i = pairs.size(); i-- > 0;) {
      const auto& [s, y] = pairs[i];
      factor[i] = s.dot(q) / s.dot(y);
      q -= factor[i] * y;
    }
    if (!pairs.empty()) q *= pairs.back().first.dot(pairs.back().second) / pairs.back().second.squaredNorm();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [s, y] = pairs[i];
      q += (factor[i] - y.dot(q) / s.dot(y)) * s;
    }
    return q;
  }

  const test::FlatCase& mesh_;
  Eigen::VectorXd x_;
  std::vector<Eigen::Matrix2d> rest_;  // Gram matrices of target shapes, times alpha
};

}  // namespace orbicube::untangle::bench
