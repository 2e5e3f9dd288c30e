#include "gltf/reading/surface_colors.h"

#include <cmath>
#include <string>

#include "gltf/kept/attribute_blend.h"
#include "gltf/reading/accessor.h"

namespace orbicube::gltf {
namespace {

Wrap wrap_of(int mode) {
  return mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? Wrap::clamp
         : mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Wrap::mirror
                                                         : Wrap::repeat;
}

double number_in(const tiny::Value& object, const char* name, std::size_t place, double otherwise) {
  if (!object.IsObject() || !object.Has(name)) return otherwise;
  const tiny::Value& value = object.Get(name);
  if (value.IsNumber()) return value.GetNumberAsDouble();
  if (!value.IsArray() || place >= value.ArrayLen()) return otherwise;
  const tiny::Value& element = value.Get(static_cast<int>(place));
  return element.IsNumber() ? element.GetNumberAsDouble() : otherwise;
}

// The extension KHR_texture_transform: scaled, then rotated, then moved.
class TextureTransform {
 public:
  explicit TextureTransform(const tiny::TextureInfo& texture) {
    const auto found = texture.extensions.find("KHR_texture_transform");
    if (found == texture.extensions.end()) return;
    for (std::size_t k = 0; k < 2; ++k) {
      offset_[k] = number_in(found->second, "offset", k, 0);
      scale_[k] = number_in(found->second, "scale", k, 1);
    }
    const double angle = number_in(found->second, "rotation", 0, 0);
    cosine_ = std::cos(angle);
    sine_ = std::sin(angle);
    set_ = static_cast<int>(number_in(found->second, "texCoord", 0, -1));
  }

  int set_or(int otherwise) const { return set_ < 0 ? otherwise : set_; }
  std::array<double, 2> apply(const std::array<double, 2>& at) const {
    const double u = scale_[0] * at[0], v = scale_[1] * at[1];
    return {offset_[0] + cosine_ * u + sine_ * v, offset_[1] - sine_ * u + cosine_ * v};
  }

 private:
  std::array<double, 2> offset_{0, 0}, scale_{1, 1};
  double cosine_ = 1, sine_ = 0;
  int set_ = -1;
};

std::span<const std::byte> bytes_of(const Kept& kept, const tiny::Image& image) {
  return image.uri.empty() ? kept.asset.view(image.bufferView, "an image").bytes
                           : kept.asset.bytes_of_uri(image.uri, "an image");
}

ColorMaterial color_material(const Kept& kept, const tiny::Material& from) {
  const tiny::Model& model = kept.asset.model();
  ColorMaterial material;
  for (std::size_t k = 0; k < 3 && k < from.pbrMetallicRoughness.baseColorFactor.size(); ++k)
    material.factor[k] = from.pbrMetallicRoughness.baseColorFactor[k];
  const int number = from.pbrMetallicRoughness.baseColorTexture.index;
  if (number < 0) return material;
  const tiny::Texture& texture = model.textures[static_cast<std::size_t>(number)];
  if (texture.source >= 0) material.image = bytes_of(kept, model.images[static_cast<std::size_t>(texture.source)]);
  if (texture.sampler >= 0) {
    const tiny::Sampler& sampler = model.samplers[static_cast<std::size_t>(texture.sampler)];
    material.wrap = {wrap_of(sampler.wrapS), wrap_of(sampler.wrapT)};
  }
  return material;
}

// An attribute of the vertices of a primitive, or none.
struct Attribute {
  Attribute(const Kept& kept, const tiny::Primitive& primitive, const std::string& name)
      : elements(kept.asset.host().memory) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return;
    type = &kept.asset.model().accessors[static_cast<std::size_t>(found->second)];
    elements = read_elements(kept.asset, static_cast<std::size_t>(found->second));
  }

  template <std::size_t N>
  void read(std::size_t vertex, std::array<double, N>& values) const {
    if (type == nullptr) return;
    const std::size_t size = element_size(*type);
    if ((vertex + 1) * size > elements.size()) return;
    for (std::size_t k = 0; k < N; ++k)
      values[k] = component_at(*type, elements.data() + vertex * size, k);
  }

  const tiny::Accessor* type = nullptr;
  base::Array<std::byte> elements;
};

void add_primitive(const Kept& kept, const KeptPrimitive& primitive, SurfaceColors& colors) {
  const tiny::Model& model = kept.asset.model();
  const tiny::Primitive& from = model.meshes[primitive.mesh].primitives[primitive.primitive];
  const bool has_material = from.material >= 0;
  const tiny::TextureInfo texture =
      has_material ? model.materials[static_cast<std::size_t>(from.material)].pbrMetallicRoughness.baseColorTexture
                   : tiny::TextureInfo();
  const TextureTransform transform(texture);
  const Attribute coordinates(kept, from, "TEXCOORD_" + std::to_string(transform.set_or(texture.texCoord))),
      shades(kept, from, "COLOR_0");
  for (std::size_t t = primitive.first_triangle; t < primitive.first_triangle + primitive.triangle_count; ++t) {
    // The last material is the one of primitives without any.
    colors.triangle_materials[t] =
        static_cast<std::uint32_t>(has_material ? static_cast<std::size_t>(from.material) : model.materials.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t vertex = kept.triangles[t][k] - primitive.first_vertex;
      std::array<double, 2> at{};
      coordinates.read(vertex, at);
      colors.coordinates[t][k] = transform.apply(at);
      shades.read(vertex, colors.vertex_colors[t][k]);
    }
  }
}

}  // namespace

SurfaceColors surface_colors(const Kept& kept, const base::Host& host) {
  SurfaceColors colors(host.memory);
  for (const tiny::Material& material : kept.asset.model().materials)
    colors.materials.push_back(color_material(kept, material));
  colors.materials.emplace_back();
  const std::size_t triangles = kept.triangles.size();
  colors.triangle_materials.resize(triangles);
  colors.coordinates.resize(triangles);
  colors.vertex_colors.assign(triangles, {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}});
  for (const KeptPrimitive& primitive : kept.primitives) {
    host.report("colors", 0, 0);
    add_primitive(kept, primitive, colors);
  }
  return colors;
}

}  // namespace orbicube::gltf
