// Tetrahedral meshes without inverted elements; wraps orbicube/untangle.h.
#ifndef ORBICUBE_UNTANGLE_HPP
#define ORBICUBE_UNTANGLE_HPP

#include <cstdint>
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

// A mesh whose elements were split where that is needed; vertices of the mesh before come first.
struct Refined {
  std::vector<double> positions;
  std::vector<std::uint32_t> elements;
  std::vector<std::uint32_t> parents;  // of each element: the one of the mesh before that it is part of
  // Of each vertex: those of the mesh before whose mean it is there, four each for tetrahedra and three for triangles;
  // UINT32_MAX with weight 0 for the rest.
  std::vector<std::uint32_t> origins;
  std::vector<double> weights;
  Report report;
};

namespace runs {
template <class Call>
Refined refine(std::size_t axes, Host* host, const Call& body) {
  Refined result;
  const auto handle = detail::take<obc_untangle_refined, obc_untangle_refined_destroy>(
      host, [&](obc_untangle_refined** made, obc_error* error) { return body(made, &result.report, error); });
  const obc_untangle_refined* const out = handle.get();
  const std::size_t n = obc_untangle_refined_vertex_count(out), m = obc_untangle_refined_element_count(out);
  result.positions.resize(axes * n);
  result.elements.resize((axes + 1) * m);
  result.parents.resize(m);
  result.origins.resize((axes + 1) * n);
  result.weights.resize((axes + 1) * n);
  detail::call(nullptr, [&](obc_error* error) {
    return obc_untangle_refined_copy(out, result.positions.data(), result.elements.data(), result.parents.data(),
                                     result.origins.data(), result.weights.data(), error);
  });
  return result;
}
}  // namespace runs

// As tetrahedra(), and splits tetrahedra where the mesh as it is has no solution, or none is found.
inline Refined refine_tetrahedra(const Tetrahedra& problem, const Options& options = {}, Host* host = nullptr) {
  return runs::refine(3, host, [&](obc_untangle_refined** made, obc_untangle_report* report, obc_error* error) {
    return obc_untangle_refine_tetrahedra(&problem, &options, detail::c(host), made, report, error);
  });
}

// The same for triangles in the plane. A disk whose boundary is fixed to a star-shaped polygon always has a solution.
inline Refined refine_triangles(const Triangles& problem, const Options& options = {}, Host* host = nullptr) {
  return runs::refine(2, host, [&](obc_untangle_refined** made, obc_untangle_report* report, obc_error* error) {
    return obc_untangle_refine_triangles(&problem, &options, detail::c(host), made, report, error);
  });
}

}  // namespace untangle
}  // namespace api
}  // namespace orbicube

#endif
