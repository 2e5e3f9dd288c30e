#include "sphere_map/hierarchy/collapse_costs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/random.h"
#include "sphere_map/hierarchy/level.h"

namespace orbicube::sphere_map {
namespace {

// Share of squared length times area in a cost. Larger: edges and stars of even size at the cost of shape; smaller: on
// flat regions rounding decides.
constexpr double flat_share = 1e-6;

// A number in [0, 1) that depends on vertex and seed only.
double random_of(std::uint64_t vertex, std::uint64_t seed) {
  return base::Random((seed << 32U) + vertex).unit();
}

}  // namespace

CollapseCosts::CollapseCosts(std::span<const Vector3> positions, VertexRings rings, std::uint64_t seed, Ties ties,
                             const base::Host& host, const base::ThreadPool& pool)
    : positions_(positions),
      host_(host),
      seed_(seed),
      ties_(ties),
      rings_(std::move(rings)),
      quadric_(positions.size(), host.memory),
      target_(positions.size(), no_index, host.memory),
      cost_(positions.size(), 0, host.memory),
      stale_(positions.size(), 0, host.memory),
      dead_(positions.size(), 0, host.memory) {
  for (Index v = 0; v < positions.size(); ++v) {
    dead_[v] = rings_.valence(v) == 0;
    alive_ += !dead_[v];
  }
  if (ties == Ties::by_geometry) tie_breaker_ = TieBreaker(positions, rings_, host);
  sum_quadrics(pool);
  choose_first_targets(pool);
}

void CollapseCosts::sum_quadrics(const base::ThreadPool& pool) {
  host_.report("decimation", 0, alive_);
  pool.run_pieces(positions_.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
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

void CollapseCosts::choose_first_targets(const base::ThreadPool& pool) {
  constexpr std::size_t batch = 65536;  // some tens of milliseconds of work between reports
  for (std::size_t first = 0; first < positions_.size(); first += batch) {
    host_.report("decimation", 0, alive_);
    pool.run_pieces(std::min(batch, positions_.size() - first), vertices_a_piece,
                    [&](std::size_t begin, std::size_t end) {
                      CandidatesOnStack stack;
                      for (std::size_t v = first + begin; v < first + end; ++v) {
                        if (!dead_[v]) choose(static_cast<Index>(v), true, stack.candidates);
                      }
                    });
  }
}

// Merging `vertex` into the neighbor at `position` keeps a manifold exactly when the two have no common neighbor but
// the two that their edge faces (Dey et al. 1999).
bool CollapseCosts::link_condition(Index vertex, std::size_t position) const {
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
double CollapseCosts::penalty(Index vertex, std::size_t position) const {
  const auto ring = rings_[vertex];
  const std::size_t k = ring.size();
  const Index target = ring[position];
  double factor = 1;
  for (const Index opposite : {ring[(position + 1) % k], ring[(position + k - 1) % k]}) {
    if (rings_.valence(opposite) == 4) factor *= 3;  // it falls to 3
  }
  const std::size_t valence = rings_.valence(target) + k - 4;
  if (valence < 4 && !few_left_) factor *= 3;
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
  return (std::max(error, 0.0) + flat_share * (to - from).squaredNorm() * area) * factor *
         (1 + 0.1 / (worst_quality + 1e-6));
}

void CollapseCosts::choose(Index vertex, bool patient, Candidates& candidates) {
  target_[vertex] = no_index;
  cost_[vertex] = std::numeric_limits<double>::infinity();
  const auto ring = rings_[vertex];
  if (patient && ring.size() > patient_valence) return;
  candidates.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector3& to = positions_[ring[i]];
    double bound = quadric_[vertex].at(to) + quadric_[ring[i]].at(to);
    if (ties_ == Ties::by_geometry) {
      // A tenth of the flat share, with the weight for the area, is below the cost of every collapse.
      const double flat = 0.1 * flat_share * (to - positions_[vertex]).squaredNorm() * quadric_[vertex].weight();
      bound = (std::max(bound, 0.0) + flat) * tie_break(ring[i]);
    }
    candidates.emplace_back(bound, i);
  }
  std::sort(candidates.begin(), candidates.end());
  int looks = 0;
  for (const auto& [bound, position] : candidates) {
    if (bound >= cost_[vertex] || (looks >= close_looks && target_[vertex] != no_index)) break;
    if (!link_condition(vertex, position)) continue;
    ++looks;
    const double cost = penalty(vertex, position) * tie_break(ring[position]);
    if (cost < cost_[vertex] || target_[vertex] == no_index) {
      cost_[vertex] = cost;
      target_[vertex] = ring[position];
    }
  }
  cost_[vertex] *= tie_break(vertex);
  if (seed_ != 0) cost_[vertex] *= 1 + 0.05 * random_of(vertex, seed_);
}

void CollapseCosts::collapse(const Collapse& collapse, std::span<const Index> ring) {
  rings_.collapse(collapse, ring);
  quadric_[collapse.kept].add(quadric_[collapse.removed]);
  dead_[collapse.removed] = 1;
}

}  // namespace orbicube::sphere_map
