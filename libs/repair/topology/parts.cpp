#include "repair/topology/parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "base/grouping.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/intersections.h"
#include "mesh/search/nearest.h"
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

// Which parts are inside which others.
class Nesting {
 public:
  Nesting(const Soup& soup, mesh::DisjointSets& sets, std::span<const Part> parts, const Context& context)
      : soup_(soup),
        context_(context),
        part_(soup.triangles.size(), no_index, soup.memory()),
        triangles_(soup.memory()),
        met_(soup.memory()),
        boxes_(parts.size(), soup.memory()),
        around_(soup.memory()) {
    Array<Index> of_set(soup.triangles.size(), no_index, soup.memory());
    for (std::size_t p = 0; p < parts.size(); ++p)
      of_set[parts[p].first] = static_cast<Index>(p);
    for (Index t = 0; t < soup.triangles.size(); ++t) {
      part_[t] = of_set[sets.find(t)];
      for (const Index v : soup.triangles[t])
        boxes_[part_[t]].add(soup.positions[v]);
    }
    tree_.emplace(boxes_, context.host);
    triangles_.assign(parts.size(), [&](const auto& visit) {
      for (Index t = 0; t < soup.triangles.size(); ++t)
        visit(part_[t], t);
    });
    const auto pairs = mesh::intersecting_triangles(soup.positions, soup.triangles, context.host, max_meetings);
    met_.assign(parts.size(), [&](const auto& visit) {
      for (const auto& pair : pairs) {
        if (part_[pair[0]] == part_[pair[1]]) continue;
        for (const Index t : pair)
          visit(part_[t], t);
      }
    });
  }

  // The number of other parts that a part is in: a point of it decides where it meets none, and else all points of a
  // choice have to be inside.
  std::int64_t depth(std::size_t part) {
    const std::span<const Index> own = triangles_[part], met = met_[part];
    const std::size_t points = std::min(met.empty() ? 1 : max_points, own.size());
    around_.clear();
    const Vector3 first = centroid(soup_, soup_.triangles[own[0]]);
    tree_->for_each_near({first, first}, [&](Index other) {
      if (other != part) around_.push_back({other, unknown});
    });
    for (std::size_t i = 0; i < points; ++i)
      look_from(centroid(soup_, soup_.triangles[own[i * (own.size() / points)]]), part);
    // Where parts cross, triangles that meet have corners on both sides.
    const std::size_t count = std::min(max_points, met.size());
    for (std::size_t i = 0; i < count; ++i) {
      for (const Index v : soup_.triangles[met[i * met.size() / count]])
        look_from(soup_.positions[v], part);
    }
    std::int64_t sum = 0;
    for (const Around& a : around_)
      sum += a.winding == unknown ? 0 : a.winding;
    return sum;
  }

 private:
  // Another part, with its minimum winding number around the points so far.
  struct Around {
    Index part;
    std::int64_t winding;
  };

  // Larger: parts that cross others by less are known to be not inside; linear time.
  static constexpr std::size_t max_points = 16;
  static constexpr std::size_t max_meetings = 1'000'000;  // pairs of triangles; bounds the memory
  static constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();

  // Lowers the winding numbers of the parts that may be around to those around a point, of those that it is not on.
  void look_from(const Vector3& from, std::size_t part) {
    for (Around& a : around_) {
      if (boxes_[a.part].squared_distance(from) > 0) {
        a.winding = std::min<std::int64_t>(a.winding, 0);
      } else if (a.winding > 0) {
        const double angle = angle_of(a.part, from, !met_[part].empty());
        if (!std::isnan(angle))
          a.winding = std::min<std::int64_t>(a.winding, std::llround(angle / (4 * std::numbers::pi)));
      }
    }
  }

  // The solid angle of a part; NaN where the point may be on it and is.
  double angle_of(Index part, const Vector3& from, bool may_be_on) {
    constexpr std::size_t reported = 65536;  // solid angles from one report to the next
    double angle = 0;
    for (const Index t : triangles_[part]) {
      if (++angles_ % reported == 0) context_.host.report("nested parts", 0, 0);
      if (may_be_on && is_on(soup_.triangles[t], from)) return std::numeric_limits<double>::quiet_NaN();
      angle += solid_angle(soup_, soup_.triangles[t], from);
    }
    return angle;
  }

  // Whether a point is on a triangle but for rounding, which leaves its solid angle undecided.
  bool is_on(const Triangle& t, const Vector3& p) const {
    constexpr double rounding = 1e-12;
    const Vector3 &a = soup_.positions[t[0]], &b = soup_.positions[t[1]], &c = soup_.positions[t[2]];
    const double size = std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), p.squaredNorm()});
    return (mesh::nearest_on_triangle(p, a, b, c).position - p).squaredNorm() <= rounding * rounding * size;
  }

  const Soup& soup_;
  const Context& context_;
  Array<Index> part_;                     // of each triangle
  base::Groups<Index, Index> triangles_;  // of each part
  base::Groups<Index> met_;               // those of each part that meet another part
  Array<mesh::Box> boxes_;                // of each part
  std::optional<mesh::BoundingVolumeTree> tree_;
  Array<Around> around_;
  std::size_t angles_ = 0;
};

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
  Nesting nesting(soup, sets, parts, context);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const std::int64_t depth = nesting.depth(p);
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
