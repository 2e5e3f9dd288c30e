#include "polycube/surface/decimation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/heap.h"
#include "polycube/surface/quadric.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;

constexpr Index max_valence = 24;  // of the vertex that is kept

class Decimator {
 public:
  Decimator(const Surface& surface, std::span<const AxisLabel> labels, const base::Host& host)
      : surface_(surface),
        labels_(labels),
        host_(host),
        result_(host.memory),
        dead_(surface.triangles.size(), host.memory),
        arms_(surface.positions.size(), host.memory),
        quadric_(surface.positions.size(), host.memory),
        best_(surface.positions.size(), no_index, host.memory),
        stamp_(surface.positions.size(), host.memory),
        mark_(surface.positions.size(), host.memory),
        heap_(host.memory) {
    result_.triangles.assign(surface.triangles.begin(), surface.triangles.end());
    result_.opposite.resize(3 * surface.triangles.size());
    result_.outgoing.resize(surface.positions.size());
    for (Index h = 0; h < result_.opposite.size(); ++h)
      result_.opposite[h] = surface.opposite(h);
    for (Index v = 0; v < result_.outgoing.size(); ++v)
      result_.outgoing[v] = surface.connectivity.outgoing(v);
    for (Index h = 0; h < result_.opposite.size(); ++h) {
      if (separates(h)) ++arms_[start(h)];
      const Vector3& normal = surface.normals[h / 3];
      quadric_[start(h)].add_plane(normal, -normal.dot(surface.positions[start(h)]), surface.areas[h / 3] / 3);
    }
  }

  Decimation run(std::size_t target) {
    std::size_t alive = dead_.size();
    for (Index v = 0; v < result_.outgoing.size(); ++v) {
      if (v % 1024 == 0) host_.report("decimation", v, result_.outgoing.size());
      if (result_.outgoing[v] != no_index) refresh(v);
    }
    while (alive > target && !heap_.empty()) {
      const Entry entry = heap_.pop();
      const Index v = entry.vertex;
      if (entry.stamp != stamp_[v] || best_[v] == no_index) continue;
      if (!allowed(best_[v])) {  // something changed farther away
        refresh(v);
        continue;
      }
      if (alive % 1024 < 2) host_.report("decimation", dead_.size() - alive, dead_.size() - target);
      const Index kept = end(best_[v]);
      collapse(best_[v]);
      ++stamp_[v];
      best_[v] = no_index;
      alive -= 2;
      refresh(kept);
      result_.for_each_outgoing(kept, [&](Index h) { refresh(end(h)); });
    }
    for (Index t = 0; t < dead_.size(); ++t) {
      if (!dead_[t]) result_.left.push_back(t);
    }
    return std::move(result_);
  }

 private:
  struct Entry {
    double cost;
    Index vertex, stamp;
    bool operator>(const Entry& other) const { return cost != other.cost ? cost > other.cost : vertex > other.vertex; }
  };

  Index start(Index h) const { return result_.start(h); }
  Index end(Index h) const { return result_.end(h); }
  bool separates(Index h) const { return !labels_.empty() && labels_[h / 3] != labels_[result_.opposite[h] / 3]; }

  Index valence(Index vertex) const {
    Index result = 0;
    result_.for_each_outgoing(vertex, [&](Index) { ++result; });
    return result;
  }

  // Whether the start of h may go to its end.
  bool allowed(Index h) {
    const Index removed = start(h), kept = end(h);
    const Index left = end(Connectivity::next(h)), right = end(Connectivity::next(result_.opposite[h]));
    if (left == right) return false;
    // Manifold exactly when the two have no common neighbors but those that their edge faces (Dey et al. 1999).
    ++round_;
    Index around_kept = 0;
    result_.for_each_outgoing(kept, [&](Index g) {
      mark_[end(g)] = round_;
      ++around_kept;
    });
    Index common = 0, around_removed = 0;
    bool chord = false;
    result_.for_each_outgoing(removed, [&](Index g) {
      const Index x = end(g);
      ++around_removed;
      if (mark_[x] == round_)
        ++common;
      else if (x != kept && arms_[removed] == 0 && arms_[kept] > 0 && arms_[x] > 0)
        chord = true;
    });
    if (common != 2 || chord || around_kept + around_removed > max_valence + 4) return false;
    if (valence(left) <= 3 || valence(right) <= 3) return false;
    if (arms_[removed] == 0) return true;
    // Along an arc, not into a corner, beside whose reflex angle it would have no way back, and not where a triangle
    // has two edges of it.
    return arms_[removed] == 2 && arms_[kept] == 2 && separates(h) && !separates(Connectivity::previous(h)) &&
           !separates(Connectivity::next(result_.opposite[h]));
  }

  double cost(Index h) const {
    const Index removed = start(h), kept = end(h);
    const Vector3& to = surface_.positions[kept];
    double worst = 1, factor = 1, area = 0;
    const Index first = h / 3, second = result_.opposite[h] / 3;
    result_.for_each_outgoing(removed, [&](Index g) {
      if (g / 3 == first || g / 3 == second) return;
      const Vector3& x = surface_.positions[end(g)];
      const Vector3& y = surface_.positions[end(Connectivity::next(g))];
      const Vector3 normal = (x - to).cross(y - to);
      const Vector3 before = (x - surface_.positions[removed]).cross(y - surface_.positions[removed]);
      const double twice_area = normal.norm();
      const double squares = (x - to).squaredNorm() + (y - to).squaredNorm() + (x - y).squaredNorm();
      if (squares > 0) worst = std::min(worst, 2 * std::sqrt(3.0) * twice_area / squares);
      const double cosine = normal.dot(before);
      if (cosine < 0.3 * twice_area * before.norm()) factor *= cosine < 0 ? 100 : 4;
      area += twice_area;
    });
    const double error = std::max(0.0, quadric_[removed].at(to) + quadric_[kept].at(to));
    const double flat = 1e-4 * (to - surface_.positions[removed]).squaredNorm() * area;
    return (error + flat) * factor * (1 + 0.1 / (worst + 1e-4));
  }

  void refresh(Index vertex) {
    ++stamp_[vertex];
    best_[vertex] = no_index;
    if (arms_[vertex] > 2) return;
    double least = std::numeric_limits<double>::infinity();
    const Index first = result_.outgoing[vertex];
    Index h = first;
    do {
      const double c = cost(h);
      if (c < least && allowed(h)) {
        least = c;
        best_[vertex] = h;
      }
      h = result_.opposite[Connectivity::previous(h)];
    } while (h != first);
    if (best_[vertex] != no_index) heap_.push({least, vertex, stamp_[vertex]});
  }

  void collapse(Index h) {
    Collapse c{start(h), end(h), {}, {}, static_cast<Index>(result_.moved.size()), 0};
    const Index g = result_.opposite[h];
    c.dead = {h / 3, g / 3};
    result_.for_each_outgoing(c.removed, [&](Index k) {
      if (k / 3 != c.dead[0] && k / 3 != c.dead[1]) result_.moved.push_back(k / 3);
    });
    c.size = static_cast<Index>(result_.moved.size()) - c.begin;
    // Left: kept to apex, apex to removed. Right: removed to apex, apex to kept.
    c.beside[0] = {result_.opposite[Connectivity::next(h)], result_.opposite[Connectivity::previous(h)]};
    c.beside[1] = {result_.opposite[Connectivity::previous(g)], result_.opposite[Connectivity::next(g)]};
    const Index left = end(Connectivity::next(h)), right = end(Connectivity::next(g));
    for (const Index t : result_.moved_by(c))
      *std::find(result_.triangles[t].begin(), result_.triangles[t].end(), c.removed) = c.kept;
    for (const auto& pair : c.beside) {
      result_.opposite[pair[0]] = pair[1];
      result_.opposite[pair[1]] = pair[0];
    }
    result_.outgoing[left] = c.beside[0][0];    // from the apex to kept
    result_.outgoing[c.kept] = c.beside[0][1];  // it started at removed
    result_.outgoing[right] = c.beside[1][1];   // from the apex, which it left for removed
    result_.outgoing[c.removed] = no_index;
    dead_[c.dead[0]] = dead_[c.dead[1]] = 1;
    quadric_[c.kept].add(quadric_[c.removed]);
    result_.collapses.push_back(c);
  }

  const Surface& surface_;
  std::span<const AxisLabel> labels_;
  const base::Host& host_;
  Decimation result_;
  Array<std::uint8_t> dead_;
  Array<std::uint8_t> arms_;  // of each vertex: edges that separate patches
  Array<Quadric> quadric_;
  Array<Index> best_;  // half-edge to collapse
  Array<Index> stamp_;
  Array<Index> mark_;
  Index round_ = 0;
  base::Heap<Entry> heap_;
};

}  // namespace

Decimation decimate(const Surface& surface, std::span<const AxisLabel> labels, std::size_t target,
                    const base::Host& host) {
  return Decimator(surface, labels, host).run(target);
}

void Decimation::undo(const Collapse& c) {
  for (std::size_t side = 0; side < 2; ++side) {
    // The half-edges of the dead triangle that faced those beside still know them.
    for (const Index beside : c.beside[side]) {
      for (Index h = 3 * c.dead[side]; h < 3 * c.dead[side] + 3; ++h) {
        if (opposite[h] == beside) opposite[beside] = h;
      }
    }
  }
  for (const Index t : moved_by(c))
    *std::find(triangles[t].begin(), triangles[t].end(), c.kept) = c.removed;
  outgoing[c.removed] = c.beside[0][1];
  outgoing[c.kept] = opposite[c.beside[0][0]];  // from kept to the apex, in the dead triangle
}

void undo_labels(const Decimation& decimation, std::span<const std::array<double, label_count>> costs,
                 std::span<AxisLabel> labels) {
  for (std::size_t i = decimation.collapses.size(); i-- > 0;) {
    const Collapse& c = decimation.collapses[i];
    for (std::size_t side = 0; side < 2; ++side) {
      const AxisLabel a = labels[c.beside[side][0] / 3], b = labels[c.beside[side][1] / 3];
      const auto& cost = costs[c.dead[side]];
      labels[c.dead[side]] = cost[a] <= cost[b] ? a : b;
    }
  }
}

void take_left(const Decimation& decimation, std::span<const Vector3> from, Array<Vector3>& positions,
               Array<Triangle>& triangles, Array<Index>& vertex_source, const base::Host& host) {
  Array<Index> number(from.size(), no_index, host.memory);
  positions.clear();
  triangles.clear();
  vertex_source.clear();
  for (const Index t : decimation.left) {
    Triangle triangle = decimation.triangles[t];
    for (Index& v : triangle) {
      if (number[v] == no_index) {
        number[v] = static_cast<Index>(positions.size());
        positions.push_back(from[v]);
        vertex_source.push_back(v);
      }
      v = number[v];
    }
    triangles.push_back(triangle);
  }
}

}  // namespace orbicube::polycube
