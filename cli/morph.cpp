// orbicube morph: shapes that become each other, through their sphere maps, as morph targets of one glTF mesh.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "base/sums.h"
#include "grid_choice.h"
#include "mesh/measures.h"
#include "morph_alignment.h"
#include "morph_placement.h"
#include "morph_states.h"
#include "sphere_map/correspondence.h"
#include "sphere_map/overlay.h"
#include "sphere_map/sphere_map.h"
#include "sphere_uses.h"
#include "surface_file.h"
#include "text.h"
#include "verbs.h"
#ifdef ORBICUBE_WITH_POLYCUBE
#include "morph_polycube.h"
#endif

namespace orbicube::cli {
namespace {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;
using sphere_map::Alignment;

struct MorphOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::string landmarks;
  std::string grid = "both";
  std::string align = "rotation";
  std::string place = "kept";
  double tolerance = 0.2;  // percent of the diagonal
  std::size_t steps = 0;
  double seconds = 2;
  bool weld = false;
  bool polycube = false;
  bool show_polycube = false;
  std::size_t corners = 0;
};

// The triangulation of the common sphere that all shapes get.
struct CommonMesh {
  explicit CommonMesh(std::pmr::memory_resource* memory) : directions(memory), triangles(memory) {}

  base::Array<Vector3> directions;
  base::Array<Triangle> triangles;
  std::vector<base::Array<Index>> own_vertex;  // one a shape: which of its vertices each one is, no_index for none
};

void read_and_map(MorphShape& shape, const MorphOptions& options, Session& session) {
  shape.surface = read_closed_surface(shape.path, options.weld, session);
  const mesh::Mesh& mesh = shape.surface.mesh;
  const double start = session.seconds();
  about(shape.path, Role::input, [&] {
    shape.directions = sphere_map::compute(mesh.positions, mesh.triangles, {.seed = session.seed()}, session.host());
  });
  shape.locator = std::make_unique<sphere_map::Locator>(mesh.triangles, shape.directions, session.host());
  shape.figures = {{"input", shape.path}};
  shape.figures.update(shape.surface.figures);
  shape.figures.update({{"vertices", mesh.positions.size()},
                        {"triangles", mesh.triangles.size()},
                        {"seconds_map", session.seconds() - start},
                        {"rotation", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
}

// The vertices of all shapes, on the triangles of the first.
CommonMesh overlay_of(const MorphOptions& options, const std::deque<MorphShape>& shapes, Session& session) {
  const base::Host& host = session.host();
  std::vector<sphere_map::PlacedMap> others;
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    others.push_back({shapes[i].directions, shapes[i].surface.mesh.triangles});
  }
  const Alignment in_line;
  // The first shape is flat between its own edges; what the others have there is looked after.
  std::vector<sphere_map::EdgeError::Shape> missed;
  std::size_t vertices = shapes[0].directions.size();
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    missed.push_back({shapes[i].locator.get(), shapes[i].surface.mesh.positions, &in_line});
    vertices += shapes[i].directions.size();
  }
  constexpr std::size_t most_growth = 3;
  const sphere_map::Refinement refinement{sphere_map::EdgeError(missed, options.tolerance / 100),
                                          most_growth * vertices};
  sphere_map::Overlay made = sphere_map::overlay({shapes[0].directions, shapes[0].surface.mesh.triangles}, others, host,
                                                 options.tolerance > 0 ? &refinement : nullptr);
  CommonMesh common(host.memory);
  common.directions = std::move(made.directions);
  common.triangles = std::move(made.triangles);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    base::Array<Index>& own = common.own_vertex.emplace_back(common.directions.size(), mesh::no_index, host.memory);
    for (Index v = 0; v < shapes[i].directions.size(); ++v) {
      const Index place = i == 0 ? v : made.vertex_of[i - 1][v];
      if (place != mesh::no_index) own[place] = v;
    }
  }
  session.figures()["edges_of_others"] = made.edges_of_others;
  session.figures()["edges_kept"] = made.edges_present;
  return common;
}

CommonMesh common_mesh(const MorphOptions& options, const std::deque<MorphShape>& shapes, Session& session) {
  if (options.grid == "both") return overlay_of(options, shapes, session);
  const base::Host& host = session.host();
  CommonMesh common(host.memory);
  if (options.grid == "first") {
    common.directions = shapes[0].directions;
    common.triangles = shapes[0].surface.mesh.triangles;
  } else {
    const GridChoice choice = grid_choice(options.grid, "--grid");
    sphere_map::Grid grid = sphere_map::make_grid(choice.kind, choice.resolution, host);
    common.directions = std::move(grid.directions);
    common.triangles = std::move(grid.triangles);
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    base::Array<Index>& own = common.own_vertex.emplace_back(common.directions.size(), mesh::no_index, host.memory);
    for (Index v = 0; options.grid == "first" && i == 0 && v < own.size(); ++v)
      own[v] = v;
  }
  return common;
}

// How much areas change from one state to another, both scaled to the same whole: the root mean square of the logarithm
// of the ratio, by the area of the first.
double area_distortion(std::span<const Triangle> triangles, std::span<const Vector3> from,
                       std::span<const Vector3> to) {
  const auto area = [&](std::span<const Vector3> x, const Triangle& t) {
    return 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
  };
  base::CompensatedSum from_area, to_area, squares;
  for (const Triangle& t : triangles) {
    from_area.add(area(from, t));
    to_area.add(area(to, t));
  }
  for (const Triangle& t : triangles) {
    const double a = area(from, t) / from_area.value();
    const double b = area(to, t) / to_area.value();
    if (a > 0 && b > 0) squares.add(a * std::log(b / a) * std::log(b / a));
  }
  return std::sqrt(squares.value());
}

void morph(const MorphOptions& options, Session& session) {
  session.options() = {{"output", options.output},
                       {"landmarks", options.landmarks},
                       {"align", options.align},
                       {"place", options.place},
                       {"grid", options.grid},
                       {"tolerance", options.tolerance},
                       {"steps", options.steps},
                       {"seconds", options.seconds},
                       {"weld", options.weld},
                       {"polycube", options.polycube},
                       {"show_polycube", options.show_polycube}};
  require_writable(options.output);
  if (!is_gltf(options.output))
    throw Failure(Exit::wrong_input, options.output, "unsupported-format", "morph targets need .glb or .gltf");
#ifdef ORBICUBE_WITH_POLYCUBE
  if (options.polycube) {
    morph_by_polycube({options.inputs, options.output, options.landmarks, options.grid, options.place, options.corners,
                       options.steps, options.seconds, options.weld, options.show_polycube},
                      session);
    return;
  }
#endif
  if (options.grid != "both" && options.grid != "first") grid_choice(options.grid, "--grid");
  const base::Host& host = session.host();
  std::deque<MorphShape> shapes;
  for (const std::string& path : options.inputs) {
    shapes.emplace_back(host.memory).path = path;
    read_and_map(shapes.back(), options, session);
  }
  if (!options.landmarks.empty()) {
    align_by_landmarks(shapes, options.landmarks, session);
  } else if (options.align == "rotation") {
    align_by_rotation(shapes, session);
  }

  const CommonMesh common = common_mesh(options, shapes, session);
  std::vector<base::Array<Vector3>> states;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    MorphShape& shape = shapes[i];
    sphere_map::CarriedShape carried =
        sphere_map::carry_over(*shape.locator, shape.surface.mesh.positions, Alignment(), common.directions,
                               common.triangles, common.own_vertex[i], host);
    mesh::Mesh state(host.memory);
    state.positions = carried.positions;
    state.triangles = common.triangles;
    shape.figures["turned_over"] = carried.turned_over;
    shape.figures["distance"] = json_of_distance(shape.surface.mesh, state, host);
    states.push_back(std::move(carried.positions));
    if (i > 0) shape.figures["area_distortion"] = area_distortion(common.triangles, states[0], states[i]);
  }
  std::vector<Json*> figures;
  for (MorphShape& shape : shapes)
    figures.push_back(&shape.figures);
  place(options.place, common.triangles, states, figures);
  MorphStates morph{options.output, {}, common.triangles, states, options.seconds, options.steps};
  for (const MorphShape& shape : shapes)
    morph.names.push_back(std::filesystem::path(shape.path).stem().string());
  write_morph(morph, session);

  session.figures()["output"] = options.output;
  session.figures()["vertices"] = common.directions.size();
  session.figures()["triangles"] = common.triangles.size();
  session.figures()["shapes"] = Json::array();
  session.say("wrote " + options.output + ": " + std::to_string(shapes.size()) + " shapes on " +
              std::to_string(common.directions.size()) + " vertices and " + std::to_string(common.triangles.size()) +
              " triangles");
  for (const MorphShape& shape : shapes) {
    session.figures()["shapes"].push_back(shape.figures);
    const Json& distance = shape.figures["distance"];
    session.say("  " + shape.path + ": at most " +
                number(100 * distance["from_surface"]["max_of_diagonal"].get<double>()) + " % of its diagonal is lost" +
                (shape.figures.contains("landmarks")
                     ? "; landmarks apart by " +
                           number(shape.figures["landmarks"]["angle_rotated"]["max"].get<double>()) +
                           " rad at most after turning, by " +
                           number(shape.figures["landmarks"]["angle"]["max"].get<double>()) + " after bending"
                     : ""));
    if (const auto over = shape.figures["turned_over"].get<std::size_t>(); over > 0)
      session.note(shape.path + ": " + std::to_string(over) +
                   " triangles of the mesh are turned over or flat on its sphere");
  }
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

}  // namespace

void add_morph(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("morph", "blend shapes into each other, as morph targets of one mesh");
  const auto options = std::make_shared<MorphOptions>();
  verb->add_option("SHAPES", options->inputs,
                   std::string("two closed surfaces without handles or more: ") + surface_endings)
      ->required()
      ->expected(2, 100)
      ->type_name("A B ...");
  verb->add_option("-o,--output", options->output,
                   "mesh to write, .glb or .gltf: the first shape, the others as targets")
      ->required()
      ->type_name("OUT");
#ifdef ORBICUBE_WITH_POLYCUBE
  CLI::Option* polycube =
      verb->add_flag("--polycube", options->polycube,
                     "through one polycube rather than spheres: two to ten shapes of any genus, the "
                     "same for all; --grid is first or cells:N (as many as the shapes have)");
  verb->add_flag("--show-polycube", options->show_polycube,
                 "the polycube itself is a target, too: the first shape becomes it, then it becomes the next")
      ->needs(polycube);
  verb->add_option("--corners", options->corners, "corners of that polycube at most; 0: any number (0)")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->needs(polycube)
      ->type_name("N");
#endif
  verb->add_option("--landmarks", options->landmarks,
                   "points that belong together: a line each, with a vertex number (from 0) or x y z for each shape")
      ->type_name("FILE");
  verb->add_option("--align", options->align,
                   "how spheres are turned without landmarks (rotation): rotation, to where positions agree best; none")
      ->check(unnamed(CLI::IsMember({"rotation", "none"})))
      ->type_name("HOW");
  verb->add_option("--place", options->place, placement_help)
      ->check(unnamed(CLI::IsMember({"kept", "turned", "scaled"})))
      ->type_name("HOW");
  verb->add_option("--grid", options->grid,
                   std::string("the one mesh (both): both, with the vertices of all shapes; first, with those of the "
                               "first; or ") +
                       grid_help)
      ->type_name("GRID");
  verb->add_option("--tolerance", options->tolerance,
                   "of --grid both: edges are halved where they miss more of a shape, in percent of its diagonal (0.2; "
                   "0: never)")
      ->check(unnamed(CLI::NonNegativeNumber))
      ->type_name("P");
  verb->add_option("--steps", options->steps, "write so many shapes in between as well, to OUT-01 and so on")
      ->check(unnamed(CLI::Range(0, 10000)))
      ->type_name("N");
  verb->add_option("--seconds", options->seconds, "of the animation, from one shape to the next (2)")
      ->check(unnamed(CLI::PositiveNumber))
      ->type_name("S");
  verb->add_flag("--weld", options->weld, "join vertices at identical positions where a surface is not closed");
  add_common_options(*verb, common);
  verb->footer(
      "Each shape is mapped to the sphere, and the spheres are turned until positions agree best (shapes should\n"
      "then stand alike), or until landmarks meet; what is then at one direction corresponds. Shapes of other\n"
      "sizes or other axes: --landmarks FILE --place scaled.");
  verb->callback([options, &common] {
    Session session(common, "morph", options->inputs.front());
    session.run([&] { morph(*options, session); });
  });
}

}  // namespace orbicube::cli
