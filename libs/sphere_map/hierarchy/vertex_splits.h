// The insertion of vertices into a map, many at a time.
//
// A split puts its vertex into the spherical kernel of its ring and then moves the vertex and its ring once each
// (vertex_step.h). Splits of a batch are given in order, each with what the connectivity is at that time; then they are
// carried out, those that do not touch each other side by side (dependency_levels.h). Meanwhile the next batch is
// given: that takes one thread a third of the time.
#pragma once

#include <atomic>

#include "base/host.h"
#include "sphere_map/hierarchy/level.h"
#include "sphere_map/hierarchy/spherical_kernel.h"
#include "sphere_map/hierarchy/vertex_rings.h"
#include "sphere_map/optimization/dependency_levels.h"
#include "sphere_map/optimization/distortion.h"

namespace orbicube::sphere_map {

class VertexSplits {
 public:
  // `scratch` has one a slot of the dependency_levels.
  VertexSplits(std::span<const Vector3> positions, std::span<Vector3> directions, DependencyLevels& dependency_levels,
               std::span<StepScratch> scratch, const base::Host& host);

  // Adds the split that undoes `collapse`, which has just been undone in `rings`.
  void add(const VertexRings& rings, const Collapse& collapse, const Energy& energy);

  // Whether splits were added that have not been carried out.
  bool waiting() const { return !added_.splits.empty(); }

  // Carries out what was added, while beside(done, total) is called from any thread, one call after the other, to add
  // to the next batch (DependencyLevels::run). Throws Error no-valid-result when a kernel has no room.
  template <class Beside>
  void run(const Beside& beside) {
    begin();
    dependency_levels_.run([this](std::size_t i, std::size_t slot) { carry_out(i, slot); }, beside);
    finish();
  }

 private:
  // A vertex that is moved and its ring, ring_[begin .. begin + size).
  struct Move {
    Index vertex;
    Index size;
    std::size_t begin;
  };
  // The first move is that of the new vertex.
  struct Split {
    Index kept;
    std::size_t moves_begin, moves_end;
    Energy energy;
  };
  struct Batch {
    explicit Batch(std::pmr::memory_resource* memory) : splits(memory), moves(memory), ring(memory) {}
    std::span<const Index> ring_of(const Move& move) const { return {ring.data() + move.begin, move.size}; }

    Array<Split> splits;
    Array<Move> moves;
    Array<Index> ring;
    std::size_t largest_ring = 0;
  };
  // What one thread works with.
  struct Slot {
    explicit Slot(std::pmr::memory_resource* memory) : star(memory), kernel(memory) {}
    Array<StarTriangle> star;
    KernelPolygon kernel;
  };

  void add_move(const VertexRings& rings, Index vertex);
  void begin();
  void carry_out(std::size_t i, std::size_t slot);
  bool insert(const Split& split, std::size_t slot);
  void improve(const Energy& energy, const Move& move, std::size_t slot);
  void finish();

  std::span<const Vector3> positions_;
  std::span<Vector3> directions_;
  DependencyLevels& dependency_levels_;
  std::span<StepScratch> scratch_;
  Batch added_, running_;
  Array<Index> written_;
  Array<Slot> slots_;
  std::atomic<std::size_t> failed_{0};  // the first split in order for which there was no room
};

}  // namespace orbicube::sphere_map
