// orbicube hex: a hexahedral mesh of a solid.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/surface_file.h"
#include "report/hex_output.h"
#include "report/unit_size.h"
#include "solids/frame_hex.h"
#include "solids/machined_shape.h"
#include "solids/polycube_solid.h"
#include "verbs/verbs.h"
#include "volume_map/meshing/hex_pieces.h"
#include "volume_map/solid/solid_boundary.h"

namespace orbicube::cli {
namespace {

const std::map<std::string, volume_map::Padding> paddings = {{"auto", volume_map::Padding::automatic},
                                                             {"with", volume_map::Padding::with},
                                                             {"without", volume_map::Padding::without}};

const std::map<std::string, Cut> cuts = {{"quarter", Cut::quarter}, {"half", Cut::half}, {"none", Cut::none}};

constexpr double aligned_angle = volume_map::HexOptions{}.feature_angle;

struct HexVerb {
  PolycubeSolidOptions solid;
  HexOutput output;
  std::size_t cells = 10000;
  std::string padding = "auto";
  std::string cut = "quarter";
  double distance = 1;
  std::size_t max_cells = 100'000;
  // In degrees; not set: aligned_angle, and none with --method frames.
  std::optional<double> feature_angle;
  std::string method = "auto";
  std::string frames;
};

HexOutcome hexahedra_of_cells(const HexVerb& verb, volume_map::HexMethod method, Session& session) {
  using volume_map::HexMethod;
  const Polycubes polycubes = method == HexMethod::polycube ? Polycubes::needed
                              : method == HexMethod::grid   ? Polycubes::none
                                                            : Polycubes::where_there_are;
  PolycubeSolidOptions solid = verb.solid;
  solid.max_pieces = verb.cells;
  const std::vector<PolycubeSolidInput> pieces =
      session.portion(0.3, [&] { return read_polycube_solid(solid, Inside::nothing, polycubes, session); });
  const double start = session.seconds();
  std::vector<volume_map::PolycubeSurface> boundaries;
  std::size_t corners = 0;
  for (const PolycubeSolidInput& piece : pieces) {
    corners += piece.made.certificate.corners;
    boundaries.push_back(piece.boundary());
  }
  HexOutcome made{volume_map::HexResult(session.host().memory), Json::object(),
                  std::to_string(corners) + " corners of the polycube", ""};
  about(verb.output.path, Role::output, [&] {
    const base::Stage stage(session.host(), 0.95);
    made.result = volume_map::make_hexahedra_of_pieces(boundaries,
                                                       {.method = method,
                                                        .cells = verb.cells,
                                                        .padding = paddings.at(verb.padding),
                                                        .distance = verb.distance,
                                                        .max_cells = verb.max_cells,
                                                        .feature_angle = verb.feature_angle.value_or(aligned_angle)},
                                                       session.host());
  });
  made.besides =
      made.result.grid_based ? "cells of a grid in space" : std::to_string(corners) + " corners of the polycube";
  if (!pieces.empty()) made.exponent = pieces.front().exponent;
  made.figures = {{"method", made.result.grid_based ? "grid" : "polycube"},
                  {"padded", made.result.padded},
                  {"follows_sharp_edges", made.result.follows_sharp_edges},
                  {"seconds_compute", session.seconds() - start}};
  return made;
}

HexOutcome hexahedra_by_frames(const HexVerb& verb, double feature_angle, std::size_t max_fields, Session& session) {
  HexOutcome made = hexahedra_along_frames(
      {verb.solid, verb.output.path, verb.frames, verb.cells, verb.distance, verb.max_cells, feature_angle, max_fields},
      session);
  made.figures["method"] = "frames";
  return made;
}

bool looks_machined(const PolycubeSolidOptions& solid, Session& session) {
  const base::Host& host = session.host();
  InputMesh input = read_input(solid.input, solid.weld, session);
  bring_to_unit_size(input.mesh);
  try {
    if (input.mesh.tetrahedra.empty()) return is_machined(input.mesh.positions, input.mesh.triangles, host);
    const volume_map::BoundaryFirst first = volume_map::boundary_first(input.mesh, host);
    return is_machined(first.positions, first.surface, host);
  } catch (const base::Error& error) {
    if (error.status() == base::Status::cancelled) throw;
    return false;  // no surface of a solid; what is wrong is said by who wants one
  }
}

// Of machined parts by frames, which know of other than right angles and of round edges; of others, and where frames do
// not do, by polycubes; by frames again where there is no other way. The better one, if there are two.
HexOutcome best_hexahedra(const HexVerb& verb, Session& session) {
  constexpr double poor = 0.7;  // about what the corners of a polycube leave on round shapes
  // Each takes long, and what has a map at all has one along the first or the second most often.
  constexpr std::size_t few_fields = 3;
  // Layers are those of a polycube.
  const bool frames_may = verb.padding == "auto", machined = frames_may && looks_machined(verb.solid, session);
  std::optional<HexOutcome> made;
  const auto take = [&](HexOutcome now) {
    if (!made || volume_map::better(now.result, made->result, verb.distance)) made = std::move(now);
  };
  const auto try_frames = [&] {
    try {
      take(hexahedra_by_frames(verb, verb.feature_angle.value_or(aligned_angle), few_fields, session));
    } catch (const Failure& failure) {
      if (failure.kind() == "cancelled") throw;
    }
  };
  if (machined) try_frames();
  if (made && made->result.quality.min_scaled_jacobian > poor && volume_map::excess(made->result, verb.distance) <= 1)
    return std::move(*made);
  try {
    take(hexahedra_of_cells(verb, frames_may ? volume_map::HexMethod::automatic : volume_map::HexMethod::polycube,
                            session));
  } catch (const Failure& failure) {
    if (failure.kind() == "cancelled") throw;
    if (!made && !machined && frames_may && failure.kind() == "no-valid-result") try_frames();
    if (!made) throw;
  }
  return std::move(*made);
}

void run_hex(const HexVerb& verb, Session& session) {
  if (verb.method == "grid" && verb.padding == "without")
    throw Failure(Exit::wrong_input, "", "usage",
                  "--padding without: the cells of a grid in space have a layer around");
  HexOutput output = verb.output;
  output.cut = cuts.at(verb.cut);
  require_hex_output(output);
  session.options() = {{"output", output.path},
                       {"cells", verb.cells},
                       {"padding", verb.padding},
                       {"distance", verb.distance},
                       {"max_cells", verb.max_cells},
                       {"method", verb.method},
                       {"frames", verb.frames},
                       {"text", output.text},
                       {"glb", output.glb},
                       {"keep_partial", output.keep_partial},
                       {"cut", verb.cut}};
  session.options().update(json_of(verb.solid));
  const bool by_frames = verb.method == "frames" || (verb.method == "auto" && !verb.frames.empty());
  session.options()["feature_angle"] = verb.feature_angle.value_or(by_frames ? 0 : aligned_angle);
  HexOutcome made = by_frames
                        ? hexahedra_by_frames(verb, verb.feature_angle.value_or(0), FrameHexVerb{}.max_fields, session)
                    : verb.method == "polycube" ? hexahedra_of_cells(verb, volume_map::HexMethod::polycube, session)
                    : verb.method == "grid"     ? hexahedra_of_cells(verb, volume_map::HexMethod::grid, session)
                                                : best_hexahedra(verb, session);
  write_hexahedra(output, std::move(made), verb.distance, session);
}

}  // namespace

void add_hex(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("hex", "generate a hexahedral mesh of a solid");
  const auto options = std::make_shared<HexVerb>();
  add_polycube_solid_options(*verb, options->solid);
  verb->add_option("-o,--output", options->output.path, "hexahedra to write: " + cell_endings)
      ->required()
      ->type_name("OUT");
  verb->add_option("--cells", options->cells, "approximate number of hexahedra [default: 10000]")
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  verb->add_option("--distance", options->distance,
                   "maximum two-sided distance to the surface, in percent of the bounding-box diagonal, and maximum "
                   "volume error, in percent. While it is exceeded, the cell count is doubled, up to --max-cells; "
                   "more than twice of it is an error. 0: no limit [default: 1]")
      ->check(unnamed(CLI::Range(0.0, 100.0)))
      ->type_name("PERCENT");
  verb->add_option("--max-cells", options->max_cells,
                   "approximate maximum number of hexahedra for --distance [default: 100000]")
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  verb->add_option("--feature-angle", options->feature_angle,
                   "minimum dihedral angle, in degrees, of surface edges that edges of OUT or axes of computed frames "
                   "follow; 0: none [default: 40; with --method frames 0]")
      ->check(unnamed(CLI::Range(0.0, 179.0)))
      ->type_name("DEGREES");
  verb->add_option("--padding", options->padding,
                   "layer of hexahedra at the boundary: auto, on the patches where it improves the mesh; with; without "
                   "[default: auto]")
      ->check(unnamed(CLI::IsMember({"auto", "with", "without"})))
      ->type_name("P");
  verb->add_option("--glb", options->output.glb, "draw the mesh: quads with their edges, inner ones colored by quality")
      ->type_name("FILE.glb");
  verb->add_option("--cut", options->cut, "part that --glb leaves out: quarter, half or none [default: quarter]")
      ->check(unnamed(CLI::IsMember({"quarter", "half", "none"})))
      ->type_name("C");
  verb->add_option(
          "--method", options->method,
          "polycube: cells of a polycube; frames: along a frame field, with its singular edges inside; grid: "
          "grid-based, with a layer of cells around; auto (default): frames for machined parts; otherwise, and where "
          "frames fail, polycube; grid where that is too far from the surface or of low quality")
      ->check(unnamed(CLI::IsMember({"auto", "polycube", "frames", "grid"})))
      ->type_name("METHOD");
  verb->add_option("--frames", options->frames,
                   "frame field of IN, a tetrahedral mesh, for the hexahedra; default: computed")
      ->type_name("FILE.frames");
  verb->add_flag("--keep-partial", options->output.keep_partial,
                 "write OUT also if it exceeds twice --distance (exit code 1)");
  verb->add_flag("--text", options->output.text, "write text in place of binary VTK");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "hex", options->solid.input);
    session.run([&] { run_hex(*options, session); });
  });
}

}  // namespace orbicube::cli
