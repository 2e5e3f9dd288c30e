#include "volume_map/input/coarse_surface.h"

#include "polycube/surface/decimation.h"

namespace orbicube::volume_map {

CoarseSurface coarse_surface(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                             std::size_t target, const base::Host& host) {
  CoarseSurface coarse(host.memory);
  if (triangles.size() > target) {
    const polycube::Surface surface(Array<Vector3>(positions.begin(), positions.end(), host.memory),
                                    Array<mesh::Triangle>(triangles.begin(), triangles.end(), host.memory), host);
    const polycube::Decimation decimation = polycube::decimate(surface, {}, target, host);
    for (const Index t : decimation.left)
      coarse.triangles.push_back(decimation.triangles[t]);
  } else {
    coarse.triangles.assign(triangles.begin(), triangles.end());
  }
  Array<Index> number(positions.size(), no_index, host.memory);
  for (mesh::Triangle& t : coarse.triangles) {
    for (Index& v : t) {
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(coarse.positions.size());
        coarse.positions.push_back(positions[v]);
      }
      v = number[v];
    }
  }
  return coarse;
}

}  // namespace orbicube::volume_map
