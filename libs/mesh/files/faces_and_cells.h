// Faces and cells as files of solids have them, with the numbers of their regions, on the way to a mesh: polygons
// become triangles, prisms and pyramids tetrahedra, and these keep the numbers of what they are made from.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/host.h"
#include "mesh/files/polygons.h"
#include "mesh/files/polyhedral_cells.h"
#include "mesh/files/read.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

class FacesAndCells {
 public:
  FacesAndCells(Mesh& mesh, const base::Host& host)
      : mesh_(mesh),
        host_(host),
        faces_(host.memory),
        others_(host.memory),
        of_faces_(host.memory),
        of_tetrahedra_(host.memory),
        of_hexahedra_(host.memory),
        of_others_(host.memory) {}

  // `region` may be another number that translate_regions() turns into a region's. `place` as for Polygons::add.
  template <class Place>
  void add_face(std::span<const Index> corners, std::int32_t region, const Place& place) {
    put(region, faces_.size(), of_faces_);
    faces_.add(corners, place);
  }
  void add_triangle(const Triangle& t, std::int32_t region) {
    put(region, faces_.size(), of_faces_);
    faces_.add_triangle(t[0], t[1], t[2]);
  }
  void add(const Tetrahedron& t, std::int32_t region) {
    put(region, mesh_.tetrahedra.size(), of_tetrahedra_);
    mesh_.tetrahedra.push_back(t);
  }
  void add(const Hexahedron& h, std::int32_t region) {
    put(region, mesh_.hexahedra.size(), of_hexahedra_);
    mesh_.hexahedra.push_back(h);
  }
  void add(Polyhedron kind, std::span<const Index> corners, std::int32_t region) {
    put(region, others_.size(), of_others_);
    others_.add(kind, corners);
  }

  std::size_t face_count() const { return faces_.size(); }

  // Returns a number of the file as that of a region. Where 32 bits do not hold it, finish() leaves all regions out.
  std::int32_t region_of(std::int64_t number);
  // The same; some programs write real numbers.
  std::int32_t region_of(double number);

  // Before finish(): replaces each number by that at its place in a table. An empty table removes all numbers.
  void translate_regions(std::span<const std::int32_t> table);
  void leave_out_regions(std::string why) { left_out_ = std::move(why); }

  // After the last one, when the positions are in the mesh: fills its triangles, its other cells and its regions, and
  // the notes and the number of polygons of the report. Kinds whose regions are all 0 have none.
  void finish(ReadReport& report);

 private:
  // Lists begin with the first number that is not 0, since most files have none.
  static void put(std::int32_t region, std::size_t place, Array<std::int32_t>& regions) {
    if (region == 0 && regions.empty()) return;
    regions.resize(place);
    regions.push_back(region);
  }
  void finish_regions(std::size_t tetrahedra, std::size_t hexahedra);

  Mesh& mesh_;
  const base::Host& host_;
  Polygons faces_;
  PolyhedralCells others_;
  Array<std::int32_t> of_faces_, of_tetrahedra_, of_hexahedra_, of_others_;
  std::string left_out_;  // why there are no regions
};

}  // namespace orbicube::mesh
