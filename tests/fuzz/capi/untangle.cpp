// Inverted tetrahedra and triangles: meshes, target shapes, fixed and tied coordinates, and options of any kind.
#include "orbicube/untangle.h"

#include <cstring>

#include "shapes.h"

using namespace fuzz;

namespace {

obc_untangle_options options_from(Input& in) {
  obc_untangle_options options;
  obc_untangle_options_init(&options, sizeof options);
  options.max_steps =
      in.one_in(20) ? static_cast<std::int32_t>(in.bits()) % 100 : static_cast<std::int32_t>(in.below(40));
  options.max_polish_steps = in.one_in(20) ? -1 : static_cast<std::int32_t>(in.below(5));
  options.free_boundary = in.one_in(2);
  if (in.one_in(8)) options.tolerance = in.number();
  if (in.one_in(3)) options.volume_weight = in.number();
  return options;
}

// Some places of a list of coordinates or vertices.
std::vector<std::uint8_t> flags(Input& in, std::size_t count) {
  std::vector<std::uint8_t> result(count);
  for (std::uint8_t& flag : result)
    flag = in.one_in(4);
  return result;
}

void require_untangled(const std::vector<double>& result, const obc_untangle_report& report) {
  require_finite(result, "a position that is not finite");
  require(report.inverted == 0 && report.first_inverted == UINT32_MAX, "a certified mesh with an inverted element");
  require(report.min_determinant > -1e-9, "a certified mesh with a determinant that is not positive");  // rounded
}

// What is fixed keeps its bits; `each` coordinates have one flag.
void require_fixed(const std::uint8_t* fixed, std::size_t each, const std::vector<double>& before,
                   const std::vector<double>& after) {
  for (std::size_t i = 0; fixed != nullptr && i < after.size(); ++i)
    require(fixed[i / each] == 0 || std::memcmp(&after[i], &before[i], sizeof after[i]) == 0,
            "a fixed coordinate moved");
}

// A refined mesh: positions that are finite, and elements, parents and origins that exist.
void check_refined(obc_untangle_refined* refined, std::size_t axes, const std::vector<double>& before,
                   std::size_t elements, const std::uint8_t* fixed) {
  const std::size_t n = obc_untangle_refined_vertex_count(refined), m = obc_untangle_refined_element_count(refined);
  std::vector<double> positions(axes * n), weights((axes + 1) * n);
  std::vector<std::uint32_t> cells((axes + 1) * m), parents(m), origins((axes + 1) * n);
  require(obc_untangle_refined_copy(refined, positions.data(), cells.data(), parents.data(), origins.data(),
                                    weights.data(), nullptr) == OBC_OK,
          "a refined mesh is not copied");
  obc_untangle_refined_destroy(refined);
  require(positions.size() >= before.size() && m >= elements, "a refined mesh has lost something");
  require_finite(positions, "a position that is not finite");
  for (const std::uint32_t v : cells)
    require(v < n, "a vertex of a refined element is out of range");
  for (const std::uint32_t parent : parents)
    require(parent < elements, "a parent is out of range");
  for (std::size_t i = 0; i < origins.size(); ++i)
    require(weights[i] > 0 ? axes * origins[i] < before.size() : origins[i] == UINT32_MAX, "an origin is out of range");
  positions.resize(before.size());
  require_fixed(fixed, axes, before, positions);
}

// A square of squares cut in two, or a part of some surface.
Shape flat_mesh(Input& in) {
  if (in.one_in(2)) {
    Shape part = surface(in);
    part.cells.resize(3 * in.below(part.cell_count() + 1));
    return part;
  }
  Shape grid;
  const auto n = static_cast<std::uint32_t>(1 + in.below(5));
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      grid.positions.insert(grid.positions.end(), {1.0 * x, 1.0 * y, 0.0});
      const std::uint32_t p = (n + 1) * y + x;
      if (x < n && y < n) grid.cells.insert(grid.cells.end(), {p, p + 1, p + n + 2, p, p + n + 2, p + n + 1});
    }
  }
  return grid;
}

void untangle_triangles(Input& in, Host& host) {
  const Shape mesh = flat_mesh(in);
  std::vector<double> flat;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (i % 3 < 2) flat.push_back(mesh.positions[i]);
  for (std::size_t i = in.below(6); i > 0 && !flat.empty(); --i)
    flat[in.bits() % flat.size()] += 2 * in.moderate();
  obc_untangle_triangles_problem problem;
  obc_untangle_triangles_problem_init(&problem, sizeof problem);
  problem.positions = flat.data();
  problem.vertex_count = mesh.vertex_count();
  problem.triangles = mesh.cells.data();
  problem.triangle_count = mesh.cell_count();
  const std::vector<std::uint8_t> vertices = flags(in, flat.size() / 2), coordinates = flags(in, flat.size());
  if (in.one_in(2)) problem.rest = mesh.positions.data();
  if (in.one_in(4)) problem.fixed = vertices.data();
  if (in.one_in(2)) problem.fixed_coordinates = coordinates.data();
  std::vector<std::uint32_t> ties(flat.size(), UINT32_MAX);
  for (std::size_t i = in.below(6); i > 0 && !ties.empty(); --i)
    ties[in.bits() % ties.size()] = in.index(ties.size());
  if (in.one_in(3)) problem.ties = ties.data();
  const obc_untangle_options options = options_from(in);
  obc_untangle_report report;
  obc_untangle_report_init(&report, sizeof report);
  if (in.one_in(3)) {
    obc_untangle_refined* refined = nullptr;
    if (ok([&](obc_error* e) {
          return obc_untangle_refine_triangles(&problem, &options, host.c(), &refined, &report, e);
        }))
      check_refined(refined, 2, flat, mesh.cell_count(), problem.fixed);
    return;
  }
  std::vector<double> result(flat.size());
  if (!ok([&](obc_error* e) {
        return obc_untangle_triangles(&problem, &options, host.c(), result.data(), &report, e);
      }))
    return;
  require_untangled(result, report);
  require_fixed(problem.fixed, 2, flat, result);
  require_fixed(problem.fixed_coordinates, 1, flat, result);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  if (in.one_in(2)) {
    untangle_triangles(in, host);
    return 0;
  }
  Shape mesh = solid(in, in.one_in(2));
  const std::vector<double> rest = mesh.positions;
  for (std::size_t i = in.below(6); i > 0 && !mesh.positions.empty(); --i)
    mesh.positions[in.bits() % mesh.positions.size()] += 2 * in.moderate();
  obc_untangle_tetrahedra_problem problem;
  obc_untangle_tetrahedra_problem_init(&problem, sizeof problem);
  problem.positions = mesh.positions.data();
  problem.vertex_count = mesh.vertex_count();
  problem.tetrahedra = mesh.cells.data();
  problem.tetrahedron_count = mesh.cell_count();
  const std::vector<std::uint8_t> fixed = flags(in, mesh.positions.size()),
                                  fixed_vertices = flags(in, mesh.vertex_count());
  std::vector<std::uint32_t> ties(mesh.positions.size(), UINT32_MAX);
  for (std::size_t i = in.below(6); i > 0; --i)
    ties[in.bits() % ties.size()] = in.index(ties.size());
  if (in.one_in(2)) problem.rest = rest.data();
  if (in.one_in(2)) problem.fixed_coordinates = fixed.data();
  if (in.one_in(4)) problem.fixed = fixed_vertices.data();
  if (in.one_in(3)) problem.ties = ties.data();
  const obc_untangle_options options = options_from(in);
  obc_untangle_report report;
  obc_untangle_report_init(&report, sizeof report);
  if (in.one_in(3)) {
    obc_untangle_refined* refined = nullptr;
    if (ok([&](obc_error* e) {
          return obc_untangle_refine_tetrahedra(&problem, &options, host.c(), &refined, &report, e);
        }))
      check_refined(refined, 3, mesh.positions, mesh.cell_count(), problem.fixed);
    return 0;
  }
  std::vector<double> result(mesh.positions.size());
  if (!ok([&](obc_error* e) {
        return obc_untangle_tetrahedra(&problem, &options, host.c(), result.data(), &report, e);
      }))
    return 0;
  require_untangled(result, report);
  require_fixed(problem.fixed_coordinates, 1, mesh.positions, result);
  require_fixed(problem.fixed, 3, mesh.positions, result);
  for (std::size_t i = 0; problem.ties != nullptr && i < result.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      require(ties[i] == UINT32_MAX || ties[i] != ties[j] || result[i] == result[j], "tied coordinates differ");
  }
  return 0;
}
