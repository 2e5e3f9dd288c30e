#include "gltf/asset.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/error.h"
#include "gltf/base64.h"
#include "gltf/uri.h"

namespace orbicube::gltf {

namespace {

// Required extensions that say nothing about positions and triangles, or that the reader knows.
bool is_known_extension(std::string_view name) {
  constexpr std::array known = {"KHR_mesh_quantization", "KHR_texture_transform", "KHR_texture_basisu",
                                "KHR_lights_punctual",   "KHR_animation_pointer", "KHR_xmp_json_ld",
                                "EXT_texture_webp",      "EXT_texture_avif",      "MSFT_texture_dds"};
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
  const JsonValue required = root.member("extensionsRequired");
  if (!required) return;
  required.for_each_element([](JsonValue name) {
    if (!is_known_extension(name.string()))
      throw base::Error("unsupported-extension", "the file requires " + in_quotes(name.string()));
  });
}

bool uses_extension(JsonValue root, std::string_view name) {
  const JsonValue used = root.member("extensionsUsed");
  bool found = false;
  if (used) used.for_each_element([&](JsonValue value) { found = found || value.string() == name; });
  return found;
}

}  // namespace

TopLevelArray::TopLevelArray(JsonValue root, const char* name, std::pmr::memory_resource* memory)
    : name_(name), values_(memory) {
  const JsonValue array = root.member(name);
  if (array) array.for_each_element([&](JsonValue value) { values_.push_back(value); });
}

JsonValue TopLevelArray::at(JsonValue index, const char* kind) const {
  const std::uint64_t i = index.unsigned_integer();
  if (i >= values_.size()) {
    throw base::Error(kind, index.path() + " is " + std::to_string(i) + ", but there are " +
                                std::to_string(values_.size()) + ' ' + name_);
  }
  return values_[static_cast<std::size_t>(i)];
}

Asset::Asset(std::span<const std::byte> bytes, std::optional<std::filesystem::path> folder, const base::Host& host)
    : host_(host),
      folder_(std::move(folder)),
      container_(open_container(bytes)),
      json_(container_.json, host),
      accessors_(json_.root(), "accessors", host.memory),
      buffer_views_(json_.root(), "bufferViews", host.memory),
      buffers_(json_.root(), "buffers", host.memory),
      meshes_(json_.root(), "meshes", host.memory),
      nodes_(json_.root(), "nodes", host.memory),
      scenes_(json_.root(), "scenes", host.memory),
      opened_(host.memory),
      decoded_(host.memory),
      external_files_(host.memory),
      stored_bytes_(bytes.size()),
      quantized_(uses_extension(json_.root(), "KHR_mesh_quantization")) {
  check_version(root());
  check_extensions(root());
}

BufferView Asset::view(JsonValue index) {
  const JsonValue description = buffer_views_.at(index, "parse");
  const JsonValue which = description.required("buffer");
  buffers_.at(which, "parse");
  const std::span<const std::byte> whole = buffer(static_cast<std::size_t>(which.unsigned_integer()));
  const JsonValue given_offset = description.member("byteOffset");
  const std::uint64_t offset = given_offset ? given_offset.unsigned_integer() : 0;
  const std::uint64_t length = description.required("byteLength").unsigned_integer();
  if (offset > whole.size() || length > whole.size() - offset) {
    throw base::Error("accessor-range", description.path() + " needs " + std::to_string(length) + " bytes from " +
                                            std::to_string(offset) + ", its buffer has " +
                                            std::to_string(whole.size()));
  }
  const JsonValue given_stride = description.member("byteStride");
  // The specification allows up to 252; this bound only keeps the arithmetic of accessors small.
  const std::uint64_t stride = given_stride ? given_stride.unsigned_integer() : 0;
  if (stride > UINT32_MAX) throw base::Error("accessor-range", given_stride.path() + " is too large");
  return {whole.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length)),
          static_cast<std::size_t>(stride)};
}

std::span<const std::byte> Asset::buffer(std::size_t index) {
  const auto found = opened_.find(index);
  if (found != opened_.end()) return found->second;
  const JsonValue description = buffers_[index];
  const std::uint64_t length = description.required("byteLength").unsigned_integer();
  const std::span<const std::byte> bytes = load(index);
  if (length > bytes.size()) {
    throw base::Error("truncated", description.path() + " declares " + std::to_string(length) + " bytes, but has " +
                                       std::to_string(bytes.size()));
  }
  return opened_.emplace(index, bytes.first(static_cast<std::size_t>(length))).first->second;
}

std::span<const std::byte> Asset::load(std::size_t index) {
  const JsonValue uri = buffers_[index].member("uri");
  if (!uri) {
    if (index == 0 && container_.chunk) return *container_.chunk;
    throw base::Error("truncated", buffers_[index].path() + " has no uri, and there is no BIN chunk for it");
  }
  const std::string_view text = uri.string();
  if (const std::optional<std::string_view> base64 = base64_of_data_uri(text))
    return decoded_.emplace(index, decode_base64(*base64, host_)).first->second;

  const std::string name = std::filesystem::path(file_of_uri(text)).lexically_normal().string();
  if (!folder_) throw base::Error("unsupported-uri", uri.path() + " names a file, but there is no folder to read from");
  auto file = external_files_.find(name);
  if (file == external_files_.end()) {
    file = external_files_.emplace(name, read_file_below(*folder_, name, host_)).first;
    stored_bytes_ += file->second.size();
  }
  return file->second;
}

}  // namespace orbicube::gltf
