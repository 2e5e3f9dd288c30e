// orbicube volume: a one-to-one map of a solid to a polycube.
#include <algorithm>
#include <memory>
#include <string>

#include "base/error.h"
#include "polycube/certificate.h"
#include "polycube_solid.h"
#include "solver_choice.h"
#include "surface_file.h"
#include "verbs.h"
#include "volume_map/untangle.h"

namespace orbicube::cli {
namespace {

struct VolumeVerb {
  PolycubeSolidOptions solid;
  std::string output;
  std::string source;
  std::string solver = "own";
  bool text = false;
};

// A further piece, beside those that are there: its polycube is moved along x, and certified again.
void add(volume_map::VolumeMap& map, volume_map::VolumeMap&& piece, const polycube::SurfaceMap& surface,
         const base::Host& host) {
  if (map.source.empty()) {
    map = std::move(piece);
    return;
  }
  constexpr double gap = 0.1;
  mesh::Vector3 high = map.image[0], low = piece.image[0];
  double size = 0;
  for (const mesh::Vector3& p : map.image) {
    high = high.cwiseMax(p);
    size = std::max(size, (p - map.image[0]).cwiseAbs().maxCoeff());
  }
  for (const mesh::Vector3& p : piece.image)
    low = low.cwiseMin(p);
  const double shift = high[0] + gap * size - low[0];
  for (mesh::Vector3& p : piece.image)
    p[0] += shift;
  const polycube::Certificate certificate =
      polycube::certify(std::span(piece.image).first(surface.positions.size()), surface.triangles, host);
  if (!certificate.valid() || volume_map::count_inverted(piece.tetrahedra, piece.image, host).count > 0)
    throw base::Error("no-valid-result", "a piece could not be moved beside the others: " + certificate.reason);
  const auto first = static_cast<mesh::Index>(map.source.size());
  map.source.insert(map.source.end(), piece.source.begin(), piece.source.end());
  map.image.insert(map.image.end(), piece.image.begin(), piece.image.end());
  for (mesh::Tetrahedron t : piece.tetrahedra) {
    for (mesh::Index& v : t)
      v += first;
    map.tetrahedra.push_back(t);
  }
  map.inverted_at_start += piece.inverted_at_start;
  map.steps += piece.steps;
}

void run_volume(const VolumeVerb& verb, Session& session) {
  const std::unique_ptr<volume_map::LinearEngine> engine = start_solver(verb.solver);
  require_cells_writable(verb.output);
  if (!verb.source.empty()) require_cells_writable(verb.source);
  session.options() = {{"output", verb.output}, {"source", verb.source}, {"solver", verb.solver}, {"text", verb.text}};
  session.options().update(json_of(verb.solid));
  const std::vector<PolycubeSolidInput> pieces =
      read_polycube_solid(verb.solid, Inside::tetrahedra, Polycubes::needed, session);
  const double start = session.seconds();
  volume_map::VolumeMap map(session.host().memory);
  std::size_t corners = 0;
  for (const PolycubeSolidInput& piece : pieces) {
    corners += piece.made.certificate.corners;
    about(verb.output, Role::output, [&] {
      add(map, volume_map::map_to_polycube(piece.solid(), session.host(), engine.get()), piece.made.map,
          session.host());
    });
  }
  session.figures().update(Json{{"output", verb.output},
                                {"source", verb.source},
                                {"vertices", map.source.size()},
                                {"tetrahedra", map.tetrahedra.size()},
                                {"inverted_at_start", map.inverted_at_start},
                                {"steps", map.steps},
                                {"seconds_compute", session.seconds() - start}});
  mesh::Mesh cells(session.host().memory);
  cells.tetrahedra = std::move(map.tetrahedra);
  cells.positions = std::move(map.image);
  write_cells_exactly(verb.output, cells, verb.text, session.host());
  if (!verb.source.empty()) {
    cells.positions = std::move(map.source);
    write_cells_exactly(verb.source, cells, verb.text, session.host());
  }
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + verb.output + ": " + std::to_string(cells.tetrahedra.size()) +
              " tetrahedra on a polycube with " + std::to_string(corners) + " corners, one to one; " +
              std::to_string(map.inverted_at_start) + " were inverted at the start");
  if (!verb.source.empty()) session.say("wrote " + verb.source);
}

}  // namespace

void add_volume(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("volume", "map a solid to a polycube, one to one");
  const auto options = std::make_shared<VolumeVerb>();
  add_polycube_solid_options(*verb, options->solid);
  verb->add_option("-o,--output", options->output, "the solid's tetrahedra on the polycube: .mesh .vtk")
      ->required()
      ->type_name("OUT");
  verb->add_option("--source", options->source, "the same tetrahedra in space")->type_name("OUT2");
  add_solver_option(*verb, options->solver);
  verb->add_flag("--text", options->text, "text rather than binary VTK");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "volume", options->solid.input);
    session.run([&] { run_volume(*options, session); });
  });
}

}  // namespace orbicube::cli
