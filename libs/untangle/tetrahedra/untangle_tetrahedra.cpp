#include "untangle/tetrahedra/untangle_tetrahedra.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "mesh/topology/place_text.h"
#include "untangle/barycentric_start.h"
#include "untangle/tetrahedra/local_untangling.h"
#include "untangle/tetrahedra/newton.h"

namespace orbicube::untangle {
namespace {

// Whether all of the boundary stays, so that the sum of volumes is that of every map.
bool has_fixed_boundary(const UntangleProblem& mesh, const base::Host& host) {
  if (mesh.fixed.empty()) return false;
  const Array<std::uint8_t> boundary = mesh::boundary_vertices(mesh.tetrahedra, mesh.start.size(), host);
  for (std::size_t i = 0; i < mesh.fixed.size(); ++i) {
    if (boundary[i / 3] != 0 && mesh.fixed[i] == 0) return false;
  }
  return true;
}

// The factor that gives the target shapes the volume that the map will have: that of the start, or the sum of absolute
// volumes where the start is too inverted for its own to be useful.
double scale_of(const UntangleProblem& mesh, std::span<const Vector3> start, const base::Host& host) {
  double sum = 0, absolute = 0, wanted = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const double volume = six_volumes(start, t);
    sum += volume;
    absolute += std::abs(volume);
    wanted += mesh.rest.empty() ? std::sqrt(0.5) : six_volumes(mesh.rest, t);  // of a regular one with edges of 1
  }
  const bool useful = sum > 0.1 * absolute || (sum > 0 && has_fixed_boundary(mesh, host));
  const double scale = std::cbrt((useful ? sum : absolute) / wanted);
  if (!(scale > 0) || !std::isfinite(scale))
    throw base::Error("degenerate-geometry", "the tetrahedra have no volume, or one that is not finite");
  return scale;
}

// Coordinates that stay while a neighborhood moves: also those that others far away are tied to.
Array<std::uint8_t> held_of(const UntangleProblem& mesh, std::pmr::memory_resource* memory) {
  Array<std::uint8_t> held(3 * mesh.start.size(), 0, memory);
  std::copy(mesh.fixed.begin(), mesh.fixed.end(), held.begin());
  for (std::size_t i = 0; i < mesh.ties.size(); ++i) {
    if (mesh.ties[i] != no_index) held[i] = 1;
  }
  return held;
}

Array<double> values_of(const Variables& variables, std::span<const Vector3> positions,
                        std::pmr::memory_resource* memory) {
  Array<double> values(variables.size(), 0, memory);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (std::size_t a = 0; a < 3; ++a)
      values[variables.of(v, a)] = positions[v][static_cast<Eigen::Index>(a)];
  }
  return values;
}

// Moves all vertices until nothing is inverted, or to where the fewest elements are. Far from a solution a large eps
// finds the way, unless all may collapse; where neither does, a start at the means of neighbors does.
void untangle_everywhere(Newton& newton, std::span<const Tetrahedron> tetrahedra, const Variables& variables, int steps,
                         const base::Host& host) {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  Array<double> best(newton.values().begin(), newton.values().end(), host.memory);
  Array<double> start(variables.start().begin(), variables.start().end(), host.memory);
  std::size_t fewest = newton.now().inverted;
  bool first = true;
  for (const bool barycentric : {false, true}) {
    if (newton.now().inverted == 0) return;
    if (barycentric && (steps == 0 || !start_barycentric(tetrahedra, variables, start, host))) break;
    for (const auto& [max_eps, patience] : {std::pair{no_limit, 1}, {0.4, 1}, {0.4, 6}}) {
      if (newton.now().inverted == 0) break;
      if (!first) newton.restart(start);
      first = false;
      newton.untangle(steps, max_eps, patience, {});
      if (newton.now().inverted < fewest) {
        fewest = newton.now().inverted;
        best.assign(newton.values().begin(), newton.values().end());
      }
    }
  }
  if (newton.now().inverted > fewest) newton.restart(best);
}

// Fills in the energy of the result and the range of its determinants.
void measure_energy(std::span<const Element> elements, double volume_weight, Untangled& result) {
  double weights = 0, sum = 0;
  result.min_determinant = std::numeric_limits<double>::infinity();
  result.max_determinant = -result.min_determinant;
  for (const Element& element : elements) {
    const Eigen::Matrix3d j = element.jacobian(result.positions);
    const double d = j.determinant();
    result.min_determinant = std::min(result.min_determinant, d);
    result.max_determinant = std::max(result.max_determinant, d);
    weights += element.weight;
    const double root = std::cbrt(d);
    sum += d > 0 ? element.weight * (j.squaredNorm() / (root * root) + volume_weight * (1 + d * d) / d)
                 : std::numeric_limits<double>::infinity();
  }
  result.energy = sum / weights;
}

}  // namespace

void require_vertices(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions) {
  if (tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    const Tetrahedron& t = tetrahedra[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (t[k] >= positions.size()) {
        throw base::Error("index-range", "tetrahedron " + std::to_string(i) + " has vertex " + std::to_string(t[k]) +
                                             ", there are " + std::to_string(positions.size()));
      }
      for (std::size_t l = 0; l < k; ++l) {
        if (t[k] == t[l])
          throw base::Error("degenerate-cell", "tetrahedron " + std::to_string(i) + " has vertex " +
                                                   std::to_string(t[k]) + " twice, at " +
                                                   mesh::place_text(positions[t[k]]));
      }
    }
  }
}

InvertedCount count_inverted(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions,
                             const base::Host& host) {
  InvertedCount result;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    if (i % 4096 == 0) host.report("check", i, tetrahedra.size());
    const Tetrahedron& t = tetrahedra[i];
    if (mesh::orientation_3d(positions[t[0]], positions[t[1]], positions[t[2]], positions[t[3]]) > 0) continue;
    if (result.count++ == 0) result.first = static_cast<Index>(i);
  }
  return result;
}

Untangled untangle_tetrahedra(const UntangleProblem& mesh, const UntangleOptions& options, const base::Host& host) {
  require_valid(options);
  base::require(mesh.rest.empty() || mesh.rest.size() == mesh.start.size(),
                "the target shapes need a position for each vertex");
  require_vertices(mesh.tetrahedra, mesh.start);
  for (const Vector3& p : mesh.rest)
    base::require(p.allFinite(), "a position of the target shapes is not finite");
  const Variables variables(mesh.start, mesh.fixed, mesh.ties, host.memory);
  Untangled result(host.memory);
  result.positions.resize(mesh.start.size());
  variables.expand(variables.start(), result.positions);
  result.inverted_before = count_inverted(mesh.tetrahedra, result.positions, host).count;

  const Array<Element> elements = elements_of(mesh.tetrahedra, mesh.rest, scale_of(mesh, result.positions, host), host);
  mesh::require_conforming(mesh.tetrahedra, mesh.start, host);
  FoldoverEnergy energy(elements, variables, options.volume_weight, host);
  energy.set_engine(options.engine);
  Newton newton(energy, variables.start(), host);
  const auto certify = [&] {
    variables.expand(newton.values(), result.positions);
    const InvertedCount found = count_inverted(mesh.tetrahedra, result.positions, host);
    result.inverted = found.count;
    result.first_inverted = found.first;
  };
  // Where few are inverted, their neighborhoods alone move, and in these what is not tied.
  const LocalUntangling local = untangle_locally(elements, held_of(mesh, host.memory), options.volume_weight,
                                                 options.steps, result.positions, host);
  if (local.done) newton.restart(values_of(variables, result.positions, host.memory));
  // Otherwise all vertices do.
  untangle_everywhere(newton, mesh.tetrahedra, variables, options.steps, host);
  result.steps = newton.steps() + local.steps;
  certify();
  // What is positive by exact arithmetic may be flat in floating point, and is kept where that leads to nothing.
  if (result.inverted > result.inverted_before) {
    newton.restart(variables.start());
    certify();
  }
  if (newton.now().inverted == 0 && (options.polish_steps > 0 || result.inverted > 0)) {
    const Array<Vector3> before(result.positions, host.memory);
    const std::size_t inverted = result.inverted;
    newton.polish(std::max(options.polish_steps, inverted > 0 ? 5 : 0), options.tolerance, {.tolerance = 3e-2});
    result.polish_steps = newton.steps() + local.steps - result.steps;
    certify();
    // What is positive in floating point may be flat by exact arithmetic, if only just.
    if (result.inverted > inverted) {
      result.positions = before;
      const InvertedCount found = count_inverted(mesh.tetrahedra, result.positions, host);
      result.inverted = found.count;
      result.first_inverted = found.first;
    }
  }
  measure_energy(elements, options.volume_weight, result);
  return result;
}

}  // namespace orbicube::untangle
