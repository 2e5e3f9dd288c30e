#include "mesh/bounding_volume_tree.h"

#include <numeric>

#include "base/error.h"

namespace orbicube::mesh {

BoundingVolumeTree::BoundingVolumeTree(std::span<const Box> boxes, const base::Host& host)
    : nodes_(host.memory), items_(boxes.size(), host.memory) {
  if (boxes.size() >= no_index) throw base::Error("unsupported", "more items than 32-bit numbers can count");
  std::iota(items_.begin(), items_.end(), Index{0});
  nodes_.reserve(boxes.size() / (items_in_leaf / 2) + 1);
  if (!boxes.empty()) build(boxes, 0, boxes.size(), host);
}

void BoundingVolumeTree::build(std::span<const Box> boxes, std::size_t begin, std::size_t end, const base::Host& host) {
  const std::size_t node = nodes_.size();
  if (end - begin > 4096 || node % 4096 == 0) host.report("building a search tree", begin, boxes.size());
  Box all, centres;
  const auto centre = [&](Index item) -> Vector3 { return 0.5 * boxes[item].low + 0.5 * boxes[item].high; };
  for (std::size_t i = begin; i < end; ++i) {
    all.add(boxes[items_[i]]);
    centres.add(centre(items_[i]));
  }
  nodes_.push_back({all, static_cast<Index>(begin), static_cast<Index>(end - begin)});
  if (end - begin <= items_in_leaf) return;
  Eigen::Index axis = 0;
  (0.5 * centres.high - 0.5 * centres.low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
  // Equal centres are told apart by number, so that the tree is the same wherever it is built.
  std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
    const double x = centre(a)[axis], y = centre(b)[axis];
    return x != y ? x < y : a < b;
  });
  build(boxes, begin, middle, host);
  nodes_[node].begin = static_cast<Index>(nodes_.size());
  nodes_[node].count = 0;
  build(boxes, middle, end, host);
}

}  // namespace orbicube::mesh
