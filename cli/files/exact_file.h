// Surfaces whose files hold every bit of what was certified.
#pragma once

#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

// Throws Failure when the file cannot be written, or is of a format that does not keep the order of vertices and every
// bit of their coordinates.
void require_exact_output(const std::string& path);

// Writes beside the place, reads again and compares, so that the file holds the certified mesh.
void write_exactly(const std::string& path, const base::Array<mesh::Vector3>& positions,
                   const base::Array<mesh::Triangle>& triangles, bool text, Session& session);

}  // namespace orbicube::cli
