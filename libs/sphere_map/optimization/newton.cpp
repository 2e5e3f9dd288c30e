#include "sphere_map/optimization/newton.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <utility>

#include "base/backtracking.h"
#include "sphere_map/optimization/coarse_space.h"
#include "sphere_map/optimization/star_matrix.h"
#include "sphere_map/optimization/triangle_model.h"

namespace orbicube::sphere_map {
namespace {

constexpr const char* newton_phase = "final optimization";

// A triangle of the level by the places of its corners, the lowest first. entry[i] is the star triangle of corner i
// that starts with the next corner: there the matrix joins the two. after[i] is the one that starts with the last
// corner.
struct LevelTriangle {
  std::array<Index, 3> corner;
  std::array<Index, 3> entry;
  std::array<Index, 3> after;
};

// The models of this number of triangles are computed side by side, while those before them are added to the matrix in
// order.
constexpr std::size_t triangles_a_batch = 2048;
constexpr std::size_t triangles_a_piece = 256;

// Residual of the systems, as a part of the gradient. Smaller: fewer steps, each of more conjugate gradients.
constexpr double tolerance = 0.1;
// Radius of the first trust region, in units of the preconditioned gradient: longer steps fail, from shorter ones it
// grows by region_growth a step.
constexpr double first_radius = 10, region_growth = 3;
// Gains over those of the model: above the first the region grows, below the second it shrinks, and below the third
// single vertices are moved in between, after which the model holds farther.
constexpr double good_gain = 0.75, poor_gain = 0.25, smooth_below = 0.9;
constexpr double region_growth_of_smoothing = 2;
// Where no part of a step lowers the energy, the region shrinks below the shortest trial, up to this often.
constexpr int max_failures = 6, max_halvings = 8;
// A step with its smoothing that gains less than this part of the relative gain ends the run.
constexpr double min_gain = 0.1;

class Newton {
 public:
  Newton(const Energy& energy, const Level& level, std::span<const Index> place, std::span<Vector3> directions,
         const base::Host& host, const base::ThreadPool& pool)
      : energy_(energy),
        level_(level),
        host_(host),
        pool_(pool),
        directions_(directions),
        points_(level.vertices.size(), host.memory),
        trial_(level.vertices.size(), host.memory),
        triangles_(host.memory),
        matrix_(level, place, host),
        space_(matrix_, host, pool),
        solver_(level.vertices.size(), host, pool),
        downhill_(level.vertices.size(), host.memory),
        step_(level.vertices.size(), host.memory),
        models_{Array<TriangleModel>(host.memory), Array<TriangleModel>(host.memory)},
        partial_(host.memory) {
    take_directions();
    build(place);
  }

  double run(const NewtonLimits& limits, const std::function<void()>& smooth) {
    double value = assemble(), radius = -first_radius;
    space_.set(matrix_, points_);
    for (int step = 0, failures = 0; step < limits.steps && failures <= max_failures;) {
      const RegionStep model = solver_.solve(matrix_, space_, radius, downhill_, tolerance, limits.solver_steps, step_);
      const auto taken = search(value);
      if (taken && !(taken->value < value)) break;
      if (!taken) {
        radius = model.length / (1 << max_halvings);
        ++failures;
        continue;
      }
      const double before = std::exchange(value, taken->value), gain = before - value;
      const bool whole = taken->length == 1;
      if (++step == limits.steps || (whole && !model.limited && gain < limits.relative_gain * before)) break;
      radius = model.length * taken->length;
      if (whole && gain > good_gain * model.gain) radius *= region_growth;
      if (whole && gain < poor_gain * model.gain) radius /= 2;
      if (gain < smooth_below * model.gain) {
        put_directions();
        smooth();
        take_directions();
        radius *= region_growth_of_smoothing;
      }
      value = assemble();
      if (before - value < min_gain * limits.relative_gain * before) break;
      space_.set(matrix_, points_);
    }
    put_directions();
    return value;
  }

 private:
  void take_directions() {
    for (std::size_t i = 0; i < points_.size(); ++i)
      points_[i] = directions_[level_.vertices[i]];
  }
  void put_directions() {
    for (std::size_t i = 0; i < points_.size(); ++i)
      directions_[level_.vertices[i]] = points_[i];
  }

  // The triangles in the order of their lowest corners.
  void build(std::span<const Index> place) {
    const std::size_t count = level_.vertices.size();
    triangles_.reserve(2 * count - 4);
    // The star triangle of vertex a that starts with b.
    const auto entry = [&](Index a, Index b) {
      std::size_t k = level_.star_begin[a];
      while (place[level_.stars[k].q] != b)
        ++k;
      return static_cast<Index>(k);
    };
    const auto after = [&](Index a, Index k) {
      return static_cast<Index>(k + 1 < level_.star_begin[a + 1] ? k + 1 : level_.star_begin[a]);
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (i % 16384 == 0) host_.report(newton_phase, 0, 0);
      for (std::size_t k = level_.star_begin[i]; k < level_.star_begin[i + 1]; ++k) {
        const auto a = static_cast<Index>(i);
        const Index b = place[level_.stars[k].q];
        const Index c = place[level_.stars[k].r];
        if (a > b || a > c) continue;
        const std::array<Index, 3> entries = {static_cast<Index>(k), entry(b, c), entry(c, a)};
        triangles_.push_back({{a, b, c}, entries, {after(a, entries[0]), after(b, entries[1]), after(c, entries[2])}});
      }
    }
    const std::size_t batch = std::min(triangles_a_batch, triangles_.size());
    models_[0].resize(batch);
    models_[1].resize(batch);
    partial_.resize((triangles_.size() + triangles_a_batch - 1) / triangles_a_batch);
  }

  const TriangleShape& shape_of(const LevelTriangle& t) const { return level_.stars[t.entry[0]].shape; }

  // The energy with its negative gradient and Hessian at points_.
  double assemble() {
    double value = 0;
    matrix_.set_zero(pool_);
    std::fill(downhill_.begin(), downhill_.end(), Vector2d::Zero());
    const std::size_t batches = (triangles_.size() + triangles_a_batch - 1) / triangles_a_batch;
    for (std::size_t batch = 0; batch <= batches; ++batch) {
      const std::size_t begin = std::min(batch * triangles_a_batch, triangles_.size());
      const std::size_t end = std::min(begin + triangles_a_batch, triangles_.size());
      const std::size_t pieces = (end - begin + triangles_a_piece - 1) / triangles_a_piece;
      // One thread adds up the batch before, so that sums have an order of their own.
      pool_.run(pieces + 1, [&](std::size_t piece) {
        if (piece == 0) {
          if (batch > 0) value += add((batch - 1) * triangles_a_batch, begin, models_[(batch - 1) % 2]);
          return;
        }
        const std::size_t first = begin + (piece - 1) * triangles_a_piece;
        for (std::size_t t = first; t < std::min(first + triangles_a_piece, end); ++t) {
          const auto& [a, b, c] = triangles_[t].corner;
          models_[batch % 2][t - begin] =
              triangle_model(energy_, shape_of(triangles_[t]), {points_[a], points_[b], points_[c]});
        }
      });
      host_.report(newton_phase, 0, 0, value);
    }
    return value;
  }

  double add(std::size_t begin, std::size_t end, std::span<const TriangleModel> models) {
    double value = 0;
    for (std::size_t t = begin; t < end; ++t) {
      const LevelTriangle& triangle = triangles_[t];
      const TriangleModel& m = models[t - begin];
      value += m.value;
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t last = (c + 2) % 3;
        downhill_[triangle.corner[c]] -= m.gradient[c];
        matrix_.diagonal[triangle.corner[c]] += m.diagonal[c];
        matrix_.off_diagonal[triangle.entry[c]] += m.next[c];
        matrix_.off_diagonal[triangle.after[c]] += m.next[last].transpose();
      }
    }
    return value;
  }

  // Halves the step until it lowers the energy enough and all triangles are safely positive.
  std::optional<base::BacktrackingStep> search(double value) {
    double slope = 0;
    for (std::size_t i = 0; i < step_.size(); ++i)
      slope -= downhill_[i].dot(step_[i]);
    if (!(slope < 0)) return std::nullopt;
    const auto energy_after = [&](double length) {
      move(length);
      const double reached = trial_energy();
      host_.report(newton_phase, 0, 0, value);
      return reached;
    };
    const auto taken = base::backtrack(value, slope, {.max_trials = max_halvings}, energy_after);
    if (taken) std::swap(points_, trial_);
    return taken;
  }

  // Sets trial_ to the points after a part of the step.
  void move(double length) {
    pool_.run_pieces(points_.size(), vertices_a_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const TangentBasis basis(points_[i]);
        const Vector2d s = length * step_[i];
        trial_[i] = (points_[i] + s.x() * basis.first + s.y() * basis.second).normalized();
      }
    });
  }

  // Infinite when a triangle is not safely positive.
  double trial_energy() {
    std::atomic<bool> invalid{false};
    pool_.run_pieces(triangles_.size(), triangles_a_batch, [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for (std::size_t t = begin; t < end; ++t) {
        const auto& [a, b, c] = triangles_[t].corner;
        if (t % 256 == 0 && invalid.load(std::memory_order_relaxed)) return;
        if (!safely_positive(trial_[a], trial_[b], trial_[c])) {
          invalid.store(true, std::memory_order_relaxed);
          return;
        }
        sum += triangle_energy(energy_, shape_of(triangles_[t]), SphericalTriangle(trial_[a], trial_[b], trial_[c]));
      }
      partial_[begin / triangles_a_batch] = sum;
    });
    if (invalid) return std::numeric_limits<double>::infinity();
    double total = 0;
    for (const double sum : partial_)
      total += sum;
    return total;
  }

  const Energy& energy_;
  const Level& level_;
  const base::Host& host_;
  const base::ThreadPool& pool_;
  std::span<Vector3> directions_;
  Array<Vector3> points_, trial_;
  Array<LevelTriangle> triangles_;
  StarMatrix matrix_;
  CoarseSpace space_;
  ConjugateGradients solver_;
  Array<Vector2d> downhill_, step_;
  std::array<Array<TriangleModel>, 2> models_;
  Array<double> partial_;  // energies of batches
};

}  // namespace

double newton(const Energy& energy, const Level& level, const NewtonLimits& limits, std::span<const Index> place,
              std::span<Vector3> directions, const std::function<void()>& smooth, const base::Host& host,
              const base::ThreadPool& pool) {
  return Newton(energy, level, place, directions, host, pool).run(limits, smooth);
}

}  // namespace orbicube::sphere_map
