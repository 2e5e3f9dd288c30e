#include "hexmesh/captured/feature_choice.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "hexmesh/captured/captured_features.h"
#include "hexmesh/captured/feature_bound.h"
#include "mesh/search/measures.h"

namespace orbicube::hexmesh {
namespace {

// Of the mean cell: where a line bends only, and again so soon, the bend is a place of an arc, not a corner; and curves
// so short are left out together. Larger: fewer corners, which small cells are not needed for; smaller: more exact
// ones.
constexpr double shortest_side = 2.5;

bool has_all(const FeatureFigures& figures) {
  constexpr double all = 0.99;  // of the length
  return figures.missing.empty() && figures.captured >= all;
}

// More of the length, or as much and more corners; as many, or all of both: the better mesh.
bool keeps_more(const HexResult& x, const FeatureFigures& of_x, const HexResult& y, const FeatureFigures& of_y,
                double distance) {
  constexpr double same = 1e-3;  // of the length
  if (excess(y, distance) > refused_excess && excess(x, distance) < excess(y, distance)) return true;
  const double near = std::max(1.0, excess(y, distance));
  if (excess(x, distance) > near) return false;
  if (has_all(of_x) && has_all(of_y)) return better(x, y, distance);
  if (of_x.captured > of_y.captured + same) return true;
  if (of_x.captured < of_y.captured - same) return false;
  if (of_x.missing.size() != of_y.missing.size()) return of_x.missing.size() < of_y.missing.size();
  return better(x, y, distance);
}

// The reason for a missing feature: what was in the way of the embedding.
std::string reason(const std::optional<FeatureHexes>& tried, bool embedded, std::size_t pieces) {
  if (embedded) return "edges of the mesh are farther than a tenth of the mean edge from it";
  if (pieces > 1) return "features of several pieces are those that the method follows";
  if (!tried) return "the method does not follow it, and the mesh is not to be replaced";
  if (tried->found)
    return "the mesh that has the graph of the features keeps less of it or is farther from the surface";
  return "the feature graph has no mesh: " + tried->obstacle;
}

double length_of_all(const FeatureSurface& surface) {
  double sum = 0;
  for (Index a = 0; a < surface.graph.arcs.size(); ++a)
    sum += length_of(surface, a);
  return sum;
}

}  // namespace

bool can_keep_features() {
  return true;
}

FeatureKeeper::FeatureKeeper(const mesh::Mesh& input, const FeatureChoice& choice, const base::Host& host)
    : choice_(choice), host_(host), left_out_(host.memory) {
  try {
    surface_.emplace(feature_surface(input, choice.request, host));
    if (!any()) return;
    figures_.bound = scaled_jacobian_bound(*surface_, host);
    rectangular_ = has_right_angles(*surface_, host);
  } catch (const base::Error& error) {
    if (error.must_end()) throw;
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
  constexpr std::size_t most_fitted = 8;  // of the option `cells`: a fit of the largest mesh, or several of others
  constexpr std::size_t cheap = 5000;     // hexahedra that are fitted in a second or two in any case
  constexpr double rings_saved = 1.2;     // about, of the number of hexahedra that is expected over that of a mesh
  // Likewise of all grids. Of machined parts that were tried, those with an embedding take up to 116.
  constexpr std::size_t most_visited = 400;
  const std::size_t left = std::max({most_fitted * choice_.cells, cheap, fitted_}) - fitted_;
  const std::size_t visits_left = std::max(most_visited * choice_.cells, visited_) - visited_;
  const auto affordable = static_cast<std::size_t>(rings_saved * static_cast<double>(left));
  try {
    FeatureHexes made = feature_hexahedra(surface.positions, surface.triangles, surface.graph,
                                          {.cells = choice_.cells,
                                           .max_cells = std::min(choice_.max_cells, affordable),
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
                                           .max_fitted = left,
                                           .max_visited = visits_left},
                                          host_);
    fitted_ += made.fitted;
    visited_ += made.visited;
    return made;
  } catch (const base::Error& error) {
    if (error.must_end()) throw;
    FeatureHexes none(host_.memory);
    none.obstacle = error.what();
    return none;
  }
}

FeatureSurface FeatureKeeper::with_graph_of(const FeatureRequest& request) const {
  FeatureSurface surface(host_.memory);
  surface = *surface_;
  surface.graph = graph_without(surface, request, {}, host_);
  return surface;
}

bool FeatureKeeper::leave_out(const FeatureHexes& made, FeatureSurface& surface, const FeatureRequest& request) {
  constexpr double least_kept = 0.5;  // of the length of the sharp edges: less is hardly worth a mesh with a layer
  if (made.arcs_in_the_way.empty()) return false;
  left_out_.add(surface, made.arcs_in_the_way, request.shortest_side, made.obstacle, host_);
  const mesh::FeatureGraph before = std::move(surface.graph);
  surface.graph = graph_without(surface, request, left_out_.edges(), host_);
  left_out_.add_lost(before, surface.graph, "it would end inside a face; " + made.obstacle);
  return !surface.graph.arcs.empty() && length_of_all(surface) >= least_kept * length_of_all(*surface_);
}

std::optional<HexResult> FeatureKeeper::embed() {
  constexpr int most_left_out = 6;  // times
  if (!can_embed()) return {};
  FeatureRequest request = choice_.request;
  const double volume = mesh::measures(surface_->positions, surface_->triangles, host_).volume;
  request.shortest_side = shortest_side * std::cbrt(volume / static_cast<double>(choice_.cells));
  FeatureSurface surface = with_graph_of(request);
  tried_ = hexahedra_of(surface, false);
  if (!tried_->found && request.features == Features::automatic && !surface_->lines.empty()) {
    request.features = Features::angles;
    FeatureSurface sharp = with_graph_of(request);
    if (!sharp.graph.arcs.empty() && sharp.graph.arcs.size() < surface.graph.arcs.size()) {
      host_.log("features: without those that are marked and not sharp");
      left_out_.add_lost(surface.graph, sharp.graph, "it is not sharp; " + tried_->obstacle);
      surface = std::move(sharp);
      tried_ = hexahedra_of(surface, false);
    }
  }
  for (int i = 0; i < most_left_out && !tried_->found && leave_out(*tried_, surface, request); ++i)
    tried_ = hexahedra_of(surface, true);
  if (tried_->found) return std::move(tried_->result);
  host_.log("sharp edges are not kept: " + tried_->obstacle);
  return {};
}

bool FeatureKeeper::nearly_complete() const {
  constexpr double enough = 0.95, enough_embedded = 0.75;  // of the length; strategies without the graph have no more
  return complete() || figures_.captured >= (figures_.replaced ? enough_embedded : enough);
}

const std::string* FeatureKeeper::why_left_out(const MissingFeature& missing) const {
  const mesh::FeatureGraph& graph = surface_->graph;
  const auto of_arc = [&](Index arc) {
    const auto v = graph.vertices_of(graph.arcs[arc]);
    const std::string* why = nullptr;
    for (std::size_t i = 1; i < v.size() && why == nullptr; ++i)
      why = left_out_.why(v[i - 1], v[i]);
    return why;
  };
  if (!missing.corner) return of_arc(missing.number);
  const std::string* why = nullptr;
  for (const mesh::FeatureEnd& end : graph.around[missing.number])
    why = why != nullptr ? why : of_arc(end.arc);
  return why;
}

FeatureFigures FeatureKeeper::figures() const {
  FeatureFigures figures = figures_;
  for (MissingFeature& missing : figures.missing) {
    const std::string* const why = why_left_out(missing);
    missing.why =
        why != nullptr ? "the graph with it has no mesh: " + *why : reason(tried_, figures.replaced, surface_->pieces);
  }
  return figures;
}

}  // namespace orbicube::hexmesh
