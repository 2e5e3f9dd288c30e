#include "hexmesh/features/feature_hexes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "hexmesh/certificate/hex_embedding.h"
#include "hexmesh/certificate/hex_figures.h"
#include "hexmesh/features/embedding.h"
#include "hexmesh/features/feature_fitting.h"
#include "hexmesh/features/pillowing.h"
#include "hexmesh/grid/voxel_hexes.h"
#include "hexmesh/quality/gap_opening.h"
#include "mesh/search/measures.h"
#include "mesh/topology/place_text.h"

namespace orbicube::hexmesh {
namespace {

constexpr double cells_an_arc = 3;  // that the shortest arc should have
constexpr double most_growth = 3;   // of the number of cells, for that
constexpr double grid_part = 0.55;  // of the cells: the rest are rings
// Attempts to embed, each with more cells, up to a multiple of the option. They limit the work, which is proportional
// to the cells; hardly any part embeds later.
constexpr int max_attempts = 3;
constexpr double more_cells = 1.6, most_cells = 8;

// Cells with a layer, in units of a cell, and the surface in the same units.
class Attempt {
 public:
  Attempt(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
          const mesh::FeatureGraph& graph, std::size_t cells, const base::Host& host)
      : host_(host),
        grid_(voxel_hexahedra(positions, triangles, cells, host)),
        shape_(positions, triangles, graph, grid_.scale, host),
        embedding_(host.memory) {}

  std::optional<FeatureObstacle> embed() {
    HexMesh& mesh = grid_.mesh;
    BoundaryQuads quads(mesh.hexahedra, mesh.positions.size(), host_);
    if (auto obstacle = place_corners(mesh, quads, shape_, embedding_, host_)) return obstacle;
    if (auto obstacle = choose_arc_ends(mesh, quads, shape_, embedding_, host_)) return obstacle;
    std::optional<FeatureObstacle> obstacle;
    for (const double price : {3.0, 1.0, 0.3}) {
      obstacle = route_arcs(mesh, quads, shape_, price, embedding_, host_);
      if (!obstacle) obstacle = match_patches(mesh, quads, shape_, embedding_, host_);
      if (!obstacle) return add_rings(quads);
    }
    return obstacle;
  }

  // Returns whether the mesh has no inverted corner.
  bool fit(int rounds, double bound) {
    FeatureTargets targets(grid_.mesh, shape_, embedding_, host_);
    if (!fit_to_features(grid_.mesh, targets, {.rounds = rounds}, host_)) return false;
    off_surface_ = snap_to_features(grid_.mesh, targets, bound, host_);
    return true;
  }

  // The arc nearest to where the boundary meets itself, in the coordinates of the surface.
  Index arc_at(const Vector3& place) const { return nearest_arc(grid_.scale * place); }
  // The arc nearest to the worst hexahedron.
  Index arc_at_worst() const {
    const HexMesh& mesh = grid_.mesh;
    double worst = std::numeric_limits<double>::infinity();
    Vector3 place = Vector3::Zero();
    for (const Hexahedron& h : mesh.hexahedra) {
      const double now = scaled_jacobian(mesh.positions, h);
      if (now >= worst) continue;
      worst = now;
      place.setZero();
      for (const Index v : h)
        place += mesh.positions[v] / 8;
    }
    return nearest_arc(place);
  }

  HexResult result(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles) const {
    HexResult made(host_.memory);
    made.mesh = grid_.mesh;
    for (Vector3& p : made.mesh.positions)
      p /= grid_.scale;
    made.padded = made.grid_based = made.follows_sharp_edges = true;
    made.off_surface = off_surface_;
    const auto measure_quality = [&] {
      made.quality = measure_hexahedra(made.mesh.positions, made.mesh.hexahedra, host_);
      measure_embedding(made.mesh.positions, made.mesh.quads, made.quality, host_);
    };
    measure_quality();
    if (made.quality.positive() && made.quality.intersections > 0 && open_gaps(made.mesh, host_)) measure_quality();
    const HexFigures figures = figures_of(made.mesh.positions, made.mesh.hexahedra, positions, triangles, host_);
    made.distance = figures.distance;
    made.volume_error = figures.volume_error;
    made.quality.volume = figures.volume;
    const mesh::Measures measures = mesh::measures(positions, triangles, host_);
    made.pieces.assign(1, HexPiece{0.5 * (measures.low + measures.high), made.mesh.hexahedra.size(), figures.distance,
                                   figures.volume_error, true});
    return made;
  }

 private:
  Index nearest_arc(const Vector3& place) const {
    double least = std::numeric_limits<double>::infinity();
    Index arc = no_index;
    for (Index a = 0; a < shape_.arcs(); ++a) {
      const double distance = shape_.nearest_on_arc(a, place).distance;
      if (distance >= least) continue;
      least = distance;
      arc = a;
    }
    return arc;
  }

  // A layer on each patch, closed along its border: arcs get two quads a side at their corners, whatever their paths.
  std::optional<FeatureObstacle> add_rings(const BoundaryQuads& quads) {
    HexMesh& mesh = grid_.mesh;
    Array<Index> labels(mesh.hexahedra.size(), 0, host_.memory);
    for (Index q = 0; q < quads.quads().size(); ++q) {
      Index& label = labels[quads.owner(q)];
      const Index own = embedding_.quad_patches[q] + 1;
      if (label != 0 && label != own) return FeatureObstacle{no_index, no_index, "a hexahedron is on two patches"};
      label = own;
    }
    pillow(mesh, labels, host_);
    const BoundaryQuads outer(mesh.hexahedra, mesh.positions.size(), host_);
    mesh.quads.assign(outer.quads().begin(), outer.quads().end());
    mesh.quad_patches.clear();
    for (Index q = 0; q < mesh.quads.size(); ++q)
      mesh.quad_patches.push_back(labels[outer.owner(q)] - 1);
    return {};
  }

  const base::Host& host_;
  VoxelHexes grid_;
  const FeatureShape shape_;
  Embedding embedding_;
  std::size_t off_surface_ = 0;
};

std::string text_of(const FeatureObstacle& met, const mesh::FeatureGraph& graph, std::span<const Vector3> positions) {
  if (met.arc != no_index)
    return met.why + "; curve from " + mesh::place_text(positions[graph.vertices[graph.arcs[met.arc].begin]]);
  if (met.corner != no_index)
    return met.why + "; corner at " + mesh::place_text(positions[graph.corners[met.corner].vertex]);
  return met.why;
}

double shortest_arc(std::span<const Vector3> positions, const mesh::FeatureGraph& graph) {
  double least = std::numeric_limits<double>::infinity();
  for (const mesh::FeatureArc& arc : graph.arcs) {
    const auto v = graph.vertices_of(arc);
    double sum = 0;
    for (std::size_t i = 1; i < v.size(); ++i)
      sum += (positions[v[i]] - positions[v[i - 1]]).norm();
    least = std::min(least, sum);
  }
  return least;
}

}  // namespace

FeatureHexes feature_hexahedra(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                               const mesh::FeatureGraph& graph, const FeatureHexOptions& options,
                               const base::Host& host) {
  FeatureHexes made(host.memory);
  const double volume = mesh::measures(positions, triangles, host).volume;
  const double cell = shortest_arc(positions, graph) / cells_an_arc;
  const auto given = static_cast<double>(options.cells);
  const double most = std::max(given, std::min(most_cells * given, static_cast<double>(options.max_cells)));
  // Half of the cells or so are inside, at their full size.
  double cells = std::clamp(2 * volume / (cell * cell * cell), given, std::min(most, most_growth * given));
  if (options.once) cells = std::min(most, more_cells * cells);
  for (int attempt = 0; attempt < (options.once ? 1 : max_attempts); ++attempt, cells *= more_cells) {
    if (attempt > 0 && cells > most) break;
    const base::Stage stage(host, 0.5);
    const auto missed = [&](std::string why, Index arc = no_index, Index corner = no_index) {
      host.log("features in about " + std::to_string(static_cast<std::size_t>(cells)) + " hexahedra: " + why);
      made.obstacle = std::move(why);
      made.obstacle_arc = arc;
      made.obstacle_corner = corner;
    };
    try {
      Attempt now(positions, triangles, graph, static_cast<std::size_t>(grid_part * cells) + 1, host);
      if (auto obstacle = now.embed()) {
        missed(text_of(*obstacle, graph, positions), obstacle->arc, obstacle->corner);
        continue;
      }
      if (!now.fit(options.rounds, options.bound)) {
        missed("the cells along the arcs do not untangle", now.arc_at_worst());
        continue;
      }
      HexResult result = now.result(positions, triangles);
      if (!result.quality.valid()) {
        const bool meets = result.quality.positive() && result.quality.intersections > 0;
        missed(what_is_wrong(result.quality),
               meets ? now.arc_at(result.quality.first_intersection) : now.arc_at_worst());
        continue;
      }
      const bool better_one = !made.found || better(result, made.result, options.distance);
      if (better_one) made.result = std::move(result);
      made.found = true;
      if (excess(made.result, options.distance) <= 1) break;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      missed(error.what());
    }
  }
  if (made.found) made.obstacle.clear();
  return made;
}

}  // namespace orbicube::hexmesh
