// The dissertation's own sphere map, method `dissertation`: chapter 3 as printed, so that its tables can be made again
// and the gain of the default be seen in one run.
//
// Progressive mesh down to a tetrahedron (decimation.h; the text says no more of it), which is put on the sphere;
// vertex splits into spherical kernels (spherical_kernel.h); Algorithm 1 with its priority queue (eq. 3.6) after every
// eta splits and at the end; Algorithm 2 for each vertex. What had to be mended, each because the printed method fails
// there, is named in step.h for Algorithm 2 and in method.cpp for Algorithm 1. No move is taken that makes a
// triangle non-positive, so the map is a bijection at every moment.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "base/host.h"
#include "sphere_map/optimization/distortion.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::sphere_map::dissertation {

using sphere_map::TracePoint;

struct DissertationOptions {
  double angle_weight = 0.1;    // lambda of eq. 3.5; not negative
  double area_weight = 1.0;     // mu of eq. 3.5; not negative; one of the two is positive
  AlgorithmLimits limits = {};  // of Algorithm 1
  std::uint64_t seed = 0;       // varies the order of equally good decimation steps
  RestTriangles rest = {};      // without min_area
  // As in sphere_map.h.
  std::function<void(const TracePoint&)> trace = nullptr;
};

// Directions of the vertices of a closed, connected surface of genus 0 that is outward-oriented, near unit size and the
// origin (normalize.h); zero for vertices in no triangle. sphere_map::compute checks and prepares surfaces so. O(n log
// n) time. Throws Error: invalid-argument (options), cancelled, no-valid-result when no valid map was found.
// `partial` as in sphere_map.h.
Array<Vector3> compute(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                       const DissertationOptions& options, const base::Host& host, Partial* partial = nullptr);

}  // namespace orbicube::sphere_map::dissertation
