// PNG files in builds without libspng: written without compression, read by stb_image.
#include "base/error.h"
#include "sphere_map/sampling/geometry_image_png.h"
#include "sphere_map/sampling/png_file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#include <stb/stb_image.h>

namespace orbicube::sphere_map {

const char* version_of_spng() {
  return nullptr;
}

base::Array<std::byte> png_file(const base::PngImage& image, const base::Host& host) {
  return base::stored_png(image, host.memory);
}

GeometryImage image_of_png(std::span<const std::byte> file, const base::Host& host) {
  if (file.size() > INT32_MAX) throw base::Error("unsupported", "a PNG file of 2 GiB or more");
  const auto* data = reinterpret_cast<const stbi_uc*>(file.data());
  const auto size = static_cast<int>(file.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
    throw base::Error("parse", "this is no PNG file");
  GeometryImage image(host.memory);
  set_png_size(image, static_cast<std::size_t>(width), static_cast<std::size_t>(height), file.size());
  image.pixels.resize(image.width * image.height);
  const auto box = box_of(base::png_text(file, box_key));
  stbi_us* const levels = stbi_load_16_from_memory(data, size, &width, &height, &channels, 3);
  if (levels == nullptr) throw base::Error("parse", "the PNG file is damaged");
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = point_in(box, levels + 3 * i);
  stbi_image_free(levels);
  return image;
}

}  // namespace orbicube::sphere_map
