// Shapes on one triangulation: all that lies between closed surfaces and a morph.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/host.h"
#include "correspondence/pose.h"
#include "mesh/mesh.h"

namespace orbicube::correspondence {

enum class Via { sphere = 0, polycube = 1 };

// How spheres are turned: to maximum correlation for any poses of the shapes; the same for equal poses; not at all.
enum class SphereAlignment { shape = 0, rotation = 1, none = 2 };

// The triangulation: the vertices of all shapes, or the grid of the polycube; the triangles of the first shape.
enum class CommonGrid { both = 0, first = 1 };

struct MorphOptions {
  Via via = Via::sphere;
  SphereAlignment align = SphereAlignment::shape;
  CommonGrid grid = CommonGrid::both;
  Pose pose = Pose::kept;
  double tolerance = 0.2;   // sphere, both: deviation of an edge in percent of a shape's diagonal; 0: no limit
  std::size_t cells = 0;    // polycube, both: quads of the grid; 0: as many as fit the shapes
  std::size_t corners = 0;  // maximum number of polycube corners; 0: no limit
  std::uint64_t seed = 0;
};

struct SurfaceSpan {
  std::span<const mesh::Vector3> positions;
  std::span<const mesh::Triangle> triangles;
};

struct Morph {
  explicit Morph(std::pmr::memory_resource* memory) : triangles(memory) {}

  base::Array<mesh::Triangle> triangles;
  std::vector<base::Array<mesh::Vector3>> states;  // positions of each shape
};

// Maps two or more shapes to spheres, or two to ten of one genus to one polycube, and returns one triangulation on all
// of them. Triangles are turned to be consistent and outward-oriented first. The same bits for any number of threads.
// Throws Error "invalid-argument", "not-closed", "not-manifold", "wrong-genus", "degenerate", "no-valid-result",
// "cancelled".
Morph morph(std::span<const SurfaceSpan> shapes, const MorphOptions& options, const base::Host& host);

// Returns the weighted sum of the states, one weight each. Throws Error "invalid-argument" unless there is one finite
// weight a state.
base::Array<mesh::Vector3> blend(const Morph& morph, std::span<const double> weights, const base::Host& host);

// Returns the state at `fraction`, from 0 to 1, of the straight way from one to the next.
base::Array<mesh::Vector3> intermediate(std::span<const mesh::Vector3> from, std::span<const mesh::Vector3> to,
                                        double fraction, std::pmr::memory_resource* memory);

}  // namespace orbicube::correspondence
