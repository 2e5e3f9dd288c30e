// Any triangles, repaired.
#include "orbicube/repair.h"

#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const Shape shape = surface(in);
  const obc_surface given = shape.surface();
  obc_repair_options options;
  obc_repair_options_init(&options, sizeof options);
  if (in.one_in(2)) {
    for (std::int32_t* step :
         {&options.weld, &options.clean, &options.slivers, &options.t_junctions, &options.orient, &options.contacts,
          &options.drop_parts, &options.cavities, &options.fill_holes, &options.fair})
      *step = in.choice(2);
    for (double* number : {&options.weld_distance, &options.sliver_ratio, &options.sliver_move,
                           &options.t_junction_distance, &options.contact_gap, &options.min_area_percent}) {
      if (in.one_in(3)) *number = in.number();
    }
    options.max_genus = in.choice(3) - 1;
    if (in.one_in(4)) options.max_handle_length = in.number();
    options.keep_parts = static_cast<std::size_t>(in.choice(3));
    options.max_hole_edges = static_cast<std::size_t>(in.choice(5));
  }
  obc_repair* repaired = nullptr;
  if (!ok([&](obc_error* e) { return obc_repair_compute(&given, &options, host.c(), &repaired, e); })) return 0;
  const std::size_t vertices = obc_repair_vertex_count(repaired), events = obc_repair_event_count(repaired);
  std::vector<double> positions(3 * vertices), sizes(events), places(3 * events);
  std::vector<std::uint32_t> triangles(3 * obc_repair_triangle_count(repaired)), counts(events);
  std::vector<std::int32_t> actions(events);
  require(ok([&](obc_error* e) {
            return obc_repair_copy(repaired, positions.data(), triangles.data(), nullptr, nullptr, e);
          }),
          "a surface cannot be copied");
  require(ok([&](obc_error* e) {
            return obc_repair_copy_events(repaired, actions.data(), counts.data(), places.data(), sizes.data(), e);
          }),
          "events cannot be copied");
  require_finite(positions, "a position that is not finite");
  require_below(triangles, vertices, "a triangle with a vertex that does not exist");
  require(!triangles.empty(), "a surface of nothing");
  obc_repair_report report;
  obc_repair_report_init(&report, sizeof report);
  require(ok([&](obc_error* e) { return obc_repair_get_report(repaired, &report, e); }), "no report");
  obc_repair_destroy(repaired);
  return 0;
}
