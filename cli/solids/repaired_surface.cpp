#include "solids/repaired_surface.h"

#include <utility>

#include "mesh/regions/nearest_regions.h"
#include "report/text.h"

namespace orbicube::cli {
namespace {

constexpr std::size_t max_events_in_report = 1000;

std::string count(std::size_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

Json steps_json(const repair::Report& r) {
  return {{"weld",
           {{"vertices", r.weld.vertices}, {"lost_triangles", r.weld.triangles}, {"max_move", r.weld.largest_move}}},
          {"clean",
           {{"degenerate_faces", r.clean.degenerate},
            {"duplicate_faces", r.clean.duplicate},
            {"unused_vertices", r.unused_vertices}}},
          {"slivers",
           {{"found", r.slivers.found},
            {"collapsed_edges", r.slivers.collapsed},
            {"flipped_edges", r.slivers.flipped},
            {"left", r.slivers.left},
            {"max_move", r.slivers.largest_move}}},
          {"t_junctions", {{"splits", r.t_junctions.splits}, {"max_move", r.t_junctions.largest_move}}},
          {"orient", {{"orientable", r.orientable}, {"reversed_triangles", r.reversed_triangles}}},
          {"contacts",
           {{"edges", r.contacts.edges},
            {"vertices", r.contacts.vertices},
            {"added_vertices", r.contacts.added_vertices},
            {"max_move", r.contacts.largest_move}}},
          {"parts",
           {{"found", r.parts.found},
            {"kept", r.parts.kept},
            {"cavities", r.parts.cavities},
            {"dropped_triangles", r.parts.dropped_triangles},
            {"dropped_area_percent", r.parts.dropped_area_percent}}},
          {"holes",
           {{"found", r.holes.found},
            {"filled", r.holes.filled},
            {"triangles", r.holes.triangles},
            {"vertices", r.holes.vertices}}},
          {"wrap", {{"triangles", r.wrap.triangles}, {"cell", r.wrap.cell}}},
          {"handles",
           {{"cut", r.handles.cut},
            {"triangles", r.handles.triangles},
            {"longest", r.handles.longest},
            {"max_move", r.handles.largest_move}}}};
}

}  // namespace

void add_mending_options(CLI::App& verb, Mending& mending) {
  add_weld_option(verb, mending.weld);
  verb.add_flag("--repair", mending.repair,
                "repair the surface first, as orbicube repair does: welds, contacts, largest part, holes");
}

InputMesh read_mended(const std::filesystem::path& path, const Mending& mending, Session& session, Keep keep,
                      bool tags) {
  InputMesh input = read_input(path, mending.weld, session, keep, tags);
  if (!mending.repair || !input.mesh.tetrahedra.empty() || !input.mesh.hexahedra.empty()) return input;
  about(path, Role::input, [&] {
    repair::Repaired repaired = repair::repair(input.mesh.positions, input.mesh.triangles, {}, session.host());
    if (!repaired.report.changed) return;
    session.figures()["repair"] = figures_of_repair(repaired);
    for (const std::string& line : lines_of(repaired.report))
      session.note(line);
    if (!repaired.report.certificate.is_solid()) {
      throw base::Error("no-valid-result", "the repair reached no closed, oriented manifold: " +
                                               repair::shortcomings(repaired.report.certificate));
    }
    input.mesh.regions.triangles = repaired_regions(input.mesh, repaired.surface, session.host());
    input.mesh.positions = std::move(repaired.surface.positions);
    input.mesh.triangles = std::move(repaired.surface.triangles);
    if (input.report.tags && !input.report.tags->empty()) {
      input.report.tags.reset();
      session.note("edges and vertices that the file marks were left out, since the surface was repaired");
    }
    if (input.kept) {
      input.kept.reset();
      session.note("only the surface of the file was kept, since it was repaired");
    }
  });
  return input;
}

base::Array<std::int32_t> repaired_regions(const mesh::Mesh& input, const repair::Soup& surface,
                                           const base::Host& host) {
  base::Array<std::int32_t> result(host.memory);
  if (input.regions.triangles.empty()) return result;
  base::Array<mesh::FacePlace> made(host.memory);
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const mesh::Index source = surface.triangle_source[i];
    result.push_back(source == mesh::no_index ? 0 : input.regions.triangles[source]);
    if (source == mesh::no_index) made.push_back(mesh::face_place(surface.positions, surface.triangles[i]));
  }
  const auto of_made = mesh::nearest_face_regions(input, made, host);
  std::size_t next = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (surface.triangle_source[i] == mesh::no_index && !of_made.empty()) result[i] = of_made[next++];
  return result;
}

std::vector<std::string> lines_of(const repair::Report& r) {
  std::vector<std::string> lines;
  const auto add = [&](bool done, const std::string& line) {
    if (done) lines.push_back(line);
  };
  add(r.weld.vertices > 0, count(r.weld.vertices, "vertex was welded", "vertices were welded") + " to others at most " +
                               number(r.weld.largest_move) + " away");
  add(r.clean.degenerate > 0, count(r.clean.degenerate, "face with a repeated corner was removed",
                                    "faces with a repeated corner were removed"));
  add(r.clean.duplicate > 0, count(r.clean.duplicate, "copy of a face was removed", "copies of faces were removed"));
  add(r.slivers.collapsed + r.slivers.flipped + r.slivers.removed > 0,
      "of " + count(r.slivers.found, "near-degenerate triangle", "near-degenerate triangles") + ", " +
          count(r.slivers.collapsed, "edge was collapsed and ", "edges were collapsed and ") +
          std::to_string(r.slivers.flipped + r.slivers.removed) + " flipped, which moved the surface by at most " +
          number(r.slivers.largest_move));
  add(r.slivers.left > 0, count(r.slivers.left, "near-degenerate triangle stays", "near-degenerate triangles stay"));
  add(r.t_junctions.splits > 0,
      count(r.t_junctions.splits, "open edge was split at a vertex", "open edges were split at vertices") +
          " at most " + number(r.t_junctions.largest_move) + " away from it");
  add(!r.orientable, "the surface has one side only: it cannot be oriented");
  add(r.reversed_triangles > 0, count(r.reversed_triangles, "triangle was reversed", "triangles were reversed"));
  add(r.contacts.added_vertices > 0, count(r.contacts.edges, "edge", "edges") + " of more than two faces and " +
                                         count(r.contacts.vertices, "vertex", "vertices") +
                                         " where sheets touch were split");
  add(r.parts.dropped_triangles > 0,
      "kept " + std::to_string(r.parts.kept) + " of " + count(r.parts.found, "part", "parts") + "; " +
          count(r.parts.dropped_triangles, "triangle was dropped, ", "triangles were dropped, ") +
          number(r.parts.dropped_area_percent) + " % of the area");
  add(r.parts.cavities > 0, count(r.parts.cavities, "part bounds a cavity", "parts bound cavities"));
  add(r.holes.filled > 0, count(r.holes.filled, "hole was filled", "holes were filled") + " with " +
                              count(r.holes.triangles, "triangle", "triangles"));
  add(r.holes.found > r.holes.filled, count(r.holes.found - r.holes.filled, "hole stays open", "holes stay open"));
  add(r.wrap.triangles > 0,
      "all was replaced by a surface around it of " + std::to_string(r.wrap.triangles) + " triangles");
  add(r.handles.cut > 0, count(r.handles.cut, "handle or tunnel was cut", "handles and tunnels were cut") +
                             ", the longest loop of length " + number(r.handles.longest));
  add(!r.handles_searched, "no handle was cut, since the surface is not closed, oriented and manifold");
  add(r.unused_vertices > 0, count(r.unused_vertices, "unused vertex was removed", "unused vertices were removed"));
  add(r.changed && r.certificate.self_intersections > 0,
      count(r.certificate.self_intersections, "pair of triangles intersects", "pairs of triangles intersect"));
  return lines;
}

Json certificate_json(const repair::Certificate& c) {
  return {{"closed", c.closed},
          {"manifold", c.manifold},
          {"oriented", c.oriented},
          {"parts", c.parts},
          {"genus", c.is_solid() ? Json(c.genus) : Json()},
          {"boundary_loops", c.boundary_loops},
          {"self_intersections", c.self_intersections},
          {"area", c.area},
          {"volume", c.is_solid() ? Json(c.volume) : Json()}};
}

Json figures_of_repair(const repair::Repaired& repaired) {
  const repair::Report& r = repaired.report;
  Json events = Json::array();
  for (std::size_t i = 0; i < std::min(repaired.events.size(), max_events_in_report); ++i) {
    const repair::Event& e = repaired.events[i];
    events.push_back({{"action", repair::name_of(e.action)},
                      {"place", {e.place[0], e.place[1], e.place[2]}},
                      {"count", e.count},
                      {"size", e.size}});
  }
  return {{"changed", r.changed},
          {"steps", steps_json(r)},
          {"distance",
           {{"from_input", r.move.from_input}, {"from_result", r.move.from_result}, {"of_patches", r.move.patches}}},
          {"certificate", certificate_json(r.certificate)},
          {"event_count", repaired.events.size()},
          {"events", events}};
}

}  // namespace orbicube::cli
