#include "gltf/kept/kept_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "base/error.h"
#include "gltf/reading/accessor.h"
#include "gltf/writing/morph_data.h"
#include "gltf/writing/normals.h"

namespace orbicube::gltf {

namespace {

int accessor_or_none(const tiny::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

bool is_influence(const std::string& name) {
  return name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
}

}  // namespace

const tiny::Primitive& KeptVertexWriter::source(const PlacedPrimitive& primitive) const {
  return scene_.kept->asset.model().meshes[primitive.from->mesh].primitives[primitive.from->primitive];
}

tiny::Primitive KeptVertexWriter::write(const PlacedPrimitive& primitive) {
  const tiny::Primitive& from = source(primitive);
  const VertexGroup& group = corners_.groups[primitive.group];
  const Shape& shape = shape_of(primitive);
  tiny::Primitive to;
  to.material = from.material;
  to.mode = TINYGLTF_MODE_TRIANGLES;
  to.extras = from.extras;
  to.extensions = from.extensions;
  to.extensions.erase("KHR_draco_mesh_compression");
  to.attributes["POSITION"] = shape.position;
  if (shape.normal >= 0) to.attributes["NORMAL"] = shape.normal;
  to.targets = shape.targets;
  for (const auto& [name, accessor] : from.attributes) {
    if (name == "POSITION" || name == "NORMAL" || is_influence(name)) continue;
    if (name == "TANGENT") {
      if (const int tangents = tangents_of(primitive, accessor); tangents >= 0) to.attributes[name] = tangents;
    } else {
      to.attributes[name] = blended(primitive, accessor);
    }
  }
  add_influences(primitive, to);
  if (!to.attributes.contains("TEXCOORD_0") && !scene_.texture_coordinates.empty())
    to.attributes["TEXCOORD_0"] = buffer_.add_floats(gathered(primitive, scene_.texture_coordinates, 2), 2, false);
  to.indices =
      buffer_.add_indices({primitive.triangles.front().data(), 3 * primitive.triangles.size()}, group.vertices.size());
  return to;
}

base::Array<float> KeptVertexWriter::gathered(const PlacedPrimitive& primitive, std::span<const float> of_surface,
                                              std::size_t components) const {
  const VertexGroup& group = corners_.groups[primitive.group];
  base::Array<float> result(host_.memory);
  result.reserve(components * group.surface_vertex.size());
  for (const mesh::Index v : group.surface_vertex) {
    if (std::size_t{v} >= of_surface.size() / components)
      throw base::Error("invalid-argument", "there are fewer positions than the surface that was read has");
    result.insert(result.end(), of_surface.begin() + static_cast<std::ptrdiff_t>(components * v),
                  of_surface.begin() + static_cast<std::ptrdiff_t>(components * (v + std::size_t{1})));
  }
  return result;
}

const base::Array<float>& KeptVertexWriter::smooth_normals_of(std::size_t state) {
  const auto found = smooth_.find(state);
  if (found != smooth_.end()) return found->second;
  const std::span<const float> positions = state == 0 ? scene_.positions : scene_.morph_targets[state - 1].positions;
  return smooth_.emplace(state, smooth_normals(positions, scene_.triangles, host_)).first->second;
}

const KeptVertexWriter::Shape& KeptVertexWriter::shape_of(const PlacedPrimitive& primitive) {
  const std::pair key(primitive.group, accessor_or_none(source(primitive), "NORMAL"));
  const auto found = shapes_.find(key);
  if (found != shapes_.end()) return found->second;
  Shape shape{};
  base::Array<float> positions = gathered(primitive, scene_.positions, 3);
  base::Array<float> normals = normals_of(primitive);
  for (std::size_t i = 0; i < scene_.morph_targets.size(); ++i) {
    std::map<std::string, int>& target = shape.targets.emplace_back();
    target["POSITION"] = buffer_.add_floats(
        deltas_of(positions, gathered(primitive, scene_.morph_targets[i].positions, 3), host_), 3, true);
    if (!scene_.morph_normals || normals.empty()) continue;
    target["NORMAL"] =
        buffer_.add_floats(deltas_of(normals, gathered(primitive, smooth_normals_of(i + 1), 3), host_), 3, false);
  }
  shape.position = buffer_.add_floats(std::move(positions), 3, true);
  shape.normal = normals.empty() ? -1 : buffer_.add_floats(std::move(normals), 3, false);
  return shapes_.emplace(key, std::move(shape)).first->second;
}

// Vectors as numbers, blended, not placed.
base::Array<float> KeptVertexWriter::kept_vectors(const PlacedPrimitive& primitive, int accessor,
                                                  std::size_t components) const {
  const Kept& kept = *scene_.kept;
  const auto number = static_cast<std::size_t>(accessor);
  const tiny::Accessor& type = kept.asset.model().accessors[number];
  const std::size_t size = element_size(type);
  base::Array<float> result(host_.memory);
  if (static_cast<std::size_t>(tiny::GetNumComponentsInType(static_cast<std::uint32_t>(type.type))) != components ||
      type.count != primitive.from->vertex_count)
    return result;
  const base::Array<std::byte> elements = read_elements(kept.asset, number);
  for (const BlendedVertex& vertex : corners_.groups[primitive.group].vertices) {
    for (std::size_t c = 0; c < components; ++c) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += vertex.weights[k] * component_at(type, elements.data() + vertex.vertices[k] * size, c);
      result.push_back(static_cast<float>(sum));
    }
  }
  return result;
}

// Those of the file as they are placed; smooth ones where it has none, or none for some vertex.
base::Array<float> KeptVertexWriter::normals_of(const PlacedPrimitive& primitive) {
  base::Array<float> smooth(host_.memory);
  if (scene_.smooth_normals) smooth = gathered(primitive, smooth_normals_of(0), 3);
  const int accessor = accessor_or_none(source(primitive), "NORMAL");
  if (accessor < 0) return smooth;
  base::Array<float> normals = kept_vectors(primitive, accessor, 3);
  if (normals.empty()) return smooth;
  const Eigen::Matrix3d to_world =
      primitive.from->to_world.linear().inverse().transpose() * (primitive.turned ? -1 : 1);
  for (std::size_t at = 0; at < normals.size(); at += 3) {
    Eigen::Map<Eigen::Vector3f> normal(normals.data() + at);
    Eigen::Vector3d placed = to_world * normal.cast<double>();
    placed.stableNormalize();
    if (placed.allFinite() && placed.squaredNorm() > 0.5) {
      normal = placed.cast<float>();
    } else if (!smooth.empty()) {
      normal = Eigen::Map<const Eigen::Vector3f>(smooth.data() + at);
    } else {
      normal = Eigen::Vector3f::UnitZ();
    }
  }
  return normals;
}

int KeptVertexWriter::tangents_of(const PlacedPrimitive& primitive, int accessor) {
  if (accessor_or_none(source(primitive), "NORMAL") < 0 || primitive.turned) return -1;
  base::Array<float> tangents = kept_vectors(primitive, accessor, 4);
  for (std::size_t at = 0; at < tangents.size(); at += 4) {
    Eigen::Map<Eigen::Vector3f> tangent(tangents.data() + at);
    Eigen::Vector3d placed = primitive.from->to_world.linear() * tangent.cast<double>();
    placed.stableNormalize();
    if (!placed.allFinite() || !(placed.squaredNorm() > 0.5)) return -1;
    tangent = placed.cast<float>();
    const bool mirrored = primitive.from->mirrored != (tangents[at + 3] < 0);
    tangents[at + 3] = mirrored ? -1.0F : 1.0F;
  }
  return tangents.empty() ? -1 : buffer_.add_floats(std::move(tangents), 4, false);
}

int KeptVertexWriter::blended(const PlacedPrimitive& primitive, int accessor) {
  const auto [found, added] = blended_.emplace(std::pair(primitive.group, accessor), 0);
  if (!added) return found->second;
  const Kept& kept = *scene_.kept;
  const auto number = static_cast<std::size_t>(accessor);
  tiny::Accessor type = kept.asset.model().accessors[number];
  if (type.count != primitive.from->vertex_count)
    throw base::Error("accessor-range",
                      place_of("accessors", number) + " has another number of elements than positions");
  const base::Array<std::byte> elements = read_elements(kept.asset, number);
  type.minValues.clear();
  type.maxValues.clear();
  found->second = buffer_.add_elements(blend(type, elements, corners_.groups[primitive.group].vertices, host_.memory),
                                       type, BinaryBuffer::Target::vertices);
  return found->second;
}

// Joints and weights: as they are where every vertex is one of the file's.
void KeptVertexWriter::add_influences(const PlacedPrimitive& primitive, tiny::Primitive& to) {
  const tiny::Primitive& from = source(primitive);
  const auto& vertices = corners_.groups[primitive.group].vertices;
  if (std::all_of(vertices.begin(), vertices.end(), [](const BlendedVertex& v) { return v.single(); })) {
    for (const auto& [name, accessor] : from.attributes) {
      if (is_influence(name)) to.attributes[name] = blended(primitive, accessor);
    }
    return;
  }
  Kept const& kept = *scene_.kept;
  std::vector<base::Array<std::byte>> elements;
  std::vector<InfluenceSet> sets;
  for (std::size_t i = 0;; ++i) {
    const int joints = accessor_or_none(from, "JOINTS_" + std::to_string(i));
    const int weights = accessor_or_none(from, "WEIGHTS_" + std::to_string(i));
    if (joints < 0 || weights < 0) break;
    const tiny::Accessor& joint_type = kept.asset.model().accessors[static_cast<std::size_t>(joints)];
    const tiny::Accessor& weight_type = kept.asset.model().accessors[static_cast<std::size_t>(weights)];
    for (const tiny::Accessor* type : {&joint_type, &weight_type}) {
      if (type->count != primitive.from->vertex_count || type->type != TINYGLTF_TYPE_VEC4)
        throw base::Error("accessor-type", "joints or weights of a primitive are not four for each vertex");
    }
    elements.push_back(read_elements(kept.asset, static_cast<std::size_t>(joints)));
    elements.push_back(read_elements(kept.asset, static_cast<std::size_t>(weights)));
    sets.push_back({&joint_type, &weight_type, {}, {}});
  }
  for (std::size_t i = 0; i < sets.size(); ++i) {
    sets[i].joints = elements[2 * i];
    sets[i].weights = elements[2 * i + 1];
  }
  const Influences influences = blend_influences(sets, vertices, host_.memory);
  const std::size_t each = 4 * vertices.size();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    tiny::Accessor joint_type;
    joint_type.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    joint_type.type = TINYGLTF_TYPE_VEC4;
    const auto joint_bytes = std::as_bytes(std::span(influences.joints).subspan(i * each, each));
    base::Array<std::byte> joints(joint_bytes.begin(), joint_bytes.end(), host_.memory);
    to.attributes["JOINTS_" + std::to_string(i)] =
        buffer_.add_elements(std::move(joints), joint_type, BinaryBuffer::Target::vertices);
    const auto weights = std::span(influences.weights).subspan(i * each, each);
    to.attributes["WEIGHTS_" + std::to_string(i)] =
        buffer_.add_floats(base::Array<float>(weights.begin(), weights.end(), host_.memory), 4, false);
  }
}

}  // namespace orbicube::gltf
