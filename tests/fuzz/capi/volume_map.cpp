// Solids on polycubes: tetrahedra and options of any kind.
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
  map_solid(in, host);
  return 0;
}
