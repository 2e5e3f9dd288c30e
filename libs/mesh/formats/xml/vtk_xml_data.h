// How numbers are stored in XML files of VTK: in each array or behind all of them, as bytes or base64, compressed in
// blocks or not.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/host.h"
#include "mesh/formats/xml/number_array.h"

namespace orbicube::mesh {

// What the attributes of the outermost element say about all arrays.
struct VtkXmlStorage {
  std::endian order = std::endian::little;
  std::size_t header_size = 4;  // bytes of each number before the contents: 4 or 8
  bool compressed = false;
  std::string_view appended;  // the contents of AppendedData behind its underscore
  bool appended_base64 = false;
};

enum class VtkXmlForm : std::uint8_t { ascii, binary, appended };

struct VtkXmlArray {
  NumberType type = NumberType::float32;
  VtkXmlForm form = VtkXmlForm::ascii;
  std::string_view text;     // of ascii and binary
  std::uint64_t offset = 0;  // of appended
};

// Returns the type with a name, as "Float32".
std::optional<NumberType> vtk_xml_type(std::string_view name);

// Reads an array. Sizes that the file claims are compared with the bytes that are there before memory is allocated.
// `taken` has the number of bytes of AppendedData that all arrays have read so far, and grows: a file whose arrays
// overlap would need memory by the square of its size. Throws Error "truncated", "parse", "index-range" for an offset
// behind the end, "unsupported", "cancelled".
NumberArray read_vtk_xml_array(const VtkXmlArray& array, const VtkXmlStorage& storage, const ArrayPlace& place,
                               const base::Host& host, std::uint64_t& taken);

}  // namespace orbicube::mesh
