// A textured, skinned surface with everything that a file may have besides positions and triangles.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "gltf/writing/checker.h"
#include "made_files.h"

namespace orbicube::gltf::test {

// An ellipsoid of 8 by 4 patches between its poles: texture coordinates with a seam along a meridian, colors, two
// bones, an upper half of one material and a lower half of another.
class Decorated {
 public:
  static constexpr std::size_t columns = 8, rows = 4;

  MadeFile file;

  Decorated() {
    file.json = Json::parse(R"({"asset": {"version": "2.0"}, "scene": 0,
      "scenes": [{"name": "the scene", "nodes": [0, 1], "extras": {"author": "A"}}],
      "nodes": [{"name": "body", "mesh": 0, "skin": 0, "extras": {"id": 7}},
                {"name": "root", "translation": [0, -1, 0], "children": [2]},
                {"name": "tip", "translation": [0, 1, 0]}],
      "skins": [{"name": "bones", "joints": [1, 2], "inverseBindMatrices": 6, "skeleton": 1}],
      "meshes": [{"name": "egg", "extras": {"note": "kept"}, "primitives": [
        {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 3, "JOINTS_0": 4, "WEIGHTS_0": 5},
         "indices": 7, "material": 0},
        {"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2, "COLOR_0": 3, "JOINTS_0": 4, "WEIGHTS_0": 5},
         "indices": 8, "material": 1}]}],
      "materials": [
        {"name": "painted", "extras": {"k": [1, 2]},
         "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.0}},
        {"name": "red", "doubleSided": true, "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1.0]}}],
      "textures": [{"source": 0, "sampler": 0}], "samplers": [{"magFilter": 9728, "minFilter": 9728}],
      "images": [{"name": "paint", "mimeType": "image/png"}],
      "animations": [{"name": "bend", "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}}],
                      "samplers": [{"input": 9, "output": 10}]}],
      "buffers": [{"byteLength": 0}], "bufferViews": [], "accessors": []})");
    add_vertices();
    add_rest();
  }

  // Of the vertex in row i and column j, of which the last is where the first is.
  static std::array<float, 3> position(std::size_t i, std::size_t j) {
    const double theta = M_PI * static_cast<double>(i) / rows,
                 phi = 2 * M_PI * static_cast<double>(j % columns) / columns;
    const double radius = i == 0 || i == rows ? 0 : std::sin(theta);
    return {static_cast<float>(0.5 * radius * std::cos(phi)), static_cast<float>(std::cos(theta)),
            static_cast<float>(0.75 * radius * std::sin(phi))};
  }

  static std::array<float, 2> texture_coordinate(std::size_t i, std::size_t j) {
    return {static_cast<float>(j) / columns, static_cast<float>(i) / rows};
  }

 private:
  template <class Value>
  std::size_t add_bytes(const std::vector<Value>& values) {
    file.buffer.resize((file.buffer.size() + 3) / 4 * 4);
    const std::size_t size = values.size() * sizeof(Value);
    file.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", file.buffer.size()}, {"byteLength", size}});
    file.buffer.append(reinterpret_cast<const char*>(values.data()), size);
    file.json["buffers"][0]["byteLength"] = file.buffer.size();
    return file.json["bufferViews"].size() - 1;
  }

  template <class Value>
  Json& add(const std::vector<Value>& values, int component_type, const char* type, std::size_t components) {
    const std::size_t view = add_bytes(values);
    file.json["accessors"].push_back({{"bufferView", view},
                                      {"componentType", component_type},
                                      {"count", values.size() / components},
                                      {"type", type}});
    return file.json["accessors"].back();
  }

  void add_vertices() {
    std::vector<float> positions, normals, coordinates, weights;
    std::vector<std::uint8_t> colors, joints;
    for (std::size_t i = 0; i <= rows; ++i) {
      for (std::size_t j = 0; j <= columns; ++j) {
        const auto p = position(i, j);
        const auto t = texture_coordinate(i, j);
        positions.insert(positions.end(), p.begin(), p.end());
        coordinates.insert(coordinates.end(), t.begin(), t.end());
        const double n[3] = {p[0] / 0.25, p[1], p[2] / 0.5625}, length = std::hypot(n[0], n[1], n[2]);
        for (const double x : n)
          normals.push_back(static_cast<float>(x / length));
        for (const std::size_t c : {std::size_t{255}, 200 - 10 * i, std::size_t{100}, std::size_t{255}})
          colors.push_back(static_cast<std::uint8_t>(c));
        const float upper = (p[1] + 1) / 2;
        joints.insert(joints.end(), {0, static_cast<std::uint8_t>(upper > 0 ? 1 : 0), 0, 0});
        weights.insert(weights.end(), {1 - upper, upper, 0, 0});
      }
    }
    Json& accessor = add(positions, 5126, "VEC3", 3);
    accessor["min"] = {-0.5, -1.0, -0.75};
    accessor["max"] = {0.5, 1.0, 0.75};
    add(normals, 5126, "VEC3", 3);
    add(coordinates, 5126, "VEC2", 2);
    add(colors, 5121, "VEC4", 4)["normalized"] = true;
    add(joints, 5121, "VEC4", 4);
    add(weights, 5126, "VEC4", 4);
  }

  static std::vector<std::uint16_t> triangles(std::size_t from, std::size_t to) {
    std::vector<std::uint16_t> corners;
    for (std::size_t i = from; i < to; ++i) {
      for (std::size_t j = 0; j < columns; ++j) {
        const auto a = static_cast<std::uint16_t>(i * (columns + 1) + j), b = static_cast<std::uint16_t>(a + 1);
        const auto c = static_cast<std::uint16_t>(a + columns + 1), d = static_cast<std::uint16_t>(c + 1);
        if (i > 0) corners.insert(corners.end(), {a, b, c});
        if (i + 1 < rows) corners.insert(corners.end(), {b, d, c});
      }
    }
    return corners;
  }

  void add_rest() {
    // By columns: the root at y = -1, the tip at the origin.
    const std::vector<float> matrices(
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    add(matrices, 5126, "MAT4", 16);
    add(triangles(0, rows / 2), 5123, "SCALAR", 1);
    add(triangles(rows / 2, rows), 5123, "SCALAR", 1);
    Json& times = add(std::vector<float>{0, 1}, 5126, "SCALAR", 1);
    times["min"] = Json::array({0.0});
    times["max"] = Json::array({1.0});
    add(std::vector<float>{0, 0, 0, 1, 0, 0, 0.6F, 0.8F}, 5126, "VEC4", 4);
    const base::Array<std::byte> png = checker_png({4, 4, 2, {}, {}}, std::pmr::get_default_resource());
    file.json["images"][0]["bufferView"] = add_bytes(std::vector<std::byte>(png.begin(), png.end()));
  }
};

}  // namespace orbicube::gltf::test
