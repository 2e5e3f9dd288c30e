#include "textures/stored_image.h"

#include <limits>
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>

namespace orbicube::cli {

StoredImage decoded(std::span<const std::byte> file, const base::Host& host) {
  StoredImage image(host.memory);
  if (file.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return image;
  int width = 0, height = 0, channels = 0;
  const auto release = [](stbi_uc* pixels) { stbi_image_free(pixels); };
  const std::unique_ptr<stbi_uc, decltype(release)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(file.data()), static_cast<int>(file.size()), &width,
                            &height, &channels, 3),
      release);
  if (pixels == nullptr || width <= 0 || height <= 0) return image;
  image.width = static_cast<std::size_t>(width);
  image.height = static_cast<std::size_t>(height);
  image.rgb.assign(pixels.get(), pixels.get() + 3 * image.width * image.height);
  return image;
}

}  // namespace orbicube::cli
