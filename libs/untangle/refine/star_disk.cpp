#include "untangle/refine/star_disk.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "linear/sparse_system.h"
#include "mesh/search/planar.h"
#include "mesh/search/predicates.h"

namespace orbicube::untangle {
namespace {

using mesh::cross;

// Of the circle: parts of the distance from its middle to the nearest line through an edge of the polygon, and of the
// angle between two boundary vertices that new vertices next to one of them spread over. Any below 1 and 1/2 do; a
// larger circle leaves less room for triangles around it.
constexpr double radius_part = 0.5;
constexpr double spread = 0.25;

// Boundary vertices, counter-clockwise where triangles are; empty unless the boundary is one closed curve.
Array<Index> boundary_loop(std::span<const Triangle> triangles, std::size_t vertices, const base::Host& host) {
  Array<std::array<Index, 2>> edges(host.memory);
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({t[k], t[(k + 1) % 3]});
  }
  host.report("refine", 0, 0);
  std::sort(edges.begin(), edges.end());
  host.report("refine", 0, 0);
  Array<Index> next(vertices, no_index, host.memory), loop(host.memory);
  std::size_t count = 0;
  for (const auto& [a, b] : edges) {
    if (std::binary_search(edges.begin(), edges.end(), std::array{b, a})) continue;
    if (next[a] != no_index) return loop;
    next[a] = b;
    ++count;
  }
  Index v = 0;
  while (v < vertices && next[v] == no_index)
    ++v;
  for (; v < vertices && next[v] != no_index; v = std::exchange(next[v], no_index))
    loop.push_back(v);
  if (loop.size() != count) loop.clear();
  return loop;
}

// Whether the triangles are one disk, of which all vertices are used.
bool is_disk(std::span<const Triangle> triangles, std::size_t vertices, std::size_t boundary,
             std::pmr::memory_resource* memory) {
  // V - E + F of one component with one closed boundary curve, 3 F = 2 E - boundary.
  if (2 * vertices != triangles.size() + boundary + 2) return false;
  Array<Index> group(vertices, 0, memory);
  for (Index v = 0; v < vertices; ++v)
    group[v] = v;
  const auto root = [&](Index v) {
    while (group[v] != v)
      v = group[v] = group[group[v]];
    return v;
  };
  std::size_t groups = vertices;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 1; k < 3; ++k) {
      const Index a = root(t[0]), b = root(t[k]);
      groups -= a != b;
      group[a] = b;
    }
  }
  return groups == 1;
}

// Whether the loop stays where it is, and nothing else does.
bool is_free_but_for(const TriangleProblem& problem, std::span<const Index> loop, std::pmr::memory_resource* memory) {
  if (problem.fixed.empty()) return false;
  Array<std::uint8_t> on(problem.start.size(), 0, memory);
  for (const Index v : loop)
    on[v] = 1;
  for (std::size_t i = 0; i < problem.fixed.size(); ++i) {
    if ((problem.fixed[i] != 0) != (on[i / 2] != 0)) return false;
  }
  return std::all_of(problem.ties.begin(), problem.ties.end(), [](Index group) { return group == no_index; });
}

// Whether a closed polygon goes around a point once, each edge counter-clockwise.
bool sees_all(const Vector2d& point, std::span<const Vector2d> polygon) {
  double turn = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (mesh::orientation_2d(point, a, b) <= 0) return false;
    turn += std::atan2(cross(a - point, b - point), (a - point).dot(b - point));
  }
  return turn < 3 * std::numbers::pi;
}

// Splits all that begins at the boundary. Returns for each new vertex, and each before, the one boundary vertex on
// whose edge it lies, or no_index.
Array<Index> split_from_boundary(SplitMesh<3>& mesh, std::span<const std::uint8_t> on_boundary,
                                 const base::Host& host) {
  split_marked(mesh, on_boundary, host);
  Array<Index> owner(mesh.vertices(), no_index, host.memory);
  const auto on = [&](Index v) { return v < on_boundary.size() && on_boundary[v] != 0; };
  for (const auto& edge : inner_edges<3>(mesh.elements(), host)) {
    if (!on(edge[0]) && !on(edge[1])) continue;
    host.report("refine", 0, 0);
    mesh.split(edge);
    owner.push_back(on(edge[0]) ? edge[0] : edge[1]);
  }
  return owner;
}

// The new vertices on edges of a boundary vertex, in the order of these edges from that to the vertex before to that to
// the next one on the loop.
Array<Index> owned_neighbors(const SplitMesh<3>& mesh, Index vertex, Index next, std::span<const Index> owner,
                             std::pmr::memory_resource* memory) {
  Array<std::array<Index, 2>> opposite(memory);  // edges of the triangles around it
  for (const Index i : mesh.around(vertex)) {
    const Triangle& t = mesh.elements()[i];
    const std::size_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    opposite.push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
  }
  std::sort(opposite.begin(), opposite.end());
  Array<Index> fan(memory);
  for (Index v = next; v != no_index;) {
    if (owner[v] == vertex) fan.push_back(v);
    const auto found = std::lower_bound(opposite.begin(), opposite.end(), std::array{v, Index{0}});
    v = found != opposite.end() && (*found)[0] == v ? (*found)[1] : no_index;
  }
  std::reverse(fan.begin(), fan.end());
  return fan;
}

// Puts vertices that are not `placed` to the means of their neighbors.
bool place_means(const SplitMesh<3>& mesh, std::span<const std::uint8_t> placed, Array<Vector2d>& positions,
                 const base::Host& host) {
  Array<Index> number(positions.size(), no_index, host.memory);
  std::size_t count = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (placed[v] == 0) number[v] = static_cast<Index>(count++);
  }
  const auto edges = inner_edges<3>(mesh.elements(), host);
  linear::SparseSystem::Triplets triplets(host.memory);
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(static_cast<Eigen::Index>(count), 2);
  for (const auto& [v, w] : edges) {
    for (const auto& [a, b] : {std::pair(v, w), std::pair(w, v)}) {
      const Index row = number[a], column = number[b];
      if (row == no_index) continue;
      triplets.emplace_back(static_cast<int>(row), static_cast<int>(row), 1.0);
      if (column == no_index)
        right.row(row) += positions[b];
      else if (column < row)
        triplets.emplace_back(static_cast<int>(row), static_cast<int>(column), -1.0);
    }
  }
  linear::SparseSystem system(count, triplets);
  host.report("refine", 0, 0);
  if (!system.factorize()) return false;
  for (Eigen::Index a = 0; a < 2; ++a) {
    const Eigen::VectorXd solution = system.solve(right.col(a));
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (number[v] != no_index) positions[v][a] = solution[number[v]];
  }
  return true;
}

}  // namespace

bool kernel_point(std::span<const Vector2d> polygon, Vector2d& point, const base::Host& host) {
  Vector2d low = polygon[0], high = polygon[0];
  for (const Vector2d& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Array<Vector2d> kernel(host.memory), next(host.memory);
  kernel = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for (std::size_t i = 0; i < polygon.size() && !kernel.empty(); ++i) {
    host.report("refine", 0, 0);
    const Vector2d &a = polygon[i], edge = polygon[(i + 1) % polygon.size()] - a;
    next.clear();
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const Vector2d &p = kernel[k], &q = kernel[(k + 1) % kernel.size()];
      const double at_p = cross(edge, p - a), at_q = cross(edge, q - a);
      if (at_p >= 0) next.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) next.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    std::swap(kernel, next);
  }
  if (kernel.size() < 3) return false;
  // Its centroid.
  double area = 0;
  Vector2d sum(0, 0);
  for (std::size_t k = 1; k + 1 < kernel.size(); ++k) {
    const double part = cross(kernel[k] - kernel[0], kernel[k + 1] - kernel[0]);
    area += part;
    sum += part / 3 * (kernel[k] - kernel[0] + (kernel[k + 1] - kernel[0]));
  }
  if (!(area > 0)) return false;
  point = kernel[0] + sum / area;
  return sees_all(point, polygon);
}

bool map_star_disk(const TriangleProblem& problem, StarDisk& disk, const base::Host& host) {
  const Array<Index> loop = boundary_loop(problem.triangles, problem.start.size(), host);
  if (loop.empty() || !is_disk(problem.triangles, problem.start.size(), loop.size(), host.memory) ||
      !is_free_but_for(problem, loop, host.memory))
    return false;
  Array<Vector2d> polygon(host.memory);
  for (const Index v : loop)
    polygon.push_back(problem.start[v]);
  Vector2d middle;
  if (!kernel_point(polygon, middle, host)) return false;
  disk.mesh = SplitMesh<3>(problem.triangles, problem.start.size(), host.memory);
  Array<std::uint8_t> placed(problem.start.size(), 0, host.memory);
  for (const Index v : loop)
    placed[v] = 1;
  const Array<Index> owner = split_from_boundary(disk.mesh, placed, host);
  disk.positions.assign(problem.start.begin(), problem.start.end());
  disk.positions.resize(disk.mesh.vertices(), middle);
  placed.resize(disk.mesh.vertices(), 0);

  double radius = (polygon[0] - middle).norm();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    radius = std::min(radius, cross(b - a, middle - a) / (b - a).norm());
  }
  radius *= radius_part;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    host.report("refine", 0, 0);
    const std::size_t n = loop.size(), after = (i + 1) % n;
    const Vector2d at = polygon[i] - middle;
    const auto turn_to = [&](const Vector2d& to) { return std::atan2(cross(at, to), at.dot(to)); };
    const double low = spread * turn_to(polygon[(i + n - 1) % n] - middle),
                 high = spread * turn_to(polygon[after] - middle);
    const Array<Index> fan = owned_neighbors(disk.mesh, loop[i], loop[after], owner, host.memory);
    if (fan.empty()) return false;
    for (std::size_t k = 0; k < fan.size(); ++k) {
      const double part = fan.size() > 1 ? static_cast<double>(k) / static_cast<double>(fan.size() - 1) : 0.5;
      const double angle = fan.size() > 1 ? low + part * (high - low) : 0;
      const Vector2d direction = at.normalized();
      disk.positions[fan[k]] =
          middle + radius * Vector2d(std::cos(angle) * direction.x() - std::sin(angle) * direction.y(),
                                     std::sin(angle) * direction.x() + std::cos(angle) * direction.y());
      placed[fan[k]] = 1;
    }
  }
  return place_means(disk.mesh, placed, disk.positions, host) &&
         count_inverted(disk.mesh.elements(), disk.positions, host).count == 0;
}

}  // namespace orbicube::untangle
