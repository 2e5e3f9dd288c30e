// orbicube harmonics: the spherical harmonics of a surface that has a sphere map, and the surface made of them again.
#include "harmonics/fitting/fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "base/counted.h"
#include "files/map_file.h"
#include "files/refined_map.h"
#include "files/surface_file.h"
#include "harmonics/functions/coefficient_file.h"
#include "harmonics/functions/spectrum.h"
#include "harmonics/rotations/alignment.h"
#include "harmonics/rotations/rotation.h"
#include "mesh/search/measures.h"
#include "mesh/search/unit_scale.h"
#include "mesh/search/vertex_measures.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "scenes/page_figures.h"
#include "session/unused_options.h"
#include "solids/harmonics_of_shape.h"
#include "sphere_map/sphere_map.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

using harmonics::Coefficients;

const std::map<std::string, harmonics::FitMethod> fit_methods = {{"automatic", harmonics::FitMethod::automatic},
                                                                 {"dense", harmonics::FitMethod::dense},
                                                                 {"iterative", harmonics::FitMethod::iterative}};

struct HarmonicsOptions {
  std::string input, sphere, output, reconstruction, page;
  std::string reference;  // coefficients of a shape to lie as, or empty
  std::string align = "shape";
  std::uint32_t degree = 0;
  std::string method = "automatic";
  std::string weights = "area";
  double regularization = 0;
  std::uint32_t low = harmonics::largest_degree, high = 0, width = 0;
  std::vector<std::uint32_t> band;
  MapRefinement refinement;
  bool text = false, weld = false;

  harmonics::Band kept() const {
    if (!band.empty()) return {band[0], band[1], width};
    return {high, low, width};
  }
};

base::Array<double> weights_of(const HarmonicsOptions& options, const mesh::Mesh& surface, const mesh::Mesh& map,
                               const base::Host& host) {
  if (options.weights == "uniform") return base::Array<double>(surface.positions.size(), 1.0, host.memory);
  return mesh::vertex_areas(options.weights == "sphere" ? map.positions : surface.positions, surface.triangles, host);
}

harmonics::FitOptions fit_options(const HarmonicsOptions& options) {
  return {.degree = options.degree, .method = fit_methods.at(options.method), .regularization = options.regularization};
}

// The fit of the vertices of triangles.
Coefficients fit_used(const HarmonicsOptions& options, const mesh::Mesh& surface, const mesh::Mesh& map,
                      const base::Host& host, harmonics::FitReport& report) {
  const base::Array<std::uint8_t> used = mesh::used_vertices(surface.positions.size(), surface.triangles, host.memory);
  const base::Array<double> weights = weights_of(options, surface, map, host);
  base::Array<mesh::Vector3> positions(host.memory), directions(host.memory);
  base::Array<double> used_weights(host.memory);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    positions.push_back(surface.positions[v]);
    directions.push_back(map.positions[v]);
    used_weights.push_back(weights[v]);
  }
  return harmonics::fit(directions, used_weights, numbers(positions), 3, fit_options(options), host, report);
}

// Reports a fit that the samples do not determine.
void note_rank(const harmonics::FitReport& fit, std::size_t vertices, Session& session) {
  if (fit.rank == fit.unknowns) return;
  const std::string unknowns = std::to_string(fit.unknowns);
  const std::string why = vertices < fit.unknowns ? base::counted(vertices, "vertex is", "vertices are") + " too few"
                                                  : "the map leaves parts of the sphere without vertices";
  session.note("rank-deficient: " +
               (fit.rank > 0 ? "the vertices determine " + std::to_string(fit.rank) + " of " + unknowns
                             : "the vertices do not determine all " + unknowns) +
               " coefficients of each coordinate (" + why +
               "); the solution of minimum norm was taken; lower --degree or give --regularization");
}

// Where the map says nothing of vertices in no triangle, they get some direction.
void direct_unused(const mesh::Mesh& surface, mesh::Mesh& map, const base::Host& host) {
  const base::Array<std::uint8_t> used = mesh::used_vertices(surface.positions.size(), surface.triangles, host.memory);
  for (std::size_t v = 0; v < used.size(); ++v) {
    mesh::Vector3& direction = map.positions[v];
    if (used[v] == 0 && !(direction.allFinite() && direction != mesh::Vector3::Zero()))
      direction = mesh::Vector3::UnitZ();
  }
}

// Shape, map and distortion, and the slider through the degrees.
void write_harmonics_page(const HarmonicsOptions& options, const mesh::Mesh& surface, mesh::Mesh map,
                          const Coefficients& coefficients, const harmonics::FitReport& fit, double error,
                          Session& session) {
  const base::Host& host = session.host();
  const sphere_map::Options weights;
  sphere_map::FaceDistortion faces(host.memory);
  const sphere_map::Measurement m = about(options.sphere, Role::input, [&] {
    return sphere_map::measure(surface.positions, map.triangles, map.positions, weights.angle_weight,
                               weights.area_weight, host, &faces);
  });
  for (mesh::Vector3& direction : map.positions)
    direction.stableNormalize();
  const std::string name = std::filesystem::path(options.input).filename().string();
  PageResult result = page_result(name, surface, map.positions, m, faces, weights.angle_weight, weights.area_weight);
  result.triangles = map.triangles;
  add_harmonics(result, coefficients, fit, error);
  write_page(options.page, {&result, 1}, "Spherical harmonics of " + name, session);
}

// As the reference lies: its parameters, and with "shape" it itself too, turned to where positions agree best.
Coefficients aligned(const Coefficients& coefficients, const HarmonicsOptions& options, Session& session) {
  if (options.reference.empty()) return coefficients.copy();
  const base::Host& host = session.host();
  return about(options.reference, Role::input, [&] {
    const Coefficients reference =
        harmonics::read_coefficients(options.reference, harmonics::FileFormat::by_ending, host);
    const bool joint = options.align == "shape";
    const harmonics::Alignment found =
        harmonics::align(reference, coefficients, {.turn_values = joint, .prefer_standing = joint}, host);
    Coefficients turned = harmonics::rotate(coefficients, found.rotation, host);
    if (joint) harmonics::rotate_values(turned, found.values);
    const double angle = 180 / std::numbers::pi * Eigen::AngleAxisd(found.values).angle();
    session.figures()["alignment"] = {{"to", options.reference},
                                      {"align", options.align},
                                      {"correlation", found.correlation},
                                      {"turn_degrees", angle}};
    session.say("  aligned with " + options.reference + ": correlation " + number(found.correlation) +
                ", the shape turned by " + number(angle) + " degrees");
    return turned;
  });
}

Json json_of(const HarmonicsOptions& options) {
  return {{"sphere", options.sphere},
          {"degree", options.degree},
          {"output", options.output},
          {"reconstruct", options.reconstruction},
          {"page", options.page},
          {"align_to", options.reference},
          {"align", options.align},
          {"method", options.method},
          {"vertex_weights", options.weights},
          {"regularization", options.regularization},
          {"low", options.low},
          {"high", options.high},
          {"band", options.band},
          {"width", options.width},
          {"refine_map", options.refinement.rounds},
          {"refined_map", options.refinement.output}};
}

void require_outputs(const HarmonicsOptions& options) {
  about(options.output, Role::output, [&] { harmonics::format_of_path(options.output); });
  if (!options.reconstruction.empty()) require_writable(options.reconstruction);
  check_refinement(options.refinement);
  const harmonics::Band band = options.kept();
  if (band.low > band.high) throw Failure(Exit::wrong_input, "", "usage", "the filter keeps no degree");
}

mesh::Mesh read_surface(const HarmonicsOptions& options, Session& session) {
  mesh::Mesh surface = session.portion(0.03, [&] { return read_input(options.input, options.weld, session).mesh; });
  if (surface.triangles.empty())
    throw Failure(Exit::wrong_input, options.input, "empty-mesh", "there are no triangles");
  return surface;
}

// The coefficients of a surface, and what is known of them.
struct Expansion {
  explicit Expansion(std::pmr::memory_resource* memory) : coefficients(memory) {}

  int exponent = 0;  // of the power of two by which the surface was scaled
  Coefficients coefficients;
  std::vector<double> norms;  // by degree
  harmonics::FitReport fit;
  double area = 0;  // of the scaled surface
};

// Fits the surface at a size near 1, where squares neither overflow nor vanish. Powers of two change no bit of the
// coefficients.
Expansion expand(const HarmonicsOptions& options, const mesh::Mesh& surface, const mesh::Mesh& map,
                 const base::Host& host) {
  Expansion result(host.memory);
  result.exponent = mesh::unit_scale_exponent(surface.positions, surface.triangles);
  mesh::Mesh scaled(host.memory);
  scaled.positions = surface.positions;
  scaled.triangles = surface.triangles;
  mesh::scale_by_power(scaled.positions, result.exponent);
  about(options.sphere, Role::input, [&] {
    const base::Stage stage(host, 0.8);
    for (const double a : mesh::vertex_areas(scaled.positions, scaled.triangles, host))
      result.area += a;
    if (!(result.area > 0) || !std::isfinite(result.area))
      throw Failure(Exit::wrong_input, options.input, "degenerate-geometry", "the surface has no area");
    result.coefficients = fit_used(options, scaled, map, host, result.fit);
  });
  return result;
}

// Keeps the band of the options; coefficients and norms are those of the surface before it was scaled.
void filter(const HarmonicsOptions& options, Expansion& made) {
  harmonics::filter(made.coefficients, options.kept(), true);
  made.norms.resize(options.degree + std::size_t{1});
  harmonics::degree_norms(made.coefficients, made.norms);
  for (double& norm : made.norms)
    norm = std::ldexp(norm, -made.exponent);
  for (double& value : made.coefficients.values)
    value = std::ldexp(value, -made.exponent);
}

Json figures_of(const HarmonicsOptions& options, const mesh::Mesh& surface, const Expansion& made, double error) {
  return {{"output", options.output},
          {"vertices", surface.positions.size()},
          {"triangles", surface.triangles.size()},
          {"degree", options.degree},
          {"unknowns", made.fit.unknowns},
          {"rank", made.fit.rank},
          {"condition", made.fit.condition},
          {"method", made.fit.method == harmonics::FitMethod::dense ? "dense" : "iterative"},
          {"iterations", made.fit.iterations},
          {"residual", unscaled(made.fit.residual, -made.exponent)},
          {"area", unscaled(made.area, -2 * made.exponent)},
          {"error", error},
          {"degree_norms", made.norms}};
}

void say_fit(const HarmonicsOptions& options, const Expansion& made, std::size_t vertices, double seconds, double error,
             Session& session) {
  session.say(options.input + ": degree " + std::to_string(options.degree) + ", " +
              base::counted(made.fit.unknowns, "coefficient") + " of each coordinate from " +
              base::counted(vertices, "vertex", "vertices") + " in " + number(seconds) + " s, in " + options.output);
  session.say("  reconstruction error " + number(error) + " at area 4 pi, root mean square residual " +
              number(std::ldexp(made.fit.residual, -made.exponent)) + ", condition " + number(made.fit.condition));
  if (!options.reconstruction.empty()) session.say("  wrote " + options.reconstruction);
  if (!options.page.empty()) session.say("  wrote " + options.page + ", open it in a browser");
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void fit_surface(const HarmonicsOptions& options, Session& session) {
  const base::Host& host = session.host();
  session.options() = json_of(options);
  require_outputs(options);
  const mesh::Mesh surface = read_surface(options, session);
  mesh::Mesh map = read_map(surface, options.input, options.sphere, session);
  direct_unused(surface, map, host);
  const base::Array<std::uint8_t> used = mesh::used_vertices(surface.positions.size(), surface.triangles, host.memory);
  const auto vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  const double read = session.seconds();
  if (options.refinement.rounds > 0) {
    const auto weights = [&](const mesh::Mesh& scaled) { return weights_of(options, scaled, map, host); };
    about(options.sphere, Role::input,
          [&] { refine_map(options.refinement, fit_options(options), weights, surface, map, options.text, session); });
  }

  Expansion expansion = expand(options, surface, map, host);
  const double fitted = session.seconds();
  note_rank(expansion.fit, vertices, session);
  filter(options, expansion);
  const Coefficients& coefficients = expansion.coefficients;

  mesh::Mesh made = surface_of(coefficients, map, host);
  made.triangles = surface.triangles;
  const double error = reconstruction_error(surface, made, host);
  const double compared = session.seconds();

  about(options.output, Role::output, [&] {
    harmonics::write_coefficients(session.stage(options.output), aligned(coefficients, options, session),
                                  harmonics::FileFormat::by_ending);
  });
  if (!options.reconstruction.empty()) write_output(options.reconstruction, made, !options.text, session);
  if (!options.page.empty())
    write_harmonics_page(options, surface, std::move(map), coefficients, expansion.fit, error, session);

  session.figures().update(figures_of(options, surface, expansion, error));
  session.figures().update({{"seconds_read", read},
                            {"seconds_fit", fitted - read},
                            {"seconds_compare", compared - fitted},
                            {"seconds_write", session.seconds() - compared}});
  say_fit(options, expansion, vertices, fitted - read, error, session);
}

CLI::Validator degree_range() {
  return unnamed(CLI::Range(0U, harmonics::largest_degree));
}

void add_filter_options(CLI::App& verb, HarmonicsOptions& options) {
  const auto degree = degree_range();
  auto* low = verb.add_option("--low", options.low, "low pass: keep degrees up to N")->check(degree)->type_name("N");
  auto* high =
      verb.add_option("--high", options.high, "high pass: keep degrees from N on, and the position of the shape")
          ->check(degree)
          ->type_name("N");
  verb.add_option("--band", options.band, "band pass: keep degrees A to B, and the position of the shape")
      ->expected(2)
      ->check(degree)
      ->excludes(low)
      ->excludes(high)
      ->type_name("A B");
  verb.add_option("--width", options.width, "width of the transition of filters, in degrees [default: 0]")
      ->check(degree)
      ->type_name("N");
}

void add_fit_options(CLI::App& verb, HarmonicsOptions& options) {
  verb.add_option("--refine-map", options.refinement.rounds,
                  "refine the map for this degree: up to N rounds of a fit and a step of all vertices on the sphere; "
                  "0: none [default: 0]")
      ->check(unnamed(CLI::Range(0, 1000)))
      ->type_name("N");
  verb.add_option("--refined-map", options.refinement.output, "write the refined map")->type_name("MAP2");
  verb.add_option("--regularization", options.regularization,
                  "weight of the squared Laplacian in the fit, for surfaces that do not determine it [default: 0]")
      ->check(non_negative_number())
      ->type_name("S");
  verb.add_option("--vertex-weights", options.weights,
                  "weight of a vertex: area (a third of the area of its triangles on the surface, default), sphere "
                  "(the same on the map), uniform")
      ->check(unnamed(CLI::IsMember({"area", "sphere", "uniform"})))
      ->type_name("WHAT");
  std::vector<std::string> names;
  for (const auto& [name, method] : fit_methods)
    names.push_back(name);
  verb.add_option("--method", options.method,
                  "dense (QR with column pivoting), iterative (conjugate gradients, refined), or automatic by size "
                  "[default: automatic]")
      ->check(unnamed(CLI::IsMember(names)))
      ->type_name("METHOD");
}

}  // namespace

void add_harmonics(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("harmonics", "expand a mapped surface in spherical harmonics");
  const auto options = std::make_shared<HarmonicsOptions>();
  verb->add_option("IN", options->input, std::string("surface to read: ") + surface_endings)->required()->type_name("");
  verb->add_option("--sphere", options->sphere,
                   "map of IN, written by 'orbicube sphere IN -o MAP': the same vertices and faces on the sphere")
      ->required()
      ->type_name("MAP");
  verb->add_option("--degree", options->degree, "maximum degree L: (L + 1)^2 coefficients for each coordinate")
      ->required()
      ->check(degree_range())
      ->type_name("L");
  verb->add_option("-o,--output", options->output,
                   "coefficients to write: .sh .shtools .txt in the format of SHTOOLS (one block each for x, y, z), "
                   ".coef in that of SPHARM-PDM")
      ->required()
      ->type_name("COEFFS");
  verb->add_option("--align-to", options->reference,
                   "rotate COEFFS into alignment with the shape of these coefficients")
      ->type_name("COEFFS2");
  verb->add_option(
          "--align", options->align,
          "to maximum correlation: shape, for any poses of the shapes; rotation, for equal poses [default: shape]")
      ->check(unnamed(CLI::IsMember({"shape", "rotation"})))
      ->type_name("HOW");
  verb->add_option("--reconstruct", options->reconstruction, "write the surface of the coefficients")->type_name("OUT");
  verb->add_option("--page", options->page,
                   "write a page with shape and map, and a slider for the surface of the coefficients to each degree")
      ->type_name("FILE.html");
  add_filter_options(*verb, *options);
  add_fit_options(*verb, *options);
  add_text_option(*verb, options->text);
  add_weld_option(*verb, options->weld);
  add_common_options(*verb, common);
  verb->footer(
      "Filters change the written coefficients and their surface. The printed error is the mean distance between\nthe "
      "vertices of both surfaces, the larger of the two directions, for a surface of area 4 pi.\nFor example:\n  "
      "orbicube sphere creature.obj -o map.obj\n  orbicube harmonics creature.obj --sphere map.obj --degree 32 -o "
      "creature.coef --reconstruct smooth.obj");
  verb->callback([options, verb, &common] {
    Session session(common, "harmonics", options->input);
    session.run([&] {
      refuse_unused_harmonics_options(*verb);
      fit_surface(*options, session);
    });
  });
}

}  // namespace orbicube::cli
