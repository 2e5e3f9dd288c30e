// The surface of a voxel polycube as a graph drawn on it: its faces cut into rectangles, arcs where two rectangles
// meet, nodes where three arcs or more do. What tracing draws again on the surface in space.
#pragma once

#include "polycube/surface/axis_label.h"
#include "polycube/voxels/voxel_solid.h"

namespace orbicube::polycube {

struct LayoutNode {
  Cell vertex;     // of the compressed grid, see planes
  Vector3 normal;  // mean of the faces around it, unit length
  bool corner;     // of the polycube; others end cuts of a face
};

struct LayoutRectangle {
  AxisLabel label;
  Index facet;     // the patch of the polycube that it is a part of
  Cell low, high;  // vertices of the compressed grid; the same along its axis
};

// Arc a has two darts: 2 a from its first node to its second, 2 a + 1 back.
struct Layout {
  explicit Layout(std::pmr::memory_resource* memory)
      : planes{Array<double>(memory), Array<double>(memory), Array<double>(memory)},
        nodes(memory),
        rectangles(memory),
        dart_origin(memory),
        dart_left(memory),
        rotation_begin(memory),
        rotation(memory),
        boundary_begin(memory),
        boundary(memory) {}

  std::size_t arcs() const { return dart_origin.size() / 2; }
  Index origin(Index dart) const { return dart_origin[dart]; }
  Index target(Index dart) const { return dart_origin[dart ^ 1U]; }
  std::size_t corners() const;
  std::size_t facets = 0;

  Vector3 position(const Cell& vertex) const {
    const auto at = [&](std::size_t axis) { return planes[axis][static_cast<std::size_t>(vertex[axis])]; };
    return {at(0), at(1), at(2)};
  }
  Vector3 node_position(Index node) const { return position(nodes[node].vertex); }
  // The axis that an arc is parallel to.
  std::size_t axis(Index arc) const;
  // Darts that leave a node, counter-clockwise seen from outside.
  std::span<const Index> darts_of(Index node) const {
    return {rotation.data() + rotation_begin[node], rotation_begin[node + 1] - rotation_begin[node]};
  }
  // Darts around a rectangle, which is on the left of each, counter-clockwise.
  std::span<const Index> darts_around(Index rectangle) const {
    return {boundary.data() + boundary_begin[rectangle], boundary_begin[rectangle + 1] - boundary_begin[rectangle]};
  }

  std::array<Array<double>, 3> planes;  // of the grid, those that the polycube has a face in
  Array<LayoutNode> nodes;
  Array<LayoutRectangle> rectangles;
  Array<Index> dart_origin, dart_left;  // node and rectangle of each dart
  Array<Index> rotation_begin, rotation;
  Array<Index> boundary_begin, boundary;
};

// The solid must be certified (voxel_solid.h). O(n log n) in the cells of the compressed grid.
Layout make_layout(const VoxelSolid& solid, const base::Host& host);

}  // namespace orbicube::polycube
