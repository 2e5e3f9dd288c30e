#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/left_out.h"
#include "mesh/files/polygons.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

class ObjReader {
 public:
  ObjReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : scanner_(bytes, '#', host),
        host_(host),
        report_(report),
        mesh_(host.memory),
        faces_(host.memory),
        face_(host.memory) {
    scanner_.continue_lines_with_backslash();
    mesh_.positions.reserve(bytes.size() / 80);  // a line of 30 bytes for a vertex, 20 for each of its two faces
    faces_.reserve_triangles(bytes.size() / 40);
  }

  Mesh run() {
    for (; !scanner_.at_end_of_file(); scanner_.next_line()) {
      // Keywords of some programs are in capitals; "fo" is the face of files before 1995.
      const std::string keyword = in_small_letters(scanner_.word());
      if (keyword == "v") {
        vertex();
      } else if (keyword == "f" || keyword == "fo") {
        face();
      } else if (report_.tags && (keyword == "l" || keyword == "p")) {
        tag(keyword == "l");
      } else if (!keyword.empty()) {
        pass_over(keyword);
      }
      scanner_.progress();
    }
    if (max_index_ > static_cast<std::int64_t>(mesh_.positions.size())) {
      throw base::Error("index-range", "line " + std::to_string(scanner_.line_of(place_of_largest_)) +
                                           ": vertex index " + std::to_string(max_index_) + " of " +
                                           base::counted(mesh_.positions.size(), "vertex", "vertices"));
    }
    report_.format = "OBJ";
    report_.polygons = faces_.larger_than_triangles();
    faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
    if (lines_ > 0)
      report_.notes.push_back(base::counted(lines_, "line or point was", "lines and points were") + " passed over");
    if (unknown_ > 0)
      report_.notes.push_back(base::counted(unknown_, "line was", "lines were") +
                              " passed over that no OBJ file has (" + first_unknown_ + ")");
    if (free_form_ > 0)
      report_.notes.push_back(
          base::counted(free_form_, "curve or surface of free form was", "curves and surfaces of free form were") +
          " passed over");
    note_left_out({{texture_coordinates_, "texture coordinate", "texture coordinates"},
                   {normals_, "normal", "normals"},
                   {colors_, "vertex color", "vertex colors"},
                   {materials_, "use of a material", "uses of materials"},
                   {groups_, "name of a group or object", "names of groups and objects"}},
                  report_.notes);
    return std::move(mesh_);
  }

 private:
  // Lines that say nothing of faces, counted for the notes.
  void pass_over(const std::string& keyword) {
    constexpr std::string_view known =
        " vt vn vp g s o mg mtllib usemtl usemap maplib l p curv curv2 surf cstype deg bmat step parm trim hole scrv "
        "sp "
        "end con bevel c_interp d_interp lod shadow_obj trace_obj ctech stech ";
    constexpr std::string_view free_form = " curv curv2 surf bzp bsp cdc cdp res ";
    const std::string between = " " + keyword + " ";
    if (free_form.find(between) != std::string_view::npos) {
      ++free_form_;
    } else if (known.find(between) == std::string_view::npos && unknown_++ == 0) {
      first_unknown_ = "line " + std::to_string(scanner_.line_of(scanner_.place())) + ": " + in_quotes(keyword);
    }
    texture_coordinates_ += keyword == "vt";
    normals_ += keyword == "vn";
    materials_ += keyword == "usemtl";
    groups_ += (keyword == "g" || keyword == "o") && !scanner_.at_end_of_line();
    lines_ += keyword == "l" || keyword == "p";
  }

  void vertex() {
    Vector3 p;
    for (double& x : p) {
      if (scanner_.at_end_of_line()) scanner_.fail("parse", "a vertex with fewer than three coordinates");
      x = scanner_.coordinate("a coordinate");
    }
    if (mesh_.positions.size() == no_index) scanner_.fail("unsupported", "more vertices than 32 bits can count");
    mesh_.positions.push_back(p);
    // A fourth number is a weight.
    if (scanner_.at_end_of_line()) return;
    scanner_.word();
    colors_ += !scanner_.at_end_of_line();
  }

  void face() {
    face_.clear();
    while (!scanner_.at_end_of_line())
      face_.push_back(corner());
    faces_.add(face_, scanner_);
  }

  // A line, or points.
  void tag(bool line) {
    face_.clear();
    while (!scanner_.at_end_of_line())
      face_.push_back(corner());
    if (line)
      report_.tags->add_line(face_);
    else
      report_.tags->vertices.insert(report_.tags->vertices.end(), face_.begin(), face_.end());
  }

  // "7", "7/1", "7//3" or "7/1/3"; negative numbers count back from the latest vertex.
  Index corner() {
    const std::int64_t given = scanner_.any_index();
    const std::string_view others = scanner_.rest_of_word();
    if (others.find_first_not_of("/-0123456789") != std::string_view::npos || (!others.empty() && others[0] != '/')) {
      scanner_.fail("parse", "a face corner like 7, 7/1 or 7/1/3 expected, found " +
                                 in_quotes(std::to_string(given).append(others)));
    }
    const auto count = static_cast<std::int64_t>(mesh_.positions.size());
    if (given == 0) scanner_.fail("index-range", "vertex index 0: OBJ files count from 1");
    if (given < -count) {
      scanner_.fail("index-range",
                    "vertex index " + std::to_string(given) + " after " + base::counted(count, "vertex", "vertices"));
    }
    if (given > static_cast<std::int64_t>(no_index)) {
      scanner_.fail("index-range", "vertex index " + std::to_string(given) + " is out of range");
    }
    if (given > count && given > max_index_) {  // of a vertex that may still come
      max_index_ = given;
      place_of_largest_ = scanner_.place();
    }
    return static_cast<Index>(given < 0 ? count + given : given - 1);
  }

  TextScanner scanner_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  Polygons faces_;
  Array<Index> face_;
  std::int64_t max_index_ = 0;
  const char* place_of_largest_ = nullptr;
  std::size_t texture_coordinates_ = 0, normals_ = 0, colors_ = 0, materials_ = 0, groups_ = 0, lines_ = 0;
  std::size_t free_form_ = 0, unknown_ = 0;
  std::string first_unknown_;
};

}  // namespace

Mesh read_obj(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  return ObjReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
