#include "gltf/kept/kept_corners.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::gltf {

namespace {

using mesh::Index;
using mesh::Triangle;

void require(bool condition, const char* message) {
  if (!condition) throw base::Error("invalid-argument", message);
}

// The corners of a kept triangle in the order of a triangle of the surface, which may be turned.
Triangle corners_in_order(const Kept& kept, std::size_t number, const Triangle& surface) {
  Triangle result{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Triangle& corners = kept.triangles[number];
    const auto found = std::find_if(corners.begin(), corners.end(),
                                    [&](Index corner) { return kept.surface_vertex[corner] == surface[k]; });
    require(found != corners.end(), "a triangle is not that of the surface that was read");
    result[k] = *found;
  }
  return result;
}

bool is_turned(const Triangle& from, const Triangle& to) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (to[0] == from[k]) return to[1] != from[(k + 1) % 3];
  }
  return false;
}

// The surface itself: all vertices of its primitives as they are in the file.
PlacedCorners place_surface(const Scene& scene, const base::Host& host) {
  const Kept& kept = *scene.kept;
  require(scene.triangles.size() == kept.triangles.size(), "there are other triangles than in the file that was read");
  PlacedCorners result;
  std::map<Index, std::size_t> groups;  // by the first vertex
  for (const KeptPrimitive& from : kept.primitives) {
    const auto [found, added] = groups.emplace(from.first_vertex, result.groups.size());
    if (added) {
      VertexGroup group{base::Array<BlendedVertex>(host.memory), base::Array<Index>(host.memory)};
      for (Index v = 0; v < from.vertex_count; ++v) {
        group.vertices.push_back({{v, v, v}, {1, 0, 0}});
        group.surface_vertex.push_back(kept.surface_vertex[from.first_vertex + v]);
      }
      result.groups.push_back(std::move(group));
    }
    PlacedPrimitive to{&from, found->second, base::Array<Triangle>(host.memory)};
    for (std::size_t t = from.first_triangle; t < from.first_triangle + from.triangle_count; ++t) {
      if (t % base::items_between_reports == 0) host.report("placing corners", t, kept.triangles.size());
      Triangle corners = corners_in_order(kept, t, scene.triangles[t]);
      if (to.triangles.empty()) to.turned = is_turned(kept.triangles[t], corners);
      for (Index& corner : corners)
        corner -= from.first_vertex;
      to.triangles.push_back(corners);
    }
    if (!to.triangles.empty()) result.primitives.push_back(std::move(to));
  }
  return result;
}

// Triangles that lie on those of the surface.
class CornerPlacer {
 public:
  CornerPlacer(const Scene& scene, const base::Host& host)
      : scene_(scene),
        kept_(*scene.kept),
        host_(host),
        corners_(host.memory),
        primitive_of_(host.memory),
        uses_(host.memory) {
    require(
        scene.kept_surface.size() == kept_.triangles.size() && scene.kept_triangles.size() == scene.triangles.size(),
        "there are other triangles than in the file that was read");
    for (std::size_t t = 0; t < kept_.triangles.size(); ++t)
      corners_.push_back(corners_in_order(kept_, t, scene.kept_surface[t]));
    for (std::size_t p = 0; p < kept_.primitives.size(); ++p)
      primitive_of_.insert(primitive_of_.end(), kept_.primitives[p].triangle_count, static_cast<Index>(p));
    uses_ = base::cells_around(std::span<const Triangle>(corners_), kept_.surface_vertex.size(), host_.memory);
  }

  PlacedCorners place() {
    PlacedCorners result;
    std::vector<std::vector<Index>> first(kept_.primitives.size()), next(kept_.primitives.size());
    for (const KeptPrimitive& from : kept_.primitives) {
      PlacedPrimitive to{&from, result.groups.size(), base::Array<Triangle>(host_.memory)};
      if (from.triangle_count > 0)
        to.turned = is_turned(kept_.triangles[from.first_triangle], corners_[from.first_triangle]);
      result.primitives.push_back(std::move(to));
      result.groups.push_back({base::Array<BlendedVertex>(host_.memory), base::Array<Index>(host_.memory)});
    }
    for (std::size_t t = 0; t < scene_.triangles.size(); ++t) {
      if (t % base::items_between_reports == 0) host_.report("placing corners", t, scene_.triangles.size());
      const KeptTriangle& on = scene_.kept_triangles[t];
      require(on.middle < corners_.size(), "a triangle lies on none of the surface that was read");
      const std::size_t p = primitive_of_[on.middle];
      if (first[p].empty()) first[p].assign(scene_.positions.size() / 3, mesh::no_index);
      Triangle triangle{};
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] =
            vertex_at(result.groups[p], scene_.triangles[t][k], blended(on, on.corners[k]), first[p], next[p]);
      result.primitives[p].triangles.push_back(triangle);
    }
    std::erase_if(result.primitives, [](const PlacedPrimitive& primitive) { return primitive.triangles.empty(); });
    return result;
  }

 private:
  static bool meet(const Triangle& a, const Triangle& b) {
    return std::any_of(a.begin(), a.end(), [&](Index v) { return std::find(b.begin(), b.end(), v) != b.end(); });
  }

  // Whether attributes go on without a seam from one triangle to the other: they are the same, have a vertex in common,
  // or have one each in common with a third.
  bool continuous(Index a, Index b) const {
    if (a == b) return true;
    if (primitive_of_[a] != primitive_of_[b]) return false;
    if (meet(corners_[a], corners_[b])) return true;
    return std::any_of(corners_[a].begin(), corners_[a].end(), [&](Index v) {
      const std::span<const Index> uses = uses_[v];
      return std::any_of(uses.begin(), uses.end(), [&](Index between) { return meet(corners_[between], corners_[b]); });
    });
  }

  // The vertex of a triangle that is this one of the surface, or none.
  Index corner_at(Index triangle, Index surface_vertex) const {
    for (const Index v : corners_[triangle]) {
      if (kept_.surface_vertex[v] == surface_vertex) return v;
    }
    return mesh::no_index;
  }

  // The same of the triangle or of one that has a vertex in common with it. Where seams meet, the vertices that a place
  // has belong to one triangle each.
  Index corner_near(Index triangle, Index surface_vertex) const {
    if (const Index v = corner_at(triangle, surface_vertex); v != mesh::no_index) return v;
    for (const Index corner : corners_[triangle]) {
      for (const Index use : uses_[corner]) {
        if (primitive_of_[use] != primitive_of_[triangle]) continue;
        if (const Index v = corner_at(use, surface_vertex); v != mesh::no_index) return v;
      }
    }
    return mesh::no_index;
  }

  BlendedVertex blended(const KeptTriangle& on, const KeptTriangle::Corner& corner) const {
    require(corner.triangle < corners_.size(), "a corner lies on no triangle of the surface that was read");
    const Index first = kept_.primitives[primitive_of_[on.middle]].first_vertex;
    const bool here = continuous(on.middle, corner.triangle);
    const Triangle& vertices = corners_[here ? corner.triangle : on.middle];
    const std::array<double, 3>& weights = here ? corner.weights : corner.nearest;
    constexpr double all = 1 - 1e-9;  // of what may have been rounded
    for (std::size_t k = 0; k < 3; ++k) {
      require(corner.weights[k] >= 0 && corner.weights[k] <= 1 + 1e-6 && corner.nearest[k] >= 0 &&
                  corner.nearest[k] <= 1 + 1e-6,
              "weights of a corner are not from 0 to 1");
      if (corner.weights[k] > all) {
        const Index v = corner_near(on.middle, kept_.surface_vertex[corners_[corner.triangle][k]]);
        if (v != mesh::no_index) return {{v - first, v - first, v - first}, {1, 0, 0}};
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = vertices[k] - first;
      if (weights[k] > all) return {{v, v, v}, {1, 0, 0}};
    }
    return {{vertices[0] - first, vertices[1] - first, vertices[2] - first}, weights};
  }

  // The vertex of the group with these attributes, which is added where there is none. Those of one vertex of the
  // surface are a list.
  static Index vertex_at(VertexGroup& group, Index surface_vertex, const BlendedVertex& target,
                         std::vector<Index>& first, std::vector<Index>& next) {
    for (Index v = first[surface_vertex]; v != mesh::no_index; v = next[v]) {
      if (group.vertices[v].vertices == target.vertices && group.vertices[v].weights == target.weights) return v;
    }
    const auto added = static_cast<Index>(group.vertices.size());
    group.vertices.push_back(target);
    group.surface_vertex.push_back(surface_vertex);
    next.push_back(std::exchange(first[surface_vertex], added));
    return added;
  }

  const Scene& scene_;
  const Kept& kept_;
  const base::Host& host_;
  base::Array<Triangle> corners_;  // of what was kept, in the order of the surface's
  base::Array<Index> primitive_of_;
  base::Groups<Index, Index> uses_;  // triangles at each vertex
};

}  // namespace

PlacedCorners place_corners(const Scene& scene, const base::Host& host) {
  if (scene.kept_triangles.empty()) return place_surface(scene, host);
  return CornerPlacer(scene, host).place();
}

}  // namespace orbicube::gltf
