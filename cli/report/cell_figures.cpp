#include "report/cell_figures.h"

#include <cstdio>

namespace orbicube::cli {
namespace {

template <class... Numbers>
std::string printed(const char* format, Numbers... numbers) {
  char text[160];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

}  // namespace

Json quality_json(const mesh::TetrahedronQuality& q) {
  return {{"positive", q.positive},
          {"flat", q.flat},
          {"inverted", q.inverted},
          {"volume", q.volume},
          {"min_volume", q.min_volume},
          {"max_volume", q.max_volume},
          {"min_dihedral", q.min_dihedral},
          {"max_dihedral", q.max_dihedral},
          {"mean_min_dihedral", q.mean_min_dihedral},
          {"min_radius_ratio", q.min_radius_ratio},
          {"mean_radius_ratio", q.mean_radius_ratio},
          {"max_radius_edge", q.max_radius_edge},
          {"mean_radius_edge", q.mean_radius_edge},
          {"min_edge_length", q.min_edge_length},
          {"max_edge_length", q.max_edge_length},
          {"worst", q.worst == mesh::no_index ? Json() : Json(q.worst)},
          {"dihedral_histogram", q.dihedral_histogram},
          {"radius_ratio_histogram", q.radius_ratio_histogram}};
}

std::string angles_text(const mesh::TetrahedronQuality& q) {
  return printed("%.4g to %.4g degrees, smallest of each on average %.4g", q.min_dihedral, q.max_dihedral,
                 q.mean_min_dihedral);
}

std::string radii_text(const mesh::TetrahedronQuality& q) {
  return printed("%.3g at worst, %.3g on average (1: regular)", q.min_radius_ratio, q.mean_radius_ratio);
}

}  // namespace orbicube::cli
