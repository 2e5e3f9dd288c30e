// Names of the constructions of polycubes, and what is reported of the dissertation's.
#pragma once

#include <string>

#include "polycube/map/construction.h"
#include "session/session.h"

namespace orbicube::cli {

polycube::Method polycube_method_named(const std::string& name);

// Of what made a polycube; automatic: it was given.
std::string polycube_method_name(polycube::Method method);

// Adds the corner points in the dissertation's sense, and the figures of its method where that was used.
void report_corner_points(const polycube::BestConstruction& best, Session& session);

}  // namespace orbicube::cli
