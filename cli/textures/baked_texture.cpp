#include "textures/baked_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "files/surface_file.h"
#include "gltf/reading/read.h"
#include "gltf/reading/surface_colors.h"
#include "mesh/search/nearest.h"
#include "sphere_map/sampling/png_file.h"
#include "textures/stored_image.h"

namespace orbicube::cli {
namespace {

// Linear light of each level of sRGB (IEC 61966-2-1), and the level nearest to an amount of light.
class Srgb {
 public:
  Srgb() {
    for (std::size_t i = 0; i < linear_.size(); ++i)
      linear_[i] = light(static_cast<double>(i) / 255);
    for (std::size_t i = 0; i < borders_.size(); ++i)
      borders_[i] = light((static_cast<double>(i) + 0.5) / 255);
  }

  double linear(std::uint8_t level) const { return linear_[level]; }
  std::uint8_t level(double amount) const {
    return static_cast<std::uint8_t>(std::upper_bound(borders_.begin(), borders_.end(), amount) - borders_.begin());
  }

 private:
  static double light(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

  std::array<double, 256> linear_{};
  std::array<double, 255> borders_{};
};

// The pixel that a number beyond the image stands for.
std::size_t wrapped(double pixel, std::size_t size, gltf::Wrap wrap) {
  const auto n = static_cast<double>(size);
  double at = pixel;
  if (wrap == gltf::Wrap::repeat) at = pixel - n * std::floor(pixel / n);
  if (wrap == gltf::Wrap::mirror) {
    at = pixel - 2 * n * std::floor(pixel / (2 * n));
    at = std::min(at, 2 * n - 1 - at);
  }
  return static_cast<std::size_t>(std::clamp(at, 0.0, n - 1));
}

using Color = std::array<double, 3>;

// The linear color of an image, mixed from four pixels.
Color sample(const StoredImage& image, const std::array<gltf::Wrap, 2>& wrap, const std::array<double, 2>& at,
             const Srgb& srgb) {
  const double x = at[0] * static_cast<double>(image.width) - 0.5, y = at[1] * static_cast<double>(image.height) - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  Color color{};
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const double weight = (dx == 0 ? left + 1 - x : x - left) * (dy == 0 ? top + 1 - y : y - top);
      const std::size_t pixel =
          wrapped(top + dy, image.height, wrap[1]) * image.width + wrapped(left + dx, image.width, wrap[0]);
      for (std::size_t k = 0; k < 3; ++k)
        color[k] += weight * srgb.linear(image.rgb[3 * pixel + k]);
    }
  }
  return color;
}

// A glTF surface with its colors, decoded.
class ColoredSurface {
 public:
  ColoredSurface(const std::filesystem::path& path, const base::Host& host)
      : mesh_(gltf::read(path, {}, host, nullptr, &kept_)), colors_(host.memory) {
    if (kept_ == nullptr)
      throw Failure(Exit::wrong_input, path.string(), "unsupported", "its materials cannot be read");
    colors_ = gltf::surface_colors(*kept_, host);
    for (const gltf::ColorMaterial& material : colors_.materials) {
      images_.push_back(material.image.empty() ? StoredImage(host.memory) : decoded(material.image, host));
      if (!material.image.empty() && images_.back().rgb.empty())
        throw Failure(Exit::wrong_input, path.string(), "unsupported", "a texture is neither PNG nor JPEG, or damaged");
    }
    search_.emplace(mesh_.positions, mesh_.triangles, host);
  }

  // Near points with the same hint are found faster.
  Color at(const mesh::Vector3& point, mesh::Index& hint) const {
    const mesh::SurfacePoint place = search_->nearest(point, hint);
    hint = place.triangle;
    if (place.triangle == mesh::no_index) return {1, 1, 1};
    const std::uint32_t number = colors_.triangle_materials[place.triangle];
    const gltf::ColorMaterial& material = colors_.materials[number];
    std::array<double, 2> at{};
    Color color{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double weight = place.weights[static_cast<Eigen::Index>(corner)];
      for (std::size_t k = 0; k < 2; ++k)
        at[k] += weight * colors_.coordinates[place.triangle][corner][k];
      for (std::size_t k = 0; k < 3; ++k)
        color[k] += weight * material.factor[k] * colors_.vertex_colors[place.triangle][corner][k];
    }
    if (material.image.empty()) return color;
    const Color texture = sample(images_[number], material.wrap, at, srgb_);
    for (std::size_t k = 0; k < 3; ++k)
      color[k] *= texture[k];
    return color;
  }
  std::uint8_t level(double amount) const { return srgb_.level(amount); }

 private:
  std::unique_ptr<gltf::Kept> kept_;
  mesh::Mesh mesh_;
  gltf::SurfaceColors colors_;
  std::vector<StoredImage> images_;
  std::optional<mesh::SurfaceSearch> search_;
  Srgb srgb_;
};

mesh::Vector3 blend_of(const polycube::SurfaceMap& map, std::span<const mesh::Vector3> places, mesh::Index triangle,
                       const mesh::Vector3& weights) {
  const mesh::Triangle& t = map.triangles[triangle];
  return weights[0] * places[t[0]] + weights[1] * places[t[1]] + weights[2] * places[t[2]];
}

mesh::Vector3 weights_of(const AtlasOfMap& of, mesh::Index texel) {
  return polycube::weights_at(of.corners, of.texels, texel);
}

}  // namespace

base::Array<std::byte> checker_of_atlas(const AtlasOfMap& of, const mesh::Vector3& low, double square,
                                        const base::Host& host) {
  constexpr std::array<std::uint8_t, 6> palette = {235, 235, 235, 70, 110, 160};  // sRGB
  const std::uint32_t size = of.texels.size;
  const auto is_second = [&](mesh::Index texel) {
    const mesh::Index triangle = of.texels.triangles[texel];
    const mesh::Vector3 at = (blend_of(of.map, of.map.polycube, triangle, weights_of(of, texel)) - low) / square;
    const int axis = polycube::axis_of(of.map.labels[triangle]);
    return std::fmod(std::floor(at[(axis + 1) % 3]) + std::floor(at[(axis + 2) % 3]), 2.0) != 0;
  };
  base::Array<std::byte> rows(host.memory);
  rows.reserve(std::size_t{size} * ((size + 7) / 8));
  for (std::uint32_t row = 0; row < size; ++row) {
    host.report("texture", row, size);
    for (std::uint32_t column = 0; column < size; column += 8) {
      unsigned bits = 0;
      for (std::uint32_t i = 0; i < 8 && column + i < size; ++i) {
        const mesh::Index shown = of.texels.shown[row * size + column + i];
        if (shown != mesh::no_index && is_second(shown)) bits |= 1U << (7U - i);
      }
      rows.push_back(static_cast<std::byte>(bits));
    }
  }
  base::PngImage image;
  image.width = image.height = size;
  image.bits = 1;
  image.color = base::PngColor::palette;
  image.palette = std::as_bytes(std::span(palette));
  image.rows = rows;
  return sphere_map::png_file(image, host);
}

void require_colored(const std::filesystem::path& input) {
  if (!is_gltf(input))
    throw Failure(Exit::wrong_input, input.string(), "unsupported",
                  "--texture takes the colors of glTF files: " + gltf_endings);
}

base::Array<std::byte> colors_of_input(const AtlasOfMap& of, const std::filesystem::path& input,
                                       const base::Host& host) {
  const ColoredSurface surface(input, host);
  const std::uint32_t size = of.texels.size;
  base::Array<std::uint8_t> rgb(std::size_t{3} * size * size, std::uint8_t{255}, host.memory);
  mesh::Index hint = mesh::no_index;
  for (mesh::Index texel = 0; texel < of.texels.triangles.size(); ++texel) {
    if (texel % 1024 == 0) host.report("texture", texel, of.texels.triangles.size());
    const mesh::Index triangle = of.texels.triangles[texel];
    if (triangle == mesh::no_index) continue;
    const Color color = surface.at(blend_of(of.map, of.map.positions, triangle, weights_of(of, texel)), hint);
    for (std::size_t k = 0; k < 3; ++k)
      rgb[3 * std::size_t{texel} + k] = surface.level(color[k]);
  }
  for (mesh::Index texel = 0; texel < of.texels.shown.size(); ++texel) {
    const mesh::Index shown = of.texels.shown[texel];
    if (shown != mesh::no_index && shown != texel)
      std::copy_n(rgb.begin() + std::ptrdiff_t{3} * shown, 3, rgb.begin() + std::ptrdiff_t{3} * texel);
  }
  base::PngImage image;
  image.width = image.height = size;
  image.rows = std::as_bytes(std::span(rgb));
  return sphere_map::png_file(image, host);
}

}  // namespace orbicube::cli
