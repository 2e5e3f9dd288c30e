// Sphere maps that are refined for an expansion in spherical harmonics.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "harmonics/fitting/fit.h"
#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

struct MapRefinement {
  std::uint32_t rounds = 0;  // maximum number; 0: none
  std::string output;        // the refined map, or empty
};

// Throws Failure when the options do not go together or the file cannot be written.
void check_refinement(const MapRefinement& refinement);

// The weights of the fit, one a vertex, of a surface that is scaled to a size near 1.
using VertexWeights = std::function<base::Array<double>(const mesh::Mesh& scaled)>;

// Refines `map`, writes it, and reports. Throws Failure no-valid-result when a map with all triangles positive does not
// stay so.
void refine_map(const MapRefinement& refinement, const harmonics::FitOptions& fit, const VertexWeights& weights,
                const mesh::Mesh& surface, mesh::Mesh& map, bool text, Session& session);

}  // namespace orbicube::cli
