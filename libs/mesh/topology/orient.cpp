#include "mesh/topology/orient.h"

#include <algorithm>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/measures.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::mesh {
namespace {

constexpr std::size_t triangles_between_reports = 65536;

void turn(Triangle& t) {
  std::swap(t[1], t[2]);
}

}  // namespace

std::vector<std::string> OrientReport::notes() const {
  std::vector<std::string> notes;
  if (reversed_triangles > 0)
    notes.push_back(base::counted(reversed_triangles, "triangle was reversed to agree with its neighbors",
                                  "triangles were reversed to agree with their neighbors"));
  if (inward_oriented) notes.emplace_back("the surface was inward-oriented; all triangles were reversed");
  return notes;
}

std::optional<Array<std::uint8_t>> orientation_signs(std::span<const Triangle> triangles, const EdgeTable& edges,
                                                     const base::Host& host) {
  // The neighbor over each half-edge of an edge with two triangles.
  Array<Index> opposite(3 * triangles.size(), no_index, host.memory);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    if (h.size() != 2) continue;
    opposite[h[0]] = h[1];
    opposite[h[1]] = h[0];
  }
  constexpr std::uint8_t unknown = 2;
  Array<std::uint8_t> turned(triangles.size(), unknown, host.memory);
  Array<Index> open(host.memory);
  std::size_t visited = 0;
  for (Index seed = 0; seed < triangles.size(); ++seed) {
    if (turned[seed] != unknown) continue;
    turned[seed] = 0;
    open.push_back(seed);
    while (!open.empty()) {
      const Index t = open.back();
      open.pop_back();
      if (visited++ % triangles_between_reports == 0) host.report("orienting", visited, triangles.size());
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        if (opposite[h] == no_index) continue;
        const bool same_way = start_of(triangles, h) == start_of(triangles, opposite[h]);
        const auto needed = static_cast<std::uint8_t>(same_way ? 1 - turned[t] : turned[t]);
        std::uint8_t& other = turned[triangle_of(opposite[h])];
        if (other == unknown) {
          other = needed;
          open.push_back(triangle_of(opposite[h]));
        } else if (other != needed) {
          return std::nullopt;
        }
      }
    }
  }
  return turned;
}

OrientReport orient(std::span<const Vector3> positions, std::span<Triangle> triangles, const base::Host& host) {
  const EdgeTable edges(positions.size(), triangles, host);
  auto turned = orientation_signs(triangles, edges, host);
  if (!turned) throw base::Error("non-orientable", "the surface has one side only, like a Moebius strip");

  // Turn the minority of each part.
  bool closed = edges.size() > 0;
  DisjointSets parts(triangles.size(), host.memory);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (e % triangles_between_reports == 0) host.report("orienting", e, edges.size());
    const auto h = edges.half_edges(e);
    if (h.size() == 2) parts.unite(triangle_of(h[0]), triangle_of(h[1]));
    closed = closed && h.size() % 2 == 0;
  }
  Array<std::int64_t> excess(triangles.size(), 0, host.memory);  // turned minus unturned of each part
  for (Index t = 0; t < triangles.size(); ++t)
    excess[parts.find(t)] += (*turned)[t] ? 1 : -1;
  OrientReport report;
  for (Index t = 0; t < triangles.size(); ++t) {
    if (((*turned)[t] != 0) == (excess[parts.find(t)] > 0)) continue;
    turn(triangles[t]);
    ++report.reversed_triangles;
  }
  if (closed && measures(positions, triangles, host).volume < 0) {
    std::ranges::for_each(triangles, turn);
    report.inward_oriented = true;
  }
  return report;
}

}  // namespace orbicube::mesh
