#include "repair/topology/contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "mesh/search/vertex_measures.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::repair {
namespace {

using mesh::end_of;
using mesh::next_in_triangle;
using mesh::start_of;

// How much each patch of faces, connected by edges of two, is worth at an edge with a face too many.
struct Patches {
  Patches(const Soup& soup, const mesh::EdgeTable& edges)
      : sets(soup.triangles.size(), soup.memory()),
        open(soup.triangles.size(), 0, soup.memory()),
        area(soup.triangles.size(), 0.0, soup.memory()) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto h = edges.half_edges(e);
      if (h.size() == 2) sets.unite(h[0] / 3, h[1] / 3);
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto h = edges.half_edges(e);
      if (h.size() == 1) open[sets.find(h[0] / 3)] = 1;
    }
    for (Index t = 0; t < soup.triangles.size(); ++t) {
      const Triangle& c = soup.triangles[t];
      area[sets.find(t)] +=
          (soup.positions[c[1]] - soup.positions[c[0]]).cross(soup.positions[c[2]] - soup.positions[c[0]]).norm();
    }
  }
  mesh::DisjointSets sets;
  Array<std::uint8_t> open;
  Array<double> area;
};

struct AtEdge {
  double angle;
  bool forward;  // from the lower vertex to the higher one
  Index half_edge;
  // A wedge ends before another begins at the same angle.
  bool operator<(const AtEdge& o) const {
    return angle != o.angle ? angle < o.angle : forward != o.forward ? forward : half_edge < o.half_edge;
  }
};

class Contacts {
 public:
  Contacts(Soup& soup, const Context& context)
      : soup_(soup), context_(context), corners_(3 * soup.triangles.size(), soup.memory()), sheets_(soup.memory()) {}

  ContactFigures run(double gap, bool join_open_fans) {
    {
      const mesh::EdgeTable edges(soup_.positions.size(), soup_.triangles, context_.host);
      Patches patches(soup_, edges);
      for (std::size_t e = 0; e < edges.size(); ++e) {
        if (e % 65536 == 0) context_.host.report("contacts", e, edges.size());
        const auto h = edges.half_edges(e);
        if (h.size() == 2) unite(h[0], h[1]);
        if (h.size() > 2) pair_up(h, patches);
      }
      if (join_open_fans) join_fans(edges);
    }
    Array<std::uint8_t> split(soup_.positions.size(), 0, soup_.memory());
    give_own_vertices(split);
    if (figures_.added_vertices > 0 && gap > 0) move_apart(split, gap);
    if (figures_.edges > 0) split_doubled_edges(gap);
    return figures_;
  }

 private:
  void unite(Index h, Index g) {
    if (start_of(soup_.triangles, h) == start_of(soup_.triangles, g)) return;  // one-sided
    corners_.unite(h, next_in_triangle(g));
    corners_.unite(next_in_triangle(h), g);
  }

  // The faces at the edge in ascending order of their angle around it; an odd one out is left out.
  Array<AtEdge> around(std::span<const Index> half_edges, Patches& patches) const {
    const auto [low, high] =
        std::minmax({start_of(soup_.triangles, half_edges[0]), end_of(soup_.triangles, half_edges[0])});
    const Vector3& a = soup_.positions[low];
    const Vector3 axis = (soup_.positions[high] - a).stableNormalized();
    const Vector3 x = axis.unitOrthogonal(), y = axis.cross(x);
    Array<AtEdge> faces(soup_.memory());
    for (const Index h : half_edges) {
      const Vector3 d = soup_.positions[start_of(soup_.triangles, next_in_triangle(next_in_triangle(h)))] - a;
      faces.push_back({std::atan2(d.dot(y), d.dot(x)), start_of(soup_.triangles, h) == low, h});
    }
    if (faces.size() % 2 == 1) {
      const auto worth = [&](const AtEdge& f) {
        const Index patch = patches.sets.find(f.half_edge / 3);
        return std::pair(patches.open[patch] == 0, patches.area[patch]);
      };
      faces.erase(std::min_element(faces.begin(), faces.end(),
                                   [&](const AtEdge& f, const AtEdge& g) { return worth(f) < worth(g); }));
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  // Matches wedges of the solid like parentheses, around the edge: against the axis from the low to the high vertex,
  // the solid lies behind a backward face and before the forward face that follows it.
  void pair_up(std::span<const Index> half_edges, Patches& patches) {
    ++figures_.edges;
    const Vector3 &a = soup_.positions[start_of(soup_.triangles, half_edges[0])],
                  &b = soup_.positions[end_of(soup_.triangles, half_edges[0])];
    context_.record(Action::split_contact_edge, 0.5 * (a + b), (b - a).norm(), half_edges.size());
    const Array<AtEdge> faces = around(half_edges, patches);
    Array<std::size_t> open(soup_.memory());
    Array<std::uint8_t> done(faces.size(), 0, soup_.memory());
    for (std::size_t i = 0; i < 2 * faces.size(); ++i) {
      const AtEdge& face = faces[i % faces.size()];
      if (done[i % faces.size()] != 0) continue;
      if (!face.forward) {
        if (i < faces.size()) open.push_back(i);
      } else if (!open.empty()) {
        const std::size_t from = open.back();
        open.pop_back();
        done[from] = done[i % faces.size()] = 1;
        unite(faces[from].half_edge, face.half_edge);
        sheets_.push_back({faces[from].half_edge, face.half_edge});
      }
    }
    for (const Index h : half_edges) {
      const bool paired = std::any_of(faces.begin(), faces.end(), [&](const AtEdge& f) {
        return f.half_edge == h && done[static_cast<std::size_t>(&f - faces.data())] != 0;
      });
      if (!paired) sheets_.push_back({h, no_index});
    }
  }

  // Fans of one part that have open edges at one vertex are separated by holes, which are going to be filled.
  void join_fans(const mesh::EdgeTable& edges) {
    struct OpenCorner {
      Index vertex, part, corner;
      bool operator<(const OpenCorner& o) const {
        return std::tuple(vertex, part, corner) < std::tuple(o.vertex, o.part, o.corner);
      }
    };
    mesh::DisjointSets parts(soup_.triangles.size(), soup_.memory());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const auto h = edges.half_edges(e);
      if (h.size() == 2) parts.unite(h[0] / 3, h[1] / 3);
    }
    for (const auto& [h, g] : sheets_) {
      if (g != no_index) parts.unite(h / 3, g / 3);
    }
    Array<OpenCorner> open(soup_.memory());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.half_edges(e).size() != 1) continue;
      const Index h = edges.half_edges(e)[0];
      const Index part = parts.find(h / 3);
      open.push_back({start_of(soup_.triangles, h), part, h});
      open.push_back({end_of(soup_.triangles, h), part, next_in_triangle(h)});
    }
    std::sort(open.begin(), open.end());
    for (std::size_t i = 1; i < open.size(); ++i) {
      if (open[i].vertex == open[i - 1].vertex && open[i].part == open[i - 1].part)
        corners_.unite(open[i].corner, open[i - 1].corner);
    }
  }

  // The set of corners with the lowest triangle keeps the vertex.
  void give_own_vertices(Array<std::uint8_t>& split) {
    const std::size_t before = soup_.positions.size();
    Array<Index> owner(before, no_index, soup_.memory());  // set of corners that has the vertex
    Array<Index> own(3 * soup_.triangles.size(), no_index, soup_.memory());
    Array<Index> fans(before, 1, soup_.memory());
    for (Index c = 0; c < own.size(); ++c) {
      const Index set = corners_.find(c);
      const Index v = soup_.triangles[c / 3][c % 3];
      if (own[set] == no_index) {
        if (owner[v] == no_index) {
          owner[v] = set;
          own[set] = v;
        } else {
          own[set] = soup_.add_vertex(Vector3(soup_.positions[v]), soup_.vertex_source[v]);
          split[v] = 1;
          split.push_back(1);
          ++fans[v];
          ++figures_.added_vertices;
        }
      }
    }
    if (figures_.added_vertices == 0) return;
    for (Index c = 0; c < own.size(); ++c)
      soup_.triangles[c / 3][c % 3] = own[corners_.find(c)];
    for (Index v = 0; v < before; ++v) {
      if (fans[v] == 1) continue;
      ++figures_.vertices;
      context_.record(Action::split_contact_vertex, soup_.positions[v], 0, fans[v]);
    }
  }

  void move_apart(std::span<const std::uint8_t> split, double gap) {
    const Array<Vector3> normals = mesh::vertex_normals(soup_.positions, soup_.triangles, context_.host);
    for (std::size_t v = 0; v < split.size(); ++v) {
      if (split[v] != 0) soup_.positions[v] -= gap * normals[v];
    }
    figures_.largest_move = gap;
  }

  // Sheets whose edges still have the same two vertices, since they hang together around each of them: all but the
  // first get a vertex in the middle.
  void split_doubled_edges(double gap) {
    struct Edge {
      Index low, high;
      std::size_t sheet;
      auto key() const { return std::tuple(low, high, sheet); }
    };
    Array<Edge> edges(soup_.memory());
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
      const auto [low, high] =
          std::minmax({start_of(soup_.triangles, sheets_[i][0]), end_of(soup_.triangles, sheets_[i][0])});
      edges.push_back({low, high, i});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.key() < f.key(); });
    for (std::size_t i = 1; i < edges.size(); ++i) {
      if (edges[i].low != edges[i - 1].low || edges[i].high != edges[i - 1].high) continue;
      const Vector3 middle = 0.5 * (soup_.positions[edges[i].low] + soup_.positions[edges[i].high]);
      Vector3 normal = Vector3::Zero();
      for (const Index h : sheets_[edges[i].sheet]) {
        if (h != no_index) normal += unit_normal(soup_.triangles[h / 3]);
      }
      const Index m = soup_.add_vertex(middle - gap * normal.stableNormalized(), no_index);
      ++figures_.added_vertices;
      for (const Index h : std::array(sheets_[edges[i].sheet]))
        if (h != no_index) split_face(h, m);
    }
  }

  Vector3 unit_normal(const Triangle& t) const {
    const Vector3& a = soup_.positions[t[0]];
    return (soup_.positions[t[1]] - a).cross(soup_.positions[t[2]] - a).stableNormalized();
  }

  // Half-edges keep their number at their start; those of the later pairs of this face may move to the new triangle.
  void split_face(Index h, Index m) {
    const Index t = h / 3, k = h % 3;
    const Triangle c = soup_.triangles[t];
    const auto added = static_cast<Index>(soup_.triangles.size());
    Triangle second = c;
    second[k] = m;
    soup_.triangles[t][(k + 1) % 3] = m;
    soup_.add_triangle(second, soup_.triangle_source[t]);
    const Index moved = 3 * t + (k + 1) % 3;  // from the end of h on
    for (auto& pair : sheets_) {
      for (Index& other : pair) {
        if (other == moved) other = 3 * added + (k + 1) % 3;
      }
    }
  }

  Soup& soup_;
  const Context& context_;
  mesh::DisjointSets corners_;
  Array<std::array<Index, 2>> sheets_;  // at edges of more than two faces: a pair of faces, or one that stays open
  ContactFigures figures_;
};

}  // namespace

ContactFigures split_contacts(Soup& soup, double gap, bool join_open_fans, const Context& context) {
  return Contacts(soup, context).run(gap, join_open_fans);
}

}  // namespace orbicube::repair
