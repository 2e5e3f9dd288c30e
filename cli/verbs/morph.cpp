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
#include "files/surface_file.h"
#include "mesh/search/measures.h"
#include "morphs/morph_alignment.h"
#include "morphs/morph_placement.h"
#include "morphs/morph_states.h"
#include "report/grid_choice.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "solids/kept_surface.h"
#include "sphere_map/correspondence/correspondence.h"
#include "sphere_map/correspondence/overlay.h"
#include "sphere_map/sphere_map.h"
#include "verbs/verbs.h"
#ifdef ORBICUBE_WITH_POLYCUBE
#include "morphs/morph_polycube.h"
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
  std::string align = "shape";
  std::string placement = "kept";
  double tolerance = 0.2;  // percent of the diagonal
  std::size_t intermediates = 0;
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

void read_and_map(MorphShape& shape, const MorphOptions& options, Keep keep, Session& session) {
  shape.surface = read_closed_surface(shape.path, options.weld, session, keep);
  const mesh::Mesh& mesh = shape.surface.mesh;
  require_ordinary_size(mesh, shape.path);
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

// Of vertices of triangles.
std::size_t used_count(const MorphShape& shape, const base::Host& host) {
  const mesh::Mesh& m = shape.surface.mesh;
  const base::Array<std::uint8_t> used = mesh::used_vertices(m.positions.size(), m.triangles, host.memory);
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

// Without the vertices of the shapes that are in no triangle.
void remove_unused(CommonMesh& common, const base::Host& host) {
  const base::Array<std::uint8_t> used = mesh::used_vertices(common.directions.size(), common.triangles, host.memory);
  base::Array<Index> number(used.size(), mesh::no_index, host.memory);
  Index count = 0;
  for (Index v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    number[v] = count;
    common.directions[count] = common.directions[v];
    for (base::Array<Index>& own : common.own_vertex)
      own[count] = own[v];
    ++count;
  }
  if (count == used.size()) return;
  common.directions.resize(count);
  for (base::Array<Index>& own : common.own_vertex)
    own.resize(count);
  for (Triangle& t : common.triangles) {
    for (Index& v : t)
      v = number[v];
  }
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
  std::size_t vertices = used_count(shapes[0], host);
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    missed.push_back({shapes[i].locator.get(), shapes[i].surface.mesh.positions, &in_line});
    vertices += used_count(shapes[i], host);
  }
  constexpr std::size_t max_growth = 3;
  const sphere_map::Refinement refinement{
      sphere_map::EdgeError(missed, options.tolerance / 100),
      max_growth * vertices + shapes[0].directions.size() - used_count(shapes[0], host)};
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

Json json_of(const MorphOptions& options) {
  return {{"output", options.output},
          {"landmarks", options.landmarks},
          {"align", options.align},
          {"placement", options.placement},
          {"grid", options.grid},
          {"tolerance", options.tolerance},
          {"intermediates", options.intermediates},
          {"seconds", options.seconds},
          {"weld", options.weld},
          {"polycube", options.polycube},
          {"show_polycube", options.show_polycube}};
}

std::deque<MorphShape> map_shapes(const MorphOptions& options, Session& session) {
  const base::Host& host = session.host();
  std::deque<MorphShape> shapes;
  for (const std::string& path : options.inputs) {
    const base::Stage stage(host, 0.8 / static_cast<double>(options.inputs.size() - shapes.size()));
    shapes.emplace_back(host.memory).path = path;
    read_and_map(shapes.back(), options, shapes.size() == 1 ? Keep::decoration : Keep::surface, session);
  }
  return shapes;
}

void align_shapes(std::deque<MorphShape>& shapes, const MorphOptions& options, Session& session) {
  if (!options.landmarks.empty()) {
    const base::Stage stage(session.host(), 0.5);
    align_by_landmarks(shapes, options.landmarks, session);
  } else if (options.align != "none") {
    align_by_correlation(shapes, options.align == "shape", session);
    if (options.placement == "kept") note_turned(shapes, session);
  }
  session.figures()["alignment"] = options.landmarks.empty() ? options.align : "landmarks";
}

// The common mesh on each shape; its triangles on the first one go to `on_first` where that is kept.
std::vector<base::Array<Vector3>> carry_to_shapes(std::deque<MorphShape>& shapes, const CommonMesh& common,
                                                  base::Array<gltf::KeptTriangle>& on_first, const base::Host& host) {
  std::vector<base::Array<Vector3>> states;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    MorphShape& shape = shapes[i];
    const base::Stage stage(host, 1.0 / static_cast<double>(shapes.size() + 1 - i));
    sphere_map::CarriedShape carried =
        sphere_map::carry_over(*shape.locator, shape.surface.mesh.positions, Alignment(), common.directions,
                               common.triangles, common.own_vertex[i], host);
    mesh::Mesh state(host.memory);
    state.positions = carried.positions;
    state.triangles = common.triangles;
    shape.figures["flipped"] = carried.flipped;
    shape.figures["distance"] = json_of_distance(shape.surface.mesh, state, host);
    states.push_back(std::move(carried.positions));
    if (i == 0 && shape.surface.kept)
      on_first = kept_triangles(*shape.locator, carried.directions, common.triangles, host);
    if (i > 0) shape.figures["area_distortion"] = area_distortion(common.triangles, states[0], states[i]);
  }
  return states;
}

void write_states(const std::deque<MorphShape>& shapes, const CommonMesh& common,
                  const std::vector<base::Array<Vector3>>& states, const base::Array<gltf::KeptTriangle>& on_first,
                  const MorphOptions& options, Session& session) {
  MorphStates morph{options.output, {}, common.triangles, states, options.seconds, options.intermediates};
  if (shapes[0].surface.kept) {
    morph.kept = shapes[0].surface.kept.get();
    morph.kept_surface = shapes[0].surface.mesh.triangles;
    morph.kept_triangles = on_first;
  }
  for (const MorphShape& shape : shapes)
    morph.names.push_back(std::filesystem::path(shape.path).stem().string());
  write_morph(morph, session);
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
  session.say("wrote " + output + ": " + std::to_string(shapes.size()) + " shapes on " +
              std::to_string(common.directions.size()) + " vertices and " + std::to_string(common.triangles.size()) +
              " triangles");
  for (const MorphShape& shape : shapes) {
    session.figures()["shapes"].push_back(shape.figures);
    const double lost = shape.figures["distance"]["from_surface"]["max_of_diagonal"].get<double>();
    session.say("  " + shape.path + ": at most " + number(100 * lost) + " % of its diagonal is lost" +
                text_of_landmarks(shape.figures));
    if (const auto over = shape.figures["flipped"].get<std::size_t>(); over > 0)
      session.note(shape.path + ": " + std::to_string(over) +
                   " triangles of the mesh are flipped or flat on its sphere");
  }
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void morph(const MorphOptions& options, Session& session) {
  session.options() = json_of(options);
  require_writable(options.output);
  if (!is_gltf(options.output))
    throw Failure(Exit::wrong_input, options.output, "unsupported-format", "morph targets need one of " + gltf_endings);
#ifdef ORBICUBE_WITH_POLYCUBE
  if (options.polycube) {
    morph_by_polycube({options.inputs, options.output, options.landmarks, options.grid, options.placement,
                       options.corners, options.intermediates, options.seconds, options.weld, options.show_polycube},
                      session);
    return;
  }
#endif
  if (options.grid != "both" && options.grid != "first") grid_choice(options.grid, "--grid");
  const base::Host& host = session.host();
  std::deque<MorphShape> shapes = map_shapes(options, session);
  align_shapes(shapes, options, session);
  CommonMesh common = common_mesh(options, shapes, session);
  remove_unused(common, host);
  base::Array<gltf::KeptTriangle> on_first(host.memory);
  std::vector<base::Array<Vector3>> states = carry_to_shapes(shapes, common, on_first, host);
  std::vector<Json*> figures;
  for (MorphShape& shape : shapes)
    figures.push_back(&shape.figures);
  place(options.placement, common.triangles, states, figures);
  write_states(shapes, common, states, on_first, options, session);
  report_shapes(shapes, common, options.output, session);
}

#ifdef ORBICUBE_WITH_POLYCUBE
void add_polycube_options(CLI::App& verb, MorphOptions& options) {
  CLI::Option* polycube = verb.add_flag("--polycube", options.polycube,
                                        "use one polycube in place of spheres, for two to ten shapes of any one "
                                        "genus; --grid is first or cells:N [default: the maximum triangle count]");
  verb.add_flag("--show-polycube", options.show_polycube, "add the polycube as a target between consecutive shapes")
      ->needs(polycube);
  verb.add_option("--corners", options.corners, "maximum number of polycube corners; 0: no limit [default: 0]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->needs(polycube)
      ->type_name("N");
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
                   "mesh to write: " + gltf_endings + "; the first shape, the others as targets")
      ->required()
      ->type_name("OUT");
#ifdef ORBICUBE_WITH_POLYCUBE
  add_polycube_options(*verb, *options);
#endif
  verb->add_option("--landmarks", options->landmarks,
                   "corresponding points: one line each, with a vertex number (from 0) or x y z for each shape")
      ->type_name("FILE");
  verb->add_option("--align", options->align,
                   "rotation of the spheres without landmarks: shape, to maximum correlation for any poses of the "
                   "shapes; rotation, the same for equal poses; none [default: shape]")
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
      ->check(unnamed(CLI::NonNegativeNumber))
      ->type_name("P");
  verb->add_option("--intermediates", options->intermediates,
                   "also write N intermediate shapes between consecutive ones, to OUT-01 and so on")
      ->check(unnamed(CLI::Range(0, 10000)))
      ->type_name("N");
  verb->add_option("--seconds", options->seconds,
                   "duration of the animation from one shape to the next, in seconds [default: 2]")
      ->check(unnamed(CLI::PositiveNumber))
      ->type_name("S");
  verb->add_flag("--weld", options->weld, "weld vertices at identical positions where a surface is not closed");
  add_common_options(*verb, common);
  verb->footer(
      "Each shape is mapped to the sphere. The spheres are rotated to maximum correlation, or until landmarks "
      "coincide; points\nat one direction correspond. For shapes with other sizes or axes, --placement scaled aligns "
      "them "
      "with the first one.\nFor example:\n  orbicube morph a.obj b.obj -o ab.glb --placement turned");
  verb->callback([options, &common] {
    Session session(common, "morph", options->inputs.front());
    session.run([&] { morph(*options, session); });
  });
}

}  // namespace orbicube::cli
