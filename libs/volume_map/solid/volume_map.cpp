#include "volume_map/solid/volume_map.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "polycube/map/certificate.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"
#include "volume_map/solid/boundary_refinement.h"
#include "volume_map/solid/solid_map.h"

namespace orbicube::volume_map {
namespace {

// Along x, beside what there is. Rounding may make it another map: it is certified again.
void move_beside(VolumeMap& map, const PolycubeSolid& solid, const VolumeMap& all, const base::Host& host) {
  constexpr double gap = 0.1;
  Vector3 high = all.image[0], low = map.image[0];
  double size = 0;
  for (const Vector3& p : all.image) {
    high = high.cwiseMax(p);
    size = std::max(size, (p - all.image[0]).cwiseAbs().maxCoeff());
  }
  for (const Vector3& p : map.image)
    low = low.cwiseMin(p);
  const double shift = high[0] + gap * size - low[0];
  for (Vector3& p : map.image)
    p[0] += shift;
  const polycube::Certificate certificate =
      polycube::certify(std::span(map.image).first(solid.map.positions.size()), solid.map.triangles, host);
  if (!certificate.valid() || untangle::count_inverted(map.tetrahedra, map.image, host).count > 0)
    throw base::Error("no-valid-result", "a piece could not be moved beside the others: " + certificate.reason);
}

}  // namespace

VolumeMap map_to_polycube(const PolycubeSolid& solid, const base::Host& host, untangle::BlockEngine* engine) {
  const RefinedSolid refined = refine_boundary(solid.positions, solid.tetrahedra, solid.surface, solid.map, host);
  SolidMap map =
      map_solid(solid.map, solid.map.polycube, refined.positions, refined.tetrahedra, {.engine = engine}, host);
  return VolumeMap(std::move(map));
}

VolumeMap map_pieces_to_polycubes(std::span<const PolycubeSolid> pieces, const base::Host& host,
                                  untangle::BlockEngine* engine) {
  VolumeMap all(host.memory);
  for (const PolycubeSolid& piece : pieces) {
    VolumeMap map = map_to_polycube(piece, host, engine);
    if (all.source.empty()) {
      all = std::move(map);
      continue;
    }
    move_beside(map, piece, all, host);
    const auto first = static_cast<Index>(all.source.size());
    all.source.insert(all.source.end(), map.source.begin(), map.source.end());
    all.image.insert(all.image.end(), map.image.begin(), map.image.end());
    for (Tetrahedron t : map.tetrahedra) {
      for (Index& v : t)
        v += first;
      all.tetrahedra.push_back(t);
    }
    all.inverted_at_start += map.inverted_at_start;
    all.steps += map.steps;
  }
  return all;
}

}  // namespace orbicube::volume_map
