// An opened glTF asset: its document, checked and then read by tinygltf, and the bytes of its buffer views. Nothing of
// the file is trusted: every index and range is checked where it is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/array.h"
#include "base/host.h"
#include "gltf/json/json.h"
#include "gltf/json/model.h"
#include "gltf/writing/container.h"

namespace orbicube::gltf {

// The bytes of a buffer view.
struct BufferView {
  std::span<const std::byte> bytes;
  std::size_t stride;  // 0: elements are packed
};

class Asset {
 public:
  // `folder` is where external buffers lie; without it they are refused. `bytes` must outlive the asset. With
  // Extent::everything, a document of which tinygltf refuses what is not of its surface is read without that
  // (problem()). Throws Error of the kinds of open_container, JsonDocument, check_structure and model_of, and
  // "unsupported-extension" where EXT_meshopt_compression is required and no view has it.
  Asset(std::span<const std::byte> bytes, std::optional<std::filesystem::path> folder, Extent extent,
        const base::Host& host);

  const Container& container() const { return container_; }
  const tiny::Model& model() const { return model_; }
  JsonValue root() const { return json_.root(); }
  // Whether the file uses KHR_mesh_quantization.
  bool quantized() const { return quantized_; }
  // Why the model has no more than what a surface is read from; empty when it has all that was requested.
  const std::string& problem() const { return problem_; }

  // The accessor, node, mesh or scene of that number. Throws Error "index-range", saying where the number stands, when
  // there is none. -1 stands for a number that is not given, which is not allowed here.
  const tiny::Accessor& accessor(int index, const std::string& where) const;

  // The bytes of a buffer view of the model; `where` is what refers to it. Buffers are decoded or read when the first
  // view of them is requested, and so are compressed views (compressed_view.h), which the model does not mention.
  // Throws Error: "parse" for an index beyond its array; "accessor-range" for a view that does not fit its buffer;
  // "truncated" for a buffer with fewer bytes than it declares; "unsupported" for compressed views that repeat bytes;
  // the kinds of compressed_view.h, uri.h and base64.h.
  BufferView view(int index, const std::string& where);

  // The bytes of an image's or a buffer's URI: base64 in it, or a file of the folder. Live as long as the asset.
  std::span<const std::byte> bytes_of_uri(std::string_view uri, const std::string& where);

  // Bytes of the file and of every buffer read and every view decompressed so far: what counts in the file are measured
  // against.
  std::uint64_t stored_bytes() const { return stored_bytes_; }

  const base::Host& host() const { return host_; }

 private:
  void find_compressed_views();
  BufferView decompressed(std::size_t index, JsonValue extension);
  // The bytes that `where` has in a buffer.
  std::span<const std::byte> part_of_buffer(std::uint64_t index, std::uint64_t offset, std::uint64_t length,
                                            const std::string& where);
  std::span<const std::byte> buffer(std::size_t index);
  std::span<const std::byte> load(std::size_t index);

  const base::Host& host_;
  std::optional<std::filesystem::path> folder_;
  Container container_;
  JsonDocument json_;
  std::string problem_;  // before the model, with which it is set
  tiny::Model model_;
  base::Array<JsonValue> buffers_;
  std::pmr::map<std::size_t, JsonValue> compressed_views_;           // the extensions, by view
  std::pmr::map<std::size_t, base::Array<std::byte>> decompressed_;  // by view
  std::uint64_t decompressed_bytes_ = 0;
  std::pmr::map<std::size_t, std::span<const std::byte>> opened_;      // buffers by index
  std::pmr::list<base::Array<std::byte>> decoded_;                     // of data URIs
  std::pmr::map<std::string, base::Array<std::byte>> external_files_;  // by name; several buffers may share one
  std::uint64_t stored_bytes_;
  bool quantized_;
};

// Throws Error "index-range" unless the index is one of `count` elements of the array.
void require_index(int index, std::size_t count, const char* array, const std::string& where);

}  // namespace orbicube::gltf
