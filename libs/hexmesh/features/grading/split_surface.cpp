#include "hexmesh/features/grading/split_surface.h"

#include <algorithm>
#include <utility>

namespace orbicube::hexmesh {
namespace {

constexpr int max_halvings = 10;
constexpr std::size_t max_triangles = 2'000'000;  // no round begins with more

class Splitting {
 public:
  Splitting(SplitSurface& surface, const base::Host& host)
      : surface_(surface), host_(host), edges_(host.memory), triangles_(host.memory), patches_(host.memory) {}

  // Returns whether an edge was split.
  bool round(const std::function<bool(const Vector3&, const Vector3&)>& too_long) {
    find_edges(too_long);
    if (edges_.empty()) return false;
    first_ = static_cast<Index>(surface_.positions.size());
    for (const auto& [from, to] : edges_)
      surface_.positions.push_back(0.5 * (surface_.positions[from] + surface_.positions[to]));
    triangles_.clear();
    patches_.clear();
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      split(surface_.triangles[t], surface_.graph.patches[t]);
    surface_.triangles.swap(triangles_);
    surface_.graph.patches.swap(patches_);
    split_arcs();
    return true;
  }

 private:
  void find_edges(const std::function<bool(const Vector3&, const Vector3&)>& too_long) {
    edges_.clear();
    for (const mesh::Triangle& t : surface_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        // Each edge once: its other triangle has it in the opposite direction.
        const Index a = t[k], b = t[(k + 1) % 3];
        if (a < b && too_long(surface_.positions[a], surface_.positions[b])) edges_.push_back({a, b});
      }
    }
    host_.report("features", 0, 0);
    std::sort(edges_.begin(), edges_.end());
  }

  // The vertex in the middle of an edge, or none.
  Index middle(Index a, Index b) const {
    const mesh::Edge edge = {std::min(a, b), std::max(a, b)};
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), edge);
    if (found == edges_.end() || *found != edge) return no_index;
    return first_ + static_cast<Index>(found - edges_.begin());
  }

  void add(Index a, Index b, Index c, Index patch) {
    triangles_.push_back({a, b, c});
    patches_.push_back(patch);
  }

  void split(mesh::Triangle t, Index patch) {
    std::array<Index, 3> m = {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    const auto count = 3 - std::count(m.begin(), m.end(), no_index);
    if (count == 0) return add(t[0], t[1], t[2], patch);
    if (count == 3) {
      for (std::size_t k = 0; k < 3; ++k)
        add(t[k], m[k], m[(k + 2) % 3], patch);
      return add(m[0], m[1], m[2], patch);
    }
    // The edge 0 1 is the only one to split, or the only one that is not.
    while ((m[0] == no_index) == (count == 1)) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (count == 1) {
      add(t[0], m[0], t[2], patch);
      return add(m[0], t[1], t[2], patch);
    }
    add(m[1], t[2], m[2], patch);
    const auto& p = surface_.positions;
    if ((p[t[0]] - p[m[1]]).squaredNorm() < (p[t[1]] - p[m[2]]).squaredNorm()) {
      add(t[0], t[1], m[1], patch);
      return add(t[0], m[1], m[2], patch);
    }
    add(t[0], t[1], m[2], patch);
    add(t[1], m[1], m[2], patch);
  }

  void split_arcs() {
    Array<Index> vertices(host_.memory);
    for (mesh::FeatureArc& arc : surface_.graph.arcs) {
      const auto before = surface_.graph.vertices_of(arc);
      const auto begin = static_cast<Index>(vertices.size());
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Index between = i == 0 ? no_index : middle(before[i - 1], before[i]);
        if (between != no_index) vertices.push_back(between);
        vertices.push_back(before[i]);
      }
      arc.begin = begin;
      arc.end = static_cast<Index>(vertices.size());
    }
    surface_.graph.vertices.swap(vertices);
  }

  SplitSurface& surface_;
  const base::Host& host_;
  Array<mesh::Edge> edges_;  // that are split, ascending
  Index first_ = 0;          // vertex in the middle of an edge: of the first of these
  Array<mesh::Triangle> triangles_;
  Array<Index> patches_;
};

}  // namespace

void split_edges(SplitSurface& surface, const std::function<bool(const Vector3&, const Vector3&)>& too_long,
                 const base::Host& host) {
  Splitting splitting(surface, host);
  for (int round = 0; round < max_halvings && surface.triangles.size() <= max_triangles; ++round) {
    if (!splitting.round(too_long)) return;
  }
}

}  // namespace orbicube::hexmesh
