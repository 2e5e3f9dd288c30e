#include "orbicube/gltf.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/version.h"
#include "capi/src/entry.h"
#include "gltf/kept/kept.h"
#include "gltf/kept/kept_nearest.h"
#include "gltf/reading/read.h"
#include "gltf/writing/checker.h"
#include "gltf/writing/morph.h"
#include "gltf/writing/write.h"

using namespace orbicube;

struct obc_gltf_surface {
  explicit obc_gltf_surface(const obc_host* host) : adapter(host), mesh(adapter.host().memory) {}
  capi::HostAdapter adapter;
  mesh::Mesh mesh;
  mesh::ReadReport report;
  std::unique_ptr<gltf::Kept> kept;  // null: nothing is
};

namespace {

obc_gltf_read_options default_read_options() {
  obc_gltf_read_options options{};
  options.struct_size = sizeof options;
  options.weld_identical = 1;
  return options;
}

gltf::ReadOptions to_read_options(const obc_gltf_read_options* given) {
  const obc_gltf_read_options from = capi::copy_versioned(given, default_read_options());
  gltf::ReadOptions options;
  options.weld_identical = from.weld_identical != 0;
  if (from.morph_target != nullptr) options.morph_target = from.morph_target;
  return options;
}

// Where the handle keeps the rest of a file; null: nowhere.
std::unique_ptr<gltf::Kept>* place_to_keep(const obc_gltf_read_options* given, obc_gltf_surface& surface) {
  const int32_t keep = capi::copy_versioned(given, default_read_options()).keep;
  capi::require(keep == 0 || keep == 1, "keep is neither 0 nor 1");
  return keep == 1 ? &surface.kept : nullptr;
}

// Runs `read` with a new handle and hands it out when that succeeds.
template <class Read>
obc_status read_surface(const obc_host* host, obc_gltf_surface** out, obc_error* error, const Read& read) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    auto surface = std::make_unique<obc_gltf_surface>(host);
    surface->mesh = read(surface->adapter.host(), *surface);
    *out = surface.release();
  });
}

obc_gltf_scene default_scene() {
  const gltf::Scene from;
  obc_gltf_scene scene{};
  scene.struct_size = sizeof scene;
  scene.scale = from.scale;
  std::copy(from.base_color.begin(), from.base_color.end(), scene.base_color);
  return scene;
}

// `count` elements of `components` numbers each; nothing for NULL. Views the caller's array as elements of another type
// with the same layout.
template <class Element, class Number>
std::span<const Element> view(const Number* numbers, std::size_t count) {
  static_assert(sizeof(Element) % sizeof(Number) == 0 && alignof(Element) == alignof(Number));
  if (numbers == nullptr) return {};
  return {reinterpret_cast<const Element*>(numbers), count};
}

// What a gltf::Scene points at besides the caller's arrays.
struct SceneStorage {
  explicit SceneStorage(std::pmr::memory_resource* memory) : texture(memory), kept_triangles(memory) {}
  std::vector<gltf::MorphTarget> targets;
  base::Array<std::byte> texture;
  base::Array<gltf::KeptTriangle> kept_triangles;
};

const gltf::Kept& checked_kept(const obc_gltf_surface* surface) {
  capi::require(surface != nullptr, "surface is NULL");
  capi::require(surface->kept != nullptr,
                "the surface keeps nothing of its file: it was read without `keep`, or a note gives the reason");
  return *surface->kept;
}

// Adds what a surface keeps, and where the triangles of the scene lie on it.
void add_kept(const obc_gltf_scene& from, gltf::Scene& scene, SceneStorage& storage, const base::Host& host) {
  if (from.kept == nullptr) {
    capi::require(from.kept_positions == nullptr, "kept_positions needs kept");
    return;
  }
  scene.kept = &checked_kept(from.kept);
  if (from.kept_positions == nullptr) return;
  const mesh::Mesh& surface = from.kept->mesh;
  constexpr double max_coordinate = 1e150;  // squares are in the range of double
  const auto require_range = [&](std::span<const mesh::Vector3> positions, const char* message) {
    for (const mesh::Vector3& p : positions)
      capi::require(p.cwiseAbs().maxCoeff() <= max_coordinate && p.allFinite(), message);
  };
  require_range(surface.positions, "a coordinate of the surface that was read is beyond 1e150");
  const auto positions = view<mesh::Vector3>(from.kept_positions, from.vertex_count);
  require_range(positions, "kept_positions is not finite, or beyond 1e150");
  base::Array<mesh::Vector3> middles(host.memory);
  middles.reserve(scene.triangles.size());
  for (const auto& [a, b, c] : scene.triangles) {
    capi::require(std::max({a, b, c}) < positions.size(), "a triangle has a vertex that does not exist");
    middles.push_back((positions[a] + positions[b] + positions[c]) / 3);
  }
  storage.kept_triangles = gltf::nearest_kept_triangles(surface, positions, scene.triangles, middles, host);
  scene.kept_surface = surface.triangles;
  scene.kept_triangles = storage.kept_triangles;
}

gltf::Scene to_scene(const obc_gltf_scene* given, SceneStorage& storage, const base::Host& host) {
  capi::require(given != nullptr, "scene is NULL");
  const obc_gltf_scene from = capi::copy_versioned(given, default_scene());
  const std::size_t n = from.vertex_count;
  constexpr std::size_t most = UINT32_MAX;
  capi::require(n < most && from.triangle_count <= SIZE_MAX / 16 && from.edge_count <= SIZE_MAX / 16,
                "a count is too large");
  capi::require(from.positions != nullptr && from.triangles != nullptr, "positions or triangles are NULL");
  gltf::Scene scene;
  scene.positions = {from.positions, 3 * n};
  scene.triangles = view<mesh::Triangle>(from.triangles, from.triangle_count);
  if (from.normals != nullptr) scene.normals = {from.normals, 3 * n};
  scene.smooth_normals = from.smooth_normals != 0;
  if (from.texture_coordinates != nullptr) scene.texture_coordinates = {from.texture_coordinates, 2 * n};
  if (from.colors != nullptr) scene.colors = {from.colors, 4 * n};
  scene.edges = view<std::array<mesh::Index, 2>>(from.edges, from.edge_count);
  capi::require(from.morph_target_count == 0 || from.morph_targets != nullptr, "morph_targets is NULL");
  for (std::size_t i = 0; i < from.morph_target_count; ++i) {
    const obc_gltf_morph_target& target = from.morph_targets[i];
    capi::require(target.name != nullptr && target.positions != nullptr, "a morph target has NULL inside");
    storage.targets.push_back({target.name, {target.positions, 3 * n}});
  }
  scene.morph_targets = storage.targets;
  scene.morph_normals = from.morph_normals != 0;
  scene.morph_seconds = from.morph_seconds;
  scene.translation = mesh::Vector3(from.translation);
  scene.scale = from.scale;
  std::copy(std::begin(from.base_color), std::end(from.base_color), scene.base_color.begin());
  if (from.texture != nullptr) {
    scene.texture = {static_cast<const std::byte*>(from.texture), from.texture_size};
  } else if (from.checker_texture != 0) {
    storage.texture = gltf::checker_png({}, storage.texture.get_allocator().resource());
    scene.texture = storage.texture;
  }
  if (from.name != nullptr) scene.name = from.name;
  if (from.extras != nullptr) scene.extras = from.extras;
  add_kept(from, scene, storage, host);
  return scene;
}

}  // namespace

obc_status obc_gltf_read_options_init(obc_gltf_read_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_read_options());
}

obc_status obc_gltf_read(const char* path, const obc_gltf_read_options* options, const obc_host* host,
                         obc_gltf_surface** out, obc_error* error) {
  return read_surface(host, out, error, [&](const base::Host& adapted, obc_gltf_surface& made) {
    mesh::Mesh surface(adapted.memory);
    std::unique_ptr<gltf::Kept>* const kept = place_to_keep(options, made);
    capi::on_file(path, [&] { surface = gltf::read(path, to_read_options(options), adapted, &made.report, kept); });
    return surface;
  });
}

obc_status obc_gltf_read_memory(const void* bytes, size_t size, const char* folder,
                                const obc_gltf_read_options* options, const obc_host* host, obc_gltf_surface** out,
                                obc_error* error) {
  return read_surface(host, out, error, [&](const base::Host& adapted, obc_gltf_surface& made) {
    capi::require(bytes != nullptr || size == 0, "bytes is NULL");
    std::optional<std::filesystem::path> where;
    if (folder != nullptr) where = folder;
    const std::span<const std::byte> content(static_cast<const std::byte*>(bytes), size);
    return gltf::read(content, where, to_read_options(options), adapted, &made.report, place_to_keep(options, made));
  });
}

size_t obc_gltf_surface_vertex_count(const obc_gltf_surface* surface) {
  return surface != nullptr ? surface->mesh.positions.size() : 0;
}

size_t obc_gltf_surface_triangle_count(const obc_gltf_surface* surface) {
  return surface != nullptr ? surface->mesh.triangles.size() : 0;
}

size_t obc_gltf_surface_welded_vertex_count(const obc_gltf_surface* surface) {
  return surface != nullptr ? surface->report.welded_vertices : 0;
}

int32_t obc_gltf_surface_keeps(const obc_gltf_surface* surface) {
  return surface != nullptr && surface->kept != nullptr ? 1 : 0;
}

size_t obc_gltf_surface_note_count(const obc_gltf_surface* surface) {
  return surface != nullptr ? surface->report.notes.size() : 0;
}

const char* obc_gltf_surface_note(const obc_gltf_surface* surface, size_t index) {
  return index < obc_gltf_surface_note_count(surface) ? surface->report.notes[index].c_str() : nullptr;
}

obc_status obc_gltf_surface_copy(const obc_gltf_surface* surface, double* positions, uint32_t* triangles,
                                 obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(surface != nullptr, "surface is NULL");
    const mesh::Mesh& from = surface->mesh;
    if (positions != nullptr)
      std::memcpy(positions, from.positions.data(), from.positions.size() * sizeof(mesh::Vector3));
    if (triangles != nullptr)
      std::memcpy(triangles, from.triangles.data(), from.triangles.size() * sizeof(mesh::Triangle));
  });
}

void obc_gltf_surface_destroy(obc_gltf_surface* surface) {
  delete surface;
}

obc_status obc_gltf_scene_init(obc_gltf_scene* scene, size_t struct_size) {
  return capi::init_versioned(scene, struct_size, default_scene());
}

obc_status obc_gltf_write(const char* path, const obc_gltf_scene* scene, const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::HostAdapter adapter(host);
    SceneStorage storage(adapter.host().memory);
    const gltf::Scene checked = to_scene(scene, storage, adapter.host());
    capi::on_file(path, [&] { gltf::write(path, checked, adapter.host()); });
  });
}

obc_status obc_gltf_write_kept(const char* path, const obc_gltf_surface* surface, const obc_host* host,
                               obc_error* error) {
  return capi::guarded(error, [&] {
    const gltf::Kept& kept = checked_kept(surface);
    const capi::HostAdapter adapter(host);
    capi::on_file(path, [&] { gltf::write(path, kept, adapter.host()); });
  });
}

obc_status obc_gltf_write_surface(const char* path, const float* positions, size_t vertex_count,
                                  const uint32_t* triangles, size_t triangle_count, const obc_host* host,
                                  obc_error* error) {
  obc_gltf_scene scene = default_scene();
  scene.positions = positions;
  scene.vertex_count = vertex_count;
  scene.triangles = triangles;
  scene.triangle_count = triangle_count;
  scene.smooth_normals = 1;
  return obc_gltf_write(path, &scene, host, error);
}

float obc_gltf_delta(float base, float wanted) {
  return gltf::delta_for(base, wanted);
}

float obc_gltf_reconstructed(float base, float delta) {
  return gltf::reconstructed(base, delta);
}

uint32_t obc_gltf_version(void) {
  return base::version_number;
}
