#include "gltf/kept/attribute_blend.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "gltf/reading/accessor.h"

namespace orbicube::gltf {

namespace {

// visit(Number{}) with the type of a component.
template <class Visit>
auto with_component(int type, const Visit& visit) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return visit(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return visit(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return visit(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return visit(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return visit(std::uint32_t{});
    default:
      return visit(float{});
  }
}

// The mean of numbers as they are stored.
template <class Number>
void blend_element(const std::byte* elements, std::size_t size, const BlendedVertex& vertex, std::byte* to) {
  for (std::size_t at = 0; at < size; at += sizeof(Number)) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      Number number;
      std::memcpy(&number, elements + vertex.vertices[k] * size + at, sizeof number);
      sum += vertex.weights[k] * static_cast<double>(number);
    }
    if constexpr (std::is_integral_v<Number>) {
      sum = std::clamp(std::round(sum), static_cast<double>(std::numeric_limits<Number>::min()),
                       static_cast<double>(std::numeric_limits<Number>::max()));
    }
    const auto result = static_cast<Number>(sum);
    std::memcpy(to + at, &result, sizeof result);
  }
}

}  // namespace

base::Array<std::byte> blend(const tiny::Accessor& type, std::span<const std::byte> elements,
                             std::span<const BlendedVertex> vertices, std::pmr::memory_resource* memory) {
  const std::size_t size = element_size(type);
  const bool quantity = type.normalized || type.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  base::Array<std::byte> result(vertices.size() * size, memory);
  with_component(type.componentType, [&](auto number) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const BlendedVertex& vertex = vertices[i];
      std::byte* const to = result.data() + i * size;
      if (quantity && !vertex.single()) {
        blend_element<decltype(number)>(elements.data(), size, vertex, to);
      } else {
        const auto heaviest = std::max_element(vertex.weights.begin(), vertex.weights.end()) - vertex.weights.begin();
        std::memcpy(to, elements.data() + vertex.vertices[static_cast<std::size_t>(heaviest)] * size, size);
      }
    }
  });
  return result;
}

double component_at(const tiny::Accessor& type, const std::byte* element, std::size_t component) {
  return with_component(type.componentType, [&](auto number) {
    std::memcpy(&number, element + component * sizeof number, sizeof number);
    const auto plain = static_cast<double>(number);
    if constexpr (std::is_integral_v<decltype(number)>) {
      if (type.normalized)
        return std::max(plain / static_cast<double>(std::numeric_limits<decltype(number)>::max()), -1.0);
    }
    return plain;
  });
}

Influences blend_influences(std::span<const InfluenceSet> sets, std::span<const BlendedVertex> vertices,
                            std::pmr::memory_resource* memory) {
  Influences result{base::Array<std::uint16_t>(4 * sets.size() * vertices.size(), 0, memory),
                    base::Array<float>(4 * sets.size() * vertices.size(), 0.0F, memory)};
  std::vector<std::pair<double, std::uint16_t>> found;  // weight and joint
  found.reserve(12 * sets.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    found.clear();
    for (const InfluenceSet& set : sets) {
      for (std::size_t k = 0; k < 12; ++k) {
        const std::size_t corner = k / 4, vertex = vertices[i].vertices[corner];
        const std::byte* const joints = set.joints.data() + vertex * element_size(*set.joint_type);
        const std::byte* const weights = set.weights.data() + vertex * element_size(*set.weight_type);
        const double weight = vertices[i].weights[corner] * component_at(*set.weight_type, weights, k % 4);
        const auto joint = static_cast<std::uint16_t>(component_at(*set.joint_type, joints, k % 4));
        if (!(weight > 0)) continue;
        const auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.second == joint; });
        same == found.end() ? static_cast<void>(found.emplace_back(weight, joint))
                            : static_cast<void>(same->first += weight);
      }
    }
    // The heaviest first; of equal weights the lower joint.
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    found.resize(std::min(found.size(), 4 * sets.size()));
    double sum = 0;
    for (const auto& [weight, joint] : found)
      sum += weight;
    for (std::size_t k = 0; k < found.size(); ++k) {
      const std::size_t to = 4 * (k / 4 * vertices.size() + i) + k % 4;
      result.joints[to] = found[k].second;
      result.weights[to] = static_cast<float>(found[k].first / sum);
    }
  }
  return result;
}

}  // namespace orbicube::gltf
