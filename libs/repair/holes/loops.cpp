#include "repair/holes/loops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/grouping.h"
#include "mesh/search/vertex_measures.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::repair {
namespace {

using mesh::end_of;
using mesh::start_of;

class Loops {
 public:
  Loops(const Soup& soup, const base::Host& host)
      : soup_(soup), host_(host), boundary_(host.memory), done_(3 * soup.triangles.size(), 0, host.memory) {
    const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (edges.half_edges(e).size() == 1) boundary_.push_back(edges.half_edges(e)[0]);
    }
    std::sort(boundary_.begin(), boundary_.end());
    out_.assign(soup.positions.size(), [&](const auto& visit) {
      for (const Index h : boundary_)
        visit(start_of(soup.triangles, h), h);
    });
  }

  BoundaryLoops run() {
    BoundaryLoops loops(host_.memory);
    if (boundary_.empty()) return loops;
    find_normals();
    Array<Index> on_path(soup_.positions.size(), no_index, host_.memory);  // position in the path of its start
    Array<Index> path(host_.memory);
    for (const Index first : boundary_) {
      if (done_[first] != 0) continue;
      path.clear();
      for (Index h = first; h != no_index; h = next(h)) {
        done_[h] = 1;
        on_path[start_of(soup_.triangles, h)] = static_cast<Index>(path.size());
        path.push_back(h);
        // A vertex that the path was at before ends a loop, which is taken out of it.
        const Index begin = on_path[end_of(soup_.triangles, h)];
        if (begin == no_index) continue;
        for (std::size_t i = begin; i < path.size(); ++i) {
          on_path[start_of(soup_.triangles, path[i])] = no_index;
          loops.half_edges.push_back(path[i]);
        }
        loops.begin.push_back(loops.half_edges.size());
        path.resize(begin);
        if (path.empty()) break;
      }
      for (const Index h : path)
        on_path[start_of(soup_.triangles, h)] = no_index;
      loops.tangled_edges += path.size();
    }
    return loops;
  }

 private:
  void find_normals() {
    const bool simple = std::all_of(boundary_.begin(), boundary_.end(),
                                    [&](Index h) { return out_.size(start_of(soup_.triangles, h)) == 1; });
    if (!simple) normals_ = mesh::vertex_normals(soup_.positions, soup_.triangles, host_);
  }

  // The boundary edge that follows at the end of h: at a vertex of several holes the nearest one across the hole, which
  // lies counter-clockwise of h seen from outside.
  Index next(Index h) const {
    const Index v = end_of(soup_.triangles, h);
    Index best = no_index;
    double least = 0;
    for (const Index candidate : out_[v]) {
      if (done_[candidate] != 0) continue;
      const double angle =
          out_.size(v) == 1 ? 0 : turn(v, start_of(soup_.triangles, h), end_of(soup_.triangles, candidate));
      if (best != no_index && !(angle < least)) continue;
      best = candidate;
      least = angle;
    }
    return best;
  }

  // From the direction of one vertex to that of another, counter-clockwise around the normal at v; 0 to 2 pi.
  double turn(Index v, Index from, Index to) const {
    const Vector3& n = normals_[v];
    const Vector3 a = soup_.positions[from] - soup_.positions[v], b = soup_.positions[to] - soup_.positions[v];
    const Vector3 flat_a = a - n * n.dot(a), flat_b = b - n * n.dot(b);
    const double angle = std::atan2(n.dot(flat_a.cross(flat_b)), flat_a.dot(flat_b));
    return angle > 0 ? angle : angle + 2 * std::numbers::pi;
  }

  const Soup& soup_;
  const base::Host& host_;
  Array<Index> boundary_;
  Array<std::uint8_t> done_;
  base::Groups<Index, Index> out_{soup_.memory()};
  Array<Vector3> normals_{soup_.memory()};
};

}  // namespace

BoundaryLoops boundary_loops(const Soup& soup, const base::Host& host) {
  return Loops(soup, host).run();
}

}  // namespace orbicube::repair
