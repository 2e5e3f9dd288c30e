// How far the surface and the boundary of a mesh of hexahedra are from each other while it is smoothed, both ways, and
// what pulls the boundary to parts of the surface that it does not cover.
#pragma once

#include "hexmesh/quality/hex_boundary.h"

namespace orbicube::hexmesh {

class SurfaceCoverage {
 public:
  // Keeps references. `distance` is the maximum requested, 0 for none; then the mesh has to be where the map has it.
  SurfaceCoverage(const HexMesh& mesh, const SurfaceTarget& target, double distance, const base::Host& host);

  // Finds what of the surface the boundary is not at, and where it is nearest to that.
  void find();
  // Adds what pulls the boundary there to the pull of each vertex.
  void add_pulls(std::span<Pull> pulls) const;
  // Fixes vertices of the boundary more where it was found farther than requested, and less elsewhere.
  void hold_what_is_far(HexBoundary& boundary) const;
  // Finds again; returns how much farther than requested the surface and the boundary are from each other, relative.
  double excess();

 private:
  struct Sample {
    Vector3 position, normal;
  };
  struct Uncovered {
    Index half = no_index;  // of a quad
    mesh::Triangle vertices{};
    Vector3 weights = Vector3::Zero(), position = Vector3::Zero();
    double distance = 0;  // 0 where this is another side
    double gap = 0;
  };

  template <class Body>
  void for_pieces(std::size_t count, const Body& body) const;
  void take_samples();
  void find_homes();
  Array<mesh::Triangle> halves_of_quads() const;
  double gap_of_quad(std::size_t i) const;

  const HexMesh& mesh_;
  const SurfaceTarget& target_;
  double distance_;
  const base::Host& host_;
  Array<Sample> samples_;
  Array<Uncovered> uncovered_;  // of each sample
  Array<Index> homes_;          // the quad of each sample
};

}  // namespace orbicube::hexmesh
