// Materials, textures, texture coordinates, colors, nodes, skins, animations and extras of a file, written again with
// its surface, with another shape of it, and with other triangles on it.
#include "gltf/kept/kept.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "decorated.h"
#include "gltf/writing/write.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using gltf::test::Decorated;
using gltf::test::Json;
using gltf::test::MadeFile;
using test::host;

namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

struct ReadFile {
  mesh::ReadReport report;
  std::unique_ptr<gltf::Kept> kept;
  mesh::Mesh surface;

  explicit ReadFile(const std::string& bytes) : surface(gltf::read(bytes_of(bytes), {}, {}, host, &report, &kept)) {}
};

// The document of a GLB and the numbers of its accessors.
struct Written {
  Json json;
  std::string buffer;

  explicit Written(const base::Array<std::byte>& glb) {
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, sizeof length);
    const auto* const text = reinterpret_cast<const char*>(glb.data());
    json = Json::parse(std::string(text + 20, length));
    buffer.assign(text + 28 + length, glb.size() - 28 - length);
  }

  std::string bytes(const Json& view) const {
    return buffer.substr(view.value("byteOffset", std::size_t{0}), view["byteLength"].get<std::size_t>());
  }

  template <class Value>
  std::vector<Value> values(const Json& number) const {
    const Json& accessor = json["accessors"][number.get<std::size_t>()];
    const std::string from = bytes(json["bufferViews"][accessor["bufferView"].get<std::size_t>()]);
    std::vector<Value> result(from.size() / sizeof(Value));
    std::memcpy(result.data(), from.data(), result.size() * sizeof(Value));
    return result;
  }

  const Json& attributes(std::size_t primitive) const {
    return json["meshes"][0]["primitives"][primitive]["attributes"];
  }
};

std::vector<float> floats_of(const mesh::Mesh& surface, double scale = 1) {
  std::vector<float> result;
  for (const mesh::Vector3& p : surface.positions) {
    for (const double x : p)
      result.push_back(static_cast<float>(scale * x));
  }
  return result;
}

bool same_surface(const mesh::Mesh& a, const mesh::Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

}  // namespace

TEST_CASE("A file that is written again has everything that it had, in both forms") {
  const Decorated made;
  const ReadFile read(made.file.glb());
  REQUIRE(read.kept != nullptr);
  CHECK(
      read.kept->decoration ==
      "left out: 2 materials, 1 texture, 2 primitives' texture coordinates, 2 primitives' colors, 1 skin, 1 animation");
  for (const std::string& note : read.report.notes)
    CHECK_FALSE(note.starts_with("left out"));
  for (const gltf::Form form : {gltf::Form::glb, gltf::Form::gltf}) {
    const base::Array<std::byte> bytes = gltf::to_bytes(*read.kept, form, host);
    CHECK(same_surface(gltf::read(bytes, {}, {}, host), read.surface));
    Json json = form == gltf::Form::glb
                    ? Written(bytes).json
                    : Json::parse(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    // Members are in another order, and defaults may be written.
    const auto same = [&](const char* pointer) {
      const Json::json_pointer at(pointer);
      return nlohmann::json::parse(json[at].dump()) == nlohmann::json::parse(made.file.json[at].dump());
    };
    for (const char* at :
         {"/scenes", "/nodes", "/skins", "/materials", "/textures", "/images", "/meshes/0/name", "/meshes/0/extras",
          "/meshes/0/primitives/1/attributes", "/meshes/0/primitives/1/material"}) {
      CAPTURE(at);
      CHECK(same(at));
    }
    CHECK(json["animations"][0]["channels"] == made.file.json["animations"][0]["channels"]);
    CHECK(json["accessors"].size() == made.file.json["accessors"].size());
    CHECK(json["bufferViews"].size() == made.file.json["bufferViews"].size());
  }
  // The bytes of every view are those of the file.
  const Written written(gltf::to_bytes(*read.kept, gltf::Form::glb, host));
  for (std::size_t i = 0; i < made.file.json["bufferViews"].size(); ++i) {
    const Json& view = made.file.json["bufferViews"][i];
    CHECK(written.bytes(written.json["bufferViews"][i]) ==
          made.file.buffer.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>()));
  }
}

TEST_CASE("Another shape of the surface keeps seams, materials, skin and image") {
  const Decorated made;
  const ReadFile read(made.file.glb());
  REQUIRE(read.kept != nullptr);
  CHECK(read.surface.positions.size() == (Decorated::rows - 1) * Decorated::columns + 2);
  const std::vector<float> positions = floats_of(read.surface), target = floats_of(read.surface, 2);
  const std::vector<gltf::MorphTarget> targets = {{"twice", target}};
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = read.surface.triangles;
  scene.smooth_normals = scene.morph_normals = true;
  scene.morph_targets = targets;
  scene.morph_seconds = 1;
  scene.kept = read.kept.get();
  const base::Array<std::byte> bytes = gltf::to_bytes(scene, gltf::Form::glb, host);
  const Written written(bytes);
  CHECK(same_surface(gltf::read(bytes, {}, {}, host), read.surface));
  gltf::ReadOptions options;
  options.morph_target = "twice";
  const mesh::Mesh twice = gltf::read(bytes, {}, options, host);
  REQUIRE(twice.positions.size() == read.surface.positions.size());
  for (std::size_t v = 0; v < twice.positions.size(); ++v)
    CHECK(twice.positions[v] == 2 * read.surface.positions[v]);

  const Json& json = written.json;
  CHECK(json["meshes"][0]["extras"] == Json({{"note", "kept"}, {"targetNames", {"twice"}}}));
  CHECK(json["nodes"][0]["mesh"] == 0);
  CHECK(json["nodes"][0]["skin"] == 0);
  CHECK(json["nodes"][0]["extras"]["id"] == 7);
  CHECK(json["nodes"][1]["name"] == "root");
  CHECK(json["skins"][0]["joints"] == Json({1, 2}));
  CHECK(json["materials"][0]["extras"]["k"] == Json({1, 2}));
  CHECK(json["scenes"][0]["extras"]["author"] == "A");
  REQUIRE(json["animations"].size() == 2);
  CHECK(json["animations"][0]["name"] == "bend");
  CHECK(json["animations"][1]["channels"][0]["target"]["node"] == 0);
  // Each vertex of the file has its own coordinates, on both sides of the seam.
  for (std::size_t primitive = 0; primitive < 2; ++primitive) {
    CHECK(json["meshes"][0]["primitives"][primitive]["material"] == primitive);
    const auto coordinates = written.values<float>(written.attributes(primitive)["TEXCOORD_0"]);
    REQUIRE(coordinates.size() == 2 * (Decorated::rows + 1) * (Decorated::columns + 1));
    const auto weights = written.values<float>(written.attributes(primitive)["WEIGHTS_0"]);
    for (std::size_t v = 0; 2 * v < coordinates.size(); ++v) {
      const auto wanted = Decorated::texture_coordinate(v / (Decorated::columns + 1), v % (Decorated::columns + 1));
      CHECK(coordinates[2 * v] == wanted[0]);
      CHECK(coordinates[2 * v + 1] == wanted[1]);
      CHECK(weights[4 * v] + weights[4 * v + 1] == 1);
    }
    CHECK(written.values<std::uint8_t>(written.attributes(primitive)["COLOR_0"]).size() == 2 * coordinates.size());
  }
  const Json& image = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
  CHECK(written.bytes(image).starts_with("\x89PNG"));
  CHECK(written.values<float>(json["skins"][0]["inverseBindMatrices"])[13] == 1);
}

TEST_CASE("A skin takes positions from where they are stored to where the file has them") {
  const Decorated made;
  const ReadFile read(made.file.glb());
  REQUIRE(read.kept != nullptr);
  const std::vector<float> positions = floats_of(read.surface, 0.25);
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = read.surface.triangles;
  scene.scale = 4;
  scene.translation = {1, 2, 3};
  scene.kept = read.kept.get();
  const Written written(gltf::to_bytes(scene, gltf::Form::glb, host));
  const auto matrices = written.values<float>(written.json["skins"][0]["inverseBindMatrices"]);
  // The first is a shift by 1 along y: by columns, 4 on the diagonal, and the shifts of both added.
  const std::vector<float> wanted = {4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 4, 0, 1, 3, 3, 1};
  CHECK(std::vector<float>(matrices.begin(), matrices.begin() + 16) == wanted);
  CHECK_FALSE(written.json["nodes"][0].contains("scale"));  // which would not count
}

TEST_CASE("Triangles on those of the file get what its attributes are there, and no vertex spans a seam") {
  const Decorated made;
  const ReadFile read(made.file.glb());
  REQUIRE(read.kept != nullptr);
  // Each triangle in three, with its middle.
  std::vector<float> positions = floats_of(read.surface);
  std::vector<mesh::Triangle> triangles;
  std::vector<gltf::KeptTriangle> on;
  const auto corner = [](std::size_t t, std::size_t k) {
    std::array<double, 3> weights{};
    k < 3 ? static_cast<void>(weights[k] = 1) : weights.fill(1.0 / 3);
    return gltf::KeptTriangle::Corner{static_cast<mesh::Index>(t), weights, weights};
  };
  for (std::size_t t = 0; t < read.surface.triangles.size(); ++t) {
    const mesh::Triangle& corners = read.surface.triangles[t];
    const auto middle = static_cast<mesh::Index>(positions.size() / 3);
    for (int axis = 0; axis < 3; ++axis) {
      positions.push_back(
          static_cast<float>((read.surface.positions[corners[0]][axis] + read.surface.positions[corners[1]][axis] +
                              read.surface.positions[corners[2]][axis]) /
                             3));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      triangles.push_back({corners[k], corners[(k + 1) % 3], middle});
      // The corners lie in any triangle of the vertex; here, in the first that has it.
      gltf::KeptTriangle kept{static_cast<mesh::Index>(t), {corner(t, k), corner(t, (k + 1) % 3), corner(t, 3)}};
      for (std::size_t c = 0; c < 2; ++c) {
        const mesh::Index v = triangles.back()[c];
        for (std::size_t s = 0; s < read.surface.triangles.size(); ++s) {
          const mesh::Triangle& other = read.surface.triangles[s];
          const auto found = std::find(other.begin(), other.end(), v);
          if (found == other.end()) continue;
          kept.corners[c].triangle = static_cast<mesh::Index>(s);
          kept.corners[c].weights = corner(s, static_cast<std::size_t>(found - other.begin())).weights;
          break;
        }
      }
      on.push_back(kept);
    }
  }
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = triangles;
  scene.kept = read.kept.get();
  scene.kept_surface = read.surface.triangles;
  scene.kept_triangles = on;
  const Written written(gltf::to_bytes(scene, gltf::Form::glb, host));
  std::size_t written_triangles = 0;
  for (std::size_t primitive = 0; primitive < 2; ++primitive) {
    const auto coordinates = written.values<float>(written.attributes(primitive)["TEXCOORD_0"]);
    const auto places = written.values<float>(written.attributes(primitive)["POSITION"]);
    const auto weights = written.values<float>(written.attributes(primitive)["WEIGHTS_0"]);
    const auto indices = written.values<std::uint16_t>(written.json["meshes"][0]["primitives"][primitive]["indices"]);
    written_triangles += indices.size() / 3;
    for (std::size_t v = 0; 2 * v < coordinates.size(); ++v) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k)
        sum += static_cast<double>(weights[4 * v + k]);
      CHECK(sum == doctest::Approx(1).epsilon(1e-6));
    }
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      float least = 2, most = -1;
      for (std::size_t k = 0; k < 3; ++k) {
        least = std::min(least, coordinates[2U * indices[i + k]]);
        most = std::max(most, coordinates[2U * indices[i + k]]);
        // Rows of the file stand at fixed heights.
        const double height = static_cast<double>(places[3U * indices[i + k] + 1]);
        if (std::abs(height) == 1) CHECK(coordinates[2U * indices[i + k] + 1] == (height > 0 ? 0.0F : 1.0F));
      }
      CHECK(most - least <= 1.0F / Decorated::columns + 1e-6F);
    }
  }
  CHECK(written_triangles == triangles.size());
}

TEST_CASE("Meshes of placed nodes move to nodes of their own, in the order in which they are read") {
  Decorated made;
  Json& json = made.file.json;
  json["nodes"] = Json::parse(R"([{"name": "hips", "translation": [3, 0, 0], "scale": [2, 2, 2], "children": [1]},
                                  {"name": "body", "mesh": 0}, {"name": "other", "mesh": 0, "translation": [0, 0, 9]}])");
  json["scenes"][0]["nodes"] = {0, 2};
  json.erase("skins");
  json.erase("animations");
  const ReadFile read(made.file.glb());
  REQUIRE(read.kept != nullptr);
  const std::vector<float> positions = floats_of(read.surface);
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = read.surface.triangles;
  scene.kept = read.kept.get();
  const base::Array<std::byte> bytes = gltf::to_bytes(scene, gltf::Form::glb, host);
  const Written written(bytes);
  CHECK(written.json["nodes"].size() == 5);
  CHECK_FALSE(written.json["nodes"][1].contains("mesh"));
  CHECK(written.json["meshes"].size() == 2);
  const mesh::Mesh again = gltf::read(bytes, {}, {}, host);
  CHECK(again.triangles == read.surface.triangles);
  REQUIRE(again.positions.size() == read.surface.positions.size());
  for (std::size_t v = 0; v < again.positions.size(); ++v)
    CHECK((again.positions[v] - read.surface.positions[v]).norm() < 1e-5);
  // Normals are turned with the node, and stay unit vectors.
  const auto normals = written.values<float>(written.attributes(0)["NORMAL"]);
  for (std::size_t i = 0; i < normals.size(); i += 3)
    CHECK(std::hypot(normals[i], normals[i + 1], normals[i + 2]) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("What cannot be kept is said, and the surface is read all the same") {
  const mesh::Mesh surface = ReadFile(Decorated().file.glb()).surface;
  struct Fault {
    const char *pointer, *value;
  };
  for (const Fault& fault :
       {Fault{"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "5"}, Fault{"/materials", "[7]"},
        Fault{"/textures/0/source", "1"}, Fault{"/images/0/bufferView", "99"},
        Fault{"/images/0", R"({"uri": "../secret.png"})"}, Fault{"/images/0", R"({"uri": "file:///etc/passwd"})"},
        Fault{"/skins/0/joints", "[1, 9]"}, Fault{"/skins/0/inverseBindMatrices", "0"},
        Fault{"/accessors/6/count", "1"}, Fault{"/accessors/2/count", "7"}, Fault{"/accessors/10/byteOffset", "4096"},
        Fault{"/animations/0/channels/0/sampler", "1"}, Fault{"/animations/0/samplers/0/input", "77"},
        Fault{"/cameras", "[{}]"}}) {
    CAPTURE(fault.pointer);
    CAPTURE(fault.value);
    Decorated made;
    made.file.json[Json::json_pointer(fault.pointer)] = Json::parse(fault.value);
    const ReadFile read(made.file.glb());
    CHECK(read.kept == nullptr);
    CHECK(same_surface(read.surface, surface));
    REQUIRE_FALSE(read.report.notes.empty());
    CHECK(read.report.notes.back().starts_with("materials, textures, skins and the like cannot be kept: "));
  }
  Decorated not_finite;
  const std::size_t at = not_finite.file.json["bufferViews"][2]["byteOffset"].get<std::size_t>();
  const float nan = NAN;
  std::memcpy(not_finite.file.buffer.data() + at, &nan, sizeof nan);
  CHECK(ReadFile(not_finite.file.glb()).kept == nullptr);
}

TEST_CASE("Images in base64 and in files of the folder come into the file") {
  Decorated made;
  const Json view = made.file.json["bufferViews"][made.file.json["images"][0]["bufferView"].get<std::size_t>()];
  const std::string png =
      made.file.buffer.substr(view["byteOffset"].get<std::size_t>(), view["byteLength"].get<std::size_t>());
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "orbicube-gltf-kept-test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "paint.png", std::ios::binary) << png;
  made.file.json["images"] = Json::parse(R"([{"uri": "paint.png"}, {"uri": "missing.png"}])");
  std::ofstream(folder / "a.glb", std::ios::binary) << made.file.glb();
  std::unique_ptr<gltf::Kept> kept;
  gltf::read(folder / "a.glb", {}, host, nullptr, &kept);
  REQUIRE(kept != nullptr);
  const Written written(gltf::to_bytes(*kept, gltf::Form::glb, host));
  const Json& images = written.json["images"];
  CHECK(written.bytes(written.json["bufferViews"][images[0]["bufferView"].get<std::size_t>()]) == png);
  CHECK(images[0]["mimeType"] == "image/png");
  CHECK(images[1]["uri"] == "missing.png");
  std::filesystem::remove_all(folder);
}

TEST_CASE("Objects without members stay objects") {
  Decorated made;
  made.file.json["nodes"].push_back(Json::object());
  made.file.json["scenes"][0]["nodes"].push_back(3);
  made.file.json["materials"].push_back(Json::object());
  made.file.json["textures"].push_back(Json::object());
  const ReadFile read(made.file.glb());
  REQUIRE(read.kept != nullptr);
  const Written written(gltf::to_bytes(*read.kept, gltf::Form::glb, host));
  CHECK(written.json["nodes"][3].is_object());
  CHECK(written.json["materials"][2].is_object());
  CHECK(written.json["textures"][1].is_object());
}

TEST_CASE("Triangles of another surface are refused") {
  const ReadFile read(Decorated().file.glb());
  const std::vector<float> positions = floats_of(read.surface);
  const auto refused = [&](std::span<const mesh::Triangle> triangles) {
    gltf::Scene scene;
    scene.positions = positions;
    scene.triangles = triangles;
    scene.kept = read.kept.get();
    try {
      gltf::to_bytes(scene, gltf::Form::glb, host);
    } catch (const base::Error& error) {
      return std::string(error.kind()) == "invalid-argument";
    }
    return false;
  };
  std::vector<mesh::Triangle> triangles(read.surface.triangles.begin(), read.surface.triangles.end());
  CHECK_FALSE(refused(triangles));
  std::swap(triangles[0][0], triangles[0][1]);  // turned
  CHECK_FALSE(refused(triangles));
  std::swap(triangles[0], triangles[9]);
  CHECK(refused(triangles));
  triangles.pop_back();
  CHECK(refused(triangles));
}
