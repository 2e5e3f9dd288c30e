// What is written is read again bit for bit, whole or not at all; and files cut short anywhere never do harm.
#include "mesh/files/write.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>

#include "mesh/shapes/make_shape.h"
#include "read_text.h"
#include "temporary_folder.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

std::string contents_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool same_bits(const Mesh& a, const Mesh& b) {
  const auto bits = [](const Mesh& mesh) {
    std::vector<std::uint64_t> result;
    for (const Vector3& p : mesh.positions) {
      for (const double x : p)
        result.push_back(std::bit_cast<std::uint64_t>(x));
    }
    return result;
  };
  return bits(a) == bits(b) && a.triangles == b.triangles && a.tetrahedra == b.tetrahedra && a.hexahedra == b.hexahedra;
}

// Positions of every size that doubles have.
Mesh hard_numbers() {
  std::mt19937_64 engine(17);
  Mesh mesh;
  while (mesh.positions.size() < 3000) {
    Vector3 p;
    for (double& x : p)
      x = std::bit_cast<double>(engine());
    if (p.allFinite()) mesh.positions.push_back(p);
  }
  mesh.positions[0] = Vector3(-0.0, 0x1p-1074, -0x1.fffffffffffffp1023);
  for (Index v = 0; v + 2 < 3000; ++v)
    mesh.triangles.push_back({v, v + 1, v + 2});
  return mesh;
}

Mesh solid() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back(0.1 * (i % 2), 0.3 * (i / 2 % 2), 0.7 * (i / 4));
  mesh.positions.emplace_back(0.05, 0.15, 1.1);
  mesh.hexahedra.push_back({0, 1, 3, 2, 4, 5, 7, 6});
  mesh.tetrahedra.push_back({4, 5, 7, 8});
  mesh.tetrahedra.push_back({4, 7, 6, 8});
  mesh.triangles.push_back({4, 5, 8});
  return mesh;
}

constexpr FileKind kinds[] = {{"a.obj", false}, {"a.off", false}, {"a.ply", false},   {"b.ply", true},
                              {"a.stl", false}, {"b.stl", true},  {"a.mesh", false},  {"a.vtk", false},
                              {"b.vtk", true},  {"a.msh", false}, {"a.white", false}, {"b.white", true},
                              {"a.inp", false}, {"a.vtp", false}, {"b.vtp", true},    {"a.vtu", false},
                              {"b.vtu", true},  {"a.gii", false}, {"b.gii", true}};

}  // namespace

TEST_CASE("Surfaces come back bit for bit from every format that keeps vertices") {
  const TemporaryFolder folder;
  const Mesh mesh = hard_numbers();
  for (const FileKind& kind : kinds) {
    if (!holds(kind.file, Holds::polygons)) continue;
    CAPTURE(kind.file);
    write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host());
    CHECK(same_bits(read_mesh(folder / kind.file, {}, base::Host()), mesh));
  }
}

TEST_CASE("Solids come back bit for bit, and surface formats refuse them") {
  const TemporaryFolder folder;
  const Mesh mesh = solid();
  for (const FileKind& kind : kinds) {
    CAPTURE(kind.file);
    const std::string name = kind.file;
    if (holds(*format_of_path(name), Holds::cells)) {
      write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host());
      CHECK(same_bits(read_mesh(folder / kind.file, {}, base::Host()), mesh));
    } else {
      CHECK_THROWS_AS(write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host()), base::Error);
      CHECK_FALSE(std::filesystem::exists(folder / kind.file));
    }
  }
}

TEST_CASE("STL keeps the triangles, binary ones to float32, text exactly") {
  const TemporaryFolder folder;
  const Mesh mesh = make_shape("blob", {.triangles = 2000}, base::Host());
  for (const bool binary : {false, true}) {
    write_mesh(folder / "a.stl", mesh, {.binary = binary}, base::Host());
    const Mesh again = read_mesh(folder / "a.stl", {}, base::Host());
    REQUIRE(again.triangles.size() == mesh.triangles.size());
    CHECK(again.positions.size() == mesh.positions.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3& wanted = mesh.positions[mesh.triangles[t][k]];
        const Vector3& got = again.positions[again.triangles[t][k]];
        for (int axis = 0; axis < 3; ++axis) {
          const volatile float rounded = static_cast<float>(wanted[axis]);  // GCC 12 drops the rounding of vectors
          REQUIRE(got[axis] == (binary ? static_cast<double>(rounded) : wanted[axis]));
        }
      }
    }
  }
}

TEST_CASE("FreeSurfer and GIFTI files keep vertices and triangles, binary ones to float32, text exactly") {
  const TemporaryFolder folder;
  const Mesh mesh = make_shape("blob", {.triangles = 2000}, base::Host());
  for (const auto& [name, binary] :
       {std::pair{"lh.pial", false}, {"lh.pial", true}, {"lh.surf.gii", false}, {"lh.surf.gii", true}}) {
    write_mesh(folder / name, mesh, {.binary = binary}, base::Host());
    const Mesh again = read_mesh(folder / name, {}, base::Host());
    CHECK(again.triangles == mesh.triangles);
    REQUIRE(again.positions.size() == mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        const volatile float rounded = static_cast<float>(mesh.positions[v][axis]);
        REQUIRE(again.positions[v][axis] == (binary ? static_cast<double>(rounded) : mesh.positions[v][axis]));
      }
    }
  }
  CHECK_THROWS_AS(write_mesh(folder / "b.white", hard_numbers(), {}, base::Host()), base::Error);
  CHECK_THROWS_AS(write_mesh(folder / "b.gii", hard_numbers(), {}, base::Host()), base::Error);
}

TEST_CASE("A mesh that cannot be written leaves the old file and nothing else") {
  const TemporaryFolder folder;
  for (const FileKind& kind : kinds) {
    CAPTURE(kind.file);
    std::ofstream(folder / kind.file) << "old";
    const std::size_t files = folder.files();
    Mesh mesh = hard_numbers();
    mesh.positions[2].y() = std::nan("");
    CHECK_THROWS_AS(write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host()), base::Error);
    mesh = hard_numbers();
    mesh.triangles[2][1] = 3000;
    CHECK_THROWS_AS(write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host()), base::Error);
    CHECK(contents_of(folder / kind.file) == "old");
    CHECK(folder.files() == files);
  }
  CHECK_THROWS_AS(write_mesh(folder / "a.xyz", hard_numbers(), {}, base::Host()), base::Error);
  CHECK_THROWS_AS(write_mesh(folder / "no/such/folder.obj", hard_numbers(), {}, base::Host()), base::Error);
}

TEST_CASE("Reading and writing end when the host wants it, and leave the old file") {
  const TemporaryFolder folder;
  const Mesh mesh = make_shape("sphere", {.triangles = 200'000}, base::Host());
  for (const FileKind& kind : kinds) {
    CAPTURE(kind.file);
    base::Host host;
    host.on_progress = [&](const base::Progress& progress) {
      CHECK(progress.done <= progress.total);
      return false;
    };
    const auto cancelled = [&](const auto& work) {
      try {
        work();
      } catch (const base::Error& error) {
        return std::string(error.kind()) == "cancelled";
      }
      return false;
    };
    std::ofstream(folder / kind.file) << "old";
    CHECK(cancelled([&] { write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, host); }));
    CHECK(contents_of(folder / kind.file) == "old");
    write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host());
    CHECK(cancelled([&] { read_mesh(folder / kind.file, {}, host); }));
  }
}

TEST_CASE("Each row of the table of formats has its ending, and files that are tried here") {
  CHECK(format_endings(Holds::cells) == ".mesh .vtk .msh .inp .vtu");
  CHECK(format_endings(Holds::polygons) == ".obj .off .ply .mesh .vtk .msh .inp .vtp .vtu");
  for (const FormatRow& row : formats()) {
    CAPTURE(row.name);
    CHECK(format_of_path("A" + std::string(row.ending)) == row.format);
    const auto is_tried = [&](bool binary) {
      return std::any_of(std::begin(kinds), std::end(kinds), [&](const FileKind& kind) {
        return std::string_view(kind.file).ends_with(row.ending) && kind.binary == binary;
      });
    };
    CHECK(is_tried(false));
    CHECK(is_tried(true) == row.binary);
    CHECK(holds("b" + std::string(row.ending), Holds::cells) == row.cells);
  }
  CHECK(format_of_path("a.PLY") == Format::ply);
  CHECK_FALSE(format_of_path("ply"));
  CHECK_FALSE(holds("a.glb", Holds::surfaces));
}

TEST_CASE("A file cut short after any byte is refused, or is a mesh all the same") {
  const TemporaryFolder folder;
  const Mesh surface =
      read_text(Format::obj, "v 0 0 0\nv 1.5 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  for (const FileKind& kind : kinds) {
    for (const Mesh& mesh : {surface, solid()}) {
      const std::string name = kind.file;
      if (!mesh.hexahedra.empty() && !holds(name, Holds::cells)) continue;
      write_mesh(folder / kind.file, mesh, {.binary = kind.binary}, base::Host());
      const std::string whole = contents_of(folder / kind.file);
      const Format format = *format_of_path(kind.file);
      std::size_t refused = 0;
      for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(kind.file);
        CAPTURE(size);
        // A copy of its own, so that the sanitizer sees a byte read behind it.
        const std::vector<char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        const std::string ended = outcome(format, {cut.data(), cut.size()});
        refused += ended != "accept";
        CHECK_FALSE(ended.starts_with("internal"));
      }
      if (kind.binary) CHECK(refused + 1 >= whole.size());
      // All but the end of the line, and the name behind endsolid, which a closed surface need not have.
      if (name.ends_with("stl") || name.ends_with("ply")) CHECK(refused + 12 >= whole.size());
    }
  }
}

TEST_CASE("A file with any byte changed is refused, or is a mesh all the same") {
  const TemporaryFolder folder;
  std::mt19937_64 engine(23);
  for (const FileKind& kind : kinds) {
    const bool holds_cells = holds(kind.file, Holds::cells);
    write_mesh(folder / kind.file,
               holds_cells ? solid() : read_text(Format::obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
               {.binary = kind.binary}, base::Host());
    const std::string whole = contents_of(folder / kind.file);
    const Format format = *format_of_path(kind.file);
    for (int trial = 0; trial < 2000; ++trial) {
      std::string changed = whole;
      for (int i = 0; i <= trial % 3; ++i)
        changed[engine() % changed.size()] = static_cast<char>(engine());
      CAPTURE(kind.file);
      CHECK_FALSE(outcome(format, changed).starts_with("internal"));
    }
  }
}
