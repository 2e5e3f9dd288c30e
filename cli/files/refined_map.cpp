#include "files/refined_map.h"

#include <cmath>

#include "base/counted.h"
#include "files/exact_file.h"
#include "harmonics/fitting/map_refinement.h"
#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"
#include "report/text.h"
#include "sphere_map/optimization/measure.h"

namespace orbicube::cli {

void check_refinement(const MapRefinement& refinement) {
  if (refinement.output.empty()) return;
  if (refinement.rounds == 0) throw Failure(Exit::wrong_input, "", "usage", "--refined-map is for --refine-map ROUNDS");
  require_exact_output(refinement.output);
}

void refine_map(const MapRefinement& refinement, const harmonics::FitOptions& fit, const VertexWeights& weights,
                const mesh::Mesh& surface, mesh::Mesh& map, bool text, Session& session) {
  const base::Host& host = session.host();
  // At a size near 1 squares neither overflow nor vanish. Vertices in no triangle count for nothing.
  mesh::Mesh scaled(host.memory);
  scaled.positions = surface.positions;
  scaled.triangles = surface.triangles;
  const int exponent = mesh::unit_scale_exponent(surface.positions, surface.triangles);
  mesh::scale_by_power(scaled.positions, exponent);
  base::Array<double> of_vertices = weights(scaled);
  const base::Array<std::uint8_t> used = mesh::used_vertices(surface.positions.size(), surface.triangles, host.memory);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] != 0) continue;
    of_vertices[v] = 0;
    scaled.positions[v].setZero();
  }
  const std::size_t before = sphere_map::count_not_positive(map.triangles, map.positions);
  const harmonics::RefinementReport report = harmonics::refine_map(
      scaled.positions, map.triangles, of_vertices, {.fit = fit, .rounds = refinement.rounds}, map.positions, host);
  if (before == 0 && sphere_map::count_not_positive(map.triangles, map.positions) > 0)
    throw Failure(Exit::no_result, refinement.output, "no-valid-result", "the refined map is not one to one");
  session.figures()["refinement"] = {{"output", refinement.output},
                                     {"rounds", report.rounds},
                                     {"residual_before", std::ldexp(report.residual_before, -exponent)},
                                     {"residual", std::ldexp(report.residual, -exponent)}};
  session.say("  map refined in " + base::counted(report.rounds, "round") + ": residual " +
              number(std::ldexp(report.residual, -exponent)) + ", before " +
              number(std::ldexp(report.residual_before, -exponent)));
  if (refinement.output.empty()) return;
  write_exactly(refinement.output, map.positions, map.triangles, text, session);
  session.say("  wrote " + refinement.output);
}

}  // namespace orbicube::cli
