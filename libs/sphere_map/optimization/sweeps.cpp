#include "sphere_map/optimization/sweeps.h"

#include <atomic>

#include "base/grouping.h"

namespace orbicube::sphere_map {
namespace {

// As many vertices go to the threads at once: some milliseconds of work, so that a cancel is heard in time.
constexpr std::size_t vertices_a_batch = 16384;

class Sweeps {
 public:
  Sweeps(const Energy& energy, const Level& level, std::span<const Index> place, double movement,
         std::span<Vector3> directions, std::span<StepScratch> scratch, const base::Host& host,
         const base::ThreadPool& pool)
      : energy_(energy),
        level_(level),
        place_(place),
        movement_(movement),
        directions_(directions),
        scratch_(scratch),
        host_(host),
        pool_(pool),
        awake_(level.vertices.size(), 1, host.memory),
        star_energy_(level.vertices.size(), 0, host.memory),
        order_(host.memory),
        gains_(scratch.size(), host.memory) {
    color();
  }

  // One pass over all that are awake. Returns the gain.
  double pass() {
    double gain = 0;
    for (const Index v : level_.large)
      gain += visit(place_[v], 0);
    for (std::size_t c = 0; c < order_.keys(); ++c) {
      const std::span<const Index> places = order_[c];
      for (std::size_t begin = 0; begin < places.size(); begin += vertices_a_batch) {
        gain += visit(places.subspan(begin, std::min(vertices_a_batch, places.size() - begin)));
        host_.report("relaxation", 0, 0);
      }
    }
    return gain;
  }

  Array<Index> outliers() const {
    constexpr double far = 30;
    double mean = 0;
    for (const float e : star_energy_)
      mean += e;
    mean /= static_cast<double>(star_energy_.size());
    Array<Index> result(host_.memory);
    for (std::size_t i = 0; i < star_energy_.size(); ++i) {
      if (star_energy_[i] > far * mean) result.push_back(level_.vertices[i]);
    }
    return result;
  }

 private:
  // Each vertex takes the first color that none of its neighbors has; then order_ holds them color by color.
  void color() {
    constexpr std::uint8_t none = 255;
    static_assert(large_star < none);
    const std::size_t count = level_.vertices.size();
    Array<std::uint8_t> color(count, none, host_.memory);
    Array<std::size_t> taken_by(none, count, host_.memory);  // the last vertex with a neighbor of that color
    std::size_t colors = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 65536 == 0) host_.report("relaxation", 0, 0);
      if (level_.star(i).size() > large_star) continue;
      for (const StarTriangle& s : level_.star(i)) {
        const std::uint8_t c = color[place_[s.q]];
        if (c != none) taken_by[c] = i;
      }
      std::uint8_t c = 0;
      while (taken_by[c] == i)
        ++c;
      color[i] = c;
      colors = std::max(colors, std::size_t{c} + 1);
    }
    order_.assign(colors, [&](const auto& visit) {
      for (std::size_t i = 0; i < count; ++i) {
        if (color[i] != none) visit(color[i], static_cast<Index>(i));
      }
    });
  }

  // Steps of vertices of one color.
  double visit(std::span<const Index> places) {
    const std::size_t pieces = gains_.size();
    pool_.run(pieces, [&](std::size_t slot) {
      double gain = 0;
      for (std::size_t i = slot * places.size() / pieces; i < (slot + 1) * places.size() / pieces; ++i)
        gain += visit(places[i], slot);
      gains_[slot] = gain;
    });
    double gain = 0;
    for (const double g : gains_)
      gain += g;
    return gain;
  }

  double visit(std::size_t place, std::size_t slot) {
    if (!awake(place).exchange(0, std::memory_order_relaxed)) return 0;
    const auto star = level_.star(place);
    const StepResult result = improve_vertex(energy_, level_.vertices[place], star, directions_, scratch_[slot]);
    star_energy_[place] = static_cast<float>(result.energy - result.gain);
    if (result.gain > 0 && result.movement > movement_) {
      awake(place).store(1, std::memory_order_relaxed);
      for (const StarTriangle& s : star)
        awake(place_[s.q]).store(1, std::memory_order_relaxed);
    }
    return result.gain;
  }

  // Neighbors of two vertices of a color may be the same.
  std::atomic_ref<std::uint8_t> awake(std::size_t place) { return std::atomic_ref(awake_[place]); }

  const Energy& energy_;
  const Level& level_;
  std::span<const Index> place_;
  double movement_;
  std::span<Vector3> directions_;
  std::span<StepScratch> scratch_;
  const base::Host& host_;
  const base::ThreadPool& pool_;
  Array<std::uint8_t> awake_;
  Array<float> star_energy_;   // at the latest look
  base::Groups<Index> order_;  // places, color by color
  Array<double> gains_;
};

}  // namespace

Array<Index> sweep(const Energy& energy, const Level& level, std::span<const Index> place,
                   const RelaxationLimits& limits, std::span<Vector3> directions, std::span<StepScratch> scratch,
                   const base::Host& host, const base::ThreadPool& pool) {
  double value = level_energy(energy, level, directions, host, pool);
  Sweeps sweeps(energy, level, place, limits.movement, directions, scratch, host, pool);
  for (std::size_t pass = 0; pass < limits.passes; ++pass) {
    const double gain = sweeps.pass();
    value -= gain;
    if (gain < limits.relative_gain * value) break;
  }
  return sweeps.outliers();
}

}  // namespace orbicube::sphere_map
