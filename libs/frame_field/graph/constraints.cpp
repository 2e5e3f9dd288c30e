#include "frame_field/graph/constraints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

using quaternion::multiply;
using quaternion::normalized;

struct BoundaryFace {
  double area;
  Vector normal;
};

// The faces of a tetrahedron on the boundary, from the largest area down; those without area are left out.
std::size_t boundary_faces(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                           Index tetrahedron, std::array<BoundaryFace, 4>& faces) {
  std::size_t count = 0;
  for (Index k = 0; k < 4; ++k) {
    const Index face = 4 * tetrahedron + k;
    if (!connectivity.on_boundary(face)) continue;
    const mesh::Triangle v = connectivity.vertices(face);
    Vector3 e = positions[v[1]] - positions[v[0]], f = positions[v[2]] - positions[v[0]];
    const double size = std::max(e.cwiseAbs().maxCoeff(), f.cwiseAbs().maxCoeff());
    if (!(size > 0)) continue;
    e /= size;
    f /= size;
    const Vector3 normal = e.cross(f);
    const double length = normal.norm();
    if (!(length > 0)) continue;
    faces[count++] = {length * size * size, {normal[0] / length, normal[1] / length, normal[2] / length}};
  }
  std::stable_sort(faces.begin(), faces.begin() + count,
                   [](const BoundaryFace& a, const BoundaryFace& b) { return a.area > b.area; });
  return count;
}

// Other directions for the axis of a tetrahedron with several boundary faces: their normals; and where two of them
// cannot both be met, because they are neither nearly alike nor nearly perpendicular, directions between them and that
// of the edge where they meet, about which the frame may then turn.
template <typename Add>
void for_each_alternative(std::span<const BoundaryFace> faces, const Add& add) {
  constexpr double alike = 0.996, perpendicular = 0.087;  // cosines of 5 and 85 degrees
  for (std::size_t k = 1; k < faces.size(); ++k)
    add(faces[k].normal);
  const auto add_unit = [&](const Vector& v) {
    const double length = std::hypot(v.x, v.y, v.z);
    if (length > 1e-3) add(Vector{v.x / length, v.y / length, v.z / length});
  };
  for (std::size_t k = 1; k < faces.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      const Vector& a = faces[k].normal;
      Vector b = faces[l].normal;
      const double cosine = a.x * b.x + a.y * b.y + a.z * b.z;
      if (std::abs(cosine) > alike || std::abs(cosine) < perpendicular) continue;
      if (cosine < 0) b = {-b.x, -b.y, -b.z};  // an axis has no sense
      add_unit({a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x});
      for (int eighth = 1; eighth < 8; ++eighth) {
        const double t = eighth / 8.0;
        add_unit({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)});
      }
    }
  }
}

}  // namespace

Quaternion aligned(const Quaternion& frame, const Vector& n) {
  // The direction in the frame's own axes; its largest component says which axis is next to it.
  const Vector local = quaternion::rotate(quaternion::conjugate(frame), n);
  const double x = std::abs(local.x), y = std::abs(local.y), z = std::abs(local.z);
  Vector axis{0, 0, 0};
  if (x >= y && x >= z)
    axis.x = local.x < 0 ? -1 : 1;
  else if (y >= z)
    axis.y = local.y < 0 ? -1 : 1;
  else
    axis.z = local.z < 0 ? -1 : 1;
  // The shortest rotation from the axis to the direction: 1 + cos, sin times its axis.
  const double cosine = axis.x * local.x + axis.y * local.y + axis.z * local.z;
  const Quaternion turn{1 + cosine, axis.y * local.z - axis.z * local.y, axis.z * local.x - axis.x * local.z,
                        axis.x * local.y - axis.y * local.x};
  return normalized(multiply(frame, normalized(turn)));
}

namespace {

// The `count` given frames and axes that pull but are not imposed, by node.
void list_pulls(const DualGraph& graph, std::span<const GivenFrame> given_frames, std::span<const GivenAxis> given_axes,
                std::size_t count, Array<Pull>& pulls, const base::Host& host) {
  Array<Index> node(graph.size(), host.memory);
  for (Index i = 0; i < graph.size(); ++i)
    node[graph.tetrahedron[i]] = i;
  pulls.reserve(count);
  for (const GivenFrame& g : given_frames) {
    if (g.weight < held) pulls.push_back({node[g.tetrahedron], true, normalized(g.frame), {}, g.weight});
  }
  for (const GivenAxis& g : given_axes) {
    if (g.weight < held)
      pulls.push_back({node[g.tetrahedron], false, aligned({1, 0, 0, 0}, g.direction), g.direction, g.weight});
  }
  // Equals stay in the order in which they were given.
  Array<Index> order(count, host.memory);
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(
      order, [&](Index a, Index b) { return pulls[a].node != pulls[b].node ? pulls[a].node < pulls[b].node : a < b; });
  Array<Pull> sorted(host.memory);
  sorted.reserve(count);
  for (const Index i : order)
    sorted.push_back(pulls[i]);
  std::swap(sorted, pulls);
}

}  // namespace

Constraints make_constraints(const DualGraph& graph, std::span<const Vector3> positions,
                             const mesh::TetrahedralConnectivity& connectivity, bool align_boundary,
                             std::span<const GivenFrame> given_frames, std::span<const GivenAxis> given_axes,
                             const base::Host& host) {
  Constraints result(host.memory);
  result.of_node.assign(graph.size(), no_index);
  Array<Index> frame_of(host.memory), axis_of(host.memory);  // by tetrahedron
  std::size_t pulls = 0;
  const auto table = [&](auto given, Array<Index>& of) {
    if (given.empty()) return;
    of.assign(graph.size(), no_index);
    for (Index i = 0; i < given.size(); ++i) {
      if (given[i].weight < held)
        ++pulls;
      else
        of[given[i].tetrahedron] = i;
    }
  };
  table(given_frames, frame_of);
  table(given_axes, axis_of);
  if (pulls > 0) list_pulls(graph, given_frames, given_axes, pulls, result.pulls, host);
  for (Index i = 0; i < graph.size(); ++i) {
    if (i % 16384 == 0) host.report("boundary", i, graph.size());
    const Index t = graph.tetrahedron[i];
    Constraint constraint{i, false, {1, 0, 0, 0}, {0, 0, 0}};
    std::array<BoundaryFace, 4> faces;
    std::size_t count = 0;
    if (!frame_of.empty() && frame_of[t] != no_index) {
      constraint.fixed = true;
      constraint.frame = normalized(given_frames[frame_of[t]].frame);
    } else if (!axis_of.empty() && axis_of[t] != no_index) {
      constraint.direction = given_axes[axis_of[t]].direction;
      constraint.frame = aligned(constraint.frame, constraint.direction);
    } else {
      if (align_boundary) count = boundary_faces(positions, connectivity, t, faces);
      if (count == 0) continue;
      constraint.direction = faces[0].normal;
      constraint.frame = aligned(constraint.frame, constraint.direction);
    }
    const auto number = static_cast<Index>(result.list.size());
    result.of_node[i] = number;
    result.list.push_back(constraint);
    for_each_alternative({faces.data(), count}, [&](const Vector& direction) {
      result.alternatives.push_back({number, direction});
    });
  }
  return result;
}

std::span<const Pull> Constraints::pulls_at(Index node) const {
  const auto begin = std::partition_point(pulls.begin(), pulls.end(), [&](const Pull& p) { return p.node < node; });
  auto end = begin;
  while (end != pulls.end() && end->node == node)
    ++end;
  return std::span(pulls).subspan(static_cast<std::size_t>(begin - pulls.begin()),
                                  static_cast<std::size_t>(end - begin));
}

Quaternion target(const Pull& pull, const Quaternion& frame) {
  if (!pull.whole) return aligned(frame, pull.direction);
  return multiply(pull.frame, quaternion::conjugate(
                                  quaternion::cube_group.element[quaternion::symmetric_matching(frame, pull.frame)]));
}

double worth(const Pull& pull, const Quaternion& frame) {
  return pull.weight * quaternion::symmetric_sine_square(frame, target(pull, frame));
}

void satisfy(const Constraints& constraints, Field& field) {
  for (const Constraint& c : constraints.list)
    field[c.node] = c.fixed ? c.frame : aligned(aligned(field[c.node], c.direction), c.direction);
}

}  // namespace orbicube::frame_field
