// Maps of tetrahedral meshes without inverted tetrahedra; wraps orbicube/volume_map.h.
#ifndef ORBICUBE_VOLUME_MAP_HPP
#define ORBICUBE_VOLUME_MAP_HPP

#include <vector>

#include <orbicube/volume_map.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace volume_map {

using UntangleOptions = detail::Filled<obc_volume_map_untangle_options, obc_volume_map_untangle_options_init>;
using UntangleReport = detail::Filled<obc_volume_map_untangle_report, obc_volume_map_untangle_report_init>;

// A mesh in the caller's arrays. Rest, fixed and ties are set as members where they are wanted.
struct Tangle : detail::Filled<obc_volume_map_tangle, obc_volume_map_tangle_init> {
  Tangle(Doubles places, Indices cells) {
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
inline Untangled untangle(const Tangle& tangle, const UntangleOptions& options = {}, Host* host = nullptr,
                          Untangled* best = nullptr) {
  Untangled result{std::vector<double>(3 * tangle.vertex_count), {}};
  try {
    detail::call(host, [&](obc_error* error) {
      return obc_volume_map_untangle(&tangle, &options, detail::c(host), result.positions.data(), &result.report,
                                     error);
    });
  } catch (const Error& error) {
    if (best != nullptr && error.status() == OBC_NO_VALID_RESULT) *best = std::move(result);
    throw;
  }
  return result;
}

}  // namespace volume_map
}  // namespace api
}  // namespace orbicube

#endif
