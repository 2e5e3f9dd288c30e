// Geometry images as files: portable float maps (Debevec's PFM) and PNG with 16 bits a channel.
#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <new>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/file.h"
#include "sphere_map/sampling/geometry_image_png.h"
#include "sphere_map/sampling/png_file.h"

namespace orbicube::sphere_map {
namespace {

using Bytes = Array<std::byte>;

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
  if (ending != ".pfm" && ending != ".png")
    throw base::Error("unsupported-format", "geometry images end in .pfm or .png");
  return ending;
}

Bytes to_pfm(const GeometryImage& image, const base::Host& host) {
  // Below this, the numbers of float32 lose digits, in the end all.
  constexpr double min_size = 1e-30;
  Vector3 low = image.pixels[0], high = low;
  for (const Vector3& p : image.pixels) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (0.5 * high - 0.5 * low).maxCoeff();
  if (size > 0 && size < min_size)
    throw base::Error("invalid-argument", "the surface is too small for the numbers of float32");
  Bytes bytes(host.memory);
  const std::string head = "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  bytes.reserve(head.size() + 12 * image.pixels.size());
  for (const char c : head)
    bytes.push_back(static_cast<std::byte>(c));
  for (std::size_t row = image.height; row-- > 0;) {  // from the bottom
    host.report("writing the image", image.height - row, image.height);
    for (std::size_t column = 0; column < image.width; ++column) {
      for (const double x : image.pixels[row * image.width + column]) {
        const auto value = static_cast<float>(x);
        if (!std::isfinite(value)) throw base::Error("invalid-argument", "a pixel is beyond the numbers of float32");
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (const unsigned shift : {0U, 8U, 16U, 24U})
          bytes.push_back(static_cast<std::byte>(bits >> shift & 0xFFU));
      }
    }
  }
  return bytes;
}

Bytes to_png(const GeometryImage& image, const base::Host& host) {
  Vector3 low = image.pixels[0];
  Vector3 high = low;
  for (const Vector3& p : image.pixels) {
    if (!p.allFinite()) throw base::Error("invalid-argument", "a pixel is not finite");
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::string box;
  for (const Vector3& corner : {low, high}) {
    for (const double x : corner) {
      std::array<char, 32> digits;
      const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr;
      box.append(box.empty() ? "" : " ").append(digits.data(), end);
    }
  }
  Bytes rows(host.memory);
  rows.reserve(6 * image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (i % 65536 == 0) host.report("writing the image", i, image.pixels.size());
    for (Eigen::Index k = 0; k < 3; ++k) {
      // Halves, since the extent can overflow.
      const double extent = 0.5 * high[k] - 0.5 * low[k];
      const double share = extent > 0 ? (0.5 * image.pixels[i][k] - 0.5 * low[k]) / extent : 0;
      const auto level = static_cast<std::uint32_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
      rows.push_back(static_cast<std::byte>(level >> 8U));
      rows.push_back(static_cast<std::byte>(level & 0xFFU));
    }
  }
  base::PngImage png;
  png.width = static_cast<std::uint32_t>(image.width);
  png.height = static_cast<std::uint32_t>(image.height);
  png.bits = 16;
  png.rows = rows;
  png.text_key = box_key;
  png.text = box;
  return png_file(png, host);
}

// Sets layout, resolution and size, not yet the pixels.
void set_size(GeometryImage& image, std::size_t width, std::size_t height) {
  const auto layout = layout_of_size(width, height);
  if (!layout) {
    throw base::Error("parse", "an image of " + std::to_string(width) + " x " + base::counted(height, "pixel") +
                                   "; geometry images are squares of an odd side or 3 x 2 squares");
  }
  image.layout = *layout;
  image.width = width;
  image.height = height;
  image.resolution = (*layout == ImageLayout::octahedron ? width : height / 2) - 1;
}

GeometryImage from_pfm(std::span<const std::byte> bytes, const base::Host& host) {
  // Four words, each followed by one character.
  std::array<std::string_view, 4> words;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::size_t at = 0;
  for (std::string_view& word : words) {
    while (at < text.size() && at < 4096 && (text[at] == ' ' || text[at] == '\n' || text[at] == '\r'))
      ++at;
    const std::size_t begin = at;
    while (at < text.size() && at - begin < 64 && text[at] != ' ' && text[at] != '\n' && text[at] != '\r')
      ++at;
    word = text.substr(begin, at - begin);
  }
  ++at;  // the character behind the head
  if (words[0] != "PF")
    throw base::Error("parse", "no portable float map of three channels: it does not begin with PF");
  const auto number = [](std::string_view word, auto& value) {
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc() || end != word.data() + word.size())
      throw base::Error("parse", "the head of the portable float map has no number where one should be");
  };
  std::size_t width = 0, height = 0;
  double scale = 0;
  number(words[1], width);
  number(words[2], height);
  number(words[3], scale);
  if (!(scale != 0 && std::isfinite(scale))) throw base::Error("parse", "the scale of the portable float map is 0");
  GeometryImage image(host.memory);
  set_size(image, width, height);
  if (at > bytes.size() || (bytes.size() - at) / 12 < width * height)
    throw base::Error("truncated", "the file has fewer pixels than its head says");
  image.pixels.resize(width * height);
  for (std::size_t row = height; row-- > 0;) {
    host.report("reading the image", height - row, height);
    for (std::size_t column = 0; column < width; ++column) {
      for (double& x : image.pixels[row * width + column]) {
        std::uint32_t bits = 0;
        for (unsigned i = 0; i < 4; ++i)
          bits |= static_cast<std::uint32_t>(bytes[at++]) << (scale < 0 ? 8 * i : 24 - 8 * i);
        x = static_cast<double>(std::bit_cast<float>(bits));
        if (!std::isfinite(x)) throw base::Error("non-finite", "a pixel is not finite");
      }
    }
  }
  return image;
}

}  // namespace

void set_png_size(GeometryImage& image, std::size_t width, std::size_t height, std::size_t file_bytes) {
  // Deflate makes a byte of at most 1032; a pixel is at least a bit. No memory for what cannot be there.
  if (width * height / 8 > 1032 * file_bytes) throw base::Error("truncated", "the file has fewer pixels than it says");
  set_size(image, width, height);
}

std::array<Vector3, 2> box_of(std::string_view text) {
  std::array<Vector3, 2> box{Vector3::Zero(), Vector3::Ones()};
  if (text.empty()) return box;
  const char* at = text.data();
  const char* end = at + text.size();
  for (Vector3& corner : box) {
    for (double& x : corner) {
      while (at != end && *at == ' ')
        ++at;
      const auto [next, problem] = std::from_chars(at, end, x);
      if (problem != std::errc() || !std::isfinite(x)) throw base::Error("parse", "the box of the image is no box");
      at = next;
    }
  }
  return box;
}

void write_geometry_image(const std::filesystem::path& path, const GeometryImage& image, const base::Host& host) {
  const std::string ending = ending_of(path);
  const auto [width, height] = image_size(image.layout, image.resolution);
  if (image.width != width || image.height != height || image.pixels.size() != width * height)
    throw base::Error("invalid-argument", "the image has not the size of its layout and resolution");
  const Bytes bytes = ending == ".pfm" ? to_pfm(image, host) : to_png(image, host);
  mesh::OutputFile file(path);
  file.write(bytes);
  file.commit();
}

GeometryImage read_geometry_image(const std::filesystem::path& path, const base::Host& host) {
  const std::string ending = ending_of(path);
  const Bytes bytes = mesh::read_file(path, host);
  return ending == ".pfm" ? from_pfm(bytes, host) : image_of_png(bytes, host);
}

}  // namespace orbicube::sphere_map
