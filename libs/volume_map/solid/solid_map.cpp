#include "volume_map/solid/solid_map.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/cells.h"
#include "polycube/map/certificate.h"
#include "untangle/tetrahedra/local_untangling.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"
#include "volume_map/solid/freeing_splits.h"
#include "volume_map/solid/harmonic_start.h"

namespace orbicube::volume_map {
namespace {

using mesh::Triangle;

// The boundary triangles as elements, so that none of them flips in its plane: the derivative along the triangle
// is that of the map, and the normal in space goes to the normal of the face. The fourth corner is a vertex that stays,
// one a direction, from `normals` on.
void add_boundary(const polycube::SurfaceMap& surface, std::span<const Vector3> positions, double scale,
                  double mean_volume, double min_weight, Index normals, Array<untangle::Element>& elements) {
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const Triangle& t = surface.triangles[i];
    const Vector3 a = scale * positions[t[0]], b = scale * positions[t[1]], c = scale * positions[t[2]];
    const Vector3 twice_area = (b - a).cross(c - a);
    const double length = twice_area.norm();
    if (!(length > 0)) continue;
    const Vector3 n = twice_area / length;
    untangle::Element e;
    e.corner = {t[0], t[1], t[2], normals + surface.labels[i]};
    e.gradient = {n.cross(c - b) / length, n.cross(a - c) / length, n.cross(b - a) / length, n};
    e.weight = std::pow(0.5 * length, 1.5) / 3 / mean_volume + min_weight;
    elements.push_back(e);
  }
}

class Mapping {
 public:
  Mapping(const polycube::SurfaceMap& surface, std::span<const Vector3> target, SolidMap& map,
          const SolidMapOptions& options, const base::Host& host)
      : surface_(surface),
        map_(map),
        options_(options),
        host_(host),
        elements_(host.memory),
        start_(host.memory),
        sliding_(host.memory) {
    constexpr double min_weight = 0.02;
    const std::size_t vertices = map.source.size();
    double source_volume = 0, image_volume = 0;
    for (const Tetrahedron& t : map.tetrahedra)
      source_volume += untangle::six_volumes(map.source, t);
    for (const Triangle& t : surface.triangles)
      image_volume += target[t[0]].dot(target[t[1]].cross(target[t[2]]));
    map.scale = std::cbrt(image_volume / source_volume);
    elements_ = untangle::elements_of(map.tetrahedra, map.source, map.scale, host);
    const std::size_t inner = elements_.size();

    start_.assign(vertices, Vector3::Zero());
    Array<std::uint8_t> held(vertices, 0, host.memory);
    for (std::size_t v = 0; v < target.size(); ++v) {
      start_[v] = target[v];
      held[v] = 1;
    }
    Vector3 center = Vector3::Zero();
    for (const Vector3& p : target)
      center += p / static_cast<double>(target.size());
    std::fill(start_.begin() + static_cast<std::ptrdiff_t>(target.size()), start_.end(), center);
    make_harmonic(elements_, held, start_, host, options.engine);
    if (options.start) options.start(map, held, start_);

    const double mean = std::abs(image_volume) / static_cast<double>(inner);
    add_boundary(surface, map.source, map.scale, mean / 6, min_weight, static_cast<Index>(vertices), elements_);
    for (polycube::AxisLabel label = 0; label < polycube::label_count; ++label)
      start_.push_back(polycube::direction_of(label));
    sliding_.assign(3 * start_.size(), 0);
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
      for (const Index v : surface.triangles[i])
        sliding_[3 * v + static_cast<std::size_t>(polycube::axis_of(surface.labels[i]))] = 1;
    }
    std::fill(sliding_.begin() + static_cast<std::ptrdiff_t>(3 * vertices), sliding_.end(), 1);
    map.inverted_at_start = untangle::count_inverted(map.tetrahedra, start_, host).count;
  }

  // Only neighborhoods of inverted elements move.
  untangle::LocalUntangling untangle_neighborhoods() {
    map_.image = start_;
    untangle::LocalUntangling local =
        untangle::untangle_locally(elements_, sliding_, 1, options_.steps, map_.image, host_);
    map_.steps += local.steps;
    return local;
  }

  // All vertices of the boundary slide; where elements jam, a growing ring round them is fixed to the surface map, and
  // all begins again.
  bool untangle(int max_holds) {
    Array<std::uint8_t> held(start_.size(), 0, host_.memory);
    for (int holds = 0;; ++holds, ++map_.holds) {
      Array<std::uint8_t> fixed(sliding_, host_.memory);
      for (std::size_t v = 0; v < surface_.positions.size(); ++v) {
        for (std::size_t a = 0; a < 3 && held[v] != 0; ++a)
          fixed[3 * v + a] = 1;
      }
      const untangle::Variables variables(start_, fixed, {}, host_.memory);
      untangle::FoldoverEnergy energy(elements_, variables, 1, host_);
      energy.set_engine(options_.engine);
      untangle::Newton newton(energy, variables.start(), host_);
      const bool done = newton.untangle(options_.steps, 1, 1, {});
      map_.steps += newton.steps();
      map_.image.resize(start_.size());
      variables.expand(newton.values(), map_.image);
      if (done || holds == max_holds) return done;
      for (const untangle::Element& e : elements_) {
        if (e.jacobian(map_.image).determinant() > 0) continue;
        for (const Index v : e.corner)
          held[v] = 1;
      }
      for (int ring = 0; ring <= holds; ++ring)
        grow(held);
    }
  }

  void polish() {
    const untangle::Variables variables(map_.image, sliding_, {}, host_.memory);
    untangle::FoldoverEnergy energy(elements_, variables, 1, host_);
    energy.set_engine(options_.engine);
    untangle::Newton newton(energy, variables.start(), host_);
    newton.polish(options_.polish_steps, 1e-4, {.tolerance = 3e-2});
    map_.steps += newton.steps();
    variables.expand(newton.values(), map_.image);
  }

  // An entry a vertex: 1 for those of elements that stayed inverted.
  Array<std::uint8_t> jammed() const {
    Array<std::uint8_t> result(map_.source.size(), 0, host_.memory);
    for (const untangle::Element& e : elements_) {
      if (e.jacobian(map_.image).determinant() > 0) continue;
      for (const Index v : e.corner) {
        if (v < result.size()) result[v] = 1;
      }
    }
    return result;
  }

  std::string inverted() const {
    std::size_t tetrahedra = 0, triangles = 0;
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      if (elements_[i].jacobian(map_.image).determinant() > 0) continue;
      ++(i < map_.tetrahedra.size() ? tetrahedra : triangles);
    }
    return base::counted(tetrahedra, "tetrahedron", "tetrahedra") + " and " +
           base::counted(triangles, "triangle of the boundary stays", "triangles of the boundary stay") + " inverted";
  }

 private:
  void grow(Array<std::uint8_t>& held) const {
    const Array<std::uint8_t> before(held, host_.memory);
    for (std::size_t i = 0; i < map_.tetrahedra.size(); ++i) {
      const Tetrahedron& t = map_.tetrahedra[i];
      if (before[t[0]] + before[t[1]] + before[t[2]] + before[t[3]] == 0) continue;
      for (const Index v : t)
        held[v] = 1;
    }
  }

  const polycube::SurfaceMap& surface_;
  SolidMap& map_;
  const SolidMapOptions& options_;
  const base::Host& host_;
  Array<untangle::Element> elements_;
  Array<Vector3> start_;         // with the directions behind
  Array<std::uint8_t> sliding_;  // what stays while the boundary slides
};

}  // namespace

SolidMap map_solid(const polycube::SurfaceMap& surface, std::span<const Vector3> target,
                   std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                   const SolidMapOptions& options, const base::Host& host) {
  base::require(target.size() == surface.positions.size() && target.size() <= positions.size(),
                "the solid has fewer vertices than its surface");
  SolidMap map(host.memory);
  map.source.assign(positions.begin(), positions.end());
  map.tetrahedra.assign(tetrahedra.begin(), tetrahedra.end());
  map.added = split_for_freedom(map.source, map.tetrahedra, host);
  // An inner vertex may be next to triangles of the boundary that have no place in common on the right side of all:
  // where elements jam, edges are halved, and all begins again.
  constexpr int max_refinements = 3;
  for (int refinements = 0;; ++refinements) {
    Mapping mapping(surface, target, map, options, host);
    const bool last = refinements == max_refinements;
    const untangle::LocalUntangling local = mapping.untangle_neighborhoods();
    const bool jammed = !local.jammed.empty();  // not too much to try neighborhoods alone
    if (local.done || ((last || !jammed) && mapping.untangle(last ? 3 : 1))) {
      mapping.polish();
      break;
    }
    if (last)
      throw base::Error("no-valid-result", "the map of the solid could not be made one to one: " + mapping.inverted());
    const std::span<const std::uint8_t> marked = local.jammed;
    map.added +=
        split_edges_at(map.source, map.tetrahedra, jammed ? marked.first(map.source.size()) : mapping.jammed(), host);
  }
  map.image.resize(map.source.size());
  const untangle::InvertedCount found = untangle::count_inverted(map.tetrahedra, map.image, host);
  if (found.count > 0) {
    throw base::Error("no-valid-result", "the map of the solid could not be made one to one: " +
                                             base::counted(found.count, "tetrahedron is", "tetrahedra are") + " flat");
  }
  const polycube::Certificate certificate =
      polycube::certify(std::span(map.image).first(target.size()), surface.triangles, host);
  if (!certificate.valid())
    throw base::Error("no-valid-result",
                      "the boundary of the solid does not cover the polycube once: " + certificate.reason);
  return map;
}

}  // namespace orbicube::volume_map
