// Writing: what is read again is what was given, bit for bit, and the text says what the specification asks for.
#include "gltf/writing/write.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "gltf/writing/checker.h"
#include "gltf/writing/morph.h"
#include "gltf/writing/normals.h"
#include "gltf/writing/tangents.h"
#include "made_files.h"

using namespace orbicube;
using gltf::Scene;
using gltf::test::Json;

namespace {

// A closed surface of n times m quads on a torus, in floats of all magnitudes.
struct Torus {
  std::vector<float> positions, other, texture_coordinates;
  std::vector<std::uint8_t> colors;
  std::vector<mesh::Triangle> triangles;
  std::vector<std::array<mesh::Index, 2>> edges;

  explicit Torus(std::uint32_t n = 20, std::uint32_t m = 12, std::uint32_t seed = 1) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(-0.01F, 0.01F), wide(-30, 30);
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::uint32_t j = 0; j < m; ++j) {
        const double u = 2 * M_PI * i / n, v = 2 * M_PI * j / m, r = 2 + std::cos(v);
        for (const double x : {r * std::cos(u), r * std::sin(u), std::sin(v)}) {
          positions.push_back(static_cast<float>(x) + jitter(random));
          other.push_back(std::ldexp(jitter(random), static_cast<int>(wide(random))));
        }
        for (const std::uint32_t x : {i, j}) {
          texture_coordinates.push_back(static_cast<float>(x) / static_cast<float>(n));
          for (const std::uint32_t channel : {x, x + 1})
            colors.push_back(static_cast<std::uint8_t>(channel));
        }
        const auto at = [&](std::uint32_t a, std::uint32_t b) { return a % n * m + b % m; };
        triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        edges.push_back({at(i, j), at(i + 1, j)});
      }
    }
  }

  Scene scene() const {
    Scene scene;
    scene.positions = positions;
    scene.triangles = triangles;
    return scene;
  }
};

std::string written(const Scene& scene, gltf::Form form = gltf::Form::glb) {
  const base::Array<std::byte> bytes = gltf::to_bytes(scene, form, base::Host());
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

// The document of a GLB file, and the bytes of an accessor.
struct Parts {
  explicit Parts(const std::string& glb) {
    const std::size_t length = word_at(glb, 12);
    json = Json::parse(glb.substr(20, length));
    buffer = glb.substr(28 + length);
  }
  template <class Value>
  std::vector<Value> values(std::size_t accessor) const {
    const Json& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
    std::vector<Value> result(view["byteLength"].get<std::size_t>() / sizeof(Value));
    std::memcpy(result.data(), buffer.data() + view.value("byteOffset", std::size_t{0}), result.size() * sizeof(Value));
    return result;
  }
  Json json;
  std::string buffer;
};

bool same_bits(std::span<const float> a, std::span<const float> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

std::string kind_of_writing(const Scene& scene) {
  try {
    written(scene);
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("A surface that is written and read again is the same to the bit, in both forms") {
  // 240 vertices have 16-bit indices, 70000 have 32-bit ones.
  for (const std::uint32_t n : {20U, 5000U}) {
    const Torus torus(n, 14);
    for (const gltf::Form form : {gltf::Form::glb, gltf::Form::gltf}) {
      mesh::ReadReport report;
      const mesh::Mesh surface = gltf::test::read_text(written(torus.scene(), form), {}, &report);
      REQUIRE(surface.positions.size() * 3 == torus.positions.size());
      bool same = true;
      for (std::size_t i = 0; i < torus.positions.size(); ++i)
        same = same && surface.positions[i / 3][static_cast<int>(i % 3)] == static_cast<double>(torus.positions[i]);
      CHECK(same);
      CHECK(std::equal(surface.triangles.begin(), surface.triangles.end(), torus.triangles.begin(),
                       torus.triangles.end()));
      CHECK(report.format == (form == gltf::Form::glb ? "GLB" : "glTF"));
      CHECK(report.welded_vertices == 0);
      CHECK(report.notes == std::vector<std::string>{"left out: 1 material"});
    }
  }
}

TEST_CASE("Everything that a scene holds is where the specification wants it") {
  const Torus torus;
  const base::Array<std::byte> png = gltf::checker_png({}, std::pmr::get_default_resource());
  const std::vector<gltf::MorphTarget> targets = {{"sphere \"1\"", torus.other}, {"Würfel", torus.positions}};
  Scene scene = torus.scene();
  scene.smooth_normals = true;
  scene.morph_normals = true;
  scene.texture_coordinates = torus.texture_coordinates;
  scene.colors = torus.colors;
  scene.morph_targets = targets;
  scene.morph_seconds = 2;
  scene.edges = torus.edges;
  scene.texture = png;
  scene.translation = {1, -2, 0.1};
  scene.scale = 3;
  scene.extras = R"({"energy": 0.1, "list": [1, {"deep": null}]})";
  scene.name = "torus";
  const Parts parts(written(scene));
  const Json& json = parts.json;

  CHECK(json["asset"]["version"] == "2.0");
  CHECK(json["scenes"][0]["extras"] == Json::parse(scene.extras));
  CHECK(json["nodes"][0]["translation"] == Json({1.0, -2.0, 0.1}));
  CHECK(json["nodes"][0]["scale"] == Json({3.0, 3.0, 3.0}));
  const Json& mesh = json["meshes"][0];
  CHECK(mesh["extras"]["targetNames"] == Json({"sphere \"1\"", "Würfel"}));
  CHECK(mesh["weights"] == Json({0.0, 0.0}));
  REQUIRE(mesh["primitives"].size() == 2);
  const Json& surface = mesh["primitives"][0];
  const auto accessor_of = [&](const char* name) { return surface["attributes"][name].get<std::size_t>(); };
  CHECK(same_bits(parts.values<float>(accessor_of("POSITION")), torus.positions));
  CHECK(same_bits(parts.values<float>(accessor_of("TEXCOORD_0")), torus.texture_coordinates));
  CHECK(parts.values<std::uint8_t>(accessor_of("COLOR_0")) == torus.colors);
  CHECK(json["accessors"][accessor_of("COLOR_0")]["normalized"] == true);
  const std::vector<float> normals = parts.values<float>(accessor_of("NORMAL"));
  for (std::size_t v = 0; v < normals.size(); v += 3)
    CHECK(std::hypot(normals[v], normals[v + 1], normals[v + 2]) == doctest::Approx(1).epsilon(1e-6));
  // On a torus about z, the normal leads away from the circle of radius 2.
  for (std::size_t v = 0; v < normals.size(); v += 3) {
    const double x = torus.positions[v], y = torus.positions[v + 1], r = std::hypot(x, y);
    CHECK(normals[v] * (x - 2 * x / r) + normals[v + 1] * (y - 2 * y / r) + normals[v + 2] * torus.positions[v + 2] >
          0.5);
  }
  CHECK(mesh["primitives"][1]["mode"] == 1);
  CHECK(mesh["primitives"][1]["targets"].size() == 2);
  CHECK(parts.values<std::uint16_t>(mesh["primitives"][1]["indices"].get<std::size_t>()).size() ==
        2 * torus.edges.size());
  const Json& image_view = json["bufferViews"][json["images"][0]["bufferView"].get<std::size_t>()];
  CHECK(std::memcmp(parts.buffer.data() + image_view.value("byteOffset", std::size_t{0}), png.data(), png.size()) == 0);
  CHECK_FALSE(image_view.contains("target"));

  // The animation goes to each target in turn and back.
  const Json& animation = json["animations"][0];
  CHECK(animation["channels"][0]["target"] == Json({{"node", 0}, {"path", "weights"}}));
  const Json& sampler = animation["samplers"][0];
  CHECK(parts.values<float>(sampler["input"].get<std::size_t>()) == std::vector<float>{0, 2, 4, 6});
  CHECK(parts.values<float>(sampler["output"].get<std::size_t>()) == std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0});
  const Json& times = json["accessors"][sampler["input"].get<std::size_t>()];
  CHECK(times["min"] == Json::array({0.0}));
  CHECK(times["max"] == Json::array({6.0}));
  CHECK_FALSE(json["bufferViews"][times["bufferView"].get<std::size_t>()].contains("target"));

  // Every accessor of positions, of morph targets too, has its exact bounds; views begin at multiples of four.
  for (const std::size_t accessor : {accessor_of("POSITION"), surface["targets"][0]["POSITION"].get<std::size_t>()}) {
    const std::vector<float> values = parts.values<float>(accessor);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      float least = values[axis], largest = values[axis];
      for (std::size_t i = axis; i < values.size(); i += 3) {
        least = std::min(least, values[i]);
        largest = std::max(largest, values[i]);
      }
      CHECK(json["accessors"][accessor]["min"][axis].get<float>() == least);
      CHECK(json["accessors"][accessor]["max"][axis].get<float>() == largest);
    }
  }
  for (const Json& view : json["bufferViews"])
    CHECK(view.value("byteOffset", std::size_t{0}) % 4 == 0);
}

TEST_CASE("Tangents go along the first texture coordinate, and tell mirrored textures") {
  const base::Host host;
  // A square that lies askew, counter-clockwise seen from above.
  const std::vector<float> positions = {0, 0, 0, 2, 0, 1, 2, 2, 1, 0, 2, 0};
  const std::vector<mesh::Triangle> triangles = {{0, 1, 2}, {0, 2, 3}};
  const base::Array<float> normals = gltf::smooth_normals(positions, triangles, host);
  // v goes down: (0, 1) is the corner at the bottom left.
  for (const float sign : {1.0F, -1.0F}) {
    const std::vector<float> coordinates = {0, 1, sign, 1, sign, 0, 0, 0};
    const base::Array<float> tangents = gltf::smooth_tangents(positions, normals, coordinates, triangles, host);
    REQUIRE(tangents.size() == 16);
    for (std::size_t v = 0; v < 4; ++v) {
      CHECK(tangents[4 * v] == doctest::Approx(sign * 2 / std::sqrt(5.0)));
      CHECK(tangents[4 * v + 1] == doctest::Approx(0));
      CHECK(tangents[4 * v + 2] == doctest::Approx(sign / std::sqrt(5.0)));
      CHECK(tangents[4 * v + 3] == sign);
    }
    Scene scene;
    scene.positions = positions;
    scene.triangles = triangles;
    scene.tangents = tangents;
    scene.texture_coordinates = coordinates;
    CHECK_THROWS_AS(written(scene), base::Error);  // without normals
    scene.normals = normals;
    CHECK(written(scene, gltf::Form::gltf).find("\"TANGENT\"") != std::string::npos);
  }
  // Without a direction in the texture, any that is across the normal.
  const std::vector<float> none(8, 0.5F);
  const base::Array<float> tangents = gltf::smooth_tangents(positions, normals, none, triangles, host);
  for (std::size_t v = 0; v < 4; ++v) {
    const float* const t = tangents.data() + 4 * v;
    const float* const n = normals.data() + 3 * v;
    CHECK(t[0] * t[0] + t[1] * t[1] + t[2] * t[2] == doctest::Approx(1));
    CHECK(t[0] * n[0] + t[1] * n[1] + t[2] * n[2] == doctest::Approx(0));
  }
}

TEST_CASE("A morph target is read with its base, in floats where a renderer gets it and in doubles here") {
  const Torus torus;
  const std::vector<gltf::MorphTarget> targets = {{"first", torus.positions}, {"second", torus.other}};
  Scene scene = torus.scene();
  scene.morph_targets = targets;
  const std::string file = written(scene);
  gltf::ReadOptions options;
  options.morph_target = "second";
  const mesh::Mesh morphed = gltf::test::read_text(file, options);
  const Parts parts(file);
  const Json& target = parts.json["meshes"][0]["primitives"][0]["targets"][1];
  const std::vector<float> deltas = parts.values<float>(target["POSITION"].get<std::size_t>());
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    const float base = torus.positions[i];
    CHECK(deltas[i] == gltf::delta_for(base, torus.other[i]));
    CHECK(morphed.positions[i / 3][static_cast<int>(i % 3)] == gltf::reconstructed_in_double(base, deltas[i]));
  }
  options.morph_target = "third";
  CHECK(gltf::test::kind_of(file, options) == "missing-attribute");
}

TEST_CASE("The delta of a morph target gives the wanted float whenever any float does") {
  // Floats around a pair of base and wanted one: no delta near the exact difference may do better.
  std::mt19937 random(5);
  std::uniform_int_distribution<std::uint32_t> bits;
  std::size_t exact = 0, tried = 0;
  while (tried < 20000) {
    const float base = std::bit_cast<float>(bits(random));
    const int distance = static_cast<int>(bits(random) % 80U) - 40;
    float wanted = std::ldexp(base, distance / 2) * (bits(random) % 2 == 0 ? 1.0F : -1.0F);
    wanted = std::bit_cast<float>(std::bit_cast<std::uint32_t>(wanted) ^ (bits(random) & 0xFFFFU));
    if (!std::isfinite(base) || !std::isfinite(wanted) || !std::isfinite(wanted - base)) continue;
    ++tried;
    const float delta = gltf::delta_for(base, wanted);
    const auto error_of = [&](float d) {
      return std::abs(static_cast<double>(gltf::reconstructed(base, d)) - static_cast<double>(wanted));
    };
    if (error_of(delta) == 0) {
      ++exact;
      continue;
    }
    float candidate = delta;
    for (int step = 0; step < 4; ++step) {
      candidate = std::nextafter(candidate, -std::numeric_limits<float>::infinity());
      REQUIRE(error_of(candidate) >= error_of(delta));
    }
    candidate = delta;
    for (int step = 0; step < 4; ++step) {
      candidate = std::nextafter(candidate, std::numeric_limits<float>::infinity());
      REQUIRE(error_of(candidate) >= error_of(delta));
    }
  }
  CHECK(exact > tried / 2);
  // Of values of like size every one is met.
  std::uniform_real_distribution<float> unit(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const float base = unit(random), wanted = base + 0.25F * unit(random);
    if (std::abs(wanted) >= std::abs(base) / 2)
      REQUIRE(gltf::reconstructed(base, gltf::delta_for(base, wanted)) == wanted);
  }
}

TEST_CASE("A scene that no valid file could hold is refused") {
  const Torus torus;
  CHECK(kind_of_writing(torus.scene()) == "accepted");
  const std::vector<float> short_values(7, 0.0F), not_finite(torus.positions.size(), NAN);
  const std::vector<mesh::Triangle> beyond = {{0, 1, 240}};
  const std::vector<std::array<mesh::Index, 2>> edge_beyond = {{0, 240}};
  const std::vector<gltf::MorphTarget> short_target = {{"short", short_values}}, bad_name = {{"\xFF", torus.positions}};
  const std::array<std::byte, 20> no_png{};
  std::vector<Scene> refused(19, torus.scene());
  refused[0].positions = short_values;
  refused[1].positions = not_finite;
  refused[2].triangles = {};
  refused[3].triangles = beyond;
  refused[4].normals = short_values;
  refused[5].normals = not_finite;
  refused[6].texture_coordinates = short_values;
  refused[7].edges = edge_beyond;
  refused[8].morph_targets = short_target;
  refused[9].morph_targets = bad_name;
  refused[10].scale = 0;
  refused[11].translation.x() = NAN;
  refused[12].base_color[1] = 1.5;
  refused[13].texture_coordinates = torus.texture_coordinates;
  refused[13].texture = no_png;
  refused[14].morph_normals = true;
  refused[15].extras = "[1]";
  refused[16].extras = "{" + std::string(100000, '[');
  refused[17].morph_seconds = 1;  // of what?
  refused[18].morph_seconds = -1;
  for (std::size_t i = 0; i < refused.size(); ++i) {
    CAPTURE(i);
    CHECK(kind_of_writing(refused[i]) == "invalid-argument");
  }
}

TEST_CASE("Writing to a path gives the same bytes, and leaves the old file when it fails") {
  const Torus torus;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "orbicube-gltf-write-test";
  std::filesystem::create_directories(folder);
  const auto content = [](const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  for (const char* name : {"a.glb", "a.gltf", "a.GLTF"}) {
    const std::filesystem::path path = folder / name;
    gltf::write(path, torus.scene(), base::Host());
    const bool binary = path.extension() == ".glb";
    CHECK(content(path) == written(torus.scene(), binary ? gltf::Form::glb : gltf::Form::gltf));
    const mesh::Mesh surface = gltf::read(path, {}, base::Host());
    CHECK(surface.triangles.size() == torus.triangles.size());
    // Cancelled in the middle, it leaves the old file and nothing beside it.
    const std::string before = content(path);
    int reports = 0;
    base::Host cancelling;
    cancelling.on_progress = [&](const base::Progress&) { return ++reports < 3; };
    CHECK_THROWS_AS(gltf::write(path, Torus(30).scene(), cancelling), base::Error);
    CHECK(content(path) == before);
  }
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder))
    ++files;
  CHECK(files == 3);
  std::filesystem::remove_all(folder);
}
