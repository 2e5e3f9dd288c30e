#include "scenes/frame_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "gltf/writing/float_frame.h"
#include "gltf/writing/parts.h"
#include "mesh/search/rotations.h"

namespace orbicube::cli {
namespace {

using base::Array;
using mesh::Index;
using mesh::Vector3;
using quaternion::CubeClass;

constexpr std::size_t items_between_reports = std::size_t{1} << 14U;
constexpr Index sides = 8;  // of a tube

struct Shape {
  explicit Shape(std::pmr::memory_resource* memory) : positions(memory), triangles(memory) {}

  Index add(const Vector3& p) {
    positions.push_back(p);
    return static_cast<Index>(positions.size() - 1);
  }

  Array<Vector3> positions;
  Array<mesh::Triangle> triangles;
};

// Sizes in the units of the solid.
struct Scale {
  gltf::FloatFrame frame;  // what float32 is relative to
  double tube = 0;         // radius
  double spacing = 0;      // of crosses
};

Scale scale_of(const FieldView& view, const Array<Vector3>& boundary, std::size_t crosses) {
  Vector3 low = boundary.front(), high = low;
  for (const Vector3& p : boundary) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  double volume = 0;
  for (const mesh::Tetrahedron& t : view.solid.tetrahedra) {
    const auto edge = [&](std::size_t k) { return Vector3(view.solid.positions[t[k]] - view.solid.positions[t[0]]); };
    volume += edge(1).cross(edge(2)).dot(edge(3)) / 6;
  }
  Scale scale;
  scale.frame = gltf::float_frame(low, high);
  const double diagonal = (high - low).norm();
  const double edge =
      view.graph.inner_edges > 0 ? view.graph.inner_length / static_cast<double>(view.graph.inner_edges) : diagonal;
  scale.tube = std::max(diagonal / 800, std::min(edge / 4, diagonal / 250));
  scale.spacing = crosses > 0 ? std::cbrt(volume / static_cast<double>(crosses)) : 0;
  return scale;
}

// The boundary, with vertices of its own.
Shape boundary_of(const FieldView& view, const base::Host& host) {
  Shape result(host.memory);
  Array<Index> number(view.solid.positions.size(), mesh::no_index, host.memory);
  for (Index face = 0; face < view.connectivity.face_count(); ++face) {
    if (!view.connectivity.on_boundary(face)) continue;
    mesh::Triangle triangle = view.connectivity.vertices(face);
    for (Index& v : triangle) {
      if (number[v] == mesh::no_index) number[v] = result.add(view.solid.positions[v]);
      v = number[v];
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

// A tube through the points, which are closed to a ring when the last is the first. Its sections follow the turns
// without twist, and lie halfway in each corner.
void add_tube(const std::vector<Vector3>& points, double radius, Shape& shape) {
  const std::size_t segments = points.size() - 1;
  const bool ring = points.front() == points.back();
  const auto direction = [&](std::size_t s) { return Vector3((points[s + 1] - points[s]).normalized()); };
  Vector3 forward = direction(0);
  Vector3 across = forward.unitOrthogonal();
  Index last = mesh::no_index;
  const auto section = [&](const Vector3& at, const Vector3& along) {
    across = mesh::rotation_between(forward, along) * across;
    across = (across - across.dot(along) * along).normalized();
    forward = along;
    const Vector3 side = along.cross(across);
    const auto first = static_cast<Index>(shape.positions.size());
    for (Index k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      shape.add(at + radius * (std::cos(angle) * across + std::sin(angle) * side));
    }
    for (Index k = 0; k < sides && last != mesh::no_index; ++k) {
      const Index next = (k + 1) % sides;
      shape.triangles.push_back({last + k, last + next, first + k});
      shape.triangles.push_back({last + next, first + next, first + k});
    }
    last = first;
  };
  const auto cap = [&](const Vector3& at, bool begin) {
    const Index center = shape.add(at);
    for (Index k = 0; k < sides; ++k) {
      const Index next = (k + 1) % sides;
      shape.triangles.push_back({center, last + (begin ? next : k), last + (begin ? k : next)});
    }
  };
  const auto corner = [&](const Vector3& at, const Vector3& in, const Vector3& out) {
    const Vector3 middle = in + out;
    // A hairpin has no middle to speak of.
    if (middle.norm() > 0.5) return section(at, middle.normalized());
    section(at, in);
    section(at, out);
  };
  if (ring) {
    corner(points[0], direction(segments - 1), direction(0));
  } else {
    section(points[0], direction(0));
    cap(points[0], true);
  }
  for (std::size_t s = 1; s < segments; ++s)
    corner(points[s], direction(s - 1), direction(s));
  if (ring) {
    corner(points[segments], direction(segments - 1), direction(0));
  } else {
    section(points[segments], direction(segments - 1));
    cap(points[segments], false);
  }
}

// A regular icosahedron.
void add_ball(const Vector3& center, double radius, Shape& shape) {
  constexpr double golden = std::numbers::phi;
  const auto first = static_cast<Index>(shape.positions.size());
  const double unit = radius / std::sqrt(1 + golden * golden);
  for (const auto& [x, y, z] : {std::array{-1.0, golden, 0.0},
                                {1.0, golden, 0.0},
                                {-1.0, -golden, 0.0},
                                {1.0, -golden, 0.0},
                                {0.0, -1.0, golden},
                                {0.0, 1.0, golden},
                                {0.0, -1.0, -golden},
                                {0.0, 1.0, -golden},
                                {golden, 0.0, -1.0},
                                {golden, 0.0, 1.0},
                                {-golden, 0.0, -1.0},
                                {-golden, 0.0, 1.0}})
    shape.add(center + unit * Vector3(x, y, z));
  constexpr mesh::Triangle faces[] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (const mesh::Triangle& f : faces)
    shape.triangles.push_back({first + f[0], first + f[1], first + f[2]});
}

// Three spindles along the axes of a frame.
void add_cross(const Vector3& center, const quaternion::Quaternion& frame, double reach, Shape& shape) {
  const std::array<quaternion::Vector, 3> units = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<Vector3, 3> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    const quaternion::Vector v = quaternion::rotate(frame, units[k]);
    axes[k] = Vector3(v.x, v.y, v.z);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 along = reach * axes[k], u = 0.08 * reach * axes[(k + 1) % 3], v = 0.08 * reach * axes[(k + 2) % 3];
    const Index top = shape.add(center + along), bottom = shape.add(center - along);
    const std::array<Index, 4> belt = {shape.add(center + u), shape.add(center + v), shape.add(center - u),
                                       shape.add(center - v)};
    for (std::size_t i = 0; i < 4; ++i) {
      shape.triangles.push_back({belt[i], belt[(i + 1) % 4], top});
      shape.triangles.push_back({belt[(i + 1) % 4], belt[i], bottom});
    }
  }
}

// One tetrahedron for each cell of a grid, that whose center is nearest to the cell's.
Array<Index> evenly_chosen(const FieldView& view, double spacing, const base::Host& host) {
  struct Candidate {
    std::array<std::int64_t, 3> cell;
    double distance;
    Index tetrahedron;
  };
  Array<Candidate> candidates(host.memory);
  candidates.reserve(view.solid.tetrahedra.size());
  for (Index t = 0; t < view.solid.tetrahedra.size(); ++t) {
    if (t % items_between_reports == 0) host.report("choosing frames to show", t, view.solid.tetrahedra.size());
    Vector3 center = Vector3::Zero();
    for (const Index v : view.solid.tetrahedra[t])
      center += 0.25 * view.solid.positions[v];
    const Vector3 at = center / spacing;
    const Vector3 cell = at.array().floor();
    candidates.push_back(
        {{static_cast<std::int64_t>(cell[0]), static_cast<std::int64_t>(cell[1]), static_cast<std::int64_t>(cell[2])},
         (at - cell - Vector3::Constant(0.5)).squaredNorm(),
         t});
  }
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    if (a.cell != b.cell) return std::ranges::lexicographical_compare(a.cell, b.cell);
    return a.distance != b.distance ? a.distance < b.distance : a.tetrahedron < b.tetrahedron;
  });
  Array<Index> result(host.memory);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i == 0 || candidates[i].cell != candidates[i - 1].cell) result.push_back(candidates[i].tetrahedron);
  }
  return result;
}

// How a kind of thing looks: threes and fives are what hexahedral meshes have, in red and blue.
struct Look {
  const char* name;
  std::array<double, 4> color;
};
enum Kind : std::size_t { threes, fives, half_turns, third_turns, diagonals, nodes, not_meshable, frames, surface };
constexpr std::array<Look, 9> looks = {{{"threes", {0.75, 0.03, 0.03, 1}},
                                        {"fives", {0.03, 0.12, 0.75, 1}},
                                        {"half turns", {0.9, 0.35, 0.02, 1}},
                                        {"third turns", {0.6, 0.02, 0.6, 1}},
                                        {"diagonal half turns", {0.02, 0.02, 0.02, 1}},
                                        {"nodes", {0.1, 0.1, 0.1, 1}},
                                        {"not meshable", {0.95, 0.75, 0.02, 1}},
                                        {"frames", {0.1, 0.4, 0.22, 1}},
                                        {"surface", {0.6, 0.68, 0.75, 0.22}}}};

Kind kind_of(const frame_field::SingularEdge& edge) {
  if (edge.turn == 1) return threes;
  if (edge.turn == -1) return fives;
  if (edge.kind() == CubeClass::corner_third) return third_turns;
  return edge.kind() == CubeClass::edge_half ? diagonals : half_turns;
}

// The vertices of a curve in order; those of a closed one begin and end with the same.
std::vector<Index> vertices_of(const frame_field::SingularGraph& graph, std::size_t curve) {
  const std::span<const Index> edges = graph.curve(curve);
  const auto& first = graph.edges[edges[0]].vertices;
  const auto on = [&](const mesh::Edge& edge, Index v) { return edge[0] == v || edge[1] == v; };
  // From the end that the second edge does not have.
  const bool turned = edges.size() > 1 && on(graph.edges[edges[1]].vertices, first[0]);
  std::vector<Index> result = {first[turned ? 1 : 0]};
  for (const Index e : edges) {
    const auto& [a, b] = graph.edges[e].vertices;
    result.push_back(result.back() == a ? b : a);
  }
  return result;
}

void add_curves(const FieldView& view, double radius, std::span<Shape> shapes) {
  std::vector<Vector3> points;
  for (std::size_t c = 0; c < view.graph.curves(); ++c) {
    const std::vector<Index> vertices = vertices_of(view.graph, c);
    const std::span<const Index> edges = view.graph.curve(c);
    for (std::size_t begin = 0; begin < edges.size();) {
      const Kind kind = kind_of(view.graph.edges[edges[begin]]);
      std::size_t end = begin + 1;
      while (end < edges.size() && kind_of(view.graph.edges[edges[end]]) == kind)
        ++end;
      points.clear();
      for (std::size_t i = begin; i <= end; ++i)
        points.push_back(view.solid.positions[vertices[i]]);
      add_tube(points, radius, shapes[kind]);
      begin = end;
    }
  }
}

}  // namespace

void write_scene(const std::filesystem::path& path, const FieldView& view, std::size_t crosses,
                 const base::Host& host) {
  std::vector<Shape> shapes(looks.size(), Shape(host.memory));
  shapes[surface] = boundary_of(view, host);
  const Scale scale = scale_of(view, shapes[surface].positions, crosses);
  add_curves(view, scale.tube, shapes);
  const auto add_balls = [&](std::span<const Index> vertices, double radius, Kind kind) {
    for (const Index v : vertices)
      add_ball(view.solid.positions[v], radius, shapes[kind]);
  };
  add_balls(view.graph.nodes, 1.8 * scale.tube, nodes);
  add_balls(view.meshability.vertices, 2.4 * scale.tube, not_meshable);
  if (crosses > 0) {
    for (const Index t : evenly_chosen(view, scale.spacing, host)) {
      Vector3 center = Vector3::Zero();
      for (const Index v : view.solid.tetrahedra[t])
        center += 0.25 * view.solid.positions[v];
      add_cross(center, view.field[t], 0.3 * scale.spacing, shapes[frames]);
    }
  }
  std::vector<gltf::Part> parts;
  for (std::size_t kind = 0; kind < looks.size(); ++kind) {
    Shape& shape = shapes[kind];
    if (shape.triangles.empty()) continue;
    for (Vector3& p : shape.positions)
      p = scale.frame.stored(p);
    gltf::Part& part = parts.emplace_back();
    part.name = looks[kind].name;
    part.positions = shape.positions;
    part.triangles = shape.triangles;
    part.color = looks[kind].color;
    part.translation = scale.frame.translation;
    part.scale = scale.frame.scale;
    part.flat = kind == frames || kind == surface;
  }
  gltf::write_parts(path, parts, host);
}

}  // namespace orbicube::cli
