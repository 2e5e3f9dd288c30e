#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/faces_and_cells.h"
#include "mesh/files/left_out.h"
#include "mesh/files/text_scanner.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

class MeditReader {
 public:
  MeditReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : scanner_(bytes, '#', host),
        report_(report),
        mesh_(host.memory),
        cells_(mesh_, host),
        edges_(host.memory),
        tagged_(host.memory) {}

  Mesh run() {
    while (scanner_.skip_space()) {
      const std::string_view keyword = scanner_.word();
      const std::string name = in_small_letters(keyword);
      if (name == "end") break;
      if (!section(name) && !target_section(name) && !tag_section(name)) skip_section(keyword);
    }
    report_.format = "MEDIT";
    if (report_.tags) resolve_tags();
    cells_.finish(report_);
    if (!passed_over_.empty()) report_.notes.push_back("sections passed over: " + passed_over_);
    note_left_out({{references_, "reference number of vertices or edges", "reference numbers of vertices or edges"}},
                  report_.notes);
    return std::move(mesh_);
  }

 private:
  // Cells, in words of any size of letters. Returns false for other sections.
  bool section(const std::string& name) {
    if (name == "vertices") {
      vertices();
    } else if (name == "triangles") {
      cells<3>("triangles", [&](const Triangle& t) { cells_.add_face(t, region(), scanner_); });
    } else if (name == "quadrilaterals") {
      cells<4>("quadrilaterals", [&](const std::array<Index, 4>& q) { cells_.add_face(q, region(), scanner_); });
    } else if (name == "tetrahedra") {
      cells<4>("tetrahedra", [&](const Tetrahedron& t) { cells_.add(t, region()); });
    } else if (name == "hexahedra") {
      cells<8>("hexahedra", [&](const Hexahedron& h) { cells_.add(h, region()); });
    } else if (name == "prisms" || name == "wedges" || name == "pentahedra") {
      cells<6>("prisms", [&](const std::array<Index, 6>& p) { cells_.add(Polyhedron::prism, p, region()); });
    } else if (name == "pyramids") {
      cells<5>("pyramids", [&](const std::array<Index, 5>& p) { cells_.add(Polyhedron::pyramid, p, region()); });
    } else {
      return false;
    }
    return true;
  }

  // What says how to read, and cells that cannot be read: leaving them out would leave a hole.
  bool target_section(const std::string& name) {
    if (name == "dimension") {
      dimension();
    } else if (name == "meshversionformatted") {
      scanner_.skip_space();
      scanner_.integer("the version");
    } else if (is_unread_cell(name)) {
      scanner_.skip_space();
      if (const std::uint64_t n = scanner_.count("the number of items"); n > 0) {
        scanner_.fail("unsupported", base::counted(n, "cell") + " in the section " + in_quotes(name) +
                                         ", which is not read; without them a part of the shape would be missing");
      }
    } else {
      return false;
    }
    return true;
  }

  // Marked edges and vertices. Edges are numbered in the section Edges, which may come later.
  bool tag_section(const std::string& name) {
    if (!report_.tags) return false;
    if (name == "edges") {
      cells<2>("edges", [&](const std::array<Index, 2>& e) { edges_.push_back(e); });
    } else if (name == "ridges" || name == "requirededges") {
      for_each_number("edges", [&] { tagged_.push_back(static_cast<Index>(scanner_.index(1, no_index - 1))); });
    } else if (name == "corners" || name == "requiredvertices") {
      if (mesh_.positions.empty()) scanner_.fail("parse", name + " before the section Vertices");
      for_each_number("vertices", [&] { report_.tags->vertices.push_back(scanner_.index(1, mesh_.positions.size())); });
    } else {
      return false;
    }
    return true;
  }

  template <class Read>
  void for_each_number(const char* what, const Read& read) {
    const std::uint64_t n = count(what, 2);
    for (std::uint64_t i = 0; i < n; ++i) {
      scanner_.skip_space();
      read();
      scanner_.progress();
    }
  }

  void resolve_tags() {
    for (const Index e : tagged_) {
      if (e >= edges_.size())
        scanner_.fail("index-range", "edge " + std::to_string(std::uint64_t{e} + 1) + " of " +
                                         std::to_string(edges_.size()) + " in the section Edges");
      report_.tags->add_line(edges_[e]);
    }
    if (!tagged_.empty()) return;
    for (const std::array<Index, 2>& edge : edges_)
      report_.tags->add_line(edge);
  }

  // Curved cells, as TetrahedraP2 or HexahedraQ3, and those of any number of corners. Edges are no cells.
  static bool is_unread_cell(const std::string& name) {
    if (name.find("polygon") != std::string::npos || name.find("polyhedr") != std::string::npos) return true;
    for (const std::string_view kind :
         {"triangles", "quadrilaterals", "tetrahedra", "hexahedra", "prisms", "pyramids"}) {
      if (!name.starts_with(kind)) continue;
      const std::string_view order = std::string_view(name).substr(kind.size());
      return order.size() == 2 && (order[0] == 'p' || order[0] == 'q') && order[1] >= '2' && order[1] <= '9';
    }
    return false;
  }

  void dimension() {
    scanner_.skip_space();
    const std::int64_t dimension = scanner_.integer("the dimension");
    if (dimension != 3)
      scanner_.fail("unsupported-format", "dimension " + std::to_string(dimension) + ", where 3 is needed");
  }

  std::uint64_t count(const char* what, std::size_t bytes_each) {
    scanner_.skip_space();
    const std::uint64_t count = scanner_.count("the number of items");
    scanner_.require_room(count, bytes_each, what);
    return count;
  }

  void vertices() {
    if (!mesh_.positions.empty()) scanner_.fail("parse", "the section Vertices comes twice");
    const std::uint64_t n = count("vertices", 8);
    mesh_.positions.reserve(n);
    begin_references();
    for (std::uint64_t v = 0; v < n; ++v) {
      const Vector3 p = scanner_.point_after_space();
      compare(reference());
      mesh_.positions.push_back(p);
      scanner_.progress();
    }
    end_references(n);
  }

  template <std::size_t corners, class Take>
  void cells(const char* what, const Take& take) {
    if (mesh_.positions.empty()) scanner_.fail("parse", std::string(what) + " before the section Vertices");
    const std::uint64_t n = count(what, 2 * corners + 2);
    if (corners == 2) begin_references();
    for (std::uint64_t i = 0; i < n; ++i) {
      std::array<Index, corners> cell;
      for (Index& v : cell) {
        scanner_.skip_space();
        v = scanner_.index(1, mesh_.positions.size());
      }
      number_ = reference();
      if (corners == 2) compare(number_);
      take(cell);
      scanner_.progress();
    }
    if (corners == 2) end_references(n);
  }

  // The number of the part that an item belongs to; some programs write it as a real number.
  double reference() {
    scanner_.skip_space();
    return scanner_.coordinate("a reference");
  }
  // That of the face or cell read last, as a region.
  std::int32_t region() { return cells_.region_of(number_); }
  // Numbers of vertices and edges are not kept. Those of a section tell something if they differ.
  void compare(double number) {
    if (!first_reference_) first_reference_ = number;
    references_differ_ = references_differ_ || number != *first_reference_;
  }
  void begin_references() {
    first_reference_.reset();
    references_differ_ = false;
  }
  void end_references(std::uint64_t items) {
    if (references_differ_) references_ += static_cast<std::size_t>(items);
  }

  // A section that is not read: its numbers, up to the next word.
  void skip_section(std::string_view name) {
    const char first = name.front();
    if (!((first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z')))
      scanner_.fail("parse", "the name of a section expected, found " + in_quotes(name));
    constexpr std::size_t longest = 200;
    if (passed_over_.size() < longest) passed_over_.append(passed_over_.empty() ? "" : ", ").append(in_quotes(name));
    while (scanner_.skip_space() && !at_keyword()) {
      scanner_.word();
      scanner_.progress();
    }
  }

  // Whether a word is next, as opposed to a number, be it one that is not finite.
  bool at_keyword() {
    if (!scanner_.at_letter()) return false;
    return !scanner_.starts_with_ignoring_case("nan") && !scanner_.starts_with_ignoring_case("inf");
  }

  TextScanner scanner_;
  ReadReport& report_;
  Mesh mesh_;
  FacesAndCells cells_;
  double number_ = 0;  // of the face or cell read last
  Array<std::array<Index, 2>> edges_;
  Array<Index> tagged_;      // edges, by their number
  std::string passed_over_;  // names of sections
  std::optional<double> first_reference_;
  bool references_differ_ = false;
  std::size_t references_ = 0;  // of sections where they differ
};

}  // namespace

Mesh read_medit(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  // Binary files begin with the number 1, in the byte order of their machine.
  constexpr std::array one = {std::byte{1}, std::byte{0}, std::byte{0}, std::byte{0}};
  if (bytes.size() >= one.size() &&
      (std::equal(one.begin(), one.end(), bytes.begin()) || std::equal(one.rbegin(), one.rend(), bytes.begin())))
    throw base::Error("unsupported-format", "binary MEDIT files (.meshb) are not read, only text files are");
  return MeditReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
