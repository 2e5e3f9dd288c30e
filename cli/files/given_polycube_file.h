// A polycube of the user's: from the JSON that `--domain` writes or from a mesh of it, and the places of its corners.
#pragma once

#include <filesystem>
#include <vector>

#include "polycube/layout/drawn_construction.h"
#include "session/session.h"

namespace orbicube::cli {

struct GivenPolycube {
  explicit GivenPolycube(std::pmr::memory_resource* memory) : target(memory), numbered(memory), pose(memory) {}

  polycube::TargetPolycube target;
  base::Array<mesh::Index> numbered;  // of each corner or vertex of the file the corner of the graph; no_index for none
  base::Array<mesh::Vector3>
      pose;  // of each corner of the graph, its point on the surface of which it was constructed; or empty
};

// Reads JSON by its ending, and meshes of all formats otherwise. Throws Failure.
GivenPolycube read_given_polycube(const std::filesystem::path& path, Session& session);

// Reads the positions of corners, a JSON array of objects with "corner", a number of a corner in the file of the
// polycube (of a vertex where that is a mesh), and "vertex" or "point" of the surface. Throws Failure.
std::vector<polycube::CornerPlace> read_corner_places(const std::filesystem::path& path, const GivenPolycube& given,
                                                      const base::Host& host);

}  // namespace orbicube::cli
