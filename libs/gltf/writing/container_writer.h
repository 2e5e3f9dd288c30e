// How a written glTF file is put together: GLB, or text with the buffer inside as base64. tinygltf would do this with
// two copies of the buffer, without a report on the way, and with wrong lengths from 4 GiB on.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/files/base64.h"
#include "gltf/json/document.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/write.h"

namespace orbicube::gltf {

inline std::array<std::byte, 4> little_endian(std::uint64_t value) {
  std::array<std::byte, 4> bytes;
  for (std::size_t i = 0; i < 4; ++i)
    bytes[i] = static_cast<std::byte>(value >> (8 * i) & 0xFFU);
  return bytes;
}

// GLB: header, JSON chunk filled up with spaces, BIN chunk filled up with zeros.
template <class Sink>
void emit_glb(const DocumentText& document, const BinaryBuffer& buffer, const Sink& sink) {
  std::string text = document.before + document.after;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  constexpr std::uint64_t magic = 0x46546C67U, version = 2, json_chunk = 0x4E4F534AU, binary_chunk = 0x004E4942U;
  constexpr std::uint64_t header = 12, chunk_header = 8;
  const std::uint64_t total = header + chunk_header + text.size() + chunk_header + buffer.size();
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw base::Error("unsupported", "a GLB file of 4 GiB or more");
  for (const std::uint64_t word : {magic, version, total, std::uint64_t{text.size()}, json_chunk})
    sink(little_endian(word));
  sink(std::as_bytes(std::span(text.data(), text.size())));
  for (const std::uint64_t word : {buffer.size(), binary_chunk})
    sink(little_endian(word));
  buffer.emit(sink);
}

// .gltf: the buffer as base64 in the text.
template <class Sink>
void emit_gltf(const DocumentText& document, const BinaryBuffer& buffer, const Sink& sink) {
  sink(std::as_bytes(std::span(document.before)));
  // Three bytes are four characters: pieces are collected until they are whole.
  constexpr std::size_t whole = std::size_t{3} << 14U;
  std::array<std::byte, whole> collected;
  std::string encoded(base::base64_size(whole), '\0');
  std::size_t fill = 0;
  const auto flush = [&] {
    base::encode_base64(std::span(collected).first(fill), encoded.data());
    sink(std::as_bytes(std::span(encoded).first(base::base64_size(fill))));
    fill = 0;
  };
  buffer.emit([&](std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const std::size_t taken = std::min(bytes.size(), whole - fill);
      std::copy_n(bytes.begin(), taken, collected.begin() + static_cast<std::ptrdiff_t>(fill));
      bytes = bytes.subspan(taken);
      fill += taken;
      if (fill == whole) flush();
    }
  });
  flush();
  sink(std::as_bytes(std::span(document.after)));
}

// Calls sink(bytes) for each piece of the file. Throws Error "unsupported" for a GLB of 4 GiB.
template <class Sink>
void emit_container(Form form, tiny::Model model, std::string_view extras, const BinaryBuffer& buffer,
                    const base::Host& host, const Sink& sink) {
  const DocumentText document = document_text(std::move(model), extras, buffer, form, host);
  form == Form::glb ? emit_glb(document, buffer, sink) : emit_gltf(document, buffer, sink);
}

}  // namespace orbicube::gltf
