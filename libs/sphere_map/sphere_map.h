// Bijective, low-distortion maps of closed genus-0 triangle surfaces to the unit sphere.
//
// The hierarchical method of the dissertation's chapter 3 and of Praun and Hoppe (2003), with what is known today put
// in where it is better: the surface is decimated to a tetrahedron (decimation.h), the tetrahedron is put on the
// sphere, and the vertices are inserted again one by one, each into the spherical kernel of its ring
// (spherical_kernel.h), with local optimization (vertex_step.h, relaxation.h) of a distortion energy that grows without
// bound as a triangle collapses (distortion.h). No step is taken that makes a triangle non-positive by exact
// predicates, so the map is a bijection at every moment.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

enum class Method : std::int32_t {
  balanced = 0,    // angle and area distortion with a barrier on the worst triangle: the default
  angle_area = 1,  // the dissertation's energy E = angle_weight E_D + area_weight E_A, to a local optimum
  isometric = 2,   // symmetric Dirichlet energy
  stretch = 3,     // L2 stretch (Sander et al. 2001; Praun and Hoppe 2003)
  conformal = 4,   // angle distortion alone
  dissertation =
      5,  // chapter 3 of the dissertation as printed, mended only where it would fail (dissertation/method.h)
};

// Where the optimization of method `dissertation` is, for the dissertation's Figure 3.2.
struct TracePoint {
  std::uint64_t iterations;  // calls of Algorithm 2 so far
  std::size_t vertices;      // of the mesh that is optimized
  double energy;             // E of that mesh, eq. 3.5
};

// Parameters of the dissertation's Algorithm 1 (section 3.1.3). Its stop reads: the mean gain of the last iterations,
// as many as eta on a level and as there are vertices at the end, is below the tolerance times E over the number of
// vertices. The dissertation prints no value but eta; the others let a new vertex cost a few steps, and end the final
// phase where it crawls.
struct AlgorithmLimits {
  std::uint64_t level_splits = 40;         // eta, vertex splits between two optimizations: 1 to max_level_splits
  double level_tolerance = 1e-4;           // epsilon^eta; not negative, 0 disables the stop
  double final_tolerance = 1e-4;           // epsilon^F; not negative, 0 disables the stop
  std::uint64_t max_level_iterations = 0;  // Iter_max^eta; 0: 50 times level_splits
  std::uint64_t max_final_iterations = 0;  // Iter_max^F; 0: 100 times the number of vertices
};
inline constexpr std::uint64_t max_level_splits = 1000000000;

struct Options {
  Method method = Method::balanced;
  double angle_weight = 0.1;    // lambda of eq. 3.5; not negative
  double area_weight = 1.0;     // mu of eq. 3.5; not negative; one of the two is positive
  std::uint64_t seed = 0;       // varies the order of equally good decimation steps
  AlgorithmLimits limits = {};  // of method `dissertation`
  // Method `dissertation` calls it when a level ends, and once in as many iterations as there are vertices at the end;
  // iterations count from zero again when a kernel was empty and the map is begun again. May be empty.
  std::function<void(const TracePoint&)> trace = nullptr;
};

// What there is of a map when its computation fails or is cancelled. Vertices that have no place of their own yet have
// that of the vertex that they were merged into on the way to the coarsest mesh; their triangles have no area.
struct Partial {
  explicit Partial(std::pmr::memory_resource* memory) : directions(memory) {}

  Array<Vector3> directions;  // unit vectors, one a vertex; empty when the work did not come so far
  std::size_t placed = 0;     // vertices of triangles that have a place of their own
};

// Throws Error invalid-argument unless both weights are finite and not negative, and one is positive.
void require_weights(double angle_weight, double area_weight);

// Maps the vertices of a closed, connected, consistently oriented surface of genus 0 to unit vectors, one a vertex in
// the order of `positions`. Vertices in no triangle get the direction from the bounding box's center. Orientation is
// kept: det[p q r] > 0 for every triangle, exactly, and so that rounding each coordinate again cannot change it.
// O(n log n) time, at most 1 KB a vertex.
// Throws Error: invalid-argument (options, sizes), the kinds of mesh::require_closed_genus_zero, cancelled,
// no-valid-result when no valid map was found. For the last two kinds `partial`, which may be null, gets what there is
// of the attempt that came furthest.
Array<Vector3> compute(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
                       const base::Host& host, Partial* partial = nullptr);

}  // namespace orbicube::sphere_map
