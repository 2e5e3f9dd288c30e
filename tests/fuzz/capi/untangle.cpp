// Inverted tetrahedra: meshes, target shapes, fixed and tied coordinates, and options of any kind.
#include "orbicube/untangle.h"

#include <cstring>

#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
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
  std::vector<std::uint8_t> fixed(mesh.positions.size());
  for (std::uint8_t& flag : fixed)
    flag = in.one_in(4);
  std::vector<std::uint32_t> ties(mesh.positions.size(), UINT32_MAX);
  for (std::size_t i = in.below(6); i > 0; --i)
    ties[in.bits() % ties.size()] = in.index(ties.size());
  if (in.one_in(2)) problem.rest = rest.data();
  if (in.one_in(2)) problem.fixed_coordinates = fixed.data();
  std::vector<std::uint8_t> fixed_vertices(mesh.vertex_count());
  for (std::uint8_t& flag : fixed_vertices)
    flag = in.one_in(4);
  if (in.one_in(4)) problem.fixed = fixed_vertices.data();
  if (in.one_in(3)) problem.ties = ties.data();
  obc_untangle_options options;
  obc_untangle_options_init(&options, sizeof options);
  options.max_steps =
      in.one_in(20) ? static_cast<std::int32_t>(in.bits()) % 100 : static_cast<std::int32_t>(in.below(40));
  options.max_polish_steps = in.one_in(20) ? -1 : static_cast<std::int32_t>(in.below(5));
  options.free_boundary = in.one_in(2);
  if (in.one_in(8)) options.tolerance = in.number();
  if (in.one_in(3)) options.volume_weight = in.number();
  obc_untangle_report report;
  obc_untangle_report_init(&report, sizeof report);
  std::vector<double> result(mesh.positions.size());
  if (!ok([&](obc_error* e) {
        return obc_untangle_tetrahedra(&problem, &options, host.c(), result.data(), &report, e);
      }))
    return 0;
  require_finite(result, "a position that is not finite");
  require(report.inverted == 0 && report.first_inverted == UINT32_MAX, "a certified mesh with an inverted tetrahedron");
  require(report.min_determinant > -1e-9, "a certified mesh with a determinant that is not positive");  // rounded
  for (std::size_t i = 0; problem.fixed_coordinates != nullptr && i < result.size(); ++i)
    require(fixed[i] == 0 || std::memcmp(&result[i], &mesh.positions[i], sizeof result[i]) == 0,
            "a fixed coordinate moved");
  for (std::size_t i = 0; problem.fixed != nullptr && i < result.size(); ++i)
    require(fixed_vertices[i / 3] == 0 || std::memcmp(&result[i], &mesh.positions[i], sizeof result[i]) == 0,
            "a fixed vertex moved");
  for (std::size_t i = 0; problem.ties != nullptr && i < result.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      require(ties[i] == UINT32_MAX || ties[i] != ties[j] || result[i] == result[j], "tied coordinates differ");
  }
  return 0;
}
