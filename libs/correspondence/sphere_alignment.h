// How the spheres of a morph's shapes are brought into line: turned to where positions agree best, or turned and bent
// until landmarks coincide, and then put onto the common sphere as maps that are one to one there.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"
#include "mesh/mesh.h"
#include "polycube/surface/surface_map.h"
#include "sphere_map/correspondence/alignment.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::correspondence {

// A closed genus-0 surface with its sphere map. It stays where it is: the locator has views of it.
struct SphereShape {
  explicit SphereShape(std::pmr::memory_resource* memory)
      : mesh(memory), directions(memory), triangle_sources(memory), vertex_sources(memory) {}

  mesh::Mesh mesh;
  // The shape's map: on its own sphere at first, once it is brought into line on the common sphere.
  base::Array<mesh::Vector3> directions;
  // Where triangles were split: the triangle of the surface of each, and where vertices are on it; empty before.
  base::Array<mesh::Index> triangle_sources;
  base::Array<polycube::VertexSource> vertex_sources;
  std::unique_ptr<sphere_map::Locator> locator;
};

// What bringing a map onto the common sphere did.
struct Settled {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  std::size_t added = 0;  // vertices on edges that were cut
  std::size_t moved = 0;  // vertices that are not where rotation and warp take them
};

struct Correlated {
  double correlation = 0;         // at most 1
  Eigen::Matrix3d turn_of_shape;  // what the positions are turned by where that is joint
  Settled settled;
};

struct Angles {
  double mean = 0, max = 0;  // radians
};

struct Bent {
  Angles before, rotated, after;  // between landmarks and those of the first shape
  double share = 1;               // of their way that landmarks go
  std::size_t vertices = 0;       // of the map
  sphere_map::Measurement warp;   // from the shape's own sphere to the common one
  Settled settled;
};

// Returns the positions as functions on the sphere: samples of the flat triangles, which turn with the map, each by its
// share of the sphere.
harmonics::Coefficients coefficients_of(const SphereShape& shape, const base::Host& host);

// Turns a sphere to where its positions agree best with those of the first shape: with `joint`, whichever way the shape
// itself lies. Throws Error "no-valid-result", "cancelled".
Correlated align_by_correlation(const harmonics::Coefficients& first, SphereShape& shape, bool joint,
                                const base::Host& host);

// Throws Error "invalid-argument" for landmarks of one sphere nearer than 0.01 to each other.
void require_apart(std::span<const mesh::Vector3> landmarks);

// Turns a sphere so that its landmarks come as near to those of the first shape as they can, and bends it so that they
// meet. Where that would flip triangles that moving vertices a little does not turn back, landmarks go only a part of
// their way. Throws Error "no-valid-result", "cancelled".
Bent align_by_landmarks(SphereShape& shape, std::span<const mesh::Vector3> landmarks,
                        std::span<const mesh::Vector3> first, const base::Host& host);

}  // namespace orbicube::correspondence
