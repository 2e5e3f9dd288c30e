#include "gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

#include "base/error.h"
#include "gltf/uri.h"

namespace orbicube::gltf {

namespace {

enum class Component : std::uint64_t {
  signed_8 = 5120,
  unsigned_8 = 5121,
  signed_16 = 5122,
  unsigned_16 = 5123,
  unsigned_32 = 5125,
  float_32 = 5126,
};

constexpr std::size_t elements_between_reports = std::size_t{1} << 16U;

[[noreturn]] void fail_type(JsonValue where, const std::string& what) {
  throw base::Error("accessor-type", where.path() + ' ' + what);
}

[[noreturn]] void fail_range(JsonValue where, const std::string& what) {
  throw base::Error("accessor-range", where.path() + ' ' + what);
}

Component component_of(JsonValue accessor) {
  const JsonValue given = accessor.required("componentType");
  const auto component = static_cast<Component>(given.unsigned_integer());
  switch (component) {
    case Component::signed_8:
    case Component::unsigned_8:
    case Component::signed_16:
    case Component::unsigned_16:
    case Component::unsigned_32:
    case Component::float_32:
      return component;
  }
  fail_type(given, "is " + std::to_string(given.unsigned_integer()) + ", which is no component type");
}

std::uint64_t offset_of(JsonValue description) {
  const JsonValue given = description.member("byteOffset");
  return given ? given.unsigned_integer() : 0;
}

// A run of elements whose every byte is known to be there.
struct Elements {
  const std::byte* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
};

Elements locate(Asset& asset, JsonValue description, std::uint64_t count, std::size_t element_size) {
  const BufferView view = asset.view(description.required("bufferView"));
  const std::size_t stride = view.stride == 0 ? element_size : view.stride;
  if (stride < element_size) fail_range(description, "has elements longer than the byteStride of its buffer view");
  const std::uint64_t offset = offset_of(description), size = view.bytes.size();
  // offset + (count - 1) stride + element_size <= size, without a sum or product that could overflow.
  if (count > 0 &&
      (element_size > size || offset > size - element_size || count - 1 > (size - element_size - offset) / stride)) {
    fail_range(description, "needs " + std::to_string(count) + " elements from byte " + std::to_string(offset) +
                                ", its buffer view has " + std::to_string(size) + " bytes");
  }
  return {count > 0 ? view.bytes.data() + offset : nullptr, stride, static_cast<std::size_t>(count)};
}

template <class Value>
Value value_at(const Elements& from, std::size_t element, std::size_t component = 0) {
  Value value;
  std::memcpy(&value, from.first + element * from.stride + component * sizeof value, sizeof value);
  return value;
}

// Calls visit(Value{}) with the type that the component stands for; anything else than an unsigned integer is refused.
template <class Visit>
void with_index_type(Component component, JsonValue where, const Visit& visit) {
  switch (component) {
    case Component::unsigned_8:
      return visit(std::uint8_t{});
    case Component::unsigned_16:
      return visit(std::uint16_t{});
    case Component::unsigned_32:
      return visit(std::uint32_t{});
    default:
      fail_type(where, "has indices that are not unsigned integers");
  }
}

// (element, replacement's number) for each sparse replacement of an accessor, handed to visit in order.
template <class Visit>
void visit_sparse(Asset& asset, JsonValue sparse, std::uint64_t accessor_count, const Visit& visit) {
  const std::uint64_t count = sparse.required("count").unsigned_integer();
  if (count > accessor_count) fail_range(sparse, "has more elements than its accessor");
  const JsonValue indices = sparse.required("indices");
  const Component component = component_of(indices);
  with_index_type(component, indices, [&](auto type) {
    const Elements elements = locate(asset, indices, count, sizeof type);
    for (std::size_t i = 0; i < elements.count; ++i) {
      if (i % elements_between_reports == 0) asset.host().report("reading sparse values", i, elements.count);
      const std::uint64_t element = value_at<decltype(type)>(elements, i);
      if (element >= accessor_count) {
        throw base::Error("index-range", indices.path() + " has " + std::to_string(element) + " of " +
                                             std::to_string(accessor_count) + " elements");
      }
      visit(static_cast<std::size_t>(element), i);
    }
  });
}

// The number of elements, when it is one that the file can hold: an accessor without a buffer view is all zeros and
// costs the file nothing, so that its count alone says nothing.
std::size_t checked_count(const Asset& asset, JsonValue accessor) {
  const std::uint64_t count = element_count(accessor);
  if (count == 0) throw base::Error("empty-mesh", accessor.path() + " has no elements");
  if (count > asset.stored_bytes() && !accessor.member("bufferView"))
    fail_range(accessor, "has " + std::to_string(count) + " elements, more than the file has bytes");
  return static_cast<std::size_t>(count);
}

void check_type(JsonValue accessor, std::string_view wanted) {
  const JsonValue type = accessor.required("type");
  if (type.string() != wanted) fail_type(type, "is " + in_quotes(type.string()) + ", not " + std::string(wanted));
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
void read_vectors_of(Asset& asset, JsonValue accessor, base::Array<Vector3>& result) {
  const JsonValue given = accessor.member("normalized");
  const bool normalized = given && given.boolean();
  constexpr std::size_t element_size = 3 * sizeof(Value);
  if (accessor.member("bufferView")) {
    const Elements elements = locate(asset, accessor, element_count(accessor), element_size);
    result.reserve(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
      if (i % elements_between_reports == 0) asset.host().report("reading positions", i, elements.count);
      result.push_back(vector_at<Value>(elements, i, normalized));
    }
  } else {
    result.assign(checked_count(asset, accessor), Vector3::Zero());
  }
  const JsonValue sparse = accessor.member("sparse");
  if (!sparse) return;
  const Elements values =
      locate(asset, sparse.required("values"), sparse.required("count").unsigned_integer(), element_size);
  visit_sparse(asset, sparse, result.size(), [&](std::size_t element, std::size_t replacement) {
    result[element] = vector_at<Value>(values, replacement, normalized);
  });
}

void check_finite(const Asset& asset, JsonValue accessor, const base::Array<Vector3>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    if (i % elements_between_reports == 0) asset.host().report("checking positions", i, vectors.size());
    if (!vectors[i].allFinite())
      throw base::Error("non-finite", accessor.path() + ": element " + std::to_string(i) + " is not finite");
  }
}

template <class Value>
void check_index(JsonValue accessor, Value value, std::size_t limit) {
  if (value < limit && value != std::numeric_limits<Value>::max()) return;
  throw base::Error("index-range", accessor.path() + " has the index " + std::to_string(value) + ", but there are " +
                                       std::to_string(limit) + " vertices");
}

template <class Value>
void read_indices_of(Asset& asset, JsonValue accessor, std::size_t limit, base::Array<Index>& result) {
  if (accessor.member("bufferView")) {
    const Elements elements = locate(asset, accessor, element_count(accessor), sizeof(Value));
    result.resize(elements.count);
    for (std::size_t i = 0; i < elements.count; ++i) {
      if (i % elements_between_reports == 0) asset.host().report("reading indices", i, elements.count);
      result[i] = value_at<Value>(elements, i);
    }
  } else {
    result.assign(checked_count(asset, accessor), 0);
  }
  if (const JsonValue sparse = accessor.member("sparse")) {
    const Elements values =
        locate(asset, sparse.required("values"), sparse.required("count").unsigned_integer(), sizeof(Value));
    visit_sparse(asset, sparse, result.size(), [&](std::size_t element, std::size_t replacement) {
      result[element] = value_at<Value>(values, replacement);
    });
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (i % elements_between_reports == 0) asset.host().report("checking indices", i, result.size());
    check_index(accessor, static_cast<Value>(result[i]), limit);
  }
}

}  // namespace

std::uint64_t element_count(JsonValue accessor) {
  return accessor.required("count").unsigned_integer();
}

base::Array<Vector3> read_vectors(Asset& asset, JsonValue accessor) {
  check_type(accessor, "VEC3");
  const Component component = component_of(accessor);
  checked_count(asset, accessor);
  if (component != Component::float_32 && !asset.quantized())
    fail_type(accessor, "is of integers without KHR_mesh_quantization");
  base::Array<Vector3> result(asset.host().memory);
  switch (component) {
    case Component::signed_8:
      read_vectors_of<std::int8_t>(asset, accessor, result);
      break;
    case Component::unsigned_8:
      read_vectors_of<std::uint8_t>(asset, accessor, result);
      break;
    case Component::signed_16:
      read_vectors_of<std::int16_t>(asset, accessor, result);
      break;
    case Component::unsigned_16:
      read_vectors_of<std::uint16_t>(asset, accessor, result);
      break;
    case Component::unsigned_32:
      fail_type(accessor, "is of 32-bit integers");
    case Component::float_32:
      read_vectors_of<float>(asset, accessor, result);
      break;
  }
  check_finite(asset, accessor, result);
  return result;
}

base::Array<Index> read_indices(Asset& asset, JsonValue accessor, std::size_t limit) {
  check_type(accessor, "SCALAR");
  const Component component = component_of(accessor);
  checked_count(asset, accessor);
  base::Array<Index> result(asset.host().memory);
  with_index_type(component, accessor,
                  [&](auto type) { read_indices_of<decltype(type)>(asset, accessor, limit, result); });
  return result;
}

}  // namespace orbicube::gltf
