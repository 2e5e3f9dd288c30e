// Any triangles to a closed, oriented, manifold surface; wraps orbicube/repair.h.
#ifndef ORBICUBE_REPAIR_HPP
#define ORBICUBE_REPAIR_HPP

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include <orbicube/repair.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace repair {

using Options = detail::Filled<obc_repair_options, obc_repair_options_init>;
using Report = detail::Filled<obc_repair_report, obc_repair_report_init>;

// What was done at one place.
struct Event {
  std::int32_t action;  // OBC_REPAIR_...
  std::uint32_t count;
  std::array<double, 3> place;
  double size;
};

struct Repaired {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> vertex_source, triangle_source;  // UINT32_MAX: made by the repair
  std::vector<Event> events;
  Report report;
};

// Whether a closed, oriented manifold was reached is in the report.
inline Repaired repair(const Surface& surface, const Options& options = {}, Host* host = nullptr) {
  const auto handle = detail::take<obc_repair, obc_repair_destroy>(host, [&](obc_repair** made, obc_error* error) {
    return obc_repair_compute(&surface, &options, detail::c(host), made, error);
  });
  const obc_repair* const out = handle.get();
  Repaired result;
  result.positions.resize(3 * obc_repair_vertex_count(out));
  result.triangles.resize(3 * obc_repair_triangle_count(out));
  result.vertex_source.resize(obc_repair_vertex_count(out));
  result.triangle_source.resize(obc_repair_triangle_count(out));
  const std::size_t events = obc_repair_event_count(out);
  std::vector<std::int32_t> actions(events);
  std::vector<std::uint32_t> counts(events);
  std::vector<double> places(3 * events), sizes(events);
  detail::call(nullptr, [&](obc_error* error) {
    return obc_repair_copy(out, result.positions.data(), result.triangles.data(), result.vertex_source.data(),
                           result.triangle_source.data(), error);
  });
  detail::call(nullptr, [&](obc_error* error) {
    return obc_repair_copy_events(out, actions.data(), counts.data(), places.data(), sizes.data(), error);
  });
  detail::call(nullptr, [&](obc_error* error) { return obc_repair_get_report(out, &result.report, error); });
  for (std::size_t i = 0; i < events; ++i)
    result.events.push_back({actions[i], counts[i], {places[3 * i], places[3 * i + 1], places[3 * i + 2]}, sizes[i]});
  return result;
}

using LabelOptions = detail::Filled<obc_repair_label_options, obc_repair_label_options_init>;
using LabelReport = detail::Filled<obc_repair_label_report, obc_repair_label_report_init>;

struct LabelSurface {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;
  LabelReport label_report;
  Report report;  // with the certificate
};

// The closed surface of a label of an image. `labels`: x fastest; `to_world`: 4x4, row-major, or empty.
inline LabelSurface surface_of_label(View<const std::int32_t> labels, const std::array<std::size_t, 3>& size,
                                     Doubles to_world = nullptr, const LabelOptions& options = {},
                                     Host* host = nullptr) {
  const auto within = [](std::size_t have, std::size_t n) { return n != 0 && have % n == 0; };
  if (!within(labels.size(), size[0]) || !within(labels.size() / size[0], size[1]) ||
      labels.size() / size[0] / size[1] != size[2])
    throw std::invalid_argument("labels: the product of the sizes is needed");
  if (to_world.size() != 0 && to_world.size() != 16) throw std::invalid_argument("to_world: 16 numbers are needed");
  const auto handle = detail::take<obc_repair, obc_repair_destroy>(host, [&](obc_repair** made, obc_error* error) {
    return obc_repair_surface_of_label(labels.data(), size.data(), to_world.data(), &options, detail::c(host), made,
                                       error);
  });
  const obc_repair* const out = handle.get();
  LabelSurface result;
  result.positions.resize(3 * obc_repair_vertex_count(out));
  result.triangles.resize(3 * obc_repair_triangle_count(out));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_repair_copy(out, result.positions.data(), result.triangles.data(), nullptr, nullptr, error);
  });
  detail::call(nullptr, [&](obc_error* error) { return obc_repair_get_report(out, &result.report, error); });
  detail::call(nullptr,
               [&](obc_error* error) { return obc_repair_get_label_report(out, &result.label_report, error); });
  return result;
}

inline std::string action_name(std::int32_t action) {
  return obc_repair_action_name(action);
}

}  // namespace repair
}  // namespace api
}  // namespace orbicube

#endif
