#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "base/counted.h"
#include "mesh/files/binary_scanner.h"
#include "mesh/files/text_scanner.h"
#include "mesh/files/wrapped_file.h"
#include "mesh/formats/codecs.h"
#include "mesh/topology/topology.h"
#include "mesh/topology/weld.h"

namespace orbicube::mesh {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50;  // normal and corners as float32, and two bytes of anything

void add_facet(Mesh& mesh) {
  const auto count = static_cast<Index>(mesh.positions.size());
  mesh.triangles.push_back({count - 3, count - 2, count - 1});
}

// Bytes behind the last facet: padding and the like are passed over, but not what may be facets that the count at the
// beginning has not.
void note_trailing(BinaryScanner& scanner, std::uint32_t count, std::span<const std::byte> trailing,
                   ReadReport& report) {
  if (trailing.empty()) return;
  const bool zeros = std::ranges::all_of(trailing, [](std::byte b) { return b == std::byte{0}; });
  if (count == 0 || (trailing.size() % facet_size == 0 && !zeros)) {
    scanner.fail("trailing-data", "the file says that it has " + base::counted(count, "facet") + ", but " +
                                      base::counted(scanner.left(), "byte follows", "bytes follow") +
                                      ", which is more");
  }
  report.notes.push_back(
      base::counted(trailing.size(), "byte behind the last facet was", "bytes behind the last facet were") +
      " passed over");
}

Mesh read_binary(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  BinaryScanner scanner(bytes, 0, std::endian::little, host);
  scanner.require(header_size + 4, "the header");
  scanner.skip(header_size);
  const auto count = scanner.next<std::uint32_t>();
  scanner.require_room(count, facet_size, "facets");
  note_trailing(scanner, count, bytes.subspan(header_size + 4 + count * facet_size), report);
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

bool is_closed_when_joined(const Mesh& mesh, const base::Host& host) {
  if (mesh.triangles.empty()) return false;
  Mesh joined(host.memory);
  joined.positions = mesh.positions;
  joined.triangles = mesh.triangles;
  weld(joined, host);
  return topology(joined.positions, joined.triangles, host).closed();
}

// ASCII files as many programs write them: keywords in letters of any size, "end loop" in two words, several of them on
// a line, any words behind solid and endsolid, several solids.
class TextReader {
 public:
  TextReader(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report)
      : scanner_(bytes, 0, host), host_(host), report_(report), mesh_(host.memory) {
    mesh_.positions.reserve(bytes.size() / 80);
    mesh_.triangles.reserve(bytes.size() / 240);
  }

  Mesh run() {
    for (; !scanner_.at_end_of_file(); scanner_.next_line()) {
      line();
      scanner_.progress();
    }
    if (corners_ != 0 || state_ == State::in_facet) scanner_.fail("truncated", "the file ends inside a facet");
    if (state_ == State::in_solid) {
      // A closed surface is whole; another may be half of one.
      if (!is_closed_when_joined(mesh_, host_)) scanner_.fail("truncated", "the file ends before endsolid");
      report_.notes.emplace_back("the file ends without endsolid");
    }
    if (passed_over_ > 0)
      report_.notes.push_back(base::counted(passed_over_, "line behind endsolid was", "lines behind endsolid were") +
                              " passed over");
    return std::move(mesh_);
  }

 private:
  enum class State { in_solid, in_facet, behind };

  void line() {
    for (bool first = true; !scanner_.at_end_of_line(); first = false) {
      const std::string_view word = scanner_.word();
      const std::string keyword = in_small_letters(word.substr(0, 12));
      if (keyword == "solid") {
        if (begin_solid()) continue;
        return;
      }
      if (keyword == "endsolid" || (keyword == "end" && next_is("solid"))) return end_solid();
      if (keyword == "vertex") {
        vertex();
      } else if (keyword == "endfacet" || (keyword == "end" && next_is("facet"))) {
        end_facet();
      } else if (keyword == "facet") {
        begin_facet();
      } else if (keyword == "outer" || keyword == "endloop" || (keyword == "end" && next_is("loop"))) {
        continue;
      } else if (first && state_ == State::behind) {
        ++passed_over_;
        return;
      } else if (first) {
        scanner_.fail(scanner_.at_end_of_file() ? "truncated" : "parse",
                      in_quotes(word) + " has no meaning in an STL file");
      }
    }
  }

  // Past the second word of "end loop" and the like.
  bool next_is(std::string_view target) {
    if (scanner_.at_end_of_line() || !scanner_.starts_with_ignoring_case(target)) return false;
    scanner_.word();
    return true;
  }

  void require_whole_facet(const char* keyword) const {
    if (corners_ != 0 || state_ == State::in_facet) scanner_.fail("parse", std::string(keyword) + " inside a facet");
  }
  // The name goes on to the end of the line, or to the first facet where that has all of the file.
  bool begin_solid() {
    require_whole_facet("solid");
    state_ = State::in_solid;
    constexpr std::size_t longest_name = 1000;  // bytes: many solids on one line must not be searched to its end each
    const std::size_t facet = in_small_letters(scanner_.line().substr(0, longest_name)).find("facet normal");
    if (facet == std::string::npos) return false;
    scanner_.skip_bytes(facet);
    return true;
  }
  void end_solid() {
    require_whole_facet("endsolid");
    state_ = State::behind;
  }
  // The normal does not count.
  void begin_facet() {
    require_whole_facet("facet");
    state_ = State::in_facet;
    if (!next_is("normal")) return;
    for (int i = 0; i < 3; ++i)
      scanner_.word();
  }

  void vertex() {
    Vector3 p;
    for (double& x : p)
      x = scanner_.coordinate("a coordinate");
    mesh_.positions.push_back(p);
    ++corners_;
  }

  void end_facet() {
    if (corners_ != 3) scanner_.fail("parse", "a facet with " + base::counted(corners_, "corner"));
    corners_ = 0;
    state_ = State::in_solid;
    add_facet(mesh_);
  }

  TextScanner scanner_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  std::size_t corners_ = 0;
  std::size_t passed_over_ = 0;
  State state_ = State::in_solid;
};

// Without the NUL bytes and the Control-Z behind a text, as old systems pad files.
std::span<const std::byte> without_padding(std::span<const std::byte> bytes) {
  while (!bytes.empty() && (bytes.back() == std::byte{0} || bytes.back() == std::byte{0x1A}))
    bytes = bytes.first(bytes.size() - 1);
  return bytes;
}

bool has_size_of_binary(std::span<const std::byte> bytes) {
  if (bytes.size() < header_size + 4) return false;
  std::array<unsigned char, 4> count{};
  std::memcpy(count.data(), bytes.data() + header_size, count.size());
  const std::uint64_t facets = count[0] + 0x100ULL * count[1] + 0x10000ULL * count[2] + 0x1000000ULL * count[3];
  return bytes.size() == header_size + 4 + facets * facet_size;
}

// Of a file that has not the size that its header says: whether it is binary all the same. Binary headers may begin
// with "solid" too: then a NUL decides, which no text has. Texts that begin otherwise have their say in messages.
bool is_binary(std::span<const std::byte> bytes) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\v\f\r\n"), text.size()));
  const std::span<const std::byte> whole = without_padding(bytes);
  const std::string_view kept(reinterpret_cast<const char*>(whole.data()), whole.size());
  if (in_small_letters(text.substr(0, 5)) != "solid")
    return bytes.size() < header_size + 4 || std::ranges::any_of(kept, [](char c) { return c >= 0 && c < '\t'; });
  if (kept.find('\0') == std::string_view::npos) {
    // A binary file may end in zeros as well; a text that is one says what its facets are.
    return bytes.size() != whole.size() && in_small_letters(kept).find("vertex") == std::string::npos;
  }
  return bytes.size() >= header_size + 4;
}

}  // namespace

Mesh read_stl(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  bool binary = has_size_of_binary(bytes);
  if (!binary) {
    refuse_wrapped(bytes);
    binary = is_binary(bytes);
  }
  report.format = binary ? "STL, binary" : "STL, ASCII";
  return binary ? read_binary(bytes, host, report) : TextReader(without_padding(bytes), host, report).run();
}

}  // namespace orbicube::mesh
