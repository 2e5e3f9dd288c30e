// Which energies a method minimizes, and in which order.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "sphere_map/optimization/distortion.h"
#include "sphere_map/optimization/newton.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::sphere_map {

// Newton's method on the whole mesh for one energy.
struct Stage {
  Weights weights;
  NewtonLimits limits;
};

// The hierarchy lowers the energy of the first stage; then the stages follow one another on the whole mesh, each with a
// weaker barrier than the one before it.
class Schedule {
 public:
  std::span<const Stage> stages() const { return {stages_.data(), count_}; }
  const Weights& hierarchy() const { return stages_[0].weights; }

  void add(const Stage& stage) { stages_[count_++] = stage; }

  // The terms that keep triangles from collapsing, for surfaces that are hard to map: `attempt` 0 leaves them as they
  // are.
  Schedule with_stronger_barrier(std::size_t attempt) const;

 private:
  std::array<Stage, 3> stages_{};
  std::size_t count_ = 0;
};

// Without a stage for `dissertation`. Throws Error invalid-argument for weights or a method that cannot be used.
Schedule schedule_of(const Options& options);

}  // namespace orbicube::sphere_map
