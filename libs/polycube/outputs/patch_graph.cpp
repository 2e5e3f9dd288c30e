#include "polycube/outputs/patch_graph.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/error.h"
#include "base/grouping.h"
#include "mesh/topology/connectivity.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;

[[noreturn]] void refuse() {
  throw base::Error("invalid-argument", "the map is not certified");
}

class PatchGraphBuilder {
 public:
  PatchGraphBuilder(const SurfaceMap& map, const base::Host& host)
      : map_(map),
        host_(host),
        connectivity_(map.positions.size(), map.triangles, host),
        corner_at_(map.positions.size(), no_index, host.memory),
        dart_at_(3 * map.triangles.size(), no_index, host.memory),
        last_(host.memory),
        graph_(host.memory) {}

  PatchGraph build() {
    find_corners();
    find_edges();
    find_patches();
    find_loops();
    find_neighbors();
    return std::move(graph_);
  }

 private:
  Index patch(Index half_edge) const { return map_.patches[half_edge / 3]; }
  bool drawn(Index h) const { return patch(h) != patch(connectivity_.opposite(h)); }
  void report(std::size_t done) const {
    if (done % 4096 == 0) host_.report("patches", 0, 0);
  }

  void find_corners() {
    if (map_.labels.size() != map_.triangles.size() || map_.patches.size() != map_.triangles.size()) refuse();
    for (Index v = 0; v < map_.positions.size(); ++v) {
      report(v);
      int arcs = 0;
      connectivity_.for_each_outgoing(v, [&](Index h) { arcs += drawn(h); });
      if (arcs < 3) continue;
      corner_at_[v] = static_cast<Index>(graph_.corners.size());
      graph_.corners.push_back(map_.polycube[v]);
      graph_.corner_vertices.push_back(v);
    }
  }

  // The half-edge that goes on along the edge after h, which ends at no corner.
  Index onward(Index h) const {
    Index result = no_index;
    connectivity_.for_each_outgoing(connectivity_.end(h), [&](Index x) {
      if (drawn(x) && x != connectivity_.opposite(h)) result = x;
    });
    if (result == no_index) refuse();
    return result;
  }

  void find_edges() {
    graph_.path_begin.push_back(0);
    for (Index corner = 0; corner < graph_.corners.size(); ++corner) {
      report(corner);
      connectivity_.for_each_outgoing(graph_.corner_vertices[corner], [&](Index first) {
        if (!drawn(first) || dart_at_[first] != no_index) return;
        const auto dart = static_cast<Index>(graph_.dart_origin.size());
        Index h = first;
        graph_.paths.push_back(connectivity_.start(h));
        while (true) {
          dart_at_[h] = dart;
          dart_at_[connectivity_.opposite(h)] = dart + 1;
          graph_.paths.push_back(connectivity_.end(h));
          if (corner_at_[connectivity_.end(h)] != no_index) break;
          h = onward(h);
        }
        graph_.path_begin.push_back(static_cast<Index>(graph_.paths.size()));
        graph_.dart_origin.push_back(corner);
        graph_.dart_origin.push_back(corner_at_[connectivity_.end(h)]);
        graph_.dart_left.push_back(patch(first));
        graph_.dart_left.push_back(patch(connectivity_.opposite(first)));
        last_.push_back(h);
        last_.push_back(connectivity_.opposite(first));
        const Vector3 along = map_.polycube[connectivity_.end(first)] - map_.polycube[connectivity_.start(first)];
        const Vector3 left = direction_of(map_.labels[first / 3]);
        const Vector3 right = direction_of(map_.labels[connectivity_.opposite(first) / 3]);
        graph_.convex.push_back(left.cross(right).dot(along) > 0);
      });
    }
  }

  void find_patches() {
    Index patches = 0;
    for (const Index c : map_.patches)
      patches = std::max(patches, c + 1);
    graph_.labels.assign(patches, 0);
    graph_.coordinates.assign(patches, 0);
    for (Index t = 0; t < map_.triangles.size(); ++t) {
      graph_.labels[map_.patches[t]] = map_.labels[t];
      graph_.coordinates[map_.patches[t]] = map_.polycube[map_.triangles[t][0]][axis_of(map_.labels[t])];
    }
  }

  // The dart that follows along the boundary of the patch on the left.
  Index following(Index dart) const {
    Index h = Connectivity::next(last_[dart]);
    while (!drawn(h))
      h = Connectivity::next(connectivity_.opposite(h));
    return dart_at_[h];
  }

  Vector3 direction(Index dart) const {
    return (graph_.corners[graph_.target(dart)] - graph_.corners[graph_.origin(dart)]).normalized();
  }

  void find_loops() {
    struct Loop {
      Index patch, first;
      int turns;
    };
    Array<Loop> found(host_.memory);
    Array<std::uint8_t> seen(graph_.dart_origin.size(), 0, host_.memory);
    for (Index first = 0; first < seen.size(); ++first) {
      if (seen[first]) continue;
      const Vector3 normal = direction_of(graph_.labels[graph_.dart_left[first]]);
      Loop loop{graph_.dart_left[first], first, 0};
      Index dart = first;
      do {
        seen[dart] = 1;
        const Index next = following(dart);
        if (next == no_index || graph_.dart_left[next] != loop.patch) refuse();
        loop.turns += static_cast<int>(direction(dart).cross(direction(next)).dot(normal));
        dart = next;
      } while (dart != first);
      found.push_back(loop);
    }
    // Outer loops turn by four quarters, holes by minus four.
    std::sort(found.begin(), found.end(), [](const Loop& a, const Loop& b) {
      if (a.patch != b.patch) return a.patch < b.patch;
      return a.turns != b.turns ? a.turns > b.turns : a.first < b.first;
    });
    graph_.loop_begin.push_back(0);
    for (const Loop& loop : found) {
      while (graph_.loops_of_patch.size() <= loop.patch)
        graph_.loops_of_patch.push_back(static_cast<Index>(graph_.loop_begin.size() - 1));
      Index dart = loop.first;
      do {
        graph_.loops.push_back(dart);
        dart = following(dart);
      } while (dart != loop.first);
      graph_.loop_begin.push_back(static_cast<Index>(graph_.loops.size()));
    }
    graph_.loops_of_patch.push_back(static_cast<Index>(found.size()));
    if (graph_.loops_of_patch.size() != graph_.patches() + 1) refuse();
  }

  void find_neighbors() {
    Array<std::array<Index, 2>> links(host_.memory);
    for (Index dart = 0; dart < graph_.dart_left.size(); ++dart)
      links.push_back({graph_.dart_left[dart], graph_.dart_left[dart ^ 1U]});
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    graph_.neighbor_begin.assign(graph_.patches() + 1, 0);
    for (const auto& [patch, other] : links) {
      ++graph_.neighbor_begin[patch + 1];
      graph_.neighbors.push_back(other);
    }
    base::add_up_counts(std::span(graph_.neighbor_begin));
  }

  const SurfaceMap& map_;
  const base::Host& host_;
  Connectivity connectivity_;
  Array<Index> corner_at_;  // of vertices
  Array<Index> dart_at_;    // of half-edges on edges
  Array<Index> last_;       // half-edge of each dart
  PatchGraph graph_;
};

}  // namespace

PatchGraph make_patch_graph(const SurfaceMap& map, const base::Host& host) {
  return PatchGraphBuilder(map, host).build();
}

}  // namespace orbicube::polycube
