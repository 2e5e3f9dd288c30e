#include "hexmesh/captured/feature_choice.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "hexmesh/captured/captured_features.h"
#include "hexmesh/captured/feature_bound.h"
#include "hexmesh/features/feature_hexes.h"

namespace orbicube::hexmesh {
namespace {

bool must_end(const base::Error& error) {
  return error.status() == base::Status::cancelled || error.status() == base::Status::out_of_memory;
}

// More of the length, or as much and more corners; as many: the better mesh.
bool keeps_more(const HexResult& x, const FeatureFigures& of_x, const HexResult& y, const FeatureFigures& of_y,
                double distance) {
  constexpr double same = 1e-3;  // of the length
  const double near = std::max(1.0, excess(y, distance));
  if (excess(x, distance) > near) return false;
  if (of_x.captured > of_y.captured + same) return true;
  if (of_x.captured < of_y.captured - same) return false;
  if (of_x.missing.size() != of_y.missing.size()) return of_x.missing.size() < of_y.missing.size();
  return better(x, y, distance);
}

// The reason for a missing feature: what was in the way of the embedding, at this curve or corner where that is known.
std::string reason(const MissingFeature& missing, const std::optional<FeatureHexes>& tried, bool replaced,
                   const std::string& untried) {
  if (replaced) return "edges of the mesh are farther than a tenth of the mean edge from it";
  if (!tried) return untried;
  if (tried->found) return "the mesh that has the graph of the features keeps less of it";
  const bool own = missing.corner ? tried->obstacle_corner == missing.number : tried->obstacle_arc == missing.number;
  return own ? tried->obstacle : "the feature graph has no mesh: " + tried->obstacle;
}

}  // namespace

FeatureFigures keep_features(const mesh::Mesh& input, const FeatureChoice& choice, std::optional<HexResult>& made,
                             const base::Host& host) {
  FeatureFigures figures;
  try {
    const FeatureSurface surface = feature_surface(input, choice.request, host);
    if (surface.graph.corners.empty()) return figures;
    figures.bound = scaled_jacobian_bound(surface, host);
    if (made) measure_captured(made->mesh, surface, figures, host);
    if (made && figures.missing.empty()) return figures;
    std::string untried = "the method does not follow it, and the mesh is not to be replaced";
    if (surface.pieces > 1) untried = "features of several pieces are those that the method follows";
    std::optional<FeatureHexes> tried;
    if (choice.may_replace && surface.pieces == 1 && !surface.graph.arcs.empty()) {
      const base::Stage stage(host, 0.95);
      tried = feature_hexahedra(
          surface.positions, surface.triangles, surface.graph,
          {.cells = choice.cells, .max_cells = choice.max_cells, .distance = choice.distance, .rounds = choice.rounds},
          host);
      if (tried->found) {
        FeatureFigures now = figures;
        measure_captured(tried->result.mesh, surface, now, host);
        if (!made || keeps_more(tried->result, now, *made, figures, choice.distance)) {
          made = std::move(tried->result);
          figures = std::move(now);
          figures.replaced = true;
        }
      } else {
        host.log("sharp edges are not kept: " + tried->obstacle);
      }
    }
    for (MissingFeature& missing : figures.missing)
      missing.why = reason(missing, tried, figures.replaced, untried);
  } catch (const base::Error& error) {
    if (must_end(error)) throw;
    host.log(std::string("sharp edges are not kept: ") + error.what());
  }
  return figures;
}

}  // namespace orbicube::hexmesh
