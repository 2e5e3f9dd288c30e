#include "gltf/writing/write.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "base/error.h"
#include "gltf/json/document.h"
#include "gltf/kept/kept_writer.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/container_writer.h"
#include "gltf/writing/morph_data.h"
#include "gltf/writing/normals.h"
#include "mesh/files/file.h"

namespace orbicube::gltf {

namespace {

void require(bool condition, const std::string& message) {
  if (!condition) throw base::Error("invalid-argument", message);
}

void require_finite(std::span<const float> values, const char* what, const base::Host& host) {
  constexpr std::size_t values_between_reports = std::size_t{1} << 18U;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % values_between_reports == 0) host.report("checking", i, values.size());
    require(std::isfinite(values[i]), std::string(what) + " are not finite");
  }
}

void check(const Scene& scene, const base::Host& host) {
  const std::size_t vertices = scene.positions.size() / 3;
  require(scene.positions.size() % 3 == 0, "positions do not have three numbers a vertex");
  require(vertices > 0 && !scene.triangles.empty(), "there are no triangles to write");
  require(vertices < mesh::no_index, "there are more vertices than 32-bit indices can count");
  require_finite(scene.positions, "positions", host);
  const auto check_size = [&](std::size_t size, std::size_t components, const char* what) {
    require(size == 0 || size == components * vertices, std::string(what) + " have another size than positions");
  };
  check_size(scene.normals.size(), 3, "normals");
  check_size(scene.texture_coordinates.size(), 2, "texture coordinates");
  check_size(scene.tangents.size(), 4, "tangents");
  check_size(scene.colors.size(), 4, "colors");
  require_finite(scene.normals, "normals", host);
  require_finite(scene.tangents, "tangents", host);
  require(scene.tangents.empty() || !scene.normals.empty(), "tangents need normals");
  require_finite(scene.texture_coordinates, "texture coordinates", host);
  for (const MorphTarget& target : scene.morph_targets) {
    require(target.positions.size() == 3 * vertices, "a morph target has another size than positions");
    require_finite(target.positions, "positions of a morph target", host);
  }
  const auto is_index = [&](mesh::Index v) { return v < vertices; };
  for (const mesh::Triangle& triangle : scene.triangles)
    require(std::all_of(triangle.begin(), triangle.end(), is_index), "a triangle has a vertex that does not exist");
  for (const auto& edge : scene.edges)
    require(std::all_of(edge.begin(), edge.end(), is_index), "an edge has a vertex that does not exist");
  require(!scene.morph_normals || scene.smooth_normals || !scene.normals.empty(), "morph normals need normals");
  require(std::isfinite(scene.morph_seconds) && scene.morph_seconds >= 0,
          "the seconds of the animation are no duration");
  require(scene.morph_seconds == 0 || !scene.morph_targets.empty(), "an animation needs morph targets");
  require(scene.translation.allFinite() && std::isfinite(scene.scale) && scene.scale > 0,
          "translation is not finite, or scale is not a positive number");
  require(std::all_of(scene.base_color.begin(), scene.base_color.end(), [](double c) { return c >= 0 && c <= 1; }),
          "the base color is not between 0 and 1");
  constexpr std::array<unsigned char, 8> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  require(scene.texture.empty() ||
              (scene.texture.size() > png.size() && std::memcmp(scene.texture.data(), png.data(), png.size()) == 0),
          "the texture is no PNG file");
  require(scene.texture.empty() || !scene.texture_coordinates.empty(), "a texture needs texture coordinates");
  require(scene.kept == nullptr ||
              (scene.normals.empty() && scene.tangents.empty() && scene.colors.empty() && scene.edges.empty() &&
               scene.extras.empty() && (!scene.morph_normals || scene.smooth_normals)),
          "a surface with what its file has besides takes no normals, tangents, colors, edges or extras");
}

SceneAccessors add_all(BinaryBuffer& buffer, const Scene& scene, const base::Host& host) {
  SceneAccessors accessors;
  const std::size_t vertices = scene.positions.size() / 3;
  accessors.position = buffer.add_floats(scene.positions, 3, true);
  std::span<const float> normals = scene.normals;
  base::Array<float> made(host.memory);
  if (normals.empty() && scene.smooth_normals) {
    made = smooth_normals(scene.positions, scene.triangles, host);
    normals = made;
  }
  for (const MorphTarget& target : scene.morph_targets) {
    TargetAccessors added{};
    base::Array<float> deltas = deltas_of(scene.positions, target.positions, host);
    added.position = buffer.add_floats(std::move(deltas), 3, true);
    if (scene.morph_normals) {
      const base::Array<float> wanted = smooth_normals(target.positions, scene.triangles, host);
      added.normal = buffer.add_floats(deltas_of(normals, wanted, host), 3, false);
    }
    accessors.targets.push_back(added);
  }
  if (!made.empty()) {
    accessors.normal = buffer.add_floats(std::move(made), 3, false);
  } else if (!normals.empty()) {
    accessors.normal = buffer.add_floats(normals, 3, false);
  }
  if (!scene.tangents.empty()) accessors.tangent = buffer.add_floats(scene.tangents, 4, false);
  if (!scene.texture_coordinates.empty())
    accessors.texture_coordinate = buffer.add_floats(scene.texture_coordinates, 2, false);
  if (!scene.colors.empty()) accessors.color = buffer.add_colors(scene.colors);
  accessors.triangles = buffer.add_indices({scene.triangles.front().data(), 3 * scene.triangles.size()}, vertices);
  if (!scene.edges.empty())
    accessors.edges = buffer.add_indices({scene.edges.front().data(), 2 * scene.edges.size()}, vertices);
  if (scene.morph_seconds > 0) {
    const AnimationAccessors animation = add_animation(buffer, scene, host);
    accessors.animation_times = animation.times;
    accessors.animation_weights = animation.weights;
  }
  if (!scene.texture.empty()) accessors.texture_view = buffer.add_view(scene.texture, BinaryBuffer::Target::none);
  return accessors;
}

template <class Sink>
void emit(const Scene& scene, Form form, const base::Host& host, const Sink& sink) {
  BinaryBuffer buffer(host);
  if (scene.kept != nullptr) {
    tiny::Model model = scene.kept->add_scene(buffer, scene, host);
    emit_container(form, std::move(model), "", buffer, host, sink);
    return;
  }
  const SceneAccessors accessors = add_all(buffer, scene, host);
  emit_container(form, model_of(scene, accessors), scene.extras, buffer, host, sink);
}

template <class Sink>
void emit(const Kept& kept, Form form, const base::Host& host, const Sink& sink) {
  BinaryBuffer buffer(host);
  tiny::Model model = add_kept_file(buffer, kept);
  emit_container(form, std::move(model), "", buffer, host, sink);
}

}  // namespace

void write(const std::filesystem::path& path, const Scene& scene, const base::Host& host) {
  check(scene, host);
  mesh::OutputFile file(path);
  emit(scene, form_of_path(path).value_or(Form::glb), host,
       [&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.commit();
}

void write(const std::filesystem::path& path, const Kept& kept, const base::Host& host) {
  mesh::OutputFile file(path);
  emit(kept, form_of_path(path).value_or(Form::glb), host,
       [&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.commit();
}

base::Array<std::byte> to_bytes(const Kept& kept, Form form, const base::Host& host) {
  base::Array<std::byte> result(host.memory);
  emit(kept, form, host,
       [&](std::span<const std::byte> bytes) { result.insert(result.end(), bytes.begin(), bytes.end()); });
  return result;
}

base::Array<std::byte> to_bytes(const Scene& scene, Form form, const base::Host& host) {
  check(scene, host);
  base::Array<std::byte> result(host.memory);
  emit(scene, form, host,
       [&](std::span<const std::byte> bytes) { result.insert(result.end(), bytes.begin(), bytes.end()); });
  return result;
}

}  // namespace orbicube::gltf
