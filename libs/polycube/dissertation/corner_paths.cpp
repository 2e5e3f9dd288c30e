#include "polycube/dissertation/corner_paths.h"

#include <algorithm>

#include "base/infinity.h"
#include "mesh/topology/place_text.h"

namespace orbicube::polycube::dissertation {
namespace {

constexpr const char* corner_paths_phase = "corner paths";
constexpr std::size_t max_known_vertices = 4'000'000;  // of paths that are kept, 16 MB

std::string place_text(const EditableSurface& surface, Index v) {
  return "vertex " + std::to_string(v) + " " + mesh::place_text(surface.position[v]);
}

// Whether paths meet, and what they bound.
class PatchFlood {
 public:
  PatchFlood(const Layout& layout, const EditableSurface& surface, Drawn& drawn, const base::Host& host)
      : layout_(layout),
        surface_(surface),
        drawn_(drawn),
        host_(host),
        on_arc_(3 * surface.faces(), 0, host.memory),
        owner_(surface.vertices(), no_index, host.memory) {}

  void run() {
    find_meetings();
    if (drawn_.valid()) check_order();
    if (!drawn_.valid()) return;
    mark();
    flood();
    if (drawn_.valid()) check_disks();
  }

 private:
  void defect(const std::string& what) {
    if (drawn_.defects++ == 0) drawn_.first = what;
  }

  Index vertex_of(Index node) const {
    const Index dart = layout_.darts_of(node)[0];
    const auto path = drawn_.path(dart / 2);
    return dart % 2 == 0 ? path.front() : path.back();
  }

  // The half-edge by which a dart leaves its node.
  Index departure(Index dart) const {
    const auto path = drawn_.path(dart / 2);
    return dart % 2 == 0 ? surface_.between(path[0], path[1]) : surface_.between(path.back(), path[path.size() - 2]);
  }

  void find_meetings() {
    const auto nodes = static_cast<Index>(layout_.nodes.size());
    for (Index n = 0; n < nodes; ++n) {
      const Index v = vertex_of(n);
      if (owner_[v] != no_index) defect("two corner points are at " + place_text(surface_, v));
      owner_[v] = n;
    }
    for (Index arc = 0; arc < layout_.arcs(); ++arc) {
      const auto path = drawn_.path(arc);
      if (path.size() < 2) {
        defect("an edge of the polycube has no path");
        continue;
      }
      for (std::size_t i = 1; i + 1 < path.size(); ++i) {
        if (owner_[path[i]] == no_index)
          owner_[path[i]] = nodes + arc;
        else
          defect("two shortest paths meet at " + place_text(surface_, path[i]));
      }
    }
  }

  // Paths leave each corner point in the order of the polycube's edges.
  void check_order() {
    Array<Index> rank(host_.memory);
    for (Index n = 0; n < layout_.nodes.size(); ++n) {
      const Index v = vertex_of(n);
      rank.clear();
      for (const Index dart : layout_.darts_of(n)) {
        const Index leaves = departure(dart);
        Index at = 0, found = no_index;
        surface_.for_each_outgoing(v, [&](Index h) {
          if (h == leaves) found = at;
          ++at;
        });
        rank.push_back(found);
      }
      int turns = 0;
      for (std::size_t i = 0; i < rank.size(); ++i)
        turns += rank[i] >= rank[(i + 1) % rank.size()];
      if (turns != 1) defect("shortest paths cross at the corner point of " + place_text(surface_, v));
    }
  }

  void mark() {
    for (Index arc = 0; arc < layout_.arcs(); ++arc) {
      const auto path = drawn_.path(arc);
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Index h = surface_.between(path[i], path[i + 1]);
        on_arc_[h] = on_arc_[surface_.opposite(h)] = 1;
      }
    }
  }

  void flood() {
    drawn_.rectangle.assign(surface_.faces(), no_index);
    Array<Index> front(host_.memory);
    for (Index dart = 0; dart < 2 * layout_.arcs(); ++dart) {
      const Index h = departure(dart), own = layout_.dart_left[dart];
      Index& first = drawn_.rectangle[h / 3];
      if (first == own) continue;
      if (first != no_index) {
        defect("the paths around a patch are not closed at " + place_text(surface_, surface_.start(h)));
        continue;
      }
      first = own;
      front.assign(1, h / 3);
      while (!front.empty()) {
        const Index face = front.back();
        front.pop_back();
        for (Index k = 0; k < 3; ++k) {
          if (on_arc_[3 * face + k] != 0) continue;
          const Index there = surface_.opposite(3 * face + k) / 3;
          if (drawn_.rectangle[there] != no_index) continue;
          drawn_.rectangle[there] = own;
          front.push_back(there);
        }
      }
    }
  }

  // By Euler's number, with each patch cut free along its paths.
  void check_disks() {
    const std::size_t count = layout_.rectangles.size();
    Array<std::int64_t> twice_euler(count, 0, host_.memory);
    Array<Index> seen(surface_.vertices(), no_index, host_.memory);
    for (Index face = 0; face < surface_.faces(); ++face) {
      const Index own = drawn_.rectangle[face];
      if (own == no_index) {
        defect("no patch has triangle " + std::to_string(surface_.triangle_source[face]));
        return;
      }
      twice_euler[own] += 2;
      for (Index k = 0; k < 3; ++k) {
        twice_euler[own] -= on_arc_[3 * face + k] != 0 ? 2 : 1;
        const Index v = surface_.start(3 * face + k);
        if (owner_[v] != no_index || seen[v] == own) continue;
        seen[v] = own;
        twice_euler[own] += 2;
      }
    }
    for (Index r = 0; r < count; ++r) {
      for (const Index dart : layout_.darts_around(r))
        twice_euler[r] += 2 * (static_cast<std::int64_t>(drawn_.path(dart / 2).size()) - 1);
      if (twice_euler[r] != 2)
        defect("a patch is no disk: the one right of the path from " +
               place_text(surface_, drawn_.path(layout_.darts_around(r)[0] / 2)[0]));
    }
  }

  const Layout& layout_;
  const EditableSurface& surface_;
  Drawn& drawn_;
  const base::Host& host_;
  Array<std::uint8_t> on_arc_;  // of half-edges
  Array<Index> owner_;          // node, or nodes + arc, at each vertex
};

}  // namespace

ShortestPaths::ShortestPaths(const EditableSurface& surface, const base::Host& host)
    : surface_(surface),
      host_(host),
      distance_(surface.vertices(), base::infinity, host.memory),
      parent_(surface.vertices(), no_index, host.memory),
      touched_(host.memory),
      heap_(host.memory),
      known_(host.memory),
      reversed_(host.memory) {}

std::span<const Index> ShortestPaths::find(Index from, Index to) {
  const Pair key = std::minmax(from, to);
  auto at = known_.find(key);
  if (at == known_.end()) {
    if (known_size_ > max_known_vertices) {
      known_.clear();
      known_size_ = 0;
    }
    at = known_.emplace(key, Array<Index>(host_.memory)).first;
    search(key.first, key.second, at->second);
    known_size_ += at->second.size();
  }
  if (from == key.first) return at->second;
  reversed_.assign(at->second.rbegin(), at->second.rend());
  return reversed_;
}

void ShortestPaths::search(Index from, Index to, Array<Index>& path) {
  for (const Index v : touched_) {
    distance_[v] = base::infinity;
    parent_[v] = no_index;
  }
  touched_.assign(1, from);
  heap_.clear();
  distance_[from] = 0;
  heap_.push({0, from});
  while (!heap_.empty()) {
    const Reached now = heap_.pop();
    if (now.length > distance_[now.vertex]) continue;
    if (now.vertex == to) break;
    host_.report(corner_paths_phase, 0, 0);
    surface_.for_each_outgoing(now.vertex, [&](Index h) {
      const Index v = surface_.end(h);
      const double length = now.length + surface_.length(h);
      if (!(length < distance_[v])) return;
      if (distance_[v] == base::infinity) touched_.push_back(v);
      distance_[v] = length;
      parent_[v] = now.vertex;
      heap_.push({length, v});
    });
  }
  path.clear();
  if (distance_[to] == base::infinity) return;
  for (Index v = to; v != no_index; v = parent_[v])
    path.push_back(v);
  std::reverse(path.begin(), path.end());
}

Drawn draw_paths(const Layout& layout, std::span<const Index> node_vertices, const EditableSurface& surface,
                 ShortestPaths& shortest, const base::Host& host) {
  Drawn drawn(host.memory);
  drawn.path_begin.push_back(0);
  for (Index arc = 0; arc < layout.arcs(); ++arc) {
    const auto path = shortest.find(node_vertices[layout.origin(2 * arc)], node_vertices[layout.target(2 * arc)]);
    drawn.paths.insert(drawn.paths.end(), path.begin(), path.end());
    drawn.path_begin.push_back(static_cast<Index>(drawn.paths.size()));
  }
  find_patches(layout, surface, drawn, host);
  return drawn;
}

void find_patches(const Layout& layout, const EditableSurface& surface, Drawn& drawn, const base::Host& host) {
  PatchFlood(layout, surface, drawn, host).run();
}

}  // namespace orbicube::polycube::dissertation
