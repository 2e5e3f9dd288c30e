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
          {"volume_min", q.smallest_volume},
          {"volume_max", q.largest_volume},
          {"dihedral_min", q.smallest_dihedral},
          {"dihedral_max", q.largest_dihedral},
          {"dihedral_min_mean", q.mean_smallest_dihedral},
          {"radius_ratio_min", q.smallest_radius_ratio},
          {"radius_ratio_mean", q.mean_radius_ratio},
          {"radius_edge_max", q.largest_radius_edge},
          {"radius_edge_mean", q.mean_radius_edge},
          {"edge_min", q.shortest_edge},
          {"edge_max", q.longest_edge},
          {"worst", q.worst == mesh::no_index ? Json() : Json(q.worst)},
          {"dihedral_histogram", q.dihedral_histogram},
          {"radius_ratio_histogram", q.radius_ratio_histogram}};
}

std::string angles_text(const mesh::TetrahedronQuality& q) {
  return printed("%.4g to %.4g degrees, smallest of each on average %.4g", q.smallest_dihedral, q.largest_dihedral,
                 q.mean_smallest_dihedral);
}

std::string radii_text(const mesh::TetrahedronQuality& q) {
  return printed("%.3g at worst, %.3g on average (1: regular)", q.smallest_radius_ratio, q.mean_radius_ratio);
}

}  // namespace orbicube::cli
