#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "mesh/binary_scanner.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"

namespace orbicube::mesh {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50;  // normal and corners as float32, and two bytes of anything

void add_facet(Mesh& mesh) {
  const auto count = static_cast<Index>(mesh.positions.size());
  mesh.triangles.push_back({count - 3, count - 2, count - 1});
}

Mesh read_binary(std::span<const std::byte> bytes, const base::Host& host) {
  BinaryScanner scanner(bytes, 0, std::endian::little, host);
  scanner.require(header_size + 4, "the header");
  scanner.skip(header_size);
  const auto count = scanner.next<std::uint32_t>();
  scanner.require_room(count, facet_size, "facets");
  if (scanner.left() > count * facet_size) {
    scanner.fail("trailing-data", "the file says that it has " + std::to_string(count) + " facets, but " +
                                      std::to_string(scanner.left()) + " bytes follow, which is more");
  }
  Mesh mesh(host.memory);
  mesh.positions.reserve(std::size_t{3} * count);
  mesh.triangles.reserve(count);
  for (std::uint32_t f = 0; f < count; ++f) {
    scanner.skip(3 * sizeof(float));
    for (int corner = 0; corner < 3; ++corner) {
      Vector3 p;
      for (double& x : p)
        x = static_cast<double>(scanner.next<float>());
      if (!p.allFinite()) scanner.fail("non-finite", "a corner of facet " + std::to_string(f) + " is not finite");
      mesh.positions.push_back(p);
    }
    scanner.skip(2);
    add_facet(mesh);
    scanner.progress();
  }
  return mesh;
}

Mesh read_text(std::span<const std::byte> bytes, const base::Host& host) {
  TextScanner scanner(bytes, 0, host);
  Mesh mesh(host.memory);
  mesh.positions.reserve(bytes.size() / 80);
  mesh.triangles.reserve(bytes.size() / 240);
  std::size_t corners = 0;
  bool ended = false;
  for (; !scanner.at_end_of_file(); scanner.next_line()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "vertex") {
      Vector3 p;
      for (double& x : p)
        x = scanner.coordinate("a coordinate");
      mesh.positions.push_back(p);
      ++corners;
    } else if (keyword == "endfacet") {
      if (corners != 3) scanner.fail("parse", "a facet with " + std::to_string(corners) + " corners");
      corners = 0;
      add_facet(mesh);
    } else if (keyword == "endsolid") {
      if (corners != 0) scanner.fail("parse", "endsolid inside a facet");
      ended = true;
    } else if (keyword == "solid") {
      ended = false;
    } else if (!keyword.empty() && keyword != "facet" && keyword != "outer" && keyword != "endloop") {
      scanner.fail(scanner.at_end_of_file() ? "truncated" : "parse",
                   in_quotes(keyword) + " has no meaning in an STL file");
    }
    scanner.progress();
  }
  if (!ended) scanner.fail("truncated", "the file ends before endsolid");
  return mesh;
}

// Binary headers may begin with "solid" too: then the size tells, or a NUL, which no text has.
bool is_binary(std::span<const std::byte> bytes) {
  if (bytes.size() >= header_size + 4) {
    std::array<unsigned char, 4> count{};
    std::memcpy(count.data(), bytes.data() + header_size, count.size());
    const std::uint64_t facets = count[0] + 0x100ULL * count[1] + 0x10000ULL * count[2] + 0x1000000ULL * count[3];
    if (bytes.size() == header_size + 4 + facets * facet_size) return true;
  }
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  if (!text.substr(start).starts_with("solid")) return true;
  if (text.find('\0') == std::string_view::npos) return false;
  return text.size() >= header_size + 4;
}

}  // namespace

Mesh read_stl(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  const bool binary = is_binary(bytes);
  report.format = binary ? "STL, binary" : "STL, ASCII";
  return binary ? read_binary(bytes, host) : read_text(bytes, host);
}

}  // namespace orbicube::mesh
