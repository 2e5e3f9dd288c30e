// The reader of XML files of VTK: each form of storage with the same contents, several pieces, and what is refused.
#include <doctest/doctest.h>

#include <limits>

#include "read_text.h"
#include "xml_files.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

enum class Form { ascii, binary, appended_base64, appended_raw };

struct Storage {
  Form form = Form::ascii;
  bool compressed = false, big_endian = false, long_header = false;
};

std::vector<Storage> all_storages() {
  std::vector<Storage> result = {{}};
  for (const Form form : {Form::binary, Form::appended_base64, Form::appended_raw}) {
    for (int flags = 0; flags < 8; ++flags) {
      if ((flags & 1) != 0 && !has_zlib()) continue;
      result.push_back({form, (flags & 1) != 0, (flags & 2) != 0, (flags & 4) != 0});
    }
  }
  return result;
}

// Collects arrays as a form of storage has them.
class XmlFile {
 public:
  XmlFile(const Storage& storage, const std::string& kind) : storage_(storage), kind_(kind) {}

  XmlFile& operator<<(const std::string& xml) {
    body_ += xml;
    return *this;
  }
  template <class Number>
  XmlFile& array(const std::string& type_and_name, const std::vector<Number>& numbers) {
    body_ += "<DataArray type=" + type_and_name;
    if (storage_.form == Form::ascii) {
      body_ += " format=\"ascii\">";
      for (const Number number : numbers)
        body_ += std::to_string(number) + "\n";
    } else if (storage_.form == Form::binary) {
      body_ += " format=\"binary\"><InformationKey>text</InformationKey>\n" + encoded(numbers) + "\n";
    } else {
      body_ += " format=\"appended\" offset=\"" + std::to_string(appended_.size()) + "\">";
      appended_ += encoded(numbers);
    }
    body_ += "</DataArray>\n";
    return *this;
  }
  std::string text() const {
    std::string result = "<?xml version='1.0'?>\n<!-- a < comment -->\n<VTKFile type=\"" + kind_ +
                         "\" version=\"1.0\" byte_order=\"" + (storage_.big_endian ? "Big" : "Little") + "Endian\"" +
                         (storage_.long_header ? " header_type=\"UInt64\"" : "") +
                         (storage_.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") + ">\n<" + kind_ + ">\n" +
                         body_ + "</" + kind_ + ">\n";
    if (storage_.form == Form::appended_base64)
      result += "<AppendedData encoding=\"base64\">\n  _" + appended_ + "\n</AppendedData>\n";
    if (storage_.form == Form::appended_raw)
      result += "<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n";
    return result + "</VTKFile>\n";
  }

 private:
  std::string header(const std::vector<std::uint64_t>& numbers) const {
    if (storage_.long_header) return raw_bytes(numbers, storage_.big_endian);
    return raw_bytes(std::vector<std::uint32_t>(numbers.begin(), numbers.end()), storage_.big_endian);
  }
  template <class Number>
  std::string encoded(const std::vector<Number>& numbers) const {
    const std::string bytes = raw_bytes(numbers, storage_.big_endian);
    std::string head = header({bytes.size()}), contents = bytes;
    if (storage_.compressed) {
      // Blocks of 40 bytes, so that there are several.
      constexpr std::size_t block = 40;
      contents.clear();
      std::vector<std::uint64_t> sizes = {(bytes.size() + block - 1) / block, block, bytes.size() % block};
      for (std::size_t at = 0; at < bytes.size(); at += block) {
        const std::string packed = compressed(bytes.substr(at, block));
        sizes.push_back(packed.size());
        contents += packed;
      }
      head = header(sizes);
    }
    if (storage_.form == Form::appended_raw) return head + contents;
    return storage_.compressed ? base64(head) + base64(contents) : base64(head + contents);
  }

  Storage storage_;
  std::string kind_, body_, appended_;
};

const std::vector<double> cube = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
const std::vector<float> tip = {0, 0, 1, 1, 0, 1, 1, 1, 1, .5, .5, 2};

std::string grid(const Storage& storage, std::int32_t corner = 7, std::int64_t end = 8, std::uint8_t type = 12) {
  XmlFile file(storage, "UnstructuredGrid");
  file << "<FieldData><DataArray type=\"String\" Name=\"title\" format=\"ascii\">65 0</DataArray></FieldData>";
  file << "<Piece NumberOfPoints=\"8\" NumberOfCells=\"3\"><PointData Scalars='t'>";
  file.array("\"Float64\" Name=\"t\"", std::vector<double>(8, 1.5)) << "</PointData><Points>";
  file.array("\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", cube) << "</Points><Cells>";
  file.array("\"Int32\" Name=\"connectivity\"", std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, corner, 0, 1, 4, 6, 5});
  file.array("\"Int64\" Name=\"offsets\"", std::vector<std::int64_t>{end, 10, 13});
  file.array("\"UInt8\" Name=\"types\"", std::vector<std::uint8_t>{type, 3, 5}) << "</Cells></Piece>";
  file << "<Piece NumberOfPoints=\"4\" NumberOfCells=\"1\"><Points>";
  file.array("\"Float32\" NumberOfComponents=\"3\"", tip) << "</Points><Cells>";
  file.array("\"UInt64\" Name=\"connectivity\"", std::vector<std::uint64_t>{0, 1, 2, 3});
  file.array("\"UInt32\" Name=\"offsets\"", std::vector<std::uint32_t>{4});
  file.array("\"Int8\" Name=\"types\"", std::vector<std::int8_t>{10}) << "</Cells></Piece>";
  return file.text();
}

std::string surface(const Storage& storage) {
  XmlFile file(storage, "PolyData");
  file << "<Piece NumberOfPoints=\"8\" NumberOfVerts=\"1\" NumberOfPolys=\"1\"><Points>";
  file.array("\"Float64\" NumberOfComponents=\"3\"", cube) << "</Points><Verts>";
  file.array("\"Int16\" Name=\"connectivity\"", std::vector<std::int16_t>{3});
  file.array("\"UInt16\" Name=\"offsets\"", std::vector<std::uint16_t>{1}) << "</Verts><Lines/><Strips>";
  file.array("\"Int32\" Name=\"connectivity\"", std::vector<std::int32_t>{0, 1, 4, 5});
  file.array("\"Int32\" Name=\"offsets\"", std::vector<std::int32_t>{4}) << "</Strips><Polys>";
  file.array("\"Int32\" Name=\"connectivity\"", std::vector<std::int32_t>{0, 3, 2, 1});
  file.array("\"Int32\" Name=\"offsets\"", std::vector<std::int32_t>{4}) << "</Polys></Piece>";
  return file.text();
}

}  // namespace

TEST_CASE("VTK XML: grids and surfaces of each form of storage are the same mesh") {
  for (const Storage& storage : all_storages()) {
    CAPTURE(static_cast<int>(storage.form));
    CAPTURE(storage.compressed);
    CAPTURE(storage.big_endian);
    ReadReport report;
    const Mesh solid = read_text(Format::vtu, grid(storage), {.feature_tags = true}, &report);
    REQUIRE(solid.positions.size() == 12);
    CHECK(solid.positions[6] == Vector3(1, 1, 1));
    CHECK(solid.positions[11] == Vector3(.5, .5, 2));
    CHECK(solid.hexahedra == Array<Hexahedron>{{0, 1, 2, 3, 4, 5, 6, 7}});
    CHECK(solid.tetrahedra == Array<Tetrahedron>{{8, 9, 10, 11}});
    CHECK(solid.triangles == Array<Triangle>{{4, 6, 5}});
    CHECK(report.tags->edges == std::vector<std::array<Index, 2>>{{0, 1}});
    CHECK(report.notes.back() == "left out: 2 data arrays");
    const Mesh faces = read_text(Format::vtp, surface(storage), {}, &report);
    CHECK(faces.positions.size() == 8);
    CHECK(faces.triangles == Array<Triangle>{{0, 1, 4}, {4, 1, 5}, {0, 3, 2}, {0, 2, 1}});
    CHECK(report.polygons == 1);
    CHECK(report.notes.back() == "passed over: 1 vertex");
  }
}

TEST_CASE("VTK XML: what cannot be read is refused with the array") {
  constexpr Format format = Format::vtu;
  const std::string text = grid({});
  CHECK(ends_as(format, "solid\n", "bad-magic"));
  CHECK(ends_as(format, "<svg/>", "bad-magic", "VTKFile"));
  CHECK(ends_as(format, replaced_once(text, "UnstructuredGrid", "ImageData"), "unsupported-format", "'ImageData'"));
  CHECK(ends_as(format, replaced_once(text, "<UnstructuredGrid>", "<PolyData>"), "parse"));
  CHECK(ends_as(format, "<VTKFile type=\"PolyData\"></VTKFile>", "empty-mesh"));
  CHECK(ends_as(format, replaced_once(text, " byte_order=", " compressor=\"vtkLZ4DataCompressor\" byte_order="),
                "unsupported", "LZ4"));
  CHECK(ends_as(format, replaced_once(text, "NumberOfCells=\"3\"", "NumberOfCells=\"-3\""), "parse", "'-3'"));
  CHECK(ends_as(format, replaced_once(text, "NumberOfCells=\"3\"", "NumberOfCells=\"4\""), "parse",
                "3 offsets of 4 cells"));
  CHECK(
      ends_as(format, replaced_once(text, "NumberOfPoints=\"8\"", "NumberOfPoints=\"18446744073709551615\""), "parse"));
  CHECK(ends_as(format, replaced_once(text, "\n1.000000\n", "\nnan\n"), "non-finite"));
  CHECK(ends_as(format, replaced_once(text, "\n1.000000\n", "\n1e999\n"), "non-finite"));
  CHECK(ends_as(format, replaced_once(text, "\n1.000000\n", "\none\n"), "parse", "'one'"));
  CHECK(ends_as(format, replaced_once(text, "Name=\"offsets\"", "Name=\"offset\""), "missing-attribute",
                "offsets of Cells"));
  CHECK(ends_as(format, replaced_once(text, "Name=\"offsets\"", "Name=\"connectivity\""), "parse", "twice"));
  CHECK(ends_as(format, replaced_once(text, "</Cells>", "</Points>"), "parse", "not open"));
  CHECK(ends_as(format, replaced_once(text, "\"Int32\" Name=\"connectivity\"", "\"Float32\" Name=\"connectivity\""),
                "parse", "real numbers"));
  CHECK(ends_as(format, grid({}, 8), "index-range", "vertex index 8 of 8 points"));
  CHECK(ends_as(format, grid({}, -1), "index-range", "vertex index -1"));
  CHECK(ends_as(format, grid({}, 7, 14), "index-range", "offset 14"));
  CHECK(ends_as(format, grid({}, 7, 11), "index-range", "offset 10 behind offset 11"));
  CHECK(ends_as(format, grid({}, 7, 8, 25), "unsupported", "quadratic hexahedron"));
  CHECK(ends_as(format, grid({}, 7, 8, 42), "unsupported", "polyhedron"));
  CHECK(ends_as(format, grid({}, 7, 8, 10), "parse"));
  std::string deep;
  for (int i = 0; i < 1000; ++i)
    deep += "<a>";
  CHECK(ends_as(format, deep, "bad-magic"));
  CHECK(ends_as(format, replaced_once(text, "<Points>", deep + "<Points>"), "depth-limit"));
}

TEST_CASE("VTK XML: sizes that a file claims are compared with its bytes") {
  const Storage raw = {.form = Form::appended_raw};
  const std::string text = grid(raw);
  CHECK(outcome(Format::vtu, replaced_once(text, "offset=\"0\"", "offset=\"99999999999\"")) == "accept");  // of data
  CHECK(ends_as(Format::vtu, replaced_once(text, "offset=\"68\"", "offset=\"99999999999\""), "index-range",
                "AppendedData"));
  CHECK(ends_as(Format::vtu, replaced_once(text, "offset=\"68\"", "offset=\"69\""), "parse", "0 numbers"));
  const auto inside = [](const std::string& head) {
    return "<VTKFile type=\"PolyData\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"><PolyData>"
           "<Piece NumberOfPoints=\"2\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
           "format=\"binary\">" +
           head + "</DataArray></Points></Piece></PolyData></VTKFile>";
  };
  const auto head = [](const std::vector<std::uint64_t>& numbers) { return base64(raw_bytes(numbers)); };
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::string blocks = base64(std::string(24, 'x'));
  CHECK(ends_as(Format::vtp, inside(head({most, 32768, 0})), "truncated", "blocks"));
  CHECK(ends_as(Format::vtp, inside(head({1, most, 0, 24}) + blocks), "parse", "cannot come from"));
  CHECK(ends_as(Format::vtp, inside(head({2, most / 2, 5, 12, 12}) + blocks), "parse", "cannot come from"));
  CHECK(ends_as(Format::vtp, inside(head({1, 48, 49, 24}) + blocks), "parse", "last block"));
  CHECK(ends_as(Format::vtp, inside(head({2, 48, 0, most, 24}) + blocks), "truncated"));
  CHECK(ends_as(Format::vtp, inside(head({1, 48, 0, 400}) + blocks), "truncated"));
  CHECK(ends_as(Format::vtp, inside("AAAA!"), "truncated"));
  if (!has_zlib()) {
    CHECK(ends_as(Format::vtp, inside(head({1, 48, 0, 24}) + blocks), "unsupported", "zlib"));
    return;
  }
  CHECK(ends_as(Format::vtp, inside(head({1, 48, 0, 24}) + blocks), "parse", "damaged"));
  // More bytes than the block has, and fewer.
  const std::string packed = compressed(std::string(100000, '\0'));
  CHECK(ends_as(Format::vtp, inside(head({1, 48, 0, packed.size()}) + base64(packed)), "parse", "longer"));
  CHECK(ends_as(Format::vtp, inside(head({1, 100002, 0, packed.size()}) + base64(packed)), "parse", "shorter"));
  CHECK(ends_as(Format::vtp, inside(head({1, 100000, 0, packed.size()}) + base64(packed)), "parse"));
  CHECK(ends_as(Format::vtp, inside(head({1, 100000, 0, packed.size() - 9}) + base64(packed)), "parse", "cut short"));
}

TEST_CASE("VTK XML: memory follows the size of a file whose pieces share their points") {
  const std::string points = raw_bytes(std::vector<std::uint32_t>{1200}) + raw_bytes(std::vector<float>(300, 1));
  const auto file = [&](int pieces) {
    std::string text = "<VTKFile type=\"PolyData\"><PolyData>";
    for (int i = 0; i < pieces; ++i)
      text +=
          "<Piece NumberOfPoints=\"100\"><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
          "format=\"appended\" offset=\"0\"/></Points><Polys><DataArray type=\"Int8\" Name=\"connectivity\" "
          "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int8\" Name=\"offsets\" "
          "format=\"ascii\">3</DataArray></Polys></Piece>";
    return text + "</PolyData><AppendedData encoding=\"raw\">_" + points + "</AppendedData></VTKFile>";
  };
  CHECK(outcome(Format::vtp, file(4)) == "accept");
  CHECK(ends_as(Format::vtp, file(5), "parse", "arrays overlap"));
}

TEST_CASE("VTK XML: a file cut short or changed at any byte is refused, or is a mesh all the same") {
  for (const Storage& storage : all_storages()) {
    if (storage.long_header != storage.big_endian) continue;
    for (const auto& [format, whole] : {std::pair{Format::vtu, grid(storage)}, {Format::vtp, surface(storage)}}) {
      for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::vector<char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
        const std::string ended = outcome(format, {cut.data(), cut.size()});
        CHECK_FALSE(ended.starts_with("internal"));
        if (size + 2 < whole.size()) CHECK(ended != "accept");
        std::string changed = whole;
        changed[size] = static_cast<char>(changed[size] ^ (size % 2 == 0 ? 0x41 : 0x80));
        CHECK_FALSE(outcome(format, changed).starts_with("internal"));
      }
    }
  }
}
