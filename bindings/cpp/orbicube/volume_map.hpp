// Maps of tetrahedral meshes without inverted tetrahedra, and hexahedral meshes; wraps orbicube/volume_map.h.
#ifndef ORBICUBE_VOLUME_MAP_HPP
#define ORBICUBE_VOLUME_MAP_HPP

#include <vector>

#include <orbicube/volume_map.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace volume_map {

using UntangleOptions = detail::Filled<obc_volume_map_untangle_options, obc_volume_map_untangle_options_init>;
using UntangleReport = detail::Filled<obc_volume_map_untangle_report, obc_volume_map_untangle_report_init>;

// A mesh in the caller's arrays. Rest, fixed and ties are set as members where they are requested.
struct UntangleProblem : detail::Filled<obc_volume_map_untangle_problem, obc_volume_map_untangle_problem_init> {
  UntangleProblem(Doubles places, Indices cells) {
    positions = places.data();
    vertex_count = detail::rows(places.size(), 3, "positions");
    tetrahedra = cells.data();
    tetrahedron_count = detail::rows(cells.size(), 4, "tetrahedra");
  }
};

struct Untangled {
  std::vector<double> positions;  // x y z a vertex
  UntangleReport report;
};

// Moves vertices until every tetrahedron is positive. Where some stay inverted it throws an Error with the status
// OBC_NO_VALID_RESULT, and *best, if it is given, is the best that was found.
inline Untangled untangle(const UntangleProblem& problem, const UntangleOptions& options = {}, Host* host = nullptr,
                          Untangled* best = nullptr) {
  Untangled result{std::vector<double>(3 * problem.vertex_count), {}};
  try {
    detail::call(host, [&](obc_error* error) {
      return obc_volume_map_untangle(&problem, &options, detail::c(host), result.positions.data(), &result.report,
                                     error);
    });
  } catch (const Error& error) {
    if (best != nullptr && error.status() == OBC_NO_VALID_RESULT) *best = std::move(result);
    throw;
  }
  return result;
}

using SolidOptions = detail::Filled<obc_volume_map_solid_options, obc_volume_map_solid_options_init>;
using HexesOptions = detail::Filled<obc_volume_map_hexes_options, obc_volume_map_hexes_options_init>;

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

// A certified mesh of hexahedra.
struct Hexes {
  std::vector<double> positions;            // x y z a vertex
  std::vector<std::uint32_t> hexahedra;     // eight vertices each
  std::vector<std::uint32_t> quads;         // four vertices each, of the boundary
  std::vector<std::uint32_t> quad_patches;  // of the polycube
  obc_volume_map_hexes_report report;
};

namespace detail_hexes {

// What the call f(&handle, error) hands out.
template <class F>
void copy(Host* host, Hexes& to, F&& f) {
  const auto keeper = detail::take<obc_volume_map_hexes, obc_volume_map_hexes_destroy>(host, std::forward<F>(f));
  const obc_volume_map_hexes* const made = keeper.get();
  to.positions.resize(3 * obc_volume_map_hexes_vertex_count(made));
  to.hexahedra.resize(8 * obc_volume_map_hexes_count(made));
  to.quads.resize(4 * obc_volume_map_hexes_quad_count(made));
  to.quad_patches.resize(obc_volume_map_hexes_quad_count(made));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_volume_map_hexes_copy(made, to.positions.data(), to.hexahedra.data(), to.quads.data(),
                                     to.quad_patches.data(), error);
  });
}

}  // namespace detail_hexes

// Fills a closed surface with hexahedra.
inline Hexes fill_with_hexahedra(const Surface& surface, const HexesOptions& options = {}, Host* host = nullptr) {
  Hexes result;
  result.report = detail::sized<obc_volume_map_hexes_report>();
  detail_hexes::copy(host, result, [&](obc_volume_map_hexes** out, obc_error* error) {
    return obc_volume_map_hexes_compute(&surface, &options, detail::c(host), &result.report, out, error);
  });
  return result;
}

using FrameOptions = detail::Filled<obc_volume_map_frame_options, obc_volume_map_frame_options_init>;
using FrameReport = obc_volume_map_frame_report;

// Fills a solid of tetrahedra with hexahedra that follow frames, w x y z a tetrahedron; without any a smooth field is
// made. The figures go to *report, if it is given; those of the result say what they have in common.
inline Hexes fill_along_frames(Doubles positions, Indices tetrahedra, Doubles frames, const FrameOptions& options = {},
                               Host* host = nullptr, FrameReport* report = nullptr) {
  const std::size_t vertices = detail::rows(positions.size(), 3, "positions");
  const std::size_t cells = detail::rows(tetrahedra.size(), 4, "tetrahedra");
  if (frames.size() != 0 && detail::rows(frames.size(), 4, "frames") != cells)
    throw Error(OBC_INVALID_ARGUMENT, "frames need four numbers a tetrahedron");
  FrameReport figures = detail::sized<FrameReport>();
  Hexes result;
  detail_hexes::copy(host, result, [&](obc_volume_map_hexes** out, obc_error* error) {
    return obc_volume_map_frame_hexes_compute(positions.data(), vertices, tetrahedra.data(), cells,
                                              frames.size() != 0 ? frames.data() : nullptr, &options, detail::c(host),
                                              &figures, out, error);
  });
  result.report = detail::sized<obc_volume_map_hexes_report>();
  result.report.min_scaled_jacobian = figures.min_scaled_jacobian;
  result.report.mean_scaled_jacobian = figures.mean_scaled_jacobian;
  result.report.volume = figures.volume;
  result.report.off_surface = figures.off_surface;
  if (report != nullptr) *report = figures;
  return result;
}

}  // namespace volume_map
}  // namespace api
}  // namespace orbicube

#endif
