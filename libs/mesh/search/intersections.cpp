// Two triangles meet when an edge of one meets the other; with a shared vertex, when the edge opposite to it does; with
// a shared edge, when they lie in one plane on the same side of it. Each of these is a few signs of orientation.
#include "mesh/search/intersections.h"

#include <algorithm>
#include <vector>

#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/nearest.h"
#include "mesh/search/predicates.h"

namespace orbicube::mesh {
namespace {

using Corners = std::array<Vector3, 3>;
using Flat = Eigen::Vector2d;

Flat without_axis(const Vector3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

// An axis along which the triangle does not look like a line, or -1 when it is one.
int projection_axis(const Corners& t) {
  for (int axis = 0; axis < 3; ++axis) {
    if (orientation_2d(without_axis(t[0], axis), without_axis(t[1], axis), without_axis(t[2], axis)) != 0) return axis;
  }
  return -1;
}

// Segments of one line or none: whether c, which lies on the line through a and b, is between them.
bool between(const Flat& a, const Flat& b, const Flat& c) {
  return (c.array() >= a.cwiseMin(b).array()).all() && (c.array() <= a.cwiseMax(b).array()).all();
}

bool segments_meet(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
  const int c_side = orientation_2d(a, b, c), d_side = orientation_2d(a, b, d);
  const int a_side = orientation_2d(c, d, a), b_side = orientation_2d(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && between(a, b, c)) || (d_side == 0 && between(a, b, d)) || (a_side == 0 && between(c, d, a)) ||
         (b_side == 0 && between(c, d, b));
}

// In the plane of the triangle.
bool segment_meets_in_plane(const Vector3& p, const Vector3& q, const Corners& t) {
  const int axis = projection_axis(t);
  const Flat from = without_axis(p, axis), to = without_axis(q, axis);
  const std::array<Flat, 3> c = {without_axis(t[0], axis), without_axis(t[1], axis), without_axis(t[2], axis)};
  int least = 1, most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const int side = orientation_2d(c[k], c[(k + 1) % 3], from);
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least >= 0 || most <= 0) return true;  // one end is inside
  for (std::size_t k = 0; k < 3; ++k) {
    if (segments_meet(from, to, c[k], c[(k + 1) % 3])) return true;
  }
  return false;
}

// p_side and q_side: on which side of the triangle's plane the ends are.
bool segment_meets(const Vector3& p, int p_side, const Vector3& q, int q_side, const Corners& t) {
  if (p_side * q_side > 0) return false;
  if (p_side == 0 && q_side == 0) return segment_meets_in_plane(p, q, t);
  const int a = orientation_3d(p, q, t[0], t[1]);
  const int b = orientation_3d(p, q, t[1], t[2]);
  if (a * b < 0) return false;
  const int c = orientation_3d(p, q, t[2], t[0]);
  return a * c >= 0 && b * c >= 0;
}

std::array<int, 3> sides(const Corners& of, const Corners& plane) {
  std::array<int, 3> result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = orientation_3d(plane[0], plane[1], plane[2], of[k]);
  return result;
}

bool all_on_one_side(const std::array<int, 3>& side) {
  return side[0] * side[1] > 0 && side[1] * side[2] > 0;
}

bool disjoint_triangles_meet(const Corners& p, const Corners& q) {
  const auto q_sides = sides(q, p);
  if (all_on_one_side(q_sides)) return false;
  const auto p_sides = sides(p, q);
  if (all_on_one_side(p_sides)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (segment_meets(q[k], q_sides[k], q[next], q_sides[next], p)) return true;
    if (segment_meets(p[k], p_sides[k], p[next], p_sides[next], q)) return true;
  }
  return false;
}

// Both with the shared vertex first.
bool meet_beyond_vertex(const Corners& p, const Corners& q) {
  const int q1 = orientation_3d(p[0], p[1], p[2], q[1]), q2 = orientation_3d(p[0], p[1], p[2], q[2]);
  if (q1 * q2 > 0) return false;
  const int p1 = orientation_3d(q[0], q[1], q[2], p[1]), p2 = orientation_3d(q[0], q[1], q[2], p[2]);
  return segment_meets(q[1], q1, q[2], q2, p) || segment_meets(p[1], p1, p[2], p2, q);
}

// Both with the shared edge first.
bool meet_beyond_edge(const Corners& p, const Corners& q) {
  if (orientation_3d(p[0], p[1], p[2], q[2]) != 0) return false;
  const int axis = projection_axis(p);
  const auto side = [&](const Vector3& x) {
    return orientation_2d(without_axis(p[0], axis), without_axis(p[1], axis), without_axis(x, axis));
  };
  return side(p[2]) * side(q[2]) > 0;
}

using Pair = std::array<Index, 2>;
using Quad = std::array<Index, 4>;

// Pairs of items whose boxes overlap and for which `meet(i, j)` is true, i <= j, ascending; pairs of an item with
// itself are included. Blocks of items are searched side by side and put together in their order.
template <class Meet>
Array<Pair> meeting_pairs(std::span<const Box> boxes, std::size_t most, const base::Host& host, const Meet& meet) {
  const BoundingVolumeTree tree(boxes, host);
  constexpr std::size_t block = 128, blocks_at_once = 16;
  std::array<std::vector<Pair>, blocks_at_once> found;
  Array<Pair> result(host.memory);
  for (std::size_t first = 0; first < boxes.size() && result.size() < most; first += block * blocks_at_once) {
    host.report("finding intersections", first, boxes.size());
    host.parallel_for(blocks_at_once, [&](std::size_t i) {
      const std::size_t begin = std::min(first + i * block, boxes.size());
      const std::size_t end = std::min(begin + block, boxes.size());
      std::vector<Pair>& pairs = found[i];
      pairs.clear();
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t before = pairs.size();
        const auto item = static_cast<Index>(k);
        tree.for_each_near(boxes[k], [&](Index other) {
          if (other >= item && boxes[k].overlaps(boxes[other]) && meet(item, other)) pairs.push_back({item, other});
        });
        std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(before), pairs.end());
      }
    });
    for (const std::vector<Pair>& pairs : found) {
      const auto target = static_cast<std::ptrdiff_t>(std::min(pairs.size(), most - result.size()));
      result.insert(result.end(), pairs.begin(), pairs.begin() + target);
    }
  }
  return result;
}

// The halves by both diagonals.
std::array<Triangle, 4> halves_of(const Quad& q) {
  return {{{q[0], q[1], q[2]}, {q[0], q[2], q[3]}, {q[0], q[1], q[3]}, {q[1], q[2], q[3]}}};
}

Box box_of(std::span<const Vector3> positions, const Triangle& t) {
  Box box;
  for (const Index v : t)
    box.add(positions[v]);
  return box;
}

// Whether the two halves of a diagonal lie over each other.
bool lies_over_itself(std::span<const Vector3> positions, const Quad& q) {
  const auto folds = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    const Corners one = {positions[q[a]], positions[q[c]], positions[q[b]]};
    const Corners other = {positions[q[a]], positions[q[c]], positions[q[d]]};
    return projection_axis(one) >= 0 && projection_axis(other) >= 0 && meet_beyond_edge(one, other);
  };
  return folds(0, 1, 2, 3) || folds(1, 2, 3, 0);
}

}  // namespace

bool triangles_intersect(std::span<const Vector3> positions, const Triangle& p, const Triangle& q) {
  // The shared vertices first, in the same order in both.
  Triangle a = p, b = q;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
    if (found == b.end()) continue;
    std::swap(b[shared], *found);
    std::swap(a[shared], a[i]);
    ++shared;
  }
  const auto corners = [&](const Triangle& t) { return Corners{positions[t[0]], positions[t[1]], positions[t[2]]}; };
  switch (shared) {
    case 0:
      return disjoint_triangles_meet(corners(a), corners(b));
    case 1:
      return meet_beyond_vertex(corners(a), corners(b));
    case 2:
      return meet_beyond_edge(corners(a), corners(b));
    default:
      return true;
  }
}

bool quads_intersect(std::span<const Vector3> positions, const Quad& p, const Quad& q) {
  const auto shared =
      std::count_if(p.begin(), p.end(), [&](Index v) { return std::find(q.begin(), q.end(), v) != q.end(); });
  if (shared >= 3) return true;
  const std::array<Triangle, 4> p_halves = halves_of(p), q_halves = halves_of(q);
  const auto has_area = [&](const Triangle& t) {
    return projection_axis({positions[t[0]], positions[t[1]], positions[t[2]]}) >= 0;
  };
  std::array<Box, 4> boxes;
  std::array<bool, 4> counts{};
  for (std::size_t k = 0; k < 4; ++k) {
    boxes[k] = box_of(positions, q_halves[k]);
    counts[k] = has_area(q_halves[k]);
  }
  for (const Triangle& half : p_halves) {
    const Box box = box_of(positions, half);
    if (!has_area(half)) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (counts[k] && box.overlaps(boxes[k]) && triangles_intersect(positions, half, q_halves[k])) return true;
    }
  }
  return false;
}

Array<Pair> intersecting_triangles(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                   const base::Host& host, std::size_t most) {
  const Array<Box> boxes = boxes_of(positions, triangles, host);
  Array<std::uint8_t> has_area(triangles.size(), 0, host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 4096 == 0) host.report("finding flat triangles", t, triangles.size());
    const Triangle& c = triangles[t];
    has_area[t] = projection_axis({positions[c[0]], positions[c[1]], positions[c[2]]}) >= 0;
  }
  return meeting_pairs(boxes, most, host, [&](Index t, Index other) {
    return t != other && has_area[t] && has_area[other] &&
           triangles_intersect(positions, triangles[t], triangles[other]);
  });
}

Array<Pair> intersecting_quads(std::span<const Vector3> positions, std::span<const Quad> quads, const base::Host& host,
                               std::size_t most) {
  Array<Box> boxes(quads.size(), Box(), host.memory);
  for (std::size_t i = 0; i < quads.size(); ++i) {
    if (i % 4096 == 0) host.report("finding intersections", 0, quads.size());
    for (const Index v : quads[i])
      boxes[i].add(positions[v]);
  }
  return meeting_pairs(boxes, most, host, [&](Index i, Index k) {
    return i == k ? lies_over_itself(positions, quads[i]) : quads_intersect(positions, quads[i], quads[k]);
  });
}

}  // namespace orbicube::mesh
