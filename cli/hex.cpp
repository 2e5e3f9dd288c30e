// orbicube hex: a hexahedral mesh of a solid.
#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "frame_hex.h"
#include "hex_scene.h"
#include "polycube_solid.h"
#include "surface_file.h"
#include "text.h"
#include "verbs.h"
#include "volume_map/hex_pieces.h"

namespace orbicube::cli {
namespace {

const std::map<std::string, volume_map::Padding> paddings = {{"auto", volume_map::Padding::automatic},
                                                             {"with", volume_map::Padding::with},
                                                             {"without", volume_map::Padding::without}};

const std::map<std::string, Cut> cuts = {{"quarter", Cut::quarter}, {"half", Cut::half}, {"none", Cut::none}};

struct HexVerb {
  PolycubeSolidOptions solid;
  std::string output;
  std::size_t cells = 10000;
  std::string padding = "auto";
  std::string glb;
  std::string cut = "quarter";
  double distance = 1;
  std::size_t most_cells = 100'000;
  double sharp_edges = volume_map::HexOptions{}.sharp_angle;  // degrees
  std::string method = "polycube";
  std::string frames;
  double features = 0;  // degrees
  bool text = false;
};

void run_hex(const HexVerb& verb, Session& session) {
  require_cells_writable(verb.output);
  if (!verb.glb.empty()) {
    require_writable(verb.glb);
    if (!is_gltf(verb.glb))
      throw Failure(Exit::wrong_input, verb.glb, "unsupported-format", "--glb needs .glb or .gltf");
  }
  session.options() = {{"output", verb.output},
                       {"cells", verb.cells},
                       {"padding", verb.padding},
                       {"distance", verb.distance},
                       {"most_cells", verb.most_cells},
                       {"sharp_edges", verb.sharp_edges},
                       {"method", verb.method},
                       {"frames", verb.frames},
                       {"features", verb.features},
                       {"text", verb.text},
                       {"glb", verb.glb},
                       {"cut", verb.cut}};
  session.options().update(json_of(verb.solid));
  if (verb.method == "frames") {
    run_frame_hex(
        {verb.solid, verb.output, verb.frames, verb.cells, verb.features, verb.glb, cuts.at(verb.cut), verb.text},
        session);
    return;
  }
  const std::vector<PolycubeSolidInput> pieces = read_polycube_solid(verb.solid, Inside::nothing, session);
  const double start = session.seconds();
  std::vector<volume_map::PolycubeSurface> boundaries;
  std::size_t corners = 0;
  for (const PolycubeSolidInput& piece : pieces) {
    corners += piece.made.certificate.corners;
    boundaries.push_back(piece.boundary());
  }
  volume_map::HexResult result(session.host().memory);
  about(verb.output, Role::output, [&] {
    result = volume_map::make_hexahedra_of_pieces(boundaries,
                                                  {.cells = verb.cells,
                                                   .padding = paddings.at(verb.padding),
                                                   .distance = verb.distance,
                                                   .most_cells = verb.most_cells,
                                                   .sharp_angle = verb.sharp_edges},
                                                  session.host());
  });
  const volume_map::HexQuality quality = result.quality;
  const double distance = result.distance, volume_error = result.volume_error;
  session.figures().update(Json{{"output", verb.output},
                                {"vertices", result.mesh.positions.size()},
                                {"hexahedra", result.mesh.hexahedra.size()},
                                {"boundary_quads", result.mesh.quads.size()},
                                {"padded", result.padded},
                                {"follows_sharp_edges", result.follows_sharp_edges},
                                {"scaled_jacobian_min", quality.least_scaled_jacobian},
                                {"scaled_jacobian_mean", quality.mean_scaled_jacobian},
                                {"volume", quality.volume},
                                {"off_surface", result.off_surface},
                                {"distance_percent", result.distance},
                                {"volume_error_percent", result.volume_error},
                                {"seconds_compute", session.seconds() - start}});
  if (!verb.glb.empty()) {
    about(verb.glb, Role::output, [&] {
      session.figures()["scene"] = write_hex_scene(verb.glb, result.mesh, cuts.at(verb.cut),
                                                   std::filesystem::path(verb.output).stem().string(), session.host());
    });
  }
  mesh::Mesh cells(session.host().memory);
  cells.positions = std::move(result.mesh.positions);
  cells.hexahedra = std::move(result.mesh.hexahedra);
  write_cells_exactly(verb.output, cells, verb.text, session.host());
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + verb.output + ": " + std::to_string(cells.hexahedra.size()) +
              " hexahedra, each certified to be positive");
  session.say("  scaled Jacobians " + number(quality.least_scaled_jacobian) + " at least, " +
              number(quality.mean_scaled_jacobian) + " on average; " + std::to_string(corners) +
              " corners of the polycube");
  session.say("  " + number(distance) + " % of the diagonal from the surface at most, volume off by " +
              number(volume_error) + " %");
  if (verb.distance > 0 && std::max(distance, volume_error) > verb.distance)
    session.say("  that is more than --distance " + number(verb.distance) +
                ", with all the cells that --most-cells allows");
}

}  // namespace

void add_hex(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("hex", "make a hexahedral mesh of a solid");
  const auto options = std::make_shared<HexVerb>();
  add_polycube_solid_options(*verb, options->solid);
  verb->add_option("-o,--output", options->output, "hexahedra to write: .mesh .vtk")->required()->type_name("OUT");
  verb->add_option("--cells", options->cells, "about so many hexahedra (10000)")
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  verb->add_option(
          "--distance", options->distance,
          "how far in percent of the diagonal the mesh may be from the surface, and its volume in percent of the "
          "surface's (1); where it is more, there are twice as many cells, and again; 0: as it comes")
      ->check(unnamed(CLI::Range(0.0, 100.0)))
      ->type_name("PERCENT");
  verb->add_option("--most-cells", options->most_cells, "about so many hexahedra for --distance (100000)")
      ->check(unnamed(CLI::Range(1, 10'000'000)))
      ->type_name("N");
  verb->add_option("--sharp-edges", options->sharp_edges,
                   "edges of the surface that bend by so many degrees are followed where the polycube has edges "
                   "nearby (40); 0: none")
      ->check(unnamed(CLI::Range(0.0, 179.0)))
      ->type_name("DEGREES");
  verb->add_option(
          "--padding", options->padding,
          "a layer of hexahedra at the boundary: auto, on the faces where it serves (the default), with or without")
      ->check(unnamed(CLI::IsMember({"auto", "with", "without"})))
      ->type_name("P");
  verb->add_option("--glb", options->glb,
                   "draw it, too: quads with their edges, what is seen inside coloured by quality")
      ->type_name("FILE.glb");
  verb->add_option("--cut", options->cut, "what that leaves out: a quarter (the default), half or none")
      ->check(unnamed(CLI::IsMember({"quarter", "half", "none"})))
      ->type_name("C");
  CLI::Option* method =
      verb->add_option(
              "--method", options->method,
              "polycube: the cells of a polycube (the default); frames: along a frame field, with its singular "
              "edges inside")
          ->check(unnamed(CLI::IsMember({"polycube", "frames"})))
          ->type_name("METHOD");
  verb->add_option("--frames", options->frames,
                   "frames of IN, a mesh of tetrahedra, for --method frames; else they are found")
      ->type_name("FILE.frames")
      ->needs(method);
  verb->add_option(
          "--features", options->features,
          "where frames are found, an axis follows edges of the boundary that turn by more than so many degrees "
          "(0: none)")
      ->check(unnamed(CLI::Range(0.0, 180.0)))
      ->type_name("DEGREES")
      ->needs(method);
  verb->add_flag("--text", options->text, "text rather than binary VTK");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "hex", options->solid.input);
    session.run([&] { run_hex(*options, session); });
  });
}

}  // namespace orbicube::cli
