// orbicube volume: a one-to-one map of a solid to a polycube.
#include <memory>
#include <string>
#include <vector>

#include "files/surface_file.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/cells.h"
#include "report/embedding.h"
#include "report/solver_choice.h"
#include "solids/polycube_solid.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct VolumeVerb {
  PolycubeSolidOptions solid;
  std::string output;
  std::string source;
  std::string solver = "own";
  bool text = false;
};

void run_volume(const VolumeVerb& verb, Session& session) {
  const std::unique_ptr<volume_map::BlockEngine> engine = start_solver(verb.solver);
  require_cells_writable(verb.output);
  if (!verb.source.empty()) require_cells_writable(verb.source);
  session.options() = {{"output", verb.output}, {"source", verb.source}, {"solver", verb.solver}, {"text", verb.text}};
  session.options().update(json_of(verb.solid));
  const std::vector<PolycubeSolidInput> pieces = session.portion(
      0.4, [&] { return read_polycube_solid(verb.solid, Inside::tetrahedra, Polycubes::needed, session); });
  const double start = session.seconds();
  std::size_t corners = 0;
  std::vector<volume_map::PolycubeSolid> solids;
  for (const PolycubeSolidInput& piece : pieces) {
    corners += piece.made.certificate.corners;
    solids.push_back(piece.solid());
  }
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
  const int exponent = pieces.empty() ? 0 : pieces.front().exponent;
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
  session.say("wrote " + verb.output + ": " + std::to_string(cells.tetrahedra.size()) +
              " tetrahedra on a polycube with " + std::to_string(corners) + " corners, one to one; " +
              std::to_string(map.inverted_at_start) + " were inverted at the start");
  if (!verb.source.empty()) session.say("wrote " + verb.source);
}

}  // namespace

void add_volume(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("volume", "map a solid to a polycube bijectively");
  const auto options = std::make_shared<VolumeVerb>();
  add_polycube_solid_options(*verb, options->solid);
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
