// Geometry images from PNG files of up to 16 bits a channel, by libspng (png_by_spng.cpp) or, in builds without it, by
// stb_image (png_without_spng.cpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/host.h"
#include "sphere_map/sampling/geometry_image.h"

namespace orbicube::sphere_map {

// The key of the text that has the box, low and high corner.
inline constexpr std::string_view box_key = "orbicube-box";

// Returns the image of a file. Throws Error "parse", "truncated", "unsupported", "cancelled".
GeometryImage image_of_png(std::span<const std::byte> file, const base::Host& host);

// For both ways to read. Sets layout, resolution and size, not yet the pixels; throws Error "parse" for another size,
// "truncated" where a file of so few bytes cannot have them.
void set_png_size(GeometryImage& image, std::size_t width, std::size_t height, std::size_t file_bytes);

// The corners of the box, 0 and 1 without a text. Throws Error "parse".
std::array<Vector3, 2> box_of(std::string_view text);

// The point that three levels of a pixel stand for.
inline Vector3 point_in(const std::array<Vector3, 2>& box, const std::uint16_t* levels) {
  Vector3 point;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double share = levels[k] / 65535.0;
    point[k] = (1 - share) * box[0][k] + share * box[1][k];
  }
  return point;
}

}  // namespace orbicube::sphere_map
