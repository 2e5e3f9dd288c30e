#include "gltf/json/document.h"

#include <array>
#include <utility>

#include "base/error.h"
#include "base/version.h"
#include "gltf/json/json.h"

namespace orbicube::gltf {

namespace {

tiny::Primitive primitive_of(int position, int indices, int mode, int material) {
  tiny::Primitive primitive;
  primitive.attributes["POSITION"] = position;
  primitive.indices = indices;
  primitive.mode = mode;
  primitive.material = material;
  return primitive;
}

void add_targets(tiny::Primitive& primitive, const SceneAccessors& accessors, bool with_normals) {
  for (const TargetAccessors& target : accessors.targets) {
    std::map<std::string, int>& attributes = primitive.targets.emplace_back();
    attributes["POSITION"] = target.position;
    if (with_normals && target.normal) attributes["NORMAL"] = *target.normal;
  }
}

tiny::Mesh mesh_of(const Scene& scene, const SceneAccessors& accessors) {
  tiny::Mesh mesh;
  mesh.name = scene.name;
  tiny::Primitive& surface =
      mesh.primitives.emplace_back(primitive_of(accessors.position, accessors.triangles, TINYGLTF_MODE_TRIANGLES, 0));
  if (accessors.normal) surface.attributes["NORMAL"] = *accessors.normal;
  if (accessors.tangent) surface.attributes["TANGENT"] = *accessors.tangent;
  if (accessors.texture_coordinate) surface.attributes["TEXCOORD_0"] = *accessors.texture_coordinate;
  if (accessors.color) surface.attributes["COLOR_0"] = *accessors.color;
  add_targets(surface, accessors, true);
  if (accessors.edges) {
    // All primitives of a mesh have the same targets.
    tiny::Primitive& edges =
        mesh.primitives.emplace_back(primitive_of(accessors.position, *accessors.edges, TINYGLTF_MODE_LINE, 1));
    add_targets(edges, accessors, false);
  }
  if (!accessors.targets.empty()) set_target_names(mesh, scene.morph_targets);
  return mesh;
}

tiny::Model model_with_scene() {
  tiny::Model model;
  model.asset.version = "2.0";
  model.asset.generator = generator();
  model.defaultScene = 0;
  model.scenes.emplace_back();
  return model;
}

// Throws Error "invalid-argument" unless the text is a JSON object.
void require_object(std::string_view text, const base::Host& host) {
  try {
    if (JsonDocument(text, host).root().kind() == JsonKind::object) return;
  } catch (const base::Error& error) {
    if (error.status() == base::Status::cancelled) throw;
  }
  throw base::Error("invalid-argument", "the extras are no JSON object");
}

// tinygltf 2.7 writes an object without members as null, and nothing else: numbers are finite, and extras have no null.
void mend_empty_objects(std::string& text) {
  constexpr std::string_view null = "null";
  bool in_string = false;
  std::size_t to = 0;
  for (std::size_t from = 0; from < text.size(); ++from) {
    const char c = text[from];
    if (in_string && c == '\\') {
      text[to++] = c;
      text[to++] = text[++from];
      continue;
    }
    if (c == '"') in_string = !in_string;
    if (!in_string && text.compare(from, null.size(), null) == 0) {
      text[to++] = '{';
      text[to++] = '}';
      from += null.size() - 1;
      continue;
    }
    text[to++] = c;
  }
  text.resize(to);
}

}  // namespace

std::string generator() {
  return std::string("Orbicube ") + base::version_text;
}

void set_target_names(tiny::Mesh& mesh, std::span<const MorphTarget> targets) {
  tiny::Value::Array names;
  for (const MorphTarget& target : targets)
    names.emplace_back(target.name);
  tiny::Value::Object extras;
  if (mesh.extras.IsObject()) extras = mesh.extras.Get<tiny::Value::Object>();
  extras["targetNames"] = tiny::Value(std::move(names));
  mesh.extras = tiny::Value(std::move(extras));
  mesh.weights.assign(targets.size(), 0.0);
}

void add_animation(tiny::Model& model, std::span<const int> nodes, int times, int weights) {
  tiny::Animation& animation = model.animations.emplace_back();
  animation.name = "morph";
  tiny::AnimationSampler& sampler = animation.samplers.emplace_back();
  sampler.input = times;
  sampler.output = weights;
  sampler.interpolation = "LINEAR";
  for (const int node : nodes) {
    tiny::AnimationChannel& channel = animation.channels.emplace_back();
    channel.sampler = 0;
    channel.target_node = node;
    channel.target_path = "weights";
  }
}

void place_node(tiny::Node& node, const mesh::Vector3& translation, double scale) {
  node.matrix.clear();
  node.rotation.clear();
  node.translation.clear();
  node.scale.clear();
  if (translation != mesh::Vector3::Zero()) node.translation.assign(translation.begin(), translation.end());
  if (scale != 1) node.scale.assign(3, scale);
}

tiny::Material surface_material(const std::string& name, const std::array<double, 4>& color) {
  tiny::Material material;
  material.name = name;
  material.pbrMetallicRoughness.baseColorFactor.assign(color.begin(), color.end());
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.7;
  if (color.back() < 1) material.alphaMode = "BLEND";
  return material;
}

void add_texture(tiny::Model& model, tiny::Material& material, int view) {
  material.pbrMetallicRoughness.baseColorTexture.index = static_cast<int>(model.textures.size());
  tiny::Texture& texture = model.textures.emplace_back();
  texture.sampler = static_cast<int>(model.samplers.size());
  texture.source = static_cast<int>(model.images.size());
  tiny::Sampler& sampler = model.samplers.emplace_back();
  sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
  sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
  tiny::Image& image = model.images.emplace_back();
  image.bufferView = view;
  image.mimeType = "image/png";
}

tiny::Model model_of(const Scene& scene, const SceneAccessors& accessors) {
  tiny::Model model = model_with_scene();
  model.scenes[0].nodes = {0};
  tiny::Node& node = model.nodes.emplace_back();
  node.name = scene.name;
  node.mesh = 0;
  place_node(node, scene.translation, scene.scale);
  model.meshes.push_back(mesh_of(scene, accessors));
  if (accessors.animation_times)
    add_animation(model, std::array{0}, *accessors.animation_times, *accessors.animation_weights);
  model.materials.push_back(surface_material("surface", scene.base_color));
  if (accessors.texture_view) add_texture(model, model.materials[0], *accessors.texture_view);
  if (accessors.edges) model.materials.push_back(surface_material("edges", {0.02, 0.02, 0.02, 1.0}));
  return model;
}

tiny::Model model_of(std::span<const Part> parts, std::span<const PartAccessors> accessors) {
  tiny::Model model = model_with_scene();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto number = static_cast<int>(i);
    model.scenes[0].nodes.push_back(number);
    tiny::Node& node = model.nodes.emplace_back();
    node.name = parts[i].name;
    node.mesh = number;
    place_node(node, parts[i].translation, parts[i].scale);
    tiny::Mesh& mesh = model.meshes.emplace_back();
    mesh.name = parts[i].name;
    tiny::Primitive& primitive = mesh.primitives.emplace_back(
        primitive_of(accessors[i].position, accessors[i].triangles, TINYGLTF_MODE_TRIANGLES, number));
    primitive.attributes["NORMAL"] = accessors[i].normal;
    if (accessors[i].color) primitive.attributes["COLOR_0"] = *accessors[i].color;
    model.materials.push_back(surface_material(parts[i].name, parts[i].color));
    model.materials.back().doubleSided = true;
  }
  return model;
}

DocumentText document_text(tiny::Model model, std::string_view extras, const BinaryBuffer& buffer, Form form,
                           const base::Host& host) {
  if (!extras.empty()) require_object(extras, host);
  model.accessors = buffer.accessors();
  model.bufferViews = buffer.views();
  // tinygltf keeps no whole number of more than 32 bits, and nothing that is null or empty: extras go in as they are.
  std::string nodes;
  if (!extras.empty()) {
    for (const int node : model.scenes[0].nodes)
      nodes += (nodes.empty() ? "" : ",") + std::to_string(node);
    model.scenes.clear();
  }
  std::string text = text_of(model, host);
  mend_empty_objects(text);
  DocumentText result;
  result.before = R"({"buffers":[{"byteLength":)" + std::to_string(buffer.size());
  result.after = "}],";
  if (form == Form::gltf) {
    result.before += R"(,"uri":"data:application/octet-stream;base64,)";
    result.after = "\"}],";
  }
  if (!extras.empty())
    result.after += R"("scenes":[{"extras":)" + std::string(extras) + R"(,"nodes":[)" + nodes + "]}],";
  result.after += std::string_view(text).substr(1);
  return result;
}

}  // namespace orbicube::gltf
