#include "sphere_map/hierarchy/decimation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "sphere_map/hierarchy/collapse_costs.h"
#include "sphere_map/hierarchy/collapse_queue.h"
#include "sphere_map/hierarchy/regional_decimation.h"

namespace orbicube::sphere_map {
namespace {

// When nothing is left to be done patiently, look at every vertex, whatever its valence.
void refill(CollapseQueue& queue, CollapseCosts& costs, Candidates& candidates) {
  for (Index v = 0; v < costs.vertex_count(); ++v) {
    if (!costs.is_dead(v)) queue.refresh(v, false, candidates);
  }
  if (queue.empty()) throw base::Error("internal", "decimation is stuck: the surface is no closed genus-0 manifold");
}

// One collapse after the other, always the cheapest of all.
void collapse_to_tetrahedron(CollapseCosts& costs, Decimation& result, const base::Host& host) {
  VertexRings& rings = costs.rings();
  Array<Index> vertices(costs.vertex_count(), host.memory);
  std::iota(vertices.begin(), vertices.end(), Index{0});
  CollapseQueue queue(costs, host.memory);
  queue.fill(vertices, host.memory);
  Candidates candidates(host.memory);
  const std::size_t total = costs.alive_at_first() - 4;
  while (result.collapses.size() < total) {
    const Index vertex = queue.pop([](Index) { return true; }, candidates);
    if (vertex == no_index) {
      refill(queue, costs, candidates);
      continue;
    }
    const auto ring = rings[vertex];
    const std::size_t position = rings.find(vertex, costs.target(vertex));
    const Collapse collapse{vertex, costs.target(vertex), static_cast<Index>(result.ring_pool.size()),
                            static_cast<Index>(ring.size())};
    for (std::size_t j = 0; j < ring.size(); ++j)
      result.ring_pool.push_back(ring[(position + j) % ring.size()]);
    result.collapses.push_back(collapse);
    costs.collapse(collapse, result.ring(collapse));
    if (total - result.collapses.size() == 1) costs.set_few_left();
    queue.touch_around(collapse.kept, [](Index) { return true; });
    if (result.collapses.size() % 1024 == 0) host.report("decimation", result.collapses.size(), total);
  }
}

std::array<Index, 4> tetrahedron_left(CollapseCosts& costs) {
  const auto comes_first = [&](Index a, Index b) { return costs.tie_break(a) < costs.tie_break(b); };
  Index first = no_index;
  for (Index v = 0; v < costs.vertex_count(); ++v) {
    if (!costs.is_dead(v) && (first == no_index || comes_first(v, first))) first = v;
  }
  const auto ring = costs.rings()[first];
  costs.rings().start_with(first, *std::min_element(ring.begin(), ring.end(), comes_first));
  return {first, ring[0], ring[1], ring[2]};
}

}  // namespace

Decimation decimate(std::span<const Vector3> positions, VertexRings rings, std::uint64_t seed, const base::Host& host,
                    const base::ThreadPool& pool, std::size_t region_size, Ties ties) {
  CollapseCosts costs(positions, std::move(rings), seed, ties, host, pool);
  const std::size_t count = costs.alive_at_first();
  if (count < 4) throw base::Error("internal", "decimation of fewer than four vertices");
  Decimation result{Array<Collapse>(host.memory), Array<Index>(host.memory), {}, VertexRings(0, {}, host)};
  result.collapses.reserve(count - 4);
  result.ring_pool.reserve(6 * count);
  if (count >= min_regions * region_size) decimate_regions(positions, region_size, costs, result, host, pool);
  collapse_to_tetrahedron(costs, result, host);

  result.tetrahedron = tetrahedron_left(costs);
  result.rings = std::move(costs.rings());
  return result;
}

Array<Index> renumber(Decimation& decimation, const base::Host& host) {
  const std::size_t count = decimation.rings.vertex_count();
  // Of each vertex: with those that were merged into it.
  Array<Index> size(count, 1, host.memory);
  for (const Collapse& c : decimation.collapses)
    size[c.kept] += size[c.removed];
  host.report("decimation", count, count);
  Array<Index> number(count, no_index, host.memory);
  Index next = 0;
  for (const Index v : decimation.tetrahedron) {
    number[v] = next;
    next += size[v];
  }
  // The latest merged into a vertex has the end of its range.
  for (auto c = decimation.collapses.rbegin(); c != decimation.collapses.rend(); ++c) {
    size[c->kept] -= size[c->removed];
    number[c->removed] = number[c->kept] + size[c->kept];
  }
  for (Index& n : number) {
    if (n == no_index) n = next++;
  }

  host.report("decimation", count, count);
  decimation.rings.renumber(number);
  host.report("decimation", count, count);
  for (Index& v : decimation.ring_pool)
    v = number[v];
  for (Collapse& c : decimation.collapses) {
    c.removed = number[c.removed];
    c.kept = number[c.kept];
    decimation.rings.start_with(c.removed, c.kept);
  }
  for (Index& v : decimation.tetrahedron)
    v = number[v];
  const auto [first, second, third, fourth] = decimation.tetrahedron;
  decimation.rings.start_with(first, second);
  for (const Index v : {second, third, fourth})
    decimation.rings.start_with(v, first);
  return number;
}

void set_tetrahedron(const std::array<Index, 4>& vertices, std::span<Vector3> directions) {
  const double a = 1 / std::sqrt(3.0);
  const auto [top, first, second, third] = vertices;
  directions[top] = Vector3(a, a, a);
  // The first three neighbors counter-clockwise seen from outside at `top`.
  directions[first] = Vector3(a, -a, -a);
  directions[second] = Vector3(-a, a, -a);
  directions[third] = Vector3(-a, -a, a);
}

}  // namespace orbicube::sphere_map
