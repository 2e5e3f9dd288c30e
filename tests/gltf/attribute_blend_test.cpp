// Attributes of vertices between those of a file.
#include "gltf/kept/attribute_blend.h"

#include <doctest/doctest.h>

#include <vector>

using namespace orbicube;

TEST_CASE("Influences of new vertices are the heaviest of their corners', and sum up to one") {
  gltf::tiny::Accessor joint_type, weight_type;
  joint_type.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
  weight_type.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
  joint_type.type = weight_type.type = TINYGLTF_TYPE_VEC4;
  const std::vector<std::uint8_t> joints = {0, 1, 2, 3, 4, 5, 6, 7, 0, 9, 0, 0};
  const std::vector<float> weights = {0.5F, 0.25F, 0.125F, 0.125F, 0.5F, 0.25F, 0.125F, 0.125F, 0.75F, 0.25F, 0, 0};
  const gltf::InfluenceSet set{&joint_type, &weight_type, std::as_bytes(std::span(joints)),
                               std::as_bytes(std::span(weights))};
  const gltf::BlendedVertex vertex{{0, 1, 2}, {0.25, 0.25, 0.5}};
  const gltf::Influences influences = gltf::blend_influences({&set, 1}, {&vertex, 1}, std::pmr::get_default_resource());
  // 0: 0.125 + 0.375, 4: 0.125, 9: 0.125, then 1: 0.0625 before 5: 0.0625.
  CHECK(influences.joints == base::Array<std::uint16_t>{0, 4, 9, 1});
  const double sum = 0.5 + 0.125 + 0.125 + 0.0625;
  CHECK(influences.weights[0] == static_cast<float>(0.5 / sum));
  CHECK(influences.weights[3] == static_cast<float>(0.0625 / sum));
}

TEST_CASE("Quantities are interpolated and rounded, numbers of things are taken from the nearest vertex") {
  gltf::tiny::Accessor type;
  type.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
  type.type = TINYGLTF_TYPE_SCALAR;
  const std::vector<std::uint8_t> values = {10, 20, 41};
  const std::vector<gltf::BlendedVertex> vertices = {{{2, 2, 2}, {1, 0, 0}}, {{0, 1, 2}, {0.25, 0.25, 0.5}}};
  const auto blended = [&] {
    const auto bytes = gltf::blend(type, std::as_bytes(std::span(values)), vertices, std::pmr::get_default_resource());
    return std::vector<int>{std::to_integer<int>(bytes[0]), std::to_integer<int>(bytes[1])};
  };
  CHECK(blended() == std::vector<int>{41, 41});
  type.normalized = true;
  CHECK(blended() == std::vector<int>{41, 28});
}
