// A polycube and a map to it by the method of the dissertation's chapter 4 as it is printed: voxels of an octree
// (4.2.1), shortest paths and harmonic maps (4.2.2), and Algorithm 3 (4.3 and 4.4).
//
// Nothing in it guarantees a bijective map: paths may cross and patches fold over. Octrees of fewer corner points, and
// two ways to project them, are tried then; the certificate decides. The global smoothing that ends Algorithm 3 is not
// part of it.
#pragma once

#include "polycube/labels/label_construction.h"

namespace orbicube::polycube::dissertation {

struct PrintedOptions {
  std::size_t corner_points =
      0;                   // n of Algorithm 3: maximum number of vertices of rectangles; 0: default_corner_points
  double area_weight = 1;  // alpha of eq. 4.4
  int max_rounds = 40;     // of Algorithm 3; 0: the initial map
};

// The largest number in the dissertation's Table 4.2.
inline constexpr std::size_t default_corner_points = 60;

struct PrintedReport {
  explicit PrintedReport(std::pmr::memory_resource* memory) : energies(memory) {}

  std::size_t corner_points = 0;  // vertices of the merged rectangles
  std::size_t rectangles = 0;
  int octree_depth = 0;
  Distortion before;       // of the initial map; zeros where that is not valid
  Array<double> energies;  // E of eq. 4.4 over the area of the polycube: of the initial map and after each step
  int rounds = 0;
  bool converged = false;  // the polycube changes no more
  std::uint64_t domain_evaluations = 0, corner_evaluations = 0, failed_evaluations = 0;
  std::uint64_t factorizations = 0, rows_removed = 0, rows_added = 0;  // of matrices; in factors that were kept
};

struct Printed {
  explicit Printed(std::pmr::memory_resource* memory) : made(memory), report(memory) {}
  Construction made;  // `tried` and `valid` count octrees
  PrintedReport report;
};

// Of a closed, connected, outward-oriented surface without unused vertices, of about unit size. Throws Error
// "no-valid-result" with what stood in the way of each octree, "not-closed" and the like, "cancelled".
Printed construct_as_printed(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                             const PrintedOptions& options, const base::Host& host);

// The number of corner points in the dissertation's sense: vertices of the rectangles that the faces of a certified
// map's polycube are cut into. Throws Error "cancelled".
std::size_t count_corner_points(const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube::dissertation
