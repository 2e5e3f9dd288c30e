// The choice between meshes of one solid by the features that they keep, and the mesh that has the graph embedded.
#pragma once

#include <optional>

#include "hexmesh/captured/feature_surface.h"
#include "hexmesh/captured/left_out_features.h"
#include "hexmesh/features/feature_hexes.h"
#include "hexmesh/strategies/hex_draft.h"

namespace orbicube::hexmesh {

constexpr double refused_excess = 2;  // excess() of a result that is an error

struct FeatureChoice {
  FeatureRequest request;
  // As in Options.
  std::size_t cells = 10000, max_cells = 100'000;
  double distance = 1;
  int rounds = 40;
};

// Whether features are part of this build; the module for web pages has none.
bool can_keep_features();

class FeatureKeeper {
 public:
  // Where the input has no feature graph, the log says why. Throws Error "cancelled".
  FeatureKeeper(const mesh::Mesh& input, const FeatureChoice& choice, const base::Host& host);

  // Whether there are features.
  bool any() const { return surface_ && !surface_->graph.corners.empty(); }
  // Whether embed() may succeed.
  bool can_embed() const { return any() && surface_->pieces == 1 && !surface_->graph.arcs.empty(); }
  // Whether all features are edges of about right angles that meet three at a corner, as on a polycube.
  bool rectangular() const { return rectangular_; }
  // The largest scaled Jacobian of a mesh with the graph embedded (feature_bound.h).
  double bound() const { return figures_.bound; }

  // Measures a mesh of the input and returns whether it is to be preferred to the one that was so far, `best`: by a
  // larger captured length, or as much and more corners; as many: the better mesh (hex_draft.h).
  bool offer(const HexResult& now, bool embedded, const HexResult* best);
  // Makes a grid-based mesh with the graph embedded (feature_hexes.h); where that of sharp and of marked edges has
  // none, with that of the sharp ones, then without what is in the way (left_out_features.h). Nothing: there is none,
  // and figures() say why.
  std::optional<HexResult> embed();

  // Of the preferred mesh: whether it has all features; whether hardly more can be expected.
  bool complete() const { return figures_.missing.empty(); }
  bool nearly_complete() const;
  // Its figures; each missing feature has a reason.
  FeatureFigures figures() const;

 private:
  // Makes hexahedra with the graph of `surface` embedded; errors are obstacles.
  FeatureHexes hexahedra_of(const FeatureSurface& surface, bool once);
  // The surface with the graph of another request.
  FeatureSurface with_graph_of(const FeatureRequest& request) const;
  // Leaves the arcs in the way out of the graph of a surface; returns whether enough is left.
  bool leave_out(const FeatureHexes& made, FeatureSurface& surface, const FeatureRequest& request);
  // Returns the reason why a missing feature is none of the embedded graph; nothing: it is one.
  const std::string* why_left_out(const MissingFeature& missing) const;

  const FeatureChoice choice_;
  const base::Host& host_;
  std::optional<FeatureSurface> surface_;
  bool rectangular_ = false;
  FeatureFigures figures_;
  std::optional<FeatureHexes> tried_;
  LeftOutFeatures left_out_;
  std::size_t fitted_ = 0, visited_ = 0;  // hexahedra of all fits, cells of all grids
};

}  // namespace orbicube::hexmesh
