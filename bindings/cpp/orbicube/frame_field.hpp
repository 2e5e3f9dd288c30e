// Smooth frame fields on tetrahedral meshes; wraps orbicube/frame_field.h.
#ifndef ORBICUBE_FRAME_FIELD_HPP
#define ORBICUBE_FRAME_FIELD_HPP

#include <vector>

#include <orbicube/frame_field.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace frame_field {

using Options = detail::Filled<obc_frame_field_options, obc_frame_field_options_init>;
using Constraints = detail::Filled<obc_frame_field_constraints, obc_frame_field_constraints_init>;
using Report = detail::Filled<obc_frame_field_report, obc_frame_field_report_init>;

// A solid in the caller's arrays.
struct Solid : obc_frame_field_solid {
  Solid(Doubles places, Indices cells) : obc_frame_field_solid() {
    positions = places.data();
    vertex_count = detail::rows(places.size(), 3, "positions");
    tetrahedra = cells.data();
    tetrahedron_count = detail::rows(cells.size(), 4, "tetrahedra");
  }
};

struct Field {
  std::vector<double> frames;  // w x y z a tetrahedron
  Report report;
};

// `start`: frames for the start OBC_FRAME_FIELD_GIVEN.
inline Field compute(const Solid& solid, const Options& options = {}, const Constraints& constraints = {},
                     Doubles start = {}, Host* host = nullptr) {
  if (!start.empty()) detail::check_size(start.size(), 4 * solid.tetrahedron_count, "start");
  Field field{std::vector<double>(start.begin(), start.end()), {}};
  field.frames.resize(4 * solid.tetrahedron_count);
  detail::call(host, [&](obc_error* error) {
    return obc_frame_field_compute(&solid, &options, &constraints, detail::c(host), field.frames.data(), &field.report,
                                   error);
  });
  return field;
}
inline Report measure(const Solid& solid, Doubles frames, Host* host = nullptr) {
  detail::check_size(frames.size(), 4 * solid.tetrahedron_count, "frames");
  Report report;
  detail::call(host, [&](obc_error* error) {
    return obc_frame_field_measure(&solid, frames.data(), detail::c(host), &report, error);
  });
  return report;
}
inline std::vector<std::uint8_t> matchings(const Solid& solid, Doubles frames, Host* host = nullptr) {
  detail::check_size(frames.size(), 4 * solid.tetrahedron_count, "frames");
  std::vector<std::uint8_t> found(4 * solid.tetrahedron_count);
  detail::call(host, [&](obc_error* error) {
    return obc_frame_field_matchings(&solid, frames.data(), detail::c(host), found.data(), error);
  });
  return found;
}

// Singular edges, and the curves that they form.
struct Singularities {
  std::vector<std::uint32_t> edges;  // two vertices each
  std::vector<std::uint8_t> rotations;
  std::vector<std::int8_t> turns;
  std::vector<std::size_t> curve_begin;
  std::vector<std::uint32_t> curve_edges, nodes, unmeshable_edges, unmeshable_vertices;

  Singularities(const Solid& solid, Doubles frames, Host* host = nullptr) {
    detail::check_size(frames.size(), 4 * solid.tetrahedron_count, "frames");
    const auto handle = detail::take<obc_frame_field_singularities, obc_frame_field_singularities_destroy>(
        host, [&](obc_frame_field_singularities** made, obc_error* error) {
          return obc_frame_field_singularities_create(&solid, frames.data(), detail::c(host), made, error);
        });
    const obc_frame_field_singularities* const out = handle.get();
    const std::size_t n = obc_frame_field_singular_edge_count(out);
    edges.resize(2 * n);
    rotations.resize(n);
    turns.resize(n);
    curve_begin.resize(obc_frame_field_singular_curve_count(out) + 1);
    curve_edges.resize(n);
    nodes.resize(obc_frame_field_singular_node_count(out));
    unmeshable_edges.resize(obc_frame_field_unmeshable_edge_count(out));
    unmeshable_vertices.resize(obc_frame_field_unmeshable_vertex_count(out));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_frame_field_singularities_copy(out, edges.data(), rotations.data(), turns.data(), curve_begin.data(),
                                                curve_edges.data(), nodes.data(), error);
    });
    detail::call(nullptr, [&](obc_error* error) {
      return obc_frame_field_unmeshable_copy(out, unmeshable_edges.data(), unmeshable_vertices.data(), error);
    });
  }
};

}  // namespace frame_field
}  // namespace api
}  // namespace orbicube

#endif
