#include "gltf/json/tiny_document.h"

#include <cmath>
#include <cstdint>
#include <string_view>

namespace orbicube::gltf {

namespace {

TinyJson number_of(double number) {
  constexpr double exact = 9007199254740992.0;  // 2^53
  const bool whole = std::abs(number) <= exact && number == std::floor(number);
  if (!whole || (number == 0 && std::signbit(number))) return number;
  if (number < 0) return static_cast<std::int64_t>(number);
  return static_cast<std::uint64_t>(number);
}

}  // namespace

TinyJson tiny_value(JsonValue value, std::size_t max_depth) {
  switch (value.kind()) {
    case JsonKind::null:
      return nullptr;
    case JsonKind::boolean:
      return value.boolean();
    case JsonKind::whole_number:
      return value.unsigned_integer();
    case JsonKind::number:
      return number_of(value.number());
    case JsonKind::string:
      return std::string(value.string());
    case JsonKind::array:
    case JsonKind::object:
      break;
  }
  if (max_depth == 0) return nullptr;
  if (value.kind() == JsonKind::array) {
    TinyJson result(TinyJson::value_t::array);
    auto& elements = result.get_ref<TinyJson::array_t&>();
    elements.reserve(value.size());
    value.for_each_element([&](JsonValue element) { elements.push_back(tiny_value(element, max_depth - 1)); });
    return result;
  }
  TinyJson result(TinyJson::value_t::object);
  auto& members = result.get_ref<TinyJson::object_t&>();
  value.for_each_member(
      [&](std::string_view name, JsonValue member) { members[std::string(name)] = tiny_value(member, max_depth - 1); });
  return result;
}

}  // namespace orbicube::gltf
