#include "hexmesh/captured/captured_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/search/bounding_volume_tree.h"

namespace orbicube::hexmesh {
namespace {

constexpr double near_part = 0.1;     // of the mean boundary edge
constexpr double max_degrees = 25;    // between a curve and the edge that follows it
constexpr double whole_curve = 0.95;  // captured of a curve that is not missing

class BoundaryEdges {
 public:
  BoundaryEdges(const HexMesh& mesh, const base::Host& host)
      : mesh_(mesh), edges_(edges_of(mesh, host.memory)), tree_(boxes_of_edges(host.memory), host) {
    double sum = 0;
    for (const mesh::Edge& e : edges_)
      sum += direction(e).norm();
    near_ = edges_.empty() ? 0 : near_part * sum / static_cast<double>(edges_.size());
  }

  double near() const { return near_; }

  bool has_edge(const Vector3& p, const Vector3& along) const {
    const double least = std::cos(max_degrees * std::numbers::pi / 180);
    bool found = false;
    tree_.for_each_within(p, near_ * near_, [&](Index e) {
      if (found) return;
      const Vector3 way = direction(edges_[e]);
      found = std::abs(way.dot(along)) > least * way.norm() && distance(e, p) <= near_;
    });
    return found;
  }

  bool has_vertex(const Vector3& p) const {
    bool found = false;
    tree_.for_each_within(p, near_ * near_, [&](Index e) {
      for (const Index v : edges_[e])
        found = found || (mesh_.positions[v] - p).norm() <= near_;
    });
    return found;
  }

 private:
  static Array<mesh::Edge> edges_of(const HexMesh& mesh, std::pmr::memory_resource* memory) {
    Array<mesh::Edge> edges(memory);
    for (const Quad& quad : mesh.quads) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Index a = quad[k], b = quad[(k + 1) % 4];
        if (a < b) edges.push_back({a, b});  // the other quad has it the other way
      }
    }
    return edges;
  }

  Array<mesh::Box> boxes_of_edges(std::pmr::memory_resource* memory) const {
    Array<mesh::Box> boxes(edges_.size(), mesh::Box(), memory);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (const Index v : edges_[i])
        boxes[i].add(mesh_.positions[v]);
    }
    return boxes;
  }

  Vector3 direction(const mesh::Edge& e) const { return mesh_.positions[e[1]] - mesh_.positions[e[0]]; }

  double distance(Index e, const Vector3& p) const {
    const Vector3 &from = mesh_.positions[edges_[e][0]], way = direction(edges_[e]);
    const double square = way.squaredNorm();
    const double t = square > 0 ? std::clamp(way.dot(p - from) / square, 0.0, 1.0) : 0;
    return (from + t * way - p).norm();
  }

  const HexMesh& mesh_;
  Array<mesh::Edge> edges_;
  mesh::BoundingVolumeTree tree_;
  double near_ = 0;
};

struct Length {
  double whole = 0, captured = 0;
};

// Samples an arc by points as far apart as an edge may be away.
Length length_of(const FeatureSurface& surface, const mesh::FeatureArc& arc, const BoundaryEdges& edges) {
  constexpr double max_samples = 10'000;  // of an edge of the surface
  const auto vertices = surface.graph.vertices_of(arc);
  Length length;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vector3 from = surface.positions[vertices[i - 1]], way = surface.positions[vertices[i]] - from;
    const double whole = way.norm();
    if (!(whole > 0)) continue;
    const double samples = std::clamp(std::ceil(whole / edges.near()), 1.0, max_samples);
    for (double k = 0.5; k < samples; ++k) {
      length.whole += whole / samples;
      if (edges.has_edge(from + k / samples * way, way / whole)) length.captured += whole / samples;
    }
  }
  return length;
}

}  // namespace

void measure_captured(const HexMesh& mesh, const FeatureSurface& surface, FeatureFigures& figures,
                      const base::Host& host) {
  const mesh::FeatureGraph& graph = surface.graph;
  const BoundaryEdges edges(mesh, host);
  figures.missing.clear();
  figures.curves = graph.arcs.size();
  figures.corners = 0;
  Length sum;
  for (Index a = 0; a < graph.arcs.size(); ++a) {
    host.report("features", a, graph.arcs.size());
    const Length length = length_of(surface, graph.arcs[a], edges);
    sum.whole += length.whole;
    sum.captured += length.captured;
    if (length.captured >= whole_curve * length.whole) continue;
    const auto v = graph.vertices_of(graph.arcs[a]);
    figures.missing.push_back(
        {false, a, surface.positions[v.front()], surface.positions[v.back()], length.captured / length.whole, {}});
  }
  figures.captured = sum.whole > 0 ? sum.captured / sum.whole : 1;
  for (Index c = 0; c < graph.corners.size(); ++c) {
    if (graph.corners[c].soft) continue;
    ++figures.corners;
    const Vector3& p = surface.positions[graph.corners[c].vertex];
    if (!edges.has_vertex(p)) figures.missing.push_back({true, c, p, p, 0, {}});
  }
}

}  // namespace orbicube::hexmesh
