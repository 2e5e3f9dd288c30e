// What `orbicube sphere` writes besides the map: the surface on a regular grid of the sphere, and as an image.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

struct SphereUses {
  std::string remesh;  // file, or empty
  std::string grid = "icosphere";
  std::string image;  // file, or empty
  std::string image_grid = "octahedron";
};

void add_sphere_uses(CLI::App& verb, SphereUses& uses);

// Throws Failure when a file cannot be written or a grid is none: before long work.
void check_sphere_uses(const SphereUses& uses);

// Writes what is requested. `directions` is a bijective map of the surface. Figures and text go to the session.
void write_sphere_uses(const SphereUses& uses, const mesh::Mesh& surface, std::span<const mesh::Vector3> directions,
                       Session& session);

// How far surfaces are apart, for reports: both ways, as parts of the first one's diagonal too.
Json json_of_distance(const mesh::Mesh& first, const mesh::Mesh& second, const base::Host& host);

}  // namespace orbicube::cli
