#include "volume_map/frames/layer_bounds.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "volume_map/frames/transitions.h"

namespace orbicube::volume_map {
namespace {

using quaternion::cube_group;

class Walk {
 public:
  Walk(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity, const FrameCut& cut,
       double cell_length, SeamlessSystem& system, const base::Host& host)
      : positions_(positions),
        connectivity_(connectivity),
        cut_(cut),
        reach_(0.5 * cell_length),
        system_(system),
        host_(host),
        found_(host.memory) {}

  Vector3 axis_of(Index t, std::size_t axis) const {
    const quaternion::Vector v =
        quaternion::rotate(cut_.frames[t], {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
    return {v.x, v.y, v.z};
  }

  Index form_at(Index t, Index vertex, std::size_t axis) const {
    const std::size_t i = 3 * std::size_t{cut_.copies[t][connectivity_.corner_of(t, vertex)]} + axis;
    return system_.variable[i] == no_index ? system_.form[i] : no_index;
  }

  // From a point whose coordinate along the axis is `start`, to where that grows (direction 1) or falls (-1), as far as
  // the first that is met.
  void go(Index t, Vector3 x, std::size_t axis, int direction, Index start) {
    constexpr int most = 4096;
    const Vector3 begin = x;
    const int first_direction = direction;
    int sign = 1;    // the coordinate in the first chart is sign times that here
    Index rest = 0;  // plus this
    Index entered = no_index;
    for (int step = 0; step < most; ++step) {
      host_.report("layers", 0, 0);
      const Tetrahedron& corners = connectivity_.tetrahedra()[t];
      const Vector3& origin = positions_[corners[0]];
      const Eigen::Matrix3d inverse = inverse_edges(corners);
      const Vector3 d = direction * axis_of(t, axis);
      const Vector3 place = inverse * (x - origin), rate = inverse * d;
      const std::array<double, 4> weights = {1 - place.sum(), place[0], place[1], place[2]};
      const std::array<double, 4> rates = {-rate.sum(), rate[0], rate[1], rate[2]};
      const auto meet = [&](Index v) {
        const Index form = form_at(t, v, axis);
        if (form == no_index) return false;
        const Index there = system_.forms.sum(form, sign, rest, 1);
        const Index between = system_.forms.sum(there, first_direction, start, -first_direction);
        if (system_.forms.is_zero(between)) return false;
        found_.push_back({between, begin, positions_[v]});
        return true;
      };
      bool met = false;
      for (const Index v : corners) {
        const Vector3 to = positions_[v] - x;
        const double along = to.dot(d);
        if (along > 0 && (to - along * d).norm() < reach_) met = meet(v) || met;
      }
      if (met) return;
      const auto [exit, least] = exit_of(t, entered, weights, rates);
      if (exit == no_index) return;
      x += least * d;
      const Index other = connectivity_.opposite(exit);
      if (other == no_index) {
        if (system_.label[exit] == 2 * axis + (direction > 0 ? 1 : 0)) meet(connectivity_.vertices(exit)[0]);
        return;
      }
      if (cut_.sheet[exit] != no_index) {
        // The coordinate here is a turned one of there and the gap of the way back.
        const Index back = gap_of(other, axis);
        rest = system_.forms.sum(rest, 1, back, sign);
        const std::uint8_t rotation = cut_.rotation[exit];
        const int turn = Transition::sign(rotation, axis);
        axis = Transition::source(rotation, axis);
        sign *= turn;
        direction *= turn;
      }
      entered = other;
      t = other / 4;
    }
  }

  LayerBounds result() {
    LayerBounds result(host_.memory);
    const auto compare = [&](Index a, Index b, int sign) {
      const auto x = system_.forms.terms(a), y = system_.forms.terms(b);
      for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (x[i].unknown != y[i].unknown) return x[i].unknown < y[i].unknown ? -1 : 1;
        if (x[i].factor != sign * y[i].factor) return x[i].factor < sign * y[i].factor ? -1 : 1;
      }
      return x.size() == y.size() ? 0 : x.size() < y.size() ? -1 : 1;
    };
    std::stable_sort(found_.begin(), found_.end(),
                     [&](const Found& a, const Found& b) { return compare(a.form, b.form, 1) < 0; });
    host_.report("layers", 0, 0);
    // Each once, with how often it was found.
    Array<Found> distinct(host_.memory);
    Array<std::size_t> count(host_.memory);
    for (const Found& f : found_) {
      if (distinct.empty() || compare(distinct.back().form, f.form, 1) != 0) {
        distinct.push_back(f);
        count.push_back(0);
      }
      ++count.back();
    }
    for (std::size_t i = 0; i < distinct.size(); ++i) {
      host_.report("layers", 0, 0);
      // Where some ways say the opposite, as may happen where the field turns much, the greater number is believed.
      const Index opposite = system_.forms.sum(distinct[i].form, -1, 0, 1);
      const auto other = std::lower_bound(distinct.begin(), distinct.end(), opposite,
                                          [&](const Found& f, Index form) { return compare(f.form, form, 1) < 0; });
      if (other != distinct.end() && compare(other->form, opposite, 1) == 0 &&
          count[static_cast<std::size_t>(other - distinct.begin())] >= count[i])
        continue;
      result.bounds.push_back({distinct[i].form, 1});
      result.from.push_back(distinct[i].from);
      result.to.push_back(distinct[i].to);
    }
    return result;
  }

 private:
  struct Found {
    Index form;
    Vector3 from, to;
  };

  // Returns the inverse of the matrix of edges from the first corner.
  Eigen::Matrix3d inverse_edges(const Tetrahedron& corners) const {
    const Vector3& origin = positions_[corners[0]];
    Eigen::Matrix3d edges;
    edges << positions_[corners[1]] - origin, positions_[corners[2]] - origin, positions_[corners[3]] - origin;
    return edges.inverse();
  }

  struct Exit {
    Index face = no_index;
    double length = std::numeric_limits<double>::infinity();
  };
  // Returns the face by which one leaves a tetrahedron, by barycentric weights and their rates, and how far it is.
  static Exit exit_of(Index t, Index entered, const std::array<double, 4>& weights,
                      const std::array<double, 4>& rates) {
    Exit exit;
    for (Index k = 0; k < 4; ++k) {
      if (4 * t + k == entered || rates[k] >= 0) continue;
      const double length = std::max(0.0, weights[k]) / -rates[k];
      if (length >= exit.length) continue;
      exit = {4 * t + k, length};
    }
    return exit;
  }

  // The form of one coordinate of the gap beyond a face.
  Index gap_of(Index face, std::size_t axis) {
    const auto& gap = system_.gap[cut_.sheet[face]];
    if (cut_.forward[face] != 0) return gap[axis];
    const std::uint8_t back = cube_group.inverse[cut_.rotation[face]];
    return system_.forms.sum(gap[Transition::source(back, axis)], -Transition::sign(back, axis), 0, 1);
  }

  std::span<const Vector3> positions_;
  const mesh::TetrahedralConnectivity& connectivity_;
  const FrameCut& cut_;
  double reach_;
  SeamlessSystem& system_;
  const base::Host& host_;
  Array<Found> found_;
};

}  // namespace

LayerBounds find_layer_bounds(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                              const mesh::EdgeRings& rings, const FrameCut& cut, double cell_length,
                              SeamlessSystem& system, const base::Host& host) {
  Walk walk(positions, connectivity, cut, cell_length, system, host);
  for (Index face = 0; face < connectivity.face_count(); ++face) {
    if (!connectivity.on_boundary(face)) continue;
    const auto [a, b, c] = connectivity.vertices(face);
    const std::size_t axis = system.label[face] / 2;
    const Index start = walk.form_at(face / 4, a, axis);
    walk.go(face / 4, (positions[a] + positions[b] + positions[c]) / 3, axis, system.label[face] % 2 == 1 ? -1 : 1,
            start);
  }
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    if (cut.singular[ring] == 0) continue;
    const auto [p, q] = rings.vertices(ring);
    const Vector3 middle = 0.5 * (positions[p] + positions[q]);
    for (const Index face : rings.faces(ring)) {
      const Index t = face / 4;
      // The two other corners: one goes from the edge into the tetrahedron where both weights grow.
      std::array<Vector3, 2> other;
      std::size_t count = 0;
      for (const Index v : connectivity.tetrahedra()[t]) {
        if (v != p && v != q) other[count++] = positions[v] - middle;
      }
      const Vector3 along = positions[q] - positions[p];
      const Vector3 first = along.cross(other[0]), second = along.cross(other[1]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Index start = walk.form_at(t, p, axis), end = walk.form_at(t, q, axis);
        // The edge itself is along the axis that has no common integer at both ends.
        if (start == no_index || end == no_index || !system.forms.is_zero(system.forms.sum(start, 1, end, -1))) {
          // Where curves meet or end there is one: from there one goes along the curve.
          if (face != rings.faces(ring).front()) continue;
          const Vector3 beside = middle + 0.02 * (other[0] + other[1]);
          const int ahead = along.dot(walk.axis_of(t, axis)) > 0 ? 1 : -1;
          if (start != no_index) walk.go(t, beside, axis, ahead, start);
          if (end != no_index) walk.go(t, beside, axis, -ahead, end);
          continue;
        }
        for (const int direction : {1, -1}) {
          const Vector3 d = direction * walk.axis_of(t, axis);
          if (d.dot(first) * other[1].dot(first) > 0 && d.dot(second) * other[0].dot(second) > 0)
            walk.go(t, middle, axis, direction, start);
        }
      }
    }
  }
  return walk.result();
}

}  // namespace orbicube::volume_map
