// The planes in which the patches of a polycube lie, and where each vertex is among them. Whatever distances the planes
// are given, as long as their order stays and vertices go with them, the faces remain the same polycube but for its
// proportions: the map of space that stretches the slabs between neighboring planes is one to one.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

struct CoordinateLayers {
  // position = layer's position + fraction * (distance to the next layer); on a layer, the last one included, the
  // fraction is 0.
  struct Place {
    Index layer;
    double fraction;
  };

  explicit CoordinateLayers(std::pmr::memory_resource* memory)
      : positions{Array<double>(memory), Array<double>(memory), Array<double>(memory)}, places(memory) {}

  std::size_t intervals(std::size_t axis) const { return positions[axis].size() - 1; }
  std::size_t intervals() const { return intervals(0) + intervals(1) + intervals(2); }
  std::size_t layers() const { return intervals() + 3; }
  // Intervals of all axes are numbered one after the other: the first of an axis.
  std::size_t first_interval(std::size_t axis) const {
    return (axis > 0 ? intervals(0) : 0) + (axis > 1 ? intervals(1) : 0);
  }

  std::array<Array<double>, 3> positions;  // of the layers along each axis, ascending
  Array<std::array<Place, 3>> places;      // of each vertex along each axis
};

// Of a certified map (its labels are used). Vertices of no triangle that lie outside count as on the outermost layer.
CoordinateLayers find_layers(const SurfaceMap& map, const base::Host& host);

// Where vertices come to lie when layers are elsewhere: those on a layer exactly on it.
void place_vertices(const CoordinateLayers& layers, const std::array<Array<double>, 3>& positions,
                    std::span<Vector3> vertices);

}  // namespace orbicube::polycube
