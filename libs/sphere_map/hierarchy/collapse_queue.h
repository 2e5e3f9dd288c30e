// The vertices that may be merged into a neighbor, cheapest first, of a whole mesh or of one region of it.
#pragma once

#include <span>
#include <utility>

#include "base/heap.h"
#include "sphere_map/hierarchy/collapse_costs.h"

namespace orbicube::sphere_map {

class CollapseQueue {
 public:
  CollapseQueue(CollapseCosts& costs, std::pmr::memory_resource* memory) : costs_(costs), heap_(memory) {}

  // Fills an empty queue with those of `vertices` that have a target or must be looked at again; the memory for them is
  // all that the queue will ever request.
  void fill(std::span<const Index> vertices, std::pmr::memory_resource* memory) {
    Array<Entry> entries(memory);
    entries.reserve(vertices.size());
    for (const Index v : vertices) {
      if (costs_.is_dead(v)) continue;
      if (costs_.target(v) == no_index && costs_.is_stale(v)) costs_.set_cost(v, 0);
      if (costs_.target(v) != no_index || costs_.is_stale(v)) entries.push_back({costs_.cost(v), v});
    }
    heap_.assign(std::move(entries));
  }

  bool empty() const { return heap_.empty(); }

  // Looks again at a vertex, whose entry is gone.
  void refresh(Index vertex, bool patient, Candidates& candidates) {
    costs_.mark_stale(vertex, false);
    costs_.choose(vertex, patient, candidates);
    if (costs_.target(vertex) != no_index) push(vertex);
  }

  // Takes entries until one is a vertex with a target and a cost that holds, and returns it; no_index when none is
  // left. Vertices that are not `usable` lose their entries.
  template <class Usable>
  Index pop(const Usable& usable, Candidates& candidates) {
    while (!heap_.empty()) {
      const auto [cost, vertex] = heap_.pop();
      if (costs_.is_dead(vertex) || cost != costs_.cost(vertex) || !usable(vertex)) continue;  // dead, or replaced
      if (costs_.is_stale(vertex)) {
        refresh(vertex, true, candidates);
      } else if (costs_.target(vertex) != no_index) {
        return vertex;
      }
    }
    return no_index;
  }

  // After a collapse: the neighborhoods of `kept` and its neighbors have changed. Those that are not `own` are
  // marked, for who looks at them later; others may mark them at the same time.
  template <class Own>
  void touch_around(Index kept, const Own& own) {
    touch(kept);
    for (const Index v : costs_.rings()[kept]) {
      if (own(v))
        touch(v);
      else
        costs_.mark_stale(v, true);
    }
  }

 private:
  using Entry = std::pair<double, Index>;

  void push(Index vertex) { heap_.push({costs_.cost(vertex), vertex}); }

  void touch(Index v) {
    if (costs_.target(v) == no_index && !costs_.is_stale(v)) {  // it had no feasible neighbor and so no entry
      costs_.set_cost(v, 0);
      push(v);
    }
    costs_.mark_stale(v, true);
  }

  CollapseCosts& costs_;
  base::Heap<Entry> heap_;
};

}  // namespace orbicube::sphere_map
