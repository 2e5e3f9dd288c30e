#include <algorithm>
#include <cctype>
#include <string>

#include "base/error.h"
#include "mesh/polygons.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"

namespace orbicube::mesh {
namespace {

class MeditReader {
 public:
  MeditReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : scanner_(bytes, '#', host), host_(host), report_(report), mesh_(host.memory), faces_(host.memory) {}

  Mesh run() {
    while (scanner_.skip_space()) {
      const std::string_view keyword = scanner_.word();
      if (keyword == "End") break;
      if (keyword == "Vertices") {
        vertices();
      } else if (keyword == "Triangles") {
        cells<3>("triangles", [&](const Triangle& t) { faces_.add(t, scanner_); });
      } else if (keyword == "Quadrilaterals") {
        cells<4>("quadrilaterals", [&](const std::array<Index, 4>& q) { faces_.add(q, scanner_); });
      } else if (keyword == "Tetrahedra") {
        cells<4>("tetrahedra", [&](const Tetrahedron& t) { mesh_.tetrahedra.push_back(t); });
      } else if (keyword == "Hexahedra") {
        cells<8>("hexahedra", [&](const Hexahedron& h) { mesh_.hexahedra.push_back(h); });
      } else if (keyword == "Dimension") {
        dimension();
      } else if (keyword == "MeshVersionFormatted") {
        scanner_.skip_space();
        scanner_.integer("the version");
      } else if (std::isalpha(static_cast<unsigned char>(keyword.front())) != 0) {
        skip_section(std::string(keyword));
      } else {
        scanner_.fail("parse", "the name of a section expected, found " + in_quotes(keyword));
      }
    }
    report_.format = "MEDIT";
    report_.polygons = faces_.larger_than_triangles();
    faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
    return std::move(mesh_);
  }

 private:
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
    for (std::uint64_t v = 0; v < n; ++v) {
      Vector3 p;
      for (double& x : p) {
        scanner_.skip_space();
        x = scanner_.coordinate("a coordinate");
      }
      reference();
      mesh_.positions.push_back(p);
      scanner_.progress();
    }
  }

  template <std::size_t corners, class Take>
  void cells(const char* what, const Take& take) {
    if (mesh_.positions.empty()) scanner_.fail("parse", std::string(what) + " before the section Vertices");
    const std::uint64_t n = count(what, 2 * corners + 2);
    for (std::uint64_t i = 0; i < n; ++i) {
      std::array<Index, corners> cell;
      for (Index& v : cell) {
        scanner_.skip_space();
        v = scanner_.index(1, mesh_.positions.size());
      }
      reference();
      take(cell);
      scanner_.progress();
    }
  }

  // The number of the part that an item belongs to, which is not kept.
  void reference() {
    scanner_.skip_space();
    scanner_.integer("a reference");
  }

  // A section that is not read: its numbers, up to the next word.
  void skip_section(const std::string& name) {
    while (scanner_.skip_space() && !scanner_.at_letter()) {
      scanner_.word();
      scanner_.progress();
    }
    report_.notes.push_back("the section " + name + " was passed over");
  }

  TextScanner scanner_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  Polygons faces_;
};

}  // namespace

Mesh read_medit(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  return MeditReader(bytes, host, report).run();
}

}  // namespace orbicube::mesh
