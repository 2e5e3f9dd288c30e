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
#include "mesh/files/polygons.h"
#include "mesh/files/polyhedral_cells.h"
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
  VtkCells(Mesh& mesh, const base::Host& host, ReadReport& report)
      : mesh_(mesh), host_(host), report_(report), faces_(host.memory), others_(host.memory) {}

  // Returns false for points and lines that are passed over. The numbers are those of vtkCellType.h.
  template <class Place>
  bool add(std::int64_t cell_type, std::span<const Index> c, std::uint64_t number, const Place& place) {
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
    for (std::size_t i = 2; i < cell.size(); ++i) {
      const bool even = i % 2 == 0;
      faces_.add_triangle(cell[even ? i - 2 : i - 1], cell[even ? i - 1 : i - 2], cell[i]);
    }
  }

  template <class Place>
  void add_polygon(std::span<const Index> cell, const Place& place) {
    faces_.add(cell, place);
  }

  void pass_over(std::size_t count, const char* one, const char* many) {
    passed_over_.append(passed_over_.empty() ? "" : ", ").append(base::counted(count, one, many));
  }

  // After the last cell: triangles of polygons, tetrahedra of prisms and pyramids, notes.
  template <class Place>
  void finish(const Place& place) {
    refuse_unread_cells(place);
    report_.polygons = faces_.larger_than_triangles();
    faces_.to_triangles(mesh_.positions, mesh_.triangles, host_);
    if (!others_.empty()) note_turned_cells(mesh_, report_.notes, host_);
    others_.cut_into_tetrahedra(mesh_, report_.notes, host_);
    if (!passed_over_.empty()) report_.notes.push_back("passed over: " + passed_over_);
  }

 private:
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
  void add_face(std::int64_t cell_type, std::span<const Index> c, std::uint64_t number, const Place& place) {
    if (cell_type == 6) {
      add_strip(c);
      return;
    }
    if (cell_type != 7) require_corners(cell_type == 5 ? 3 : 4, c, number, place);
    if (cell_type == 8)
      faces_.add(std::array{c[0], c[1], c[3], c[2]}, place);
    else
      faces_.add(c, place);
  }

  template <class Place>
  void add_solid_cell(std::int64_t cell_type, std::span<const Index> c, std::uint64_t number, const Place& place) {
    const auto add_other = [&](Polyhedron kind) {
      require_corners(corner_count(kind), c, number, place);
      others_.add(kind, c);
    };
    switch (cell_type) {
      case 10:
        require_corners(4, c, number, place);
        mesh_.tetrahedra.push_back({c[0], c[1], c[2], c[3]});
        break;
      case 11:  // voxel: a box by rows
        require_corners(8, c, number, place);
        mesh_.hexahedra.push_back({c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]});
        break;
      case 12:
        require_corners(8, c, number, place);
        mesh_.hexahedra.push_back({c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]});
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

  Mesh& mesh_;
  const base::Host& host_;
  ReadReport& report_;
  Polygons faces_;
  PolyhedralCells others_;
  std::map<std::int64_t, std::size_t> unread_;  // cells of each type that is not read
  std::string passed_over_;
};

}  // namespace orbicube::mesh
