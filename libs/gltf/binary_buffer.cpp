#include "gltf/binary_buffer.h"

#include <limits>
#include <utility>

namespace orbicube::gltf {

std::uint64_t BinaryBuffer::add_view(std::span<const std::byte> bytes, Target target) {
  views_.push_back({size_, bytes.size(), target});
  pieces_.push_back(bytes);
  size_ += (bytes.size() + 3) / 4 * 4;
  return views_.size() - 1;
}

std::uint64_t BinaryBuffer::add_accessor(Accessor accessor) {
  accessors_.push_back(std::move(accessor));
  return accessors_.size() - 1;
}

std::uint64_t BinaryBuffer::add_floats(std::span<const float> values, std::size_t components, bool with_bounds,
                                       Target target) {
  const std::uint64_t view = add_view(std::as_bytes(values), target);
  Accessor accessor{view, Component::float_32, false, values.size() / components, components, {}, {}};
  if (with_bounds) {
    accessor.smallest.assign(components, std::numeric_limits<double>::infinity());
    accessor.largest.assign(components, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < values.size(); ++i) {
      double &smallest = accessor.smallest[i % components], &largest = accessor.largest[i % components];
      smallest = std::min(smallest, static_cast<double>(values[i]));
      largest = std::max(largest, static_cast<double>(values[i]));
    }
  }
  return add_accessor(std::move(accessor));
}

std::uint64_t BinaryBuffer::add_floats(base::Array<float>&& values, std::size_t components, bool with_bounds,
                                       Target target) {
  floats_.push_back(std::move(values));
  return add_floats(std::span<const float>(floats_.back()), components, with_bounds, target);
}

std::uint64_t BinaryBuffer::add_colors(std::span<const std::uint8_t> values) {
  const std::uint64_t view = add_view(std::as_bytes(values), Target::vertices);
  return add_accessor({view, Component::unsigned_8, true, values.size() / 4, 4, {}, {}});
}

std::uint64_t BinaryBuffer::add_indices(std::span<const mesh::Index> values, std::size_t vertex_count) {
  // The largest value of a type would mean primitive restart, so that 65535 is no index of 16 bits.
  if (vertex_count > std::numeric_limits<std::uint16_t>::max()) {
    const std::uint64_t view = add_view(std::as_bytes(values), Target::indices);
    return add_accessor({view, Component::unsigned_32, false, values.size(), 1, {}, {}});
  }
  auto& stored = short_indices_.emplace_back(values.size());
  std::transform(values.begin(), values.end(), stored.begin(),
                 [](mesh::Index index) { return static_cast<std::uint16_t>(index); });
  const std::uint64_t view = add_view(std::as_bytes(std::span(stored)), Target::indices);
  return add_accessor({view, Component::unsigned_16, false, values.size(), 1, {}, {}});
}

}  // namespace orbicube::gltf
