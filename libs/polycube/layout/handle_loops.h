// The closed curves of a tree of free vertices and a cotree of faces of what is not drawn on a surface (Eppstein 2003).
// A path leaves its sides connected exactly when it crosses one of them an odd number of times.
#pragma once

#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube {

class HandleLoops {
 public:
  // The surface may not change while this is used.
  HandleLoops(const EditableSurface& surface, const base::Host& host)
      : surface_(surface),
        host_(host),
        in_tree_(3 * surface.faces(), 0, host.memory),
        in_cotree_(3 * surface.faces(), 0, host.memory),
        towards_(host.memory),
        queue_(host.memory) {
    for (Index v = 0; v < surface_.vertices() && queue_.empty(); ++v)
      if (!surface_.occupied[v] && surface_.outgoing(v) != no_index) queue_.push_back(v);
    if (queue_.empty()) return;
    first_ = surface_.outgoing(queue_[0]) / 3;
    grow_tree();
    grow_cotree();
  }

  // Calls visit(odd) for each curve, with 1 for half-edges that it crosses an odd number of times.
  template <class Visit>
  void for_each(const Visit& visit) const {
    Array<std::uint8_t> odd(host_.memory);
    for (const Index f : queue_) {
      for (Index k = 0; k < 3; ++k) {
        const Index h = 3 * f + k, t = surface_.opposite(h);
        if (h > t || surface_.arc[h] != no_index || in_tree_[h] || in_cotree_[h]) continue;
        odd.assign(in_tree_.size(), 0);
        const auto cross = [&](Index x) {
          odd[x] ^= 1;
          odd[surface_.opposite(x)] ^= 1;
        };
        cross(h);
        for (Index side : {h / 3, t / 3}) {
          while (side != first_) {
            cross(towards_[side]);
            side = surface_.opposite(towards_[side]) / 3;
          }
        }
        visit(odd);
      }
    }
  }

 private:
  // From the vertex in the queue.
  void grow_tree() {
    Array<std::uint8_t> seen(surface_.vertices(), 0, host_.memory);
    seen[queue_[0]] = 1;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      surface_.for_each_outgoing(queue_[i], [&](Index h) {
        const Index w = surface_.end(h);
        if (surface_.occupied[w] || seen[w]) return;
        seen[w] = 1;
        in_tree_[h] = in_tree_[surface_.opposite(h)] = 1;
        queue_.push_back(w);
      });
    }
  }

  // Leaves the faces that are reached in the queue.
  void grow_cotree() {
    towards_.assign(surface_.faces(), no_index);
    queue_.assign(1, first_);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      for (Index k = 0; k < 3; ++k) {
        const Index h = 3 * queue_[i] + k, t = surface_.opposite(h);
        if (surface_.arc[h] != no_index || in_tree_[h] || t / 3 == first_ || towards_[t / 3] != no_index) continue;
        towards_[t / 3] = t;
        in_cotree_[h] = in_cotree_[t] = 1;
        queue_.push_back(t / 3);
      }
    }
  }

  const EditableSurface& surface_;
  const base::Host& host_;
  Array<std::uint8_t> in_tree_, in_cotree_;  // of each half-edge
  Array<Index> towards_;                     // half-edge of a face to the one before it
  Array<Index> queue_;                       // vertices of the tree, then faces of the cotree
  Index first_ = no_index;                   // face
};

}  // namespace orbicube::polycube
