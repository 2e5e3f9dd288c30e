#include "textures/atlas_scene.h"

#include "gltf/writing/tangents.h"
#include "gltf/writing/write.h"
#include "textures/baked_texture.h"
#include "textures/float_coordinates.h"
#include "textures/split_map.h"

namespace orbicube::cli {
namespace {

constexpr double squares_along_polycube = 32;  // of the checker, on its longest side

base::Array<float> coordinates_of(const SplitMap& split, const polycube::Atlas& atlas,
                                  const polycube::PatchGraph& graph, std::pmr::memory_resource* memory) {
  base::Array<float> coordinates(memory);
  coordinates.reserve(2 * split.vertices.size());
  for (std::size_t i = 0; i < split.vertices.size(); ++i)
    for (const double texel : polycube::texel_of(atlas, graph, split.patches[i], split.on_polycube[i]))
      coordinates.push_back(static_cast<float>(texel / atlas.options.size));
  return coordinates;
}

}  // namespace

Json write_atlas_scene(const AtlasRequest& request, const polycube::SurfaceMap& map, const polycube::PatchGraph& graph,
                       const std::string& name, const base::Host& host) {
  const polycube::Atlas atlas = polycube::make_atlas(graph, request.options, host);
  const base::Array<polycube::TexelCorners> corners = polycube::texel_corners(atlas, graph, map, host);
  const polycube::AtlasTexels texels = polycube::covered_texels(atlas.options.size, corners, host);
  const SplitMap split(map, host.memory);
  const PolycubeFrame frame(split, host);
  const double square = (frame.high - frame.low).maxCoeff() / squares_along_polycube;
  const AtlasOfMap baked{map, corners, texels};
  const base::Array<std::byte> texture = request.colors.empty() ? checker_of_atlas(baked, frame.low, square, host)
                                                                : colors_of_input(baked, request.colors, host);
  const base::Array<float> base = gltf::stored_positions(split.positions, frame.surface, host.memory);
  const base::Array<float> target = gltf::stored_positions(split.on_polycube, frame.polycube, host.memory);
  const base::Array<float> normals = normals_of(map, split, frame.surface, host);
  base::Array<float> coordinates = coordinates_of(split, atlas, graph, host.memory);
  const std::size_t lost = mend_coordinates(split.triangles, coordinates);
  const base::Array<float> tangents = gltf::smooth_tangents(base, normals, coordinates, split.triangles, host);
  const gltf::MorphTarget morph{"polycube", target};
  gltf::Scene scene;
  scene.positions = base;
  scene.triangles = split.triangles;
  scene.normals = normals;
  scene.tangents = tangents;
  scene.texture_coordinates = coordinates;
  scene.morph_targets = {&morph, 1};
  scene.morph_normals = true;
  scene.translation = frame.surface.translation;
  scene.scale = frame.surface.scale;
  scene.base_color = {1, 1, 1, 1};
  scene.texture = texture;
  scene.name = name;
  Json extras = {{"texels_per_unit", atlas.scale}};
  if (request.colors.empty()) extras["square"] = square;
  scene.extras = extras.dump();
  gltf::write(request.output, scene, host);
  return {{"vertices", split.vertices.size()}, {"patches", graph.patches()},
          {"size", atlas.options.size},        {"padding", atlas.options.padding},
          {"texels_per_unit", atlas.scale},    {"coverage", atlas.coverage},
          {"triangles_lost_in_texture", lost}, {"triangles_lost_in_float32", lost_triangles(split, base, target)}};
}

}  // namespace orbicube::cli
