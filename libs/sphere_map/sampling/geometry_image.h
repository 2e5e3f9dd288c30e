// A closed surface as an image: each pixel is a point of it (Gu, Gortler and Hoppe, Geometry images, 2002; Praun and
// Hoppe, Spherical parametrization and remeshing, 2003). The sphere of its map is cut open along edges of an octahedron
// into a square, or along those of a cube into six tiles. Pixels that the cut has torn apart hold the same point, so
// that the surface which is read back is closed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::sphere_map {

enum class ImageLayout : std::int32_t {
  octahedron = 0,  // (resolution + 1) x (resolution + 1) pixels, an even resolution; grids.h says what is where
  cube = 1,        // 3 x 2 tiles of as many pixels: +x -x +y, below -y +z -z
};

struct GeometryImage {
  explicit GeometryImage(std::pmr::memory_resource* memory) : pixels(memory) {}

  ImageLayout layout = ImageLayout::octahedron;
  std::size_t resolution = 0;
  std::size_t width = 0, height = 0;
  Array<Vector3> pixels;  // row by row from the top
};

struct ImageSize {
  std::size_t width, height;
};
// Throws Error "invalid-argument" for an unknown layout, or a resolution that is not from 1 (octahedron: even, from 2)
// to 4096.
ImageSize image_size(ImageLayout layout, std::size_t resolution);

// What pixels the layout has, by the image's size; nothing when it is none that layouts have.
std::optional<ImageLayout> layout_of_size(std::size_t width, std::size_t height);

// The vectors of the vertices (positions, or normals with Interpolation::unit) as an image.
// Throws Error "invalid-argument" for sizes and resolutions, "cancelled".
GeometryImage make_geometry_image(const Locator& locator, std::span<const Vector3> vectors, ImageLayout layout,
                                  std::size_t resolution, const base::Host& host);

struct ImageSurface {
  explicit ImageSurface(std::pmr::memory_resource* memory) : mesh(memory) {}

  mesh::Mesh mesh;      // closed, of genus 0, oriented like the sphere; the vertices and triangles of the layout's grid
  double seam_gap = 0;  // the largest distance between pixels that are one vertex, whose mean it becomes; 0 as written
};

// The surface back from its image. Throws Error "invalid-argument" when the sizes do not fit or a pixel is not finite,
// "cancelled". O(pixels).
ImageSurface surface_of(const GeometryImage& image, const base::Host& host);

// Writes the image by the ending of the path, whole or not at all: .pfm holds float32 (portable float map, low byte
// first, three channels); .png 16 bits a channel from the low to the high corner of the bounding box, which a text
// chunk "orbicube-box" holds. Throws Error "unsupported-format" for another ending; "invalid-argument" when numbers are
// not finite, in float32 for .pfm; "io"; "cancelled".
void write_geometry_image(const std::filesystem::path& path, const GeometryImage& image, const base::Host& host);

// Reads what was written, or any image of three channels with such a size; PNG files of other programs, which have no
// box, fill the cube from 0 to 1. Throws Error "unsupported-format", "parse", "truncated", "io", "cancelled".
GeometryImage read_geometry_image(const std::filesystem::path& path, const base::Host& host);

}  // namespace orbicube::sphere_map
