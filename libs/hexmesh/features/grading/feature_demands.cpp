#include "hexmesh/features/grading/feature_demands.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace orbicube::hexmesh {
namespace {

// Of an arc, in radians a cell. Edges of the mesh are chords of it, about twice as long on the outer side of a bend of
// few cells, where a layer is around. Twice this is still less than the 25 degrees with which a curve counts as
// captured, and its chords are within a tenth of an edge.
constexpr double max_turning = 0.35;

bool meet(const mesh::FeatureArc& a, const mesh::FeatureArc& b) {
  return std::any_of(a.corners.begin(), a.corners.end(),
                     [&](Index c) { return c == b.corners[0] || c == b.corners[1]; });
}

}  // namespace

FeatureDemands::FeatureDemands(const FeatureShape& shape, double reach, double straight, const base::Host& host)
    : shape_(shape), demands_(host.memory) {
  const auto& graph = shape.graph();
  Array<std::pair<Vector3, Vector3>> boxes(host.memory);
  for (const mesh::FeatureArc& arc : graph.arcs) {
    Vector3 low = shape.positions()[graph.vertices[arc.begin]], high = low;
    for (const Index v : graph.vertices_of(arc)) {
      low = low.cwiseMin(shape.positions()[v]);
      high = high.cwiseMax(shape.positions()[v]);
    }
    boxes.push_back({low, high});
  }
  for (Index a = 0; a < graph.arcs.size(); ++a) {
    add_arc(a);
    add_turns(a, straight);
    for (Index b = 0; b < graph.arcs.size(); ++b) {
      host.report("features", 0, 0);
      if (a == b || meet(graph.arcs[a], graph.arcs[b])) continue;
      const Vector3 between = (boxes[a].first - boxes[b].second).cwiseMax(boxes[b].first - boxes[a].second).cwiseMax(0);
      if (between.norm() < reach) add_gaps(a, b, reach);
    }
  }
}

void FeatureDemands::add_arc(Index arc) {
  const auto v = shape_.graph().vertices_of(shape_.graph().arcs[arc]);
  const double length = shape_.length(arc);
  for (std::size_t i = 1; i < v.size(); ++i)
    demands_.push_back({shape_.positions()[v[i - 1]], shape_.positions()[v[i]], length, arc, arc, length});
}

void FeatureDemands::add_turns(Index arc, double straight) {
  const double length = shape_.length(arc), window = std::min(straight, length / 2);
  const auto places = static_cast<int>(std::ceil(4 * length / window));
  for (int i = 1; i < places; ++i) {
    const double s = std::clamp(length * i / places, window / 2, length - window / 2);
    const double turning = 2 * shape_.turning(arc, s, window), size = window * max_turning / turning;
    if (size >= straight) continue;
    demands_.push_back({shape_.point(arc, s - window / 4), shape_.point(arc, s + window / 4), length, arc, arc, size});
  }
}

// From the vertices of an arc to the nearest points of another.
void FeatureDemands::add_gaps(Index arc, Index other, double reach) {
  for (const Index v : shape_.graph().vertices_of(shape_.graph().arcs[arc])) {
    const Vector3& from = shape_.positions()[v];
    const FeatureShape::ArcPoint to = shape_.nearest_on_arc(other, from);
    if (to.distance < reach) demands_.push_back({from, to.position, to.distance, arc, other, reach});
  }
}

void FeatureDemands::refine(std::span<const double> strength, double wider, AxisGrading& grading) const {
  for (const Demand& d : demands_)
    grading.refine(d.from, d.to, std::min(wider * d.max_size, d.size / std::max(strength[d.arc], strength[d.other])));
  grading.spread();
}

}  // namespace orbicube::hexmesh
