#include <bit>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/binary_scanner.h"
#include "mesh/files/left_out.h"
#include "mesh/files/polygons.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/ply_header.h"

namespace orbicube::mesh {
namespace {

// Of the property of a face that holds its vertices.
std::optional<std::size_t> place_of_corners(const PlyElement& face) {
  return face.find({"vertex_indices", "vertex_index"});
}

// Names from a file, for a note: printable, and not too many.
std::string shortened(const std::string& names) {
  constexpr std::size_t longest = 120;
  std::string text = names.substr(0, longest);
  for (char& c : text)
    c = c >= ' ' && c <= '~' ? c : '?';
  return names.size() > longest ? text + "..." : text;
}

// Both kinds of body support the same queries: is there room for a count, the next number, the next item.
class TextBody {
 public:
  explicit TextBody(TextScanner& scanner) : scanner_(scanner) {}

  void require_elements(const PlyElement& e) {
    scanner_.require_room(e.count, std::max<std::size_t>(1, 2 * e.properties.size()), e.name.c_str());
  }
  void require_list(std::uint64_t count, PlyType) { scanner_.require_room(count, 2, "entries of a list"); }
  double number(PlyType) { return scanner_.skip_space(), scanner_.coordinate("a number"); }
  std::int64_t integer(PlyType) { return scanner_.skip_space(), scanner_.integer("an integer"); }
  std::int64_t index(PlyType type) {
    if (type == PlyType::float32 || type == PlyType::float64) return to_integer(number(type));
    return scanner_.skip_space(), scanner_.integer("a vertex index", "index-range");
  }
  // Whatever it is: normals that are no numbers are not judged.
  void skip(PlyType) { scanner_.skip_word("a number"); }
  void next_item() { scanner_.progress(); }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

  std::int64_t to_integer(double x) const {
    const auto i = static_cast<std::int64_t>(std::clamp(x, -1e18, 1e18));
    if (static_cast<double>(i) != x) fail("parse", "a vertex index that is no integer");
    return i;
  }

 private:
  TextScanner& scanner_;
};

class BinaryBody {
 public:
  explicit BinaryBody(BinaryScanner& scanner) : scanner_(scanner) {}

  void require_elements(const PlyElement& e) {
    scanner_.require_room(e.count, std::max<std::size_t>(1, e.min_size()), e.name.c_str());
  }
  void require_list(std::uint64_t count, PlyType type) {
    scanner_.require_room(count, size_of(type), "entries of a list");
  }
  double number(PlyType type) {
    scanner_.require(size_of(type), "an element");
    switch (type) {
      case PlyType::int8:
        return scanner_.next<std::int8_t>();
      case PlyType::uint8:
        return scanner_.next<std::uint8_t>();
      case PlyType::int16:
        return scanner_.next<std::int16_t>();
      case PlyType::uint16:
        return scanner_.next<std::uint16_t>();
      case PlyType::int32:
        return scanner_.next<std::int32_t>();
      case PlyType::uint32:
        return scanner_.next<std::uint32_t>();
      case PlyType::float32:
        return static_cast<double>(scanner_.next<float>());
      case PlyType::float64:
        break;
    }
    return scanner_.next<double>();
  }
  std::int64_t integer(PlyType type) {
    const double x = number(type);  // exact: there are no 64-bit integers in PLY
    if (!(std::abs(x) < 1e18) || std::floor(x) != x) fail("parse", "a vertex index that is no integer");
    return static_cast<std::int64_t>(x);
  }
  std::int64_t index(PlyType type) { return integer(type); }
  void skip(PlyType type) {
    scanner_.require(size_of(type), "an element");
    scanner_.skip(size_of(type));
  }
  void next_item() { scanner_.progress(); }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

 private:
  BinaryScanner& scanner_;
};

template <class Body>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Body body, const base::Host& host, ReadReport& report)
      : header_(header),
        body_(body),
        host_(host),
        report_(report),
        mesh_(host.memory),
        faces_(host.memory),
        list_(host.memory) {
    // Faces may come before the vertices that they name.
    for (const PlyElement& e : header_.elements)
      if (e.name == "vertex") vertex_count_ += e.count;
  }

  Mesh run() {
    for (const PlyElement& e : header_.elements) {
      if (e.properties.empty() && (e.name != "vertex" || e.count == 0)) continue;  // takes no room, whatever its number
      body_.require_elements(e);
      if (e.name == "vertex") {
        vertices(e);
      } else if (e.name == "face") {
        faces(e, false);
      } else if (e.name == "tristrips") {
        faces(e, true);
      } else {
        for (std::uint64_t i = 0; i < e.count; ++i)
          skip_all(e);
      }
    }
    report_.polygons = faces_.larger_than_triangles();
    faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
    note_rest();
    return std::move(mesh_);
  }

 private:
  // Properties of vertices and faces that are not read, and elements.
  void note_rest() {
    std::string names;
    const auto add = [&](const std::string& name) { names.append(names.empty() ? "" : " ").append(name); };
    std::size_t properties = 0, elements = 0;
    for (const PlyElement& e : header_.elements) {
      const bool is_vertex = e.name == "vertex", is_face = e.name == "face" || e.name == "tristrips";
      if (e.count == 0) continue;
      if (!is_vertex && !is_face) {
        ++elements;
        add(std::to_string(e.count) + " " + e.name);
        continue;
      }
      const auto corners = place_of_corners(e);
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const std::string& name = e.properties[i].name;
        if (is_vertex ? name == "x" || name == "y" || name == "z" : i == corners) continue;
        ++properties;
        add(name);
      }
    }
    note_left_out({{properties, "property of vertices and faces", "properties of vertices and faces"},
                   {elements, "other element", "other elements"}},
                  report_.notes);
    if (properties + elements > 0) report_.notes.back() += " (" + shortened(names) + ")";
  }

  void skip(const PlyProperty& p) {
    const std::uint64_t count = p.count_type ? list_size(p) : 1;
    for (std::uint64_t i = 0; i < count; ++i)
      body_.skip(p.type);
  }
  void skip_all(const PlyElement& e) {
    for (const PlyProperty& p : e.properties)
      skip(p);
    body_.next_item();
  }

  std::uint64_t list_size(const PlyProperty& p) {
    const std::int64_t count = body_.integer(*p.count_type);
    if (count < 0) body_.fail("parse", "a list of " + base::counted(count, "entry", "entries"));
    body_.require_list(static_cast<std::uint64_t>(count), p.type);
    return static_cast<std::uint64_t>(count);
  }

  void vertices(const PlyElement& e) {
    if (e.count >= no_index) body_.fail("unsupported", "more vertices than 32 bits can count");
    if (e.count != vertex_count_ || !mesh_.positions.empty()) body_.fail("parse", "the element vertex comes twice");
    const std::array<std::optional<std::size_t>, 3> place = {e.find({"x"}), e.find({"y"}), e.find({"z"})};
    for (const auto& p : place) {
      if (!p || e.properties[*p].count_type) body_.fail("missing-attribute", "the vertices have no x, y and z");
    }
    mesh_.positions.reserve(e.count);
    for (std::uint64_t v = 0; v < e.count; ++v) {
      Vector3 position;
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const auto axis = i == place[0] ? 0 : i == place[1] ? 1 : i == place[2] ? 2 : 3;
        if (axis < 3) {
          position[axis] = body_.number(e.properties[i].type);
        } else {
          skip(e.properties[i]);
        }
      }
      if (!position.allFinite()) body_.fail("non-finite", "vertex " + std::to_string(v) + " is not finite");
      mesh_.positions.push_back(position);
      body_.next_item();
    }
  }

  void faces(const PlyElement& e, bool strips) {
    const auto place = place_of_corners(e);
    if (!place || !e.properties[*place].count_type) {
      body_.fail("missing-attribute", "the element " + e.name + " has no list vertex_indices");
    }
    if (!strips) faces_.reserve_triangles(e.count);
    for (std::uint64_t f = 0; f < e.count; ++f) {
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        if (i != *place) {
          skip(e.properties[i]);
        } else if (strips) {
          strip(e.properties[i]);
        } else {
          face(e.properties[i]);
        }
      }
      body_.next_item();
    }
  }

  void check_index(std::int64_t index) {
    if (index < 0 || static_cast<std::uint64_t>(index) >= vertex_count_) {
      body_.fail("index-range",
                 "vertex index " + std::to_string(index) + " of " + base::counted(vertex_count_, "vertex", "vertices"));
    }
  }

  void face(const PlyProperty& p) {
    const std::uint64_t count = list_size(p);
    list_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::int64_t index = body_.index(p.type);
      check_index(index);
      list_.push_back(static_cast<Index>(index));
    }
    faces_.add(list_, body_);
  }

  // -1 starts a new strip; every other triangle of a strip is the other way round; those with a corner twice only serve
  // to go on elsewhere.
  void strip(const PlyProperty& p) {
    const std::uint64_t count = list_size(p);
    list_.clear();
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::int64_t index = body_.index(p.type);
      if (index == -1) {
        list_.clear();
        continue;
      }
      check_index(index);
      list_.push_back(static_cast<Index>(index));
      const std::size_t n = list_.size();
      if (n < 3) continue;
      const Index a = list_[n - 3];
      const Index b = list_[n - 2];
      const Index c = list_[n - 1];
      if (a == b || b == c || c == a) continue;
      if (n % 2 == 1) {
        faces_.add_triangle(a, b, c);
      } else {
        faces_.add_triangle(b, a, c);
      }
    }
  }

  const PlyHeader& header_;
  std::uint64_t vertex_count_ = 0;  // that the header promises
  Body body_;
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  Polygons faces_;
  Array<Index> list_;
};

// The text part of the file, that is its header when the body is binary.
std::span<const std::byte> text_part(std::span<const std::byte> bytes) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t format = all.find("\nformat ascii");
  const std::size_t end = all.find("\nend_header");
  if (format < end || end == std::string_view::npos) return bytes;
  const std::size_t line_end = all.find('\n', end + 1);
  return bytes.first(line_end == std::string_view::npos ? bytes.size() : line_end + 1);
}

}  // namespace

Mesh read_ply(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  const auto text = text_part(bytes);
  TextScanner scanner(text, 0, host);
  const PlyHeader header = read_ply_header(scanner);
  if (header.form == PlyForm::ascii) {
    report.format = "PLY, ASCII";
    return PlyReader(header, TextBody(scanner), host, report).run();
  }
  const bool big = header.form == PlyForm::big_endian;
  report.format = big ? "PLY, binary, big-endian" : "PLY, binary, little-endian";
  BinaryScanner body(bytes.subspan(text.size()), text.size(), big ? std::endian::big : std::endian::little, host);
  return PlyReader(header, BinaryBody(body), host, report).run();
}

}  // namespace orbicube::mesh
