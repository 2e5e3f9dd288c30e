#include "polycube/outputs/atlas.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "polycube/outputs/atlas_packing.h"
#include "polycube/outputs/patch_rectangles.h"

namespace orbicube::polycube {
namespace {

constexpr std::uint32_t max_size = 16384;
// Cells of the grid of masks along a side: a power of two from the first, where patches are few, to the last. Twice as
// many take up to four times as long, and waste half of a cell less around each patch.
constexpr std::size_t min_cells = 256, max_cells = 1024;
constexpr double cells_a_patch = 16;  // along a side of a patch of mean size

double area_of(const PatchBoxes& boxes) {
  double area = 0;
  for (const PatchBox& box : boxes.boxes)
    area += (box.u_high - box.u_low) * (box.v_high - box.v_low);
  return area;
}

// A scale that no packing exceeds: a connected patch with its margin, a square of the padding moved over it, has its
// area and at least the padding times width and height, and the square of the padding. 0 where nothing fits.
double scale_bound(const PatchBoxes& boxes, const AtlasOptions& options) {
  const double area = area_of(boxes);
  double sides = 0, rest = static_cast<double>(options.size) * options.size;
  for (Index p = 0; p < boxes.patches(); ++p) {
    const AtlasPlace place = bounds_of(boxes.of(p));
    sides += options.padding * (place.u_high - place.u_low + place.v_high - place.v_low);
    rest -= options.padding * options.padding;
  }
  return rest > 0 ? 2 * rest / (sides + std::sqrt(sides * sides + 4 * area * rest)) : 0;
}

std::size_t first_cells(std::size_t patches) {
  const double wanted = cells_a_patch * std::sqrt(static_cast<double>(patches));
  std::size_t cells = min_cells;
  while (cells < max_cells && static_cast<double>(cells) < wanted)
    cells *= 2;
  return cells;
}

}  // namespace

Atlas make_atlas(const PatchGraph& graph, const AtlasOptions& options, const base::Host& host) {
  if (options.size < 1 || options.size > max_size)
    throw base::Error("invalid-argument", "an atlas has from 1 to 16384 texels along a side");
  if (!std::isfinite(options.padding) || options.padding < 0)
    throw base::Error("invalid-argument", "the padding of an atlas is a number of at least 0");
  Atlas atlas(host.memory);
  atlas.options = options;
  const PatchBoxes boxes(graph, host);
  const double high = scale_bound(boxes, options);
  for (std::size_t cells = first_cells(graph.patches()); high > 0 && cells <= max_cells; cells *= 2) {
    if (!pack_largest(boxes, high, cells, atlas, host)) continue;
    const double side = atlas.scale / options.size;
    atlas.coverage = area_of(boxes) * side * side;
    return atlas;
  }
  throw base::Error("unsupported", "an atlas of " + std::to_string(options.size) +
                                       " texels along a side is too small for " + std::to_string(graph.patches()) +
                                       " patches with their padding");
}

std::array<double, 2> texel_of(const Atlas& atlas, const PatchGraph& graph, Index patch, const Vector3& on_polycube) {
  const AtlasPlace& place = atlas.places[patch];
  const AxisLabel label = graph.labels[patch];
  const double u = sign_of(label) * on_polycube[static_cast<Eigen::Index>(first_axis(label))];
  const double v = on_polycube[static_cast<Eigen::Index>(second_axis(label))];
  const auto [x, y] = in_place(place, u, v);
  return {place.left + atlas.scale * x, place.top + atlas.scale * y};
}

}  // namespace orbicube::polycube
