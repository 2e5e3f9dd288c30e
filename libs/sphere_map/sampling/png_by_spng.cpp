// PNG files by libspng, row by row, so that the host can cancel in between. What libspng keeps for itself (a few
// hundred KB) is not in the host's memory, since its allocator has no argument for the host.
#include <spng.h>

#include <algorithm>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "sphere_map/sampling/geometry_image_png.h"
#include "sphere_map/sampling/png_file.h"

namespace orbicube::sphere_map {
namespace {

using Bytes = Array<std::byte>;
using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

Context context(int flags) {
  Context made(spng_ctx_new(flags), &spng_ctx_free);
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

void require(int outcome, const char* kind, const char* message) {
  if (outcome == SPNG_EMEM) throw std::bad_alloc();
  if (outcome != SPNG_OK) throw base::Error(kind, message + (": " + std::string(spng_strerror(outcome))));
}

// The file so far. libspng has a code of its own for whatever went wrong in append().
struct Output {
  Bytes file;
  bool out_of_memory = false;
};

void require_written(int outcome) {
  require(outcome, "internal", "a PNG file cannot be made");
}

void require_written(int outcome, const Output& output) {
  if (output.out_of_memory) throw std::bad_alloc();
  require_written(outcome);
}

void require_read(int outcome) {
  require(outcome, "parse", "the PNG file is damaged");
}

// For libspng: no exception passes through its code.
int append(spng_ctx*, void* to, void* bytes, std::size_t count) {
  const auto* first = static_cast<const std::byte*>(bytes);
  auto& output = *static_cast<Output*>(to);
  try {
    output.file.insert(output.file.end(), first, first + count);
  } catch (const std::bad_alloc&) {
    output.out_of_memory = true;
    return SPNG_IO_ERROR;
  }
  return SPNG_OK;
}

void set_header(spng_ctx* encoder, const base::PngImage& image) {
  // Of zlib. On textures, checkers and geometry images 6, its default, takes twice the time for files of up to 8 %
  // less, 1 half the time for up to 25 % more.
  constexpr int compression_level = 4;
  spng_ihdr header = {};
  header.width = image.width;
  header.height = image.height;
  header.bit_depth = image.bits;
  header.color_type = static_cast<std::uint8_t>(image.color);
  require_written(spng_set_option(encoder, SPNG_IMG_COMPRESSION_LEVEL, compression_level));
  require_written(spng_set_ihdr(encoder, &header));
  if (!image.palette.empty()) {
    spng_plte palette = {};
    palette.n_entries = static_cast<std::uint32_t>(image.palette.size() / 3);
    for (std::size_t i = 0; i < std::min(image.palette.size() / 3, std::size(palette.entries)); ++i) {
      const auto channel = [&](std::size_t k) { return static_cast<std::uint8_t>(image.palette[3 * i + k]); };
      palette.entries[i] = {channel(0), channel(1), channel(2), 255};
    }
    require_written(spng_set_plte(encoder, &palette));
  }
}

// libspng keeps a view of the text until the header is written.
void set_text(spng_ctx* encoder, const base::PngImage& image, std::string& kept) {
  if (image.text_key.empty()) return;
  kept = image.text;
  spng_text text = {};
  std::copy(image.text_key.begin(), image.text_key.end(), text.keyword);
  text.type = SPNG_TEXT;
  text.length = kept.size();
  text.text = kept.data();
  require_written(spng_set_text(encoder, &text, 1));
}

// The text of a file that has been read to its end.
std::string text_of(spng_ctx* decoder, std::string_view key) {
  std::uint32_t count = 0;
  const int outcome = spng_get_text(decoder, nullptr, &count);
  if (outcome == SPNG_ECHUNKAVAIL) return {};
  require_read(outcome);
  std::vector<spng_text> texts(count);
  require_read(spng_get_text(decoder, texts.data(), &count));
  for (const spng_text& text : texts)
    if (key == text.keyword) return {text.text, text.length};
  return {};
}

// Of 16 bits: red, green, blue and alpha of each pixel.
void read_levels(spng_ctx* decoder, std::size_t width, std::size_t height, std::span<std::uint16_t> levels,
                 const base::Host& host) {
  require_read(spng_decode_image(decoder, nullptr, 0, SPNG_FMT_RGBA16, SPNG_DECODE_PROGRESSIVE));
  // An interlaced image comes in seven passes, each with some of the rows.
  for (std::size_t done = 0;; ++done) {
    host.report("reading the image", std::min(done, height), height);
    spng_row_info row = {};
    require_read(spng_get_row_info(decoder, &row));
    const auto of_row = levels.subspan(4 * width * row.row_num, 4 * width);
    const int outcome = spng_decode_row(decoder, of_row.data(), of_row.size_bytes());
    if (outcome == SPNG_EOI) break;
    require_read(outcome);
  }
  require_read(spng_decode_chunks(decoder));
}

}  // namespace

const char* version_of_spng() {
  return spng_version_string();
}

Bytes png_file(const base::PngImage& image, const base::Host& host) {
  const std::size_t row_bytes = base::checked_row_bytes(image);
  Output output{Bytes(host.memory)};
  std::string text;
  const Context encoder = context(SPNG_CTX_ENCODER);
  require_written(spng_set_png_stream(encoder.get(), append, &output));
  set_header(encoder.get(), image);
  set_text(encoder.get(), image, text);
  // Numbers of 16 bits have the high byte first already.
  require_written(
      spng_encode_image(encoder.get(), nullptr, 0, SPNG_FMT_RAW, SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE),
      output);
  for (std::size_t y = 0; y < image.height; ++y) {
    host.report("compressing the image", y, image.height);
    const int outcome = spng_encode_row(encoder.get(), image.rows.data() + y * row_bytes, row_bytes);
    if (y + 1 < image.height || outcome != SPNG_EOI) require_written(outcome, output);
  }
  return std::move(output.file);
}

GeometryImage image_of_png(std::span<const std::byte> file, const base::Host& host) {
  // What is beside the pixels: texts and profiles, of which a file may claim any size.
  constexpr std::size_t max_chunk = 1 << 24, max_chunks = 1 << 26;
  const Context decoder = context(0);
  require_read(spng_set_png_buffer(decoder.get(), file.data(), file.size()));
  require_read(spng_set_chunk_limits(decoder.get(), max_chunk, max_chunks));
  spng_ihdr header = {};
  require(spng_get_ihdr(decoder.get(), &header), "parse", "this is no PNG file");
  GeometryImage image(host.memory);
  set_png_size(image, header.width, header.height, file.size());
  image.pixels.resize(image.width * image.height);
  Array<std::uint16_t> levels(4 * image.pixels.size(), host.memory);
  read_levels(decoder.get(), image.width, image.height, levels, host);
  const auto box = box_of(text_of(decoder.get(), box_key));
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = point_in(box, &levels[4 * i]);
  return image;
}

}  // namespace orbicube::sphere_map
