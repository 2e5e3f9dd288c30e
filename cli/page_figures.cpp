#include "page_figures.h"

#include <cstdio>

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
  return "no: " + std::to_string(map.flipped) + " triangles turned over, " + std::to_string(map.degenerate) +
         " without area, degree " + text_of(map.degree);
}

}  // namespace

std::vector<std::pair<std::string, std::string>> page_figures(const sphere_map::Measurement& map, std::size_t vertices,
                                                              std::size_t triangles, double angle_weight,
                                                              double area_weight) {
  std::vector<std::pair<std::string, std::string>> rows = {
      {"Vertices", std::to_string(vertices)},
      {"Triangles", std::to_string(triangles)},
      {"One to one, checked exactly", validity(map)},
      {"Mean dilatation (at least 1)", text_of(map.dilatation_mean)},
      {"Largest dilatation", text_of(map.dilatation_largest)},
      {"Smallest area ratio", text_of(map.area_ratio_smallest)},
      {"Largest area ratio", text_of(map.area_ratio_largest)},
      {"Stretch efficiency (at most 1)", text_of(map.stretch_efficiency)},
      {"Mean isometric distortion (at least 1)", text_of(map.isometric_mean)},
      {"Angle energy E_D (at least 16 pi, 50.2655)", text_of(map.energy_angle)},
      {"Area energy E_A (at least 4 pi, 12.5664)", text_of(map.energy_area)},
      {"Energy " + text_of(angle_weight) + " E_D + " + text_of(area_weight) + " E_A", text_of(map.energy)},
  };
  if (map.zero_area_faces > 0) rows.emplace_back("Triangles without area", std::to_string(map.zero_area_faces));
  return rows;
}

}  // namespace orbicube::cli
