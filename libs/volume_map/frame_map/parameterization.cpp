#include "volume_map/frame_map/parameterization.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/place_text.h"
#include "untangle/tetrahedra/elements.h"
#include "volume_map/frames/field_refusal.h"
#include "volume_map/frames/frame_energy.h"
#include "volume_map/frames/layer_bounds.h"
#include "volume_map/frames/transitions.h"

namespace orbicube::volume_map {
namespace {

using quaternion::cube_group;
using Connectivity = mesh::TetrahedralConnectivity;

constexpr double default_cells = 10'000;

double volume_of(const FramedSolid& solid) {
  double volume = 0;
  for (const Tetrahedron& t : solid.tetrahedra)
    volume += untangle::six_volumes(solid.positions, t) / 6;
  return volume;
}

// M x, M the matrix of a rotation.
Vector3 turned(std::uint8_t rotation, const Vector3& x) {
  return Transition{rotation, {}}.turn(x);
}

void set_transitions(const FrameCut& cut, const SeamlessSystem& system, const Connectivity& connectivity,
                     const Eigen::VectorXd& integers, Parameterization& map) {
  const std::size_t faces = connectivity.face_count();
  map.rotation.assign(faces, 0);
  map.gap.assign(faces, Vector3::Zero());
  map.cut.assign(faces, 0);
  for (Index face = 0; face < faces; ++face) {
    if (cut.sheet[face] == no_index) continue;
    map.cut[face] = 1;
    if (cut.forward[face] == 0) continue;
    const Index back = connectivity.opposite(face);
    map.rotation[face] = cube_group.inverse[cut.rotation[face]];
    map.rotation[back] = cut.rotation[face];
    for (std::size_t a = 0; a < 3; ++a) {
      double& gap = map.gap[face][static_cast<Eigen::Index>(a)];
      for (const IntegerTerm& term : system.forms.terms(system.gap[cut.sheet[face]][a]))
        gap += term.factor * integers[term.unknown];
    }
    map.gap[back] = -turned(map.rotation[back], map.gap[face]);
    ++map.cut_faces;
  }
}

// Coordinates of the corners, and what they cost.
void set_corners(const FramedSolid& solid, const FrameCut& cut, const SeamlessSystem& system,
                 const Eigen::VectorXd& free, const Eigen::VectorXd& integers, const base::Host& host,
                 Parameterization& map) {
  Array<double> coordinates(3 * cut.vertex_of_copy.size(), host.memory);
  expand(system, free, integers, coordinates);
  map.corners.resize(solid.tetrahedra.size());
  double energy = 0;
  for (std::size_t t = 0; t < map.corners.size(); ++t) {
    if (t % 4096 == 0) host.report("check", t, map.corners.size());
    std::array<Vector3, 4> p;
    Eigen::Matrix<double, 4, 3> image;
    for (std::size_t k = 0; k < 4; ++k) {
      p[k] = solid.positions[solid.tetrahedra[t][k]];
      map.corners[t][k] = Eigen::Map<const Vector3>(&coordinates[3 * std::size_t{cut.copies[t][k]}]);
      if (!map.corners[t][k].allFinite()) {
        throw base::Error("no-valid-result", "the parameters overflow at tetrahedron " + std::to_string(t) +
                                                 ": the length of cells is too small for this solid");
      }
      image.row(static_cast<Eigen::Index>(k)) = map.corners[t][k];
    }
    const Quaternion& q = cut.frames[t];
    energy += frame_energy(p, matrix_of(q), map.cell_length, image);
    const auto& c = map.corners[t];
    map.inverted += mesh::orientation_3d(c[0], c[1], c[2], c[3]) <= 0 ? 1 : 0;
  }
  map.energy = energy * map.cell_length * map.cell_length / volume_of(solid);
}

// The maximum violation around an edge of eq. 5.11 at its two ends, and of eqs. 5.8 to 5.10 on the way.
double residual_around(const Parameterization& map, const Connectivity& connectivity, const mesh::EdgeRings& rings,
                       std::size_t ring) {
  double worst = 0;
  for (const Index v : rings.vertices(ring)) {
    Index t = rings.faces(ring).front() / 4;
    const auto corner = [&](Index of) { return map.corners[of][connectivity.corner_of(of, v)]; };
    const Vector3 start = corner(t);
    Vector3 passed = start;
    for (const Index face : rings.faces(ring)) {
      const Index beyond = connectivity.opposite(face) / 4;
      passed = turned(map.rotation[face], passed) + map.gap[face];
      worst = std::max(worst, (passed - corner(beyond)).cwiseAbs().maxCoeff());
    }
    worst = std::max(worst, (passed - start).cwiseAbs().maxCoeff());
  }
  return worst;
}

}  // namespace

double constraint_residual(const FramedSolid& solid, const Parameterization& map, const base::Host& host) {
  const Connectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const mesh::EdgeRings rings(connectivity, host);
  double worst = 0;
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (face % 4096 == 0) host.report("check", face, connectivity.face_count());
    const Index t = face / 4, other = connectivity.opposite(face);
    const auto v = connectivity.vertices(face);
    const auto corner = [&](Index of, std::size_t k) { return map.corners[of][connectivity.corner_of(of, v[k])]; };
    for (std::size_t k = 0; k < 3; ++k) {
      if (other == no_index) {
        const auto axis = static_cast<Eigen::Index>(map.label[face] / 2);
        worst = std::max(worst, std::abs(corner(t, k)[axis] - corner(t, 0)[axis]));
      } else {
        const Vector3 rest = turned(map.rotation[face], corner(t, k)) + map.gap[face] - corner(other / 4, k);
        worst = std::max(worst, rest.cwiseAbs().maxCoeff());
      }
    }
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (!rings.on_boundary(ring)) worst = std::max(worst, residual_around(map, connectivity, rings, ring));
  }
  return worst;
}

Parameterization parameterize(const FramedSolid& solid, const ParameterizationOptions& options,
                              const base::Host& host) {
  base::require(options.cell_length >= 0 && std::isfinite(options.cell_length),
                "the length of cells must be positive, or 0 for the default");
  base::require(solid.frames.size() == solid.tetrahedra.size(), "frames need one entry a tetrahedron");
  if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
  Parameterization map(host.memory);
  map.cell_length = options.cell_length > 0 ? options.cell_length : std::cbrt(volume_of(solid) / default_cells);
  const Connectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const mesh::EdgeRings rings(connectivity, host);
  require_meshable(solid, connectivity, rings, frame_field::matchings(connectivity, solid.frames, host), host);
  FrameCut cut = cut_open(connectivity, rings, solid.frames, host);
  SeamlessSystem system = make_seamless_system(solid.positions, connectivity, rings, cut, host);
  const FrameEnergy energy(solid.positions, solid.tetrahedra, cut, system, map.cell_length, host);
  map.integers = system.integers;
  Eigen::VectorXd integers = energy.minimum();
  if (options.integer) {
    const LayerBounds layers =
        find_layer_bounds(solid.positions, connectivity, rings, cut, map.cell_length, system, host);
    const Rounding rounding =
        round_integers(energy.curvature(), energy.best_integers(), system.forms, layers.bounds, {}, host);
    if (rounding.violated > 0) {
      const std::size_t b = rounding.first_violated;
      throw base::Error("no-valid-result",
                        std::to_string(rounding.violated) + " of " + base::counted(layers.bounds.size(), "layer") +
                            " of cells would collapse, the first between " + mesh::place_text(layers.from[b]) +
                            " and " + mesh::place_text(layers.to[b]) + "; request more cells");
    }
    integers = rounding.integers;
    map.integer_cost = rounding.cost * map.cell_length * map.cell_length / volume_of(solid);
    map.integers_optimal = rounding.optimal;
  }
  map.solves = system.integers + 1;
  set_transitions(cut, system, connectivity, integers, map);
  set_corners(solid, cut, system, energy.free_variables(integers), integers, host, map);
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (cut.singular[ring] != 0) map.singular_edges.push_back(rings.vertices(ring));
  }
  map.label = std::move(system.label);
  map.patch = std::move(system.patch);
  map.patches = system.patches;
  map.frames = std::move(cut.frames);
  map.residual = constraint_residual(solid, map, host);
  return map;
}

}  // namespace orbicube::volume_map
