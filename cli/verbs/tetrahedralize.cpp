// orbicube tetrahedralize: a closed surface filled with tetrahedra.
#include <memory>
#include <string>
#include <utility>

#include "base/counted.h"
#include "files/sizing_file.h"
#include "files/surface_file.h"
#include "mesh/files/file.h"
#include "report/cell_figures.h"
#include "session/unused_options.h"
#include "solids/repaired_surface.h"
#include "tetrahedra/input_check.h"
#include "tetrahedra/tetrahedra.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

constexpr std::size_t max_pairs_in_report = 1000;

struct TetrahedralizeOptions {
  std::string input;
  std::string output;
  tetrahedra::Options filling;
  std::string sizing;
  bool cut_surface = false;
  bool text = false;
  Mending mending;
};

tetrahedra::Solid fill(const mesh::Mesh& surface, TetrahedralizeOptions options, Session& session) {
  base::Array<tetrahedra::SizePoint> sizes(session.host().memory);
  if (!options.sizing.empty()) {
    sizes = about(options.sizing, Role::input,
                  [&] { return read_sizing(options.sizing, surface.positions, session.host()); });
    options.filling.sizes = sizes;
  }
  return about(options.input, Role::input, [&] {
    if (!surface.tetrahedra.empty() || !surface.hexahedra.empty())
      throw base::Error("unsupported", "a solid of cells already; tetrahedralize takes surfaces");
    try {
      return tetrahedra::fill(surface.positions, surface.triangles, options.filling, session.host());
    } catch (const base::Error& error) {
      if (error.kind() == std::string("self-intersection")) {
        const auto pairs = tetrahedra::self_intersections(surface.positions, surface.triangles, session.host());
        Json first = Json::array();
        for (std::size_t i = 0; i < std::min(pairs.size(), max_pairs_in_report); ++i)
          first.push_back({pairs[i][0], pairs[i][1]});
        session.figures()["self_intersections"] = pairs.size();
        session.figures()["self_intersecting_faces"] = first;
      }
      throw;
    }
  });
}

void tetrahedralize(TetrahedralizeOptions options, Session& session) {
  require_cells_writable(options.output);
  options.filling.keep_surface = !options.cut_surface;
  session.options() = {{"output", options.output},
                       {"quality", options.filling.quality},
                       {"max_volume", options.filling.max_volume},
                       {"edge_length", options.filling.edge_length},
                       {"sizing", options.sizing},
                       {"growth", options.filling.size_growth},
                       {"cut_surface", options.cut_surface},
                       {"text", options.text},
                       {"weld", options.mending.weld},
                       {"repair", options.mending.repair}};
  const InputMesh input = session.portion(0.03, [&] { return read_mended(options.input, options.mending, session); });
  session.figures()["format"] = input.report.format;
  session.figures()["seconds_read"] = input.seconds;
  const double start = session.seconds();
  tetrahedra::Solid solid = session.portion(0.85, [&] { return fill(input.mesh, options, session); });
  const auto quality = mesh::tetrahedron_quality(solid.positions, solid.tetrahedra, session.host());
  const double filled = session.seconds();

  mesh::Mesh result;
  result.positions = std::move(solid.positions);
  result.tetrahedra = std::move(solid.tetrahedra);
  result.triangles = std::move(solid.boundary);
  if (!input.mesh.regions.triangles.empty()) {
    for (const mesh::Index source : solid.boundary_source)
      result.regions.triangles.push_back(input.mesh.regions.triangles[source]);
  }
  write_output(options.output, result, !options.text, session);

  const std::size_t added = result.positions.size() - input.mesh.positions.size();
  session.figures().update({{"output", options.output},
                            {"vertices", result.positions.size()},
                            {"added_vertices", added},
                            {"tetrahedra", result.tetrahedra.size()},
                            {"triangles", input.mesh.triangles.size()},
                            {"boundary_triangles", result.triangles.size()},
                            {"parts", solid.parts},
                            {"cavities", solid.cavities},
                            {"cells", quality_json(quality)},
                            {"seconds_compute", filled - start},
                            {"seconds_write", session.seconds() - filled}});
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + options.output + ": " + base::counted(result.positions.size(), "vertex", "vertices") + " (" +
              std::to_string(added) + " added), " +
              base::counted(result.tetrahedra.size(), "tetrahedron", "tetrahedra"));
  session.say("  dihedral angles " + angles_text(quality));
  session.say("  radius ratio    " + radii_text(quality));
}

}  // namespace

void add_tetrahedralize(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("tetrahedralize", "fill a closed surface with tetrahedra");
  const auto options = std::make_shared<TetrahedralizeOptions>();
  verb->add_option("IN", options->input, std::string("surface to fill: ") + surface_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output, "mesh to write: " + cell_endings)->required()->type_name("OUT");
  verb->add_option(
          "--quality", options->filling.quality,
          "maximum ratio of circumradius to shortest edge, at least 1; 0: no vertices for quality [default: 1.4]")
      ->check(non_negative_number())
      ->type_name("R");
  verb->add_option("--max-volume", options->filling.max_volume, "maximum volume of a tetrahedron")
      ->check(positive_number())
      ->type_name("V");
  verb->add_option("--edge-length", options->filling.edge_length, "approximate length of inner edges")
      ->check(positive_number())
      ->type_name("L");
  verb->add_option("--sizing", options->sizing,
                   "edge lengths at points: lines x y z L, or one line L for each vertex of IN")
      ->type_name("FILE");
  verb->add_option("--growth", options->filling.size_growth,
                   "gradation of --sizing: edge-length growth per unit distance [default: 0.3]")
      ->check(non_negative_number())
      ->type_name("G");
  verb->add_flag("--cut-surface", options->cut_surface,
                 "allow edges and triangles of the surface to be split; default: they are preserved");
  add_text_option(*verb, options->text);
  add_mending_options(*verb, options->mending);
  add_common_options(*verb, common);
  verb->footer(
      "The surface may have any number of closed components; one within another bounds a cavity. Its vertices come "
      "first in\nOUT, in their order.");
  verb->callback([options, verb, &common] {
    Session session(common, "tetrahedralize", options->input);
    session.run([&] {
      refuse_unused_tetrahedralize_options(*verb);
      tetrahedralize(*options, session);
    });
  });
}

}  // namespace orbicube::cli
