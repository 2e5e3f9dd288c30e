#include "hexmesh/features/feature_fitting.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/threads/pieces.h"
#include "hexmesh/certificate/hex_tetrahedra.h"
#include "hexmesh/features/left_out_lines.h"
#include "untangle/tetrahedra/newton.h"

namespace orbicube::hexmesh {
namespace {

constexpr double volume_weight = 0.2;  // of the energy
constexpr double loose = 2;            // pull to the start while the mesh is untangled; less lets holes close
constexpr int untangling_steps = 100;
constexpr double first_weight = 0.3, weight_growth = 1e4;  // of targets, over the rounds
constexpr double last_progress = 1.25;                     // the growth at the end, as a power
constexpr double full_progress = 0.625;                    // of the rounds, at which the growth is reached
constexpr double slide_from = 0.36;                        // of the rounds: vertices of arcs slide from then on
constexpr double own_shapes_from = 0.2;                    // of the rounds: boxes have the lengths of hexahedra

Array<Index> all_hexahedra(const HexMesh& mesh, const base::Host& host) {
  Array<Index> all(mesh.hexahedra.size(), host.memory);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

class Fit {
 public:
  Fit(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, const FeatureFitOptions& options,
      const base::Host& host)
      : mesh_(mesh),
        sizes_(sizes),
        targets_(targets),
        options_(options),
        host_(host),
        elements_(corner_elements(mesh, all_hexahedra(mesh, host), sizes, host)),
        variables_(mesh.positions, {}, {}, host.memory),
        pulls_(mesh.positions.size(), Pull(), host.memory),
        energy_(elements_, variables_, volume_weight, host),
        newton_(energy_, variables_.start(), host) {
    energy_.set_pulls(pulls_);
  }

  bool run() {
    if (!untangle()) return false;
    for (int round = 0; round < options_.rounds; ++round) {
      host_.report("fit", static_cast<std::uint64_t>(round), static_cast<std::uint64_t>(options_.rounds));
      take_round(static_cast<double>(round) / options_.rounds);
    }
    return true;
  }

 private:
  bool untangle() {
    for (const Index v : targets_.vertices()) {
      pulls_[v].at = mesh_.positions[v];
      pulls_[v].to_point(mesh_.positions[v], loose * targets_.weight(v));
    }
    newton_.restart(variables_.start());
    const bool done = newton_.untangle(untangling_steps, 1, 1, {.products = 80});
    variables_.expand(newton_.values(), mesh_.positions);
    return done;
  }

  void take_round(double progress) {
    const double growth = std::min(last_progress, progress / full_progress);
    const double weight = first_weight * std::pow(weight_growth, growth);
    const bool slide = progress >= slide_from;
    targets_.look_from(mesh_.positions);
    if (slide) targets_.slide(mesh_.positions);
    if (slide && !lines_placed_) place_lines();
    if (progress > own_shapes_from) set_own_shapes();
    weigh_corners(mesh_.positions, progress < 0.14 ? 1 : growth < 1 ? 20 : 60, elements_);
    set_pulls(weight, slide);
    untangle::EnergyValue now = energy_.value(newton_.values(), 0);
    for (int k = 0; k < 2; ++k) {
      const double before = now.energy;
      newton_.step(0, {.products = 60, .tolerance = 3e-2}, now);
      if (now.energy > before * (1 - 1e-5)) break;
    }
    variables_.expand(newton_.values(), mesh_.positions);
  }

  void place_lines() {
    lines_placed_ = true;
    for (const PlaceOnLine& place : places_on_lines_left_out(mesh_, targets_, host_))
      targets_.keep_at(place.vertex, place.position);
  }

  void set_own_shapes() {
    base::parallel_pieces(host_, "fit", mesh_.hexahedra.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::array<double, 3> length = own_lengths(mesh_, static_cast<Index>(i), sizes_[i]);
        for (std::size_t k = 0; k < 8; ++k)
          hex_tetrahedra[k].set_shape(length, elements_[8 * i + k]);
      }
    });
  }

  void set_pulls(double weight, bool slide) {
    const auto vertices = targets_.vertices();
    base::parallel_pieces(host_, "fit", vertices.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index v = vertices[i];
        Pull& pull = pulls_[v] = Pull();
        pull.at = mesh_.positions[v];
        targets_.pull(v, mesh_.positions[v], weight, slide, pull);
      }
    });
  }

  HexMesh& mesh_;
  const BoxSizes& sizes_;
  FeatureTargets& targets_;
  const FeatureFitOptions& options_;
  const base::Host& host_;
  Array<Element> elements_;
  untangle::Variables variables_;
  Array<Pull> pulls_;
  untangle::FoldoverEnergy energy_;
  untangle::Newton newton_;
  bool lines_placed_ = false;
};

}  // namespace

bool fit_to_features(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, const FeatureFitOptions& options,
                     const base::Host& host) {
  return Fit(mesh, sizes, targets, options, host).run();
}

void smooth_inside(HexMesh& mesh, const BoxSizes& sizes, const FeatureTargets& targets, int steps,
                   const base::Host& host) {
  constexpr double most = 200;
  Array<std::uint8_t> fixed(3 * mesh.positions.size(), 0, host.memory);
  for (const Index v : targets.vertices())
    std::fill_n(fixed.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{v}), 3, std::uint8_t{1});
  Array<Element> elements = corner_elements(mesh, all_hexahedra(mesh, host), sizes, host);
  const untangle::Variables variables(mesh.positions, fixed, {}, host.memory);
  untangle::FoldoverEnergy energy(elements, variables, volume_weight, host);
  untangle::Newton newton(energy, variables.start(), host);
  for (int i = 0; i < steps; ++i) {
    host.report("smooth", static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(steps));
    weigh_corners(mesh.positions, most, elements);
    untangle::EnergyValue now = energy.value(newton.values(), 0);
    if (now.inverted > 0) return;
    if (newton.step(0, {.products = 60, .tolerance = 3e-2}, now) == 0) return;
    variables.expand(newton.values(), mesh.positions);
  }
}

}  // namespace orbicube::hexmesh
