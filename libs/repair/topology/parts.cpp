#include "repair/topology/parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/edge_table.h"
#include "repair/soup/soup.h"

namespace orbicube::repair {
namespace {

mesh::DisjointSets sets_of(const Soup& soup, const base::Host& host) {
  mesh::DisjointSets sets(soup.triangles.size(), host.memory);
  const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    for (std::size_t i = 1; i < h.size(); ++i)
      sets.unite(h[0] / 3, h[i] / 3);
  }
  return sets;
}

double area_of(const Soup& soup, const Triangle& t) {
  const Vector3& a = soup.positions[t[0]];
  return 0.5 * (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a).norm();
}

Array<Part> parts_of(const Soup& soup, mesh::DisjointSets& sets, const base::Host& host) {
  Array<Index> number(soup.triangles.size(), no_index, host.memory);
  Array<Part> parts(host.memory);
  for (Index t = 0; t < soup.triangles.size(); ++t) {
    const Index first = sets.find(t);
    if (number[first] == no_index) {
      number[first] = static_cast<Index>(parts.size());
      parts.push_back({first, 0, 0});
    }
    Part& part = parts[number[first]];
    ++part.triangles;
    part.area += area_of(soup, soup.triangles[t]);
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.area > b.area; });
  return parts;
}

// Keeps those with keep(part); the others are recorded.
void drop_parts(Soup& soup, mesh::DisjointSets& sets, std::span<const Part> parts, std::span<const std::uint8_t> keep,
                PartFigures& figures, const Context& context) {
  Array<std::uint8_t> of_set(soup.triangles.size(), 0, soup.memory());
  Array<std::uint8_t> of_triangle(soup.triangles.size(), 0, soup.memory());
  double total = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    total += parts[p].area;
    of_set[parts[p].first] = keep[p];
    if (keep[p] != 0) continue;
    figures.dropped_triangles += parts[p].triangles;
    context.record(Action::dropped_part, centroid(soup, soup.triangles[parts[p].first]), parts[p].area,
                   parts[p].triangles);
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (keep[p] == 0 && total > 0) figures.dropped_area_percent += 100 * parts[p].area / total;
  }
  for (Index t = 0; t < soup.triangles.size(); ++t)
    of_triangle[t] = of_set[sets.find(t)];
  for (Index t = 0; t < soup.triangles.size(); ++t) {
    if (of_triangle[t] == 0 && soup.triangle_source[t] != no_index) context.counted[soup.triangle_source[t]] = 0;
  }
  keep_triangles(soup, of_triangle);
}

// The solid angle of a triangle as seen from p (van Oosterom and Strackee 1983).
double solid_angle(const Soup& soup, const Triangle& t, const Vector3& p) {
  const Vector3 a = soup.positions[t[0]] - p, b = soup.positions[t[1]] - p, c = soup.positions[t[2]] - p;
  const double x = a.norm(), y = b.norm(), z = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
}

// The number of other parts that a part is in. Parts may touch: of a few points the one whose winding number is nearest
// to a whole one counts.
std::int64_t depth_of(const Soup& soup, mesh::DisjointSets& sets, const Part& part, const Context& context) {
  constexpr int max_points = 5;
  std::int64_t depth = 0;
  double least = 2;
  int points = 0;
  for (Index of = part.first; of < soup.triangles.size() && points < max_points && least > 1e-6; ++of) {
    if (sets.find(of) != part.first) continue;
    ++points;
    const Vector3 from = centroid(soup, soup.triangles[of]);
    double angle = 0;
    for (Index t = 0; t < soup.triangles.size(); ++t) {
      if (t % 65536 == 0) context.host.report("nested parts", t, soup.triangles.size());
      if (sets.find(t) != part.first) angle += solid_angle(soup, soup.triangles[t], from);
    }
    const double winding = angle / (4 * std::numbers::pi);
    if (!(std::abs(winding - std::round(winding)) < least)) continue;
    least = std::abs(winding - std::round(winding));
    depth = std::llround(winding);
  }
  return depth;
}

}  // namespace

Array<Part> parts_of(const Soup& soup, const base::Host& host) {
  mesh::DisjointSets sets = sets_of(soup, host);
  return parts_of(soup, sets, host);
}

PartFigures keep_parts(Soup& soup, const PartOptions& options, const Context& context) {
  mesh::DisjointSets sets = sets_of(soup, context.host);
  const Array<Part> parts = parts_of(soup, sets, context.host);
  PartFigures figures;
  figures.found = figures.kept = parts.size();
  double total = 0;
  for (const Part& part : parts)
    total += part.area;
  Array<std::uint8_t> keep(parts.size(), 0, soup.memory());
  std::size_t kept = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    // The largest stays whatever the limit.
    const bool large = p == 0 || 100 * parts[p].area >= options.min_area_percent * total;
    keep[p] = large && (options.keep == 0 || p < options.keep);
    kept += keep[p];
  }
  figures.kept = kept;
  if (kept < parts.size()) drop_parts(soup, sets, parts, keep, figures, context);
  return figures;
}

void settle_nested_parts(Soup& soup, bool cavities, PartFigures& figures, const Context& context) {
  mesh::DisjointSets sets = sets_of(soup, context.host);
  const Array<Part> parts = parts_of(soup, sets, context.host);
  if (parts.size() < 2) return;
  Array<std::uint8_t> keep(parts.size(), 1, soup.memory());
  Array<std::uint8_t> inward(soup.triangles.size(), 0, soup.memory());
  std::size_t dropped = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::int64_t depth = depth_of(soup, sets, parts[p], context);
    if (cavities && depth % 2 != 0) {
      inward[parts[p].first] = 1;
      ++figures.cavities;
    } else if (!cavities && depth > 0) {
      keep[p] = 0;
      ++dropped;
    }
  }
  for (Index t = 0; t < soup.triangles.size(); ++t) {
    if (inward[sets.find(t)] != 0) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  }
  if (dropped == 0) return;
  figures.kept -= dropped;
  drop_parts(soup, sets, parts, keep, figures, context);
}

}  // namespace orbicube::repair
