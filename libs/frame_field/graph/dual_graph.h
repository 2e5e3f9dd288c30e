// The graph that all methods work on: a node for each tetrahedron, a link for each inner face. Nodes are numbered along
// a Hilbert curve through the tetrahedra's centers, so that neighbors are near each other in memory, whatever the
// order of the mesh, and results do not depend on that order.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <span>

#include "base/host.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "quaternion/quaternion.h"

namespace orbicube::frame_field {

using base::Array;
using mesh::Index;
using mesh::no_index;
using mesh::Tetrahedron;
using mesh::Vector3;
using quaternion::Quaternion;
using Vector = quaternion::Vector;

// A unit quaternion a tetrahedron or a node: the active rotation that takes the axes to the frame's.
using Field = Array<Quaternion>;

// What the difference between the frames on both sides of a face counts for.
enum class Weighting : std::int32_t {
  uniform = 0,   // every inner face alike: the energy of the dissertation's eq. 6.12
  geometric = 1  // area / distance of the centers, scaled to mean 1: the Dirichlet energy, whatever the mesh
};

struct DualGraph {
  explicit DualGraph(std::pmr::memory_resource* memory) : others(memory), weights(memory), tetrahedron(memory) {}

  std::size_t size() const { return others.size(); }

  Array<std::array<Index, 4>> others;   // by node and face; the node itself on the boundary
  Array<std::array<float, 4>> weights;  // of the links; 0 on the boundary
  Array<Index> tetrahedron;             // that a node stands for
  std::size_t links = 0;                // inner faces
};

// The numbers of tetrahedra along a Hilbert curve through their centers; equal places by number. O(n log n).
Array<Index> tetrahedral_order(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                               const base::Host& host);

// O(n log n), 100 bytes a tetrahedron while it runs and 36 kept. Throws Error "cancelled".
DualGraph make_dual_graph(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                          Weighting weighting, const base::Host& host);

// Values by tetrahedron in the order of the nodes, and back.
Field by_node(const DualGraph& graph, std::span<const Quaternion> by_tetrahedron, std::pmr::memory_resource* memory);
void by_tetrahedron(const DualGraph& graph, const Field& by_node, std::span<Quaternion> result);

// body(begin, end, chunk) for pieces of [0, count), on the host's threads where there is work enough for them: from
// `least` nodes. The pieces do not depend on the number of threads.
inline constexpr std::size_t chunk_size = 4096;
inline constexpr std::size_t least_for_threads = 32768;  // of a microsecond of work each
inline constexpr std::size_t least_of_little = 131072;   // of some nanoseconds
inline std::size_t chunk_count(std::size_t count) {
  return (count + chunk_size - 1) / chunk_size;
}
template <class Body>
void for_each_chunk(const base::Host& host, std::size_t count, const Body& body,
                    std::size_t least = least_for_threads) {
  const std::size_t chunks = chunk_count(count);
  const auto piece = [&](std::size_t c) { body(c * chunk_size, std::min(count, (c + 1) * chunk_size), c); };
  if (count < least) {
    for (std::size_t c = 0; c < chunks; ++c)
      piece(c);
    return;
  }
  host.parallel_for(chunks, std::cref(piece));  // a function object that need not be copied to the heap
}

}  // namespace orbicube::frame_field
