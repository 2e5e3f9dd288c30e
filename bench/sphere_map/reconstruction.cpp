// Figures for the dissertation's Table 3.5, one record a line, for tables.py: how far shapes are from what their
// spherical harmonics give.
//
//   bench-sphere-map-reconstruction FOLDER     with the models cow.off, bunny.ply, ..., those that FOLDER has
//
// Tab-separated: NAME METHOD vertices bands e(M, M^) rank condition. The surface is scaled to the area 4 pi; the fit is
// by least squares weighted by area; e is that of section 3.3.2, from vertices to vertices.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string_view>
#include <utility>

#include "baselines.h"
#include "harmonics/fitting/fit.h"
#include "mesh/search/distances.h"
#include "mesh/search/vertex_measures.h"
#include "sphere_map/sphere_map.h"
#include "table_models.h"

using namespace orbicube;
using sphere_map::Method;

namespace {

constexpr std::string_view names[] = {"bunny", "venus", "cow", "horse", "armadillo"};
constexpr std::uint32_t bands[] = {6, 16, 32};
constexpr std::pair<const char*, Method> methods[] = {{"dissertation", Method::dissertation},
                                                      {"balanced", Method::balanced},
                                                      {"stretch", Method::stretch},
                                                      {"conformal", Method::conformal}};

void scale_to_unit_sphere_area(mesh::Mesh& surface) {
  double area = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    const auto& p = surface.positions;
    area += 0.5 * (p[b] - p[a]).cross(p[c] - p[a]).norm();
  }
  const double scale = std::sqrt(4 * std::numbers::pi / area);
  for (mesh::Vector3& position : surface.positions)
    position *= scale;
}

void measure(const bench::Model& model, const mesh::Mesh& surface, const char* name,
             std::span<const mesh::Vector3> directions) {
  const base::Host host;
  const auto weights = mesh::vertex_areas(surface.positions, surface.triangles, host);
  const std::span<const double> values(surface.positions.front().data(), 3 * surface.positions.size());
  for (const std::uint32_t band_count : bands) {
    harmonics::FitOptions fit_options;
    fit_options.degree = band_count - 1;
    harmonics::FitReport report;
    const auto coefficients = harmonics::fit(directions, weights, values, 3, fit_options, host, report);
    base::Array<mesh::Vector3> rebuilt(surface.positions.size());
    harmonics::synthesise(coefficients, directions, {rebuilt.front().data(), 3 * rebuilt.size()}, host);
    std::printf("%s\t%s\t%zu\t%u\t%.6f\t%zu\t%.4g\n", model.name, name, surface.positions.size(), band_count,
                mesh::mean_distance(surface.positions, rebuilt, host), report.rank, report.condition);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  int found = 0;
  for (const std::string_view wanted : names) {
    for (const bench::Model& model : bench::table_models) {
      if (wanted != model.name || !std::filesystem::exists(folder / model.file)) continue;
      ++found;
      mesh::Mesh surface = bench::read_model(folder, model, 0);
      scale_to_unit_sphere_area(surface);
      for (const auto& [name, method] : methods) {
        sphere_map::Options options;
        options.method = method;
        measure(model, surface, name, sphere_map::compute(surface.positions, surface.triangles, options, base::Host()));
      }
      measure(model, surface, "harmonic", bench::harmonic_baseline(surface, base::Host()));
      measure(model, surface, "curvilinear", bench::curvilinear_baseline(surface, base::Host()));
    }
  }
  if (found == 0) {
    std::fprintf(stderr, "%s has none of the models\n", folder.c_str());
    return 1;
  }
  return 0;
}
