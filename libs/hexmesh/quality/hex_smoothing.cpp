#include "hexmesh/quality/hex_smoothing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/threads/pieces.h"
#include "hexmesh/quality/hex_elements.h"
#include "hexmesh/quality/surface_coverage.h"
#include "untangle/tetrahedra/local_untangling.h"
#include "untangle/tetrahedra/newton.h"

namespace orbicube::hexmesh {
namespace {

class Smoothing {
 public:
  Smoothing(HexMesh& mesh, HexBoundary& boundary, const SurfaceTarget& target, const HexSmoothingOptions& options,
            const base::Host& host)
      : mesh_(mesh),
        boundary_(boundary),
        options_(options),
        host_(host),
        anchor_(mesh.positions, host.memory),
        elements_(mesh, host),
        pulls_(mesh.positions.size(), Pull(), host.memory),
        stiffness_(mesh.positions.size(), 1, host.memory),
        coverage_(mesh, target, options.distance, host),
        variables_(mesh.positions, {}, {}, host.memory) {}

  bool run() {
    if (!make_positive()) return false;
    Array<Vector3> best_positions(host_.memory);
    double best = -std::numeric_limits<double>::infinity();
    for (int round = 0; round < options_.rounds; ++round) {
      host_.report("smooth", static_cast<std::uint64_t>(round), static_cast<std::uint64_t>(options_.rounds));
      prepare(round);
      take_steps();
      // Projections may change from round to round: the best of the last rounds counts.
      if (4 * round < 3 * options_.rounds) continue;
      const double score = worst() - coverage_.excess();
      if (score > best) {
        best = score;
        best_positions.assign(mesh_.positions.begin(), mesh_.positions.end());
      }
    }
    if (!best_positions.empty()) mesh_.positions = best_positions;
    untwist_the_last();
    return true;
  }

 private:
  static constexpr double quick = 0.5, slow = 0.1;  // of eps, a step
  static constexpr double first_pull = 20, last_pull = 1000;
  static constexpr double volume_weight = 0.1;

  // Untangles the mesh from where it is. The start is near to a mesh without inverted corners most often, so that eps
  // may fall quickly.
  bool make_positive() {
    elements_.set_shapes(0, options_.padding);
    begin(variables_.start());
    if (untangle(first_pull, quick)) return true;
    newton_->restart(variables_.start());
    return untangle(first_pull, slow);
  }

  // Sets shapes, weights and pulls for the steps of a round, by where the mesh is now.
  void prepare(int round) {
    const double progress = std::min(1.0, round / (0.5 * options_.rounds));
    const double own = std::min(1.0, round / 6.0), pull = first_pull * std::pow(last_pull / first_pull, progress);
    // Where corners have had time to become good, and before it is too late.
    constexpr double little = 0.02;
    if (round % 4 == 0 && 2 * round >= options_.rounds && 10 * round <= 9 * options_.rounds) untwist(own, pull, little);
    elements_.set_shapes(own, options_.padding);
    if (round >= 4) set_weights();
    if (round % 4 == 0 && 10 * round >= 4 * options_.rounds && 10 * round <= 7 * options_.rounds) release_what_is_bad();
    if (options_.lift && round >= 4 && round % 2 == 0)
      boundary_.lift(mesh_.positions, mesh_.quads, mesh_.quad_patches, host_);
    set_pulls(pull);
    if (round % 2 == 0) coverage_.find();
    // Not before the pulls have done most of what they can.
    if (round % 2 == 0 && 10 * round >= 3 * options_.rounds && options_.distance > 0)
      coverage_.hold_what_is_far(boundary_);
    coverage_.add_pulls(pulls_);
  }

  // Takes the steps of a round. The mesh follows.
  void take_steps() {
    untangle::EnergyValue now = energy_->value(newton_->values(), 0);
    for (int k = 0; k < 2; ++k) {
      const double before = now.energy;
      newton_->step(0, {.products = 60, .tolerance = 3e-2}, now);
      if (now.energy > before * (1 - 1e-5)) break;
    }
    variables_.expand(newton_->values(), mesh_.positions);
  }

  // From these values of the variables on, with the elements that there are now.
  void begin(std::span<const double> values) {
    newton_.reset();
    energy_.emplace(elements_.all(), variables_, volume_weight, host_);
    energy_->set_pulls(pulls_);
    newton_.emplace(*energy_, values, host_);
  }

  // A determinant that may be negative is worse than any corner.
  double worst() const {
    double result = 1;
    for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (i % base::items_between_reports == 0) host_.report("smooth", 0, 0);
      const Hexahedron& h = mesh_.hexahedra[i];
      const double least = min_bezier(mesh_.positions, h);
      result = std::min(result, least > 0 ? scaled_jacobian(mesh_.positions, h) : least);
    }
    return result;
  }

  // Until all elements are positive. The mesh follows.
  bool untangle(double pull, double min_fall) {
    constexpr double hopeless_eps = 1e-6;
    constexpr int turns = 8;  // of steps, between tries to untangle the few that are left
    double eps = 0;
    for (int k = 0; k < options_.untangling_steps; ++k) {
      variables_.expand(newton_->values(), mesh_.positions);
      set_pulls(pull);
      untangle::EnergyValue now = energy_->value(newton_->values(), 1);
      host_.report("untangle", static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(options_.untangling_steps),
                   static_cast<double>(now.inverted));
      if (now.inverted == 0) return true;
      if (k == 0) eps = std::clamp(std::hypot(1e-3, 0.2 * now.min_determinant), 1e-3, 1.0);
      if (k > 0 && k % turns == 0 && few(now.inverted)) {
        const bool done = untangle_neighborhoods();
        newton_->restart(values());
        if (done) return true;
      }
      if (eps < hopeless_eps) break;
      now = energy_->value(newton_->values(), eps);
      const double before = now.energy;
      newton_->step(eps, {.products = 80}, now);
      const double sigma = std::max(min_fall, 1 - now.energy / before);
      const double least = now.min_determinant, m = std::hypot(least, eps);
      eps = std::max(eps * (least < 0 ? 1 - sigma * m / (std::abs(least) + m) : 1 - sigma), 1e-9);
    }
    variables_.expand(newton_->values(), mesh_.positions);
    return energy_->value(newton_->values(), 1).inverted == 0;
  }

  bool few(std::size_t inverted) const { return 1000 * inverted < elements_.size(); }

  // Untangles inverted elements, each group of elements in its neighborhood. Returns whether nothing is inverted any
  // more.
  bool untangle_neighborhoods() {
    constexpr int max_steps = 60;
    const Array<std::uint8_t> none_fixed(3 * mesh_.positions.size(), 0, host_.memory);
    return untangle::untangle_locally(elements_.all(), none_fixed, volume_weight, max_steps, mesh_.positions, host_,
                                      pulls_)
        .done;
  }

  // Of the variables, where the mesh is now.
  Array<double> values() const {
    Array<double> result(3 * mesh_.positions.size(), 0, host_.memory);
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
      for (std::size_t a = 0; a < 3; ++a)
        result[variables_.of(v, a)] = mesh_.positions[v][static_cast<Eigen::Index>(a)];
    }
    return result;
  }

  // Where the best of all rounds has some that are twisted, they are untangled with what is beside them left alone
  // as far as that can be; what twists in turn is next.
  void untwist_the_last() {
    constexpr int max_turns = 4;
    const auto count = [&] {
      return std::count_if(mesh_.hexahedra.begin(), mesh_.hexahedra.end(),
                           [&](const Hexahedron& h) { return min_bezier(mesh_.positions, h) <= 0; });
    };
    auto fewest = count();
    Array<Vector3> best(mesh_.positions, host_.memory);
    for (int turn = 0; turn < max_turns && fewest > 0; ++turn) {
      untwist(1, last_pull, 0);
      const auto left = count();
      if (left >= fewest) continue;
      fewest = left;
      best = mesh_.positions;
    }
    mesh_.positions = best;
  }

  // Untangles the tetrahedra along the edges of hexahedra whose corners are positive while the determinant inside may
  // not be, or hardly; they count from now on where that was possible.
  void untwist(double own, double pull, double least) {
    const Array<Index> twisted = elements_.find_twisted(least);
    if (twisted.empty()) return;
    elements_.add_edges(twisted);
    elements_.set_shapes(own, options_.padding);
    set_pulls(pull);
    // In a small mesh a neighborhood is half of it, and a step for all of it costs little.
    constexpr std::size_t small = 20000;
    if (!untangle_neighborhoods() && elements_.size() < small) {
      const Array<double> reached = values();
      begin(reached);
      if (!untangle(pull, quick)) variables_.expand(reached, mesh_.positions);
    }
    elements_.keep_positive_edges(twisted);
    begin(values());
  }

  void set_weights() {
    elements_.set_weights(options_.max_weight);
    // What pulls to the surface is to keep pace.
    constexpr double light = 10;
    std::fill(stiffness_.begin(), stiffness_.end(), 1.0);
    for (const Element& e : elements_.all()) {
      for (const Index v : e.corner)
        stiffness_[v] = std::max(stiffness_[v], e.weight / light);
    }
  }

  void set_pulls(double weight) {
    constexpr double stay = 0.02, anchor = 0.1;
    std::fill(pulls_.begin(), pulls_.end(), Pull());
    const auto vertices = boundary_.vertices();
    base::parallel_pieces(host_, "smooth", vertices.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Index v = vertices[i];
        Pull& pull = pulls_[v];
        pull.at = mesh_.positions[v];
        // What is fixed belongs where it began, not to another part of the surface that is nearer now.
        const double hold = boundary_.hold(v) - 1, part = hold / (hold + 30);
        boundary_.pull(v, (1 - part) * mesh_.positions[v] + part * anchor_[v], weight * stiffness_[v], pull);
        pull.to_point(mesh_.positions[v], stay);
        const auto kind = boundary_.kind(v);
        if (kind == HexBoundary::Kind::surface || kind == HexBoundary::Kind::patch || boundary_.hold(v) > 1)
          pull.to_point(anchor_[v], anchor * boundary_.hold(v));
      }
    });
  }

  // Sharp edges are given up where hexahedra cannot follow them.
  void release_what_is_bad() {
    constexpr double bad = 0.5;
    for (const Hexahedron& h : mesh_.hexahedra) {
      if (scaled_jacobian(mesh_.positions, h) > bad) continue;
      for (const Index v : h) {
        if (boundary_.kind(v) != HexBoundary::Kind::inside) boundary_.release(v);
      }
    }
  }

  HexMesh& mesh_;
  HexBoundary& boundary_;
  const HexSmoothingOptions& options_;
  const base::Host& host_;
  Array<Vector3> anchor_;
  HexElements elements_;
  Array<Pull> pulls_;
  Array<double> stiffness_;  // of what pulls each vertex to the surface
  SurfaceCoverage coverage_;
  untangle::Variables variables_;
  std::optional<untangle::FoldoverEnergy> energy_;
  std::optional<untangle::Newton> newton_;
};

}  // namespace

bool smooth_hexahedra(HexMesh& mesh, HexBoundary& boundary, const SurfaceTarget& target,
                      const HexSmoothingOptions& options, const base::Host& host) {
  return Smoothing(mesh, boundary, target, options, host).run();
}

}  // namespace orbicube::hexmesh
