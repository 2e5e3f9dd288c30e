#include "sphere_map/correspondence/placement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/rounding.h"

namespace orbicube::sphere_map {
namespace {

std::uint64_t edge_key(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
}

// The longest edge of each triangle that is not positive, on the shape's own sphere; those that are too short to be cut
// are left out.
Array<std::uint64_t> edges_to_cut(const Placement& placed, const base::Host& host) {
  constexpr double shortest = 1e-7;  // directions are exact to 1e-16
  Array<std::uint64_t> edges(host.memory);
  for (std::size_t i = 0; i < placed.triangles.size(); ++i) {
    if (i % 65536 == 0) host.report("placing the map", i, placed.triangles.size());
    const Triangle& t = placed.triangles[i];
    if (mesh::orientation_from_origin(placed.directions[t[0]], placed.directions[t[1]], placed.directions[t[2]]) > 0)
      continue;
    std::array<double, 3> square{};
    for (std::size_t k = 0; k < 3; ++k)
      square[k] = (placed.own[t[(k + 1) % 3]] - placed.own[t[k]]).squaredNorm();
    const auto longest = static_cast<std::size_t>(std::max_element(square.begin(), square.end()) - square.begin());
    if (square[longest] > shortest * shortest) edges.push_back(edge_key(t[longest], t[(longest + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// Each edge gets a vertex in its middle, numbered from `first` on, and each triangle is replaced by its pieces.
void cut(Placement& placed, const Array<std::uint64_t>& edges, Index first) {
  Array<Triangle>& triangles = placed.triangles;
  const std::size_t count = triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = triangles[i];
    std::array<Index, 3> middle{};
    std::size_t cuts = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t key = edge_key(t[k], t[(k + 1) % 3]);
      const auto at = std::lower_bound(edges.begin(), edges.end(), key);
      const bool is_cut = at != edges.end() && *at == key;
      middle[k] = is_cut ? first + static_cast<Index>(at - edges.begin()) : mesh::no_index;
      cuts += is_cut;
    }
    if (cuts == 0) continue;
    placed.triangle_sources.insert(placed.triangle_sources.end(), cuts, Index{placed.triangle_sources[i]});
    if (cuts == 3) {
      triangles[i] = {middle[0], middle[1], middle[2]};
      for (std::size_t k = 0; k < 3; ++k)
        triangles.push_back({t[k], middle[k], middle[(k + 2) % 3]});
      continue;
    }
    // With one edge cut, it is from a to b; with two, the other one is from b to c.
    std::size_t k = 0;
    while (middle[k] == mesh::no_index || (cuts == 2 && middle[(k + 1) % 3] == mesh::no_index))
      ++k;
    const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], ab = middle[k], bc = middle[(k + 1) % 3];
    if (cuts == 1) {
      triangles[i] = {a, ab, c};
      triangles.push_back({ab, b, c});
    } else {
      triangles[i] = {ab, b, bc};
      triangles.push_back({a, ab, bc});
      triangles.push_back({a, bc, c});
    }
  }
}

}  // namespace

std::optional<Placement> placed_one_to_one(std::span<const Vector3> positions, std::span<const Vector3> directions,
                                           std::span<const Triangle> triangles, const SphereMove& move,
                                           const base::Host& host) {
  if (positions.size() != directions.size())
    throw base::Error("invalid-argument", "positions and directions have different sizes");
  Placement result(host.memory);
  result.positions.assign(positions.begin(), positions.end());
  result.triangles.assign(triangles.begin(), triangles.end());
  result.triangle_sources.resize(triangles.size());
  std::iota(result.triangle_sources.begin(), result.triangle_sources.end(), Index{0});
  result.own.assign(directions.begin(), directions.end());
  result.directions.assign(directions.begin(), directions.end());
  move(result.directions);
  constexpr int max_rounds = 100;
  const std::size_t max_vertices = 2 * positions.size() + 25000;
  for (int round = 0; round < max_rounds && result.own.size() < max_vertices; ++round) {
    const Array<std::uint64_t> edges = edges_to_cut(result, host);
    if (edges.empty()) break;
    const auto first = static_cast<Index>(result.own.size());
    for (const std::uint64_t key : edges) {
      const auto a = static_cast<std::size_t>(key >> 32U), b = static_cast<std::size_t>(key & 0xFFFFFFFFU);
      result.positions.push_back(0.5 * result.positions[a] + 0.5 * result.positions[b]);
      result.parents.push_back({static_cast<Index>(a), static_cast<Index>(b)});
      result.own.push_back((result.own[a] + result.own[b]).normalized());
    }
    result.directions.insert(result.directions.end(), result.own.begin() + first, result.own.end());
    move(std::span(result.directions).subspan(first));
    cut(result, edges, first);
  }
  result.added = result.own.size() - positions.size();
  if (count_not_positive(result.triangles, result.directions) == 0) return result;
  const Store as_it_is = [](Index, const Vector3& direction) { return direction; };
  RoundedMap repaired = round_and_repair(result.triangles, result.directions, as_it_is, 0, host);
  if (count_not_positive(result.triangles, repaired.directions) > 0) return std::nullopt;
  result.directions = std::move(repaired.directions);
  result.moved = repaired.moved;
  return result;
}

}  // namespace orbicube::sphere_map
