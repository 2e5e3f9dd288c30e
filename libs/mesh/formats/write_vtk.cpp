#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/error.h"
#include "mesh/files/binary_writer.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/vtk_regions.h"

namespace orbicube::mesh {
namespace {

// Where numbers go: each item's on a line of their own in text, one after the other in binary files.
class TextOut {
 public:
  TextOut(OutputFile& file, std::uint64_t total, const base::Host& host) : out_(file, total, host) {}
  void line(std::string_view text) { out_ << text << '\n'; }
  void put(double x) { out_ << x << ' '; }
  void put(std::int32_t x) { out_ << x << ' '; }
  void end_item() {
    out_ << '\n';
    out_.end_item();
  }
  void end_section() {}
  void flush() { out_.flush(); }

 private:
  TextWriter out_;
};

class BinaryOut {
 public:
  BinaryOut(OutputFile& file, std::uint64_t total, const base::Host& host)
      : out_(file, std::endian::big, total, host) {}
  void line(std::string_view text) {
    out_.put_text(text);
    out_.put_text("\n");
  }
  void put(double x) { out_.put(x); }
  void put(std::int32_t x) { out_.put(x); }
  void end_item() { out_.end_item(); }
  void end_section() { out_.put_text("\n"); }
  void flush() { out_.flush(); }

 private:
  BinaryWriter out_;
};

// A line of words and numbers. Without streams, since these bring all of locales into the module for JavaScript.
template <class... Parts>
std::string words(const Parts&... parts) {
  std::string line;
  const auto add = [&](const auto& part) {
    if (!line.empty()) line += ' ';
    if constexpr (std::is_integral_v<std::decay_t<decltype(part)>>)
      line += std::to_string(part);
    else
      line += part;
  };
  (add(parts), ...);
  return line;
}

template <class Out>
void write_regions(Out& out, const Mesh& mesh, const WriteOptions& options, std::size_t cells) {
  out.line(words("CELL_DATA", cells));
  out.line("SCALARS region int");  // without the number of components meshio has one number a cell
  out.line("LOOKUP_TABLE default");
  put_regions_of_cells(out, mesh, options);
  out.end_section();
}

template <class Out>
void write(Out&& out, const Mesh& mesh, const WriteOptions& options) {
  const bool surface = mesh.tetrahedra.empty() && mesh.hexahedra.empty();
  out.line("# vtk DataFile Version 3.0");
  out.line(surface ? "surface" : "solid");
  out.line(options.binary ? "BINARY" : "ASCII");
  out.line(surface ? "DATASET POLYDATA" : "DATASET UNSTRUCTURED_GRID");
  out.line(words("POINTS", mesh.positions.size(), "double"));
  for (const Vector3& p : mesh.positions) {
    for (const double x : p)
      out.put(x);
    out.end_item();
  }
  out.end_section();
  const auto put_cells = [&](const auto& cells) {
    for (const auto& cell : cells) {
      out.put(static_cast<std::int32_t>(cell.size()));
      for (const Index v : cell)
        out.put(static_cast<std::int32_t>(v));
      out.end_item();
    }
  };
  const std::size_t count =
      mesh.triangles.size() + options.quads.size() + mesh.tetrahedra.size() + mesh.hexahedra.size();
  const std::size_t size =
      4 * mesh.triangles.size() + 5 * (options.quads.size() + mesh.tetrahedra.size()) + 9 * mesh.hexahedra.size();
  out.line(words(surface ? "POLYGONS" : "CELLS", count, size));
  put_cells(mesh.triangles);
  put_cells(options.quads);
  put_cells(mesh.tetrahedra);
  put_cells(mesh.hexahedra);
  out.end_section();
  if (!surface) {
    out.line(words("CELL_TYPES", count));
    const auto put_types = [&](std::size_t cells, std::int32_t type) {
      for (std::size_t i = 0; i < cells; ++i) {
        out.put(type);
        out.end_item();
      }
    };
    put_types(mesh.triangles.size(), 5);
    put_types(options.quads.size(), 9);
    put_types(mesh.tetrahedra.size(), 10);
    put_types(mesh.hexahedra.size(), 12);
    out.end_section();
  }
  if (!mesh.regions.empty() || !options.quad_regions.empty()) write_regions(out, mesh, options, count);
  out.flush();
}

}  // namespace

void write_vtk(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (mesh.positions.size() > most) throw base::Error("unsupported", "more vertices than VTK's 32 bits can count");
  const std::uint64_t total = mesh.positions.size() + mesh.triangles.size() + 2 * options.quads.size() +
                              2 * mesh.tetrahedra.size() + 2 * mesh.hexahedra.size();
  if (options.binary) {
    write(BinaryOut(file, total, host), mesh, options);
  } else {
    write(TextOut(file, total, host), mesh, options);
  }
}

}  // namespace orbicube::mesh
