#include "volume_map/hex_meshing.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "polycube/patch_graph.h"
#include "volume_map/hex_grid.h"
#include "volume_map/hex_search.h"
#include "volume_map/hex_smoothing.h"

namespace orbicube::volume_map {
namespace {

std::string what_is_wrong(const HexQuality& q) {
  return std::to_string(q.inverted) + " hexahedra have a corner that is not positive, " + std::to_string(q.uncertain) +
         " more are not certainly positive; the first is " + std::to_string(q.first_bad);
}

// One mesh of the solid, with or without padding; valid or not.
HexResult one_mesh(const PolycubeSurface& solid, const HexOptions& options, bool padded, bool lift,
                   const base::Host& host) {
  const polycube::PatchGraph graph = polycube::make_patch_graph(solid.map, host);
  const IntegerDomain domain = domain_of_cells(graph, options.cells, padded, host);
  HexResult result(host.memory);
  result.padded = padded;
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
  if (padded) pad(mesh, 1, host);
  const SurfaceTarget target_surface(solid.map, solid.fine_positions, solid.fine_triangles, scale, host);
  HexBoundary boundary(mesh, target_surface, host);
  const HexSmoothingOptions smoothing = {
      .rounds = options.rounds, .lift = lift, .padding = mesh.hexahedra.size() - cells};
  if (!smooth_hexahedra(mesh, boundary, target_surface, smoothing, host)) {
    // A few that stay inverted are turned right by the search.
    search_hexahedra(mesh, boundary, {}, host);
    smooth_hexahedra(mesh, boundary, target_surface, smoothing, host);
  }
  result.off_surface = search_hexahedra(mesh, boundary, {}, host);
  for (Vector3& p : mesh.positions)
    p /= scale;
  result.quality = measure_hexahedra(mesh.positions, mesh.hexahedra, host);
  return result;
}

}  // namespace

HexResult make_hexahedra(const PolycubeSurface& solid, const HexOptions& options, const base::Host& host) {
  base::require(options.cells > 0 && options.cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  base::require(options.rounds >= 0, "the number of rounds must not be negative");
  HexResult best(host.memory);
  std::string reason;
  bool any = false;
  struct Attempt {
    bool padded, lift;
  };
  for (const auto& [padded, lift] : {Attempt{true, true}, {false, true}, {true, false}, {false, false}}) {
    if (options.padding != Padding::automatic && padded != (options.padding == Padding::with)) continue;
    // Padding serves round shapes; what is good with it is not tried without. Vertices on the surface itself are less
    // accurate and leave more room, where nothing else is valid.
    constexpr double good = 0.4;
    if (any && (!lift || best.quality.least_scaled_jacobian > good)) continue;
    try {
      HexResult now = one_mesh(solid, options, padded, lift, host);
      if (!now.quality.valid()) {
        reason = what_is_wrong(now.quality);
      } else if (!any || now.quality.least_scaled_jacobian > best.quality.least_scaled_jacobian) {
        any = true;
        best = std::move(now);
      }
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      reason = error.what();
    }
  }
  if (!any) throw base::Error("no-valid-result", reason);
  return best;
}

}  // namespace orbicube::volume_map
