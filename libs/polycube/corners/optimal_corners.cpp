#include "polycube/corners/optimal_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "polycube/corners/corner_cut.h"
#include "polycube/corners/corner_newton.h"
#include "polycube/surface/added_vertices.h"
#include "polycube/surface/unit_size.h"

namespace orbicube::polycube {
namespace {

double energy_of(const Distortion& d, double area_weight) {
  return d.angle_weighted_mean + area_weight * d.area_weighted_mean;
}

bool positive(const WorkingMap& map, Index f) {
  const int axis = axis_of(map.label[f]);
  const auto flat = [&](Index v) {
    return Vector2d(map.image[v][(axis + 1) % 3], sign_of(map.label[f]) * map.image[v][(axis + 2) % 3]);
  };
  const auto& [a, b, c] = map.surface.triangle[f];
  return mesh::orientation_2d(flat(a), flat(b), flat(c)) > 0;
}

class Rounds {
 public:
  Rounds(SurfaceMap& map, const CornerOptions& options, const base::Host& host)
      : map_(map), options_(options), host_(host), result_(host.memory), course_(host.memory) {}

  OptimalCorners run() {
    result_.certificate = certify(map_.polycube, map_.triangles, host_);
    base::require(result_.certificate.valid(), "the map is not certified");
    result_.distortion = measure_distortion(map_, host_);
    result_.energies.push_back(energy_of(result_.distortion, options_.area_weight));
    const double isometry = 1 + options_.area_weight;
    for (int round = 0; round < options_.rounds; ++round) {
      const double before = result_.energies.back();
      if (options_.domain) improve_domain();
      if (!improve() && !(result_.energies.back() < before)) {
        result_.converged = true;
        break;
      }
      const double gain = before - result_.energies.back();
      if (host_.on_log) host_.log("corners: energy " + std::to_string(result_.energies.back()));
      if (!(gain > options_.min_gain * (before - isometry))) {
        result_.converged = true;
        break;
      }
    }
    return std::move(result_);
  }

 private:
  // How a corner has fared: with what step its search begins, and how many rounds it rests since it gained nothing.
  struct Course {
    double step = 0.25;
    int rests = 0;
  };
  static constexpr double last_step = 0.05;
  static constexpr int rest = 2;

  // Smaller triangles count as if they had a part of the mean area.
  double min_area(const WorkingMap& working) const {
    constexpr double part = 0.05;
    return part * working.area / static_cast<double>(map_.triangles.size());
  }

  void improve_domain() {
    OptimalDomain found =
        optimize_domain(map_, {.measure = DomainMeasure::surface_mean, .area_weight = options_.area_weight}, host_);
    // Sums of thousands of terms, in another order.
    result_.energies.push_back(std::min(energy_of(found.distortion, options_.area_weight), result_.energies.back()));
    result_.distortion = found.distortion;
    result_.certificate = std::move(found.certificate);
  }

  // One round; false, with nothing changed, when it gains nothing or ends in no valid map.
  bool improve() {
    WorkingMap working(map_, host_);
    move_corners(working);
    move_edges(working);
    WorkingMap refined(working);
    const MapView view{working.surface, working.label, working.facet, working.image, working.scale, 0};
    if (remove_added_vertices(working.surface, view, host_) > 0 && accept(working)) return true;
    return accept(refined);
  }

  bool accept(WorkingMap& working) {
    smooth_map(working, options_.area_weight, min_area(working), options_.smoothing_steps, host_);
    SurfaceMap made = working.result(host_);
    const Distortion distortion = measure_distortion(made, host_);
    const double energy = energy_of(distortion, options_.area_weight);
    constexpr double min_gain = 1e-12;  // less is rounding
    if (!(energy < result_.energies.back() * (1 - min_gain))) return false;
    Certificate certificate = certify(made, host_);
    if (!certificate.valid()) {
      host_.log("corners: " + certificate.reason);
      return false;
    }
    result_.energies.push_back(energy);
    result_.distortion = distortion;
    result_.certificate = std::move(certificate);
    std::swap(map_, made);
    return true;
  }

  // Corners in an order that neither moves of theirs nor other proportions of the polycube change.
  void move_corners(WorkingMap& working) {
    RegionFinder finder(working, host_);
    Array<Index> corners = finder.corners();
    std::sort(corners.begin(), corners.end(), [&](Index a, Index b) {
      const Vector3 &p = working.image[a], &q = working.image[b];
      return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    });
    course_.resize(corners.size());
    const double excess = result_.energies.back() - 1 - options_.area_weight;
    const double little = options_.min_gain * excess / static_cast<double>(corners.size());
    double triangles = 0;
    std::size_t movable = 0;
    CornerRegion region(host_.memory);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      host_.report("corners", i, corners.size(), result_.energies.back());
      Course& course = course_[i];
      if (course.rests > 0) {
        --course.rests;
        continue;
      }
      if (!finder.find(corners[i], options_.max_vertices, region)) continue;
      ++movable;
      CornerMove move(region, working.area, {.area_weight = options_.area_weight, .min_area = min_area(working)},
                      host_);
      const CornerSearch found = search_corner(move, options_.method, course.step, host_);
      result_.evaluations += found.evaluations;
      triangles += static_cast<double>(found.evaluations * region.triangles.size());
      course.step = std::clamp(2 * found.at.norm(), last_step, Course().step);
      if (!(move.energy_now() - found.energy > little)) course.rests = rest;
      if (found.improved && cut(move, working)) ++result_.moves;
    }
    if (result_.movable == 0) result_.movable = movable;
    result_.map_evaluations += triangles / static_cast<double>(map_.triangles.size());
  }

  // Between corners, edges of the polycube go where the distortion of the map is minimum without them.
  void move_edges(WorkingMap& working) {
    RegionFinder finder(working, host_);
    const Array<Index> middles = finder.edge_middles();
    CornerRegion region(host_.memory);
    for (std::size_t i = 0; i < middles.size(); ++i) {
      host_.report("corners", i, middles.size(), result_.energies.back());
      // One that was cut before may have left the edge beside it.
      if (working.edges_at(middles[i]) != 2 || !finder.find(middles[i], options_.max_vertices, region)) continue;
      CornerMove move(region, working.area, {.area_weight = options_.area_weight, .min_area = min_area(working)},
                      host_);
      if (move.relax() < move.energy_now()) cut(move, working);
    }
  }

  bool cut(const CornerMove& move, WorkingMap& working) {
    // Copied into memory that is there already.
    if (uncut_)
      *uncut_ = working;
    else
      uncut_.emplace(working);
    if (cut_region(move, working, host_)) return true;
    host_.log("corners: a region could not be cut");
    std::swap(*uncut_, working);
    return false;
  }

  SurfaceMap& map_;
  const CornerOptions& options_;
  const base::Host& host_;
  OptimalCorners result_;
  Array<Course> course_;             // of each corner
  std::optional<WorkingMap> uncut_;  // what was there before the last cut
};

}  // namespace

void smooth_map(WorkingMap& map, double area_weight, double min_area, int steps, const base::Host& host) {
  constexpr double min_gain = 1e-6;
  const EditableSurface& surface = map.surface;
  // A number for each coordinate; those first that may change.
  Array<std::array<Index, 3>> number(map.image.size(), {no_index, no_index, no_index}, host.memory);
  std::size_t count = 0, free = 0;
  for (const bool fixed : {false, true}) {
    for (Index v = 0; v < map.image.size(); ++v) {
      if (surface.outgoing(v) == no_index) continue;
      std::array<bool, 3> held{};
      int edges = 0;
      surface.for_each_outgoing(v, [&](Index h) {
        held[static_cast<std::size_t>(axis_of(map.label[h / 3]))] = true;
        edges += map.on_edge(h);
      });
      for (std::size_t axis = 0; axis < 3; ++axis)
        if ((held[axis] || edges > 2) == fixed) number[v][axis] = static_cast<Index>(count++);
    }
    if (!fixed) free = count;
  }
  Array<double> value(count, 0.0, host.memory);
  for (Index v = 0; v < map.image.size(); ++v) {
    if (surface.outgoing(v) == no_index) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      value[number[v][axis]] = map.image[v][static_cast<Eigen::Index>(axis)];
  }
  untangle::PlanarTriangles planar(host.memory);
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f)) continue;
    const auto axis = static_cast<std::size_t>(axis_of(map.label[f]));
    const Triangle& t = surface.triangle[f];
    std::array<Index, 6> coordinates{};
    std::array<double, 6> signs{};
    std::array<Vector3, 3> space;
    for (std::size_t k = 0; k < 3; ++k) {
      space[k] = map.scale * surface.position[t[k]];
      coordinates[2 * k] = number[t[k]][(axis + 1) % 3];
      coordinates[2 * k + 1] = number[t[k]][(axis + 2) % 3];
      signs[2 * k] = 1;
      signs[2 * k + 1] = sign_of(map.label[f]);
    }
    planar.add(space, coordinates, signs, map.area, min_area);
  }
  if (!std::isfinite(planar.energy(value, area_weight))) return;
  untangle::PlanarNewton(planar, free, corner_newton, host).polish(value, steps, min_gain, area_weight);
  const Array<Vector3> before(map.image, host.memory);
  for (Index v = 0; v < map.image.size(); ++v) {
    if (surface.outgoing(v) == no_index) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      map.image[v][static_cast<Eigen::Index>(axis)] = value[number[v][axis]];
  }
  // Positive in floating point is not always so exactly.
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f) || positive(map, f)) continue;
    map.image = before;
    return;
  }
}

OptimalCorners optimize_corners(SurfaceMap& map, const CornerOptions& options, const base::Host& host) {
  base::require(map.labels.size() == map.triangles.size() && !map.labels.empty(), "the map is not certified");
  base::require(std::isfinite(options.area_weight) && options.area_weight >= 0, "area_weight must not be negative");
  base::require(options.method == CornerMethod::trust_region || options.method == CornerMethod::gradient,
                "unknown method");
  const AtUnitSize unit(map);
  return Rounds(map, options, host).run();
}

}  // namespace orbicube::polycube
