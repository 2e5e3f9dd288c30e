// The feature graph of a closed surface: corners, arcs between them, and the patches that they bound. What a mesh of
// the solid keeps when it keeps its sharp edges.
#pragma once

#include <span>

#include "base/grouping.h"
#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/topology.h"

namespace orbicube::mesh {

struct FeatureCorner {
  Index vertex = no_index;
  bool soft = false;  // only cuts a closed or a long arc; nothing is sharp there but the arc itself
};

struct FeatureArc {
  std::array<Index, 2> corners{};  // at its two ends
  std::array<Index, 2> patches{};  // on its left and on its right, seen from outside
  Index begin = 0, end = 0;        // its vertices in FeatureGraph::vertices, those of its corners included
};

// An arc at a corner, and which of its ends is there.
struct FeatureEnd {
  Index arc = 0;
  Index end = 0;  // 0 or 1
};

struct FeatureGraph {
  explicit FeatureGraph(std::pmr::memory_resource* memory)
      : corners(memory),
        arcs(memory),
        vertices(memory),
        fades(memory),
        bends(memory),
        around(memory),
        patches(memory),
        euler(memory),
        left_out(memory) {}

  Array<FeatureCorner> corners;
  Array<FeatureArc> arcs;
  Array<Index> vertices;                   // of all arcs
  Array<Index> fades;                      // vertices of the surface at which a sharp line goes on along weaker edges
  Array<Index> bends;                      // vertices of the surface at which lines bend without a corner
  base::Groups<FeatureEnd, Index> around;  // of each corner, counter-clockwise seen from outside
  Array<Index> patches;                    // of each triangle
  Array<std::int64_t> euler;               // Euler characteristic of each patch, its border included
  Array<Array<Index>> left_out;            // the vertices along each line of sharp edges that no arc has
  std::size_t sharp_edges = 0;             // of the surface
  double sharp_length = 0;                 // of these, without repairs
  std::size_t continued = 0, cut_sectors = 0;  // repairs

  std::span<const Index> vertices_of(const FeatureArc& arc) const {
    return std::span(vertices).subspan(arc.begin, arc.end - arc.begin);
  }
};

struct FeatureOptions {
  double angle = 40;                    // minimum dihedral angle of sharp edges, in degrees; also of bends at corners
  bool sharp = true;                    // whether sharp edges are features
  std::span<const Edge> edges = {};     // features whatever their angle
  std::span<const Edge> lines = {};     // that repairs follow, such as the curves of a CAD model
  bool weak_lines = false;              // lines at which the surface turns more than beside them are features, too
  std::span<const Edge> without = {};   // none of the features, nor what is then left to end inside a patch
  std::span<const Index> corners = {};  // vertices that are corners whatever meets there
  double shortest_side = 0;             // where a line only bends, a corner has such lengths to the next on both sides
};

// Finds sharp edges and joins them to arcs. Lines that end inside a patch are continued, along edges of half the angle
// and `lines` first; those up to a fortieth of the diagonal that are none of `lines` are left out. Sectors of more than
// 300 degrees are cut, closed arcs get three soft corners, and arcs longer than 1.8 times their chord are halved. Edges
// and corners of the options that are none of the surface are left out. Throws Error as Connectivity does,
// "not-closed", "cancelled". O(n log n).
FeatureGraph feature_graph(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const FeatureOptions& options, const base::Host& host);

}  // namespace orbicube::mesh
