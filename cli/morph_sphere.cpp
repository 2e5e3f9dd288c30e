#include "morph_sphere.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include "base/error.h"
#include "gltf/accessor.h"
#include "gltf/asset.h"
#include "gltf/checker.h"
#include "gltf/morph.h"
#include "gltf/write.h"
#include "sphere_map/measure.h"
#include "sphere_map/rounding.h"

namespace orbicube::cli {
namespace {

using base::Array;
using mesh::Triangle;
using mesh::Vector3;

// Where the sphere's points are as floats: what a renderer that adds base and delta in float32 sees.
Array<Vector3> rounded(std::span<const Vector3> sums, std::pmr::memory_resource* memory) {
  Array<Vector3> result(memory);
  result.reserve(sums.size());
  for (const Vector3& sum : sums)
    result.push_back(sphere_map::rounded_to_float(sum));
  return result;
}

std::size_t count_not_positive_either_way(std::span<const Triangle> triangles, std::span<const Vector3> sums,
                                          std::pmr::memory_resource* memory) {
  return sphere_map::count_not_positive(triangles, sums) +
         sphere_map::count_not_positive(triangles, rounded(sums, memory));
}

// The map on this base, and whether it is valid there.
bool round_on_base(MorphSphere& map, std::span<const Triangle> triangles, std::span<const Vector3> directions,
                   const base::Host& host) {
  const bool finite = std::all_of(map.base.begin(), map.base.end(), [](float b) { return std::isfinite(b); });
  if (!finite) return false;
  const sphere_map::Store store = [&](mesh::Index v, const Vector3& direction) {
    Vector3 sum;
    for (int k = 0; k < 3; ++k) {
      const float base = map.base[3 * std::size_t{v} + static_cast<std::size_t>(k)];
      // The sum first, then the delta that the writer stores for it.
      const float in_float = gltf::reconstructed(base, gltf::delta_for(base, static_cast<float>(direction[k])));
      sum[k] = gltf::reconstructed_in_double(base, gltf::delta_for(base, in_float));
    }
    return sum;
  };
  // What the two ways to add differ by: half a unit of the last place below 1, in each coordinate.
  const double rounding = 0x1p-25 * std::numbers::sqrt3;
  for (const double slack : {rounding, 0.0}) {
    sphere_map::RoundedMap stored = sphere_map::round_and_repair(triangles, directions, store, slack, host);
    if (count_not_positive_either_way(triangles, stored.directions, host.memory) > 0) continue;
    map.directions = std::move(stored.directions);
    map.moved = stored.moved;
    map.sphere.clear();
    for (const Vector3& sum : map.directions) {
      for (const double coordinate : sum)
        map.sphere.push_back(static_cast<float>(coordinate));
    }
    return true;
  }
  return false;
}

void set_base(MorphSphere& map, std::span<const Vector3> positions) {
  map.base.clear();
  for (const Vector3& p : positions) {
    for (const double coordinate : Vector3((p - map.translation) / map.scale))
      map.base.push_back(static_cast<float>(coordinate));
  }
}

std::vector<float> folded_octahedron(std::span<const Vector3> directions) {
  std::vector<float> coordinates;
  coordinates.reserve(2 * directions.size());
  for (const Vector3& d : directions) {
    const double size = d.lpNorm<1>();
    coordinates.push_back(static_cast<float>(0.5 + 0.5 * d[0] / size));
    coordinates.push_back(static_cast<float>(0.5 - 0.5 * d[1] / size));  // v goes down
  }
  return coordinates;
}

}  // namespace

MorphSphere round_to_morph_target(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                  std::span<const Vector3> directions, const base::Host& host) {
  MorphSphere map(host.memory);
  Vector3 low = positions[triangles[0][0]];
  Vector3 high = low;
  for (const Triangle& t : triangles) {
    for (const mesh::Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  const double half_size = (0.5 * high - 0.5 * low).maxCoeff();
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  // Beyond these the surface loses more than a millionth of its size, or the sphere more than 1e-4 of its radius.
  if (largest <= 32 * half_size && largest <= 1024) {
    set_base(map, positions);
    if (round_on_base(map, triangles, directions, host)) return map;
  }
  map.translation = 0.5 * low + 0.5 * high;
  map.scale = half_size;
  set_base(map, positions);
  if (round_on_base(map, triangles, directions, host)) return map;
  throw base::Error("no-valid-result",
                    "the map has triangles that are too small for the float32 of glTF; text formats and PLY hold it");
}

void write_morph_sphere(const std::filesystem::path& path, const MorphSphere& map, std::span<const Triangle> triangles,
                        const std::string& name, const base::Host& host) {
  const gltf::MorphTarget target{"sphere", map.sphere};
  const std::vector<float> coordinates = folded_octahedron(map.directions);
  gltf::Checker checker;
  checker.columns = checker.rows = 32;
  const Array<std::byte> texture = gltf::checker_png(checker, host.memory);
  gltf::Scene scene;
  scene.positions = map.base;
  scene.triangles = triangles;
  scene.smooth_normals = true;
  scene.texture_coordinates = coordinates;
  scene.morph_targets = {&target, 1};
  scene.morph_normals = true;
  scene.translation = map.translation;
  scene.scale = map.scale;
  scene.base_color = {1, 1, 1, 1};
  scene.texture = texture;
  scene.name = name;
  gltf::write(path, scene, host);
}

void check_morph_sphere(const std::filesystem::path& path, const MorphSphere& map, std::span<const Triangle> triangles,
                        const base::Host& host) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  gltf::Asset asset(std::as_bytes(std::span(bytes)), std::nullopt, host);
  gltf::JsonValue primitive;
  asset.meshes()[0].required("primitives").for_each_element([&](gltf::JsonValue each) { primitive = each; });
  gltf::JsonValue target;
  primitive.required("targets").for_each_element([&](gltf::JsonValue each) { target = each; });
  const auto vectors = [&](gltf::JsonValue attributes) {
    return gltf::read_vectors(asset, asset.accessors().at(attributes.required("POSITION"), "parse"));
  };
  const Array<Vector3> stored_base = vectors(primitive.required("attributes"));
  Array<Vector3> sums = vectors(target);
  const Array<mesh::Index> corners =
      gltf::read_indices(asset, asset.accessors().at(primitive.required("indices"), "parse"), map.directions.size());
  for (std::size_t v = 0; v < sums.size(); ++v)
    sums[v] += stored_base[v];
  bool same = stored_base.size() == map.directions.size() && std::ranges::equal(sums, map.directions) &&
              corners.size() == 3 * triangles.size();
  for (std::size_t i = 0; same && i < corners.size(); ++i)
    same = corners[i] == triangles[i / 3][i % 3];
  if (!same) throw base::Error("no-valid-result", "what was written is not what is read again");
  const std::size_t bad = count_not_positive_either_way(triangles, sums, host.memory);
  if (bad > 0) {
    throw base::Error("no-valid-result", std::to_string(bad) + " triangles of the written map are not positive");
  }
}

}  // namespace orbicube::cli
