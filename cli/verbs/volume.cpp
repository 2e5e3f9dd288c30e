// orbicube volume: a one-to-one map of a solid to a polycube.
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "frame_field/frames_file.h"
#include "mesh/files/write.h"
#include "mesh/regions/nearest_regions.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/place_text.h"
#include "report/embedding.h"
#include "report/solver_choice.h"
#include "solids/solid_input.h"
#include "verbs/verbs.h"
#include "volume_map/frame_map/frame_guided.h"
#include "volume_map/sampling/grid_resampling.h"

namespace orbicube::cli {
namespace {

struct VolumeVerb {
  SolidOptions solid;
  std::string output;
  std::string source;
  std::string solver = "own";
  std::string frames;
  std::string resample;
  std::size_t cells = 10000;
  bool text = false;
};

frame_field::Field read_frames_of(const VolumeVerb& verb, const mesh::Mesh& solid, Session& session) {
  about(verb.solid.input, Role::input, [&] {
    if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra; --frames has a frame for each");
  });
  return about(verb.frames, Role::input,
               [&] { return frame_field::read_frames(verb.frames, solid.tetrahedra.size(), session.host()); });
}

// Hexahedra of a grid on the polycube, taken to the solid.
void write_resampled(const VolumeVerb& verb, const volume_map::VolumeMap& map, int exponent, Session& session) {
  about(verb.resample, Role::output, [&] {
    const volume_map::ResampledGrid grid = mesh::with_places_of_caller(exponent, [&] {
      return volume_map::resample_grid(map.source, map.image, map.tetrahedra, verb.cells, session.host());
    });
    if (grid.hexahedra.empty()) throw base::Error("no-valid-result", "no cell of the grid is inside; request more");
    mesh::Mesh cells(session.host().memory);
    cells.positions = grid.positions;
    cells.hexahedra = grid.hexahedra;
    mesh::scale_by_power(cells.positions, -exponent);
    const std::filesystem::path file = session.stage(verb.resample);
    mesh::write_mesh(file, cells, {.binary = !verb.text}, session.host());
    session.figures()["resampled"] = {{"output", verb.resample},
                                      {"vertices", cells.positions.size()},
                                      {"hexahedra", cells.hexahedra.size()},
                                      {"not_positive", grid.not_positive},
                                      {"min_scaled_jacobian", grid.min_scaled_jacobian},
                                      {"mean_scaled_jacobian", grid.mean_scaled_jacobian}};
    session.say("wrote " + verb.resample + ": " + base::counted(cells.hexahedra.size(), "hexahedron", "hexahedra") +
                ", " + std::to_string(grid.not_positive) + " with a corner that is not positive");
  });
}

base::Array<mesh::Vector3> centers_of(const mesh::Mesh& solid) {
  base::Array<mesh::Vector3> centers(solid.positions.get_allocator());
  for (const mesh::Tetrahedron& t : solid.tetrahedra) {
    const auto& x = solid.positions;
    centers.push_back((x[t[0]] + x[t[1]] + x[t[2]] + x[t[3]]) / 4);
  }
  return centers;
}

// The pieces of the input, times 2^exponent, and a copy of it if its tetrahedra have regions.
std::vector<volume_map::PolycubePiece> read_pieces(const VolumeVerb& verb, volume_map::InputFindings& findings,
                                                   int& exponent, frame_field::Field& frames, mesh::Mesh& with_regions,
                                                   Session& session) {
  const SolidOptions& options = verb.solid;
  InputMesh input = session.portion(0.03, [&] { return read_mended(options.input, options.mending, session); });
  exponent = mesh::bring_to_unit_size(input.mesh);
  if (!input.mesh.regions.tetrahedra.empty()) with_regions = input.mesh;
  if (!verb.frames.empty()) frames = read_frames_of(verb, input.mesh, session);
  std::optional<SolidPolycube> given = read_solid_polycube(options, session);
  if (given) mesh::scale_by_power(given->file.pose, exponent);
  const volume_map::PieceOptions of_pieces = {.corners = options.corners,
                                              .triangles = options.triangles,
                                              .seed = session.seed(),
                                              .max_pieces = verb.frames.empty() ? std::size_t{0} : std::size_t{1},
                                              .fill = fill_by_tetgen(),
                                              .given = given ? given->view() : volume_map::GivenPolycube{}};
  return about_solid(options.input, options.input, input.report.format, findings, session, [&] {
    return mesh::with_places_of_caller(exponent, [&] {
      return volume_map::polycube_pieces(std::move(input.mesh), of_pieces, findings, session.host());
    });
  });
}

// The map of all pieces, along frames where there are any.
volume_map::VolumeMap map_of(std::span<const volume_map::PolycubePiece> pieces, const frame_field::Field& frames,
                             volume_map::GuidedFigures& guided, untangle::BlockEngine* engine, Session& session) {
  std::vector<volume_map::PolycubeSolid> solids;
  for (const volume_map::PolycubePiece& piece : pieces)
    solids.push_back(piece.solid());
  const base::Stage stage(session.host(), 0.95);
  if (frames.empty()) return volume_map::map_pieces_to_polycubes(solids, session.host(), engine);
  return volume_map::map_to_polycube_by_frames(solids.front(), frames, guided, session.host(), engine);
}

void require_outputs(const VolumeVerb& verb) {
  require_cells_writable(verb.output);
  for (const std::string& path : {verb.source, verb.resample}) {
    if (!path.empty()) require_cells_writable(path);
  }
}

void run_volume(const VolumeVerb& verb, Session& session) {
  const std::unique_ptr<untangle::BlockEngine> engine = start_solver(verb.solver);
  require_outputs(verb);
  session.options() = {{"output", verb.output},    {"source", verb.source}, {"solver", verb.solver},
                       {"text", verb.text},        {"frames", verb.frames}, {"cells", verb.cells},
                       {"resample", verb.resample}};
  session.options().update(json_of(verb.solid));
  int exponent = 0;
  volume_map::InputFindings findings = findings_of(session);
  frame_field::Field frames(session.host().memory);
  mesh::Mesh with_regions(session.host().memory);
  const auto pieces =
      session.portion(0.4, [&] { return read_pieces(verb, findings, exponent, frames, with_regions, session); });
  const double start = session.seconds();
  volume_map::GuidedFigures guided;
  volume_map::VolumeMap map = about(verb.output, Role::output, [&] {
    return mesh::with_places_of_caller(exponent, [&] { return map_of(pieces, frames, guided, engine.get(), session); });
  });
  session.figures().update(Json{{"output", verb.output},
                                {"source", verb.source},
                                {"vertices", map.source.size()},
                                {"tetrahedra", map.tetrahedra.size()},
                                {"inverted_at_start", map.inverted_at_start},
                                {"steps", map.steps},
                                {"seconds_compute", session.seconds() - start}});
  if (!frames.empty()) {
    session.figures()["frames"] = {{"energy", guided.energy},
                                   {"minimum_energy", guided.minimum_energy},
                                   {"harmonic_energy", guided.harmonic_energy},
                                   {"mismatched_faces", guided.mismatched_faces}};
  }
  if (!verb.resample.empty()) write_resampled(verb, map, exponent, session);
  mesh::Mesh cells(session.host().memory);
  cells.tetrahedra = std::move(map.tetrahedra);
  cells.positions = std::move(map.source);
  cells.regions.tetrahedra = mesh::nearest_cell_regions(with_regions, centers_of(cells), session.host());
  mesh::scale_by_power(cells.positions, -exponent);
  about(verb.solid.input, Role::input, [&] {
    report_intersections(verb.source.empty() ? verb.solid.input : verb.source, cells.positions,
                         mesh::boundary_triangles(cells, session.host()),
                         "the map is one to one between the tetrahedra, but the solid lies over itself there",
                         session.figures(), session);
  });
  if (!verb.source.empty()) write_cells_exactly(verb.source, cells, {.binary = !verb.text}, session);
  cells.positions = std::move(map.image);
  mesh::scale_by_power(cells.positions, -exponent);
  write_cells_exactly(verb.output, cells, {.binary = !verb.text}, session);
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
  verb->add_option("--frames", options->frames,
                   "frame field of IN, a tetrahedral mesh: its axes guide the map inside (eq. 5.3 of the dissertation)")
      ->type_name("FILE.frames");
  CLI::Option* resample =
      verb->add_option("--resample", options->resample,
                       "also write hexahedra: a regular grid on the polycube, taken to IN by the inverse of the map")
          ->type_name("HEXAHEDRA");
  verb->add_option("--cells", options->cells, "approximate number of hexahedra of --resample [default: 10000]")
      ->needs(resample)
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  add_solver_option(*verb, options->solver);
  add_text_option(*verb, options->text);
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "volume", options->solid.input);
    session.run([&] { run_volume(*options, session); });
  });
}

}  // namespace orbicube::cli
