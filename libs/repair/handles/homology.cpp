#include "repair/handles/homology.h"

#include <utility>

#include "base/random.h"

namespace orbicube::repair {
namespace {

class Trees {
 public:
  Trees(const Soup& soup, const mesh::Connectivity& connectivity, const base::Host& host)
      : soup_(soup),
        connectivity_(connectivity),
        host_(host),
        in_tree_(3 * soup.triangles.size(), 0, host.memory),
        entered_by_(soup.triangles.size(), no_index, host.memory),
        depth_(soup.triangles.size(), 0, host.memory) {}

  Homology run() {
    span_vertices();
    span_faces();
    Array<std::uint64_t> codes(in_tree_.size(), 0, host_.memory);
    Array<Index> left(host_.memory);
    for (Index h = 0; h < in_tree_.size(); ++h) {
      if (in_tree_[h] == 0 && h < connectivity_.opposite(h)) left.push_back(h);
    }
    base::Random random(left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      host_.report("finding handles", i, left.size());
      const std::uint64_t code = left.size() <= 64 ? std::uint64_t{1} << i : random.next();
      mark_cycle(left[i], code, codes);
    }
    return {std::move(codes), static_cast<std::int64_t>(left.size() / 2)};
  }

 private:
  void take(Index h, std::uint8_t tree) {
    in_tree_[h] = tree;
    in_tree_[connectivity_.opposite(h)] = tree;
  }

  // Goes by breadth from the first element of each part: for_each(element, visit) calls visit(other, half_edge) for
  // what is beside the element, and entered(other, half_edge, element) is called where `other` is reached first.
  template <class ForEach, class Entered>
  void span(std::size_t count, const ForEach& for_each, const Entered& entered) {
    Array<std::uint8_t> seen(count, 0, host_.memory);
    Array<Index> queue(host_.memory);
    for (Index seed = 0; seed < count; ++seed) {
      if (seen[seed] != 0) continue;
      seen[seed] = 1;
      queue.assign(1, seed);
      for (std::size_t i = 0; i < queue.size(); ++i) {
        if (i % 65536 == 0) host_.report("finding handles", i, count);
        const Index element = queue[i];
        for_each(element, [&](Index other, Index h) {
          if (seen[other] != 0) return;
          seen[other] = 1;
          entered(other, h, element);
          queue.push_back(other);
        });
      }
    }
  }

  void span_vertices() {
    span(
        soup_.positions.size(),
        [&](Index vertex, const auto& visit) {
          connectivity_.for_each_outgoing(vertex, [&](Index h) { visit(connectivity_.end(h), h); });
        },
        [&](Index, Index h, Index) { take(h, 1); });
  }

  void span_faces() {
    span(
        soup_.triangles.size(),
        [&](Index face, const auto& visit) {
          for (Index h = 3 * face; h < 3 * face + 3; ++h)
            if (in_tree_[h] != 1) visit(connectivity_.opposite(h) / 3, h);
        },
        [&](Index other, Index h, Index face) {
          take(h, 2);
          entered_by_[other] = connectivity_.opposite(h);
          depth_[other] = depth_[face] + 1;
        });
  }

  // The edge itself, and those that the tree of faces crosses between its two faces.
  void mark_cycle(Index h, std::uint64_t code, Array<std::uint64_t>& codes) const {
    const auto mark = [&](Index edge) {
      codes[edge] ^= code;
      codes[connectivity_.opposite(edge)] ^= code;
    };
    mark(h);
    Index a = h / 3, b = connectivity_.opposite(h) / 3;
    while (a != b) {
      Index& deeper = depth_[a] >= depth_[b] ? a : b;
      mark(entered_by_[deeper]);
      deeper = connectivity_.opposite(entered_by_[deeper]) / 3;
    }
  }

  const Soup& soup_;
  const mesh::Connectivity& connectivity_;
  const base::Host& host_;
  Array<std::uint8_t> in_tree_;  // of each half-edge: 1 of vertices, 2 of faces
  Array<Index> entered_by_;      // for each face its half-edge to the one before it in the tree
  Array<Index> depth_;
};

}  // namespace

Homology homology_codes(const Soup& soup, const mesh::Connectivity& connectivity, const base::Host& host) {
  return Trees(soup, connectivity, host).run();
}

}  // namespace orbicube::repair
