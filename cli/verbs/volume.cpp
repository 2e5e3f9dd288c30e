// orbicube volume: a one-to-one map of a solid to a polycube.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/cells.h"
#include "report/embedding.h"
#include "report/solver_choice.h"
#include "solids/solid_input.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct VolumeVerb {
  SolidOptions solid;
  std::string output;
  std::string source;
  std::string solver = "own";
  bool text = false;
};

// The pieces of the input, times 2^exponent.
std::vector<volume_map::PolycubePiece> read_pieces(const SolidOptions& options, volume_map::InputFindings& findings,
                                                   int& exponent, Session& session) {
  InputMesh input = session.portion(0.03, [&] { return read_mended(options.input, options.mending, session); });
  exponent = mesh::bring_to_unit_size(input.mesh);
  std::optional<SolidPolycube> given = read_solid_polycube(options, session);
  if (given) mesh::scale_by_power(given->file.pose, exponent);
  const volume_map::PieceOptions of_pieces = {.corners = options.corners,
                                              .triangles = options.triangles,
                                              .seed = session.seed(),
                                              .fill = fill_by_tetgen(),
                                              .given = given ? given->view() : volume_map::GivenPolycube{}};
  return about_solid(options.input, options.input, input.report.format, findings, session, [&] {
    return volume_map::polycube_pieces(std::move(input.mesh), of_pieces, findings, session.host());
  });
}

void run_volume(const VolumeVerb& verb, Session& session) {
  const std::unique_ptr<untangle::BlockEngine> engine = start_solver(verb.solver);
  require_cells_writable(verb.output);
  if (!verb.source.empty()) require_cells_writable(verb.source);
  session.options() = {{"output", verb.output}, {"source", verb.source}, {"solver", verb.solver}, {"text", verb.text}};
  session.options().update(json_of(verb.solid));
  int exponent = 0;
  volume_map::InputFindings findings = findings_of(session);
  const std::vector<volume_map::PolycubePiece> pieces =
      session.portion(0.4, [&] { return read_pieces(verb.solid, findings, exponent, session); });
  const double start = session.seconds();
  std::vector<volume_map::PolycubeSolid> solids;
  for (const volume_map::PolycubePiece& piece : pieces)
    solids.push_back(piece.solid());
  volume_map::VolumeMap map = about(verb.output, Role::output, [&] {
    const base::Stage stage(session.host(), 0.95);
    return volume_map::map_pieces_to_polycubes(solids, session.host(), engine.get());
  });
  session.figures().update(Json{{"output", verb.output},
                                {"source", verb.source},
                                {"vertices", map.source.size()},
                                {"tetrahedra", map.tetrahedra.size()},
                                {"inverted_at_start", map.inverted_at_start},
                                {"steps", map.steps},
                                {"seconds_compute", session.seconds() - start}});
  mesh::Mesh cells(session.host().memory);
  cells.tetrahedra = std::move(map.tetrahedra);
  cells.positions = std::move(map.source);
  mesh::scale_by_power(cells.positions, -exponent);
  about(verb.solid.input, Role::input, [&] {
    report_intersections(verb.source.empty() ? verb.solid.input : verb.source, cells.positions,
                         mesh::boundary_triangles(cells, session.host()),
                         "the map is one to one between the tetrahedra, but the solid lies over itself there",
                         session.figures(), session);
  });
  if (!verb.source.empty()) write_cells_exactly(verb.source, cells, verb.text, session);
  cells.positions = std::move(map.image);
  mesh::scale_by_power(cells.positions, -exponent);
  write_cells_exactly(verb.output, cells, verb.text, session);
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + verb.output + ": " + base::counted(cells.tetrahedra.size(), "tetrahedron", "tetrahedra") +
              " on a polycube with " + base::counted(findings.polycube->corners, "corner") + ", one to one; " +
              std::to_string(map.inverted_at_start) + " were inverted at the start");
  if (!verb.source.empty()) session.say("wrote " + verb.source);
}

}  // namespace

void add_volume(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("volume", "map a solid to a polycube bijectively");
  const auto options = std::make_shared<VolumeVerb>();
  add_solid_options(*verb, options->solid);
  verb->add_option("-o,--output", options->output, "the tetrahedra of the solid on the polycube: " + cell_endings)
      ->required()
      ->type_name("OUT");
  verb->add_option("--source", options->source, "the same tetrahedra in space")->type_name("OUT2");
  add_solver_option(*verb, options->solver);
  verb->add_flag("--text", options->text, "write text in place of binary VTK");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "volume", options->solid.input);
    session.run([&] { run_volume(*options, session); });
  });
}

}  // namespace orbicube::cli
