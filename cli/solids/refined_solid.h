// Meshes whose elements were split by untangling: what else files have of them, figures, and notes.
#pragma once

#include "session/session.h"
#include "untangle/refine/refined.h"

namespace orbicube::cli {

// Returns for each vertex after splits its mean of positions of the mesh before.
template <std::size_t corners, class Vector>
base::Array<mesh::Vector3> split_positions(const untangle::Refined<corners, Vector>& refined,
                                           const base::Array<mesh::Vector3>& before) {
  base::Array<mesh::Vector3> positions(before.get_allocator());
  for (const auto& origin : refined.origins)
    positions.push_back(origin.mean(std::span<const mesh::Vector3>(before)));
  return positions;
}

// Replaces the tetrahedra of a solid by their parts, with the regions of those that they are parts of. Leaves out
// triangles between tetrahedra of which one was split; those of the boundary never are. Returns how many.
std::size_t split_cells(const untangle::RefinedTetrahedra& refined, mesh::Mesh& solid, const base::Host& host);

// Adds the figures `splits` and `split_elements` for a mesh that had `vertices`, and a note where one was split.
void report_splits(const untangle::RefinedTriangles& refined, std::size_t vertices, Session& session);
void report_splits(const untangle::RefinedTetrahedra& refined, std::size_t vertices, Session& session);

}  // namespace orbicube::cli
