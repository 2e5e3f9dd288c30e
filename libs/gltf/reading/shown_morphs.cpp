#include "gltf/reading/shown_morphs.h"

#include "base/error.h"
#include "gltf/json/uri.h"

namespace orbicube::gltf {

namespace {

std::uint64_t find_target(const tiny::Mesh& mesh, const std::string& name, const std::string& where) {
  if (mesh.extras.Has("targetNames")) {
    const tiny::Value& names = mesh.extras.Get("targetNames");
    for (std::size_t i = 0; i < names.ArrayLen(); ++i) {
      const tiny::Value& each = names.Get(static_cast<int>(i));
      if (each.IsString() && each.Get<std::string>() == name) return i;
    }
  }
  throw base::Error("missing-attribute", where + " has no morph target " + in_quotes(name));
}

}  // namespace

base::Array<Morph> morphs_of(const Asset& asset, const Placement& placement, const std::string& name) {
  const tiny::Model& model = asset.model();
  const tiny::Mesh& mesh = model.meshes[placement.mesh];
  base::Array<Morph> result(asset.host().memory);
  if (!name.empty()) {
    result.push_back({find_target(mesh, name, place_of("meshes", placement.mesh)), 1});
    return result;
  }
  const bool by_node = placement.node != no_node && !model.nodes[placement.node].weights.empty();
  const std::vector<double>& weights = by_node ? model.nodes[placement.node].weights : mesh.weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] != 0) result.push_back({i, weights[i]});
  }
  return result;
}

std::uint64_t morph_accessor(const Asset& asset, const tiny::Primitive& primitive, const Morph& morph,
                             const std::string& name, const std::string& where) {
  const bool there = morph.target < primitive.targets.size();
  if (!there && name.empty()) {
    throw base::Error(
        "parse", where + " has no morph target " + std::to_string(morph.target) + ", to which the file gives a weight");
  }
  if (there) {
    const auto position = primitive.targets[morph.target].find("POSITION");
    if (position != primitive.targets[morph.target].end()) {
      asset.accessor(position->second, where + ".targets.POSITION");
      return static_cast<std::uint64_t>(position->second);
    }
  }
  if (name.empty()) return no_accessor;
  throw base::Error("missing-attribute", where + " has no positions for the morph target " + in_quotes(name));
}

}  // namespace orbicube::gltf
