// The reader of GIFTI's surfaces: each encoding with the same contents, matrices, and what is refused.
#include <doctest/doctest.h>

#include <limits>

#include "read_text.h"
#include "xml_files.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

const std::vector<float> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1.5F};
const std::vector<std::int32_t> triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

struct Encoding {
  const char* name;
  bool big_endian = false, by_columns = false;
};

template <class Number>
std::string array(const char* intent, const char* type, std::vector<Number> numbers, const Encoding& encoding,
                  const std::string& about = "") {
  const std::size_t rows = numbers.size() / 3;
  if (encoding.by_columns) {
    const std::vector<Number> by_rows = numbers;
    for (std::size_t i = 0; i < 3 * rows; ++i)
      numbers[i % 3 * rows + i / 3] = by_rows[i];
  }
  std::string data;
  const std::string name = encoding.name;
  if (name == "ASCII") {
    for (const Number number : numbers)
      data += std::to_string(number) + " ";
  } else {
    const std::string bytes = raw_bytes(numbers, encoding.big_endian);
    data = base64(name == "Base64Binary" ? bytes : compressed(bytes));
  }
  return "<DataArray Intent=\"NIFTI_INTENT_" + std::string(intent) + "\" DataType=\"NIFTI_TYPE_" + type +
         "\" ArrayIndexingOrder=\"" + (encoding.by_columns ? "Column" : "Row") +
         "MajorOrder\" Dimensionality=\"2\" Dim0=\"" + std::to_string(rows) + "\" Dim1=\"3\" Encoding=\"" + name +
         "\" Endian=\"" + (encoding.big_endian ? "Big" : "Little") +
         "Endian\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n" +
         "<MetaData><MD><Name><![CDATA[a ]] > b]]></Name><Value>1 &lt; 2</Value></MD></MetaData>\n" + about + "<Data>" +
         data + "</Data></DataArray>\n";
}

std::string file_of(const Encoding& encoding, const std::string& about = "",
                    const std::vector<std::int32_t>& corners = triangles) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\" [ <!ENTITY e \"text\"> ]>\n<GIFTI Version=\"1.0\" "
         "NumberOfDataArrays=\"2\"><MetaData/><LabelTable/>\n" +
         array("TRIANGLE", "INT32", corners, encoding) + array("POINTSET", "FLOAT32", points, encoding, about) +
         "</GIFTI>\n";
}

std::string transform(const std::string& matrix) {
  return "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>"
         "<TransformedSpace><![CDATA[NIFTI_XFORM_TALAIRACH]]></TransformedSpace><MatrixData>" +
         matrix + "</MatrixData></CoordinateSystemTransformMatrix>";
}

}  // namespace

TEST_CASE("GIFTI: each encoding and order has the same surface") {
  for (const char* name : {"ASCII", "Base64Binary", "GZipBase64Binary"}) {
    if (std::string(name) == "GZipBase64Binary" && !has_zlib()) continue;
    for (int flags = 0; flags < 4; ++flags) {
      CAPTURE(name);
      CAPTURE(flags);
      const Mesh mesh = read_text(Format::gifti, file_of({name, (flags & 1) != 0, (flags & 2) != 0}));
      REQUIRE(mesh.positions.size() == 4);
      CHECK(mesh.positions[1] == Vector3(1, 0, 0));
      CHECK(mesh.positions[3] == Vector3(0, 0, 1.5));
      CHECK(mesh.triangles == Array<Triangle>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    }
  }
}

TEST_CASE("GIFTI: coordinates are kept, and a matrix to another space is noted") {
  const auto notes = [](const std::string& matrix) {
    ReadReport report;
    CHECK(read_text(Format::gifti, file_of({"ASCII"}, transform(matrix)), {}, &report).positions[1] ==
          Vector3(1, 0, 0));
    return report.notes;
  };
  CHECK(notes("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1").empty());
  const auto told = notes("1 0 0 2.5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  REQUIRE(told.size() == 1);
  CHECK(told[0].find("'NIFTI_XFORM_TALAIRACH'") != std::string::npos);
}

TEST_CASE("GIFTI: what cannot be read is refused") {
  constexpr Format format = Format::gifti;
  const std::string text = file_of({"ASCII"});
  CHECK(ends_as(format, "solid\n", "bad-magic"));
  CHECK(ends_as(format, "<svg/>", "bad-magic", "GIFTI"));
  CHECK(ends_as(format, "<GIFTI/>", "missing-attribute", "POINTSET"));
  CHECK(ends_as(format, replaced_once(text, "INTENT_TRIANGLE", "INTENT_SHAPE"), "missing-attribute", "TRIANGLE"));
  CHECK(ends_as(format, replaced_once(text, "INTENT_TRIANGLE", "INTENT_POINTSET"), "unsupported", "more than one"));
  CHECK(ends_as(format, replaced_once(text, "ASCII", "ExternalFileBinary"), "unsupported-uri"));
  CHECK(ends_as(format, replaced_once(text, "ASCII", "Base16"), "parse", "'Base16'"));
  CHECK(ends_as(format, replaced_once(text, "TYPE_INT32", "TYPE_FLOAT32"), "parse", "integers"));
  CHECK(ends_as(format, replaced_once(text, "TYPE_INT32", "TYPE_RGB24"), "parse", "RGB24"));
  CHECK(ends_as(format, replaced_once(text, "Dim1=\"3\"", "Dim1=\"2\""), "parse"));
  CHECK(ends_as(format, replaced_once(text, "Dim0=\"4\"", "Dim0=\"5\""), "parse", "5 rows"));
  CHECK(ends_as(format, replaced_once(text, "Dim0=\"4\"", "Dim0=\"nan\""), "parse", "'nan'"));
  CHECK(ends_as(format, replaced_once(text, "1.500000", "inf"), "non-finite"));
  CHECK(ends_as(format, file_of({"ASCII"}, "", {0, 2, 4}), "index-range", "4 of 4"));
  CHECK(ends_as(format, file_of({"ASCII"}, "", {0, 2, -1}), "index-range", "-1 of 4"));
  CHECK(ends_as(format, file_of({"ASCII"}, transform("1 0 x")), "parse", "'x'"));
  const std::string huge = "Dim0=\"" + std::to_string(std::numeric_limits<std::uint64_t>::max()) + "\"";
  for (const char* name : {"ASCII", "Base64Binary", "GZipBase64Binary"}) {
    if (std::string(name) == "GZipBase64Binary" && !has_zlib()) continue;
    const std::string whole = file_of({name});
    CHECK(ends_as(format, replaced_once(whole, "Dim0=\"4\"", huge),
                  std::string(name) == "ASCII" ? "parse" : "truncated"));
    CHECK(ends_as(format, replaced_once(whole, "Dim0=\"4\"", "Dim0=\"3\""), "parse"));
  }
}

TEST_CASE("GIFTI: a file cut short or changed at any byte is refused, or is a surface all the same") {
  for (const char* name : {"ASCII", "Base64Binary", "GZipBase64Binary"}) {
    if (std::string(name) == "GZipBase64Binary" && !has_zlib()) continue;
    const std::string whole = file_of({name}, transform("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"));
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::vector<char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      const std::string ended = outcome(Format::gifti, {cut.data(), cut.size()});
      CHECK_FALSE(ended.starts_with("internal"));
      if (size + 2 < whole.size()) CHECK(ended != "accept");
      std::string changed = whole;
      changed[size] = static_cast<char>(changed[size] ^ 0x41);
      CHECK_FALSE(outcome(Format::gifti, changed).starts_with("internal"));
    }
  }
}
