// orbicube polycube: a polycube of a closed surface and a certified map to it.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "files/exact_file.h"
#include "files/given_polycube_file.h"
#include "files/surface_file.h"
#include "mesh/topology/degenerate_triangles.h"
#include "polycube/corners/optimal_corners.h"
#include "polycube/domain/optimal_domain.h"
#include "polycube/layout/drawn_construction.h"
#include "polycube/map/construction.h"
#include "report/degenerate_note.h"
#include "report/polycube_methods.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "session/unused_options.h"
#include "solids/any_genus_surface.h"
#include "solids/repaired_surface.h"
#include "textures/baked_texture.h"
#include "verbs/polycube_options.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

// Optimizes the proportions of the polycube.
base::Array<double> optimize_domain(const PolycubeOptions& options, polycube::Construction& made, Session& session) {
  const double start = session.seconds();
  polycube::OptimalDomain found = polycube::optimize_domain(
      made.map, {.measure = measure_of(options.measure), .area_weight = options.area_weight}, session.host());
  session.figures()["domain"] = {{"distortion_before", distortion_figures(made.distortion)},
                                 {"energies", found.energies},
                                 {"evaluations", found.evaluations},
                                 {"converged", found.converged},
                                 {"layers", found.layers},
                                 {"cells", found.cells},
                                 {"triangles_across_layers", found.crossing},
                                 {"seconds", session.seconds() - start}};
  made.certificate = std::move(found.certificate);
  made.distortion = found.distortion;
  return std::move(found.energies);
}

// The best of our own polycubes, or the one that is given.
polycube::BestConstruction construct(const PolycubeOptions& options, const mesh::Mesh& input, Session& session) {
  if (options.from.empty()) {
    polycube::ConstructionOptions construction{.method = polycube_method_named(options.construct),
                                               .corners = options.corners,
                                               .seed = session.seed(),
                                               .area_weight = options.area_weight};
    if (options.rounds >= 0) construction.rounds = options.rounds;
    return about(options.input, Role::input,
                 [&] { return polycube::construct(input.positions, input.triangles, construction, session.host()); });
  }
  const GivenPolycube given = read_given_polycube(options.from, session);
  std::vector<polycube::CornerPlace> places;
  if (!options.constraints.empty()) places = read_corner_places(options.constraints, given, session.host());
  session.figures()["from"] = {{"file", options.from},
                               {"corners", given.target.graph.corners.size()},
                               {"genus", given.target.genus},
                               {"constraints", places.size()}};
  return about(options.input, Role::input, [&] {
    return polycube::BestConstruction{
        polycube::construct_on(input.positions, input.triangles, given.target.graph, given.target.genus,
                               {.places = places, .pose = given.pose}, session.host()),
        polycube::Method::automatic,
        {}};
  });
}

// The best positions of the corners on the surface, and with `all` the best proportions in turn.
base::Array<double> optimize_corners(const PolycubeOptions& options, polycube::Construction& made, Session& session) {
  const double start = session.seconds();
  polycube::CornerOptions corners;
  if (options.corner_search == "gradient") corners.method = polycube::CornerMethod::gradient;
  corners.area_weight = options.area_weight;
  corners.domain = options.optimize == "all";
  if (options.rounds >= 0) corners.rounds = options.rounds;
  polycube::OptimalCorners found = polycube::optimize_corners(made.map, corners, session.host());
  session.figures()["corner_optimization"] = {{"distortion_before", distortion_figures(made.distortion)},
                                              {"energies", found.energies},
                                              {"evaluations", found.evaluations},
                                              {"map_evaluations", found.map_evaluations},
                                              {"moves", found.moves},
                                              {"movable", found.movable},
                                              {"converged", found.converged},
                                              {"seconds", session.seconds() - start}};
  std::string line = "energy after each step:";
  for (const double energy : found.energies)
    line += " " + std::to_string(energy);
  session.say(line);
  made.certificate = std::move(found.certificate);
  made.distortion = found.distortion;
  return std::move(found.energies);
}

Json json_of(const PolycubeOptions& options) {
  Json result = {{"output", options.output},
                 {"surface", options.surface},
                 {"construct", options.construct},
                 {"corners", options.corners},
                 {"text", options.text},
                 {"weld", options.mending.weld},
                 {"repair", options.mending.repair},
                 {"from", options.from},
                 {"constraints", options.constraints},
                 {"optimize", options.optimize},
                 {"targets", options.targets.empty() ? Json("") : Json(options.targets.front())},
                 {"feature_angle", options.feature_angle}};
  if (!options.optimize.empty() || options.construct == "dissertation")
    result.update(Json{
        {"measure", options.measure}, {"area_weight", options.area_weight}, {"corner_search", options.corner_search}});
  if (options.rounds >= 0) result["rounds"] = options.rounds;
  return result;
}

AnyGenusSurface read_surface(const PolycubeOptions& options, Session& session) {
  AnyGenusSurface surface =
      session.portion(0.03, [&] { return read_any_genus_surface(options.input, options.mending, session); });
  const mesh::Mesh& input = surface.mesh;
  session.figures()["input"] = surface.figures;
  const PolycubeOutputs& more = options.outputs;
  if (!(more.quads.empty() && more.glb.empty() && more.page.empty() && options.from.empty()))
    require_ordinary_size(input, options.input);
  note_degenerate(mesh::count_degenerate(input.positions, input.triangles), session);
  require_float_range(options.outputs.glb, input.positions, input.triangles);
  return surface;
}

void say_polycube(const PolycubeOptions& options, const polycube::BestConstruction& best, std::size_t added,
                  Session& session) {
  const polycube::Construction& made = best.made;
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  const auto& is = made.certificate;
  session.say("wrote " + options.output + ": a polycube with " + base::counted(is.corners, "corner") + " and " +
              base::counted(is.patch_count, "face") + ", genus " + std::to_string(is.genus) + "; " +
              base::counted(added, "vertex was", "vertices were") + " added");
  if (options.from.empty())
    session.say("  constructed by " + polycube_method_name(best.method) + ", " +
                base::counted(made.valid, "valid map") + " in " + base::counted(made.tried, "attempt"));
  session.say("  mean distortion of angles " + std::to_string(made.distortion.angle_weighted_mean) + ", of areas " +
              std::to_string(made.distortion.area_weighted_mean) + " (over the surface; 1: none)");
  if (!options.surface.empty()) session.say("wrote " + options.surface);
}

// Optimizes as the options request; returns the energies on the way.
base::Array<double> optimize(const PolycubeOptions& options, polycube::Construction& made, Session& session) {
  base::Array<double> energies(session.host().memory);
  if (!options.optimize.empty()) {
    const base::Stage stage(session.host(), 0.8);
    energies = options.optimize == "domain" ? optimize_domain(options, made, session)
                                            : optimize_corners(options, made, session);
  }
  const std::string targets = options.targets.empty() ? "" : options.targets.front();
  if (!targets.empty() || options.feature_angle > 0)
    align_features(options.input, targets, options.feature_angle, made.map, made.certificate, made.distortion,
                   session.figures(), session);
  return energies;
}

void polycube(const PolycubeOptions& options, Session& session) {
  require_exact_output(options.output);
  if (!options.surface.empty()) require_exact_output(options.surface);
  session.options() = json_of(options);
  if (options.targets.size() > 1) session.options()["targets"] = options.targets;
  check_polycube_outputs(options.outputs, session);
  if (options.outputs.texture)
    for (const std::string& input : options.inputs)
      require_colored(input);
  if (options.inputs.size() == 1 && options.targets.size() > 1)
    throw Failure(Exit::wrong_input, "", "usage", "--targets: one file for one surface");
  if (options.inputs.size() > 1) return share_one_polycube(options, session);
  const AnyGenusSurface surface = read_surface(options, session);
  const double start = session.seconds();
  const double part = options.optimize.empty() ? 0.9 : 0.5;
  polycube::BestConstruction best = session.portion(part, [&] { return construct(options, surface.mesh, session); });
  polycube::Construction& made = best.made;
  const double constructed = session.seconds();
  const base::Array<double> energies = optimize(options, made, session);
  const double optimized = session.seconds();
  const polycube::SurfaceMap& map = made.map;
  write_exactly(options.output, map.polycube, map.triangles, options.text, session);
  if (!options.surface.empty()) write_exactly(options.surface, map.positions, map.triangles, options.text, session);

  const std::size_t added = map.positions.size() - surface.mesh.positions.size();
  session.figures().update(Json{{"vertices", map.positions.size()},
                                {"vertices_added", added},
                                {"triangles", map.triangles.size()},
                                {"corners", made.certificate.corners},
                                {"patches", made.certificate.patch_count},
                                {"genus", made.certificate.genus},
                                {"distortion", distortion_figures(made.distortion)},
                                {"construction", polycube_method_name(best.method)},
                                {"polycubes_tried", made.tried},
                                {"polycubes_valid", made.valid},
                                {"seconds_construct", constructed - start},
                                {"seconds_write", session.seconds() - optimized}});
  say_polycube(options, best, added, session);
  report_corner_points(best, session);
  write_polycube_outputs(options.outputs,
                         {options.input, map, made.certificate.genus, made.certificate.corners,
                          made.certificate.patch_count, made.distortion, energies},
                         session.figures(), session);
}

void add_construction_options(CLI::App& verb, PolycubeOptions& options) {
  CLI::Option* construct =
      verb.add_option(
              "--construct,--method", options.construct,
              "construction: labels, voxels (grid-based), auto, the better of both, or dissertation: the method "
              "of its chapter 4, with up to 60 corner points unless --corners is given [default: auto]")
          ->check(unnamed(CLI::IsMember({"auto", "labels", "voxels", "dissertation"})))
          ->type_name("METHOD");
  CLI::Option* corners =
      verb.add_option("--corners", options.corners, "maximum number of polycube corners; 0: no limit [default: 0]")
          ->check(unnamed(CLI::Range(0, 1'000'000)))
          ->type_name("N");
  CLI::Option* from = verb.add_option("--from", options.from, "map to this polycube: a .json of --domain, or a mesh")
                          ->excludes(construct)
                          ->excludes(corners)
                          ->type_name("POLYCUBE");
  verb.add_option("--constraints", options.constraints,
                  "positional constraints of the corners of that polycube on IN: JSON, [{\"corner\": 0, \"vertex\": "
                  "17}, ...] or \"point\": [x, y, z]")
      ->needs(from)
      ->type_name("FILE");
}

void add_optimization_options(CLI::App& verb, PolycubeOptions& options) {
  verb.add_option("--optimize", options.optimize,
                  "optimize domain, the proportions of the polycube; corners, their positions on the surface; or all, "
                  "both in turn")
      ->check(unnamed(CLI::IsMember({"domain", "corners", "all"})))
      ->type_name("WHAT");
  verb.add_option("--corner-search", options.corner_search,
                  "corner search: trust-region, derivative-free, or gradient, which needs fewer evaluations [default: "
                  "trust-region]")
      ->check(unnamed(CLI::IsMember({"trust-region", "gradient"})))
      ->type_name("METHOD");
  verb.add_option("--rounds", options.rounds,
                  "maximum number of rounds that optimize proportions and corners in turn: of --method dissertation, "
                  "where 0 is the initial map [default: 40], and of --optimize corners and all [default: 6]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
  verb.add_option("--measure", options.measure,
                  "distortion that domain minimizes: mean over surface or faces, or harmonic [default: surface]")
      ->check(unnamed(CLI::IsMember({"surface", "faces", "harmonic"})))
      ->type_name("MEAN");
  verb.add_option("--area-weight", options.area_weight, "weight of area relative to angle distortion [default: 1]")
      ->check(non_negative_number())
      ->type_name("W");
  verb.add_option(
          "--targets", options.targets,
          "target positions of vertices and curves on the polycube: JSON, {\"points\": [{\"vertex\": 17, "
          "\"target\": [x, y, z]}, ...], \"curves\": [{\"vertices\": [...], \"from\": [x, y, z], \"to\": [x, "
          "y, z]}, ...]}; with a \"weight\" approximately. Of several surfaces one each, in their order; none for "
          "no file")
      ->allow_extra_args(false)
      ->type_name("FILE");
  verb.add_option("--feature-angle", options.feature_angle,
                  "minimum dihedral angle, in degrees, of surface edges that are aligned to nearby polycube edges; 0: "
                  "none [default: 0]")
      ->check(number_from_to(0, 179))
      ->type_name("DEGREES");
}

}  // namespace

void add_polycube(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("polycube", "compute a polycube of a closed surface and a certified map to it");
  const auto options = std::make_shared<PolycubeOptions>();
  verb->add_option("IN", options->inputs,
                   std::string("closed surface, or up to ten for one common polycube: ") + surface_endings)
      ->required()
      ->expected(1, 10)
      ->type_name("");
  verb->add_option("-o,--output", options->output, "the triangles of the surface on the polycube: " + polygon_endings)
      ->required()
      ->type_name("OUT");
  verb->add_option("--surface", options->surface, "the surface in space with the vertices and triangles of OUT")
      ->type_name("OUT2");
  add_construction_options(*verb, *options);
  add_optimization_options(*verb, *options);
  verb->add_option("--landmarks", options->landmarks,
                   "corresponding points of several surfaces: one line each, with a vertex number (from 0) or x y z "
                   "for each surface")
      ->type_name("FILE");
  add_polycube_outputs(*verb, options->outputs);
  add_text_option(*verb, options->text);
  add_mending_options(*verb, options->mending);
  add_common_options(*verb, common);
  verb->footer(
      "Every written map is certified by exact arithmetic; if none is found, the exit code is 1. The vertices of the "
      "surface\ncome first in OUT, in their order; edges are split where required. For several surfaces the outputs "
      "are numbered:\nOUT-1, OUT-2.");
  verb->callback([options, verb, &common] {
    options->input = options->inputs.front();
    Session session(common, "polycube", options->input);
    session.run([&] {
      refuse_unused_polycube_options(*verb);
      polycube(*options, session);
    });
  });
}

}  // namespace orbicube::cli
