// The two containers of glTF 2.0: a JSON text (.gltf) and GLB, the text and one buffer in a binary file (glTF 2.0
// specification, chapter 4). Distinguished by their content.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace orbicube::gltf {

struct Container {
  bool binary = false;                              // GLB
  std::string_view json;                            // a view of the file's bytes
  std::optional<std::span<const std::byte>> chunk;  // the BIN chunk of a GLB
  std::size_t trailing_bytes = 0;                   // behind the end that a GLB declares
};

// Throws Error: "empty-file", "bad-magic" (neither GLB nor JSON), "truncated" (declared lengths reach beyond the file),
// "parse" (they contradict each other), "unsupported-version" (a GLB that is not of version 2).
Container open_container(std::span<const std::byte> bytes);

}  // namespace orbicube::gltf
