// MetaImage, attached (.mha) or with a data file of its own (.mhd), as ITK writes it.
#include <algorithm>
#include <map>
#include <vector>

#include "images/image_header.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::cli {
namespace {

// The lines up to ElementDataFile, after which data_begin is.
HeaderFields metaimage_fields(std::string_view bytes, ImageHeader& header) {
  HeaderFields fields;
  std::size_t at = 0;
  while (fields.count("ElementDataFile") == 0) {
    const std::size_t end = bytes.find('\n', at);
    const std::string_view line = mesh::trimmed(bytes.substr(at, end == std::string_view::npos ? end : end - at));
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos || line.size() > 10'000) {
      if (line.empty() && end != std::string_view::npos) {
        at = end + 1;
        continue;
      }
      if (fields.count("NDims") == 0) refuse_image("bad-magic", "this is no MetaImage file: its header has no NDims");
      refuse_image("truncated", "the header ends without ElementDataFile");
    }
    fields.emplace(mesh::trimmed(line.substr(0, equals)), mesh::trimmed(line.substr(equals + 1)));
    at = end == std::string_view::npos ? bytes.size() : end + 1;
  }
  header.data_begin = at;
  return fields;
}

bool is_metaimage_true(const HeaderFields& fields, std::initializer_list<const char*> names, bool otherwise) {
  const std::string* found = find_field(fields, names);
  if (found == nullptr || found->empty()) return otherwise;
  return (*found)[0] == 'T' || (*found)[0] == 't' || (*found)[0] == '1';
}

VoxelType metaimage_type(std::string_view name) {
  static const std::map<std::string_view, VoxelType> types = {
      {"MET_CHAR", VoxelType::int8},         {"MET_UCHAR", VoxelType::uint8},   {"MET_SHORT", VoxelType::int16},
      {"MET_USHORT", VoxelType::uint16},     {"MET_INT", VoxelType::int32},     {"MET_UINT", VoxelType::uint32},
      {"MET_LONG", VoxelType::int32},        {"MET_ULONG", VoxelType::uint32},  {"MET_LONG_LONG", VoxelType::int64},
      {"MET_ULONG_LONG", VoxelType::uint64}, {"MET_FLOAT", VoxelType::float32}, {"MET_DOUBLE", VoxelType::float64}};
  const auto found = types.find(name);
  if (found == types.end())
    refuse_image("unsupported", "voxels of the type \"" + std::string(name.substr(0, 40)) + "\" are no labels");
  return found->second;
}

// TransformMatrix lists the direction of each axis; columns of the map are directions times spacing.
void read_metaimage_orientation(const HeaderFields& fields, std::size_t axes, ImageHeader& header) {
  header.space = "LPS";
  const auto numbers = [&](const std::string* text, std::size_t count, const char* field, double otherwise) {
    std::vector<double> values(count, otherwise);
    if (text == nullptr) return values;
    std::string_view rest = *text;
    for (double& value : values)
      value = real_number(next_word(rest), field);
    return values;
  };
  const std::vector<double> spacing =
      numbers(find_field(fields, {"ElementSpacing", "ElementSize"}), axes, "ElementSpacing", 1);
  const std::vector<double> origin = numbers(find_field(fields, {"Offset", "Position", "Origin"}), axes, "Offset", 0);
  const std::string* matrix = find_field(fields, {"TransformMatrix", "Rotation", "Orientation"});
  const std::vector<double> directions = numbers(matrix, axes * axes, "TransformMatrix", 0);
  const std::size_t used = std::min<std::size_t>(axes, 3);
  for (std::size_t axis = 0; axis < used; ++axis) {
    std::array<double, 3> column{};
    for (std::size_t row = 0; row < used; ++row)
      column[row] = spacing[axis] * (matrix != nullptr ? directions[axis * axes + row] : axis == row ? 1 : 0);
    set_column(header, axis, column);
    header.to_world[4 * axis + 3] = origin[axis];
  }
}

void read_data_place(const HeaderFields& fields, ImageHeader& header) {
  const std::string& file = required_field(fields, "ElementDataFile");
  if (file != "LOCAL") {
    if (file.rfind("LIST", 0) == 0 || file.find('%') != std::string::npos)
      refuse_image("unsupported-mode", "the voxels are in several files; join them in one");
    require_plain_name(file);
    header.data_file = file;
    header.data_begin = 0;
  }
  if (const std::string* skip = find_field(fields, {"HeaderSize"})) {
    if (*skip == "-1") {
      header.data_at_end = true;
    } else {
      const std::uint64_t bytes = whole_number(*skip, "HeaderSize");
      if (bytes > 1'000'000'000'000'000) refuse_image("parse", "HeaderSize is too large");
      header.data_begin += bytes;
    }
  }
}

}  // namespace

ImageHeader metaimage_header(std::string_view bytes) {
  ImageHeader header;
  header.format = "MetaImage";
  const HeaderFields fields = metaimage_fields(bytes, header);
  const std::uint64_t axes = whole_number(required_field(fields, "NDims"), "NDims");
  if (axes < 1 || axes > 10) refuse_image("parse", "NDims is not 1 to 10");
  std::string_view sizes = required_field(fields, "DimSize");
  std::vector<std::uint64_t> lengths;
  for (std::uint64_t i = 0; i < axes; ++i)
    lengths.push_back(whole_number(next_word(sizes), "DimSize"));
  set_sizes(header, lengths);
  header.type = metaimage_type(required_field(fields, "ElementType"));
  if (const std::string* channels = find_field(fields, {"ElementNumberOfChannels"});
      channels != nullptr && *channels != "1")
    refuse_image("unsupported", "voxels with several channels are no labels");
  header.big_endian = is_metaimage_true(fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false);
  const bool binary = is_metaimage_true(fields, {"BinaryData"}, true),
             compressed = is_metaimage_true(fields, {"CompressedData"}, false);
  header.encoding = compressed ? VoxelEncoding::deflated : binary ? VoxelEncoding::raw : VoxelEncoding::text;
  if (compressed && !binary) refuse_image("unsupported-mode", "compressed text");
  read_metaimage_orientation(fields, static_cast<std::size_t>(axes), header);
  read_data_place(fields, header);
  return header;
}

}  // namespace orbicube::cli
