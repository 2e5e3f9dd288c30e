// Inverted tetrahedra: meshes, target shapes, fixed and tied coordinates, and options of any kind; solids on polycubes.
#include "orbicube/volume_map.h"

#include <algorithm>

#include "shapes.h"

using namespace fuzz;

namespace {

double volume_of(const std::vector<double>& positions, const std::uint32_t* t) {
  double e[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      e[i][k] = positions[3 * t[i + 1] + k] - positions[3 * t[0] + k];
  }
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

void map_solid(Input& in, Host& host) {
  const Shape mesh = solid(in);
  obc_volume_map_solid_options options;
  obc_volume_map_solid_options_init(&options, sizeof options);
  options.corners = in.one_in(3) ? 8 : in.byte();
  options.seed = in.byte();
  obc_volume_map_solid* map = nullptr;
  if (!ok([&](obc_error* e) {
        return obc_volume_map_solid_compute(mesh.positions.data(), mesh.vertex_count(), mesh.cells.data(),
                                            mesh.cell_count(), &options, host.c(), &map, e);
      }))
    return;
  const std::size_t n = obc_volume_map_solid_vertex_count(map), m = obc_volume_map_solid_tetrahedron_count(map);
  std::vector<double> positions(3 * n), polycube(3 * n);
  std::vector<std::uint32_t> tetrahedra(4 * m);
  require(ok([&](obc_error* e) {
            return obc_volume_map_solid_copy(map, positions.data(), polycube.data(), tetrahedra.data(), e);
          }),
          "a map of a solid cannot be copied");
  obc_volume_map_solid_destroy(map);
  require_finite(positions, "a position that is not finite");
  require_finite(polycube, "a place on a polycube that is not finite");
  require_below(tetrahedra, n, "a tetrahedron with a vertex that does not exist");
  double scale = 0;
  for (const double x : polycube)
    scale = std::max(scale, std::abs(x));
  for (std::size_t t = 0; t < m; ++t)
    require(volume_of(polycube, &tetrahedra[4 * t]) > -1e-12 * scale * scale * scale, "an inverted tetrahedron");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  if (in.one_in(40)) {
    map_solid(in, host);
    return 0;
  }
  Shape mesh = solid(in, in.one_in(2));
  const std::vector<double> rest = mesh.positions;
  for (std::size_t i = in.below(6); i > 0 && !mesh.positions.empty(); --i)
    mesh.positions[in.bits() % mesh.positions.size()] += 2 * in.moderate();
  obc_volume_map_untangle_problem problem;
  obc_volume_map_untangle_problem_init(&problem, sizeof problem);
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
  if (in.one_in(2)) problem.fixed = fixed.data();
  if (in.one_in(3)) problem.ties = ties.data();
  obc_volume_map_untangle_options options;
  obc_volume_map_untangle_options_init(&options, sizeof options);
  options.steps = in.one_in(20) ? static_cast<std::int32_t>(in.bits()) % 100 : static_cast<std::int32_t>(in.below(40));
  options.polish_steps = in.one_in(20) ? -1 : static_cast<std::int32_t>(in.below(5));
  if (in.one_in(3)) options.volume_weight = in.number();
  obc_volume_map_untangle_report report;
  obc_volume_map_untangle_report_init(&report, sizeof report);
  std::vector<double> result(mesh.positions.size());
  if (!ok([&](obc_error* e) {
        return obc_volume_map_untangle(&problem, &options, host.c(), result.data(), &report, e);
      }))
    return 0;
  require_finite(result, "a position that is not finite");
  require(report.inverted == 0 && report.first_inverted == UINT32_MAX, "a certified mesh with an inverted tetrahedron");
  require(report.min_determinant > -1e-9, "a certified mesh with a determinant that is not positive");  // rounded
  for (std::size_t i = 0; problem.fixed != nullptr && i < result.size(); ++i)
    require(fixed[i] == 0 || std::memcmp(&result[i], &mesh.positions[i], sizeof result[i]) == 0,
            "a fixed coordinate moved");
  for (std::size_t i = 0; problem.ties != nullptr && i < result.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      require(ties[i] == UINT32_MAX || ties[i] != ties[j] || result[i] == result[j], "tied coordinates differ");
  }
  return 0;
}
