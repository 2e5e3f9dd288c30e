// Closed surfaces filled with tetrahedra by TetGen (AGPL 3, which binds programs that link it); wraps
// orbicube/tetrahedra.h.
#ifndef ORBICUBE_TETRAHEDRA_HPP
#define ORBICUBE_TETRAHEDRA_HPP

#include <vector>

#include <orbicube/tetrahedra.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace tetrahedra {

using Options = detail::Filled<obc_tetrahedra_options, obc_tetrahedra_options_init>;

struct Solid {
  std::vector<double> positions;
  std::vector<std::uint32_t> tetrahedra, boundary, boundary_source;
  std::size_t parts = 0, cavities = 0;
};

inline Solid fill(const Surface& surface, const Options& options = {}, Host* host = nullptr) {
  const auto handle =
      detail::take<obc_tetrahedra, obc_tetrahedra_destroy>(host, [&](obc_tetrahedra** made, obc_error* error) {
        return obc_tetrahedra_fill(&surface, &options, detail::c(host), made, error);
      });
  const obc_tetrahedra* const out = handle.get();
  Solid solid;
  solid.positions.resize(3 * obc_tetrahedra_vertex_count(out));
  solid.tetrahedra.resize(4 * obc_tetrahedra_count(out));
  solid.boundary.resize(3 * obc_tetrahedra_boundary_count(out));
  solid.boundary_source.resize(obc_tetrahedra_boundary_count(out));
  solid.parts = obc_tetrahedra_part_count(out);
  solid.cavities = obc_tetrahedra_cavity_count(out);
  detail::call(nullptr, [&](obc_error* error) {
    return obc_tetrahedra_copy(out, solid.positions.data(), solid.tetrahedra.data(), solid.boundary.data(),
                               solid.boundary_source.data(), error);
  });
  return solid;
}

// Throws, with kind and place, unless fill can work.
inline void check_surface(const Surface& surface, Host* host = nullptr) {
  std::size_t count = 0;
  detail::call(host, [&](obc_error* error) {
    return obc_tetrahedra_check_surface(&surface, detail::c(host), nullptr, 0, &count, error);
  });
}

}  // namespace tetrahedra
}  // namespace api
}  // namespace orbicube

#endif
