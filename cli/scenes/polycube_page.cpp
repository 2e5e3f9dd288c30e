#include "scenes/polycube_page.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "base/sums.h"

namespace orbicube::cli {

FaceDistortions face_distortions(const polycube::SurfaceMap& map, const base::Host& host) {
  using mesh::Vector3;
  FaceDistortions result(host.memory);
  base::CompensatedSum in_space, on_polycube;
  const auto sides = [&](const base::Array<Vector3>& at, const mesh::Triangle& t) {
    return std::array<Vector3, 2>{at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]};
  };
  const auto doubled_area = [](const std::array<Vector3, 2>& s) { return s[0].cross(s[1]).norm(); };
  for (const mesh::Triangle& t : map.triangles) {
    in_space.add(doubled_area(sides(map.positions, t)));
    on_polycube.add(doubled_area(sides(map.polycube, t)));
  }
  const double scale = in_space.value() / on_polycube.value();
  for (const mesh::Triangle& t : map.triangles) {
    const auto [a, b] = sides(map.positions, t);
    const auto [x, y] = sides(map.polycube, t);
    const double area = doubled_area({a, b}), image = doubled_area({x, y});
    if (!(area > 0) || !(image > 0)) {
      result.quasi_conformal.push_back(std::numeric_limits<double>::infinity());
      result.area_ratio.push_back(0);
      continue;
    }
    // |J|^2 / (2 det J) = (sigma_1 / sigma_2 + sigma_2 / sigma_1) / 2, from dot products of sides.
    const double norm =
        (a.squaredNorm() * y.squaredNorm() + b.squaredNorm() * x.squaredNorm() - 2 * a.dot(b) * x.dot(y)) /
        (2 * area * image);
    result.quasi_conformal.push_back(norm + std::sqrt(std::max(0.0, norm * norm - 1)));
    result.area_ratio.push_back(scale * image / area);
  }
  return result;
}

}  // namespace orbicube::cli
