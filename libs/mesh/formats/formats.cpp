#include "mesh/formats/formats.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

// Columns: format, ending, name; whether it holds polygons and cells, and may be binary; reader, writer.
constexpr std::array rows = {
    FormatRow{Format::obj, ".obj", "OBJ", true, false, false, read_obj, write_obj},
    FormatRow{Format::off, ".off", "OFF", true, false, false, read_off, write_off},
    FormatRow{Format::ply, ".ply", "PLY", true, false, true, read_ply, write_ply},
    FormatRow{Format::stl, ".stl", "STL", false, false, true, read_stl, write_stl},
    FormatRow{Format::medit, ".mesh", "MEDIT", true, true, false, read_medit, write_medit},
    FormatRow{Format::vtk, ".vtk", "VTK", true, true, true, read_vtk, write_vtk},
#ifndef __EMSCRIPTEN__  // the module for web pages has to stay small
    FormatRow{Format::msh, ".msh", "MSH", true, true, false, read_msh, write_msh},
#endif
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].format) != i) return false;
  return true;
}
static_assert(in_order(), "rows are numbered by Format");

bool holds(const FormatRow& row, Holds what) {
  return what == Holds::surfaces || (what == Holds::polygons ? row.polygons : row.cells);
}

}  // namespace

std::span<const FormatRow> formats() {
  return rows;
}

const FormatRow& row_of(Format format) {
  return rows[static_cast<std::size_t>(format)];
}

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::optional<Format> format_of_path(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  for (const FormatRow& row : rows) {
    if (ending == row.ending) return row.format;
  }
  return std::nullopt;
}

bool holds(Format format, Holds what) {
  return holds(row_of(format), what);
}

bool holds(const std::filesystem::path& path, Holds what) {
  const auto format = format_of_path(path);
  return format && holds(*format, what);
}

std::string format_endings(Holds what) {
  std::string endings;
  for (const FormatRow& row : rows) {
    if (holds(row, what)) endings.append(endings.empty() ? "" : " ").append(row.ending);
  }
  return endings;
}

}  // namespace orbicube::mesh
