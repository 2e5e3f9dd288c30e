#include "hexmesh/captured/left_out_features.h"

#include <algorithm>

namespace orbicube::hexmesh {
namespace {

mesh::Edge ordered(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

template <class Visit>
void for_each_edge(const mesh::FeatureGraph& graph, Index arc, const Visit& visit) {
  const auto v = graph.vertices_of(graph.arcs[arc]);
  for (std::size_t i = 1; i < v.size(); ++i)
    visit(ordered(v[i - 1], v[i]));
}

}  // namespace

double length_of(const FeatureSurface& surface, Index arc) {
  double sum = 0;
  for_each_edge(surface.graph, arc,
                [&](const mesh::Edge& e) { sum += (surface.positions[e[1]] - surface.positions[e[0]]).norm(); });
  return sum;
}

void LeftOutFeatures::add(const mesh::FeatureGraph& graph, Index arc, std::size_t reason) {
  for_each_edge(graph, arc, [&](const mesh::Edge& e) {
    edges_.push_back(e);
    reasons_.push_back(reason);
  });
}

void LeftOutFeatures::add(const FeatureSurface& surface, std::span<const Index> arcs, double small,
                          const std::string& why, const base::Host& host) {
  const mesh::FeatureGraph& graph = surface.graph;
  texts_.push_back(why);
  Array<std::uint8_t> taken(graph.arcs.size(), 0, host.memory);
  Array<Index> open(host.memory);
  for (const Index first : arcs) {
    bool some = length_of(surface, first) < small;
    open.assign(1, first);
    while (!open.empty()) {
      const Index arc = open.back();
      open.pop_back();
      for (const Index corner : graph.arcs[arc].corners) {
        for (const mesh::FeatureEnd& end : graph.around[corner]) {
          if (length_of(surface, end.arc) >= small) continue;
          some = true;
          if (taken[end.arc]++ == 0) open.push_back(end.arc);
        }
      }
    }
    if (!some) taken[first] = 1;
  }
  for (Index a = 0; a < taken.size(); ++a) {
    if (taken[a] != 0) add(graph, a, texts_.size() - 1);
  }
}

void LeftOutFeatures::add_lost(const mesh::FeatureGraph& before, const mesh::FeatureGraph& after,
                               const std::string& why) {
  std::vector<mesh::Edge> kept(edges_.begin(), edges_.end());
  for (Index a = 0; a < after.arcs.size(); ++a)
    for_each_edge(after, a, [&](const mesh::Edge& e) { kept.push_back(e); });
  std::sort(kept.begin(), kept.end());
  texts_.push_back(why);
  for (Index a = 0; a < before.arcs.size(); ++a) {
    for_each_edge(before, a, [&](const mesh::Edge& e) {
      if (std::binary_search(kept.begin(), kept.end(), e)) return;
      edges_.push_back(e);
      reasons_.push_back(texts_.size() - 1);
    });
  }
}

const std::string* LeftOutFeatures::why(Index from, Index to) const {
  const auto found = std::find(edges_.begin(), edges_.end(), ordered(from, to));
  if (found == edges_.end()) return nullptr;
  return &texts_[reasons_[static_cast<std::size_t>(found - edges_.begin())]];
}

}  // namespace orbicube::hexmesh
