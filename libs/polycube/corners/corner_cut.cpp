#include "polycube/corners/corner_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/search/planar.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

using mesh::cross;

// A vertex that is as near to a ray, in parts of its shortest edge, goes onto it if its triangles keep such a part of
// their areas.
constexpr double snapping = 0.2, min_part_of_area = 0.3;

class RegionCut {
 public:
  RegionCut(const CornerMove& move, WorkingMap& map, const base::Host& host)
      : move_(move),
        region_(move.region()),
        map_(map),
        surface_(map.surface),
        whole_(move.region().whole_turn()),
        faces_(region_.faces.begin(), region_.faces.end(), host.memory),
        moved_(host.memory),
        known_(host.memory),
        member_(host.memory),
        cone_(host.memory),
        angle_(host.memory),
        local_angle_(host.memory),
        old_areas_(host.memory) {}

  bool run() {
    const auto first_face = static_cast<Index>(surface_.faces());
    apex_ = insert_apex();
    for (Index f = first_face; f < surface_.faces(); ++f)
      faces_.push_back(f);
    cone_.resize(surface_.vertices(), Vector2d::Zero());
    angle_.resize(surface_.vertices(), 0.0);
    if (!unfold()) return false;
    snap();
    if (!cut()) return false;
    return write();
  }

 private:
  // The corners of a triangle unfolded, each beside the others.
  struct Unfolded {
    std::array<Vector2d, 3> at;
    std::array<double, 3> angle;
    std::size_t apex = 3;  // which corner
  };

  Index insert_apex() {
    if (!move_.added()) return region_.vertices[move_.apex()];
    const CornerMove::Place& place = move_.place();
    const auto& w = place.weights;
    const Index f = region_.faces[place.face];
    const auto zero = static_cast<std::size_t>(std::find(w.begin(), w.end(), 0.0) - w.begin());
    if (zero < 3) {
      const auto k = static_cast<Index>((zero + 1) % 3);
      return surface_.split_edge(3 * f + k, w[(zero + 2) % 3]);
    }
    const Triangle t = surface_.triangle[f];
    const Index v = surface_.split_face(f);
    surface_.position[v] =
        w[0] * surface_.position[t[0]] + w[1] * surface_.position[t[1]] + w[2] * surface_.position[t[2]];
    surface_.source[v] =
        between_sources(between_sources(surface_.source[t[0]], surface_.source[t[1]], w[1] / (w[0] + w[1])),
                        surface_.source[t[2]], w[2]);
    return v;
  }

  // Into what is from 0 up to the whole turn; the point, if there is one, with it.
  double normalized(double angle, Vector2d* point = nullptr) const {
    const int turns = static_cast<int>(std::floor(angle / whole_));
    if (point != nullptr) *point = turned_by(*point, -turns * region_.quarters);
    return std::clamp(angle - turns * whole_, 0.0, whole_);
  }

  // Angles from those on the boundary, triangle by triangle.
  bool unfold() {
    const std::size_t count = region_.vertices.size() + (move_.added() ? 1 : 0);
    known_.assign(count, 0);
    Array<double>& angles = local_angle_;
    angles.assign(count, 0.0);
    for (std::size_t v = region_.inside; v < region_.vertices.size(); ++v) {
      angles[v] = region_.angle[v];
      known_[v] = 1;
    }
    known_[move_.apex()] = 1;
    const auto& triangles = move_.triangles();
    std::size_t left = static_cast<std::size_t>(std::count(known_.begin(), known_.end(), 0));
    for (bool changed = true; changed && left > 0;) {
      changed = false;
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Triangle& t = triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t n = (k + 1) % 3;
          for (const auto& [from, to] : {std::array{k, n}, std::array{n, k}}) {
            const Index a = t[from], b = t[to];
            if (a == move_.apex() || !known_[a] || known_[b]) continue;
            const int turn_a = move_.turn(i, from), turn_b = move_.turn(i, to);
            const Vector2d p = turned_by(move_.position(a), turn_a), q = turned_by(move_.position(b), turn_b);
            angles[b] = angles[a] + (turn_a - turn_b) * quarter_turn + std::atan2(cross(p, q), p.dot(q));
            known_[b] = 1;
            --left;
            changed = true;
          }
        }
      }
    }
    if (left > 0) return false;
    for (Index v = 0; v < count; ++v) {
      const Index own = v < region_.vertices.size() ? region_.vertices[v] : apex_;
      cone_[own] = v < region_.inside || v >= region_.vertices.size() ? move_.position(v) : region_.cone[v];
      angle_[own] = normalized(angles[v], &cone_[own]);
      if (v < region_.inside || v >= region_.vertices.size()) moved_.push_back(own);
    }
    return true;
  }

  // Whole turns are chosen so that the triangle is positive and narrow.
  bool unfolded(Index face, Unfolded& result) const {
    const Triangle& t = surface_.triangle[face];
    result.apex = static_cast<std::size_t>(std::find(t.begin(), t.end(), apex_) - t.begin());
    for (std::size_t k = 0; k < 3; ++k) {
      result.at[k] = cone_[t[k]];
      result.angle[k] = angle_[t[k]];
    }
    const auto turn = [&](std::size_t k, int turns) {
      result.at[k] = turned_by(cone_[t[k]], turns * region_.quarters);
      result.angle[k] = angle_[t[k]] + turns * whole_;
    };
    if (result.apex < 3) {
      const std::size_t b = (result.apex + 1) % 3, c = (result.apex + 2) % 3;
      if (result.angle[c] <= result.angle[b]) turn(c, 1);
      return true;
    }
    double least = 2 * quarter_turn;
    std::array<int, 2> best{};
    for (const int second : {0, -1, 1}) {
      for (const int third : {0, -1, 1}) {
        turn(1, second);
        turn(2, third);
        const auto [low, high] = std::minmax({result.angle[0], result.angle[1], result.angle[2]});
        if (high - low < least && cross(result.at[1] - result.at[0], result.at[2] - result.at[0]) > 0) {
          least = high - low;
          best = {second, third};
        }
      }
    }
    turn(1, best[0]);
    turn(2, best[1]);
    return least < 2 * quarter_turn;
  }

  double area(Index face) const {
    Unfolded u;
    return unfolded(face, u) ? cross(u.at[1] - u.at[0], u.at[2] - u.at[0]) : 0;
  }

  void snap() {
    for (const Index v : moved_) {
      if (v == apex_) continue;
      double shortest = cone_[v].norm();
      surface_.for_each_outgoing(v, [&](Index h) {
        Unfolded u;
        if (!unfolded(h / 3, u)) return;
        const std::size_t k = h % 3;
        shortest = std::min(shortest, (u.at[(k + 1) % 3] - u.at[k]).norm());
      });
      for (const CornerSector& sector : region_.sectors) {
        // The first ray is also where the whole turn ends.
        const bool at_end = sector.begin == 0 && angle_[v] > 0.5 * whole_;
        const int ray = at_end ? region_.quarters : sector.begin;
        const Vector2d p = turned_by(cone_[v], -ray);
        if (!(std::abs(angle_[v] - ray * quarter_turn) < quarter_turn) || !(p.x() > 0) || p.y() == 0 ||
            std::abs(p.y()) > snapping * shortest)
          continue;
        const Vector2d before = cone_[v];
        const double angle_before = angle_[v];
        double worst = std::numeric_limits<double>::infinity();
        old_areas_.clear();
        surface_.for_each_outgoing(v, [&](Index h) { old_areas_.push_back(area(h / 3)); });
        cone_[v] = turned_by({p.x(), 0}, sector.begin);
        angle_[v] = sector.begin * quarter_turn;
        std::size_t i = 0;
        surface_.for_each_outgoing(v, [&](Index h) { worst = std::min(worst, area(h / 3) / old_areas_[i++]); });
        if (worst > min_part_of_area) break;
        cone_[v] = before;
        angle_[v] = angle_before;
      }
    }
  }

  // Splits all edges that cross rays; a new vertex lies on its ray, so that no new edge does.
  bool cut() {
    for (const Index v : moved_) {
      for (const CornerSector& sector : region_.sectors) {
        const Vector2d p = turned_by(cone_[v], -sector.begin);
        if (p.y() == 0 && p.x() > 0 && std::abs(angle_[v] - sector.begin * quarter_turn) < quarter_turn)
          angle_[v] = sector.begin * quarter_turn;
      }
    }
    member_.assign(surface_.faces(), 0);
    for (const Index f : faces_)
      member_[f] = 1;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const Index f = faces_[i];
      bool crossed = true;
      while (crossed) {
        crossed = false;
        Unfolded u;
        if (!unfolded(f, u)) return false;
        for (std::size_t k = 0; k < 3 && !crossed; ++k) {
          const std::size_t n = (k + 1) % 3;
          if (u.apex == k || u.apex == n) continue;
          for (std::size_t s = 0; s < region_.sectors.size() && !crossed; ++s) {
            for (int turns = -1; turns <= 1 && !crossed; ++turns) {
              const int ray = region_.sectors[s].begin + turns * region_.quarters;
              const auto [low, high] = std::minmax(u.angle[k], u.angle[n]);
              if (ray * quarter_turn < low - 1e-9 || ray * quarter_turn > high + 1e-9) continue;
              const Vector2d a = turned_by(u.at[k], -ray), b = turned_by(u.at[n], -ray);
              if (!((a.y() < 0 && b.y() > 0) || (a.y() > 0 && b.y() < 0))) continue;
              const double part = a.y() / (a.y() - b.y());
              const double along = a.x() + part * (b.x() - a.x());
              if (!(along > 0)) continue;
              const Index h = 3 * f + static_cast<Index>(k);
              if (!member_[surface_.opposite(h) / 3]) return false;
              const Index m = surface_.split_edge(h, part);
              cone_.push_back(turned_by({along, 0}, region_.sectors[s].begin));
              angle_.push_back(region_.sectors[s].begin * quarter_turn);
              moved_.push_back(m);
              for (Index added = static_cast<Index>(member_.size()); added < surface_.faces(); ++added) {
                member_.push_back(1);
                faces_.push_back(added);
              }
              crossed = true;
            }
          }
        }
      }
    }
    return true;
  }

  const CornerSector& sector_at(double angle) const {
    angle = normalized(angle);
    for (const CornerSector& sector : region_.sectors)
      if (angle < (sector.begin + sector.quarters) * quarter_turn) return sector;
    return region_.sectors.front();
  }

  bool write() {
    map_.image.resize(surface_.vertices(), region_.apex);
    map_.label.resize(surface_.faces());
    map_.facet.resize(surface_.faces());
    for (const Index f : faces_) {
      Unfolded u;
      if (!unfolded(f, u)) return false;
      const std::size_t from = u.apex == 0 ? 1 : 0;
      const Vector2d middle = (u.at[0] + u.at[1] + u.at[2]) / 3;
      const CornerSector& sector =
          sector_at(u.angle[from] + std::atan2(cross(u.at[from], middle), u.at[from].dot(middle)));
      map_.label[f] = sector.label;
      map_.facet[f] = sector.facet;
    }
    for (const Index v : moved_) {
      if (v == apex_) {
        map_.image[v] = region_.apex;
        continue;
      }
      // Of a face at the vertex: near a ray the angle does not tell.
      const Index f = surface_.outgoing(v) / 3;
      const auto sector = std::find_if(region_.sectors.begin(), region_.sectors.end(),
                                       [&](const CornerSector& s) { return s.facet == map_.facet[f]; });
      // A ray is seen from both its sides, the first also as the end of the whole turn.
      Vector2d p = cone_[v];
      const bool wraps = angle_[v] == 0 && sector->begin > 0 && sector->begin + sector->quarters == region_.quarters;
      if (wraps) p = turned_by(p, region_.quarters);
      map_.image[v] = region_.fold(p, *sector);
    }
    return std::all_of(faces_.begin(), faces_.end(), [&](Index f) {
      const int axis = axis_of(map_.label[f]);
      const auto flat = [&](Index v) {
        return Vector2d(map_.image[v][(axis + 1) % 3], sign_of(map_.label[f]) * map_.image[v][(axis + 2) % 3]);
      };
      const auto& [a, b, c] = surface_.triangle[f];
      return map_.image[a][axis] == region_.apex[axis] && map_.image[b][axis] == region_.apex[axis] &&
             map_.image[c][axis] == region_.apex[axis] && mesh::orientation_2d(flat(a), flat(b), flat(c)) > 0;
    });
  }

  const CornerMove& move_;
  const CornerRegion& region_;
  WorkingMap& map_;
  EditableSurface& surface_;
  double whole_;
  Index apex_ = no_index;
  Array<Index> faces_;  // of the region, those that come up included
  Array<Index> moved_;  // vertices that are not on its boundary
  Array<std::uint8_t> known_, member_;
  Array<Vector2d> cone_;  // of each vertex of the region
  Array<double> angle_, local_angle_;
  Array<double> old_areas_;
};

}  // namespace

bool cut_region(const CornerMove& move, WorkingMap& map, const base::Host& host) {
  return RegionCut(move, map, host).run();
}

}  // namespace orbicube::polycube
