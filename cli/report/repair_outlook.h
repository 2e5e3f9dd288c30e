// What orbicube repair would do with a surface: defects with their sizes and places.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

struct RepairOutlook {
  Json figures;                    // as of the verb repair, and handles
  std::vector<std::string> lines;  // for people
};

// Runs the default steps on a copy, and, on surfaces of few handles and triangles, the search of their shortest loops.
// Throws Error "cancelled".
RepairOutlook repair_outlook(const mesh::Mesh& surface, Session& session);

}  // namespace orbicube::cli
