#include "correspondence/study/subject.h"

#include <Eigen/Geometry>
#include <memory>
#include <numbers>
#include <utility>

#include "sphere_map/sphere_map.h"

namespace orbicube::correspondence {

Subject map_subject(const mesh::Mesh& surface, const harmonics::Coefficients* first, const SubjectOptions& options,
                    const base::Host& host) {
  Subject result(host.memory);
  SphereShape shape(host.memory);
  shape.mesh.positions = surface.positions;
  shape.mesh.triangles = surface.triangles;
  {
    const base::Stage stage(host, 0.8);
    shape.directions = sphere_map::compute(shape.mesh.positions, shape.mesh.triangles, {.seed = options.seed}, host);
  }
  shape.locator = std::make_unique<sphere_map::Locator>(shape.mesh.triangles, shape.directions, host);
  if (options.align && first == nullptr) result.functions.emplace(coefficients_of(shape, host));
  if (options.align && first != nullptr) {
    const base::Stage stage(host, 0.7);
    const Correlated found = align_by_correlation(*first, shape, options.joint, host);
    constexpr double degrees = 180 / std::numbers::pi;
    result.correlation = found.correlation;
    result.turn = degrees * Eigen::AngleAxisd(found.turn_of_shape).angle();
  }
  const CommonMesh grid = mesh_of_grid({&shape}, options.grid, options.resolution, host);
  sphere_map::CarriedShape carried = carry_to_shape(shape, grid, 0, host);
  result.positions = std::move(carried.positions);
  result.flipped = carried.flipped;
  return result;
}

}  // namespace orbicube::correspondence
