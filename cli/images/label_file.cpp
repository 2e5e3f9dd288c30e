#include "images/label_file.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/files/file.h"
#include "images/inflate.h"

namespace orbicube::cli {
namespace {

using ByteSpan = std::span<const std::byte>;

enum class ImageFormat { nifti, nrrd, metaimage };

std::string lower_case(std::string text) {
  for (char& c : text)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

ImageFormat image_format(const std::filesystem::path& path) {
  const std::string name = lower_case(path.filename().string());
  const auto ends = [&](std::string_view ending) {
    return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  };
  if (ends(".nii") || ends(".nii.gz")) return ImageFormat::nifti;
  if (ends(".nrrd") || ends(".nhdr")) return ImageFormat::nrrd;
  if (ends(".mha") || ends(".mhd")) return ImageFormat::metaimage;
  throw base::Error("unsupported-format", "label images end in " + label_image_endings);
}

std::string_view bytes_as_text(ByteSpan bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// "voxel (3, 0, 7)"
std::string voxel_name(const ImageHeader& header, std::size_t i) {
  return "voxel (" + std::to_string(i % header.size[0]) + ", " + std::to_string(i / header.size[0] % header.size[1]) +
         ", " + std::to_string(i / (header.size[0] * header.size[1])) + ")";
}

template <class Number>
std::int32_t label_of(Number number, const ImageHeader& header, std::size_t i) {
  const double value = static_cast<double>(number) * header.slope + header.intercept;
  if (!(value >= std::numeric_limits<std::int32_t>::min() && value <= std::numeric_limits<std::int32_t>::max()) ||
      value != std::nearbyint(value)) {
    char shown[32];
    std::snprintf(shown, sizeof shown, "%.9g", value);
    throw base::Error("unsupported",
                      voxel_name(header, i) + " has the value " + shown +
                          "; labels are whole numbers from -2147483648 to 2147483647. Threshold the image first");
  }
  return static_cast<std::int32_t>(value);
}

template <class Number>
void convert_labels(ByteSpan bytes, LabelFile& file, const base::Host& host) {
  const bool swapped = file.header.big_endian != (std::endian::native == std::endian::big);
  for (std::size_t i = 0; i < file.labels.size(); ++i) {
    if (i % 65536 == 0) host.report("reading", i, file.labels.size());
    std::array<std::byte, sizeof(Number)> raw{};
    std::memcpy(raw.data(), bytes.data() + i * sizeof(Number), sizeof(Number));
    if (swapped) std::reverse(raw.begin(), raw.end());
    file.labels[i] = label_of(std::bit_cast<Number>(raw), file.header, i);
  }
}

void convert_raw(ByteSpan bytes, LabelFile& file, const base::Host& host) {
  switch (file.header.type) {
    case VoxelType::int8:
      return convert_labels<std::int8_t>(bytes, file, host);
    case VoxelType::uint8:
      return convert_labels<std::uint8_t>(bytes, file, host);
    case VoxelType::int16:
      return convert_labels<std::int16_t>(bytes, file, host);
    case VoxelType::uint16:
      return convert_labels<std::uint16_t>(bytes, file, host);
    case VoxelType::int32:
      return convert_labels<std::int32_t>(bytes, file, host);
    case VoxelType::uint32:
      return convert_labels<std::uint32_t>(bytes, file, host);
    case VoxelType::int64:
      return convert_labels<std::int64_t>(bytes, file, host);
    case VoxelType::uint64:
      return convert_labels<std::uint64_t>(bytes, file, host);
    case VoxelType::float32:
      return convert_labels<float>(bytes, file, host);
    case VoxelType::float64:
      return convert_labels<double>(bytes, file, host);
  }
}

void convert_text(ByteSpan bytes, LabelFile& file, const base::Host& host) {
  std::string_view rest = bytes_as_text(bytes);
  for (std::size_t i = 0; i < file.labels.size(); ++i) {
    if (i % 65536 == 0) host.report("reading", i, file.labels.size());
    const std::string_view word = next_word(rest, " \t\r\n,");
    if (word.empty())
      throw base::Error("truncated", "the file has " + std::to_string(i) + " numbers, the sizes need " +
                                         std::to_string(file.labels.size()));
    file.labels[i] = label_of(real_number(word, voxel_name(file.header, i)), file.header, i);
  }
}

[[noreturn]] void refuse_short_data(std::uint64_t have, std::uint64_t need) {
  throw base::Error(
      "truncated", "the file has " + std::to_string(have) + " bytes of voxels, the sizes need " + std::to_string(need));
}

// The voxels, after what the header says is before them; no more memory is taken than the file can fill.
void read_voxels(ByteSpan data, bool all_deflated, LabelFile& file, const base::Host& host) {
  const ImageHeader& h = file.header;
  const std::size_t count = h.size[0] * h.size[1] * h.size[2];
  const std::uint64_t need = static_cast<std::uint64_t>(count) * size_of(h.type);
  const bool text = h.encoding == VoxelEncoding::text, deflated = all_deflated || h.encoding == VoxelEncoding::deflated;
  std::uint64_t begin = h.data_begin;
  for (std::uint64_t line = 0; line < h.skipped_lines; ++line) {
    const std::size_t end = begin < data.size() ? bytes_as_text(data).find('\n', begin) : std::string_view::npos;
    if (end == std::string_view::npos) throw base::Error("truncated", "the file has fewer lines than are skipped");
    begin = end + 1;
  }
  begin += h.skipped_bytes;
  if (h.data_at_end && !deflated && !text) begin = data.size() > need ? data.size() - need : 0;
  if (!all_deflated && begin > data.size()) refuse_short_data(0, need);
  if (!all_deflated) data = data.subspan(begin);
  // Deflate compresses at most 1032 to 1; text has a digit and a blank for each voxel.
  const std::uint64_t most = text ? data.size() / 2 + 1 : deflated ? data.size() * std::uint64_t{1032} : data.size();
  if ((text ? count : need) > most) refuse_short_data(deflated || text ? 0 : data.size(), need);
  base::Array<std::byte> inflated(host.memory);
  if (deflated) {
    const std::uint64_t before = all_deflated ? begin : 0;
    if (before > most) refuse_short_data(0, need);
    inflated = inflate(data, static_cast<std::size_t>(before + need), host);
    if (inflated.size() < before + need)
      refuse_short_data(inflated.size() - std::min<std::uint64_t>(before, inflated.size()), need);
    data = ByteSpan(inflated).subspan(static_cast<std::size_t>(before));
  }
  file.labels.resize(count);
  text ? convert_text(data, file, host) : convert_raw(data, file, host);
}

}  // namespace

LabelFile read_labels(const std::filesystem::path& path, Session& session) {
  const base::Host& host = session.host();
  const ImageFormat format = image_format(path);
  const base::Array<std::byte> bytes = base::read_file(path, host);
  if (bytes.empty()) throw base::Error("empty-file", "no bytes");
  LabelFile file{{}, base::Array<std::int32_t>(host.memory)};
  const bool all_deflated = format == ImageFormat::nifti && is_gzip(bytes);
  if (format == ImageFormat::nifti) {
    file.header = all_deflated ? nifti_header(inflate(bytes, max_nifti_header, host))
                               : nifti_header(ByteSpan(bytes).first(std::min(bytes.size(), max_nifti_header)));
  } else {
    file.header =
        format == ImageFormat::nrrd ? nrrd_header(bytes_as_text(bytes)) : metaimage_header(bytes_as_text(bytes));
  }
  if (file.header.data_file.empty()) {
    read_voxels(bytes, all_deflated, file, host);
  } else {
    base::Array<std::byte> data(host.memory);
    try {
      data = base::read_file(path.parent_path() / file.header.data_file, host, base::Links::refuse);
    } catch (const base::Error& error) {
      refuse_image(error.kind(), "the data file " + file.header.data_file + ": " + error.what());
    }
    read_voxels(data, false, file, host);
  }
  return file;
}

}  // namespace orbicube::cli
