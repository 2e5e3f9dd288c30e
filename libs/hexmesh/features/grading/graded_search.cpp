#include "hexmesh/features/grading/graded_search.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"

namespace orbicube::hexmesh {
namespace {

constexpr double grid_part = 0.55;                       // of the cells: the rest are rings
constexpr double first_strength = 1.4;                   // cells along each arc, and between two
constexpr double most_strength = 6;                      // for which gaps are looked at
constexpr double at_obstacle = 1.25, everywhere = 1.08;  // how much more of it after an attempt that failed
constexpr int max_attempts = 40;
// Cells along bends become wider where there are too many, and after a number of attempts that failed.
constexpr double at_bends = 1.4, widest = 3;
constexpr int attempts_at_bends = 8;
// Cells of the grid in the box of the solid, which are all looked at: thin solids across the axes fill few of them.
constexpr double most_in_box = 50;  // of the largest number of hexahedra
constexpr double least_layers = 2;  // that a solid takes which is thinner, where its gaps are widened

double size_of(double volume, double hexahedra) {
  return std::cbrt(volume / (grid_part * hexahedra));
}

}  // namespace

GradedSearch::GradedSearch(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                           const mesh::FeatureGraph& graph, double cells, double max_cells, double max_visited,
                           const base::Host& host)
    : positions_(positions),
      triangles_(triangles),
      graph_(graph),
      host_(host),
      whole_(mesh::measures(positions, triangles, host)),
      base_cells_(cells),
      max_cells_(max_cells),
      max_visited_(max_visited),
      shape_(positions, triangles, graph, 1, host),
      demands_(shape_, most_strength * size_of(whole_.volume, cells), size_of(whole_.volume, cells), host),
      strength_(graph.arcs.size(), first_strength, host.memory),
      small_(host.memory),
      obstacles_(host.memory) {}

std::optional<EmbeddedCells> GradedSearch::next() {
  for (; attempts_ < max_attempts; ++attempts_) {
    EmbeddedCells now;
    now.grading = std::make_unique<AxisGrading>(whole_.low, whole_.high, size_of(whole_.volume, base_cells_), host_);
    for (const SmallCells& s : small_)
      now.grading->refine(s.from, s.to, s.size);
    demands_.refine(strength_, wider_, *now.grading);
    now.surface = std::make_unique<GradedSurface>(positions_, triangles_, graph_, *now.grading, host_);
    hexahedra_ = now.surface->volume / grid_part;
    if (hexahedra_ > max_cells_) {
      if (wider_ < widest) {
        wider_ *= at_bends;
        continue;
      }
      require_fewer_cells();
      return {};
    }
    const double in_box =
        (now.grading->cells(whole_.high) - now.grading->cells(whole_.low)).cwiseMax(least_layers).prod();
    if (in_box > most_in_box * max_cells_) {
      set_obstacle("the solid fills too small a part of its box along the axes");
      return {};
    }
    if (in_box > max_visited_ - visited_) {
      if (obstacles_.empty()) set_obstacle("grids of this size take too long");
      return {};
    }
    visited_ += in_box;
    try {
      now.cells = std::make_unique<GradedCells>(*now.surface, host_);
      obstacles_ = now.cells->embed();
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      set_obstacle(error.what());
    }
    if (obstacles_.empty()) {
      now.cells->move_to_space();
      ++attempts_;
      return now;
    }
    if (attempts_ % attempts_at_bends == attempts_at_bends - 1) wider_ = std::min(widest, wider_ * at_bends);
    refine_at(obstacles_, at_obstacle);
  }
  return {};
}

// What was in the way before remains so; else it is what requires the smallest cells.
void GradedSearch::require_fewer_cells() {
  if (!obstacles_.empty()) return;
  const std::string why = "it needs about " + std::to_string(static_cast<std::size_t>(hexahedra_)) +
                          " hexahedra, more than the " + std::to_string(static_cast<std::size_t>(max_cells_)) +
                          " that --cells and --max-cells allow";
  for (const Index arc : demands_.most_demanding(strength_, host_))
    obstacles_.push_back({no_index, arc, why});
}

void GradedSearch::set_obstacle(std::string why) {
  obstacles_.clear();
  obstacles_.push_back({no_index, no_index, std::move(why)});
}

bool GradedSearch::strengthen(Index arc, double factor) {
  const double before = strength_[arc];
  strength_[arc] = std::min(most_strength, factor * before);
  return strength_[arc] > before;
}

bool GradedSearch::strengthen_at(const FeatureObstacle& obstacle, double factor) {
  bool finer = false;
  const auto around = [&](Index corner, double by) {
    for (const mesh::FeatureEnd& end : graph_.around[corner])
      finer = strengthen(end.arc, by) || finer;
  };
  if (obstacle.corner != no_index) around(obstacle.corner, factor);
  if (obstacle.arc != no_index) {
    finer = strengthen(obstacle.arc, std::sqrt(factor)) || finer;
    for (const Index corner : graph_.arcs[obstacle.arc].corners)
      around(corner, std::sqrt(factor));
  }
  return finer;
}

void GradedSearch::refine_at(std::span<const FeatureObstacle> obstacles, double factor) {
  bool finer = false;
  for (const FeatureObstacle& obstacle : obstacles)
    finer = strengthen_at(obstacle, factor) || finer;
  if (!finer) refine_everywhere(everywhere);
}

void GradedSearch::refine_everywhere(double factor) {
  for (Index a = 0; a < strength_.size(); ++a)
    strengthen(a, factor);
  base_cells_ *= factor;
}

}  // namespace orbicube::hexmesh
