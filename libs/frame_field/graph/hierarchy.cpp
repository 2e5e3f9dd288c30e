#include "frame_field/graph/hierarchy.h"

#include <algorithm>

#include "base/grouping.h"

namespace orbicube::frame_field {
namespace {

constexpr std::size_t group_size = 8;

// Links of the finest graph and of a coarse one, alike.
struct FineLinks {
  const DualGraph& graph;
  std::size_t size() const { return graph.size(); }
  float members(Index) const { return 1; }
  template <class Visit>
  void for_each(Index node, const Visit& visit) const {
    for (std::size_t k = 0; k < 4; ++k) {
      if (graph.others[node][k] != node) visit(graph.others[node][k], graph.weights[node][k]);
    }
  }
};
struct CoarseLinks {
  const CoarseGraph& graph;
  std::size_t size() const { return graph.size(); }
  float members(Index node) const { return graph.members[node]; }
  template <class Visit>
  void for_each(Index node, const Visit& visit) const {
    for (Index l = graph.begin[node]; l < graph.begin[node + std::size_t{1}]; ++l)
      visit(graph.other[l], graph.weight[l]);
  }
};

// Grows groups one after another from the first node without one: always the node with the most weight of links into
// the group. A group that stays small joins the neighbor that it is linked to most.
template <class Links>
Index make_groups(const Links& links, Array<Index>& group, const base::Host& host) {
  group.assign(links.size(), no_index);
  Index groups = 0;
  struct Candidate {
    Index node;
    float weight;
  };
  Array<Candidate> candidates(host.memory);
  for (Index start = 0; start < links.size(); ++start) {
    if (start % base::items_between_reports == 0) host.report("coarsening", start, links.size());
    if (group[start] != no_index) continue;
    candidates.clear();
    Candidate heaviest{no_index, 0};  // a group beside this one
    std::size_t size = 0;
    for (Index node = start; node != no_index && size < group_size;) {
      group[node] = groups;
      ++size;
      std::erase_if(candidates, [&](const Candidate& c) { return c.node == node; });
      links.for_each(node, [&](Index other, float weight) {
        if (group[other] == groups) return;
        if (group[other] != no_index) {
          if (weight > heaviest.weight) heaviest = {group[other], weight};
          return;
        }
        const auto known = std::ranges::find(candidates, other, &Candidate::node);
        if (known != candidates.end())
          known->weight += weight;
        else
          candidates.push_back({other, weight});
      });
      const auto best = std::ranges::max_element(candidates, {}, &Candidate::weight);
      node = best == candidates.end() ? no_index : best->node;
    }
    if (size <= 2 && heaviest.node != no_index) {
      group[start] = heaviest.node;
      // The other node of a pair, if there is one, is linked to the first.
      links.for_each(start, [&](Index other, float) {
        if (group[other] == groups) group[other] = heaviest.node;
      });
    } else {
      ++groups;
    }
  }
  return groups;
}

template <class Links>
CoarseGraph coarsen(const Links& links, const base::Host& host) {
  CoarseGraph coarse(host.memory);
  const Index groups = make_groups(links, coarse.group, host);
  coarse.members.assign(groups, 0);
  coarse.total_weight.assign(groups, 0);
  coarse.begin.assign(groups + std::size_t{1}, 0);

  const auto for_each_node = [&](const auto& visit) {
    for (Index i = 0; i < links.size(); ++i)
      visit(coarse.group[i], i);
  };
  const base::Groups<Index, Index> nodes(groups, for_each_node, host.memory);

  // Links of one group at a time; slot[h] is where the link to group h stands while its group is at work.
  Array<Index> slot(groups, no_index, host.memory);
  for (Index g = 0; g < groups; ++g) {
    if (g % base::items_between_reports == 0) host.report("coarsening", g, groups);
    const auto begin = static_cast<Index>(coarse.other.size());
    coarse.begin[g] = begin;
    for (const Index node : nodes[g]) {
      coarse.members[g] += links.members(node);
      links.for_each(node, [&](Index other, float weight) {
        const Index h = coarse.group[other];
        if (h == g) return;
        if (slot[h] == no_index || slot[h] < begin) {
          slot[h] = static_cast<Index>(coarse.other.size());
          coarse.other.push_back(h);
          coarse.weight.push_back(0);
        }
        coarse.weight[slot[h]] += weight;
        coarse.total_weight[g] += weight;
      });
    }
  }
  coarse.begin[groups] = static_cast<Index>(coarse.other.size());
  return coarse;
}

}  // namespace

Array<CoarseGraph> make_hierarchy(const DualGraph& graph, std::size_t smallest, const base::Host& host) {
  Array<CoarseGraph> levels(host.memory);
  std::size_t size = graph.size();
  while (size > smallest) {
    CoarseGraph coarse = levels.empty() ? coarsen(FineLinks{graph}, host) : coarsen(CoarseLinks{levels.back()}, host);
    // Parts that hang together are one node each by then.
    if (2 * coarse.size() > size) break;
    size = coarse.size();
    levels.push_back(std::move(coarse));
  }
  return levels;
}

}  // namespace orbicube::frame_field
