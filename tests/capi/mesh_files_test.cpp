// The C functions of mesh that read and write files: what they promise about formats, arguments, memory and cancelling.
#include "orbicube/mesh.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>

#include "failing_allocations.h"
#include "mesh_cube.h"

using namespace orbicube;
using test::create;
using test::Cube;
using test::Mesh;
using test::topology;

namespace {

// A file in the tests' folder that is removed at the end.
class TemporaryFile {
 public:
  explicit TemporaryFile(const char* ending)
      : path_(std::filesystem::temp_directory_path() / ("orbicube-mesh-test-" + std::to_string(::getpid()) + ending)) {}
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const char* path() const { return path_.c_str(); }

 private:
  std::filesystem::path path_;
};

// A file of each format goes to the disk and comes back.
obc_status write_and_read(const obc_host& host) {
  const Cube cube;
  const obc_surface surface = cube.surface();
  obc_status status = OBC_OK;
  for (const char* ending :
       {".obj", ".off", ".ply", ".stl", ".mesh", ".vtk", ".msh", ".white", ".inp", ".vtp", ".vtu", ".gii"}) {
    // Not std::filesystem: the call must not allocate for itself.
    char path[64];
    std::snprintf(path, sizeof path, "orbicube-mesh-test-%ld%s", static_cast<long>(::getpid()), ending);
    obc_mesh* mesh = nullptr;
    if (status == OBC_OK) status = obc_mesh_write_surface(path, &surface, nullptr, &host, nullptr);
    if (status == OBC_OK) status = obc_mesh_read(path, nullptr, &host, &mesh, nullptr);
    std::remove(path);
    obc_mesh_destroy(mesh);
  }
  return status;
}

}  // namespace

TEST_CASE("A mesh written to each format is read again to the bit") {
  Cube cube;
  for (double& x : cube.positions)
    x = x / 3 + 0.1;
  const obc_surface surface = cube.surface();
  for (const char* ending : {".obj", ".off", ".ply", ".mesh", ".vtk", ".msh", ".inp", ".vtp", ".vtu"}) {
    for (const std::int32_t binary : {0, 1}) {
      const TemporaryFile file(ending);
      obc_mesh_write_options options;
      REQUIRE(obc_mesh_write_options_init(&options, sizeof options) == OBC_OK);
      CHECK(options.binary == 1);
      options.binary = binary;
      obc_error error;
      REQUIRE(obc_mesh_write_surface(file.path(), &surface, &options, nullptr, &error) == OBC_OK);
      obc_mesh* made = nullptr;
      REQUIRE(obc_mesh_read(file.path(), nullptr, nullptr, &made, &error) == OBC_OK);
      const Mesh mesh(made);
      Cube read;
      REQUIRE(obc_mesh_vertex_count(made) == 8);
      REQUIRE(obc_mesh_triangle_count(made) == 12);
      REQUIRE(obc_mesh_copy(made, read.positions.data(), read.triangles.data(), nullptr, nullptr, nullptr) == OBC_OK);
      CHECK(read.positions == cube.positions);
      CHECK(read.triangles == cube.triangles);
      CHECK(std::strlen(obc_mesh_format(made)) > 0);
    }
  }
  // Cells go to the formats that have them, and are refused by the others.
  const Mesh solid = create(cube.cells());
  const TemporaryFile volume(".vtk"), flat(".obj");
  obc_error error;
  REQUIRE(obc_mesh_write(volume.path(), solid.get(), nullptr, nullptr, &error) == OBC_OK);
  obc_mesh* made = nullptr;
  REQUIRE(obc_mesh_read(volume.path(), nullptr, nullptr, &made, &error) == OBC_OK);
  CHECK(obc_mesh_tetrahedron_count(made) == 5);
  obc_mesh_destroy(made);
  CHECK(obc_mesh_write(flat.path(), solid.get(), nullptr, nullptr, &error) == OBC_UNSUPPORTED);
  CHECK(std::string(error.message).find(flat.path()) == 0);
  CHECK_FALSE(std::filesystem::exists(flat.path()));
}

TEST_CASE("The table of formats: endings, names, contents") {
  CHECK(std::string(obc_mesh_format_ending(OBC_MESH_PLY)) == ".ply");
  CHECK(std::string(obc_mesh_format_name(OBC_MESH_MEDIT)) == "MEDIT");
  CHECK(obc_mesh_format_contents(OBC_MESH_STL) == (OBC_MESH_HOLDS_SURFACES | OBC_MESH_HOLDS_BINARY));
  CHECK((obc_mesh_format_contents(OBC_MESH_VTK) & OBC_MESH_HOLDS_CELLS) != 0);
  for (const std::int32_t none : {-1, OBC_MESH_GIFTI + 1, INT32_MAX}) {
    CHECK(obc_mesh_format_ending(none) == nullptr);
    CHECK(obc_mesh_format_name(none) == nullptr);
    CHECK(obc_mesh_format_contents(none) == 0);
  }
}

TEST_CASE("Files in memory: changes are reported, defects are reported with their locations") {
  obc_mesh* made = nullptr;
  obc_error error;
  const std::string quads =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  REQUIRE(obc_mesh_read_memory(quads.data(), quads.size(), OBC_MESH_OBJ, nullptr, nullptr, &made, &error) == OBC_OK);
  CHECK(obc_mesh_triangle_count(made) == 12);
  CHECK(obc_mesh_polygon_count(made) == 6);
  CHECK(obc_mesh_welded_vertex_count(made) == 0);
  obc_surface surface;
  REQUIRE(obc_mesh_surface(made, &surface, nullptr) == OBC_OK);
  CHECK(topology(surface).genus == 0);
  std::size_t notes = 0;
  while (obc_mesh_note(made, notes) != nullptr)
    ++notes;
  CHECK(obc_mesh_note(made, notes + 1) == nullptr);
  obc_mesh_destroy(made);

  // The same cube with its own four vertices a face, welded on request.
  std::string loose;
  const std::array<std::array<int, 4>, 6> faces = {
      {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  for (const auto& face : faces) {
    for (const int v : face)
      loose += std::string("v ") + (v % 4 == 1 || v % 4 == 2 ? "1 " : "0 ") + (v % 4 > 1 ? "1 " : "0 ") +
               (v > 3 ? "1\n" : "0\n");
    loose += "f -4 -3 -2 -1\n";
  }
  obc_mesh_read_options options;
  REQUIRE(obc_mesh_read_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.weld_identical == 0);
  for (const std::int32_t weld : {0, 1}) {
    options.weld_identical = weld;
    REQUIRE(obc_mesh_read_memory(loose.data(), loose.size(), OBC_MESH_OBJ, &options, nullptr, &made, &error) == OBC_OK);
    CHECK(obc_mesh_vertex_count(made) == (weld == 1 ? 8 : 24));
    CHECK(obc_mesh_welded_vertex_count(made) == (weld == 1 ? 16 : 0));
    obc_mesh_destroy(made);
  }

  made = nullptr;
  CHECK(obc_mesh_read_memory("v 1 2", 5, OBC_MESH_OBJ, nullptr, nullptr, &made, &error) == OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "parse");
  CHECK(std::string(error.message).find("line 1") != std::string::npos);
  CHECK(obc_mesh_read_memory(nullptr, 0, OBC_MESH_OFF, nullptr, nullptr, &made, &error) == OBC_MALFORMED_FILE);
  CHECK(std::string(error.kind) == "empty-file");
  CHECK(obc_mesh_read_memory(nullptr, 5, OBC_MESH_OFF, nullptr, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_read_memory("OFF", 3, OBC_MESH_GIFTI + 1, nullptr, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_read_memory("OFF", 3, OBC_MESH_OFF, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_mesh_read("/nowhere/at/all.off", nullptr, nullptr, &made, &error) == OBC_IO);
  CHECK(std::string(error.message).find("/nowhere/at/all.off: ") == 0);
  CHECK(obc_mesh_read("shape.xyz", nullptr, nullptr, &made, &error) == OBC_UNSUPPORTED);
  CHECK(obc_mesh_read(nullptr, nullptr, nullptr, &made, &error) == OBC_INVALID_ARGUMENT);
  CHECK(made == nullptr);
  CHECK(obc_mesh_write(nullptr, nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  const Cube cube;
  const obc_surface of_cube = cube.surface();
  CHECK(obc_mesh_write_surface(nullptr, &of_cube, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(std::string(obc_mesh_format(nullptr)) == "");
  CHECK(obc_mesh_note(nullptr, 0) == nullptr);
}

TEST_CASE("Each allocation of reading and writing fails in turn and nothing is leaked") {
  const test::Outcome files = test::fail_each_allocation(write_and_read);
  CHECK(files.problem == "");
  CHECK(files.runs > 40);
}

TEST_CASE("Reading and writing can be cancelled at each of their reports") {
  const test::Outcome files = test::cancel_everywhere(write_and_read, 200);
  CHECK(files.problem == "");
  CHECK(files.runs > 6);
}
