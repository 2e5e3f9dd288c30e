// Where the regions of a solid of tetrahedra meet: faces between two, curves between three, points between more, the
// outside being one of them.
#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "hexmesh/types.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/topology.h"

namespace orbicube::hexmesh {

// Ascending. 0 is the outside; regions have the labels 1, 2 and so on, in the order of their numbers.
using LabelSet = std::vector<Index>;

class RegionInterfaces {
 public:
  // Keeps views. `regions` has the number of each tetrahedron.
  RegionInterfaces(std::span<const Vector3> positions, std::span<const mesh::Tetrahedron> tetrahedra,
                   std::span<const std::int32_t> regions, const base::Host& host);

  // Whether two regions share a face.
  bool any() const { return any_; }
  // Whether two labels share a face.
  bool meet(Index a, Index b) const { return a == b || faces_.contains({std::min(a, b), std::max(a, b)}); }
  std::span<const std::int32_t> numbers() const { return numbers_; }  // of the labels 1, 2, ...
  Index label_of(std::int32_t number) const;
  // The faces between regions, each once.
  std::span<const mesh::Triangle> between_regions() const { return between_; }
  std::span<const Vector3> positions() const { return positions_; }

  struct Place {
    Vector3 position = Vector3::Zero();
    Vector3 direction = Vector3::Zero();  // normal of a face, or tangent of a curve
    int dimension = 0;                    // 2: of a face, 1: of a curve, 0: of a point
    bool found = false;
  };
  // The nearest point at which all of these labels meet, of faces that do not look against `facing` where only two
  // meet and it is not 0; where no point is on all of that many, the nearest of a curve of three of them.
  Place nearest(const LabelSet& labels, const Vector3& p, const Vector3& facing);
  // The nearest point of a sharp edge within the faces between two regions.
  Place nearest_on_crease(const LabelSet& labels, const Vector3& p);
  // Whether there are creases or corners, and creases are so far from each other that a mesh with edges of this length
  // can have edges along them: not those of steps of a segmented image.
  bool has_clear_creases(double edge) const;
  // Ends, branches and bends of sharp edges between two labels and of curves of three, with all labels around.
  struct Corner {
    Index vertex;
    LabelSet labels;
  };
  std::span<const Corner> corners() const { return corners_; }
  // The vertices at which all of these labels meet, at most `radius` away.
  void vertices_near(const LabelSet& labels, const Vector3& p, double radius, Array<Vector3>& found) const;

 private:
  struct Stratum {
    Stratum(std::span<const Vector3> positions, Array<mesh::Triangle> t, int d, const base::Host& host)
        : triangles(std::move(t)), search(positions, triangles, host), dimension(d) {}

    Array<mesh::Triangle> triangles;  // segments and points are flat ones
    mesh::SurfaceSearch search;
    int dimension;
  };

  void collect_faces(std::span<const mesh::Tetrahedron> tetrahedra, const Array<Index>& label);
  void collect_curves(std::span<const mesh::Tetrahedron> tetrahedra, const Array<Index>& label);
  void collect_creases();
  void collect_corners();
  const Stratum& stratum(const LabelSet& labels);
  Array<mesh::Triangle> triangles_of(const LabelSet& labels, int& dimension) const;

  std::span<const Vector3> positions_;
  const base::Host& host_;
  Array<std::int32_t> numbers_;
  Array<mesh::Triangle> between_;
  bool any_ = false;
  std::map<LabelSet, Array<mesh::Triangle>> faces_;  // of two labels; looking out of the greater one
  std::map<LabelSet, Array<mesh::Edge>> curves_;     // of three and more
  std::map<LabelSet, Array<Index>> points_;          // of three and more
  std::map<LabelSet, Array<mesh::Edge>> creases_;    // of two
  std::vector<Corner> corners_;
  std::map<LabelSet, Stratum> strata_, strata_of_creases_;
};

}  // namespace orbicube::hexmesh
