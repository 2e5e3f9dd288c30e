// The C interface of gltf: arguments, sizes of structs, memory, cancelling, and the way there and back.
#include "orbicube/gltf.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "failing_allocations.h"

using namespace orbicube;

namespace {

struct Destroy {
  void operator()(obc_gltf_surface* surface) const { obc_gltf_surface_destroy(surface); }
};
using Handle = std::unique_ptr<obc_gltf_surface, Destroy>;

// An octahedron, the same blown up to a sphere's positions, and all that a scene may have.
struct Fixture {
  std::array<float, 18> positions{1, 0, 0, -1, 0, 0, 0, 1.5F, 0, 0, -1.5F, 0, 0, 0, 0.1F, 0, 0, -0.1F};
  std::array<float, 18> sphere{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  std::array<float, 12> texture_coordinates{0, 0, 1, 0, 0.5F, 0, 0, 1, 1, 1, 0.5F, 1};
  std::array<std::uint8_t, 24> colors{};
  std::array<std::uint32_t, 24> triangles{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  std::array<std::uint32_t, 4> edges{0, 2, 2, 1};
  obc_gltf_morph_target target{"sphere", sphere.data()};
  obc_gltf_scene scene{};
  std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                 ("orbicube-capi-gltf-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)));
  std::string path = (folder / "a.glb").string(), text_path = (folder / "a.gltf").string();

  Fixture() {
    REQUIRE(obc_gltf_scene_init(&scene, sizeof scene) == OBC_OK);
    scene.positions = positions.data();
    scene.vertex_count = 6;
    scene.triangles = triangles.data();
    scene.triangle_count = 8;
    scene.smooth_normals = 1;
    scene.morph_normals = 1;
    scene.texture_coordinates = texture_coordinates.data();
    scene.colors = colors.data();
    scene.morph_targets = &target;
    scene.morph_target_count = 1;
    scene.edges = edges.data();
    scene.edge_count = 2;
    scene.checker_texture = 1;
    scene.name = "octahedron";
    scene.extras = "{\"a\": [1, 2]}";
    std::filesystem::create_directories(folder);
  }
  ~Fixture() { std::filesystem::remove_all(folder); }
  Fixture(const Fixture&) = delete;
  Fixture& operator=(const Fixture&) = delete;

  std::string write_and_load(const std::string& where) const {
    REQUIRE(obc_gltf_write(where.c_str(), &scene, nullptr, nullptr) == OBC_OK);
    std::ifstream file(where, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

}  // namespace

TEST_CASE("A surface goes to a file and comes back through C, with its morph target") {
  const Fixture fixture;
  for (const std::string& path : {fixture.path, fixture.text_path}) {
    obc_error error;
    REQUIRE(obc_gltf_write(path.c_str(), &fixture.scene, nullptr, &error) == OBC_OK);
    obc_gltf_read_options options;
    REQUIRE(obc_gltf_read_options_init(&options, sizeof options) == OBC_OK);
    for (const char* morph : {static_cast<const char*>(nullptr), "sphere"}) {
      options.morph_target = morph;
      obc_gltf_surface* raw = nullptr;
      REQUIRE(obc_gltf_read(path.c_str(), &options, nullptr, &raw, &error) == OBC_OK);
      const Handle surface(raw);
      REQUIRE(obc_gltf_surface_vertex_count(raw) == 6);
      REQUIRE(obc_gltf_surface_triangle_count(raw) == 8);
      CHECK(obc_gltf_surface_welded_vertex_count(raw) == 0);
      std::array<double, 18> positions;
      std::array<std::uint32_t, 24> triangles;
      REQUIRE(obc_gltf_surface_copy(raw, positions.data(), triangles.data(), &error) == OBC_OK);
      CHECK(triangles == fixture.triangles);
      for (std::size_t i = 0; i < 18; ++i) {
        const float base = fixture.positions[i], wanted = morph != nullptr ? fixture.sphere[i] : base;
        CHECK(static_cast<float>(positions[i]) == wanted);
        CHECK(obc_gltf_reconstructed(base, obc_gltf_delta(base, wanted)) == wanted);
      }
      CHECK(obc_gltf_surface_copy(raw, nullptr, nullptr, nullptr) == OBC_OK);
      // The edges are lines, which are left out, and so is what decorates the surface.
      REQUIRE(obc_gltf_surface_note_count(raw) == 2);
      CHECK(std::strlen(obc_gltf_surface_note(raw, 0)) > 0);
      CHECK(std::string(obc_gltf_surface_note(raw, 1)).starts_with("left out: "));
      CHECK(obc_gltf_surface_note(raw, 2) == nullptr);
    }
  }
  REQUIRE(obc_gltf_write_surface(fixture.path.c_str(), fixture.positions.data(), 6, fixture.triangles.data(), 8,
                                 nullptr, nullptr) == OBC_OK);
  obc_gltf_surface* plain = nullptr;
  REQUIRE(obc_gltf_read(fixture.path.c_str(), nullptr, nullptr, &plain, nullptr) == OBC_OK);
  CHECK(obc_gltf_surface_note_count(plain) == 1);
  obc_gltf_surface_destroy(plain);
}

TEST_CASE("What a file has besides its surface is kept for another shape, for other triangles, and as it is") {
  const Fixture fixture;
  obc_error error;
  REQUIRE(obc_gltf_write(fixture.path.c_str(), &fixture.scene, nullptr, &error) == OBC_OK);
  obc_gltf_read_options options;
  REQUIRE(obc_gltf_read_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.keep == 0);
  options.keep = 1;
  const auto read = [&](const std::string& path) {
    obc_gltf_surface* surface = nullptr;
    REQUIRE(obc_gltf_read(path.c_str(), &options, nullptr, &surface, &error) == OBC_OK);
    return Handle(surface);
  };
  const Handle kept = read(fixture.path);
  CHECK(obc_gltf_surface_keeps(kept.get()) == 1);
  CHECK(obc_gltf_surface_keeps(nullptr) == 0);

  const auto has_texture = [&](const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(file), {}};
    return content.find("TEXCOORD_0") != std::string::npos && content.find("\x89PNG") != std::string::npos &&
           content.find("COLOR_0") != std::string::npos;
  };
  const std::string path = (fixture.folder / "kept.glb").string();
  obc_gltf_scene scene;
  REQUIRE(obc_gltf_scene_init(&scene, sizeof scene) == OBC_OK);
  scene.positions = fixture.sphere.data();
  scene.vertex_count = 6;
  scene.triangles = fixture.triangles.data();
  scene.triangle_count = 8;
  scene.kept = kept.get();
  REQUIRE(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_OK);
  CHECK(has_texture(path));
  const Handle moved = read(path);
  std::array<double, 18> positions{};
  REQUIRE(obc_gltf_surface_copy(moved.get(), positions.data(), nullptr, &error) == OBC_OK);
  for (std::size_t i = 0; i < 18; ++i)
    CHECK(positions[i] == double{fixture.sphere[i]});

  // Half of the triangles, each at its place.
  scene.triangle_count = 4;
  CHECK(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_INVALID_ARGUMENT);
  std::array<double, 18> places{};
  std::copy(fixture.positions.begin(), fixture.positions.end(), places.begin());
  scene.kept_positions = places.data();
  REQUIRE(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_OK);
  CHECK(has_texture(path));
  CHECK(obc_gltf_surface_triangle_count(read(path).get()) == 4);

  REQUIRE(obc_gltf_write_kept(path.c_str(), kept.get(), nullptr, &error) == OBC_OK);
  CHECK(has_texture(path));

  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    places[7] = bad;
    CHECK(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_INVALID_ARGUMENT);
  }
  const std::array<std::uint32_t, 3> beyond{0, 1, 6};
  places[7] = 1;
  scene.triangles = beyond.data();
  scene.triangle_count = 1;
  CHECK(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_INVALID_ARGUMENT);
  scene.triangles = fixture.triangles.data();
  scene.kept = nullptr;
  CHECK(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_INVALID_ARGUMENT);
  options.keep = 0;
  const Handle plain = read(fixture.path);
  CHECK(obc_gltf_surface_keeps(plain.get()) == 0);
  scene.kept = plain.get();
  CHECK(obc_gltf_write(path.c_str(), &scene, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_write_kept(path.c_str(), plain.get(), nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_write_kept(path.c_str(), nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  options.keep = 2;
  obc_gltf_surface* none = nullptr;
  CHECK(obc_gltf_read(fixture.path.c_str(), &options, nullptr, &none, &error) == OBC_INVALID_ARGUMENT);
  CHECK(none == nullptr);
}

TEST_CASE("Each allocation of keeping the rest of a file fails in turn and nothing is leaked") {
  const Fixture fixture;
  const std::string bytes = fixture.write_and_load(fixture.path), path = (fixture.folder / "kept.glb").string();
  obc_gltf_read_options options;
  obc_gltf_read_options_init(&options, sizeof options);
  options.keep = 1;
  std::array<double, 18> places{};
  std::copy(fixture.positions.begin(), fixture.positions.end(), places.begin());
  const test::Outcome outcome = test::fail_each_allocation([&](const obc_host& host) {
    obc_gltf_surface* surface = nullptr;
    obc_status status = obc_gltf_read_memory(bytes.data(), bytes.size(), nullptr, &options, &host, &surface, nullptr);
    obc_gltf_scene scene;
    obc_gltf_scene_init(&scene, sizeof scene);
    scene.positions = fixture.sphere.data();
    scene.vertex_count = 6;
    scene.triangles = fixture.triangles.data();
    scene.triangle_count = 8;
    scene.kept = surface;
    scene.kept_positions = places.data();
    if (status == OBC_OK) status = obc_gltf_write(path.c_str(), &scene, &host, nullptr);
    if (status == OBC_OK) status = obc_gltf_write_kept(path.c_str(), surface, &host, nullptr);
    obc_gltf_surface_destroy(surface);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 20);
}

TEST_CASE("Each allocation of reading and writing fails in turn and nothing is leaked") {
  const Fixture fixture;
  for (const std::string& path : {fixture.path, fixture.text_path}) {
    const std::string bytes = fixture.write_and_load(path);
    obc_gltf_read_options options;
    obc_gltf_read_options_init(&options, sizeof options);
    options.morph_target = "sphere";
    const test::Outcome from_memory = test::fail_each_allocation([&](const obc_host& host) {
      obc_gltf_surface* surface = nullptr;
      const obc_status status =
          obc_gltf_read_memory(bytes.data(), bytes.size(), nullptr, &options, &host, &surface, nullptr);
      if (status != OBC_OK) CHECK(surface == nullptr);
      obc_gltf_surface_destroy(surface);
      return status;
    });
    CHECK(from_memory.problem == "");
    CHECK(from_memory.runs > 20);
    const test::Outcome from_file = test::fail_each_allocation([&](const obc_host& host) {
      obc_gltf_surface* surface = nullptr;
      const obc_status status = obc_gltf_read(path.c_str(), nullptr, &host, &surface, nullptr);
      obc_gltf_surface_destroy(surface);
      return status;
    });
    CHECK(from_file.problem == "");
    const test::Outcome writing = test::fail_each_allocation(
        [&](const obc_host& host) { return obc_gltf_write(path.c_str(), &fixture.scene, &host, nullptr); });
    CHECK(writing.problem == "");
    CHECK(writing.runs > 50);
  }
  // Neither whole files nor pieces of them are left over.
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(fixture.folder))
    ++files;
  CHECK(files == 2);
}

TEST_CASE("Reading and writing can be cancelled at every report") {
  const Fixture fixture;
  for (const std::string& path : {fixture.path, fixture.text_path}) {
    const std::string bytes = fixture.write_and_load(path);
    const test::Outcome reading = test::cancel_everywhere([&](const obc_host& host) {
      obc_gltf_surface* surface = nullptr;
      const obc_status status = obc_gltf_read(path.c_str(), nullptr, &host, &surface, nullptr);
      obc_gltf_surface_destroy(surface);
      return status;
    });
    CHECK(reading.problem == "");
    CHECK(reading.runs > 5);
    const test::Outcome writing = test::cancel_everywhere(
        [&](const obc_host& host) { return obc_gltf_write(path.c_str(), &fixture.scene, &host, nullptr); });
    CHECK(writing.problem == "");
    CHECK(writing.runs > 3);
    std::ifstream file(path, std::ios::binary);
    CHECK(std::string(std::istreambuf_iterator<char>(file), {}) == bytes);
  }
}

TEST_CASE("Arguments that cannot be are refused") {
  const Fixture fixture;
  obc_error error;
  obc_gltf_surface* surface = nullptr;
  const std::string bytes = fixture.write_and_load(fixture.path);
  CHECK(obc_gltf_read(nullptr, nullptr, nullptr, &surface, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_read(fixture.path.c_str(), nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_read_memory(nullptr, 7, nullptr, nullptr, nullptr, &surface, &error) == OBC_INVALID_ARGUMENT);
  surface = reinterpret_cast<obc_gltf_surface*>(&error);
  CHECK(obc_gltf_read_memory(nullptr, 0, nullptr, nullptr, nullptr, &surface, &error) == OBC_MALFORMED_FILE);
  CHECK(surface == nullptr);
  CHECK(std::string(error.kind) == "empty-file");
  CHECK(obc_gltf_read_memory(bytes.data(), bytes.size() - 1, nullptr, nullptr, nullptr, &surface, &error) ==
        OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "truncated");
  const std::string missing = (fixture.folder / "missing.glb").string();
  CHECK(obc_gltf_read(missing.c_str(), nullptr, nullptr, &surface, &error) == OBC_IO);
  CHECK(std::string(error.message).rfind(missing + ": ", 0) == 0);
  obc_gltf_read_options options{};
  CHECK(obc_gltf_read(fixture.path.c_str(), &options, nullptr, &surface, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_read_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_read_options_init(&options, 2) == OBC_INVALID_ARGUMENT);
  CHECK(obc_gltf_scene_init(nullptr, sizeof(obc_gltf_scene)) == OBC_INVALID_ARGUMENT);

  const auto refused = [&](const char* path, const obc_gltf_scene* scene) {
    return obc_gltf_write(path, scene, nullptr, &error) == OBC_INVALID_ARGUMENT && error.message[0] != '\0';
  };
  const char* const path = fixture.path.c_str();
  CHECK(refused(nullptr, &fixture.scene));
  CHECK(refused(path, nullptr));
  for (int which = 0; which < 12; ++which) {
    CAPTURE(which);
    obc_gltf_scene scene = fixture.scene;
    const obc_gltf_morph_target no_name = {nullptr, fixture.sphere.data()}, no_positions = {"x", nullptr};
    if (which == 0) scene.struct_size = 0;
    if (which == 1) scene.positions = nullptr;
    if (which == 2) scene.triangles = nullptr;
    if (which == 3) scene.vertex_count = 5;  // a triangle goes beyond
    if (which == 4) scene.vertex_count = SIZE_MAX / 2;
    if (which == 5) scene.triangle_count = SIZE_MAX / 2;
    if (which == 6) scene.morph_targets = nullptr;
    if (which == 7) scene.morph_targets = &no_name;
    if (which == 8) scene.morph_targets = &no_positions;
    if (which == 9) scene.scale = std::numeric_limits<double>::quiet_NaN();
    if (which == 10) scene.extras = "[]";
    if (which == 11) scene.name = "\xC3";
    CHECK(refused(path, &scene));
  }
  CHECK(obc_gltf_write((fixture.folder / "no" / "a.glb").string().c_str(), &fixture.scene, nullptr, &error) == OBC_IO);

  CHECK(obc_gltf_surface_vertex_count(nullptr) == 0);
  CHECK(obc_gltf_surface_triangle_count(nullptr) == 0);
  CHECK(obc_gltf_surface_welded_vertex_count(nullptr) == 0);
  CHECK(obc_gltf_surface_note_count(nullptr) == 0);
  CHECK(obc_gltf_surface_note(nullptr, 0) == nullptr);
  CHECK(obc_gltf_surface_copy(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  obc_gltf_surface_destroy(nullptr);
  CHECK(obc_gltf_version() >= 100);
}

TEST_CASE("A program with a shorter header of the same library is served") {
  const Fixture fixture;
  // Up to the counts of triangles: the members behind keep their defaults.
  obc_gltf_scene scene = fixture.scene;
  scene.struct_size = offsetof(obc_gltf_scene, normals);
  REQUIRE(obc_gltf_write(fixture.path.c_str(), &scene, nullptr, nullptr) == OBC_OK);
  obc_gltf_read_options options;
  REQUIRE(obc_gltf_read_options_init(&options, offsetof(obc_gltf_read_options, morph_target)) == OBC_OK);
  obc_gltf_surface* surface = nullptr;
  REQUIRE(obc_gltf_read(fixture.path.c_str(), &options, nullptr, &surface, nullptr) == OBC_OK);
  CHECK(obc_gltf_surface_note_count(surface) == 1);  // its material
  obc_gltf_surface_destroy(surface);
}
