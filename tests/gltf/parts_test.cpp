// Several meshes in one file: each is there with its name, place and look.
#include "gltf/writing/parts.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <limits>
#include <vector>

#include "base/error.h"
#include "gltf/reading/read.h"
#include "made_files.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using gltf::Part;
using gltf::test::Json;
using mesh::Vector3;
using test::host;

namespace {

struct Cube {
  std::vector<Vector3> positions;
  std::vector<mesh::Triangle> triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  std::vector<std::uint8_t> colors;

  explicit Cube(double size) {
    for (int i = 0; i < 8; ++i) {
      positions.push_back(size * Vector3(i & 1, i >> 1 & 1, i >> 2 & 1));
      for (const int c : {i & 1, i >> 1 & 1, i >> 2 & 1, 1})
        colors.push_back(static_cast<std::uint8_t>(255 * c));
    }
  }

  Part part(const char* name) const {
    Part part;
    part.name = name;
    part.positions = positions;
    part.triangles = triangles;
    return part;
  }
};

// The text of a .gltf, whose buffer is inside.
Json text_of(std::span<const Part> parts) {
  const auto bytes = gltf::parts_to_bytes(parts, gltf::Form::gltf, host);
  return Json::parse(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string refusal(std::span<const Part> parts) {
  try {
    gltf::parts_to_bytes(parts, gltf::Form::glb, host);
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("Each part is a node, a mesh and a material of its name") {
  const Cube large(2), small(1);
  std::vector<Part> parts = {large.part("surface"), small.part("curves")};
  parts[0].color = {0.5, 0.6, 0.7, 0.25};
  parts[1].colors = small.colors;
  parts[1].flat = true;
  const Json json = text_of(parts);
  REQUIRE(json["scenes"][0]["nodes"] == Json({0, 1}));
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& node = json["nodes"][i];
    CHECK(node["name"] == parts[i].name);
    CHECK(node["mesh"] == i);
    CHECK(json["meshes"][i]["name"] == parts[i].name);
    const Json& primitive = json["meshes"][i]["primitives"][0];
    CHECK(primitive["material"] == i);
    CHECK(primitive["attributes"].contains("NORMAL"));
    CHECK(primitive["attributes"].contains("COLOR_0") == (i == 1));
    const Json& position = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
    CHECK(position["count"] == (i == 0 ? 8 : 36));
    CHECK(position["max"] == (i == 0 ? Json({2, 2, 2}) : Json({1, 1, 1})));
    CHECK(json["accessors"][primitive["indices"].get<std::size_t>()]["count"] == 36);
    const Json& material = json["materials"][i];
    CHECK(material["name"] == parts[i].name);
    CHECK(material["doubleSided"] == true);
    CHECK(material.value("alphaMode", "OPAQUE") == (i == 0 ? "BLEND" : "OPAQUE"));
  }
  CHECK(json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] == Json({0.5, 0.6, 0.7, 0.25}));
}

TEST_CASE("All triangles of all parts are read again, in both containers") {
  const Cube large(2), small(1);
  const std::vector<Part> parts = {large.part("a"), small.part("b")};
  for (const gltf::Form form : {gltf::Form::glb, gltf::Form::gltf}) {
    const auto bytes = gltf::parts_to_bytes(parts, form, host);
    const mesh::Mesh read = gltf::read(bytes, {}, {.weld_identical = false, .morph_target = ""}, host);
    REQUIRE(read.positions.size() == 16);
    REQUIRE(read.triangles.size() == 24);
    for (std::size_t v = 0; v < 8; ++v) {
      CHECK(read.positions[v] == large.positions[v]);
      CHECK(read.positions[8 + v] == small.positions[v]);
    }
    CHECK(read.triangles[3] == large.triangles[3]);
    CHECK(read.triangles[15] == mesh::Triangle{13, 15, 14});
  }
}

TEST_CASE("A part stands where its node puts it") {
  const Cube cube(1);
  std::vector<Part> parts = {cube.part("here"), cube.part("there")};
  parts[1].translation = {1e6, -2e6, 0.5};
  const Json json = text_of(parts);
  CHECK_FALSE(json["nodes"][0].contains("translation"));
  CHECK(json["nodes"][1]["translation"] == Json({1e6, -2e6, 0.5}));
  const auto bytes = gltf::parts_to_bytes(parts, gltf::Form::glb, host);
  const mesh::Mesh read = gltf::read(bytes, {}, {.weld_identical = false, .morph_target = ""}, host);
  REQUIRE(read.positions.size() == 16);
  for (std::size_t v = 0; v < 8; ++v)
    CHECK(read.positions[8 + v] == cube.positions[v] + parts[1].translation);
}

TEST_CASE("Parts that cannot be written are refused") {
  const Cube cube(1);
  CHECK(refusal({}) == "invalid-argument");
  const auto refused = [&](const auto& spoil) {
    std::vector<Part> parts = {cube.part("good"), cube.part("bad")};
    spoil(parts[1]);
    return refusal(parts) == "invalid-argument";
  };
  CHECK(refused([](Part& p) { p.triangles = {}; }));
  CHECK(refused([](Part& p) { p.positions = p.positions.first(7); }));
  CHECK(refused([&](Part& p) { p.colors = std::span(cube.colors).first(31); }));
  CHECK(refused([](Part& p) { p.color[1] = 1.5; }));
  CHECK(refused([](Part& p) { p.color[3] = std::numeric_limits<double>::quiet_NaN(); }));
  CHECK(refused([](Part& p) { p.translation[2] = std::numeric_limits<double>::infinity(); }));
  CHECK(refused([](Part& p) { p.name = std::string("\xff"); }));
  std::vector<Vector3> far = cube.positions;
  far[2][1] = 1e39;  // beyond float32
  CHECK(refused([&](Part& p) { p.positions = far; }));
}
