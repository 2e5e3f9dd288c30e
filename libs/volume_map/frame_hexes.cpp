#include "volume_map/frame_hexes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "frame_field/frame_field.h"
#include "frame_field/meshability.h"
#include "volume_map/grid_extraction.h"
#include "volume_map/hex_search.h"
#include "volume_map/hex_smoothing.h"

namespace orbicube::volume_map {
namespace {

// The boundary of the solid, with a chart for each patch of the map.
polycube::SurfaceMap surface_of(const FrameMap& map, const base::Host& host) {
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
    surface.charts.push_back(map.patch[face]);
  }
  return surface;
}

std::size_t irregular_edges(const HexMesh& mesh, const base::Host& host) {
  constexpr std::array<std::array<std::uint8_t, 2>, 12> corners = {
      {{0, 1}, {3, 2}, {4, 5}, {7, 6}, {0, 3}, {1, 2}, {4, 7}, {5, 6}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  Array<std::array<Index, 2>> edges(host.memory), outer(host.memory);
  const auto sorted = [](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  for (const Hexahedron& h : mesh.hexahedra) {
    for (const auto& [a, b] : corners)
      edges.push_back(sorted(h[a], h[b]));
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

}  // namespace

void find_frames(FramedSolid& solid, double feature_angle, const base::Host& host) {
  using frame_field::Repairs;
  using frame_field::Start;
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const mesh::EdgeRings rings(connectivity, host);
  const Array<std::uint8_t> outer = connectivity.boundary_vertices(host.memory);
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  struct Attempt {
    Start start;
    Repairs repairs;
  };
  // The smoothest first; the others where that cannot be followed.
  for (const auto& [start, repairs] : {Attempt{Start::automatic, Repairs::places},
                                       {Start::automatic, Repairs::single_axis},
                                       {Start::propagated, Repairs::places},
                                       {Start::identity, Repairs::places}}) {
    frame_field::Options options;
    options.start = start;
    options.feature_angle = feature_angle;
    options.repairs = repairs;
    const frame_field::Outcome found = frame_field::compute(solid.positions, solid.tetrahedra, options, {}, host);
    const auto matchings = frame_field::matchings(connectivity, found.field, host);
    const auto graph = frame_field::singular_graph(solid.positions, connectivity, rings, found.field, matchings, host);
    const auto local = frame_field::meshability(graph, outer, host.memory);
    const std::size_t faults = local.edges.size() + local.vertices.size();
    if (faults >= fewest) continue;
    fewest = faults;
    solid.frames = found.field;
    if (faults == 0) return;
  }
}

FrameHexes make_hexahedra_by_frames(const FramedSolid& solid, const FrameHexOptions& options, const base::Host& host) {
  base::require(options.cells > 0 && options.cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  base::require(options.rounds >= 0, "the number of rounds must not be negative");
  double volume = 0;
  for (const Tetrahedron& t : solid.tetrahedra)
    volume += six_volumes(solid.positions, t) / 6;
  FrameHexes made(host.memory);
  made.map = map_by_frames(solid, {.cell_length = std::cbrt(volume / static_cast<double>(options.cells))}, host);
  HexMesh& mesh = made.result.mesh;
  mesh = extract_hexahedra(made.map, host);
  if (mesh.hexahedra.empty()) throw base::Error("no-valid-result", "the grid has no cell in the solid");
  const polycube::SurfaceMap surface = surface_of(made.map, host);
  const double scale = std::cbrt(static_cast<double>(mesh.hexahedra.size()) / volume);
  for (Vector3& p : mesh.positions)
    p *= scale;
  const SurfaceTarget target(surface, {}, {}, scale, host);
  HexBoundary boundary(mesh, target, host);
  const HexSmoothingOptions smoothing = {.rounds = options.rounds};
  if (!smooth_hexahedra(mesh, boundary, target, smoothing, host)) {
    search_hexahedra(mesh, boundary, {}, host);
    smooth_hexahedra(mesh, boundary, target, smoothing, host);
  }
  made.result.off_surface = search_hexahedra(mesh, boundary, {}, host);
  for (Vector3& p : mesh.positions)
    p /= scale;
  HexQuality& q = made.result.quality;
  q = measure_hexahedra(mesh.positions, mesh.hexahedra, host);
  if (!q.valid()) {
    throw base::Error("no-valid-result",
                      std::to_string(q.inverted) + " hexahedra have a corner that is not positive, " +
                          std::to_string(q.uncertain) + " more are not certainly positive; the first is " +
                          std::to_string(q.first_bad));
  }
  made.inner_irregular_edges = irregular_edges(mesh, host);
  return made;
}

}  // namespace orbicube::volume_map
