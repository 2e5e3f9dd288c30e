#include "report/polycube_methods.h"

#include "base/counted.h"
#include "report/polycube_outputs.h"
#include "report/text.h"

namespace orbicube::cli {

polycube::Method polycube_method_named(const std::string& name) {
  if (name == "labels") return polycube::Method::labels;
  if (name == "dissertation") return polycube::Method::dissertation;
  return name == "voxels" ? polycube::Method::voxels : polycube::Method::automatic;
}

std::string polycube_method_name(polycube::Method method) {
  if (method == polycube::Method::automatic) return "given";
  if (method == polycube::Method::dissertation) return "dissertation";
  return method == polycube::Method::labels ? "labels" : "voxels";
}

void report_corner_points(const polycube::BestConstruction& best, Session& session) {
  // Beyond that the cells between all planes take long to look through.
  constexpr std::size_t max_corners = 1000;
  if (best.made.certificate.corners <= max_corners)
    session.figures()["corner_points"] = polycube::dissertation::count_corner_points(best.made.map, session.host());
  if (!best.printed) return;
  const polycube::dissertation::PrintedReport& printed = *best.printed;
  session.figures()["dissertation"] = {{"octree_depth", printed.octree_depth},
                                       {"corner_points", printed.corner_points},
                                       {"rectangles", printed.rectangles},
                                       {"distortion_before", distortion_figures(printed.before)},
                                       {"energies", printed.energies},
                                       {"rounds", printed.rounds},
                                       {"converged", printed.converged},
                                       {"domain_evaluations", printed.domain_evaluations},
                                       {"corner_evaluations", printed.corner_evaluations},
                                       {"failed_evaluations", printed.failed_evaluations},
                                       {"factorizations", printed.factorizations},
                                       {"rows_removed", printed.rows_removed},
                                       {"rows_added", printed.rows_added}};
  session.say("  octree of depth " + std::to_string(printed.octree_depth) + ", " +
              base::counted(printed.corner_points, "corner point") + "; energy " + number(printed.energies.front()) +
              ", after " + base::counted(printed.rounds, "round") + " " + number(printed.energies.back()));
}

}  // namespace orbicube::cli
