#include "volume_map/hex_boundary.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace orbicube::volume_map {

HexBoundary::HexBoundary(const HexMesh& mesh, const SurfaceTarget& target, const base::Host& host)
    : target_(target), places_(mesh.positions.size(), Place(), host.memory), vertices_(host.memory) {
  // Faces at vertices, sorted by vertex.
  Array<std::array<Index, 2>> around(host.memory);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    for (const Index v : mesh.quads[i])
      around.push_back({v, mesh.quad_patches[i]});
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  for (std::size_t i = 0; i < around.size();) {
    std::size_t end = i;
    while (end < around.size() && around[end][0] == around[i][0])
      ++end;
    const Index v = around[i][0];
    vertices_.push_back(v);
    Place& place = places_[v];
    place.point = mesh.positions[v];
    place.kind = Kind::surface;
    if (target.has_sharp_edges() && end - i == 1) {
      place.kind = Kind::patch;
      place.first = around[i][1];
    }
    std::size_t sharp = 0;
    for (std::size_t k = i; k < end; ++k) {
      for (std::size_t l = i; l < k; ++l) {
        if (!target.sharp(around[k][1], around[l][1])) continue;
        ++sharp;
        place.kind = Kind::line;
        place.first = around[k][1];
        place.second = around[l][1];
      }
    }
    if (sharp > 1) place.kind = Kind::point;
    i = end;
  }
}

TargetPoint HexBoundary::project(Index vertex, const Vector3& p) const {
  const Place& place = places_[vertex];
  switch (place.kind) {
    case Kind::patch:
      return target_.nearest_on(place.first, p);
    case Kind::line:
      return target_.nearest_on_line(place.first, place.second, p);
    case Kind::point:
      return {place.point, Vector3::Zero()};
    default:
      return target_.nearest(p);
  }
}

void HexBoundary::pull(Index vertex, const Vector3& p, double weight, Pull& to) const {
  const TargetPoint at = project(vertex, p);
  const Kind kind = places_[vertex].kind;
  if (kind == Kind::point) {
    to.to_point(at.position, weight);
  } else if (kind == Kind::line) {
    const Vector3 u = at.normal.unitOrthogonal();
    to.to_plane(u, at.position, weight);
    to.to_plane(at.normal.cross(u), at.position, weight);
  } else {
    to.to_plane(at.normal, at.position, weight);
  }
}

}  // namespace orbicube::volume_map
