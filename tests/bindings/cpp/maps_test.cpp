// The C++ wrappers of meshes and of maps of surfaces: results, files, errors, and what is released when a callback
// throws.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include <orbicube/correspondence.hpp>
#include <orbicube/frame_field.hpp>
#include <orbicube/gltf.hpp>
#include <orbicube/harmonics.hpp>
#include <orbicube/polycube.hpp>
#include <orbicube/quaternion.hpp>
#include <orbicube/repair.hpp>
#include <orbicube/sphere_map.hpp>

using namespace orbicube;

namespace {

struct Mine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Memory that is counted.
struct Counted {
  std::size_t in_use = 0;
  obc_allocator allocator = {[](std::size_t size, std::size_t alignment, void* user) -> void* {
                               static_cast<Counted*>(user)->in_use += size;
                               return ::operator new(size, std::align_val_t(alignment));
                             },
                             [](void* pointer, std::size_t size, std::size_t alignment, void* user) {
                               static_cast<Counted*>(user)->in_use -= size;
                               ::operator delete(pointer, std::align_val_t(alignment));
                             },
                             this};
};

}  // namespace

TEST_CASE("errors have a status, a kind and a place") {
  const Mesh mesh = Mesh::make("sphere", 300);
  const Surface open(mesh.positions(), Indices(mesh.triangles().data(), mesh.triangles().size() - 3));
  try {
    mesh::check_closed_genus_zero(open);
    FAIL("an open surface was taken for a closed one");
  } catch (const Error& error) {
    CHECK(error.status() == OBC_NOT_CLOSED);
    CHECK(error.kind() == "not-closed");
    CHECK(std::strstr(error.what(), "boundary") != nullptr);
  }
  CHECK_THROWS_AS(Surface(Doubles(mesh.positions().data(), 4), mesh.triangles()), Error);
}

TEST_CASE("a mesh to the sphere, to files, to harmonics") {
  const Mesh mesh = Mesh::make("creature", 400);
  const auto map = sphere_map::compute(mesh);
  CHECK(map.report.bijective == 1);
  CHECK(sphere_map::measure(mesh, map.directions).energy == map.report.energy);
  const sphere_map::Locator locator(mesh, map.directions);
  const auto places = locator.locate(map.directions);
  CHECK(places.triangles.size() == mesh.vertex_count());
  CHECK(locator.remesh(mesh.positions(), OBC_SPHERE_MAP_ICOSPHERE, 2).vertex_count() == 162);
  const auto rounded = sphere_map::round_to_float(mesh, map.directions);

  const auto areas = mesh::vertex_areas(mesh);
  harmonics::FitOptions options;
  options.degree = 4;
  const auto fitted = harmonics::fit(map.directions, mesh.positions(), 3, areas, options);
  CHECK(fitted.values.size() == 75);
  const auto turned = harmonics::rotate(fitted, quaternion::to_matrix(quaternion::normalize({1, 2, 3, 4})));
  CHECK(harmonics::shape_distance(fitted, turned, 0, 4) < 1e-20);

  const auto folder = std::filesystem::temp_directory_path() / "orbicube-wrapper-test";
  std::filesystem::create_directories(folder);
  mesh.write((folder / "a.ply").string());
  const Mesh again = Mesh::read((folder / "a.ply").string());
  CHECK(std::equal(again.positions().begin(), again.positions().end(), mesh.positions().begin()));
  harmonics::write((folder / "a.coef").string(), fitted);
  CHECK(harmonics::read((folder / "a.coef").string()).degree == 4);
  const std::vector<float> positions(mesh.positions().begin(), mesh.positions().end());
  gltf::Scene scene;
  const obc_gltf_morph_target target = {"sphere", rounded.data()};
  scene.positions = positions.data();
  scene.vertex_count = mesh.vertex_count();
  scene.triangles = mesh.triangles().data();
  scene.triangle_count = mesh.triangle_count();
  scene.morph_targets = &target;
  scene.morph_target_count = 1;
  gltf::write((folder / "a.glb").string(), scene);
  CHECK(gltf::read((folder / "a.glb").string()).triangles.size() == mesh.triangles().size());
  gltf::ReadOptions keeping;
  keeping.keep = 1;
  const gltf::Surface surface = gltf::read((folder / "a.glb").string(), keeping);
  REQUIRE(surface.kept != nullptr);
  gltf::write_kept((folder / "kept.glb").string(), surface);
  CHECK(gltf::read((folder / "kept.glb").string()).positions == surface.positions);
  CHECK(gltf::read((folder / "a.glb").string()).kept == nullptr);
  std::filesystem::remove_all(folder);
}

TEST_CASE("quaternions, frames and a polycube") {
  using namespace quaternion;
  const Quaternion q = from_axis_angle({0, 0, 2}, 0.5);
  CHECK(std::abs(rotate(q, {1, 0, 0})[0] - std::cos(0.5)) < 1e-15);
  CHECK(symmetric_distance(q, multiply(q, cube_element(7))) < 1e-15);
  CHECK_THROWS_AS(cube_element(24), Error);
  CHECK(std::abs(average(std::vector<Quaternion>{q, q}).second - 1) < 1e-15);

  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::vector<std::uint32_t> cells = {0, 1, 2, 3};
  const auto field = frame_field::compute(frame_field::Solid(corners, cells));
  CHECK(field.frames.size() == 4);
  const frame_field::Singularities singular(frame_field::Solid(corners, cells), field.frames);
  CHECK(singular.edges.empty());

  const Mesh cube = Mesh::make("cube", 300);
  const Polycube map = Polycube::compute(cube).optimize_domain();
  CHECK(map.corner_count() == 8);
  CHECK(map.patch_count() == 6);
  CHECK(map.of_triangles().labels.size() == map.triangle_count());
  Polycube::QuadsOptions options;
  options.quads = 24;
  CHECK(map.quads(options).corners.size() >= 4 * 6);
  Polycube::AtlasOptions square;
  square.size = 32;
  const Polycube::Atlas atlas = map.atlas(square);
  CHECK(atlas.size() == 32);
  CHECK(atlas.triangle_count() == map.triangle_count());
  CHECK(atlas.texels_per_unit() > 0);
  const auto at = atlas.coordinates();
  const auto texels = atlas.sample();
  std::size_t covered = 0;
  for (std::size_t i = 0; i < 32 * 32; ++i) {
    if (texels.covered[i] == 0) continue;
    ++covered;
    double u = 0;
    for (std::size_t k = 0; k < 3; ++k)
      u += texels.weights[3 * i + k] * at[6 * texels.triangles[i] + 2 * k];
    CHECK(32 * u == doctest::Approx(static_cast<double>(i % 32) + 0.5));
  }
  // Six rectangles have the middles that their areas say, up to one along each of their sides, of up to 16 texels.
  CHECK(std::abs(static_cast<double>(covered) - 32 * 32 * atlas.coverage()) < 6 * 2 * 16);
  const auto positions = map.positions(), places = map.polycube();
  const auto triangles = map.triangles();
  CHECK(Polycube::certify(Surface(positions, triangles), places).corner_count() == 8);
}

TEST_CASE("what a log throws comes out in the end, and what was made meanwhile is released") {
  Counted memory;
  Host host;
  host.threads(1).on_log([](const char*) { throw Mine("log"); });
  host.c().allocator = &memory.allocator;
  const Mesh cube = Mesh::make("cube", 300);
  CHECK_THROWS_AS(Polycube::compute(cube, {}, &host), Mine);
  const std::vector<Surface> both(2, cube);
  CHECK_THROWS_AS(Polycube::compute_common(both, {}, {}, nullptr, &host), Mine);
  CHECK(memory.in_use == 0);

  host.on_log([](const char*) {});
  const auto maps = Polycube::compute_common(both, {}, {}, nullptr, &host);
  CHECK(Polycube::optimize_common_domain(maps, {}, &host).size() == 2);
  CHECK(memory.in_use > 0);
}

TEST_CASE("images, overlays and partial maps") {
  const Mesh shape = Mesh::make("creature", 400);
  const auto map = sphere_map::compute(shape);
  const auto partial = sphere_map::compute_partial(shape);
  CHECK(partial.directions == map.directions);
  CHECK(partial.placed == shape.vertex_count());
  Host host;
  host.on_progress([](const Progress&) { return false; });
  CHECK(sphere_map::compute_partial(shape, {}, &host).status == OBC_CANCELLED);
  const auto distortion = sphere_map::face_distortion(shape, map.directions);
  CHECK(*std::max_element(distortion.quasi_conformal.begin(), distortion.quasi_conformal.end()) ==
        doctest::Approx(map.report.max_quasi_conformal));
  CHECK(mesh::surface_distance(shape, shape).first_max < 1e-12);

  const sphere_map::Locator locator(shape, map.directions);
  const sphere_map::Image image(locator, shape.positions(), OBC_SPHERE_MAP_OCTAHEDRON, 16);
  CHECK(image.pixels.size() == 3 * 17 * 17);
  double gap = -1;
  CHECK(mesh::topology(image.surface(&gap)).genus == 0);
  CHECK(gap == 0);
  const std::string path = (std::filesystem::temp_directory_path() / "orbicube-wrapper-image.pfm").string();
  image.write(path);
  const auto again = sphere_map::Image::read(path);
  std::filesystem::remove(path);
  CHECK(again.resolution == 16);
  CHECK(again.pixels[100] == static_cast<double>(static_cast<float>(image.pixels[100])));

  std::vector<double> turned = map.directions;
  for (std::size_t i = 0; i < turned.size(); i += 3) {
    turned[i] = -map.directions[i + 1];
    turned[i + 1] = map.directions[i];
  }
  std::vector<std::uint32_t> second;
  const Mesh sphere = sphere_map::overlay(shape, map.directions, shape, turned, &second);
  CHECK(mesh::topology(sphere).genus == 0);
  CHECK(second.size() == shape.vertex_count());
  CHECK(*std::max_element(second.begin(), second.end()) < sphere.vertex_count());

  harmonics::FitOptions options;
  options.degree = 6;
  const auto fitted = harmonics::fit(map.directions, shape.positions(), 3, {}, options);
  const std::vector<double> pole = {0, 0, 1};
  const auto rows = harmonics::evaluate(pole, 6);
  double sum = 0;
  for (std::size_t k = 0; k < rows.size(); ++k)
    sum += rows[k] * fitted.values[3 * k];
  CHECK(sum == doctest::Approx(harmonics::synthesize(fitted, pole)[0]));
  CHECK(mesh::mean_distance(shape.positions(), shape.positions()) == 0);
}

TEST_CASE("the graph of a polycube, exact signs, and glTF from memory") {
  const Mesh cube = Mesh::make("cube", 300);
  const auto map = Polycube::compute(cube);
  const auto graph = map.graph();
  CHECK(graph.corner_vertices.size() == 8);
  CHECK(graph.edge_corners.size() == 2 * 12);
  CHECK(graph.patch_loops.back() == 6);
  CHECK(graph.loop_darts.back() == 24);
  CHECK(graph.links.size() == 24);
  CHECK(std::count(graph.edge_convex.begin(), graph.edge_convex.end(), 1) == 12);
  CHECK(map.sources().weights.size() == 3 * map.vertex_count());
  CHECK(map.construction() != 0);
  const auto quads = map.quads();
  CHECK(quads.triangles.size() == quads.positions.size() / 3);
  CHECK(*std::max_element(quads.triangles.begin(), quads.triangles.end()) < map.triangle_count());

  CHECK(mesh::orientation_2d({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(mesh::orientation_3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}) == -1);
  CHECK(mesh::orientation_from_origin({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0, 0, 1}) == 0);
  CHECK_THROWS_AS(mesh::orientation_2d({std::nan(""), 0}, {1, 0}, {0, 1}), Error);
  CHECK(mesh::first_at_same_position(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 0, 0}) ==
        std::vector<std::uint32_t>{0, 1, 0});

  const std::string path = (std::filesystem::temp_directory_path() / "orbicube-wrapper-cube.glb").string();
  const std::vector<float> positions(cube.positions().begin(), cube.positions().end());
  gltf::write(path, positions, cube.triangles());
  std::ifstream file(path, std::ios::binary);
  const std::vector<unsigned char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  std::filesystem::remove(path);
  CHECK(gltf::read(bytes).triangles.size() == 3 * cube.triangle_count());
  CHECK_THROWS_AS(gltf::read(View<const unsigned char>(bytes.data(), 11)), Error);

  for (std::uint32_t g = 0; g < 24; ++g)
    CHECK(quaternion::cube_product(g, quaternion::cube_inverse(g)) == 0);
  CHECK(quaternion::cube_class(0) == OBC_QUATERNION_IDENTITY);
  CHECK_THROWS_AS(quaternion::cube_product(24, 0), Error);
  CHECK(quaternion::symmetric_sine_square({1, 0, 0, 0}, quaternion::from_axis_angle({0, 0, 1}, 0.4)) ==
        doctest::Approx(std::pow(std::sin(0.2), 2)));
}

TEST_CASE("points of a cube are mapped to a longer one and back, and halfway is between them") {
  const Mesh cube = Mesh::make("cube", 300);
  std::vector<double> longer(cube.positions().begin(), cube.positions().end());
  for (std::size_t i = 0; i < longer.size(); i += 3)
    longer[i] *= 2;
  correspondence::Options options;
  options.via = OBC_CORRESPONDENCE_POLYCUBE;
  options.cells = 200;
  const correspondence::Correspondence both({cube.surface(), Surface(longer, cube.triangles())}, options);
  CHECK(both.shape_count() == 2);
  CHECK(both.domain().size() == 3 * both.vertex_count());
  CHECK(both.triangles().size() == 3 * both.quads().size() / 2);
  const auto half = both.blend({0.5, 0.5});
  CHECK(half[0] == 0.5 * both.positions(0)[0] + 0.5 * both.positions(1)[0]);
  const correspondence::Points there = both.map(0, 1), back = both.map(1, 0, there);
  CHECK(there.triangles.size() == cube.vertex_count());
  for (std::size_t v = 0; v < cube.vertex_count(); ++v) {
    double x = 0;
    for (std::size_t k = 0; k < 3; ++k)
      x += back.weights[3 * v + k] * cube.positions()[3 * cube.triangles()[3 * back.triangles[v] + k]];
    CHECK(x == doctest::Approx(cube.positions()[3 * v]).epsilon(1e-6));
  }
  CHECK_THROWS_AS(both.map(0, 2), Error);
  CHECK_THROWS_AS(both.map(0, 1, {{0}, {1, 0}}), Error);
}

TEST_CASE("A surface is repaired, with what was done where") {
  const std::vector<double> positions = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const std::vector<std::uint32_t> triangles = {2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  const Surface surface(positions, triangles);
  const repair::Repaired repaired = repair::repair(surface);
  CHECK(repaired.report.closed == 1);
  CHECK(repaired.report.filled_holes == 1);
  CHECK(repaired.positions == positions);
  CHECK(repaired.triangles.size() == 24);
  REQUIRE(repaired.events.size() == 1);
  CHECK(repair::action_name(repaired.events[0].action) == "filled-hole");
  repair::Options options;
  options.fill_holes = 0;
  CHECK(repair::repair(surface, options).report.boundary_loops == 1);
  options.weld_distance = -1;
  CHECK_THROWS_AS(repair::repair(surface, options), Error);
}

TEST_CASE("repair: the surface of a label") {
  const std::array<std::size_t, 3> size = {6, 5, 5};
  std::vector<std::int32_t> labels(150, 0);
  for (std::size_t i = 0; i < 150; ++i) {
    const std::size_t x = i % 6, y = i / 6 % 5, z = i / 30;
    labels[i] = x > 0 && x < 5 && y > 0 && y < 4 && z > 0 && z < 4 && (x != 2 || y != 2) ? 9 : 0;
  }
  const repair::LabelSurface made = repair::surface_of_label(labels, size);
  CHECK(made.report.closed == 1);
  CHECK(made.report.genus == 0);
  CHECK(made.label_report.handles == 1);
  repair::LabelOptions options;
  options.handles = 1;
  CHECK(repair::surface_of_label(labels, size, nullptr, options).report.genus == 1);
  options.label = 1;
  CHECK_THROWS_AS(repair::surface_of_label(labels, size, nullptr, options), Error);
  CHECK_THROWS_AS(repair::surface_of_label(labels, {6, 5, 4}), std::invalid_argument);
}
