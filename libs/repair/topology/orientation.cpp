#include "repair/topology/orientation.h"

#include <algorithm>
#include <span>
#include <utility>

#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/orient.h"

namespace orbicube::repair {
namespace {

void turn(Triangle& t) {
  std::swap(t[1], t[2]);
}

// Faces connected by edges of two faces, or by any.
mesh::DisjointSets groups_of(const Soup& soup, const mesh::EdgeTable& edges, bool any_edge) {
  mesh::DisjointSets groups(soup.triangles.size(), soup.memory());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    if (h.size() < 2 || (h.size() > 2 && !any_edge)) continue;
    for (std::size_t i = 1; i < h.size(); ++i)
      groups.unite(h[0] / 3, h[i] / 3);
  }
  return groups;
}

// Turns groups without boundary that have negative volume.
void turn_groups_outward(Soup& soup, const mesh::EdgeTable& edges, mesh::DisjointSets& groups) {
  const std::size_t n = soup.triangles.size();
  Array<std::uint8_t> open(n, 0, soup.memory());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    if (h.size() % 2 == 1) {
      for (const Index i : h)
        open[groups.find(i / 3)] = 1;
    }
  }
  // Relative to a vertex of each group, so that nothing is lost far from the origin.
  Array<double> volume(n, 0.0, soup.memory());
  for (Index t = 0; t < n; ++t) {
    const Index group = groups.find(t);
    const Vector3& origin = soup.positions[soup.triangles[group][0]];
    const Triangle& c = soup.triangles[t];
    volume[group] +=
        (soup.positions[c[0]] - origin).dot((soup.positions[c[1]] - origin).cross(soup.positions[c[2]] - origin));
  }
  for (Index t = 0; t < n; ++t) {
    const Index group = groups.find(t);
    if (open[group] == 0 && volume[group] < 0) turn(soup.triangles[t]);
  }
}

// Turns the fewer faces of each patch.
void turn_minorities(Soup& soup, const mesh::EdgeTable& edges, std::span<const std::uint8_t> turned) {
  const std::size_t n = soup.triangles.size();
  mesh::DisjointSets patches = groups_of(soup, edges, false);
  Array<std::int64_t> excess(n, 0, soup.memory());  // turned minus unturned
  for (Index t = 0; t < n; ++t)
    excess[patches.find(t)] += turned[t] != 0 ? 1 : -1;
  for (Index t = 0; t < n; ++t) {
    if ((turned[t] != 0) != (excess[patches.find(t)] > 0)) turn(soup.triangles[t]);
  }
}

// Whether each edge of an even number of faces is passed as often in one direction as in the other.
bool is_balanced(const Soup& soup, const mesh::EdgeTable& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    if (h.size() % 2 == 1) continue;
    std::size_t forward = 0;
    for (const Index i : h)
      forward += mesh::start_of(soup.triangles, i) < mesh::end_of(soup.triangles, i);
    if (2 * forward != h.size()) return false;
  }
  return true;
}

}  // namespace

bool orient_patches(Soup& soup, const base::Host& host) {
  const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
  const auto turned = mesh::orientation_signs(soup.triangles, edges, host);
  if (!turned) return false;
  if (std::any_of(turned->begin(), turned->end(), [](std::uint8_t t) { return t != 0; }))
    turn_minorities(soup, edges, *turned);
  mesh::DisjointSets groups = groups_of(soup, edges, is_balanced(soup, edges));
  turn_groups_outward(soup, edges, groups);
  return true;
}

void turn_parts_outward(Soup& soup, const base::Host& host) {
  const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
  mesh::DisjointSets parts = groups_of(soup, edges, true);
  turn_groups_outward(soup, edges, parts);
}

std::size_t count_turned(const Soup& soup, std::span<const Triangle> input) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (soup.triangle_source[t] == no_index) continue;
    const Triangle& now = soup.triangles[t];
    Triangle before = input[soup.triangle_source[t]];
    Triangle sources;
    std::transform(now.begin(), now.end(), sources.begin(), [&](Index v) { return soup.vertex_source[v]; });
    turn(before);
    for (int k = 0; k < 3; ++k) {
      std::rotate(before.begin(), before.begin() + 1, before.end());
      if (before == sources) ++count;
    }
  }
  return count;
}

}  // namespace orbicube::repair
