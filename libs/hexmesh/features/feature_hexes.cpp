#include "hexmesh/features/feature_hexes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "hexmesh/certificate/hex_embedding.h"
#include "hexmesh/certificate/hex_figures.h"
#include "hexmesh/features/feature_fitting.h"
#include "hexmesh/features/grading/graded_search.h"
#include "hexmesh/quality/gap_opening.h"
#include "mesh/search/measures.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/place_text.h"

namespace orbicube::hexmesh {
namespace {

// Meshes that are fitted, each after other cells. They limit the work, which is proportional to the cells; hardly any
// part succeeds later.
constexpr int max_fits = 3;
constexpr double part_of_rounds = 0.6;  // of smoothing: as good as all, in two thirds of the time
constexpr double more_cells = 1.6, least_more_cells = 1.1, most_cells = 8;  // of the option
constexpr double finer = 1.5;                                               // where a fit failed
constexpr double finer_at_missing = 1.25;                                   // at arcs that a mesh lacks
constexpr double all_captured = 0.99;                                       // of the length

Index nearest_arc(const FeatureShape& shape, const Vector3& place) {
  double least = std::numeric_limits<double>::infinity();
  Index arc = no_index;
  for (Index a = 0; a < shape.arcs(); ++a) {
    const double distance = shape.nearest_on_arc(a, place).distance;
    if (distance >= least) continue;
    least = distance;
    arc = a;
  }
  return arc;
}

// The arc nearest to the worst hexahedron.
Index arc_at_worst(const GradedCells& cells) {
  const HexMesh& mesh = cells.mesh();
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
  return nearest_arc(cells.shape(), place);
}

// Of a mesh that is not valid, or of cells without one: the arc nearest to what is wrong.
Index arc_at_fault(const GradedCells& cells, const std::optional<HexResult>& result) {
  if (!result || !result->quality.positive() || result->quality.intersections == 0) return arc_at_worst(cells);
  return nearest_arc(cells.shape(), cells.unit() * result->quality.first_intersection);
}

// Pairs of quads that intersect where walls of a gap went through each other: smaller cells along an arc do not help.
bool closes_a_gap(const std::optional<HexResult>& result) {
  constexpr std::size_t at_an_arc = 100;
  return result && result->quality.positive() && result->quality.intersections > at_an_arc;
}

std::string why_not(const std::optional<HexResult>& result) {
  return result ? what_is_wrong(result->quality) : "the cells along the arcs do not untangle";
}

HexResult result_of(const GradedCells& cells, std::size_t off_surface, std::span<const Vector3> positions,
                    std::span<const mesh::Triangle> triangles, const base::Host& host) {
  HexResult made(host.memory);
  made.mesh = cells.mesh();
  for (Vector3& p : made.mesh.positions)
    p /= cells.unit();
  made.padded = made.grid_based = made.follows_sharp_edges = true;
  made.off_surface = off_surface;
  const auto measure_quality = [&] {
    made.quality = measure_hexahedra(made.mesh.positions, made.mesh.hexahedra, host);
    measure_embedding(made.mesh.positions, made.mesh.quads, made.quality, host);
  };
  measure_quality();
  constexpr std::size_t few = 1000;  // pairs of quads: with more, whole walls went through each other
  const std::size_t meetings = made.quality.positive() ? made.quality.intersections : 0;
  if (meetings > 0 && meetings <= few && open_gaps(made.mesh, host)) measure_quality();
  const HexFigures figures = figures_of(made.mesh.positions, made.mesh.hexahedra, positions, triangles, host);
  made.distance = figures.distance;
  made.volume_error = figures.volume_error;
  made.quality.volume = figures.volume;
  const mesh::Measures measures = mesh::measures(positions, triangles, host);
  made.pieces.assign(1, HexPiece{0.5 * (measures.low + measures.high), made.mesh.hexahedra.size(), figures.distance,
                                 figures.volume_error, true});
  return made;
}

// The mesh of cells on the surface, valid or not; nothing where it does not untangle.
std::optional<HexResult> fitted_result(GradedCells& cells, std::span<const Vector3> positions,
                                       std::span<const mesh::Triangle> triangles, const FeatureHexOptions& options,
                                       const base::Host& host) {
  const int rounds = static_cast<int>(std::lround(part_of_rounds * options.rounds));
  if (!fit_to_features(cells.mesh(), cells.sizes(), cells.targets(), {.rounds = rounds}, host)) return {};
  std::size_t off = snap_to_features(cells.mesh(), cells.sizes(), cells.targets(), options.bound, host);
  HexResult result = result_of(cells, off, positions, triangles, host);
  if (result.quality.positive()) return result;
  // A few folds cost less of the features than other cells.
  off = free_folded_hexahedra(cells.mesh(), cells.sizes(), cells.targets(), options.bound, host);
  return result_of(cells, off, positions, triangles, host);
}

Array<Index> arcs_of(std::span<const FeatureObstacle> obstacles, const mesh::FeatureGraph& graph,
                     const base::Host& host) {
  Array<Index> arcs(host.memory);
  for (const FeatureObstacle& met : obstacles) {
    if (met.arc != no_index) arcs.push_back(met.arc);
    if (met.corner == no_index) continue;
    for (const mesh::FeatureEnd& end : graph.around[met.corner])
      arcs.push_back(end.arc);
  }
  return arcs;
}

std::string text_of(const FeatureObstacle& met, const mesh::FeatureGraph& graph, std::span<const Vector3> positions) {
  if (met.arc != no_index)
    return met.why + "; curve from " + mesh::place_text(positions[graph.vertices[graph.arcs[met.arc].begin]]);
  if (met.corner != no_index)
    return met.why + "; corner at " + mesh::place_text(positions[graph.corners[met.corner].vertex]);
  return met.why;
}

// Of two meshes near the surface that with more of the length, else the better one.
bool preferred(const HexResult& x, double captured_x, const HexResult& y, double captured_y, double distance) {
  constexpr double same = 0.005;
  const bool near = excess(x, distance) <= 1 && excess(y, distance) <= 1;
  if (near && std::min(captured_x, captured_y) < all_captured && std::abs(captured_x - captured_y) > same)
    return captured_x > captured_y;
  return better(x, y, distance);
}

void refine_at_missing(const FeatureFigures& figures, GradedSearch& search) {
  bool none = true;
  for (const MissingFeature& missing : figures.missing) {
    if (missing.corner) continue;
    const FeatureObstacle obstacle = {no_index, missing.number, ""};
    search.refine_at(std::span(&obstacle, 1), finer_at_missing);
    none = false;
  }
  if (none) search.refine_everywhere(finer_at_missing);
}

// Smaller cells where quads are chords of a surface that bends more than the distance allows: the sizes of cells are
// those that arcs require, and patches may bend between them. Returns whether there is such a quad.
bool refine_at_chords(const HexMesh& mesh, std::span<const Vector3> positions,
                      std::span<const mesh::Triangle> triangles, double distance, const AxisGrading& grading,
                      GradedSearch& search, const base::Host& host) {
  constexpr double aim = 0.6;  // of the distance
  const mesh::SurfaceSearch surface(positions, triangles, host);
  const mesh::Measures measures = mesh::measures(positions, triangles, host);
  const double most = distance / 100 * (measures.high - measures.low).norm();
  bool any = false;
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    if (i % 1024 == 0) host.report("features", 0, 0);
    const Quad& q = mesh.quads[i];
    const auto corner = [&](std::size_t k) -> const Vector3& { return mesh.positions[q[k % 4]]; };
    const Vector3 center = (corner(0) + corner(1) + corner(2) + corner(3)) / 4;
    const double away = surface.nearest(center).distance;
    if (away <= aim * most) continue;
    // A chord's height is proportional to the square of its length.
    const double size = grading.size(center).maxCoeff() * std::sqrt(aim * most / away);
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}})
      search.refine_between(corner(k), corner(k + 2), size);
    any = true;
  }
  return any;
}

// Smaller cells where a mesh is too far from the surface, everywhere or, if these would be too many, by
// refine_chords(), and else at the arcs that it lacks. Returns whether there is room below `most` cells.
template <class RefineChords>
bool refine_for_more(double times_too_far, double most, const FeatureFigures& figures,
                     const RefineChords& refine_chords, GradedSearch& search) {
  if (times_too_far <= 1) {
    refine_at_missing(figures, search);
    return true;
  }
  // Distances are as the squares of lengths.
  if (search.cells() * std::pow(times_too_far, 1.5) > most && refine_chords()) return true;
  // The square: cells become more along all axes where their size matters.
  const double room = 0.95 * std::sqrt(most / search.cells());
  if (room < least_more_cells) return false;
  search.refine_everywhere(std::min(more_cells, room));
  return true;
}

void log_missed(double cells, const std::string& obstacle, const base::Host& host) {
  host.log("features in about " + std::to_string(static_cast<std::size_t>(cells)) + " hexahedra: " + obstacle);
}

void log_fitted(const HexResult& result, const FeatureFigures& figures, double distance, const base::Host& host) {
  host.log("features in " + std::to_string(result.mesh.hexahedra.size()) +
           " hexahedra: " + std::to_string(figures.captured) + " of the length captured, " +
           std::to_string(excess(result, distance)) + " times as far away as requested");
}

// The next grid that is not the one of `refused` hexahedra again: what was requested after a fit may be less than what
// the grid had.
std::optional<EmbeddedCells> next_other(GradedSearch& search, std::size_t refused) {
  for (;;) {
    std::optional<EmbeddedCells> found = search.next();
    if (!found || found->cells->mesh().hexahedra.size() != refused) return found;
    search.refine_everywhere(finer_at_missing);
  }
}

}  // namespace

FeatureHexes feature_hexahedra(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                               const mesh::FeatureGraph& graph, const FeatureHexOptions& options,
                               const base::Host& host) {
  FeatureHexes made(host.memory);
  const auto given = static_cast<double>(options.cells);
  const double most = std::max(given, std::min(most_cells * given, static_cast<double>(options.max_cells)));
  double captured = 0;         // of made.result
  std::size_t refused = 0;     // hexahedra of the last mesh that could not be fitted
  std::size_t correction = 0;  // hexahedra that another mesh may have where one is valid and only too far away
  GradedSearch search(positions, triangles, graph, given, most, static_cast<double>(options.max_visited), host);
  const auto missed = [&](std::span<const FeatureObstacle> obstacles) {
    made.obstacle = text_of(obstacles[0], graph, positions);
    made.arcs_in_the_way = arcs_of(obstacles, graph, host);
    log_missed(search.cells(), made.obstacle, host);
  };
  for (int fit = 0; fit < max_fits; ++fit) {
    const base::Stage stage(host, 0.5);
    const std::optional<EmbeddedCells> found = next_other(search, refused);
    if (!found) {
      missed(search.obstacles());
      break;
    }
    GradedCells& cells = *found->cells;
    const std::size_t size = cells.mesh().hexahedra.size();
    if (size > std::max(options.max_fitted - std::min(options.max_fitted, made.fitted), correction)) {
      if (made.obstacle.empty())
        missed(std::array{FeatureObstacle{no_index, no_index, std::to_string(size) + " more hexahedra take too long"}});
      break;
    }
    made.fitted += size;
    const auto refine_chords = [&] {
      return refine_at_chords(made.result.mesh, positions, triangles, options.distance, *found->grading, search, host);
    };
    std::optional<HexResult> fitted = fitted_result(cells, positions, triangles, options, host);
    if (!fitted || !fitted->quality.valid()) {
      const std::array fault = {FeatureObstacle{no_index, arc_at_fault(cells, fitted), why_not(fitted)}};
      missed(fault);
      if (closes_a_gap(fitted)) made.arcs_in_the_way.clear();
      if (closes_a_gap(fitted) || (options.once && !made.found)) break;
      search.refine_at(fault, finer);
      refused = size;
      continue;
    }
    const FeatureFigures figures = options.measure ? options.measure(fitted->mesh) : FeatureFigures();
    log_fitted(*fitted, figures, options.distance, host);
    if (!made.found || preferred(*fitted, figures.captured, made.result, captured, options.distance)) {
      made.result = std::move(*fitted);
      captured = figures.captured;
    }
    made.found = true;
    const double times_too_far = excess(made.result, options.distance);
    if (times_too_far <= 1 && (options.once || captured >= all_captured)) break;
    if (times_too_far > 1 && correction == 0) correction = size + size / 2;
    if (!refine_for_more(times_too_far, most, figures, refine_chords, search)) break;
  }
  if (made.found) made.obstacle.clear();
  made.visited = static_cast<std::size_t>(std::ceil(search.visited()));
  return made;
}

}  // namespace orbicube::hexmesh
