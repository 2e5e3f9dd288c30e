#include "hexmesh/strategies/frame_hexes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "frame_field/frame_field.h"
#include "frame_field/singularities/meshability.h"
#include "hexmesh/grid/grid_extraction.h"
#include "hexmesh/strategies/hex_pieces.h"
#include "hexmesh/strategies/refinement.h"
#include "volume_map/solid/freeing_splits.h"

namespace orbicube::hexmesh {
namespace {

// The boundary of the solid, with a chart for each patch of the map.
polycube::SurfaceMap surface_of_frame_map(const volume_map::FrameMap& map, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(map.solid.positions.size(), map.solid.tetrahedra, host);
  polycube::SurfaceMap surface(host.memory);
  Array<Index> number(map.solid.positions.size(), no_index, host.memory);
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (!connectivity.on_boundary(face)) continue;
    mesh::Triangle triangle = connectivity.vertices(face);
    for (Index& v : triangle) {
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(surface.positions.size());
        surface.positions.push_back(map.solid.positions[v]);
      }
      v = number[v];
    }
    surface.triangles.push_back(triangle);
    surface.patches.push_back(map.patch[face]);
  }
  return surface;
}

std::size_t irregular_edges(const HexMesh& mesh, const base::Host& host) {
  Array<std::array<Index, 2>> edges(host.memory), outer(host.memory);
  const auto sorted = [](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  for (const Hexahedron& h : mesh.hexahedra) {
    for (const auto& parallel : edges_along) {
      for (const auto& [a, b] : parallel)
        edges.push_back(sorted(h[a], h[b]));
    }
  }
  for (const Quad& q : mesh.quads) {
    for (std::size_t k = 0; k < 4; ++k)
      outer.push_back(sorted(q[k], q[(k + 1) % 4]));
  }
  std::sort(edges.begin(), edges.end());
  std::sort(outer.begin(), outer.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end] == edges[i])
      ++end;
    count += end - i != 4 && !std::binary_search(outer.begin(), outer.end(), edges[i]);
    i = end;
  }
  return count;
}

// Edges and vertices inside that no mesh of hexahedra has, and vertices of the boundary that singular edges touch:
// where there are two of them, or one but the boundary's planes end there. A curve ends in the middle of a plane,
// alone.
std::size_t count_faults(const volume_map::FramedSolid& solid, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const mesh::EdgeRings rings(connectivity, host);
  const Array<std::uint8_t> outer = connectivity.boundary_vertices(host.memory);
  const auto matchings = frame_field::matchings(connectivity, solid.frames, host);
  const auto graph = frame_field::singular_graph(solid.positions, connectivity, rings, solid.frames, matchings, host);
  const auto local = frame_field::meshability(graph, outer, host.memory);
  Array<std::uint8_t> border(host.memory);
  volume_map::label_boundary(solid.positions, connectivity, rings, solid.frames, matchings, border, host);
  Array<Index> ends(solid.positions.size(), 0, host.memory);
  for (const frame_field::SingularEdge& edge : graph.edges) {
    for (const Index v : edge.vertices)
      ends[v] += outer[v];
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (border[ring] == 0) continue;
    for (const Index v : rings.vertices(ring))
      ends[v] += ends[v] > 0;
  }
  std::size_t faults = local.edges.size() + local.vertices.size();
  for (const Index count : ends)
    faults += count > 1;
  return faults;
}

bool same_quaternion(const quaternion::Quaternion& p, const quaternion::Quaternion& q) {
  return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
}

struct FieldAttempt {
  frame_field::Start start;
  frame_field::Repairs repairs;
  // Frames follow the boundary where they meet it in a vertex or an edge alone, too, in tetrahedra split so that each
  // meets it in one place: where tetrahedra are coarse, curves beside the boundary would else lie on it.
  bool align_stars;
};

// The smoothest first.
constexpr std::array field_attempts = {
    FieldAttempt{frame_field::Start::automatic, frame_field::Repairs::places, false},
    FieldAttempt{frame_field::Start::automatic, frame_field::Repairs::places, true},
    FieldAttempt{frame_field::Start::automatic, frame_field::Repairs::single_axis, true},
    FieldAttempt{frame_field::Start::automatic, frame_field::Repairs::single_axis, false},
    FieldAttempt{frame_field::Start::propagated, frame_field::Repairs::places, true},
    FieldAttempt{frame_field::Start::propagated, frame_field::Repairs::places, false},
    FieldAttempt{frame_field::Start::identity, frame_field::Repairs::places, false},
};

// The solid of an attempt with its frames.
volume_map::FramedSolid solid_with_frames(const FieldAttempt& attempt, std::span<const Vector3> positions,
                                          std::span<const Tetrahedron> tetrahedra, double feature_angle,
                                          const base::Host& host) {
  volume_map::FramedSolid solid(host.memory);
  solid.positions.assign(positions.begin(), positions.end());
  solid.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  if (attempt.align_stars) volume_map::split_for_freedom(solid.positions, solid.tetrahedra, host);
  frame_field::Options options;
  options.start = attempt.start;
  options.feature_angle = feature_angle;
  options.repairs = attempt.repairs;
  options.align_stars = attempt.align_stars;
  solid.frames = frame_field::compute(solid.positions, solid.tetrahedra, options, {}, host).field;
  return solid;
}

volume_map::FrameMapOptions map_options(double cell_length, bool quick) {
  volume_map::FrameMapOptions options;
  options.cell_length = cell_length;
  if (quick) options.max_attempts = 1;
  options.patient = !quick;
  return options;
}

// The map and the grid of it.
struct Grid {
  volume_map::FrameMap map;
  HexMesh mesh;

  Grid(const volume_map::FramedSolid& solid, double cell_length, bool quick, const base::Host& host)
      : map(volume_map::map_by_frames(solid, map_options(cell_length, quick), host)),
        mesh(extract_hexahedra(map, host)) {
    if (mesh.hexahedra.empty()) throw base::Error("no-valid-result", "the grid has no cell in the solid");
  }
};

bool is_refusal(const base::Error& error) {
  return std::string_view(error.kind()) == "no-valid-result";
}

// Where few layers became fewer by rounding there are far fewer cells than were requested: then shorter ones are tried,
// and kept if that is nearer.
Grid grid_of_cells(const volume_map::FramedSolid& solid, double volume, std::size_t cells, bool quick,
                   const base::Host& host) {
  constexpr double few = 0.7;
  const double cell_length = std::cbrt(volume / static_cast<double>(cells));
  Grid grid(solid, cell_length, quick, host);
  const double part = static_cast<double>(grid.mesh.hexahedra.size()) / static_cast<double>(cells);
  // Of a dozen cells each is a layer: there is nothing to choose.
  if (part > few || cells < 100) return grid;
  try {
    Grid finer(solid, cell_length * std::cbrt(part), quick, host);
    const double now = static_cast<double>(finer.mesh.hexahedra.size()) / static_cast<double>(cells);
    if (now > part && now * part < 1) grid = std::move(finer);
  } catch (const base::Error& error) {
    if (!is_refusal(error)) throw;
  }
  return grid;
}

// Hexahedra of the grid as it is, and fixed to the surface where that is not near enough. Returns their excess().
double take_better(std::optional<FrameHexes>& best, Grid&& grid, double volume, const FrameHexOptions& options,
                   const base::Host& host) {
  const polycube::SurfaceMap map = surface_of_frame_map(grid.map, host);
  const PolycubeSurface surface = {map, options.fine_positions, options.fine_triangles};
  const TargetSurface target(surface);
  const double scale = std::cbrt(static_cast<double>(grid.mesh.hexahedra.size()) / volume);
  for (Vector3& p : grid.mesh.positions)
    p *= scale;
  std::string reason;
  std::optional<HexResult> made;
  for (const bool hold : {false, true}) {
    if (hold && (options.distance == 0 || (made && excess(*made, options.distance) <= 1))) break;
    HexResult now = finish_apart(
        [&] {
          return HexDraft(HexMesh(grid.mesh), 0, scale, surface, target,
                          {.distance = options.distance, .rounds = options.rounds}, host);
        },
        {.hold = hold});
    if (!now.quality.valid()) {
      reason = what_is_wrong(now.quality);
    } else if (!made || better(now, *made, options.distance)) {
      made = std::move(now);
    }
  }
  if (!made) throw base::Error("no-valid-result", reason);
  const double far = excess(*made, options.distance);
  if (best && !better(*made, best->result, options.distance)) return far;
  best.emplace(host.memory);
  best->inner_irregular_edges = irregular_edges(made->mesh, host);
  best->result = std::move(*made);
  best->map = std::move(grid.map);
  return far;
}

}  // namespace

FrameHexes make_hexahedra_along_frames(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                                       double feature_angle, const FrameHexOptions& options, const base::Host& host) {
  using Clock = std::chrono::steady_clock;
  base::require(options.max_fields > 0, "one field has to be tried");
  std::size_t fewest = std::numeric_limits<std::size_t>::max(), fields = 0;
  volume_map::FramedSolid best(host.memory);
  std::exception_ptr first_refusal;
  double seconds = 0;
  Array<Array<quaternion::Quaternion>> refused(host.memory);  // frames
  for (const FieldAttempt& attempt : field_attempts) {
    if (fields == options.max_fields) break;
    const auto start = Clock::now();
    const base::Stage stage(host, 0.5);
    volume_map::FramedSolid solid = solid_with_frames(attempt, positions, tetrahedra, feature_angle, host);
    const std::size_t faults = count_faults(solid, host);
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
    ++fields;
    // Another start may lead to the same field.
    const auto same = [&](const Array<quaternion::Quaternion>& frames) {
      return std::equal(frames.begin(), frames.end(), solid.frames.begin(), solid.frames.end(), same_quaternion);
    };
    if (std::any_of(refused.begin(), refused.end(), same)) continue;
    refused.push_back(Array<quaternion::Quaternion>(solid.frames, host.memory));
    if (faults == 0) {
      try {
        FrameHexes made = make_hexahedra_by_frames(solid, options, host);
        made.fields = fields;
        made.field_seconds = seconds;
        return made;
      } catch (const base::Error& error) {
        if (!is_refusal(error)) throw;
        host.log("field " + std::to_string(fields) + ": " + error.what());
        if (options.quick) throw;
        if (!first_refusal) first_refusal = std::current_exception();
      }
    } else {
      const std::string text = base::counted(faults, "edge or vertex", "edges and vertices") + " of no hexahedra";
      host.log("field " + std::to_string(fields) + ": " + text);
      if (faults > options.max_faults) throw base::Error("no-valid-result", "the frame field has " + text);
    }
    if (faults >= fewest) continue;
    fewest = faults;
    best = std::move(solid);
  }
  if (first_refusal) std::rethrow_exception(first_refusal);
  // It says what is wrong, or there is a map all the same: what is counted on the boundary may be more than there is.
  FrameHexes made = make_hexahedra_by_frames(best, options, host);
  made.fields = fields;
  made.field_seconds = seconds;
  return made;
}

FrameHexes make_hexahedra_by_frames(const volume_map::FramedSolid& solid, const FrameHexOptions& options,
                                    const base::Host& host) {
  base::require(options.cells > 0 && options.cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  base::require(options.rounds >= 0 && options.rounds <= max_rounds, "the number of rounds must be from 0 to 1000");
  base::require(options.distance >= 0 && options.distance <= 100, "the distance must be from 0 to 100 percent");
  base::require(options.max_cells <= 10'000'000, "max_cells must be at most 10 million");
  double volume = 0;
  for (const Tetrahedron& t : solid.tetrahedra)
    volume += untangle::six_volumes(solid.positions, t) / 6;
  std::optional<FrameHexes> best;
  for (Refinement refinement(options.cells, options.max_cells);;) {
    const std::size_t cells = refinement.cells();
    double far = 0;
    const base::Stage stage(host, 0.5);
    try {
      far = take_better(best, grid_of_cells(solid, volume, cells, options.quick, host), volume, options, host);
    } catch (const base::Error& error) {
      // More cells are there for the distance alone.
      if (!best || !is_refusal(error)) throw;
    }
    const double least = excess(best->result, options.distance);
    if (least <= 1 || !refinement.next(far, least)) break;
  }
  const polycube::SurfaceMap map = surface_of_frame_map(best->map, host);
  complete(best->result, {map, options.fine_positions, options.fine_triangles}, host);
  return std::move(*best);
}

}  // namespace orbicube::hexmesh
