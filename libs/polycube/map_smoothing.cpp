#include "polycube/map_smoothing.h"

#include <Eigen/Geometry>
#include <cmath>

#include "mesh/bounding_volume_tree.h"
#include "polycube/planar_star.h"

namespace orbicube::polycube {

void smooth_map(SurfaceMap& map, int sweeps, const base::Host& host) {
  constexpr double least_gain = 1e-4;  // of a sweep, in parts of the energy
  const EditableSurface surface(map.positions, map.triangles, host);
  double in_space = 0, on_polycube = 0;
  mesh::Box box;
  for (const Triangle& t : map.triangles) {
    const auto area = [&](const Array<Vector3>& at) {
      return 0.5 * (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]).norm();
    };
    in_space += area(map.positions);
    on_polycube += area(map.polycube);
    for (const Index v : t)
      box.add(map.positions[v]);
  }
  const MapView view{surface,
                     map.labels,
                     map.charts,
                     map.polycube,
                     std::sqrt(on_polycube / in_space),
                     1e-6 * (box.high - box.low).norm()};
  PlanarStar star(host.memory);
  const auto count = static_cast<Index>(map.positions.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double gain = 0, energy = 0;
    for (Index i = 0; i < count; ++i) {
      if (i % 256 == 0) host.report("smoothing", 0, 0);
      const Index v = sweep % 2 == 0 ? i : count - 1 - i;
      if (surface.outgoing(v) == no_index) continue;
      star.gather(view, v);
      gain += star.improve(view);
      energy += star.energy();
    }
    // Every triangle is in three stars.
    if (!(gain > least_gain * energy / 3)) break;
  }
}

}  // namespace orbicube::polycube
