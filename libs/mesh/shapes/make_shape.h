// Shapes that need no file: to try things out, to test with, to show. Each is a closed manifold, outward, at whatever
// resolution is requested, and the same bits each time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

struct ShapeDescription {
  const char* name;
  const char* text;  // what it is, for lists
  int genus;
};

// Every shape that there is.
std::span<const ShapeDescription> shapes();

struct ShapeOptions {
  std::size_t triangles = 20'000;  // about; shapes have at least a few hundred
  std::uint64_t seed = 0;          // varies the shape, but for the cube and the sphere
};

// The shape of this name, about two units in size. Made from four-sided patches (quad_patches.h), so that its topology
// does not depend on the resolution. Planar faces are planar exactly. O(triangles).
// Throws Error "invalid-argument" for an unknown name or more than 100 million triangles, "cancelled".
Mesh make_shape(std::string_view name, const ShapeOptions& options, const base::Host& host);

}  // namespace orbicube::mesh
