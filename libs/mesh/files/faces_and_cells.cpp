#include "mesh/files/faces_and_cells.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "mesh/regions/region_numbers.h"

namespace orbicube::mesh {
namespace {

using Limits = std::numeric_limits<std::int32_t>;

// Appends each number as many times as its item became others.
template <class Count>
void append_repeated(std::span<const std::int32_t> regions, const Count& count, Array<std::int32_t>& to) {
  for (std::size_t i = 0; i < regions.size(); ++i)
    to.insert(to.end(), count(i), regions[i]);
}

}  // namespace

std::int32_t FacesAndCells::region_of(std::int64_t number) {
  if (number >= Limits::min() && number <= Limits::max()) return static_cast<std::int32_t>(number);
  if (left_out_.empty()) left_out_ = std::to_string(number) + " is beyond 32 bits";
  return 0;
}

std::int32_t FacesAndCells::region_of(double number) {
  const bool in_range = number >= Limits::min() && number <= Limits::max();
  if (in_range && static_cast<double>(static_cast<std::int32_t>(number)) == number)
    return static_cast<std::int32_t>(number);
  if (left_out_.empty()) {
    char text[32];
    left_out_.assign(text, std::to_chars(text, text + sizeof text, number).ptr);
    left_out_ += " is no integer of 32 bits";
  }
  return 0;
}

void FacesAndCells::translate_regions(std::span<const std::int32_t> table) {
  const auto translate = [&](Array<std::int32_t>& numbers, std::size_t count) {
    numbers.resize(table.empty() ? 0 : count);
    for (std::int32_t& number : numbers)
      number = table[static_cast<std::uint32_t>(number)];
  };
  translate(of_faces_, faces_.size());
  translate(of_tetrahedra_, mesh_.tetrahedra.size());
  translate(of_hexahedra_, mesh_.hexahedra.size());
  translate(of_others_, others_.size());
}

void FacesAndCells::finish(ReadReport& report) {
  report.polygons = faces_.larger_than_triangles();
  faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
  if (!others_.empty()) note_turned_cells(mesh_, report.notes, host_);
  const std::size_t tetrahedra = mesh_.tetrahedra.size(), hexahedra = mesh_.hexahedra.size();
  others_.cut_into_tetrahedra(mesh_, report.notes, host_);
  if (left_out_.empty())
    finish_regions(tetrahedra, hexahedra);
  else
    report.notes.push_back("region numbers were left out: " + left_out_);
}

// The numbers are those of cells before prisms, pyramids, and hexahedra beside them, were cut.
void FacesAndCells::finish_regions(std::size_t tetrahedra, std::size_t hexahedra) {
  Regions& regions = mesh_.regions;
  if (!of_faces_.empty()) {
    of_faces_.resize(faces_.size());
    regions.triangles.reserve(mesh_.triangles.size());
    append_repeated(
        of_faces_, [&](std::size_t i) { return static_cast<std::size_t>(faces_.triangles_of(i)); }, regions.triangles);
  }
  const bool any = !of_tetrahedra_.empty() || !of_hexahedra_.empty() || !of_others_.empty();
  of_tetrahedra_.resize(any ? tetrahedra : 0);
  of_hexahedra_.resize(any ? hexahedra : 0);
  of_others_.resize(any && !others_.empty() ? others_.size() - hexahedra : 0);
  if (others_.empty()) {
    regions.tetrahedra = std::move(of_tetrahedra_);
    regions.hexahedra = std::move(of_hexahedra_);
  } else if (any) {
    const auto made = others_.tetrahedra_of_cells();
    const std::size_t first = of_others_.size();
    regions.tetrahedra.reserve(mesh_.tetrahedra.size());
    append_repeated(
        of_tetrahedra_, [](std::size_t) { return std::size_t{1}; }, regions.tetrahedra);
    append_repeated(
        of_others_, [&](std::size_t i) { return std::size_t{made[i]}; }, regions.tetrahedra);
    append_repeated(
        of_hexahedra_, [&](std::size_t i) { return std::size_t{made[first + i]}; }, regions.tetrahedra);
  }
  clear_if_zero(regions.triangles);
  clear_if_zero(regions.tetrahedra);
  clear_if_zero(regions.hexahedra);
}

}  // namespace orbicube::mesh
