// The insertion of vertices into a map, many at a time.
//
// A split puts its vertex into the spherical kernel of its ring and then moves the vertex and its ring once each
// (vertex_step.h). Splits of a batch are given in order, each with what the connectivity is at that time; then they are
// carried out, those that do not touch each other side by side (waves.h).
#pragma once

#include "base/host.h"
#include "sphere_map/distortion.h"
#include "sphere_map/level.h"
#include "sphere_map/spherical_kernel.h"
#include "sphere_map/vertex_rings.h"
#include "sphere_map/waves.h"

namespace orbicube::sphere_map {

class VertexSplits {
 public:
  // `scratch` has one a slot of the waves.
  VertexSplits(std::span<const Vector3> positions, std::span<Vector3> directions, Waves& waves,
               std::span<StepScratch> scratch, const base::Host& host);

  // Adds the split that undoes `collapse`, which has just been undone in `rings`.
  void add(const VertexRings& rings, const Collapse& collapse, const Energy& energy);

  // Carries out what was added. Throws Error no-valid-result when a kernel has no room.
  void run();

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
  // What one thread works with.
  struct Slot {
    explicit Slot(std::pmr::memory_resource* memory) : star(memory), kernel(memory) {}
    Array<StarTriangle> star;
    KernelPolygon kernel;
  };

  void add_move(const VertexRings& rings, Index vertex);
  bool carry_out(const Split& split, std::size_t slot);
  void improve(const Energy& energy, const Move& move, std::size_t slot);
  std::span<const Index> ring_of(const Move& move) const { return {ring_.data() + move.begin, move.size}; }

  std::span<const Vector3> positions_;
  std::span<Vector3> directions_;
  Waves& waves_;
  std::span<StepScratch> scratch_;
  Array<Split> splits_;
  Array<Move> moves_;
  Array<Index> ring_;
  Array<Index> written_;
  Array<Slot> slots_;
  std::size_t largest_ring_ = 0;
};

}  // namespace orbicube::sphere_map
