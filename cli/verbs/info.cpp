// orbicube info: what is in a mesh file, and what it can be used for.
#include <cstdio>
#include <memory>
#include <string>

#include "base/counted.h"
#include "files/surface_file.h"
#include "mesh/regions/region_numbers.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/topology.h"
#include "report/cell_figures.h"
#include "report/repair_outlook.h"
#include "verbs/verbs.h"
#ifdef ORBICUBE_WITH_TETRAHEDRA
#include "tetrahedra/input_check.h"
#endif

namespace orbicube::cli {
namespace {

struct InfoOptions {
  std::string input;
  bool weld = false;
};

std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string point(const mesh::Vector3& p) {
  return "(" + digits(p[0]) + ", " + digits(p[1]) + ", " + digits(p[2]) + ")";
}

Json json_point(const mesh::Vector3& p) {
  return {p[0], p[1], p[2]};
}

// Whether something can be done with the mesh, or the refusal that it would meet.
struct Use {
  bool possible = true;
  std::string kind;
  std::string reason;
};

template <class Requirement>
Use use_of(const Requirement& require) {
  try {
    require();
  } catch (const base::Error& refusal) {
    if (refusal.status() == base::Status::cancelled) throw;
    return {false, refusal.kind(), refusal.what()};
  }
  return {};
}

Json json_of(const Use& use) {
  if (use.possible) return {{"usable", true}};
  return {{"usable", false}, {"kind", use.kind}, {"reason", use.reason}};
}

std::string text_of(const Use& use) {
  return use.possible ? "yes" : "no, " + use.kind + ": " + use.reason;
}

// Lines of a name and what there is to say about it.
class Table {
 public:
  explicit Table(Session& session) : session_(session) {}
  void row(const std::string& name, const std::string& value) const {
    constexpr std::size_t width = 16;
    session_.say("  " + name + std::string(name.size() < width ? width - name.size() : 1, ' ') + value);
  }

 private:
  Session& session_;
};

// The map turns faces round itself where that is all that is missing.
Use sphere_use(const mesh::Topology& facts) {
  mesh::Topology turned = facts;
  if (facts.orientable) turned.inconsistent_edges = 0;
  return use_of([&] { mesh::require_closed_genus_zero(turned); });
}

// Whether TetGen would be given it; the exact search for places where it meets itself is part of the result.
Use tetrahedralize_use(const mesh::Mesh& mesh, const Session& session) {
#ifdef ORBICUBE_WITH_TETRAHEDRA
  return use_of([&] { tetrahedra::require_fillable(mesh.positions, mesh.triangles, session.host()); });
#else
  static_cast<void>(mesh), static_cast<void>(session);
  return {false, "unsupported", "a build without TetGen"};
#endif
}

void tell_surface(const mesh::Topology& t, const Use& sphere, const Use& filling, Session& session) {
  const bool oriented = t.inconsistent_edges == 0;
  const bool solid = t.closed() && t.manifold() && oriented;
  session.figures().update({{"edges", t.edges},
                            {"components", t.components},
                            {"closed", t.closed()},
                            {"manifold", t.manifold()},
                            {"boundary_edges", t.boundary_edges},
                            {"boundary_loops", t.boundary_loops},
                            {"longest_boundary_loop", t.longest_boundary_loop},
                            {"non_manifold_edges", t.non_manifold_edges},
                            {"non_manifold_vertices", t.non_manifold_vertices},
                            {"orientable", t.orientable},
                            {"consistently_oriented", oriented},
                            {"outward", solid ? Json(t.volume > 0) : Json()},
                            {"euler_characteristic", t.euler_characteristic},
                            {"genus", t.genus ? Json(*t.genus) : Json()},
                            {"degenerate_faces", t.degenerate_faces},
                            {"duplicate_faces", t.duplicate_faces},
                            {"zero_area_faces", t.zero_area_faces},
                            {"coincident_vertices", t.coincident_vertices},
                            {"unreferenced_vertices", t.unreferenced_vertices},
                            {"area", t.area},
                            {"volume", solid ? Json(t.volume) : Json()},
                            {"bounding_box", {{"low", json_point(t.low)}, {"high", json_point(t.high)}}},
                            {"usable_for", {{"sphere", json_of(sphere)}, {"tetrahedralize", json_of(filling)}}}});
  const Table table(session);
  table.row("edges", std::to_string(t.edges));
  table.row("components", std::to_string(t.components));
  table.row("boundary", t.closed() ? "none, closed"
                                   : base::counted(t.boundary_loops, "loop") + " of " +
                                         base::counted(t.boundary_edges, "edge") + ", the longest " +
                                         std::to_string(t.longest_boundary_loop));
  std::string flaws;
  const auto flaw = [&](std::size_t n, const char* one, const char* many) {
    if (n > 0) flaws += (flaws.empty() ? "" : ", ") + base::counted(n, one, many);
  };
  flaw(t.non_manifold_edges, "edge with more than two faces", "edges with more than two faces");
  flaw(t.non_manifold_vertices, "vertex joining parts", "vertices joining parts");
  flaw(t.degenerate_faces, "face with a repeated vertex", "faces with a repeated vertex");
  flaw(t.duplicate_faces, "repeated face", "repeated faces");
  table.row("manifold", flaws.empty() ? "yes" : "no: " + flaws);
  table.row("orientation", !t.orientable  ? "none, one-sided"
                           : !oriented    ? base::counted(t.inconsistent_edges, "edge") + " between faces turned apart"
                           : !solid       ? "consistent"
                           : t.volume > 0 ? "consistent, outward"
                           : t.volume < 0 ? "consistent, inward"
                                          : "consistent, no volume");
  table.row("genus", t.genus ? std::to_string(*t.genus) : "-");
  table.row("area", digits(t.area));
  if (solid) table.row("volume", digits(t.volume));
  table.row("bounding box", point(t.low) + " to " + point(t.high));
  if (t.zero_area_faces > 0) table.row("no area", base::counted(t.zero_area_faces, "face"));
  if (t.coincident_vertices > 0)
    table.row("coincident", base::counted(t.coincident_vertices, "vertex", "vertices") + " at the place of another");
  if (t.unreferenced_vertices > 0) table.row("unused", base::counted(t.unreferenced_vertices, "vertex", "vertices"));
  table.row("sphere map", text_of(sphere));
  table.row("tetrahedra", text_of(filling));
}

// The surface of the solid that the cells fill.
void tell_boundary(const mesh::Mesh& mesh, Session& session) {
  const auto boundary = mesh::boundary_triangles(mesh, session.host());
  const mesh::Topology t = mesh::topology(mesh.positions, boundary, session.host());
  session.figures()["boundary"] = {{"triangles", t.triangles},
                                   {"vertices", t.vertices - t.unreferenced_vertices},
                                   {"components", t.components},
                                   {"manifold", t.manifold()},
                                   {"euler_characteristic", t.euler_characteristic},
                                   {"genus", t.genus ? Json(*t.genus) : Json()},
                                   {"area", t.area},
                                   {"volume", t.volume},
                                   {"bounding_box", {{"low", json_point(t.low)}, {"high", json_point(t.high)}}}};
  const Table table(session);
  table.row("boundary", base::counted(t.triangles, "triangle") + ", " + base::counted(t.components, "component") +
                            (t.genus ? ", genus " + std::to_string(*t.genus) : ""));
  table.row("area", digits(t.area));
  table.row("volume", digits(t.volume));
  table.row("bounding box", point(t.low) + " to " + point(t.high));
}

// As the verb frames refuses solids.
Use frames_use(const mesh::Mesh& mesh, const Use& cells) {
  if (mesh.tetrahedra.empty()) return {false, "no-cells", "no tetrahedra; frames live on a mesh of them"};
  if (!cells.possible) return cells;
  if (!mesh.hexahedra.empty()) return {false, "unsupported", "hexahedra beside the tetrahedra"};
  return {};
}

void tell_cells(const mesh::Mesh& mesh, Session& session) {
  const Table table(session);
  table.row("tetrahedra", std::to_string(mesh.tetrahedra.size()));
  table.row("hexahedra", std::to_string(mesh.hexahedra.size()));
  const Use cells = use_of([&] { mesh::require_valid_cells(mesh, session.host()); });
  const Use sphere = {false, "unsupported", "a solid of cells; the sphere map takes surfaces"};
  const Use filling = {false, "unsupported", "a solid of cells already; tetrahedralize takes surfaces"};
  const Use field = frames_use(mesh, cells);
  session.figures().update(
      {{"valid_cells", json_of(cells)},
       {"usable_for",
        {{"sphere", json_of(sphere)}, {"tetrahedralize", json_of(filling)}, {"frames", json_of(field)}}}});
  table.row("valid cells", text_of(cells));
  if (cells.possible) tell_boundary(mesh, session);
  if (!mesh.tetrahedra.empty()) {
    const auto quality = mesh::tetrahedron_quality(mesh.positions, mesh.tetrahedra, session.host());
    session.figures()["cells"] = quality_json(quality);
    table.row("dihedral angles", angles_text(quality));
    table.row("radius ratio", radii_text(quality));
  }
  table.row("sphere map", text_of(sphere));
  table.row("frame field", text_of(field));
}

void tell_regions(const mesh::Mesh& mesh, Session& session) {
  const auto tell = [&](const char* name, std::span<const std::int32_t> regions) {
    const auto numbers = mesh::distinct_regions(regions, session.host().memory);
    session.figures()["regions"][name] = numbers.size();
    if (numbers.empty()) return std::string();
    const std::string range = numbers.size() == 1
                                  ? "number " + std::to_string(numbers.front())
                                  : std::to_string(numbers.front()) + " to " + std::to_string(numbers.back());
    return base::counted(numbers.size(), "region") + " of " + name + " (" + range + ")";
  };
  const Table table(session);
  for (const std::string& text :
       {tell("triangles", mesh.regions.triangles), tell("tetrahedra", mesh.regions.tetrahedra),
        tell("hexahedra", mesh.regions.hexahedra)})
    if (!text.empty()) table.row("regions", text);
}

void info(const InfoOptions& options, Session& session) {
  session.options() = {{"weld", options.weld}};
  const InputMesh input = read_input(options.input, options.weld, session);
  const mesh::Mesh& mesh = input.mesh;
  const Table table(session);
  session.say(options.input + ": " + input.report.format);
  session.figures() = {{"format", input.report.format},
                       {"vertices", mesh.positions.size()},
                       {"triangles", mesh.triangles.size()},
                       {"tetrahedra", mesh.tetrahedra.size()},
                       {"hexahedra", mesh.hexahedra.size()},
                       {"polygons", input.report.polygons},
                       {"welded_vertices", input.report.welded_vertices}};
  table.row("vertices", std::to_string(mesh.positions.size()));
  table.row("triangles", std::to_string(mesh.triangles.size()));
  tell_regions(mesh, session);
  about(options.input, Role::input, [&] {
    if (mesh.tetrahedra.empty() && mesh.hexahedra.empty()) {
      const mesh::Topology facts = mesh::topology(mesh.positions, mesh.triangles, session.host());
      tell_surface(facts, sphere_use(facts), tetrahedralize_use(mesh, session), session);
      const RepairOutlook outlook = repair_outlook(mesh, session);
      session.figures()["repair"] = outlook.figures;
      for (const std::string& line : outlook.lines)
        table.row("repair", line);
      return;
    }
    tell_cells(mesh, session);
  });
  session.figures()["seconds_read"] = input.seconds;
  for (const std::string& note : session.notes())
    table.row("note", note);
}

}  // namespace

void add_info(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("info", "report the contents and the defects of a mesh file");
  const auto options = std::make_shared<InfoOptions>();
  verb->add_option("IN", options->input, std::string("mesh to read: ") + surface_endings)->required()->type_name("");
  add_weld_option(*verb, options->weld);
  add_common_options(*verb, common);
  verb->footer(
      "Defects of the shape are facts in the report, not errors: the exit code is 2 only for a file that cannot be "
      "read.");
  verb->callback([options, &common] {
    Session session(common, "info", options->input);
    session.run([&] { info(*options, session); });
  });
}

}  // namespace orbicube::cli
