// The makers behind make_shape, one a shape, and what they share.
#pragma once

#include <cstdint>
#include <random>

#include "base/host.h"
#include "base/random.h"
#include "mesh/mesh.h"
#include "mesh/shapes/make_shape.h"

namespace orbicube::mesh {

Mesh make_creature(const ShapeOptions& options, const base::Host& host);
Mesh make_blob(const ShapeOptions& options, const base::Host& host);
Mesh make_star(const ShapeOptions& options, const base::Host& host);
Mesh make_sphere(const ShapeOptions& options, const base::Host& host);
Mesh make_cube(const ShapeOptions& options, const base::Host& host);
Mesh make_torus(const ShapeOptions& options, const base::Host& host);
Mesh make_three_holes(const ShapeOptions& options, const base::Host& host);
Mesh make_bracket(const ShapeOptions& options, const base::Host& host);
Mesh make_angle(const ShapeOptions& options, const base::Host& host);
Mesh make_cylinder(const ShapeOptions& options, const base::Host& host);
Mesh make_vase(const ShapeOptions& options, const base::Host& host);

// Numbers from a seed, the same on every machine (the standard's distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * base::unit_interval(engine_()); }
  // From low to high, both included.
  int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace orbicube::mesh
