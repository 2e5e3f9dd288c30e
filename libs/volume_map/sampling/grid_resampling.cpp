#include "volume_map/sampling/grid_resampling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/place_text.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "untangle/tetrahedra/elements.h"

namespace orbicube::volume_map {
namespace {

using Planes = std::array<Array<double>, 3>;

// The coordinates of the planes of the boundary, by axis.
Planes planes_of(std::span<const Vector3> image, std::span<const Tetrahedron> tetrahedra, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(image.size(), tetrahedra, host);
  Planes planes{Array<double>(host.memory), Array<double>(host.memory), Array<double>(host.memory)};
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (!connectivity.on_boundary(face)) continue;
    const auto [a, b, c] = connectivity.vertices(face);
    bool flat = false;
    for (std::size_t k = 0; k < 3 && !flat; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      // Equal to the bit: a plane of a polycube.
      flat = !(image[a][axis] < image[b][axis]) && !(image[a][axis] > image[b][axis]) &&
             !(image[a][axis] < image[c][axis]) && !(image[a][axis] > image[c][axis]);
      if (flat) planes[k].push_back(image[a][axis]);
    }
    if (!flat)
      throw base::Error("no-valid-result", "the image is no polycube: a triangle of its boundary at " +
                                               mesh::place_text(image[a]) + ", lies in no plane across an axis");
  }
  for (Array<double>& p : planes) {
    std::sort(p.begin(), p.end());
    p.erase(std::unique(p.begin(), p.end()), p.end());
  }
  return planes;
}

// With others between them, `length` apart or about so.
Array<double> refined(const Array<double>& planes, double length) {
  Array<double> result(planes.get_allocator());
  for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
    const double gap = planes[i + 1] - planes[i];
    const double steps = std::max(1.0, std::round(gap / length));
    for (double k = 0; k < steps; ++k)
      result.push_back(planes[i] + gap * (k / steps));
  }
  result.push_back(planes.back());
  return result;
}

void measure(ResampledGrid& grid) {
  // Of each corner its neighbors, counter-clockwise seen from outside.
  constexpr std::array<std::array<std::size_t, 3>, 8> neighbors = {
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  grid.min_scaled_jacobian = grid.hexahedra.empty() ? 0 : 1;
  for (const mesh::Hexahedron& h : grid.hexahedra) {
    double least = 1;
    bool positive = true;
    for (std::size_t k = 0; k < 8; ++k) {
      const Vector3& p = grid.positions[h[k]];
      const auto at = [&](std::size_t n) { return grid.positions[h[neighbors[k][n]]]; };
      const Vector3 a = at(0) - p, b = at(1) - p, c = at(2) - p;
      const double lengths = a.norm() * b.norm() * c.norm();
      least = std::min(least, lengths > 0 ? a.dot(b.cross(c)) / lengths : 0);
      positive = positive && mesh::orientation_3d(p, at(0), at(1), at(2)) > 0;
    }
    grid.not_positive += positive ? 0 : 1;
    grid.min_scaled_jacobian = std::min(grid.min_scaled_jacobian, least);
    grid.mean_scaled_jacobian += least / static_cast<double>(grid.hexahedra.size());
  }
}

}  // namespace

ResampledGrid resample_grid(std::span<const Vector3> source, std::span<const Vector3> image,
                            std::span<const Tetrahedron> tetrahedra, std::size_t cells, const base::Host& host) {
  base::require(source.size() == image.size(), "source and image have not the same number of vertices");
  base::require(cells > 0 && cells <= 10'000'000, "the number of cells must be from 1 to 10 million");
  if (tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
  double volume = 0;
  for (const Tetrahedron& t : tetrahedra)
    volume += untangle::six_volumes(image, t) / 6;
  base::require(volume > 0, "the image has no volume");
  const double length = std::cbrt(volume / static_cast<double>(cells));
  Planes grid = planes_of(image, tetrahedra, host);
  constexpr double max_boxes = 5e7;
  double boxes = 1;
  for (Array<double>& planes : grid) {
    planes = refined(planes, length);
    boxes *= static_cast<double>(planes.size());
  }
  if (boxes > max_boxes) throw base::Error("no-valid-result", "the grid has too many boxes; request fewer cells");
  const PointLocator locator(image, tetrahedra, host);
  ResampledGrid result(host.memory);
  const std::size_t nx = grid[0].size(), ny = grid[1].size(), nz = grid[2].size();
  Array<Index> number(nx * ny * nz, no_index, host.memory);
  const auto vertex = [&](std::size_t i, std::size_t j, std::size_t k) {
    Index& n = number[(k * ny + j) * nx + i];
    if (n != no_index) return n;
    n = static_cast<Index>(result.positions.size());
    const Vector3 at(grid[0][i], grid[1][j], grid[2][k]);
    // On the boundary, where rounding decides between in and out.
    constexpr double boundary_tolerance = 1e-6;
    const Location found = locator.locate(at, boundary_tolerance);
    if (found.tetrahedron == no_index)
      throw base::Error("no-valid-result", "no tetrahedron has the vertex of the grid at " + mesh::place_text(at));
    result.parameters.push_back(at);
    result.positions.push_back(found.at(source, tetrahedra));
    return n;
  };
  for (std::size_t k = 0; k + 1 < nz; ++k) {
    for (std::size_t j = 0; j + 1 < ny; ++j) {
      host.report("resample", k * ny + j, nz * ny);
      for (std::size_t i = 0; i + 1 < nx; ++i) {
        const Vector3 center(0.5 * (grid[0][i] + grid[0][i + 1]), 0.5 * (grid[1][j] + grid[1][j + 1]),
                             0.5 * (grid[2][k] + grid[2][k + 1]));
        if (locator.locate(center).tetrahedron == no_index) continue;
        result.hexahedra.push_back({vertex(i, j, k), vertex(i + 1, j, k), vertex(i + 1, j + 1, k), vertex(i, j + 1, k),
                                    vertex(i, j, k + 1), vertex(i + 1, j, k + 1), vertex(i + 1, j + 1, k + 1),
                                    vertex(i, j + 1, k + 1)});
      }
    }
  }
  measure(result);
  return result;
}

}  // namespace orbicube::volume_map
