// A binary tree of axis-aligned boxes over numbered items (points, triangles, cells): what is near a point or overlaps
// a box is found by looking at few of them.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

struct Box {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = Vector3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vector3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
  double squared_distance(const Vector3& p) const {
    return (low - p).cwiseMax(p - high).cwiseMax(Vector3::Zero()).squaredNorm();
  }
};

// Median splits along the longest side of the box of the centers: O(n log n) to build, up to 60 bytes an item, and 32
// more while it is built.
class BoundingVolumeTree {
 public:
  // Item i has boxes[i]; the boxes are copied into the tree. Throws Error "unsupported" for 2^32 items, "cancelled".
  BoundingVolumeTree(std::span<const Box> boxes, const base::Host& host);

  // visit(item) for each item in a leaf whose box overlaps `box`, among them all items whose own box does.
  template <class Visit>
  void for_each_near(const Box& box, const Visit& visit) const {
    walk([&](const Node& node) { return node.box.overlaps(box); }, visit);
  }

  struct Nearest {
    Index item = no_index;  // none when nothing is closer than the limit
    double squared_distance = std::numeric_limits<double>::infinity();
  };

  // The item with the minimum squared_distance(item), which must not be below that of the item's box, or `best` where
  // nothing is as near; the lowest of equals. The nearer `best` is, the fewer are looked at.
  template <class Distance>
  Nearest nearest(const Vector3& point, const Distance& squared_distance, Nearest best) const {
    if (nodes_.empty()) return best;
    struct Open {
      Index node;
      double squared_distance;
    };
    std::array<Open, deepest> open;
    std::size_t count = 0;
    open[count++] = {0, nodes_[0].box.squared_distance(point)};
    while (count > 0) {
      const Open at = open[--count];
      if (at.squared_distance > best.squared_distance) continue;
      const Node& node = nodes_[at.node];
      if (node.count == 0) {
        Open first{at.node + 1, nodes_[at.node + 1].box.squared_distance(point)};
        Open second{node.begin, nodes_[node.begin].box.squared_distance(point)};
        if (second.squared_distance < first.squared_distance) std::swap(first, second);
        open[count++] = second;
        open[count++] = first;
        continue;
      }
      for (const Index item : items_of(node)) {
        const double d = squared_distance(item);
        if (d < best.squared_distance || (d == best.squared_distance && item < best.item)) best = {item, d};
      }
    }
    return best;
  }

  template <class Distance>
  Nearest nearest(const Vector3& point, const Distance& squared_distance) const {
    return nearest(point, squared_distance, Nearest());
  }

  // visit(item) for each item in a leaf whose box comes so near to the point, among them all items whose own box does.
  template <class Visit>
  void for_each_within(const Vector3& point, double squared_radius, const Visit& visit) const {
    walk([&](const Node& node) { return node.box.squared_distance(point) <= squared_radius; }, visit);
  }

 private:
  // A leaf has the items [begin, begin + count); an inner node (count 0) has its children at the next place and
  // `begin`.
  struct Node {
    Box box;
    Index begin;
    Index count;
  };
  static constexpr std::size_t items_in_leaf = 4;
  static constexpr std::size_t deepest = 64;  // halves of fewer than 2^32 items leave at most 32 levels

  std::span<const Index> items_of(const Node& node) const { return {items_.data() + node.begin, node.count}; }

  template <class Enter, class Visit>
  void walk(const Enter& enter, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<Index, deepest> open;
    std::size_t count = 0;
    open[count++] = 0;
    while (count > 0) {
      const Index at = open[--count];
      const Node& node = nodes_[at];
      if (!enter(node)) continue;
      if (node.count == 0) {
        open[count++] = node.begin;
        open[count++] = at + 1;
      } else {
        for (const Index item : items_of(node))
          visit(item);
      }
    }
  }

  struct Centre {
    Vector3 position;
    Index item;
  };
  // Adds the node of the items of `centres`, which go to the places from `begin` on, and the nodes below it.
  void build(std::span<const Box> boxes, std::span<Centre> centres, std::size_t begin, const base::Host& host);

  Array<Node> nodes_;  // each before its children
  Array<Index> items_;
};

}  // namespace orbicube::mesh
