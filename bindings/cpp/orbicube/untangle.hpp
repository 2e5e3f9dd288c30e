// Tetrahedral meshes without inverted elements; wraps orbicube/untangle.h.
#ifndef ORBICUBE_UNTANGLE_HPP
#define ORBICUBE_UNTANGLE_HPP

#include <vector>

#include <orbicube/untangle.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace untangle {

using Options = detail::Filled<obc_untangle_options, obc_untangle_options_init>;
using Report = detail::Filled<obc_untangle_report, obc_untangle_report_init>;

// A mesh in the caller's arrays. Rest, fixed, fixed_coordinates and ties are set as members where they are requested.
struct Tetrahedra : detail::Filled<obc_untangle_tetrahedra_problem, obc_untangle_tetrahedra_problem_init> {
  Tetrahedra(Doubles places, Indices cells) {
    positions = places.data();
    vertex_count = detail::rows(places.size(), 3, "positions");
    tetrahedra = cells.data();
    tetrahedron_count = detail::rows(cells.size(), 4, "tetrahedra");
  }
};

// A flat mesh, x y a vertex; rest positions are x y z a vertex.
struct Triangles : detail::Filled<obc_untangle_triangles_problem, obc_untangle_triangles_problem_init> {
  Triangles(Doubles places, Indices corners) {
    positions = places.data();
    vertex_count = detail::rows(places.size(), 2, "positions");
    triangles = corners.data();
    triangle_count = detail::rows(corners.size(), 3, "triangles");
  }
};

struct Untangled {
  std::vector<double> positions;  // x y z a vertex; x y of a flat mesh
  Report report;
};

// What is common to all functions of this file.
namespace runs {
template <class Call>
Untangled run(std::size_t coordinates, Host* host, Untangled* best, const Call& body) {
  Untangled result{std::vector<double>(coordinates), {}};
  try {
    detail::call(host, [&](obc_error* error) { return body(result.positions.data(), &result.report, error); });
  } catch (const Error& error) {
    if (best != nullptr && error.status() == OBC_NO_VALID_RESULT) *best = std::move(result);
    throw;
  }
  return result;
}
}  // namespace runs

// Moves vertices until every tetrahedron is positive. Where some stay inverted it throws an Error with the status
// OBC_NO_VALID_RESULT, and *best, if it is given, is the best that was found.
inline Untangled tetrahedra(const Tetrahedra& problem, const Options& options = {}, Host* host = nullptr,
                            Untangled* best = nullptr) {
  return runs::run(3 * problem.vertex_count, host, best,
                   [&](double* result, obc_untangle_report* report, obc_error* error) {
                     return obc_untangle_tetrahedra(&problem, &options, detail::c(host), result, report, error);
                   });
}

// The same for triangles in the plane.
inline Untangled triangles(const Triangles& problem, const Options& options = {}, Host* host = nullptr,
                           Untangled* best = nullptr) {
  return runs::run(2 * problem.vertex_count, host, best,
                   [&](double* result, obc_untangle_report* report, obc_error* error) {
                     return obc_untangle_triangles(&problem, &options, detail::c(host), result, report, error);
                   });
}

}  // namespace untangle
}  // namespace api
}  // namespace orbicube

#endif
