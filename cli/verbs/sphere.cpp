// orbicube sphere: a closed surface of genus 0 mapped to the unit sphere, one to one, as it is in the file.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "files/surface_file.h"
#include "mesh/files/file.h"
#include "mesh/files/write.h"
#include "mesh/search/predicates.h"
#include "morphs/morph_sphere.h"
#include "report/degenerate_note.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "scenes/page_figures.h"
#include "session/unused_options.h"
#include "solids/closed_surface.h"
#include "solids/repaired_surface.h"
#include "sphere_map/optimization/measure.h"
#include "sphere_map/sampling/rounding.h"
#include "sphere_map/sphere_map.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

using Directions = base::Array<mesh::Vector3>;

const std::map<std::string, sphere_map::Method> map_methods = {
    {"balanced", sphere_map::Method::balanced},   {"angle-area", sphere_map::Method::angle_area},
    {"stretch", sphere_map::Method::stretch},     {"isometric", sphere_map::Method::isometric},
    {"conformal", sphere_map::Method::conformal}, {"dissertation", sphere_map::Method::dissertation},
    {"seed", sphere_map::Method::dissertation}};  // the name of other programs for it

struct SphereOptions {
  std::string input;
  std::string output;
  std::string method = "balanced";
  double angle_weight = sphere_map::Options{}.angle_weight;
  double area_weight = sphere_map::Options{}.area_weight;
  sphere_map::AlgorithmLimits limits;
  std::string page;
  bool text = false;
  Mending mending;
  bool keep_partial = false;
  SphereUses uses;
};

// Throws unless the file, read again, holds the map and every triangle of it is positive.
void check_mesh_file(const std::filesystem::path& path, const mesh::Mesh& written, const base::Host& host) {
  const mesh::Mesh read = mesh::read_mesh(path, {}, host);
  // STL has no vertices to compare, only triangles.
  const bool same = !mesh::holds(path, mesh::Holds::polygons)
                        ? read.triangles.size() == written.triangles.size()
                        : read.positions == written.positions && read.triangles == written.triangles;
  if (!same) throw base::Error("no-valid-result", "verification failed: the written file reads back differently");
  const std::size_t bad = sphere_map::count_not_positive(read.triangles, read.positions);
  if (bad > 0)
    throw base::Error(
        "no-valid-result",
        base::counted(bad, "triangle of the written map is", "triangles of the written map are") + " not positive");
}

// Writes the map beside its place and checks what is there. `directions` become those that the file holds.
void write_checked(const std::filesystem::path& path, const SphereOptions& options, const ClosedSurface& input,
                   Directions& directions, Session& session, const base::Host& host) {
  const mesh::Mesh& surface = input.mesh;
  if (is_gltf(path)) {
    MorphSphere map = round_to_morph_target(surface.positions, surface.triangles, directions, host);
    write_morph_sphere(path, map, surface.triangles, std::filesystem::path(options.output).stem().string(),
                       input.kept.get(), host);
    check_morph_sphere(path, map, surface.triangles, host);
    directions = std::move(map.directions);
    session.figures()["moved_by_rounding"] = map.moved;
    if (map.translation != mesh::Vector3::Zero())
      session.note("coordinates of the surface are relative to its bounding box, see the node");
    return;
  }
  if (!mesh::holds(path, mesh::Holds::polygons))
    directions = sphere_map::round_to_float(surface.triangles, directions, host);
  mesh::Mesh image(host.memory);
  image.positions = directions;
  image.triangles = surface.triangles;
  mesh::write_mesh(path, image, {.binary = !options.text}, host);
  check_mesh_file(path, image, host);
}

// Writes what there is of a map that could not be finished; returns what of it is valid.
std::string write_partial(const SphereOptions& options, const ClosedSurface& input, sphere_map::Partial& partial,
                          Session& session) {
  const mesh::Mesh& surface = input.mesh;
  if (partial.directions.empty()) return "there is nothing to keep yet";
  const base::Host host;  // the session's has had enough
  std::size_t positive = 0;
  std::size_t flipped = 0;
  for (const mesh::Triangle& t : surface.triangles) {
    const auto& [p, q, r] = std::tie(partial.directions[t[0]], partial.directions[t[1]], partial.directions[t[2]]);
    const int sign = mesh::orientation_from_origin(p, q, r);
    positive += sign > 0;
    flipped += sign < 0;
  }
  const bool whole = positive == surface.triangles.size();
  const std::string counted = std::to_string(positive) + " of " + std::to_string(surface.triangles.size());
  if (!whole && !mesh::holds(options.output, mesh::Holds::polygons)) {
    return "the partial map (" + counted + " triangles positive) is not kept: this format only holds whole maps";
  }
  try {
    const std::filesystem::path file = session.stage(options.output);
    if (whole) {
      write_checked(file, options, input, partial.directions, session, host);
    } else {
      mesh::Mesh image(host.memory);
      image.positions = partial.directions;
      image.triangles = surface.triangles;
      mesh::write_mesh(file, image, {.binary = !options.text}, host);
    }
    session.keep();
  } catch (const std::runtime_error& error) {  // base::Error, or Failure about the file
    return std::string("the partial map is not kept: ") + error.what();
  }
  session.figures()["partial"] = {{"output", options.output},
                                  {"vertices_placed", partial.placed},
                                  {"triangles_positive", positive},
                                  {"triangles_flipped", flipped},
                                  {"triangles", surface.triangles.size()}};
  if (whole) return "kept in " + options.output + ": a map that is one to one, but not optimized to the end";
  return "kept in " + options.output + ": a partial map, " + std::to_string(partial.placed) + " of " +
         base::counted(surface.positions.size(), "vertex", "vertices") + " placed, " + counted +
         " triangles positive, " + std::to_string(flipped) + " flipped, the others without area";
}

// Energy by iteration of the method `dissertation`, its Figure 3.2.
struct Convergence {
  std::vector<std::uint64_t> iterations, vertices;
  std::vector<double> energies;
  std::size_t restarts = 0;

  void add(const sphere_map::TracePoint& point) {
    if (!iterations.empty() && point.iterations < iterations.back()) *this = {{}, {}, {}, restarts + 1};
    iterations.push_back(point.iterations);
    vertices.push_back(point.vertices);
    energies.push_back(point.energy);
  }
  Json json() const {
    return {{"iterations", iterations}, {"vertices", vertices}, {"energies", energies}, {"restarts", restarts}};
  }
};

// The map, or its failure with a word on what was kept.
Directions compute(const SphereOptions& options, const ClosedSurface& input, Session& session) {
  const mesh::Mesh& surface = input.mesh;
  sphere_map::Partial partial(session.host().memory);
  Convergence convergence;
  try {
    Directions directions =
        sphere_map::compute(surface.positions, surface.triangles,
                            {.method = map_methods.at(options.method),
                             .angle_weight = options.angle_weight,
                             .area_weight = options.area_weight,
                             .seed = session.seed(),
                             .limits = options.limits,
                             .trace = [&](const sphere_map::TracePoint& point) { convergence.add(point); }},
                            session.host(), options.keep_partial ? &partial : nullptr);
    if (!convergence.iterations.empty()) session.figures()["convergence"] = convergence.json();
    return directions;
  } catch (const base::Error& error) {
    const bool unfinished =
        error.status() == base::Status::no_valid_result || error.status() == base::Status::cancelled;
    if (!options.keep_partial || !unfinished) throw;
    throw base::Error(error.kind(), error.what() + ("; " + write_partial(options, input, partial, session)));
  }
}

Json json_of(const sphere_map::Measurement& m) {
  return {{"bijective", m.bijective},
          {"flipped", m.flipped},
          {"degenerate", m.degenerate},
          {"degree", m.degree},
          {"radius_error", m.radius_error},
          {"energy", m.energy},
          {"energy_angle", m.energy_angle},
          {"energy_area", m.energy_area},
          {"max_quasi_conformal", m.max_quasi_conformal},
          {"mean_quasi_conformal", m.mean_quasi_conformal},
          {"min_area_ratio", m.min_area_ratio},
          {"max_area_ratio", m.max_area_ratio},
          {"stretch_efficiency", m.stretch_efficiency},
          {"isometric_mean", m.isometric_mean},
          {"equation_3_1", m.equation_3_1},
          {"equation_3_2", m.equation_3_2},
          {"equation_3_3", m.equation_3_3},
          {"equation_3_4", m.equation_3_4},
          {"zero_area_faces", m.zero_area_faces}};
}

Json json_of(const SphereOptions& options) {
  Json result = {{"output", options.output},
                 {"method", options.method},
                 {"angle_weight", options.angle_weight},
                 {"area_weight", options.area_weight},
                 {"page", options.page},
                 {"text", options.text},
                 {"weld", options.mending.weld},
                 {"repair", options.mending.repair},
                 {"keep_partial", options.keep_partial},
                 {"remesh", options.uses.remesh},
                 {"grid", options.uses.grid},
                 {"image", options.uses.image},
                 {"image_grid", options.uses.image_grid}};
  if (map_methods.at(options.method) == sphere_map::Method::dissertation) {
    result.update(Json{{"level_splits", options.limits.level_splits},
                       {"level_tolerance", options.limits.level_tolerance},
                       {"final_tolerance", options.limits.final_tolerance},
                       {"max_level_iterations", options.limits.max_level_iterations},
                       {"max_final_iterations", options.limits.max_final_iterations}});
  }
  return result;
}

void say_distortion(const sphere_map::Measurement& m, Session& session) {
  session.say("  energy " + number(m.energy) + " (angles " + number(m.energy_angle) + ", areas " +
              number(m.energy_area) + "), quasi-conformal distortion " + number(m.mean_quasi_conformal) +
              " on average and " + "maximum " + number(m.max_quasi_conformal) + ", stretch efficiency " +
              number(m.stretch_efficiency));
}

void sphere(const SphereOptions& options, Session& session) {
  require_writable(options.output);
  check_sphere_uses(options.uses);
  session.options() = json_of(options);
  const ClosedSurface input = session.portion(0.03, [&] {
    return read_closed_surface(options.input, options.mending, session, keep_for(options.output, Keep::decoration));
  });
  const mesh::Mesh& surface = input.mesh;
  session.figures().update(input.figures);
  const base::Host& host = session.host();
  require_float_range(options.output, surface.positions, surface.triangles);

  const double start = session.seconds();
  Directions directions = session.portion(
      0.9, [&] { return about(options.input, Role::input, [&] { return compute(options, input, session); }); });
  const double computed = session.seconds() - start;
  sphere_map::FaceDistortion faces(host.memory);
  sphere_map::Measurement m;
  // Who wants unfinished maps kept does not want to lose a finished one while it is checked.
  const base::Host unhurried;
  const base::Host& writing = options.keep_partial ? unhurried : host;
  about(options.output, Role::output, [&] {
    write_checked(session.stage(options.output), options, input, directions, session, writing);
    m = sphere_map::measure(surface.positions, surface.triangles, directions, options.angle_weight, options.area_weight,
                            writing, &faces);
    if (!m.bijective) throw base::Error("no-valid-result", "the map covers the sphere more than once");
  });
  const double written = session.seconds() - start - computed;

  note_degenerate(m.zero_area_faces, session);
  session.figures().update({{"output", options.output},
                            {"vertices", surface.positions.size()},
                            {"triangles", surface.triangles.size()},
                            {"method", options.method},
                            {"angle_weight", options.angle_weight},
                            {"area_weight", options.area_weight}});
  session.figures().update(json_of(m));
  session.figures().update({{"seconds_compute", computed}, {"seconds_write", written}});
  if (!options.page.empty()) {
    const std::string name = std::filesystem::path(options.input).filename().string();
    const PageResult result =
        page_result(name, surface, directions, m, faces, options.angle_weight, options.area_weight);
    write_page(options.page, {&result, 1}, "Sphere map of " + name, session);
  }

  session.say(options.input + ": " + base::counted(surface.triangles.size(), "triangle") + " mapped to the sphere in " +
              number(computed) + " s, one to one, checked exactly in " + options.output);
  say_distortion(m, session);
  write_sphere_uses(options.uses, surface, directions, session);
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

// Parameters of Algorithm 1.
void add_limits(CLI::App& verb, sphere_map::AlgorithmLimits& limits) {
  const std::string only = "; method dissertation only";
  verb.add_option("--level-splits", limits.level_splits,
                  "eta: vertex splits between two optimizations [default: 40]" + only)
      ->check(unnamed(CLI::Range(std::uint64_t{1}, sphere_map::max_level_splits)))
      ->type_name("N");
  verb.add_option("--level-tolerance", limits.level_tolerance,
                  "epsilon^eta: mean gain of an iteration, times the vertex count over the energy, that ends the "
                  "optimization of a level; 0: none [default: 1e-4]" +
                      only)
      ->check(non_negative_number())
      ->type_name("GAIN");
  verb.add_option("--final-tolerance", limits.final_tolerance,
                  "epsilon^F: the same for the final optimization [default: 1e-4]" + only)
      ->check(non_negative_number())
      ->type_name("GAIN");
  verb.add_option("--max-level-iterations", limits.max_level_iterations,
                  "Iter_max^eta: maximum number of iterations on a level; 0: 50 * eta [default: 0]" + only)
      ->type_name("N");
  verb.add_option("--max-final-iterations", limits.max_final_iterations,
                  "Iter_max^F: maximum number of final iterations; 0: 100 * vertex count [default: 0]" + only)
      ->type_name("N");
}

}  // namespace

void add_sphere(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("sphere", "map a closed genus-0 surface to the unit sphere bijectively");
  const auto options = std::make_shared<SphereOptions>();
  verb->add_option("IN", options->input, std::string("surface to read: ") + surface_endings)->required()->type_name("");
  verb->add_option("-o,--output", options->output,
                   "map to write: the same vertices and faces with unit vectors for positions; glTF (" + gltf_endings +
                       ") has the surface with the sphere as a morph target")
      ->required()
      ->type_name("OUT");
  std::vector<std::string> names;
  for (const auto& [name, method] : map_methods)
    names.push_back(name);
  verb->add_option("--method", options->method,
                   "balanced (default): angle and area distortion with a barrier on the worst triangle; angle-area: "
                   "the sum of the two energies; stretch: L2 stretch; isometric: symmetric Dirichlet energy; "
                   "conformal: angle distortion alone; dissertation: the method of the dissertation")
      ->check(unnamed(CLI::IsMember(names)))
      ->type_name("METHOD");
  verb->add_option("--angle-weight", options->angle_weight, "weight of the angle energy [default: 0.1]")
      ->check(non_negative_number())
      ->type_name("W");
  verb->add_option("--area-weight", options->area_weight, "weight of the area energy [default: 1]")
      ->check(non_negative_number())
      ->type_name("W");
  add_limits(*verb, options->limits);
  verb->add_option("--page", options->page, "write a page with shape and map side by side, and the figures")
      ->type_name("FILE.html");
  add_sphere_uses(*verb, options->uses);
  add_text_option(*verb, options->text);
  add_mending_options(*verb, options->mending);
  verb->add_flag("--keep-partial", options->keep_partial,
                 "if no valid map is found, or the time limit or Ctrl-C ends the work, write the best partial map; the "
                 "message reports its valid part, and the exit code is 1");
  add_common_options(*verb, common);
  verb->footer(
      "Inward-oriented faces are reversed. The file is read back and checked by exact arithmetic before it replaces "
      "OUT;\na map that the format cannot represent is refused (no-valid-result).");
  verb->callback([options, verb, &common] {
    Session session(common, "sphere", options->input);
    session.run([&] {
      refuse_unused_sphere_options(*verb);
      sphere(*options, session);
    });
  });
}

}  // namespace orbicube::cli
