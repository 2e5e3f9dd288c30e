#include "sphere_map/sampling/geometry_image.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <string>

#include "base/error.h"
#include "sphere_map/sampling/grids.h"
#include "sphere_map/sampling/sampling.h"

namespace orbicube::sphere_map {
namespace {

constexpr std::size_t finest = 4096;

GridKind grid_of(ImageLayout layout) {
  return layout == ImageLayout::octahedron ? GridKind::octahedron : GridKind::cube;
}

// The grid's vertex at a pixel.
Index vertex_at(ImageLayout layout, std::size_t n, std::size_t column, std::size_t row) {
  if (layout == ImageLayout::octahedron) return octahedron_vertex(n, column, row);
  const std::size_t face = column / (n + 1) + 3 * (row / (n + 1));
  const std::size_t axis = face / 2;
  const std::size_t along = column % (n + 1);
  std::array<std::size_t, 3> lattice{};
  lattice[axis] = face % 2 == 0 ? n : 0;
  lattice[(axis + 1) % 3] = face % 2 == 0 ? along : n - along;  // as seen from outside
  lattice[(axis + 2) % 3] = n - row % (n + 1);
  return cube_vertex(n, lattice[0], lattice[1], lattice[2]);
}

// visit(pixel, vertex) for each pixel.
template <class Visit>
void for_each_pixel(ImageLayout layout, std::size_t n, const base::Host& host, const Visit& visit) {
  const auto [width, height] = image_size(layout, n);
  for (std::size_t row = 0; row < height; ++row) {
    host.report("pixels", row, height);
    for (std::size_t column = 0; column < width; ++column)
      visit(row * width + column, vertex_at(layout, n, column, row));
  }
}

}  // namespace

ImageSize image_size(ImageLayout layout, std::size_t resolution) {
  if (layout != ImageLayout::octahedron && layout != ImageLayout::cube)
    throw base::Error("invalid-argument", "unknown layout of an image");
  const bool octahedron = layout == ImageLayout::octahedron;
  if (resolution == 0 || resolution > finest || (octahedron && resolution % 2 != 0)) {
    throw base::Error("invalid-argument", "the resolution of an image is " +
                                              std::string(octahedron ? "an even number from 2" : "from 1") + " to " +
                                              std::to_string(finest) + ", not " + std::to_string(resolution));
  }
  const std::size_t side = resolution + 1;
  return octahedron ? ImageSize{side, side} : ImageSize{3 * side, 2 * side};
}

std::optional<ImageLayout> layout_of_size(std::size_t width, std::size_t height) {
  if (width == height && width >= 3 && width <= finest + 1 && width % 2 == 1) return ImageLayout::octahedron;
  if (width % 3 == 0 && height % 2 == 0 && width / 3 == height / 2 && height / 2 >= 2 && height / 2 <= finest + 1)
    return ImageLayout::cube;
  return std::nullopt;
}

GeometryImage make_geometry_image(const Locator& locator, std::span<const Vector3> vectors, ImageLayout layout,
                                  std::size_t resolution, const base::Host& host) {
  GeometryImage image(host.memory);
  const auto [width, height] = image_size(layout, resolution);
  image.layout = layout;
  image.resolution = resolution;
  image.width = width;
  image.height = height;
  const Grid grid = make_grid(grid_of(layout), resolution, host);
  const Array<Vector3> sampled = sample_vectors(locator, grid.directions, vectors, Interpolation::linear, host);
  image.pixels.resize(width * height);
  for_each_pixel(layout, resolution, host, [&](std::size_t pixel, Index v) { image.pixels[pixel] = sampled[v]; });
  return image;
}

ImageSurface surface_of(const GeometryImage& image, const base::Host& host) {
  const auto [width, height] = image_size(image.layout, image.resolution);
  if (image.width != width || image.height != height || image.pixels.size() != width * height)
    throw base::Error("invalid-argument", "the image has not the size of its layout and resolution");
  Grid grid = make_grid(grid_of(image.layout), image.resolution, host);
  ImageSurface result(host.memory);
  // The mean, by differences from the first, so that equal pixels give themselves to the bit.
  Array<Vector3>& positions = result.mesh.positions;
  Array<Index> count(grid.directions.size(), 0, host.memory);
  Array<Vector3> difference(grid.directions.size(), Vector3::Zero(), host.memory);
  positions.resize(grid.directions.size());
  for_each_pixel(image.layout, image.resolution, host, [&](std::size_t pixel, Index v) {
    if (!image.pixels[pixel].allFinite())
      throw base::Error("invalid-argument", "pixel " + std::to_string(pixel) + " is not finite");
    if (count[v]++ == 0) {
      positions[v] = image.pixels[pixel];
    } else {
      difference[v] += image.pixels[pixel] - positions[v];
      result.seam_gap = std::max(result.seam_gap, (image.pixels[pixel] - positions[v]).norm());
    }
  });
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] += difference[v] / static_cast<double>(count[v]);
  result.mesh.triangles = std::move(grid.triangles);
  return result;
}

}  // namespace orbicube::sphere_map
