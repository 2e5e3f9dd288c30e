// Inverted tetrahedra: meshes, wanted shapes, fixed and tied coordinates, and options of any kind.
#include "orbicube/volume_map.h"
#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  Shape mesh = solid(in, in.one_in(2));
  const std::vector<double> rest = mesh.positions;
  for (std::size_t i = in.below(6); i > 0 && !mesh.positions.empty(); --i)
    mesh.positions[in.bits() % mesh.positions.size()] += 2 * in.moderate();
  obc_volume_map_tangle tangle;
  obc_volume_map_tangle_init(&tangle, sizeof tangle);
  tangle.positions = mesh.positions.data();
  tangle.vertex_count = mesh.vertex_count();
  tangle.tetrahedra = mesh.cells.data();
  tangle.tetrahedron_count = mesh.cell_count();
  std::vector<std::uint8_t> fixed(mesh.positions.size());
  for (std::uint8_t& flag : fixed)
    flag = in.one_in(4);
  std::vector<std::uint32_t> ties(mesh.positions.size(), UINT32_MAX);
  for (std::size_t i = in.below(6); i > 0; --i)
    ties[in.bits() % ties.size()] = in.index(ties.size());
  if (in.one_in(2)) tangle.rest = rest.data();
  if (in.one_in(2)) tangle.fixed = fixed.data();
  if (in.one_in(3)) tangle.ties = ties.data();
  obc_volume_map_untangle_options options;
  obc_volume_map_untangle_options_init(&options, sizeof options);
  options.steps = in.one_in(20) ? static_cast<std::int32_t>(in.bits()) % 100 : static_cast<std::int32_t>(in.below(40));
  options.polish_steps = in.one_in(20) ? -1 : static_cast<std::int32_t>(in.below(5));
  if (in.one_in(3)) options.volume_weight = in.number();
  obc_volume_map_untangle_report report;
  obc_volume_map_untangle_report_init(&report, sizeof report);
  std::vector<double> result(mesh.positions.size());
  if (!ok([&](obc_error* e) {
        return obc_volume_map_untangle(&tangle, &options, host.c(), result.data(), &report, e);
      }))
    return 0;
  require_finite(result, "a position that is not finite");
  require(report.inverted == 0 && report.first_inverted == UINT32_MAX, "a certified mesh with an inverted tetrahedron");
  require(report.least_determinant > -1e-9, "a certified mesh with a determinant that is not positive");  // rounded
  for (std::size_t i = 0; tangle.fixed != nullptr && i < result.size(); ++i)
    require(fixed[i] == 0 || std::memcmp(&result[i], &mesh.positions[i], sizeof result[i]) == 0,
            "a fixed coordinate moved");
  for (std::size_t i = 0; tangle.ties != nullptr && i < result.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      require(ties[i] == UINT32_MAX || ties[i] != ties[j] || result[i] == result[j], "tied coordinates differ");
  }
  return 0;
}
