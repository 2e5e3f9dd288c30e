// orbicube morph: shapes that become each other, through their sphere maps, as morph targets of one glTF mesh.
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include "base/counted.h"
#include "correspondence/sphere_mesh.h"
#include "files/surface_file.h"
#include "morphs/morph_alignment.h"
#include "morphs/morph_placement.h"
#include "morphs/morph_states.h"
#include "morphs/sphere_shapes.h"
#include "report/grid_choice.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "session/unused_options.h"
#include "solids/kept_surface.h"
#include "solids/repaired_surface.h"
#include "verbs/verbs.h"
#ifdef ORBICUBE_WITH_POLYCUBE
#include "morphs/morph_polycube.h"
#endif

namespace orbicube::cli {
namespace {

using correspondence::CommonMesh;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

struct MorphOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::string landmarks;
  std::string grid = "both";
  std::string align = "shape";
  std::string placement = "kept";
  double tolerance = 0.2;  // percent of the diagonal
  std::size_t intermediates = 0;
  double seconds = 2;
  Mending mending;
  bool polycube = false;
  bool show_polycube = false;
  std::size_t corners = 0;
  ShapeBlend blend;
};

CommonMesh common_mesh(const MorphOptions& options, const std::deque<MorphShape>& shapes, Session& session) {
  const base::Host& host = session.host();
  correspondence::SphereShapes spheres;
  for (const MorphShape& shape : shapes)
    spheres.push_back(&shape);
  if (options.grid == "first") return correspondence::mesh_of_first(spheres, host);
  if (options.grid != "both") {
    const GridChoice choice = grid_choice(options.grid, "--grid");
    return correspondence::mesh_of_grid(spheres, choice.kind, choice.resolution, host);
  }
  CommonMesh common = correspondence::overlay_of(spheres, options.tolerance / 100, host);
  session.figures()["edges_of_others"] = common.edges_of_others;
  session.figures()["edges_kept"] = common.edges_kept;
  return common;
}

Json json_of(const MorphOptions& options) {
  return {{"output", options.output},
          {"landmarks", options.landmarks},
          {"align", options.align},
          {"placement", options.placement},
          {"grid", options.grid},
          {"tolerance", options.tolerance},
          {"intermediates", options.intermediates},
          {"seconds", options.seconds},
          {"weld", options.mending.weld},
          {"repair", options.mending.repair},
          {"polycube", options.polycube},
          {"show_polycube", options.show_polycube}};
}

// The common mesh on each shape; its triangles on the first one go to `on_first` where that is kept.
std::vector<base::Array<Vector3>> carry_to_shapes(std::deque<MorphShape>& shapes, const CommonMesh& common,
                                                  base::Array<gltf::KeptTriangle>& on_first, const base::Host& host) {
  std::vector<base::Array<Vector3>> states;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    MorphShape& shape = shapes[i];
    const base::Stage stage(host, 1.0 / static_cast<double>(shapes.size() + 1 - i));
    sphere_map::CarriedShape carried = correspondence::carry_to_shape(shape, common, i, host);
    mesh::Mesh state(host.memory);
    state.positions = carried.positions;
    state.triangles = common.triangles;
    shape.figures["flipped"] = carried.flipped;
    shape.figures["distance"] = json_of_distance(shape.mesh, state, host);
    states.push_back(std::move(carried.positions));
    if (i == 0 && shape.kept) on_first = kept_triangles(*shape.locator, carried.directions, common.triangles, host);
    if (i > 0)
      shape.figures["area_distortion"] = correspondence::area_distortion(common.triangles, states[0], states[i]);
  }
  return states;
}

void write_states(const std::deque<MorphShape>& shapes, const CommonMesh& common,
                  const std::vector<base::Array<Vector3>>& states, const base::Array<gltf::KeptTriangle>& on_first,
                  const MorphOptions& options, Session& session) {
  MorphStates morph{options.output, {}, common.triangles, states, options.seconds, options.intermediates};
  if (shapes[0].kept) {
    morph.kept = shapes[0].kept.get();
    morph.kept_surface = shapes[0].mesh.triangles;
    morph.kept_triangles = on_first;
  }
  for (const MorphShape& shape : shapes)
    morph.names.push_back(std::filesystem::path(shape.path).stem().string());
  if (options.blend.weights.empty())
    write_morph(morph, session);
  else
    write_blend(morph, options.blend, {}, session);
}

std::string text_of_landmarks(const Json& figures) {
  if (!figures.contains("landmarks")) return "";
  const Json& landmarks = figures["landmarks"];
  return "; landmarks apart by " + number(landmarks["angle_rotated"]["max"].get<double>()) +
         " rad at most after turning, by " + number(landmarks["angle"]["max"].get<double>()) + " after bending";
}

void report_shapes(const std::deque<MorphShape>& shapes, const CommonMesh& common, const std::string& output,
                   Session& session) {
  session.figures()["output"] = output;
  session.figures()["vertices"] = common.directions.size();
  session.figures()["triangles"] = common.triangles.size();
  session.figures()["shapes"] = Json::array();
  session.say("wrote " + output + ": " + base::counted(shapes.size(), "shape") + " on " +
              base::counted(common.directions.size(), "vertex", "vertices") + " and " +
              base::counted(common.triangles.size(), "triangle"));
  for (const MorphShape& shape : shapes) {
    session.figures()["shapes"].push_back(shape.figures);
    const double lost = shape.figures["distance"]["from_surface"]["max_of_diagonal"].get<double>();
    session.say("  " + shape.path + ": at most " + number(100 * lost) + " % of its diagonal is lost" +
                text_of_landmarks(shape.figures));
    if (const auto over = shape.figures["flipped"].get<std::size_t>(); over > 0)
      session.note(shape.path + ": " + base::counted(over, "triangle of the mesh is", "triangles of the mesh are") +
                   " flipped or flat on its sphere");
  }
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void morph(const MorphOptions& options, Session& session) {
  session.options() = json_of(options);
  require_writable(options.output);
  require_weights(options.blend, options.inputs.size());
  if (!options.blend.quads.empty()) require_writable(options.blend.quads);
  if (options.blend.weights.empty() && !is_gltf(options.output))
    throw Failure(Exit::wrong_input, options.output, "unsupported-format",
                  "morph targets need one of " + gltf_endings + "; a shape between them is --blend WEIGHTS");
  if (!options.blend.weights.empty()) session.options()["blend"] = options.blend.weights;
#ifdef ORBICUBE_WITH_POLYCUBE
  if (options.polycube) {
    morph_by_polycube(
        {options.inputs, options.output, options.landmarks, options.grid, options.placement, options.corners,
         options.intermediates, options.seconds, options.mending, options.blend, options.show_polycube},
        session);
    return;
  }
#endif
  if (options.grid != "both" && options.grid != "first") grid_choice(options.grid, "--grid");
  const base::Host& host = session.host();
  const SphereShapesOptions of_spheres{options.inputs, options.landmarks, options.align, options.mending,
                                       Keep::decoration};
  std::deque<MorphShape> shapes = map_shapes(of_spheres, session);
  align_shapes(shapes, of_spheres, session);
  if (options.landmarks.empty() && options.align != "none" && options.placement == "kept") note_turned(shapes, session);
  const CommonMesh common = common_mesh(options, shapes, session);
  base::Array<gltf::KeptTriangle> on_first(host.memory);
  std::vector<base::Array<Vector3>> states = carry_to_shapes(shapes, common, on_first, host);
  std::vector<Json*> figures;
  for (MorphShape& shape : shapes)
    figures.push_back(&shape.figures);
  place_states(options.placement, common.triangles, states, figures);
  write_states(shapes, common, states, on_first, options, session);
  report_shapes(shapes, common, options.output, session);
}

CLI::Option* add_blend_option(CLI::App& verb, MorphOptions& options) {
  return verb
      .add_option("--blend", options.blend.weights,
                  "write one shape in place of a morph: the weighted sum of the shapes, a weight each, as .2,.5,.3")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(finite_number())
      ->type_name("W,W,...");
}

#ifdef ORBICUBE_WITH_POLYCUBE
void add_polycube_options(CLI::App& verb, MorphOptions& options, CLI::Option* blend) {
  CLI::Option* polycube = verb.add_flag("--polycube", options.polycube,
                                        "use one polycube in place of spheres, for two to ten shapes of any one "
                                        "genus; --grid is first or cells:N [default: the maximum triangle count]");
  verb.add_flag("--show-polycube", options.show_polycube, "add the polycube as a target between consecutive shapes")
      ->needs(polycube);
  verb.add_option("--corners", options.corners, "maximum number of polycube corners; 0: no limit [default: 0]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->needs(polycube)
      ->type_name("N");
  verb.add_option("--quads", options.blend.quads,
                  "also write the shape of --blend as quads of the polycube's grid: " + polygon_endings +
                      "; other formats get two triangles a quad")
      ->needs(polycube)
      ->needs(blend)
      ->type_name("FILE");
}
#endif

}  // namespace

void add_morph(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("morph", "blend shapes as morph targets of one mesh");
  const auto options = std::make_shared<MorphOptions>();
  verb->add_option("SHAPES", options->inputs, std::string("two or more closed genus-0 surfaces: ") + surface_endings)
      ->required()
      ->expected(2, 100)
      ->type_name("A B ...");
  verb->add_option("-o,--output", options->output,
                   "mesh to write: " + gltf_endings +
                       "; the first shape, the others as targets. With --blend one shape: " + surface_endings)
      ->required()
      ->type_name("OUT");
  CLI::Option* blend = add_blend_option(*verb, *options);
#ifdef ORBICUBE_WITH_POLYCUBE
  add_polycube_options(*verb, *options, blend);
#else
  static_cast<void>(blend);
#endif
  verb->add_option("--landmarks", options->landmarks,
                   "corresponding points: one line each, with a vertex number (from 0) or x y z for each shape")
      ->type_name("FILE");
  verb->add_option("--align", options->align, align_help)
      ->check(unnamed(CLI::IsMember({"shape", "rotation", "none"})))
      ->type_name("HOW");
  verb->add_option("--placement", options->placement, placement_help)
      ->check(unnamed(CLI::IsMember({"kept", "turned", "scaled"})))
      ->type_name("HOW");
  verb->add_option(
          "--grid", options->grid,
          std::string("mesh [default: both]: both, the vertices of all shapes; first, those of the first one; or ") +
              grid_help)
      ->type_name("GRID");
  verb->add_option("--tolerance", options->tolerance,
                   "maximum deviation of edges with --grid both, in percent of the diagonal of a shape; longer edges "
                   "are bisected; 0: no limit [default: 0.2]")
      ->check(non_negative_number())
      ->type_name("P");
  verb->add_option("--intermediates", options->intermediates,
                   "also write N intermediate shapes between consecutive ones, to OUT-01 and so on")
      ->check(unnamed(CLI::Range(0, 10000)))
      ->type_name("N");
  verb->add_option("--seconds", options->seconds,
                   "duration of the animation from one shape to the next, in seconds [default: 2]")
      ->check(positive_number())
      ->type_name("S");
  add_mending_options(*verb, options->mending);
  add_common_options(*verb, common);
  verb->footer(
      "Each shape is mapped to the sphere. The spheres are rotated to maximum correlation, or until landmarks "
      "coincide; points\nat one direction correspond. For shapes with other sizes or axes, --placement scaled aligns "
      "them "
      "with the first one.\nFor example:\n  orbicube morph a.obj b.obj -o ab.glb --placement turned");
  verb->callback([options, verb, &common] {
    Session session(common, "morph", options->inputs.front());
    session.run([&] {
      refuse_unused_morph_options(*verb);
      morph(*options, session);
    });
  });
}

}  // namespace orbicube::cli
