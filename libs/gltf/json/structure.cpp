#include "gltf/json/structure.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "base/counted.h"
#include "base/error.h"
#include "gltf/json/compressed_view.h"
#include "gltf/json/uri.h"

namespace orbicube::gltf {

namespace {

enum class ValueForm : std::uint8_t {
  index,           // into an array: 0 to 2^31 - 1
  indices,         // an array of them
  index_map,       // an object of them
  index_maps,      // an array of such objects
  size,            // in bytes or elements
  small_size,      // which tinygltf holds in 32 bits
  numbers,         // an array of them, `count` long where that is not 0
  text,            // a string
  boolean,         // true or false
  component_type,  // one of 5.1.3 of the specification
  accessor_type,   // one of 5.1.6
  object,          // with members of its own
  objects,         // an array of them
};

// A member of an object. `kind` is of the error for a number beyond its range.
struct Rule {
  std::string_view name;
  ValueForm form;
  bool required = false;
  const char* kind = "parse";
  std::span<const Rule> members{};
  std::size_t count = 0;
};

constexpr bool required = true, optional = false;

constexpr std::array sparse_indices = {Rule{"bufferView", ValueForm::index, required},
                                       Rule{"byteOffset", ValueForm::small_size, optional, "accessor-range"},
                                       Rule{"componentType", ValueForm::component_type, required}};
constexpr std::array sparse_values = {Rule{"bufferView", ValueForm::index, required},
                                      Rule{"byteOffset", ValueForm::small_size, optional, "accessor-range"}};
constexpr std::array sparse = {Rule{"count", ValueForm::small_size, required, "accessor-range"},
                               Rule{"indices", ValueForm::object, required, "parse", sparse_indices},
                               Rule{"values", ValueForm::object, required, "parse", sparse_values}};
constexpr std::array accessor = {Rule{"bufferView", ValueForm::index},
                                 Rule{"byteOffset", ValueForm::size, optional, "accessor-range"},
                                 Rule{"normalized", ValueForm::boolean},
                                 Rule{"componentType", ValueForm::component_type, required},
                                 Rule{"count", ValueForm::size, required, "accessor-range"},
                                 Rule{"type", ValueForm::accessor_type, required},
                                 Rule{"sparse", ValueForm::object, optional, "parse", sparse}};
constexpr std::array buffer_view = {Rule{"buffer", ValueForm::index, required},
                                    Rule{"byteOffset", ValueForm::size, optional, "accessor-range"},
                                    Rule{"byteLength", ValueForm::size, required, "accessor-range"},
                                    Rule{"byteStride", ValueForm::small_size, optional, "accessor-range"}};
constexpr std::array buffer = {Rule{"byteLength", ValueForm::size, required, "truncated"},
                               Rule{"uri", ValueForm::text}};
constexpr std::array primitive = {Rule{"attributes", ValueForm::index_map, required, "index-range"},
                                  Rule{"indices", ValueForm::index, optional, "index-range"},
                                  Rule{"mode", ValueForm::index},
                                  Rule{"targets", ValueForm::index_maps, optional, "index-range"}};
constexpr std::array mesh = {Rule{"primitives", ValueForm::objects, required, "parse", primitive},
                             Rule{"weights", ValueForm::numbers}};
constexpr std::array node = {Rule{"mesh", ValueForm::index, optional, "index-range"},
                             Rule{"skin", ValueForm::index, optional, "index-range"},
                             Rule{"children", ValueForm::indices, optional, "index-range"},
                             Rule{"matrix", ValueForm::numbers, optional, "parse", {}, 16},
                             Rule{"translation", ValueForm::numbers, optional, "parse", {}, 3},
                             Rule{"rotation", ValueForm::numbers, optional, "parse", {}, 4},
                             Rule{"scale", ValueForm::numbers, optional, "parse", {}, 3},
                             Rule{"weights", ValueForm::numbers}};
constexpr std::array scene = {Rule{"nodes", ValueForm::indices, optional, "index-range"}};
constexpr std::array document_rules = {Rule{"accessors", ValueForm::objects, optional, "parse", accessor},
                                       Rule{"bufferViews", ValueForm::objects, optional, "parse", buffer_view},
                                       Rule{"buffers", ValueForm::objects, optional, "parse", buffer},
                                       Rule{"meshes", ValueForm::objects, optional, "parse", mesh},
                                       Rule{"nodes", ValueForm::objects, optional, "parse", node},
                                       Rule{"scenes", ValueForm::objects, optional, "parse", scene},
                                       Rule{"scene", ValueForm::index, optional, "index-range"}};

void check_members(JsonValue object, std::span<const Rule> rules);

void check_whole(JsonValue value, std::uint64_t largest, const char* kind) {
  if (const std::uint64_t given = value.unsigned_integer(); given > largest) {
    throw base::Error(kind, value.path() + " is " + std::to_string(given) + ", more than any file has");
  }
}

void check_index_map(JsonValue value, const char* kind) {
  constexpr std::uint64_t largest = std::numeric_limits<std::int32_t>::max();
  value.for_each_member([&](std::string_view, JsonValue index) { check_whole(index, largest, kind); });
}

void check_numbers(JsonValue value, std::size_t count) {
  value.for_each_element([](JsonValue number) { number.number(); });
  if (count > 0 && value.size() != count)
    throw base::Error("parse", value.path() + " does not have " + base::counted(count, "number"));
}

void check_component_type(JsonValue value) {
  const std::uint64_t type = value.unsigned_integer();
  if (type < 5120 || type > 5126 || type == 5124)
    throw base::Error("accessor-type", value.path() + " is " + std::to_string(type) + ", which is no component type");
}

void check_accessor_type(JsonValue value) {
  constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  if (std::find(types.begin(), types.end(), value.string()) == types.end())
    throw base::Error("accessor-type", value.path() + " is " + in_quotes(value.string()) + ", which is no type");
}

void check_value(JsonValue value, const Rule& rule) {
  constexpr std::uint64_t largest = std::numeric_limits<std::int32_t>::max();
  switch (rule.form) {
    case ValueForm::index:
    case ValueForm::small_size:
      return check_whole(value, largest, rule.kind);
    case ValueForm::indices:
      return value.for_each_element([&](JsonValue index) { check_whole(index, largest, rule.kind); });
    case ValueForm::index_map:
      return check_index_map(value, rule.kind);
    case ValueForm::index_maps:
      return value.for_each_element([&](JsonValue map) { check_index_map(map, rule.kind); });
    case ValueForm::size:
      return check_whole(value, std::numeric_limits<std::ptrdiff_t>::max(), rule.kind);
    case ValueForm::numbers:
      return check_numbers(value, rule.count);
    case ValueForm::text:
      return static_cast<void>(value.string());
    case ValueForm::boolean:
      return static_cast<void>(value.boolean());
    case ValueForm::component_type:
      return check_component_type(value);
    case ValueForm::accessor_type:
      return check_accessor_type(value);
    case ValueForm::object:
      return check_members(value, rule.members);
    case ValueForm::objects:
      return value.for_each_element([&](JsonValue element) { check_members(element, rule.members); });
  }
}

// Of members that an object has several times, each one.
void check_members(JsonValue object, std::span<const Rule> rules) {
  object.for_each_member([&](std::string_view name, JsonValue value) {
    for (const Rule& rule : rules) {
      if (rule.name == name) check_value(value, rule);
    }
  });
  for (const Rule& rule : rules) {
    if (rule.required) object.required(rule.name);
  }
}

// Required extensions that say nothing about positions and triangles, or that the reader knows.
bool is_known_extension(std::string_view name) {
  constexpr std::array<std::string_view, 9> known = {
      "KHR_mesh_quantization", "KHR_texture_transform", "KHR_texture_basisu",
      "KHR_lights_punctual",   "KHR_animation_pointer", "KHR_xmp_json_ld",
      "EXT_texture_webp",      "EXT_texture_avif",      "MSFT_texture_dds"};
  if (name == compression_extension) return version_of_meshoptimizer() != 0;
  return name.starts_with("KHR_materials_") || std::find(known.begin(), known.end(), name) != known.end();
}

void check_version(JsonValue root) {
  const JsonValue asset = root.required("asset");
  for (const char* name : {"version", "minVersion"}) {
    const JsonValue version = asset.member(name);
    if (!version) continue;
    const std::string_view text = version.string();
    const std::size_t point = text.find('.');
    const auto is_number = [](std::string_view part) {
      return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
    };
    if (point == std::string_view::npos || !is_number(text.substr(0, point)) || !is_number(text.substr(point + 1)))
      throw base::Error("parse", version.path() + " is not of the form 2.0");
    if (text.substr(0, point) != "2" || (name == std::string_view("minVersion") && text != "2.0"))
      throw base::Error("unsupported-version", version.path() + " is " + in_quotes(text) + ", not 2.0");
  }
  asset.required("version");
}

void check_extensions(JsonValue root) {
  for (const char* name : {"extensionsRequired", "extensionsUsed"}) {
    const JsonValue names = root.member(name);
    if (!names) continue;
    names.for_each_element([&](JsonValue extension) {
      if (!is_known_extension(extension.string()) && name == std::string_view("extensionsRequired"))
        throw base::Error("unsupported-extension", "the file requires " + in_quotes(extension.string()));
    });
  }
}

}  // namespace

void check_structure(JsonValue root) {
  check_version(root);
  check_extensions(root);
  check_members(root, document_rules);
}

}  // namespace orbicube::gltf
