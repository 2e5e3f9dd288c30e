#include "polycube/map/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/intersections.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/connectivity.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/surface_check.h"
#include "mesh/topology/topology.h"
#include "polycube/map/embedding.h"

namespace orbicube::polycube {
namespace {

using mesh::Connectivity;

constexpr const char* certificate_phase = "certificate";
constexpr AxisLabel no_label = label_count;

Eigen::Vector2d in_plane(const Vector3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

// The direction in which a triangle looks, or no_label when it is in no axis-aligned plane or has no area.
AxisLabel exact_label(std::span<const Vector3> p, const Triangle& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[t[0]][axis] != p[t[1]][axis] || p[t[0]][axis] != p[t[2]][axis]) continue;
    const int sign = mesh::orientation_2d(in_plane(p[t[0]], axis), in_plane(p[t[1]], axis), in_plane(p[t[2]], axis));
    if (sign != 0) return label_of(axis, sign);
  }
  return no_label;
}

// Quarter turns, by exact comparisons, of directions that turn by less than half a turn at a time.
class QuarterTurns {
 public:
  // Directions of edges that look from the point `at` to others in a face that looks in the direction `label`.
  QuarterTurns(const Vector3& at, AxisLabel label)
      : at_(at), u_((axis_of(label) + 1) % 3), v_((axis_of(label) + 2) % 3) {
    if (sign_of(label) < 0) std::swap(u_, v_);
  }

  void start(const Vector3& to) {
    first_ = eighth(to);
    last_ = first_;
    turns_ = 0;
  }
  // A counter-clockwise turn by less than half a turn.
  void turn(const Vector3& to) {
    const int now = eighth(to);
    if (last_ >= 4 && now < 4) ++turns_;
    last_ = now;
  }
  // In eighths: even between directions along the axes.
  int eighths() const { return 8 * turns_ + last_ - first_; }

 private:
  // 0, 2, 4, 6 along the axes, odd numbers between them.
  int eighth(const Vector3& to) const {
    const int x = (to[u_] > at_[u_]) - (to[u_] < at_[u_]);
    const int y = (to[v_] > at_[v_]) - (to[v_] < at_[v_]);
    static constexpr std::array<std::array<int, 3>, 3> table = {{{5, 4, 3}, {6, 0, 2}, {7, 0, 1}}};
    return table[static_cast<std::size_t>(x + 1)][static_cast<std::size_t>(y + 1)];
  }

  const Vector3& at_;
  int u_, v_;
  int first_ = 0, last_ = 0, turns_ = 0;
};

class Certifier {
 public:
  Certifier(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host)
      : positions_(positions), triangles_(triangles), host_(host), result_(host.memory) {}

  Certificate run() {
    if (surface() && planes()) {
      const Connectivity connectivity(positions_.size(), triangles_, host_);
      patches(connectivity);
      if (fans(connectivity) && outward() && embedded(connectivity)) return std::move(result_);
    }
    return std::move(result_);
  }

 private:
  bool refuse(const std::string& reason) {
    result_.reason = reason;
    return false;
  }
  void report_now_and_then(std::size_t i) const {
    if (i % 4096 == 0) host_.report(certificate_phase, i, triangles_.size());
  }

  bool surface() {
    const mesh::Topology t = mesh::topology(positions_, triangles_, host_);
    try {
      mesh::require_closed_manifold(t);
    } catch (const base::Error& error) {
      return refuse(std::string(error.kind()) + ": " + error.what());
    }
    if (t.inconsistent_edges > 0) return refuse("neighboring triangles are oriented differently");
    result_.cavities = t.components - 1;
    // Euler's characteristic is 2 - 2 genus of each part.
    result_.genus = static_cast<std::int64_t>(t.components) - t.euler_characteristic / 2;
    return true;
  }

  bool planes() {
    result_.labels.resize(triangles_.size());
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      report_now_and_then(i);
      result_.labels[i] = exact_label(positions_, triangles_[i]);
      if (result_.labels[i] == no_label && wrong++ == 0) first = i;
    }
    if (wrong == 0) return true;
    return refuse(base::counted(wrong, "triangle lies", "triangles lie") +
                  " in no axis-aligned plane or have no area, the first is " + std::to_string(first));
  }

  void patches(const Connectivity& connectivity) {
    mesh::DisjointSets sets(triangles_.size(), host_.memory);
    for (Index h = 0; h < 3 * triangles_.size(); ++h) {
      report_now_and_then(h);
      const Index other = connectivity.opposite(h) / 3;
      if (result_.labels[h / 3] == result_.labels[other]) sets.unite(h / 3, other);
    }
    result_.patches.assign(triangles_.size(), no_index);
    for (Index i = 0; i < triangles_.size(); ++i) {
      const Index root = sets.find(i);  // the lowest of its set, so it has its number already
      result_.patches[i] = root == i ? static_cast<Index>(result_.patch_count++) : result_.patches[root];
    }
  }

  bool fans(const Connectivity& connectivity) {
    for (Index v = 0; v < positions_.size(); ++v) {
      report_now_and_then(v);
      const Index any = connectivity.outgoing(v);
      if (any != no_index && !turns_once(connectivity, v, any)) return false;
    }
    return true;
  }

  // Walks counter-clockwise round the vertex, one patch of the polycube after the other.
  bool turns_once(const Connectivity& connectivity, Index vertex, Index any) {
    const auto label = [&](Index h) { return result_.labels[h / 3]; };
    const auto turned = [&](Index h) { return connectivity.opposite(Connectivity::previous(h)); };
    Index first = any;  // the first half-edge of a face, if there is more than one
    for (Index h = turned(any); h != any; h = turned(h)) {
      if (label(h) == label(connectivity.opposite(h))) continue;
      first = h;
      break;
    }
    const bool inside = label(first) == label(connectivity.opposite(first));
    std::size_t faces = 0;
    std::size_t straight = 0;
    Index h = first;
    do {
      QuarterTurns turns(positions_[vertex], label(h));
      turns.start(positions_[connectivity.end(h)]);
      Index next = h;
      do {
        turns.turn(positions_[connectivity.start(Connectivity::previous(next))]);
        next = turned(next);
      } while (next != first && label(next) == label(h));
      const int eighths = turns.eighths();
      if (inside ? eighths != 8 : (eighths % 2 != 0 || eighths < 2 || eighths > 6))
        return refuse("the triangles around vertex " + std::to_string(vertex) + " turn by " +
                      base::counted(eighths, "eighth") + " within one patch of the polycube");
      ++faces;
      straight += eighths == 4;
      h = next;
    } while (h != first);
    if (faces == 2 && straight != 2)
      return refuse("an edge of the polycube turns at vertex " + std::to_string(vertex) + ", which is no corner");
    result_.corners += faces >= 3;
    return true;
  }

  // The face of a part that is farthest along an axis looks along it where the part is outward-oriented. One part does;
  // whether the others are cavities within that is seen where no two meet (embedding.h).
  bool outward() {
    mesh::DisjointSets parts(positions_.size(), host_.memory);
    for (const Triangle& t : triangles_) {
      parts.unite(t[0], t[1]);
      parts.unite(t[0], t[2]);
    }
    Array<Index> farthest(positions_.size(), no_index, host_.memory);  // of the part with that root
    for (Index i = 0; i < triangles_.size(); ++i) {
      report_now_and_then(i);
      if (axis_of(result_.labels[i]) != 0) continue;
      Index& of_part = farthest[parts.find(triangles_[i][0])];
      if (of_part == no_index || positions_[triangles_[i][0]].x() > positions_[triangles_[of_part][0]].x()) of_part = i;
    }
    std::size_t outward = 0;
    for (const Index i : farthest)
      outward += i != no_index && sign_of(result_.labels[i]) > 0;
    if (outward == 1) return true;
    return refuse(outward == 0 ? "the polycube is inward-oriented"
                               : base::counted(outward, "component is", "components are") +
                                     " outward-oriented; a solid has one, and cavities");
  }

  bool embedded(const Connectivity& connectivity) {
    constexpr std::size_t max_cells = 10'000'000;
    const auto contact =
        embedding_fault(positions_, triangles_, result_.labels, result_.patches, connectivity, max_cells, host_);
    if (contact) return contact->empty() || refuse(*contact);
    if (result_.cavities > 0) return refuse("there are too many corners to see where cavities lie");
    constexpr std::size_t most = 1;
    const auto pairs = mesh::intersecting_triangles(positions_, triangles_, host_, most);
    if (pairs.empty()) return true;
    return refuse("the polycube meets itself, first in triangles " + std::to_string(pairs[0][0]) + " and " +
                  std::to_string(pairs[0][1]));
  }

  std::span<const Vector3> positions_;
  std::span<const Triangle> triangles_;
  const base::Host& host_;
  Certificate result_;
};

}  // namespace

Certificate certify(std::span<const Vector3> polycube, std::span<const Triangle> triangles, const base::Host& host) {
  mesh::require_valid_surface(polycube, triangles, host);
  return Certifier(polycube, triangles, host).run();
}

Certificate certify(SurfaceMap& map, const base::Host& host) {
  Certificate certificate = certify(map.polycube, map.triangles, host);
  if (certificate.valid()) {
    map.labels = certificate.labels;
    map.patches = certificate.patches;
  }
  return certificate;
}

}  // namespace orbicube::polycube
