#include "sphere_map/refinement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.h"
#include "sphere_map/newton.h"
#include "sphere_map/relaxation.h"
#include "sphere_map/spherical_kernel.h"

namespace orbicube::sphere_map {
namespace {

// The number of vertices at which the next level is optimised: every one while that costs nothing, then in steps whose
// cost adds up to a constant number of passes over the whole mesh.
std::size_t next_level(std::size_t count, std::size_t total) {
  if (count < 60) return count + 1;
  const double ratio = count < 200 ? 1.15 : 1.7;
  const auto next = static_cast<std::size_t>(static_cast<double>(count) * ratio);
  // A last step that is nearly a whole level is taken at once.
  return static_cast<double>(next) > static_cast<double>(total) / 1.25 ? total : next;
}

// What a coarse level leaves unsolved is inherited by all that follow, so up to this size a level is solved in full.
constexpr std::size_t fully_solved = 1000;

RelaxationLimits limits_of(std::size_t count, std::size_t total) {
  if (count == total) return {30, 2e-4, 1e-3};
  if (count <= fully_solved) return {200, 1e-5, 1e-4};
  return {12, 1e-3, 3e-3};
}

class Refiner {
 public:
  Refiner(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule, double least_area,
          const base::Host& host)
      : decimation_(decimation),
        rings_(decimation.rings),
        positions_(positions),
        schedule_(schedule),
        host_(host),
        directions_(positions.size(), Vector3::Zero(), host.memory),
        level_(host.memory),
        queue_(positions.size(), host.memory),
        place_(positions.size(), host.memory),
        star_(host.memory),
        step_scratch_(host.memory),
        kernel_scratch_(host.memory) {
    energy_.weights = schedule.hierarchy();
    energy_.least_area = least_area;
  }

  Array<Vector3> run() {
    const std::size_t total = 4 + decimation_.collapses.size();
    level_.vertices.reserve(total);
    place_tetrahedron();
    solve_level(total);
    std::size_t next = next_level(4, total);
    for (std::size_t i = decimation_.collapses.size(); i-- > 0;) {
      split(decimation_.collapses[i]);
      const std::size_t count = level_.vertices.size();
      if (count >= next || count == total) {
        solve_level(total);
        next = next_level(count, total);
      }
      if (count % 256 == 0) host_.report("refinement", count, total);
    }
    return std::move(directions_);
  }

 private:
  void place_tetrahedron() {
    const double a = 1 / std::sqrt(3.0);
    const auto [top, first, second, third] = decimation_.tetrahedron;
    directions_[top] = Vector3(a, a, a);
    // The first three neighbours counter-clockwise seen from outside at `top`.
    directions_[first] = Vector3(a, -a, -a);
    directions_[second] = Vector3(-a, a, -a);
    directions_[third] = Vector3(-a, -a, a);
    level_.vertices.assign({top, first, second, third});
  }

  void solve_level(std::size_t total) {
    std::sort(level_.vertices.begin(), level_.vertices.end());
    level_.build(rings_, positions_, energy_, host_);
    const std::size_t count = level_.vertices.size();
    if (count == total) release_hierarchy();
    relax(energy_, level_, limits_of(count, total), directions_, queue_, place_, step_scratch_, host_);
    // Below, single vertices reach everything; between, the next level moves them again.
    if (count == total) {
      for (const Stage& stage : schedule_.stages()) {
        energy_.weights = stage.weights;
        newton(energy_, level_, stage.limits, place_, directions_, host_);
      }
    } else if (count >= 300 && count <= 4000) {
      newton(energy_, level_, {8, 200, 1e-5}, place_, directions_, host_);
    }
  }

  // The whole mesh has its stars in level_: what led there makes room for the last steps.
  void release_hierarchy() {
    decimation_.collapses = Array<Collapse>(host_.memory);
    decimation_.ring_pool = Array<Index>(host_.memory);
    rings_ = VertexRings(0, {}, host_);
  }

  // Inserts a vertex and optimises it and its ring once.
  void split(const Collapse& collapse) {
    rings_.split(collapse, decimation_.ring(collapse));
    const Index v = collapse.removed;
    const auto point = kernel_centroid(rings_[v], collapse.kept, directions_, kernel_scratch_);
    if (!point) {
      throw base::Error("no-valid-result",
                        "the spherical kernel of vertex " + std::to_string(v) + " is too small for double precision");
    }
    directions_[v] = *point;
    level_.vertices.push_back(v);
    energy_.uniform_area = 4 * std::numbers::pi / static_cast<double>(2 * level_.vertices.size() - 4);
    improve(v);
    improve(v);
    for (std::size_t i = 0; i < rings_.valence(v); ++i) {
      const Index neighbour = rings_[v][i];
      if (rings_.valence(neighbour) <= large_star) improve(neighbour);
    }
    improve(v);
  }

  void improve(Index v) {
    const auto ring = rings_[v];
    star_.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index q = ring[i];
      const Index r = ring[i + 1 < ring.size() ? i + 1 : 0];
      star_.push_back({q, r, triangle_shape(positions_[v], positions_[q], positions_[r], energy_.least_area)});
    }
    improve_vertex(energy_, v, star_, directions_, step_scratch_);
  }

  Decimation& decimation_;
  VertexRings& rings_;
  std::span<const Vector3> positions_;
  const Schedule& schedule_;
  const base::Host& host_;
  Energy energy_;
  Array<Vector3> directions_;
  Level level_;
  BucketQueue queue_;
  Array<Index> place_;
  Array<StarTriangle> star_;
  StepScratch step_scratch_;
  KernelPolygon kernel_scratch_;
};

}  // namespace

Array<Vector3> refine(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule,
                      double least_area, const base::Host& host) {
  return Refiner(decimation, positions, schedule, least_area, host).run();
}

}  // namespace orbicube::sphere_map
