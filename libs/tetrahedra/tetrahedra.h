// Fills a closed surface with tetrahedra: checks the surface exactly, has TetGen fill it (Si 2015, "TetGen, a
// Delaunay-based quality tetrahedral mesh generator", ACM TOMS 41(2)), distinguishes inside from cavities, and checks
// the result exactly again.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "tetrahedra/sizing.h"

namespace orbicube::tetrahedra {

using mesh::Array;
using mesh::Index;
using mesh::Tetrahedron;
using mesh::Triangle;
using mesh::Vector3;

// What tetrahedra should be like. TetGen adds vertices inside until they are, but where the surface stands in the way;
// its last step, flips and moves for better angles, may overstep the bounds again by a little, in few places.
struct Options {
  // Largest ratio of a tetrahedron's circumradius to its shortest edge, at least 1. 0: no vertices are added for
  // quality, only those without which there is no mesh.
  double quality = 1.4;
  // Largest volume, in the units of the surface; 0: none.
  double max_volume = 0;
  // Edges inside about this long, in the units of the surface; 0: as the surface has it.
  double edge_length = 0;
  // The same at some places only, as at the surface's vertices; from each, edges may get longer by `size_growth` in
  // each unit of distance. The shortest of all that applies. The surface is not cut for them, also where it may be.
  std::span<const SizePoint> sizes = {};
  double size_growth = 0.3;
  // Whether every triangle stays as it is. Otherwise edges and triangles may get further vertices: the surface's own
  // triangles need not appear, only parts that cover them.
  // Without a size, at most 50,000 vertices and 20 for each of the surface's own are then added, whatever quality they
  // give.
  bool keep_surface = true;
};

struct Solid {
  explicit Solid(std::pmr::memory_resource* memory)
      : positions(memory), tetrahedra(memory), boundary(memory), boundary_source(memory) {}

  Array<Vector3> positions;       // the surface's own first, to the bit and in its order, then those added
  Array<Tetrahedron> tetrahedra;  // each of positive volume by exact arithmetic
  Array<Triangle> boundary;       // is outward-oriented; with keep_surface triangle i is the surface's triangle i
  Array<Index> boundary_source;   // the surface's triangle that each boundary triangle lies in
  std::size_t parts = 0;          // of the solid, that share no face
  std::size_t cavities = 0;       // empty regions within
};

// Fills the surface, whose components may lie beside each other or within each other: what an odd number of them
// surrounds is solid, what an even number does is not, so a shell within a shell is a cavity. Which way triangles look
// has no effect. Vertices in no triangle stay, in no tetrahedron.
//
// TetGen runs in a child process (fork), since it cannot be stopped, keeps its state in globals, prints, and crashes
// where it means to report an error. The host's threads go on; the child ends with this call, whatever happens.
//
// Throws Error: those of require_fillable (input_check.h); "invalid-argument" for options out of range;
// "no-valid-result" when TetGen fails or its mesh does not stand the checks; "unsupported" when no child process can be
// started; "out-of-memory", "cancelled". The same bits in every run. Time and memory are TetGen's: about 10 us and 1 KB
// a tetrahedron.
Solid fill(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
           const base::Host& host);

// Returns the same as a mesh, for callers that take any function which fills a surface.
mesh::Mesh filled_mesh(std::span<const Vector3> positions, std::span<const Triangle> triangles, double max_volume,
                       const base::Host& host);

}  // namespace orbicube::tetrahedra
