#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "base/files/base64.h"
#include "mesh/files/left_out.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/xml/number_array.h"
#include "mesh/formats/xml/xml_scanner.h"
#include "mesh/formats/xml/zlib_data.h"

namespace orbicube::mesh {
namespace {

struct GiftiArray {
  NumberType type = NumberType::float32;
  std::string_view encoding;
  std::endian order = std::endian::little;
  bool by_columns = false;
  std::uint64_t rows = 0;
  std::string_view text;    // of Data
  std::string_view matrix;  // of the first transform to another space
  std::string_view space;   // the name of that space
};

std::optional<NumberType> gifti_type(std::string_view name) {
  constexpr std::array types = {
      std::pair{"NIFTI_TYPE_INT8", NumberType::int8},       std::pair{"NIFTI_TYPE_UINT8", NumberType::uint8},
      std::pair{"NIFTI_TYPE_INT16", NumberType::int16},     std::pair{"NIFTI_TYPE_UINT16", NumberType::uint16},
      std::pair{"NIFTI_TYPE_INT32", NumberType::int32},     std::pair{"NIFTI_TYPE_UINT32", NumberType::uint32},
      std::pair{"NIFTI_TYPE_INT64", NumberType::int64},     std::pair{"NIFTI_TYPE_UINT64", NumberType::uint64},
      std::pair{"NIFTI_TYPE_FLOAT32", NumberType::float32}, std::pair{"NIFTI_TYPE_FLOAT64", NumberType::float64}};
  for (const auto& [word, type] : types) {
    if (name == word) return type;
  }
  return std::nullopt;
}

class GiftiReader {
 public:
  GiftiReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : scanner_(bytes, host), host_(host), report_(report), mesh_(host.memory) {}

  Mesh run() {
    structure();
    require(points_, "NIFTI_INTENT_POINTSET");
    require(triangles_, "NIFTI_INTENT_TRIANGLE");
    report_.format = "GIFTI, " + std::string(points_->encoding);
    read_points();
    read_triangles();
    note_space();
    note_left_out({{others_, "data array", "data arrays"}}, report_.notes);
    return std::move(mesh_);
  }

 private:
  void structure() {
    using enum XmlScanner::Event;
    std::optional<GiftiArray>* current = nullptr;
    for (auto event = scanner_.next(); event != end_of_file; event = scanner_.next()) {
      const auto& open = scanner_.open();
      if (event == start && open.size() == 1 && scanner_.name() != "GIFTI")
        scanner_.fail("bad-magic", "the element GIFTI expected, found " + in_quotes(scanner_.name()));
      if (event == start && open.size() == 2) current = scanner_.name() == "DataArray" ? array() : nullptr;
      if (event != text || !current) continue;
      GiftiArray& array = **current;
      const bool in_matrix = open.size() == 4 && open[2] == "CoordinateSystemTransformMatrix";
      if (open.size() == 3 && open[2] == "Data") array.text = scanner_.text();
      if (in_matrix && open[3] == "MatrixData" && array.matrix.empty()) array.matrix = scanner_.text();
      if (in_matrix && open[3] == "TransformedSpace" && array.space.empty()) array.space = trimmed(scanner_.text());
    }
  }

  // Returns where the array at whose start this is goes; nothing for one that is passed over.
  std::optional<GiftiArray>* array() {
    const std::string_view intent = attribute("Intent");
    const bool points = intent == "NIFTI_INTENT_POINTSET";
    if (!points && intent != "NIFTI_INTENT_TRIANGLE") {
      ++others_;
      return nullptr;
    }
    std::optional<GiftiArray>& result = points ? points_ : triangles_;
    if (result)
      scanner_.fail("unsupported", "more than one array of " + std::string(intent) + "; write one surface to a file");
    result.emplace();
    const auto type = gifti_type(attribute("DataType"));
    if (!type) scanner_.fail("parse", "an array of the type " + in_quotes(attribute("DataType")));
    result->type = *type;
    result->encoding = attribute("Encoding");
    if (result->encoding == "ExternalFileBinary")
      scanner_.fail("unsupported-uri", "numbers in another file are not read; save the file with GZipBase64Binary");
    if (result->encoding != "ASCII" && result->encoding != "Base64Binary" && result->encoding != "GZipBase64Binary")
      scanner_.fail("parse", "an array of the encoding " + in_quotes(result->encoding));
    result->order = attribute("Endian") == "BigEndian" ? std::endian::big : std::endian::little;
    result->by_columns = attribute("ArrayIndexingOrder") == "ColumnMajorOrder";
    result->rows = number("Dim0");
    if (number("Dimensionality") != 2 || number("Dim1") != 3)
      scanner_.fail("parse", "an array of " + std::string(intent) + " has rows of three numbers");
    return &result;
  }

  std::string_view attribute(const char* name) const { return trimmed(scanner_.attribute(name).value_or("")); }

  std::uint64_t number(const char* name) const {
    const std::string_view text = attribute(name);
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || problem != std::errc() || end != text.data() + text.size())
      scanner_.fail("parse", std::string(name) + ": a number of 0 or more expected, found " + in_quotes(text));
    return value;
  }

  static void require(const std::optional<GiftiArray>& array, const char* intent) {
    if (array) return;
    throw base::Error("missing-attribute", std::string("the file has no array of ") + intent +
                                               ": a surface has one; files of data or labels have none");
  }

  NumberArray read(const GiftiArray& array, const ArrayPlace& place) const {
    NumberArray result(host_.memory);
    if (array.encoding == "ASCII") {
      result = NumberArray::of_text(array.text, array.type, place, host_);
    } else {
      result = NumberArray::of_bytes(bytes_of(array, place), array.type, array.order, place);
    }
    if (result.size() % 3 != 0 || result.size() / 3 != array.rows) {
      place.fail("parse", base::counted(result.size(), "number") + ", where " + base::counted(array.rows, "row") +
                              " of three are expected");
    }
    return result;
  }

  base::Array<std::byte> bytes_of(const GiftiArray& array, const ArrayPlace& place) const {
    const bool compressed = array.encoding == "GZipBase64Binary";
    base::Base64Decoder decoder(array.text);
    // Sizes that the file claims are compared with the bytes that there are.
    const std::uint64_t row = 3 * size_of(array.type), there = decoder.max_left();
    if (array.rows > there * (compressed ? zlib_max_expansion : 1) / row) {
      place.fail("truncated", "the file says that it has " + base::counted(array.rows, "row") + ", but only " +
                                  std::to_string(array.text.size()) + " characters follow");
    }
    base::Array<std::byte> result(host_.memory);
    if (!compressed) {
      result.resize(array.rows * row);
      decode(decoder, result, place);
      return result;
    }
    base::Array<std::byte> packed(host_.memory);
    packed.resize(there);
    packed.resize(decoder.read_some(packed));
    if (!decoder.at_end()) place.fail("parse", "the numbers are no base64");
    result.resize(array.rows * row);
    inflate_exactly(packed, result, host_);
    return result;
  }

  static void decode(base::Base64Decoder& decoder, std::span<std::byte> into, const ArrayPlace& place) {
    if (!decoder.read(into)) place.fail("truncated", "the numbers end before their size, or are no base64");
    if (!decoder.at_end()) place.fail("parse", "more numbers than the array has");
  }

  static std::size_t at(const GiftiArray& array, std::size_t row, std::size_t column) {
    return array.by_columns ? column * array.rows + row : 3 * row + column;
  }

  void read_points() {
    const ArrayPlace place{"the array of points"};
    const NumberArray numbers = read(*points_, place);
    mesh_.positions.reserve(points_->rows);
    for (std::size_t i = 0; i < points_->rows; ++i) {
      if (i % 4096 == 0) host_.report("reading", i, points_->rows);
      Vector3 p;
      for (std::size_t k = 0; k < 3; ++k)
        p[static_cast<int>(k)] = numbers.real(at(*points_, i, k));
      if (!p.allFinite()) place.fail("non-finite", "point " + std::to_string(i) + " is not finite");
      mesh_.positions.push_back(p);
    }
  }

  void read_triangles() {
    const ArrayPlace place{"the array of triangles"};
    const NumberArray numbers = read(*triangles_, place);
    if (numbers.is_real()) place.fail("parse", "real numbers, where integers are expected");
    mesh_.triangles.reserve(triangles_->rows);
    for (std::size_t i = 0; i < triangles_->rows; ++i) {
      if (i % 4096 == 0) host_.report("reading", i, triangles_->rows);
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t v = numbers.integer(at(*triangles_, i, k));
        if (v < 0 || static_cast<std::uint64_t>(v) >= mesh_.positions.size()) {
          place.fail("index-range", "vertex index " + std::to_string(v) + " of " +
                                        base::counted(mesh_.positions.size(), "vertex", "vertices"));
        }
        triangle[k] = static_cast<Index>(v);
      }
      mesh_.triangles.push_back(triangle);
    }
  }

  // Coordinates are kept in the space of the data; a matrix to another space is noted.
  void note_space() {
    if (points_->matrix.empty()) return;
    const NumberArray matrix =
        NumberArray::of_text(points_->matrix, NumberType::float64, ArrayPlace{"the matrix of the points"}, host_);
    bool identity = matrix.size() == 16;
    for (std::size_t i = 0; i < matrix.size() && identity; ++i)
      identity = matrix.real(i) == (i % 5 == 0 ? 1 : 0);
    if (identity) return;
    report_.notes.push_back("coordinates are kept as they are; the file's matrix to the space " +
                            in_quotes(points_->space) + " is left out");
  }

  XmlScanner scanner_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  std::optional<GiftiArray> points_, triangles_;
  std::size_t others_ = 0;
};

}  // namespace

Mesh read_gifti(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  return GiftiReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
