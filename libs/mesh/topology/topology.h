// What kind of surface a triangle mesh is: counts, components, boundary, places where it is no manifold, orientation,
// genus; and the check that methods for closed surfaces of genus 0 start with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

using Edge = std::array<Index, 2>;
inline constexpr Edge no_edge{no_index, no_index};

struct Topology {
  std::size_t vertices = 0;
  std::size_t unreferenced_vertices = 0;  // in no triangle; they take no part in the other figures
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t components = 0;           // connected through vertices
  Index first_vertex_apart = no_index;  // the first one that is not connected with the first vertex

  std::size_t boundary_edges = 0;         // with one triangle
  std::size_t boundary_loops = 0;         // connected parts of the boundary
  std::size_t longest_boundary_loop = 0;  // in edges
  Edge first_boundary_edge = no_edge;

  std::size_t non_manifold_edges = 0;  // with three triangles or more
  Edge first_non_manifold_edge = no_edge;
  std::size_t non_manifold_vertices = 0;  // whose triangles form more than one fan
  Index first_non_manifold_vertex = no_index;

  std::size_t inconsistent_edges = 0;  // that both of their triangles pass in the same direction
  Edge first_inconsistent_edge = no_edge;
  bool orientable = true;  // turning triangles round can make all edges consistent

  std::size_t degenerate_faces = 0;  // with a repeated corner; they have no edges
  Index first_degenerate_face = no_index;
  std::size_t duplicate_faces = 0;  // with the corners of an earlier face, in any order
  std::array<Index, 2> first_duplicate_faces{no_index, no_index};
  std::size_t zero_area_faces = 0;  // with three different corners that lie exactly on one line
  Index first_zero_area_face = no_index;
  std::size_t coincident_vertices = 0;  // at the very position of an earlier vertex
  std::array<Index, 2> first_coincident_vertices{no_index, no_index};

  std::int64_t euler_characteristic = 0;  // vertices - edges + triangles
  std::optional<std::int64_t> genus;      // of a closed, connected, orientable manifold

  Vector3 low = Vector3::Zero(), high = Vector3::Zero();  // bounding box of the referenced vertices
  double area = 0;                                        // beyond the range of double as in measures.h
  double volume = 0;  // enclosed by a closed oriented surface; negative when it is inward-oriented

  bool closed() const { return triangles > 0 && boundary_edges == 0; }
  bool manifold() const {
    return non_manifold_edges == 0 && non_manifold_vertices == 0 && duplicate_faces == 0 && degenerate_faces == 0;
  }
};

// O(n log n) time, O(n) for bounded valence; up to 100 bytes a triangle while it runs. Throws Error "invalid-argument"
// for an index that is out of range or a position that is not finite, "cancelled".
Topology topology(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host);

// Throws Error unless the surface is closed and manifold, of any number of components: "empty-mesh",
// "degenerate-geometry" (all vertices at one point), "degenerate-face", "duplicate-face", "non-manifold-edge",
// "not-closed" or "non-manifold-vertex", the first that applies.
void require_closed_manifold(const Topology& topology);

// The same and connected, consistently oriented and of genus 0: also "not-connected", "non-orientable",
// "inconsistent-orientation" or "wrong-genus".
void require_closed_genus_zero(const Topology& topology);

}  // namespace orbicube::mesh
