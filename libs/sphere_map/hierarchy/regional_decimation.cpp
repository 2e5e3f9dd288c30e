#include "sphere_map/hierarchy/regional_decimation.h"

#include <algorithm>
#include <utility>

#include "base/heap.h"
#include "mesh/search/hilbert_curve.h"
#include "sphere_map/hierarchy/collapse_queue.h"

namespace orbicube::sphere_map {
namespace {

// Room for rings, in indices a vertex: those that collapses record hold six in the mean, and some are of higher
// valence; those that outgrow their room take five. A region that has used up its room leaves the rest
// to others.
constexpr std::size_t recorded_room = 6, growing_room = 6;
constexpr std::size_t collapses_between_reports = 4096;  // some milliseconds

class Region {
 public:
  Region(std::span<const Index> vertices, Index number, std::span<const Index> region_of, CollapseCosts& costs,
         Array<Index>& ring_pool, std::size_t pool_begin, VertexRings::Room room, const base::Host& host)
      : vertices_(vertices),
        number_(number),
        region_of_(region_of),
        costs_(costs),
        queue_(costs, host.memory),
        collapses_(host.memory),
        collapse_costs_(host.memory),
        ring_pool_(ring_pool),
        pool_used_(pool_begin),
        pool_end_(pool_begin + recorded_room * vertices.size()),
        room_(room) {
    queue_.fill(vertices, host.memory);
    max_collapses_ = vertices.size() - vertices.size() / 4;
    collapses_.reserve(max_collapses_);
    collapse_costs_.reserve(max_collapses_);
  }

  bool done() const { return done_; }

  // Goes on for `count` collapses. Requires no memory.
  void run(std::size_t count) {
    CandidatesOnStack stack;
    const auto usable = [&](Index v) { return is_inner(v); };
    const std::size_t end = std::min(collapses_.size() + count, max_collapses_);
    while (collapses_.size() < end) {
      const Index vertex = queue_.pop(usable, stack.candidates);
      if (vertex == no_index || !collapse(vertex)) {
        done_ = true;
        return;
      }
    }
    done_ = collapses_.size() == max_collapses_;
  }

  std::span<const Collapse> collapses() const { return collapses_; }
  // Of each collapse: the largest cost so far.
  std::span<const double> costs() const { return collapse_costs_; }

 private:
  bool is_inner(Index vertex) const {
    for (const Index neighbor : costs_.rings()[vertex]) {
      if (region_of_[neighbor] != number_) return false;
    }
    return true;
  }

  // Returns false when there is no room for it.
  bool collapse(Index vertex) {
    VertexRings& rings = costs_.rings();
    const Index target = costs_.target(vertex);
    const auto ring = rings[vertex];
    if (pool_end_ - pool_used_ < ring.size() || !rings.make_room(vertex, target, room_)) return false;
    const Collapse collapse{vertex, target, static_cast<Index>(pool_used_), static_cast<Index>(ring.size())};
    const auto start = ring.begin() + static_cast<std::ptrdiff_t>(rings.find(vertex, target));
    std::rotate_copy(ring.begin(), start, ring.end(), ring_pool_.begin() + static_cast<std::ptrdiff_t>(pool_used_));
    pool_used_ += ring.size();
    const double before = collapse_costs_.empty() ? 0 : collapse_costs_.back();
    collapse_costs_.push_back(std::max(before, costs_.cost(vertex)));
    collapses_.push_back(collapse);
    costs_.collapse(collapse, std::span(ring_pool_).subspan(collapse.ring_begin, collapse.ring_size));
    queue_.touch_around(target, [&](Index v) { return region_of_[v] == number_; });
    return true;
  }

  std::span<const Index> vertices_;
  Index number_;
  std::span<const Index> region_of_;
  CollapseCosts& costs_;
  CollapseQueue queue_;
  Array<Collapse> collapses_;
  Array<double> collapse_costs_;
  Array<Index>& ring_pool_;
  std::size_t pool_used_, pool_end_;
  VertexRings::Room room_;
  std::size_t max_collapses_ = 0;
  bool done_ = false;
};

// All collapses by the largest cost that their region had seen, which keeps the order within each region.
void merge(std::span<const Region> regions, Array<Collapse>& result, std::pmr::memory_resource* memory) {
  using Entry = std::pair<double, std::size_t>;  // cost of the next collapse of a region
  base::Heap<Entry> next(memory);
  Array<std::size_t> done(regions.size(), 0, memory);
  const auto push = [&](std::size_t r) {
    if (done[r] < regions[r].collapses().size()) next.push({regions[r].costs()[done[r]], r});
  };
  for (std::size_t r = 0; r < regions.size(); ++r)
    push(r);
  while (!next.empty()) {
    const std::size_t r = next.pop().second;
    result.push_back(regions[r].collapses()[done[r]++]);
    push(r);
  }
}

// Takes each region of `vertices`, which lie along the curve, down to a quarter.
void decimate_once(std::span<const Index> vertices, std::size_t region_size, std::span<Index> region_of,
                   CollapseCosts& costs, Decimation& result, const base::Host& host, const base::ThreadPool& pool) {
  const std::size_t count = vertices.size() / region_size;
  const std::size_t total = costs.alive_at_first();
  const auto begin_of = [&](std::size_t region) { return vertices.size() * region / count; };
  const std::size_t pool_begin = result.ring_pool.size();
  result.ring_pool.reserve(pool_begin + 2 * recorded_room * vertices.size());  // also for the rounds that follow
  result.ring_pool.resize(pool_begin + recorded_room * vertices.size());
  const VertexRings::Room room = costs.rings().set_aside(growing_room * vertices.size());
  Array<Region> regions(host.memory);
  regions.reserve(count);
  for (std::size_t r = 0; r < count; ++r) {
    const std::size_t begin = begin_of(r), end = begin_of(r + 1);
    for (const Index v : vertices.subspan(begin, end - begin))
      region_of[v] = static_cast<Index>(r);
    regions.emplace_back(vertices.subspan(begin, end - begin), static_cast<Index>(r), region_of, costs,
                         result.ring_pool, pool_begin + recorded_room * begin,
                         VertexRings::Room{room.begin + growing_room * begin, room.begin + growing_room * end}, host);
  }
  Array<std::size_t> active(host.memory);
  for (std::size_t done = result.collapses.size();;) {
    active.clear();
    for (std::size_t r = 0; r < count; ++r) {
      if (!regions[r].done()) active.push_back(r);
    }
    if (active.empty()) break;
    host.report("decimation", std::min(done, total), total);
    pool.run(active.size(), [&](std::size_t i) { regions[active[i]].run(collapses_between_reports); });
    done += active.size() * collapses_between_reports;
  }
  merge(regions, result.collapses, host.memory);
}

}  // namespace

void decimate_regions(std::span<const Vector3> positions, std::size_t region_size, CollapseCosts& costs,
                      Decimation& result, const base::Host& host, const base::ThreadPool& pool) {
  Array<Index> vertices = mesh::hilbert_order(positions, host);
  Array<Index> region_of(positions.size(), host.memory);
  for (std::size_t before = positions.size() + 1;;) {
    std::erase_if(vertices, [&](Index v) { return costs.is_dead(v); });
    if (vertices.size() < min_regions * region_size || vertices.size() == before) return;
    before = vertices.size();
    decimate_once(vertices, region_size, region_of, costs, result, host, pool);
  }
}

}  // namespace orbicube::sphere_map
