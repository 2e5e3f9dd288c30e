// The surroundings of a corner of the polycube in a map, or of a point on an edge of it: a disk of triangles, unfolded.
//
// Around a corner the polycube is a cone: its faces make 3 quarter turns, or 5, or more, and are flat otherwise. So
// what lies around the corner unfolds into the plane, with the corner at the origin; what comes after the last quarter
// is what comes before the first, turned by whole quarters. Edges of the polycube that leave the corner are rays there,
// and distortion does not see them: triangles may lie across.
#pragma once

#include <span>

#include "base/heap.h"
#include "base/host.h"
#include "polycube/surface/editable_surface.h"
#include "polycube/surface/quarter_turns.h"

namespace orbicube::polycube {

// A map that is being changed.
struct WorkingMap {
  WorkingMap(const SurfaceMap& map, const base::Host& host);
  // The map of what is there; vertices of the input first.
  SurfaceMap result(const base::Host& host) const;

  bool on_edge(Index h) const { return facet[h / 3] != facet[surface.opposite(h) / 3]; }
  // How many edges of the polycube's patches are at a vertex: 2 on an edge, 3 or more at a corner.
  int edges_at(Index v) const;

  EditableSurface surface;
  Array<AxisLabel> label;  // of each triangle
  Array<Index> facet;      // of each triangle: the patch of the polycube
  Array<Vector3> image;    // of each vertex, on the polycube
  double scale = 1;        // of lengths in space, for equal areas
  double area = 1;         // of the polycube
};

struct CornerSector {
  AxisLabel label;
  Index facet;
  int begin, quarters;  // from which quarter on, and how many
  int turn;             // from the plane of the face to the unfolded plane, in quarters
};

struct CornerRegion {
  explicit CornerRegion(std::pmr::memory_resource* memory)
      : vertices(memory),
        faces(memory),
        triangles(memory),
        space(memory),
        cone(memory),
        angle(memory),
        flat(memory),
        sectors(memory) {}

  double whole_turn() const;  // in radians
  // On the polycube, from unfolded coordinates in a sector.
  Vector3 fold(const Vector2d& p, const CornerSector& sector) const;
  // Into a disk, around the whole turn once: angles in proportion, radii so that small circles stay circles.
  Vector2d flatten(double radius, double angle) const;

  Index corner() const { return vertices[0]; }
  std::size_t inside = 0;     // vertices that may move, the first; the others bound the region
  Array<Index> vertices;      // of the surface
  Array<Index> faces;         // of the surface
  Array<Triangle> triangles;  // numbers in `vertices`
  Array<Vector3> space;       // of each vertex, at the scale of the polycube
  Array<Vector2d> cone;       // of each vertex: unfolded, the corner at the origin
  Array<double> angle;        // of each vertex, from 0 up to the whole turn
  Array<Vector2d> flat;       // of each vertex: flatten()ed
  Array<CornerSector> sectors;
  int quarters = 0;
  double radius = 0;  // of the largest circle about the corner without a vertex of the boundary; 1 in `flat`
  Vector3 apex;
};

// Finds regions in a map, as it is at each call.
class RegionFinder {
 public:
  // Keeps references.
  RegionFinder(const WorkingMap& map, const base::Host& host);

  Array<Index> corners() const;
  // Vertices nearest to the middles of the polycube's edges, where there are any between the corners.
  Array<Index> edge_middles() const;

  // The given number of nearest vertices around one of these that may move, or fewer where they would not be a disk;
  // false when there is no room at all.
  bool find(Index centre, std::size_t max_vertices, CornerRegion& region);

  // Disjoint regions of the corners that have room, each vertex in that of the corner that is nearest.
  Array<CornerRegion> find_disjoint(std::size_t max_vertices);

 private:
  struct Waiting {
    double distance;
    Index vertex, corner;
  };
  struct Farther {
    bool operator()(const Waiting& a, const Waiting& b) const;
  };
  bool find_sectors(Index centre, CornerRegion& region) const;
  bool may_move(Index v, const CornerRegion& region) const;
  bool gather(std::span<const Index> candidates, CornerRegion& region);
  bool gather_stars(std::span<const Index> candidates, CornerRegion& region);
  bool unfold(CornerRegion& region) const;

  const WorkingMap& map_;
  const base::Host& host_;
  Array<Index> nearest_;     // corner of each vertex
  Array<Index> place_;       // of each vertex, in the region that is made
  Array<double> distance_;   // of each vertex, to where the search began
  Array<Index> touched_;     // vertices with a distance
  Array<Index> candidates_;  // the nearest first
  base::Heap<Waiting, Farther> heap_;
};

}  // namespace orbicube::polycube
