#include "mesh/topology/topology.h"

#include <algorithm>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "base/grouping.h"
#include "mesh/search/measures.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/surface_check.h"
#include "mesh/topology/weld.h"

namespace orbicube::mesh {
namespace {

// One pass of the whole examination a function; each fills in its part of the result.
class Examination {
 public:
  Examination(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host)
      : positions_(positions), triangles_(triangles), host_(host) {}

  Topology run() {
    require_valid_surface(positions_, triangles_, host_);
    result_.vertices = positions_.size();
    result_.triangles = triangles_.size();
    duplicate_and_degenerate_faces();
    {
      const EdgeTable edges(positions_.size(), triangles_, host_);
      edges_and_boundary(edges);
      fans(edges);
      if (result_.inconsistent_edges > 0) result_.orientable = orientation_signs(triangles_, edges, host_).has_value();
    }
    vertices_and_components();
    zero_area_faces();
    const Measures sizes = measures(positions_, triangles_, host_);
    Topology& r = result_;
    r.low = sizes.low;
    r.high = sizes.high;
    r.area = sizes.area;
    r.volume = sizes.volume;
    r.euler_characteristic =
        static_cast<std::int64_t>(r.vertices - r.unreferenced_vertices + r.triangles - r.degenerate_faces) -
        static_cast<std::int64_t>(r.edges);
    if (r.closed() && r.manifold() && r.orientable && r.components == 1) r.genus = 1 - r.euler_characteristic / 2;
    host_.report("topology", 1, 1);
    return result_;
  }

 private:
  // Called with the number of each item of a long loop.
  void report(const char* what, std::size_t item, std::size_t total) const {
    if (item % 65536 == 0) host_.report(what, item, total);
  }

  // Corners in ascending order, grouped by the lowest.
  void duplicate_and_degenerate_faces() {
    struct Corners {
      Index middle, high, face;
      bool operator<(const Corners& o) const {
        return middle != o.middle ? middle < o.middle : high != o.high ? high < o.high : face < o.face;
      }
    };
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      report("comparing faces", t, triangles_.size());
      if (has_repeated_corner(triangles_[t]) && result_.degenerate_faces++ == 0)
        result_.first_degenerate_face = static_cast<Index>(t);
    }
    const auto for_each = [&](const auto& visit) {
      for (std::size_t t = 0; t < triangles_.size(); ++t) {
        report("comparing faces", t, triangles_.size());
        if (has_repeated_corner(triangles_[t])) continue;
        Triangle c = triangles_[t];
        std::sort(c.begin(), c.end());
        visit(c[0], Corners{c[1], c[2], static_cast<Index>(t)});
      }
    };
    base::Groups<Corners, Index> by_lowest(positions_.size(), for_each, host_.memory);
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      report("comparing faces", v, positions_.size());
      const std::span<Corners> sorted = by_lowest[v];
      std::sort(sorted.begin(), sorted.end());
      for (std::size_t i = 1; i < sorted.size(); ++i) {
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
      report("edges and boundary", e, edges.size());
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
      report("faces around vertices", e, edges.size());
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
      report("faces around vertices", c, 3 * triangles_.size());
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
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      report("components", t, triangles_.size());
      sets.unite(triangles_[t][0], triangles_[t][1]);
      sets.unite(triangles_[t][0], triangles_[t][2]);
      for (const Index v : triangles_[t])
        used[v] = 1;
    }
    const Array<Index> at_same_position = first_at_same_position(positions_, host_);
    // Of those at one position, the first that is used; filled in ascending order.
    Array<Index> first_used(positions_.size(), no_index, host_.memory);
    for (Index v = 0; v < positions_.size(); ++v) {
      if (!used[v]) {
        ++result_.unreferenced_vertices;
        continue;
      }
      if (sets.find(v) == v && result_.components++ == 1) result_.first_vertex_apart = v;
      Index& earlier = first_used[at_same_position[v]];
      if (earlier == no_index) {
        earlier = v;
      } else if (result_.coincident_vertices++ == 0) {
        result_.first_coincident_vertices = {earlier, v};
      }
    }
  }

  void zero_area_faces() {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      report("faces without area", t, triangles_.size());
      if (has_repeated_corner(triangles_[t]) || !collinear(triangles_[t])) continue;
      if (result_.zero_area_faces++ == 0) result_.first_zero_area_face = static_cast<Index>(t);
    }
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

[[noreturn]] void refuse(const char* kind, const std::string& what) {
  throw base::Error(kind, what);
}

}  // namespace

Topology topology(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host) {
  return Examination(positions, triangles, host).run();
}

void require_closed_manifold(const Topology& t) {
  if (t.triangles == 0) refuse("empty-mesh", "there are no triangles");
  if (t.low == t.high) refuse("degenerate-geometry", "all vertices are at the same point");
  if (t.degenerate_faces > 0) {
    refuse("degenerate-face", base::counted(t.degenerate_faces, "face has", "faces have") +
                                  " a repeated vertex; first face " + std::to_string(t.first_degenerate_face));
  }
  if (t.duplicate_faces > 0) {
    refuse("duplicate-face", base::counted(t.duplicate_faces, "face repeats", "faces repeat") +
                                 " the vertices of another; first faces " + std::to_string(t.first_duplicate_faces[0]) +
                                 " and " + std::to_string(t.first_duplicate_faces[1]));
  }
  if (t.non_manifold_edges > 0) {
    refuse("non-manifold-edge", base::counted(t.non_manifold_edges, "edge has", "edges have") +
                                    " more than two faces; first edge " + text(t.first_non_manifold_edge));
  }
  if (t.boundary_edges > 0) {
    refuse("not-closed", base::counted(t.boundary_loops, "boundary loop") + ", the longest with " +
                             base::counted(t.longest_boundary_loop, "edge") + "; first edge " +
                             text(t.first_boundary_edge));
  }
  if (t.non_manifold_vertices > 0) {
    refuse("non-manifold-vertex", base::counted(t.non_manifold_vertices, "vertex joins", "vertices join") +
                                      " parts that share no edge; first vertex " +
                                      std::to_string(t.first_non_manifold_vertex));
  }
}

void require_closed_genus_zero(const Topology& t) {
  require_closed_manifold(t);
  if (t.components > 1) {
    refuse("not-connected", "the surface has " + base::counted(t.components, "part") + "; vertex " +
                                std::to_string(t.first_vertex_apart) + " is not connected with the first one");
  }
  if (!t.orientable) refuse("non-orientable", "the surface has one side only, like a Moebius strip");
  if (t.inconsistent_edges > 0) {
    refuse("inconsistent-orientation", base::counted(t.inconsistent_edges, "edge lies", "edges lie") +
                                           " between faces of opposite orientations; first edge " +
                                           text(t.first_inconsistent_edge));
  }
  if (t.genus != 0) {
    refuse("wrong-genus", "genus " + std::to_string(t.genus.value_or(-1)) + ", where genus 0 (no handles) is needed");
  }
}

}  // namespace orbicube::mesh
