// Shapes on one triangulation: all that lies between closed surfaces and a morph.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/host.h"
#include "correspondence/pose.h"
#include "correspondence/shape_maps.h"
#include "mesh/mesh.h"

namespace orbicube::correspondence {

enum class Via { sphere = 0, polycube = 1 };

// How spheres are turned: to maximum correlation for any poses of the shapes; the same for equal poses; not at all.
enum class SphereAlignment { shape = 0, rotation = 1, none = 2 };

// The triangulation: the vertices of all shapes, or the grid of the polycube; the triangles of the first shape; a grid
// of the sphere (sphere_map/sampling/grids.h).
enum class CommonGrid { both = 0, first = 1, icosphere = 2, cube = 3, latitude = 4, octahedron = 5 };

struct MorphOptions {
  Via via = Via::sphere;
  SphereAlignment align = SphereAlignment::shape;
  CommonGrid grid = CommonGrid::both;
  Pose pose = Pose::kept;
  double tolerance = 0.2;   // sphere, both: deviation of an edge in percent of a shape's diagonal; 0: no limit
  std::size_t cells = 0;    // polycube, both: quads of the grid; 0: as many as fit the shapes
  std::size_t corners = 0;  // maximum number of polycube corners; 0: no limit
  std::uint64_t seed = 0;
  std::size_t resolution = 0;  // of a grid of the sphere
  // Points of each shape that correspond, whose nearest points of the surfaces count, in place of `align`; or none.
  std::span<const std::span<const mesh::Vector3>> landmarks = {};
};

struct SurfaceSpan {
  std::span<const mesh::Vector3> positions;
  std::span<const mesh::Triangle> triangles;
};

struct Morph {
  explicit Morph(std::pmr::memory_resource* memory) : triangles(memory), quads(memory), domain(memory) {}

  base::Array<mesh::Triangle> triangles;
  base::Array<std::array<mesh::Index, 4>> quads;   // with a polycube's grid: triangles 2 q and 2 q + 1 are halves of q
  base::Array<mesh::Vector3> domain;               // of each vertex, on the common sphere or polycube
  std::shared_ptr<const ShapeMaps> maps;           // between the shapes, whatever their placement
  std::vector<base::Array<mesh::Vector3>> states;  // positions of each shape
};

// Maps two or more shapes to spheres, or two to ten of one genus to one polycube, and returns one triangulation on all
// of them. Triangles are reversed to be consistent and outward-oriented first. The same bits for any number of threads.
// Throws Error "invalid-argument", "not-closed", "not-manifold", "wrong-genus", "degenerate", "no-valid-result",
// "cancelled".
Morph morph(std::span<const SurfaceSpan> shapes, const MorphOptions& options, const base::Host& host);

// Returns the weighted sum of the states, one weight each. Throws Error "invalid-argument" unless there is one finite
// weight a state.
base::Array<mesh::Vector3> blend(std::span<const base::Array<mesh::Vector3>> states, std::span<const double> weights,
                                 const base::Host& host);
inline base::Array<mesh::Vector3> blend(const Morph& morph, std::span<const double> weights, const base::Host& host) {
  return blend(std::span(morph.states), weights, host);
}

// Returns the state at `fraction`, from 0 to 1, of the straight way from one to the next.
base::Array<mesh::Vector3> intermediate(std::span<const mesh::Vector3> from, std::span<const mesh::Vector3> to,
                                        double fraction, std::pmr::memory_resource* memory);

}  // namespace orbicube::correspondence
