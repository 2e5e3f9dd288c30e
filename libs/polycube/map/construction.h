// A polycube of a closed surface and a certified map to it, by the construction that is best for the shape.
//
// Axis labels follow a shape with the minimum distortion, but not every labeling is a polycube; voxels have the right
// topology by construction and reach the fewest corners, but lose detail. `automatic` tries both (starting from other
// grids and budgets where voxels fail) and keeps the certified map of minimum distortion.
#pragma once

#include <optional>

#include "polycube/dissertation/printed_construction.h"
#include "polycube/labels/label_construction.h"

namespace orbicube::polycube {

//
// `dissertation` is the method of its chapter 4 as printed (dissertation/printed_construction.h), which is never tried
// unless it is chosen; `corners` then is the maximum number of corner points.
enum class Method { automatic = 0, labels = 1, voxels = 2, dissertation = 3 };

struct ConstructionOptions {
  Method method = Method::automatic;
  // Maximum number of corners; 0: any number. For a surface with handles never less than 8 for each and 8 more, which
  // is the number of a box with a tunnel for each handle.
  std::size_t corners = 0;
  // More than the given number only where the map is better by 3 %; 0: all alike.
  std::size_t preferred_corners = 0;
  std::uint64_t seed = 0;
  // Of the dissertation's method: alpha of eq. 4.4, and the maximum number of rounds of Algorithm 3.
  double area_weight = 1;
  int rounds = dissertation::PrintedOptions().max_rounds;
};

struct BestConstruction {
  Construction made;                                   // `tried` and `valid` are those of all constructions
  Method method = Method::automatic;                   // which one made it
  std::optional<dissertation::PrintedReport> printed;  // of the dissertation's method
};

// Of a closed, connected, oriented surface that is outward-oriented. What is tried depends on the surface and the
// options alone, not on time. Throws Error "no-valid-result" with what became of each attempt, "not-closed" and the
// like, "cancelled".
BestConstruction construct(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const ConstructionOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
