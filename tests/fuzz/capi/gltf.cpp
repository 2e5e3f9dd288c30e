// glTF: scenes of any arrays are written, and read again with changed bytes; and any bytes are read.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "orbicube/gltf.h"
#include "scratch.h"
#include "shapes.h"

using namespace fuzz;

namespace {

void read(std::span<const std::uint8_t> bytes, Input& in, Host& host) {
  obc_gltf_read_options options;
  obc_gltf_read_options_init(&options, sizeof options);
  options.weld_identical = in.choice(2);
  if (in.one_in(3)) options.morph_target = "sphere";
  options.keep = in.choice(2);
  obc_gltf_surface* surface = nullptr;
  if (!ok([&](obc_error* e) {
        return obc_gltf_read_memory(bytes.data(), bytes.size(), nullptr, &options, host.c(), &surface, e);
      }))
    return;
  const std::size_t vertices = obc_gltf_surface_vertex_count(surface);
  std::vector<double> positions(3 * vertices);
  std::vector<std::uint32_t> triangles(3 * obc_gltf_surface_triangle_count(surface));
  require(ok([&](obc_error* e) { return obc_gltf_surface_copy(surface, positions.data(), triangles.data(), e); }),
          "it cannot be copied");
  require_finite(positions, "a position that is not finite");
  require_below(triangles, vertices, "a triangle with a vertex that does not exist");
  for (std::size_t i = 0; i < obc_gltf_surface_note_count(surface); ++i)
    require(obc_gltf_surface_note(surface, i) != nullptr, "no note");
  require(obc_gltf_surface_note(surface, SIZE_MAX) == nullptr, "a note too many");
  if (obc_gltf_surface_keeps(surface) == 1 && in.one_in(2)) {
    const Scratch file(".kept.glb");
    std::vector<float> moved;
    for (const double x : positions)
      moved.push_back(static_cast<float>(std::clamp(x, -1e30, 1e30)));
    obc_gltf_scene scene;
    obc_gltf_scene_init(&scene, sizeof scene);
    scene.positions = moved.data();
    scene.vertex_count = vertices;
    scene.triangles = triangles.data();
    scene.triangle_count = triangles.size() / 3;
    scene.kept = surface;
    if (in.one_in(2)) scene.kept_positions = positions.data();
    ok([&](obc_error* e) { return obc_gltf_write(file.path(), &scene, host.c(), e); });
    ok([&](obc_error* e) { return obc_gltf_write_kept(file.path(), surface, host.c(), e); });
  }
  obc_gltf_surface_destroy(surface);
}

std::vector<float> floats(const std::vector<double>& from) {
  std::vector<float> result;
  for (const double x : from)
    result.push_back(std::abs(x) < 3e38 || std::isnan(x) ? static_cast<float>(x)
                                                         : std::numeric_limits<float>::infinity());
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const Shape shape = surface(in);
  const std::size_t n = shape.vertex_count();
  const auto positions = floats(shape.positions), target = floats(in.one_in(4) ? in.numbers(3 * n) : shape.positions),
             normals = floats(in.one_in(4) ? in.numbers(3 * n) : std::vector<double>(3 * n, 0.57735026918962576)),
             coordinates = floats(in.one_in(4) ? in.numbers(2 * n) : in.moderates(2 * n));
  std::vector<std::uint8_t> colors(4 * n, in.byte());
  const auto edges = in.indices(2 * in.below(4), n);
  const auto texture = in.rest();
  const char* const texts[] = {"sphere", "", "\xff\xfe", "\"quoted\\", "{}", "{\"a\": [1, 2]}", "[", "nul", nullptr};
  const obc_gltf_morph_target targets[] = {{texts[in.below(9)], target.data()},
                                           {texts[in.below(9)], in.one_in(9) ? nullptr : positions.data()}};
  obc_gltf_scene scene;
  obc_gltf_scene_init(&scene, sizeof scene);
  scene.positions = positions.data();
  scene.vertex_count = n;
  scene.triangles = shape.cells.data();
  scene.triangle_count = shape.cell_count();
  scene.smooth_normals = in.choice(2);
  if (in.one_in(3)) scene.normals = normals.data();
  if (in.one_in(3)) scene.texture_coordinates = coordinates.data();
  if (in.one_in(3)) scene.colors = colors.data();
  scene.edges = edges.data();
  scene.edge_count = edges.size() / 2;
  scene.morph_targets = targets;
  scene.morph_target_count = in.below(3);
  if (in.one_in(4)) {
    scene.translation[in.below(3)] = in.number();
    scene.scale = in.number();
    scene.base_color[in.below(4)] = in.number();
    scene.morph_seconds = in.number();
  }
  if (in.one_in(4)) {
    scene.texture = texture.data();
    scene.texture_size = texture.size();
  }
  scene.checker_texture = in.choice(2);
  scene.morph_normals = in.choice(2);
  if (in.one_in(3)) scene.name = texts[in.below(9)];
  if (in.one_in(3)) scene.extras = texts[in.below(9)];
  const Scratch file(in.one_in(2) ? ".glb" : ".gltf");
  if (ok([&](obc_error* e) { return obc_gltf_write(file.path(), &scene, host.c(), e); })) {
    std::ifstream stream(file.path(), std::ios::binary);
    std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    for (std::size_t i = in.below(6); i > 0; --i)
      bytes[in.bits() % bytes.size()] = in.byte();
    if (in.one_in(8)) bytes.resize(in.bits() % (bytes.size() + 1));
    read(bytes, in, host);
  }
  read(in.rest(), in, host);
  return 0;
}
