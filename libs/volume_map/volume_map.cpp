#include "volume_map/volume_map.h"

#include <utility>

#include "volume_map/boundary_refinement.h"
#include "volume_map/solid_map.h"

namespace orbicube::volume_map {

VolumeMap map_to_polycube(const PolycubeSolid& solid, const base::Host& host, LinearEngine* engine) {
  const RefinedSolid refined = refine_boundary(solid.positions, solid.tetrahedra, solid.surface, solid.map, host);
  SolidMap map =
      map_solid(solid.map, solid.map.polycube, refined.positions, refined.tetrahedra, {.engine = engine}, host);
  VolumeMap result(host.memory);
  result.source = std::move(map.source);
  result.image = std::move(map.image);
  result.tetrahedra = std::move(map.tetrahedra);
  result.inverted_at_start = map.inverted_at_start;
  result.steps = map.steps;
  return result;
}

}  // namespace orbicube::volume_map
