// The document of a written glTF file: what its one buffer holds and how it is shown.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gltf/json/model.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/parts.h"
#include "gltf/writing/write.h"

namespace orbicube::gltf {

// Numbers of accessors of a morph target.
struct TargetAccessors {
  int position;
  std::optional<int> normal;
};

// Numbers of accessors, and of the texture's view, in the buffer.
struct SceneAccessors {
  int position = 0, triangles = 0;
  std::optional<int> normal, tangent, texture_coordinate, color, edges, texture_view, animation_times,
      animation_weights;
  std::vector<TargetAccessors> targets;
};

// Numbers of accessors of a part.
struct PartAccessors {
  int position, normal, triangles;
  std::optional<int> color;
};

// The models of a scene and of parts, without what is in the buffer.
tiny::Model model_of(const Scene& scene, const SceneAccessors& accessors);
tiny::Model model_of(std::span<const Part> parts, std::span<const PartAccessors> accessors);

// Pieces of models, for those of other files (kept_writer.h).
std::string generator();
void add_animation(tiny::Model& model, std::span<const int> nodes, int times, int weights);
void set_target_names(tiny::Mesh& mesh, std::span<const MorphTarget> targets);
void place_node(tiny::Node& node, const mesh::Vector3& translation, double scale);
tiny::Material surface_material(const std::string& name, const std::array<double, 4>& color);
// Adds image, sampler and texture for a view of the buffer, and shows it as the base color of the material.
void add_texture(tiny::Model& model, tiny::Material& material, int view);

// A document in two halves, between which the characters of its buffer belong in a .gltf.
struct DocumentText {
  std::string before, after;
};

// The text of a model with views and accessors of the buffer. `extras` is a JSON object for its one scene, or empty.
// Throws Error "invalid-argument" when the extras are no JSON object or a text is not UTF-8.
DocumentText document_text(tiny::Model model, std::string_view extras, const BinaryBuffer& buffer, Form form,
                           const base::Host& host);

}  // namespace orbicube::gltf
