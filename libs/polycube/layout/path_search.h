// Shortest paths along the edges of a surface that keep off what is drawn on it.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "base/heap.h"
#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube {

class PathSearch {
 public:
  PathSearch(const EditableSurface& surface, const base::Host& host)
      : surface_(surface),
        host_(host),
        distance_(host.memory),
        parent_(host.memory),
        arrival_(host.memory),
        heap_(host.memory) {}

  // From `from` by one of the half-edges `starts` to `to` by one of those of which `ends` holds the opposites (they
  // start at `to`), through vertices that are not occupied. `odd` is empty, or has for each half-edge whether it
  // crosses a closed curve; then the path crosses it an odd number of times, and may pass a vertex twice. Returns the
  // length and sets `path` to the vertices; infinite when there is none. cost(half_edge) must be positive.
  template <class Cost>
  double find(Index from, std::span<const Index> starts, Index to, std::span<const Index> ends,
              std::span<const std::uint8_t> odd, const Cost& cost, Array<Index>& path) {
    const std::size_t sheets = odd.empty() ? 1 : 2;
    prepare(sheets, ends);
    const auto crosses = [&](Index h) { return odd.empty() ? Index{0} : Index{odd[h]}; };
    double best = infinite;
    Index last = no_index;
    bool direct = false;
    for (const Index h : starts) {
      const Index v = surface_.end(h);
      if (v == to) {
        const bool open = std::any_of(ends.begin(), ends.end(), [&](Index e) { return surface_.end(e) == from; });
        if (open && (odd.empty() || odd[h]) && cost(h) < best) {
          best = cost(h);
          direct = true;
        }
      } else if (!surface_.occupied[v]) {
        reach(static_cast<Index>(sheets * v + crosses(h)), cost(h), no_index);
      }
    }
    for (std::size_t popped = 0; !heap_.empty(); ++popped) {
      if (popped % 4096 == 0) host_.report("tracing", 0, 0);
      const Reached nearest = heap_.pop();
      const double length = nearest.length;
      const Index state = nearest.state;
      if (length >= best) break;
      if (length > distance_[state]) continue;
      const auto v = static_cast<Index>(state / sheets), sheet = static_cast<Index>(state % sheets);
      if (const Index h = arrival_[v]; h != no_index && (odd.empty() || (sheet ^ crosses(h)) == 1)) {
        const double whole = length + cost(h);
        if (whole < best) {
          best = whole;
          last = state;
          direct = false;
        }
      }
      surface_.for_each_outgoing(v, [&](Index h) {
        const Index w = surface_.end(h);
        if (!surface_.occupied[w])
          reach(static_cast<Index>(sheets * w + (sheet ^ crosses(h))), length + cost(h), state);
      });
    }
    path.clear();
    if (best == infinite) return infinite;
    path.push_back(to);
    if (!direct)
      for (Index state = last; state != no_index; state = parent_[state])
        path.push_back(static_cast<Index>(state / sheets));
    path.push_back(from);
    std::reverse(path.begin(), path.end());
    return best;
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();

 private:
  struct Reached {
    double length;
    Index state;

    bool operator>(const Reached& other) const {
      return length != other.length ? length > other.length : state > other.state;
    }
  };

  void prepare(std::size_t sheets, std::span<const Index> ends) {
    distance_.assign(sheets * surface_.vertices(), infinite);
    parent_.resize(sheets * surface_.vertices());
    arrival_.assign(surface_.vertices(), no_index);
    heap_.clear();
    for (const Index h : ends)
      arrival_[surface_.end(h)] = h;
  }

  void reach(Index state, double length, Index from_state) {
    if (!(length < distance_[state])) return;
    distance_[state] = length;
    parent_[state] = from_state;
    heap_.push({length, state});
  }

  const EditableSurface& surface_;
  const base::Host& host_;
  Array<double> distance_;
  Array<Index> parent_, arrival_;  // by vertex and sheet; by vertex
  base::Heap<Reached> heap_;
};

}  // namespace orbicube::polycube
