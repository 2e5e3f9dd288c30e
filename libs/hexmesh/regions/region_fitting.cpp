#include "hexmesh/regions/region_fitting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/grouping.h"
#include "base/random.h"
#include "hexmesh/features/unfolding.h"
#include "hexmesh/quality/corner_elements.h"
#include "hexmesh/regions/region_targets.h"
#include "untangle/tetrahedra/newton.h"

namespace orbicube::hexmesh {
namespace {

class RegionFit {
 public:
  RegionFit(HexMesh& mesh, const Array<Index>& labels, const Sheets& sheets, const BoundaryLines& lines,
            RegionInterfaces& interfaces, bool creases, const base::Host& host)
      : mesh_(mesh),
        first_of_sheets_(sheets.first),
        host_(host),
        around_(base::cells_around(std::span<const Hexahedron>(mesh.hexahedra), mesh.positions.size(), host.memory)),
        targets_(mesh, labels, around_, sheets, lines, interfaces, creases, host),
        chosen_(host.memory),
        pulled_(host.memory),
        sizes_(host.memory),
        fixed_(3 * mesh.positions.size(), 1, host.memory),
        pulls_(mesh.positions.size(), Pull(), host.memory) {
    choose();
    set_sizes();
  }

  bool run() {
    Array<Element> elements = corner_elements(mesh_, chosen_, sizes_, host_);
    const untangle::Variables variables(mesh_.positions, fixed_, {}, host_.memory);
    untangle::FoldoverEnergy energy(elements, variables, volume_weight, host_);
    energy.set_pulls(pulls_);
    for (const Index v : pulled_) {
      pulls_[v].at = mesh_.positions[v];
      pulls_[v].to_point(mesh_.positions[v], targets_.on_boundary(v) ? loose : looser);
    }
    constexpr int untangling_steps = 100;
    untangle::Newton newton(energy, variables.start(), host_);
    const bool done = newton.untangle(untangling_steps, 1, 1, {.products = 80});
    variables.expand(newton.values(), mesh_.positions);
    if (!done) return false;
    for (int round = 0; round < rounds; ++round) {
      host_.report("regions", static_cast<std::uint64_t>(round), rounds);
      const double progress = static_cast<double>(round) / rounds;
      if (progress > own_shapes_from) set_own_shapes(elements);
      weigh_corners(mesh_.positions, progress < own_shapes_from ? 1 : 40, elements);
      set_pulls(first_weight * std::pow(weight_growth, progress));
      untangle::EnergyValue now = energy.value(newton.values(), 0);
      for (int k = 0; k < 2; ++k) {
        const double last = now.energy;
        newton.step(0, {.products = 60, .tolerance = 3e-2}, now);
        if (now.energy > last * (1 - 1e-5)) break;
      }
      variables.expand(newton.values(), mesh_.positions);
    }
    unfold();
    if (!is_positive()) return false;
    snap();
    improve();
    snap();
    return is_positive();
  }

 private:
  static constexpr int rings = 4;                   // of hexahedra beside the sheets that move
  static constexpr double volume_weight = 0.2;      // of the energy
  static constexpr double loose = 2, looser = 0.1;  // pulls of the boundary and of others to the start, to untangle
  static constexpr int rounds = 30;
  static constexpr double first_weight = 0.3, weight_growth = 1e4;  // of targets, over the rounds
  static constexpr double own_shapes_from = 0.2;  // of the rounds: boxes have the lengths of hexahedra

  // Hexahedra near the faces between labels, and the vertices that only these have.
  void choose() {
    Array<std::uint8_t> reached(mesh_.hexahedra.size(), 0, host_.memory);
    std::fill(reached.begin() + static_cast<std::ptrdiff_t>(first_of_sheets_), reached.end(), std::uint8_t{1});
    for (Index v = 0; v < mesh_.positions.size(); ++v) {
      if (targets_.kind(v) != RegionTargets::Kind::interface) continue;
      for (const Index i : around_[v])
        reached[i] = 1;
    }
    for (int ring = 0; ring < rings; ++ring) {
      Array<std::uint8_t> next(reached, host_.memory);
      for (Index i = 0; i < reached.size(); ++i) {
        if (i % base::items_between_reports == 0) host_.report("regions", 0, 0);
        for (const Index v : mesh_.hexahedra[i])
          for (const Index j : around_[v])
            next[i] = next[i] | reached[j];
      }
      reached = std::move(next);
    }
    for (Index i = 0; i < reached.size(); ++i)
      if (reached[i] != 0) chosen_.push_back(i);
    for (Index v = 0; v < mesh_.positions.size(); ++v) {
      const auto cells = around_[v];
      const bool free = !cells.empty() && targets_.kind(v) != RegionTargets::Kind::fixed &&
                        std::all_of(cells.begin(), cells.end(), [&](Index i) { return reached[i] != 0; });
      if (!free) continue;
      std::fill_n(fixed_.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{v}), 3, std::uint8_t{0});
      if (targets_.kind(v) != RegionTargets::Kind::inside) pulled_.push_back(v);
    }
  }

  // Those of the sheets are half as thick as others.
  void set_sizes() {
    constexpr double thickness = 0.5;
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i) {
      const Hexahedron& h = mesh_.hexahedra[i];
      std::array<double, 3> size{};
      for (std::size_t d = 0; d < 3; ++d) {
        for (const auto& e : edges_along[d])
          size[d] += 0.25 * (mesh_.positions[h[e[1]]] - mesh_.positions[h[e[0]]]).norm();
      }
      if (i >= first_of_sheets_) size[2] = thickness * std::sqrt(size[0] * size[1]);
      sizes_.push_back(size);
    }
  }

  void set_own_shapes(Array<Element>& elements) const {
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      const std::array<double, 3> lengths = own_lengths(mesh_, chosen_[i], sizes_[chosen_[i]]);
      for (std::size_t k = 0; k < corner_tetrahedra; ++k)
        hex_tetrahedra[k].set_shape(lengths, elements[corner_tetrahedra * i + k]);
    }
  }

  // Hexahedra that are folded between good corners.
  void unfold() {
    Array<Index> held(host_.memory);
    for (Index v = 0; v < mesh_.positions.size(); ++v)
      if (targets_.kind(v) != RegionTargets::Kind::inside) held.push_back(v);
    const Array<Vector3> start(mesh_.positions, host_.memory);
    unfold_hexahedra(
        mesh_, sizes_, held,
        [&](Index v, const Vector3&, double weight, Pull& pull) {
          constexpr double point = 4;
          if (fixed_[3 * std::size_t{v}] != 0)
            pull.to_point(start[v], point * weight);
          else
            targets_.add_pull(v, weight, pull);
        },
        host_);
  }

  void set_pulls(double weight) {
    for (const Index v : pulled_) {
      pulls_[v] = Pull();
      pulls_[v].at = mesh_.positions[v];
      targets_.add_pull(v, weight, pulls_[v]);
    }
  }

  bool is_positive() const {
    return std::all_of(chosen_.begin(), chosen_.end(),
                       [&](Index i) { return certainly_positive(mesh_.positions, mesh_.hexahedra[i]); });
  }

  double quality(Index hexahedron) const { return searched_quality(mesh_.positions, mesh_.hexahedra[hexahedron]); }
  double worst_around(Index v) const { return worst_searched_quality(mesh_, around_[v]); }
  // What a hexahedron is below good. The fourth power: the worst count most, but none becomes bad for another.
  double missing_around(Index v) const {
    constexpr double good = 0.5;
    double sum = 0;
    for (const Index i : around_[v]) {
      const double missing = std::max(0.0, good - quality(i));
      sum += missing * missing * missing * missing;
    }
    return sum;
  }

  // Tries other positions for the vertices of bad hexahedra, on their targets where they are.
  void improve() {
    constexpr int passes = 40;
    constexpr double first_radius = 0.25, last_radius = 0.02, shrinking = 0.94;  // times the mean edge
    double radius = first_radius;
    for (int pass = 0; pass < passes; ++pass) {
      const Array<Index> vertices = vertices_of_bad();
      if (vertices.empty()) return;
      for (const Index v : vertices) {
        host_.report("regions", static_cast<std::uint64_t>(pass), passes);
        try_positions(v, radius);
      }
      radius = std::max(last_radius, radius * shrinking);
    }
  }

  Array<Index> vertices_of_bad() const {
    constexpr double bad = 0.4;
    constexpr std::size_t most = 300;  // hexahedra of a pass, the worst ones
    Array<std::pair<double, Index>> worst(host_.memory);
    for (const Index i : chosen_) {
      if (const double q = quality(i); q < bad) worst.push_back({q, i});
    }
    Array<Index> vertices = hexmesh::vertices_of_worst(mesh_.hexahedra, std::move(worst), most);
    std::erase_if(vertices, [&](Index v) { return fixed_[3 * std::size_t{v}] != 0; });
    return vertices;
  }

  void try_positions(Index v, double radius) {
    constexpr int trials = 8, far_trials = 4;
    constexpr double near_part = 0.2;  // of the radius
    constexpr double gain = 1e-3;      // of what is missing
    constexpr double on_target = 0.02;
    Vector3& at = mesh_.positions[v];
    double missing = missing_around(v);
    for (int trial = 0; trial < trials; ++trial) {
      const Vector3 from = at;
      const bool held =
          targets_.kind(v) != RegionTargets::Kind::inside && (targets_.target(v).position - from).norm() < on_target;
      const double x = uniform(), y = uniform(), z = uniform();
      at += radius * (trial < far_trials ? 1 : near_part) * Vector3(x, y, z);
      if (held) at = targets_.target(v).position;
      const double now = missing_around(v);
      if (now < (1 - gain) * missing)
        missing = now;
      else
        at = from;
    }
  }

  double uniform() { return 2 * base::unit_interval(random_()) - 1; }

  // Puts vertices onto their targets as far as the hexahedra allow.
  void snap() {
    constexpr double kept = 0.8, floor = 0.1, positive = 1e-3;
    for (int round = 0; round < 3; ++round) {
      for (const Index v : pulled_) {
        if (v % 64 == 0) host_.report("regions", 0, 0);
        const Vector3 from = mesh_.positions[v], to = targets_.target(v).position;
        const double least = std::max(positive, std::min(kept * worst_around(v), floor));
        for (const double part : {1.0, 0.5, 0.25}) {
          mesh_.positions[v] = part == 1 ? to : Vector3(from + part * (to - from));
          if (worst_around(v) >= least) break;
          mesh_.positions[v] = from;
        }
      }
    }
  }

  HexMesh& mesh_;
  const std::size_t first_of_sheets_;
  const base::Host& host_;
  const base::Groups<Index, Index> around_;
  RegionTargets targets_;
  Array<Index> chosen_, pulled_;  // hexahedra that move, and vertices of them with targets
  BoxSizes sizes_;
  Array<std::uint8_t> fixed_;
  Array<Pull> pulls_;
  std::mt19937_64 random_{1};
};

}  // namespace

bool fit_to_regions(HexMesh& mesh, const Array<Index>& labels, const Sheets& sheets, const BoundaryLines& lines,
                    RegionInterfaces& interfaces, bool creases, const base::Host& host) {
  return RegionFit(mesh, labels, sheets, lines, interfaces, creases, host).run();
}

}  // namespace orbicube::hexmesh
