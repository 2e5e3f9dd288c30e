// orbicube hex: a hexahedral mesh of a solid.
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "frame_hex.h"
#include "hex_output.h"
#include "polycube_solid.h"
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
  HexOutput output;
  std::size_t cells = 10000;
  std::string padding = "auto";
  std::string cut = "quarter";
  double distance = 1;
  std::size_t most_cells = 100'000;
  double sharp_edges = volume_map::HexOptions{}.sharp_angle;  // degrees
  std::string method = "polycube";
  std::string frames;
  double features = 0;  // degrees
};

void run_hex(const HexVerb& verb, Session& session) {
  HexOutput output = verb.output;
  output.cut = cuts.at(verb.cut);
  require_hex_output(output);
  session.options() = {{"output", output.path},
                       {"cells", verb.cells},
                       {"padding", verb.padding},
                       {"distance", verb.distance},
                       {"most_cells", verb.most_cells},
                       {"sharp_edges", verb.sharp_edges},
                       {"method", verb.method},
                       {"frames", verb.frames},
                       {"features", verb.features},
                       {"text", output.text},
                       {"glb", output.glb},
                       {"cut", verb.cut}};
  session.options().update(json_of(verb.solid));
  if (verb.method == "frames") {
    run_frame_hex({verb.solid, output, verb.frames, verb.cells, verb.distance, verb.most_cells, verb.features},
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
  about(output.path, Role::output, [&] {
    result = volume_map::make_hexahedra_of_pieces(boundaries,
                                                  {.cells = verb.cells,
                                                   .padding = paddings.at(verb.padding),
                                                   .distance = verb.distance,
                                                   .most_cells = verb.most_cells,
                                                   .sharp_angle = verb.sharp_edges},
                                                  session.host());
  });
  session.figures().update(Json{{"padded", result.padded},
                                {"follows_sharp_edges", result.follows_sharp_edges},
                                {"seconds_compute", session.seconds() - start}});
  write_hexahedra(output, std::move(result), verb.distance, std::to_string(corners) + " corners of the polycube",
                  session);
}

}  // namespace

void add_hex(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("hex", "make a hexahedral mesh of a solid");
  const auto options = std::make_shared<HexVerb>();
  add_polycube_solid_options(*verb, options->solid);
  verb->add_option("-o,--output", options->output.path, "hexahedra to write: .mesh .vtk")->required()->type_name("OUT");
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
  verb->add_option("--glb", options->output.glb,
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
  verb->add_flag("--text", options->output.text, "text rather than binary VTK");
  add_common_options(*verb, common);
  verb->callback([options, &common] {
    Session session(common, "hex", options->solid.input);
    session.run([&] { run_hex(*options, session); });
  });
}

}  // namespace orbicube::cli
