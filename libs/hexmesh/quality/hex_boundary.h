// Where the vertices on the boundary of a mesh of hexahedra may go: on the surface, in one patch of the polycube, along
// a sharp edge, or nowhere. Where the surface is curved, flat quads between vertices on it would all be on one side;
// vertices are raised off it by so much that half of what lies between is outside.
#pragma once

#include <algorithm>

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/quality/surface_target.h"
#include "untangle/tetrahedra/foldover_energy.h"

namespace orbicube::hexmesh {

using untangle::Pull;

class HexBoundary {
 public:
  enum class Kind : std::uint8_t { inside, surface, patch, line, point };

  // Keeps references. By the patches of the polycube around each vertex of the boundary.
  HexBoundary(const HexMesh& mesh, const SurfaceTarget& target, const base::Host& host);

  Kind kind(Index vertex) const { return places_[vertex].kind; }
  std::span<const Index> vertices() const { return vertices_; }  // of the boundary
  // How firmly a vertex is fixed to where it began, 1 or more.
  double hold(Index vertex) const { return holds_[vertex]; }
  void hold_more(Index vertex) { holds_[vertex] = std::min(3 * holds_[vertex], 1e5); }
  void hold_less(Index vertex) { holds_[vertex] = std::max(0.7 * holds_[vertex], 1.0); }
  // From now on no vertex goes to a part of the surface that looks the other way than the boundary does there now, as
  // the other wall of a narrow gap does, nor is it raised over more than a part of the gap.
  void keep_apart(std::span<const Vector3> positions, std::span<const Quad> quads);
  // From now on anywhere on the surface.
  void release(Index vertex) { places_[vertex].kind = Kind::surface; }
  // Changes raises by half of what is between the quads around a vertex and the surface, on average: after some rounds
  // the mesh encloses the volume that the surface does.
  void lift(std::span<const Vector3> positions, std::span<const Quad> quads, std::span<const Index> quad_patches,
            const base::Host& host);
  // The nearest place that a vertex of the boundary may have, with the normal there, or the direction of its line.
  TargetPoint project(Index vertex, const Vector3& p) const;
  // Adds what pulls the vertex to where it may be: to the tangent plane, to the line, or to its point.
  void pull(Index vertex, const Vector3& p, double weight, Pull& to) const;

 private:
  using Faces = std::array<Index, 2>;  // of the polycube
  struct Place {
    Kind kind = Kind::inside;
    Faces faces{no_index, no_index};
    Faces others{no_index, no_index};  // of a line that goes on between others
    Vector3 point = Vector3::Zero();
  };
  void place_at_sharp_edges(Place& place, std::span<const Faces> sharp) const;

  bool apart() const { return !normals_.empty(); }
  TargetPoint nearest_target(Index vertex, const Vector3& p) const;
  TargetPoint target_of_quad(Index patch, const Vector3& p, const Vector3& facing) const;
  void limit_lifts(std::span<const Vector3> positions, const base::Host& host);

  const SurfaceTarget& target_;
  Array<double> lifts_;  // of each vertex, outward, in cells
  Array<double> holds_;
  Array<Place> places_;
  Array<Index> vertices_;
  Array<Vector3> normals_;  // of each vertex where walls are kept apart, else none
};

}  // namespace orbicube::hexmesh
