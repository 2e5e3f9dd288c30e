// The voxels of an image file, as its header describes them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace orbicube::cli {

enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
enum class VoxelEncoding { raw, deflated, text };

std::size_t size_of(VoxelType type);

struct ImageHeader {
  const char* format = "";
  std::array<std::size_t, 3> size{};
  VoxelType type = VoxelType::uint8;
  bool big_endian = false;
  VoxelEncoding encoding = VoxelEncoding::raw;
  std::string data_file;                               // beside the header; empty: the same file
  std::uint64_t data_begin = 0;                        // in bytes; of NIfTI after decompression
  bool data_at_end = false;                            // in place of data_begin
  std::uint64_t skipped_lines = 0, skipped_bytes = 0;  // before the voxels, in this order
  double slope = 1, intercept = 0;                     // value = slope * number + intercept
  std::array<double, 16> to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  std::string space;  // the world's axes, as "RAS" (to the right, anterior, superior) or "LPS"; empty: unknown
};

// The bytes of a NIfTI header are at most this number, after decompression.
inline constexpr std::size_t max_nifti_header = 544;

// Each throws Error "bad-magic", "truncated", "parse", "unsupported", "unsupported-mode" or "unsafe-path". Of a number
// of axes other than three, further ones of length 1 are allowed.
ImageHeader nifti_header(std::span<const std::byte> bytes);
ImageHeader nrrd_header(std::string_view bytes);
ImageHeader metaimage_header(std::string_view bytes);

// What the readers share: the fields of a header of lines, by their names.
using HeaderFields = std::map<std::string, std::string, std::less<>>;
// Returns the first of these that is there, or nullptr.
const std::string* find_field(const HeaderFields& fields, std::initializer_list<const char*> names);
const std::string& required_field(const HeaderFields& fields, const char* name);
[[noreturn]] void refuse_image(const char* kind, const std::string& text);
double real_number(std::string_view word, const std::string& field);
std::uint64_t whole_number(std::string_view word, const std::string& field);
// The words between blanks and the given separators.
std::string_view next_word(std::string_view& text, std::string_view separators = " \t");
// Throws Error "unsafe-path" unless it is the name of a file in the folder of the header.
void require_plain_name(std::string_view name);
// Sets the sizes: at least one voxel along each axis. A product that overflows is refused as "parse".
void set_sizes(ImageHeader& header, std::span<const std::uint64_t> sizes);
// Column `axis` of the map to the world; axis 3: the origin.
void set_column(ImageHeader& header, std::size_t axis, const std::array<double, 3>& column);

}  // namespace orbicube::cli
