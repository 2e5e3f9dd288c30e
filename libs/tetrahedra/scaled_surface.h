// The surface as TetGen gets it: the vertices of triangles only, numbered without gaps in their order, about 1 in size
// and near the origin, so that tolerances and squares mean the same for a surface of any size at any place.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::tetrahedra {

// There must be triangles, and their vertices must be finite and not all the same.
class ScaledSurface {
 public:
  ScaledSurface(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                std::pmr::memory_resource* memory);

  // Nothing is rounded in them: scaled by a power of two, and shifted along an axis only where all of them are further
  // from 0 than from each other, so that differences are exact (Sterbenz 1974). Only what is 1e-300 times smaller than
  // the whole may be lost.
  std::span<const mesh::Vector3> positions() const { return positions_; }
  std::span<const mesh::Triangle> triangles() const { return triangles_; }
  // The number of each vertex in the surface.
  std::span<const mesh::Index> original() const { return original_; }

  // A place here as a place there; rounds.
  mesh::Vector3 unscaled(const mesh::Vector3& p) const;
  // And back; of places far off it may be infinite.
  mesh::Vector3 scaled(const mesh::Vector3& p) const;
  double scaled_length(double length) const;
  double scaled_volume(double volume) const;

 private:
  mesh::Array<mesh::Vector3> positions_;
  mesh::Array<mesh::Triangle> triangles_;
  mesh::Array<mesh::Index> original_;
  mesh::Vector3 shift_ = mesh::Vector3::Zero();
  int exponent_ = 0;
};

}  // namespace orbicube::tetrahedra
