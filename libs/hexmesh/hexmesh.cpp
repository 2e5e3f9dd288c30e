#include "hexmesh/hexmesh.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "hexmesh/captured/feature_choice.h"
#include "hexmesh/scale_back.h"
#include "hexmesh/strategies/hex_pieces.h"
#include "hexmesh/strategies/machined_shape.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/orient.h"
#include "mesh/topology/place_text.h"
#include "volume_map/input/solid_boundary.h"
#include "volume_map/input/solid_pieces.h"

namespace orbicube::hexmesh {
namespace {

using Clock = std::chrono::steady_clock;
using volume_map::InputFindings;
using volume_map::Inside;
using volume_map::PolycubePiece;
using volume_map::Polycubes;

// What a strategy works on.
struct Work {
  const mesh::Mesh& input;  // of a size near 1
  const Options& options;
  InputFindings& findings;
  const base::Host& host;
  int exponent;  // the input is that of the caller times 2^exponent
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

mesh::Mesh copy_of(const mesh::Mesh& from, const base::Host& host) {
  mesh::Mesh copy(host.memory);
  copy.positions.assign(from.positions.begin(), from.positions.end());
  copy.triangles.assign(from.triangles.begin(), from.triangles.end());
  copy.tetrahedra.assign(from.tetrahedra.begin(), from.tetrahedra.end());
  copy.hexahedra.assign(from.hexahedra.begin(), from.hexahedra.end());
  copy.regions.tetrahedra.assign(from.regions.tetrahedra.begin(), from.regions.tetrahedra.end());
  return copy;
}

PolycubeSurface surface_of(const PolycubePiece& piece) {
  return {piece.made.map, piece.fine.positions, piece.fine.triangles, &piece.space};
}

Hexahedra hexahedra_of_cells(const Work& work, HexMethod method, double to_beat = 0) {
  const Options& o = work.options;
  const base::Host& host = work.host;
  work.findings.examined = false;
  // The input was scaled, and with it go the points of corners.
  Array<mesh::Vector3> pose(o.given.pose.begin(), o.given.pose.end(), host.memory);
  mesh::scale_by_power(pose, work.exponent);
  const volume_map::GivenPolycube given{o.given.target, pose};
  const std::vector<PolycubePiece> pieces = [&] {
    const base::Stage stage(host, 0.3);
    return volume_map::polycube_pieces(copy_of(work.input, host),
                                       {.corners = o.corners,
                                        .triangles = o.triangles,
                                        .seed = o.seed,
                                        .max_pieces = o.cells,
                                        .inside = Inside::nothing,
                                        .polycubes = method == HexMethod::polycube ? Polycubes::needed
                                                     : method == HexMethod::grid   ? Polycubes::none
                                                                                   : Polycubes::where_there_are,
                                        .given = given},
                                       work.findings, host);
  }();
  const auto start = Clock::now();
  Hexahedra made(host.memory);
  Array<PolycubeSurface> boundaries(host.memory);
  for (const PolycubePiece& piece : pieces) {
    made.polycube_corners += piece.made.certificate.corners;
    boundaries.push_back(surface_of(piece));
  }
  const base::Stage stage(host, 0.95);
  made.result = make_hexahedra_of_pieces(boundaries,
                                         {.method = method,
                                          .cells = o.cells,
                                          .padding = o.padding,
                                          .rounds = o.rounds,
                                          .distance = o.distance,
                                          .max_cells = o.max_cells,
                                          .feature_angle = feature_angle_of(o),
                                          .to_beat = to_beat},
                                         host);
  made.method = made.result.grid_based ? Method::grid : Method::polycube;
  made.compute_seconds = seconds_since(start);
  return made;
}

// A solid for frames, and the surface that counts.
struct Framed {
  explicit Framed(std::pmr::memory_resource* memory) : solid(memory), fine(memory) {}

  volume_map::FramedSolid solid;
  mesh::Mesh fine;  // the surface, where a coarser one is filled
};

void fill_surface(const Work& work, Framed& result) {
  if (!work.options.fill)
    throw base::Error("unsupported", "there is no TetGen to fill a surface; give a mesh of tetrahedra");
  mesh::Mesh surface = copy_of(work.input, work.host);
  const volume_map::SurfacePieces pieces =
      volume_map::pieces_of_surface(surface, Inside::tetrahedra, 0, work.findings, work.host);
  if (pieces.count > 1) {
    const auto second = std::find(pieces.of.begin(), pieces.of.end(), 1U) - pieces.of.begin();
    const Index v = surface.triangles[static_cast<std::size_t>(second)][0];
    throw base::Error("not-connected", base::counted(pieces.count, "piece") +
                                           ", and a frame field has one; the second has vertex " + std::to_string(v) +
                                           ", at " + mesh::place_text(surface.positions[v]));
  }
  volume_map::FilledSolid filled =
      volume_map::filled_solid(surface, work.options.triangles, work.options.fill, work.host);
  result.solid.positions = std::move(filled.solid.positions);
  result.solid.tetrahedra = std::move(filled.solid.tetrahedra);
  if (filled.surface.size() < surface.triangles.size()) result.fine = std::move(surface);
}

void take_tetrahedra(const Work& work, Framed& result) {
  const mesh::Mesh& input = work.input;
  if (input.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra, which frames are for");
  mesh::require_valid_cells(input, work.host);
  if (!input.hexahedra.empty()) throw base::Error("unsupported", "hexahedra beside the tetrahedra");
  result.solid.positions.assign(input.positions.begin(), input.positions.end());
  result.solid.tetrahedra.assign(input.tetrahedra.begin(), input.tetrahedra.end());
  base::require(work.options.frames.empty() || work.options.frames.size() == input.tetrahedra.size(),
                "frames must have one for each tetrahedron");
  result.solid.frames.assign(work.options.frames.begin(), work.options.frames.end());
}

FrameFigures frame_figures_of(const FrameHexes& made) {
  FrameFigures figures;
  figures.inner_irregular_edges = made.inner_irregular_edges;
  figures.tetrahedra = made.map.solid.tetrahedra.size();
  figures.singular_edges = made.map.singular_edges;
  figures.cut_faces = made.map.cut_faces;
  figures.integers = made.map.integers;
  figures.layer_bounds = made.map.bounds;
  figures.integers_optimal = made.map.integers_optimal;
  figures.inverted_at_start = made.map.inverted_at_start;
  figures.steps = made.map.steps;
  figures.fields = made.fields;
  figures.field_seconds = made.field_seconds;
  return figures;
}

// How much is tried for hexahedra along frames, where there are other strategies or none. A first field with more
// faults than that has hardly ever another one without (measured: 0 to 2 where there is one, 100 and more elsewhere).
enum class Effort : std::uint8_t { all, few_fields, hopeful };

FrameHexOptions with_effort(FrameHexOptions options, Effort effort) {
  constexpr std::size_t few_fields = 3;  // what has a map at all has one along the first or the second most often
  if (effort != Effort::all) options.max_fields = few_fields;
  if (effort == Effort::hopeful) {
    options.max_faults = 20;
    options.quick = true;
  }
  return options;
}

Hexahedra hexahedra_along_frames(const Work& work, double feature_angle, Effort effort) {
  const Options& o = work.options;
  const auto begin = Clock::now();
  work.findings.examined = false;
  Framed framed(work.host.memory);
  const bool surface = work.input.tetrahedra.empty() && work.input.hexahedra.empty() && o.frames.empty();
  surface ? fill_surface(work, framed) : take_tetrahedra(work, framed);
  work.findings.examined = true;
  const double fill_seconds = seconds_since(begin);
  const auto start = Clock::now();
  const FrameHexOptions options = with_effort({.cells = o.cells,
                                               .rounds = o.rounds,
                                               .distance = o.distance,
                                               .max_cells = o.max_cells,
                                               .fine_positions = framed.fine.positions,
                                               .fine_triangles = framed.fine.triangles},
                                              effort);
  FrameHexes found = o.frames.empty()
                         ? make_hexahedra_along_frames(framed.solid.positions, framed.solid.tetrahedra,
                                                       feature_angle * std::numbers::pi / 180, options, work.host)
                         : make_hexahedra_by_frames(framed.solid, options, work.host);
  Hexahedra made(work.host.memory);
  made.method = Method::frames;
  made.along_frames = frame_figures_of(found);
  made.along_frames->fill_seconds = fill_seconds;
  made.compute_seconds = seconds_since(start) - found.field_seconds;
  made.result = std::move(found.result);
  return made;
}

// judge(positions, triangles, host) of the surface; false where there is none.
template <class Judge>
bool surface_is(const Judge& judge, const Work& work) {
  try {
    if (work.input.tetrahedra.empty()) {
      volume_map::require_closed_surface(work.input.positions, work.input.triangles, work.host);
      Array<mesh::Triangle> turned(work.input.triangles.begin(), work.input.triangles.end(), work.host.memory);
      mesh::orient(work.input.positions, turned, work.host);
      return judge(work.input.positions, turned, work.host);
    }
    const volume_map::BoundaryFirst first = volume_map::boundary_first(work.input, work.host);
    return judge(first.positions, first.surface, work.host);
  } catch (const base::Error& error) {
    if (error.status() == base::Status::cancelled) throw;
    return false;  // no surface of a solid; what is wrong is said by who wants one
  }
}

// What the features `machined` are of this shape.
Features features_of_machined(const Work& work) {
  const Options& o = work.options;
  const bool tagged = !o.tagged_edges.empty() || !o.tagged_vertices.empty();
  const auto has_edges = [&](std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                             const base::Host& host) {
    const double angle = feature_angle_of(o);
    return angle > 0 && (is_machined(positions, triangles, host) || has_sharp_lines(positions, triangles, angle, host));
  };
  return may_have_features(o) && (tagged || surface_is(has_edges, work)) ? Features::automatic : Features::off;
}

constexpr double poor = 0.7;  // about what the corners of a polycube leave on round shapes

// Layers are those of a polycube.
bool frames_may(const Work& work) {
  return work.options.padding == Padding::automatic;
}

std::optional<Hexahedra> tried_along_frames(const Work& work, Effort effort) {
  try {
    return hexahedra_along_frames(work, feature_angle_of(work.options), effort);
  } catch (const base::Error& error) {
    if (error.must_end()) throw;
    work.host.log(std::string("no hexahedra along frames: ") + error.what());
    return {};
  }
}

// By the polycube and grid-based; `made`: what there is along frames.
Hexahedra best_of_cells(const Work& work, bool machined, std::optional<Hexahedra> made) {
  const double distance = work.options.distance;
  const auto take = [&](std::optional<Hexahedra> now) {
    if (now && (!made || better(now->result, made->result, distance))) made = std::move(now);
  };
  try {
    take(hexahedra_of_cells(work, frames_may(work) ? HexMethod::automatic : HexMethod::polycube));
  } catch (const base::Error& error) {
    if (error.must_end()) throw;
    const bool examined = work.findings.examined;
    if (!made && !machined && frames_may(work) && std::string_view(error.kind()) == "no-valid-result")
      take(tried_along_frames(work, Effort::few_fields));
    work.findings.examined = examined;
    if (!made) throw;
  }
  return std::move(*made);
}

Hexahedra best_hexahedra(const Work& work) {
  const bool machined = frames_may(work) && surface_is(is_machined, work);
  std::optional<Hexahedra> made;
  if (machined) made = tried_along_frames(work, Effort::few_fields);
  if (made && made->result.quality.min_scaled_jacobian > poor && excess(made->result, work.options.distance) <= 1)
    return std::move(*made);
  return best_of_cells(work, machined, std::move(made));
}

Hexahedra by_strategy(const Work& work) {
  if (by_frames(work.options)) return hexahedra_along_frames(work, feature_angle_of(work.options), Effort::all);
  if (work.options.method == Method::polycube || work.options.given.target != nullptr)
    return hexahedra_of_cells(work, HexMethod::polycube);
  if (work.options.method == Method::grid) return hexahedra_of_cells(work, HexMethod::grid);
  return best_hexahedra(work);
}

// The hexahedra that keep most of the features, of strategies from the cheapest to the dearest, until one keeps them.
class WithFeatures {
 public:
  explicit WithFeatures(const Work& work)
      : work_(work),
        keeper_(work.input,
                {.request = {work.options.features, feature_angle_of(work.options), work.options.tagged_edges,
                             work.options.tagged_vertices},
                 .cells = work.options.cells,
                 .max_cells = work.options.max_cells,
                 .distance = work.options.distance,
                 .rounds = work.options.rounds},
                work.host),
        by_grid_(work.options.method == Method::grid),
        embeds_((by_grid_ || work.options.method == Method::automatic) && !by_frames(work.options) &&
                work.options.given.target == nullptr && work.options.padding != Padding::without && keeper_.any()) {}

  Hexahedra made() {
    embeds_ ? embed_or_strategy() : take(by_strategy(work_), false);
    best_->features = keeper_.figures();
    best_->compute_seconds += seconds_;
    return std::move(*best_);
  }

 private:
  bool near() const { return best_ && excess(best_->result, work_.options.distance) <= 1; }
  // No farther from the surface than what is returned at all: what is nearer with less of the features is not
  // preferred.
  bool may_be_returned() const { return best_ && excess(best_->result, work_.options.distance) <= refused_excess; }
  double least() const { return best_->result.quality.min_scaled_jacobian; }

  // On frames, or on a polycube where all is at right angles, there may be a better mesh than that with the graph
  // embedded, which has a layer around. Elsewhere those only take long.
  void embed_or_strategy() {
    const bool machined = !by_grid_ && frames_may(work_) && surface_is(is_machined, work_);
    if (machined) {
      const base::Stage stage(work_.host, 0.3);
      if (auto now = tried_along_frames(work_, keeper_.can_embed() ? Effort::hopeful : Effort::few_fields))
        take(std::move(*now), false);
      if (near() && keeper_.complete() && least() >= std::min(poor, keeper_.bound())) return;
    }
    embed();
    if (may_be_returned() && keeper_.nearly_complete() && (by_grid_ || !keeper_.rectangular() || least() > poor))
      return;
    Options options = work_.options;
    if (near()) options.max_cells = options.cells;  // more cells are for the distance only
    const Work work = {work_.input, options, work_.findings, work_.host, work_.exponent};
    // A mesh on the polycube replaces one with all features only if it has them all, too. The first way to fill the
    // polycube follows sharp edges where any does; grids in space do not follow them.
    const bool all_kept = near() && keeper_.complete();
    try {
      take(by_grid_   ? by_strategy(work)
           : all_kept ? hexahedra_of_cells(work, HexMethod::polycube, least())
                      : best_of_cells(work, machined, {}),
           false);
    } catch (const base::Error& error) {
      if (error.must_end() || !best_) throw;
      work_.host.log(std::string("no other hexahedra: ") + error.what());
    }
    work_.findings.examined = true;
  }

  void embed() {
    const auto start = Clock::now();
    const base::Stage stage(work_.host, 0.5);
    std::optional<HexResult> result = keeper_.embed();
    seconds_ += seconds_since(start);
    if (!result) return;
    Hexahedra now(work_.host.memory);
    now.method = Method::grid;
    now.result = std::move(*result);
    take(std::move(now), true);
  }

  void take(Hexahedra now, bool embedded) {
    if (keeper_.offer(now.result, embedded, best_ ? &best_->result : nullptr)) best_ = std::move(now);
  }

  const Work& work_;
  FeatureKeeper keeper_;
  const bool by_grid_, embeds_;
  std::optional<Hexahedra> best_;
  double seconds_ = 0;
};

}  // namespace

Hexahedra make_hexahedra(const mesh::Mesh& input, const Options& options, volume_map::InputFindings& findings,
                         const base::Host& host) {
  require_valid(options, input.positions.size());
  mesh::Mesh near_unit = copy_of(input, host);
  Options decided = options;
  const Work work{near_unit, decided, findings, host, mesh::bring_to_unit_size(near_unit)};
  Hexahedra made = mesh::with_places_of_caller(work.exponent, [&] {
    if (options.features == Features::machined) decided.features = features_of_machined(work);
    Hexahedra result = decided.features == Features::off ? by_strategy(work) : WithFeatures(work).made();
    if (!near_unit.regions.tetrahedra.empty()) result.regions = conform_to_regions(result.result, near_unit, host);
    return result;
  });
  made.feature_angle = feature_angle_of(decided);
  scale_back(made.result, work.exponent);
  if (made.features) scale_back(*made.features, work.exponent);
  return made;
}

}  // namespace orbicube::hexmesh
