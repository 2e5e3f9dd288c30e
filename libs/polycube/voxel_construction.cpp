#include "polycube/voxel_construction.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/error.h"
#include "mesh/topology.h"
#include "polycube/layout_map.h"
#include "polycube/simplification.h"

namespace orbicube::polycube {
namespace {

// Corners when there is no budget: what follows a shape's parts and leaves each room.
constexpr std::size_t plenty = 100;

// Adds to what was tried; whether it is valid is in the certificate.
void attempt(const VoxelSolid& solid, std::span<const Vector3> positions, std::span<const Triangle> triangles,
             Construction& construction, const base::Host& host) {
  ++construction.tried;
  const Layout layout = make_layout(solid, host);
  EditableSurface surface(positions, triangles, host);
  Drawing drawing = trace(layout, surface, host);
  construction.map = map_layout(layout, surface, drawing, {}, host);
  construction.certificate = certify(construction.map, host);
  if (!construction.certificate.valid()) throw base::Error("no-valid-result", construction.certificate.reason);
  construction.distortion = measure_distortion(construction.map, host);
  ++construction.valid;
}

bool no_valid_result(const base::Error& error) {
  return std::string_view(error.kind()) == "no-valid-result";
}

}  // namespace

Construction construct_by_voxels(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const VoxelConstructionOptions& options, const base::Host& host) {
  const auto topology = mesh::topology(positions, triangles, host);
  mesh::require_closed_manifold(topology);
  if (!topology.genus) throw base::Error("not-connected", "a polycube map needs one closed, oriented surface");
  const Occupancy occupancy(positions, triangles, occupancy_resolution, host);
  Construction construction(host.memory);
  std::string reason;
  // Grids that begin finer or coarser make other polycubes.
  for (const int least_cells : {40, 60, 20, 84}) {
    VoxelisationOptions grid;
    grid.least_cells = least_cells;
    try {
      const Voxelisation voxels = voxelise(positions, triangles, *topology.genus, occupancy, grid, host);
      Simplification simplification(voxels, host);
      std::size_t tried = 0;
      // Down to two thirds each time, and to the fewest possible.
      for (std::size_t target = options.corners > 0 ? options.corners : plenty; target > 0;
           target = target < 8 ? 0 : 2 * target / 3) {
        simplification.reduce(target);
        if (simplification.corners() == tried) continue;
        tried = simplification.corners();
        try {
          attempt(simplification.solid(), positions, triangles, construction, host);
          return construction;
        } catch (const base::Error& error) {
          if (!no_valid_result(error)) throw;
          reason = error.what();
        }
      }
    } catch (const base::Error& error) {
      if (!no_valid_result(error)) throw;
      reason = error.what();
    }
  }
  throw base::Error("no-valid-result", "no polycube of voxels has a valid map: " + reason);
}

}  // namespace orbicube::polycube
