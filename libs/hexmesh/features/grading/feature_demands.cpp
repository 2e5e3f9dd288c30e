#include "hexmesh/features/grading/feature_demands.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

// Of an arc that bends without corners: for each of its straight parts.
void FeatureDemands::add_arc(Index arc) {
  constexpr double at_bends = 0.7;  // of the strength: one cell is enough where paths do not branch
  const auto v = shape_.graph().vertices_of(shape_.graph().arcs[arc]);
  const auto bends = shape_.bends(arc);
  const double length = shape_.length(arc);
  if (!(length > 0)) return;  // no cell is small enough
  double from = 0, at = 0;
  std::size_t next = 0;
  const auto end_of_part = [&] { return next < bends.size() ? bends[next] : length; };
  for (std::size_t i = 1; i < v.size(); ++i) {
    const Vector3 &a = shape_.positions()[v[i - 1]], &b = shape_.positions()[v[i]];
    const double part = end_of_part() - from;
    demands_.push_back({a, b, bends.empty() ? part : part / at_bends, arc, arc, length});
    at += (b - a).norm();
    if (next < bends.size() && at >= bends[next]) from = bends[next++];
  }
}

void FeatureDemands::add_turns(Index arc, double straight) {
  const double length = shape_.length(arc), window = std::min(straight, length / 2);
  if (!(window > 0)) return;
  const auto places = static_cast<int>(std::ceil(4 * length / window));
  for (int i = 1; i < places; ++i) {
    const double s = std::clamp(length * i / places, window / 2, length - window / 2);
    const auto bends = shape_.bends(arc);
    if (std::any_of(bends.begin(), bends.end(), [&](double b) { return std::abs(b - s) < window / 2; })) continue;
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
    if (to.distance > 0 && to.distance < reach) demands_.push_back({from, to.position, to.distance, arc, other, reach});
  }
}

void FeatureDemands::refine(std::span<const double> strength, double wider, AxisGrading& grading) const {
  for (const Demand& d : demands_)
    grading.refine(d.from, d.to, std::min(wider * d.max_size, d.size_for(strength)));
  grading.spread();
}

Array<Index> FeatureDemands::most_demanding(std::span<const double> strength, const base::Host& host) const {
  constexpr double about = 1.5;
  double least = std::numeric_limits<double>::infinity();
  for (const Demand& d : demands_)
    least = std::min(least, d.size_for(strength));
  Array<Index> arcs(host.memory);
  for (const Demand& d : demands_) {
    if (d.size_for(strength) > about * least) continue;
    arcs.push_back(d.arc);
    arcs.push_back(d.other);
  }
  std::sort(arcs.begin(), arcs.end());
  arcs.erase(std::unique(arcs.begin(), arcs.end()), arcs.end());
  return arcs;
}

}  // namespace orbicube::hexmesh
