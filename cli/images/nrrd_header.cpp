// NRRD, attached (.nrrd) or with a data file of its own (.nhdr): Kindlmann, "Definition of NRRD file format", 2004.
#include <algorithm>
#include <map>
#include <vector>

#include "images/image_header.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::cli {
namespace {

VoxelType nrrd_type(std::string_view name) {
  static const std::map<std::string_view, VoxelType> types = {{"signed char", VoxelType::int8},
                                                              {"int8", VoxelType::int8},
                                                              {"int8_t", VoxelType::int8},
                                                              {"uchar", VoxelType::uint8},
                                                              {"unsigned char", VoxelType::uint8},
                                                              {"uint8", VoxelType::uint8},
                                                              {"uint8_t", VoxelType::uint8},
                                                              {"short", VoxelType::int16},
                                                              {"short int", VoxelType::int16},
                                                              {"signed short", VoxelType::int16},
                                                              {"signed short int", VoxelType::int16},
                                                              {"int16", VoxelType::int16},
                                                              {"int16_t", VoxelType::int16},
                                                              {"ushort", VoxelType::uint16},
                                                              {"unsigned short", VoxelType::uint16},
                                                              {"unsigned short int", VoxelType::uint16},
                                                              {"uint16", VoxelType::uint16},
                                                              {"uint16_t", VoxelType::uint16},
                                                              {"int", VoxelType::int32},
                                                              {"signed int", VoxelType::int32},
                                                              {"int32", VoxelType::int32},
                                                              {"int32_t", VoxelType::int32},
                                                              {"uint", VoxelType::uint32},
                                                              {"unsigned int", VoxelType::uint32},
                                                              {"uint32", VoxelType::uint32},
                                                              {"uint32_t", VoxelType::uint32},
                                                              {"longlong", VoxelType::int64},
                                                              {"long long", VoxelType::int64},
                                                              {"int64", VoxelType::int64},
                                                              {"int64_t", VoxelType::int64},
                                                              {"signed long long", VoxelType::int64},
                                                              {"ulonglong", VoxelType::uint64},
                                                              {"unsigned long long", VoxelType::uint64},
                                                              {"uint64", VoxelType::uint64},
                                                              {"uint64_t", VoxelType::uint64},
                                                              {"float", VoxelType::float32},
                                                              {"double", VoxelType::float64}};
  const auto found = types.find(name);
  if (found == types.end())
    refuse_image("unsupported", "voxels of the type \"" + std::string(name.substr(0, 40)) + "\" are no labels");
  return found->second;
}

// The lines up to the first empty one, where data_begin is.
HeaderFields nrrd_fields(std::string_view bytes, ImageHeader& header) {
  if (bytes.substr(0, 4) != "NRRD") refuse_image("bad-magic", "this is no NRRD file: it does not begin with NRRD");
  HeaderFields fields;
  std::size_t at = 0;
  for (bool first = true;; first = false) {
    const std::size_t end = bytes.find('\n', at);
    const std::string_view line = mesh::trimmed(bytes.substr(at, end == std::string_view::npos ? end : end - at));
    const bool ended = end == std::string_view::npos;
    at = ended ? bytes.size() : end + 1;
    if (!first && !line.empty() && line[0] != '#') {
      const std::size_t colon = line.find(':');
      if (colon == std::string_view::npos)
        refuse_image("parse", "the line \"" + std::string(line.substr(0, 40)) + "\" of the header is no field");
      if (line.substr(colon, 2) != ":=")  // keys with values are not part of the format
        fields.emplace(line.substr(0, colon), mesh::trimmed(line.substr(colon + 1)));
    }
    if (ended || (!first && line.empty())) break;
  }
  header.data_begin = at;
  return fields;
}

// "(x,y,z)"
std::array<double, 3> nrrd_vector(std::string_view& text, const char* field) {
  text = mesh::trimmed(text);
  const std::size_t end = text.find(')');
  if (text.empty() || text[0] != '(' || end == std::string_view::npos)
    refuse_image("parse", std::string(field) +
                              ": a vector (x,y,z) is needed; images with axes that are not of the space are not read");
  std::string_view inside = text.substr(1, end - 1);
  text.remove_prefix(end + 1);
  std::array<double, 3> vector{};
  for (double& x : vector)
    x = real_number(next_word(inside, ", \t"), field);
  if (!next_word(inside, ", \t").empty())
    refuse_image("unsupported", std::string(field) + ": a space of three dimensions is needed");
  return vector;
}

void read_nrrd_orientation(const HeaderFields& fields, std::size_t axes, ImageHeader& header) {
  if (const std::string* space = find_field(fields, {"space"})) {
    static const std::map<std::string_view, const char*> spaces = {{"right-anterior-superior", "RAS"}, {"RAS", "RAS"},
                                                                   {"left-posterior-superior", "LPS"}, {"LPS", "LPS"},
                                                                   {"left-anterior-superior", "LAS"},  {"LAS", "LAS"}};
    const auto found = spaces.find(*space);
    header.space = found != spaces.end() ? found->second : space->substr(0, 80);
  }
  if (const std::string* directions = find_field(fields, {"space directions"})) {
    std::string_view rest = *directions;
    for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis)
      set_column(header, axis, nrrd_vector(rest, "space directions"));
    if (axes == 2) refuse_image("unsupported", "an image with two axes in a space of three dimensions");
  } else if (const std::string* spacings = find_field(fields, {"spacings"})) {
    std::string_view rest = *spacings;
    for (std::size_t axis = 0; axis < std::min<std::size_t>(axes, 3); ++axis) {
      const std::string_view word = next_word(rest);
      if (word != "nan" && word != "NaN") header.to_world[5 * axis] = real_number(word, "spacings");
    }
  }
  if (const std::string* origin = find_field(fields, {"space origin"})) {
    std::string_view rest = *origin;
    set_column(header, 3, nrrd_vector(rest, "space origin"));
  }
}

void read_nrrd_encoding(const HeaderFields& fields, ImageHeader& header) {
  const std::string& encoding = required_field(fields, "encoding");
  if (encoding == "raw") {
    header.encoding = VoxelEncoding::raw;
  } else if (encoding == "gzip" || encoding == "gz") {
    header.encoding = VoxelEncoding::deflated;
  } else if (encoding == "ascii" || encoding == "text" || encoding == "txt") {
    header.encoding = VoxelEncoding::text;
  } else {
    refuse_image("unsupported-mode", "the encoding \"" + encoding.substr(0, 40) + "\"; raw, gzip and ascii are read");
  }
  if (header.encoding == VoxelEncoding::text || size_of(header.type) == 1) return;
  const std::string& endian = required_field(fields, "endian");
  if (endian != "little" && endian != "big") refuse_image("parse", "endian is neither little nor big");
  header.big_endian = endian == "big";
}

}  // namespace

ImageHeader nrrd_header(std::string_view bytes) {
  ImageHeader header;
  header.format = "NRRD";
  const HeaderFields fields = nrrd_fields(bytes, header);
  header.type = nrrd_type(required_field(fields, "type"));
  const std::uint64_t axes = whole_number(required_field(fields, "dimension"), "dimension");
  if (axes < 1 || axes > 16) refuse_image("parse", "dimension is not 1 to 16");
  std::string_view sizes = required_field(fields, "sizes");
  std::vector<std::uint64_t> lengths;
  for (std::uint64_t i = 0; i < axes; ++i)
    lengths.push_back(whole_number(next_word(sizes), "sizes"));
  if (!next_word(sizes).empty()) refuse_image("parse", "sizes: more numbers than the dimension");
  set_sizes(header, lengths);
  read_nrrd_encoding(fields, header);
  read_nrrd_orientation(fields, static_cast<std::size_t>(axes), header);
  if (const std::string* lines = find_field(fields, {"line skip", "lineskip"}))
    header.skipped_lines = whole_number(*lines, "line skip");
  std::uint64_t skip = 0;
  if (const std::string* bytes_skipped = find_field(fields, {"byte skip", "byteskip"})) {
    if (*bytes_skipped == "-1") {
      header.data_at_end = true;
    } else {
      skip = whole_number(*bytes_skipped, "byte skip");
    }
  }
  if (const std::string* file = find_field(fields, {"data file", "datafile"})) {
    if (file->rfind("LIST", 0) == 0 || file->find('%') != std::string::npos)
      refuse_image("unsupported-mode", "the voxels are in several files; join them in one");
    require_plain_name(*file);
    header.data_file = *file;
    header.data_begin = 0;
  }
  if (skip > 0 && header.encoding == VoxelEncoding::deflated)
    refuse_image("unsupported-mode", "byte skip in compressed data");
  if (skip > 1'000'000'000'000'000) refuse_image("parse", "byte skip is too large");
  header.skipped_bytes = skip;
  return header;
}

}  // namespace orbicube::cli
