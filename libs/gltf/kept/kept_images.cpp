#include "gltf/kept/kept_images.h"

#include <array>
#include <cstring>
#include <string_view>

#include "base/error.h"
#include "gltf/json/uri.h"

namespace orbicube::gltf {

namespace {

std::string mime_type_of(std::span<const std::byte> bytes) {
  struct Signature {
    std::string_view start, type;
  };
  constexpr std::array<Signature, 4> signatures = {{{"\x89PNG\r\n\x1a\n", "image/png"},
                                                    {"\xFF\xD8\xFF", "image/jpeg"},
                                                    {"RIFF", "image/webp"},
                                                    {"\xABKTX 20\xBB", "image/ktx2"}}};
  for (const auto& [start, type] : signatures) {
    if (bytes.size() >= start.size() && std::memcmp(bytes.data(), start.data(), start.size()) == 0)
      return std::string(type);
  }
  return "";
}

}  // namespace

void check_image(const Kept& kept, const tiny::Image& image, const std::string& where) {
  std::span<const std::byte> bytes;
  if (image.uri.empty()) {
    bytes = kept.asset.view(image.bufferView, where).bytes;
  } else if (base64_of_data_uri(image.uri)) {
    bytes = kept.asset.bytes_of_uri(image.uri, where);
  } else {
    file_of_uri(image.uri);
    return;
  }
  if (image.mimeType.empty() && mime_type_of(bytes).empty())
    throw base::Error("unsupported", where + " has no mimeType, and is neither PNG nor JPEG");
}

void add_images(BinaryBuffer& buffer, const Kept& kept, bool views_added, tiny::Model& model) {
  const tiny::Model& source = kept.asset.model();
  for (std::size_t i = 0; i < source.images.size(); ++i) {
    const tiny::Image& from = source.images[i];
    tiny::Image& image = model.images[i];
    std::span<const std::byte> bytes;
    try {
      bytes = from.uri.empty() ? kept.asset.view(from.bufferView, "").bytes : kept.asset.bytes_of_uri(from.uri, "");
    } catch (const base::Error& error) {
      if (error.status() == base::Status::cancelled) throw;
      continue;
    }
    if (const std::string type = mime_type_of(bytes); !type.empty()) image.mimeType = type;
    if (from.uri.empty() && views_added) continue;
    image.uri.clear();
    image.bufferView = buffer.add_view(bytes, BinaryBuffer::Target::none);
  }
}

}  // namespace orbicube::gltf
