// Curves of a surface that are left out of its feature graph so that the rest of it has a mesh, and why.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hexmesh/captured/feature_surface.h"

namespace orbicube::hexmesh {

class LeftOutFeatures {
 public:
  explicit LeftOutFeatures(std::pmr::memory_resource* memory) : edges_(memory) {}

  // Adds arcs in the way of a mesh. With one go the arcs shorter than `small` that it is joined to by such arcs, since
  // a small hole without a part of its rim has no mesh either; in place of a longer one, those alone, if there are
  // some.
  void add(const FeatureSurface& surface, std::span<const Index> arcs, double small, const std::string& why,
           const base::Host& host);
  // Adds what a graph of the same surface lost against another one.
  void add_lost(const mesh::FeatureGraph& before, const mesh::FeatureGraph& after, const std::string& why);

  std::span<const mesh::Edge> edges() const { return edges_; }
  // Returns the reason for the edge between two vertices of the surface; nothing: it is not left out.
  const std::string* why(Index from, Index to) const;

 private:
  void add(const mesh::FeatureGraph& graph, Index arc, std::size_t reason);

  Array<mesh::Edge> edges_;           // of the surface, with the lower vertex first
  std::vector<std::size_t> reasons_;  // of each edge
  std::vector<std::string> texts_;
};

// Returns the length of an arc of the graph.
double length_of(const FeatureSurface& surface, Index arc);

}  // namespace orbicube::hexmesh
