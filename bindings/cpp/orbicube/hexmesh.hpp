// Hexahedral meshes of closed surfaces and of tetrahedral solids; wraps orbicube/hexmesh.h.
#ifndef ORBICUBE_HEXMESH_HPP
#define ORBICUBE_HEXMESH_HPP

#include <array>
#include <string>
#include <vector>

#include <orbicube/hexmesh.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace hexmesh {

using Options = detail::Filled<obc_hexmesh_options, obc_hexmesh_options_init>;

// A corner or a curve of the surface that a mesh lacks.
struct MissingFeature {
  bool corner;
  std::array<double, 3> first, last;  // ends of the curve
  double captured;                    // fraction of its length
  std::string why;
};

// A certified mesh of hexahedra.
struct Hexes {
  std::vector<double> positions;            // x y z a vertex
  std::vector<std::uint32_t> hexahedra;     // eight vertices each
  std::vector<std::uint32_t> quads;         // four vertices each, of the boundary
  std::vector<std::uint32_t> quad_patches;  // of the polycube, or of the features where they are embedded
  std::vector<MissingFeature> missing;      // of the features that options request
  obc_hexmesh_report report;
};

namespace detail_hexes {

// What the call f(&handle, error) hands out.
template <class F>
void copy(Host* host, Hexes& to, F&& f) {
  const auto keeper = detail::take<obc_hexmesh, obc_hexmesh_destroy>(host, std::forward<F>(f));
  const obc_hexmesh* const made = keeper.get();
  to.positions.resize(3 * obc_hexmesh_vertex_count(made));
  to.hexahedra.resize(8 * obc_hexmesh_count(made));
  to.quads.resize(4 * obc_hexmesh_quad_count(made));
  to.quad_patches.resize(obc_hexmesh_quad_count(made));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_hexmesh_copy(made, to.positions.data(), to.hexahedra.data(), to.quads.data(), to.quad_patches.data(),
                            error);
  });
  for (std::size_t i = 0; i < obc_hexmesh_missing_count(made); ++i) {
    auto m = detail::sized<obc_hexmesh_missing>();
    detail::call(nullptr, [&](obc_error* error) { return obc_hexmesh_get_missing(made, i, &m, error); });
    to.missing.push_back({m.corner != 0,
                          {m.first[0], m.first[1], m.first[2]},
                          {m.last[0], m.last[1], m.last[2]},
                          m.captured,
                          obc_hexmesh_missing_reason(made, i)});
  }
}

}  // namespace detail_hexes

// Fills a closed surface with hexahedra.
inline Hexes fill_with_hexahedra(const Surface& surface, const Options& options = {}, Host* host = nullptr) {
  Hexes result;
  result.report = detail::sized<obc_hexmesh_report>();
  detail_hexes::copy(host, result, [&](obc_hexmesh** out, obc_error* error) {
    return obc_hexmesh_compute(&surface, &options, detail::c(host), &result.report, out, error);
  });
  return result;
}

// Fills a solid of tetrahedra with hexahedra, along frames if there are any, w x y z a tetrahedron.
inline Hexes fill_with_hexahedra(Doubles positions, Indices tetrahedra, Doubles frames, const Options& options = {},
                                 Host* host = nullptr) {
  const std::size_t vertices = detail::rows(positions.size(), 3, "positions");
  const std::size_t cells = detail::rows(tetrahedra.size(), 4, "tetrahedra");
  if (frames.size() != 0 && detail::rows(frames.size(), 4, "frames") != cells)
    throw Error(OBC_INVALID_ARGUMENT, "frames need four numbers a tetrahedron");
  Hexes result;
  result.report = detail::sized<obc_hexmesh_report>();
  detail_hexes::copy(host, result, [&](obc_hexmesh** out, obc_error* error) {
    return obc_hexmesh_compute_solid(positions.data(), vertices, tetrahedra.data(), cells,
                                     frames.size() != 0 ? frames.data() : nullptr, &options, detail::c(host),
                                     &result.report, out, error);
  });
  return result;
}

}  // namespace hexmesh
}  // namespace api
}  // namespace orbicube

#endif
