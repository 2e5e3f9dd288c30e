#include "polycube/dissertation/printed_map.h"

#include <cmath>

#include "base/counted.h"
#include "base/error.h"
#include "base/infinity.h"

namespace orbicube::polycube::dissertation {

PrintedMapper::PrintedMapper(const EditableSurface& surface, const base::Host& host)
    : surface_(surface),
      host_(host),
      weights_(half_edge_weights(surface, host)),
      system_(surface, weights_, host),
      shortest_(surface, host) {}

Drawn PrintedMapper::draw(const Layout& layout, std::span<const Index> corner_points) {
  return draw_paths(layout, corner_points, surface_, shortest_, host_);
}

PatchMap PrintedMapper::map(const Layout& layout, const Drawn& drawn) {
  return map_patches(layout, surface_, drawn, weights_, system_, host_);
}

FinishedMap PrintedMapper::finish(const Layout& layout, const Drawn& drawn, Certificate& certificate) const {
  FinishedMap finished = finish_map(layout, surface_, drawn, host_);
  if (finished.flipped > 0)
    throw base::Error("no-valid-result",
                      "the harmonic maps fold over: " + base::counted(finished.flipped, "flipped triangle") +
                          ", the first in " + finished.first);
  certificate = certify(finished.map, host_);
  if (!certificate.valid()) throw base::Error("no-valid-result", certificate.reason);
  return finished;
}

namespace {

Index nearest_vertex(const EditableSurface& surface, const Vector3& point) {
  double least = base::infinity;
  Index nearest = no_index;
  for (Index v = 0; v < surface.vertices(); ++v) {
    const double distance = (surface.position[v] - point).squaredNorm();
    if (!(distance < least) || surface.outgoing(v) == no_index) continue;
    least = distance;
    nearest = v;
  }
  return nearest;
}

// Where a line hits a triangle, as the parameter on the line; infinite where it does not.
double hit(const Vector3& origin, const Vector3& direction, const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 u = b - a, v = c - a, p = direction.cross(v);
  const double volume = u.dot(p);
  if (volume == 0) return base::infinity;
  const Vector3 from = origin - a, q = from.cross(u);
  const double s = from.dot(p) / volume, t = direction.dot(q) / volume;
  return s >= 0 && t >= 0 && s + t <= 1 ? v.dot(q) / volume : base::infinity;
}

Index vertex_along(const EditableSurface& surface, const Vector3& origin, const Vector3& direction) {
  double least = base::infinity;
  Index face = no_index;
  for (Index f = 0; f < surface.faces(); ++f) {
    const Triangle& t = surface.triangle[f];
    const double at =
        std::abs(hit(origin, direction, surface.position[t[0]], surface.position[t[1]], surface.position[t[2]]));
    if (!(at < least)) continue;
    least = at;
    face = f;
  }
  if (face == no_index) return nearest_vertex(surface, origin);
  const Triangle& t = surface.triangle[face];
  // The sign of the parameter is lost, but both points are tried.
  Index best = t[0];
  double distance = base::infinity;
  for (const Index v : t) {
    for (const double at : {least, -least}) {
      const double there = (surface.position[v] - (origin + at * direction)).squaredNorm();
      if (!(there < distance)) continue;
      distance = there;
      best = v;
    }
  }
  return best;
}

}  // namespace

Array<Index> project_corners(const Layout& layout, const EditableSurface& surface, Projection projection,
                             const base::Host& host) {
  Array<Index> result(host.memory);
  for (Index n = 0; n < layout.nodes.size(); ++n) {
    host.report("corner points", n, layout.nodes.size());
    const Vector3 corner = layout.node_position(n);
    result.push_back(projection == Projection::nearest ? nearest_vertex(surface, corner)
                                                       : vertex_along(surface, corner, layout.nodes[n].normal));
  }
  return result;
}

}  // namespace orbicube::polycube::dissertation
