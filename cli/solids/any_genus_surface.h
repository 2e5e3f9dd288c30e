// A surface that has a polycube, read from a file.
#pragma once

#include <memory>
#include <string>

#include "files/surface_file.h"
#include "mesh/mesh.h"
#include "session/session.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {

struct AnyGenusSurface {
  mesh::Mesh mesh;                           // closed, connected, turned outward
  Json figures;                              // format, numbers and genus
  std::shared_ptr<const gltf::Kept> kept{};  // with Keep::decoration, where it can be
  base::Array<mesh::Triangle> given{};       // triangles as in the file, before they were turned
};

// Reads it, turns triangles and notes that, or throws the refusal of a surface that has no map.
AnyGenusSurface read_any_genus_surface(const std::string& path, const Mending& mending, Session& session,
                                       Keep keep = Keep::surface);

}  // namespace orbicube::cli
