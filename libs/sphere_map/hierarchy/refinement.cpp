#include "sphere_map/hierarchy/refinement.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/error.h"
#include "sphere_map/hierarchy/partial.h"
#include "sphere_map/hierarchy/vertex_splits.h"
#include "sphere_map/optimization/newton.h"
#include "sphere_map/optimization/relaxation.h"
#include "sphere_map/optimization/sweeps.h"

namespace orbicube::sphere_map {
namespace {

// The number of vertices at which the next level is optimized: every one while that costs nothing, then in steps whose
// cost adds up to a constant number of passes over the whole mesh.
std::size_t next_level(std::size_t count, std::size_t total) {
  if (count < 60) return count + 1;
  const double ratio = count < 200 ? 1.15 : 1.7;
  const auto next = static_cast<std::size_t>(static_cast<double>(count) * ratio);
  // A last step that is nearly a whole level is taken at once.
  return static_cast<double>(next) > static_cast<double>(total) / 1.25 ? total : next;
}

// What a coarse level leaves unsolved is inherited by all that follow, so these are solved in full: the smallest by
// single vertices, which reach everything there, the others by Newton's method. With a fifth of its steps, or up to a
// third of the vertices, protrusions stay turned by degrees, and differently after each order of decimation.
constexpr std::size_t small_level = 300;
constexpr std::size_t newton_from = 100, newton_to = 12000;
constexpr RelaxationLimits small_limits = {.passes = 20, .relative_gain = 1e-4, .movement = 1e-4};
constexpr RelaxationLimits sweep_limits = {.passes = 3, .relative_gain = 1e-3, .movement = 3e-3};
constexpr RelaxationLimits last_sweep_limits = {.passes = 12, .relative_gain = 1e-5, .movement = 1e-2};
constexpr RelaxationLimits outlier_limits = {.passes = 5000, .relative_gain = 1e-8, .movement = 1e-3};
// Levels with more of all vertices are left to the last stages, which would solve them again.
constexpr double newton_share = 0.6;
constexpr RelaxationLimits smoothing_limits = {.passes = 1, .relative_gain = 1e-3, .movement = 1e-3};
constexpr NewtonLimits newton_limits = {.steps = 40, .solver_steps = 1000, .relative_gain = 1e-6};

// Between levels, this number of splits is prepared one by one and carried out side by side.
std::size_t batch_size(std::size_t count) {
  return std::clamp<std::size_t>(count / 8, 1, 4096);
}

Array<StepScratch> scratch_of_slots(std::pmr::memory_resource* memory) {
  Array<StepScratch> scratch(memory);
  scratch.reserve(DependencyLevels::slots);
  for (std::size_t slot = 0; slot < DependencyLevels::slots; ++slot)
    scratch.emplace_back(memory).heights.reserve(large_star);
  return scratch;
}

class Refiner {
 public:
  Refiner(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule,
          const RestTriangles& rest, const base::Host& host, const base::ThreadPool& pool)
      : decimation_(decimation),
        rings_(decimation.rings),
        positions_(positions),
        schedule_(schedule),
        host_(host),
        pool_(pool),
        directions_(positions.size(), Vector3::Zero(), host.memory),
        level_(host.memory),
        place_(positions.size(), host.memory),
        queue_(positions.size(), host.memory),
        dependency_levels_(positions.size(), host, pool_),
        scratch_(scratch_of_slots(host.memory)),
        splits_(positions, directions_, dependency_levels_, scratch_, host) {
    energy_.weights = schedule.hierarchy();
    energy_.rest = rest;
  }

  Array<Vector3> run(Partial* partial) {
    try {
      refine_and_solve();
    } catch (const base::Error&) {
      keep_partial(decimation_.collapses, directions_, partial);
      throw;
    }
    return std::move(directions_);
  }

 private:
  void refine_and_solve() {
    const std::size_t total = 4 + decimation_.collapses.size();
    level_.vertices.reserve(total);
    place_tetrahedron();
    solve_level(total);
    std::size_t next = std::min(next_level(4, total), total);
    while (level_.vertices.size() < total) {
      split_until(next, total);
      solve_level(total);
      next = std::min(next_level(next, total), total);
    }
  }

  void place_tetrahedron() {
    set_tetrahedron(decimation_.tetrahedron, directions_);
    level_.vertices.assign(decimation_.tetrahedron.begin(), decimation_.tetrahedron.end());
  }

  void solve_level(std::size_t total) {
    std::sort(level_.vertices.begin(), level_.vertices.end());
    level_.build(rings_, positions_, energy_, host_, pool_);
    const std::size_t count = level_.vertices.size();
    for (std::size_t i = 0; i < count; ++i)
      place_[level_.vertices[i]] = static_cast<Index>(i);
    if (count <= small_level) {
      relax(energy_, level_, place_, level_.vertices, small_limits, directions_, queue_, scratch_[0], host_, pool_);
    } else {
      const RelaxationLimits& limits = count == total ? last_sweep_limits : sweep_limits;
      const auto outliers = sweep(energy_, level_, place_, limits, directions_, scratch_, host_, pool_);
      relax(energy_, level_, place_, outliers, outlier_limits, directions_, queue_, scratch_[0], host_, pool_);
    }
    const auto smooth = [&] { sweep(energy_, level_, place_, smoothing_limits, directions_, scratch_, host_, pool_); };
    if (count == total) {
      release_hierarchy();
      for (const Stage& stage : schedule_.stages()) {
        energy_.weights = stage.weights;
        newton(energy_, level_, stage.limits, place_, directions_, smooth, host_, pool_);
      }
    } else if (count >= newton_from && count <= newton_to &&
               static_cast<double>(count) < newton_share * static_cast<double>(total)) {
      newton(energy_, level_, newton_limits, place_, directions_, smooth, host_, pool_);
    }
  }

  // The whole mesh has its stars in level_: what led there makes room for the last steps.
  void release_hierarchy() {
    decimation_.collapses = Array<Collapse>(host_.memory);
    decimation_.ring_pool = Array<Index>(host_.memory);
    rings_ = VertexRings(0, {}, host_);
    queue_ = BucketQueue(0, host_.memory);
    dependency_levels_.release();
  }

  // Inserts vertices until there are `count`, and optimizes each and its ring once. A batch of splits is prepared
  // beside the one before it, which the preparation does not depend on.
  void split_until(std::size_t count, std::size_t total) {
    prepare(std::min(count, level_.vertices.size() + batch_size(level_.vertices.size())));
    while (splits_.waiting()) {
      const std::size_t from = level_.vertices.size();
      const std::size_t batch = std::min(count - from, batch_size(from));
      splits_.run([&](std::size_t done, std::size_t all) { prepare(from + batch * done / all); });
      host_.report("refinement", from, total);
    }
  }

  // Splits the connectivity until there are `count` vertices.
  void prepare(std::size_t count) {
    while (level_.vertices.size() < count) {
      const Collapse& collapse = decimation_.collapses[total_splits() - 1 - done_++];
      rings_.split(collapse, decimation_.ring(collapse));
      level_.vertices.push_back(collapse.removed);
      energy_.uniform_area = 4 * std::numbers::pi / static_cast<double>(2 * level_.vertices.size() - 4);
      splits_.add(rings_, collapse, energy_);
    }
  }

  std::size_t total_splits() const { return decimation_.collapses.size(); }

  Decimation& decimation_;
  VertexRings& rings_;
  std::span<const Vector3> positions_;
  const Schedule& schedule_;
  const base::Host& host_;
  const base::ThreadPool& pool_;
  Energy energy_;
  Array<Vector3> directions_;
  Level level_;
  Array<Index> place_;  // of each vertex of the level in it
  BucketQueue queue_;
  DependencyLevels dependency_levels_;
  Array<StepScratch> scratch_;  // one a slot of the dependency_levels
  VertexSplits splits_;
  std::size_t done_ = 0;  // splits
};

}  // namespace

Array<Vector3> refine(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule,
                      const RestTriangles& rest, const base::Host& host, const base::ThreadPool& pool,
                      Partial* partial) {
  return Refiner(decimation, positions, schedule, rest, host, pool).run(partial);
}

}  // namespace orbicube::sphere_map
