#include "repair/repair.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/names.h"
#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/surface_check.h"
#include "repair/topology/orientation.h"

namespace orbicube::repair {
namespace {

// Fractions of the diagonal of the bounding box.
constexpr double weld_fraction = 1e-6;  // larger: seams with larger gaps are closed; smaller: fewer details can merge
constexpr double sliver_fraction = 1e-5;
constexpr double t_junction_fraction = 1e-6;
// Splits of T-junctions may bring about others, at the vertices that they weld.
constexpr int max_t_junction_passes = 3;
// Of splitting contacts and filling holes; the last one only splits.
constexpr int max_closing_passes = 6;

void require_options(const Options& o) {
  const auto require = [](bool fine, const char* message) { base::require(fine, message); };
  const auto length = [](double x) { return std::isfinite(x) && x >= 0; };
  require(length(o.weld_distance), "the weld distance must be finite and not negative");
  require(length(o.sliver_ratio) && o.sliver_ratio < 0.5, "the ratio of near-degenerate triangles must be 0 to 0.5");
  require(length(o.sliver_move), "the bound of movement must be finite and not negative");
  require(length(o.t_junction_distance), "the distance of T-junctions must be finite and not negative");
  require(length(o.contact_gap), "the gap at contacts must be finite and not negative");
  require(length(o.wrap_offset), "the offset of the wrap must be finite and not negative");
  require(length(o.handles.max_length), "the maximum length of handles must be finite and not negative");
  require(length(o.parts.min_area_percent) && o.parts.min_area_percent <= 100,
          "the minimum area of parts must be 0 to 100 percent");
}

double diagonal_of(const Soup& soup, const base::Host& host) {
  const mesh::Measures m = mesh::measures(soup.positions, soup.triangles, host);
  return (m.high - m.low).norm();
}

// All lengths times a power of two.
Options scaled(Options o, int exponent) {
  for (double* length : {&o.weld_distance, &o.sliver_move, &o.t_junction_distance, &o.contact_gap,
                         &o.handles.max_length, &o.wrap_offset})
    *length = std::scalbn(*length, exponent);
  return o;
}

class Pipeline {
 public:
  Pipeline(Soup& soup, const Options& options, Report& report, const Context& context)
      : soup_(soup),
        options_(options),
        report_(report),
        context_(context),
        diagonal_(diagonal_of(soup, context.host)) {}

  void run() {
    weld();
    if (options_.clean) report_.clean = drop_degenerate_and_duplicate(soup_, context_);
    if (options_.slivers && options_.clean) remove_near_degenerate();
    if (options_.t_junctions) split_junctions();
    if (options_.orient) report_.orientable = orient_patches(soup_, context_.host);
    close();
    const bool wrapped = options_.wrap_offset > 0;
    if (options_.orient && report_.orientable) {
      turn_parts_outward(soup_, context_.host);
      if (options_.drop_parts && !wrapped && report_.parts.kept > 1)
        settle_nested_parts(soup_, options_.parts.cavities, report_.parts, context_);
    }
    if (wrapped) {
      report_.wrap = wrap(soup_, options_.wrap_offset, context_);
      if (options_.drop_parts) add_parts();
    }
    cut();
    if (options_.clean) report_.unused_vertices = drop_unused_vertices(soup_);
  }

 private:
  double or_fraction(double length, double fraction) const { return length > 0 ? length : fraction * diagonal_; }

  void cut() {
    if (options_.handles.max_genus < 0 && !(options_.handles.max_length > 0)) return;
    report_.handles_searched = certify(soup_.positions, soup_.triangles, false, context_.host).is_solid();
    if (report_.handles_searched) report_.handles = cut_handles(soup_, options_.handles, context_);
  }

  void weld() {
    if (!options_.weld || !has_open_edges(soup_, context_.host)) return;
    add_weld(0);
    if (options_.weld_distance > 0 || has_open_edges(soup_, context_.host))
      add_weld(or_fraction(options_.weld_distance, weld_fraction));
  }
  void add_weld(double distance) {
    const WeldFigures f = weld_open_edges(soup_, distance, context_);
    report_.weld.vertices += f.vertices;
    report_.weld.triangles += f.triangles;
    report_.weld.largest_move = std::max(report_.weld.largest_move, f.largest_move);
  }

  void remove_near_degenerate() {
    const double bound = or_fraction(options_.sliver_move, sliver_fraction);
    report_.slivers = remove_slivers(soup_, options_.sliver_ratio, bound, context_);
  }

  void split_junctions() {
    for (int pass = 0; pass < max_t_junction_passes; ++pass) {
      if (!has_open_edges(soup_, context_.host)) return;
      const double distance = or_fraction(options_.t_junction_distance, t_junction_fraction);
      const TJunctionFigures f = split_t_junctions(soup_, distance, context_);
      report_.t_junctions.splits += f.splits;
      report_.t_junctions.largest_move = std::max(report_.t_junctions.largest_move, f.largest_move);
      if (f.splits == 0) return;
      if (options_.slivers && options_.clean) {
        const SliverFigures s =
            remove_slivers(soup_, options_.sliver_ratio, or_fraction(options_.sliver_move, sliver_fraction), context_);
        report_.slivers.collapsed += s.collapsed;
        report_.slivers.flipped += s.flipped;
      }
    }
  }

  void add_contacts(bool join_open_fans) {
    const ContactFigures f = split_contacts(soup_, options_.contact_gap, join_open_fans, context_);
    report_.contacts.edges += f.edges;
    report_.contacts.vertices += f.vertices;
    report_.contacts.added_vertices += f.added_vertices;
    report_.contacts.largest_move = std::max(report_.contacts.largest_move, f.largest_move);
  }

  void add_parts() {
    const PartFigures f = keep_parts(soup_, options_.parts, context_);
    report_.parts.found = std::max(report_.parts.found, f.found);
    report_.parts.kept = f.kept;
    report_.parts.dropped_triangles += f.dropped_triangles;
    report_.parts.dropped_area_percent += f.dropped_area_percent;
  }

  void add_holes() {
    const HoleFigures f = fill_holes(soup_, options_.holes, context_);
    report_.holes.found = report_.holes.filled + f.found;  // those that stayed open are found again
    report_.holes.filled += f.filled;
    report_.holes.triangles += f.triangles;
    report_.holes.vertices += f.vertices;
  }

  // Patches can touch each other where holes do, and sheets can be connected there in more than one way: what is not
  // manifold then is split, and what that opened is filled.
  void close() {
    const bool splits = options_.contacts && report_.orientable;
    for (int pass = 0; pass < max_closing_passes; ++pass) {
      if (splits) add_contacts(pass == 0 && options_.fill_holes);
      if (options_.drop_parts && !(options_.wrap_offset > 0)) add_parts();
      if (options_.fill_holes && pass + 1 < max_closing_passes) add_holes();
      if (!splits || !options_.fill_holes) return;
      const Certificate c = certify(soup_.positions, soup_.triangles, false, context_.host);
      if (c.manifold && (c.closed || report_.holes.found > report_.holes.filled)) return;
    }
  }

  Soup& soup_;
  const Options& options_;
  Report& report_;
  const Context& context_;
  double diagonal_;
};

// Back to the scale of the input: what did not move has the bits of the input.
void restore_scale(Soup& soup, std::span<const Vector3> input, std::span<const Vector3> scaled_input, int exponent) {
  if (exponent == 0) return;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    const Index source = soup.vertex_source[v];
    if (source != no_index && soup.positions[v] == scaled_input[source]) {
      soup.positions[v] = input[source];
    } else {
      mesh::scale_by_power({&soup.positions[v], 1}, -exponent);
    }
  }
}

void scale_figures(Repaired& result, int exponent) {
  if (exponent == 0) return;
  const auto back = [&](double& x, int dimension) { x = std::scalbn(x, -exponent * dimension); };
  Report& r = result.report;
  for (double* x : {&r.weld.largest_move, &r.slivers.largest_move, &r.t_junctions.largest_move,
                    &r.contacts.largest_move, &r.handles.largest_move, &r.handles.longest, &r.wrap.cell,
                    &r.move.from_input, &r.move.from_result, &r.move.patches})
    back(*x, 1);
  back(r.certificate.area, 2);
  back(r.certificate.volume, 3);
  for (Event& e : result.events) {
    back(e.size, e.action == Action::dropped_part ? 2 : 1);
    mesh::scale_by_power({&e.place, 1}, -exponent);
  }
}

}  // namespace

const char* name_of(Action action) {
  static constexpr const char* names[] = {
      "welded-vertex",        "removed-degenerate", "removed-duplicate",  "collapsed-edge",       "flipped-edge",
      "left-near-degenerate", "split-edge",         "split-contact-edge", "split-contact-vertex", "dropped-part",
      "filled-hole",          "left-hole",          "cut-handle"};
  return base::name_of(action, names);
}

Repaired repair(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
                const base::Host& host) {
  require_options(options);
  mesh::require_valid_surface(positions, triangles, host);
  if (triangles.empty()) throw base::Error("empty-mesh", "there are no triangles");
  Repaired result(host.memory);
  result.surface = soup_of(positions, triangles, host);
  constexpr int ordinary = 40;  // exponents of scales at which squares and cubes keep their digits
  int exponent = mesh::unit_scale_exponent(positions, triangles);
  if (std::abs(exponent) <= ordinary) exponent = 0;
  if (exponent != 0) mesh::scale_by_power(result.surface.positions, exponent);
  Array<Vector3> scaled_input(result.surface.positions, host.memory);
  Array<std::uint8_t> counted(triangles.size(), 1, host.memory);
  const Context context{host, result.events, counted};
  const Options lengths = scaled(options, exponent);
  {
    const base::Stage stage(host, 0.6);
    Pipeline(result.surface, lengths, result.report, context).run();
  }
  Soup& surface = result.surface;
  Report& report = result.report;
  if (surface.triangles.empty()) {
    throw base::Error("degenerate-geometry", "no triangle is left: each of the " + std::to_string(triangles.size()) +
                                                 " is degenerate or a copy of another");
  }
  report.input_vertices = positions.size();
  report.input_triangles = triangles.size();
  report.reversed_triangles = count_turned(surface, triangles);
  report.changed = surface.positions != scaled_input ||
                   !std::equal(triangles.begin(), triangles.end(), surface.triangles.begin(), surface.triangles.end());
  const base::Stage stage(host, 1);
  if (report.changed) report.move = measure_move(scaled_input, triangles, counted, surface, host);
  report.certificate = certify(surface.positions, surface.triangles, options.find_intersections, host);
  if (!(report.certificate.area > 0))
    throw base::Error("degenerate-geometry", "the surface has no area: all of it lies on one line or point");
  restore_scale(surface, positions, scaled_input, exponent);
  scale_figures(result, exponent);
  return result;
}

std::string shortcomings(const Certificate& c) {
  std::string text;
  const auto add = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + (n == 1 ? one : many);
  };
  add(c.boundary_loops, "boundary loop", "boundary loops");
  add(c.non_manifold_edges, "edge of more than two faces", "edges of more than two faces");
  add(c.non_manifold_vertices, "vertex that joins parts", "vertices that join parts");
  add(c.inconsistent_edges, "edge between faces of opposite orientations",
      "edges between faces of opposite orientations");
  add(c.self_intersections, "pair of triangles that intersect", "pairs of triangles that intersect");
  return text;
}

}  // namespace orbicube::repair
