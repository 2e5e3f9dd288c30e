#include "polycube/unfolded/polycube_edges.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/search/planar.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

using mesh::cross;

constexpr const char* polycube_edges_phase = "edges of the polycube";
// A vertex as near to a line as that goes onto it, in parts of the triangle.
constexpr double near_line = 1e-7;

// A line as seen in a triangle's plane.
struct Line {
  // Positive on the left.
  double side(const Vector2d& p) const { return cross(direction, p - point); }

  Vector2d point, direction;  // the direction is one of the four along the axes
};

class Folding {
 public:
  Folding(UnfoldedMap& map, const base::Host& host)
      : map_(map),
        surface_(map.surface),
        host_(host),
        facet_(host.memory),
        to_facet_(host.memory),
        on_dart_(host.memory) {
    std::fill(surface_.arc.begin(), surface_.arc.end(), no_index);
    std::fill(surface_.occupied.begin(), surface_.occupied.end(), std::uint8_t{0});
    for (const UnfoldedCorner& corner : map.corners)
      surface_.occupied[corner.vertex] = 1;
  }

  SurfaceMap run() {
    map_.follow_corners();
    for (Index dart = 0; dart < map_.darts.size(); ++dart) {
      host_.report(polycube_edges_phase, dart, map_.darts.size());
      if (map_.darts[dart].corner < map_.darts[dart].target) draw(dart);
    }
    paint();
    return result();
  }

 private:
  [[noreturn]] static void astray(const std::string& how) {
    throw base::Error("no-valid-result", "an edge of the polycube is lost on the smoothed map: " + how);
  }

  // A half-edge at the corner, and the dart's line in the plane of its triangle, which the dart enters or which comes
  // next before one that it does.
  std::pair<Index, Line> start(const UnfoldedDart& dart) const {
    constexpr double quarter = 0.5 * std::numbers::pi, little = 1e-9, doubtful = 1e-4;
    const UnfoldedCorner& corner = map_.corners[dart.corner];
    const Index first = surface_.between(corner.vertex, corner.end);
    const double whole = corner.quarters * quarter;
    double angle = corner.angle, wanted = dart.quarters * quarter;
    while (wanted < angle)
      wanted += whole;
    while (wanted >= angle + whole)
      wanted -= whole;
    Index h = first;
    do {
      const Vector2d p = map_.at(h);
      const Vector2d a = map_.at(EditableSurface::next(h)) - p, b = map_.at(EditableSurface::previous(h)) - p;
      const double turn = std::atan2(cross(a, b), a.dot(b));
      if (wanted < angle + turn + little) {
        const double way = std::atan2(a.y(), a.x()) + wanted - angle;
        const double exact = std::round(way / quarter) * quarter;
        if (std::abs(way - exact) > doubtful) astray("its direction at a corner is doubtful");
        const Line line{p, {std::round(std::cos(exact)), std::round(std::sin(exact))}};
        return {EditableSurface::next(surface_.opposite(h)), through(line, map_.across(h))};
      }
      angle += turn;
      h = surface_.turned(h);
    } while (h != first);
    astray("a corner has no triangle for it");
  }

  // Moves a vertex onto the line if its triangles stay positive.
  bool snap(Index h, const Line& line) {
    const Index v = surface_.start(h);
    if (surface_.occupied[v]) return false;
    const Vector2d before = map_.image[v];
    Vector2d there = map_.at(h);
    there -= line.side(there) * left_of(line);
    map_.image[v] = map_.motion[h].inverse()(there);
    bool positive = true;
    surface_.for_each_outgoing(v, [&](Index x) {
      positive = positive && mesh::orientation_2d(map_.at(x), map_.at(EditableSurface::next(x)),
                                                  map_.at(EditableSurface::previous(x))) > 0;
    });
    if (!positive) map_.image[v] = before;
    return positive;
  }

  // From vertex to vertex along the line of a dart, cutting the edges that it crosses.
  void draw(Index number) {
    const UnfoldedDart dart = map_.darts[number];
    const Index goal = map_.corners[dart.target].vertex;
    auto [h, line] = start(dart);
    Index here = surface_.start(h);
    for (std::size_t turns = 0, most = 8 * surface_.faces() + 1000; turns < most; ++turns) {
      // Triangles (here, a, b) counter-clockwise until b is not on the right.
      const Index next = EditableSurface::next(h), previous = EditableSurface::previous(h);
      const Vector2d p = map_.at(h), a = map_.at(next), b = map_.at(previous);
      const double near = near_line * std::sqrt(std::max({(a - p).squaredNorm(), (b - p).squaredNorm()}));
      const double at_a = line.side(a), at_b = line.side(b);
      const bool reached = std::abs(at_b) <= near && (b - p).dot(line.direction) > 0 &&
                           (surface_.start(previous) == goal || snap(previous, line));
      Index back = no_index;  // half-edge to here from the next vertex on the line
      if (reached) {
        back = previous;
      } else if (at_b > 0) {
        if (!(at_a < 0)) astray("it leaves a triangle where it came from");
        if (surface_.arc[next] != no_index) astray("it meets another");
        const Index m = map_.split_edge(next, at_a / (at_a - at_b));
        // Exactly on the line, in the plane of this triangle, which is that of the new vertex.
        map_.image[m] -= line.side(map_.image[m]) * left_of(line);
        back = surface_.opposite(surface_.between(here, m));
      } else {
        line = through(line, map_.across(previous));
        h = surface_.turned(h);
        continue;
      }
      if (surface_.arc[back] != no_index) astray("it runs along another");
      surface_.draw(back, number);
      here = surface_.start(back);
      if (here == goal) return;
      surface_.occupied[here] = 1;
      on_dart_.emplace_back(here, number);
      h = back;
    }
    astray("it does not end");
  }

  static Vector2d left_of(const Line& line) { return {-line.direction.y(), line.direction.x()}; }
  static Line through(const Line& line, const PlaneMotion& motion) {
    return {motion(line.point), turned_by(line.direction, motion.quarters)};
  }

  // The patch of the polycube of each triangle, from the corners on.
  void paint() {
    facet_.assign(surface_.faces(), no_index);
    to_facet_.resize(surface_.faces());
    Array<Index> open(host_.memory);
    for (const UnfoldedCorner& corner : map_.corners) {
      surface_.for_each_outgoing(corner.vertex, [&](Index h) {
        if (surface_.arc[h] == no_index) return;
        const UnfoldedDart& drawn = map_.darts[surface_.arc[h]];
        const bool forward = map_.corners[drawn.corner].vertex == corner.vertex;
        const Vector3 direction = forward ? drawn.direction : Vector3(-drawn.direction);
        Index dart = corner.dart_begin;
        while (dart < corner.dart_end && map_.darts[dart].direction != direction)
          ++dart;
        if (dart == corner.dart_end) astray("it reaches the wrong corner");
        const UnfoldedPatch& facet = map_.facets[map_.darts[dart].facet];
        const Vector2d p = map_.at(h), along = map_.at(EditableSurface::next(h)) - p, wanted = facet.flat(direction);
        PlaneMotion motion;
        motion.quarters = static_cast<int>(std::lround(std::atan2(cross(along, wanted), along.dot(wanted)) /
                                                       (0.5 * std::numbers::pi))) &
                          3;
        motion.shift = facet.flat(corner.place) - turned_by(p, motion.quarters);
        if (facet_[h / 3] != no_index && facet_[h / 3] != map_.darts[dart].facet) astray("faces meet");
        facet_[h / 3] = map_.darts[dart].facet;
        to_facet_[h / 3] = motion;
        open.push_back(h / 3);
      });
    }
    while (!open.empty()) {
      const Index f = open.back();
      open.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index other = surface_.opposite(h) / 3;
        if (surface_.arc[h] != no_index) continue;
        if (facet_[other] == no_index) {
          facet_[other] = facet_[f];
          to_facet_[other] = to_facet_[f].after(map_.across(surface_.opposite(h)));
          open.push_back(other);
        } else if (facet_[other] != facet_[f]) {
          astray("faces meet");
        }
      }
    }
  }

  SurfaceMap result() {
    Array<Vector3> place(surface_.vertices(), Vector3::Zero(), host_.memory);
    for (Index h = 0; h < 3 * surface_.faces(); ++h) {
      if (!surface_.alive(h / 3)) continue;
      if (facet_[h / 3] == no_index) astray("a part belongs to no face");
      place[surface_.start(h)] = map_.facets[facet_[h / 3]].in_space(to_facet_[h / 3](map_.at(h)));
    }
    for (const auto& [vertex, number] : on_dart_) {
      const UnfoldedDart& dart = map_.darts[number];
      for (int axis = 0; axis < 3; ++axis)
        if (dart.direction[axis] == 0) place[vertex][axis] = map_.corners[dart.corner].place[axis];
    }
    for (const UnfoldedCorner& corner : map_.corners)
      place[corner.vertex] = corner.place;

    return map_of(
        surface_, place, facet_, [&](Index f) { return map_.facets[facet_[f]].label; }, host_.memory);
  }

  UnfoldedMap& map_;
  EditableSurface& surface_;
  const base::Host& host_;
  Array<Index> facet_;                      // of each triangle
  Array<PlaneMotion> to_facet_;             // of each triangle: from its plane to that of its patch of the polycube
  Array<std::pair<Index, Index>> on_dart_;  // vertices inside edges of the polycube, and the dart
};

}  // namespace

SurfaceMap fold(UnfoldedMap& map, const base::Host& host) {
  return Folding(map, host).run();
}

}  // namespace orbicube::polycube
