#include "textures/split_map.h"

#include <algorithm>
#include <utility>

#include "gltf/writing/morph.h"
#include "gltf/writing/normals.h"
#include "mesh/search/measures.h"
#include "mesh/search/predicates.h"

namespace orbicube::cli {

SplitMap::SplitMap(const polycube::SurfaceMap& map, std::pmr::memory_resource* memory)
    : vertices(memory), patches(memory), labels(memory), positions(memory), on_polycube(memory), triangles(memory) {
  // Vertices with their patches.
  base::Array<std::pair<mesh::Index, mesh::Index>> pairs(memory);
  for (mesh::Index t = 0; t < map.triangles.size(); ++t)
    for (const mesh::Index v : map.triangles[t])
      pairs.emplace_back(v, map.patches[t]);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  labels.assign(pairs.size(), 0);
  for (mesh::Index t = 0; t < map.triangles.size(); ++t) {
    mesh::Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::pair wanted(map.triangles[t][k], map.patches[t]);
      corners[k] = static_cast<mesh::Index>(std::lower_bound(pairs.begin(), pairs.end(), wanted) - pairs.begin());
      labels[corners[k]] = map.labels[t];
    }
    triangles.push_back(corners);
  }
  for (const auto& [v, patch] : pairs) {
    vertices.push_back(v);
    patches.push_back(patch);
    positions.push_back(map.positions[v]);
    on_polycube.push_back(map.polycube[v]);
  }
}

PolycubeFrame::PolycubeFrame(const SplitMap& split, const base::Host& host) {
  const mesh::Measures box = mesh::measures(split.positions, split.triangles, host);
  const mesh::Measures domain = mesh::measures(split.on_polycube, split.triangles, host);
  low = domain.low;
  high = domain.high;
  // Both at one scale, each around its own middle.
  surface.translation = 0.5 * box.low + 0.5 * box.high;
  surface.scale = gltf::float_scale(
      std::max((0.5 * box.high - 0.5 * box.low).maxCoeff(), (0.5 * domain.high - 0.5 * domain.low).maxCoeff()));
  polycube = {0.5 * domain.low + 0.5 * domain.high, surface.scale};
}

base::Array<float> normals_of(const polycube::SurfaceMap& map, const SplitMap& split, const gltf::FloatFrame& frame,
                              const base::Host& host) {
  const base::Array<float> whole =
      gltf::smooth_normals(gltf::stored_positions(map.positions, frame, host.memory), map.triangles, host);
  base::Array<float> normals(host.memory);
  for (const mesh::Index v : split.vertices)
    for (std::size_t k = 0; k < 3; ++k)
      normals.push_back(whole[3 * std::size_t{v} + k]);
  return normals;
}

std::size_t lost_triangles(const SplitMap& split, std::span<const float> base, std::span<const float> target) {
  std::size_t lost = 0;
  for (const auto& [a, b, c] : split.triangles) {
    const polycube::AxisLabel label = split.labels[a];
    const auto axis = static_cast<std::size_t>(polycube::axis_of(label));
    const auto flat = [&, label, axis](mesh::Index v) {
      const auto at = [&](std::size_t k) {
        const std::size_t i = 3 * std::size_t{v} + (axis + k) % 3;
        return static_cast<double>(gltf::reconstructed(base[i], gltf::delta_for(base[i], target[i])));
      };
      return Eigen::Vector2d(at(1), polycube::sign_of(label) * at(2));
    };
    lost += mesh::orientation_2d(flat(a), flat(b), flat(c)) <= 0;
  }
  return lost;
}

}  // namespace orbicube::cli
