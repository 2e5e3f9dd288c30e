#include "gltf/writing/binary_buffer.h"

#include <cstring>
#include <limits>
#include <utility>

#include "gltf/reading/accessor.h"

namespace orbicube::gltf {

int BinaryBuffer::add_view(std::span<const std::byte> bytes, Target target, std::size_t stride) {
  tiny::BufferView& view = views_.emplace_back();
  view.buffer = 0;
  view.byteOffset = static_cast<std::size_t>(size_);
  view.byteLength = bytes.size();
  view.byteStride = stride;
  view.target = static_cast<int>(target);
  pieces_.push_back(bytes);
  size_ += (bytes.size() + 3) / 4 * 4;
  return static_cast<int>(views_.size() - 1);
}

int BinaryBuffer::add_accessor(int view, int component_type, std::size_t components, std::size_t count) {
  constexpr std::array types = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4};
  tiny::Accessor& accessor = accessors_.emplace_back();
  accessor.bufferView = view;
  accessor.componentType = component_type;
  accessor.type = types[components - 1];
  accessor.count = count;
  return static_cast<int>(accessors_.size() - 1);
}

int BinaryBuffer::add_floats(std::span<const float> values, std::size_t components, bool with_bounds, Target target) {
  const int view = add_view(std::as_bytes(values), target);
  const int number = add_accessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, components, values.size() / components);
  if (with_bounds) {
    tiny::Accessor& accessor = accessors_.back();
    accessor.minValues.assign(components, std::numeric_limits<double>::infinity());
    accessor.maxValues.assign(components, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < values.size(); ++i) {
      double &smallest = accessor.minValues[i % components], &largest = accessor.maxValues[i % components];
      smallest = std::min(smallest, static_cast<double>(values[i]));
      largest = std::max(largest, static_cast<double>(values[i]));
    }
  }
  return number;
}

int BinaryBuffer::add_floats(base::Array<float>&& values, std::size_t components, bool with_bounds, Target target) {
  floats_.push_back(std::move(values));
  return add_floats(std::span<const float>(floats_.back()), components, with_bounds, target);
}

int BinaryBuffer::add_colors(std::span<const std::uint8_t> values) {
  const int view = add_view(std::as_bytes(values), Target::vertices);
  const int number = add_accessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, 4, values.size() / 4);
  accessors_.back().normalized = true;
  return number;
}

int BinaryBuffer::add_indices(std::span<const mesh::Index> values, std::size_t vertex_count) {
  // The largest value of a type would mean primitive restart, so that 65535 is no index of 16 bits.
  if (vertex_count > std::numeric_limits<std::uint16_t>::max()) {
    const int view = add_view(std::as_bytes(values), Target::indices);
    return add_accessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, 1, values.size());
  }
  auto& stored = short_indices_.emplace_back(values.size());
  std::transform(values.begin(), values.end(), stored.begin(),
                 [](mesh::Index index) { return static_cast<std::uint16_t>(index); });
  const int view = add_view(std::as_bytes(std::span(stored)), Target::indices);
  return add_accessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, 1, values.size());
}

int BinaryBuffer::add_elements(base::Array<std::byte>&& elements, const tiny::Accessor& like, Target target) {
  const std::size_t size = element_size(like), stride = target == Target::vertices ? (size + 3) / 4 * 4 : size;
  const std::size_t count = elements.size() / size;
  base::Array<std::byte>& stored = elements_.emplace_back();
  if (stride == size) {
    stored = std::move(elements);
  } else {
    stored.resize(count * stride);
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(stored.data() + i * stride, elements.data() + i * size, size);
  }
  tiny::Accessor& accessor = accessors_.emplace_back();
  accessor.bufferView = add_view(stored, target, stride == size ? 0 : stride);
  accessor.componentType = like.componentType;
  accessor.type = like.type;
  accessor.normalized = like.normalized;
  accessor.count = count;
  accessor.minValues = like.minValues;
  accessor.maxValues = like.maxValues;
  return static_cast<int>(accessors_.size() - 1);
}

}  // namespace orbicube::gltf
