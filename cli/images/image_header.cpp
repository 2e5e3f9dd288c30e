#include "images/image_header.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace orbicube::cli {

std::size_t size_of(VoxelType type) {
  switch (type) {
    case VoxelType::int8:
    case VoxelType::uint8:
      return 1;
    case VoxelType::int16:
    case VoxelType::uint16:
      return 2;
    case VoxelType::int32:
    case VoxelType::uint32:
    case VoxelType::float32:
      return 4;
    case VoxelType::int64:
    case VoxelType::uint64:
    case VoxelType::float64:
      return 8;
  }
  return 8;
}

void refuse_image(const char* kind, const std::string& text) {
  std::string shown = text;
  for (char& c : shown)
    c = c >= ' ' && c <= '~' ? c : '?';
  throw base::Error(kind, shown);
}

const std::string* find_field(const HeaderFields& fields, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const auto found = fields.find(name); found != fields.end()) return &found->second;
  }
  return nullptr;
}

const std::string& required_field(const HeaderFields& fields, const char* name) {
  const std::string* found = find_field(fields, {name});
  if (found == nullptr) refuse_image("parse", "the header has no field \"" + std::string(name) + "\"");
  return *found;
}

double real_number(std::string_view word, const std::string& field) {
  double value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    refuse_image("parse", field + ": \"" + std::string(word.substr(0, 40)) + "\" is no finite number");
  return value;
}

std::uint64_t whole_number(std::string_view word, const std::string& field) {
  std::uint64_t value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc() || end != word.data() + word.size())
    refuse_image("parse", field + ": \"" + std::string(word.substr(0, 40)) + "\" is no whole number");
  return value;
}

std::string_view next_word(std::string_view& text, std::string_view separators) {
  const auto first = text.find_first_not_of(separators);
  if (first == std::string_view::npos) {
    text = {};
    return {};
  }
  text.remove_prefix(first);
  const std::string_view word = text.substr(0, text.find_first_of(separators));
  text.remove_prefix(word.size());
  return word;
}

void require_plain_name(std::string_view name) {
  if (name.empty() || name == "." || name == ".." || name.find_first_of("/\\") != std::string_view::npos ||
      name.find('\0') != std::string_view::npos)
    refuse_image("unsafe-path",
                 "the data file \"" + std::string(name.substr(0, 80)) + "\" is not in the folder of the header");
}

void set_sizes(ImageHeader& header, std::span<const std::uint64_t> sizes) {
  header.size = {1, 1, 1};
  std::uint64_t count = 1;
  for (std::size_t axis = 0; axis < sizes.size(); ++axis) {
    const std::uint64_t n = sizes[axis];
    if (n == 0) refuse_image("parse", "axis " + std::to_string(axis) + " of the image has no voxels");
    if (axis >= 3) {
      if (n != 1)
        refuse_image("unsupported", "the image has more than three axes: " + std::to_string(n) +
                                        " volumes or components; extract one");
      continue;
    }
    // Labels of four bytes are to have a size in memory.
    if (n > std::numeric_limits<std::ptrdiff_t>::max() / 8 / count)
      refuse_image("parse", "the sizes of the image overflow");
    count *= n;
    header.size[axis] = static_cast<std::size_t>(n);
  }
}

void set_column(ImageHeader& header, std::size_t axis, const std::array<double, 3>& column) {
  for (std::size_t row = 0; row < 3; ++row)
    header.to_world[4 * row + axis] = column[row];
}

}  // namespace orbicube::cli
