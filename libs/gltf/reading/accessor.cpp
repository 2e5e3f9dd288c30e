#include "gltf/reading/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::gltf {

namespace {

constexpr std::size_t elements_between_reports = std::size_t{1} << 16U;

std::string place(std::size_t accessor) {
  return place_of("accessors", accessor);
}

[[noreturn]] void fail_type(std::size_t accessor, const std::string& what) {
  throw base::Error("accessor-type", place(accessor) + ' ' + what);
}

[[noreturn]] void fail_range(const std::string& where, const std::string& what) {
  throw base::Error("accessor-range", where + ' ' + what);
}

const tiny::Accessor& description(const Asset& asset, std::size_t accessor) {
  return asset.model().accessors[accessor];
}

// A run of elements whose every byte is known to be there.
struct Elements {
  const std::byte* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

Elements locate(Asset& asset, int buffer_view, std::uint64_t offset, std::uint64_t count, std::size_t element_size,
                const std::string& where) {
  const BufferView view = asset.view(buffer_view, where);
  const std::size_t stride = view.stride == 0 ? element_size : view.stride;
  if (stride < element_size) fail_range(where, "has elements longer than the byteStride of its buffer view");
  const std::uint64_t size = view.bytes.size();
  // offset + (count - 1) stride + element_size <= size, without a sum or product that could overflow.
  if (count > 0 &&
      (element_size > size || offset > size - element_size || count - 1 > (size - element_size - offset) / stride)) {
    fail_range(where, "needs " + base::counted(count, "element") + " from byte " + std::to_string(offset) +
                          ", its buffer view has " + base::counted(size, "byte"));
  }
  return {count > 0 ? view.bytes.data() + offset : nullptr, stride, static_cast<std::size_t>(count)};
}

Elements locate(Asset& asset, std::size_t accessor, std::size_t element_size) {
  const tiny::Accessor& from = description(asset, accessor);
  return locate(asset, from.bufferView, from.byteOffset, from.count, element_size, place(accessor));
}

template <class Value>
Value value_at(const Elements& from, std::size_t element, std::size_t component = 0) {
  Value value;
  std::memcpy(&value, from.first + element * from.stride + component * sizeof value, sizeof value);
  return value;
}

// Calls visit(Value{}) with the type that the component stands for; anything else than an unsigned integer is refused.
template <class Visit>
void with_index_type(int component, std::size_t accessor, const Visit& visit) {
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return visit(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return visit(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return visit(std::uint32_t{});
    default:
      fail_type(accessor, "has indices that are not unsigned integers");
  }
}

// The sparse replacements of an accessor; none where it has none.
struct Replacements {
  Elements values;
  base::Array<std::size_t> elements;  // that the values are for
};

Replacements replacements_of(Asset& asset, std::size_t accessor, std::size_t element_size) {
  const tiny::Accessor& from = description(asset, accessor);
  Replacements result{{}, base::Array<std::size_t>(asset.host().memory)};
  if (!from.sparse.isSparse) return result;
  const std::string where = place(accessor) + ".sparse";
  const auto count = static_cast<std::uint64_t>(from.sparse.count);
  if (from.sparse.count < 0 || count > from.count) fail_range(where, "has more elements than its accessor");
  const auto& values = from.sparse.values;
  const auto& indices = from.sparse.indices;
  result.values = locate(asset, values.bufferView, static_cast<std::uint64_t>(values.byteOffset), count, element_size,
                         where + ".values");
  with_index_type(indices.componentType, accessor, [&](auto type) {
    const Elements elements = locate(asset, indices.bufferView, static_cast<std::uint64_t>(indices.byteOffset), count,
                                     sizeof type, where + ".indices");
    result.elements.resize(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i)
      result.elements[i] = value_at<decltype(type)>(elements, i);
  });
  for (std::size_t i = 0; i < result.elements.size(); ++i) {
    if (i % elements_between_reports == 0) asset.host().report("reading sparse values", i, result.elements.size());
    if (result.elements[i] >= from.count) {
      throw base::Error("index-range", where + ".indices has " + std::to_string(result.elements[i]) + " of " +
                                           base::counted(from.count, "element"));
    }
  }
  return result;
}

// visit(element, bytes of its replacement) for each sparse replacement of an accessor, in order.
template <class Visit>
void visit_sparse(Asset& asset, std::size_t accessor, std::size_t element_size, const Visit& visit) {
  const Replacements replacements = replacements_of(asset, accessor, element_size);
  for (std::size_t i = 0; i < replacements.elements.size(); ++i)
    visit(replacements.elements[i], replacements.values, i);
}

// The number of elements, when it is one that the file can hold: an accessor without a buffer view is all zeros and
// costs the file nothing, so that its count alone says nothing.
std::size_t checked_count(const Asset& asset, std::size_t accessor) {
  const tiny::Accessor& from = description(asset, accessor);
  if (from.count == 0) throw base::Error("empty-mesh", place(accessor) + " has no elements");
  if (from.bufferView < 0 && from.count > asset.stored_bytes())
    fail_range(place(accessor), "has " + base::counted(from.count, "element") + ", more than the file has bytes");
  return from.count;
}

void check_type(const Asset& asset, std::size_t accessor, int target, const char* name) {
  if (description(asset, accessor).type != target) fail_type(accessor, std::string("is not of type ") + name);
}

// KHR_mesh_quantization: signed c -> max(c / 127, -1), unsigned c -> c / 255, and so on for 16 bits.
template <class Value>
double component_value(Value value, bool normalized) {
  const double plain = static_cast<double>(value);
  if constexpr (std::is_integral_v<Value>) {
    if (normalized) return std::max(plain / static_cast<double>(std::numeric_limits<Value>::max()), -1.0);
  }
  return plain;
}

template <class Value>
Vector3 vector_at(const Elements& from, std::size_t element, bool normalized) {
  return {component_value(value_at<Value>(from, element, 0), normalized),
          component_value(value_at<Value>(from, element, 1), normalized),
          component_value(value_at<Value>(from, element, 2), normalized)};
}

template <class Value>
void read_vectors_of(Asset& asset, std::size_t accessor, base::Array<Vector3>& result) {
  const tiny::Accessor& from = description(asset, accessor);
  constexpr std::size_t size = 3 * sizeof(Value);
  if (from.bufferView >= 0) {
    const Elements elements = locate(asset, accessor, size);
    result.reserve(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
      if (i % elements_between_reports == 0) asset.host().report("reading positions", i, elements.count);
      result.push_back(vector_at<Value>(elements, i, from.normalized));
    }
  } else {
    result.assign(checked_count(asset, accessor), Vector3::Zero());
  }
  visit_sparse(asset, accessor, size, [&](std::size_t element, const Elements& values, std::size_t replacement) {
    result[element] = vector_at<Value>(values, replacement, from.normalized);
  });
}

void check_finite(const Asset& asset, std::size_t accessor, const base::Array<Vector3>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (i % elements_between_reports == 0) asset.host().report("checking positions", i, vectors.size());
    if (!vectors[i].allFinite())
      throw base::Error("non-finite", place(accessor) + ": element " + std::to_string(i) + " is not finite");
  }
}

template <class Value>
void check_index(std::size_t accessor, Value value, std::size_t limit) {
  if (value < limit && value != std::numeric_limits<Value>::max()) return;
  throw base::Error("index-range", place(accessor) + " has the index " + std::to_string(value) + ", but there are " +
                                       base::counted(limit, "vertex", "vertices"));
}

template <class Value>
void read_indices_of(Asset& asset, std::size_t accessor, std::size_t limit, base::Array<Index>& result) {
  if (description(asset, accessor).bufferView >= 0) {
    const Elements elements = locate(asset, accessor, sizeof(Value));
    result.resize(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
      if (i % elements_between_reports == 0) asset.host().report("reading indices", i, elements.count);
      result[i] = value_at<Value>(elements, i);
    }
  } else {
    result.assign(checked_count(asset, accessor), 0);
  }
  visit_sparse(asset, accessor, sizeof(Value),
               [&](std::size_t element, const Elements& values, std::size_t replacement) {
                 result[element] = value_at<Value>(values, replacement);
               });
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (i % elements_between_reports == 0) asset.host().report("checking indices", i, result.size());
    check_index(accessor, static_cast<Value>(result[i]), limit);
  }
}

}  // namespace

std::uint64_t element_count(const Asset& asset, std::size_t accessor) {
  return description(asset, accessor).count;
}

base::Array<Vector3> read_vectors(Asset& asset, std::size_t accessor) {
  check_type(asset, accessor, TINYGLTF_TYPE_VEC3, "VEC3");
  const int component = description(asset, accessor).componentType;
  checked_count(asset, accessor);
  if (component != TINYGLTF_COMPONENT_TYPE_FLOAT && !asset.quantized())
    fail_type(accessor, "is of integers without KHR_mesh_quantization");
  base::Array<Vector3> result(asset.host().memory);
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      read_vectors_of<std::int8_t>(asset, accessor, result);
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      read_vectors_of<std::uint8_t>(asset, accessor, result);
      break;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      read_vectors_of<std::int16_t>(asset, accessor, result);
      break;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      read_vectors_of<std::uint16_t>(asset, accessor, result);
      break;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      read_vectors_of<float>(asset, accessor, result);
      break;
    default:
      fail_type(accessor, "is of 32-bit integers");
  }
  check_finite(asset, accessor, result);
  return result;
}

base::Array<Index> read_indices(Asset& asset, std::size_t accessor, std::size_t limit) {
  check_type(asset, accessor, TINYGLTF_TYPE_SCALAR, "SCALAR");
  checked_count(asset, accessor);
  base::Array<Index> result(asset.host().memory);
  with_index_type(description(asset, accessor).componentType, accessor,
                  [&](auto type) { read_indices_of<decltype(type)>(asset, accessor, limit, result); });
  return result;
}

std::size_t element_size(const tiny::Accessor& accessor) {
  // check_structure has refused all other types.
  return static_cast<std::size_t>(tiny::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)) *
                                  tiny::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

base::Array<std::byte> read_elements(Asset& asset, std::size_t accessor) {
  const std::size_t size = element_size(description(asset, accessor)), count = checked_count(asset, accessor);
  base::Array<std::byte> result(asset.host().memory);
  const auto copy = [&](const Elements& from, std::size_t element, std::size_t to) {
    std::memcpy(result.data() + to * size, from.first + element * from.stride, size);
  };
  if (description(asset, accessor).bufferView >= 0) {
    const Elements elements = locate(asset, accessor, size);
    result.resize(count * size);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % elements_between_reports == 0) asset.host().report("reading attributes", i, count);
      copy(elements, i, i);
    }
  } else {
    result.resize(count * size);
  }
  visit_sparse(asset, accessor, size, [&](std::size_t element, const Elements& values, std::size_t replacement) {
    copy(values, replacement, element);
  });
  return result;
}

void check_range(Asset& asset, std::size_t accessor) {
  const std::size_t size = element_size(description(asset, accessor));
  checked_count(asset, accessor);
  if (description(asset, accessor).bufferView >= 0) locate(asset, accessor, size);
  replacements_of(asset, accessor, size);
}

}  // namespace orbicube::gltf
