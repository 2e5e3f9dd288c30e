#include "repair/labels/surface_of_labels.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/search/intersections.h"
#include "repair/labels/crossings.h"
#include "repair/labels/extraction.h"
#include "repair/labels/label_voxels.h"
#include "repair/labels/voxel_topology.h"

namespace orbicube::repair {
namespace {

// Rounds in which vertices of intersecting triangles move to the middle of their edges. From one to the next, vertices
// around them may get into each other's way; with all in the middle no triangles intersect.
constexpr int max_rounds = 16;

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

struct ToWorld {
  Matrix linear;
  Vector3 offset;
  bool mirrors = false;
};

ToWorld to_world(const LabelImage& image, const std::array<double, 3>& origin) {
  ToWorld map;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      map.linear(row, column) = image.to_world[static_cast<std::size_t>(4 * row + column)];
    map.offset[row] = image.to_world[static_cast<std::size_t>(4 * row + 3)];
  }
  // Columns of length one: a tilt is judged without the spacing.
  Matrix unit = map.linear;
  for (int column = 0; column < 3; ++column)
    unit.col(column) /= unit.col(column).norm();
  const double volume = unit.determinant();
  if (!(std::abs(volume) > 1e-6))
    throw base::Error("invalid-argument",
                      "the map from voxels to the world is singular: two axes of the image have the same direction or "
                      "a spacing is 0");
  map.mirrors = volume < 0;
  map.offset += map.linear * Vector3(origin[0], origin[1], origin[2]);
  return map;
}

void check(const LabelOptions& o) {
  if (!(o.max_slide >= 0 && o.max_slide < 0.5))
    throw base::Error("invalid-argument", "the bound of slides is not at least 0 and below 0.5");
  if (!(o.smoothing >= 0 && o.smoothing <= 10))
    throw base::Error("invalid-argument", "the standard deviation of the smoothing is not from 0 to 10 voxels");
  if (o.cavities && !o.handles)
    throw base::Error("invalid-argument", "cavities can be kept only where handles are kept");
}

// Makes each part a ball: with several parts handles are only cut, because what closes a tunnel may join two parts.
void remove_handles_of(Voxels& voxels, const std::array<double, 3>& spacing, LabelReport& report,
                       const base::Host& host) {
  const std::int64_t handles = static_cast<std::int64_t>(report.kept_parts) - euler_characteristic(voxels);
  if (handles == 0) return;
  report.handles = static_cast<std::size_t>(handles);
  const HandleVoxelFigures figures =
      report.kept_parts == 1 ? remove_handles(voxels, spacing, host) : cut_handles(voxels, spacing, host);
  report.added_voxels = figures.added_voxels;
  report.removed_voxels = figures.removed_voxels;
  // Parts that touch at edges or corners of voxels only stay apart, so that the count shows whether all are balls.
  if (euler_characteristic(voxels) != static_cast<std::int64_t>(report.kept_parts))
    throw base::Error("internal", "handles are left after all were removed");
}

void change_topology(Voxels& voxels, const LabelOptions& options, const ToWorld& map, LabelReport& report,
                     const base::Host& host) {
  VoxelPartFigures parts;
  keep_voxel_parts(voxels, options.keep, parts, host);
  report.found_parts = parts.found;
  report.kept_parts = parts.kept;
  report.dropped_voxels = parts.dropped_voxels;
  if (!options.cavities) {
    fill_cavities(voxels, parts, host);
    report.cavities = parts.cavities;
    report.filled_voxels = parts.filled_voxels;
    if (parts.filled_voxels > 0 && parts.kept > 1) {  // parts inside others are filled in
      VoxelPartFigures left;
      keep_voxel_parts(voxels, 0, left, host);
      report.kept_parts = left.kept;
    }
  }
  if (options.handles) return;
  const std::array<double, 3> spacing = {map.linear.col(0).norm(), map.linear.col(1).norm(), map.linear.col(2).norm()};
  remove_handles_of(voxels, spacing, report, host);
}

void place_vertices(const VoxelSurface& surface, const Voxels& voxels, const ToWorld& map, Array<Vector3>& positions) {
  positions.resize(surface.vertex_count());
  for (Index v = 0; v < positions.size(); ++v)
    positions[v] = map.linear * place_of(surface, voxels, v) + map.offset;
}

// Moves the vertices of intersecting triangles to the middle of their edges, until none intersect.
void separate(VoxelSurface& surface, const Voxels& voxels, const ToWorld& map, LabelSurface& result,
              const base::Host& host) {
  base::Stage stage(host, 0.5);
  for (int round = 0; round < max_rounds; ++round) {
    const auto pairs = mesh::intersecting_triangles(result.positions, result.triangles, host);
    if (pairs.empty()) return;
    std::size_t centered = 0;
    const auto center = [&](Index v) {
      if (surface.edge_axis[v] == 3 || surface.crossing[v] == 0.5) return;
      surface.crossing[v] = 0.5;
      ++centered;
    };
    for (const auto& pair : pairs) {
      for (const Index t : pair) {
        for (const Index v : surface.triangles[t]) {
          center(v);
          if (surface.edge_axis[v] != 3) continue;
          const std::size_t loop = surface.edge_voxel[v];
          for (std::size_t i = surface.loop_start[loop]; i < surface.loop_start[loop + 1]; ++i)
            center(surface.loop[i]);
        }
      }
    }
    if (centered == 0) return;  // see the certificate
    result.report.centered_vertices += centered;
    place_vertices(surface, voxels, map, result.positions);
  }
}

}  // namespace

LabelSurface surface_of_label(const LabelImage& image, const LabelOptions& options, const base::Host& host) {
  check(options);
  LabelVoxels object = voxels_of_label(image, options.label, host);
  const ToWorld map = to_world(image, object.origin);
  LabelSurface result(host.memory);
  LabelReport& report = result.report;
  report.label = object.label;
  report.voxels = object.count;
  report.border_voxels = object.border_count;
  change_topology(object.voxels, options, map, report, host);
  const SmoothedVoxels smoothed(object.voxels, options.smoothing, host);
  VoxelSurface surface = extract_surface(object.voxels, smoothed, options.max_slide, host);
  result.triangles = surface.triangles;
  if (map.mirrors) {
    for (Triangle& t : result.triangles)
      std::swap(t[1], t[2]);
  }
  place_vertices(surface, object.voxels, map, result.positions);
  separate(surface, object.voxels, map, result, host);
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    if (surface.edge_axis[v] < 3)
      report.largest_slide = std::max(report.largest_slide, std::abs(surface.crossing[v] - 0.5));
  }
  report.certificate = certify(result.positions, result.triangles, true, host);
  if (report.certificate.self_intersections > 0)
    throw base::Error("no-valid-result", "triangles of the surface intersect, the first is " +
                                             std::to_string(report.certificate.first_intersection) +
                                             "; coordinates that are large for their spacing leave too few digits");
  return result;
}

}  // namespace orbicube::repair
