// The reader of Gmsh's files: each version and form with the same contents, and what is refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

struct Variant {
  bool version_4, binary, turned;  // turned: of the other order of bytes
};
constexpr Variant variants[] = {{false, false, false}, {true, false, false}, {false, true, false},
                                {true, true, false},   {false, true, true},  {true, true, true}};

// Numbers as a variant has them, a line of text or bytes.
class Encoder {
 public:
  explicit Encoder(const Variant& variant) : variant_(variant) {}
  void text(const std::string& line) { bytes_ += line + "\n"; }
  void integers(const std::vector<std::int32_t>& numbers) { put_all(numbers); }
  // The numbers of nodes and cells, and sizes of version 4.
  void sizes(const std::vector<std::uint64_t>& numbers) {
    if (variant_.version_4)
      put_all(numbers);
    else
      put_all(std::vector<std::int32_t>(numbers.begin(), numbers.end()));
  }
  void reals(const std::vector<double>& numbers) { put_all(numbers); }
  void end_line() {
    if (!variant_.binary) bytes_ += "\n";
  }
  void end_block() {
    if (variant_.binary) bytes_ += "\n";
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class Number>
  void put_all(const std::vector<Number>& numbers) {
    for (const Number number : numbers) {
      if (!variant_.binary) {
        std::string digits = std::to_string(number);
        bytes_ += digits + " ";
        continue;
      }
      std::string raw(sizeof number, '\0');
      std::memcpy(raw.data(), &number, sizeof number);
      if (variant_.turned) std::reverse(raw.begin(), raw.end());
      bytes_ += raw;
    }
  }
  Variant variant_;
  std::string bytes_;
};

struct Element {
  std::int32_t type, region;
  std::vector<std::uint64_t> nodes;
};

// A cube, a pyramid on it, a prism beside it, faces, a line and a point; nodes have numbers of their own.
const std::vector<double> cube_and_more = {0, 0, 0, 1, 0, 0, 1, 1,  0,  0, 1, 0, 0, 0, 1, 1, 0,
                                           1, 1, 1, 1, 0, 1, 1, .5, .5, 2, 2, 0, 0, 2, 0, 1};
const std::vector<std::uint64_t> node_numbers = {11, 12, 13, 14, 25, 26, 27, 28, 7, 30, 31};
const std::vector<Element> all_elements = {{15, 1, {7}},
                                           {1, 2, {11, 12}},
                                           {2, 3, {25, 26, 7}},
                                           {3, 4, {11, 14, 13, 12}},
                                           {5, 5, {11, 12, 13, 14, 25, 26, 27, 28}},
                                           {7, 5, {25, 26, 27, 28, 7}},
                                           {6, 6, {12, 30, 13, 26, 31, 27}}};

std::string file_of(const Variant& variant, const std::vector<Element>& elements) {
  Encoder out(variant);
  out.text("$MeshFormat");
  out.text(std::string(variant.version_4 ? "4.1" : "2.2") + (variant.binary ? " 1 8" : " 0 8"));
  if (variant.binary) {
    out.integers({1});
    out.end_block();
  }
  out.text("$EndMeshFormat");
  out.text("$PhysicalNames");
  out.text("1\n3 5 \"the $Nodes of it\"");
  out.text("$EndPhysicalNames");
  out.text("$Nodes");
  const std::size_t count = node_numbers.size();
  const auto position = [&](std::size_t i) {
    return std::vector<double>(cube_and_more.begin() + static_cast<std::ptrdiff_t>(3 * i),
                               cube_and_more.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
  };
  if (variant.version_4) {
    // Two blocks; the nodes of the first, on a surface, have parameters.
    out.sizes({2, count, 7, 31});
    out.end_line();
    for (const auto& [begin, end, parametric] : {std::tuple{std::size_t{0}, std::size_t{3}, 1}, {3, count, 0}}) {
      out.integers({2, 9, parametric});
      out.sizes({end - begin});
      out.end_line();
      for (std::size_t i = begin; i < end; ++i) {
        out.sizes({node_numbers[i]});
        out.end_line();
      }
      for (std::size_t i = begin; i < end; ++i) {
        out.reals(position(i));
        if (parametric != 0) out.reals({.25, .75});
        out.end_line();
      }
    }
  } else {
    out.text(std::to_string(count));
    for (std::size_t i = 0; i < count; ++i) {
      out.sizes({node_numbers[i]});
      out.reals(position(i));
      out.end_line();
    }
  }
  out.end_block();
  out.text("$EndNodes");
  out.text("$Elements");
  if (variant.version_4) {
    out.sizes({elements.size(), elements.size(), 1, elements.size()});
    out.end_line();
  } else {
    out.text(std::to_string(elements.size()));
  }
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Element& e = elements[i];
    if (variant.version_4) {
      out.integers({3, e.region, e.type});
      out.sizes({1});
      out.end_line();
      out.sizes({i + 1});
    } else if (variant.binary) {
      out.integers({e.type, 1, 2, static_cast<std::int32_t>(i + 1), e.region, 1});
    } else {
      out.integers({static_cast<std::int32_t>(i + 1), e.type, 2, e.region, 1});
    }
    out.sizes(e.nodes);
    out.end_line();
  }
  out.end_block();
  out.text("$EndElements");
  out.text("$NodeData");
  out.text("1\n\"temperature\"");
  out.text("$EndNodeData");
  return out.bytes();
}

}  // namespace

TEST_CASE("Gmsh: both versions, as text and binary of either order of bytes, have the same mesh") {
  const Mesh first = read_text(Format::msh, file_of(variants[0], all_elements));
  CHECK(first.positions.size() >= 11);
  CHECK(first.positions[8] == Vector3(.5, .5, 2));
  CHECK(first.triangles.size() == 3);
  CHECK(first.triangles[0] == Triangle{4, 5, 8});
  CHECK(first.hexahedra.empty());  // cut with the cells beside it
  double volume = 0;
  for (const Tetrahedron& t : first.tetrahedra) {
    const auto p = [&](std::size_t k) { return first.positions[t[k]]; };
    volume += (p(1) - p(0)).cross(p(2) - p(0)).dot(p(3) - p(0)) / 6;
  }
  CHECK(volume == doctest::Approx(1 + 1 / 3. + .5));
  for (const Variant& variant : variants) {
    CAPTURE(variant.version_4);
    CAPTURE(variant.binary);
    ReadReport report;
    const Mesh mesh = read_text(Format::msh, file_of(variant, all_elements), {.feature_tags = true}, &report);
    CHECK(mesh.positions == first.positions);
    CHECK(mesh.triangles == first.triangles);
    CHECK(mesh.tetrahedra == first.tetrahedra);
    CHECK(report.tags->edges == std::vector<std::array<Index, 2>>{{0, 1}});
    CHECK(report.tags->vertices == std::vector<Index>{8});
    CHECK(report.polygons == 1);
    REQUIRE(!report.notes.empty());
    CHECK(report.notes.back() == "left out: 1 list of names of regions, 1 data array");
    // Groups of version 2; entities of version 4, which has no groups here.
    CHECK(mesh.regions.triangles == Array<std::int32_t>{3, 4, 4});
    CHECK(std::ranges::count(mesh.regions.tetrahedra, 6) == 3);
    CHECK(std::ranges::count(mesh.regions.tetrahedra, 5) + 3 == std::ssize(mesh.tetrahedra));
  }
  const Mesh cube = read_text(Format::msh, file_of(variants[0], {all_elements[4]}));
  CHECK(cube.hexahedra == Array<Hexahedron>{{0, 1, 2, 3, 4, 5, 6, 7}});
}

TEST_CASE("Gmsh: what cannot be read is refused with the place") {
  const std::string text = file_of(variants[0], all_elements), head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  CHECK(ends_as(Format::msh, "$NOD\n1\n", "unsupported-version", "version 1"));
  CHECK(ends_as(Format::msh, "solid\n", "bad-magic"));
  CHECK(ends_as(Format::msh, "$MeshFormat\n4 0 8\n$EndMeshFormat\n", "unsupported-version", "4.1"));
  CHECK(ends_as(Format::msh, "$MeshFormat\n4.1 0 4\n$EndMeshFormat\n", "unsupported", "'0 4'"));
  CHECK(ends_as(Format::msh, head, "truncated", "Elements"));
  CHECK(ends_as(Format::msh, head + "$Elements\n0\n$EndElements\n", "parse", "before the section Nodes"));
  CHECK(
      ends_as(Format::msh, head + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n", "parse", "two nodes have the number 1"));
  CHECK(ends_as(Format::msh, head + "$Nodes\n1\n1 0 0 inf\n$EndNodes\n", "non-finite"));
  CHECK(ends_as(Format::msh, head + "$Nodes\n99999999\n1 0 0 0\n$EndNodes\n", "truncated"));
  const auto with = [](const Variant& variant, const Element& element) { return file_of(variant, {element}); };
  for (const Variant& variant : variants) {
    CAPTURE(variant.version_4);
    CAPTURE(variant.binary);
    CHECK(ends_as(Format::msh, with(variant, {2, 1, {11, 12, 99}}), "index-range", "no node 99"));
    CHECK(ends_as(Format::msh, with(variant, {2, 1, {11, 12, 0}}), "index-range", "no node 0"));
    CHECK(ends_as(Format::msh, with(variant, {9, 1, {11, 12, 13, 14, 25, 26}}), "unsupported", "type 9"));
    CHECK(ends_as(Format::msh, with(variant, {-1, 1, {11}}), "unsupported", "type -1"));
  }
  std::string unended = text;
  unended.replace(unended.find("$EndNodes"), 9, "$EndNode");
  CHECK(ends_as(Format::msh, unended, "parse", "$EndNodes expected"));
}

TEST_CASE("Gmsh: a file cut short or changed at any byte is refused, or is a mesh all the same") {
  for (const Variant& variant : variants) {
    const std::string whole = file_of(variant, all_elements);
    const std::size_t end = whole.find("$EndElements");
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::vector<char> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      const std::string ended = outcome(Format::msh, {cut.data(), cut.size()});
      CHECK_FALSE(ended.starts_with("internal"));
      if (size < end) CHECK(ended != "accept");
      std::string changed = whole;
      changed[size] = static_cast<char>(changed[size] ^ 0x41);
      CHECK_FALSE(outcome(Format::msh, changed).starts_with("internal"));
    }
  }
}
