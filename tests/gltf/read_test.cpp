// Reading: every way in which a file may hold a surface gives the same surface, and placements do what they say.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/files/base64.h"
#include "made_files.h"
#include "mesh/topology/topology.h"

using namespace orbicube;
using gltf::test::is_tetrahedron;
using gltf::test::Json;
using gltf::test::kind_of;
using gltf::test::MadeFile;
using gltf::test::read_text;
using gltf::test::tetrahedron;

namespace {

std::string base64_of(const std::string& bytes) {
  std::string text(base::base64_size(bytes.size()), '\0');
  base::encode_base64(std::as_bytes(std::span(bytes)), text.data());
  return text;
}

double volume_of(const mesh::Mesh& surface) {
  double volume = 0;
  for (const mesh::Triangle& t : surface.triangles)
    volume += surface.positions[t[0]].dot(surface.positions[t[1]].cross(surface.positions[t[2]])) / 6;
  return volume;
}

template <class Value>
MadeFile with_indices(const std::array<Value, 12>& indices, int component_type) {
  MadeFile file = tetrahedron();
  file.json["accessors"][1] = {
      {"bufferView", file.add_view(indices)}, {"componentType", component_type}, {"count", 12}, {"type", "SCALAR"}};
  return file;
}

template <class Value>
std::array<Value, 12> indices_as() {
  std::array<Value, 12> indices{};
  for (std::size_t i = 0; i < 12; ++i)
    indices[i] = static_cast<Value>(gltf::test::corner_indices[i]);
  return indices;
}

}  // namespace

TEST_CASE("Indices of 8, 16 and 32 bits mean the same") {
  CHECK(is_tetrahedron(read_text(tetrahedron().glb())));
  CHECK(is_tetrahedron(read_text(with_indices(indices_as<std::uint8_t>(), 5121).glb())));
  CHECK(is_tetrahedron(read_text(with_indices(indices_as<std::uint32_t>(), 5125).glb())));
}

TEST_CASE("Buffers are read from base64 and from a file of the same folder") {
  MadeFile file = tetrahedron();
  for (const char* type : {"application/octet-stream", "application/gltf-buffer", ""}) {
    file.json["buffers"][0]["uri"] = "data:" + std::string(type) + ";base64," + base64_of(file.buffer);
    CHECK(is_tetrahedron(read_text(file.json.dump())));
    CHECK(is_tetrahedron(read_text("\xEF\xBB\xBF \n" + file.json.dump(2) + "\n")));
  }

  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "orbicube-gltf-read-test";
  std::filesystem::create_directories(folder / "inner" / "below");
  const auto put = [](const std::filesystem::path& path, const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
  };
  const auto outcome = [&](const char* uri) -> std::string {
    file.json["buffers"][0]["uri"] = uri;
    put(folder / "inner" / "a.gltf", file.json.dump());
    try {
      return is_tetrahedron(gltf::read(folder / "inner" / "a.gltf", {}, base::Host())) ? "read" : "another surface";
    } catch (const base::Error& error) {
      return error.kind();
    }
  };
  put(folder / "outside.bin", file.buffer);
  put(folder / "inner" / "b c.bin", file.buffer);
  put(folder / "inner" / "below" / "d.bin", file.buffer);
  std::filesystem::remove(folder / "inner" / "link.bin");
  std::filesystem::create_symlink(folder / "outside.bin", folder / "inner" / "link.bin");
  std::filesystem::create_symlink(folder / "inner" / "b c.bin", folder / "inner" / "inside.bin");
  CHECK(outcome("b%20c.bin") == "read");
  CHECK(outcome("b c.bin") == "read");
  CHECK(outcome("./below/d.bin") == "read");
  for (const char* uri : {"below/../b%20c.bin", "missing/../below/./d.bin", "below/%2e%2e/below//d.bin"}) {
    CAPTURE(uri);
    CHECK(outcome(uri) == "read");
  }
  CHECK(outcome("below/..") == "unsupported-uri");
  CHECK(outcome("inside.bin") == "read");
  CHECK(outcome("missing.bin") == "io");
  CHECK(outcome("below") == "unsafe-path");
  for (const char* uri : {"../outside.bin", "below/../../outside.bin", "%2e%2e/outside.bin", "..%2Foutside.bin",
                          "..\\outside.bin", "link.bin", "/dev/zero", "%2fdev%2fzero", "file:///etc/passwd",
                          "C:outside.bin", "HTTP://example.org/a.bin", "a\n.bin", "a%00.bin"}) {
    CAPTURE(uri);
    CHECK(outcome(uri) == "unsafe-path");
  }
  CHECK(outcome("b%2xc.bin") == "parse");
  CHECK(outcome("") == "unsupported-uri");
  CHECK(outcome("a.bin?x=1") == "unsupported-uri");
  CHECK(outcome("data:,plain") == "unsupported-uri");
  std::filesystem::remove_all(folder);

  file.json["buffers"][0]["uri"] = "a.bin";
  CHECK(kind_of(file.json.dump()) == "unsupported-uri");  // bytes in memory have no folder
}

TEST_CASE("Interleaved and offset elements are read at their stride") {
  MadeFile file = tetrahedron();
  std::array<float, 4 * 6> interleaved{};
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t axis = 0; axis < 6; ++axis)
      interleaved[6 * v + axis] = axis < 3 ? 99 : gltf::test::corner_positions[3 * v + axis - 3];
  }
  const std::size_t view = file.add_view(interleaved);
  file.json["bufferViews"][view]["byteStride"] = 24;
  file.json["accessors"][0]["bufferView"] = view;
  file.json["accessors"][0]["byteOffset"] = 12;
  CHECK(is_tetrahedron(read_text(file.glb())));
  // The last element need not be followed by a whole stride, but must be there itself.
  file.json["bufferViews"][view]["byteLength"] = 96;
  CHECK(is_tetrahedron(read_text(file.glb())));
  file.json["bufferViews"][view]["byteLength"] = 95;
  CHECK(kind_of(file.glb()) == "accessor-range");
}

TEST_CASE("Sparse values replace those of the base, or zeros") {
  MadeFile file = tetrahedron();
  const std::size_t elements = file.add_view(std::array<std::uint8_t, 3>{1, 2, 3});
  const std::size_t values = file.add_view(std::array<float, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  Json& accessor = file.json["accessors"][0];
  accessor.erase("bufferView");
  accessor["sparse"] = {{"count", 3},
                        {"indices", {{"bufferView", elements}, {"componentType", 5121}}},
                        {"values", {{"bufferView", values}}}};
  CHECK(is_tetrahedron(read_text(file.glb())));
  accessor["bufferView"] = 0;
  accessor["sparse"]["count"] = 1;
  accessor["sparse"]["values"]["byteOffset"] = 24;  // (0, 0, 1) for vertex 1
  const mesh::Mesh surface = read_text(file.glb());
  CHECK(surface.positions[1] == mesh::Vector3(0, 0, 1));
  CHECK(surface.positions[2] == mesh::Vector3(0, 1, 0));
}

TEST_CASE("Quantised positions are read with and without normalization, when the file says so") {
  MadeFile file = tetrahedron();
  std::array<std::int8_t, 12> bytes{};
  std::array<std::uint16_t, 12> words{};
  for (std::size_t i = 0; i < 12; ++i) {
    bytes[i] = static_cast<std::int8_t>(127 * gltf::test::corner_positions[i]);
    words[i] = static_cast<std::uint16_t>(1000 * gltf::test::corner_positions[i]);
  }
  const auto use = [&](std::size_t view, int component_type, bool normalized) {
    file.json["accessors"][0] = {{"bufferView", view},
                                 {"componentType", component_type},
                                 {"normalized", normalized},
                                 {"count", 4},
                                 {"type", "VEC3"}};
  };
  use(file.add_view(bytes), 5120, true);
  CHECK(kind_of(file.glb()) == "accessor-type");
  file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  CHECK(is_tetrahedron(read_text(file.glb())));
  use(file.add_view(words), 5123, false);
  CHECK(is_tetrahedron(read_text(file.glb()), 1000));
  use(file.add_view(words), 5123, true);
  CHECK(is_tetrahedron(read_text(file.glb()), 1000.0 / 65535.0));
  // -128 is -1 as well.
  use(file.add_view(std::array<std::int8_t, 12>{-128, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127}), 5120, true);
  CHECK(read_text(file.glb()).positions[0] == mesh::Vector3(-1, 0, 0));
}

TEST_CASE("Strips and fans give the triangles of the specification") {
  MadeFile file = tetrahedron();
  const std::size_t view = file.add_view(std::array<std::uint16_t, 6>{0, 1, 2, 3, 3, 0});
  file.json["accessors"][1] = {{"bufferView", view}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}};
  gltf::ReadOptions as_stored;
  as_stored.weld_identical = false;
  using Triangles = std::vector<mesh::Triangle>;
  const auto triangles = [&](int mode, std::size_t left_out) {
    file.json["meshes"][0]["primitives"][0]["mode"] = mode;
    mesh::ReadReport report;
    const mesh::Mesh surface = read_text(file.glb(), as_stored, &report);
    CHECK(report.notes.size() == (left_out > 0 ? 1 : 0));
    return Triangles(surface.triangles.begin(), surface.triangles.end());
  };
  // Triangles with equal corners join parts of a strip; the winding alternates.
  CHECK(triangles(5, 2) == Triangles{{0, 1, 2}, {1, 3, 2}});
  CHECK(triangles(6, 2) == Triangles{{1, 2, 0}, {2, 3, 0}});
  CHECK(triangles(4, 0) == Triangles{{0, 1, 2}, {3, 3, 0}});
}

TEST_CASE("Nodes place their meshes, and mirrors do not turn a surface inside out") {
  MadeFile file = tetrahedron();
  const double volume = volume_of(read_text(file.glb()));
  CHECK(volume == doctest::Approx(1.0 / 6));
  // A quarter turn about z and a stretch, below a shift.
  const double half = std::sqrt(0.5);
  file.json["nodes"] =
      Json::parse(R"([{"children": [1], "translation": [10, 0, 0]}, {"mesh": 0, "scale": [2, 3, 4]}])");
  file.json["nodes"][1]["rotation"] = {0.0, 0.0, half, half};
  const mesh::Mesh placed = read_text(file.glb());
  CHECK((placed.positions[1] - mesh::Vector3(10, 2, 0)).norm() < 1e-15 * 20);
  CHECK((placed.positions[2] - mesh::Vector3(7, 0, 0)).norm() < 1e-15 * 20);
  CHECK(volume_of(placed) == doctest::Approx(24 * volume));

  file.json["nodes"] = Json::parse(R"([{"mesh": 0, "scale": [-1, 1, 1]}])");
  mesh::ReadReport report;
  const mesh::Mesh mirrored = read_text(file.glb(), {}, &report);
  CHECK(volume_of(mirrored) == doctest::Approx(volume));
  CHECK(mirrored.positions[1] == mesh::Vector3(-1, 0, 0));
  CHECK(report.notes.size() == 1);

  // The same by a matrix, by columns.
  file.json["nodes"] = Json::parse(R"([{"mesh": 0, "matrix": [2,0,0,0, 0,0,2,0, 0,-2,0,0, 5,6,7,1]}])");
  const mesh::Mesh turned = read_text(file.glb());
  CHECK(turned.positions[2] == mesh::Vector3(5, 6, 9));
  CHECK(turned.positions[3] == mesh::Vector3(5, 4, 7));
  CHECK(volume_of(turned) == doctest::Approx(8 * volume));

  // A mesh that is shown twice is there twice; nodes outside the scene do not count.
  file.json["nodes"] = Json::parse(R"([{"mesh": 0}, {"mesh": 0, "translation": [2, 0, 0]}, {"mesh": 0}])");
  file.json["scenes"] = Json::parse(R"([{}, {"nodes": [0, 1]}])");
  file.json["scene"] = 1;
  CHECK(read_text(file.glb()).triangles.size() == 8);
  CHECK(read_text(file.glb()).positions.size() == 8);
  file.json.erase("scene");
  CHECK(kind_of(file.glb()) == "empty-mesh");  // the first scene is empty
  file.json.erase("scenes");
  CHECK(read_text(file.glb()).triangles.size() == 12);
  file.json.erase("nodes");
  CHECK(is_tetrahedron(read_text(file.glb())));
  // A chain of any length is no recursion.
  for (int i = 0; i < 20000; ++i)
    file.json["nodes"].push_back({{"children", {i + 1}}});
  file.json["nodes"].push_back({{"mesh", 0}});
  CHECK(is_tetrahedron(read_text(file.glb())));
}

TEST_CASE("Primitives that share positions share vertices") {
  MadeFile file = tetrahedron();
  file.json["accessors"][1]["count"] = 6;
  file.json["accessors"].push_back(file.json["accessors"][1]);
  file.json["accessors"][2]["byteOffset"] = 12;
  file.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"indices", 2}});
  mesh::ReadReport report;
  CHECK(is_tetrahedron(read_text(file.glb(), {}, &report)));
  CHECK(report.notes.empty());
  // Points and lines beside them are left out, and said.
  file.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  CHECK(is_tetrahedron(read_text(file.glb(), {}, &report)));
  CHECK(report.notes.size() == 1);
}

TEST_CASE("A soup of triangles and a surface with seams become closed, a closed one with twin vertices is left alone") {
  MadeFile file = tetrahedron();
  std::array<float, 36> soup{};
  for (std::size_t i = 0; i < 36; ++i)
    soup[i] = gltf::test::corner_positions[3U * gltf::test::corner_indices[i / 3] + i % 3];
  soup[0] = -0.0F;  // the same place as 0
  file.json["accessors"][0] = {
      {"bufferView", file.add_view(soup)}, {"componentType", 5126}, {"count", 12}, {"type", "VEC3"}};
  file.json["meshes"][0]["primitives"][0].erase("indices");
  mesh::ReadReport report;
  const mesh::Mesh joined = read_text(file.glb(), {}, &report);
  CHECK(joined.positions.size() == 4);
  CHECK(joined.triangles.size() == 4);
  CHECK(report.welded_vertices == 8);
  CHECK(mesh::topology(joined.positions, joined.triangles, base::Host()).genus == 0);
  gltf::ReadOptions as_stored;
  as_stored.weld_identical = false;
  CHECK(read_text(file.glb(), as_stored).positions.size() == 12);

  // Two tetrahedra that touch at every vertex, each closed: joining them would make edges of four triangles.
  MadeFile twice = tetrahedron();
  twice.json["nodes"].push_back({{"mesh", 0}});
  twice.json["scenes"][0]["nodes"] = {0, 1};
  CHECK(read_text(twice.glb(), {}, &report).positions.size() == 8);
  CHECK(report.welded_vertices == 0);
}

TEST_CASE("What is required and does not change positions is accepted, what may is not") {
  MadeFile file = tetrahedron();
  for (const char* name : {"KHR_materials_unlit", "KHR_texture_transform", "KHR_mesh_quantization"}) {
    file.json["extensionsRequired"] = {name};
    CHECK(is_tetrahedron(read_text(file.glb())));
  }
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_mesh_gpu_instancing", "X\n"}) {
    file.json["extensionsRequired"] = {name};
    CHECK(kind_of(file.glb()) == "unsupported-extension");
  }
  file.json.erase("extensionsRequired");
  file.json["asset"]["version"] = "2.1";
  CHECK(is_tetrahedron(read_text(file.glb())));
  file.json["asset"]["minVersion"] = "2.1";
  CHECK(kind_of(file.glb()) == "unsupported-version");
}

TEST_CASE("Nodes of scale 0 on all axes hide their meshes, those below them too; flattened ones are refused") {
  MadeFile file = tetrahedron();
  file.json["nodes"] = Json::parse(
      R"([{"mesh": 0}, {"mesh": 0, "scale": [0, 0, 0]}, {"scale": [0, 0, 0], "children": [3]}, {"mesh": 0}])");
  file.json["scenes"][0]["nodes"] = {0, 1, 2};
  mesh::ReadReport report;
  CHECK(is_tetrahedron(read_text(file.glb(), {}, &report)));
  CHECK(report.notes ==
        std::vector<std::string>{"2 meshes of nodes of scale 0, left out; the first is that of nodes[1]"});
  file.json["scenes"][0]["nodes"] = {1, 2};
  CHECK(kind_of(file.glb()) == "degenerate-geometry");
  file.json["nodes"][0]["scale"] = {1, 0, 1};
  file.json["scenes"][0]["nodes"] = {0};
  CHECK(kind_of(file.glb()) == "degenerate-geometry");
}

TEST_CASE("Morph targets count with their default weights, those of the node before those of the mesh") {
  MadeFile file = tetrahedron();
  for (int target = 0; target < 2; ++target) {
    std::array<float, 12> deltas{};
    deltas[static_cast<std::size_t>(9 + target)] = 4;  // of the last vertex, along x or y
    file.json["accessors"].push_back(
        {{"bufferView", file.add_view(deltas)}, {"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
    file.json["meshes"][0]["primitives"][0]["targets"].push_back({{"POSITION", 2 + target}});
  }
  mesh::ReadReport report;
  CHECK(is_tetrahedron(read_text(file.glb(), {}, &report)));
  CHECK(report.notes == std::vector<std::string>{"left out: 2 morph targets"});
  file.json["meshes"][0]["weights"] = {0.0, 0.0};
  CHECK(is_tetrahedron(read_text(file.glb())));
  file.json["meshes"][0]["weights"] = {0.0, 0.5};
  CHECK(read_text(file.glb(), {}, &report).positions[3] == mesh::Vector3(0, 2, 1));
  CHECK(report.notes ==
        std::vector<std::string>{"1 mesh with morph targets, taken with the weights that the file gives them"});
  file.json["nodes"][0]["weights"] = {0.25, -0.25};
  CHECK(read_text(file.glb()).positions[3] == mesh::Vector3(1, -1, 1));
  // One that is asked for counts in full, whatever the weights.
  file.json["meshes"][0]["extras"]["targetNames"] = {"a", "b"};
  gltf::ReadOptions options;
  options.morph_target = "b";
  CHECK(gltf::test::read_text(file.glb(), options).positions[3] == mesh::Vector3(0, 4, 1));
  file.json["nodes"][0]["weights"] = {0, 0, 1};
  CHECK(kind_of(file.glb()) == "parse");
  file.json["nodes"][0]["weights"] = {"x"};
  CHECK(kind_of(file.glb()) == "parse");
  file.json["nodes"][0]["weights"] = {1e300, 1};
  CHECK(kind_of(file.glb()) == "accepted");
}

TEST_CASE("What decorates a surface is counted in one note") {
  MadeFile file = tetrahedron();
  auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["TEXCOORD_0"] = 0;
  attributes["COLOR_0"] = 0;
  attributes["NORMAL"] = 0;
  file.json["materials"] = Json::array({Json::object(), Json::object()});
  file.json["textures"] = Json::array({Json::object()});
  file.json["skins"] = Json::array({Json::object()});
  file.json["animations"] = Json::array({Json::object()});
  file.json["cameras"] = Json::array({Json::object()});
  mesh::ReadReport report;
  CHECK(is_tetrahedron(read_text(file.glb(), {}, &report)));
  CHECK(report.notes == std::vector<std::string>{"left out: 2 materials, 1 texture, 1 primitive's texture coordinates, "
                                                 "1 primitive's colors, 1 skin, 1 animation, 1 camera"});
}
