// PNG files, by libspng or without it: what another reader finds in them, and what is read of files of others.
#include "sphere_map/sampling/png_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "sphere_map/sampling/geometry_image_png.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

using namespace orbicube;
using base::PngColor;
using base::PngImage;
using Bytes = std::vector<std::byte>;

namespace {

// Rows of numbers between smooth and random, so that each filter of PNG is the best of some row.
Bytes rows_of(std::size_t row_bytes, std::size_t height, unsigned max) {
  Bytes rows;
  std::uint32_t state = 1;
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < row_bytes; ++x) {
      state = state * 1664525 + 1013904223;
      const auto smooth = static_cast<unsigned>(3 * x + y * y / 7);
      rows.push_back(static_cast<std::byte>((y % 3 == 0 ? smooth : smooth + (state >> 24) / (1 + y % 5)) % (max + 1)));
    }
  }
  return rows;
}

// 8 bits a channel, three channels a pixel, by stb_image.
std::vector<std::uint8_t> decoded(std::span<const std::byte> file, const PngImage& image) {
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), static_cast<int>(file.size()), &width,
                            &height, &channels, 3),
      &stbi_image_free);
  REQUIRE(pixels != nullptr);
  REQUIRE(static_cast<std::uint32_t>(width) == image.width);
  REQUIRE(static_cast<std::uint32_t>(height) == image.height);
  return {pixels.get(), pixels.get() + std::size_t{3} * image.width * image.height};
}

std::string kind_of(const auto& call) {
  try {
    call();
  } catch (const base::Error& error) {
    return error.kind();
  }
  return "";
}

void put_big_endian(Bytes& to, std::uint32_t word) {
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    to.push_back(static_cast<std::byte>(word >> shift & 0xFFU));
}

void put_chunk(Bytes& file, const std::string& type, const Bytes& content) {
  put_big_endian(file, static_cast<std::uint32_t>(content.size()));
  const std::size_t begin = file.size();
  for (const char c : type)
    file.push_back(static_cast<std::byte>(c));
  file.insert(file.end(), content.begin(), content.end());
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t i = begin; i < file.size(); ++i) {
    crc ^= static_cast<std::uint32_t>(file[i]);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  put_big_endian(file, ~crc);
}

// A file of 16 bits a channel, red, green and blue, from filtered rows of less than 64 KB, stored without compression.
Bytes file_of(std::uint32_t side, bool interlaced, const Bytes& lines, const Bytes& text) {
  Bytes file, header, data;
  for (const char c : std::string("\x89PNG\r\n\x1A\n"))
    file.push_back(static_cast<std::byte>(c));
  put_big_endian(header, side);
  put_big_endian(header, side);
  for (const int byte : {16, 2, 0, 0, interlaced ? 1 : 0})
    header.push_back(static_cast<std::byte>(byte));
  put_chunk(file, "IHDR", header);
  const auto length = static_cast<unsigned>(lines.size());
  for (const unsigned byte : {0x78U, 1U, 1U, length & 0xFFU, length >> 8U, ~length & 0xFFU, (~length >> 8U) & 0xFFU})
    data.push_back(static_cast<std::byte>(byte));
  data.insert(data.end(), lines.begin(), lines.end());
  std::uint32_t low = 1, high = 0;
  for (const std::byte byte : lines) {
    low = (low + static_cast<std::uint32_t>(byte)) % 65521U;
    high = (high + low) % 65521U;
  }
  put_big_endian(data, high << 16U | low);
  put_chunk(file, "IDAT", data);
  if (!text.empty()) put_chunk(file, "tEXt", text);
  put_chunk(file, "IEND", {});
  return file;
}

// The pixel at a place: channels that differ in their high and low bytes.
std::uint32_t level_at(std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
  return 65535 - 9000 * x - 5000 * y - 257 * channel;
}

// Rows of a pass of Adam7 (or of the whole), each after a byte for no filter.
void put_pass(Bytes& lines, std::uint32_t side, std::uint32_t x0, std::uint32_t y0, std::uint32_t dx,
              std::uint32_t dy) {
  for (std::uint32_t y = y0; y < side && x0 < side; y += dy) {
    lines.push_back(std::byte{0});
    for (std::uint32_t x = x0; x < side; x += dx) {
      for (std::uint32_t channel = 0; channel < 3; ++channel) {
        lines.push_back(static_cast<std::byte>(level_at(x, y, channel) >> 8U));
        lines.push_back(static_cast<std::byte>(level_at(x, y, channel) & 0xFFU));
      }
    }
  }
}

}  // namespace

TEST_CASE("Another reader finds the pixels of a PNG file") {
  const std::vector<std::uint8_t> palette = {235, 235, 235, 70, 110, 160, 1, 2, 3};
  for (const auto& [bits, color, width] : {std::tuple{1, PngColor::palette, 77},
                                           {8, PngColor::palette, 31},
                                           {8, PngColor::rgb, 53},
                                           {16, PngColor::rgb, 40}}) {
    PngImage image;
    image.width = static_cast<std::uint32_t>(width);
    image.height = 61;
    image.bits = static_cast<std::uint8_t>(bits);
    image.color = color;
    if (color == PngColor::palette) image.palette = std::as_bytes(std::span(palette).first(bits == 1 ? 6 : 9));
    const std::size_t row_bytes = (image.width * (color == PngColor::rgb ? 3 : 1) * image.bits + 7) / 8;
    const Bytes rows = rows_of(row_bytes, image.height, color == PngColor::palette && bits == 8 ? 2 : 255);
    image.rows = rows;
    CHECK(base::checked_row_bytes(image) == row_bytes);
    const auto file = sphere_map::png_file(image, base::Host());
    CHECK(file == sphere_map::png_file(image, base::Host()));
    const std::vector<std::uint8_t> pixels = decoded(file, image);
    CHECK(pixels == decoded(base::stored_png(image, std::pmr::get_default_resource()), image));
    bool same = true;
    for (std::size_t y = 0; y < image.height; ++y) {
      for (std::size_t x = 0; x < image.width; ++x) {
        for (std::size_t k = 0; k < 3; ++k) {
          const auto byte = [&](std::size_t i) { return static_cast<unsigned>(rows[y * row_bytes + i]); };
          unsigned expected = 0;
          if (color == PngColor::rgb)
            expected = bits == 8 ? byte(3 * x + k) : byte(2 * (3 * x + k));
          else
            expected = palette[3 * (bits == 8 ? byte(x) : byte(x / 8) >> (7 - x % 8) & 1U) + k];
          same = same && pixels[3 * (y * image.width + x) + k] == expected;
        }
      }
    }
    CHECK(same);
  }
}

TEST_CASE("PNG files are compressed in builds with libspng, and can be cancelled at each row") {
  PngImage image;
  image.width = image.height = 512;
  const Bytes rows(std::size_t{3} * image.width * image.height, std::byte{100});
  image.rows = rows;
  const auto file = sphere_map::png_file(image, base::Host());
  if (sphere_map::version_of_spng() == nullptr) {
    CHECK(file.size() > rows.size());
    return;
  }
  CHECK(file.size() < rows.size() / 100);
  std::size_t reports = 0;
  base::Host host;
  host.on_progress = [&](const base::Progress& progress) {
    ++reports;
    CHECK(progress.total == image.height);
    return false;
  };
  CHECK(kind_of([&] { (void)sphere_map::png_file(image, host); }) == "cancelled");
  CHECK(reports == 1);
}

TEST_CASE("Images that no PNG file can have are refused") {
  PngImage image;
  const Bytes rows(300);
  image.rows = rows;
  const auto kind = [&] { return kind_of([&] { (void)sphere_map::png_file(image, base::Host()); }); };
  CHECK(kind() == "invalid-argument");  // no pixels
  image.width = image.height = 10;
  CHECK(kind() == "");
  image.height = 11;
  CHECK(kind() == "invalid-argument");
  image.width = 20000;
  CHECK(kind() == "invalid-argument");
}

TEST_CASE("Geometry images of other programs are read: interlaced, with texts behind the pixels, or large") {
  constexpr std::uint32_t side = 5;
  Bytes plain, passes;
  put_pass(plain, side, 0, 0, 1, 1);
  for (const auto& [x0, y0, dx, dy] : {std::array{0U, 0U, 8U, 8U},
                                       {4U, 0U, 8U, 8U},
                                       {0U, 4U, 4U, 8U},
                                       {2U, 0U, 4U, 4U},
                                       {0U, 2U, 2U, 4U},
                                       {1U, 0U, 2U, 2U},
                                       {0U, 1U, 1U, 2U}})
    put_pass(passes, side, x0, y0, dx, dy);
  Bytes text;
  for (const char c : std::string("orbicube-box\0"
                                  "0 0 0 65535 131070 65535",
                                  13 + 24))
    text.push_back(static_cast<std::byte>(c));
  const auto read = [](const Bytes& file) { return sphere_map::image_of_png(file, base::Host()); };
  const auto image = read(file_of(side, false, plain, {})), in_passes = read(file_of(side, true, passes, {})),
             in_box = read(file_of(side, true, passes, text));
  for (std::uint32_t i = 0; i < side * side; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double level = level_at(i % side, i / side, k);
      const auto axis = static_cast<Eigen::Index>(k);
      CHECK(image.pixels[i][axis] == level / 65535);
      CHECK(in_box.pixels[i][axis] == doctest::Approx(k == 1 ? 2 * level : level).epsilon(1e-15));
    }
  }
  CHECK(image.pixels == in_passes.pixels);

  // One block of data of more than what texts may have.
  PngImage large;
  large.width = large.height = 1801;
  large.bits = 16;
  const Bytes rows(std::size_t{6} * large.width * large.height, std::byte{255});
  large.rows = rows;
  const auto stored = base::stored_png(large, std::pmr::get_default_resource());
  const auto pixels = sphere_map::image_of_png(stored, base::Host()).pixels;
  CHECK(std::all_of(pixels.begin(), pixels.end(), [](const mesh::Vector3& p) { return p == mesh::Vector3::Ones(); }));

  Bytes damaged = file_of(side, false, plain, {});
  damaged[60] ^= std::byte{1};
  if (sphere_map::version_of_spng() != nullptr)  // stb_image compares no checksums
    CHECK(kind_of([&] { read(damaged); }) == "parse");
  for (std::size_t size = 0; size + 16 < damaged.size(); ++size)
    CHECK(kind_of([&] { read(Bytes(damaged.begin(), damaged.begin() + static_cast<std::ptrdiff_t>(size))); }) != "");
}
