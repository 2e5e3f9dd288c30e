#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/files/faces_and_cells.h"
#include "mesh/files/left_out.h"
#include "mesh/files/node_numbers.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/msh_body.h"
#include "mesh/formats/msh_regions.h"

namespace orbicube::mesh {
namespace {

// The types of elements that are read, by Gmsh's numbers.
enum ElementType : std::int64_t {
  line = 1,
  triangle = 2,
  quadrangle = 3,
  tetrahedron = 4,
  hexahedron = 5,
  prism = 6,
  pyramid = 7,
  second_order_line = 8,
  point = 15
};

std::size_t nodes_of(std::int64_t type) {
  switch (type) {
    case point:
      return 1;
    case line:
      return 2;
    case triangle:
    case second_order_line:
      return 3;
    case quadrangle:
    case tetrahedron:
      return 4;
    case pyramid:
      return 5;
    case prism:
      return 6;
    case hexahedron:
      return 8;
    default:
      return 0;
  }
}

template <class Body>
class MshReader {
 public:
  MshReader(Body body, bool version_4, const base::Host& host, ReadReport& report)
      : body_(std::move(body)),
        version_4_(version_4),
        report_(report),
        mesh_(host.memory),
        cells_(mesh_, host),
        numbers_(host.memory) {}

  Mesh run() {
    while (true) {
      const std::string_view line = body_.line();
      if (line.empty()) break;
      if (line.front() != '$')
        body_.fail("parse", "the name of a section, as $Nodes, expected, found " + in_quotes(line));
      const std::string name(line.substr(1, std::min(line.find_first_of(" \t"), line.size()) - 1));
      if (name == "Nodes") {
        if (version_4_)
          nodes_by_entity();
        else
          nodes();
      } else if (name == "Elements") {
        if (mesh_.positions.empty()) body_.fail("parse", "the section Elements before the section Nodes");
        complete_ = true;
        if (version_4_)
          elements_by_entity();
        else
          elements();
      } else if (name == "Entities" && version_4_) {
        entities();
      } else if (name == "ParametricNodes") {
        body_.fail("unsupported", "the section ParametricNodes is not read");
      } else {
        skip(name);
        continue;
      }
      const std::string_view end = body_.line();
      if (end != "$End" + name) body_.fail("parse", "$End" + name + " expected, found " + in_quotes(end));
    }
    if (!complete_) body_.fail("truncated", "the file ends before its section Elements");
    finish_regions();
    cells_.finish(report_);
    note_left_out({{names_, "list of names of regions", "lists of names of regions"},
                   {regions_.further_groups(), "further group of an entity", "further groups of entities"},
                   {data_, "data array", "data arrays"}},
                  report_.notes);
    return std::move(mesh_);
  }

 private:
  void skip(const std::string& name) {
    if (name.ends_with("Data")) ++data_;
    if (name == "PhysicalNames") ++names_;
    const std::string end = "$End" + name;
    if constexpr (requires { body_.skip_to(end); }) body_.skip_to(end);
    while (true) {
      const std::string_view line = body_.line();
      if (line.empty()) body_.fail("truncated", "the file ends inside the section " + in_quotes(name));
      if (line == end) return;
      body_.progress();
    }
  }

  void reserve_nodes(std::uint64_t count) {
    if (!mesh_.positions.empty()) body_.fail("parse", "the section Nodes comes twice");
    body_.require_room(count, 4, 28, "nodes");
    mesh_.positions.reserve(count);
    numbers_.reserve(count);
  }

  Vector3 position() {
    Vector3 p;
    for (double& x : p)
      x = body_.coordinate();
    body_.progress();
    return p;
  }

  void nodes() {
    const std::uint64_t count = body_.item_count();
    reserve_nodes(count);
    for (std::uint64_t i = 0; i < count; ++i) {
      numbers_.add(body_.number("the number of a node"));
      mesh_.positions.push_back(position());
    }
    sort_numbers();
  }

  void nodes_by_entity() {
    const std::uint64_t blocks = body_.item_count(), count = body_.size("the number of nodes");
    body_.size("the minimum number of a node");
    body_.size("the maximum number of a node");
    reserve_nodes(count);
    for (std::uint64_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = body_.integer("the dimension of an entity");
      body_.integer("the number of an entity");
      const std::int64_t parametric = body_.integer("0 or 1");
      const std::uint64_t here = body_.size("a number of nodes");
      if (dimension < 0 || dimension > 3) body_.fail("parse", "dimension " + std::to_string(dimension));
      if (here > count - mesh_.positions.size()) body_.fail("parse", "more nodes than the section says that it has");
      for (std::uint64_t i = 0; i < here; ++i)
        numbers_.add(body_.number("the number of a node"));
      for (std::uint64_t i = 0; i < here; ++i) {
        mesh_.positions.push_back(position());
        for (std::int64_t k = 0; parametric != 0 && k < dimension; ++k)
          body_.skip_parameter();
      }
    }
    if (mesh_.positions.size() != count) body_.fail("parse", "fewer nodes than the section says that it has");
    sort_numbers();
  }

  void sort_numbers() {
    if (const auto repeated = numbers_.sort())
      body_.fail("parse", "two nodes have the number " + std::to_string(*repeated));
  }

  Index vertex(std::uint64_t number) {
    const auto found = numbers_.vertex(number);
    if (!found) body_.fail("index-range", "there is no node " + std::to_string(number));
    return *found;
  }

  std::size_t checked_nodes_of(std::int64_t type) {
    const std::size_t nodes = nodes_of(type);
    if (nodes > 0) return nodes;
    body_.fail("unsupported",
               "elements of Gmsh's type " + std::to_string(type) +
                   " (curved or of another kind) are not read; without them a part of the shape would be "
                   "missing: save the mesh with order 1");
  }

  void elements() {
    std::uint64_t left = body_.item_count();
    constexpr bool text = !requires(Body & b) {
      b.skip_to(std::string_view());
    };
    body_.require_room(left, 4, 4, "elements");
    while (left > 0) {
      // In text each element has its type and its number of tags, in binary files a block of elements.
      if (text) body_.number("the number of an element");
      const std::int64_t type = body_.integer("the type of elements");
      const std::size_t nodes = checked_nodes_of(type);
      const std::int64_t here = text ? 1 : body_.integer("a number of elements");
      const std::int64_t tags = body_.integer("a number of tags");
      if (here < 1 || static_cast<std::uint64_t>(here) > left || tags < 0 || tags > 1000)
        body_.fail("parse", "a block of " + std::to_string(here) + " elements with " + std::to_string(tags) + " tags");
      for (std::int64_t i = 0; i < here; ++i) {
        if (!text) body_.number("the number of an element");
        std::int64_t group = 0, entity = 0;
        for (std::int64_t k = 0; k < tags; ++k) {
          const std::int64_t tag = body_.integer("a tag");
          if (k == 0) group = tag;
          if (k == 1) entity = tag;
        }
        element(type, nodes, place_of(type, entity, group));
      }
      left -= static_cast<std::uint64_t>(here);
    }
  }

  void elements_by_entity() {
    const std::uint64_t blocks = body_.item_count();
    std::uint64_t left = body_.size("the number of elements");
    body_.size("the minimum number of an element");
    body_.size("the maximum number of an element");
    body_.require_room(left, 2, 16, "elements");
    for (std::uint64_t b = 0; b < blocks; ++b) {
      body_.integer("the dimension of an entity");
      const std::int64_t entity = body_.integer("the number of an entity");
      const std::int64_t type = body_.integer("the type of elements");
      const std::uint64_t here = body_.size("a number of elements");
      if (here > left) body_.fail("parse", "more elements than the section says that it has");
      left -= here;
      const std::size_t nodes = here > 0 ? checked_nodes_of(type) : 0;
      const std::int32_t here_is = here > 0 ? place_of(type, entity, 0) : 0;
      for (std::uint64_t i = 0; i < here; ++i) {
        body_.number("the number of an element");
        element(type, nodes, here_is);
      }
    }
    if (left > 0) body_.fail("parse", "fewer elements than the section says that it has");
  }

  // Points and lines have no regions.
  std::int32_t place_of(std::int64_t type, std::int64_t entity, std::int64_t group) {
    if (nodes_of(type) < 3 || type == second_order_line) return 0;
    return regions_.place_of(type == triangle || type == quadrangle ? 2 : 3, entity, group);
  }

  // Version 4: the groups of points, curves, surfaces and volumes; the rest of each is passed over.
  void entities() {
    std::array<std::uint64_t, 4> counts{};
    counts[0] = body_.item_count();
    for (std::size_t d = 1; d < 4; ++d)
      counts[d] = body_.size("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::uint64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
        const std::int64_t entity = body_.integer("the number of an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k)
          body_.skip_parameter();
        const std::uint64_t groups = body_.size("a number of groups");
        for (std::uint64_t k = 0; k < groups; ++k) {
          const std::int64_t group = body_.integer("the number of a group");
          if (dimension >= 2) regions_.add_group(dimension, entity, group);
        }
        const std::uint64_t bounds = dimension > 0 ? body_.size("a number of entities") : 0;
        for (std::uint64_t k = 0; k < bounds; ++k)
          body_.integer("the number of an entity");
        body_.progress();
      }
    }
  }

  void finish_regions() {
    std::vector<std::int32_t> table;
    for (const std::int64_t region : regions_.regions())
      table.push_back(cells_.region_of(region));
    cells_.translate_regions(table);
  }

  void element(std::int64_t type, std::size_t nodes, std::int32_t region) {
    std::array<Index, 8> v{};
    for (std::size_t k = 0; k < nodes; ++k)
      v[k] = vertex(body_.number("the number of a node"));
    const std::span<const Index> corners(v.data(), nodes);
    switch (type) {
      case point:
        if (report_.tags) report_.tags->vertices.push_back(v[0]);
        break;
      case line:
      case second_order_line:  // its middle node comes last
        if (report_.tags) report_.tags->add_line(corners.first(2));
        break;
      case tetrahedron:
        cells_.add(Tetrahedron{v[0], v[1], v[2], v[3]}, region);
        break;
      case hexahedron:
        cells_.add(v, region);
        break;
      case prism:
        cells_.add(Polyhedron::prism, corners, region);
        break;
      case pyramid:
        cells_.add(Polyhedron::pyramid, corners, region);
        break;
      default:
        cells_.add_face(corners, region, body_);
    }
    body_.progress();
  }

  Body body_;
  bool version_4_;
  ReadReport& report_;
  Mesh mesh_;
  FacesAndCells cells_;
  NodeNumbers numbers_;
  MshRegions regions_;
  bool complete_ = false;
  std::size_t names_ = 0, data_ = 0;
};

struct Header {
  bool version_4 = false, binary = false;
  std::endian order = std::endian::native;
  std::size_t length = 0;  // of the section
};

// The section MeshFormat, with which files begin.
Header header_of(std::span<const std::byte> bytes, const base::Host& host) {
  BinaryScanner scanner(bytes, 0, std::endian::native, host);
  const auto line = [&] {
    std::string_view text = scanner.line();
    while (!text.empty() && (text.back() == '\r' || text.back() == ' '))
      text.remove_suffix(1);
    return text;
  };
  const std::string_view first = line();
  if (first == "$NOD") scanner.fail("unsupported-version", "version 1 of Gmsh's format; save it as version 2.2 or 4.1");
  if (first != "$MeshFormat")
    scanner.fail("bad-magic", "$MeshFormat expected in the first line, found " + in_quotes(first));
  const std::string_view text = line();
  Header header;
  header.version_4 = text.starts_with("4.1 ");
  const bool version_2 =
      text.starts_with("2 ") || text.starts_with("2.0 ") || text.starts_with("2.1 ") || text.starts_with("2.2 ");
  if (!header.version_4 && !version_2) {
    scanner.fail("unsupported-version",
                 "version, form and size " + in_quotes(text) +
                     ", where versions 2.2 and 4.1 are read; Gmsh saves them with -format msh41");
  }
  const std::string_view form = text.substr(text.find(' ') + 1);
  if (form != "0 8" && form != "1 8")
    scanner.fail("unsupported", "form and size of numbers " + in_quotes(form) + ", where 0 8 (text) and 1 8 are read");
  header.binary = form == "1 8";
  if (header.binary) {
    scanner.require(4, "the number for the order of bytes");
    const auto one = scanner.next<std::uint32_t>();
    constexpr std::uint32_t turned = 0x01000000;
    if (one != 1 && one != turned) scanner.fail("parse", "the number 1 expected, for the order of bytes");
    if (one == turned)
      header.order = std::endian::native == std::endian::little ? std::endian::big : std::endian::little;
    if (!line().empty()) scanner.fail("parse", "an end of line expected");
  }
  if (const std::string_view end = line(); end != "$EndMeshFormat")
    scanner.fail("parse", "$EndMeshFormat expected, found " + in_quotes(end));
  header.length = bytes.size() - scanner.left();
  return header;
}

}  // namespace

Mesh read_msh(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  const Header header = header_of(bytes, host);
  report.format = header.version_4 ? "Gmsh 4.1" : "Gmsh 2";
  if (!header.binary) {
    report.format += ", text";
    return MshReader(MshText(bytes, host), header.version_4, host, report).run();
  }
  report.format += header.order == std::endian::little ? ", binary, little-endian" : ", binary, big-endian";
  return MshReader(MshBinary(bytes.subspan(header.length), header.length, header.order, header.version_4, host),
                   header.version_4, host, report)
      .run();
}

}  // namespace orbicube::mesh
