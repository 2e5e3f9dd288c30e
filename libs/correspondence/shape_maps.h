// Maps between shapes (the dissertation's section 4.5): f_ij = f_j^-1 o f_i, from shape i to the common sphere or
// polycube, and from there to shape j.
#pragma once

#include <deque>
#include <span>
#include <vector>

#include "correspondence/refined_surface.h"
#include "correspondence/sphere_alignment.h"

namespace orbicube::correspondence {

class ShapeMaps {
 public:
  // Of spheres that are in line, or of certified maps to one polycube; given[i] are the triangles of shape i, of which
  // the map's may be pieces. Throws Error "cancelled".
  ShapeMaps(std::deque<SphereShape> spheres, std::span<const std::span<const mesh::Triangle>> given,
            const base::Host& host);
  ShapeMaps(std::vector<polycube::SurfaceMap> maps, std::span<const std::span<const mesh::Triangle>> given,
            const base::Host& host);

  std::size_t size() const { return surfaces_.size(); }
  // The triangles that points of a shape are given by.
  std::span<const mesh::Triangle> triangles(std::size_t shape) const { return surfaces_[shape].given(); }

  // Returns where points of one shape are on another. The map is one to one; of a shape to itself it is the identity
  // but for rounding. Throws Error "invalid-argument" for shapes that do not exist and what RefinedSurface::piece_of
  // does, "cancelled".
  base::Array<TrianglePoint> carry(std::size_t from, std::size_t to, std::span<const TrianglePoint> points,
                                   const base::Host& host) const;

  // Returns how many triangles of the maps are not positive on the common sphere or polycube, by exact signs: 0, so
  // that no triangle is flipped from one shape to another, nor any piece of two where they overlap.
  std::size_t flipped() const;

 private:
  base::Array<TrianglePoint> through_sphere(std::size_t from, std::size_t to, std::span<const TrianglePoint> pieces,
                                            const base::Host& host) const;
  base::Array<TrianglePoint> through_polycube(std::size_t from, std::size_t to, std::span<const TrianglePoint> pieces,
                                              const base::Host& host) const;

  std::deque<SphereShape> spheres_;
  std::vector<polycube::SurfaceMap> maps_;
  std::vector<RefinedSurface> surfaces_;
};

// Returns each vertex as a point of a triangle at it; for a vertex in no triangle, one of no_index.
base::Array<TrianglePoint> points_of_vertices(std::size_t vertices, std::span<const mesh::Triangle> triangles,
                                              const base::Host& host);

// Returns where the vertices of one shape are on another; for a vertex in no triangle, a point of no_index. Throws what
// carry() does.
base::Array<TrianglePoint> carry_vertices(const ShapeMaps& maps, std::size_t from, std::size_t to, std::size_t vertices,
                                          const base::Host& host);

}  // namespace orbicube::correspondence
