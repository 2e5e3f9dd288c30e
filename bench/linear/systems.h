// Sparse symmetric systems on the edges of meshes and grids, for the benchmarks of this folder.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "linear/symmetric_matrix.h"

namespace orbicube::bench {

using linear::Index;

using Edges = std::vector<std::pair<Index, Index>>;  // the larger vertex first, sorted

struct System {
  std::string name;
  int block = 1;
  std::vector<std::size_t> row_begin{0};
  std::vector<Index> columns;
  std::vector<double> values;

  linear::SymmetricMatrix view() const { return {row_begin, columns, values}; }
};

// Blocks of size 1 or 3 on the edges of a mesh; block_of(i, j) is that of an edge, subtracted off the diagonal and
// added to that of both ends. `fixed`, where it is not empty, is added to the diagonal of each vertex: edges to
// vertices that are fixed.
inline System system_of(const std::string& name, int block, std::size_t vertices, const Edges& edges,
                        const std::function<Eigen::Matrix3d(Index, Index)>& block_of,
                        const std::vector<double>& fixed = {}) {
  constexpr double mass = 1e-6;
  std::vector<Eigen::Matrix3d> diagonal(vertices, Eigen::Matrix3d::Zero());
  for (std::size_t v = 0; v < fixed.size(); ++v)
    diagonal[v] = fixed[v] * Eigen::Matrix3d::Identity();
  for (const auto& [i, j] : edges) {
    const Eigen::Matrix3d b = block_of(i, j);
    diagonal[i] += b;
    diagonal[j] += b;
  }
  System system;
  system.name = name;
  system.block = block;
  auto edge = edges.begin();
  for (Index v = 0; v < vertices; ++v) {
    auto last = edge;
    while (last != edges.end() && last->first == v)
      ++last;
    for (int r = 0; r < block; ++r) {
      for (auto e = edge; e != last; ++e) {
        const Eigen::Matrix3d b = block_of(v, e->second);
        for (int c = 0; c < block; ++c) {
          system.columns.push_back(static_cast<Index>(block) * e->second + static_cast<Index>(c));
          system.values.push_back(-b(r, c));
        }
      }
      for (int c = 0; c <= r; ++c) {
        system.columns.push_back(static_cast<Index>(block) * v + static_cast<Index>(c));
        const double d = diagonal[v](r, c);
        system.values.push_back(r == c ? (d > 0 ? d * (1 + mass) : 1) : d);
      }
      system.row_begin.push_back(system.columns.size());
    }
    edge = last;
  }
  return system;
}

// Returns |b - A x| / |b|.
inline double residual_of(const System& system, const std::vector<double>& right, const std::vector<double>& x) {
  std::vector<double> image(right.size());
  system.view().multiply(x, image);
  double above = 0, below = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    above += (right[i] - image[i]) * (right[i] - image[i]);
    below += right[i] * right[i];
  }
  return std::sqrt(above / below);
}

// Returns entries from -1 to 1, the same for every run.
inline std::vector<double> random_right(const System& system) {
  std::vector<double> right(system.row_begin.size() - 1);
  std::uint64_t state = 1;
  for (double& entry : right) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    entry = static_cast<double>(state >> 11) / 4503599627370496.0 - 1;
  }
  return right;
}

}  // namespace orbicube::bench
