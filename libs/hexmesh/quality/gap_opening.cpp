#include "hexmesh/quality/gap_opening.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/grouping.h"
#include "mesh/search/intersections.h"

namespace orbicube::hexmesh {
namespace {

constexpr const char* gap_opening_phase = "open gaps";

class GapOpening {
 public:
  GapOpening(HexMesh& mesh, const base::Host& host)
      : mesh_(mesh),
        host_(host),
        around_(base::cells_around(std::span<const Hexahedron>(mesh.hexahedra), mesh.positions.size(), host.memory)),
        meetings_(host.memory),
        deep_(host.memory) {}

  bool run() {
    constexpr int max_rounds = 40, patience = 6;  // rounds without fewer pairs
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    int waited = 0;
    for (int round = 0; round < max_rounds; ++round) {
      host_.report(gap_opening_phase, static_cast<std::uint64_t>(round), max_rounds);
      const std::size_t pairs = find_meetings();
      if (pairs == 0) return true;
      waited = pairs < fewest ? 0 : waited + 1;
      fewest = std::min(fewest, pairs);
      if (waited > patience || !part()) return false;
    }
    return false;
  }

 private:
  // Two quads that intersected once, to be on either side of a plane.
  struct Meeting {
    std::array<Index, 2> quads;
    Vector3 normal;  // of the plane, from the first to the second
    double margin;   // between the quads
  };

  Vector3 normal_of(Index quad) const {
    const Quad& q = mesh_.quads[quad];
    const auto at = [&](std::size_t k) { return mesh_.positions[q[k]]; };
    return (at(2) - at(0)).cross(at(3) - at(1));
  }

  // Quads that intersect now, beside those that did; deep ones, as sides of ends that are pushed into each other, only
  // where there are no others, whose parting parts most of them, too. Returns how many intersect.
  std::size_t find_meetings() {
    const auto pairs = mesh::intersecting_quads(mesh_.positions, mesh_.quads, host_);
    const std::size_t before = meetings_.size();
    bool others = false;
    deep_.clear();
    for (const auto& pair : pairs) {
      const auto end = meetings_.begin() + static_cast<std::ptrdiff_t>(before);
      const auto known =
          std::lower_bound(meetings_.begin(), end, pair, [](const Meeting& m, const auto& p) { return m.quads < p; });
      if (known != end && known->quads == pair) {
        known->margin *= 2;
        others = true;
      } else {
        add(pair);
      }
    }
    others |= meetings_.size() > before;
    if (!others) meetings_.insert(meetings_.end(), deep_.begin(), deep_.end());
    std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) { return a.quads < b.quads; });
    return pairs.size();
  }

  void add(const std::array<Index, 2>& pair) {
    constexpr double min_margin = 1e-3, deep = 0.35;  // of the length of a quad
    const Quad &p = mesh_.quads[pair[0]], &q = mesh_.quads[pair[1]];
    const Vector3 a = normal_of(pair[0]), b = normal_of(pair[1]);
    const Vector3 n = direction(p, q, a.normalized(), b.normalized());
    if (n.norm() == 0) return;
    const double length = std::sqrt(std::min(a.norm(), b.norm()));
    (overlap(p, q, n) > deep * length ? deep_ : meetings_).push_back({pair, n, min_margin * length});
  }

  // Along which the minimum of a way parts quads with these normals, among those against which they look and that are
  // normal to a quad or to two edges; 0: there is none.
  Vector3 direction(const Quad& p, const Quad& q, const Vector3& a, const Vector3& b) const {
    constexpr double against = 0.7;  // the sum of the cosines
    Vector3 best = Vector3::Zero();
    double least = std::numeric_limits<double>::infinity();
    // Neighbors turn about the edge that they share.
    const Vector3 hinge = shared_edge(p, q);
    const auto attempt = [&](Vector3 n, double dearer) {
      n -= hinge.dot(n) * hinge;
      const double length = n.norm();
      if (!(length > 0)) return;
      n *= ((a - b).dot(n) < 0 ? -1 : 1) / length;
      if ((a - b).dot(n) < against) return;
      const double cost = dearer * overlap(p, q, n);
      if (cost >= least) return;
      least = cost;
      best = n;
    };
    // Neighbors are to go the same way, so that what is normal to edges only, which has many directions, must be much
    // shorter.
    constexpr double of_edges = 4;
    attempt(a, 1);
    attempt(-b, 1);
    attempt(a - b, 1);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3 u = mesh_.positions[p[(i + 1) % 4]] - mesh_.positions[p[i]];
      for (std::size_t k = 0; k < 4; ++k)
        attempt(u.normalized().cross((mesh_.positions[q[(k + 1) % 4]] - mesh_.positions[q[k]]).normalized()), of_edges);
    }
    return best;
  }

  static bool has(const Quad& quad, Index v) { return std::find(quad.begin(), quad.end(), v) != quad.end(); }

  // Of length 1, or 0 where quads share at most a vertex.
  Vector3 shared_edge(const Quad& p, const Quad& q) const {
    Vector3 edge = Vector3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      if (has(q, p[i]) && has(q, p[(i + 1) % 4])) edge = mesh_.positions[p[(i + 1) % 4]] - mesh_.positions[p[i]];
    }
    return edge.norm() > 0 ? Vector3(edge.normalized()) : edge;
  }

  // How far the vertices of the first quad reach along a direction, where those of the second begin, and the plane
  // between: through what they share, which is left out of both, else in the middle.
  struct Sides {
    double top, bottom, middle;
  };
  Sides sides(const Quad& p, const Quad& q, const Vector3& n) const {
    double top = -std::numeric_limits<double>::infinity(), bottom = -top, sum = 0;
    int shared = 0;
    for (const Index v : p) {
      const double height = n.dot(mesh_.positions[v]);
      if (has(q, v))
        sum += height, ++shared;
      else
        top = std::max(top, height);
    }
    for (const Index v : q) {
      if (!has(p, v)) bottom = std::min(bottom, n.dot(mesh_.positions[v]));
    }
    return {top, bottom, shared == 0 ? 0.5 * (top + bottom) : sum / shared};
  }
  // By how much they are on the wrong sides, twice that of the worse one; negative where both are on the right ones.
  double overlap(const Quad& p, const Quad& q, const Vector3& n) const {
    const Sides s = sides(p, q, n);
    return 2 * std::max(s.top - s.middle, s.middle - s.bottom);
  }

  // Moves quads that met to both sides of their planes, as far as there is room. Returns whether any moved.
  bool part() {
    constexpr int max_sweeps = 60;
    bool any = false;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
      bool moved = false;
      for (const Meeting& meeting : meetings_)
        moved |= part(meeting);
      any |= moved;
      if (!moved) break;
    }
    return any;
  }

  bool part(const Meeting& meeting) {
    const Quad &p = mesh_.quads[meeting.quads[0]], &q = mesh_.quads[meeting.quads[1]];
    const Vector3& n = meeting.normal;
    const Sides s = sides(p, q, n);
    if (s.middle - s.top >= 0.5 * meeting.margin && s.bottom - s.middle >= 0.5 * meeting.margin) return false;
    const double half = 0.55 * meeting.margin;  // a little more, so that a sum of small steps ends
    bool moved = false;
    for (const Index v : p) {
      if (!has(q, v)) moved |= move(v, std::min(0.0, s.middle - half - n.dot(mesh_.positions[v])) * n);
    }
    for (const Index v : q) {
      if (!has(p, v)) moved |= move(v, std::max(0.0, s.middle + half - n.dot(mesh_.positions[v])) * n);
    }
    return moved;
  }

  double worst_around(Index v) const {
    double worst = 1;
    for (const Index h : around_[v])
      worst = std::min({worst, scaled_jacobian(mesh_.positions, mesh_.hexahedra[h]),
                        6 * min_bezier(mesh_.positions, mesh_.hexahedra[h])});
    return worst;
  }

  bool move(Index v, const Vector3& by) {
    constexpr double floor = 0.1;
    if (by.squaredNorm() == 0) return false;
    Vector3& x = mesh_.positions[v];
    const Vector3 from = x;
    const double least = std::min(floor, worst_around(v));
    for (const double part : {1.0, 0.5, 0.25}) {
      x = from + part * by;
      if (worst_around(v) >= least) return true;
    }
    x = from;
    return false;
  }

  HexMesh& mesh_;
  const base::Host& host_;
  base::Groups<Index, Index> around_;
  Array<Meeting> meetings_, deep_;  // those that are parted, and those that wait
};

}  // namespace

bool open_gaps(HexMesh& mesh, const base::Host& host) {
  return GapOpening(mesh, host).run();
}

}  // namespace orbicube::hexmesh
