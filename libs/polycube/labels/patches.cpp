#include "polycube/labels/patches.h"

#include "base/grouping.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;

// Connected sets of triangles with one label.
void grow(const Surface& surface, std::span<const AxisLabel> labels, Patches& patches, Array<Index>& open) {
  patches.patch.assign(surface.triangles.size(), no_index);
  for (Index first = 0; first < surface.triangles.size(); ++first) {
    if (patches.patch[first] != no_index) continue;
    const auto number = static_cast<Index>(patches.labels.size());
    patches.labels.push_back(labels[first]);
    patches.areas.push_back(0);
    patches.euler.push_back(0);
    patches.patch[first] = number;
    open.assign(1, first);
    while (!open.empty()) {
      const Index triangle = open.back();
      open.pop_back();
      patches.areas[number] += surface.areas[triangle];
      ++patches.euler[number];
      for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        const Index other = surface.neighbor(h);
        if (labels[other] != labels[triangle]) {
          --patches.euler[number];  // an edge of the boundary
        } else {
          if (h < surface.opposite(h)) --patches.euler[number];
          if (patches.patch[other] == no_index) {
            patches.patch[other] = number;
            open.push_back(other);
          }
        }
      }
    }
  }
}

// The loops of all patches, in the order of their patches.
void trace_loops(const Surface& surface, Patches& patches, Array<Index>& by_patch, Array<std::uint8_t>& seen) {
  const auto half_edges = static_cast<Index>(3 * surface.triangles.size());
  const auto on_boundary = [&](Index h) { return patches.patch[h / 3] != patches.patch[surface.neighbor(h)]; };
  // Half-edges of boundaries, sorted by patch.
  patches.patch_loops.resize(patches.count() + 1);
  base::group_by_key(
      std::span(patches.patch_loops),
      [&](const auto& visit) {
        for (Index h = 0; h < half_edges; ++h) {
          if (on_boundary(h)) visit(patches.patch[h / 3], h);
        }
      },
      [&](Index total) { by_patch.resize(total); }, [&](Index at, Index h) { by_patch[at] = h; });
  for (const Index h : by_patch)
    ++patches.valence[surface.start(h)];
  seen.assign(half_edges, 0);
  patches.loop_half_edges.reserve(by_patch.size());
  Index current = no_index;
  for (const Index first : by_patch) {
    if (seen[first]) continue;
    const Index own = patches.patch[first / 3];
    while (current == no_index || current < own) {
      current = current == no_index ? 0 : current + 1;
      patches.patch_loops[current] = static_cast<Index>(patches.loop_patch.size());
    }
    patches.loop_patch.push_back(own);
    patches.loop_begin.push_back(static_cast<Index>(patches.loop_half_edges.size()));
    Index h = first;
    do {
      seen[h] = 1;
      patches.loop_half_edges.push_back(h);
      ++patches.euler[own];  // each boundary half-edge starts one fan of the patch
      h = Connectivity::next(h);
      while (!on_boundary(h))
        h = Connectivity::next(surface.opposite(h));
    } while (h != first);
  }
  const auto loops = static_cast<Index>(patches.loop_patch.size());
  for (std::size_t c = current == no_index ? 0 : current + 1; c <= patches.count(); ++c)
    patches.patch_loops[c] = loops;
  patches.loop_begin.push_back(static_cast<Index>(patches.loop_half_edges.size()));
}

}  // namespace

Patches find_patches(const Surface& surface, std::span<const AxisLabel> labels, const base::Host& host) {
  Patches patches(host.memory);
  Array<Index> work(host.memory);
  Array<std::uint8_t> seen(host.memory);
  grow(surface, labels, patches, work);
  patches.valence.assign(surface.positions.size(), 0);
  trace_loops(surface, patches, work, seen);
  for (Index v = 0; v < surface.positions.size(); ++v) {
    const Index h = surface.connectivity.outgoing(v);
    if (h != no_index && patches.valence[v] == 0) ++patches.euler[patches.patch[h / 3]];
  }
  return patches;
}

std::size_t corners_of_loop(const Surface& surface, const Patches& patches, std::size_t loop) {
  const auto half_edges = patches.loop(loop);
  std::size_t result = 0;
  for (std::size_t i = 0; i < half_edges.size(); ++i) {
    const Index next = half_edges[i + 1 < half_edges.size() ? i + 1 : 0];
    result += patches.patch[surface.neighbor(half_edges[i])] != patches.patch[surface.neighbor(next)];
  }
  return result;
}

LabelFaults find_faults(const Surface& surface, const Patches& patches) {
  LabelFaults result;
  for (const std::uint8_t valence : patches.valence) {
    result.corners += valence >= 3;
    result.high_valence += valence > 3;
  }
  for (const Index h : patches.loop_half_edges) {
    const Index g = surface.opposite(h);
    if (h < g && patches.labels[patches.patch[h / 3]] == opposite(patches.labels[patches.patch[g / 3]]))
      ++result.opposite_edges;
  }
  for (std::size_t c = 0; c < patches.count(); ++c)
    result.handles += patches.has_handles(c);
  for (std::size_t i = 0; i < patches.loop_count(); ++i)
    result.short_loops += corners_of_loop(surface, patches, i) < 4;
  result.missing = patches.count() < label_count;
  return result;
}

}  // namespace orbicube::polycube
