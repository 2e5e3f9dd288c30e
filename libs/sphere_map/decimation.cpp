#include "sphere_map/decimation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <queue>
#include <utility>

#include "base/error.h"
#include "sphere_map/level.h"

namespace orbicube::sphere_map {
namespace {

using mesh::no_index;
using mesh::Vector3;

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
  double at(const Vector3& p) const {
    return q[0] * p.x() * p.x() + q[3] * p.y() * p.y() + q[5] * p.z() * p.z() + q[9] +
           2 * (q[1] * p.x() * p.y() + q[2] * p.x() * p.z() + q[4] * p.y() * p.z() + q[6] * p.x() + q[7] * p.y() +
                q[8] * p.z());
  }
};

// A number in [0, 1) that depends on vertex and seed only (splitmix64, Steele et al. 2014).
double random_of(std::uint64_t vertex, std::uint64_t seed) {
  std::uint64_t z = (seed << 32) + vertex + 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

class Decimator {
 public:
  Decimator(std::span<const Vector3> positions, VertexRings rings, std::uint64_t seed, const base::Host& host,
            const base::Team& team);

  Decimation run();

 private:
  // Above this valence a vertex waits until its neighbours are gone: looking at it is dear and it makes bad rings.
  static constexpr std::size_t patient_valence = 64;
  // How many of the cheapest feasible neighbours are looked at closely.
  static constexpr int close_looks = 4;

  using Candidates = Array<std::pair<double, std::size_t>>;  // of one vertex: quadric error and position in its ring

  void sum_quadrics(const base::Team& team);
  void choose_first_targets(const base::Team& team);
  bool link_condition(Index vertex, std::size_t position) const;
  double penalty(Index vertex, std::size_t position) const;
  void choose_target(Index vertex, bool patient, Candidates& candidates);
  void refresh(Index vertex, bool patient);
  void push(Index vertex) { heap_.push({cost_[vertex], vertex}); }
  void refill_heap();

  std::span<const Vector3> positions_;
  const base::Host& host_;
  std::uint64_t seed_;
  VertexRings rings_;
  std::size_t alive_ = 0;
  Array<Quadric> quadric_;
  Array<Index> target_;  // best neighbour to merge into, or no_index
  Array<double> cost_;
  Array<std::uint8_t> stale_;  // neighbourhood changed since the cost was computed
  Array<std::uint8_t> dead_;
  using Entry = std::pair<double, Index>;
  using Heap = std::priority_queue<Entry, Array<Entry>, std::greater<>>;
  Heap heap_;
  Candidates candidates_;
};

Decimator::Decimator(std::span<const Vector3> positions, VertexRings rings, std::uint64_t seed, const base::Host& host,
                     const base::Team& team)
    : positions_(positions),
      host_(host),
      seed_(seed),
      rings_(std::move(rings)),
      quadric_(positions.size(), host.memory),
      target_(positions.size(), no_index, host.memory),
      cost_(positions.size(), 0, host.memory),
      stale_(positions.size(), 0, host.memory),
      dead_(positions.size(), 0, host.memory),
      heap_(std::greater<>(), Array<Entry>(host.memory)),
      candidates_(host.memory) {
  for (Index v = 0; v < positions.size(); ++v) {
    dead_[v] = rings_.valence(v) == 0;
    alive_ += !dead_[v];
  }
  sum_quadrics(team);
  choose_first_targets(team);
}

void Decimator::sum_quadrics(const base::Team& team) {
  host_.report("decimation", 0, alive_);
  team.run_pieces(positions_.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const auto ring = rings_[v];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vector3& p = positions_[v];
        const Vector3 normal = (positions_[ring[i]] - p).cross(positions_[ring[i + 1 < ring.size() ? i + 1 : 0]] - p);
        const double length = normal.norm();
        if (length > 0) quadric_[v].add_plane(normal / length, -normal.dot(p) / length, 0.5 * length);
      }
    }
  });
}

void Decimator::choose_first_targets(const base::Team& team) {
  constexpr std::size_t batch = 65536;  // some tens of milliseconds of work between reports
  for (std::size_t first = 0; first < positions_.size(); first += batch) {
    host_.report("decimation", 0, alive_);
    team.run_pieces(std::min(batch, positions_.size() - first), vertices_a_piece,
                    [&](std::size_t begin, std::size_t end) {
                      std::array<std::byte, 2 * patient_valence * sizeof(Candidates::value_type)> room;
                      std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
                      Candidates candidates(&memory);
                      candidates.reserve(patient_valence);
                      for (std::size_t v = first + begin; v < first + end; ++v) {
                        if (!dead_[v]) choose_target(static_cast<Index>(v), true, candidates);
                      }
                    });
  }
  Array<Entry> entries(host_.memory);
  entries.reserve(alive_);
  for (Index v = 0; v < dead_.size(); ++v) {
    if (target_[v] != no_index) entries.push_back({cost_[v], v});
  }
  heap_ = Heap(std::greater<>(), std::move(entries));
}

// Merging `vertex` into the neighbour at `position` keeps a manifold exactly when the two have no common neighbour but
// the two that their edge faces (Dey et al. 1999).
bool Decimator::link_condition(Index vertex, std::size_t position) const {
  const auto ring = rings_[vertex];
  const Index other = ring[position];
  for (std::size_t j = 2; j + 1 < ring.size(); ++j) {
    if (rings_.adjacent(ring[(position + j) % ring.size()], other)) return false;
  }
  const Index left = ring[(position + 1) % ring.size()];
  const Index right = ring[(position + ring.size() - 1) % ring.size()];
  return rings_.valence(left) > 3 && rings_.valence(right) > 3;
}

// Factor and summand on the quadric error: (factor, shape term). Larger is worse.
double Decimator::penalty(Index vertex, std::size_t position) const {
  const auto ring = rings_[vertex];
  const std::size_t k = ring.size();
  const Index target = ring[position];
  double factor = 1;
  for (const Index opposite : {ring[(position + 1) % k], ring[(position + k - 1) % k]}) {
    if (rings_.valence(opposite) == 4) factor *= 3;  // it falls to 3
  }
  const std::size_t valence = rings_.valence(target) + k - 4;
  if (valence < 4 && alive_ > 5) factor *= 3;
  if (valence > 9) factor *= 1 + 0.3 * static_cast<double>(valence - 9);

  const Vector3& to = positions_[target];
  const Vector3& from = positions_[vertex];
  double worst_quality = 1;  // 1 for an equilateral triangle, 0 for a sliver
  double area = 0;
  for (std::size_t j = 1; j + 1 < k; ++j) {
    const Vector3& x = positions_[ring[(position + j) % k]];
    const Vector3& y = positions_[ring[(position + j + 1) % k]];
    const Vector3 normal = (x - to).cross(y - to);
    const Vector3 old_normal = (x - from).cross(y - from);
    const double twice_area = normal.norm();
    const double squares = (x - to).squaredNorm() + (y - to).squaredNorm() + (x - y).squaredNorm();
    if (squares > 0) worst_quality = std::min(worst_quality, 2 * std::sqrt(3.0) * twice_area / squares);
    const double cosine = normal.dot(old_normal);
    if (cosine < 0.2 * twice_area * old_normal.norm()) factor *= cosine < 0 ? 6 : 2;
    area += twice_area;
  }
  const double error = quadric_[vertex].at(to) + quadric_[target].at(to);
  // The second term decides where the surface is flat and every error is zero: short edges and small stars go first.
  return (std::max(error, 0.0) + 1e-6 * (to - from).squaredNorm() * area) * factor * (1 + 0.1 / (worst_quality + 1e-6));
}

void Decimator::choose_target(Index vertex, bool patient, Candidates& candidates) {
  target_[vertex] = no_index;
  cost_[vertex] = std::numeric_limits<double>::infinity();
  const auto ring = rings_[vertex];
  if (patient && ring.size() > patient_valence) return;
  candidates.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector3& to = positions_[ring[i]];
    candidates.emplace_back(quadric_[vertex].at(to) + quadric_[ring[i]].at(to), i);
  }
  std::sort(candidates.begin(), candidates.end());
  int looks = 0;
  for (const auto& [error, position] : candidates) {
    if (error >= cost_[vertex] || (looks >= close_looks && target_[vertex] != no_index)) break;
    if (!link_condition(vertex, position)) continue;
    ++looks;
    const double cost = penalty(vertex, position);
    if (cost < cost_[vertex] || target_[vertex] == no_index) {
      cost_[vertex] = cost;
      target_[vertex] = ring[position];
    }
  }
  if (seed_ != 0) cost_[vertex] *= 1 + 0.05 * random_of(vertex, seed_);
}

void Decimator::refresh(Index vertex, bool patient) {
  stale_[vertex] = 0;
  choose_target(vertex, patient, candidates_);
  if (target_[vertex] != no_index) push(vertex);
}

// When nothing is left to be done patiently, look at every vertex, whatever its valence.
void Decimator::refill_heap() {
  for (Index v = 0; v < dead_.size(); ++v) {
    if (!dead_[v]) refresh(v, false);
  }
  if (heap_.empty()) throw base::Error("internal", "decimation is stuck: the surface is no closed genus-0 manifold");
}

Decimation Decimator::run() {
  Decimation result{Array<Collapse>(host_.memory), Array<Index>(host_.memory), {}, VertexRings(0, {}, host_)};
  if (alive_ < 4) throw base::Error("internal", "decimation of fewer than four vertices");
  const std::size_t start = alive_;
  result.collapses.reserve(start - 4);
  result.ring_pool.reserve(6 * start);
  while (alive_ > 4) {
    if (heap_.empty()) refill_heap();
    const auto [cost, vertex] = heap_.top();
    heap_.pop();
    if (dead_[vertex] || cost != cost_[vertex]) continue;  // an entry that was replaced
    if (stale_[vertex]) {
      refresh(vertex, true);
      continue;
    }
    if (target_[vertex] == no_index) continue;

    const auto ring = rings_[vertex];
    const std::size_t position = rings_.find(vertex, target_[vertex]);
    const Collapse collapse{vertex, target_[vertex], static_cast<Index>(result.ring_pool.size()),
                            static_cast<Index>(ring.size())};
    for (std::size_t j = 0; j < ring.size(); ++j)
      result.ring_pool.push_back(ring[(position + j) % ring.size()]);
    result.collapses.push_back(collapse);
    rings_.collapse(collapse, result.ring(collapse));
    quadric_[collapse.kept].add(quadric_[vertex]);
    dead_[vertex] = 1;
    --alive_;

    const auto touch = [&](Index v) {
      if (target_[v] == no_index && !stale_[v]) {  // it had no feasible neighbour and so no entry: look again
        cost_[v] = 0;
        push(v);
      }
      stale_[v] = 1;
    };
    touch(collapse.kept);
    for (const Index v : rings_[collapse.kept])
      touch(v);
    if (alive_ % 1024 == 0) host_.report("decimation", start - alive_, start - 4);
  }
  const auto first = static_cast<Index>(std::find(dead_.begin(), dead_.end(), 0) - dead_.begin());
  const auto ring = rings_[first];
  result.tetrahedron = {first, ring[0], ring[1], ring[2]};
  result.rings = std::move(rings_);
  return result;
}

}  // namespace

Decimation decimate(std::span<const Vector3> positions, VertexRings rings, std::uint64_t seed, const base::Host& host,
                    const base::Team& team) {
  return Decimator(positions, std::move(rings), seed, host, team).run();
}

}  // namespace orbicube::sphere_map
