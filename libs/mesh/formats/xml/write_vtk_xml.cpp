#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/files/base64.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/vtk_regions.h"
#include "mesh/formats/xml/zlib_data.h"

namespace orbicube::mesh {
namespace {

// The numbers of an array, in text or as base64 of little-endian bytes, compressed in builds with zlib.
class ArrayWriter {
 public:
  ArrayWriter(OutputFile& file, bool binary, std::uint64_t total, const base::Host& host)
      : file_(file), binary_(binary), total_(total), host_(host), bytes_(host.memory) {}

  void line(std::string_view text) {
    text_.append(text).append("\n");
    flush_when_large();
  }
  void begin(std::string_view type_and_name) {
    text_.append("<DataArray type=")
        .append(type_and_name)
        .append(binary_ ? " format=\"binary\">\n" : " format=\"ascii\">\n");
  }
  template <class Number>
  void put(Number x) {
    if (!binary_) {
      char digits[32];
      text_.append(digits, std::to_chars(digits, digits + sizeof digits, x).ptr).append(" ");
      return;
    }
    auto raw = std::bit_cast<std::array<std::byte, sizeof(Number)>>(x);
    if (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
  }
  void put(std::uint8_t x) {
    if (binary_)
      bytes_.push_back(static_cast<std::byte>(x));
    else
      put(static_cast<std::uint32_t>(x));
  }
  void end_item() {
    if (!binary_) text_ += '\n';
    flush_when_large();
    if (++done_ % 1024 == 0) host_.report("writing", std::min(done_, total_), total_);
  }
  void end() {
    if (binary_) encode();
    line("</DataArray>");
  }
  void flush() {
    file_.write(text_);
    text_.clear();
  }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 20U;
  static constexpr std::size_t block = std::size_t{1} << 15U;  // that of VTK

  void flush_when_large() {
    if (text_.size() >= piece) flush();
  }

  static void append(base::Array<std::byte>& bytes, std::uint64_t number) {
    for (unsigned i = 0; i < 8; ++i)
      bytes.push_back(static_cast<std::byte>(number >> (8 * i) & 0xFFU));
  }

  void encode() {
    base::Array<std::byte> header(host_.memory), contents(host_.memory);
    if (has_zlib()) {
      // The number of blocks, their size, that of a last one which is smaller, and each compressed size.
      append(header, (bytes_.size() + block - 1) / block);
      append(header, block);
      append(header, bytes_.size() % block);
      for (std::size_t at = 0; at < bytes_.size(); at += block) {
        host_.report("compressing", at, bytes_.size());
        const auto packed = deflate(std::span(bytes_).subspan(at, std::min(block, bytes_.size() - at)), host_);
        append(header, packed.size());
        contents.insert(contents.end(), packed.begin(), packed.end());
      }
      base::append_base64(header, text_);  // with an end of its own
      base::append_base64(contents, text_);
    } else {
      append(header, bytes_.size());
      header.insert(header.end(), bytes_.begin(), bytes_.end());
      base::append_base64(header, text_);
    }
    text_ += '\n';
    bytes_.clear();
  }

  OutputFile& file_;
  bool binary_;
  std::uint64_t total_;
  const base::Host& host_;
  base::Array<std::byte> bytes_;  // of the array, if binary
  std::string text_;
  std::uint64_t done_ = 0;
};

void put_points(ArrayWriter& out, const Mesh& mesh) {
  out.line("<Points>");
  out.begin("\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"");
  for (const Vector3& p : mesh.positions) {
    for (const double x : p)
      out.put(x);
    out.end_item();
  }
  out.end();
  out.line("</Points>");
}

// Calls `put` with all triangles, quadrilaterals, tetrahedra and hexahedra, one after the other.
template <class Put>
void for_all_cells(const Mesh& mesh, const WriteOptions& options, const Put& put) {
  for (const auto& cell : mesh.triangles)
    put(cell, std::uint8_t{5});
  for (const auto& cell : options.quads)
    put(cell, std::uint8_t{9});
  for (const auto& cell : mesh.tetrahedra)
    put(cell, std::uint8_t{10});
  for (const auto& cell : mesh.hexahedra)
    put(cell, std::uint8_t{12});
}

void put_cells(ArrayWriter& out, const Mesh& mesh, bool grid, const WriteOptions& options) {
  out.line(grid ? "<Cells>" : "<Polys>");
  out.begin("\"Int64\" Name=\"connectivity\"");
  for_all_cells(mesh, options, [&](const auto& cell, std::uint8_t) {
    for (const Index v : cell)
      out.put(std::int64_t{v});
    out.end_item();
  });
  out.end();
  out.begin("\"Int64\" Name=\"offsets\"");
  std::int64_t end = 0;
  for_all_cells(mesh, options, [&](const auto& cell, std::uint8_t) {
    end += static_cast<std::int64_t>(cell.size());
    out.put(end);
    out.end_item();
  });
  out.end();
  if (grid) {
    out.begin("\"UInt8\" Name=\"types\"");
    for_all_cells(mesh, options, [&](const auto&, std::uint8_t type) {
      out.put(type);
      out.end_item();
    });
    out.end();
  }
  out.line(grid ? "</Cells>" : "</Polys>");
}

void put_regions(ArrayWriter& out, const Mesh& mesh, const WriteOptions& options) {
  out.line("<CellData Scalars=\"region\">");
  out.begin("\"Int32\" Name=\"region\"");
  put_regions_of_cells(out, mesh, options);
  out.end();
  out.line("</CellData>");
}

void write(OutputFile& file, const Mesh& mesh, bool grid, const WriteOptions& options, const base::Host& host) {
  const std::size_t cells =
      mesh.triangles.size() + options.quads.size() + mesh.tetrahedra.size() + mesh.hexahedra.size();
  ArrayWriter out(file, options.binary, mesh.positions.size() + (grid ? 3 : 2) * cells, host);
  const std::string kind = grid ? "UnstructuredGrid" : "PolyData";
  const bool compressed = options.binary && has_zlib();
  out.line("<?xml version=\"1.0\"?>");
  out.line("<VTKFile type=\"" + kind + "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"" +
           (compressed ? " compressor=\"vtkZLibDataCompressor\">" : ">"));
  out.line("<" + kind + ">");
  const std::string counts = "<Piece NumberOfPoints=\"" + std::to_string(mesh.positions.size()) + "\"";
  if (grid)
    out.line(counts + " NumberOfCells=\"" + std::to_string(cells) + "\">");
  else
    out.line(counts + " NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
             std::to_string(cells) + "\">");
  put_points(out, mesh);
  put_cells(out, mesh, grid, options);
  if (!mesh.regions.empty() || !options.quad_regions.empty()) put_regions(out, mesh, options);
  out.line("</Piece>");
  out.line("</" + kind + ">");
  out.line("</VTKFile>");
  out.flush();
}

}  // namespace

void write_vtp(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  write(file, mesh, false, options, host);
}

void write_vtu(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  write(file, mesh, true, options, host);
}

}  // namespace orbicube::mesh
