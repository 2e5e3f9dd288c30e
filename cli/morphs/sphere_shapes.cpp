#include "morphs/sphere_shapes.h"

#include <memory>
#include <utility>

#include "report/unit_size.h"
#include "solids/closed_surface.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::cli {
namespace {

void read_shape(MorphShape& shape, const Mending& mending, Keep keep, Session& session) {
  ClosedSurface surface = read_closed_surface(shape.path, mending, session, keep);
  shape.kept = std::move(surface.kept);
  shape.given = std::move(surface.given);
  shape.mesh = std::move(surface.mesh);
  require_ordinary_size(shape.mesh, shape.path);
  shape.figures = {{"input", shape.path}};
  shape.figures.update(surface.figures);
}

void map_to_sphere(MorphShape& shape, Session& session) {
  const mesh::Mesh& mesh = shape.mesh;
  const double start = session.seconds();
  about(shape.path, Role::input, [&] {
    shape.directions = sphere_map::compute(mesh.positions, mesh.triangles, {.seed = session.seed()}, session.host());
  });
  shape.locator = std::make_unique<sphere_map::Locator>(mesh.triangles, shape.directions, session.host());
  shape.figures.update({{"vertices", mesh.positions.size()},
                        {"triangles", mesh.triangles.size()},
                        {"seconds_map", session.seconds() - start},
                        {"rotation", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
}

}  // namespace

std::deque<MorphShape> map_shapes(const SphereShapesOptions& options, Session& session) {
  const base::Host& host = session.host();
  std::deque<MorphShape> shapes;
  // What has no sphere is refused before the others are mapped.
  for (const std::string& path : options.inputs) {
    shapes.emplace_back(host.memory).path = path;
    read_shape(shapes.back(), options.mending, shapes.size() == 1 ? options.keep_first : Keep::surface, session);
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const base::Stage stage(host, 0.8 / static_cast<double>(shapes.size() - i));
    map_to_sphere(shapes[i], session);
  }
  return shapes;
}

void align_shapes(std::deque<MorphShape>& shapes, const SphereShapesOptions& options, Session& session) {
  if (!options.landmarks.empty()) {
    const base::Stage stage(session.host(), 0.5);
    align_by_landmarks(shapes, options.landmarks, session);
  } else if (options.align != "none") {
    align_by_correlation(shapes, options.align == "shape", session);
  }
  session.figures()["alignment"] = options.landmarks.empty() ? options.align : "landmarks";
}

}  // namespace orbicube::cli
