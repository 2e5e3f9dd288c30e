// Cells by the numbers of vtkCellType.h, as legacy and XML files of VTK have them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "base/counted.h"
#include "mesh/files/faces_and_cells.h"
#include "mesh/files/read.h"

namespace orbicube::mesh {

// The names of what vtkCellType.h counts, for messages.
inline std::string vtk_cell_name(std::int64_t type) {
  static constexpr std::array names = {std::pair{21, "quadratic edge"},          std::pair{22, "quadratic triangle"},
                                       std::pair{23, "quadratic quad"},          std::pair{24, "quadratic tetrahedron"},
                                       std::pair{25, "quadratic hexahedron"},    std::pair{26, "quadratic wedge"},
                                       std::pair{27, "quadratic pyramid"},       std::pair{28, "biquadratic quad"},
                                       std::pair{29, "triquadratic hexahedron"}, std::pair{42, "polyhedron"},
                                       std::pair{69, "Lagrange triangle"},       std::pair{70, "Lagrange quad"},
                                       std::pair{71, "Lagrange tetrahedron"},    std::pair{72, "Lagrange hexahedron"},
                                       std::pair{73, "Lagrange wedge"},          std::pair{74, "Lagrange pyramid"}};
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& name) { return name.first == type; });
  return "type " + std::to_string(type) + (found == names.end() ? "" : std::string(" (") + found->second + ")");
}

class VtkCells {
 public:
  // Cells go to `mesh`, and points and lines to the tags of the report, if it has any. place.fail(kind, message) of the
  // functions below throws Error.
  VtkCells(Mesh& mesh, const base::Host& host, ReadReport& report) : report_(report), cells_(mesh, host) {}

  // Cells so far, of all kinds: data on cells has one number for each.
  std::size_t count() const { return count_; }
  // Points and lines that are cells, too, come before others.
  void add_tags(std::size_t cells) { count_ += cells; }
  // The regions of all cells, or none; before finish().
  void set_regions(std::span<const std::int32_t> regions) { cells_.translate_regions(regions); }
  std::int32_t region_of(std::int64_t number) { return cells_.region_of(number); }
  std::int32_t region_of(double number) { return cells_.region_of(number); }
  void leave_out_regions(std::string why) { cells_.leave_out_regions(std::move(why)); }

  // Returns false for points and lines that are passed over. The numbers are those of vtkCellType.h.
  template <class Place>
  bool add(std::int64_t cell_type, std::span<const Index> c, std::uint64_t number, const Place& place) {
    ++count_;
    // An empty cell; a vertex, vertices, a line, lines; curved lines.
    constexpr std::array<std::int64_t, 8> no_faces{0, 1, 2, 3, 4, 21, 35, 68};
    if (std::ranges::find(no_faces, cell_type) != no_faces.end()) return add_tag(cell_type, c);
    if (cell_type >= 5 && cell_type <= 9)
      add_face(cell_type, c, number, place);
    else if (cell_type >= 10 && cell_type <= 16)
      add_solid_cell(cell_type, c, number, place);
    else if (unread_.size() < 32 || unread_.contains(cell_type))
      ++unread_[cell_type];
    return true;
  }

  // Returns whether points and straight lines are kept as tags.
  bool add_tag(std::int64_t cell_type, std::span<const Index> c) {
    if (!report_.tags) return false;
    if (cell_type == 1 || cell_type == 2)
      report_.tags->vertices.insert(report_.tags->vertices.end(), c.begin(), c.end());
    if (cell_type == 3 || cell_type == 4) report_.tags->add_line(c);
    return cell_type <= 4;
  }

  void add_strip(std::span<const Index> cell) {
    ++count_;
    put_strip(cell);
  }

  template <class Place>
  void add_polygon(std::span<const Index> cell, const Place& place) {
    ++count_;
    cells_.add_face(cell, number(), place);
  }

  void pass_over(std::size_t count, const char* one, const char* many) {
    passed_over_.append(passed_over_.empty() ? "" : ", ").append(base::counted(count, one, many));
  }

  // After the last cell: triangles of polygons, tetrahedra of prisms and pyramids, notes.
  template <class Place>
  void finish(const Place& place) {
    refuse_unread_cells(place);
    cells_.finish(report_);
    if (!passed_over_.empty()) report_.notes.push_back("passed over: " + passed_over_);
  }

 private:
  // That of the cell added last; regions are looked up by it.
  std::int32_t number() const { return static_cast<std::int32_t>(static_cast<std::uint32_t>(count_ - 1)); }

  void put_strip(std::span<const Index> cell) {
    for (std::size_t i = 2; i < cell.size(); ++i) {
      const bool even = i % 2 == 0;
      cells_.add_triangle({cell[even ? i - 2 : i - 1], cell[even ? i - 1 : i - 2], cell[i]}, number());
    }
  }

  // Leaving cells out would leave a hole.
  template <class Place>
  void refuse_unread_cells(const Place& place) const {
    if (unread_.empty()) return;
    std::string text;
    for (const auto& [type, count] : unread_) {
      text.append(text.empty() ? "" : ", ").append(std::to_string(count)).append(" of ").append(vtk_cell_name(type));
    }
    place.fail("unsupported",
               "cells that are not read: " + text + "; without them a part of the shape would be missing");
  }

  template <class Place>
  void require_corners(std::size_t corners, std::span<const Index> c, std::uint64_t number, const Place& place) {
    if (c.size() != corners) {
      place.fail("parse", "cell " + std::to_string(number) + " has " + base::counted(c.size(), "corner") +
                              ", where its type has " + std::to_string(corners));
    }
  }

  // Triangle, strip of triangles, polygon, pixel (a square by rows) or quadrilateral.
  template <class Place>
  void add_face(std::int64_t cell_type, std::span<const Index> c, std::uint64_t which, const Place& place) {
    if (cell_type == 6) {
      put_strip(c);
      return;
    }
    if (cell_type != 7) require_corners(cell_type == 5 ? 3 : 4, c, which, place);
    if (cell_type == 8)
      cells_.add_face(std::array{c[0], c[1], c[3], c[2]}, number(), place);
    else
      cells_.add_face(c, number(), place);
  }

  template <class Place>
  void add_solid_cell(std::int64_t cell_type, std::span<const Index> c, std::uint64_t which, const Place& place) {
    const auto add_other = [&](Polyhedron kind) {
      require_corners(corner_count(kind), c, which, place);
      cells_.add(kind, c, number());
    };
    switch (cell_type) {
      case 10:
        require_corners(4, c, which, place);
        cells_.add(Tetrahedron{c[0], c[1], c[2], c[3]}, number());
        break;
      case 11:  // voxel: a box by rows
        require_corners(8, c, which, place);
        cells_.add(Hexahedron{c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]}, number());
        break;
      case 12:
        require_corners(8, c, which, place);
        cells_.add(Hexahedron{c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]}, number());
        break;
      case 13:
        add_other(Polyhedron::prism);
        break;
      case 14:
        add_other(Polyhedron::pyramid);
        break;
      case 15:
        add_other(Polyhedron::pentagonal_prism);
        break;
      default:
        add_other(Polyhedron::hexagonal_prism);
    }
  }

  ReadReport& report_;
  FacesAndCells cells_;
  std::size_t count_ = 0;
  std::map<std::int64_t, std::size_t> unread_;  // cells of each type that is not read
  std::string passed_over_;
};

}  // namespace orbicube::mesh
