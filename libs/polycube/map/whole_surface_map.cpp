#include "polycube/map/whole_surface_map.h"

#include <limits>
#include <utility>

#include "polycube/labels/label_smoothing.h"
#include "polycube/map/labelled_target.h"
#include "polycube/map/map_refinement.h"
#include "polycube/surface/distortion.h"
#include "polycube/surface/refinement.h"

namespace orbicube::polycube {
namespace {

constexpr std::size_t map_triangles = 5000;
constexpr int smoothing_sweeps = 30;
constexpr int final_polishing_steps = 40;
constexpr int final_sweeps = 6;

// Returns where the candidate's map has the planes of the given triangles of the whole surface's map.
Array<double> planes_of(const WholeSurface& surface, const LabelCandidate& candidate, const SurfaceMap& map,
                        std::span<const Index> triangles, const base::Host& host) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Array<double> plane(surface.triangles.size(), unknown, host.memory);
  Array<AxisLabel> label(surface.triangles.size(), label_count, host.memory);
  for (std::size_t i = 0; i < candidate.map.triangles.size(); ++i) {
    const Index source = surface.search.source[candidate.map.triangle_sources[i]];
    label[source] = candidate.map.labels[i];
    plane[source] = surface.frame.scale * candidate.map.polycube[candidate.map.triangles[i][0]][axis_of(label[source])];
  }
  Array<double> result(host.memory);
  for (const Index t : triangles) {
    const Index source = map.triangle_sources[t];
    result.push_back(label[source] == map.labels[t] ? plane[source] : unknown);
  }
  return result;
}

// Draws the polycube of the candidate along its map.
void draw_whole(const WholeSurface& surface, const LabelCandidate& candidate, Construction& result,
                const base::Host& host) {
  const PatchGraph target = make_patch_graph(candidate.map, host);
  DrawingOptions drawing;
  drawing.model = &candidate.map;
  drawing.redrawings = 0;
  drawing.smoothing_rounds = 0;
  Construction made =
      construct_on(surface.positions, surface.triangles, target, candidate.certificate.genus, drawing, host);
  result.map = std::move(made.map);
  result.certificate = std::move(made.certificate);
  result.distortion = made.distortion;
}

// Returns the labels of the whole surface: the candidate's, with arcs made straight.
Array<AxisLabel> whole_labels(const WholeSurface& surface, const LabelCandidate& candidate, const base::Host& host) {
  const LabelCosts costs = label_costs(surface.fine, surface.fine.normals, candidate.compactness, host);
  Array<AxisLabel> labels(surface.triangles.size(), host.memory);
  for (std::size_t i = 0; i < surface.search.source.size(); ++i)
    labels[surface.search.source[i]] = candidate.labels[i];
  undo_labels(surface.search.decimation, costs.data, labels);
  smooth_labels(surface.fine, costs, smoothing_sweeps, labels, host);
  return labels;
}

// Fills in positions on the polycube, solved on a coarse surface that keeps the patches and then brought to the fine
// one. Returns why there is no map, or nothing.
std::string solve_coarse(const WholeSurface& surface, const LabelCandidate& candidate, std::uint64_t seed,
                         SurfaceMap& map, const base::Host& host) {
  const Surface refined = framed(map.positions, map.triangles, surface.frame, host);
  Decimation decimation = decimate(refined, map.labels, map_triangles, host);
  SurfaceMap small(host.memory);
  Array<Index> vertices(host.memory);
  take_left(decimation, map.positions, small.positions, small.triangles, vertices, host);
  for (const Index t : decimation.left)
    small.labels.push_back(AxisLabel{map.labels[t]});
  set_unrefined(small);
  LabelledMapOptions map_options;
  map_options.seed = seed;
  map_options.polishing_steps = final_polishing_steps;
  const Array<double> planes = planes_of(surface, candidate, map, decimation.left, host);
  const LabelledMapOutcome outcome = make_labelled_map(small, surface.frame, map_options, planes, host);
  if (!outcome.valid()) return outcome.reason;
  map.polycube.resize(map.positions.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    map.polycube[vertices[i]] = surface.frame.scale * small.polycube[i];
  refine_map(refined, map.labels, decimation, map_options.area_weight, final_sweeps, map.polycube, host);
  for (Vector3& p : map.polycube)
    p /= surface.frame.scale;
  return {};
}

}  // namespace

std::string map_whole_surface(const WholeSurface& surface, LabelCandidate& candidate, std::uint64_t seed,
                              Construction& result, const base::Host& host) {
  if (surface.search.source.empty()) {
    result.map = std::move(candidate.map);
    result.certificate = std::move(candidate.certificate);
    result.distortion = measure_distortion(result.map, host);
    return {};
  }
  if (candidate.drawn) {
    draw_whole(surface, candidate, result, host);
    return {};
  }
  const Array<AxisLabel> labels = whole_labels(surface, candidate, host);
  SurfaceMap map = unrefined(surface.positions, surface.triangles, labels, host);
  split_chords(map, host);
  const std::string reason = solve_coarse(surface, candidate, seed, map, host);
  if (!reason.empty()) return reason;
  result.certificate = certify(map, host);
  if (!result.certificate.valid()) return result.certificate.reason;
  result.map = std::move(map);
  result.distortion = measure_distortion(result.map, host);
  return {};
}

}  // namespace orbicube::polycube
