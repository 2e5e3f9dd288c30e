#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/error.h"
#include "base/files/base64.h"
#include "mesh/files/float_positions.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/xml/zlib_data.h"

namespace orbicube::mesh {
namespace {

constexpr std::string_view head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
    "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n<MetaData/>\n<LabelTable/>\n";
// The gifti_space of the points is not known.
constexpr std::string_view gifti_space =
    "<CoordinateSystemTransformMatrix>\n<DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>\n"
    "<TransformedSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></TransformedSpace>\n"
    "<MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData>\n</CoordinateSystemTransformMatrix>\n";

void append(std::uint32_t x, base::Array<std::byte>& bytes) {
  for (unsigned i = 0; i < 4; ++i)
    bytes.push_back(static_cast<std::byte>(x >> (8 * i) & 0xFFU));
}

// An array of rows of three numbers of 32 bits, each put by put_row(row, put).
template <class PutRow>
void write_array(TextWriter& out, const std::string& intent_and_type, std::string_view about, std::size_t rows,
                 bool binary, const base::Host& host, const PutRow& put_row) {
  out << "<DataArray " << intent_and_type << " ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\""
      << std::uint64_t{rows} << "\" Dim1=\"3\" Encoding=\""
      << (!binary      ? "ASCII"
          : has_zlib() ? "GZipBase64Binary"
                       : "Base64Binary")
      << "\" Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData/>\n"
      << about << "<Data>";
  base::Array<std::byte> bytes(host.memory);
  for (std::size_t i = 0; i < rows; ++i) {
    put_row(i, [&](auto x) {
      if (!binary)
        out << x << ' ';
      else if constexpr (std::is_same_v<decltype(x), double>)
        append(std::bit_cast<std::uint32_t>(to_float(x, "GIFTI")), bytes);
      else
        append(x, bytes);
    });
    if (!binary) out << '\n';
    out.end_item();
  }
  if (binary) {
    std::string text;
    base::append_base64(has_zlib() ? deflate(bytes, host) : bytes, text);
    out << text;
  }
  out << "</Data>\n</DataArray>\n";
}

}  // namespace

void write_gifti(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (mesh.positions.size() > most) throw base::Error("unsupported", "more vertices than GIFTI's 32 bits can count");
  if (options.binary) require_float_resolution(mesh, "GIFTI", "PLY and OBJ hold them");
  TextWriter out(file, mesh.positions.size() + mesh.triangles.size(), host);
  out << head;
  write_array(out, "Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\"", gifti_space,
              mesh.positions.size(), options.binary, host, [&](std::size_t i, const auto& put) {
                for (const double x : mesh.positions[i])
                  put(x);
              });
  write_array(out, "Intent=\"NIFTI_INTENT_TRIANGLE\" DataType=\"NIFTI_TYPE_INT32\"", "", mesh.triangles.size(),
              options.binary, host, [&](std::size_t i, const auto& put) {
                for (const Index v : mesh.triangles[i])
                  put(v);
              });
  out << "</GIFTI>\n";
  out.flush();
}

}  // namespace orbicube::mesh
