#include "polycube/layout/rectangle_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "linear/sparse_system.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

constexpr const char* rectangle_map_phase = "rectangles";

// The tangent of half the angle between two vectors, between 0 and a large number.
double half_tangent(const Vector3& a, const Vector3& b) {
  constexpr double most = 1e4;
  const double sine = a.cross(b).norm(), whole = a.norm() * b.norm();
  if (!(sine > whole / most)) return a.dot(b) >= 0 ? 0 : most;
  return std::min(most, (whole - a.dot(b)) / sine);
}

class RectangleMaps {
 public:
  RectangleMaps(const Layout& layout, const Drawing& drawing, const EditableSurface& surface, const base::Host& host)
      : layout_(layout),
        drawing_(drawing),
        surface_(surface),
        host_(host),
        image_(surface.vertices(), Vector3::Zero(), host.memory),
        free_(host.memory),
        row_begin_(host.memory),
        column_(host.memory),
        weight_(host.memory) {}

  Array<Vector3> run(std::span<const double> parameter) {
    place_arcs(parameter);
    for (Index v = 0; v < surface_.vertices(); ++v)
      if (!surface_.occupied[v] && surface_.outgoing(v) != no_index) free_.push_back(v);
    // Mean-value weights first; where rounding spoils that, equal ones are easier.
    for (const bool equal : {false, true}) {
      weigh(equal);
      if (relax() && positive()) return std::move(image_);
    }
    throw base::Error("no-valid-result", "the maps of the rectangles are lost in rounding");
  }

 private:
  const LayoutRectangle& rectangle_of(Index face) const { return layout_.rectangles[drawing_.rectangle[face]]; }

  void place_arcs(std::span<const double> parameter) {
    for (Index arc = 0; arc < layout_.arcs(); ++arc) {
      const Vector3 a = layout_.node_position(layout_.origin(2 * arc)),
                    b = layout_.node_position(layout_.target(2 * arc));
      const auto axis = static_cast<Eigen::Index>(layout_.axis(arc));
      for (const Index v : drawing_.path[arc]) {
        image_[v] = a;
        image_[v][axis] += parameter[v] * (b[axis] - a[axis]);
      }
    }
    for (Index n = 0; n < layout_.nodes.size(); ++n)
      image_[drawing_.node_vertex[n]] = layout_.node_position(n);
  }

  // What an edge pulls its ends together by: as much as the mean-value weights of both, which differ, so that the
  // system is symmetric. Positive weights are all that a bijection requires.
  double weight(Index h, bool equal) const {
    if (equal) return 1;
    const Vector3& start = surface_.position[surface_.start(h)];
    const Vector3& end = surface_.position[surface_.end(h)];
    const Vector3& left = surface_.position[surface_.end(EditableSurface::next(h))];
    const Vector3& right = surface_.position[surface_.end(EditableSurface::next(surface_.opposite(h)))];
    const auto angles_at = [&](const Vector3& p, const Vector3& other) {
      return half_tangent(other - p, left - p) + half_tangent(other - p, right - p);
    };
    return (angles_at(start, end) + angles_at(end, start) + 1e-3) / std::max((end - start).norm(), 1e-300);
  }

  void weigh(bool equal) {
    row_begin_.assign(1, 0);
    column_.clear();
    weight_.clear();
    if (free_.empty()) return;
    for (const Index v : free_) {
      surface_.for_each_outgoing(v, [&](Index h) {
        column_.push_back(surface_.end(h));
        weight_.push_back(weight(h, equal));
      });
      row_begin_.push_back(static_cast<Index>(weight_.size()));
    }
    // None may vanish beside the others, nor all others beside one.
    constexpr double most = 1e3;
    Array<double> sorted(weight_, host_.memory);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    for (double& w : weight_)
      w = std::clamp(w, *middle / most, *middle * most);
  }

  // Each vertex at the mean of its neighbors, all at once; vertices on arcs do not move, so that rectangles know
  // nothing of each other. Returns whether there is such a place.
  bool relax() {
    host_.report(rectangle_map_phase, 0, 0);
    if (free_.empty()) return true;
    constexpr Index fixed = no_index;
    Array<Index> unknown(surface_.vertices(), fixed, host_.memory);
    for (std::size_t i = 0; i < free_.size(); ++i)
      unknown[free_[i]] = static_cast<Index>(i);
    linear::SparseSystem::Triplets triplets(host_.memory);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(free_.size()), 3);
    for (Index i = 0; i < free_.size(); ++i) {
      double sum = 0;
      for (Index k = row_begin_[i]; k < row_begin_[i + 1]; ++k) {
        const Index j = unknown[column_[k]];
        sum += weight_[k];
        if (j == fixed) right.row(i) += weight_[k] * image_[column_[k]];
        if (j != fixed && j < i) triplets.emplace_back(static_cast<int>(i), static_cast<int>(j), -weight_[k]);
      }
      triplets.emplace_back(static_cast<int>(i), static_cast<int>(i), sum);
    }
    linear::SparseSystem system(free_.size(), triplets);
    if (!system.factorize()) return false;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Eigen::VectorXd solved = system.solve(right.col(axis));
      for (std::size_t i = 0; i < free_.size(); ++i)
        image_[free_[i]][axis] = solved[static_cast<Eigen::Index>(i)];
    }
    // Exactly in the plane.
    for (const Index v : free_) {
      const LayoutRectangle& r = rectangle_of(surface_.outgoing(v) / 3);
      const int axis = axis_of(r.label);
      image_[v][axis] = layout_.position(r.low)[axis];
    }
    return true;
  }

  bool positive() const {
    for (Index f = 0; f < surface_.faces(); ++f) {
      if (!surface_.alive(f)) continue;
      const AxisLabel label = rectangle_of(f).label;
      const int u = (axis_of(label) + 1) % 3, v = (axis_of(label) + 2) % 3;
      const auto flat = [&](Index vertex) {
        return Eigen::Vector2d(image_[vertex][u], sign_of(label) * image_[vertex][v]);
      };
      const Triangle& t = surface_.triangle[f];
      if (mesh::orientation_2d(flat(t[0]), flat(t[1]), flat(t[2])) <= 0) return false;
    }
    return true;
  }

  const Layout& layout_;
  const Drawing& drawing_;
  const EditableSurface& surface_;
  const base::Host& host_;
  Array<Vector3> image_;
  Array<Index> free_;                // vertices on no arc
  Array<Index> row_begin_, column_;  // their neighbors
  Array<double> weight_;
};

}  // namespace

Array<double> arc_parameters(const EditableSurface& surface, const Drawing& drawing, const base::Host& host) {
  Array<double> parameter(surface.vertices(), 0.0, host.memory);
  for (const auto& path : drawing.path) {
    double whole = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      whole += (surface.position[path[i + 1]] - surface.position[path[i]]).norm();
    // A path without length is cut evenly.
    const auto pieces = static_cast<double>(path.size() - 1);
    double length = 0;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      length += (surface.position[path[i]] - surface.position[path[i - 1]]).norm();
      const double even = static_cast<double>(i) / pieces;
      // A little of the even spacing keeps vertices apart that are at one point.
      parameter[path[i]] = whole > 0 ? 0.999 * length / whole + 0.001 * even : even;
    }
  }
  return parameter;
}

Array<Vector3> map_rectangles(const Layout& layout, const Drawing& drawing, const EditableSurface& surface,
                              std::span<const double> parameter, const base::Host& host) {
  return RectangleMaps(layout, drawing, surface, host).run(parameter);
}

}  // namespace orbicube::polycube
