#include "scenes/heat_map.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string_view>

#include "sphere_map/sampling/png_file.h"

namespace orbicube::cli {
namespace {

// Digits and what else numbers have, 5 x 7 points each: a row is 5 bits, the left one the highest.
constexpr std::string_view letters = "0123456789.e-+";
constexpr std::array<std::array<std::uint8_t, 7>, 14> shapes = {{{14, 17, 19, 21, 25, 17, 14},
                                                                 {4, 12, 4, 4, 4, 4, 14},
                                                                 {14, 17, 1, 2, 4, 8, 31},
                                                                 {31, 2, 4, 2, 1, 17, 14},
                                                                 {2, 6, 10, 18, 31, 2, 2},
                                                                 {31, 16, 30, 1, 1, 17, 14},
                                                                 {6, 8, 16, 30, 17, 17, 14},
                                                                 {31, 1, 2, 4, 8, 8, 8},
                                                                 {14, 17, 17, 14, 17, 17, 14},
                                                                 {14, 17, 17, 15, 1, 2, 12},
                                                                 {0, 0, 0, 0, 0, 12, 12},
                                                                 {0, 0, 14, 17, 31, 16, 14},
                                                                 {0, 0, 0, 31, 0, 0, 0},
                                                                 {0, 4, 4, 31, 4, 4, 0}}};
constexpr HeatColor black{0, 0, 0}, white{255, 255, 255};
constexpr int letter_width = 6, letter_height = 7;

class Picture {
 public:
  Picture(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), white) {}

  void fill(int x, int y, int width, int height, HeatColor color) {
    for (int j = std::max(y, 0); j < std::min(y + height, height_); ++j) {
      for (int i = std::max(x, 0); i < std::min(x + width, width_); ++i)
        pixels_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(i)] = color;
    }
  }
  // Text with its middle at (x, y).
  void write(std::string_view text, int x, int y, HeatColor color) {
    int left = x - static_cast<int>(text.size()) * letter_width / 2;
    for (const char c : text) {
      const std::size_t shape = letters.find(c);
      for (int row = 0; shape != std::string_view::npos && row < letter_height; ++row) {
        for (int bit = 0; bit < letter_width - 1; ++bit) {
          if ((shapes[shape][static_cast<std::size_t>(row)] >> (letter_width - 2 - bit) & 1) != 0)
            fill(left + bit, y - letter_height / 2 + row, 1, 1, color);
        }
      }
      left += letter_width;
    }
  }
  base::Array<std::byte> png(const base::Host& host) const {
    base::PngImage image;
    image.width = static_cast<std::uint32_t>(width_);
    image.height = static_cast<std::uint32_t>(height_);
    image.color = base::PngColor::rgb;
    static_assert(sizeof(HeatColor) == 3);
    image.rows = std::as_bytes(std::span(pixels_));
    return sphere_map::png_file(image, host);
  }

 private:
  int width_, height_;
  std::vector<HeatColor> pixels_;
};

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

}  // namespace

HeatColor heat_color(double share) {
  constexpr std::array<std::array<double, 3>, 6> stops{
      {{0, 0, 0}, {50, 20, 120}, {150, 30, 130}, {230, 80, 80}, {250, 170, 50}, {255, 255, 190}}};
  const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double part = at - static_cast<double>(first);
  const auto channel = [&](std::size_t k) {
    return static_cast<std::uint8_t>((1 - part) * stops[first][k] + part * stops[first + 1][k] + 0.5);
  };
  return {channel(0), channel(1), channel(2)};
}

base::Array<std::byte> heat_map_png(const std::vector<std::vector<double>>& matrix, const base::Host& host) {
  const int n = static_cast<int>(matrix.size());
  constexpr int margin = 28, scale_width = 16, scale_room = 84, wanted_size = 640, largest_cell = 64;
  const int cell = std::clamp(wanted_size / std::max(n, 1), 2, largest_cell);
  const int side = n * cell;
  double largest = 0;
  for (const std::vector<double>& row : matrix)
    largest = std::max(largest, *std::max_element(row.begin(), row.end()));
  const auto share_of = [&](double value) { return largest > 0 ? std::clamp(value / largest, 0.0, 1.0) : 0.0; };

  Picture picture(margin + side + scale_room, margin + std::max(side, 4 * margin) + margin / 2);
  constexpr int smallest_with_text = 40;  // six letters
  // The interval of numbered rows is such that the numbers do not touch.
  const int every = std::max(1, (4 * letter_width + cell - 1) / cell);
  for (int i = 0; i < n; ++i) {
    if (i % every == 0) {
      picture.write(std::to_string(i + 1), margin + i * cell + cell / 2, margin / 2, black);
      picture.write(std::to_string(i + 1), margin / 2, margin + i * cell + cell / 2, black);
    }
    for (int j = 0; j < n; ++j) {
      const double value = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      const int x = margin + j * cell, y = margin + i * cell;
      picture.fill(x, y, cell, cell, heat_color(share_of(value)));
      if (cell >= smallest_with_text)
        picture.write(short_number(value), x + cell / 2, y + cell / 2, share_of(value) < 0.5 ? white : black);
    }
  }
  const int left = margin + side + margin / 2, height = std::max(side, 4 * margin);
  picture.fill(left - 1, margin - 1, scale_width + 2, height + 2, black);
  for (int y = 0; y < height; ++y)
    picture.fill(left, margin + y, scale_width, 1, heat_color(1 - static_cast<double>(y) / std::max(1, height - 1)));
  constexpr int steps = 4;
  for (int k = 0; k <= steps; ++k) {
    picture.write(short_number(largest * (steps - k) / steps), left + scale_width + scale_room / 3,
                  margin + height * k / steps, black);
  }
  return picture.png(host);
}

}  // namespace orbicube::cli
