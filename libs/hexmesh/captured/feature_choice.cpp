#include "hexmesh/captured/feature_choice.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "hexmesh/captured/captured_features.h"
#include "hexmesh/captured/feature_bound.h"

namespace orbicube::hexmesh {
namespace {

bool must_end(const base::Error& error) {
  return error.status() == base::Status::cancelled || error.status() == base::Status::out_of_memory;
}

bool has_all(const FeatureFigures& figures) {
  constexpr double all = 0.99;  // of the length
  return figures.missing.empty() && figures.captured >= all;
}

// More of the length, or as much and more corners; as many, or all of both: the better mesh.
bool keeps_more(const HexResult& x, const FeatureFigures& of_x, const HexResult& y, const FeatureFigures& of_y,
                double distance) {
  constexpr double same = 1e-3;  // of the length
  constexpr double refused = 2;  // excess of a result that is an error
  if (excess(y, distance) > refused && excess(x, distance) < excess(y, distance)) return true;
  const double near = std::max(1.0, excess(y, distance));
  if (excess(x, distance) > near) return false;
  if (has_all(of_x) && has_all(of_y)) return better(x, y, distance);
  if (of_x.captured > of_y.captured + same) return true;
  if (of_x.captured < of_y.captured - same) return false;
  if (of_x.missing.size() != of_y.missing.size()) return of_x.missing.size() < of_y.missing.size();
  return better(x, y, distance);
}

// The reason for a missing feature: what was in the way of the embedding, at this curve or corner where that is known.
std::string reason(const MissingFeature& missing, const std::optional<FeatureHexes>& tried, bool embedded,
                   std::size_t pieces) {
  if (embedded && tried && !tried->obstacle.empty()) return "the graph with it has no mesh: " + tried->obstacle;
  if (embedded) return "edges of the mesh are farther than a tenth of the mean edge from it";
  if (pieces > 1) return "features of several pieces are those that the method follows";
  if (!tried) return "the method does not follow it, and the mesh is not to be replaced";
  if (tried->found) return "the mesh that has the graph of the features keeps less of it";
  const bool own = missing.corner ? tried->obstacle_corner == missing.number : tried->obstacle_arc == missing.number;
  return own ? tried->obstacle : "the feature graph has no mesh: " + tried->obstacle;
}

double length_of(const FeatureSurface& surface, Index arc) {
  const auto v = surface.graph.vertices_of(surface.graph.arcs[arc]);
  double sum = 0;
  for (std::size_t i = 1; i < v.size(); ++i)
    sum += (surface.positions[v[i]] - surface.positions[v[i - 1]]).norm();
  return sum;
}

// The arc that stopped an embedding, or the shortest at the corner that did.
Index arc_in_the_way(const FeatureHexes& made, const FeatureSurface& surface) {
  const mesh::FeatureGraph& graph = surface.graph;
  if (made.obstacle_arc != no_index || made.obstacle_corner == no_index) return made.obstacle_arc;
  Index shortest = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (const mesh::FeatureEnd& end : graph.around[made.obstacle_corner]) {
    const double length = length_of(surface, end.arc);
    if (length >= least) continue;
    least = length;
    shortest = end.arc;
  }
  return shortest;
}

}  // namespace

bool can_keep_features() {
  return true;
}

FeatureKeeper::FeatureKeeper(const mesh::Mesh& input, const FeatureChoice& choice, const base::Host& host)
    : input_(input), choice_(choice), host_(host) {
  try {
    surface_.emplace(feature_surface(input, choice.request, host));
    if (!any()) return;
    figures_.bound = scaled_jacobian_bound(*surface_, host);
    rectangular_ = has_right_angles(*surface_, host);
  } catch (const base::Error& error) {
    if (must_end(error)) throw;
    surface_.reset();
    host.log(std::string("sharp edges are not kept: ") + error.what());
  }
}

bool FeatureKeeper::offer(const HexResult& now, bool embedded, const HexResult* best) {
  FeatureFigures of_now;
  of_now.bound = figures_.bound;
  of_now.replaced = embedded;
  if (any()) measure_captured(now.mesh, *surface_, of_now, host_);
  if (best != nullptr && !keeps_more(now, of_now, *best, figures_, choice_.distance)) return false;
  figures_ = std::move(of_now);
  return true;
}

FeatureHexes FeatureKeeper::hexahedra_of(const FeatureSurface& surface, bool once) {
  constexpr std::size_t most_fitted = 12;  // of the option `cells`: a fit of the largest mesh, or several of others
  try {
    FeatureHexes made = feature_hexahedra(surface.positions, surface.triangles, surface.graph,
                                          {.cells = choice_.cells,
                                           .max_cells = choice_.max_cells,
                                           .distance = choice_.distance,
                                           .rounds = choice_.rounds,
                                           .bound = scaled_jacobian_bound(surface, host_),
                                           .once = once,
                                           .measure =
                                               [&](const HexMesh& mesh) {
                                                 FeatureFigures figures;
                                                 measure_captured(mesh, surface, figures, host_);
                                                 return figures;
                                               },
                                           .max_fitted = std::max(most_fitted * choice_.cells, fitted_) - fitted_},
                                          host_);
    fitted_ += made.fitted;
    return made;
  } catch (const base::Error& error) {
    if (must_end(error)) throw;
    FeatureHexes none(host_.memory);
    none.obstacle = error.what();
    return none;
  }
}

// Leaves out one arc after the other that is in the way.
FeatureHexes FeatureKeeper::without_obstacles(FeatureSurface& surface, const FeatureRequest& request,
                                              FeatureHexes made) {
  constexpr int most = 3;             // arcs
  constexpr double least_kept = 0.5;  // of the length of the sharp edges: less is hardly worth a mesh with a layer
  const auto length_of_all = [&] {
    double sum = 0;
    for (Index a = 0; a < surface.graph.arcs.size(); ++a)
      sum += length_of(surface, a);
    return sum;
  };
  const double whole = length_of_all();
  Array<mesh::Edge> without(host_.memory);
  for (int i = 0; i < most && !made.found; ++i) {
    const Index arc = arc_in_the_way(made, surface);
    if (arc == no_index) break;
    const auto v = surface.graph.vertices_of(surface.graph.arcs[arc]);
    for (std::size_t k = 1; k < v.size(); ++k)
      without.push_back({v[k - 1], v[k]});
    surface.graph = graph_without(surface, request, without, host_);
    if (surface.graph.arcs.empty() || length_of_all() < least_kept * whole) break;
    made = hexahedra_of(surface, true);
  }
  return made;
}

std::optional<HexResult> FeatureKeeper::embed() {
  if (!any() || surface_->pieces != 1 || surface_->graph.arcs.empty()) return {};
  tried_ = hexahedra_of(*surface_, false);
  if (!tried_->found) {
    FeatureRequest request = choice_.request;
    const bool marked = request.features == Features::automatic && !surface_->lines.empty();
    if (marked) request.features = Features::angles;
    FeatureSurface surface = feature_surface(input_, request, host_);
    FeatureHexes fewer(host_.memory);
    fewer.obstacle_arc = tried_->obstacle_arc;
    fewer.obstacle_corner = tried_->obstacle_corner;
    const bool sharp_only = surface.graph.arcs.size() < surface_->graph.arcs.size();
    if (sharp_only) host_.log("features: without those that are marked and not sharp");
    const bool some = !surface.graph.arcs.empty();
    if (some && sharp_only) fewer = hexahedra_of(surface, false);
    if (some && !fewer.found) fewer = without_obstacles(surface, request, std::move(fewer));
    tried_->found = fewer.found;
    if (fewer.found) tried_->result = std::move(fewer.result);
  }
  if (tried_->found) return std::move(tried_->result);
  host_.log("sharp edges are not kept: " + tried_->obstacle);
  return {};
}

bool FeatureKeeper::nearly_complete() const {
  constexpr double enough = 0.95;  // of the length
  return complete() || figures_.captured >= enough;
}

FeatureFigures FeatureKeeper::figures() const {
  FeatureFigures figures = figures_;
  for (MissingFeature& missing : figures.missing)
    missing.why = reason(missing, tried_, figures.replaced, surface_->pieces);
  return figures;
}

}  // namespace orbicube::hexmesh
