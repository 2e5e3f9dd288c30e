// orbicube frames: a smooth frame field on a mesh of tetrahedra, aligned with its boundary.
#include "frame_field/frame_field.h"

#include <algorithm>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "frame_field/frames_file.h"
#include "mesh/files/file.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/cells.h"
#include "report/frame_figures.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "scenes/angle_plot.h"
#include "scenes/frame_scene.h"
#include "session/unused_options.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

using frame_field::Start;

const std::map<std::string, Start> starts = {{"auto", Start::automatic},
                                             {"identity", Start::identity},
                                             {"propagated", Start::propagated},
                                             {"harmonic", Start::harmonic},
                                             {"diffusion", Start::diffusion}};
const std::map<std::string, frame_field::Weighting> weightings = {{"uniform", frame_field::Weighting::uniform},
                                                                  {"geometric", frame_field::Weighting::geometric}};
const std::map<std::string, frame_field::Method> frame_methods = {{"smooth", frame_field::Method::smooth},
                                                                  {"dissertation", frame_field::Method::dissertation}};

struct FramesOptions {
  std::string input;
  std::string output;
  std::string start = "auto";
  std::string start_field;
  bool unchanged = false;
  std::string boundary;
  std::string method = "smooth";
  std::string weights = "uniform";
  double feature_angle = 0;  // degrees
  std::uint32_t rounds = frame_field::Options{}.rounds;
  bool free_boundary = false;
  bool locally_meshable = false;
  bool single_axis = false;
  std::string vtk;
  std::string plot;
  std::string glb;
  std::uint32_t crosses = 1000;
};

mesh::Mesh read_solid(const FramesOptions& options, Session& session) {
  InputMesh input = read_input(options.input, false, session);
  session.figures()["format"] = input.report.format;
  session.figures()["seconds_read"] = input.seconds;
  about(options.input, Role::input, [&] {
    if (input.mesh.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra; frames live on a mesh of them");
    mesh::require_valid_cells(input.mesh, session.host());
    if (!input.mesh.hexahedra.empty()) throw base::Error("unsupported", "hexahedra beside the tetrahedra");
  });
  return std::move(input.mesh);
}

// Frames of tetrahedra with a boundary face, from a file of all frames.
base::Array<frame_field::GivenFrame> boundary_frames(const mesh::Mesh& solid, const frame_field::Field& field,
                                                     const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  base::Array<frame_field::GivenFrame> result(host.memory);
  for (mesh::Index t = 0; t < field.size(); ++t) {
    bool outer = false;
    for (mesh::Index k = 0; k < 4; ++k)
      outer = outer || connectivity.on_boundary(4 * t + k);
    if (outer) result.push_back({t, field[t]});
  }
  return result;
}

frame_field::Outcome compute(const FramesOptions& options, const mesh::Mesh& solid, const base::Host& host) {
  const auto read = [&](const std::string& path) {
    return about(path, Role::input, [&] { return frame_field::read_frames(path, solid.tetrahedra.size(), host); });
  };
  frame_field::Field start(host.memory);
  base::Array<frame_field::GivenFrame> held(host.memory);
  if (!options.start_field.empty()) start = read(options.start_field);
  if (options.unchanged) {
    frame_field::Outcome outcome(host.memory);
    outcome.field = std::move(start);
    outcome.start = Start::given;
    return outcome;
  }
  if (!options.boundary.empty()) held = boundary_frames(solid, read(options.boundary), host);
  frame_field::Options settings;
  settings.start = options.start_field.empty() ? starts.at(options.start) : Start::given;
  settings.method = frame_methods.at(options.method);
  settings.weighting = weightings.at(options.weights);
  settings.align_boundary = !options.free_boundary;
  settings.feature_angle = options.feature_angle * std::numbers::pi / 180;
  settings.rounds = options.rounds;
  settings.repairs = options.single_axis        ? frame_field::Repairs::single_axis
                     : options.locally_meshable ? frame_field::Repairs::places
                                                : frame_field::Repairs::none;
  return about(options.input, Role::input, [&] {
    return frame_field::compute(solid.positions, solid.tetrahedra, settings,
                                {.frames = held, .axes = {}, .start = start}, host);
  });
}

void write(const FramesOptions& options, const mesh::Mesh& solid, int exponent, const frame_field::Field& field,
           Session& session) {
  const base::Host& host = session.host();
  about(options.output, Role::output, [&] {
    const std::filesystem::path file = session.stage(options.output);
    frame_field::write_frames(file, field, host);
    const frame_field::Field read = frame_field::read_frames(file, field.size(), host);
    for (std::size_t t = 0; t < field.size(); ++t) {
      // Reading makes lengths 1 again, which may move the last bit.
      if (!(std::abs(quaternion::dot(read[t], field[t]) - 1) < 1e-15 * 8))
        throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
    }
  });
  if (options.vtk.empty()) return;
  base::Array<mesh::Vector3> positions(solid.positions, host.memory);
  mesh::scale_by_power(positions, -exponent);
  about(options.vtk, Role::output,
        [&] { frame_field::write_vtk(session.stage(options.vtk), positions, solid.tetrahedra, field, host); });
}

Json json_of(const FramesOptions& options) {
  return {{"output", options.output},
          {"start", options.start},
          {"start_field", options.start_field},
          {"unchanged", options.unchanged},
          {"boundary", options.boundary},
          {"method", options.method},
          {"face_weights", options.weights},
          {"feature_angle", options.feature_angle},
          {"rounds", options.rounds},
          {"align_boundary", !options.free_boundary},
          {"locally_meshable", options.locally_meshable},
          {"single_axis", options.single_axis},
          {"vtk", options.vtk},
          {"plot", options.plot},
          {"glb", options.glb},
          {"crosses", options.crosses}};
}

void draw(const FramesOptions& options, const mesh::Mesh& solid, const mesh::TetrahedralConnectivity& connectivity,
          const frame_field::Field& field, const FieldFindings& found, Session& session) {
  const base::Host& host = session.host();
  if (!options.plot.empty()) {
    about(options.plot, Role::output, [&] {
      mesh::OutputFile file(session.stage(options.plot));
      file.write(std::span<const std::byte>(angle_plot(found.measurement.histogram, host)));
      file.commit();
    });
  }
  if (!options.glb.empty()) {
    about(options.glb, Role::output, [&] {
      write_scene(session.stage(options.glb), {solid, connectivity, field, found.graph, found.local}, options.crosses,
                  host);
    });
  }
}

void run_frames(const FramesOptions& options, Session& session) {
  session.options() = json_of(options);
  require_folder(options.output);
  for (const std::string& path : {options.vtk, options.plot, options.glb}) {
    if (!path.empty()) require_folder(path);
  }
  mesh::Mesh solid = session.portion(0.05, [&] { return read_solid(options, session); });
  // Frames know nothing of sizes.
  constexpr int ordinary = 100;
  const int exponent = mesh::bring_to_unit_size(solid, ordinary);
  if (exponent != 0 && !options.glb.empty())
    throw Failure(Exit::wrong_input, options.input, "unsupported",
                  "--glb is for solids of a size between 1e-30 and 1e30; scale it first");
  const base::Host& host = session.host();

  const double begin = session.seconds();
  const frame_field::Outcome outcome = session.portion(0.85, [&] { return compute(options, solid, host); });
  const double computed = session.seconds() - begin;
  const auto connectivity = about(options.input, Role::input, [&] {
    return mesh::TetrahedralConnectivity(solid.positions.size(), solid.tetrahedra, host);
  });
  const FieldFindings found(solid, connectivity, outcome.field, host);
  const double measured = session.seconds() - begin - computed;

  Json& figures = session.figures();
  figures.update({{"output", options.output},
                  {"vertices", solid.positions.size()},
                  {"tets", solid.tetrahedra.size()},
                  {"start", frame_field::start_name(outcome.start)}});
  figures.update(field_figures(solid, found, exponent));
  figures.update({{"smoothing_steps", outcome.smoothing_steps},
                  {"solver_iterations", outcome.solver_iterations},
                  {"seconds_compute", computed},
                  {"seconds_measure", measured}});
  const bool repairs = options.locally_meshable || options.single_axis;
  if (repairs) figures["repair"] = repair_figures(outcome.repair);
  about(options.output, Role::output, [&] {
    if (const std::size_t ends = found.graph.dead_ends.size(); ends > 0)
      throw base::Error("no-valid-result",
                        base::counted(ends, "singular curve ends", "singular curves end") + " inside");
  });
  write(options, solid, exponent, outcome.field, session);
  draw(options, solid, connectivity, outcome.field, found, session);
  figures["seconds_write"] = session.seconds() - begin - computed - measured;

  session.say(options.input + ": " + base::counted(solid.tetrahedra.size(), "frame") + " in " + number(computed) +
              " s, from the start " + frame_field::start_name(outcome.start));
  say_field(found, session);
  if (repairs) say_repair(outcome.repair, session);
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

template <class Value>
CLI::Validator one_of(const std::map<std::string, Value>& names) {
  std::vector<std::string> list;
  for (const auto& entry : names)
    list.push_back(entry.first);
  return unnamed(CLI::IsMember(list));
}

void add_drawings(CLI::App& verb, FramesOptions& options) {
  verb.add_option("--vtk", options.vtk, "also write the tetrahedra with the axes as vectors")->type_name("FILE.vtk");
  verb.add_option("--plot", options.plot, "draw the distribution of angles between neighbors")->type_name("FILE.png");
  CLI::Option* glb = verb.add_option("--glb", options.glb, "draw the singular curves in the surface, and some frames")
                         ->type_name("FILE.glb");
  verb.add_option("--crosses", options.crosses, "approximate number of frames in --glb [default: 1000]")
      ->needs(glb)
      ->check(unnamed(CLI::Range(0, 1000000)))
      ->type_name("N");
}

}  // namespace

void add_frames(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("frames", "compute a smooth frame field on a tetrahedral mesh");
  const auto options = std::make_shared<FramesOptions>();
  verb->add_option("TETS", options->input, "tetrahedra to read: " + cell_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output, "frames to write, one line w x y z for each tetrahedron")
      ->required()
      ->type_name("OUT.frames");
  CLI::Option* start =
      verb->add_option(
              "--start", options->start,
              "initial field: auto (default), the best of all; identity, the coordinate axes; propagated, the "
              "nearest boundary frame; harmonic, harmonics of degree 4; diffusion, these, diffused and projected")
          ->check(one_of(starts))
          ->type_name("START");
  CLI::Option* start_field = verb->add_option("--start-field", options->start_field, "smooth the field of this file")
                                 ->excludes(start)
                                 ->type_name("FILE.frames");
  verb->add_flag("--unchanged", options->unchanged, "only report and draw the field of --start-field")
      ->needs(start_field);
  verb->add_option("--boundary", options->boundary, "fix the frames of boundary tetrahedra to those of this file")
      ->type_name("FILE.frames");
  verb->add_option("--method", options->method,
                   "smooth, or dissertation: the method of the dissertation with fixed matchings [default: smooth]")
      ->check(one_of(frame_methods))
      ->type_name("METHOD");
  verb->add_option(
          "--face-weights", options->weights,
          "weights of inner faces: uniform, or geometric, area over distance of the centers [default: uniform]")
      ->check(one_of(weightings))
      ->type_name("WEIGHTS");
  verb->add_option("--feature-angle", options->feature_angle,
                   "minimum dihedral angle, in degrees, of boundary edges that an axis follows; 0: none [default: 0]")
      ->check(number_from_to(0, 180))
      ->type_name("DEGREES");
  verb->add_option("--rounds", options->rounds, "number of improvement rounds of --start auto [default: 2]")
      ->check(unnamed(CLI::Range(0, 1000)))
      ->type_name("N");
  verb->add_flag("--no-align-boundary", options->free_boundary, "do not align frames with the boundary");
  verb->add_flag("--locally-meshable", options->locally_meshable,
                 "change the field where no hexahedral mesh can follow it, at a small increase of the energy")
      ->excludes(verb->get_option("--unchanged"));
  verb->add_flag("--single-axis", options->single_axis,
                 "search only among fields that rotate about one axis along each curve, starting from identity")
      ->excludes(verb->get_option("--unchanged"));
  add_drawings(*verb, *options);
  add_common_options(*verb, common);
  verb->footer(
      "A frame is a unit quaternion that rotates the coordinate axes to its own (active, Hamilton's product). At "
      "the\nboundary one axis is along the normal; tetrahedra with several boundary faces are aligned with one of "
      "them,\nor with a direction between them or their common edge if no frame aligns with both.");
  verb->callback([options, verb, &common] {
    Session session(common, "frames", options->input);
    session.run([&] {
      refuse_unused_frames_options(*verb);
      run_frames(*options, session);
    });
  });
}

}  // namespace orbicube::cli
