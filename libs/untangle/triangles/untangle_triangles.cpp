#include "untangle/triangles/untangle_triangles.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/edge_table.h"
#include "untangle/barycentric_start.h"
#include "untangle/triangles/planar_newton.h"

namespace orbicube::untangle {
namespace {

constexpr double min_weight = 0.02;  // of a triangle, of the mean

std::string name_of(std::size_t triangle) {
  return "triangle " + std::to_string(triangle);
}

double twice_area(std::span<const Vector2d> positions, const Triangle& t) {
  const Vector2d e = positions[t[1]] - positions[t[0]], f = positions[t[2]] - positions[t[0]];
  return e.x() * f.y() - e.y() * f.x();
}

void check(const TriangleProblem& mesh, const UntangleOptions& options) {
  require_valid(options);
  base::require(mesh.rest.empty() || mesh.rest.size() == mesh.start.size(),
                "the target shapes need a position for each vertex");
  base::require(mesh.fixed.empty() || mesh.fixed.size() == 2 * mesh.start.size(),
                "fixed coordinates need an entry for each coordinate");
  base::require(mesh.ties.empty() || mesh.ties.size() == 2 * mesh.start.size(),
                "ties need an entry for each coordinate");
  for (const Vector3& p : mesh.rest)
    base::require(p.allFinite(), "a position of the target shapes is not finite");
  for (const Index group : mesh.ties)
    base::require(group == no_index || group < 2 * mesh.start.size(), "a group of ties is out of range");
}

// The unknowns: those of vertices in space whose third coordinate is fixed.
Variables variables_of(const TriangleProblem& mesh, std::pmr::memory_resource* memory) {
  const std::size_t n = mesh.start.size();
  Array<Vector3> start(n, memory);
  Array<std::uint8_t> fixed(3 * n, 0, memory);
  Array<Index> ties(mesh.ties.empty() ? 0 : 3 * n, no_index, memory);
  for (std::size_t v = 0; v < n; ++v) {
    start[v] = {mesh.start[v].x(), mesh.start[v].y(), 0};
    fixed[3 * v + 2] = 1;
    for (std::size_t a = 0; a < 2; ++a) {
      if (!mesh.fixed.empty()) fixed[3 * v + a] = mesh.fixed[2 * v + a];
      if (!mesh.ties.empty()) ties[3 * v + a] = mesh.ties[2 * v + a];
    }
  }
  return {start, fixed, ties, memory};
}

// Sums of areas: signed and absolute of the start, and of the target shapes as they are.
struct Areas {
  double sum = 0, absolute = 0, target = 0;
  std::size_t count;
  bool known = true;  // whether the sum is that of every map, since the boundary is fixed

  Areas(const TriangleProblem& mesh, std::span<const Vector2d> start, std::span<const std::uint8_t> boundary)
      : count(mesh.triangles.size()) {
    for (const Triangle& t : mesh.triangles) {
      const double twice = twice_area(start, t);
      sum += 0.5 * twice;
      absolute += 0.5 * std::abs(twice);
      if (!mesh.rest.empty())
        target += 0.5 * (mesh.rest[t[1]] - mesh.rest[t[0]]).cross(mesh.rest[t[2]] - mesh.rest[t[0]]).norm();
    }
    if (mesh.rest.empty()) target = static_cast<double>(count);
    for (std::size_t i = 0; i < 2 * boundary.size(); ++i)
      known = known && (boundary[i / 2] == 0 || (!mesh.fixed.empty() && mesh.fixed[i] != 0));
  }
  // Of the map: of the start, unless that is too inverted for its own to be useful.
  double whole() const { return sum > (known ? 0 : 0.1) * absolute ? sum : absolute; }
  double mean() const { return whole() / static_cast<double>(count); }
};

void require_positive(const Areas& areas) {
  if (!(areas.absolute > 0) || !std::isfinite(areas.absolute) || !(areas.target > 0) || !std::isfinite(areas.target))
    throw base::Error("degenerate-geometry", "the triangles have no area, or one that is not finite");
}

// The triangles with their target shapes, in a plane that is scaled by `unit`, where their mean area is about 1.
PlanarTriangles elements_of(const TriangleProblem& mesh, const Variables& variables, const Areas& areas, double unit,
                            const base::Host& host) {
  const double mean = unit * unit * areas.mean();
  const double scale = std::sqrt(unit * unit * areas.whole() / areas.target);
  base::require(std::isfinite(scale) && scale > 0 && std::isfinite(mean), "areas are out of range");
  const double edge = scale * 2 / std::pow(3, 0.25);  // of an equilateral triangle of area scale^2
  const std::array<Vector3, 3> regular = {Vector3::Zero(), Vector3(edge, 0, 0),
                                          Vector3(0.5 * edge, 0.5 * std::sqrt(3.0) * edge, 0)};
  PlanarTriangles result(host.memory);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 8192 == 0) host.report("elements", i, mesh.triangles.size());
    const Triangle& t = mesh.triangles[i];
    std::array<Vector3, 3> corners = regular;
    if (!mesh.rest.empty()) {
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = scale * mesh.rest[t[k]];
      const Vector3 e = corners[1] - corners[0], f = corners[2] - corners[0];
      if (!(e.cross(f).norm() > 1e-12 * std::max({e.squaredNorm(), f.squaredNorm(), (f - e).squaredNorm()})))
        throw base::Error("degenerate-face", name_of(i) + " has no area in its target shape");
    }
    std::array<Index, 6> coordinates{};
    for (std::size_t k = 0; k < 6; ++k)
      coordinates[k] = variables.of(t[k / 2], k % 2);
    result.add(corners, coordinates, {1, 1, 1, 1, 1, 1}, mean, min_weight * mean);
  }
  return result;
}

// Moves all vertices until nothing is flipped, or to where the fewest triangles are. Each of these first values of eps
// finds maps that the others do not, and so does a start at the means of neighbors.
void untangle_values(PlanarNewton& newton, std::span<const Triangle> triangles, const Variables& variables,
                     const UntangleOptions& options, Array<double>& values, const base::Host& host) {
  Array<double> start(values, host.memory), best(values, host.memory);
  newton.min_determinant(values);
  std::size_t fewest = newton.flipped();
  for (const bool barycentric : {false, true}) {
    if (barycentric && (options.steps == 0 || !start_barycentric(triangles, variables, start, host))) break;
    const double worst = newton.min_determinant(start);
    for (const double first_eps : {std::max(0.05, 0.2 * std::abs(worst)), 0.0, 0.01}) {
      values = start;
      if (newton.untangle(values,
                          {.max_steps = options.steps, .area_weight = options.volume_weight, .first_eps = first_eps}))
        return;
      if (newton.flipped() < fewest) {
        fewest = newton.flipped();
        best = values;
      }
    }
  }
  values = best;
}

// Fills in the energy of the result and the range of its determinants.
void measure(const PlanarTriangles& elements, std::span<const double> values, double lambda,
             UntanglingFigures& result) {
  result.min_determinant = std::numeric_limits<double>::infinity();
  result.max_determinant = -result.min_determinant;
  double weights = 0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const double d = elements.jacobian(values, i).determinant();
    result.min_determinant = std::min(result.min_determinant, d);
    result.max_determinant = std::max(result.max_determinant, d);
    weights += elements.weights[i];
  }
  result.energy = 2 * elements.energy(values, lambda) / weights;
}

}  // namespace

InvertedCount count_inverted(std::span<const Triangle> triangles, std::span<const Vector2d> positions,
                             const base::Host& host) {
  InvertedCount result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % 4096 == 0) host.report("check", i, triangles.size());
    const Triangle& t = triangles[i];
    if (mesh::orientation_2d(positions[t[0]], positions[t[1]], positions[t[2]]) > 0) continue;
    if (result.count++ == 0) result.first = static_cast<Index>(i);
  }
  return result;
}

Array<std::uint8_t> boundary_vertices(std::span<const Triangle> triangles, std::size_t vertices,
                                      const base::Host& host) {
  if (triangles.empty()) throw base::Error("no-cells", "no triangles");
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    for (const Index v : t) {
      if (v >= vertices)
        throw base::Error("index-range",
                          name_of(i) + " has vertex " + std::to_string(v) + ", there are " + std::to_string(vertices));
    }
    if (mesh::has_repeated_corner(t)) throw base::Error("degenerate-face", name_of(i) + " has a vertex twice");
  }
  Array<std::uint8_t> result(vertices, 0, host.memory);
  const mesh::EdgeTable edges(vertices, triangles, host);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto around = edges.half_edges(e);
    const Index a = mesh::start_of(triangles, around[0]), b = mesh::end_of(triangles, around[0]);
    const auto between = [&] { return " between vertices " + std::to_string(a) + " and " + std::to_string(b); };
    if (around.size() > 2)
      throw base::Error("non-manifold-edge", std::to_string(around.size()) + " triangles have the edge" + between());
    if (around.size() == 2 && mesh::start_of(triangles, around[1]) == a)
      throw base::Error("inconsistent-orientation",
                        "triangles " + std::to_string(mesh::triangle_of(around[0])) + " and " +
                            std::to_string(mesh::triangle_of(around[1])) +
                            " can never both be positive: the order of their vertices at the edge" + between());
    if (around.size() == 1) result[a] = result[b] = 1;
  }
  return result;
}

UntangledTriangles untangle_triangles(const TriangleProblem& mesh, const UntangleOptions& options,
                                      const base::Host& host) {
  check(mesh, options);
  const Array<std::uint8_t> boundary = boundary_vertices(mesh.triangles, mesh.start.size(), host);
  const Variables variables = variables_of(mesh, host.memory);
  UntangledTriangles result(host.memory);
  result.positions.resize(mesh.start.size());
  Array<double> values(variables.start().begin(), variables.start().end(), host.memory);
  const auto place = [&](double unit) {
    for (std::size_t v = 0; v < mesh.start.size(); ++v) {
      for (std::size_t a = 0; a < 2; ++a) {
        const Index variable = variables.of(v, a);
        result.positions[v][static_cast<Eigen::Index>(a)] =
            variable < variables.free() ? values[variable] / unit : variables.start()[variable];
      }
    }
    const InvertedCount found = count_inverted(mesh.triangles, result.positions, host);
    result.inverted = found.count;
    result.first_inverted = found.first;
  };
  place(1);
  result.inverted_before = result.inverted;
  const Areas areas(mesh, result.positions, boundary);
  require_positive(areas);
  // A power of two: nothing is rounded.
  const double unit = std::exp2(-std::floor(0.5 * std::ilogb(areas.mean())));
  for (double& value : values)
    value *= unit;
  const PlanarTriangles elements = elements_of(mesh, variables, areas, unit, host);
  if (variables.free() > 0) {
    PlanarNewton newton(elements, variables.free(), {}, host);
    const Array<double> start(values, host.memory);
    untangle_values(newton, mesh.triangles, variables, options, values, host);
    result.steps = newton.steps();
    place(unit);
    // What is positive by exact arithmetic may be flat in floating point, and is kept where that leads to nothing.
    if (result.inverted > result.inverted_before) {
      values = start;
      place(unit);
    }
    if (elements.energy(values, 1) < std::numeric_limits<double>::infinity() &&
        (options.polish_steps > 0 || result.inverted > 0)) {
      const Array<double> before(values, host.memory);
      const std::size_t inverted = result.inverted;
      const int steps = std::max(options.polish_steps, inverted > 0 ? 5 : 0);
      newton.settle(values, steps / 2, options.volume_weight);
      newton.polish(values, steps - static_cast<int>(newton.steps() - result.steps), options.tolerance,
                    options.volume_weight);
      result.polish_steps = newton.steps() - result.steps;
      place(unit);
      // What is positive in floating point may be flat by exact arithmetic, if only just.
      if (result.inverted > inverted) {
        values = before;
        place(unit);
      }
    }
  }
  measure(elements, values, options.volume_weight, result);
  return result;
}

}  // namespace orbicube::untangle
