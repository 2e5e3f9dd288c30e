#include <array>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/left_out.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/vtk_cells.h"
#include "mesh/formats/xml/vtk_xml_file.h"

namespace orbicube::mesh {
namespace {

class VtkXmlReader {
 public:
  VtkXmlReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : scanner_(bytes, host),
        file_(read_vtk_xml_file(scanner_, host)),
        host_(host),
        report_(report),
        mesh_(host.memory),
        cells_(mesh_, host, report),
        ends_(host.memory),
        connectivity_(host.memory),
        regions_(host.memory) {}

  Mesh run() {
    report_.format = file_.grid ? "VTK XML, unstructured grid" : "VTK XML, surface";
    std::size_t next = 0;
    for (std::size_t piece = 0; piece < file_.pieces.size(); ++piece) {
      entries_ = {};
      for (; next < file_.entries.size() && file_.entries[next].piece == piece; ++next)
        take(file_.entries[next]);
      points(file_.pieces[piece].points);
      if (file_.grid)
        grid(file_.pieces[piece].cells);
      else
        surface();
      regions();
      cells_of_pieces_ = cells_.count();
    }
    cells_.set_regions(regions_);
    cells_.finish(ArrayPlace{file_.grid ? "the grid" : "the surface"});
    note_left_out({{file_.data_arrays, "data array", "data arrays"}}, report_.notes);
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t sections = 7, roles = 5;

  void surface() {
    using Section = VtkXmlSection;
    tags(Section::verts, 2, "vertex", "vertices");
    tags(Section::lines, 4, "line", "lines");
    bool strips = false, polygons = false;
    if (cell_array(Section::strips)) {
      strips = !ends_.empty();
      for_each_cell([&](std::span<const Index> cell) { cells_.add_strip(cell); });
    }
    if (cell_array(Section::polys)) {
      polygons = !ends_.empty();
      for_each_cell([&](std::span<const Index> cell) { cells_.add_polygon(cell, place_); });
    }
    if (strips && polygons && slot(Section::cell_data, VtkXmlRole::regions))
      cells_.leave_out_regions("there are triangle strips beside polygons");
  }

  // Appends the regions of the piece's cells; those of pieces without them are 0.
  void regions() {
    const VtkXmlEntry* entry = slot(VtkXmlSection::cell_data, VtkXmlRole::regions);
    if (!entry) {
      if (!regions_.empty()) regions_.resize(cells_.count());
      return;
    }
    const std::size_t first = cells_of_pieces_;
    const std::size_t count = cells_.count() - first;
    place_.name = "the array " + in_quotes(entry->name) + " of CellData";
    const NumberArray numbers = read_vtk_xml_array(entry->array, file_.storage, place_, host_, appended_taken_);
    if (numbers.size() != count) {
      place_.fail("parse",
                  base::counted(numbers.size(), "number") + ", where the piece has " + base::counted(count, "cell"));
    }
    regions_.resize(first);
    regions_.reserve(first + count);
    for (std::size_t i = 0; i < count; ++i)
      regions_.push_back(numbers.is_real() ? cells_.region_of(numbers.real(i)) : cells_.region_of(numbers.integer(i)));
  }

  const VtkXmlEntry*& slot(VtkXmlSection section, VtkXmlRole role) {
    return entries_[static_cast<std::size_t>(section)][static_cast<std::size_t>(role)];
  }

  void take(const VtkXmlEntry& entry) {
    const VtkXmlEntry*& at = slot(entry.section, entry.role);
    if (at)
      throw base::Error("parse", std::string("an array of ") + name_of(entry.section) + " comes twice in a piece");
    at = &entry;
  }

  // Reads an array that the piece must have.
  NumberArray read(VtkXmlSection section, VtkXmlRole role) {
    constexpr std::array names = {"positions", "connectivity", "offsets", "types", "regions"};
    place_.name = std::string("the array ") + names[static_cast<std::size_t>(role)] + " of " + name_of(section);
    const VtkXmlEntry* entry = slot(section, role);
    if (!entry) place_.fail("missing-attribute", "it is missing");
    NumberArray result = read_vtk_xml_array(entry->array, file_.storage, place_, host_, appended_taken_);
    if (result.is_real() && role != VtkXmlRole::positions)
      place_.fail("parse", "real numbers, where integers are expected");
    return result;
  }

  // Appends the points of the piece, whose first one is first_.
  void points(std::uint64_t count) {
    first_ = mesh_.positions.size();
    if (count == 0) return;
    const NumberArray numbers = read(VtkXmlSection::points, VtkXmlRole::positions);
    if (numbers.size() % 3 != 0 || numbers.size() / 3 != count) {
      place_.fail("parse",
                  base::counted(numbers.size(), "number") + ", where the piece has " + base::counted(count, "point"));
    }
    if (count >= no_index - first_) place_.fail("unsupported", "more points than 32 bits can count");
    mesh_.positions.reserve(first_ + count);
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 4096 == 0) host_.report("reading", i, count);
      const Vector3 p(numbers.real(3 * i), numbers.real(3 * i + 1), numbers.real(3 * i + 2));
      if (!p.allFinite()) place_.fail("non-finite", "point " + std::to_string(i) + " is not finite");
      mesh_.positions.push_back(p);
    }
  }

  // Fills ends_ and connectivity_. Returns false where the piece has no cells of this kind.
  bool cell_array(VtkXmlSection section) {
    if (!slot(section, VtkXmlRole::offsets) && !slot(section, VtkXmlRole::connectivity) && !file_.grid) return false;
    const NumberArray corners = read(section, VtkXmlRole::connectivity);
    const std::size_t points = mesh_.positions.size() - first_;
    connectivity_.clear();
    connectivity_.reserve(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i % 65536 == 0) host_.report("reading", i, corners.size());
      const std::int64_t v = corners.integer(i);
      if (v < 0 || static_cast<std::uint64_t>(v) >= points)
        place_.fail("index-range", "vertex index " + std::to_string(v) + " of " + base::counted(points, "point"));
      connectivity_.push_back(static_cast<Index>(first_ + static_cast<std::uint64_t>(v)));
    }
    const NumberArray ends = read(section, VtkXmlRole::offsets);
    ends_.clear();
    ends_.reserve(ends.size());
    std::int64_t last = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const std::int64_t end = ends.integer(i);
      if (end < last || static_cast<std::uint64_t>(end) > connectivity_.size()) {
        place_.fail("index-range", "offset " + std::to_string(end) + " behind offset " + std::to_string(last) +
                                       ", of " + base::counted(connectivity_.size(), "vertex index", "vertex indices"));
      }
      ends_.push_back(static_cast<std::size_t>(end));
      last = end;
    }
    return true;
  }

  template <class Use>
  void for_each_cell(const Use& use) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (i % 4096 == 0) host_.report("reading", i, ends_.size());
      use(std::span<const Index>(connectivity_.data() + begin, ends_[i] - begin));
      begin = ends_[i];
    }
  }

  void tags(VtkXmlSection section, std::int64_t cell_type, const char* one, const char* many) {
    if (!cell_array(section)) return;
    cells_.add_tags(ends_.size());
    if (report_.tags)
      for_each_cell([&](std::span<const Index> cell) { cells_.add_tag(cell_type, cell); });
    else if (!ends_.empty())
      cells_.pass_over(ends_.size(), one, many);
  }

  void grid(std::uint64_t count) {
    if (count == 0) return;
    cell_array(VtkXmlSection::cells);
    if (ends_.size() != count)
      place_.fail("parse", base::counted(ends_.size(), "offset") + " of " + base::counted(count, "cell"));
    const NumberArray types = read(VtkXmlSection::cells, VtkXmlRole::types);
    if (types.size() != count)
      place_.fail("parse", base::counted(types.size(), "type") + " of " + base::counted(count, "cell"));
    std::size_t number = 0, passed_over = 0;
    for_each_cell([&](std::span<const Index> cell) {
      passed_over += !cells_.add(types.integer(number), cell, number, place_);
      ++number;
    });
    if (passed_over > 0) cells_.pass_over(passed_over, "point or line", "points and lines");
  }

  XmlScanner scanner_;
  VtkXmlFile file_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  VtkCells cells_;
  std::array<std::array<const VtkXmlEntry*, roles>, sections> entries_{};  // of the piece that is read
  ArrayPlace place_;
  std::uint64_t appended_taken_ = 0;  // bytes
  std::size_t first_ = 0, cells_of_pieces_ = 0;
  Array<std::size_t> ends_;
  Array<Index> connectivity_;
  Array<std::int32_t> regions_;  // of all cells so far, if there are any
};

}  // namespace

Mesh read_vtk_xml(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  return VtkXmlReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
