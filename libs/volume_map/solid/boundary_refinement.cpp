#include "volume_map/solid/boundary_refinement.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "base/error.h"
#include "base/grouping.h"
#include "mesh/search/predicates.h"
#include "volume_map/solid/freeing_splits.h"

namespace orbicube::volume_map {
namespace {

using mesh::Triangle;

// A vertex that was added on an edge of the surface, and how far from the first of the edge's ends, the lower one.
struct EdgePoint {
  std::array<Index, 2> edge;
  double part;
  Index vertex;
};

Array<EdgePoint> edge_points(const polycube::SurfaceMap& map, std::size_t given, std::pmr::memory_resource* memory) {
  Array<EdgePoint> points(memory);
  for (auto v = static_cast<Index>(given); v < map.positions.size(); ++v) {
    const polycube::VertexSource& source = map.vertex_sources[v];
    std::array<std::size_t, 3> used{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (source.corner[k] != no_index) used[count++] = k;
    }
    if (count != 2) continue;
    Index a = source.corner[used[0]], b = source.corner[used[1]];
    double part = source.weight[used[1]];
    if (a > b) {
      std::swap(a, b);
      part = source.weight[used[0]];
    }
    points.push_back({{a, b}, part, v});
  }
  std::sort(points.begin(), points.end(), [](const EdgePoint& x, const EdgePoint& y) {
    return std::tuple(x.edge, x.part, x.vertex) < std::tuple(y.edge, y.part, y.vertex);
  });
  return points;
}

// The points on one edge, in their order.
std::span<const EdgePoint> points_on(std::span<const EdgePoint> points, Index a, Index b) {
  const std::array<Index, 2> edge{std::min(a, b), std::max(a, b)};
  const auto less = [](const EdgePoint& p, const std::array<Index, 2>& e) { return p.edge < e; };
  const auto first = std::lower_bound(points.begin(), points.end(), edge, less);
  auto last = first;
  while (last != points.end() && last->edge == edge)
    ++last;
  return points.subspan(static_cast<std::size_t>(first - points.begin()), static_cast<std::size_t>(last - first));
}

struct Face {
  Triangle sorted;
  Index triangle;
};

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

Array<Face> sorted_faces(std::span<const Triangle> triangles, std::pmr::memory_resource* memory) {
  Array<Face> faces(memory);
  faces.reserve(triangles.size());
  for (Index i = 0; i < triangles.size(); ++i)
    faces.push_back({sorted(triangles[i]), i});
  std::sort(faces.begin(), faces.end(), [](const Face& x, const Face& y) { return x.sorted < y.sorted; });
  return faces;
}

// The vertices of the surface that a map was made of: those that are their own source.
std::size_t given_vertices(const polycube::SurfaceMap& map) {
  std::size_t given = 0;
  while (given < map.vertex_sources.size() && map.vertex_sources[given].corner[0] == given &&
         map.vertex_sources[given].corner[1] == no_index)
    ++given;
  return given;
}

[[noreturn]] void refuse_bound(std::size_t tetrahedron) {
  throw base::Error("no-valid-result",
                    "tetrahedron " + std::to_string(tetrahedron) + " could not be freed of the boundary");
}

class Refinement {
 public:
  Refinement(RefinedSolid& solid, const base::Host& host) : solid_(solid), parts_(host.memory) {}

  void add(const Tetrahedron& t) {
    const auto& p = solid_.positions;
    if (mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) <= 0) {
      throw base::Error("no-valid-result",
                        "cutting the solid along the edges of its polycube leaves a tetrahedron flat, at vertex " +
                            std::to_string(t[0]));
    }
    solid_.tetrahedra.push_back(t);
  }

  // The tetrahedron with the edge between its corners `a` and `b` cut at the points.
  void add_cut(const Tetrahedron& t, std::size_t a, std::size_t b, std::span<const EdgePoint> points) {
    parts_.clear();
    parts_.push_back(t[a]);
    for (std::size_t i = 0; i < points.size(); ++i)
      parts_.push_back(t[a] < t[b] ? points[i].vertex : points[points.size() - 1 - i].vertex);
    parts_.push_back(t[b]);
    for (std::size_t i = 0; i + 1 < parts_.size(); ++i) {
      Tetrahedron part = t;
      part[a] = parts_[i];
      part[b] = parts_[i + 1];
      add(part);
    }
  }

 private:
  RefinedSolid& solid_;
  Array<Index> parts_;
};

}  // namespace

RefinedSolid refine_boundary(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                             std::span<const Triangle> triangles, const polycube::SurfaceMap& map,
                             const base::Host& host) {
  Array<Vector3> places(positions.begin(), positions.end(), host.memory);
  Array<Tetrahedron> cells(tetrahedra.begin(), tetrahedra.end(), host.memory);
  split_for_freedom(places, cells, host);

  const std::size_t given = given_vertices(map);
  base::require(given <= places.size(), "the solid has fewer vertices than its surface");
  const auto shift = static_cast<Index>(map.positions.size() - given);

  RefinedSolid solid(host.memory);
  solid.positions = map.positions;
  solid.positions.insert(solid.positions.end(), places.begin() + static_cast<std::ptrdiff_t>(given), places.end());
  const Array<EdgePoint> points = edge_points(map, given, host.memory);
  const Array<Face> faces = sorted_faces(triangles, host.memory);
  const auto for_each_part = [&](const auto& visit) {
    for (Index i = 0; i < map.triangles.size(); ++i)
      visit(map.triangle_sources[i], i);
  };
  const base::Groups<Index, Index> parts(triangles.size(), for_each_part, host.memory);

  Refinement refinement(solid, host);
  std::size_t found_faces = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i % 4096 == 0) host.report("refine", i, cells.size());
    std::array<std::size_t, 4> outer{};
    std::size_t count = 0;
    Tetrahedron t = cells[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (t[k] < given)
        outer[count++] = k;
      else
        t[k] += shift;
    }
    if (count == 2) {
      refinement.add_cut(t, outer[0], outer[1], points_on(points, t[outer[0]], t[outer[1]]));
      continue;
    }
    if (count == 3) {
      const Triangle face = sorted({t[outer[0]], t[outer[1]], t[outer[2]]});
      const auto at = std::lower_bound(faces.begin(), faces.end(), face,
                                       [](const Face& f, const Triangle& x) { return f.sorted < x; });
      if (at == faces.end() || at->sorted != face) refuse_bound(i);
      ++found_faces;
      const Index apex = t[6 - outer[0] - outer[1] - outer[2]];
      for (const Index p : parts[at->triangle]) {
        const Triangle& part = map.triangles[p];
        refinement.add({part[0], part[2], part[1], apex});
      }
      continue;
    }
    if (count == 4) refuse_bound(i);
    refinement.add(t);
  }
  base::require(found_faces == triangles.size(), "the surface is not the boundary of the tetrahedra");
  return solid;
}

}  // namespace orbicube::volume_map
