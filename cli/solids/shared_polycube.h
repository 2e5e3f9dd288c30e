// One polycube for the shapes of several files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "files/surface_file.h"
#include "polycube/domain/common_polycube.h"
#include "session/session.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {

struct SharedPolycubeOptions {
  std::vector<std::string> inputs;
  std::string landmarks;                   // file, or empty
  polycube::CommonPolycubeOptions common;  // but for landmarks
  Mending mending;
  Keep keep_first = Keep::surface;  // of the file of the first shape
};

struct SharedPolycube {
  std::vector<mesh::Mesh> meshes;
  std::vector<base::Array<mesh::Triangle>> given;  // triangles of each as in the file
  polycube::CommonPolycube common;
  std::vector<Json> figures;                     // of each shape
  std::shared_ptr<const gltf::Kept> kept_first;  // with Keep::decoration, where it can be
};

// Reads the shapes and finds their polycube; figures of all go to the session. Throws Failure.
SharedPolycube share_polycube(const SharedPolycubeOptions& options, Session& session);

}  // namespace orbicube::cli
