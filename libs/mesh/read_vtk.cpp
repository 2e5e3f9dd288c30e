#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "mesh/binary_scanner.h"
#include "mesh/polygons.h"
#include "mesh/readers.h"
#include "mesh/text_scanner.h"

namespace orbicube::mesh {
namespace {

enum class Number { int8, uint8, int16, uint16, int32, uint32, int64, float32, float64 };

std::optional<Number> number_named(std::string_view word) {
  struct Name {
    std::string_view word;
    Number number;
  };
  static constexpr Name names[] = {{"char", Number::int8},       {"unsigned_char", Number::uint8},
                                   {"short", Number::int16},     {"unsigned_short", Number::uint16},
                                   {"int", Number::int32},       {"unsigned_int", Number::uint32},
                                   {"vtkIdType", Number::int32}, {"vtktypeint64", Number::int64},
                                   {"long", Number::int64},      {"float", Number::float32},
                                   {"double", Number::float64}};
  for (const Name& name : names) {
    if (name.word == word) return name.number;
  }
  return std::nullopt;
}

std::size_t size_of(Number number) {
  switch (number) {
    case Number::int8:
    case Number::uint8:
      return 1;
    case Number::int16:
    case Number::uint16:
      return 2;
    case Number::int32:
    case Number::uint32:
    case Number::float32:
      return 4;
    case Number::int64:
    case Number::float64:
      break;
  }
  return 8;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r\v\f";
  for (std::size_t at = line.find_first_not_of(blanks); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = std::min(line.find_first_not_of(blanks, end), line.size());
  }
  return words;
}

// ASCII and binary files differ in how numbers are stored; both bodies answer the same questions.
class TextBody {
 public:
  explicit TextBody(TextScanner& scanner) : scanner_(scanner) {}
  // The words of the next line that has any; none at the end of the file.
  std::vector<std::string_view> words() {
    std::vector<std::string_view> result;
    if (!scanner_.skip_space()) return result;
    while (!scanner_.at_end_of_line())
      result.push_back(scanner_.word());
    return result;
  }
  void skip_to_empty_line() {
    scanner_.next_line();
    while (!scanner_.at_end_of_file() && !scanner_.at_end_of_line())
      scanner_.next_line();
  }
  void require_room(std::uint64_t items, Number, const char* what) { scanner_.require_room(items, 2, what); }
  double number(Number) { return scanner_.skip_space(), scanner_.coordinate("a number"); }
  std::int64_t integer(Number) { return scanner_.skip_space(), scanner_.integer("an integer"); }
  void progress() { scanner_.progress(); }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

 private:
  TextScanner& scanner_;
};

class BinaryBody {
 public:
  explicit BinaryBody(BinaryScanner& scanner) : scanner_(scanner) {}
  std::vector<std::string_view> words() {
    while (scanner_.left() > 0) {
      auto result = words_of(scanner_.line());
      if (!result.empty()) return result;
    }
    return {};
  }
  void skip_to_empty_line() {
    while (scanner_.left() > 0 && !words_of(scanner_.line()).empty())
      scanner_.progress();
  }
  void require_room(std::uint64_t items, Number type, const char* what) {
    scanner_.require_room(items, size_of(type), what);
  }
  double number(Number type) {
    if (type == Number::float32) return static_cast<double>(scanner_.next<float>());
    if (type == Number::float64) return scanner_.next<double>();
    return static_cast<double>(integer(type));
  }
  std::int64_t integer(Number type) {
    switch (type) {
      case Number::int8:
        return scanner_.next<std::int8_t>();
      case Number::uint8:
        return scanner_.next<std::uint8_t>();
      case Number::int16:
        return scanner_.next<std::int16_t>();
      case Number::uint16:
        return scanner_.next<std::uint16_t>();
      case Number::int32:
        return scanner_.next<std::int32_t>();
      case Number::uint32:
        return scanner_.next<std::uint32_t>();
      case Number::int64:
        return scanner_.next<std::int64_t>();
      case Number::float32:
      case Number::float64:
        break;
    }
    fail("parse", "an array of integers has a type of real numbers");
  }
  void progress() { scanner_.progress(); }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

 private:
  BinaryScanner& scanner_;
};

template <class Body>
class VtkReader {
 public:
  VtkReader(Body body, bool with_offsets, const base::Host& host, ReadReport& report)
      : body_(body),
        with_offsets_(with_offsets),
        host_(host),
        report_(report),
        mesh_(host.memory),
        faces_(host.memory),
        offsets_(host.memory),
        connectivity_(host.memory) {}

  Mesh run() {
    const auto dataset = body_.words();
    if (dataset.empty()) body_.fail("truncated", "the file ends before its dataset");
    if (dataset.size() != 2 || dataset[0] != "DATASET") body_.fail("parse", "DATASET and its kind expected");
    if (dataset[1] != "POLYDATA" && dataset[1] != "UNSTRUCTURED_GRID") {
      body_.fail("unsupported-format", "datasets of kind " + in_quotes(dataset[1]) + " are not read");
    }
    for (auto words = body_.words(); !words.empty(); words = body_.words()) {
      if (!section(words)) break;
    }
    report_.polygons = faces_.larger_than_triangles();
    faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
    return std::move(mesh_);
  }

 private:
  using Words = std::vector<std::string_view>;

  // Answers false where data on points and cells begins, which is of no interest.
  bool section(const Words& words) {
    const std::string name(words[0]);
    if (name == "POINT_DATA" || name == "CELL_DATA") return false;
    if (name == "METADATA") {
      body_.skip_to_empty_line();
    } else if (name == "FIELD") {
      fields(words);
    } else if (name == "POINTS") {
      points(words);
    } else if (name == "POLYGONS") {
      cell_array(words);
      for_each_cell([&](std::span<const Index> cell) { faces_.add(cell, body_); });
    } else if (name == "TRIANGLE_STRIPS") {
      cell_array(words);
      for_each_cell([&](std::span<const Index> cell) { add_strip(cell); });
    } else if (name == "CELLS") {
      cell_array(words);
    } else if (name == "CELL_TYPES") {
      cell_types(words);
    } else if (name == "LINES" || name == "VERTICES") {
      cell_array(words);
      report_.notes.push_back("the section " + name + " was passed over");
    } else {
      body_.fail("parse", in_quotes(name) + " is no section of a dataset");
    }
    return true;
  }

  std::uint64_t count(const Words& words, std::size_t place) {
    std::int64_t value = 0;
    if (words.size() <= place) body_.fail("truncated", std::string(words[0]) + " has no number of items");
    const std::string_view w = words[place];
    const auto [end, problem] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (problem != std::errc() || end != w.data() + w.size() || value < 0) {
      body_.fail("parse", "a number of items expected, found " + in_quotes(w));
    }
    return static_cast<std::uint64_t>(value);
  }

  Number type(const Words& words, std::size_t place) {
    const auto found = words.size() > place ? number_named(words[place]) : std::nullopt;
    if (!found) body_.fail("parse", in_quotes(words[0]) + " has no known type of numbers");
    return *found;
  }

  void points(const Words& words) {
    const std::uint64_t n = count(words, 1);
    const Number number = type(words, 2);
    if (!mesh_.positions.empty()) body_.fail("parse", "the section POINTS comes twice");
    if (n >= no_index / 3) body_.require_room(n, number, "points");
    body_.require_room(3 * n, number, "coordinates");
    mesh_.positions.reserve(n);
    for (std::uint64_t i = 0; i < n; ++i) {
      Vector3 p;
      for (double& x : p)
        x = body_.number(number);
      if (!p.allFinite()) body_.fail("non-finite", "point " + std::to_string(i) + " is not finite");
      mesh_.positions.push_back(p);
      body_.progress();
    }
  }

  // Fills offsets_ (one more than cells) and connectivity_.
  void cell_array(const Words& words) {
    const std::uint64_t first = count(words, 1);
    const std::uint64_t second = count(words, 2);
    offsets_.clear();
    connectivity_.clear();
    if (with_offsets_) {
      const Words offsets = body_.words();
      if (offsets.empty() || offsets[0] != "OFFSETS") body_.fail("parse", "OFFSETS expected");
      const Number offset_type = type(offsets, 1);
      body_.require_room(first, offset_type, "offsets");
      offsets_.reserve(first);
      for (std::uint64_t i = 0; i < first; ++i) {
        const std::int64_t offset = body_.integer(offset_type);
        const std::int64_t least = i == 0 ? 0 : static_cast<std::int64_t>(offsets_.back());
        if (offset < least || (i == 0 && offset != 0) || static_cast<std::uint64_t>(offset) > second) {
          body_.fail("index-range", "offset " + std::to_string(offset) + " of " + std::to_string(second));
        }
        offsets_.push_back(static_cast<std::size_t>(offset));
      }
      const Words connectivity = body_.words();
      if (connectivity.empty() || connectivity[0] != "CONNECTIVITY") body_.fail("parse", "CONNECTIVITY expected");
      const Number index_type = type(connectivity, 1);
      body_.require_room(second, index_type, "vertex indices");
      connectivity_.reserve(second);
      for (std::uint64_t i = 0; i < second; ++i)
        connectivity_.push_back(index(body_.integer(index_type)));
      return;
    }
    body_.require_room(second, Number::int32, "vertex indices of cells");
    if (first > second) body_.fail("parse", std::to_string(first) + " cells in " + std::to_string(second) + " numbers");
    offsets_.reserve(first + 1);
    connectivity_.reserve(second - first);
    offsets_.push_back(0);
    for (std::uint64_t i = 0; i < first; ++i) {
      const std::int64_t corners = body_.integer(Number::int32);
      const std::uint64_t room = second - first - connectivity_.size();
      if (corners < 0 || static_cast<std::uint64_t>(corners) > room) {
        body_.fail("parse", "cell " + std::to_string(i) + " has " + std::to_string(corners) +
                                " corners, more than the section holds");
      }
      for (std::int64_t k = 0; k < corners; ++k)
        connectivity_.push_back(index(body_.integer(Number::int32)));
      offsets_.push_back(connectivity_.size());
      body_.progress();
    }
  }

  Index index(std::int64_t value) {
    if (value < 0 || static_cast<std::uint64_t>(value) >= mesh_.positions.size()) {
      body_.fail("index-range",
                 "vertex index " + std::to_string(value) + " of " + std::to_string(mesh_.positions.size()) + " points");
    }
    return static_cast<Index>(value);
  }

  template <class Take>
  void for_each_cell(const Take& take) {
    for (std::size_t i = 0; i + 1 < offsets_.size(); ++i) {
      take(std::span<const Index>(connectivity_.data() + offsets_[i], offsets_[i + 1] - offsets_[i]));
    }
  }

  void add_strip(std::span<const Index> cell) {
    for (std::size_t i = 2; i < cell.size(); ++i) {
      const bool even = i % 2 == 0;
      faces_.add_triangle(cell[even ? i - 2 : i - 1], cell[even ? i - 1 : i - 2], cell[i]);
    }
  }

  // The kind of each cell of the section CELLS, which must have come before.
  void cell_types(const Words& words) {
    const std::uint64_t n = count(words, 1);
    if (n + 1 != std::max<std::size_t>(1, offsets_.size())) {
      body_.fail("parse", std::to_string(n) + " types of " +
                              std::to_string(offsets_.empty() ? 0 : offsets_.size() - 1) + " cells");
    }
    body_.require_room(n, Number::int32, "types of cells");
    std::uint64_t i = 0;
    std::size_t passed_over = 0;
    for_each_cell(
        [&](std::span<const Index> cell) { passed_over += !add_cell(body_.integer(Number::int32), cell, i++); });
    if (passed_over > 0) report_.notes.push_back(std::to_string(passed_over) + " points and lines were passed over");
  }

  bool add_cell(std::int64_t cell_type, std::span<const Index> c, std::uint64_t number) {
    const auto require_corners = [&](std::size_t corners) {
      if (c.size() != corners) {
        body_.fail("parse", "cell " + std::to_string(number) + " has " + std::to_string(c.size()) +
                                " corners, where its type has " + std::to_string(corners));
      }
    };
    // The numbers of vtkCellType.h.
    switch (cell_type) {
      case 1:  // vertex, vertices, line, lines
      case 2:
      case 3:
      case 4:
        return false;
      case 5:
        require_corners(3);
        faces_.add(c, body_);
        return true;
      case 6:
        add_strip(c);
        return true;
      case 7:
        faces_.add(c, body_);
        return true;
      case 8:  // pixel: a square by rows
        require_corners(4);
        faces_.add(std::array{c[0], c[1], c[3], c[2]}, body_);
        return true;
      case 9:
        require_corners(4);
        faces_.add(c, body_);
        return true;
      case 10:
        require_corners(4);
        mesh_.tetrahedra.push_back({c[0], c[1], c[2], c[3]});
        return true;
      case 11:  // voxel: a box by rows
        require_corners(8);
        mesh_.hexahedra.push_back({c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]});
        return true;
      case 12:
        require_corners(8);
        mesh_.hexahedra.push_back({c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});
        return true;
      default:
        body_.fail("unsupported", "cell " + std::to_string(number) + " is of type " + std::to_string(cell_type) +
                                      ", which is not read");
    }
  }

  // FIELD name n, then n arrays: name, components, tuples, type, and their numbers.
  void fields(const Words& words) {
    const std::uint64_t arrays = count(words, 2);
    for (std::uint64_t a = 0; a < arrays; ++a) {
      const Words array = body_.words();
      if (array.empty()) body_.fail("truncated", "the file ends inside a field");
      if (array.size() == 4 && array[3] == "string") body_.fail("unsupported", "fields of strings are not read");
      const std::uint64_t components = count(array, 1);
      const std::uint64_t tuples = count(array, 2);
      const Number number = type(array, 3);
      if (tuples > 0) body_.require_room(components, number, "components of a field");
      if (components > 0) body_.require_room(tuples, number, "numbers of a field");
      body_.require_room(components * tuples, number, "numbers of a field");
      for (std::uint64_t i = 0; i < components * tuples; ++i)
        body_.number(number);
    }
  }

  Body body_;
  bool with_offsets_;  // since version 5
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  Polygons faces_;
  Array<std::size_t> offsets_;
  Array<Index> connectivity_;
};

}  // namespace

Mesh read_vtk(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  // The first three lines: magic with version, a title, ASCII or BINARY.
  BinaryScanner scanner(bytes, 0, std::endian::big, host);
  const auto magic = words_of(scanner.line());
  if (magic.size() < 5 || magic[1] != "vtk" || magic[2] != "DataFile") {
    throw base::Error("bad-magic", "line 1: a legacy VTK file starts with # vtk DataFile Version");
  }
  const bool with_offsets = magic[4].substr(0, magic[4].find('.')) >= "5" && magic[4][0] <= '9';
  scanner.line();
  const auto form = words_of(scanner.line());
  if (form.empty()) scanner.fail("truncated", "the file ends inside its header");
  if (form[0] == "BINARY") {
    report.format = "VTK, binary";
    return VtkReader(BinaryBody(scanner), with_offsets, host, report).run();
  }
  if (form[0] != "ASCII") scanner.fail("parse", "line 3: ASCII or BINARY expected, found " + in_quotes(form[0]));
  report.format = "VTK, ASCII";
  TextScanner text(bytes, 0, host);
  for (int line = 0; line < 3; ++line)
    text.next_line();
  return VtkReader(TextBody(text), with_offsets, host, report).run();
}

}  // namespace orbicube::mesh
