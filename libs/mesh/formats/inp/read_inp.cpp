#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/files/faces_and_cells.h"
#include "mesh/files/left_out.h"
#include "mesh/files/node_numbers.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/inp/inp_elements.h"
#include "mesh/formats/inp/inp_lines.h"
#include "mesh/formats/inp/inp_sets.h"

namespace orbicube::mesh {
namespace {

// An element, for messages about it after the file was read.
struct ElementPlace {
  std::uint64_t number;
  [[noreturn]] void fail(const char* kind, const std::string& what) const {
    throw base::Error(kind, "element " + std::to_string(number) + ": " + what);
  }
};

class InpReader {
 public:
  InpReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : lines_(bytes, host),
        host_(host),
        report_(report),
        mesh_(host.memory),
        cells_(mesh_, host),
        node_numbers_(host.memory),
        shapes_(host.memory),
        numbers_(host.memory) {}

  Mesh run() {
    bool more = lines_.next();
    if (more && !lines_.at_keyword())
      lines_.fail("bad-magic", "an Abaqus or CalculiX file starts with a keyword, as *NODE, or a comment, as ** text");
    while (more) {
      const InpKeyword keyword = lines_.keyword();
      more = lines_.next();
      section(keyword, more);
    }
    if (const auto repeated = node_numbers_.sort())
      throw base::Error("parse", "two nodes have the number " + std::to_string(*repeated));
    make_cells();
    report_.format = "Abaqus";
    cells_.finish(report_);
    note_left_out({{lines_passed_over_, "element of points or lines", "elements of points or lines"},
                   {of_the_assembly_, "section of the assembly", "sections of the assembly"},
                   {other_keywords_, "other keyword", "other keywords"}},
                  report_.notes);
    return std::move(mesh_);
  }

 private:
  // Reads or skips the data lines of a keyword, from the first on; `more` is false at the end of the file.
  void section(const InpKeyword& keyword, bool& more) {
    refuse_what_changes_the_mesh(keyword);
    if (keyword.name == "PART" || keyword.name == "INSTANCE") begin_part(keyword);
    if (keyword.name == "ASSEMBLY") in_assembly_ = true;
    if (keyword.name == "ENDINSTANCE") in_instance_ = false;
    if (keyword.name == "ENDASSEMBLY") in_assembly_ = false;
    const bool mesh = keyword.name == "NODE" || keyword.name == "ELEMENT";
    if (mesh && in_assembly_ && !in_instance_ && parts_ > 0) {
      ++of_the_assembly_;  // reference points, with numbers of their own
    } else if (keyword.name == "NODE") {
      begin_mesh_of_part();
      nodes(more);
    } else if (keyword.name == "ELEMENT") {
      begin_mesh_of_part();
      elements(keyword, more);
    } else if (keyword.name == "ELSET") {
      element_set(keyword, more);
    } else {
      static const std::set<std::string> structure = {"HEADING",  "PART",        "ENDPART",    "ASSEMBLY",
                                                      "INSTANCE", "ENDINSTANCE", "ENDASSEMBLY"};
      other_keywords_ += !structure.contains(keyword.name);
    }
    while (more && !lines_.at_keyword())
      more = lines_.next();
  }

  void refuse_what_changes_the_mesh(const InpKeyword& keyword) const {
    static const std::set<std::string> generators = {"NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM"};
    if (generators.contains(keyword.name))
      lines_.fail("unsupported",
                  "the keyword *" + keyword.name + " is not read; write the mesh out with all its nodes");
    const bool input = keyword.value("INPUT").has_value();
    if (keyword.name == "INCLUDE" || (input && (keyword.name == "NODE" || keyword.name == "ELEMENT"))) {
      lines_.fail("unsupported", "*" + keyword.name + " with INPUT=" + keyword.value("INPUT").value_or("") +
                                     ": other files are not read; insert its lines here");
    }
    if (keyword.name == "NODE" && keyword.value("SYSTEM").value_or("R") != "R")
      lines_.fail("unsupported", "nodes in cylindrical or spherical coordinates are not read");
  }

  void begin_part(const InpKeyword& keyword) {
    if (keyword.name == "INSTANCE") {
      in_instance_ = true;
      if (++instances_ > 1)
        lines_.fail("unsupported", "an assembly of several instances is not read; write one part to a file");
    }
    part_has_mesh_ = false;
  }

  // Nodes are numbered by part, of which one has a mesh.
  void begin_mesh_of_part() {
    if (part_has_mesh_) return;
    part_has_mesh_ = true;
    if (++parts_ > 1)
      lines_.fail("unsupported", "a file with the meshes of several parts is not read; write one part to a file");
  }

  void nodes(bool& more) {
    for (; more && !lines_.at_keyword(); more = lines_.next()) {
      node_numbers_.add(lines_.number(lines_.field().value_or(""), "the number of a node"));
      Vector3 p(0, 0, 0);
      for (int axis = 0; axis < 3; ++axis) {
        const auto field = lines_.field();
        if (!field && axis == 0) lines_.fail("parse", "a node without coordinates");
        if (field) p[axis] = lines_.coordinate(*field);
      }
      mesh_.positions.push_back(p);
    }
  }

  void elements(const InpKeyword& keyword, bool& more) {
    const auto type = keyword.value("TYPE");
    if (!type) lines_.fail("parse", "*ELEMENT without its TYPE");
    sets_.begin_elements(keyword.value("ELSET").value_or(""));
    const auto shape = inp_shape(*type);
    if (!shape) {
      lines_.fail("unsupported",
                  "elements of type " + in_quotes(*type) +
                      " (curved or of another kind) are not read; without them a part of the shape would "
                      "be missing: save the mesh with linear elements");
    }
    if (*shape == InpShape::passed_over || (*shape == InpShape::line && !report_.tags)) {
      for (; more && !lines_.at_keyword(); more = lines_.next())
        ++lines_passed_over_;
      return;
    }
    while (more && !lines_.at_keyword())
      element(*shape, more);
  }

  // The number of the element and those of its nodes, which go on in the next line where there are too few.
  void element(InpShape shape, bool& more) {
    const std::size_t wanted = 1 + nodes_of(shape);
    for (std::size_t found = 0; found < wanted;) {
      if (!more) lines_.fail("truncated", "the file ends inside an element");
      if (lines_.at_keyword()) lines_.fail("parse", "a keyword where the nodes of an element go on");
      while (const auto field = lines_.field()) {
        if (field->empty()) continue;
        if (found == wanted)
          lines_.fail("parse", "more than the " + std::to_string(wanted - 1) + " nodes of an element of its type");
        numbers_.push_back(lines_.number(*field, "the number of a node"));
        ++found;
      }
      more = lines_.next();
    }
    shapes_.push_back(shape);
    sets_.add_element();
  }

  // Numbers of elements, or, with GENERATE, the first and the last one and the step between. Names of other sets are
  // passed over.
  void element_set(const InpKeyword& keyword, bool& more) {
    sets_.begin_set(keyword.value("ELSET").value_or(""));
    const bool generated = keyword.value("GENERATE").has_value();
    for (; more && !lines_.at_keyword(); more = lines_.next()) {
      std::array<std::uint64_t, 3> range = {0, 0, 1};
      std::size_t count = 0;
      while (const auto field = lines_.field()) {
        if (field->empty() || field->front() < '0' || field->front() > '9') continue;
        const std::uint64_t number = lines_.number(*field, "the number of an element");
        if (!generated) sets_.add(number, number, 1);
        if (count < range.size()) range[count++] = number;
      }
      if (!generated) continue;
      if (count < 2 || range[2] == 0)
        lines_.fail("parse", "*ELSET with GENERATE: the first and the last element expected, and a step above 0");
      sets_.add(range[0], range[1], range[2]);
    }
  }

  void make_cells() {
    const std::vector<std::int64_t> regions = sets_.empty() ? std::vector<std::int64_t>() : regions_of_elements();
    std::size_t at = 0, done = 0;
    for (const InpShape shape : shapes_) {
      region_ = regions.empty() ? 0 : cells_.region_of(regions[done]);
      if (++done % 4096 == 0) host_.report("reading", done, shapes_.size());
      const ElementPlace place{numbers_[at++]};
      std::array<Index, 8> v{};
      const std::size_t nodes = nodes_of(shape);
      for (std::size_t k = 0; k < nodes; ++k) {
        const std::uint64_t number = numbers_[at++];
        const auto vertex = node_numbers_.vertex(number);
        if (!vertex) place.fail("index-range", "there is no node " + std::to_string(number));
        v[k] = *vertex;
      }
      add_cell(shape, v, {v.data(), nodes}, place);
    }
  }

  std::vector<std::int64_t> regions_of_elements() {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(shapes_.size());
    std::size_t at = 0;
    for (const InpShape shape : shapes_) {
      numbers.push_back(numbers_[at]);
      at += 1 + nodes_of(shape);
    }
    return sets_.regions(numbers, shapes_, report_.notes, host_);
  }

  void add_cell(InpShape shape, const Hexahedron& v, std::span<const Index> corners, const ElementPlace& place) {
    switch (shape) {
      case InpShape::passed_over:
        break;
      case InpShape::line:
        report_.tags->add_line(corners);
        break;
      case InpShape::triangle:
      case InpShape::quadrilateral:
        cells_.add_face(corners, region_, place);
        break;
      case InpShape::tetrahedron:
        cells_.add(Tetrahedron{v[0], v[1], v[2], v[3]}, region_);
        break;
      case InpShape::pyramid:
        cells_.add(Polyhedron::pyramid, corners, region_);
        break;
      case InpShape::prism:
        cells_.add(Polyhedron::prism, corners, region_);
        break;
      case InpShape::hexahedron:
        cells_.add(v, region_);
    }
  }

  InpLines lines_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  FacesAndCells cells_;
  NodeNumbers node_numbers_;
  // Elements in the order of the file: each number with those of its nodes, as nodes may follow elements.
  Array<InpShape> shapes_;
  Array<std::uint64_t> numbers_;
  InpSets sets_;
  std::int32_t region_ = 0;  // of the element that becomes a cell
  bool part_has_mesh_ = false, in_assembly_ = false, in_instance_ = false;
  std::size_t parts_ = 0, instances_ = 0;
  std::size_t lines_passed_over_ = 0, of_the_assembly_ = 0, other_keywords_ = 0;
};

}  // namespace

Mesh read_inp(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  return InpReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
