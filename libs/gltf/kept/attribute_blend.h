// Attributes of vertices that lie on the triangles of a primitive, from those of its own vertices.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "base/array.h"
#include "gltf/json/tiny.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// A place on a triangle: three vertices with weights that sum up to 1. One of weight 1 is that vertex.
struct BlendedVertex {
  std::array<mesh::Index, 3> vertices;
  std::array<double, 3> weights;

  bool single() const { return weights[0] == 1; }
};

// The elements of an attribute, stored one behind the other as `type` says, at these places: those of single vertices
// to the bit, others as the weighted mean, rounded where they are integers. Of attributes whose integers are not
// normalized, and which therefore stand for no quantity, those of the vertex with the largest weight.
base::Array<std::byte> blend(const tiny::Accessor& type, std::span<const std::byte> elements,
                             std::span<const BlendedVertex> vertices, std::pmr::memory_resource* memory);

// A number of an element as glTF means it: c / 255 for normalized bytes, and so on.
double component_at(const tiny::Accessor& type, const std::byte* element, std::size_t component);

// Joints and weights of vertices at such places, for each set of four: the heaviest influences of all their vertices.
// Adds up to 1 again.
struct Influences {
  base::Array<std::uint16_t> joints;  // four a vertex and set, set by set
  base::Array<float> weights;
};
struct InfluenceSet {
  const tiny::Accessor *joint_type, *weight_type;
  std::span<const std::byte> joints, weights;
};
Influences blend_influences(std::span<const InfluenceSet> sets, std::span<const BlendedVertex> vertices,
                            std::pmr::memory_resource* memory);

}  // namespace orbicube::gltf
