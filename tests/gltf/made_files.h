// glTF files made in memory: a tetrahedron as a document and a buffer, which tests change before they are read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "gltf/reading/read.h"

namespace orbicube::gltf::test {

using Json = nlohmann::ordered_json;

inline const std::array<float, 12> corner_positions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::array<std::uint16_t, 12> corner_indices{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

// A GLB file before it is put together.
struct MadeFile {
  Json json;
  std::string buffer;

  // Appends bytes at a multiple of four, with a buffer view of their own; answers the view's number.
  template <class Value, std::size_t size>
  std::size_t add_view(const std::array<Value, size>& values) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size * sizeof(Value)}});
    buffer.append(reinterpret_cast<const char*>(values.data()), size * sizeof(Value));
    json["buffers"][0]["byteLength"] = buffer.size();
    return json["bufferViews"].size() - 1;
  }

  std::string glb() const { return glb_of(json.dump(), buffer); }

  static std::string glb_of(std::string text, std::string content) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    content.resize((content.size() + 3) / 4 * 4, '\0');
    std::string file = "glTF";
    const auto put_word = [&](std::size_t value) {
      for (std::size_t i = 0; i < 4; ++i)
        file += static_cast<char>(value >> (8 * i) & 0xFFU);
    };
    put_word(2);
    put_word(12 + 8 + text.size() + 8 + content.size());
    put_word(text.size());
    file += "JSON" + text;
    put_word(content.size());
    file += std::string("BIN\0", 4) + content;
    return file;
  }
};

// The tetrahedron with float positions (accessor 0) and 16-bit indices (accessor 1).
inline MadeFile tetrahedron() {
  MadeFile file;
  file.json = Json::parse(R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 0}], "bufferViews": [],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                  {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})");
  file.add_view(corner_positions);
  file.add_view(corner_indices);
  return file;
}

inline mesh::Mesh read_text(const std::string& bytes, const ReadOptions& options = {},
                            mesh::ReadReport* report = nullptr) {
  return read(std::as_bytes(std::span(bytes)), {}, options, base::Host(), report);
}

// The kind of error that reading ends with, or "accepted".
inline std::string kind_of(const std::string& bytes, const ReadOptions& options = {}) {
  try {
    read_text(bytes, options);
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "accepted";
}

// Whether the surface is the tetrahedron, with `factor` times its positions.
inline bool is_tetrahedron(const mesh::Mesh& surface, double factor = 1) {
  if (surface.positions.size() != 4 || surface.triangles.size() != 4) return false;
  for (std::size_t i = 0; i < 12; ++i) {
    if (surface.positions[i / 3][static_cast<int>(i % 3)] != factor * static_cast<double>(corner_positions[i]) ||
        surface.triangles[i / 3][i % 3] != corner_indices[i])
      return false;
  }
  return true;
}

}  // namespace orbicube::gltf::test
