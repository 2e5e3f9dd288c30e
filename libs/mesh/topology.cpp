#include "mesh/topology.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_table.h"
#include "mesh/orient.h"
#include "mesh/predicates.h"

namespace orbicube::mesh {
namespace {

// One pass of the whole examination a function; each fills in its part of the result.
class Examination {
 public:
  Examination(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host)
      : positions_(positions), triangles_(triangles), host_(host) {}

  Topology run() {
    check_arguments();
    result_.vertices = positions_.size();
    result_.triangles = triangles_.size();
    faces();
    host_.report("topology", 1, 5);
    const EdgeTable edges(positions_.size(), triangles_, host_.memory);
    host_.report("topology", 2, 5);
    edges_and_boundary(edges);
    host_.report("topology", 3, 5);
    fans(edges);
    vertices_and_components();
    host_.report("topology", 4, 5);
    if (result_.inconsistent_edges > 0)
      result_.orientable = orientation_signs(triangles_, edges, host_.memory).has_value();
    measures();
    const Topology& r = result_;
    result_.euler_characteristic =
        static_cast<std::int64_t>(r.vertices - r.unreferenced_vertices + r.triangles - r.degenerate_faces) -
        static_cast<std::int64_t>(r.edges);
    if (r.closed() && r.manifold() && r.orientable && r.components == 1) result_.genus = 1 - r.euler_characteristic / 2;
    host_.report("topology", 5, 5);
    return result_;
  }

 private:
  void check_arguments() const {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (const Index v : triangles_[t]) {
        if (v >= positions_.size()) {
          throw base::Error("invalid-argument", "triangle " + std::to_string(t) + " has vertex " + std::to_string(v) +
                                                    " of " + std::to_string(positions_.size()));
        }
      }
    }
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      if (!positions_[v].allFinite()) {
        throw base::Error("invalid-argument", "the position of vertex " + std::to_string(v) + " is not finite");
      }
    }
  }

  // Degenerate and duplicate faces: sorted corners, grouped by the lowest.
  void faces() {
    struct Corners {
      Index middle, high, face;
      bool operator<(const Corners& o) const {
        return middle != o.middle ? middle < o.middle : high != o.high ? high < o.high : face < o.face;
      }
    };
    Array<Index> begin(positions_.size() + 1, 0, host_.memory);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (has_repeated_corner(triangles_[t])) {
        if (result_.degenerate_faces++ == 0) result_.first_degenerate_face = static_cast<Index>(t);
        continue;
      }
      ++begin[std::ranges::min(triangles_[t]) + 1];
    }
    for (std::size_t v = 0; v < positions_.size(); ++v)
      begin[v + 1] += begin[v];
    Array<Corners> sorted(begin[positions_.size()], host_.memory);
    Array<Index> fill(begin.begin(), begin.end(), host_.memory);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (has_repeated_corner(triangles_[t])) continue;
      Triangle c = triangles_[t];
      std::sort(c.begin(), c.end());
      sorted[fill[c[0]]++] = {c[1], c[2], static_cast<Index>(t)};
    }
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      std::sort(sorted.begin() + begin[v], sorted.begin() + begin[v + 1]);
      for (Index i = begin[v] + 1; i < begin[v + 1]; ++i) {
        if (sorted[i].middle != sorted[i - 1].middle || sorted[i].high != sorted[i - 1].high) continue;
        if (result_.duplicate_faces++ == 0) result_.first_duplicate_faces = {sorted[i - 1].face, sorted[i].face};
      }
    }
  }

  Edge edge_of(Index half_edge) const { return {start_of(triangles_, half_edge), end_of(triangles_, half_edge)}; }

  void edges_and_boundary(const EdgeTable& edges) {
    result_.edges = edges.size();
    DisjointSets loops(positions_.size(), host_.memory);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto h = edges.half_edges(e);
      if (h.size() == 1) {
        if (result_.boundary_edges++ == 0) result_.first_boundary_edge = edge_of(h[0]);
        loops.unite(start_of(triangles_, h[0]), end_of(triangles_, h[0]));
      } else if (h.size() > 2) {
        if (result_.non_manifold_edges++ == 0) result_.first_non_manifold_edge = edge_of(h[0]);
      } else if (start_of(triangles_, h[0]) == start_of(triangles_, h[1])) {
        if (result_.inconsistent_edges++ == 0) result_.first_inconsistent_edge = edge_of(h[0]);
      }
    }
    if (result_.boundary_edges == 0) return;
    Array<Index> length(positions_.size(), 0, host_.memory);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto h = edges.half_edges(e);
      if (h.size() != 1) continue;
      Index& edges_of_loop = length[loops.find(start_of(triangles_, h[0]))];
      result_.boundary_loops += edges_of_loop == 0;
      result_.longest_boundary_loop = std::max<std::size_t>(result_.longest_boundary_loop, ++edges_of_loop);
    }
  }

  // Corners at one vertex belong to one fan when they are joined through edges at that vertex.
  void fans(const EdgeTable& edges) {
    DisjointSets corners(3 * triangles_.size(), host_.memory);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto h = edges.half_edges(e);
      for (std::size_t i = 1; i < h.size(); ++i) {
        const bool same_way = start_of(triangles_, h[0]) == start_of(triangles_, h[i]);
        const Index from = h[i];
        const Index to = next_in_triangle(h[i]);
        corners.unite(h[0], same_way ? from : to);
        corners.unite(next_in_triangle(h[0]), same_way ? to : from);
      }
    }
    Array<std::uint8_t> fans_at(positions_.size(), 0, host_.memory);
    for (Index c = 0; c < 3 * triangles_.size(); ++c) {
      if (has_repeated_corner(triangles_[c / 3]) || corners.find(c) != c) continue;
      std::uint8_t& count = fans_at[start_of(triangles_, c)];
      count = static_cast<std::uint8_t>(std::min(count + 1, 2));
    }
    for (Index v = 0; v < positions_.size(); ++v) {
      if (fans_at[v] > 1 && result_.non_manifold_vertices++ == 0) result_.first_non_manifold_vertex = v;
    }
  }

  void vertices_and_components() {
    DisjointSets sets(positions_.size(), host_.memory);
    Array<std::uint8_t> used(positions_.size(), 0, host_.memory);
    for (const Triangle& t : triangles_) {
      sets.unite(t[0], t[1]);
      sets.unite(t[0], t[2]);
      for (const Index v : t)
        used[v] = 1;
    }
    bool first = true;
    for (Index v = 0; v < positions_.size(); ++v) {
      if (!used[v]) {
        ++result_.unreferenced_vertices;
        continue;
      }
      result_.components += sets.find(v) == v;
      result_.low = first ? positions_[v] : result_.low.cwiseMin(positions_[v]);
      result_.high = first ? positions_[v] : result_.high.cwiseMax(positions_[v]);
      first = false;
    }
  }

  // Relative to the bounding box, so that far and huge surfaces lose nothing.
  void measures() {
    const Vector3 centre = 0.5 * result_.low + 0.5 * result_.high;
    const double half = (0.5 * result_.high - 0.5 * result_.low).maxCoeff();
    const auto unit = [&](Index v) -> Vector3 {
      return half > 0 ? Vector3((positions_[v] - centre) / half) : Vector3(Vector3::Zero());
    };
    double twice_area = 0;
    double six_volumes = 0;
    for (const Triangle& t : triangles_) {
      const Vector3 p = unit(t[0]);
      const Vector3 q = unit(t[1]);
      const Vector3 r = unit(t[2]);
      const Vector3 normal = (q - p).cross(r - p);
      twice_area += normal.norm();
      six_volumes += p.dot(q.cross(r));
      if (!has_repeated_corner(t)) result_.zero_area_faces += normal.norm() < 1e-6 && collinear(t);
    }
    result_.area = 0.5 * twice_area * half * half;
    result_.volume = six_volumes / 6 * half * half * half;
  }

  bool collinear(const Triangle& t) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto flat = [&](Index v) { return Eigen::Vector2d(positions_[v][axis], positions_[v][(axis + 1) % 3]); };
      if (orientation_2d(flat(t[0]), flat(t[1]), flat(t[2])) != 0) return false;
    }
    return true;
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const base::Host& host_;
  Topology result_;
};

std::string text(const Edge& e) {
  return std::to_string(e[0]) + "-" + std::to_string(e[1]);
}

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

}  // namespace

Topology topology(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host) {
  return Examination(positions, triangles, host).run();
}

void require_closed_genus_zero(const Topology& t) {
  const auto refuse = [](const char* kind, const std::string& what) { throw base::Error(kind, what); };
  if (t.triangles == 0) refuse("empty-mesh", "there are no triangles");
  if (t.low == t.high) refuse("degenerate-geometry", "all vertices are at the same point");
  if (t.degenerate_faces > 0) {
    refuse("degenerate-face", count(t.degenerate_faces, "face has", "faces have") + " a repeated vertex; first face " +
                                  std::to_string(t.first_degenerate_face));
  }
  if (t.duplicate_faces > 0) {
    refuse("duplicate-face", count(t.duplicate_faces, "face repeats", "faces repeat") +
                                 " the vertices of another; first faces " + std::to_string(t.first_duplicate_faces[0]) +
                                 " and " + std::to_string(t.first_duplicate_faces[1]));
  }
  if (t.non_manifold_edges > 0) {
    refuse("non-manifold-edge", count(t.non_manifold_edges, "edge has", "edges have") +
                                    " more than two faces; first edge " + text(t.first_non_manifold_edge));
  }
  if (t.boundary_edges > 0) {
    refuse("not-closed", count(t.boundary_loops, "boundary loop", "boundary loops") + ", the longest with " +
                             count(t.longest_boundary_loop, "edge", "edges") + "; first edge " +
                             text(t.first_boundary_edge));
  }
  if (t.non_manifold_vertices > 0) {
    refuse("non-manifold-vertex", count(t.non_manifold_vertices, "vertex joins", "vertices join") +
                                      " parts that share no edge; first vertex " +
                                      std::to_string(t.first_non_manifold_vertex));
  }
  if (t.components > 1) refuse("not-connected", "the surface has " + std::to_string(t.components) + " parts");
  if (!t.orientable) refuse("non-orientable", "the surface has one side only, like a Moebius strip");
  if (t.inconsistent_edges > 0) {
    refuse("inconsistent-orientation", count(t.inconsistent_edges, "edge lies", "edges lie") +
                                           " between faces that are turned against each other; first edge " +
                                           text(t.first_inconsistent_edge));
  }
  if (t.genus != 0) {
    refuse("wrong-genus", "genus " + std::to_string(t.genus.value_or(-1)) + ", where genus 0 (no handles) is needed");
  }
}

}  // namespace orbicube::mesh
