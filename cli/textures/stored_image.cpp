#include "textures/stored_image.h"

#include <limits>
#include <memory>
#include <new>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

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

base::Array<std::byte> encoded(const StoredImage& image, const base::Host& host) {
  base::Array<std::byte> file(host.memory);
  const auto append = [](void* to, void* bytes, int size) {
    const auto* first = static_cast<const std::byte*>(bytes);
    static_cast<base::Array<std::byte>*>(to)->insert(static_cast<base::Array<std::byte>*>(to)->end(), first,
                                                     first + size);
  };
  const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  if (stbi_write_png_to_func(append, &file, width, height, 3, image.rgb.data(), 3 * width) == 0) throw std::bad_alloc();
  return file;
}

}  // namespace orbicube::cli
