#include "sphere_map/hierarchy/vertex_splits.h"

#include <utility>

#include "base/error.h"

namespace orbicube::sphere_map {

VertexSplits::VertexSplits(std::span<const Vector3> positions, std::span<Vector3> directions,
                           DependencyLevels& dependency_levels, std::span<StepScratch> scratch, const base::Host& host)
    : positions_(positions),
      directions_(directions),
      dependency_levels_(dependency_levels),
      scratch_(scratch),
      added_(host.memory),
      running_(host.memory),
      written_(host.memory),
      slots_(host.memory) {
  slots_.reserve(DependencyLevels::slots);
  for (std::size_t slot = 0; slot < DependencyLevels::slots; ++slot)
    slots_.emplace_back(host.memory);
}

void VertexSplits::add_move(const VertexRings& rings, Index vertex) {
  const auto ring = rings[vertex];
  added_.moves.push_back({vertex, static_cast<Index>(ring.size()), added_.ring.size()});
  added_.ring.insert(added_.ring.end(), ring.begin(), ring.end());
  added_.largest_ring = std::max(added_.largest_ring, ring.size());
  written_.push_back(vertex);
}

void VertexSplits::add(const VertexRings& rings, const Collapse& collapse, const Energy& energy) {
  const std::size_t ring_begin = added_.ring.size();
  const std::size_t moves_begin = added_.moves.size();
  written_.clear();
  add_move(rings, collapse.removed);
  for (const Index neighbor : rings[collapse.removed]) {
    if (rings.valence(neighbor) <= large_star) add_move(rings, neighbor);
  }
  added_.splits.push_back({collapse.kept, moves_begin, added_.moves.size(), energy});
  dependency_levels_.add(written_, std::span(added_.ring).subspan(ring_begin));
}

void VertexSplits::begin() {
  std::swap(added_, running_);
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    slots_[slot].star.reserve(running_.largest_ring);
    slots_[slot].kernel.reserve(running_.largest_ring);
    scratch_[slot].heights.reserve(running_.largest_ring);
  }
  failed_.store(running_.splits.size());
}

void VertexSplits::carry_out(std::size_t i, std::size_t slot) {
  if (failed_.load(std::memory_order_relaxed) < i || insert(running_.splits[i], slot)) return;
  for (std::size_t other = failed_.load(); i < other && !failed_.compare_exchange_weak(other, i);) {
  }
}

// Returns whether there was room for the vertex.
bool VertexSplits::insert(const Split& split, std::size_t slot) {
  const Move& inserted = running_.moves[split.moves_begin];
  const auto point = kernel_centroid(running_.ring_of(inserted), split.kept, directions_, slots_[slot].kernel);
  if (!point) return false;
  directions_[inserted.vertex] = *point;
  improve(split.energy, inserted, slot);
  for (std::size_t m = split.moves_begin; m < split.moves_end; ++m)
    improve(split.energy, running_.moves[m], slot);
  improve(split.energy, inserted, slot);
  return true;
}

void VertexSplits::improve(const Energy& energy, const Move& move, std::size_t slot) {
  const auto ring = running_.ring_of(move);
  Array<StarTriangle>& star = slots_[slot].star;
  star.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index q = ring[i];
    const Index r = ring[i + 1 < ring.size() ? i + 1 : 0];
    star.push_back({q, r, triangle_shape(positions_[move.vertex], positions_[q], positions_[r], energy.rest)});
  }
  improve_vertex(energy, move.vertex, star, directions_, scratch_[slot]);
}

void VertexSplits::finish() {
  const bool ok = failed_.load() == running_.splits.size();
  running_.splits.clear();
  running_.moves.clear();
  running_.ring.clear();
  running_.largest_ring = 0;
  if (!ok) {
    throw base::Error("no-valid-result", "the spherical kernel of a vertex is too small for double precision");
  }
}

}  // namespace orbicube::sphere_map
