#include "volume_map/hex_meshing.h"

#include <utility>

#include "base/error.h"
#include "polycube/patch_graph.h"
#include "volume_map/boundary_refinement.h"
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
HexResult one_mesh(const PolycubeSolid& solid, const RefinedSolid& refined, const HexOptions& options, bool padded,
                   const base::Host& host) {
  const polycube::PatchGraph graph = polycube::make_patch_graph(solid.map, host);
  const IntegerDomain domain = domain_of_cells(graph, options.cells, padded, host);
  Array<Vector3> target(host.memory);
  for (const Vector3& p : solid.map.polycube)
    target.push_back(domain.place(p));
  const SolidMap map = map_solid(solid.map, target, refined.positions, refined.tetrahedra, {}, host);

  HexResult result(host.memory);
  result.padded = padded;
  result.tetrahedra = map.tetrahedra.size();
  result.inverted_at_start = map.inverted_at_start;
  result.steps = map.steps;
  HexMesh& mesh = result.mesh;
  mesh = sample_hexahedra(domain, map, solid.map, host);
  // Lengths of cells are 1 from here on.
  for (Vector3& p : mesh.positions)
    p *= map.scale;
  const std::size_t cells = mesh.hexahedra.size();
  if (padded) pad(mesh, 1, host);
  const SurfaceTarget target_surface(solid.map, solid.fine_positions, solid.fine_triangles, map.scale, host);
  const HexBoundary boundary(mesh, target_surface, host);
  const bool positive = smooth_hexahedra(mesh, boundary, target_surface,
                                         {.rounds = options.rounds, .padding = mesh.hexahedra.size() - cells}, host);
  if (positive) result.off_surface = search_hexahedra(mesh, boundary, {}, host);
  for (Vector3& p : mesh.positions)
    p /= map.scale;
  result.quality = measure_hexahedra(mesh.positions, mesh.hexahedra, host);
  return result;
}

}  // namespace

HexResult make_hexahedra(const PolycubeSolid& solid, const HexOptions& options, const base::Host& host) {
  base::require(options.cells > 0 && options.cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  base::require(options.rounds >= 0, "the number of rounds must not be negative");
  const RefinedSolid refined = refine_boundary(solid.positions, solid.tetrahedra, solid.surface, solid.map, host);
  HexResult best(host.memory);
  std::string reason;
  bool any = false;
  for (const bool padded : {true, false}) {
    if (options.padding != Padding::automatic && padded != (options.padding == Padding::with)) continue;
    // Padding serves round shapes; what is good with it is not tried without.
    constexpr double good = 0.5;
    if (any && best.quality.least_scaled_jacobian > good) continue;
    try {
      HexResult now = one_mesh(solid, refined, options, padded, host);
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

VolumeMap map_to_polycube(const PolycubeSolid& solid, const base::Host& host) {
  const RefinedSolid refined = refine_boundary(solid.positions, solid.tetrahedra, solid.surface, solid.map, host);
  SolidMap map = map_solid(solid.map, solid.map.polycube, refined.positions, refined.tetrahedra, {}, host);
  VolumeMap result(host.memory);
  result.source = std::move(map.source);
  result.image = std::move(map.image);
  result.tetrahedra = std::move(map.tetrahedra);
  result.inverted_at_start = map.inverted_at_start;
  result.steps = map.steps;
  return result;
}

}  // namespace orbicube::volume_map
