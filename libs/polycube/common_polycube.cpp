#include "polycube/common_polycube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "mesh/topology.h"
#include "polycube/drawn_construction.h"
#include "polycube/map_smoothing.h"

namespace orbicube::polycube {
namespace {

class CommonConstruction {
 public:
  CommonConstruction(std::span<const SurfaceSpan> shapes, const CommonPolycubeOptions& options, const base::Host& host)
      : shapes_(shapes), options_(options), host_(host), best_(host.memory) {}

  CommonPolycube run() {
    check();
    find_own();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t base = 0; base < shapes_.size(); ++base) {
      if (!own_[base]) continue;
      ++tried_;
      try {
        CommonPolycube found = draw(base);
        host_.log("polycube of shape " + std::to_string(base) + ": energies add up to " +
                  std::to_string(found.energies.back()));
        if (!(found.energies.back() < least)) continue;
        least = found.energies.back();
        best_ = std::move(found);
      } catch (const base::Error& error) {
        if (error.status() != base::Status::no_valid_result) throw;
        fail(base, error.what());
      }
    }
    if (!std::isfinite(least)) throw base::Error("no-valid-result", reasons_);
    refine();
    best_.own_energies = own_energies_;
    best_.tried = tried_;
    return std::move(best_);
  }

 private:
  void check() {
    base::require(!shapes_.empty(), "no shapes");
    base::require(options_.landmarks.empty() || options_.landmarks.size() == shapes_.size(),
                  "each shape must have landmarks, or none");
    for (const auto& points : options_.landmarks)
      base::require(points.size() == options_.landmarks[0].size(), "each shape must have as many landmarks");
    std::optional<std::int64_t> genus;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const auto facts = mesh::topology(shapes_[i].positions, shapes_[i].triangles, host_);
      mesh::require_closed_manifold(facts);
      if (!facts.genus) throw base::Error("not-connected", "shape " + std::to_string(i) + " is no connected surface");
      if (genus && *genus != *facts.genus)
        throw base::Error("wrong-genus", "shape 0 has genus " + std::to_string(*genus) + ", shape " +
                                             std::to_string(i) + " " + std::to_string(*facts.genus) +
                                             ": they have no polycube in common");
      genus = facts.genus;
    }
    best_.genus = genus.value_or(0);
  }

  void fail(std::size_t shape, const std::string& what) {
    reasons_ +=
        (reasons_.empty() ? "" : "; ") + std::string("polycube of shape ") + std::to_string(shape) + ": " + what;
    host_.log("polycube of shape " + std::to_string(shape) + ": " + what);
  }

  // Each shape's own polycube, and what it comes to with the best proportions: what a common one is measured by.
  void find_own() {
    own_energies_.assign(shapes_.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      own_.emplace_back();
      try {
        own_[i] = construct(shapes_[i].positions, shapes_[i].triangles, options_.construction, host_).made.map;
        SurfaceMap best = copy_of(*own_[i]);
        SurfaceMap* const one = &best;
        double energy = optimise_domain({&one, 1}, options_.domain, host_).energies.back();
        energy = improve({&one, 1}, energy, nullptr);
        own_energies_[i] = energy;
      } catch (const base::Error& error) {
        if (error.status() != base::Status::no_valid_result) throw;
        fail(i, error.what());
      }
    }
  }

  // In the host's memory, which plain copies are not.
  SurfaceMap copy_of(const SurfaceMap& map) const {
    SurfaceMap result(host_.memory);
    result = map;
    return result;
  }

  CommonPolycube draw(std::size_t base) {
    CommonPolycube result(host_.memory);
    result.base = base;
    result.genus = best_.genus;
    result.graph = make_patch_graph(*own_[base], host_);
    Array<PointPair> pairs(host_.memory);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      if (i == base) {
        result.maps.push_back(copy_of(*own_[base]));
        continue;
      }
      pairs.clear();
      if (!options_.landmarks.empty())
        for (std::size_t k = 0; k < options_.landmarks[0].size(); ++k)
          pairs.push_back({options_.landmarks[base][k], options_.landmarks[i][k]});
      const ScatteredMap bend = bend_shape(shapes_[base], shapes_[i], pairs, host_);
      DrawingOptions drawing;
      drawing.model = &*own_[base];
      drawing.from_model = &bend;
      try {
        result.maps.push_back(
            construct_on(shapes_[i].positions, shapes_[i].triangles, result.graph, result.genus, drawing, host_).map);
      } catch (const base::Error& error) {
        if (error.status() != base::Status::no_valid_result) throw;
        throw base::Error("no-valid-result", "on shape " + std::to_string(i) + ": " + error.what());
      }
    }
    CommonDomain domain = optimise_domain(pointers(result.maps), options_.domain, host_);
    result.energies = domain.energies;
    result.certificates = std::move(domain.certificates);
    result.distortions = std::move(domain.distortions);
    return result;
  }

  static std::vector<SurfaceMap*> pointers(std::vector<SurfaceMap>& maps) {
    std::vector<SurfaceMap*> result;
    for (SurfaceMap& map : maps)
      result.push_back(&map);
    return result;
  }

  // Smooths the maps and optimises proportions again, in turns, as long as that helps; answers the sum.
  double improve(std::span<SurfaceMap* const> maps, double energy, CommonPolycube* result) {
    constexpr int most_rounds = 6, sweeps = 30;
    constexpr double least_gain = 1e-3;
    for (int round = 0; round < most_rounds; ++round) {
      std::vector<Array<Vector3>> before;
      for (SurfaceMap* map : maps) {
        before.emplace_back(map->polycube, host_.memory);
        smooth_map(*map, sweeps, host_);
      }
      double now = std::numeric_limits<double>::infinity();
      CommonDomain domain(host_.memory);
      if (std::all_of(maps.begin(), maps.end(),
                      [&](const SurfaceMap* map) { return certify(map->polycube, map->triangles, host_).valid(); })) {
        domain = optimise_domain(maps, options_.domain, host_);
        now = domain.energies.back();
      }
      if (!(now < energy)) {
        for (std::size_t i = 0; i < maps.size(); ++i)
          maps[i]->polycube = std::move(before[i]);
        break;
      }
      const bool little = energy - now < least_gain * energy;
      energy = now;
      if (result != nullptr) {
        result->energies.push_back(now);
        result->certificates = std::move(domain.certificates);
        result->distortions = std::move(domain.distortions);
      }
      if (little) break;
    }
    return energy;
  }

  void refine() {
    improve(pointers(best_.maps), best_.energies.back(), &best_);
    // The planes have moved.
    best_.graph = make_patch_graph(best_.maps[best_.base], host_);
  }

  std::span<const SurfaceSpan> shapes_;
  const CommonPolycubeOptions& options_;
  const base::Host& host_;
  std::vector<std::optional<SurfaceMap>> own_;
  Array<double> own_energies_{host_.memory};
  CommonPolycube best_;
  std::size_t tried_ = 0;
  std::string reasons_;
};

}  // namespace

CommonPolycube construct_common(std::span<const SurfaceSpan> shapes, const CommonPolycubeOptions& options,
                                const base::Host& host) {
  return CommonConstruction(shapes, options, host).run();
}

}  // namespace orbicube::polycube
