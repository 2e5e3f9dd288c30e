#include "gltf/kept/kept_writer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "gltf/json/document.h"
#include "gltf/json/uri.h"
#include "gltf/kept/kept_corners.h"
#include "gltf/kept/kept_images.h"
#include "gltf/kept/kept_vertices.h"
#include "gltf/reading/accessor.h"
#include "gltf/reading/scene.h"
#include "gltf/writing/morph_data.h"

namespace orbicube::gltf {

namespace {

constexpr std::size_t matrix_numbers = 16;

// The model of the file without its meshes, views and accessors.
tiny::Model model_without_meshes(const tiny::Model& from) {
  tiny::Model model = from;
  model.meshes.clear();
  model.accessors.clear();
  model.bufferViews.clear();
  model.buffers.clear();
  model.asset.version = "2.0";
  model.asset.generator = generator();
  return model;
}

class SceneWriter {
 public:
  SceneWriter(BinaryBuffer& buffer, const Scene& scene, const base::Host& host)
      : buffer_(buffer),
        scene_(scene),
        kept_(*scene.kept),
        host_(host),
        model_(model_without_meshes(kept_.asset.model())),
        corners_(place_corners(scene, host)) {}

  tiny::Model write() {
    find_bound_nodes();
    remove_meshes();
    add_meshes();
    add_skins();
    add_animations();
    add_images(buffer_, kept_, false, model_);
    return std::move(model_);
  }

 private:
  const tiny::Model& source() const { return kept_.asset.model(); }

  // Nodes keep everything else.
  void remove_meshes() {
    for (tiny::Node& node : model_.nodes) {
      node.mesh = node.skin = -1;
      node.weights.clear();
    }
  }

  // One mesh for each node that shows some of the surface.
  void add_meshes() {
    // In the order of the file, in which they are read again.
    std::vector<std::vector<const PlacedPrimitive*>> shown;
    for (const PlacedPrimitive& primitive : corners_.primitives) {
      const bool goes_on = !shown.empty() && shown.back().front()->from->node == primitive.from->node &&
                           shown.back().front()->from->mesh == primitive.from->mesh;
      if (!goes_on) shown.emplace_back();
      shown.back().push_back(&primitive);
    }
    const bool stay = std::all_of(shown.begin(), shown.end(),
                                  [&](const auto& primitives) { return may_stay(*primitives.front()->from); });
    KeptVertexWriter vertices(buffer_, scene_, corners_, host_);
    std::vector<int> nodes;
    for (const auto& primitives : shown) {
      const int mesh = static_cast<int>(model_.meshes.size());
      tiny::Mesh& to = model_.meshes.emplace_back(source().meshes[primitives.front()->from->mesh]);
      to.primitives.clear();
      to.weights.clear();
      remove_target_names(to);
      if (!scene_.morph_targets.empty()) set_target_names(to, scene_.morph_targets);
      for (const PlacedPrimitive* primitive : primitives) {
        tiny::Primitive written = vertices.write(*primitive);
        if (written.material < 0) written.material = scene_material();
        to.primitives.push_back(std::move(written));
      }
      nodes.push_back(stay ? node_in_place(*primitives.front()->from, mesh)
                           : new_node(*primitives.front()->from, mesh));
    }
    if (scene_.morph_seconds > 0) {
      const AnimationAccessors animation = gltf::add_animation(buffer_, scene_, host_);
      gltf::add_animation(model_, nodes, animation.times, animation.weights);
    }
  }

  static void remove_target_names(tiny::Mesh& mesh) {
    if (!mesh.extras.Has("targetNames")) return;
    auto extras = mesh.extras.Get<tiny::Value::Object>();
    extras.erase("targetNames");
    mesh.extras = extras.empty() ? tiny::Value() : tiny::Value(std::move(extras));
  }

  // What the scene gives to primitives without a material.
  int scene_material() {
    if (!scene_material_) {
      tiny::Material material = surface_material("surface", scene_.base_color);
      if (!scene_.texture.empty())
        add_texture(model_, material, buffer_.add_view(scene_.texture, BinaryBuffer::Target::none));
      scene_material_ = static_cast<int>(model_.materials.size());
      model_.materials.push_back(std::move(material));
    }
    return *scene_material_;
  }

  // Whether a mesh may stay with its node: where the node's transform does not count, or may be replaced.
  bool may_stay(const KeptPrimitive& from) const {
    return from.node != no_node && (from.skinned || !is_bound_[from.node]);
  }

  void add_skin(tiny::Node& node, const KeptPrimitive& from) {
    node.skin = source().nodes[from.node].skin;
    moved_skins_.insert(node.skin);
  }

  int node_in_place(const KeptPrimitive& from, int mesh) {
    tiny::Node& node = model_.nodes[from.node];
    node.mesh = mesh;
    from.skinned ? add_skin(node, from) : place_node(node, scene_.translation, scene_.scale);
    return static_cast<int>(from.node);
  }

  // A node of its own at the root of the scene.
  int new_node(const KeptPrimitive& from, int mesh) {
    tiny::Node& node = model_.nodes.emplace_back();
    node.name = model_.meshes[static_cast<std::size_t>(mesh)].name;
    node.mesh = mesh;
    from.skinned ? add_skin(node, from) : place_node(node, scene_.translation, scene_.scale);
    if (model_.scenes.empty()) {
      model_.scenes.emplace_back();
      model_.defaultScene = 0;
      for (std::size_t root = 0; root < is_child_.size(); ++root) {
        if (!is_child_[root]) model_.scenes[0].nodes.push_back(static_cast<int>(root));
      }
    }
    const auto shown = static_cast<std::size_t>(std::max(model_.defaultScene, 0));
    model_.scenes[shown].nodes.push_back(static_cast<int>(model_.nodes.size() - 1));
    return static_cast<int>(model_.nodes.size() - 1);
  }

  // Finds the nodes of which more than their mesh depends on where they stand.
  void find_bound_nodes() {
    const std::vector<tiny::Node>& nodes = source().nodes;
    is_child_.assign(nodes.size(), false);
    is_bound_.assign(nodes.size(), false);
    const auto bind = [&](int node) {
      if (node >= 0) is_bound_[static_cast<std::size_t>(node)] = true;
    };
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].children.empty() || nodes[i].camera >= 0 || !nodes[i].extensions.empty()) is_bound_[i] = true;
      for (const int child : nodes[i].children) {
        is_child_[static_cast<std::size_t>(child)] = true;
        bind(child);
      }
    }
    for (const tiny::Skin& skin : source().skins) {
      bind(skin.skeleton);
      for (const int joint : skin.joints)
        bind(joint);
    }
    for (const tiny::Animation& animation : source().animations) {
      for (const tiny::AnimationChannel& channel : animation.channels) {
        if (channel.target_path != "weights") bind(channel.target_node);
      }
    }
  }

  // Inverse bind matrices take positions as they are stored to where the skin has them.
  void add_skins() {
    const bool moved = scene_.translation != mesh::Vector3::Zero() || scene_.scale != 1;
    for (std::size_t i = 0; i < model_.skins.size(); ++i) {
      tiny::Skin& skin = model_.skins[i];
      const bool to_move = moved && moved_skins_.contains(static_cast<int>(i));
      if (skin.inverseBindMatrices < 0 && !to_move) continue;
      tiny::Accessor like;
      like.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
      like.type = TINYGLTF_TYPE_MAT4;
      base::Array<float> matrices(host_.memory);
      if (skin.inverseBindMatrices >= 0) {
        const base::Array<std::byte> elements =
            read_elements(kept_.asset, static_cast<std::size_t>(skin.inverseBindMatrices));
        matrices.resize(elements.size() / sizeof(float));
        std::memcpy(matrices.data(), elements.data(), elements.size());
      } else {
        for (std::size_t k = 0; k < skin.joints.size() * matrix_numbers; ++k)
          matrices.push_back(k % matrix_numbers % 5 == 0 ? 1.0F : 0.0F);
      }
      if (to_move) place_matrices(matrices);
      base::Array<std::byte> elements(matrices.size() * sizeof(float), host_.memory);
      std::memcpy(elements.data(), matrices.data(), elements.size());
      skin.inverseBindMatrices = buffer_.add_elements(std::move(elements), like, BinaryBuffer::Target::none);
    }
  }

  // Multiplies each with the scene's placement, on the right.
  void place_matrices(base::Array<float>& matrices) const {
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
    placement.translation() = scene_.translation;
    placement.linear() *= scene_.scale;
    for (std::size_t at = 0; at + matrix_numbers <= matrices.size(); at += matrix_numbers) {
      Eigen::Map<Eigen::Matrix4f> matrix(matrices.data() + at);
      matrix = (matrix.cast<double>() * placement.matrix()).eval().cast<float>();
    }
  }

  // All but those of the weights of morph targets, which are others now.
  void add_animations() {
    std::map<int, int> written;
    const auto accessor = [&](int number) {
      const auto [found, added] = written.emplace(number, 0);
      if (added) {
        const auto index = static_cast<std::size_t>(number);
        found->second = buffer_.add_elements(read_elements(kept_.asset, index), source().accessors[index],
                                             BinaryBuffer::Target::none);
      }
      return found->second;
    };
    std::vector<tiny::Animation> animations;
    for (std::size_t i = 0; i < model_.animations.size(); ++i) {
      tiny::Animation& animation = model_.animations[i];
      if (i < source().animations.size()) {
        std::erase_if(animation.channels, [](const auto& channel) { return channel.target_path == "weights"; });
        if (animation.channels.empty()) continue;
        drop_unused_samplers(animation);
        for (tiny::AnimationSampler& sampler : animation.samplers) {
          sampler.input = accessor(sampler.input);
          sampler.output = accessor(sampler.output);
        }
      }
      animations.push_back(std::move(animation));
    }
    model_.animations = std::move(animations);
  }

  static void drop_unused_samplers(tiny::Animation& animation) {
    std::vector<int> number(animation.samplers.size(), -1);
    std::vector<tiny::AnimationSampler> used;
    for (tiny::AnimationChannel& channel : animation.channels) {
      int& to = number[static_cast<std::size_t>(channel.sampler)];
      if (to < 0) {
        to = static_cast<int>(used.size());
        used.push_back(animation.samplers[static_cast<std::size_t>(channel.sampler)]);
      }
      channel.sampler = to;
    }
    animation.samplers = std::move(used);
  }

  BinaryBuffer& buffer_;
  const Scene& scene_;
  const Kept& kept_;
  const base::Host& host_;
  tiny::Model model_;
  PlacedCorners corners_;
  std::optional<int> scene_material_;
  std::set<int> moved_skins_;
  std::vector<bool> is_child_, is_bound_;
};

}  // namespace

tiny::Model add_kept_scene(BinaryBuffer& buffer, const Scene& scene, const base::Host& host) {
  return SceneWriter(buffer, scene, host).write();
}

tiny::Model add_kept_file(BinaryBuffer& buffer, const Kept& kept) {
  tiny::Model model = kept.asset.model();
  model.buffers.clear();
  model.asset.version = "2.0";
  model.asset.generator = generator();
  std::erase_if(model.animations, [](const tiny::Animation& animation) { return animation.channels.empty(); });
  for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
    const tiny::BufferView& view = model.bufferViews[i];
    const BufferView from = kept.asset.view(static_cast<int>(i), "");
    buffer.add_view(from.bytes, static_cast<BinaryBuffer::Target>(view.target), view.byteStride);
  }
  for (const tiny::Accessor& accessor : model.accessors)
    buffer.add_described(accessor);
  add_images(buffer, kept, true, model);
  return model;
}

}  // namespace orbicube::gltf
