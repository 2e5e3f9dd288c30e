#include "gltf/kept/kept.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "gltf/kept/kept_images.h"
#include "gltf/kept/kept_writer.h"
#include "gltf/reading/accessor.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/weld.h"

namespace orbicube::gltf {

namespace {

using mesh::Index;
using mesh::Triangle;

// Indices that may be missing, where they are -1.
class References {
 public:
  explicit References(const tiny::Model& model) : model_(model) {}

  void check() const {
    for (std::size_t i = 0; i < model_.meshes.size(); ++i)
      check_mesh(model_.meshes[i], place_of("meshes", i));
    for (std::size_t i = 0; i < model_.nodes.size(); ++i)
      check_node(model_.nodes[i], place_of("nodes", i));
    for (std::size_t i = 0; i < model_.materials.size(); ++i)
      check_material(model_.materials[i], place_of("materials", i));
    for (std::size_t i = 0; i < model_.textures.size(); ++i) {
      optional(model_.textures[i].source, model_.images.size(), "images", place_of("textures", i) + ".source");
      optional(model_.textures[i].sampler, model_.samplers.size(), "samplers", place_of("textures", i) + ".sampler");
    }
    for (std::size_t i = 0; i < model_.skins.size(); ++i)
      check_skin(model_.skins[i], place_of("skins", i));
    for (std::size_t i = 0; i < model_.animations.size(); ++i)
      check_animation(model_.animations[i], place_of("animations", i));
    for (std::size_t i = 0; i < model_.scenes.size(); ++i) {
      for (const int node : model_.scenes[i].nodes)
        require_index(node, model_.nodes.size(), "nodes", place_of("scenes", i) + ".nodes");
    }
  }

 private:
  static void optional(int index, std::size_t count, const char* array, const std::string& where) {
    if (index != -1) require_index(index, count, array, where);
  }

  void accessors(const std::map<std::string, int>& attributes, const std::string& where) const {
    for (const auto& [name, accessor] : attributes)
      require_index(accessor, model_.accessors.size(), "accessors", where + '.' + name);
  }

  void check_mesh(const tiny::Mesh& mesh, const std::string& where) const {
    for (const tiny::Primitive& primitive : mesh.primitives) {
      accessors(primitive.attributes, where);
      for (const auto& target : primitive.targets)
        accessors(target, where + ".targets");
      optional(primitive.indices, model_.accessors.size(), "accessors", where + ".indices");
      optional(primitive.material, model_.materials.size(), "materials", where + ".material");
    }
  }

  void check_node(const tiny::Node& node, const std::string& where) const {
    optional(node.mesh, model_.meshes.size(), "meshes", where + ".mesh");
    optional(node.skin, model_.skins.size(), "skins", where + ".skin");
    optional(node.camera, model_.cameras.size(), "cameras", where + ".camera");
    for (const int child : node.children)
      require_index(child, model_.nodes.size(), "nodes", where + ".children");
  }

  void check_material(const tiny::Material& material, const std::string& where) const {
    for (const int texture :
         {material.pbrMetallicRoughness.baseColorTexture.index,
          material.pbrMetallicRoughness.metallicRoughnessTexture.index, material.normalTexture.index,
          material.occlusionTexture.index, material.emissiveTexture.index})
      optional(texture, model_.textures.size(), "textures", where);
  }

  void check_skin(const tiny::Skin& skin, const std::string& where) const {
    optional(skin.inverseBindMatrices, model_.accessors.size(), "accessors", where + ".inverseBindMatrices");
    optional(skin.skeleton, model_.nodes.size(), "nodes", where + ".skeleton");
    for (const int joint : skin.joints)
      require_index(joint, model_.nodes.size(), "nodes", where + ".joints");
    if (skin.inverseBindMatrices < 0) return;
    const tiny::Accessor& matrices = model_.accessors[static_cast<std::size_t>(skin.inverseBindMatrices)];
    if (matrices.type != TINYGLTF_TYPE_MAT4 || matrices.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT ||
        matrices.count < skin.joints.size())
      throw base::Error("accessor-type", where + ".inverseBindMatrices has not a matrix of floats for each joint");
  }

  void check_animation(const tiny::Animation& animation, const std::string& where) const {
    for (const tiny::AnimationChannel& channel : animation.channels) {
      require_index(channel.sampler, animation.samplers.size(), "samplers", where + ".channels");
      optional(channel.target_node, model_.nodes.size(), "nodes", where + ".channels");
    }
    for (const tiny::AnimationSampler& sampler : animation.samplers) {
      require_index(sampler.input, model_.accessors.size(), "accessors", where + ".samplers");
      require_index(sampler.output, model_.accessors.size(), "accessors", where + ".samplers");
    }
  }

  const tiny::Model& model_;
};

// Attributes have one element for each vertex, which is finite.
void check_attributes(Asset& asset, const KeptPrimitive& placed) {
  const tiny::Model& model = asset.model();
  const std::string where = place_of("meshes", placed.mesh) + '.' + place_of("primitives", placed.primitive);
  for (const auto& [name, number] : model.meshes[placed.mesh].primitives[placed.primitive].attributes) {
    const auto index = static_cast<std::size_t>(number);
    const tiny::Accessor& accessor = model.accessors[index];
    if (accessor.count != placed.vertex_count)
      throw base::Error("accessor-range", where + '.' + name + " has another number of elements than POSITION");
    if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || name == "POSITION") continue;
    const base::Array<std::byte> elements = read_elements(asset, index);
    for (std::size_t at = 0; at < elements.size(); at += sizeof(float)) {
      float value = 0;
      std::memcpy(&value, elements.data() + at, sizeof value);
      if (!std::isfinite(value)) throw base::Error("non-finite", where + '.' + name + " is not finite");
    }
  }
}

}  // namespace

Kept::Kept(base::Array<std::byte> bytes, std::optional<std::filesystem::path> folder, const base::Host& host)
    : file(std::move(bytes)),
      asset(file, std::move(folder), Extent::everything, host),
      primitives(host.memory),
      triangles(host.memory),
      surface_vertex(host.memory),
      add_scene(&add_kept_scene) {}

void keep_corners(Kept& kept, const mesh::Mesh& surface) {
  kept.triangles = surface.triangles;
  kept.surface_vertex.resize(surface.positions.size());
  for (std::size_t v = 0; v < surface.positions.size(); ++v)
    kept.surface_vertex[v] = static_cast<Index>(v);
}

void weld_corners(Kept& kept, const mesh::Mesh& surface, const base::Host& host) {
  base::Array<Index>& to = kept.surface_vertex;
  to = mesh::first_at_same_position(surface.positions, host);
  Index count = 0;
  for (std::size_t v = 0; v < to.size(); ++v)
    to[v] = to[v] == v ? count++ : to[to[v]];
  const auto collapses = [&](const Triangle& t) {
    return !mesh::has_repeated_corner(t) && mesh::has_repeated_corner({to[t[0]], to[t[1]], to[t[2]]});
  };
  std::size_t next = 0;
  for (KeptPrimitive& primitive : kept.primitives) {
    const auto first = kept.triangles.begin() + static_cast<std::ptrdiff_t>(primitive.first_triangle);
    const auto end = first + static_cast<std::ptrdiff_t>(primitive.triangle_count);
    primitive.first_triangle = next;
    primitive.triangle_count -= static_cast<std::size_t>(std::count_if(first, end, collapses));
    next += primitive.triangle_count;
  }
  kept.triangles.erase(std::remove_if(kept.triangles.begin(), kept.triangles.end(), collapses), kept.triangles.end());
}

void check_kept(const Kept& kept) {
  Asset& asset = kept.asset;
  const tiny::Model& model = asset.model();
  References(model).check();
  for (std::size_t i = 0; i < model.bufferViews.size(); ++i)
    asset.view(static_cast<int>(i), "");
  for (std::size_t i = 0; i < model.accessors.size(); ++i)
    check_range(asset, i);
  for (std::size_t i = 0; i < model.images.size(); ++i)
    check_image(kept, model.images[i], place_of("images", i));
  for (const KeptPrimitive& primitive : kept.primitives)
    check_attributes(asset, primitive);
}

}  // namespace orbicube::gltf
