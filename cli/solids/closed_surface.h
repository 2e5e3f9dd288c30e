// A surface that has a sphere map, read from a file.
#pragma once

#include <memory>
#include <string>

#include "files/surface_file.h"
#include "mesh/mesh.h"
#include "session/session.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {

struct ClosedSurface {
  mesh::Mesh mesh;                           // closed, of genus 0, turned outward
  Json figures;                              // of the file, and what was turned
  std::shared_ptr<const gltf::Kept> kept{};  // with Keep::decoration, where it can be
  base::Array<mesh::Triangle> given{};       // triangles as in the file, before they were turned
};

// Reads it, turns triangles and notes that, or throws the refusal of a surface that has no map.
ClosedSurface read_closed_surface(const std::string& path, const Mending& mending, Session& session,
                                  Keep keep = Keep::surface);

}  // namespace orbicube::cli
