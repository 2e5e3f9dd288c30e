#include "scenes/polycube_scene.h"

#include <vector>

#include "gltf/writing/write.h"
#include "scenes/checkered_scene.h"
#include "textures/split_map.h"

namespace orbicube::cli {
namespace {

constexpr double units_along_polycube = 8;  // of texture coordinates, on its longest side
constexpr std::uint32_t squares_a_unit = 4;

// Coordinates in the plane of each patch, from the corner `low` of the polycube's box.
std::vector<float> texture_coordinates(const SplitMap& split, const mesh::Vector3& low, double unit) {
  std::vector<float> coordinates;
  coordinates.reserve(2 * split.vertices.size());
  for (std::size_t i = 0; i < split.vertices.size(); ++i) {
    const int axis = polycube::axis_of(split.labels[i]);
    const mesh::Vector3 at = (split.on_polycube[i] - low) / unit;
    coordinates.push_back(static_cast<float>(polycube::sign_of(split.labels[i]) * at[(axis + 1) % 3]));
    coordinates.push_back(static_cast<float>(-at[(axis + 2) % 3]));  // v goes down
  }
  return coordinates;
}

}  // namespace

Json write_polycube_scene(const std::filesystem::path& path, const polycube::SurfaceMap& map, const std::string& name,
                          const base::Host& host) {
  const SplitMap split(map, host.memory);
  const PolycubeFrame frame(split, host);
  const base::Array<float> base = gltf::stored_positions(split.positions, frame.surface, host.memory);
  const base::Array<float> target = gltf::stored_positions(split.on_polycube, frame.polycube, host.memory);
  const base::Array<float> normals = normals_of(map, split, frame.surface, host);
  const double unit = (frame.high - frame.low).maxCoeff() / units_along_polycube;
  const std::vector<float> coordinates = texture_coordinates(split, frame.low, unit);
  const gltf::MorphTarget morph{"polycube", target};
  CheckeredScene checkered(frame.surface, name, squares_a_unit, host.memory);
  gltf::Scene& scene = checkered.scene;
  scene.positions = base;
  scene.triangles = split.triangles;
  scene.normals = normals;
  scene.texture_coordinates = coordinates;
  scene.morph_targets = {&morph, 1};
  scene.morph_normals = true;
  scene.extras = Json{{"texture_unit", unit}}.dump();
  gltf::write(path, scene, host);
  return {{"output", path.string()},
          {"vertices", split.vertices.size()},
          {"texture_unit", unit},
          {"triangles_lost_in_float32", lost_triangles(split, base, target)}};
}

}  // namespace orbicube::cli
