// A surface with values of its points, as VTK file: what ParaView and VTK read as point data.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

struct PointData {
  std::string name;  // without blanks
  bool vectors;      // three values a point, else one
  std::vector<double> values;
};

// Writes it as an output of the session: POLYDATA in binary, with doubles. Throws Failure.
void write_point_data(const std::filesystem::path& path, const mesh::Mesh& surface, const std::vector<PointData>& data,
                      Session& session);

}  // namespace orbicube::cli
