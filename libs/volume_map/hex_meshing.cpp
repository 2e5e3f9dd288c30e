#include "volume_map/hex_meshing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "polycube/patch_graph.h"
#include "volume_map/hex_grid.h"
#include "volume_map/hex_search.h"
#include "volume_map/hex_smoothing.h"
#include "volume_map/padding.h"
#include "volume_map/sharp_map.h"
#include "volume_map/surface_distance.h"

namespace orbicube::volume_map {
namespace {

std::string what_is_wrong(const HexQuality& q) {
  return std::to_string(q.inverted) + " hexahedra have a corner that is not positive, " + std::to_string(q.uncertain) +
         " more are not certainly positive; the first is " + std::to_string(q.first_bad);
}

// The surface that counts.
struct Wanted {
  std::span<const Vector3> positions;
  std::span<const mesh::Triangle> triangles;
  double diagonal = 0, volume = 0;

  explicit Wanted(const PolycubeSurface& solid)
      : positions(solid.fine_triangles.empty() ? solid.map.positions : solid.fine_positions),
        triangles(solid.fine_triangles.empty() ? solid.map.triangles : solid.fine_triangles) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector3 low = Vector3::Constant(infinity), high = -low;
    for (const mesh::Triangle& t : triangles) {
      for (const Index v : t) {
        low = low.cwiseMin(positions[v]);
        high = high.cwiseMax(positions[v]);
      }
      volume += positions[t[0]].dot(positions[t[1]].cross(positions[t[2]])) / 6;
    }
    diagonal = (high - low).norm();
  }
};

void measure(HexResult& result, const Wanted& wanted, const base::Host& host) {
  constexpr double spacing = 0.0025;  // of the diagonal
  Array<mesh::Triangle> outer(host.memory);
  for (const Quad& q : result.mesh.quads) {
    outer.push_back({q[0], q[1], q[2]});
    outer.push_back({q[0], q[2], q[3]});
  }
  result.quality = measure_hexahedra(result.mesh.positions, result.mesh.hexahedra, host);
  result.distance = 100 / wanted.diagonal *
                    surface_distance(result.mesh.positions, outer, wanted.positions, wanted.triangles,
                                     spacing * wanted.diagonal, host);
  result.volume_error = 100 * std::abs(result.quality.volume / wanted.volume - 1);
}

// How many times farther from the surface than allowed; at most 1 where that does not matter.
double excess(const HexResult& result, const HexOptions& options) {
  if (options.distance == 0) return 1;
  return std::max(1.0, std::max(result.distance, result.volume_error) / options.distance);
}

bool better(const HexResult& x, const HexResult& y, const HexOptions& options) {
  const double of_x = excess(x, options), of_y = excess(y, options);
  return of_x != of_y ? of_x < of_y : x.quality.least_scaled_jacobian > y.quality.least_scaled_jacobian;
}

// The faces of the polycube that get a layer, and which part of its boundary they are.
struct PaddedFaces {
  Array<std::uint8_t> faces;
  double part = 0;

  PaddedFaces(const HexMesh& mesh, Array<std::uint8_t> chosen) : faces(std::move(chosen)) {
    double count = 0;
    for (const Index patch : mesh.quad_patches)
      count += faces[patch];
    part = count / static_cast<double>(mesh.quads.size());
  }
};

// What may be padded, the most promising first.
Array<PaddedFaces> paddings_of(const PolycubeSurface& solid, const HexOptions& options, std::size_t cells,
                               const base::Host& host) {
  const polycube::PatchGraph graph = polycube::make_patch_graph(solid.map, host);
  const HexMesh mesh = sample_hexahedra(domain_of_cells(graph, cells, 0, host), solid.map, host);
  const std::size_t count = 1 + *std::max_element(solid.map.charts.begin(), solid.map.charts.end());
  Array<PaddedFaces> result(host.memory);
  if (options.padding == Padding::automatic) result.emplace_back(mesh, choose_padding(mesh, host));
  const auto add = [&](std::uint8_t everywhere) {
    result.emplace_back(mesh, Array<std::uint8_t>(count, everywhere, host.memory));
  };
  if (options.padding == Padding::with) add(1);
  if (options.padding == Padding::without) add(0);
  // Where what was chosen turns out bad: none, or all.
  if (options.padding == Padding::automatic) add(result.front().part > 0 ? 0 : 1);
  return result;
}

// One mesh of the solid; valid or not.
struct Attempt {
  const PolycubeSurface& solid;
  std::size_t cells;
  const PaddedFaces& padded;
  bool lift, hold;
};
HexResult one_mesh(const Wanted& wanted, const HexOptions& options, const Attempt& attempt, const base::Host& host) {
  const PolycubeSurface& solid = attempt.solid;
  // Of the distance that is allowed: what is farther is held, and how far the search may move vertices.
  constexpr double held = 0.75, searched = 0.2;
  const polycube::PatchGraph graph = polycube::make_patch_graph(solid.map, host);
  const IntegerDomain domain = domain_of_cells(graph, attempt.cells, attempt.padded.part, host);
  HexResult result(host.memory);
  result.padded = attempt.padded.part > 0;
  HexMesh& mesh = result.mesh;
  mesh = sample_hexahedra(domain, solid.map, host);
  // Lengths of cells are 1 from here on.
  double volume = 0;
  for (const mesh::Triangle& t : solid.map.triangles)
    volume += solid.map.positions[t[0]].dot(solid.map.positions[t[1]].cross(solid.map.positions[t[2]])) / 6;
  const double scale = std::cbrt(static_cast<double>(mesh.hexahedra.size()) / std::abs(volume));
  for (Vector3& p : mesh.positions)
    p *= scale;
  const std::size_t cells = mesh.hexahedra.size();
  pad(mesh, attempt.padded.faces, 1, host);
  const SurfaceTarget target_surface(solid.map, solid.fine_positions, solid.fine_triangles, scale, host);
  HexBoundary boundary(mesh, target_surface, host);
  const double distance = 0.01 * options.distance * scale * wanted.diagonal;
  const HexSmoothingOptions smoothing = {.rounds = options.rounds,
                                         .lift = attempt.lift,
                                         .padding = mesh.hexahedra.size() - cells,
                                         .distance = attempt.hold ? held * distance : 0};
  if (!smooth_hexahedra(mesh, boundary, target_surface, smoothing, host)) {
    // A few that stay inverted are turned right by the search.
    search_hexahedra(mesh, boundary, {}, host);
    smooth_hexahedra(mesh, boundary, target_surface, smoothing, host);
  }
  const auto finish = [&](bool all) {
    result.off_surface = search_hexahedra(mesh, boundary, {.reach = searched * distance, .all = all}, host);
    for (Vector3& p : mesh.positions)
      p /= scale;
    measure(result, wanted, host);
  };
  const Array<Vector3> before(mesh.positions, host.memory);
  finish(false);
  if (attempt.hold && result.quality.valid() && excess(result, options) > 1) {
    // The search may have gone too far.
    HexResult freer = std::move(result);
    result = HexResult(host.memory);
    result.padded = freer.padded;
    mesh = freer.mesh;
    mesh.positions = before;
    finish(true);
    if (!result.quality.valid() || better(freer, result, options)) result = std::move(freer);
  }
  return result;
}

}  // namespace

HexResult make_hexahedra(const PolycubeSurface& solid, const HexOptions& options, const base::Host& host) {
  base::require(options.cells > 0 && options.cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  base::require(options.rounds >= 0, "the number of rounds must not be negative");
  base::require(options.sharp_angle >= 0 && options.sharp_angle < 180, "the sharp angle must be from 0 to 180 degrees");
  base::require(options.distance >= 0 && options.distance <= 100, "the distance must be from 0 to 100 percent");
  base::require(options.most_cells <= 10'000'000, "most_cells must be 10 million at most");
  const Wanted wanted(solid);
  std::optional<HexResult> best;
  std::string reason;
  // What fails in one way may work in another; where more cells are more than there can be, what was found stays.
  const auto tolerate = [&](const base::Error& error) {
    const bool too_many = best && error.status() == base::Status::invalid_argument;
    if (error.status() != base::Status::no_valid_result && !too_many) throw;
    reason = error.what();
  };
  // Answers whether the mesh is as near to the surface as wanted, and valid.
  // Scaled Jacobians of what is best among meshes of one number of cells: of all, and of those that are near.
  double least = 0, least_near = 0;
  const auto attempt = [&](const Attempt& how) {
    try {
      HexResult now = one_mesh(wanted, options, how, host);
      if (!now.quality.valid()) {
        reason = what_is_wrong(now.quality);
        return false;
      }
      now.follows_sharp_edges = &how.solid.map != &solid.map;
      least = std::max(least, now.quality.least_scaled_jacobian);
      const bool near = excess(now, options) <= 1;
      if (near) least_near = std::max(least_near, now.quality.least_scaled_jacobian);
      if (!best || better(now, *best, options)) best = std::move(now);
      return near;
    } catch (const base::Error& error) {
      tolerate(error);
      return false;
    }
  };
  const auto sharp =
      options.sharp_angle > 0 ? map_with_sharp_edges(solid.map, options.sharp_angle, host) : std::nullopt;
  const PolycubeSurface along_edges{sharp ? *sharp : solid.map, solid.fine_positions, solid.fine_triangles};
  Array<const PolycubeSurface*> surfaces(host.memory);
  if (sharp) surfaces.push_back(&along_edges);
  surfaces.push_back(&solid);
  for (std::size_t cells = options.cells;; cells *= 2) {
    // What is near to the surface by itself is better than what is held there. What is good in one way is not tried in
    // another.
    constexpr double good = 0.4;
    least = least_near = 0;
    const auto done = [&] { return (least_near > 0 ? least_near : least) > good; };
    for (const PolycubeSurface* surface : surfaces) {
      if (done()) continue;
      Array<PaddedFaces> paddings(host.memory);
      try {
        paddings = paddings_of(*surface, options, cells, host);
      } catch (const base::Error& error) {
        tolerate(error);
      }
      for (const PaddedFaces& padded : paddings) {
        if (done()) continue;
        // More cells are there for what is far: held at once.
        const bool near = cells == options.cells && attempt({*surface, cells, padded, true, false});
        if (!near && options.distance > 0) attempt({*surface, cells, padded, true, true});
      }
      // Vertices on the surface itself are less accurate and leave more room.
      for (const PaddedFaces& padded : paddings) {
        if (least == 0) attempt({*surface, cells, padded, false, options.distance > 0});
      }
    }
    if (options.distance == 0 || 2 * cells > options.most_cells || (best && excess(*best, options) <= 1)) break;
    // What sharp edges have not made better they do not with more cells.
    if (best && !best->follows_sharp_edges) surfaces.assign(1, &solid);
  }
  if (!best) throw base::Error("no-valid-result", reason);
  return std::move(*best);
}

}  // namespace orbicube::volume_map
