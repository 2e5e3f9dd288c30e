#include "sphere_map/vertex_splits.h"

#include <atomic>
#include <string>

#include "base/error.h"

namespace orbicube::sphere_map {

VertexSplits::VertexSplits(std::span<const Vector3> positions, std::span<Vector3> directions, Waves& waves,
                           std::span<StepScratch> scratch, const base::Host& host)
    : positions_(positions),
      directions_(directions),
      waves_(waves),
      scratch_(scratch),
      splits_(host.memory),
      moves_(host.memory),
      ring_(host.memory),
      written_(host.memory),
      slots_(host.memory) {
  slots_.reserve(Waves::slots);
  for (std::size_t slot = 0; slot < Waves::slots; ++slot)
    slots_.emplace_back(host.memory);
}

void VertexSplits::add_move(const VertexRings& rings, Index vertex) {
  const auto ring = rings[vertex];
  moves_.push_back({vertex, static_cast<Index>(ring.size()), ring_.size()});
  ring_.insert(ring_.end(), ring.begin(), ring.end());
  largest_ring_ = std::max(largest_ring_, ring.size());
  written_.push_back(vertex);
}

void VertexSplits::add(const VertexRings& rings, const Collapse& collapse, const Energy& energy) {
  const std::size_t ring_begin = ring_.size();
  const std::size_t moves_begin = moves_.size();
  written_.clear();
  add_move(rings, collapse.removed);
  for (const Index neighbour : rings[collapse.removed]) {
    if (rings.valence(neighbour) <= large_star) add_move(rings, neighbour);
  }
  splits_.push_back({collapse.kept, moves_begin, moves_.size(), energy});
  waves_.add(written_, std::span(ring_).subspan(ring_begin));
}

void VertexSplits::run() {
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    slots_[slot].star.reserve(largest_ring_);
    slots_[slot].kernel.reserve(largest_ring_);
    scratch_[slot].heights.reserve(largest_ring_);
  }
  std::atomic<std::size_t> failed{splits_.size()};  // the first of them in order
  waves_.run([&](std::size_t i, std::size_t slot) {
    if (failed.load(std::memory_order_relaxed) < i || carry_out(splits_[i], slot)) return;
    for (std::size_t other = failed.load(); i < other && !failed.compare_exchange_weak(other, i);) {
    }
  });
  const std::size_t first = failed.load();
  const bool ok = first == splits_.size();
  const Index vertex = ok ? 0 : moves_[splits_[first].moves_begin].vertex;
  splits_.clear();
  moves_.clear();
  ring_.clear();
  if (!ok) {
    throw base::Error("no-valid-result", "the spherical kernel of vertex " + std::to_string(vertex) +
                                             " is too small for double precision");
  }
}

// Answers whether there was room for the vertex.
bool VertexSplits::carry_out(const Split& split, std::size_t slot) {
  const Move& inserted = moves_[split.moves_begin];
  const auto point = kernel_centroid(ring_of(inserted), split.kept, directions_, slots_[slot].kernel);
  if (!point) return false;
  directions_[inserted.vertex] = *point;
  improve(split.energy, inserted, slot);
  for (std::size_t m = split.moves_begin; m < split.moves_end; ++m)
    improve(split.energy, moves_[m], slot);
  improve(split.energy, inserted, slot);
  return true;
}

void VertexSplits::improve(const Energy& energy, const Move& move, std::size_t slot) {
  const auto ring = ring_of(move);
  Array<StarTriangle>& star = slots_[slot].star;
  star.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index q = ring[i];
    const Index r = ring[i + 1 < ring.size() ? i + 1 : 0];
    star.push_back({q, r, triangle_shape(positions_[move.vertex], positions_[q], positions_[r], energy.least_area)});
  }
  improve_vertex(energy, move.vertex, star, directions_, scratch_[slot]);
}

}  // namespace orbicube::sphere_map
