#include "repair/holes/fairing.h"

#include <algorithm>

#include "base/grouping.h"
#include "linear/sparse_system.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::repair {
namespace {

struct Neighbor {
  Index point;    // of the patch, or no_index
  Vector3 place;  // where it is not one of the patch
  double weight;
};

using Neighbors = base::Groups<Neighbor>;

Neighbors neighbors_of(const Patch& patch, std::span<const OuterEdge> outside, const base::Host& host) {
  const mesh::EdgeTable edges(patch.points.size(), patch.triangles, host);
  const auto inverse = [](double length) { return length > 0 ? 1 / length : 0; };
  const auto for_each = [&](const auto& visit) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const Index h = edges.half_edges(e)[0];
      const Index a = mesh::start_of(patch.triangles, h), b = mesh::end_of(patch.triangles, h);
      const double w = inverse((patch.points[b] - patch.points[a]).norm());
      visit(a, Neighbor{b, patch.points[b], w});
      visit(b, Neighbor{a, patch.points[a], w});
    }
    for (const OuterEdge& edge : outside)
      visit(edge.from, Neighbor{no_index, edge.to, inverse((edge.to - patch.points[edge.from]).norm())});
  };
  Neighbors neighbors(patch.points.size(), for_each, host.memory);
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    double sum = 0;
    for (const Neighbor& n : neighbors[v])
      sum += n.weight;
    for (Neighbor& n : neighbors[v])
      n.weight = sum > 0 ? n.weight / sum : 0;
  }
  return neighbors;
}

}  // namespace

bool fair(Patch& patch, std::span<const OuterEdge> outside, const base::Host& host) {
  const std::size_t fixed = patch.loop_size, n = patch.points.size() - fixed;
  if (n == 0) return true;
  const Neighbors neighbors = neighbors_of(patch, outside, host);
  linear::Triplets triplets(host.memory);
  // Relative to a point of the loop, so that a patch far from the origin loses no digits.
  const Vector3 origin = patch.points[0];
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(n), 3);
  Array<std::pair<int, double>> row(host.memory);
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    if (v % 1024 == 0) host.report("fairing patches", v, patch.points.size());
    // The umbrella at v: unknowns with their factors, and what is known.
    row.clear();
    Vector3 known = Vector3::Zero();
    const auto add = [&](Index point, const Vector3& place, double factor) {
      if (point != no_index && point >= fixed) {
        row.emplace_back(static_cast<int>(point - fixed), factor);
      } else {
        known += factor * (place - origin);
      }
    };
    add(static_cast<Index>(v), patch.points[v], -1);
    for (const Neighbor& neighbor : neighbors[v])
      add(neighbor.point, neighbor.place, neighbor.weight);
    for (const auto& [i, a] : row) {
      right.row(i) -= a * known.transpose();
      for (const auto& [j, b] : row) {
        if (j <= i) triplets.emplace_back(i, j, a * b);
      }
    }
  }
  // By one engine, so that programs with others get the same bits.
  linear::SparseSystem system(n, triplets, linear::DirectMethod::eigen);
  host.report("fairing patches", 1, 1);
  if (!system.factorize()) return false;
  Eigen::MatrixX3d solution(static_cast<Eigen::Index>(n), 3);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    solution.col(axis) = system.solve(right.col(axis));
  if (!solution.allFinite()) return false;
  for (std::size_t i = 0; i < n; ++i)
    patch.points[fixed + i] = solution.row(static_cast<Eigen::Index>(i)).transpose() + origin;
  return true;
}

}  // namespace orbicube::repair
