// What reports say about tetrahedra.
#pragma once

#include "mesh/search/tetrahedron_quality.h"
#include "session/session.h"

namespace orbicube::cli {

Json quality_json(const mesh::TetrahedronQuality& quality);

// The same in a few words, as "dihedral angles 9.1 to 162.3 degrees".
std::string angles_text(const mesh::TetrahedronQuality& quality);
std::string radii_text(const mesh::TetrahedronQuality& quality);

}  // namespace orbicube::cli
