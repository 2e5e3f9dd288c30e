#include "gltf/document.h"

#include <array>
#include <string_view>

#include "base/error.h"
#include "base/version.h"
#include "gltf/json.h"
#include "gltf/json_text.h"

namespace orbicube::gltf {

namespace {

constexpr std::uint64_t zero = 0, one = 1;

void write_views(JsonText& json, const BinaryBuffer& buffer) {
  json.key("bufferViews").begin_array();
  for (const BinaryBuffer::View& view : buffer.views()) {
    json.begin_object().member("buffer", zero).member("byteOffset", view.offset).member("byteLength", view.length);
    if (view.target != BinaryBuffer::Target::none) json.member("target", static_cast<std::uint64_t>(view.target));
    json.end_object();
  }
  json.end_array();
}

void write_accessors(JsonText& json, const BinaryBuffer& buffer) {
  constexpr std::array<std::string_view, 5> types = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  json.key("accessors").begin_array();
  for (const BinaryBuffer::Accessor& accessor : buffer.accessors()) {
    json.begin_object().member("bufferView", accessor.view);
    json.member("componentType", static_cast<std::uint64_t>(accessor.component));
    if (accessor.normalized) json.key("normalized").raw("true");
    json.member("count", accessor.count).member("type", types[accessor.components]);
    if (!accessor.smallest.empty()) json.member("min", accessor.smallest).member("max", accessor.largest);
    json.end_object();
  }
  json.end_array();
}

void write_targets(JsonText& json, const SceneAccessors& accessors, bool with_normals) {
  if (accessors.targets.empty()) return;
  json.key("targets").begin_array();
  for (const TargetAccessors& target : accessors.targets) {
    json.begin_object().member("POSITION", target.position);
    if (with_normals && target.normal) json.member("NORMAL", *target.normal);
    json.end_object();
  }
  json.end_array();
}

void write_mesh(JsonText& json, const Scene& scene, const SceneAccessors& accessors) {
  json.key("meshes").begin_array().begin_object().member("name", std::string_view(scene.name));
  json.key("primitives").begin_array();
  json.begin_object().key("attributes").begin_object().member("POSITION", accessors.position);
  if (accessors.normal) json.member("NORMAL", *accessors.normal);
  if (accessors.texture_coordinate) json.member("TEXCOORD_0", *accessors.texture_coordinate);
  if (accessors.color) json.member("COLOR_0", *accessors.color);
  json.end_object().member("indices", accessors.triangles).member("material", zero);
  write_targets(json, accessors, true);
  json.end_object();
  if (accessors.edges) {
    constexpr std::uint64_t lines = 1;
    json.begin_object().key("attributes").begin_object().member("POSITION", accessors.position).end_object();
    json.member("indices", *accessors.edges).member("mode", lines).member("material", one);
    // All primitives of a mesh have the same targets.
    write_targets(json, accessors, false);
    json.end_object();
  }
  json.end_array();
  if (!accessors.targets.empty()) {
    json.member("weights", std::vector<double>(accessors.targets.size(), 0.0));
    json.key("extras").begin_object().key("targetNames").begin_array();
    for (const MorphTarget& target : scene.morph_targets)
      json.value(std::string_view(target.name));
    json.end_array().end_object();
  }
  json.end_object().end_array();
}

void write_animation(JsonText& json, const SceneAccessors& accessors) {
  json.key("animations").begin_array().begin_object().member("name", std::string_view("morph"));
  json.key("channels").begin_array().begin_object().member("sampler", zero);
  json.key("target").begin_object().member("node", zero).member("path", std::string_view("weights")).end_object();
  json.end_object().end_array();
  json.key("samplers").begin_array().begin_object().member("input", *accessors.animation_times);
  json.member("interpolation", std::string_view("LINEAR")).member("output", *accessors.animation_weights);
  json.end_object().end_array().end_object().end_array();
}

void write_material(JsonText& json, std::string_view name, const std::array<double, 4>& color, bool textured,
                    bool both_sides = false) {
  json.begin_object().member("name", name).key("pbrMetallicRoughness").begin_object();
  json.member("baseColorFactor", color).member("metallicFactor", 0.0).member("roughnessFactor", 0.7);
  if (textured) json.key("baseColorTexture").begin_object().member("index", zero).end_object();
  json.end_object();
  if (color.back() < 1) json.member("alphaMode", std::string_view("BLEND"));
  if (both_sides) json.key("doubleSided").raw("true");
  json.end_object();
}

void write_texture(JsonText& json, std::uint64_t view) {
  constexpr std::uint64_t linear = 9729, linear_mipmap = 9987, repeat = 10497;
  json.key("textures").begin_array().begin_object().member("sampler", zero).member("source", zero);
  json.end_object().end_array().key("samplers").begin_array().begin_object();
  json.member("magFilter", linear).member("minFilter", linear_mipmap).member("wrapS", repeat);
  json.member("wrapT", repeat).end_object().end_array();
  json.key("images").begin_array().begin_object().member("bufferView", view);
  json.member("mimeType", std::string_view("image/png")).end_object().end_array();
}

void write_translation(JsonText& json, const mesh::Vector3& translation) {
  if (translation != mesh::Vector3::Zero()) json.member("translation", std::span(translation.data(), 3));
}

void write_scene_and_node(JsonText& json, const Scene& scene) {
  json.member("scene", zero);
  json.key("scenes").begin_array().begin_object().key("nodes").begin_array().value(zero).end_array();
  if (!scene.extras.empty()) json.key("extras").raw(scene.extras);
  json.end_object().end_array();
  json.key("nodes").begin_array().begin_object().member("name", std::string_view(scene.name)).member("mesh", zero);
  write_translation(json, scene.translation);
  if (scene.scale != 1) json.member("scale", std::array{scene.scale, scene.scale, scene.scale});
  json.end_object().end_array();
}

void begin(JsonText& json) {
  json.begin_object().key("asset").begin_object().member("version", std::string_view("2.0"));
  json.member("generator", std::string_view(std::string("Orbicube ") + base::version_text)).end_object();
}

void end(JsonText& json, const BinaryBuffer& buffer, const std::optional<std::string>& uri) {
  write_accessors(json, buffer);
  write_views(json, buffer);
  json.key("buffers").begin_array().begin_object().member("byteLength", buffer.size());
  if (uri) json.member("uri", std::string_view(*uri));
  json.end_object().end_array().end_object();
}

// Throws Error "invalid-argument" with `message` unless the text is a JSON object.
void require_object(std::string_view text, const std::string& message, const base::Host& host) {
  try {
    if (JsonDocument(text, host).root().kind() == JsonKind::object) return;
  } catch (const base::Error& error) {
    if (error.status() == base::Status::cancelled) throw;
  }
  throw base::Error("invalid-argument", message);
}

}  // namespace

std::string document_text(const Scene& scene, const SceneAccessors& accessors, const BinaryBuffer& buffer,
                          const std::optional<std::string>& uri, const base::Host& host) {
  if (!scene.extras.empty()) require_object(scene.extras, "the extras are no JSON object", host);
  JsonText json;
  begin(json);
  write_scene_and_node(json, scene);
  write_mesh(json, scene, accessors);
  if (accessors.animation_times) write_animation(json, accessors);
  json.key("materials").begin_array();
  write_material(json, "surface", scene.base_color, accessors.texture_view.has_value());
  if (accessors.edges) write_material(json, "edges", {0.02, 0.02, 0.02, 1.0}, false);
  json.end_array();
  if (accessors.texture_view) write_texture(json, *accessors.texture_view);
  end(json, buffer, uri);
  require_object(json.text(), "a name is not UTF-8", host);
  return json.text();
}

std::string document_text(std::span<const Part> parts, std::span<const PartAccessors> accessors,
                          const BinaryBuffer& buffer, const std::optional<std::string>& uri, const base::Host& host) {
  JsonText json;
  begin(json);
  json.member("scene", zero).key("scenes").begin_array().begin_object().key("nodes").begin_array();
  for (std::uint64_t i = 0; i < parts.size(); ++i)
    json.value(i);
  json.end_array().end_object().end_array();
  json.key("nodes").begin_array();
  for (std::uint64_t i = 0; i < parts.size(); ++i) {
    json.begin_object().member("name", std::string_view(parts[i].name)).member("mesh", i);
    write_translation(json, parts[i].translation);
    json.end_object();
  }
  json.end_array().key("meshes").begin_array();
  for (std::uint64_t i = 0; i < parts.size(); ++i) {
    json.begin_object().member("name", std::string_view(parts[i].name)).key("primitives").begin_array();
    json.begin_object().key("attributes").begin_object().member("POSITION", accessors[i].position);
    json.member("NORMAL", accessors[i].normal);
    if (accessors[i].color) json.member("COLOR_0", *accessors[i].color);
    json.end_object().member("indices", accessors[i].triangles).member("material", i);
    json.end_object().end_array().end_object();
  }
  json.end_array().key("materials").begin_array();
  for (const Part& part : parts)
    write_material(json, part.name, part.color, false, true);
  json.end_array();
  end(json, buffer, uri);
  require_object(json.text(), "a name is not UTF-8", host);
  return json.text();
}

}  // namespace orbicube::gltf
