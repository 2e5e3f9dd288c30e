// One polycube for the shapes of several files.
#pragma once

#include <string>
#include <vector>

#include "polycube/common_polycube.h"
#include "session.h"

namespace orbicube::cli {

struct SharedPolycubeOptions {
  std::vector<std::string> inputs;
  std::string landmarks;  // file, or empty
  polycube::ConstructionOptions construction;
  polycube::DomainOptions domain;
  bool weld = false;
};

struct SharedPolycube {
  std::vector<mesh::Mesh> meshes;
  polycube::CommonPolycube common;
  std::vector<Json> figures;  // of each shape
};

// Reads the shapes and finds their polycube; figures of all go to the session. Throws Failure.
SharedPolycube share_polycube(const SharedPolycubeOptions& options, Session& session);

}  // namespace orbicube::cli
