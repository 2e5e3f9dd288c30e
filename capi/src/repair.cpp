#include "orbicube/repair.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include "base/version.h"
#include "capi/src/entry.h"
#include "capi/src/surface_view.h"
#include "repair/labels/surface_of_labels.h"
#include "repair/repair.h"

using namespace orbicube;

struct obc_repair {
  explicit obc_repair(const obc_host* host) : adapter(host), result(adapter.host().memory) {}
  capi::HostAdapter adapter;
  repair::Repaired result;
  repair::LabelReport label;
};

namespace {

static_assert(static_cast<std::int32_t>(repair::Action::cut_handle) == OBC_REPAIR_CUT_HANDLE);

obc_repair_options default_options() {
  const repair::Options defaults;
  obc_repair_options o{};
  o.struct_size = sizeof o;
  o.weld = defaults.weld;
  o.clean = defaults.clean;
  o.slivers = defaults.slivers;
  o.t_junctions = defaults.t_junctions;
  o.orient = defaults.orient;
  o.contacts = defaults.contacts;
  o.drop_parts = defaults.drop_parts;
  o.cavities = defaults.parts.cavities;
  o.fill_holes = defaults.fill_holes;
  o.fair = defaults.holes.fair;
  o.find_intersections = defaults.find_intersections;
  o.weld_distance = defaults.weld_distance;
  o.sliver_ratio = defaults.sliver_ratio;
  o.sliver_move = defaults.sliver_move;
  o.t_junction_distance = defaults.t_junction_distance;
  o.contact_gap = defaults.contact_gap;
  o.min_area_percent = defaults.parts.min_area_percent;
  o.keep_parts = defaults.parts.keep;
  o.max_hole_edges = defaults.holes.max_edges;
  o.max_genus = static_cast<std::int32_t>(defaults.handles.max_genus);
  o.max_handle_length = defaults.handles.max_length;
  o.wrap_offset = defaults.wrap_offset;
  return o;
}

repair::Options options_of(const obc_repair_options& o) {
  repair::Options options;
  options.weld = o.weld != 0;
  options.clean = o.clean != 0;
  options.slivers = o.slivers != 0;
  options.t_junctions = o.t_junctions != 0;
  options.orient = o.orient != 0;
  options.contacts = o.contacts != 0;
  options.drop_parts = o.drop_parts != 0;
  options.parts = {.keep = o.keep_parts, .min_area_percent = o.min_area_percent, .cavities = o.cavities != 0};
  options.fill_holes = o.fill_holes != 0;
  options.holes = {.max_edges = o.max_hole_edges, .fair = o.fair != 0};
  options.handles = {.max_genus = o.max_genus, .max_length = o.max_handle_length};
  options.wrap_offset = o.wrap_offset;
  options.find_intersections = o.find_intersections != 0;
  options.weld_distance = o.weld_distance;
  options.sliver_ratio = o.sliver_ratio;
  options.sliver_move = o.sliver_move;
  options.t_junction_distance = o.t_junction_distance;
  options.contact_gap = o.contact_gap;
  return options;
}

obc_repair_report report_of(const repair::Report& r) {
  obc_repair_report report{};
  report.changed = r.changed;
  report.closed = r.certificate.closed;
  report.manifold = r.certificate.manifold;
  report.oriented = r.certificate.oriented;
  report.orientable = r.orientable;
  report.welded_vertices = r.weld.vertices;
  report.weld_lost_triangles = r.weld.triangles;
  report.degenerate_faces = r.clean.degenerate;
  report.duplicate_faces = r.clean.duplicate;
  report.unused_vertices = r.unused_vertices;
  report.near_degenerate = r.slivers.found;
  report.collapsed_edges = r.slivers.collapsed;
  report.flipped_edges = r.slivers.flipped;
  report.left_near_degenerate = r.slivers.left;
  report.t_junctions = r.t_junctions.splits;
  report.reversed_triangles = r.reversed_triangles;
  report.contact_edges = r.contacts.edges;
  report.contact_vertices = r.contacts.vertices;
  report.contact_added_vertices = r.contacts.added_vertices;
  report.found_parts = r.parts.found;
  report.kept_parts = r.parts.kept;
  report.cavity_parts = r.parts.cavities;
  report.dropped_triangles = r.parts.dropped_triangles;
  report.found_holes = r.holes.found;
  report.filled_holes = r.holes.filled;
  report.patch_triangles = r.holes.triangles;
  report.patch_vertices = r.holes.vertices;
  report.cut_handles = r.handles.cut;
  report.handle_move = r.handles.largest_move;
  report.longest_handle = r.handles.longest;
  report.weld_move = r.weld.largest_move;
  report.sliver_move = r.slivers.largest_move;
  report.t_junction_move = r.t_junctions.largest_move;
  report.dropped_area_percent = r.parts.dropped_area_percent;
  report.distance_from_input = r.move.from_input;
  report.distance_from_result = r.move.from_result;
  report.distance_of_patches = r.move.patches;
  report.parts = r.certificate.parts;
  report.genus = r.certificate.genus;
  report.boundary_loops = r.certificate.boundary_loops;
  report.self_intersections = r.certificate.self_intersections;
  report.area = r.certificate.area;
  report.volume = r.certificate.volume;
  return report;
}

obc_repair_label_options default_label_options() {
  const repair::LabelOptions defaults;
  obc_repair_label_options o{};
  o.struct_size = sizeof o;
  o.label = defaults.label;
  o.cavities = defaults.cavities;
  o.handles = defaults.handles;
  o.keep_parts = defaults.keep;
  o.smoothing = defaults.smoothing;
  o.max_slide = defaults.max_slide;
  return o;
}

repair::LabelImage image_of(const std::int32_t* labels, const std::size_t* size, const double* to_world) {
  repair::LabelImage image{{}, {size[0], size[1], size[2]}, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
  std::size_t count = 0;
  capi::require(!__builtin_mul_overflow(size[0], size[1], &count) && !__builtin_mul_overflow(count, size[2], &count) &&
                    count <= std::numeric_limits<std::ptrdiff_t>::max() / sizeof(std::int32_t),
                "the sizes of the image overflow");
  image.labels = {labels, count};
  if (to_world != nullptr) std::copy_n(to_world, 16, image.to_world.begin());
  return image;
}

obc_repair_label_report label_report_of(const repair::LabelReport& r) {
  obc_repair_label_report report{};
  report.label = r.label;
  report.voxels = r.voxels;
  report.border_voxels = r.border_voxels;
  report.found_parts = r.found_parts;
  report.kept_parts = r.kept_parts;
  report.dropped_voxels = r.dropped_voxels;
  report.cavities = r.cavities;
  report.filled_voxels = r.filled_voxels;
  report.handles = r.handles;
  report.added_voxels = r.added_voxels;
  report.removed_voxels = r.removed_voxels;
  report.centered_vertices = r.centered_vertices;
  report.largest_slide = r.largest_slide;
  return report;
}

template <class Element, class Number>
void copy(const base::Array<Element>& from, Number* to) {
  if (to != nullptr && !from.empty()) std::memcpy(to, from.data(), from.size() * sizeof(Element));
}

}  // namespace

obc_status obc_repair_options_init(obc_repair_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_repair_report_init(obc_repair_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_repair_report{});
}

obc_status obc_repair_compute(const obc_surface* surface, const obc_repair_options* options, const obc_host* host,
                              obc_repair** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    const capi::SurfaceView s(surface);
    const obc_repair_options o = capi::copy_versioned(options, default_options());
    auto made = std::make_unique<obc_repair>(host);
    made->result = repair::repair(s.positions, s.triangles, options_of(o), made->adapter.host());
    *out = made.release();
  });
}

void obc_repair_destroy(obc_repair* repaired) {
  delete repaired;
}

size_t obc_repair_vertex_count(const obc_repair* repaired) {
  return repaired != nullptr ? repaired->result.surface.positions.size() : 0;
}

size_t obc_repair_triangle_count(const obc_repair* repaired) {
  return repaired != nullptr ? repaired->result.surface.triangles.size() : 0;
}

size_t obc_repair_event_count(const obc_repair* repaired) {
  return repaired != nullptr ? repaired->result.events.size() : 0;
}

obc_status obc_repair_copy(const obc_repair* repaired, double* positions, uint32_t* triangles, uint32_t* vertex_source,
                           uint32_t* triangle_source, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(repaired != nullptr, "repaired is NULL");
    copy(repaired->result.surface.positions, positions);
    copy(repaired->result.surface.triangles, triangles);
    copy(repaired->result.surface.vertex_source, vertex_source);
    copy(repaired->result.surface.triangle_source, triangle_source);
  });
}

obc_status obc_repair_copy_events(const obc_repair* repaired, int32_t* actions, uint32_t* counts, double* places,
                                  double* sizes, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(repaired != nullptr, "repaired is NULL");
    for (std::size_t i = 0; i < repaired->result.events.size(); ++i) {
      const repair::Event& event = repaired->result.events[i];
      if (actions != nullptr) actions[i] = static_cast<std::int32_t>(event.action);
      if (counts != nullptr) counts[i] = event.count;
      if (places != nullptr) std::memcpy(places + 3 * i, event.place.data(), 3 * sizeof(double));
      if (sizes != nullptr) sizes[i] = event.size;
    }
  });
}

obc_status obc_repair_get_report(const obc_repair* repaired, obc_repair_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(repaired != nullptr, "repaired is NULL");
    capi::require(report != nullptr, "report is NULL");
    capi::write_versioned(report, report_of(repaired->result.report));
  });
}

obc_status obc_repair_label_options_init(obc_repair_label_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_label_options());
}

obc_status obc_repair_label_report_init(obc_repair_label_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_repair_label_report{});
}

obc_status obc_repair_surface_of_label(const int32_t* labels, const size_t* size, const double* to_world,
                                       const obc_repair_label_options* options, const obc_host* host, obc_repair** out,
                                       obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(labels != nullptr, "labels is NULL");
    capi::require(size != nullptr, "size is NULL");
    const obc_repair_label_options o = capi::copy_versioned(options, default_label_options());
    auto made = std::make_unique<obc_repair>(host);
    repair::LabelSurface surface = repair::surface_of_label(image_of(labels, size, to_world),
                                                            {.label = o.label,
                                                             .keep = o.keep_parts,
                                                             .cavities = o.cavities != 0,
                                                             .handles = o.handles != 0,
                                                             .smoothing = o.smoothing,
                                                             .max_slide = o.max_slide},
                                                            made->adapter.host());
    repair::Repaired& result = made->result;
    result.surface.vertex_source.assign(surface.positions.size(), mesh::no_index);
    result.surface.triangle_source.assign(surface.triangles.size(), mesh::no_index);
    result.surface.positions = std::move(surface.positions);
    result.surface.triangles = std::move(surface.triangles);
    result.report.certificate = surface.report.certificate;
    result.report.changed = true;
    result.report.parts.found = surface.report.found_parts;
    result.report.parts.kept = surface.report.kept_parts;
    made->label = surface.report;
    *out = made.release();
  });
}

obc_status obc_repair_get_label_report(const obc_repair* repaired, obc_repair_label_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(repaired != nullptr, "repaired is NULL");
    capi::require(report != nullptr, "report is NULL");
    capi::write_versioned(report, label_report_of(repaired->label));
  });
}

const char* obc_repair_action_name(int32_t action) {
  return repair::name_of(static_cast<repair::Action>(action));
}

uint32_t obc_repair_version(void) {
  return base::version_number;
}
