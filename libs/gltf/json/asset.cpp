#include "gltf/json/asset.h"

#include <algorithm>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "base/files/base64.h"
#include "gltf/json/compressed_view.h"
#include "gltf/json/structure.h"
#include "gltf/json/uri.h"

namespace orbicube::gltf {

namespace {

// Known when this is compiled, so that modules without meshoptimizer have no code for it.
#ifdef ORBICUBE_WITH_MESHOPTIMIZER
constexpr bool reads_compressed_views = true;
#else
constexpr bool reads_compressed_views = false;
#endif

bool uses_extension(const tiny::Model& model, std::string_view name) {
  return std::find(model.extensionsUsed.begin(), model.extensionsUsed.end(), name) != model.extensionsUsed.end();
}

// A checked document.
const JsonDocument& checked(const JsonDocument& document) {
  check_structure(document.root());
  return document;
}

tiny::Model read_model(const JsonDocument& document, Extent extent, const base::Host& host, std::string& problem) {
  if (extent == Extent::everything) {
    try {
      return model_of(document, extent, host);
    } catch (const base::Error& error) {
      if (error.status() == base::Status::cancelled) throw;
      problem = error.what();
    }
  }
  return model_of(document, Extent::surface, host);
}

}  // namespace

void require_index(int index, std::size_t count, const char* array, const std::string& where) {
  if (index >= 0 && static_cast<std::size_t>(index) < count) return;
  throw base::Error("index-range",
                    where + " is " + std::to_string(index) + ", but there are " + std::to_string(count) + ' ' + array);
}

Asset::Asset(std::span<const std::byte> bytes, std::optional<std::filesystem::path> folder, Extent extent,
             const base::Host& host)
    : host_(host),
      folder_(std::move(folder)),
      container_(open_container(bytes)),
      json_(container_.json, host),
      model_(read_model(checked(json_), extent, host, problem_)),
      buffers_(host.memory),
      compressed_views_(host.memory),
      decompressed_(host.memory),
      opened_(host.memory),
      decoded_(host.memory),
      external_files_(host.memory),
      stored_bytes_(bytes.size()),
      quantized_(uses_extension(model_, "KHR_mesh_quantization")) {
  if (const JsonValue buffers = root().member("buffers"))
    buffers.for_each_element([&](JsonValue each) { buffers_.push_back(each); });
  if (reads_compressed_views && uses_extension(model_, compression_extension)) find_compressed_views();
}

void Asset::find_compressed_views() {
  if (const JsonValue views = root().member("bufferViews")) {
    std::size_t i = 0;
    views.for_each_element([&](JsonValue view) {
      const JsonValue extensions = view.member("extensions");
      if (const JsonValue extension = extensions ? extensions.member(compression_extension) : JsonValue())
        compressed_views_.emplace(i, extension);
      ++i;
    });
  }
  // The validator of Khronos has the same error: required extensions have to be used.
  if (std::erase(model_.extensionsRequired, compression_extension) > 0 && compressed_views_.empty())
    throw base::Error("unsupported-extension",
                      std::string("the file requires ") + compression_extension + ", but no buffer view has it");
  std::erase(model_.extensionsUsed, compression_extension);
}

const tiny::Accessor& Asset::accessor(int index, const std::string& where) const {
  require_index(index, model_.accessors.size(), "accessors", where);
  return model_.accessors[static_cast<std::size_t>(index)];
}

BufferView Asset::view(int index, const std::string& where) {
  if (index < 0 || static_cast<std::size_t>(index) >= model_.bufferViews.size()) {
    throw base::Error("parse", where + " refers to buffer view " + std::to_string(index) + ", but there are " +
                                   std::to_string(model_.bufferViews.size()));
  }
  const tiny::BufferView& view = model_.bufferViews[static_cast<std::size_t>(index)];
  if constexpr (reads_compressed_views) {
    const auto compressed = compressed_views_.find(static_cast<std::size_t>(index));
    if (compressed != compressed_views_.end()) return decompressed(static_cast<std::size_t>(index), compressed->second);
  }
  // An index that is not given is -1, which is beyond the buffers as well.
  return {part_of_buffer(static_cast<std::uint64_t>(std::int64_t{view.buffer}), view.byteOffset, view.byteLength,
                         place_of("bufferViews", static_cast<std::size_t>(index))),
          view.byteStride};
}

BufferView Asset::decompressed(std::size_t index, JsonValue extension) {
  const tiny::BufferView& view = model_.bufferViews[index];
  auto found = decompressed_.find(index);
  if (found == decompressed_.end()) {
    const Compression compression = compression_of(extension, view.byteLength);
    const std::span<const std::byte> bytes =
        part_of_buffer(compression.buffer, compression.byte_offset, compression.byte_length, extension.path());
    decompressed_bytes_ += view.byteLength;
    if (decompressed_bytes_ / max_expansion > stored_bytes_ - (decompressed_bytes_ - view.byteLength))
      throw base::Error("unsupported", extension.path() + " repeats compressed bytes of other views");
    found = decompressed_.emplace(index, decoded_view(compression, bytes, extension.path(), host_)).first;
    stored_bytes_ += view.byteLength;
  }
  return {found->second, view.byteStride};
}

std::span<const std::byte> Asset::part_of_buffer(std::uint64_t index, std::uint64_t offset, std::uint64_t length,
                                                 const std::string& where) {
  if (index >= buffers_.size()) {
    throw base::Error("parse", where + ".buffer is " + std::to_string(static_cast<std::int64_t>(index)) +
                                   ", but there are " + base::counted(buffers_.size(), "buffer"));
  }
  const std::span<const std::byte> whole = buffer(static_cast<std::size_t>(index));
  if (offset > whole.size() || length > whole.size() - offset) {
    throw base::Error("accessor-range", where + " needs " + base::counted(length, "byte") + " from " +
                                            std::to_string(offset) + ", its buffer has " +
                                            std::to_string(whole.size()));
  }
  return whole.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

std::span<const std::byte> Asset::buffer(std::size_t index) {
  const auto found = opened_.find(index);
  if (found != opened_.end()) return found->second;
  const JsonValue description = buffers_[index];
  const std::uint64_t length = description.required("byteLength").unsigned_integer();
  const std::span<const std::byte> bytes = load(index);
  if (length > bytes.size()) {
    throw base::Error("truncated", description.path() + " declares " + base::counted(length, "byte") + ", but has " +
                                       std::to_string(bytes.size()));
  }
  return opened_.emplace(index, bytes.first(static_cast<std::size_t>(length))).first->second;
}

std::span<const std::byte> Asset::load(std::size_t index) {
  if (const JsonValue uri = buffers_[index].member("uri")) return bytes_of_uri(uri.string(), uri.path());
  if (index == 0 && container_.chunk) return *container_.chunk;
  throw base::Error("truncated", buffers_[index].path() + " has no uri, and there is no BIN chunk for it");
}

std::span<const std::byte> Asset::bytes_of_uri(std::string_view uri, const std::string& where) {
  if (const std::optional<std::string_view> base64 = base64_of_data_uri(uri))
    return decoded_.emplace_back(base::decode_base64(*base64, host_));
  const std::string name = file_of_uri(uri);
  if (!folder_) throw base::Error("unsupported-uri", where + " names a file, but there is no folder to read from");
  auto file = external_files_.find(name);
  if (file == external_files_.end()) {
    file = external_files_.emplace(name, read_file_below(*folder_, name, host_)).first;
    stored_bytes_ += file->second.size();
  }
  return file->second;
}

}  // namespace orbicube::gltf
