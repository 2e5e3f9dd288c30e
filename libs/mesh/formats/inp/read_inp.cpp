#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/files/left_out.h"
#include "mesh/files/node_numbers.h"
#include "mesh/files/polygons.h"
#include "mesh/files/polyhedral_cells.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/inp/inp_elements.h"
#include "mesh/formats/inp/inp_lines.h"

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
        faces_(host.memory),
        others_(host.memory),
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
    report_.polygons = faces_.larger_than_triangles();
    faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
    if (!others_.empty()) note_turned_cells(mesh_, report_.notes, host_);
    others_.cut_into_tetrahedra(mesh_, report_.notes, host_);
    note_left_out({{lines_passed_over_, "element of points or lines", "elements of points or lines"},
                   {sets_.size() > 1 ? sets_.size() : 0, "element set", "element sets"},
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
    if (sets_.size() < 10000) sets_.insert(keyword.value("ELSET").value_or(""));
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
  }

  void make_cells() {
    std::size_t at = 0, done = 0;
    for (const InpShape shape : shapes_) {
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

  void add_cell(InpShape shape, const Hexahedron& v, std::span<const Index> corners, const ElementPlace& place) {
    switch (shape) {
      case InpShape::passed_over:
        break;
      case InpShape::line:
        report_.tags->add_line(corners);
        break;
      case InpShape::triangle:
      case InpShape::quadrilateral:
        faces_.add(corners, place);
        break;
      case InpShape::tetrahedron:
        mesh_.tetrahedra.push_back({v[0], v[1], v[2], v[3]});
        break;
      case InpShape::pyramid:
        others_.add(Polyhedron::pyramid, corners);
        break;
      case InpShape::prism:
        others_.add(Polyhedron::prism, corners);
        break;
      case InpShape::hexahedron:
        mesh_.hexahedra.push_back(v);
    }
  }

  InpLines lines_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  Polygons faces_;
  PolyhedralCells others_;
  NodeNumbers node_numbers_;
  // Elements in the order of the file: each number with those of its nodes, as nodes may follow elements.
  Array<InpShape> shapes_;
  Array<std::uint64_t> numbers_;
  std::set<std::string> sets_;
  bool part_has_mesh_ = false, in_assembly_ = false, in_instance_ = false;
  std::size_t parts_ = 0, instances_ = 0;
  std::size_t lines_passed_over_ = 0, of_the_assembly_ = 0, other_keywords_ = 0;
};

}  // namespace

Mesh read_inp(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  return InpReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
