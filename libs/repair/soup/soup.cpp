#include "repair/soup/soup.h"

#include <algorithm>
#include <numeric>

#include "mesh/search/measures.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::repair {

Soup soup_of(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host) {
  Soup soup(host.memory);
  soup.positions.assign(positions.begin(), positions.end());
  soup.triangles.assign(triangles.begin(), triangles.end());
  soup.vertex_source.resize(positions.size());
  std::iota(soup.vertex_source.begin(), soup.vertex_source.end(), Index{0});
  soup.triangle_source.resize(triangles.size());
  std::iota(soup.triangle_source.begin(), soup.triangle_source.end(), Index{0});
  return soup;
}

void keep_triangles(Soup& soup, std::span<const std::uint8_t> keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    if (keep[t] == 0) continue;
    soup.triangles[kept] = soup.triangles[t];
    soup.triangle_source[kept++] = soup.triangle_source[t];
  }
  soup.triangles.resize(kept);
  soup.triangle_source.resize(kept);
}

std::size_t drop_unused_vertices(Soup& soup) {
  const Array<std::uint8_t> used = mesh::used_vertices(soup.positions.size(), soup.triangles, soup.memory());
  Array<Index> to(used.size(), no_index, soup.memory());
  Index kept = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    soup.positions[kept] = soup.positions[v];
    soup.vertex_source[kept] = soup.vertex_source[v];
    to[v] = kept++;
  }
  const std::size_t dropped = used.size() - kept;
  if (dropped == 0) return 0;
  soup.positions.resize(kept);
  soup.vertex_source.resize(kept);
  for (Triangle& t : soup.triangles) {
    for (Index& v : t)
      v = to[v];
  }
  return dropped;
}

CleanFigures drop_degenerate_and_duplicate(Soup& soup, const Context& context) {
  struct Sorted {
    Triangle corners;
    Index face;
    bool operator<(const Sorted& o) const { return corners != o.corners ? corners < o.corners : face < o.face; }
  };
  CleanFigures figures;
  Array<std::uint8_t> keep(soup.triangles.size(), 1, soup.memory());
  Array<Sorted> sorted(soup.memory());
  sorted.reserve(soup.triangles.size());
  for (Index t = 0; t < soup.triangles.size(); ++t) {
    if (t % 65536 == 0) context.host.report("comparing faces", t, soup.triangles.size());
    Triangle corners = soup.triangles[t];
    if (mesh::has_repeated_corner(corners)) {
      ++figures.degenerate;
      keep[t] = 0;
      if (soup.triangle_source[t] != no_index) context.counted[soup.triangle_source[t]] = 0;
      context.record(Action::removed_degenerate, centroid(soup, corners));
      continue;
    }
    std::sort(corners.begin(), corners.end());
    sorted.push_back({corners, t});
  }
  std::sort(sorted.begin(), sorted.end());
  context.host.report("comparing faces", 1, 1);
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].corners != sorted[i - 1].corners) continue;
    ++figures.duplicate;
    keep[sorted[i].face] = 0;
    context.record(Action::removed_duplicate, centroid(soup, sorted[i].corners));
  }
  if (figures.degenerate + figures.duplicate > 0) keep_triangles(soup, keep);
  return figures;
}

Vector3 centroid(const Soup& soup, const Triangle& t) {
  return (soup.positions[t[0]] + soup.positions[t[1]] + soup.positions[t[2]]) / 3;
}

}  // namespace orbicube::repair
