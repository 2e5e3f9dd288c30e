// A surface that has a sphere map, read from a file.
#pragma once

#include <string>

#include "mesh/mesh.h"
#include "session.h"

namespace orbicube::cli {

struct ClosedSurface {
  mesh::Mesh mesh;  // closed, of genus 0, turned outward
  Json figures;     // of the file, and what was turned
};

// Reads it, turns triangles and notes that, or throws the refusal of a surface that has no map.
ClosedSurface read_closed_surface(const std::string& path, bool weld, Session& session);

}  // namespace orbicube::cli
