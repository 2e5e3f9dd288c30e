#include "gltf/writing/checker.h"

#include "base/error.h"
#include "base/files/stored_png.h"

namespace orbicube::gltf {

base::Array<std::byte> checker_png(const Checker& checker, std::pmr::memory_resource* memory) {
  constexpr std::uint32_t longest_side = 16384;
  const auto fits = [&](std::uint32_t squares) {
    return squares > 0 && checker.pixels > 0 && squares <= longest_side / checker.pixels;
  };
  if (!fits(checker.columns) || !fits(checker.rows))
    throw base::Error("invalid-argument", "a checker texture has sides of 1 to 16384 pixels");

  base::PngImage image;
  image.width = checker.columns * checker.pixels;
  image.height = checker.rows * checker.pixels;
  image.bits = 1;
  image.color = base::PngColor::palette;
  base::Array<std::byte> palette(memory), rows(memory);
  for (const auto& color : {checker.first, checker.second}) {
    for (const std::uint8_t channel : color)
      palette.push_back(static_cast<std::byte>(channel));
  }
  rows.reserve(std::size_t{image.height} * ((image.width + 7) / 8));
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; x += 8) {
      std::uint32_t bits = 0;
      for (std::uint32_t i = 0; i < 8 && x + i < image.width; ++i)
        bits |= (((x + i) / checker.pixels + y / checker.pixels) & 1U) << (7U - i);
      rows.push_back(static_cast<std::byte>(bits));
    }
  }
  image.palette = palette;
  image.rows = rows;
  return base::stored_png(image, memory);
}

}  // namespace orbicube::gltf
