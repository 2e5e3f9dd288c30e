// Maps of solids to polycubes without inverted tetrahedra; wraps orbicube/volume_map.h.
#ifndef ORBICUBE_VOLUME_MAP_HPP
#define ORBICUBE_VOLUME_MAP_HPP

#include <vector>

#include <orbicube/volume_map.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace volume_map {

using SolidOptions = detail::Filled<obc_volume_map_solid_options, obc_volume_map_solid_options_init>;

// A solid on the polycube of its boundary, one to one.
struct Solid {
  std::vector<double> positions, polycube;  // x y z a vertex, in space and on the polycube
  std::vector<std::uint32_t> tetrahedra;
};

inline Solid map_to_polycube(Doubles positions, Indices tetrahedra, const SolidOptions& options = {},
                             Host* host = nullptr) {
  const std::size_t vertices = detail::rows(positions.size(), 3, "positions");
  const std::size_t cells = detail::rows(tetrahedra.size(), 4, "tetrahedra");
  const auto keeper = detail::take<obc_volume_map_solid, obc_volume_map_solid_destroy>(
      host, [&](obc_volume_map_solid** out, obc_error* error) {
        return obc_volume_map_solid_compute(positions.data(), vertices, tetrahedra.data(), cells, &options,
                                            detail::c(host), out, error);
      });
  const obc_volume_map_solid* const made = keeper.get();
  Solid result;
  result.positions.resize(3 * obc_volume_map_solid_vertex_count(made));
  result.polycube.resize(result.positions.size());
  result.tetrahedra.resize(4 * obc_volume_map_solid_tetrahedron_count(made));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_volume_map_solid_copy(made, result.positions.data(), result.polycube.data(), result.tetrahedra.data(),
                                     error);
  });
  return result;
}

}  // namespace volume_map
}  // namespace api
}  // namespace orbicube

#endif
