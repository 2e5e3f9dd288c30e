// Landmarks: points of several shapes that belong together, from a text file.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "session.h"

namespace orbicube::cli {

// A shape with its sphere map.
struct MappedSurface {
  const mesh::Mesh& mesh;
  std::span<const mesh::Vector3> directions;
};

// A line is a landmark: either one vertex number for each shape, counting from 0, or three coordinates for each, whose
// nearest point of the surface is meant. Empty lines and what follows a # do not count. Answers the landmarks'
// directions on each shape's sphere. Throws Error "parse", "index-range", "io", "cancelled".
std::vector<std::vector<mesh::Vector3>> read_landmarks(const std::filesystem::path& path,
                                                       std::span<const MappedSurface> shapes, const base::Host& host);

}  // namespace orbicube::cli
