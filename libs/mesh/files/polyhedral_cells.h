// Cells that a mesh does not hold: pyramids and prisms. They are cut into tetrahedra that meet those of their
// neighbors (Dompierre, Labbe, Vallet and Camarero 1999).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Corners are in the order of hexahedra: a face counter-clockwise seen from inside, then the corners above it.
enum class Polyhedron : std::uint8_t { pyramid, prism, pentagonal_prism, hexagonal_prism, hexahedron };

std::size_t corner_count(Polyhedron kind);

class PolyhedralCells {
 public:
  explicit PolyhedralCells(std::pmr::memory_resource* memory) : kinds_(memory), corners_(memory), made_(memory) {}

  bool empty() const { return kinds_.empty(); }
  std::size_t size() const { return kinds_.size(); }
  // `corners` has corner_count(kind) vertices of the mesh.
  void add(Polyhedron kind, std::span<const Index> corners);

  // Cuts these cells, and all hexahedra of the mesh, whose faces would not match otherwise, into tetrahedra of the
  // mesh; does nothing if there are no cells. Each polygon is cut by the diagonals from its lowest vertex and each cell
  // by those from its lowest one; where a tetrahedron of that is not positive but all around the cell's center are, by
  // that, which is added behind the other vertices. Kinds whose cells are all inverted are turned: formats and programs
  // do not agree about the order of prisms. Adds a note of what was cut. Throws Error "unsupported" for more vertices
  // than 32 bits can count, "cancelled". O(n).
  void cut_into_tetrahedra(Mesh& mesh, std::vector<std::string>& notes, const base::Host& host);
  // After that: the number of tetrahedra of each cell, the hexahedra of the mesh being the last cells.
  std::span<const std::uint8_t> tetrahedra_of_cells() const { return made_; }

 private:
  Array<Polyhedron> kinds_;
  Array<Index> corners_;
  Array<std::uint8_t> made_;
};

}  // namespace orbicube::mesh
