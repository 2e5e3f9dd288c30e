#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/left_out.h"
#include "mesh/formats/codecs.h"
#include "mesh/formats/vtk_body.h"
#include "mesh/formats/vtk_cells.h"
#include "mesh/formats/vtk_data.h"

namespace orbicube::mesh {
namespace {

template <class Body>
class VtkReader {
 public:
  VtkReader(Body body, bool with_offsets, const base::Host& host, ReadReport& report)
      : body_(body),
        with_offsets_(with_offsets),
        host_(host),
        report_(report),
        mesh_(host.memory),
        cells_(mesh_, host, report),
        offsets_(host.memory),
        connectivity_(host.memory) {}

  Mesh run() {
    const auto dataset = body_.words();
    if (dataset.empty()) body_.fail("truncated", "the file ends before its dataset");
    if (dataset.size() != 2 || in_small_letters(dataset[0]) != "dataset")
      body_.fail("parse", "DATASET and its kind expected");
    const std::string kind = in_small_letters(dataset[1]);
    if (kind != "polydata" && kind != "unstructured_grid") {
      body_.fail("unsupported-format", "datasets of kind " + in_quotes(dataset[1]) + " are not read");
    }
    for (auto words = body_.words(); !words.empty(); words = body_.words()) {
      if (!section(words)) break;
    }
    const VtkData data = find_vtk_data(body_.rest(), cells_in_data_);
    regions(data.regions);
    cells_.finish(body_);
    const std::size_t left_out = field_arrays_ + data.arrays - data.regions.has_value();
    note_left_out({{left_out, "data array", "data arrays"}}, report_.notes);
    return std::move(mesh_);
  }

 private:
  using Words = std::vector<std::string_view>;

  // Returns false where data on points and cells begins, of which regions are of interest.
  bool section(const Words& words) {
    const std::string name = in_small_letters(words[0]);
    if (name == "cell_data") cells_in_data_ = count(words, 1);
    if (name == "point_data" || name == "cell_data") return false;
    if (name == "metadata") {
      body_.skip_to_empty_line();
    } else if (name == "field") {
      fields(words);
    } else if (name == "points") {
      points(words);
    } else if (name == "polygons") {
      cell_array(words);
      in_usual_order_ = in_usual_order_ && !strips_;
      for_each_cell([&](std::span<const Index> cell) { cells_.add_polygon(cell, body_); });
    } else if (name == "triangle_strips") {
      cell_array(words);
      strips_ = true;
      for_each_cell([&](std::span<const Index> cell) { cells_.add_strip(cell); });
    } else if (name == "cells") {
      cell_array(words);
    } else if (name == "cell_types") {
      cell_types(words);
    } else if (name == "lines" || name == "vertices") {
      cell_array(words);
      in_usual_order_ = in_usual_order_ && cells_.count() == (name == "lines" ? vertices_ : 0);
      if (name == "vertices") vertices_ = offsets_.empty() ? 0 : offsets_.size() - 1;
      cells_.add_tags(offsets_.empty() ? 0 : offsets_.size() - 1);
      if (report_.tags)
        for_each_cell([&](std::span<const Index> cell) { cells_.add_tag(name == "lines" ? 4 : 2, cell); });
      else if (offsets_.size() > 1)
        cells_.pass_over(offsets_.size() - 1, name == "lines" ? "line" : "vertex",
                         name == "lines" ? "lines" : "vertices");
    } else {
      body_.fail("parse", in_quotes(words[0]) + " is no section of a dataset");
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

  VtkNumber type(const Words& words, std::size_t place) {
    const auto found = words.size() > place ? number_named(words[place]) : std::nullopt;
    if (!found) body_.fail("parse", in_quotes(words[0]) + " has no known type of numbers");
    return *found;
  }

  void points(const Words& words) {
    const std::uint64_t n = count(words, 1);
    const VtkNumber number = type(words, 2);
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
      if (offsets.empty() || in_small_letters(offsets[0]) != "offsets") body_.fail("parse", "OFFSETS expected");
      const VtkNumber offset_type = type(offsets, 1);
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
      if (connectivity.empty() || in_small_letters(connectivity[0]) != "connectivity")
        body_.fail("parse", "CONNECTIVITY expected");
      const VtkNumber index_type = type(connectivity, 1);
      body_.require_room(second, index_type, "vertex indices");
      connectivity_.reserve(second);
      for (std::uint64_t i = 0; i < second; ++i)
        connectivity_.push_back(index(body_.integer(index_type)));
      return;
    }
    body_.require_room(second, VtkNumber::int32, "vertex indices of cells");
    if (first > second) body_.fail("parse", base::counted(first, "cell") + " in " + base::counted(second, "number"));
    offsets_.reserve(first + 1);
    connectivity_.reserve(second - first);
    offsets_.push_back(0);
    for (std::uint64_t i = 0; i < first; ++i) {
      const std::int64_t corners = body_.integer(VtkNumber::int32);
      const std::uint64_t room = second - first - connectivity_.size();
      if (corners < 0 || static_cast<std::uint64_t>(corners) > room) {
        body_.fail("parse", "cell " + std::to_string(i) + " has " + base::counted(corners, "corner") +
                                ", more than the section holds");
      }
      for (std::int64_t k = 0; k < corners; ++k)
        connectivity_.push_back(index(body_.integer(VtkNumber::int32)));
      offsets_.push_back(connectivity_.size());
      body_.progress();
    }
  }

  Index index(std::int64_t value) {
    if (value < 0 || static_cast<std::uint64_t>(value) >= mesh_.positions.size()) {
      body_.fail("index-range",
                 "vertex index " + std::to_string(value) + " of " + base::counted(mesh_.positions.size(), "point"));
    }
    return static_cast<Index>(value);
  }

  template <class Take>
  void for_each_cell(const Take& take) {
    for (std::size_t i = 0; i + 1 < offsets_.size(); ++i) {
      take(std::span<const Index>(connectivity_.data() + offsets_[i], offsets_[i + 1] - offsets_[i]));
    }
  }

  // The kind of each cell of the section CELLS, which must have come before.
  void cell_types(const Words& words) {
    const std::uint64_t n = count(words, 1);
    if (n + 1 != std::max<std::size_t>(1, offsets_.size())) {
      body_.fail("parse",
                 base::counted(n, "type") + " of " + base::counted(offsets_.empty() ? 0 : offsets_.size() - 1, "cell"));
    }
    body_.require_room(n, VtkNumber::int32, "types of cells");
    std::uint64_t i = 0;
    std::size_t passed_over = 0;
    for_each_cell([&](std::span<const Index> cell) {
      passed_over += !cells_.add(body_.integer(VtkNumber::int32), cell, i++, body_);
    });
    if (passed_over > 0) cells_.pass_over(passed_over, "point or line", "points and lines");
  }

  // FIELD name n, then n arrays: name, components, tuples, type, and their numbers.
  void fields(const Words& words) {
    const std::uint64_t arrays = count(words, 2);
    field_arrays_ += arrays;
    for (std::uint64_t a = 0; a < arrays; ++a) {
      const Words array = body_.words();
      if (array.empty()) body_.fail("truncated", "the file ends inside a field");
      if (array.size() == 4 && array[3] == "string") body_.fail("unsupported", "fields of strings are not read");
      const std::uint64_t components = count(array, 1);
      const std::uint64_t tuples = count(array, 2);
      const VtkNumber number = type(array, 3);
      if (tuples > 0) body_.require_room(components, number, "components of a field");
      if (components > 0) body_.require_room(tuples, number, "numbers of a field");
      body_.require_room(components * tuples, number, "numbers of a field");
      for (std::uint64_t i = 0; i < components * tuples; ++i)
        body_.number(number);
    }
  }

  // Reads an array with a number for each cell.
  void regions(const std::optional<VtkRegionArray>& array) {
    if (!array) return cells_.set_regions({});
    body_.skip(array->begin);
    const std::size_t cells = cells_.count();
    if (array->count != cells) {
      body_.fail("parse", "the array " + in_quotes(array->name) + " has " + base::counted(array->count, "number") +
                              ", where the file has " + base::counted(cells, "cell"));
    }
    body_.require_room(cells, array->type, "region numbers");
    const bool real = array->type == VtkNumber::float32 || array->type == VtkNumber::float64;
    Array<std::int32_t> numbers(host_.memory);
    numbers.reserve(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      numbers.push_back(real ? cells_.region_of(body_.number(array->type))
                             : cells_.region_of(body_.integer(array->type)));
      body_.progress();
    }
    if (!in_usual_order_) cells_.leave_out_regions("the kinds of cells are in an unusual order");
    cells_.set_regions(numbers);
  }

  Body body_;
  bool with_offsets_;  // since version 5
  const base::Host& host_;
  ReadReport& report_;
  Mesh mesh_;
  VtkCells cells_;
  std::size_t field_arrays_ = 0, vertices_ = 0;
  std::optional<std::uint64_t> cells_in_data_;  // of CELL_DATA, if that comes first
  bool strips_ = false, in_usual_order_ = true;
  Array<std::size_t> offsets_;
  Array<Index> connectivity_;
};

}  // namespace

Mesh read_vtk(std::span<const std::byte> bytes, const base::Host& host, ReadReport& report) {
  // The first three lines: magic with version, a title, ASCII or BINARY.
  BinaryScanner scanner(bytes, 0, std::endian::big, host);
  const auto magic = words_of(scanner.line());
  if (magic.size() < 5 || in_small_letters(magic[1]) != "vtk" || in_small_letters(magic[2]) != "datafile") {
    throw base::Error("bad-magic", "line 1: a legacy VTK file starts with # vtk DataFile Version");
  }
  const bool with_offsets = magic[4].substr(0, magic[4].find('.')) >= "5" && magic[4][0] <= '9';
  scanner.line();
  const auto form = words_of(scanner.line());
  if (form.empty()) scanner.fail("truncated", "the file ends inside its header");
  if (in_small_letters(form[0]) == "binary") {
    report.format = "VTK, binary";
    return VtkReader(VtkBinaryBody(scanner), with_offsets, host, report).run();
  }
  if (in_small_letters(form[0]) != "ascii")
    scanner.fail("parse", "line 3: ASCII or BINARY expected, found " + in_quotes(form[0]));
  report.format = "VTK, ASCII";
  TextScanner text(bytes, 0, host);
  for (int line = 0; line < 3; ++line)
    text.next_line();
  return VtkReader(VtkTextBody(text), with_offsets, host, report).run();
}

}  // namespace orbicube::mesh
