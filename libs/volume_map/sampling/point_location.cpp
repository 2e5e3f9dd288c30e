#include "volume_map/sampling/point_location.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace orbicube::volume_map {
namespace {

double extent_of(std::span<const Vector3> positions) {
  mesh::Box box;
  for (const Vector3& p : positions)
    box.add(p);
  return positions.empty() ? 0 : (box.high - box.low).maxCoeff();
}

Array<mesh::Box> boxes_of(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                          std::pmr::memory_resource* memory) {
  Array<mesh::Box> boxes(tetrahedra.size(), memory);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t) {
    for (const Index v : tetrahedra[t])
      boxes[t].add(positions[v]);
  }
  return boxes;
}

}  // namespace

PointLocator::PointLocator(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                           const base::Host& host)
    : positions_(positions),
      tetrahedra_(tetrahedra),
      margin_(1e-9 * extent_of(positions)),
      tree_(boxes_of(positions, tetrahedra, host.memory), host) {}

Location PointLocator::locate(const Vector3& point, double tolerance) const {
  mesh::Box box;
  box.add(point - Vector3::Constant(margin_));
  box.add(point + Vector3::Constant(margin_));
  Location best;
  double greatest = -std::numeric_limits<double>::infinity();
  tree_.for_each_near(box, [&](Index t) {
    const Tetrahedron& c = tetrahedra_[t];
    // Edges from the point: no weight is a difference of others.
    std::array<Vector3, 4> p;
    for (std::size_t k = 0; k < 4; ++k)
      p[k] = positions_[c[k]] - point;
    const Vector3 a = p[1] - p[0], b = p[2] - p[0], d = p[3] - p[0];
    const double whole = a.dot(b.cross(d));
    if (!(whole > 0)) return;
    Location here{t,
                  {p[1].dot(p[2].cross(p[3])) / whole, -p[0].dot(p[2].cross(p[3])) / whole,
                   p[0].dot(p[1].cross(p[3])) / whole, -p[0].dot(p[1].cross(p[2])) / whole}};
    const double least = std::min({here.weight[0], here.weight[1], here.weight[2], here.weight[3]});
    if (least < greatest || (!(least > greatest) && best.tetrahedron < t)) return;
    greatest = least;
    best = here;
  });
  return greatest >= -tolerance ? best : Location{};
}

}  // namespace orbicube::volume_map
