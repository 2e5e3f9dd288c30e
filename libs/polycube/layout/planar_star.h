// The triangles around one vertex of a map to a polycube, and where that vertex may and should go.
//
// Each triangle is measured by the symmetric Dirichlet energy (Smith and Schaefer 2015) of the map from space to its
// patch of the polycube, area |J|^2 (1 + 1 / det J^2): at least 4 a unit of area, and infinite for what is flat. A
// vertex within a face has two free coordinates, one on an edge of the polycube one; at a corner it has none.
#pragma once

#include <optional>

#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube {

using Eigen::Vector2d;

// What the map is made of, by vertex and by triangle of `surface`.
struct MapView {
  const EditableSurface& surface;
  std::span<const AxisLabel> label;  // of each triangle
  std::span<const Index> facet;      // of each triangle: the patch of the polycube
  std::span<Vector3> image;          // of each vertex, on the polycube
  double scale;                      // of lengths in space, for equal areas
  double min_length;                 // shorter edges in space count as that long
};

class PlanarStar {
 public:
  explicit PlanarStar(std::pmr::memory_resource* memory) : triangles_(memory), kernel_(memory), clipped_(memory) {}

  // The star of a vertex of the map as it is.
  void gather(const MapView& map, Index vertex);

  std::size_t freedoms() const { return freedoms_; }
  // Exactly: each triangle of the star has the sign that it should have.
  bool positive() const;
  // Puts the vertex where all triangles have room: at the center of the points that see the whole ring. For vertices
  // whose star is not positive yet. False when there is none that rounding allows.
  bool place(const MapView& map);
  // One safeguarded Newton step. The star must be positive and stays so; the energy never rises. Returns by how much it
  // falls.
  double improve(const MapView& map);
  double energy() const { return energy_at(here_); }

 private:
  struct StarTriangle {
    Vector2d a, b;              // the other two corners, counter-clockwise after the vertex
    double weight;              // area in space
    Eigen::Matrix2d inverse;    // of the edges in space
    std::size_t first, second;  // the coordinates of the face's plane
    double sign;                // of its second coordinate
  };
  static Vector2d flat(const StarTriangle& t, const Vector3& p) {
    return {p[static_cast<Eigen::Index>(t.first)], t.sign * p[static_cast<Eigen::Index>(t.second)]};
  }
  // Of the energy, in coordinates (x, y) of space along the free axes.
  struct Derivatives {
    double value = 0;
    Vector2d gradient = Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  };
  std::optional<Derivatives> differentiate() const;
  std::optional<Vector2d> newton_step(const Vector2d& gradient, Eigen::Matrix2d hessian) const;
  double energy_at(const Vector3& p) const;
  bool positive_at(const Vector3& p) const;
  bool place_in_face();
  bool place_on_edge();
  void write(const MapView& map) const { map.image[vertex_] = here_; }

  Index vertex_ = no_index;
  Vector3 here_;
  std::size_t freedoms_ = 0;
  std::array<std::size_t, 2> axes_{};  // the free coordinates
  Array<StarTriangle> triangles_;
  Array<Vector2d> kernel_, clipped_;
};

}  // namespace orbicube::polycube
