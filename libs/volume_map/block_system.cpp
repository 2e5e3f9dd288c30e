#include "volume_map/block_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace orbicube::volume_map {

BlockSystem::BlockSystem(std::span<const Element> elements, std::span<const std::uint8_t> active,
                         const base::Host& host)
    : host_(host),
      row_begin_(active.size() + 1, 0, host.memory),
      column_(host.memory),
      place_(6 * elements.size(), no_index, host.memory),
      diagonal_(active.size(), Eigen::Matrix3d::Identity(), host.memory),
      inverse_(diagonal_, host.memory),
      lower_(host.memory),
      residual_(active.size(), Vector3::Zero(), host.memory),
      search_(residual_, host.memory),
      image_(residual_, host.memory),
      product_(residual_, host.memory) {
  const std::size_t vertices = active.size();
  // Lower neighbours of each vertex with repetitions, then without.
  Array<std::size_t> begin(vertices + 1, 0, host.memory);
  const auto for_pairs = [&](const Element& e, const auto& visit) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = 0; l < k; ++l) {
        const Index v = e.corner[k], w = e.corner[l];
        if (active[v] != 0 && active[w] != 0) visit(std::max(v, w), std::min(v, w), pair[k][l]);
      }
    }
  };
  for (const Element& e : elements)
    for_pairs(e, [&](Index row, Index, std::size_t) { ++begin[row + 1]; });
  for (std::size_t v = 0; v < vertices; ++v)
    begin[v + 1] += begin[v];
  Array<Index> all(begin[vertices], host.memory);
  Array<std::size_t> next(begin, host.memory);
  for (const Element& e : elements)
    for_pairs(e, [&](Index row, Index column, std::size_t) { all[next[row]++] = column; });
  for (std::size_t v = 0; v < vertices; ++v) {
    if (v % 4096 == 0) host.report("matrix", v, vertices);
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin[v]);
    auto last = all.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
    std::sort(first, last);
    last = std::unique(first, last);
    column_.insert(column_.end(), first, last);
    row_begin_[v + 1] = static_cast<Index>(column_.size());
  }
  lower_.assign(column_.size(), Eigen::Matrix3d::Zero());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for_pairs(elements[i], [&](Index row, Index column, std::size_t which) {
      const auto first = column_.begin() + static_cast<std::ptrdiff_t>(row_begin_[row]);
      const auto last = column_.begin() + static_cast<std::ptrdiff_t>(row_begin_[row + 1]);
      place_[6 * i + which] = static_cast<Index>(std::lower_bound(first, last, column) - column_.begin());
    });
  }
}

void BlockSystem::factor() {
  for (std::size_t v = 0; v < diagonal_.size(); ++v) {
    Eigen::Matrix3d& block = diagonal_[v];
    // Of size 1, or determinants may leave the range of double.
    const double size = block.trace();
    const double scale = size > 0 && std::isfinite(size) ? size : 1;
    for (const double added : {1e-9, 1e-6, 1.0}) {
      block.diagonal().array() += added * scale;
      inverse_[v] = Eigen::Matrix3d(block / scale).inverse() / scale;
      if (inverse_[v].allFinite()) break;
    }
    if (!inverse_[v].allFinite()) inverse_[v].setZero();
  }
}

void BlockSystem::forward(std::span<Vector3> x) const {
  for (std::size_t v = 0; v < x.size(); ++v) {
    Vector3 sum = x[v];
    for (Index i = row_begin_[v]; i < row_begin_[v + 1]; ++i)
      sum.noalias() -= lower_[i] * x[column_[i]];
    x[v].noalias() = inverse_[v] * sum;
  }
}

void BlockSystem::backward(std::span<Vector3> x) const {
  for (std::size_t v = x.size(); v-- > 0;) {
    const Vector3 here = inverse_[v] * x[v];
    x[v] = here;
    for (Index i = row_begin_[v]; i < row_begin_[v + 1]; ++i)
      x[column_[i]].noalias() -= lower_[i].transpose() * here;
  }
}

void BlockSystem::solve(std::span<const Vector3> right, int most_steps, double tolerance, std::span<Vector3> solution) {
  // With A = L + D + L' and u = (D + L') x the system is (D + L)^-1 A (D + L')^-1 u = (D + L)^-1 b, preconditioned by
  // D.
  const std::size_t count = right.size();
  residual_.assign(right.begin(), right.end());
  forward(residual_);
  std::fill(solution.begin(), solution.end(), Vector3::Zero());
  double rz = 0;
  for (std::size_t v = 0; v < count; ++v) {
    search_[v].noalias() = diagonal_[v] * residual_[v];
    rz += residual_[v].dot(search_[v]);
  }
  const double enough = tolerance * tolerance * rz;
  for (int k = 0; k < most_steps && rz > enough; ++k) {
    host_.report("solve", 0, 0);
    image_ = search_;
    backward(image_);
    for (std::size_t v = 0; v < count; ++v)
      product_[v].noalias() = search_[v] - diagonal_[v] * image_[v];
    forward(product_);
    double curvature = 0;
    for (std::size_t v = 0; v < count; ++v) {
      product_[v] += image_[v];
      curvature += search_[v].dot(product_[v]);
    }
    if (!(curvature > 0) || !std::isfinite(curvature)) break;
    const double length = rz / curvature;
    double next = 0;
    for (std::size_t v = 0; v < count; ++v) {
      solution[v] += length * image_[v];
      residual_[v] -= length * product_[v];
      next += residual_[v].dot(diagonal_[v] * residual_[v]);
    }
    const double beta = next / rz;
    rz = next;
    for (std::size_t v = 0; v < count; ++v)
      search_[v] = diagonal_[v] * residual_[v] + beta * search_[v];
  }
}

}  // namespace orbicube::volume_map
