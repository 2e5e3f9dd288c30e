// Feature lines of a surface: the edges that a mesh of the solid is to keep.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/connectivity.h"

namespace orbicube::mesh {

// A set of edges of a closed surface, walked around vertices.
class FeatureLines {
 public:
  // Keeps views of both.
  FeatureLines(std::span<const Vector3> positions, const Connectivity& connectivity, std::size_t triangles,
               const base::Host& host);

  // Adds the edges whose two triangles turn by at least `angle` degrees.
  void add_sharp(double angle, std::span<const Triangle> triangles);
  // Adds the edge of a half-edge.
  void add(Index half_edge) {
    marked_[half_edge] = 1;
    marked_[connectivity_->opposite(half_edge)] = 1;
  }
  // Returns the half-edge from one vertex to another; no_index where no edge joins them.
  Index find(Index from, Index to) const;

  bool contains(Index half_edge) const { return marked_[half_edge] != 0; }
  // Returns the number of feature edges at a vertex.
  std::size_t degree(Index vertex) const;
  // Returns the angle, in degrees, between the two feature edges at a vertex of degree 2: 180 for a straight line.
  double angle_at(Index vertex) const;
  // Whether feature lines end, branch or bend by more than `angle` degrees there.
  bool is_corner(Index vertex, double angle) const;
  // Follows the line of a half-edge to the next vertex of another degree than 2 or back to its start; calls
  // visit(half_edge) for each edge.
  template <class Visit>
  void follow(Index half_edge, const Visit& visit) const {
    const Index start = connectivity_->start(half_edge);
    for (Index h = half_edge; h != no_index;) {
      visit(h);
      const Index at = connectivity_->end(h);
      if (at == start || degree(at) != 2) return;
      const Index back = connectivity_->opposite(h);
      h = no_index;
      for_each(at, [&](Index next) {
        if (next != back) h = next;
      });
    }
  }
  // Calls visit(half_edge) for each feature edge out of a vertex, counter-clockwise seen from outside.
  template <class Visit>
  void for_each(Index vertex, const Visit& visit) const {
    connectivity_->for_each_outgoing(vertex, [&](Index h) {
      if (marked_[h] != 0) visit(h);
    });
  }

  std::span<const Vector3> positions() const { return positions_; }
  // Removes the edge of a half-edge.
  void remove(Index half_edge) {
    marked_[half_edge] = 0;
    marked_[connectivity_->opposite(half_edge)] = 0;
  }

  const Connectivity& connectivity() const { return *connectivity_; }

 private:
  std::span<const Vector3> positions_;
  const Connectivity* connectivity_;
  const base::Host* host_;
  Array<std::uint8_t> marked_;  // of each half-edge
};

// Returns the unit normal of a triangle; zero where it has none.
Vector3 triangle_normal(std::span<const Vector3> positions, const Triangle& triangle);

// Returns the angle between two directions in degrees.
double degrees_between(const Vector3& a, const Vector3& b);

}  // namespace orbicube::mesh
