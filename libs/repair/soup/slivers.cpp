#include "repair/soup/slivers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/topology/degenerate_triangles.h"
#include "repair/soup/editable_triangles.h"
#include "repair/soup/soup.h"

namespace orbicube::repair {
namespace {

// Passes over what is left: a flip may need one at a neighbor first.
constexpr int max_passes = 10;
// A cap is flipped first where its height is below this fraction of its shortest edge; a needle is collapsed first.
constexpr double cap_height = 0.1;

bool is_sliver(const Vector3& p, const Vector3& q, const Vector3& r, double ratio, double rounding) {
  if (mesh::is_degenerate(p, q, r, rounding)) return true;
  if (!(ratio > mesh::degenerate_height_ratio)) return false;
  const double longest = std::max({(q - p).squaredNorm(), (r - p).squaredNorm(), (r - q).squaredNorm()});
  return (q - p).cross(r - p).norm() <= ratio * longest;
}

class Slivers {
 public:
  Slivers(Soup& soup, double ratio, double max_move, const Context& context)
      : soup_(soup),
        mesh_(soup.positions.size(), soup.triangles, soup.memory()),
        ratio_(ratio),
        rounding_(mesh::rounding_unit(soup.positions, soup.triangles)),
        max_move_(max_move),
        context_(context),
        drift_(soup.positions.size(), 0.0, soup.memory()) {}

  SliverFigures run() {
    Array<Index> open(soup_.memory());
    for (Index t = 0; t < mesh_.size(); ++t) {
      if (t % 65536 == 0) context_.host.report("near-degenerate triangles", t, mesh_.size());
      if (sliver(mesh_[t])) open.push_back(t);
    }
    figures_.found = open.size();
    if (open.empty()) return figures_;
    for (int pass = 0; pass < max_passes && !open.empty(); ++pass) {
      const std::size_t before = open.size();
      Array<Index> left(soup_.memory());
      for (std::size_t i = 0; i < open.size(); ++i) {
        context_.host.report("near-degenerate triangles", i, open.size());
        const Index t = open[i];
        if (mesh_.alive(t) && sliver(mesh_[t]) && !mend(t)) left.push_back(t);
      }
      open = std::move(left);
      if (open.size() == before) break;
    }
    for (const Index t : open) {
      if (!mesh_.alive(t) || !sliver(mesh_[t])) continue;
      ++figures_.left;
      context_.record(Action::left_near_degenerate, centroid(soup_, mesh_[t]), height(mesh_[t]));
    }
    keep_triangles(soup_, mesh_.all_alive());
    return figures_;
  }

 private:
  const Vector3& at(Index v) const { return soup_.positions[v]; }
  bool sliver(const Triangle& t) const { return is_sliver(at(t[0]), at(t[1]), at(t[2]), ratio_, rounding_); }
  Vector3 normal(const Triangle& t) const { return (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])); }
  double length(const Triangle& t, Index k) const { return (at(t[(k + 1) % 3]) - at(t[k])).norm(); }
  // Over the longest edge.
  double height(const Triangle& t) const {
    const double longest = std::max({length(t, 0), length(t, 1), length(t, 2)});
    return longest > 0 ? normal(t).norm() / longest : 0;
  }

  bool mend(Index t) {
    const Triangle corners = mesh_[t];
    Index shortest = 0, longest = 0;
    for (Index k = 1; k < 3; ++k) {
      if (length(corners, k) < length(corners, shortest)) shortest = k;
      if (length(corners, k) >= length(corners, longest)) longest = k;
    }
    const Index a = corners[shortest], b = corners[(shortest + 1) % 3];
    const double edge = length(corners, shortest);
    const auto try_collapse = [&] { return collapse(a, b, edge) || collapse(b, a, edge); };
    if (height(corners) < cap_height * edge) return flip(t, longest) || try_collapse();
    return try_collapse() || flip(t, longest);
  }

  // The largest drift of the triangles at a vertex.
  double drift_around(Index u) const {
    double largest = 0;
    mesh_.for_each_at(u, [&](Index t, Index) {
      for (const Index v : mesh_[t])
        largest = std::max(largest, drift_[v]);
    });
    return largest;
  }

  // Moves vertex u to v, if it may.
  bool collapse(Index u, Index v, double edge) {
    const double drift = drift_around(u) + edge;
    if (!(drift <= max_move_)) return false;
    std::array<Index, 2> at_edge{};
    const std::size_t faces = mesh_.at_edge(u, v, at_edge);
    if (faces == 0 || faces > 2 || !has_simple_link(u, v, faces) || !keeps_shape(u, v)) return false;
    context_.record(Action::collapsed_edge, at(v), edge);
    for (std::size_t i = 0; i < faces; ++i)
      mesh_.remove(at_edge[i]);
    mesh_.replace(u, v);
    ++figures_.collapsed;
    add_drift(v, drift);
    return true;
  }

  void add_drift(Index v, double drift) {
    drift_[v] = std::max(drift_[v], drift);
    figures_.largest_move = std::max(figures_.largest_move, drift);
  }

  // Vertices next to the vertex, ascending; those of one face only are on the boundary.
  void collect_neighbors(Index u, Array<Index>& neighbors) const {
    neighbors.clear();
    mesh_.for_each_at(u, [&](Index t, Index k) {
      neighbors.push_back(mesh_[t][(k + 1) % 3]);
      neighbors.push_back(mesh_[t][(k + 2) % 3]);
    });
    std::sort(neighbors.begin(), neighbors.end());
  }
  // Whether every edge at the vertex has two faces; false for what is not manifold, too.
  static bool inner(const Array<Index>& neighbors) {
    for (std::size_t i = 0; i < neighbors.size(); i += 2) {
      if (i + 1 == neighbors.size() || neighbors[i] != neighbors[i + 1] ||
          (i + 2 < neighbors.size() && neighbors[i] == neighbors[i + 2]))
        return false;
    }
    return true;
  }

  // The link condition (Dey, Edelsbrunner, Guha and Nekhayev 1999), and that no face comes to lie on another.
  bool has_simple_link(Index u, Index v, std::size_t faces) {
    collect_neighbors(u, of_u_);
    collect_neighbors(v, of_v_);
    // A vertex of the boundary stays there, and none of it is drawn over an inner edge.
    if (!inner(of_u_) && (faces == 2 || inner(of_v_))) return false;
    const auto unique = [](Array<Index>& list) { list.erase(std::unique(list.begin(), list.end()), list.end()); };
    unique(of_u_), unique(of_v_);
    std::size_t common = 0;
    for (const Index w : of_u_)
      common += std::binary_search(of_v_.begin(), of_v_.end(), w);
    if (common != faces) return false;
    bool distinct = true;
    mesh_.for_each_at(u, [&](Index t, Index k) {
      const Index a = mesh_[t][(k + 1) % 3], b = mesh_[t][(k + 2) % 3];
      if (a == v || b == v) return;
      mesh_.for_each_at(v, [&](Index other, Index) {
        if (mesh_.has(other, a) && mesh_.has(other, b)) distinct = false;
      });
    });
    return distinct;
  }

  bool keeps_shape(Index u, Index v) const {
    bool fine = true;
    mesh_.for_each_at(u, [&](Index t, Index k) {
      if (!fine || mesh_.has(t, v)) return;
      Triangle moved = mesh_[t];
      moved[k] = v;
      if (sliver(mesh_[t])) return;
      fine = !sliver(moved) && normal(moved).dot(normal(mesh_[t])) > 0;
    });
    return fine;
  }

  // Flips edge k of triangle t, or removes the triangle if the edge is on the boundary.
  bool flip(Index t, Index k) {
    const Triangle corners = mesh_[t];
    const Index a = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
    std::array<Index, 2> at_edge{};
    const std::size_t faces = mesh_.at_edge(a, b, at_edge);
    const double moved = height(corners);
    double drift = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(faces, 2); ++i) {
      for (const Index v : mesh_[at_edge[i]])
        drift = std::max(drift, drift_[v]);
    }
    if (!(drift + moved <= max_move_)) return false;
    if (faces == 1) {
      if (!is_between(c, a, b)) return false;
      mesh_.remove(t);
      ++figures_.removed;
    } else {
      if (faces != 2) return false;
      const Index other = at_edge[0] == t ? at_edge[1] : at_edge[0];
      if (!flip_between(t, other, a, b, c)) return false;
      ++figures_.flipped;
    }
    context_.record(Action::flipped_edge, at(c), moved);
    add_drift(c, drift + moved);
    return true;
  }

  bool is_between(Index c, Index a, Index b) const {
    const Vector3 edge = at(b) - at(a);
    const double along = (at(c) - at(a)).dot(edge);
    return along > 0 && along < edge.squaredNorm();
  }

  bool flip_between(Index t, Index other, Index a, Index b, Index c) {
    const Index d = mesh_.third(other, a, b);
    const Triangle& o = mesh_[other];
    const bool opposite = (o[0] == b && o[1] == a) || (o[1] == b && o[2] == a) || (o[2] == b && o[0] == a);
    std::array<Index, 2> unused{};
    if (!opposite || d == c || mesh_.at_edge(c, d, unused) > 0) return false;
    const Triangle first{a, d, c}, second{d, b, c};
    const bool was = sliver(o);
    if (sliver(first) + sliver(second) >= 1 + was) return false;
    const Vector3 reference = normal(o);
    const auto agrees = [&](const Triangle& made) { return sliver(made) || was || normal(made).dot(reference) > 0; };
    if (!agrees(first) || !agrees(second)) return false;
    mesh_.set(t, first);
    mesh_.set(other, second);
    return true;
  }

  Soup& soup_;
  EditableTriangles mesh_;
  double ratio_, rounding_, max_move_;
  const Context& context_;
  // The triangles at a vertex are at most the largest of their corners' drifts away from where the surface was: each
  // step adds its movement to what it changes.
  Array<double> drift_;
  SliverFigures figures_;
  Array<Index> of_u_{soup_.memory()}, of_v_{soup_.memory()};
};

}  // namespace

SliverFigures remove_slivers(Soup& soup, double ratio, double max_move, const Context& context) {
  return Slivers(soup, ratio, max_move, context).run();
}

std::size_t count_slivers(const Soup& soup, double ratio) {
  const double rounding = mesh::rounding_unit(soup.positions, soup.triangles);
  return static_cast<std::size_t>(std::count_if(soup.triangles.begin(), soup.triangles.end(), [&](const Triangle& t) {
    return is_sliver(soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]], ratio, rounding);
  }));
}

}  // namespace orbicube::repair
