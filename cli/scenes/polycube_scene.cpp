#include "scenes/polycube_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gltf/writing/morph.h"
#include "gltf/writing/normals.h"
#include "mesh/search/measures.h"
#include "mesh/search/predicates.h"
#include "scenes/checkered_scene.h"

namespace orbicube::cli {
namespace {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

constexpr double units_along_polycube = 8;  // of texture coordinates, on its longest side
constexpr std::uint32_t squares_a_unit = 4;

// Of triangles with their targets as a renderer has them.
std::size_t lost_triangles(const polycube::SurfaceMap& map, std::span<const Triangle> triangles,
                           const Array<float>& base, const Array<float>& target) {
  std::size_t lost = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto axis = static_cast<std::size_t>(polycube::axis_of(map.labels[t]));
    const auto flat = [&](Index v) {
      const auto at = [&](std::size_t k) {
        const std::size_t i = 3 * std::size_t{v} + (axis + k) % 3;
        return static_cast<double>(gltf::reconstructed(base[i], gltf::delta_for(base[i], target[i])));
      };
      return Eigen::Vector2d(at(1), polycube::sign_of(map.labels[t]) * at(2));
    };
    const auto& [a, b, c] = triangles[t];
    lost += mesh::orientation_2d(flat(a), flat(b), flat(c)) <= 0;
  }
  return lost;
}

// The map with a vertex for each patch that one is in.
struct SplitMap {
  SplitMap(const polycube::SurfaceMap& map, std::pmr::memory_resource* memory)
      : vertices(memory), triangles(memory), labels(memory), positions(memory), on_polycube(memory) {
    // Vertices with their patches.
    Array<std::pair<Index, Index>> pairs(memory);
    for (Index t = 0; t < map.triangles.size(); ++t)
      for (const Index v : map.triangles[t])
        pairs.emplace_back(v, map.patches[t]);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    labels.assign(pairs.size(), 0);
    for (Index t = 0; t < map.triangles.size(); ++t) {
      Triangle corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::pair wanted(map.triangles[t][k], map.patches[t]);
        corners[k] = static_cast<Index>(std::lower_bound(pairs.begin(), pairs.end(), wanted) - pairs.begin());
        labels[corners[k]] = map.labels[t];
      }
      triangles.push_back(corners);
    }
    for (const auto& [v, patch] : pairs) {
      vertices.push_back(v);
      positions.push_back(map.positions[v]);
      on_polycube.push_back(map.polycube[v]);
    }
  }

  Array<Index> vertices;  // of the map
  Array<Triangle> triangles;
  Array<polycube::AxisLabel> labels;
  Array<Vector3> positions, on_polycube;
};

// Of the surface, which is smooth across edges of the polycube.
Array<float> normals_of(const polycube::SurfaceMap& map, const SplitMap& split, const gltf::FloatFrame& frame,
                        const base::Host& host) {
  const Array<float> whole =
      gltf::smooth_normals(gltf::stored_positions(map.positions, frame, host.memory), map.triangles, host);
  Array<float> normals(host.memory);
  for (const Index v : split.vertices)
    for (std::size_t k = 0; k < 3; ++k)
      normals.push_back(whole[3 * std::size_t{v} + k]);
  return normals;
}

// Coordinates in the plane of each patch, from the corner `low` of the polycube's box.
std::vector<float> texture_coordinates(const SplitMap& split, const Vector3& low, double unit) {
  std::vector<float> coordinates;
  coordinates.reserve(2 * split.vertices.size());
  for (std::size_t i = 0; i < split.vertices.size(); ++i) {
    const int axis = polycube::axis_of(split.labels[i]);
    const Vector3 at = (split.on_polycube[i] - low) / unit;
    coordinates.push_back(static_cast<float>(polycube::sign_of(split.labels[i]) * at[(axis + 1) % 3]));
    coordinates.push_back(static_cast<float>(-at[(axis + 2) % 3]));  // v goes down
  }
  return coordinates;
}

}  // namespace

Json write_polycube_scene(const std::filesystem::path& path, const polycube::SurfaceMap& map, const std::string& name,
                          const base::Host& host) {
  const SplitMap split(map, host.memory);
  const mesh::Measures box = mesh::measures(split.positions, split.triangles, host);
  const mesh::Measures domain = mesh::measures(split.on_polycube, split.triangles, host);
  // Both at one scale, each around its own middle.
  gltf::FloatFrame frame;
  frame.translation = 0.5 * box.low + 0.5 * box.high;
  frame.scale = gltf::float_scale(
      std::max((0.5 * box.high - 0.5 * box.low).maxCoeff(), (0.5 * domain.high - 0.5 * domain.low).maxCoeff()));
  const Array<float> base = gltf::stored_positions(split.positions, frame, host.memory);
  const Array<float> target =
      gltf::stored_positions(split.on_polycube, {0.5 * domain.low + 0.5 * domain.high, frame.scale}, host.memory);
  const Array<float> normals = normals_of(map, split, frame, host);
  const double unit = (domain.high - domain.low).maxCoeff() / units_along_polycube;
  const std::vector<float> coordinates = texture_coordinates(split, domain.low, unit);
  const gltf::MorphTarget morph{"polycube", target};
  CheckeredScene checkered(frame, name, squares_a_unit, host.memory);
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
          {"triangles_lost_in_float32", lost_triangles(map, split.triangles, base, target)}};
}

}  // namespace orbicube::cli
