#include "morphs/morph_sphere.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "gltf/json/asset.h"
#include "gltf/reading/accessor.h"
#include "gltf/reading/scene.h"
#include "gltf/writing/float_frame.h"
#include "gltf/writing/morph.h"
#include "scenes/checkered_scene.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/rounding.h"

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

// Whether the triangles of a primitive are those of the map from number `next` on, which is then behind them.
bool holds_map(gltf::Asset& asset, const gltf::tiny::Primitive& primitive, const MorphSphere& map,
               std::span<const Triangle> triangles, std::size_t& next) {
  const auto vectors = [&](const std::map<std::string, int>& attributes) {
    return gltf::read_vectors(asset, static_cast<std::size_t>(attributes.at("POSITION")));
  };
  const Array<Vector3> base = vectors(primitive.attributes), deltas = vectors(primitive.targets.at(0));
  const Array<mesh::Index> corners =
      gltf::read_indices(asset, static_cast<std::size_t>(primitive.indices), base.size());
  if (deltas.size() != base.size() || corners.size() > 3 * (triangles.size() - next)) return false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const mesh::Index v = triangles[next + i / 3][i % 3];
    if (Vector3(base[corners[i]] + deltas[corners[i]]) != map.directions[v]) return false;
    for (int k = 0; k < 3; ++k) {
      if (base[corners[i]][k] != static_cast<double>(map.base[3 * std::size_t{v} + static_cast<std::size_t>(k)]))
        return false;
    }
  }
  next += corners.size() / 3;
  return true;
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
  gltf::float_frame(low, high);  // throws where float32 ends before
  // Farther from the origin the surface loses more than a millionth of its size. With coordinates of at most 4, which a
  // power of two leaves as they are, the sphere's lose less than 1e-6 in the difference to the base.
  if (largest <= 32 * half_size) {
    const int exponent = std::ilogb(largest) - 1;
    map.scale = exponent > 0 || largest < 0x1p-100 ? std::ldexp(1.0, exponent) : 1;
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
                        const std::string& name, const gltf::Kept* kept, const base::Host& host) {
  const gltf::MorphTarget target{"sphere", map.sphere};
  const std::vector<float> coordinates = folded_octahedron(map.directions);
  CheckeredScene checkered({map.translation, map.scale}, name, 32, host.memory);
  gltf::Scene& scene = checkered.scene;
  scene.positions = map.base;
  scene.triangles = triangles;
  scene.smooth_normals = true;
  scene.texture_coordinates = coordinates;
  scene.morph_targets = {&target, 1};
  scene.morph_normals = true;
  scene.kept = kept;
  gltf::write(path, scene, host);
}

void check_morph_sphere(const std::filesystem::path& path, const MorphSphere& map, std::span<const Triangle> triangles,
                        const base::Host& host) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  gltf::Asset asset(std::as_bytes(std::span(bytes)), std::nullopt, gltf::Extent::surface, host);
  std::size_t next = 0;
  bool same = true;
  for (const gltf::Placement& placement : gltf::place_meshes(asset).shown) {
    for (const gltf::tiny::Primitive& primitive : asset.model().meshes[placement.mesh].primitives)
      same = same && holds_map(asset, primitive, map, triangles, next);
  }
  if (!same || next != triangles.size())
    throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
  const std::size_t bad = count_not_positive_either_way(triangles, map.directions, host.memory);
  if (bad > 0) {
    throw base::Error(
        "no-valid-result",
        base::counted(bad, "triangle of the written map is", "triangles of the written map are") + " not positive");
  }
}

}  // namespace orbicube::cli
