#include "hexmesh/features/unfolding.h"

#include <algorithm>
#include <cmath>

#include "base/grouping.h"
#include "hexmesh/certificate/hex_tetrahedra.h"
#include "untangle/tetrahedra/newton.h"

namespace orbicube::hexmesh {
namespace {

constexpr int max_attempts = 8;
constexpr std::size_t most_folded = 500;             // hexahedra: of more, the cells are at fault
constexpr int first_rings = 3;                       // of hexahedra around, and one more an attempt
constexpr double first_pull = 100, less_pull = 0.3;  // of the boundary to its targets, and times that an attempt
constexpr double volume_weight = 0.2;                // of the energy, as where the mesh is fitted

class Unfolding {
 public:
  Unfolding(HexMesh& mesh, const BoxSizes& sizes, std::span<const Index> vertices, const PullVertex& pull,
            const base::Host& host)
      : mesh_(mesh),
        sizes_(sizes),
        vertices_(vertices),
        pull_(pull),
        host_(host),
        around_(base::cells_around(std::span<const Hexahedron>(mesh.hexahedra), mesh.positions.size(), host.memory)),
        elements_(host.memory),
        pulls_(mesh.positions.size(), Pull(), host.memory) {}

  bool run() {
    for (int attempt = 0; attempt < max_attempts; ++attempt) {
      const Array<Index> folded = folded_hexahedra();
      if (folded.empty()) return true;
      if (folded.size() > most_folded) return false;
      const Array<Index> region = with_rings(folded, first_rings + attempt);
      set_elements(folded, region);
      relax(region, first_pull * std::pow(less_pull, attempt));
    }
    return folded_hexahedra().empty();
  }

 private:
  Array<Index> folded_hexahedra() const {
    Array<Index> folded(host_.memory);
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (i % 1024 == 0) host_.report("unfold", i, mesh_.hexahedra.size());
      if (!certainly_positive(mesh_.positions, mesh_.hexahedra[i])) folded.push_back(i);
    }
    return folded;
  }

  Array<Index> with_rings(const Array<Index>& folded, int rings) const {
    Array<Index> region(folded, host_.memory);
    for (int ring = 0; ring < rings; ++ring) {
      for (std::size_t i = 0, before = region.size(); i < before; ++i) {
        for (const Index v : mesh_.hexahedra[region[i]])
          region.insert(region.end(), around_[v].begin(), around_[v].end());
      }
      std::sort(region.begin(), region.end());
      region.erase(std::unique(region.begin(), region.end()), region.end());
    }
    return region;
  }

  void set_elements(const Array<Index>& folded, const Array<Index>& region) {
    elements_.clear();
    for (const Index i : region) {
      const std::array<double, 3> lengths = own_lengths(mesh_, i, sizes_[i]);
      const bool twisted = std::binary_search(folded.begin(), folded.end(), i);
      for (std::size_t k = 0; k < (twisted ? hex_tetrahedra.size() : corner_tetrahedra); ++k) {
        elements_.push_back(hex_tetrahedra[k].element(mesh_.hexahedra[i]));
        hex_tetrahedra[k].set_shape(lengths, elements_.back());
      }
    }
  }

  // Vertices move that only hexahedra of the region have.
  Array<std::uint8_t> fixed_coordinates(const Array<Index>& region) const {
    Array<std::uint8_t> fixed(3 * mesh_.positions.size(), 1, host_.memory);
    for (const Index i : region) {
      for (const Index v : mesh_.hexahedra[i]) {
        const auto& all = around_[v];
        if (std::all_of(all.begin(), all.end(),
                        [&](Index h) { return std::binary_search(region.begin(), region.end(), h); }))
          std::fill_n(fixed.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{v}), 3, std::uint8_t{0});
      }
    }
    return fixed;
  }

  void relax(const Array<Index>& region, double weight) {
    constexpr int untangling_steps = 60, steps = 4;
    constexpr double last_weight = 1e4, growth = 10;
    const Array<std::uint8_t> fixed = fixed_coordinates(region);
    set_pulls(fixed, weight);
    const untangle::Variables variables(mesh_.positions, fixed, {}, host_.memory);
    untangle::FoldoverEnergy energy(elements_, variables, volume_weight, host_);
    energy.set_pulls(pulls_);
    untangle::Newton newton(energy, variables.start(), host_);
    if (!newton.untangle(untangling_steps, 1, 1, {.products = 80})) return;
    // Back to the targets, with the determinants as a barrier.
    for (; weight <= last_weight; weight *= growth) {
      variables.expand(newton.values(), mesh_.positions);
      set_pulls(fixed, weight);
      untangle::EnergyValue now = energy.value(newton.values(), 0);
      for (int k = 0; k < steps; ++k) {
        if (newton.step(0, {.products = 60, .tolerance = 3e-2}, now) == 0) break;
      }
    }
    variables.expand(newton.values(), mesh_.positions);
  }

  void set_pulls(const Array<std::uint8_t>& fixed, double weight) {
    for (const Index v : vertices_) {
      pulls_[v] = Pull();
      if (fixed[3 * std::size_t{v}] != 0) continue;
      pulls_[v].at = mesh_.positions[v];
      pull_(v, mesh_.positions[v], weight, pulls_[v]);
    }
  }

  HexMesh& mesh_;
  const BoxSizes& sizes_;
  std::span<const Index> vertices_;
  const PullVertex& pull_;
  const base::Host& host_;
  const base::Groups<Index, Index> around_;
  Array<Element> elements_;
  Array<Pull> pulls_;
};

}  // namespace

bool unfold_hexahedra(HexMesh& mesh, const BoxSizes& sizes, std::span<const Index> vertices, const PullVertex& pull,
                      const base::Host& host) {
  return Unfolding(mesh, sizes, vertices, pull, host).run();
}

bool unfold_hexahedra(HexMesh& mesh, const BoxSizes& sizes, const FeatureTargets& targets, const base::Host& host) {
  const PullVertex pull = [&](Index v, const Vector3& p, double weight, Pull& to) {
    targets.pull(v, p, weight, true, to);
  };
  return unfold_hexahedra(mesh, sizes, targets.vertices(), pull, host);
}

}  // namespace orbicube::hexmesh
