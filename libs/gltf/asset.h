// An opened glTF asset: its JSON, checked as a whole, its top-level arrays with constant-time access, and the bytes of
// its buffer views. Nothing of the file is trusted: every index and range is checked where it is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "base/array.h"
#include "base/host.h"
#include "gltf/container.h"
#include "gltf/json.h"

namespace orbicube::gltf {

// One of the arrays at the top of the document ("accessors", "nodes", ...); empty when the document has none.
class TopLevelArray {
 public:
  // Throws Error "parse" when the member is no array.
  TopLevelArray(JsonValue root, const char* name, std::pmr::memory_resource* memory);

  std::size_t size() const { return values_.size(); }
  // Throws Error `kind`, saying where the index stands, when it is beyond the array.
  JsonValue at(JsonValue index, const char* kind) const;
  JsonValue operator[](std::size_t i) const { return values_[i]; }

 private:
  const char* name_;
  base::Array<JsonValue> values_;
};

// The bytes of a buffer view.
struct BufferView {
  std::span<const std::byte> bytes;
  std::size_t stride;  // 0: elements are packed
};

class Asset {
 public:
  // `folder` is where external buffers lie; without it they are refused. `bytes` must outlive the asset.
  // Throws Error of the kinds of open_container and JsonDocument; "parse" without asset.version; "unsupported-version";
  // "unsupported-extension" when one is required that changes what positions and triangles mean.
  Asset(std::span<const std::byte> bytes, std::optional<std::filesystem::path> folder, const base::Host& host);

  const Container& container() const { return container_; }
  const TopLevelArray& accessors() const { return accessors_; }
  const TopLevelArray& meshes() const { return meshes_; }
  const TopLevelArray& nodes() const { return nodes_; }
  const TopLevelArray& scenes() const { return scenes_; }
  JsonValue root() const { return json_.root(); }
  // Whether the file uses KHR_mesh_quantization.
  bool quantized() const { return quantized_; }

  // The bytes of the buffer view that the index in the document names. Buffers are decoded or read when the first view
  // of them is asked for. Throws Error: "parse" for an index beyond its array; "accessor-range" for a view that does
  // not fit its buffer; "truncated" for a buffer with fewer bytes than it declares; the kinds of uri.h and base64.h.
  BufferView view(JsonValue index);

  // Bytes of the file and of every buffer read so far: what counts in the file are measured against.
  std::uint64_t stored_bytes() const { return stored_bytes_; }

  const base::Host& host() const { return host_; }

 private:
  std::span<const std::byte> buffer(std::size_t index);
  std::span<const std::byte> load(std::size_t index);

  const base::Host& host_;
  std::optional<std::filesystem::path> folder_;
  Container container_;
  JsonDocument json_;
  TopLevelArray accessors_, buffer_views_, buffers_, meshes_, nodes_, scenes_;
  std::pmr::map<std::size_t, std::span<const std::byte>> opened_;      // buffers by index
  std::pmr::map<std::size_t, base::Array<std::byte>> decoded_;         // of data URIs, by buffer
  std::pmr::map<std::string, base::Array<std::byte>> external_files_;  // by name; several buffers may share one
  std::uint64_t stored_bytes_;
  bool quantized_;
};

}  // namespace orbicube::gltf
