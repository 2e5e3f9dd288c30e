// Whether surfaces that a verb writes intersect themselves, for the report and for people.
#pragma once

#include <array>
#include <span>
#include <string>

#include "mesh/mesh.h"
#include "session/session.h"

namespace orbicube::cli {

// Puts the number of pairs of faces that intersect, by exact predicates, in figures["self_intersections"], and adds and
// returns a note with the place of the first pair; empty without one. `advice` says what to do about it. A map that is
// one to one does not rule them out: a coarse sample of a surface may cross a narrow gap.
std::string report_intersections(const std::string& path, std::span<const mesh::Vector3> positions,
                                 std::span<const mesh::Triangle> triangles, const std::string& advice, Json& figures,
                                 Session& session);
std::string report_intersections(const std::string& path, std::span<const mesh::Vector3> positions,
                                 std::span<const std::array<mesh::Index, 4>> quads, const std::string& advice,
                                 Json& figures, Session& session);

}  // namespace orbicube::cli
