#include "volume_map/frames/frame_map.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/place_text.h"
#include "untangle/tetrahedra/newton.h"
#include "volume_map/frames/field_refusal.h"
#include "volume_map/frames/frame_energy.h"
#include "volume_map/frames/layer_bounds.h"

namespace orbicube::volume_map {
namespace {

using quaternion::cube_group;
using Connectivity = mesh::TetrahedralConnectivity;

class FrameMapping {
 public:
  FrameMapping(const FramedSolid& solid, const FrameMapOptions& options, const base::Host& host)
      : options_(options), host_(host), map_(host.memory) {
    map_.solid.positions = solid.positions;
    map_.solid.tetrahedra = solid.tetrahedra;
    map_.solid.frames = solid.frames;
  }

  FrameMap run() {
    FramedSolid& solid = map_.solid;
    {
      const Connectivity connectivity(solid.positions.size(), solid.tetrahedra, host_);
      const mesh::EdgeRings rings(connectivity, host_);
      require_meshable(solid, connectivity, rings, frame_field::matchings(connectivity, solid.frames, host_), host_);
    }
    split_for_frames(solid, host_);
    // Where few stay inverted, these get more room.
    Array<Index> bad(host_.memory);
    for (int attempt = 1; !attempt_map(attempt == options_.max_attempts, bad); ++attempt) {
      split_around(solid, bad, host_);
      split_for_frames(solid, host_);
    }
    return std::move(map_);
  }

 private:
  // Returns whether all tetrahedra are positive and lie round their edges as they should, and which are or do not;
  // throws if this is the last attempt.
  bool attempt_map(bool last, Array<Index>& bad) {
    FramedSolid& solid = map_.solid;
    const Connectivity connectivity(solid.positions.size(), solid.tetrahedra, host_);
    const mesh::EdgeRings rings(connectivity, host_);
    FrameCut cut = cut_open(connectivity, rings, solid.frames, host_);
    SeamlessSystem system = make_seamless_system(solid.positions, connectivity, rings, cut, host_);
    require_apart(cut, system);
    const LayerBounds layers =
        find_layer_bounds(solid.positions, connectivity, rings, cut, options_.cell_length, system, host_);
    Eigen::VectorXd integers, free;
    choose_integers(cut, system, layers, integers, free);
    bad = make_injective(cut, system, integers, free);
    if (!bad.empty()) {
      constexpr std::size_t few = 20;  // one of this number of tetrahedra
      if (!last && collapsed_.empty() && bad.size() * few < solid.tetrahedra.size()) return false;
      throw base::Error("no-valid-result",
                        collapsed_ + std::to_string(bad.size()) + " of " +
                            base::counted(solid.tetrahedra.size(), "tetrahedron stays", "tetrahedra stay") +
                            " inverted after " + base::counted(map_.steps, "step") + ", the first at " +
                            mesh::place_text(solid.positions[solid.tetrahedra[bad.front()][0]]) +
                            beside(bad.front(), cut, connectivity, rings));
    }
    set_transitions(cut, system, connectivity, integers);
    // More room has to help, or a map goes once too often around a vertex, where it will stay.
    bad = certify(cut, connectivity, rings, last);
    if (!bad.empty()) {
      if (bad.size() >= fewest_wound_) certify(cut, connectivity, rings, true);
      fewest_wound_ = bad.size();
      return false;
    }
    map_.label = std::move(system.label);
    map_.patch = std::move(system.patch);
    map_.patches = system.patches;
    map_.sheets = cut.sheets();
    map_.integers = system.integers;
    map_.bounds = layers.bounds.size();
    for (Index face = 0; face < cut.sheet.size(); ++face)
      map_.cut_faces += cut.sheet[face] != no_index && cut.forward[face] != 0;
    for (const std::uint8_t s : cut.singular)
      map_.singular_edges += s;
    solid.frames = std::move(cut.frames);
    return true;
  }

  // Throws where the equations alone put two corners of a tetrahedron in one place: no integers and no splits help.
  void require_apart(const FrameCut& cut, const SeamlessSystem& system) const {
    const FramedSolid& solid = map_.solid;
    const auto same = [&](Index form, Index other) {
      const auto x = system.forms.terms(form), y = system.forms.terms(other);
      return std::equal(x.begin(), x.end(), y.begin(), y.end());
    };
    for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
      if (t % 1024 == 0) host_.report("check", t, solid.tetrahedra.size());
      for (std::size_t k = 1; k < 4; ++k) {
        for (std::size_t l = 0; l < k; ++l) {
          bool apart = false;
          for (std::size_t a = 0; a < 3 && !apart; ++a) {
            const std::size_t i = 3 * std::size_t{cut.copies[t][k]} + a, j = 3 * std::size_t{cut.copies[t][l]} + a;
            apart = system.variable[i] != no_index || system.variable[j] != no_index ||
                    !same(system.form[i], system.form[j]);
          }
          if (apart) continue;
          const Index p = solid.tetrahedra[t][l], q = solid.tetrahedra[t][k];
          throw base::Error("no-valid-result", "the singular curves put vertices " + std::to_string(p) + " and " +
                                                   std::to_string(q) + " in one place, at " +
                                                   mesh::place_text(solid.positions[p]) + " and " +
                                                   mesh::place_text(solid.positions[q]));
        }
      }
    }
  }

  void choose_integers(const FrameCut& cut, const SeamlessSystem& system, const LayerBounds& layers,
                       Eigen::VectorXd& integers, Eigen::VectorXd& free) {
    const FramedSolid& solid = map_.solid;
    const FrameEnergy energy(solid.positions, solid.tetrahedra, cut, system, options_.cell_length, host_);
    const Rounding rounding =
        round_integers(energy.curvature(), energy.best_integers(), system.forms, layers.bounds, {}, host_);
    collapsed_.clear();
    if (rounding.violated > 0) {
      const std::size_t b = rounding.first_violated;
      collapsed_ = std::to_string(rounding.violated) + " of " + base::counted(layers.bounds.size(), "layer") +
                   " of cells would collapse, the first between " + mesh::place_text(layers.from[b]) + " and " +
                   mesh::place_text(layers.to[b]) + "; ";
    }
    integers = rounding.integers;
    free = energy.free_variables(integers);
    map_.integers_optimal = rounding.optimal;
    map_.integer_cost = rounding.cost;
  }

  // What lies next to a tetrahedron that stays inverted.
  std::string beside(Index t, const FrameCut& cut, const Connectivity& connectivity,
                     const mesh::EdgeRings& rings) const {
    const FramedSolid& solid = map_.solid;
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      if (cut.singular[ring] == 0) continue;
      const auto [p, q] = rings.vertices(ring);
      const Tetrahedron& c = solid.tetrahedra[t];
      if (std::find(c.begin(), c.end(), p) != c.end() || std::find(c.begin(), c.end(), q) != c.end())
        return ", beside the singular edge " + std::to_string(p) + "-" + std::to_string(q);
    }
    const auto outer = connectivity.boundary_vertices(host_.memory);
    for (const Index v : solid.tetrahedra[t]) {
      if (outer[v] != 0) return ", beside the boundary";
    }
    return ", inside";
  }

  // Sets the charts; returns the tetrahedra that are not positive.
  Array<Index> make_injective(const FrameCut& cut, const SeamlessSystem& system, const Eigen::VectorXd& integers,
                              const Eigen::VectorXd& free) {
    const FramedSolid& solid = map_.solid;
    const std::size_t copies = cut.vertex_of_copy.size();
    Array<untangle::Variables::Affine> coordinates(3 * copies, host_.memory);
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      double shift = 0;
      for (const IntegerTerm& term : system.forms.terms(system.form[i]))
        shift += term.factor * integers[term.unknown];
      coordinates[i] = {system.variable[i], system.sign[i], shift};
    }
    const untangle::Variables variables(coordinates, {free.data(), static_cast<std::size_t>(free.size())},
                                        host_.memory);
    Array<Tetrahedron> corners(solid.tetrahedra.size(), host_.memory);
    Array<Vector3> rest(copies, host_.memory), image(copies, host_.memory);
    for (std::size_t t = 0; t < corners.size(); ++t)
      corners[t] = cut.copies[t];
    for (std::size_t c = 0; c < copies; ++c)
      rest[c] = solid.positions[cut.vertex_of_copy[c]];
    variables.expand(variables.start(), image);
    require_small(image);
    map_.inverted_at_start = inverted(corners, image).size();
    double volume = 0, target = 0;
    for (const Tetrahedron& t : corners) {
      volume += untangle::six_volumes(image, t);
      target += untangle::six_volumes(rest, t);
    }
    const double scale = volume > 0 ? std::cbrt(volume / target) : 1 / options_.cell_length;
    const Array<untangle::Element> elements = untangle::elements_of(corners, rest, scale, host_);
    untangle::FoldoverEnergy energy(elements, variables, 1, host_);
    untangle::Newton newton(energy, variables.start(), host_);
    // A large eps finds no way here. More steps would help less than more room.
    constexpr int max_steps = 60;
    constexpr double max_eps = 0.4;
    bool done = newton.untangle(max_steps, max_eps, 1, {});
    if (!done && options_.patient) {
      newton.restart(variables.start());
      done = newton.untangle(2 * max_steps, max_eps, 6, {});
    }
    if (done) newton.polish(20, 1e-3, {.tolerance = 3e-2});
    map_.steps += newton.steps();
    // Short numbers, so that turning and shifting is exact.
    Array<double> values(newton.values().begin(), newton.values().end(), host_.memory);
    for (double& x : values)
      x = std::ldexp(std::round(std::ldexp(x, 30)), -30);
    variables.expand(values, image);
    require_small(image);
    Array<Index> bad = inverted(corners, image);
    map_.charts.resize(corners.size());
    for (std::size_t t = 0; t < corners.size(); ++t) {
      for (std::size_t k = 0; k < 4; ++k)
        map_.charts[t][k] = image[corners[t][k]];
    }
    return bad;
  }

  // Coordinates that have their multiples of 2^-30 exactly, with room for gaps.
  static void require_small(std::span<const Vector3> image) {
    constexpr double most = 1 << 20;
    for (const Vector3& x : image) {
      if (!(x.cwiseAbs().maxCoeff() < most))
        throw base::Error("no-valid-result", "the map has a million cells along an axis, or more");
    }
  }

  Array<Index> inverted(std::span<const Tetrahedron> corners, std::span<const Vector3> image) const {
    Array<Index> result(host_.memory);
    for (Index t = 0; t < corners.size(); ++t) {
      if (t % 4096 == 0) host_.report("check", t, corners.size());
      const Tetrahedron& c = corners[t];
      if (mesh::orientation_3d(image[c[0]], image[c[1]], image[c[2]], image[c[3]]) <= 0) result.push_back(t);
    }
    return result;
  }

  void set_transitions(const FrameCut& cut, const SeamlessSystem& system, const Connectivity& connectivity,
                       const Eigen::VectorXd& integers) {
    map_.transition.assign(connectivity.face_count(), Transition());
    for (Index face = 0; face < connectivity.face_count(); ++face) {
      if (cut.sheet[face] == no_index || cut.forward[face] == 0) continue;
      Transition& t = map_.transition[face];
      t.rotation = cube_group.inverse[cut.rotation[face]];
      for (std::size_t a = 0; a < 3; ++a) {
        double gap = 0;
        for (const IntegerTerm& term : system.forms.terms(system.gap[cut.sheet[face]][a]))
          gap += term.factor * integers[term.unknown];
        t.shift[a] = static_cast<std::int32_t>(gap);
      }
      map_.transition[connectivity.opposite(face)] = inverse(t);
    }
  }

  // Transitions to the bit, and angles around inner edges. Returns the tetrahedra around edges with wrong ones, which
  // there may be where few tetrahedra are around an edge; throws if this is the last attempt.
  Array<Index> certify(const FrameCut& cut, const Connectivity& connectivity, const mesh::EdgeRings& rings,
                       bool last) const {
    const auto corner = [&](Index t, Index v) { return map_.charts[t][connectivity.corner_of(t, v)]; };
    for (Index face = 0; face < connectivity.face_count(); ++face) {
      if (face % 4096 == 0) host_.report("check", face, connectivity.face_count());
      const Index other = connectivity.opposite(face);
      if (other == no_index) continue;
      for (const Index v : connectivity.vertices(face)) {
        if (map_.transition[face](corner(face / 4, v)) != corner(other / 4, v))
          throw base::Error("internal", "charts do not meet at face " + std::to_string(face));
      }
    }
    Array<Index> bad(host_.memory);
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
      if (rings.on_boundary(ring)) continue;
      if (ring % 1024 == 0) host_.report("check", ring, rings.size());
      const auto [p, q] = rings.vertices(ring);
      double angle = 0;
      for (const Index face : rings.faces(ring)) {
        const Index t = face / 4;
        const Vector3 a = corner(t, p), along = corner(t, q) - a;
        std::array<Vector3, 2> side;
        std::size_t count = 0;
        for (const Index v : map_.solid.tetrahedra[t]) {
          if (v != p && v != q) side[count++] = along.cross(corner(t, v) - a);
        }
        angle += std::atan2(side[0].cross(side[1]).norm(), side[0].dot(side[1]));
      }
      const long quarters = std::lround(angle / (0.5 * std::numbers::pi));
      const bool right = cut.singular[ring] == 0 ? quarters == 4 : quarters == 3 || quarters == 5;
      if (right) continue;
      if (last) {
        throw base::Error("no-valid-result", "the map goes round edge " + std::to_string(p) + "-" + std::to_string(q) +
                                                 " at " + mesh::place_text(map_.solid.positions[p]) + " with " +
                                                 base::counted(quarters, "right angle"));
      }
      for (const Index face : rings.faces(ring))
        bad.push_back(face / 4);
    }
    return bad;
  }

  const FrameMapOptions& options_;
  const base::Host& host_;
  FrameMap map_;
  std::size_t fewest_wound_ = std::numeric_limits<std::size_t>::max();  // tetrahedra around edges with wrong angles
  std::string collapsed_;  // layers that the integers let collapse; the map may do without them
};

}  // namespace

FrameMap map_by_frames(const FramedSolid& solid, const FrameMapOptions& options, const base::Host& host) {
  base::require(options.cell_length > 0 && std::isfinite(options.cell_length), "the length of cells must be positive");
  base::require(solid.frames.size() == solid.tetrahedra.size(), "frames need one entry a tetrahedron");
  if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
  return FrameMapping(solid, options, host).run();
}

}  // namespace orbicube::volume_map
