#include "polycube/corners/corner_region.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "base/infinity.h"

namespace orbicube::polycube {
namespace {

constexpr const char* corner_region_phase = "corners";

// Coordinates in the plane of a face, seen from outside.
Vector2d in_face(AxisLabel label, const Vector3& p) {
  const int axis = axis_of(label);
  return {p[(axis + 1) % 3], sign_of(label) * p[(axis + 2) % 3]};
}

double angle_of(const Vector2d& p) {
  const double a = std::atan2(p.y(), p.x());
  return a < 0 ? a + 4 * quarter_turn : a;
}

bool on_first_axis(const Vector2d& p) {
  return p.y() == 0 && p.x() > 0;
}

// Where a vertex is in the plane of a sector, from the sector's first edge on.
Vector2d in_sector(const CornerRegion& region, const CornerSector& sector, const Vector3& image) {
  const Vector2d z = in_face(sector.label, image) - in_face(sector.label, region.apex);
  return turned_by(z, sector.turn - sector.begin);
}

}  // namespace

RegionFinder::RegionFinder(const WorkingMap& map, const base::Host& host)
    : map_(map),
      host_(host),
      nearest_(host.memory),
      place_(host.memory),
      distance_(host.memory),
      touched_(host.memory),
      candidates_(host.memory),
      heap_(host.memory) {}

Array<Index> RegionFinder::corners() const {
  Array<Index> result(host_.memory);
  for (Index v = 0; v < map_.image.size(); ++v)
    if (map_.edges_at(v) >= 3) result.push_back(v);
  return result;
}

Array<Index> RegionFinder::edge_middles() const {
  Array<Index> result(host_.memory);
  const Array<Index> all = corners();
  for (const Index corner : all) {
    map_.surface.for_each_outgoing(corner, [&](Index first) {
      if (!map_.on_edge(first)) return;
      const auto for_each_inside = [&](const auto& visit) {
        Index h = first;
        for (Index v = map_.surface.end(h); !std::binary_search(all.begin(), all.end(), v); v = map_.surface.end(h)) {
          visit(v);
          h = map_.surface.opposite(h);
          do {
            h = map_.surface.turned(h);
          } while (!map_.on_edge(h));
        }
        return map_.surface.end(h);
      };
      const Index last = for_each_inside([](Index) {});
      if (last < corner) return;  // from its other end
      const Vector3 middle = 0.5 * (map_.image[corner] + map_.image[last]);
      double least = std::numeric_limits<double>::infinity();
      Index nearest = no_index;
      for_each_inside([&](Index v) {
        const double off = (map_.image[v] - middle).norm();
        if (off < least) {
          least = off;
          nearest = v;
        }
      });
      if (nearest != no_index) result.push_back(nearest);
    });
  }
  return result;
}

bool RegionFinder::Farther::operator()(const Waiting& a, const Waiting& b) const {
  return a.distance != b.distance ? a.distance > b.distance
                                  : std::pair(a.corner, a.vertex) > std::pair(b.corner, b.vertex);
}

bool RegionFinder::find(Index centre, std::size_t max_vertices, CornerRegion& region) {
  nearest_.clear();
  place_.resize(map_.image.size(), no_index);
  distance_.resize(map_.image.size(), base::infinity);
  candidates_.clear();
  touched_.assign(1, centre);
  heap_.clear();
  if (!find_sectors(centre, region)) return false;
  distance_[centre] = 0;
  heap_.push({0, centre, 0});
  while (!heap_.empty() && candidates_.size() < max_vertices) {
    const Waiting w = heap_.pop();
    if (w.distance > distance_[w.vertex] || !may_move(w.vertex, region)) continue;
    candidates_.push_back(w.vertex);
    map_.surface.for_each_outgoing(w.vertex, [&](Index h) {
      const Index v = map_.surface.end(h);
      const double there = w.distance + (map_.image[v] - map_.image[w.vertex]).norm();
      if (!(there < distance_[v])) return;
      if (distance_[v] == base::infinity) touched_.push_back(v);
      distance_[v] = there;
      heap_.push({there, v, 0});
    });
  }
  for (const Index v : touched_)
    distance_[v] = base::infinity;
  std::size_t count = candidates_.size();
  while (count > 0 && !gather(std::span<const Index>(candidates_).first(count), region))
    count = count * 2 / 3;
  return count > 0;
}

Array<CornerRegion> RegionFinder::find_disjoint(std::size_t max_vertices) {
  const Array<Index> centres = corners();
  Array<Array<Index>> own(centres.size(), Array<Index>(host_.memory), host_.memory);
  Array<double> distance(map_.image.size(), std::numeric_limits<double>::infinity(), host_.memory);
  nearest_.assign(map_.image.size(), no_index);
  place_.assign(map_.image.size(), no_index);
  heap_.clear();
  for (Index c = 0; c < centres.size(); ++c) {
    distance[centres[c]] = 0;
    heap_.push({0, centres[c], c});
  }
  while (!heap_.empty()) {
    const Waiting w = heap_.pop();
    if (nearest_[w.vertex] != no_index) continue;
    nearest_[w.vertex] = centres[w.corner];
    own[w.corner].push_back(w.vertex);
    if (own[w.corner].size() % 1024 == 0) host_.report(corner_region_phase, 0, 0);
    map_.surface.for_each_outgoing(w.vertex, [&](Index h) {
      const Index v = map_.surface.end(h);
      const double there = w.distance + (map_.image[v] - map_.image[w.vertex]).norm();
      if (!(there < distance[v])) return;
      distance[v] = there;
      heap_.push({there, v, w.corner});
    });
  }
  Array<CornerRegion> result(host_.memory);
  for (Index c = 0; c < centres.size(); ++c) {
    host_.report(corner_region_phase, c, centres.size());
    CornerRegion region(host_.memory);
    if (!find_sectors(centres[c], region)) continue;
    candidates_.clear();
    for (const Index v : own[c])
      if (candidates_.size() < max_vertices && may_move(v, region)) candidates_.push_back(v);
    if (candidates_.empty() || candidates_.front() != centres[c]) continue;
    std::size_t count = candidates_.size();
    while (count > 0 && !gather(std::span<const Index>(candidates_).first(count), region))
      count = count * 2 / 3;
    if (count > 0) result.push_back(std::move(region));
  }
  nearest_.clear();
  return result;
}

// The faces around a corner, from one of its edges on.
bool RegionFinder::find_sectors(Index centre, CornerRegion& region) const {
  region.sectors.clear();
  region.apex = map_.image[centre];
  Index start = no_index;
  map_.surface.for_each_outgoing(centre, [&](Index h) {
    if (start == no_index && map_.on_edge(h)) start = h;
  });
  if (start == no_index) return false;
  int begin = 0;
  Index h = start;
  do {
    CornerSector sector{map_.label[h / 3], map_.facet[h / 3], begin, 0, 0};
    const auto direction = [&](Index x) {
      const Vector2d d = in_face(sector.label, map_.image[map_.surface.end(x)]) - in_face(sector.label, region.apex);
      return static_cast<int>(std::lround(angle_of(d) / quarter_turn)) & 3;
    };
    const int first = direction(h);
    do {
      h = map_.surface.turned(h);
    } while (!map_.on_edge(h));
    sector.quarters = (direction(h) - first) & 3;
    sector.turn = begin - first;
    if (sector.quarters == 0) return false;
    for (const CornerSector& other : region.sectors)
      if (other.facet == sector.facet) return false;
    begin += sector.quarters;
    region.sectors.push_back(sector);
  } while (h != start);
  region.quarters = begin;
  return true;
}

// Whether a vertex lies on the cone and nothing but the center's own edges is at it.
bool RegionFinder::may_move(Index v, const CornerRegion& region) const {
  const bool centre = map_.image[v] == region.apex;
  if (!centre && map_.edges_at(v) > 2) return false;
  bool inside = true;
  map_.surface.for_each_outgoing(v, [&](Index h) {
    inside = inside && (nearest_.empty() || nearest_[map_.surface.end(h)] == nearest_[v]);
    const auto sector = std::find_if(region.sectors.begin(), region.sectors.end(),
                                     [&](const CornerSector& s) { return s.facet == map_.facet[h / 3]; });
    if (sector == region.sectors.end()) {
      inside = false;
      return;
    }
    if (centre) return;
    const Vector2d p = in_sector(region, *sector, map_.image[v]);
    inside = inside && angle_of(p) <= sector->quarters * quarter_turn;
    // An edge of the polycube along a ray.
    if (map_.on_edge(h)) inside = inside && (on_first_axis(p) || on_first_axis(turned_by(p, -sector->quarters)));
  });
  return inside;
}

// The stars of the connected part of the candidates, unfolded; false when they are no disk.
bool RegionFinder::gather(std::span<const Index> candidates, CornerRegion& region) {
  region.vertices.clear();
  region.faces.clear();
  region.triangles.clear();
  const bool done = gather_stars(candidates, region) && unfold(region);
  for (const Index v : candidates)
    place_[v] = no_index;
  for (const Index v : region.vertices)
    place_[v] = no_index;
  return done;
}

bool RegionFinder::gather_stars(std::span<const Index> candidates, CornerRegion& region) {
  constexpr Index candidate = no_index - 1;
  for (const Index v : candidates)
    place_[v] = candidate;
  const auto add = [&](Index v) {
    place_[v] = static_cast<Index>(region.vertices.size());
    region.vertices.push_back(v);
  };
  add(candidates[0]);
  for (std::size_t i = 0; i < region.vertices.size(); ++i) {
    map_.surface.for_each_outgoing(region.vertices[i], [&](Index h) {
      const Index w = map_.surface.end(h);
      if (place_[w] == candidate) add(w);
    });
  }
  region.inside = region.vertices.size();
  for (std::size_t i = 0; i < region.inside; ++i) {
    map_.surface.for_each_outgoing(region.vertices[i], [&](Index h) {
      const Triangle& t = map_.surface.triangle[h / 3];
      // From the first of its vertices that may move.
      for (const Index v : t)
        if (place_[v] < i) return;
      for (const Index v : t)
        if (place_[v] == no_index || place_[v] == candidate) add(v);
      region.faces.push_back(h / 3);
      region.triangles.push_back({place_[t[0]], place_[t[1]], place_[t[2]]});
    });
  }
  // A disk: the boundary passes each of its vertices once, and the Euler number is 1.
  std::size_t bounding = 0;
  Array<std::uint8_t> passed(region.vertices.size(), 0, host_.memory);
  for (const Index f : region.faces) {
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + k;
      if (place_[map_.surface.start(h)] < region.inside || place_[map_.surface.end(h)] < region.inside) continue;
      if (const Index across = map_.surface.end(EditableSurface::next(map_.surface.opposite(h)));
          place_[across] < region.inside)
        continue;
      ++bounding;
      if (++passed[place_[map_.surface.start(h)]] > 1) return false;
    }
  }
  const std::size_t edges = (3 * region.faces.size() + bounding) / 2;
  return bounding == region.vertices.size() - region.inside &&
         region.vertices.size() + region.faces.size() == edges + 1;
}

bool RegionFinder::unfold(CornerRegion& region) const {
  const std::size_t count = region.vertices.size();
  region.space.clear();
  for (const Index v : region.vertices)
    region.space.push_back(map_.scale * map_.surface.position[v]);
  constexpr double unknown = -1;
  region.cone.assign(count, Vector2d::Zero());
  region.angle.assign(count, unknown);
  region.angle[0] = 0;
  // Vertices on a ray belong to what comes after it, where that is a part of the region.
  for (const bool at_end : {false, true}) {
    for (std::size_t i = 0; i < region.faces.size(); ++i) {
      const auto sector = std::find_if(region.sectors.begin(), region.sectors.end(),
                                       [&](const CornerSector& s) { return s.facet == map_.facet[region.faces[i]]; });
      for (const Index v : region.triangles[i]) {
        if (region.angle[v] != unknown) continue;
        const Vector2d p = in_sector(region, *sector, map_.image[region.vertices[v]]);
        const bool ends = on_first_axis(turned_by(p, -sector->quarters));
        if (ends != at_end) continue;
        const double angle = ends ? sector->quarters * quarter_turn : angle_of(p);
        if (angle > sector->quarters * quarter_turn) return false;
        const bool wraps = ends && sector->begin + sector->quarters == region.quarters;
        region.angle[v] = wraps ? 0 : sector->begin * quarter_turn + angle;
        region.cone[v] = turned_by(p, sector->begin - (wraps ? region.quarters : 0));
      }
    }
  }
  region.radius = std::numeric_limits<double>::infinity();
  for (std::size_t v = region.inside; v < count; ++v)
    region.radius = std::min(region.radius, region.cone[v].norm());
  if (!(region.radius > 0)) return false;
  region.flat.resize(count);
  for (std::size_t v = 0; v < count; ++v)
    region.flat[v] = region.flatten(region.cone[v].norm(), region.angle[v]);
  return true;
}

WorkingMap::WorkingMap(const SurfaceMap& map, const base::Host& host)
    : surface(map.positions, map.triangles, host),
      label(map.labels.begin(), map.labels.end(), host.memory),
      facet(map.patches.begin(), map.patches.end(), host.memory),
      image(map.polycube.begin(), map.polycube.end(), host.memory) {
  surface.source = map.vertex_sources;
  surface.triangle_source = map.triangle_sources;
  double in_space = 0;
  area = 0;
  for (const auto& [a, b, c] : map.triangles) {
    in_space += 0.5 * (map.positions[b] - map.positions[a]).cross(map.positions[c] - map.positions[a]).norm();
    area += 0.5 * (image[b] - image[a]).cross(image[c] - image[a]).norm();
  }
  scale = std::sqrt(area / in_space);
}

SurfaceMap WorkingMap::result(const base::Host& host) const {
  return map_of(
      surface, image, facet, [&](Index f) { return label[f]; }, host.memory);
}

int WorkingMap::edges_at(Index v) const {
  int edges = 0;
  surface.for_each_outgoing(v, [&](Index h) { edges += on_edge(h); });
  return edges;
}

double CornerRegion::whole_turn() const {
  return quarters * quarter_turn;
}

Vector3 CornerRegion::fold(const Vector2d& p, const CornerSector& sector) const {
  const Vector2d z = turned_by(p, -sector.turn);
  const int axis = axis_of(sector.label);
  Vector3 result = apex;
  result[(axis + 1) % 3] += z.x();
  result[(axis + 2) % 3] += sign_of(sector.label) * z.y();
  return result;
}

Vector2d CornerRegion::flatten(double r, double a) const {
  const double turns = 4.0 / quarters, distance = std::pow(r / radius, turns);
  return {distance * std::cos(turns * a), distance * std::sin(turns * a)};
}

}  // namespace orbicube::polycube
