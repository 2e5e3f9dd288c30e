// orbicube harmonics: the spherical harmonics of a surface that has a sphere map, and the surface made of them again.
#include "harmonics/fit.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "harmonics/coefficient_file.h"
#include "harmonics/spectrum.h"
#include "harmonics/surface.h"
#include "harmonics_of_shape.h"
#include "map_file.h"
#include "page_figures.h"
#include "sphere_map/sphere_map.h"
#include "surface_file.h"
#include "text.h"
#include "verbs.h"

namespace orbicube::cli {
namespace {

using harmonics::Coefficients;

const std::map<std::string, harmonics::FitMethod> fit_methods = {{"automatic", harmonics::FitMethod::automatic},
                                                                 {"dense", harmonics::FitMethod::dense},
                                                                 {"iterative", harmonics::FitMethod::iterative}};

struct HarmonicsOptions {
  std::string input, sphere, output, reconstruction, page;
  std::uint32_t degree = 0;
  std::string method = "automatic";
  std::string weights = "area";
  double smoothing = 0;
  std::uint32_t low = harmonics::largest_degree, high = 0, width = 0;
  std::vector<std::uint32_t> band;
  bool text = false;
  bool weld = false;

  harmonics::Band kept() const {
    if (!band.empty()) return {band[0], band[1], width};
    return {high, low, width};
  }
};

base::Array<double> weights_of(const HarmonicsOptions& options, const mesh::Mesh& surface, const mesh::Mesh& map,
                               const base::Host& host) {
  if (options.weights == "uniform") return base::Array<double>(surface.positions.size(), 1.0, host.memory);
  return harmonics::vertex_areas(options.weights == "sphere" ? map.positions : surface.positions, surface.triangles,
                                 host);
}

// Tells of a fit that the samples do not determine.
void note_rank(const harmonics::FitReport& fit, std::size_t vertices, Session& session) {
  if (fit.rank == fit.unknowns) return;
  const std::string unknowns = std::to_string(fit.unknowns);
  const std::string why = vertices < fit.unknowns ? std::to_string(vertices) + " vertices are too few"
                                                  : "the map leaves parts of the sphere without vertices";
  session.note("rank-deficient: " +
               (fit.rank > 0 ? "the vertices determine " + std::to_string(fit.rank) + " of " + unknowns
                             : "the vertices do not determine all " + unknowns) +
               " coefficients of each coordinate (" + why +
               "); those of least length were taken. Lower --degree or give --smoothing");
}

// Shape, map and distortion, and the slider through the degrees.
void write_harmonics_page(const HarmonicsOptions& options, const mesh::Mesh& surface, mesh::Mesh map,
                          const Coefficients& coefficients, const harmonics::FitReport& fit, double error,
                          const base::Host& host) {
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
  write_page(options.page, {&result, 1}, "Spherical harmonics of " + name);
}

void fit_surface(const HarmonicsOptions& options, Session& session) {
  const base::Host& host = session.host();
  session.options() = {{"sphere", options.sphere},   {"degree", options.degree},
                       {"output", options.output},   {"reconstruct", options.reconstruction},
                       {"page", options.page},       {"method", options.method},
                       {"weights", options.weights}, {"smoothing", options.smoothing},
                       {"low", options.low},         {"high", options.high},
                       {"band", options.band},       {"width", options.width}};
  about(options.output, Role::output, [&] { harmonics::format_of_path(options.output); });
  if (!options.reconstruction.empty()) require_writable(options.reconstruction);
  const harmonics::Band band = options.kept();
  if (band.low > band.high) throw Failure(Exit::wrong_input, "", "usage", "the filter keeps no degree");

  mesh::Mesh surface = read_input(options.input, options.weld, session).mesh;
  if (surface.triangles.empty())
    throw Failure(Exit::wrong_input, options.input, "empty-mesh", "there are no triangles");
  mesh::Mesh map = read_map(surface, options.input, options.sphere, session);
  const double read = session.seconds();

  harmonics::FitReport report;
  double area = 0;
  Coefficients coefficients(host.memory);
  about(options.sphere, Role::input, [&] {
    for (const double a : harmonics::vertex_areas(surface.positions, surface.triangles, host))
      area += a;
    if (!(area > 0) || !std::isfinite(area))
      throw Failure(Exit::wrong_input, options.input, "degenerate-geometry", "the surface has no area");
    coefficients = harmonics::fit(
        map.positions, weights_of(options, surface, map, host), numbers(surface.positions), 3,
        {.degree = options.degree, .method = fit_methods.at(options.method), .smoothing = options.smoothing}, host,
        report);
  });
  const double fitted = session.seconds();
  note_rank(report, surface.positions.size(), session);
  harmonics::filter(coefficients, band, true);

  mesh::Mesh made = surface_of(coefficients, map, host);
  made.triangles = surface.triangles;
  const double error = reconstruction_error(surface, made, host);
  const double compared = session.seconds();

  about(options.output, Role::output,
        [&] { harmonics::write_coefficients(options.output, coefficients, harmonics::FileFormat::by_ending); });
  if (!options.reconstruction.empty()) write_output(options.reconstruction, made, !options.text, host);
  if (!options.page.empty()) write_harmonics_page(options, surface, std::move(map), coefficients, report, error, host);

  std::vector<double> norms(options.degree + std::size_t{1});
  harmonics::degree_norms(coefficients, norms);
  session.figures().update({{"output", options.output},
                            {"vertices", surface.positions.size()},
                            {"triangles", surface.triangles.size()},
                            {"degree", options.degree},
                            {"unknowns", report.unknowns},
                            {"rank", report.rank},
                            {"condition", report.condition},
                            {"method", report.method == harmonics::FitMethod::dense ? "dense" : "iterative"},
                            {"iterations", report.iterations},
                            {"residual", report.residual},
                            {"area", area},
                            {"error", error},
                            {"degree_norms", norms},
                            {"seconds_read", read},
                            {"seconds_fit", fitted - read},
                            {"seconds_compare", compared - fitted},
                            {"seconds_write", session.seconds() - compared}});
  session.say(options.input + ": degree " + std::to_string(options.degree) + ", " + std::to_string(report.unknowns) +
              " coefficients of each coordinate from " + std::to_string(surface.positions.size()) + " vertices in " +
              number(fitted - read) + " s, in " + options.output);
  session.say("  reconstruction error " + number(error) + " at area 4 pi, mean square residual " +
              number(report.residual) + ", condition " + number(report.condition));
  if (!options.reconstruction.empty()) session.say("  wrote " + options.reconstruction);
  if (!options.page.empty()) session.say("  wrote " + options.page + ", open it in a browser");
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

}  // namespace

void add_harmonics(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("harmonics", "expand a surface with a sphere map in spherical harmonics");
  const auto options = std::make_shared<HarmonicsOptions>();
  const auto degree = unnamed(CLI::Range(0U, harmonics::largest_degree));
  verb->add_option("IN", options->input, std::string("surface to read: ") + surface_endings)->required()->type_name("");
  verb->add_option("--sphere", options->sphere,
                   "its map, as 'orbicube sphere IN -o MAP' writes it: the same vertices and faces on the sphere")
      ->required()
      ->type_name("MAP");
  verb->add_option("--degree", options->degree, "highest degree L: (L + 1)^2 coefficients for each coordinate")
      ->required()
      ->check(degree)
      ->type_name("L");
  verb->add_option("-o,--output", options->output,
                   "coefficients to write: .sh .shtools .txt as SHTOOLS has them (a block each for x, y, z), .coef as "
                   "SPHARM-PDM")
      ->required()
      ->type_name("COEFFS");
  verb->add_option("--reconstruct", options->reconstruction, "write the surface that the coefficients make")
      ->type_name("OUT");
  verb->add_option("--page", options->page,
                   "write a page that shows shape and map, with a slider for the surface of the coefficients to each "
                   "degree")
      ->type_name("FILE.html");
  auto* low = verb->add_option("--low", options->low, "low pass: keep degrees up to N")->check(degree)->type_name("N");
  auto* high = verb->add_option("--high", options->high, "high pass: keep degrees from N on, and where the shape lies")
                   ->check(degree)
                   ->type_name("N");
  verb->add_option("--band", options->band, "band pass: keep degrees A to B, and where the shape lies")
      ->expected(2)
      ->check(degree)
      ->excludes(low)
      ->excludes(high)
      ->type_name("A B");
  verb->add_option("--width", options->width, "fade filters out over N degrees rather than at once (0)")
      ->check(degree)
      ->type_name("N");
  verb->add_option("--smoothing", options->smoothing,
                   "weight of the squared Laplacian in the fit, for surfaces that do not determine it (0)")
      ->check(unnamed(CLI::NonNegativeNumber))
      ->type_name("S");
  verb->add_option("--weights", options->weights,
                   "what a vertex counts: area (a third of its triangles' area on the surface, the default), sphere "
                   "(on the map), uniform")
      ->check(unnamed(CLI::IsMember({"area", "sphere", "uniform"})))
      ->type_name("WHAT");
  std::vector<std::string> names;
  for (const auto& [name, method] : fit_methods)
    names.push_back(name);
  verb->add_option("--method", options->method,
                   "dense (QR with column pivoting), iterative (conjugate gradients, refined), or automatic by size")
      ->check(unnamed(CLI::IsMember(names)))
      ->type_name("METHOD");
  verb->add_flag("--text", options->text, "text rather than binary, where the format of OUT has both (PLY, STL, VTK)");
  verb->add_flag("--weld", options->weld, "join vertices at identical positions, as it was done for the map");
  add_common_options(*verb, common);
  verb->footer(
      "Filters change what is written: the coefficients and the surface made of them. The error printed is the mean\n"
      "distance between the vertices of both surfaces, the larger of the two ways, for a surface of area 4 pi.\n"
      "For example:\n"
      "  orbicube sphere creature.obj -o map.obj\n"
      "  orbicube harmonics creature.obj --sphere map.obj --degree 32 -o creature.coef --reconstruct smooth.obj");
  verb->callback([options, &common] {
    Session session(common, "harmonics", options->input);
    session.run([&] { fit_surface(*options, session); });
  });
}

}  // namespace orbicube::cli
