// Any triangles to a closed, oriented, manifold surface; wraps orbicube/repair.h.
#ifndef ORBICUBE_REPAIR_HPP
#define ORBICUBE_REPAIR_HPP

#include <array>
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

inline std::string action_name(std::int32_t action) {
  return obc_repair_action_name(action);
}

}  // namespace repair
}  // namespace api
}  // namespace orbicube

#endif
