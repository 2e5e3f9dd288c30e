// The structure of an XML file of VTK: its pieces and where the arrays of their shape are.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "base/array.h"
#include "mesh/formats/xml/vtk_xml_data.h"
#include "mesh/formats/xml/xml_scanner.h"

namespace orbicube::mesh {

// The elements of a piece that have its shape and the regions of its cells, in this order, and the arrays in them.
enum class VtkXmlSection : std::uint8_t { points, verts, lines, strips, polys, cells, cell_data };
enum class VtkXmlRole : std::uint8_t { positions, connectivity, offsets, types, regions };

struct VtkXmlPiece {
  std::uint64_t points = 0, cells = 0;  // cells: of an unstructured grid
};

struct VtkXmlEntry {
  std::size_t piece;
  VtkXmlSection section;
  VtkXmlRole role;
  VtkXmlArray array;
  std::string name = {};  // of regions
};

struct VtkXmlFile {
  explicit VtkXmlFile(std::pmr::memory_resource* memory) : pieces(memory), entries(memory) {}

  bool grid = false;  // an unstructured grid, or surfaces
  VtkXmlStorage storage;
  base::Array<VtkXmlPiece> pieces;
  base::Array<VtkXmlEntry> entries;
  std::size_t data_arrays = 0;  // that have no entry
};

// Names a section as the file does.
const char* name_of(VtkXmlSection section);

// Reads the structure without the numbers. Throws the Errors of XmlScanner, "bad-magic", "unsupported-format" for other
// kinds of data sets, "unsupported", "parse".
VtkXmlFile read_vtk_xml_file(XmlScanner& scanner, const base::Host& host);

}  // namespace orbicube::mesh
