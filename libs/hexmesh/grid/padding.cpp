#include "hexmesh/grid/padding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace orbicube::hexmesh {
namespace {

// An edge of the boundary, with the two quads that meet there: the first has it from `start` to `end`.
struct BoundaryEdge {
  Index start, end;
  Index first, second;
};

Array<BoundaryEdge> edges_of_boundary(std::span<const Quad> quads, std::pmr::memory_resource* memory) {
  Array<std::array<Index, 3>> sides(memory);  // least vertex, largest vertex, 4 quad + corner
  for (Index i = 0; i < quads.size(); ++i) {
    for (Index k = 0; k < 4; ++k) {
      const Index a = quads[i][k], b = quads[i][(k + 1) % 4];
      sides.push_back({std::min(a, b), std::max(a, b), 4 * i + k});
    }
  }
  std::sort(sides.begin(), sides.end());
  Array<BoundaryEdge> result(memory);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const Index side = sides[i][2], other = sides[i + 1][2];
    result.push_back({quads[side / 4][side % 4], quads[side / 4][(side + 1) % 4], side / 4, other / 4});
  }
  return result;
}

// How many hexahedra are around each of the edges: 1 where the polycube turns outwards, 3 where it turns inwards.
Array<Index> hexahedra_around(const HexMesh& mesh, std::span<const BoundaryEdge> edges,
                              std::pmr::memory_resource* memory) {
  const auto sorted = [](Index a, Index b) { return std::array{std::min(a, b), std::max(a, b)}; };
  Array<std::array<Index, 2>> all(memory);
  all.reserve(12 * mesh.hexahedra.size());
  for (const Hexahedron& h : mesh.hexahedra) {
    for (std::size_t k = 0; k < 8; ++k) {
      for (const std::uint8_t n : corner_neighbors[k]) {
        if (k < n) all.push_back(sorted(h[k], h[n]));
      }
    }
  }
  std::sort(all.begin(), all.end());
  Array<Index> result(memory);
  for (const BoundaryEdge& e : edges) {
    const auto [begin, end] = std::equal_range(all.begin(), all.end(), sorted(e.start, e.end));
    result.push_back(static_cast<Index>(end - begin));
  }
  return result;
}

// The angle inside the solid at an edge.
double angle_at(const HexMesh& mesh, const BoundaryEdge& e) {
  const auto normal = [&](Index quad) -> Vector3 {
    const Quad& q = mesh.quads[quad];
    return (mesh.positions[q[2]] - mesh.positions[q[0]])
        .cross(mesh.positions[q[3]] - mesh.positions[q[1]])
        .normalized();
  };
  const Vector3 m = normal(e.first), n = normal(e.second);
  const Vector3 along = (mesh.positions[e.end] - mesh.positions[e.start]).normalized();
  return std::numbers::pi - std::atan2(m.cross(n).dot(along), m.dot(n));
}

// The cost of an angle shared by the given number of hexahedra: 0 for right angles, and much where they become flat, by
// their scaled Jacobians. A few bad ones are worse than many that are a little askew.
double loss(double angle, double hexahedra) {
  constexpr double least = 0.1;
  const double each = angle / hexahedra;
  const double jacobian = each < std::numbers::pi ? std::sin(each) : 0;
  const double lost = 1 / std::max(jacobian, least) - 1;
  return lost * lost;
}

// Groups of faces that are padded together, and what it costs to pad them: a cost for each, and for each two that meet.
class Choice {
 public:
  Choice(const HexMesh& mesh, const base::Host& host) : host_(host), group_(host.memory), borders_(host.memory) {
    Index patches = 0;
    for (const Index patch : mesh.quad_patches)
      patches = std::max(patches, patch + 1);
    const auto edges = edges_of_boundary(mesh.quads, host.memory);
    const auto around = hexahedra_around(mesh, edges, host.memory);
    host.report("padding", 0, 0);
    const auto patch_of = [&](Index quad) { return mesh.quad_patches[quad]; };
    group_.resize(patches);
    std::iota(group_.begin(), group_.end(), Index{0});
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (around[i] != 1) join(patch_of(edges[i].first), patch_of(edges[i].second));
    }
    number_groups();
    own_.assign(groups_, 0);
    together_.assign(groups_ * groups_, 0);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Index a = group_[patch_of(edges[i].first)], b = group_[patch_of(edges[i].second)];
      if (a != b) borders_.push_back({edges[i].start, edges[i].end, a, b});
      if (around[i] == 2) continue;
      const double angle = angle_at(mesh, edges[i]);
      // With a layer two hexahedra share the angle, and an edge of three or five is inside.
      const double inner = around[i] == 1 ? 3 : 5;
      const double more =
          loss(angle, 2) + loss(2 * std::numbers::pi, inner) - loss(angle, static_cast<double>(around[i]));
      if (a == b) {
        own_[a] += more;
      } else {
        together_[a * groups_ + b] += more;
        together_[b * groups_ + a] += more;
      }
    }
    ends_.assign(mesh.positions.size(), 0);
  }

  // The best that flips of one or two groups lead to from all and from none.
  Array<std::uint8_t> best() {
    Array<std::uint8_t> best(groups_, 0, host_.memory), now(host_.memory);
    descend(best);
    now.assign(groups_, 1);
    descend(now);
    if (cost(now) < cost(best)) best = now;
    Array<std::uint8_t> of_patches(host_.memory);
    for (const Index g : group_)
      of_patches.push_back(best[g]);
    return of_patches;
  }

 private:
  struct Border {
    Index start, end;
    Index first, second;  // groups
  };

  Index root(Index patch) {
    while (group_[patch] != patch)
      patch = group_[patch] = group_[group_[patch]];
    return patch;
  }
  void join(Index a, Index b) {
    const Index x = root(a), y = root(b);
    group_[std::max(x, y)] = std::min(x, y);
  }
  void number_groups() {
    Array<Index> number(group_.size(), no_index, host_.memory);
    for (Index p = 0; p < group_.size(); ++p) {
      // The root is the minimum of its group.
      const Index r = root(p);
      if (r == p) number[p] = static_cast<Index>(groups_++);
      number[p] = number[r];
    }
    group_ = number;
  }

  double cost(std::span<const std::uint8_t> padded) const {
    double sum = 0;
    for (std::size_t a = 0; a < groups_; ++a) {
      if (padded[a] == 0) continue;
      sum += own_[a];
      for (std::size_t b = 0; b < a; ++b) {
        if (padded[b] != 0) sum += together_[a * groups_ + b];
      }
    }
    return sum;
  }

  // A vertex has one outer copy: what is padded around it lies side by side.
  bool possible(std::span<const std::uint8_t> padded) {
    bool result = true;
    for (const Border& b : borders_) {
      if (padded[b.first] == padded[b.second]) continue;
      for (const Index v : {b.start, b.end})
        result = ++ends_[v] <= 2 && result;
    }
    for (const Border& b : borders_)
      ends_[b.start] = ends_[b.end] = 0;
    return result;
  }

  void descend(Array<std::uint8_t>& padded) {
    double now = cost(padded);
    for (bool better = true; better;) {
      better = false;
      host_.report("padding", 0, 0);
      for (std::size_t a = 0; a < groups_; ++a) {
        for (std::size_t b = a; b < groups_; ++b) {
          const auto flip = [&] {
            padded[a] ^= 1;
            if (b != a) padded[b] ^= 1;
          };
          flip();
          const double then = cost(padded);
          if (then < now - 1e-9 && possible(padded)) {
            now = then;
            better = true;
          } else {
            flip();
          }
        }
      }
    }
  }

  const base::Host& host_;
  Array<Index> group_;  // of each patch of the polycube
  Array<Border> borders_;
  std::size_t groups_ = 0;
  Array<double> own_{host_.memory}, together_{host_.memory};
  Array<std::uint8_t> ends_{host_.memory};  // of borders between padded and other faces, at each vertex
};

}  // namespace

Array<std::uint8_t> choose_padding(const HexMesh& mesh, const base::Host& host) {
  return Choice(mesh, host).best();
}

void pad(HexMesh& mesh, std::span<const std::uint8_t> padded, double cell_length, const base::Host& host) {
  constexpr double depth = 0.25;
  const std::size_t before = mesh.positions.size();
  Array<Vector3> normal(before, Vector3::Zero(), host.memory);
  Array<Index> outer(before, no_index, host.memory);
  // Before quads move outwards: they are distinguished by the vertices that they share.
  const auto edges = edges_of_boundary(mesh.quads, host.memory);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    if (padded[mesh.quad_patches[i]] == 0) continue;
    Quad& q = mesh.quads[i];
    const Vector3 n = (mesh.positions[q[2]] - mesh.positions[q[0]]).cross(mesh.positions[q[3]] - mesh.positions[q[1]]);
    Hexahedron h{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Index v = q[k];
      normal[v] += n;
      if (outer[v] == no_index) {
        outer[v] = static_cast<Index>(mesh.positions.size());
        mesh.positions.push_back(Vector3(mesh.positions[v]));
      }
      h[k] = v;
      h[k + 4] = q[k] = outer[v];
    }
    mesh.hexahedra.push_back(h);
  }
  for (const BoundaryEdge& e : edges) {
    const Index first = mesh.quad_patches[e.first], second = mesh.quad_patches[e.second];
    if (padded[first] == padded[second]) continue;
    // Counter-clockwise for what is padded, which the side prolongs upwards.
    const auto [a, b] = padded[first] != 0 ? std::pair(e.start, e.end) : std::pair(e.end, e.start);
    mesh.quads.push_back({a, b, outer[b], outer[a]});
    mesh.quad_patches.push_back(padded[first] != 0 ? second : first);
  }
  for (std::size_t v = 0; v < before; ++v) {
    const double length = normal[v].norm();
    if (length > 0) mesh.positions[v] -= depth * cell_length / length * normal[v];
  }
}

}  // namespace orbicube::hexmesh
