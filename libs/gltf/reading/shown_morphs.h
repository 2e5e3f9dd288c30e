// Which morph targets of a mesh count in the surface that a file shows.
#pragma once

#include <cstdint>
#include <string>

#include "base/array.h"
#include "gltf/json/asset.h"
#include "gltf/reading/scene.h"

namespace orbicube::gltf {

// A morph target: its place among those of its mesh, and how much of it.
struct Morph {
  std::uint64_t target;
  double weight;
};

inline constexpr std::uint64_t no_accessor = UINT64_MAX;

// The target of that name, in full; without a name, those to which the node, or else the mesh, gives a weight, in
// ascending order. Throws Error "missing-attribute" where the mesh has no target of that name.
base::Array<Morph> morphs_of(const Asset& asset, const Placement& placement, const std::string& name);

// The accessor of a target's positions for a primitive. A target that has none, but normals say, has no_accessor unless
// it is requested by name. Throws Error "missing-attribute" then, "parse" for a weight without a target, "index-range".
std::uint64_t morph_accessor(const Asset& asset, const tiny::Primitive& primitive, const Morph& morph,
                             const std::string& name, const std::string& where);

}  // namespace orbicube::gltf
