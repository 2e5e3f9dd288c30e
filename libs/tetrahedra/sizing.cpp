#include "tetrahedra/sizing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orbicube::tetrahedra {

using mesh::Index;
using mesh::Vector3;

namespace {

constexpr Index leaf_size = 4;
constexpr std::size_t deepest = 64;  // halving 2^32 points takes 32 levels

}  // namespace

Sizing::Sizing(std::span<const SizePoint> points, double growth, std::pmr::memory_resource* memory)
    : points_(points.begin(), points.end(), memory), nodes_(memory), growth_(growth) {
  if (!points_.empty()) add_node(0, static_cast<Index>(points_.size()));
}

Index Sizing::add_node(Index begin, Index end) {
  const auto number = static_cast<Index>(nodes_.size());
  Node& node = nodes_.emplace_back();
  node.shortest = std::numeric_limits<double>::infinity();
  for (Index i = begin; i < end; ++i) {
    node.box.add(points_[i].position);
    node.shortest = std::min(node.shortest, points_[i].length);
  }
  node.begin = begin;
  node.count = end - begin;
  if (node.count <= leaf_size) return number;
  node.count = 0;
  Eigen::Index axis = 0;
  (node.box.high - node.box.low).maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                   [axis](const SizePoint& a, const SizePoint& b) { return a.position[axis] < b.position[axis]; });
  add_node(begin, middle);
  const Index second = add_node(middle, end);
  nodes_[number].begin = second;  // the array may have moved
  return number;
}

double Sizing::least(const Node& node, const Vector3& place) const {
  return node.shortest + growth_ * std::sqrt(node.box.squared_distance(place));
}

double Sizing::length_at(const Vector3& place) const {
  double best = std::numeric_limits<double>::infinity();
  if (nodes_.empty()) return best;
  struct Open {
    Index node;
    double least;
  };
  std::array<Open, deepest> open;
  std::size_t count = 0;
  open[count++] = {0, least(nodes_[0], place)};
  while (count > 0) {
    const Open at = open[--count];
    if (at.least >= best) continue;
    const Node& node = nodes_[at.node];
    if (node.count == 0) {
      Open first{at.node + 1, least(nodes_[at.node + 1], place)}, second{node.begin, least(nodes_[node.begin], place)};
      if (second.least < first.least) std::swap(first, second);
      open[count++] = second;
      open[count++] = first;
      continue;
    }
    for (Index i = node.begin; i < node.begin + node.count; ++i)
      best = std::min(best, points_[i].length + growth_ * (points_[i].position - place).norm());
  }
  return best;
}

}  // namespace orbicube::tetrahedra
