#include "gltf/json/model.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

#include "base/counted.h"
#include "base/error.h"
#include "gltf/json/json_memory.h"
#include "gltf/json/tiny_document.h"

namespace orbicube::gltf {

namespace {

constexpr std::size_t max_depth = 64;  // of values that are kept; tinygltf recurses, and copies values at each level

// Those that a surface is read from.
constexpr std::array<std::string_view, 9> surface_members = {
    "asset", "extensionsUsed", "extensionsRequired", "accessors", "bufferViews", "meshes", "nodes", "scenes", "scene"};

bool is_of_surface(std::string_view name) {
  return std::find(surface_members.begin(), surface_members.end(), name) != surface_members.end();
}

// One byte for a buffer, which may have any number in its URI.
TinyJson byte_as_buffer() {
  TinyJson result(TinyJson::value_t::object);
  result["byteLength"] = 1U;
  result["uri"] = "data:application/octet-stream;base64,AA==";
  return result;
}

// An image of which nothing can be opened or decoded.
TinyJson image_without_bytes(JsonValue image) {
  if (image.kind() != JsonKind::object) return nullptr;
  TinyJson result(TinyJson::value_t::object);
  image.for_each_member([&](std::string_view name, JsonValue value) {
    if (name != "uri" && name != "bufferView" && name != "mimeType")
      result[std::string(name)] = tiny_value(value, max_depth);
  });
  result["uri"] = "-";
  return result;
}

// tinygltf refuses strides that are no multiple of 4.
TinyJson view_without_stride(JsonValue view) {
  TinyJson result = tiny_value(view, max_depth);
  if (result.is_object()) result.erase("byteStride");
  return result;
}

// tinygltf refuses indices without a buffer view.
TinyJson accessor_with_view(JsonValue accessor) {
  TinyJson result = tiny_value(accessor, max_depth);
  if (result.is_object()) result.emplace("bufferView", 0U);
  return result;
}

template <class Convert>
TinyJson converted(JsonValue array, const Convert& convert) {
  TinyJson result(TinyJson::value_t::array);
  array.for_each_element([&](JsonValue element) { result.push_back(convert(element)); });
  return result;
}

// The document as tinygltf may read it. Asset and `restore` put in what is missing then.
TinyJson values_for_tinygltf(JsonValue root, Extent extent) {
  TinyJson result(TinyJson::value_t::object);
  const JsonValue views = root.member("bufferViews");
  const bool has_views = views && views.size() > 0;
  root.for_each_member([&](std::string_view name, JsonValue value) {
    if (extent == Extent::surface && name != "buffers" && !is_of_surface(name)) return;
    TinyJson& to = result[std::string(name)];
    if (name == "buffers") {
      to = converted(value, [](JsonValue) { return byte_as_buffer(); });
    } else if (name == "bufferViews") {
      to = converted(value, view_without_stride);
    } else if (name == "accessors" && has_views) {
      to = converted(value, accessor_with_view);
    } else if (name == "images" && value.kind() == JsonKind::array) {
      to = converted(value, image_without_bytes);
    } else {
      to = tiny_value(value, max_depth);
    }
  });
  return result;
}

// An element costs three bytes of a text, and a kilobyte or two of the model.
void check_size(JsonValue root, std::size_t text_size) {
  constexpr std::uint64_t most_without_reason = std::uint64_t{1} << 28U, each = 2048, per_byte = 64;
  std::uint64_t elements = 0;
  root.for_each_member([&](std::string_view, JsonValue value) {
    if (value.kind() == JsonKind::array) elements += value.size();
  });
  if (elements * each > most_without_reason + per_byte * text_size)
    throw base::Error("unsupported", "the document has " + base::counted(elements, "nearly empty object"));
}

void require_same_count(std::size_t in_model, JsonValue in_document, const std::string& what) {
  if (in_model != (in_document ? in_document.size() : 0))
    throw base::Error("parse", what + " of the document could not all be read");
}

int index_or_none(JsonValue value) {
  constexpr std::uint64_t largest = std::numeric_limits<std::int32_t>::max();
  if (!value || value.kind() != JsonKind::whole_number || value.unsigned_integer() > largest) return -1;
  return static_cast<int>(value.unsigned_integer());
}

std::string text_or_none(JsonValue value) {
  return value && value.kind() == JsonKind::string ? std::string(value.string()) : std::string();
}

// What values_for_tinygltf withholds.
void restore(tiny::Model& model, JsonValue root) {
  std::size_t i = 0;
  if (const JsonValue views = root.member("bufferViews")) {
    views.for_each_element([&](JsonValue view) {
      tiny::BufferView& to = model.bufferViews[i++];
      const JsonValue stride = view.member("byteStride");
      to.byteStride = stride ? static_cast<std::size_t>(stride.unsigned_integer()) : 0;
      const int target = index_or_none(view.member("target"));
      to.target = target == TINYGLTF_TARGET_ARRAY_BUFFER || target == TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER ? target : 0;
    });
  }
  i = 0;
  if (const JsonValue accessors = root.member("accessors")) {
    accessors.for_each_element([&](JsonValue accessor) {
      if (!accessor.member("bufferView")) model.accessors[i].bufferView = -1;
      ++i;
    });
  }
  if (model.images.empty()) return;
  i = 0;
  root.member("images").for_each_element([&](JsonValue image) {
    tiny::Image& to = model.images[i++];
    to.uri = text_or_none(image.member("uri"));
    to.mimeType = text_or_none(image.member("mimeType"));
    to.bufferView = index_or_none(image.member("bufferView"));
  });
}

// What the reader walks through is all there: tinygltf leaves out what it does not understand.
void check_counts(const tiny::Model& model, JsonValue root) {
  require_same_count(model.accessors.size(), root.member("accessors"), "accessors");
  require_same_count(model.bufferViews.size(), root.member("bufferViews"), "bufferViews");
  require_same_count(model.buffers.size(), root.member("buffers"), "buffers");
  require_same_count(model.nodes.size(), root.member("nodes"), "nodes");
  require_same_count(model.scenes.size(), root.member("scenes"), "scenes");
  require_same_count(model.meshes.size(), root.member("meshes"), "meshes");
  std::size_t i = 0;
  if (const JsonValue meshes = root.member("meshes")) {
    meshes.for_each_element([&](JsonValue mesh) {
      require_same_count(model.meshes[i++].primitives.size(), mesh.member("primitives"), mesh.path() + ".primitives");
    });
  }
}

// tinygltf's message as one line of bounded length in printable characters.
std::string one_line(std::string text) {
  constexpr std::size_t longest = 160;
  text.resize(std::min(text.size(), longest));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
    text.pop_back();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, ' ');
  return text;
}

}  // namespace

tiny::Model model_of(const JsonDocument& document, Extent extent, const base::Host& host) {
  const JsonValue root = document.root();
  check_size(root, document.text_size());
  tiny::Model model;
  std::string problem;
  {
    const JsonMemory memory(JsonMemory::Use::reading, document.value_count(), host);
    if (!load_model(values_for_tinygltf(root, extent), model, problem))
      throw base::Error("parse", "the document: " + one_line(problem));
  }
  check_counts(model, root);
  restore(model, root);
  return model;
}

std::string text_of(const tiny::Model& model, const base::Host& host) {
  const JsonMemory memory(JsonMemory::Use::writing, 0, host);
  tiny::std::ostream stream;
  tiny::TinyGLTF writer;
  try {
    writer.WriteGltfSceneToStream(&model, stream, false, false);
  } catch (const TinyJson::exception&) {
    throw base::Error("invalid-argument", "a name is not UTF-8");
  }
  memory.check();
  std::string text = stream.str();
  while (!text.empty() && text.back() == '\n')
    text.pop_back();
  return text;
}

std::string place_of(const char* array, std::size_t index) {
  return array + ('[' + std::to_string(index) + ']');
}

}  // namespace orbicube::gltf
