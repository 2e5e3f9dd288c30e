// Points found in meshes of tetrahedra, so that a piecewise linear map and its inverse are functions: a point is in a
// tetrahedron with weights of its corners, and the same weights of the images of the corners make its image.
#pragma once

#include "mesh/search/bounding_volume_tree.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

struct Location {
  Index tetrahedron = no_index;    // none when no tetrahedron has the point
  std::array<double, 4> weight{};  // of its corners; their sum is 1 to rounding

  // The same point of other positions of the corners.
  Vector3 at(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra) const {
    const Tetrahedron& t = tetrahedra[tetrahedron];
    Vector3 sum = weight[0] * positions[t[0]];
    for (std::size_t k = 1; k < 4; ++k)
      sum += weight[k] * positions[t[k]];
    return sum;
  }
};

class PointLocator {
 public:
  // Keeps views of both arrays. Throws Error "cancelled". O(n log n), about 100 bytes a tetrahedron.
  PointLocator(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra, const base::Host& host);

  // Returns the tetrahedron with the maximum of the minimum weight, the lowest number of equals, if that weight is not
  // below minus `tolerance`. O(log n) where few tetrahedra lie over each other.
  Location locate(const Vector3& point, double tolerance = 1e-9) const;

  std::span<const Vector3> positions() const { return positions_; }
  std::span<const Tetrahedron> tetrahedra() const { return tetrahedra_; }

 private:
  std::span<const Vector3> positions_;
  std::span<const Tetrahedron> tetrahedra_;
  double margin_;  // of the boxes, for rounding
  mesh::BoundingVolumeTree tree_;
};

}  // namespace orbicube::volume_map
