#include "mesh/formats/xml/vtk_xml_file.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "mesh/files/text_scanner.h"
#include "mesh/formats/vtk_data.h"

namespace orbicube::mesh {
namespace {

constexpr std::array section_names = {"Points", "Verts", "Lines", "Strips", "Polys", "Cells", "CellData"};

std::optional<VtkXmlSection> section_named(std::string_view name) {
  const auto found = std::ranges::find(section_names, name);
  if (found == section_names.end()) return std::nullopt;
  return static_cast<VtkXmlSection>(found - section_names.begin());
}

constexpr std::size_t array_depth = 5;  // open elements at an array: VTKFile, PolyData, Piece, Points, DataArray

class FileReader {
 public:
  FileReader(XmlScanner& scanner, const base::Host& host) : scanner_(scanner), file_(host.memory) {}

  VtkXmlFile run() {
    using enum XmlScanner::Event;
    bool ended = false;
    while (!ended) {
      switch (scanner_.next()) {
        case start:
          ended = element();
          break;
        case text:
          // Not that of an element inside of the array.
          if (in_array_ && scanner_.open().size() == array_depth) file_.entries.back().array.text = scanner_.text();
          break;
        case end:
          in_array_ = in_array_ && scanner_.open().size() >= array_depth;
          break;
        case end_of_file:
          ended = true;
      }
    }
    if (kind_.empty()) scanner_.fail("truncated", "the file has no data set");
    return std::move(file_);
  }

 private:
  // Returns true for AppendedData, behind whose beginning the file need not be XML.
  bool element() {
    const auto& open = scanner_.open();
    const std::string_view name = scanner_.name();
    if (open.size() == 1) {
      root();
    } else if (open.size() == 2 && name == "AppendedData") {
      appended();
      return true;
    } else if (open.size() == 2) {
      data_set();
    } else if (open.size() == 3 && open[1] == kind_ && name == "Piece") {
      file_.pieces.push_back({count("NumberOfPoints"), file_.grid ? count("NumberOfCells") : 0});
    } else if (name == "DataArray" || name == "Array") {
      array();
    }
    return false;
  }

  void root() {
    if (scanner_.name() != "VTKFile")
      scanner_.fail("bad-magic", "the element VTKFile expected, found " + in_quotes(scanner_.name()));
    kind_ = scanner_.attribute("type").value_or("");
    file_.grid = kind_ == "UnstructuredGrid";
    if (!file_.grid && kind_ != "PolyData")
      scanner_.fail("unsupported-format", "data sets of kind " + in_quotes(kind_) + " are not read");
    const std::string_view order = scanner_.attribute("byte_order").value_or("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian")
      scanner_.fail("parse", "the order of bytes " + in_quotes(order));
    file_.storage.order = order == "BigEndian" ? std::endian::big : std::endian::little;
    const std::string_view header = scanner_.attribute("header_type").value_or("UInt32");
    if (header != "UInt32" && header != "UInt64") scanner_.fail("unsupported", "header_type " + in_quotes(header));
    file_.storage.header_size = header == "UInt32" ? 4 : 8;
    const std::string_view compressor = scanner_.attribute("compressor").value_or("");
    file_.storage.compressed = !compressor.empty();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
      scanner_.fail("unsupported", "the compressor " + in_quotes(compressor) +
                                       ", where vtkZLibDataCompressor is read; save the file with it or without one");
    }
  }

  void data_set() {
    if (scanner_.name() != kind_)
      scanner_.fail("parse", "the element " + in_quotes(kind_) + " expected, found " + in_quotes(scanner_.name()));
  }

  void appended() {
    const std::string_view encoding = scanner_.attribute("encoding").value_or("base64");
    if (encoding != "raw" && encoding != "base64")
      scanner_.fail("unsupported", "AppendedData with the encoding " + in_quotes(encoding));
    const std::string_view rest = scanner_.rest();
    const std::size_t begin = rest.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) scanner_.fail("truncated", "the file ends before its AppendedData");
    if (rest[begin] != '_') scanner_.fail("parse", "AppendedData begins with an underscore");
    const std::size_t end = rest.rfind("</AppendedData");
    if (end == std::string_view::npos || end < begin || rest.substr(end).find("</VTKFile") == std::string_view::npos)
      scanner_.fail("truncated", "the file ends inside its AppendedData");
    file_.storage.appended = rest.substr(begin + 1, end - begin - 1);
    file_.storage.appended_base64 = encoding == "base64";
  }

  std::uint64_t count(const char* attribute) const {
    return number(scanner_.attribute(attribute).value_or(""), attribute);
  }

  std::uint64_t number(std::string_view text, const char* what) const {
    std::uint64_t value = 0;
    text = trimmed(text);
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || problem != std::errc() || end != text.data() + text.size())
      scanner_.fail("parse", std::string(what) + ": a number of 0 or more expected, found " + in_quotes(text));
    return value;
  }

  static std::optional<VtkXmlRole> role_of(VtkXmlSection section, std::string_view name) {
    if (section == VtkXmlSection::points) return VtkXmlRole::positions;
    if (name == "connectivity") return VtkXmlRole::connectivity;
    if (name == "offsets") return VtkXmlRole::offsets;
    if (name == "types" && section == VtkXmlSection::cells) return VtkXmlRole::types;
    return std::nullopt;  // faces of polyhedra, which are refused by their type
  }

  void array() {
    const auto& open = scanner_.open();
    const std::string_view parent = open[open.size() - 2];
    if (parent == "PointData" || parent == "CellData" || parent == "FieldData") ++file_.data_arrays;
    if (open.size() != array_depth || open[2] != "Piece") return;
    const auto section = section_named(parent);
    if (!section) return;
    if (*section == VtkXmlSection::cell_data) {
      data_on_cells();
      return;
    }
    const auto role = role_of(*section, scanner_.attribute("Name").value_or(""));
    if (!role) return;
    file_.entries.push_back({file_.pieces.size() - 1, *section, *role, description()});
    in_array_ = file_.entries.back().array.form != VtkXmlForm::appended;
    const std::string_view components = scanner_.attribute("NumberOfComponents").value_or("1");
    if (*section == VtkXmlSection::points && components != "3")
      scanner_.fail("unsupported", "points of " + in_quotes(components) + " coordinates, where three are read");
  }

  // Keeps the array of a piece whose name is the most usual one of region numbers. Others may be of any type.
  void data_on_cells() {
    const std::string_view name = scanner_.attribute("Name").value_or("");
    const auto rank = region_rank(name);
    const std::size_t piece = file_.pieces.size() - 1;
    if (!rank || scanner_.attribute("NumberOfComponents").value_or("1") != "1") return;
    if (!vtk_xml_type(scanner_.attribute("type").value_or(""))) return;
    auto known = file_.entries.end();
    for (auto at = known; at != file_.entries.begin() && (--at)->piece == piece;)
      if (at->role == VtkXmlRole::regions) known = at;
    if (known == file_.entries.end())
      --file_.data_arrays;
    else if (*rank >= *region_rank(known->name))
      return;
    else
      file_.entries.erase(known);
    file_.entries.push_back({piece, VtkXmlSection::cell_data, VtkXmlRole::regions, description(), std::string(name)});
    in_array_ = file_.entries.back().array.form != VtkXmlForm::appended;
  }

  VtkXmlArray description() const {
    VtkXmlArray result;
    const std::string_view type = scanner_.attribute("type").value_or("");
    const auto known = vtk_xml_type(type);
    if (!known) scanner_.fail("parse", "an array of numbers of type " + in_quotes(type));
    result.type = *known;
    const std::string_view form = scanner_.attribute("format").value_or("ascii");
    if (form == "appended") {
      result.form = VtkXmlForm::appended;
      result.offset = number(scanner_.attribute("offset").value_or(""), "offset");
    } else if (form == "binary") {
      result.form = VtkXmlForm::binary;
    } else if (form != "ascii") {
      scanner_.fail("parse", "an array of the format " + in_quotes(form));
    }
    return result;
  }

  XmlScanner& scanner_;
  VtkXmlFile file_;
  std::string_view kind_;
  bool in_array_ = false;
};

}  // namespace

const char* name_of(VtkXmlSection section) {
  return section_names[static_cast<std::size_t>(section)];
}

VtkXmlFile read_vtk_xml_file(XmlScanner& scanner, const base::Host& host) {
  return FileReader(scanner, host).run();
}

}  // namespace orbicube::mesh
