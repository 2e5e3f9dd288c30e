#include "mesh/search/bounding_volume_tree.h"

#include "base/error.h"

namespace orbicube::mesh {

BoundingVolumeTree::BoundingVolumeTree(std::span<const Box> boxes, const base::Host& host)
    : nodes_(host.memory), items_(boxes.size(), host.memory) {
  if (boxes.size() >= no_index) throw base::Error("unsupported", "more items than 32-bit numbers can count");
  if (boxes.empty()) return;
  nodes_.reserve(boxes.size() / (items_in_leaf / 2) + 1);
  Array<Centre> centres(boxes.size(), host.memory);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    centres[i] = {0.5 * boxes[i].low + 0.5 * boxes[i].high, static_cast<Index>(i)};
  build(boxes, centres, 0, host);
}

void BoundingVolumeTree::build(std::span<const Box> boxes, std::span<Centre> centres, std::size_t begin,
                               const base::Host& host) {
  const std::size_t node = nodes_.size();
  if (centres.size() > 4096 || node % 4096 == 0) host.report("building a search tree", begin, boxes.size());
  nodes_.push_back({Box(), static_cast<Index>(begin), static_cast<Index>(centres.size())});
  Box box;
  if (centres.size() <= items_in_leaf) {
    for (std::size_t i = 0; i < centres.size(); ++i) {
      items_[begin + i] = centres[i].item;
      box.add(boxes[centres[i].item]);
    }
    nodes_[node].box = box;
    return;
  }
  Box around;
  for (const Centre& c : centres)
    around.add(c.position);
  Eigen::Index axis = 0;
  (0.5 * around.high - 0.5 * around.low).maxCoeff(&axis);
  const std::size_t middle = centres.size() / 2;
  // Equal centers are distinguished by number, so that the tree is the same wherever it is built.
  std::nth_element(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(middle), centres.end(),
                   [axis](const Centre& a, const Centre& b) {
                     const double x = a.position[axis], y = b.position[axis];
                     return x != y ? x < y : a.item < b.item;
                   });
  build(boxes, centres.first(middle), begin, host);
  const std::size_t second = nodes_.size();
  build(boxes, centres.subspan(middle), begin + middle, host);
  box.add(nodes_[node + 1].box);
  box.add(nodes_[second].box);
  nodes_[node] = {box, static_cast<Index>(second), 0};
}

}  // namespace orbicube::mesh
