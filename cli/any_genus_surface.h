// A surface that has a polycube, read from a file.
#pragma once

#include <string>

#include "mesh/mesh.h"
#include "session.h"

namespace orbicube::cli {

struct AnyGenusSurface {
  mesh::Mesh mesh;  // closed, connected, turned outward
  Json figures;     // format, numbers and genus
};

// Reads it, turns triangles and notes that, or throws the refusal of a surface that has no map.
AnyGenusSurface read_any_genus_surface(const std::string& path, bool weld, Session& session);

}  // namespace orbicube::cli
