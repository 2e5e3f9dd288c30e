// The C++ wrappers: the bits of C, exceptions through callbacks both ways, reverse communication, handles that release
// themselves (the address sanitizer looks on).
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
#include <orbicube/hexmesh.hpp>
#include <orbicube/linear.hpp>
#include <orbicube/polycube.hpp>
#include <orbicube/projected_gradient.hpp>
#include <orbicube/quaternion.hpp>
#include <orbicube/repair.hpp>
#include <orbicube/sphere_map.hpp>
#include <orbicube/sphere_optimizer.hpp>
#include <orbicube/trust_region.hpp>
#include <orbicube/untangle.hpp>
#include <orbicube/volume_map.hpp>

using namespace orbicube;

namespace {

struct Mine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double model(Doubles x, std::size_t i) {
  return x[0] / (1 + x[1] * (0.5 * double(i))) + x[2];
}
void misfit(Doubles x, View<double> residuals) {
  const std::array<double, 3> truth = {2.5, 0.7, 0.4};
  for (std::size_t i = 0; i < residuals.size(); ++i)
    residuals[i] = model(x, i) - model(truth, i);
}
std::int32_t misfit_in_c(const double* x, std::size_t n, double* residuals, void*) {
  misfit(Doubles(x, n), View<double>(residuals, 8));
  return 0;
}
double quadratic(Doubles x, View<double> gradient) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    gradient[i] = 2 * (x[i] - double(i));
    sum += (x[i] - double(i)) * (x[i] - double(i));
  }
  return sum;
}
// The lower triangle of the Laplacian of a path plus 1/10.
struct Path {
  std::vector<std::size_t> row_begin{0};
  std::vector<std::uint32_t> columns;
  std::vector<double> values;

  explicit Path(std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      if (i > 0) {
        columns.push_back(i - 1);
        values.push_back(-1);
      }
      columns.push_back(i);
      values.push_back(2.1);
      row_begin.push_back(columns.size());
    }
  }
  linear::Matrix view() const { return {row_begin.size() - 1, row_begin.data(), columns.data(), values.data()}; }
  // The largest entry of b - A x.
  double residual(const std::vector<double>& b, const std::vector<double>& x) const {
    std::vector<double> rest = b;
    for (std::size_t row = 0; row < b.size(); ++row) {
      for (std::size_t i = row_begin[row]; i < row_begin[row + 1]; ++i) {
        rest[row] -= values[i] * x[columns[i]];
        if (columns[i] != row) rest[columns[i]] -= values[i] * x[row];
      }
    }
    double largest = 0;
    for (const double entry : rest)
      largest = std::max(largest, std::abs(entry));
    return largest;
  }
};
double height(Doubles x, View<double> gradient) {
  for (std::size_t i = 0; i < gradient.size(); ++i)
    gradient[i] = i % 3 == 2 ? 1 : 0;
  double sum = 0;
  for (std::size_t i = 2; i < x.size(); i += 3)
    sum += x[i];
  return sum;
}

}  // namespace

TEST_CASE("a solver with a closure, by reverse communication, and in C ends in the same bits") {
  trust_region::Problem problem;
  problem.lower = {0, 0, -1};
  problem.upper = {10, 2, 1};
  std::vector<double> x = {1, 0.1, 0}, in_c = x;
  const auto result = trust_region::least_squares(misfit, x, 8, problem);
  CHECK(result.stop == OBC_TRUST_REGION_CONVERGED);

  obc_trust_region_problem plain;
  obc_trust_region_problem_init(&plain, sizeof plain);
  plain.n = 3;
  plain.residuals = 8;
  plain.lower = problem.lower.data();
  plain.upper = problem.upper.data();
  REQUIRE(obc_trust_region_minimize(&plain, nullptr, misfit_in_c, nullptr, in_c.data(), nullptr, nullptr, nullptr) ==
          OBC_OK);
  CHECK(x == in_c);

  trust_region::Solver solver(std::array<double, 3>{1, 0.1, 0}, 8, problem);
  std::vector<double> residuals(8);
  while (solver.ask()) {
    misfit(solver.point(), residuals);
    solver.tell(residuals);
    solver = trust_region::Solver::load(solver.save(), 3, 8, problem);
  }
  CHECK(solver.best() == in_c);
  CHECK(solver.result().evaluations == result.evaluations);
}

TEST_CASE("what a function throws comes out of the solver, and no handle is lost") {
  std::vector<double> x = {0, 0}, ball = {1, 0, 0};
  CHECK_THROWS_AS(trust_region::minimize([](Doubles) -> double { throw Mine("f"); }, x), Mine);
  CHECK_THROWS_AS(projected_gradient::minimize([](Doubles, View<double>) -> double { throw Mine("f"); }, x), Mine);
  CHECK_THROWS_AS(sphere_optimizer::minimize([](Doubles, View<double>) -> double { throw Mine("f"); }, ball, 3), Mine);
  CHECK_THROWS_AS(sphere_optimizer::relax(
                      [](std::size_t, const double*, const double*, double*, double*) -> double { throw Mine("f"); },
                      ball, 3, {{}}),
                  Mine);
  projected_gradient::Problem problem;
  problem.project = [](Doubles, View<double>) { throw Mine("projection"); };
  CHECK_THROWS_AS(projected_gradient::minimize(quadratic, x, problem), Mine);
  CHECK_THROWS_AS(projected_gradient::Solver(x, problem).ask(), Mine);
  Host host;
  host.on_progress([](const Progress&) -> bool { throw Mine("progress"); });
  CHECK_THROWS_AS(sphere_map::compute(Mesh::make("sphere", 200), {}, &host), Mine);
}

TEST_CASE("a function may stop a run or have no value") {
  int calls = 0;
  std::vector<double> x = {-1.2, 1};
  const auto result = trust_region::minimize(
      [&](Doubles at) {
        if (++calls > 20) throw Stop();
        if (calls == 5) throw EvaluationFailed();
        return std::pow(at[0] - 1, 2) + std::pow(at[1], 2);
      },
      x);
  CHECK(result.stop == OBC_TRUST_REGION_CANCELLED);
  CHECK(result.failed_evaluations == 1);
  CHECK(std::pow(x[0] - 1, 2) + std::pow(x[1], 2) == result.value);
}

TEST_CASE("a value that comes with a stop counts") {
  const auto distance = [](Doubles at) { return std::pow(at[0] - 1, 2) + std::pow(at[1] - 1, 2); };
  std::vector<double> x = {0, 0};
  const auto near = [&](Doubles at) {
    if (distance(at) < 1e-3) throw Stop{distance(at)};
    return distance(at);
  };
  const auto result = trust_region::minimize(near, x);
  CHECK(result.stop == OBC_TRUST_REGION_CANCELLED);
  CHECK(result.value < 1e-3);
  CHECK(distance(x) == result.value);
  x = {0, 0};
  const auto slopes = [&](Doubles at, View<double> gradient) {
    gradient[0] = 2 * (at[0] - 1);
    gradient[1] = 2 * (at[1] - 1);
    return near(at);
  };
  CHECK(projected_gradient::minimize(slopes, x).value < 1e-3);
}

TEST_CASE("projected gradient: rows, multipliers, a projection of one's own, a certificate") {
  projected_gradient::Problem problem;
  problem.lower.assign(3, 0.0);
  problem.rows.add({{0, 1}, {1, 1}, {2, 1}}, 1);
  projected_gradient::Solver solver(std::vector<double>{0, 0, 0}, problem);
  std::vector<double> gradient(3);
  while (solver.ask()) {
    const double value = quadratic(solver.point(), gradient);
    solver.tell(value, gradient);
    solver = projected_gradient::Solver::load(solver.save(), 3, problem);
  }
  const std::vector<double> best = solver.best();
  CHECK(best[0] == 0);
  CHECK(std::abs(best[1]) < 1e-8);  // the tolerance is 1e-8
  CHECK(std::abs(best[2] - 1) < 1e-8);
  CHECK(std::abs(solver.multipliers()[0] + 2) < 1e-7);

  std::vector<double> x = {5, 5, 5};
  const auto multipliers = projected_gradient::project(std::vector<double>{2, 2, 2}, x, problem);
  CHECK(std::abs(x[0] - 1. / 3) < 1e-15);
  CHECK(std::abs(multipliers[0] + 5. / 3) < 1e-14);

  problem.rows.b[0] = -1;
  projected_gradient::Solver impossible(std::vector<double>{0, 0, 0}, problem);
  CHECK_FALSE(impossible.ask());
  CHECK(impossible.result().stop == OBC_PROJECTED_GRADIENT_INFEASIBLE);
  CHECK(impossible.certificate()[0] < 0);  // c'A x is at most 0 within the bounds, and c'b positive
  problem.lower.resize(2);
  CHECK_THROWS_AS(projected_gradient::Solver(x, problem), Error);
}

TEST_CASE("points on spheres, all at once and block by block") {
  std::vector<double> x = {1, 0, 0, 0, 1, 0};
  CHECK(std::abs(sphere_optimizer::minimize(height, x, 3).value + 2) < 1e-12);
  sphere_optimizer::Solver solver(std::vector<double>{1, 0, 0, 0, 1, 0}, 3);
  std::vector<double> gradient(6);
  while (solver.ask()) {
    const double value = height(solver.point(), gradient);
    solver.tell(value, gradient);
    solver = sphere_optimizer::Solver::load(solver.save());
  }
  CHECK(solver.best() == x);
  std::vector<double> y = {1, 0, 0, 0, 1, 0};
  sphere_optimizer::Relaxation parts(y, 3, {{}, {}});
  const auto part = [](std::size_t, const double* place, const double*, double* slope, double*) {
    if (slope != nullptr) slope[0] = slope[1] = 0, slope[2] = 1;
    return place[2];
  };
  sphere_optimizer::relax(part, y, 3, {{}, {}});
  CHECK(std::abs(y[2] + 1) < 1e-9);
  CHECK(std::abs(y[5] + 1) < 1e-9);
  // In parts, broken off, saved and loaded: the same bits.
  const auto broken = [](std::size_t, const double*, const double*, double*, double*) -> double { throw 5; };
  CHECK(parts.run(part, 1).stop == OBC_SPHERE_OPTIMIZER_RUNNING);
  CHECK_THROWS_AS(parts.run(broken, 1), int);
  CHECK_THROWS_AS(sphere_optimizer::Relaxation::load(parts.save(), 3, {{1}, {0}}), Error);  // of others
  parts = sphere_optimizer::Relaxation::load(parts.save(), 3, {{}, {}});
  while (parts.run(part, 1).stop == OBC_SPHERE_OPTIMIZER_RUNNING) {
  }
  CHECK(parts.points() == y);
}

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
  const auto positions = map.positions(), places = map.polycube();
  const auto triangles = map.triangles();
  CHECK(Polycube::certify(Surface(positions, triangles), places).corner_count() == 8);
}

namespace {

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

TEST_CASE("what a progress function throws comes out of the questions of a solver") {
  Host host;
  host.on_progress([](const Progress&) -> bool { throw Mine("progress"); });
  trust_region::Solver solver(std::array<double, 2>{-1.2, 1}, 0, {}, {}, &host);
  const auto run = [&] {
    while (solver.ask())
      solver.tell(std::pow(solver.point()[0], 2));
  };
  CHECK_THROWS_AS(run(), Mine);
}

TEST_CASE("inverted tetrahedra are untangled, or the best is handed out with the error") {
  // Four tetrahedra around a vertex that has left the one that they fill.
  const std::vector<double> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2};
  const std::vector<std::uint32_t> cells = {0, 1, 2, 4, 0, 2, 3, 4, 0, 3, 1, 4, 1, 3, 2, 4};
  untangle::Tetrahedra problem(positions, cells);
  const auto right = untangle::tetrahedra(problem);
  CHECK(right.report.inverted_before > 0);
  CHECK(right.report.inverted == 0);
  CHECK(std::equal(positions.begin(), positions.begin() + 12, right.positions.begin()));

  const std::vector<std::uint8_t> fixed(5, 1);
  problem.fixed = fixed.data();
  untangle::Untangled best;
  CHECK_THROWS_AS(untangle::tetrahedra(problem, {}, nullptr, &best), Error);
  CHECK(best.positions == positions);
  CHECK(best.report.inverted == right.report.inverted_before);
}

TEST_CASE("flipped triangles of a flat mesh are untangled") {
  // Four triangles around a vertex that has left the square that they fill.
  const std::vector<double> flat = {0, 0, 1, 0, 1, 1, 0, 1, 3, 2};
  const std::vector<std::uint32_t> corners = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  const auto right = untangle::triangles(untangle::Triangles(flat, corners));
  CHECK(right.report.inverted_before > 0);
  CHECK(right.report.inverted == 0);
  CHECK(std::equal(flat.begin(), flat.begin() + 8, right.positions.begin()));
  for (std::size_t i = 8; i < 10; ++i)
    CHECK(right.positions[i] == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("a cube is filled with hexahedra, and a tetrahedral cube goes to its polycube") {
  const std::vector<double> corners = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2, 1, 1, 1};
  const std::vector<std::uint32_t> triangles = {0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                                1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  hexmesh::Options options;
  options.cells = 27;
  options.padding = OBC_HEXMESH_PADDING_WITHOUT;
  const auto hexes = hexmesh::fill_with_hexahedra(Surface(Doubles(corners.data(), 24), triangles), options);
  CHECK(hexes.hexahedra.size() == 8 * 27);
  CHECK(hexes.positions.size() == 3 * 64);
  CHECK(hexes.quads.size() == 4 * 54);
  CHECK(hexes.quad_patches.size() == 54);
  CHECK(hexes.report.volume == doctest::Approx(8));

  // The same with a vertex in the middle.
  std::vector<std::uint32_t> tetrahedra;
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    tetrahedra.insert(tetrahedra.end(), {8, triangles[t], triangles[t + 1], triangles[t + 2]});
  const auto solid = volume_map::map_to_polycube(corners, tetrahedra);
  CHECK(solid.tetrahedra.size() >= tetrahedra.size());
  CHECK(solid.polycube.size() == solid.positions.size());
}

TEST_CASE("a tetrahedral cube is parameterized along its axes, and a map of it is a function with an inverse") {
  std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1}, image, axes;
  const std::vector<std::uint32_t> cells = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  for (int t = 0; t < 6; ++t)
    axes.insert(axes.end(), {1, 0, 0, 0});
  volume_map::FrameMapOptions options;
  options.cell_length = 0.5;
  options.integer = 1;
  const auto map = volume_map::parameterize(corners, cells, axes, options);
  CHECK(map.report.inverted == 0);
  CHECK(map.report.patches == 6);
  CHECK(map.singular_edges.empty());
  for (std::size_t i = 0; i < map.parameters.size(); ++i) {
    const double moved = 2 * (corners[3 * cells[i / 3] + i % 3] - corners[3 * cells[0] + i % 3]);
    CHECK(std::abs(map.parameters[i] - map.parameters[i % 3] - moved) < 1e-6);
  }
  CHECK_THROWS_AS(volume_map::parameterize(corners, cells, Doubles(axes.data(), 20), options), Error);

  for (const double x : corners)
    image.push_back(2 * x + 1);
  const std::vector<double> points = {0.25, 0.5, 0.875, 2, 0, 0};
  const std::vector<double> images = volume_map::Locator(corners, cells).sample(points, image);
  CHECK(images[2] == doctest::Approx(2.75));
  CHECK(images[3] != images[3]);
  const std::vector<double> back = volume_map::Locator(image, cells).sample(Doubles(images.data(), 3), corners);
  for (std::size_t a = 0; a < 3; ++a)
    CHECK(back[a] == doctest::Approx(points[a]));
}

TEST_CASE("frames to start from are one a tetrahedron") {
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, too_few = {1, 0, 0};
  const std::vector<std::uint32_t> cells = {0, 1, 2, 3};
  CHECK_THROWS_AS(frame_field::compute(frame_field::Solid(corners, cells), {}, {}, too_few), Error);
}

TEST_CASE("hexahedra follow the frames of a tetrahedral cube") {
  const std::vector<double> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
  const std::vector<std::uint32_t> cells = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
  hexmesh::Options options;
  options.method = OBC_HEXMESH_METHOD_FRAMES;
  options.cells = 8;
  const auto hexes = hexmesh::fill_with_hexahedra(corners, cells, {}, options);
  CHECK(hexes.hexahedra.size() == 8 * 8);
  CHECK(hexes.positions.size() == 3 * 27);
  CHECK(hexes.quads.size() == 4 * 24);
  CHECK(hexes.report.volume == doctest::Approx(1));
  CHECK(hexes.report.min_scaled_jacobian > 0.99);
  Mesh::Cells given;
  given.positions = hexes.positions.data();
  given.vertex_count = 27;
  given.hexahedra = hexes.hexahedra.data();
  given.hexahedron_count = 8;
  Mesh(given).check_cells();
  CHECK(Mesh(given).hexahedron_regions().empty());
  const std::vector<std::int32_t> regions = {1, 2, 3, 4, 5, 6, 7, -8};
  given.hexahedron_regions = regions.data();
  CHECK(Mesh(given).hexahedron_regions() == regions);
  Host host;
  host.on_progress([](const Progress&) { return false; });
  CHECK_THROWS_AS(hexmesh::fill_with_hexahedra(corners, cells, {}, options, &host), Error);
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

TEST_CASE("a factor of a sparse symmetric matrix solves, follows changes, and says what it cannot do") {
  Path path(200);
  linear::Direct factor(path.view());
  CHECK(factor.entry_count() == 199);
  std::vector<double> b(200);
  for (std::size_t i = 0; i < b.size(); ++i)
    b[i] = std::sin(3.0 * double(i));
  const std::vector<double> x = factor.solve(b);
  CHECK(path.residual(b, x) < 1e-13);
  std::vector<double> both = b;
  both.insert(both.end(), b.begin(), b.end());
  const std::vector<double> twice = factor.solve(both);
  CHECK(std::equal(x.begin(), x.end(), twice.begin()));
  CHECK(std::equal(x.begin(), x.end(), twice.begin() + 200));

  factor.remove_row(80);
  CHECK(factor.solve(b)[80] == b[80]);
  factor.refactor(path.values);
  factor.update({20, 21}, {3, -2});
  Path updated = path;
  updated.values[updated.row_begin[21] - 1] += 9;
  updated.values[updated.row_begin[22] - 2] -= 6;
  updated.values[updated.row_begin[22] - 1] += 4;
  CHECK(updated.residual(b, factor.solve(b)) < 1e-12);
  factor.update({20, 21}, {3, -2}, -1);
  CHECK(path.residual(b, factor.solve(b)) < 1e-12);

  linear::Direct moved = std::move(factor);
  CHECK(path.residual(b, moved.solve(b)) < 1e-12);
  CHECK_THROWS_AS(moved.solve(std::vector<double>(199)), std::invalid_argument);
  CHECK_THROWS_AS(moved.update({0}, {1, 2}), std::invalid_argument);
  CHECK_THROWS_AS(moved.update({0, 199}, {1, 1}), Error);
  CHECK_THROWS_AS(moved.remove_row(200), Error);
  CHECK_THROWS_AS(moved.update({0}, {100}, -1), Error);
  CHECK_THROWS_AS(moved.solve(b), Error);
  path.values[path.row_begin[7] - 1] = -2;
  try {
    linear::Direct(path.view());
    FAIL("a matrix that is not positive definite was factorized");
  } catch (const Error& error) {
    CHECK(error.status() == OBC_NO_VALID_RESULT);
  }
}

TEST_CASE("iterations for a sparse symmetric matrix report what they reached, and pass exceptions of progress on") {
  const Path path(30000);
  const std::vector<double> b(30000, 1.0);
  for (const std::int32_t method : {OBC_LINEAR_GAUSS_SEIDEL, OBC_LINEAR_MULTIGRID}) {
    linear::IterativeOptions options;
    options.method = method;
    options.block_size = 3;
    options.tolerance = 1e-11;
    linear::IterativeReport report;
    linear::Iterative solver(path.view(), options);
    CHECK(path.residual(b, solver.solve(b, &report)) < 1e-8);
    CHECK(report.converged == 1);
    CHECK(report.residual <= 1e-11);
    CHECK_THROWS_AS(solver.solve(std::vector<double>(3)), std::invalid_argument);
  }
  Host host;
  bool fails = false;
  int told = 0;
  host.on_progress([&](const Progress&) {
    ++told;
    if (fails) throw Mine("progress");
    return true;
  });
  linear::Iterative solver(path.view(), {}, &host);
  const std::vector<double> x = solver.solve(b);
  CHECK(told > 0);
  fails = true;
  CHECK_THROWS_AS(solver.solve(b), Mine);
  fails = false;
  CHECK(solver.solve(b) == x);
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
