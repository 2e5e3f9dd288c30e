#include "polycube/unfolded/unfolded_map.h"

#include <cmath>
#include <numbers>

#include "base/error.h"

namespace orbicube::polycube {
namespace {

double signed_angle(const Vector2d& from, const Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

int quarters_of(double angle) {
  const int result = static_cast<int>(std::lround(angle / (0.5 * std::numbers::pi))) % 4;
  return result < 0 ? result + 4 : result;
}

// From one patch of the polycube to a neighbor, unfolded about the edge between them, on which `point` lies.
PlaneMotion hinge(const UnfoldedPatch& from, const UnfoldedPatch& to, const Vector3& point) {
  const Vector3 along = Vector3::Unit(third_axis(axis_of(from.label), axis_of(to.label)));
  PlaneMotion motion;
  motion.quarters = quarters_of(signed_angle(from.flat(along), to.flat(along)));
  motion.shift = to.flat(point) - turned_by(from.flat(point), motion.quarters);
  return motion;
}

}  // namespace

UnfoldedMap::UnfoldedMap(const SurfaceMap& map, const base::Host& host)
    : surface(map.positions, map.triangles, host),
      motion(3 * map.triangles.size(), host.memory),
      image(map.positions.size(), Vector2d::Zero(), host.memory),
      corner_at(map.positions.size(), no_index, host.memory),
      held(map.positions.size(), 0, host.memory),
      tie_at(map.positions.size(), no_index, host.memory),
      ties(host.memory),
      facets(host.memory),
      corners(host.memory),
      darts(host.memory) {
  surface.source.assign(map.vertex_sources.begin(), map.vertex_sources.end());
  surface.triangle_source.assign(map.triangle_sources.begin(), map.triangle_sources.end());
  for (Index f = 0; f < map.triangles.size(); ++f) {
    const Index patch = map.patches[f];
    if (patch >= facets.size()) facets.resize(patch + 1);
    facets[patch] = {map.labels[f], map.polycube[map.triangles[f][0]][axis_of(map.labels[f])]};
  }
  find_corners(map);
  for (Index v = 0; v < image.size(); ++v) {
    if (surface.outgoing(v) == no_index) continue;
    const Index home = map.patches[surface.outgoing(v) / 3];
    image[v] = facets[home].flat(map.polycube[v]);
    surface.for_each_outgoing(v, [&](Index h) {
      const Index patch = map.patches[h / 3];
      if (patch == home) return;
      // Of a corner only the place matters.
      if (is_corner(v))
        motion[h] = {0, facets[patch].flat(map.polycube[v]) - image[v]};
      else
        motion[h] = hinge(facets[home], facets[patch], map.polycube[v]);
    });
  }
}

void UnfoldedMap::find_corners(const SurfaceMap& map) {
  const auto on_edge = [&](Index h) { return map.patches[h / 3] != map.patches[surface.opposite(h) / 3]; };
  for (Index v = 0; v < image.size(); ++v) {
    int edges = 0;
    surface.for_each_outgoing(v, [&](Index h) { edges += on_edge(h); });
    if (edges < 3) continue;
    corner_at[v] = static_cast<Index>(corners.size());
    corners.push_back({v, map.polycube[v], 0, 0, 0, no_index, 0, Vector2d::Zero(), false});
  }
  for (UnfoldedCorner& corner : corners)
    add_darts(map, corner);
}

void UnfoldedMap::add_darts(const SurfaceMap& map, UnfoldedCorner& corner) {
  const auto on_edge = [&](Index h) { return map.patches[h / 3] != map.patches[surface.opposite(h) / 3]; };
  corner.dart_begin = static_cast<Index>(darts.size());
  surface.for_each_outgoing(corner.vertex, [&](Index h) {
    if (!on_edge(h)) return;
    UnfoldedDart dart{corner_at[corner.vertex], no_index, 0, map.patches[h / 3], Vector3::Zero()};
    const Vector3 along = map.polycube[surface.end(h)] - corner.place;
    along.cwiseAbs().maxCoeff(&dart.quarters);
    dart.direction[dart.quarters] = along[dart.quarters] > 0 ? 1 : -1;
    Index end = h;
    while (!is_corner(surface.end(end))) {
      Index onward = surface.turned(surface.opposite(end));
      while (!on_edge(onward))
        onward = surface.turned(onward);
      end = onward;
    }
    dart.target = corner_at[surface.end(end)];
    if (darts.size() == corner.dart_begin) {
      corner.end = surface.end(h);
      const UnfoldedPatch& facet = facets[dart.facet];
      corner.direction = facet.flat(map.polycube[corner.end]) - facet.flat(corner.place);
    }
    darts.push_back(dart);
  });
  corner.dart_end = static_cast<Index>(darts.size());
  for (Index i = corner.dart_begin; i < corner.dart_end; ++i) {
    darts[i].quarters = corner.quarters;
    const UnfoldedPatch& facet = facets[darts[i].facet];
    const Vector3& next = darts[i + 1 < corner.dart_end ? i + 1 : corner.dart_begin].direction;
    corner.quarters += quarters_of(signed_angle(facet.flat(darts[i].direction), facet.flat(next)));
  }
}

PlaneMotion UnfoldedMap::across(Index h) const {
  const Index other = surface.opposite(h);
  // Each edge is seen from both sides; at corners, motions from the vertex say nothing of the turn.
  const Vector2d here = at(h), next = at(EditableSurface::next(h));
  const Vector2d there = at(EditableSurface::next(other)), next_there = at(other);
  PlaneMotion result;
  result.quarters = quarters_of(signed_angle(next - here, next_there - there));
  result.shift = there - turned_by(here, result.quarters);
  return result;
}

double UnfoldedMap::angle_at(Index h) const {
  const Vector2d p = at(h);
  return signed_angle(at(EditableSurface::next(h)) - p, at(EditableSurface::previous(h)) - p);
}

void UnfoldedMap::follow(UnfoldedCorner& corner) const {
  const Index h = surface.between(corner.vertex, corner.end);
  const Vector2d now = at(EditableSurface::next(h)) - at(h);
  corner.angle += signed_angle(corner.direction, now);
  corner.direction = now;
}

void UnfoldedMap::follow_corners() {
  for (UnfoldedCorner& corner : corners)
    follow(corner);
}

// Angles are counted from an edge that does not go to the vertex and is in neither face.
void UnfoldedMap::leave(Index number, Index vertex, Index first_face, Index second_face) {
  UnfoldedCorner& corner = corners[number];
  follow(corner);
  const Index first = surface.between(corner.vertex, corner.end);
  Index h = first;
  while (surface.end(h) == vertex || h / 3 == first_face || h / 3 == second_face) {
    corner.angle += angle_at(h);
    h = surface.turned(h);
    if (h == first) throw base::Error("internal", "a corner of the polycube without triangles");
  }
  corner.end = surface.end(h);
  corner.direction = at(EditableSurface::next(h)) - at(h);
}

void UnfoldedMap::collapse(Index h) {
  const Index v = surface.start(h), g = surface.opposite(h);
  const PlaneMotion from_w = motion[h].inverse().after(motion[EditableSurface::next(h)]);
  surface.for_each_outgoing(v, [&](Index x) {
    const Index end = surface.end(x);
    if (is_corner(end)) leave(corner_at[end], v, h / 3, g / 3);
  });
  surface.for_each_outgoing(v, [&](Index x) {
    if (x / 3 != h / 3 && x / 3 != g / 3) motion[x] = motion[x].after(from_w);
  });
  surface.collapse(h);
}

Index UnfoldedMap::split_edge(Index h, double part) {
  const Index g = surface.opposite(h), a = surface.start(h), b = surface.end(h);
  const PlaneMotion over = across(h);
  const Vector2d place = (1 - part) * at(h) + part * at(EditableSurface::next(h));
  const auto old = [&](Index x) { return motion[x]; };
  const PlaneMotion fa = old(h), fb = old(EditableSurface::next(h)), fc = old(EditableSurface::previous(h));
  const PlaneMotion gb = old(g), ga = old(EditableSurface::next(g)), gd = old(EditableSurface::previous(g));
  const auto f2 = static_cast<Index>(surface.faces()), g2 = f2 + 1;
  const Index m = surface.split_edge(h, part);
  image.push_back(place);
  corner_at.push_back(no_index);
  held.push_back(0);
  tie_at.push_back(no_index);
  motion.resize(3 * surface.faces());
  const auto set = [&](Index face, const PlaneMotion& x, const PlaneMotion& y, const PlaneMotion& z) {
    motion[3 * face] = x;
    motion[3 * face + 1] = y;
    motion[3 * face + 2] = z;
  };
  set(h / 3, fa, {}, fc);
  set(f2, {}, fb, fc);
  set(g / 3, gb, over, gd);
  set(g2, over, ga, gd);
  for (const auto& [corner, end] : {std::pair(a, b), std::pair(b, a)})
    if (is_corner(corner) && corners[corner_at[corner]].end == end) corners[corner_at[corner]].end = m;
  return m;
}

}  // namespace orbicube::polycube
