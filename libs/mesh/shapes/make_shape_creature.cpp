// The creature: a control mesh grown out of a box by extruding its faces, then the Catmull-Clark surface of it. Growing
// a face outward never changes the genus, so it is 0 whatever the seed.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mesh/search/rotations.h"
#include "mesh/shapes/make_shape_kinds.h"
#include "mesh/shapes/quad_patches.h"
#include "mesh/shapes/subdivision_surface.h"

namespace orbicube::mesh {
namespace {

// The end of something that grows: a quad of the control mesh and where it looks.
struct Tip {
  std::size_t quad;
  Vector3 direction;
};

// Quads round the last piece that grew, in order of the sides of the quad that it grew from.
using Ring = std::array<std::size_t, 4>;

class ControlMesh {
 public:
  ControlMesh(const Vector3& half_size) {
    for (int i = 0; i < 8; ++i)
      complex_.corners.emplace_back((i & 1 ? 1 : -1) * half_size[0], (i & 2 ? 1 : -1) * half_size[1],
                                    (i & 4 ? 1 : -1) * half_size[2]);
    complex_.quads = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  }
  // The sides of the box.
  static constexpr std::size_t back = 0, front = 1, right = 2, left = 3, bottom = 4, top = 5;

  const QuadComplex& complex() const { return complex_; }

  // Moves the tip by `length` along `direction`, turned that way without a twist, and scaled.
  Ring grow(Tip& tip, const Vector3& direction, double length, double scale) {
    const Vector3 to = direction.normalized();
    const Quad base = complex_.quads[tip.quad];
    const Vector3 centre = centre_of(base);
    const Eigen::Quaterniond turn = rotation_between(tip.direction, to);
    const auto first = static_cast<Index>(complex_.corners.size());
    for (const Index corner : base)
      complex_.corners.push_back(centre + length * to + scale * (turn * (complex_.corners[corner] - centre)));
    const Quad end = {first, first + 1, first + 2, first + 3};
    Ring ring;
    for (std::size_t k = 0; k < 4; ++k) {
      ring[k] = complex_.quads.size();
      complex_.quads.push_back({base[k], base[(k + 1) % 4], end[(k + 1) % 4], end[k]});
    }
    complex_.quads[tip.quad] = end;
    tip.direction = to;
    return ring;
  }

  // The scale that gives the tip this radius (half of its diagonal).
  double scale_to(const Tip& tip, double radius) const {
    const Quad& quad = complex_.quads[tip.quad];
    return radius / (0.5 * (complex_.corners[quad[2]] - complex_.corners[quad[0]]).norm());
  }

  Tip tip_at(std::size_t quad) const {
    const Quad& q = complex_.quads[quad];
    const auto& c = complex_.corners;
    return {quad, (c[q[2]] - c[q[0]]).cross(c[q[3]] - c[q[1]]).normalized()};
  }

 private:
  Vector3 centre_of(const Quad& q) const {
    const auto& c = complex_.corners;
    return 0.25 * (c[q[0]] + c[q[1]] + c[q[2]] + c[q[3]]);
  }

  QuadComplex complex_;
};

// One part of the body after the other. x is forward, y left, z up; the trunk's pieces are about 1 long. Two random
// numbers never stand in one call, since compilers differ in which argument comes first.
class Creature {
 public:
  explicit Creature(std::uint64_t seed)
      : random_(seed), mesh_({0.5, random_.uniform(0.4, 0.55), random_.uniform(0.4, 0.5)}) {
    const int leg_pairs = random_.whole(1, 3);
    // The pieces of the trunk from the back; each has its left and right side for a pair of protrusions.
    std::vector<Ring> pieces = {{ControlMesh::bottom, ControlMesh::left, ControlMesh::top, ControlMesh::right}};
    Tip chest = mesh_.tip_at(ControlMesh::front);
    const double rise = leg_pairs == 1 ? random_.uniform(0.5, 1.2) : random_.uniform(-0.15, 0.3);
    for (int i = 0; i < leg_pairs; ++i) {
      const Vector3 way(1, 0, rise * (i + 1) / leg_pairs);
      const double scale = random_.uniform(0.85, 1.1);
      pieces.push_back(mesh_.grow(chest, way, random_.uniform(0.9, 1.2), scale));
    }
    for (int i = 0; i < leg_pairs; ++i)
      legs(pieces[static_cast<std::size_t>(i)]);
    arms(pieces.back());
    tail();
    head(chest);
    if (random_.whole(0, 1) == 1) {
      for (const Ring& piece : pieces)
        spike(piece[2]);
    }
  }

  const QuadComplex& control() const { return mesh_.complex(); }

 private:
  double vary(double usual) { return usual * random_.uniform(0.8, 1.25); }

  void protrusion(Tip& tip, const Vector3& direction, double length, double radius) {
    mesh_.grow(tip, direction, length, mesh_.scale_to(tip, radius));
  }

  // Both sides alike, so that the creature can stand; y is mirrored.
  void legs(const Ring& piece) {
    const double hip = vary(0.3);
    const double radius = vary(0.26);
    const double upper = vary(0.8);
    const double lower = vary(0.8);
    const double spread = random_.uniform(0.15, 0.6);
    const double foot = vary(0.3);
    for (const double side : {1.0, -1.0}) {
      Tip tip = mesh_.tip_at(side > 0 ? piece[1] : piece[3]);
      protrusion(tip, {0, side, -0.35}, hip, 1.25 * radius);
      protrusion(tip, {0.05, side * spread, -1}, upper, radius);
      protrusion(tip, {-0.05, 0.4 * side * spread, -1}, lower, 0.75 * radius);
      protrusion(tip, {0.35, 0.3 * side, -1}, foot, 0.85 * radius);
    }
  }

  void arms(const Ring& piece) {
    const double radius = vary(0.22);
    const double upper = vary(0.7);
    const double lower = vary(0.7);
    const double lift = random_.uniform(-0.3, 0.9);
    const double finger = vary(0.45);
    const bool thumb = random_.whole(0, 1) == 1;
    for (const double side : {1.0, -1.0}) {
      Tip tip = mesh_.tip_at(side > 0 ? piece[1] : piece[3]);
      protrusion(tip, {0.1, side, 0.3 * lift}, vary(0.3), 1.25 * radius);
      protrusion(tip, {0.25, side, lift}, upper, radius);
      const Vector3 forward = Vector3(0.6, 0.9 * side, lift).normalized();
      protrusion(tip, forward, lower, 0.7 * radius);
      const Ring palm = mesh_.grow(tip, forward, 0.3, 1.35);
      protrusion(tip, forward, 0.12, 0.4 * radius);
      protrusion(tip, forward, finger, 0.22 * radius);
      for (const std::size_t k : {0U, 1U, 2U, 3U}) {
        if (k == 0 && !thumb) continue;
        Tip one = mesh_.tip_at(palm[k]);
        const Vector3 outward = one.direction;
        protrusion(one, outward + 0.5 * forward, 0.14, 0.4 * radius);
        protrusion(one, outward + 1.6 * forward, finger * random_.uniform(0.7, 1), 0.22 * radius);
      }
    }
  }

  void tail() {
    Tip tip = mesh_.tip_at(ControlMesh::back);
    const int pieces = random_.whole(3, 6);
    double radius = vary(0.36);
    Vector3 way(-1, 0, random_.uniform(-0.2, 0.3));
    for (int i = 0; i < pieces; ++i) {
      protrusion(tip, way, vary(0.5), radius);
      radius *= random_.uniform(0.72, 0.88);
      const double up = random_.uniform(-0.1, 0.35);
      way = (way + Vector3(0, random_.uniform(-0.25, 0.25), up)).normalized();
    }
  }

  void head(Tip tip) {
    const double radius = vary(0.3);
    const double stretch = vary(0.4);
    protrusion(tip, {1, 0, 0.5}, vary(0.35), 1.3 * radius);
    protrusion(tip, {0.5, 0, 1}, stretch, radius);
    protrusion(tip, {0.4, 0, 1}, stretch, radius);
    protrusion(tip, {1, 0, 0.5}, 0.3, 1.8 * radius);
    const Ring skull = mesh_.grow(tip, {1, 0, 0}, vary(0.5), 1);
    const double snout = random_.uniform(0.8, 1.3) * radius;
    protrusion(tip, {1, 0, -0.15}, vary(0.35), snout);
    const double ear = vary(0.45);
    for (const std::size_t k : {1U, 3U}) {
      Tip one = mesh_.tip_at(skull[k]);
      const Vector3 outward(-0.15, one.direction[1] > 0 ? 0.5 : -0.5, 1);
      protrusion(one, one.direction + 0.3 * outward, 0.12, 0.16);
      protrusion(one, outward, ear, 0.06);
    }
  }

  void spike(std::size_t quad) {
    Tip tip = mesh_.tip_at(quad);
    const Vector3 up = tip.direction;
    protrusion(tip, up, 0.15, 0.25);
    protrusion(tip, up - Vector3(0.3, 0, 0), vary(0.3), 0.06);
  }

  Random random_;
  ControlMesh mesh_;
};

}  // namespace

Mesh make_creature(const ShapeOptions& options, const base::Host& host) {
  const Creature creature(options.seed);
  // The number of refined points is such that the grids, which are at most a few times finer on long patches, see a
  // smooth surface.
  const double cells =
      std::sqrt(static_cast<double>(options.triangles) / 2 / static_cast<double>(creature.control().quads.size()));
  const int levels = std::clamp(static_cast<int>(std::ceil(std::log2(2 * std::max(cells, 1.0)))), 4, 7);
  SubdivisionSurface surface(creature.control(), levels, host);
  Mesh mesh = mesh_patches(creature.control(), surface, surface.side_lengths(host), options.triangles, host);
  // It stands on the plane of x and z, as glTF and most viewers have it.
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (v % 65536 == 0) host.report("making the shape", v, mesh.positions.size());
    const Vector3 p = mesh.positions[v];
    mesh.positions[v] = {p[0], p[2], -p[1]};
  }
  return mesh;
}

}  // namespace orbicube::mesh
