#include "gltf/document.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/version.h"

namespace orbicube::gltf {

namespace {

using Json = nlohmann::ordered_json;

Json extras_of(const std::string& text) {
  constexpr int deepest_nesting = 100;
  const auto check_depth = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > deepest_nesting) throw base::Error("invalid-argument", "the extras are nested too deeply");
    return true;
  };
  try {
    Json extras = Json::parse(text, check_depth);
    if (extras.is_object()) return extras;
  } catch (const Json::exception&) {
    // Falls through to the one message for whatever is not an object.
  }
  throw base::Error("invalid-argument", "the extras are no JSON object");
}

Json views_of(const BinaryBuffer& buffer) {
  Json views = Json::array();
  for (const BinaryBuffer::View& view : buffer.views()) {
    Json one = {{"buffer", 0}, {"byteOffset", view.offset}, {"byteLength", view.length}};
    if (view.target != BinaryBuffer::Target::none) one["target"] = static_cast<std::uint64_t>(view.target);
    views.push_back(std::move(one));
  }
  return views;
}

Json accessors_of(const BinaryBuffer& buffer) {
  constexpr std::array types = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  Json accessors = Json::array();
  for (const BinaryBuffer::Accessor& accessor : buffer.accessors()) {
    Json one = {{"bufferView", accessor.view},
                {"componentType", static_cast<std::uint64_t>(accessor.component)},
                {"count", accessor.count},
                {"type", types[accessor.components]}};
    if (accessor.normalized) one["normalized"] = true;
    if (!accessor.smallest.empty()) {
      one["min"] = accessor.smallest;
      one["max"] = accessor.largest;
    }
    accessors.push_back(std::move(one));
  }
  return accessors;
}

Json targets_of(const SceneAccessors& accessors, bool with_normals) {
  Json targets = Json::array();
  for (const TargetAccessors& target : accessors.targets) {
    Json one = {{"POSITION", target.position}};
    if (with_normals && target.normal) one["NORMAL"] = *target.normal;
    targets.push_back(std::move(one));
  }
  return targets;
}

Json mesh_of(const Scene& scene, const SceneAccessors& accessors) {
  Json attributes = {{"POSITION", accessors.position}};
  if (accessors.normal) attributes["NORMAL"] = *accessors.normal;
  if (accessors.texture_coordinate) attributes["TEXCOORD_0"] = *accessors.texture_coordinate;
  if (accessors.color) attributes["COLOR_0"] = *accessors.color;
  Json primitives = Json::array();
  primitives.push_back({{"attributes", std::move(attributes)}, {"indices", accessors.triangles}, {"material", 0}});
  if (accessors.edges) {
    constexpr int lines = 1;
    primitives.push_back({{"attributes", {{"POSITION", accessors.position}}},
                          {"indices", *accessors.edges},
                          {"mode", lines},
                          {"material", 1}});
  }
  Json mesh = {{"name", scene.name}};
  if (!accessors.targets.empty()) {
    // All primitives of a mesh have the same targets.
    primitives[0]["targets"] = targets_of(accessors, true);
    if (accessors.edges) primitives[1]["targets"] = targets_of(accessors, false);
    mesh["weights"] = std::vector<double>(accessors.targets.size(), 0.0);
    Json& names = mesh["extras"]["targetNames"];
    for (const MorphTarget& target : scene.morph_targets)
      names.push_back(target.name);
  }
  mesh["primitives"] = std::move(primitives);
  return mesh;
}

Json material_of(const char* name, const std::array<double, 4>& color, bool textured) {
  Json surface = {{"baseColorFactor", color}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.7}};
  if (textured) surface["baseColorTexture"] = {{"index", 0}};
  Json material = {{"name", name}, {"pbrMetallicRoughness", std::move(surface)}};
  if (color.back() < 1) material["alphaMode"] = "BLEND";
  return material;
}

Json document_of(const Scene& scene, const SceneAccessors& accessors, const BinaryBuffer& buffer) {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", std::string("Orbicube ") + base::version_text}}},
                   {"scene", 0}};
  Json shown = {{"nodes", {0}}};
  if (!scene.extras.empty()) shown["extras"] = extras_of(scene.extras);
  document["scenes"].push_back(std::move(shown));

  Json node = {{"name", scene.name}, {"mesh", 0}};
  if (scene.translation != mesh::Vector3::Zero())
    node["translation"] = {scene.translation.x(), scene.translation.y(), scene.translation.z()};
  if (scene.scale != 1) node["scale"] = {scene.scale, scene.scale, scene.scale};
  document["nodes"].push_back(std::move(node));
  document["meshes"].push_back(mesh_of(scene, accessors));

  document["materials"].push_back(material_of("surface", scene.base_color, accessors.texture_view.has_value()));
  if (accessors.edges) document["materials"].push_back(material_of("edges", {0.02, 0.02, 0.02, 1.0}, false));
  if (accessors.texture_view) {
    constexpr int linear = 9729, linear_mipmap = 9987, repeat = 10497;
    document["textures"].push_back({{"sampler", 0}, {"source", 0}});
    document["samplers"].push_back(
        {{"magFilter", linear}, {"minFilter", linear_mipmap}, {"wrapS", repeat}, {"wrapT", repeat}});
    document["images"].push_back({{"bufferView", *accessors.texture_view}, {"mimeType", "image/png"}});
  }
  document["accessors"] = accessors_of(buffer);
  document["bufferViews"] = views_of(buffer);
  return document;
}

}  // namespace

std::string document_text(const Scene& scene, const SceneAccessors& accessors, const BinaryBuffer& buffer,
                          const std::optional<std::string>& uri) {
  Json document = document_of(scene, accessors, buffer);
  Json one = {{"byteLength", buffer.size()}};
  if (uri) one["uri"] = *uri;
  document["buffers"].push_back(std::move(one));
  try {
    return document.dump();
  } catch (const Json::type_error&) {
    throw base::Error("invalid-argument", "a name is not UTF-8");
  }
}

}  // namespace orbicube::gltf
