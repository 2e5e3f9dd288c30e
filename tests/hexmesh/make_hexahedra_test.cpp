// The choice among the strategies, and what is done to an input before.
#include <doctest/doctest.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "hexmesh/hexmesh.h"
#include "hexmesh/strategies/machined_shape.h"
#include "mesh/search/unit_scale.h"
#include "mesh/shapes/make_shape.h"
#include "tests/base/quiet_host.h"
#include "tests/volume_map/block_solid.h"

using namespace orbicube;
using hexmesh::Hexahedra;
using hexmesh::Method;
using hexmesh::Options;
using orbicube::test::host;
using volume_map::InputFindings;

namespace {

Options few(Method method = Method::automatic) {
  Options options;
  options.method = method;
  options.cells = 60;
  options.rounds = 4;
  options.distance = 0;
  return options;
}

mesh::Mesh surface(const std::string& shape) {
  return mesh::make_shape(shape, {.triangles = 600}, host);
}

mesh::Mesh solid() {
  const volume_map::test::BlockSolid block({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 2, 0, 0);
  mesh::Mesh result;
  result.positions.assign(block.positions.begin(), block.positions.end());
  result.tetrahedra.assign(block.tetrahedra.begin(), block.tetrahedra.end());
  return result;
}

std::string kind_of_failure(const mesh::Mesh& input, const Options& options) {
  InputFindings findings;
  try {
    hexmesh::make_hexahedra(input, options, findings, host);
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

}  // namespace

TEST_CASE("Machined parts are told from round shapes") {
  for (const auto& expected : {std::pair{"l-shape", true}, {"bracket", true}, {"torus", false}, {"blob", false}}) {
    const mesh::Mesh made = surface(expected.first);
    CAPTURE(expected.first);
    CHECK(hexmesh::is_machined(made.positions, made.triangles, host) == expected.second);
  }
}

TEST_CASE("Machined solids go along frames, and their surfaces by a polycube where nothing fills them") {
  InputFindings findings;
  const Hexahedra along = hexmesh::make_hexahedra(solid(), few(), findings, host);
  CHECK(along.method == Method::frames);
  REQUIRE(along.along_frames);
  CHECK(along.along_frames->singular_edges == 0);
  CHECK(along.result.quality.valid());
  CHECK(along.polycube_corners == 0);
  CHECK(findings.examined);
  CHECK(!findings.surface);

  InputFindings of_surface;
  const Hexahedra made = hexmesh::make_hexahedra(surface("l-shape"), few(), of_surface, host);
  CHECK(made.method == Method::polycube);
  CHECK(made.polycube_corners == 12);
  CHECK(!made.along_frames);
  REQUIRE(of_surface.surface);
  CHECK(of_surface.surface->genus == 0);
  REQUIRE(of_surface.polycube);
  CHECK(of_surface.polycube->corners == 12);
  CHECK(kind_of_failure(surface("l-shape"), few(Method::frames)) == "unsupported");
}

TEST_CASE("Layers are those of a polycube") {
  Options options = few();
  options.padding = hexmesh::Padding::with;
  InputFindings findings;
  const Hexahedra made = hexmesh::make_hexahedra(solid(), options, findings, host);
  CHECK(made.method == Method::polycube);
  CHECK(made.result.padded);
}

TEST_CASE("A function that fills surfaces gets the coarse surface, and its refusal leaves the polycube") {
  Options options = few();
  std::size_t calls = 0;
  options.fill = [&](auto positions, auto triangles, double max_volume, const base::Host&) -> mesh::Mesh {
    ++calls;
    CHECK(positions.size() == triangles.size() / 2 + 2);
    CHECK(max_volume > 0);
    throw base::Error("no-valid-result", "refused");
  };
  InputFindings findings;
  const Hexahedra made = hexmesh::make_hexahedra(surface("l-shape"), options, findings, host);
  CHECK(calls > 0);
  CHECK(made.method == Method::polycube);
}

TEST_CASE("Triangles are turned outward, with a note, and sizes do not matter") {
  mesh::Mesh shape = surface("l-shape");
  InputFindings findings;
  const Hexahedra made = hexmesh::make_hexahedra(shape, few(), findings, host);
  constexpr int exponent = -60;
  mesh::scale_by_power(shape.positions, exponent);
  for (mesh::Triangle& t : shape.triangles)
    std::swap(t[0], t[1]);
  std::vector<std::string> notes;
  InputFindings of_tiny;
  of_tiny.on_note = [&](const std::string& note) { notes.push_back(note); };
  const Hexahedra tiny = hexmesh::make_hexahedra(shape, few(), of_tiny, host);
  CHECK(notes == std::vector<std::string>{"the surface was inward-oriented; all triangles were reversed"});
  CHECK(tiny.result.mesh.hexahedra.size() == made.result.mesh.hexahedra.size());
  CHECK(tiny.result.quality.volume == doctest::Approx(std::ldexp(made.result.quality.volume, 3 * exponent)));
}

TEST_CASE("Angles are those of the strategy unless one is set") {
  Options options;
  CHECK(hexmesh::feature_angle_of(options) == 35);
  options.features = hexmesh::Features::off;
  CHECK(hexmesh::feature_angle_of(options) == 40);
  options.method = Method::frames;
  CHECK(hexmesh::feature_angle_of(options) == 0);
  options.feature_angle = 30;
  CHECK(hexmesh::feature_angle_of(options) == 30);
}

TEST_CASE("Wrong arguments are refused") {
  const mesh::Mesh cells = solid();
  Options options = few();
  options.method = static_cast<Method>(4);
  CHECK(kind_of_failure(cells, options) == "invalid-argument");
  options = few();
  options.feature_angle = 180;
  CHECK(kind_of_failure(cells, options) == "invalid-argument");
  options = few(Method::polycube);
  const std::vector<quaternion::Quaternion> frames(cells.tetrahedra.size(), quaternion::Quaternion{1, 0, 0, 0});
  options.frames = frames;
  CHECK(kind_of_failure(cells, options) == "invalid-argument");
  options = few();
  options.frames = std::span(frames).first(3);
  CHECK(kind_of_failure(cells, options) == "invalid-argument");
  options.frames = frames;
  CHECK(kind_of_failure(surface("l-shape"), options) == "no-cells");
  options = few();
  options.cells = 1;
  options.max_cells = 1;
  mesh::Mesh opened = surface("l-shape");
  opened.triangles.pop_back();
  CHECK(kind_of_failure(opened, options) == "not-closed");
}

TEST_CASE("Features are those of the turned surface where triangles disagree with their neighbors") {
  mesh::Mesh shape = surface("l-shape");
  InputFindings findings;
  const Hexahedra made = hexmesh::make_hexahedra(shape, few(), findings, host);
  for (std::size_t i = 0; i < shape.triangles.size(); i += 3)
    std::swap(shape.triangles[i][1], shape.triangles[i][2]);
  const Hexahedra turned = hexmesh::make_hexahedra(shape, few(), findings, host);
  REQUIRE(made.features);
  REQUIRE(turned.features);
  CHECK(made.features->captured > 0.99);
  CHECK(turned.features->captured == made.features->captured);
  CHECK(turned.result.mesh.positions == made.result.mesh.positions);
  CHECK(turned.result.mesh.hexahedra == made.result.mesh.hexahedra);
}
