#include "mesh/formats/formats.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

// Columns: format, ending, name; whether it holds polygons, cells and regions, and may be binary; reader, writer.
constexpr std::array rows = {
    FormatRow{Format::obj, ".obj", "OBJ", true, false, false, false, read_obj, write_obj},
    FormatRow{Format::off, ".off", "OFF", true, false, false, false, read_off, write_off},
    FormatRow{Format::ply, ".ply", "PLY", true, false, false, true, read_ply, write_ply},
    FormatRow{Format::stl, ".stl", "STL", false, false, false, true, read_stl, write_stl},
    FormatRow{Format::medit, ".mesh", "MEDIT", true, true, true, false, read_medit, write_medit},
    FormatRow{Format::vtk, ".vtk", "VTK", true, true, true, true, read_vtk, write_vtk},
#ifndef __EMSCRIPTEN__  // the module for web pages has to stay small
    FormatRow{Format::msh, ".msh", "MSH", true, true, true, false, read_msh, write_msh},
    FormatRow{Format::freesurfer, ".white", "FREESURFER", false, false, false, true, read_freesurfer, write_freesurfer},
    FormatRow{Format::inp, ".inp", "INP", true, true, true, false, read_inp, write_inp},
    FormatRow{Format::vtp, ".vtp", "VTP", true, false, true, true, read_vtk_xml, write_vtp},
    FormatRow{Format::vtu, ".vtu", "VTU", true, true, true, true, read_vtk_xml, write_vtu},
    FormatRow{Format::gifti, ".gii", "GIFTI", false, false, false, true, read_gifti, write_gifti},
#endif
};

#ifndef __EMSCRIPTEN__
// Further endings: FreeSurfer names surfaces by what they are, as lh.pial and rh.sphere.reg.
struct OtherEnding {
  const char* ending;
  Format format;
};
constexpr std::array other_endings = {
    OtherEnding{".pial", Format::freesurfer},     OtherEnding{".inflated", Format::freesurfer},
    OtherEnding{".sphere", Format::freesurfer},   OtherEnding{".reg", Format::freesurfer},
    OtherEnding{".orig", Format::freesurfer},     OtherEnding{".nofix", Format::freesurfer},
    OtherEnding{".smoothwm", Format::freesurfer}, OtherEnding{".midthickness", Format::freesurfer},
    OtherEnding{".graymid", Format::freesurfer},
};
#endif

constexpr bool in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].format) != i) return false;
  return true;
}
static_assert(in_order(), "rows are numbered by Format");

bool holds(const FormatRow& row, Holds what) {
  switch (what) {
    case Holds::surfaces:
      return true;
    case Holds::polygons:
      return row.polygons;
    case Holds::cells:
      return row.cells;
    case Holds::regions:
      return row.regions;
  }
  return false;
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
#ifndef __EMSCRIPTEN__
  for (const OtherEnding& other : other_endings) {
    if (ending == other.ending) return other.format;
  }
#endif
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
