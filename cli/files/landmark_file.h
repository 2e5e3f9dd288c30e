// Landmarks: points of several shapes that belong together, from a text file.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/search/nearest.h"
#include "session/session.h"

namespace orbicube::cli {

// A shape with its sphere map.
struct MappedSurface {
  const mesh::Mesh& mesh;
  std::span<const mesh::Vector3> directions;
};

// A point of a shape: a vertex, or, where that is no_index, a point of a triangle.
struct LandmarkPoint {
  mesh::Index vertex = mesh::no_index;
  mesh::SurfacePoint on_surface;  // of a vertex its position alone
};

// A line is a landmark: either one vertex number for each shape, counting from 0, or three coordinates for each, whose
// nearest point of the surface is meant. Empty lines and what follows a # do not count. Returns the landmarks of each
// shape. Throws Error "parse", "index-range", "io", "cancelled".
std::vector<std::vector<LandmarkPoint>> read_landmark_points(const std::filesystem::path& path,
                                                             std::span<const mesh::Mesh* const> shapes,
                                                             const base::Host& host);

// The same as directions on each shape's sphere.
std::vector<std::vector<mesh::Vector3>> read_landmarks(const std::filesystem::path& path,
                                                       std::span<const MappedSurface> shapes, const base::Host& host);

}  // namespace orbicube::cli
