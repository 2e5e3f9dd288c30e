#include "polycube/dissertation/harmonic_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "polycube/surface/surface.h"

namespace orbicube::polycube::dissertation {
namespace {

constexpr const char* harmonic_system_phase = "harmonic maps";
// Of the harmonic equations, relative to the largest value: what an updated factor may lose before it is made again.
constexpr double max_residual = 1e-9;

linear::DirectMethod method() {
  return linear::has_cholmod() ? linear::DirectMethod::cholmod_simplicial : linear::DirectMethod::eigen;
}

}  // namespace

Array<double> half_edge_weights(const EditableSurface& surface, const base::Host& host) {
  Array<double> result(3 * surface.faces(), host.memory);
  for (Index h = 0; h < result.size(); ++h) {
    const Index apex = surface.start(EditableSurface::previous(h));
    result[h] =
        cotangent(surface.position[apex], surface.position[surface.start(h)], surface.position[surface.end(h)]) / 2;
  }
  return result;
}

template <class Visit>
void HarmonicSystem::for_each_neighbor(Index v, const Visit& visit) const {
  surface_.for_each_outgoing(v, [&](Index h) { visit(surface_.end(h), weights_[h] + weights_[surface_.opposite(h)]); });
}

HarmonicSystem::HarmonicSystem(const EditableSurface& surface, std::span<const double> weights, const base::Host& host)
    : surface_(surface),
      weights_(weights),
      host_(host),
      factor_(linear::make_direct_factor(method())),
      fixed_(surface.vertices(), 1, host.memory),
      right_(3 * surface.vertices(), host.memory) {
  linear::Triplets triplets(host.memory);
  for (Index v = 0; v < surface.vertices(); ++v) {
    triplets.emplace_back(v, v, 1.0);
    for_each_neighbor(v, [&](Index w, double) {
      if (w < v) triplets.emplace_back(v, w, 0.0);
    });
  }
  const auto size = static_cast<Eigen::Index>(surface.vertices());
  matrix_.resize(size, size);
  matrix_.setFromTriplets(triplets.begin(), triplets.end());
  factor_->analyze(matrix_);
}

double HarmonicSystem::diagonal(Index v) const {
  double sum = 0;
  for_each_neighbor(v, [&](Index, double weight) { sum += weight; });
  return sum;
}

bool HarmonicSystem::fix(std::span<const std::uint8_t> fixed, bool may_update) {
  host_.report(harmonic_system_phase, 0, 0);
  std::size_t changed = 0;
  for (std::size_t v = 0; v < fixed.size(); ++v)
    changed += fixed[v] != fixed_[v];
  if (ready_ && changed == 0) return true;
  const bool few = static_cast<double>(changed) <= max_changed_part * static_cast<double>(fixed.size());
  if (ready_ && may_update && few) {
    bool positive = true;
    for (Index v = 0; v < fixed.size() && positive; ++v) {
      if (fixed[v] == fixed_[v]) continue;
      if (fixed[v] != 0)
        remove(v);
      else
        positive = add(v);
    }
    updated_ = true;
    if (positive) return true;
  }
  std::copy(fixed.begin(), fixed.end(), fixed_.begin());
  return factorize();
}

bool HarmonicSystem::factorize() {
  ++counts_.factorizations;
  updated_ = false;
  for (Index column = 0; column < fixed_.size(); ++column) {
    for (linear::SparseMatrix::InnerIterator entry(matrix_, static_cast<Eigen::Index>(column)); entry; ++entry)
      entry.valueRef() = 0;
  }
  for (Index v = 0; v < fixed_.size(); ++v) {
    matrix_.coeffRef(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(v)) = fixed_[v] != 0 ? 1 : diagonal(v);
    if (fixed_[v] != 0) continue;
    for_each_neighbor(v, [&](Index w, double weight) {
      if (w < v && fixed_[w] == 0)
        matrix_.coeffRef(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(w)) = -weight;
    });
  }
  ready_ = factor_->factorize(matrix_) && factor_->is_positive();
  return ready_;
}

void HarmonicSystem::remove(Index v) {
  fixed_[v] = 1;
  factor_->remove_row(v);
  ++counts_.rows_removed;
}

// What increases the matrix comes first, so that it is positive definite at each step.
bool HarmonicSystem::add(Index v) {
  fixed_[v] = 0;
  ++counts_.rows_added;
  std::vector<std::pair<Index, double>> free;
  double own = diagonal(v) - 1;
  for_each_neighbor(v, [&](Index w, double weight) {
    if (fixed_[w] != 0 || weight == 0) return;
    free.emplace_back(w, weight);
    own -= weight;
  });
  bool positive = true;
  const auto single = [&](Index row, double amount, int sign) {
    if (amount * sign > 0)
      positive = factor_->update(std::array{row}, std::array{std::sqrt(std::abs(amount))}, sign) && positive;
  };
  for (const int sign : {1, -1}) {
    single(v, own, sign);
    for (const auto& [w, weight] : free) {
      const double root = std::sqrt(std::abs(weight));
      if (weight * sign > 0) positive = factor_->update(std::array{v, w}, std::array{root, -root}, sign) && positive;
      single(w, -weight, sign);
    }
  }
  return positive;
}

double HarmonicSystem::residual(std::span<const Vector3> values) const {
  double most = 0;
  for (Index v = 0; v < fixed_.size(); ++v) {
    if (fixed_[v] != 0) continue;
    Vector3 sum = Vector3::Zero();
    double size = 0;
    for_each_neighbor(v, [&](Index w, double weight) {
      sum += weight * (values[v] - values[w]);
      size += std::abs(weight) * (values[v].cwiseAbs().maxCoeff() + values[w].cwiseAbs().maxCoeff());
    });
    if (size > 0) most = std::max(most, sum.cwiseAbs().maxCoeff() / size);
  }
  return most;
}

bool HarmonicSystem::solve(std::span<Vector3> values) {
  const std::size_t n = fixed_.size();
  for (int attempt = 0;; ++attempt) {
    ++counts_.solves;
    for (Index v = 0; v < n; ++v) {
      Vector3 right = Vector3::Zero();
      if (fixed_[v] != 0) {
        right = values[v];
      } else {
        for_each_neighbor(v, [&](Index w, double weight) {
          if (fixed_[w] != 0) right += weight * values[w];
        });
      }
      for (std::size_t k = 0; k < 3; ++k)
        right_[k * n + v] = right[static_cast<Eigen::Index>(k)];
    }
    factor_->solve(right_, 3, right_);
    bool finite = true;
    for (Index v = 0; v < n; ++v) {
      if (fixed_[v] != 0) continue;
      values[v] = {right_[v], right_[n + v], right_[2 * n + v]};
      finite = finite && values[v].allFinite();
    }
    if (finite && (!updated_ || residual(values) <= max_residual)) return true;
    if (!updated_ || attempt > 0 || !factorize()) return false;
  }
}

}  // namespace orbicube::polycube::dissertation
