// orbicube hex: a hexahedral mesh of a solid.
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "files/surface_file.h"
#include "frame_field/frames_file.h"
#include "hexmesh/hexmesh.h"
#include "report/hex_output.h"
#include "session/unused_options.h"
#include "solids/solid_input.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

const std::map<std::string, hexmesh::Method> hex_methods = {{"auto", hexmesh::Method::automatic},
                                                            {"polycube", hexmesh::Method::polycube},
                                                            {"frames", hexmesh::Method::frames},
                                                            {"grid", hexmesh::Method::grid}};

const std::map<std::string, hexmesh::Padding> paddings = {
    {"auto", hexmesh::Padding::automatic}, {"with", hexmesh::Padding::with}, {"without", hexmesh::Padding::without}};

const std::map<std::string, Cut> cuts = {{"quarter", Cut::quarter}, {"half", Cut::half}, {"none", Cut::none}};

const std::map<std::string, hexmesh::Features> feature_sources = {
    {"off", hexmesh::Features::off},        {"machined", hexmesh::Features::machined},
    {"auto", hexmesh::Features::automatic}, {"tags", hexmesh::Features::tags},
    {"angles", hexmesh::Features::angles},  {"strict", hexmesh::Features::automatic}};

struct HexVerb {
  SolidOptions solid;
  HexOutput output;
  std::size_t cells = hexmesh::Options{}.cells;
  std::string padding = "auto";
  std::string cut = "quarter";
  double distance = hexmesh::Options{}.distance;
  std::size_t max_cells = hexmesh::Options{}.max_cells;
  std::optional<double> feature_angle;  // in degrees
  std::string method = "auto";
  std::string features = "machined";
  std::string frames;
};

hexmesh::Options options_of(const HexVerb& verb, const Session& session) {
  hexmesh::Options options;
  options.method = verb.frames.empty() || verb.method != "auto" ? hex_methods.at(verb.method) : hexmesh::Method::frames;
  options.padding = paddings.at(verb.padding);
  options.cells = verb.cells;
  options.corners = verb.solid.corners;
  options.triangles = verb.solid.triangles;
  options.seed = session.seed();
  options.distance = verb.distance;
  options.max_cells = verb.max_cells;
  options.feature_angle = verb.feature_angle;
  options.features = feature_sources.at(verb.features);
  options.fill = fill_by_tetgen();
  return options;
}

frame_field::Field read_given_frames(const HexVerb& verb, const mesh::Mesh& solid, const base::Host& host) {
  about(verb.solid.input, Role::input, [&] {
    if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra; --frames has a frame for each");
  });
  return about(verb.frames, Role::input,
               [&] { return frame_field::read_frames(verb.frames, solid.tetrahedra.size(), host); });
}

void run_hex(const HexVerb& verb, Session& session) {
  if (verb.method == "grid" && verb.padding == "without")
    throw Failure(Exit::wrong_input, "", "usage",
                  "--padding without: the cells of a grid in space have a layer around");
  HexOutput output = verb.output;
  output.cut = cuts.at(verb.cut);
  output.strict = verb.features == "strict";
  require_hex_output(output);
  session.options() = {{"output", output.path},
                       {"cells", verb.cells},
                       {"padding", verb.padding},
                       {"distance", verb.distance},
                       {"max_cells", verb.max_cells},
                       {"method", verb.method},
                       {"features", verb.features},
                       {"frames", verb.frames},
                       {"text", output.text},
                       {"glb", output.glb},
                       {"keep_partial", output.keep_partial},
                       {"cut", verb.cut}};
  session.options().update(json_of(verb.solid));
  const bool by_polycube = verb.method == "auto" || verb.method == "polycube";
  const bool none_requested = verb.features == "off" || verb.features == "machined";
  if (!verb.solid.from.empty() && (!by_polycube || !verb.frames.empty() || !none_requested))
    throw Failure(Exit::wrong_input, "", "usage", "--from is for --method polycube, without --features");
  hexmesh::Options options = options_of(verb, session);
  const std::optional<SolidPolycube> given = read_solid_polycube(verb.solid, session);
  if (given) options.given = given->view();
  const bool features = options.features != hexmesh::Features::off;
  const InputMesh input = session.portion(
      0.01, [&] { return read_mended(verb.solid.input, verb.solid.mending, session, Keep::surface, features); });
  if (verb.features == "tags" && (!input.report.tags || input.report.tags->empty()))
    throw Failure(Exit::wrong_input, verb.solid.input, "usage",
                  "--features tags: the file marks no edges and no vertices; --features auto finds sharp edges");
  if (input.report.tags) {
    options.tagged_edges = input.report.tags->edges;
    options.tagged_vertices = input.report.tags->vertices;
  }
  frame_field::Field frames(session.host().memory);
  if (!verb.frames.empty() && hexmesh::by_frames(options)) frames = read_given_frames(verb, input.mesh, session.host());
  options.frames = frames;
  volume_map::InputFindings findings = findings_of(session);
  hexmesh::Hexahedra made =
      about_solid(verb.solid.input, verb.output.path, input.report.format, findings, session,
                  [&] { return hexmesh::make_hexahedra(input.mesh, options, findings, session.host()); });
  session.options()["feature_angle"] = made.feature_angle;
  write_hexahedra(output, input.mesh, std::move(made), verb.distance, session);
}

void add_feature_options(CLI::App& verb, HexVerb& options) {
  verb.add_option("--feature-angle", options.feature_angle,
                  "minimum dihedral angle, in degrees, of surface edges that edges of OUT or axes of computed frames "
                  "follow; 0: none [default: 35 where there are features, else 40, or 0 with --method frames]")
      ->check(number_from_to(0, 179))
      ->type_name("DEGREES");
  verb.add_option(
          "--features", options.features,
          "edges and corners of IN that OUT should have, grid-based where the method does not keep them: auto, "
          "sharp ones of --feature-angle and clear ones among those that IN marks; tags, all that IN marks; angles, "
          "sharp ones only; strict, as auto, and a missing one is an error; machined, as auto for machined parts and "
          "where IN marks edges, with --method auto and grid; off [default: machined]")
      ->check(unnamed(CLI::IsMember({"machined", "auto", "tags", "angles", "strict", "off"})))
      ->type_name("F");
}

void add_drawing_options(CLI::App& verb, HexVerb& options) {
  verb.add_option("--glb", options.output.glb, "draw the mesh: quads with their edges, inner ones colored by quality")
      ->type_name("FILE.glb");
  verb.add_option("--cut", options.cut, "part that --glb leaves out: quarter, half or none [default: quarter]")
      ->check(unnamed(CLI::IsMember({"quarter", "half", "none"})))
      ->type_name("C");
}

}  // namespace

void add_hex(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("hex", "generate a hexahedral mesh of a solid");
  const auto options = std::make_shared<HexVerb>();
  add_solid_options(*verb, options->solid);
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
      ->check(number_from_to(0, 100))
      ->type_name("PERCENT");
  verb->add_option("--max-cells", options->max_cells,
                   "approximate maximum number of hexahedra for --distance [default: 100000]")
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  add_feature_options(*verb, *options);
  verb->add_option("--padding", options->padding,
                   "layer of hexahedra at the boundary: auto, on the patches where it improves the mesh; with; without "
                   "[default: auto]")
      ->check(unnamed(CLI::IsMember({"auto", "with", "without"})))
      ->type_name("P");
  add_drawing_options(*verb, *options);
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
  add_text_option(*verb, options->output.text);
  add_common_options(*verb, common);
  verb->callback([options, verb, &common] {
    Session session(common, "hex", options->solid.input);
    session.run([&] {
      refuse_unused_hex_options(*verb);
      run_hex(*options, session);
    });
  });
}

}  // namespace orbicube::cli
