#include "scenes/page_figures.h"

#include <cstdio>

#include "base/counted.h"
#include "mesh/files/file.h"
#include "session/failure.h"

namespace orbicube::cli {
namespace {

// Six significant digits, as 12.5664.
std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string validity(const sphere_map::Measurement& map) {
  if (map.bijective) return map.mirrored ? "yes, mirrored" : "yes";
  return "no: " + base::counted(map.flipped, "triangle") + " flipped, " + std::to_string(map.degenerate) +
         " without area, degree " + text_of(map.degree);
}

}  // namespace

PageResult page_result(const std::string& name, const mesh::Mesh& shape, std::span<const mesh::Vector3> directions,
                       const sphere_map::Measurement& map, const sphere_map::FaceDistortion& faces, double angle_weight,
                       double area_weight) {
  PageResult result;
  result.name = name;
  result.positions = shape.positions;
  result.directions = directions;
  result.triangles = shape.triangles;
  result.quasi_conformal = faces.quasi_conformal;
  result.area_ratio = faces.area_ratio;
  result.figures = {
      {"Vertices", std::to_string(shape.positions.size())},
      {"Triangles", std::to_string(shape.triangles.size())},
      {"One to one, checked exactly", validity(map)},
      {"Mean quasi-conformal distortion (at least 1)", text_of(map.mean_quasi_conformal)},
      {"Largest quasi-conformal distortion", text_of(map.max_quasi_conformal)},
      {"Smallest area ratio", text_of(map.min_area_ratio)},
      {"Largest area ratio", text_of(map.max_area_ratio)},
      {"Stretch efficiency (at most 1)", text_of(map.stretch_efficiency)},
      {"Mean isometric distortion (at least 1)", text_of(map.isometric_mean)},
      {"Angle energy E_D (at least 16 pi, 50.2655)", text_of(map.energy_angle)},
      {"Area energy E_A (at least 4 pi, 12.5664)", text_of(map.energy_area)},
      {"Energy " + text_of(angle_weight) + " E_D + " + text_of(area_weight) + " E_A", text_of(map.energy)},
  };
  if (map.zero_area_faces > 0) {
    result.figures.emplace_back("Triangles without area", std::to_string(map.zero_area_faces));
  }
  return result;
}

void add_harmonics(PageResult& result, const harmonics::Coefficients& coefficients, const harmonics::FitReport& fit,
                   double error) {
  result.degree = coefficients.degree;
  result.coefficients = coefficients.values;
  result.figures.emplace_back("Degree of the harmonics", std::to_string(coefficients.degree));
  if (fit.rank < fit.unknowns) {
    const std::string determined = fit.rank > 0 ? std::to_string(fit.rank) : "fewer";
    result.figures.emplace_back("Coefficients that the vertices determine",
                                determined + " of " + std::to_string(fit.unknowns));
  }
  result.figures.emplace_back("Reconstruction error e, for area 4 pi", text_of(error));
}

std::size_t write_page(const std::string& path, std::span<const PageResult> results, const std::string& title,
                       Session& session) {
  const std::string page = report_page(results, title);
  about(path, Role::output, [&] {
    mesh::OutputFile file(session.stage(path));
    file.write(page);
    file.commit();
  });
  return page.size();
}

}  // namespace orbicube::cli
