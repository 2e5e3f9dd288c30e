// Reconstruction errors e(M, M^) of section 3.3.2 at 6, 16 and 32 bands on models, and after ten rounds of
// obc_harmonics_refine_map, beside the dissertation's Table 3.5
// and figures measured on Praun and Hoppe's maps; and the time of fits.
//
//   bench-harmonics errors FOLDER [stretch|balanced|...]   the models of the table below that FOLDER has
//   bench-harmonics fit FOLDER FILE...                     CPU seconds of fits of these models by degree
//   bench-harmonics scattered                              milliseconds of sums at 50000 points by degree, and errors
//
// Bands are degrees 0 to 5, 15 and 31: 6 x 6, 16 x 16 and 32 x 32 coefficients. Surfaces count as scaled to the area 4
// pi.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "harmonics/fitting/fit.h"
#include "harmonics/fitting/map_refinement.h"
#include "harmonics/functions/basis.h"
#include "mesh/files/read.h"
#include "mesh/search/distances.h"
#include "mesh/search/measures.h"
#include "mesh/search/vertex_measures.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using harmonics::Vector3;

namespace {

constexpr std::uint32_t bands[] = {6, 16, 32};
constexpr std::uint32_t refinement_rounds = 10;

// Errors at the three bands: the dissertation's own ("ours" of Table 3.5, of its versions of the models) and those of a
// weighted least-squares fit on Praun and Hoppe's maps of these files; 0 where there is none.
struct PeerRow {
  const char* file;
  double dissertation[3], praun_hoppe[3];
};
constexpr PeerRow peers[] = {
    {"cow.off", {0.1474, 0.0813, 0.0591}, {0.083, 0.027, 0.0099}},
    {"bunny.ply", {0.0891, 0.0424, 0.0247}, {0.050, 0.0128, 0.0045}},
    {"armadillo.ply", {0.1260, 0.0309, 0.0222}, {0.077, 0.021, 0.0101}},
    {"horse.ply", {0.1653, 0.0740, 0.0563}, {0.064, 0.015, 0.0061}},
    {"venus.ply", {0.0279, 0.0113, 0.0083}, {0, 0, 0}},
};

const std::map<std::string, sphere_map::Method> methods = {
    {"balanced", sphere_map::Method::balanced},   {"angle-area", sphere_map::Method::angle_area},
    {"isometric", sphere_map::Method::isometric}, {"stretch", sphere_map::Method::stretch},
    {"conformal", sphere_map::Method::conformal}, {"dissertation", sphere_map::Method::dissertation}};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Model {
  mesh::Mesh surface;
  base::Array<Vector3> directions;
  base::Array<double> weights;
};

// The surface scaled to area 4 pi, and its map.
Model mapped(const std::filesystem::path& path, sphere_map::Method method, const base::Host& host) {
  Model model{mesh::read_mesh(path, {}, host), {}, {}};
  const double area = mesh::measures(model.surface.positions, model.surface.triangles, host).area;
  for (Vector3& p : model.surface.positions)
    p *= std::sqrt(4 * std::numbers::pi / area);
  model.directions = sphere_map::compute(model.surface.positions, model.surface.triangles, {.method = method}, host);
  model.weights = mesh::vertex_areas(model.surface.positions, model.surface.triangles, host);
  return model;
}

std::span<const double> numbers(const base::Array<Vector3>& points) {
  return {points.front().data(), 3 * points.size()};
}

// With band_count^2 coefficients: degrees 0 to band_count - 1.
harmonics::Coefficients fitted(const Model& model, std::uint32_t band_count, bool by_area, const base::Host& host,
                               harmonics::FitReport& report) {
  const std::span<const double> weights = model.weights;
  return harmonics::fit(model.directions, by_area ? weights : std::span<const double>(),
                        numbers(model.surface.positions), 3, {.degree = band_count - 1}, host, report);
}

double error_of(const Model& model, const harmonics::Coefficients& coefficients, const base::Host& host) {
  base::Array<Vector3> rebuilt(model.surface.positions.size());
  harmonics::synthesise(coefficients, model.directions, {rebuilt.front().data(), 3 * rebuilt.size()}, host);
  return mesh::mean_distance(model.surface.positions, rebuilt, host);
}

// The same at the middles of edges, which no fit and no refinement has seen.
double error_between(const Model& model, const harmonics::Coefficients& coefficients, const base::Host& host) {
  base::Array<Vector3> middles, directions;
  for (const auto& t : model.surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = t[k], b = t[(k + 1) % 3];
      if (a > b) continue;  // once of both triangles
      middles.push_back(0.5 * (model.surface.positions[a] + model.surface.positions[b]));
      directions.push_back((model.directions[a] + model.directions[b]).normalized());
    }
  }
  base::Array<Vector3> rebuilt(middles.size());
  harmonics::synthesise(coefficients, directions, {rebuilt.front().data(), 3 * rebuilt.size()}, host);
  return mesh::mean_distance(middles, rebuilt, host);
}

void print_errors(const double (&errors)[3]) {
  if (!(errors[0] > 0)) return;
  for (int k = 0; k < 3; ++k)
    std::printf("%s%.4f", k == 0 ? " " : " / ", errors[k]);
}

// Errors of a model at the three bands.
struct ErrorRow {
  double by_area[3], alike[3], refined[3], between[3], refined_between[3], condition = 0, fit_seconds = 0,
                                                                           refine_seconds = 0;
};

ErrorRow errors_of(const Model& model, const base::Host& host) {
  ErrorRow row{};
  for (std::size_t k = 0; k < 3; ++k) {
    harmonics::FitReport report;
    row.alike[k] = error_of(model, fitted(model, bands[k], false, host, report), host);
    double start = cpu_seconds();
    const harmonics::Coefficients coefficients = fitted(model, bands[k], true, host, report);
    row.fit_seconds = cpu_seconds() - start;
    row.condition = report.condition;
    row.by_area[k] = error_of(model, coefficients, host);
    row.between[k] = error_between(model, coefficients, host);
    Model refined = model;
    start = cpu_seconds();
    harmonics::refine_map(refined.surface.positions, refined.surface.triangles, refined.weights,
                          {.fit = {.degree = bands[k] - 1}, .rounds = refinement_rounds}, refined.directions, host);
    row.refine_seconds = cpu_seconds() - start;
    const harmonics::Coefficients closer = fitted(refined, bands[k], true, host, report);
    row.refined[k] = error_of(refined, closer, host);
    row.refined_between[k] = error_between(refined, closer, host);
  }
  return row;
}

int errors(const std::filesystem::path& folder, const std::string& name) {
  base::Host host;
  host.thread_count = 1;
  std::printf(
      "| model | vertices | %s map, by area | all alike | refined, by area | Praun-Hoppe map | dissertation | "
      "middles of edges, by area | the same, refined | condition | fit of 32 x 32, CPU s | refinement, CPU s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      name.c_str());
  for (const PeerRow& peer : peers) {
    if (!std::filesystem::exists(folder / peer.file)) continue;
    const Model model = mapped(folder / peer.file, methods.at(name), host);
    const ErrorRow row = errors_of(model, host);
    std::printf("| %s | %zu |", peer.file, model.surface.positions.size());
    for (const double* column :
         {row.by_area, row.alike, row.refined, peer.praun_hoppe, peer.dissertation, row.between, row.refined_between}) {
      print_errors({column[0], column[1], column[2]});
      std::printf(" |");
    }
    std::printf(" %.1f | %.2f | %.1f |\n", row.condition, row.fit_seconds, row.refine_seconds);
    std::fflush(stdout);
  }
  return 0;
}

int fit_times(const std::filesystem::path& folder, const std::vector<std::string>& files) {
  const base::Host host;
  std::printf(
      "| model | vertices | degree | method | iterations | condition | residual | CPU s "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (const std::string& file : files) {
    const Model model = mapped(folder / file, sphere_map::Method::balanced, host);
    for (const std::uint32_t degree : {8U, 16U, 32U, 64U, 100U}) {
      harmonics::FitReport report;
      const double start = cpu_seconds();
      fitted(model, degree + 1, true, host, report);
      std::printf("| %s | %zu | %u | %s | %lu | %.1f | %.2e | %.2f |\n", file.c_str(), model.surface.positions.size(),
                  degree, report.method == harmonics::FitMethod::dense ? "dense" : "iterative",
                  static_cast<unsigned long>(report.iterations), report.condition, report.residual,
                  cpu_seconds() - start);
      std::fflush(stdout);
    }
  }
  return 0;
}

// Uniformly distributed, of a fixed sequence.
std::vector<Vector3> random_directions(std::size_t count) {
  std::mt19937_64 engine(1);
  std::vector<Vector3> directions(count);
  for (Vector3& d : directions) {
    const double z = 2 * base::unit_interval(engine()) - 1, turn = 2 * std::numbers::pi * base::unit_interval(engine());
    d = Vector3(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
  }
  return directions;
}

// The minimum CPU time of some calls, in milliseconds.
template <class Work>
double milliseconds(const Work& work) {
  double least = 1e300;
  for (int run = 0; run < 5; ++run) {
    const double start = cpu_seconds();
    work();
    least = std::min(least, 1e3 * (cpu_seconds() - start));
  }
  return least;
}

// Sums at scattered points and their transpose, one core. The error is to sums of so few points that they are computed
// one by one.
int scattered() {
  base::Host host;
  host.thread_count = 1;
  constexpr std::size_t point_count = 50000, few = 128;  // two blocks of lanes
  const std::vector<Vector3> directions = random_directions(point_count);
  std::printf(
      "| degree | synthesis, ms | analysis, ms | points one by one, ms | largest error, of the largest value |\n"
      "|---|---|---|---|---|\n");
  for (const std::uint32_t degree : {31U, 100U, 250U, 500U, 1000U}) {
    harmonics::Coefficients coefficients(degree, 1, host.memory), sums(degree, 1, host.memory);
    std::mt19937_64 engine(2);
    for (double& value : coefficients.values)
      value = 2 * base::unit_interval(engine()) - 1;
    std::vector<double> values(point_count), exact(few);
    const double forward = milliseconds([&] { harmonics::synthesise(coefficients, directions, values, host); });
    const double backward = milliseconds([&] { harmonics::analyse(directions, {}, values, sums, "analysis", host); });
    const double direct =
        milliseconds([&] { harmonics::synthesise(coefficients, std::span(directions).first(few), exact, host); });
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < few; ++i) {
      error = std::max(error, std::abs(values[i] - exact[i]));
      largest = std::max(largest, std::abs(exact[i]));
    }
    std::printf("| %u | %.1f | %.1f | %.0f | %.1e |\n", degree, forward, backward,
                direct * static_cast<double>(point_count) / few, error / largest);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() >= 2 && arguments[0] == "errors") {
      const std::string name = arguments.size() > 2 ? arguments[2] : "stretch";
      if (methods.count(name) != 0) return errors(arguments[1], name);
    }
    if (arguments.size() >= 3 && arguments[0] == "fit")
      return fit_times(arguments[1], {arguments.begin() + 2, arguments.end()});
    if (arguments.size() == 1 && arguments[0] == "scattered") return scattered();
  } catch (const base::Error& error) {
    std::fprintf(stderr, "bench-harmonics: %s: %s\n", error.kind(), error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: bench-harmonics errors FOLDER [METHOD] | fit FOLDER FILE... | scattered\n");
  return 2;
}
