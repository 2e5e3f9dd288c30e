#include "hexmesh/certificate/hex_embedding.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/intersections.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::hexmesh {
namespace {

// A connected component of the boundary: its halves of quads from `begin` to `end`.
struct Part {
  std::size_t begin = 0, end = 0;
  mesh::Box box;
  double volume = 0;  // times six, signed
};

// Halves of quads sorted by the components that they belong to.
struct Parts {
  Array<Part> parts;
  Array<mesh::Triangle> halves;

  Parts(std::span<const Vector3> positions, std::span<const Quad> quads, const base::Host& host)
      : parts(host.memory), halves(host.memory) {
    mesh::DisjointSets sets(positions.size(), host.memory);
    for (const Quad& q : quads) {
      for (std::size_t k = 1; k < q.size(); ++k)
        sets.unite(q[0], q[k]);
    }
    Array<Index> number(positions.size(), no_index, host.memory);
    for (const Quad& q : quads) {
      Index& n = number[sets.find(q[0])];
      if (n == no_index) {
        n = static_cast<Index>(parts.size());
        parts.emplace_back();
      }
      parts[n].end += 2;
    }
    std::size_t begin = 0;
    for (Part& part : parts) {
      part.begin = begin;
      begin += part.end;
      part.end = part.begin;
    }
    halves.resize(begin);
    for (const Quad& q : quads) {
      Part& part = parts[number[sets.find(q[0])]];
      halves[part.end++] = {q[0], q[1], q[2]};
      halves[part.end++] = {q[0], q[2], q[3]};
    }
    for (Part& part : parts)
      measure(part, positions);
  }

  // About a vertex of its own, for the digits.
  void measure(Part& part, std::span<const Vector3> positions) const {
    const Vector3& at = positions[halves[part.begin][0]];
    for (std::size_t i = part.begin; i < part.end; ++i) {
      const mesh::Triangle& t = halves[i];
      for (const Index v : t)
        part.box.add(positions[v]);
      part.volume += (positions[t[0]] - at).dot((positions[t[1]] - at).cross(positions[t[2]] - at));
    }
  }

  // How often a component goes around a point that is not on it, by solid angles (van Oosterom and Strackee 1983).
  double winding(const Part& part, const Vector3& p, std::span<const Vector3> positions, const base::Host& host) const {
    double sum = 0;
    for (std::size_t i = part.begin; i < part.end; ++i) {
      if (i % 65536 == 0) host.report("check", 0, 0);
      const mesh::Triangle& t = halves[i];
      const Vector3 a = positions[t[0]] - p, b = positions[t[1]] - p, c = positions[t[2]] - p;
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      sum += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (2 * std::numbers::pi);
  }
};

}  // namespace

void measure_embedding(std::span<const Vector3> positions, std::span<const Quad> quads, HexQuality& quality,
                       const base::Host& host) {
  const auto pairs = mesh::intersecting_quads(positions, quads, host);
  quality.intersections = pairs.size();
  quality.misplaced_parts = 0;
  if (!pairs.empty()) {
    quality.first_intersection = positions[quads[pairs[0][0]][0]];
    return;
  }
  const Parts found(positions, quads, host);
  Array<mesh::Box> boxes(host.memory);
  for (const Part& part : found.parts)
    boxes.push_back(part.box);
  const mesh::BoundingVolumeTree tree(boxes, host);
  for (std::size_t i = 0; i < found.parts.size(); ++i) {
    const Part& part = found.parts[i];
    const Vector3& at = positions[found.halves[part.begin][0]];
    mesh::Box point;
    point.add(at);
    double around = 0;
    tree.for_each_near(point, [&](Index k) {
      if (k != i && boxes[k].overlaps(point)) around += found.winding(found.parts[k], at, positions, host);
    });
    // Outside of all solids, or, the wall of a cavity, within one.
    const double target = part.volume > 0 ? 0 : 1;
    if (std::abs(around - target) < 0.5) continue;
    if (quality.misplaced_parts++ == 0) quality.first_intersection = at;
  }
}

}  // namespace orbicube::hexmesh
