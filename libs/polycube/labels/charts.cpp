#include "polycube/labels/charts.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;

// Connected sets of triangles with one label.
void grow(const Surface& surface, std::span<const AxisLabel> labels, Charts& charts, Array<Index>& open) {
  charts.chart.assign(surface.triangles.size(), no_index);
  for (Index first = 0; first < surface.triangles.size(); ++first) {
    if (charts.chart[first] != no_index) continue;
    const auto number = static_cast<Index>(charts.labels.size());
    charts.labels.push_back(labels[first]);
    charts.areas.push_back(0);
    charts.euler.push_back(0);
    charts.chart[first] = number;
    open.assign(1, first);
    while (!open.empty()) {
      const Index triangle = open.back();
      open.pop_back();
      charts.areas[number] += surface.areas[triangle];
      ++charts.euler[number];
      for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const Index other = surface.neighbour(h);
        if (labels[other] != labels[triangle]) {
          --charts.euler[number];  // an edge of the boundary
        } else {
          if (h < surface.opposite(h)) --charts.euler[number];
          if (charts.chart[other] == no_index) {
            charts.chart[other] = number;
            open.push_back(other);
          }
        }
      }
    }
  }
}

// The loops of all patches, in the order of their patches.
void trace_loops(const Surface& surface, Charts& charts, Array<Index>& by_chart, Array<std::uint8_t>& seen) {
  const auto half_edges = static_cast<Index>(3 * surface.triangles.size());
  const auto on_boundary = [&](Index h) { return charts.chart[h / 3] != charts.chart[surface.neighbour(h)]; };
  // Half-edges of boundaries, sorted by patch: counted, then placed.
  charts.chart_loops.assign(charts.count() + 1, 0);
  std::size_t total = 0;
  for (Index h = 0; h < half_edges; ++h) {
    if (!on_boundary(h)) continue;
    ++charts.valence[surface.start(h)];
    ++charts.chart_loops[charts.chart[h / 3] + 1];
    ++total;
  }
  for (std::size_t c = 0; c < charts.count(); ++c)
    charts.chart_loops[c + 1] += charts.chart_loops[c];
  by_chart.resize(total);
  for (Index h = 0; h < half_edges; ++h) {
    if (on_boundary(h)) by_chart[charts.chart_loops[charts.chart[h / 3]]++] = h;
  }
  seen.assign(half_edges, 0);
  charts.loop_half_edges.reserve(total);
  Index current = no_index;
  for (const Index first : by_chart) {
    if (seen[first]) continue;
    const Index own = charts.chart[first / 3];
    while (current == no_index || current < own) {
      current = current == no_index ? 0 : current + 1;
      charts.chart_loops[current] = static_cast<Index>(charts.loop_chart.size());
    }
    charts.loop_chart.push_back(own);
    charts.loop_begin.push_back(static_cast<Index>(charts.loop_half_edges.size()));
    Index h = first;
    do {
      seen[h] = 1;
      charts.loop_half_edges.push_back(h);
      ++charts.euler[own];  // each boundary half-edge starts one fan of the patch
      h = Connectivity::next(h);
      while (!on_boundary(h))
        h = Connectivity::next(surface.opposite(h));
    } while (h != first);
  }
  const auto loops = static_cast<Index>(charts.loop_chart.size());
  for (std::size_t c = current == no_index ? 0 : current + 1; c <= charts.count(); ++c)
    charts.chart_loops[c] = loops;
  charts.loop_begin.push_back(static_cast<Index>(charts.loop_half_edges.size()));
}

}  // namespace

Charts find_charts(const Surface& surface, std::span<const AxisLabel> labels, const base::Host& host) {
  Charts charts(host.memory);
  Array<Index> work(host.memory);
  Array<std::uint8_t> seen(host.memory);
  grow(surface, labels, charts, work);
  charts.valence.assign(surface.positions.size(), 0);
  trace_loops(surface, charts, work, seen);
  for (Index v = 0; v < surface.positions.size(); ++v) {
    const Index h = surface.connectivity.outgoing(v);
    if (h != no_index && charts.valence[v] == 0) ++charts.euler[charts.chart[h / 3]];
  }
  return charts;
}

std::size_t corners_of_loop(const Surface& surface, const Charts& charts, std::size_t loop) {
  const auto half_edges = charts.loop(loop);
  std::size_t result = 0;
  for (std::size_t i = 0; i < half_edges.size(); ++i) {
    const Index next = half_edges[i + 1 < half_edges.size() ? i + 1 : 0];
    result += charts.chart[surface.neighbour(half_edges[i])] != charts.chart[surface.neighbour(next)];
  }
  return result;
}

LabelFaults find_faults(const Surface& surface, const Charts& charts) {
  LabelFaults result;
  for (const std::uint8_t valence : charts.valence) {
    result.corners += valence >= 3;
    result.high_valence += valence > 3;
  }
  for (const Index h : charts.loop_half_edges) {
    const Index g = surface.opposite(h);
    if (h < g && charts.labels[charts.chart[h / 3]] == opposite(charts.labels[charts.chart[g / 3]]))
      ++result.opposite_edges;
  }
  for (std::size_t c = 0; c < charts.count(); ++c)
    result.handles += charts.has_handles(c);
  for (std::size_t i = 0; i < charts.loop_count(); ++i)
    result.short_loops += corners_of_loop(surface, charts, i) < 4;
  result.missing = charts.count() < label_count;
  return result;
}

}  // namespace orbicube::polycube
