// Hexahedra as the dissertation makes them (section 5.2): a regular grid on the polycube, whose vertices are taken to
// the solid by the inverse of the map, "using barycentric interpolation". Nothing is smoothed or certified;
// libs/hexmesh does both.
#pragma once

#include "volume_map/sampling/point_location.h"

namespace orbicube::volume_map {

struct ResampledGrid {
  explicit ResampledGrid(std::pmr::memory_resource* memory)
      : positions(memory), parameters(memory), hexahedra(memory) {}

  Array<Vector3> positions, parameters;  // of the vertices in space and on the polycube
  Array<mesh::Hexahedron> hexahedra;
  // Of hexahedra, the minimum over their corners; a corner of a cube has 1.
  double min_scaled_jacobian = 0, mean_scaled_jacobian = 0;
  std::size_t not_positive = 0;  // hexahedra with a corner that is not positive, by exact signs
};

// `image` is on a polycube: each triangle of the boundary lies in a plane across an axis, to the bit. The planes of the
// grid are those of the polycube and, between each two of them, others at even distances, so that about `cells` boxes
// are inside. Throws Error "no-valid-result" for images that are no polycube or of which the grid would have more than
// 50 million boxes, "cancelled", and what mesh::TetrahedralConnectivity does.
ResampledGrid resample_grid(std::span<const Vector3> source, std::span<const Vector3> image,
                            std::span<const Tetrahedron> tetrahedra, std::size_t cells, const base::Host& host);

}  // namespace orbicube::volume_map
