// What keeps a field from being that of a hexahedral mesh (meshability.h), counted, and the parts of the mesh around
// it, so that a change can be judged place by place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/host.h"
#include "frame_field/singularities/singularities.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::frame_field {

struct Faults {
  std::size_t edges = 0;      // that are no quarter turns about an axis
  std::size_t vertices = 0;   // inner ones with singular edges as in no hexahedral mesh
  std::size_t fragments = 0;  // closed curves of at most six edges, and curves of one edge

  std::size_t unmeshable() const { return edges + vertices; }
  bool operator<(const Faults& o) const {
    return unmeshable() != o.unmeshable() ? unmeshable() < o.unmeshable() : fragments < o.fragments;
  }
};

// A field's matchings and singular edges, and where its faults are.
struct Structure {
  explicit Structure(std::pmr::memory_resource* memory)
      : matchings(memory), graph(memory), vertices(memory), places(memory) {}

  Array<std::uint8_t> matchings;
  SingularGraph graph;
  Faults faults;
  Array<Index> vertices;  // of everything that is wrong
  struct Place {
    Index vertex;
    std::int32_t unmeshable, fragments;
  };
  Array<Place> places;  // one a fault
};

class FaultFinder {
 public:
  // Positions and connectivity must outlive it. 40 bytes a tetrahedron.
  FaultFinder(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
              const base::Host& host);

  // O(n).
  Structure find(std::span<const Quaternion> field) const;

  // Tetrahedra within the given number of rings of the vertices are 1, others 0.
  Array<std::uint8_t> around(std::span<const Index> vertices, std::uint32_t rings) const;

  const mesh::EdgeRings& rings() const { return rings_; }
  std::span<const std::uint8_t> boundary_vertices() const { return boundary_; }

 private:
  std::span<const Vector3> positions_;
  const mesh::TetrahedralConnectivity& connectivity_;
  const base::Host& host_;
  const mesh::EdgeRings rings_;
  const Array<std::uint8_t> boundary_;
};

// Marked tetrahedra in parts that share no vertex. Every edge with a marked tetrahedron around it has both ends in one
// part, so faults of different parts do not depend on each other.
class Parts {
 public:
  Parts(const mesh::TetrahedralConnectivity& connectivity, std::span<const std::uint8_t> marked,
        const base::Host& host);

  struct Change {
    std::int32_t unmeshable = 0, fragments = 0;
    double energy = 0;
    bool fewer() const { return unmeshable < 0 || (unmeshable == 0 && fragments < 0); }
    bool more() const { return unmeshable > 0 || (unmeshable == 0 && fragments > 0); }
  };
  // Of the part that a vertex is in.
  Change& at(Index vertex) { return change_[sets_.find(vertex)]; }
  void count(const Structure& before, const Structure& after);

 private:
  mesh::DisjointSets sets_;
  Array<Change> change_;
};

}  // namespace orbicube::frame_field
