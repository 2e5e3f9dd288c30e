// Positions, normals, colors or whatever else the vertices have, at directions: the map's inverse, interpolated.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::sphere_map {

enum class Interpolation : std::int32_t {
  linear = 0,  // with the weights of the flat triangle
  unit = 1,    // the same, then scaled to length 1: for normals. A sum that is zero stays zero
};

// What is sampled where each query lies. `values` has `components` numbers a vertex, `sampled` gets as many a query.
// At the direction of a vertex that is the vertex's own values, to the bit (for `unit`, scaled to length 1). On the
// threads of the host. Throws Error "invalid-argument" on sizes and bad queries, "cancelled".
void sample(const Locator& locator, std::span<const Vector3> queries, std::span<const double> values,
            std::size_t components, Interpolation interpolation, std::span<double> sampled, const base::Host& host);

// Positions (or other vectors) in one go.
Array<Vector3> sample_vectors(const Locator& locator, std::span<const Vector3> queries,
                              std::span<const Vector3> vectors, Interpolation interpolation, const base::Host& host);

}  // namespace orbicube::sphere_map
