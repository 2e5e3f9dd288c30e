#include "gltf/write.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/error.h"
#include "gltf/binary_buffer.h"
#include "gltf/container_writer.h"
#include "gltf/document.h"
#include "gltf/morph.h"
#include "gltf/normals.h"
#include "mesh/file.h"

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
  check_size(scene.colors.size(), 4, "colours");
  require_finite(scene.normals, "normals", host);
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
          "the base colour is not between 0 and 1");
  constexpr std::array<unsigned char, 8> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  require(scene.texture.empty() ||
              (scene.texture.size() > png.size() && std::memcmp(scene.texture.data(), png.data(), png.size()) == 0),
          "the texture is no PNG file");
  require(scene.texture.empty() || !scene.texture_coordinates.empty(), "a texture needs texture coordinates");
}

// What is stored of a morph target for each number: absolute values become deltas.
base::Array<float> deltas_of(std::span<const float> base, std::span<const float> wanted, const base::Host& host) {
  base::Array<float> deltas(base.size(), host.memory);
  constexpr std::size_t values_between_reports = std::size_t{1} << 17U;
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (i % values_between_reports == 0) host.report("making morph targets", i, base.size());
    deltas[i] = delta_for(base[i], wanted[i]);
  }
  return deltas;
}

// The times and weights of the animation: the surface, each target alone, the surface.
void add_animation(BinaryBuffer& buffer, const Scene& scene, SceneAccessors& accessors, const base::Host& host) {
  const std::size_t targets = scene.morph_targets.size();
  base::Array<float> times(host.memory);
  base::Array<float> weights((targets + 2) * targets, 0.0F, host.memory);
  for (std::size_t key = 0; key < targets + 2; ++key)
    times.push_back(static_cast<float>(scene.morph_seconds * static_cast<double>(key)));
  for (std::size_t target = 0; target < targets; ++target)
    weights[(target + 1) * targets + target] = 1;
  accessors.animation_times = buffer.add_floats(std::move(times), 1, true, BinaryBuffer::Target::none);
  accessors.animation_weights = buffer.add_floats(std::move(weights), 1, false, BinaryBuffer::Target::none);
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
    require_finite(deltas, "differences of a morph target", host);
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
  if (!scene.texture_coordinates.empty())
    accessors.texture_coordinate = buffer.add_floats(scene.texture_coordinates, 2, false);
  if (!scene.colors.empty()) accessors.color = buffer.add_colors(scene.colors);
  accessors.triangles = buffer.add_indices({scene.triangles.front().data(), 3 * scene.triangles.size()}, vertices);
  if (!scene.edges.empty())
    accessors.edges = buffer.add_indices({scene.edges.front().data(), 2 * scene.edges.size()}, vertices);
  if (scene.morph_seconds > 0) add_animation(buffer, scene, accessors, host);
  if (!scene.texture.empty()) accessors.texture_view = buffer.add_view(scene.texture, BinaryBuffer::Target::none);
  return accessors;
}

template <class Sink>
void emit(const Scene& scene, Form form, const base::Host& host, const Sink& sink) {
  BinaryBuffer buffer(host);
  const SceneAccessors accessors = add_all(buffer, scene, host);
  emit_container(
      form, buffer,
      [&](const std::optional<std::string>& uri) { return document_text(scene, accessors, buffer, uri, host); }, sink);
}

}  // namespace

Form form_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  return ending == ".gltf" ? Form::gltf : Form::glb;
}

void write(const std::filesystem::path& path, const Scene& scene, const base::Host& host) {
  check(scene, host);
  mesh::OutputFile file(path);
  emit(scene, form_of(path), host, [&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.commit();
}

base::Array<std::byte> to_bytes(const Scene& scene, Form form, const base::Host& host) {
  check(scene, host);
  base::Array<std::byte> result(host.memory);
  emit(scene, form, host,
       [&](std::span<const std::byte> bytes) { result.insert(result.end(), bytes.begin(), bytes.end()); });
  return result;
}

}  // namespace orbicube::gltf
