#include "polycube/surface/editable_surface.h"

#include <algorithm>

#include "base/error.h"

namespace orbicube::polycube {

VertexSource between_sources(const VertexSource& a, const VertexSource& b, double part) {
  VertexSource result;
  std::size_t used = 0;
  const auto add = [&](Index corner, double weight) {
    if (corner == no_index || weight == 0) return;
    for (std::size_t i = 0; i < used; ++i) {
      if (result.corner[i] == corner) {
        result.weight[i] += weight;
        return;
      }
    }
    if (used == 3) throw base::Error("internal", "a split across an edge of the input");
    result.corner[used] = corner;
    result.weight[used++] = weight;
  };
  for (std::size_t i = 0; i < 3; ++i)
    add(a.corner[i], (1 - part) * a.weight[i]);
  for (std::size_t i = 0; i < 3; ++i)
    add(b.corner[i], part * b.weight[i]);
  return result;
}

EditableSurface::EditableSurface(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const base::Host& host)
    : position(positions.begin(), positions.end(), host.memory),
      source(host.memory),
      occupied(positions.size(), 0, host.memory),
      triangle(triangles.begin(), triangles.end(), host.memory),
      triangle_source(host.memory),
      arc(3 * triangles.size(), no_index, host.memory),
      opposite_(host.memory),
      outgoing_(host.memory),
      dead_(triangles.size(), 0, host.memory) {
  const mesh::Connectivity connectivity(positions.size(), triangles, host);
  for (Index v = 0; v < positions.size(); ++v) {
    source.push_back({{v, no_index, no_index}, {1, 0, 0}});
    outgoing_.push_back(connectivity.outgoing(v));
  }
  for (Index t = 0; t < triangles.size(); ++t) {
    triangle_source.push_back(t);
    for (Index k = 0; k < 3; ++k) {
      opposite_.push_back(connectivity.opposite(3 * t + k));
      if (opposite_.back() == no_index) throw base::Error("not-closed", "a polycube map needs a closed surface");
    }
  }
}

Index EditableSurface::between(Index a, Index b) const {
  const Index first = outgoing_[a];
  Index h = first;
  do {
    if (end(h) == b) return h;
    h = turned(h);
  } while (h != first);
  return no_index;
}

Index EditableSurface::add_vertex(const Vector3& at, const VertexSource& from) {
  position.push_back(at);
  source.push_back(from);
  occupied.push_back(0);
  outgoing_.push_back(no_index);
  return static_cast<Index>(position.size() - 1);
}

Index EditableSurface::add_face(const Triangle& corners, Index from) {
  triangle.push_back(corners);
  triangle_source.push_back(from);
  dead_.push_back(0);
  for (int k = 0; k < 3; ++k) {
    arc.push_back(no_index);
    opposite_.push_back(no_index);
  }
  return static_cast<Index>(triangle.size() - 1);
}

Index EditableSurface::split_edge(Index h, double part) {
  const Index t = opposite_[h], f = h / 3, g = t / 3;
  const Index a = start(h), b = end(h), c = end(next(h)), d = end(next(t));
  const Index m =
      add_vertex((1 - part) * position[a] + part * position[b], between_sources(source[a], source[b], part));
  struct Side {
    Index opposite, arc;
  };
  const auto side = [&](Index x) { return Side{opposite_[x], arc[x]}; };
  const Side bc = side(next(h)), ca = side(previous(h)), ad = side(next(t)), db = side(previous(t));
  const Index on = arc[h];
  const Index f2 = add_face({m, b, c}, triangle_source[f]);
  const Index g2 = add_face({m, a, d}, triangle_source[g]);
  triangle[f] = {a, m, c};
  triangle[g] = {b, m, d};
  const auto set = [&](Index x, const Side& s) {
    join(x, s.opposite);
    arc[x] = s.arc;
  };
  for (const Index face : {f, f2, g, g2}) {
    arc[3 * face] = on;
    arc[3 * face + 1] = arc[3 * face + 2] = no_index;
  }
  set(3 * f + 2, ca);
  set(3 * f2 + 1, bc);
  set(3 * g + 2, db);
  set(3 * g2 + 1, ad);
  join(3 * f, 3 * g2);
  join(3 * f2, 3 * g);
  join(3 * f + 1, 3 * f2 + 2);
  join(3 * g + 1, 3 * g2 + 2);
  outgoing_[a] = 3 * f;
  outgoing_[b] = 3 * g;
  outgoing_[c] = 3 * f + 2;
  outgoing_[d] = 3 * g + 2;
  outgoing_[m] = 3 * f2;
  return m;
}

Index EditableSurface::split_face(Index f) {
  const Triangle t = triangle[f];
  const auto& [a, b, c] = t;
  const Index m = add_vertex((position[a] + position[b] + position[c]) / 3,
                             between_sources(between_sources(source[a], source[b], 0.5), source[c], 1.0 / 3));
  const std::array<Index, 3> across = {opposite_[3 * f], opposite_[3 * f + 1], opposite_[3 * f + 2]};
  const std::array<Index, 3> on = {arc[3 * f], arc[3 * f + 1], arc[3 * f + 2]};
  const Index f1 = add_face({b, c, m}, triangle_source[f]);
  const Index f2 = add_face({c, a, m}, triangle_source[f]);
  triangle[f] = {a, b, m};
  const std::array<Index, 3> face = {f, f1, f2};
  for (std::size_t k = 0; k < 3; ++k) {
    join(3 * face[k], across[k]);
    arc[3 * face[k]] = on[k];
    arc[3 * face[k] + 1] = arc[3 * face[k] + 2] = no_index;
    join(3 * face[k] + 1, 3 * face[(k + 1) % 3] + 2);
    outgoing_[t[k]] = 3 * face[k];
  }
  outgoing_[m] = 3 * f + 2;
  return m;
}

bool EditableSurface::can_collapse(Index h) const {
  const Index v = start(h), w = end(h);
  const Index c = end(next(h)), d = end(next(opposite_[h]));
  if (c == d) return false;
  // The link condition: no neighbor in common but c and d. Neither of these may be left with two triangles.
  bool linked = false;
  for_each_outgoing(v, [&](Index x) {
    const Index n = end(x);
    if (n == w || n == c || n == d) return;
    if (between(n, w) != no_index) linked = true;
  });
  if (linked) return false;
  for (const Index n : {c, d}) {
    int valence = 0;
    for_each_outgoing(n, [&](Index) { ++valence; });
    if (valence <= 3) return false;
  }
  return true;
}

void EditableSurface::collapse(Index h) {
  const Index t = opposite_[h], v = start(h), w = end(h);
  const Index c = end(next(h)), d = end(next(t));
  const Index wc = opposite_[next(h)], cv = opposite_[previous(h)];  // c to w, v to c
  const Index vd = opposite_[next(t)], dw = opposite_[previous(t)];  // d to v, w to d
  for_each_outgoing(v, [&](Index x) {
    if (x / 3 != h / 3 && x / 3 != t / 3) triangle[x / 3][x % 3] = w;
  });
  // The two edges that become one are drawn where either was; the dead triangles remember which.
  const auto merge = [&](Index x, Index y) {
    join(x, y);
    arc[x] = arc[y] = arc[x] != no_index ? arc[x] : arc[y];
  };
  merge(wc, cv);
  merge(vd, dw);
  dead_[h / 3] = dead_[t / 3] = 1;
  outgoing_[w] = cv;  // starts at w now
  outgoing_[c] = wc;
  outgoing_[d] = vd;
  outgoing_[v] = no_index;
}

void EditableSurface::undo_collapse(Index h) {
  const Index t = opposite_[h], v = start(h);
  const Index c = start(previous(h)), d = start(previous(t));
  for (const Index x : {next(h), previous(h), next(t), previous(t)}) {
    opposite_[opposite_[x]] = x;
    arc[opposite_[x]] = arc[x];
  }
  dead_[h / 3] = dead_[t / 3] = 0;
  outgoing_[v] = h;
  outgoing_[start(t)] = t;
  outgoing_[c] = previous(h);
  outgoing_[d] = previous(t);
  for (Index x = turned(h); x != h; x = turned(x))
    triangle[x / 3][x % 3] = v;
}

}  // namespace orbicube::polycube
