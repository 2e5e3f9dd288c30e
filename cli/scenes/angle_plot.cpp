#include "scenes/angle_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "sphere_map/sampling/png_file.h"

namespace orbicube::cli {
namespace {

constexpr std::uint32_t width = 900, height = 560, left = 60, right = 20, top = 20, bottom = 50;
enum Color : std::uint8_t { paper, ink, grid, bar, curve };
constexpr std::array<std::array<std::uint8_t, 3>, 5> palette = {
    {{255, 255, 255}, {40, 40, 40}, {225, 225, 225}, {150, 180, 215}, {200, 40, 40}}};

// Digits and a per cent sign, three columns by five rows, a bit a dot from the top left.
constexpr std::array<std::uint16_t, 11> glyphs = {
    0b111101101101111, 0b010110010010111, 0b111001111100111, 0b111001111001111, 0b101101111001001, 0b111100111001111,
    0b111100111101111, 0b111001001001001, 0b111101111101111, 0b111101111001111, 0b101001010100101};

class Canvas {
 public:
  explicit Canvas(std::pmr::memory_resource* memory) : pixels_(std::size_t{width} * height, paper, memory) {}

  void box(double x0, double y0, double x1, double y1, Color color) {
    const auto at = [](double v, std::uint32_t limit) {
      return static_cast<std::uint32_t>(std::clamp(std::lround(v), 0L, static_cast<long>(limit)));
    };
    for (std::uint32_t y = at(y0, height); y < at(y1, height); ++y) {
      for (std::uint32_t x = at(x0, width); x < at(x1, width); ++x)
        pixels_[std::size_t{y} * width + x] = color;
    }
  }
  void line(double x0, double y0, double x1, double y1, Color color) {
    const int steps = 1 + static_cast<int>(2 * std::max(std::abs(x1 - x0), std::abs(y1 - y0)));
    for (int s = 0; s <= steps; ++s) {
      const double t = static_cast<double>(s) / steps, x = x0 + t * (x1 - x0), y = y0 + t * (y1 - y0);
      box(x - 1, y - 1, x + 2, y + 2, color);
    }
  }
  // Digits and '%', in dots of three pixels.
  void text(double x, double y, const std::string& characters) {
    for (const char c : characters) {
      const std::uint16_t glyph = glyphs[c == '%' ? 10 : static_cast<std::size_t>(c - '0')];
      for (std::uint32_t dot = 0; dot < 15; ++dot) {
        if ((glyph >> (14 - dot) & 1) == 0) continue;
        const double px = x + 3 * (dot % 3), py = y + 3 * (dot / 3);
        box(px, py, px + 3, py + 3, ink);
      }
      x += 12;
    }
  }
  const base::Array<std::uint8_t>& pixels() const { return pixels_; }

 private:
  base::Array<std::uint8_t> pixels_;
};

}  // namespace

base::Array<std::byte> angle_plot(std::span<const std::size_t> histogram, const base::Host& host) {
  Canvas canvas(host.memory);
  double total = 0;
  for (const std::size_t n : histogram)
    total += static_cast<double>(n);
  const double degrees = static_cast<double>(histogram.size());
  const auto across = [&](double angle) { return left + angle / degrees * (width - left - right); };
  const auto up = [&](double share) { return height - bottom - share * (height - top - bottom); };
  for (int percent = 0; percent <= 100; percent += 20) {
    canvas.box(left, up(percent / 100.0), width - right, up(percent / 100.0) + 1, grid);
    canvas.text(percent == 100 ? 4 : percent == 0 ? 28 : 16, up(percent / 100.0) - 7, std::to_string(percent) + '%');
  }
  double below = 0;
  for (std::size_t d = 0; d < histogram.size(); ++d) {
    const double share = total > 0 ? static_cast<double>(histogram[d]) / total : 0, angle = static_cast<double>(d);
    canvas.box(across(angle) + 1, up(share), across(angle + 1), up(0), bar);
  }
  for (std::size_t d = 0; d < histogram.size(); ++d) {
    const double share = total > 0 ? static_cast<double>(histogram[d]) / total : 0, angle = static_cast<double>(d);
    canvas.line(across(angle), up(below), across(angle + 1), up(below + share), curve);
    below += share;
  }
  canvas.box(left - 1, top, left + 1, up(0), ink);
  canvas.box(left - 1, up(0), width - right, up(0) + 2, ink);
  for (std::size_t d = 0; d < histogram.size(); d += 10) {
    const double x = across(static_cast<double>(d));
    canvas.box(x - 1, up(0), x + 1, up(0) + 8, ink);
    canvas.text(x - (d < 10 ? 4 : 10), up(0) + 14, std::to_string(d));
  }
  base::PngImage image;
  image.width = width;
  image.height = height;
  image.color = base::PngColor::palette;
  image.palette = std::as_bytes(std::span(palette.front().data(), 3 * palette.size()));
  image.rows = std::as_bytes(std::span(canvas.pixels()));
  return sphere_map::png_file(image, host);
}

}  // namespace orbicube::cli
