// For each vertex of a mesh that is being decimated: into which neighbor it would best be merged, and at what cost.
//
// Quadric errors (Garland and Heckbert 1997) with extra costs: slivers and vertices of valence 3 make spherical kernels
// thin, turned normals make folds, and high valences make both the rings and their treatment dear.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <utility>

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/tie_breaker.h"
#include "sphere_map/hierarchy/vertex_rings.h"

namespace orbicube::sphere_map {

using mesh::no_index;

// Sum of squared distances to planes, weighted by area (Garland and Heckbert 1997): x'Ax + 2b'x + c.
struct Quadric {
  std::array<double, 10> q{};  // A (xx xy xz yy yz zz), b (x y z), c

  void add_plane(const Vector3& n, double offset, double weight) {
    const std::array<double, 10> plane = {n.x() * n.x(),  n.x() * n.y(),  n.x() * n.z(),  n.y() * n.y(),
                                          n.y() * n.z(),  n.z() * n.z(),  n.x() * offset, n.y() * offset,
                                          n.z() * offset, offset * offset};
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += weight * plane[i];
  }
  void add(const Quadric& other) {
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] += other.q[i];
  }
  // The weights of all planes.
  double weight() const { return q[0] + q[3] + q[5]; }
  double at(const Vector3& p) const {
    return q[0] * p.x() * p.x() + q[3] * p.y() * p.y() + q[5] * p.z() * p.z() + q[9] +
           2 * (q[1] * p.x() * p.y() + q[2] * p.x() * p.z() + q[4] * p.y() * p.z() + q[6] * p.x() + q[7] * p.y() +
                q[8] * p.z());
  }
};

// Neighbors of one vertex: lower bound of the cost and position in its ring.
using Candidates = Array<std::pair<double, std::size_t>>;

class CollapseCosts {
 public:
  // Above this valence a vertex waits until its neighbors are gone: looking at it is dear and it makes bad rings.
  static constexpr std::size_t patient_valence = 64;

  // Looks at every vertex of `rings`. `seed` varies the order of equally good steps.
  CollapseCosts(std::span<const Vector3> positions, VertexRings rings, std::uint64_t seed, Ties ties,
                const base::Host& host, const base::ThreadPool& pool);

  // Finds target and cost of a vertex. A `patient` look passes over those of high valence. Reads the rings, quadrics
  // and positions of the vertex and its neighbors, and writes what belongs to the vertex: vertices without a common
  // neighbor may be looked at by several threads.
  void choose(Index vertex, bool patient, Candidates& candidates);

  // Merges collapse.removed into collapse.kept. `ring` is as in VertexRings::collapse.
  void collapse(const Collapse& collapse, std::span<const Index> ring);

  // What was found about a vertex holds no more, since its neighborhood changed: several threads may say so at once.
  void mark_stale(Index vertex, bool stale) { std::atomic_ref(stale_[vertex]).store(stale, std::memory_order_relaxed); }
  bool is_stale(Index vertex) { return std::atomic_ref(stale_[vertex]).load(std::memory_order_relaxed) != 0; }

  bool is_dead(Index vertex) const { return dead_[vertex] != 0; }
  Index target(Index vertex) const { return target_[vertex]; }  // or no_index
  double cost(Index vertex) const { return cost_[vertex]; }
  void set_cost(Index vertex, double cost) { cost_[vertex] = cost; }

  // Factor on costs that decides among equals.
  double tie_break(Index vertex) const { return tie_breaker_(positions_[vertex]); }

  // With five vertices left one of valence 3 is no flaw any more.
  void set_few_left() { few_left_ = true; }

  std::size_t vertex_count() const { return positions_.size(); }
  std::size_t alive_at_first() const { return alive_; }
  VertexRings& rings() { return rings_; }

 private:
  // How many of the cheapest feasible neighbors are looked at closely.
  static constexpr int close_looks = 4;

  void sum_quadrics(const base::ThreadPool& pool);
  void choose_first_targets(const base::ThreadPool& pool);
  bool link_condition(Index vertex, std::size_t position) const;
  double penalty(Index vertex, std::size_t position) const;

  std::span<const Vector3> positions_;
  const base::Host& host_;
  std::uint64_t seed_;
  Ties ties_;
  VertexRings rings_;
  TieBreaker tie_breaker_;
  std::size_t alive_ = 0;
  bool few_left_ = false;
  Array<Quadric> quadric_;
  Array<Index> target_;
  Array<double> cost_;
  Array<std::uint8_t> stale_;
  Array<std::uint8_t> dead_;
};

// Room for the candidates of a patient look that requires no host for memory.
struct CandidatesOnStack {
  std::array<std::byte, 2 * CollapseCosts::patient_valence * sizeof(Candidates::value_type)> room;
  std::pmr::monotonic_buffer_resource memory{room.data(), room.size()};
  Candidates candidates{&memory};
  CandidatesOnStack() { candidates.reserve(CollapseCosts::patient_valence); }
};

}  // namespace orbicube::sphere_map
