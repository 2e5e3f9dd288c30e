#include "hexmesh/quality/hex_boundary.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/threads/pieces.h"

namespace orbicube::hexmesh {

HexBoundary::HexBoundary(const HexMesh& mesh, const SurfaceTarget& target, const base::Host& host)
    : target_(target),
      lifts_(mesh.positions.size(), 0, host.memory),
      holds_(mesh.positions.size(), 1, host.memory),
      places_(mesh.positions.size(), Place(), host.memory),
      vertices_(host.memory),
      normals_(host.memory) {
  // Faces at vertices, sorted by vertex.
  Array<std::array<Index, 2>> around(host.memory);
  Array<Faces> sharp(host.memory);
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    for (const Index v : mesh.quads[i])
      around.push_back({v, mesh.quad_patches[i]});
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  for (std::size_t i = 0; i < around.size();) {
    std::size_t end = i;
    while (end < around.size() && around[end][0] == around[i][0])
      ++end;
    const Index v = around[i][0];
    vertices_.push_back(v);
    Place& place = places_[v];
    place.point = mesh.positions[v];
    place.kind = Kind::surface;
    if (target.has_sharp_edges() && end - i == 1) {
      place.kind = Kind::patch;
      place.faces[0] = around[i][1];
    }
    sharp.clear();
    for (std::size_t k = i; k < end; ++k) {
      for (std::size_t l = i; l < k; ++l) {
        if (target.sharp(around[k][1], around[l][1])) sharp.push_back({around[k][1], around[l][1]});
      }
    }
    if (!sharp.empty()) place_at_sharp_edges(place, sharp);
    i = end;
  }
}

// Where two sharp edges go on into each other, the corner of the polycube may be anywhere on them.
void HexBoundary::place_at_sharp_edges(Place& place, std::span<const Faces> sharp) const {
  place.kind = sharp.size() == 1 ? Kind::line : Kind::point;
  place.faces = sharp[0];
  if (sharp.size() == 1) return;
  const auto meeting = target_.meeting(sharp[0], sharp[1], place.point);
  if (!meeting) return;
  place.point = meeting->position;
  if (meeting->corner || sharp.size() > 2) return;
  place.kind = Kind::line;
  place.others = sharp[1];
}

void HexBoundary::lift(std::span<const Vector3> positions, std::span<const Quad> quads,
                       std::span<const Index> quad_patches, const base::Host& host) {
  constexpr double most = 0.15;   // raises beyond are not curvature
  constexpr double nearby = 0.6;  // what is farther away is another part of the surface
  constexpr double part = 0.5;
  constexpr double left = 0.67;  // of the gap over the raise: all would bend the layer beneath too much
  constexpr std::size_t piece = 64;
  // The four points of Gauss on each quad.
  constexpr double low = 0.2113248654051871, high = 1 - low;
  Array<double> gap(quads.size(), 0, host.memory);
  base::parallel_pieces(host, "lift", quads.size(), piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Quad& q = quads[i];
      const Vector3 normal = apart() ? Vector3(normals_[q[0]] + normals_[q[1]] + normals_[q[2]] + normals_[q[3]])
                                     : Vector3(Vector3::Zero());
      for (const auto& [u, v] : {std::array{low, low}, {high, low}, {low, high}, {high, high}}) {
        const Vector3 x = (1 - v) * ((1 - u) * positions[q[0]] + u * positions[q[1]]) +
                          v * ((1 - u) * positions[q[3]] + u * positions[q[2]]);
        const TargetPoint at = target_of_quad(quad_patches[i], x, normal);
        const Vector3 to = at.position - x;
        if (to.norm() < nearby) gap[i] += 0.25 * to.dot(at.normal);
      }
    }
  });
  host.report("lift", 0, 0);
  Array<double> sum(lifts_.size(), 0, host.memory);
  Array<Index> count(lifts_.size(), 0, host.memory);
  for (std::size_t i = 0; i < quads.size(); ++i) {
    for (const Index v : quads[i]) {
      sum[v] += gap[i];
      ++count[v];
    }
  }
  for (const Index v : vertices_) {
    const Kind k = places_[v].kind;
    if (count[v] == 0 || (k != Kind::surface && k != Kind::patch)) continue;
    lifts_[v] = std::clamp(lifts_[v] + part * (sum[v] / count[v] - left * lifts_[v]), -most, most);
  }
  // As smooth as the curvature that they stand for.
  std::fill(sum.begin(), sum.end(), 0.0);
  for (const Quad& q : quads) {
    const double mean = 0.25 * (lifts_[q[0]] + lifts_[q[1]] + lifts_[q[2]] + lifts_[q[3]]);
    for (const Index v : q)
      sum[v] += mean;
  }
  for (const Index v : vertices_) {
    const Kind k = places_[v].kind;
    if (count[v] > 0 && (k == Kind::surface || k == Kind::patch)) lifts_[v] = sum[v] / count[v];
  }
  if (apart()) limit_lifts(positions, host);
}

// A zero vector faces anything.
TargetPoint HexBoundary::target_of_quad(Index patch, const Vector3& p, const Vector3& facing) const {
  if (facing.squaredNorm() == 0) return target_.has_sharp_edges() ? target_.nearest_on(patch, p) : target_.nearest(p);
  const Vector3 n = facing.normalized();
  return target_.has_sharp_edges() ? target_.nearest_on(patch, p, n) : target_.nearest(p, n);
}

void HexBoundary::keep_apart(std::span<const Vector3> positions, std::span<const Quad> quads) {
  normals_.assign(positions.size(), Vector3::Zero());
  for (const Quad& q : quads) {
    const Vector3 n = (positions[q[2]] - positions[q[0]]).cross(positions[q[3]] - positions[q[1]]);
    for (const Index v : q)
      normals_[v] += n;
  }
  for (Vector3& n : normals_)
    n = n.norm() > 0 ? Vector3(n.normalized()) : Vector3(Vector3::Zero());
}

// Outward, what of the gap before each vertex leaves room for the other wall.
void HexBoundary::limit_lifts(std::span<const Vector3> positions, const base::Host& host) {
  constexpr double part = 0.3, wide = 1;  // of the gap; in cells
  base::parallel_pieces(host, "lift", vertices_.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index v = vertices_[i];
      if (lifts_[v] > 0) lifts_[v] = std::min(lifts_[v], part * target_.gap(nearest_target(v, positions[v]), wide));
    }
  });
  host.report("lift", 0, 0);
}

// Where a vertex belongs that may be anywhere on the surface or on one patch of the polycube.
TargetPoint HexBoundary::nearest_target(Index vertex, const Vector3& p) const {
  const Place& place = places_[vertex];
  const bool one_face = place.kind == Kind::patch;
  if (apart())
    return one_face ? target_.nearest_on(place.faces[0], p, normals_[vertex]) : target_.nearest(p, normals_[vertex]);
  return one_face ? target_.nearest_on(place.faces[0], p) : target_.nearest(p);
}

TargetPoint HexBoundary::project(Index vertex, const Vector3& p) const {
  const Place& place = places_[vertex];
  const auto lifted = [&](TargetPoint at) {
    at.position += lifts_[vertex] * at.normal;
    return at;
  };
  switch (place.kind) {
    case Kind::line: {
      const TargetPoint at = target_.nearest_on_line(place.faces[0], place.faces[1], p);
      if (place.others[0] == no_index) return at;
      const TargetPoint other = target_.nearest_on_line(place.others[0], place.others[1], p);
      return (other.position - p).squaredNorm() < (at.position - p).squaredNorm() ? other : at;
    }
    case Kind::point:
      return {place.point, Vector3::Zero()};
    default:
      return lifted(nearest_target(vertex, p));
  }
}

void HexBoundary::pull(Index vertex, const Vector3& p, double weight, Pull& to) const {
  const TargetPoint at = project(vertex, p);
  const Kind kind = places_[vertex].kind;
  if (kind == Kind::point) {
    to.to_point(at.position, weight);
  } else if (kind == Kind::line) {
    const Vector3 u = at.normal.unitOrthogonal();
    to.to_plane(u, at.position, weight);
    to.to_plane(at.normal.cross(u), at.position, weight);
  } else {
    to.to_plane(at.normal, at.position, weight);
  }
}

}  // namespace orbicube::hexmesh
