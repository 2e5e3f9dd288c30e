#include "polycube/map/labelled_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "polycube/map/starts.h"
#include "polycube/map/untangling.h"
#include "polycube/surface/refinement.h"

namespace orbicube::polycube {
namespace {

constexpr int rounds_of_the_start = 15;
constexpr int no_limit = std::numeric_limits<int>::max();
constexpr int steps_without_signs = 50;

class LabelledMap {
 public:
  LabelledMap(SurfaceMap& result, const Surface& surface, const Patches& patches, const Frame& frame,
              const LabelledMapOptions& options, const base::Host& host)
      : result_(result),
        frame_(frame),
        options_(options),
        host_(host),
        network_(surface, patches, host),
        map_(surface, patches, host),
        poisson_(host.memory),
        signs_(host.memory),
        outcome_(host.memory) {}

  LabelledMapOutcome run(std::span<const double> planes) {
    if (!planes.empty() && place_patches_at(planes)) {
      Untangling untangling(map_, host_);
      for (const double first_eps : {0.0, 0.01}) {
        place_patches_at(planes);
        spread_vertices(map_, network_, host_);
        if (attempt(untangling, first_eps)) return std::move(outcome_);
      }
    }
    poisson_start(map_, rounds_of_the_start, host_);
    poisson_ = map_.value;
    const Array<double> target = target_signs(map_, network_, host_);
    signs_ = find_arc_signs(*map_.patches, *map_.surface, network_, target, options_.seed, host_);
    const bool as_wanted = signs_.consistent() && signs_.changed == 0;
    Untangling untangling(map_, host_);
    // Where no signs were found that obey the rules there hardly is a map, but the signs are no proof.
    if (as_wanted && attempt(untangling, 0)) return std::move(outcome_);
    if (!signs_.consistent() && attempt(untangling, 0, steps_without_signs)) return std::move(outcome_);
    if (!signs_.consistent()) {
      outcome_.reason =
          "no signs of arcs make the labels a polycube: " + base::counted(signs_.bad_corners.size(), "corner") +
          " and " + base::counted(signs_.bad_patches.size(), "patch is", "patches are") + " in conflict; " +
          outcome_.reason;
      return std::move(outcome_);
    }
    // Each of these finds maps that the others do not.
    for (const double first_eps : {0.0, 0.01, 0.001}) {
      if (outcome_.flipped <= options_.enough) break;
      map_.value = poisson_;
      place_patches(map_, network_, signs_, host_);
      spread_vertices(map_, network_, host_);
      if (attempt(untangling, first_eps)) break;
    }
    return std::move(outcome_);
  }

 private:
  // Each patch at the median of its triangles; whether all have one.
  bool place_patches_at(std::span<const double> planes) {
    Array<std::pair<Index, double>> known(host_.memory);
    for (Index t = 0; t < planes.size(); ++t) {
      if (!std::isnan(planes[t])) known.emplace_back(map_.patches->patch[t], planes[t]);
    }
    std::sort(known.begin(), known.end());
    std::size_t patches = 0;
    for (std::size_t begin = 0, end = 0; begin < known.size(); begin = end, ++patches) {
      while (end < known.size() && known[end].first == known[begin].first)
        ++end;
      map_.value[known[begin].first] = known[(begin + end) / 2].second;
    }
    return patches == map_.patches->count();
  }

  bool attempt(Untangling& untangling, double first_eps, int steps = no_limit) {
    const std::size_t before = untangling.steps_taken();
    const bool made = make(untangling, first_eps, steps);
    outcome_.steps += untangling.steps_taken() - before;
    return made;
  }

  bool make(Untangling& untangling, double first_eps, int steps) {
    if (!untangling.untangle({std::min(steps, options_.untangling_steps), first_eps, 1})) {
      keep_best(untangling.flipped());
      outcome_.reason = base::counted(untangling.flipped(), "triangle stays", "triangles stay") + " flipped";
      return false;
    }
    untangling.polish(options_.polishing_steps, options_.area_weight);
    store_map();
    outcome_.certificate = certify(result_, host_);
    outcome_.reason = outcome_.certificate.reason;
    return outcome_.valid();
  }

  void keep_best(std::size_t flipped) {
    if (flipped >= outcome_.flipped) return;
    outcome_.flipped = flipped;
    store_map();
  }

  void store_map() {
    result_.polycube.resize(result_.positions.size());
    for (Index v = 0; v < result_.positions.size(); ++v)
      result_.polycube[v] = map_.position(v) / frame_.scale;
  }

  SurfaceMap& result_;
  const Frame& frame_;
  const LabelledMapOptions& options_;
  const base::Host& host_;
  ArcNetwork network_;
  TiedMap map_;
  Array<double> poisson_;
  ArcSigns signs_;
  LabelledMapOutcome outcome_;
};

}  // namespace

Frame unit_frame(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  double area = 0;
  Vector3 moment = Vector3::Zero();
  for (const auto& [a, b, c] : triangles) {
    const double part = 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm();
    area += part;
    moment += part / 3 * (positions[a] + positions[b] + positions[c]);
  }
  Frame frame;
  if (area > 0) {
    frame.scale = std::exp2(std::round(-0.5 * std::log2(area)));
    frame.centre = moment / area;
  }
  return frame;
}

Surface framed(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Frame& frame,
               const base::Host& host) {
  Array<Vector3> seen(positions.size(), host.memory);
  std::transform(positions.begin(), positions.end(), seen.begin(), frame);
  return {std::move(seen), Array<Triangle>(triangles.begin(), triangles.end(), host.memory), host};
}

LabelledMapOutcome make_labelled_map(SurfaceMap& map, const Frame& frame, const LabelledMapOptions& options,
                                     std::span<const double> planes, const base::Host& host) {
  base::require(planes.empty() || planes.size() == map.triangles.size(), "planes: one a triangle");
  Array<double> plane(planes.begin(), planes.end(), host.memory);
  split_chords(map, host);
  // What was cut may lie anywhere; its patch has other triangles.
  if (!plane.empty()) plane.resize(map.triangles.size(), std::numeric_limits<double>::quiet_NaN());

  const Surface surface = framed(map.positions, map.triangles, frame, host);
  const Patches patches = find_patches(surface, map.labels, host);
  return LabelledMap(map, surface, patches, frame, options, host).run(plane);
}

}  // namespace orbicube::polycube
