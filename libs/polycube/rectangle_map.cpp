#include "polycube/rectangle_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/predicates.h"

namespace orbicube::polycube {
namespace {

constexpr const char* phase = "rectangles";

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
    const Index none = 0;
    for (Index v = none; v < surface_.vertices(); ++v)
      if (!surface_.occupied[v] && surface_.outgoing(v) != no_index) free_.push_back(v);
    // Mean-value weights first; where rounding spoils that, equal ones are easier.
    for (const bool equal : {false, true}) {
      weigh(equal);
      relax();
      if (positive()) return std::move(image_);
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

  void weigh(bool equal) {
    row_begin_.assign(1, 0);
    column_.clear();
    weight_.clear();
    for (const Index v : free_) {
      double sum = 0;
      const std::size_t begin = weight_.size();
      const Vector3& p = surface_.position[v];
      surface_.for_each_outgoing(v, [&](Index h) {
        const Vector3 along = surface_.position[surface_.end(h)] - p;
        const Vector3 left = surface_.position[surface_.end(EditableSurface::next(h))] - p;
        const Vector3 right = surface_.position[surface_.end(EditableSurface::next(surface_.opposite(h)))] - p;
        const double length = std::max(along.norm(), 1e-300);
        const double w = equal ? 1.0 : (half_tangent(along, left) + half_tangent(along, right) + 1e-3) / length;
        column_.push_back(surface_.end(h));
        weight_.push_back(std::min(w, 1e200));
        sum += weight_.back();
      });
      // None may vanish beside the others.
      const double least = 1e-4 * sum / static_cast<double>(weight_.size() - begin);
      sum = 0;
      for (std::size_t k = begin; k < weight_.size(); ++k)
        sum += weight_[k] = std::max(weight_[k], least);
      for (std::size_t k = begin; k < weight_.size(); ++k)
        weight_[k] /= sum;
      row_begin_.push_back(static_cast<Index>(weight_.size()));
    }
  }

  // Each vertex at the mean of its neighbours, over and over (Gauss-Seidel, successive over-relaxation): rectangles are
  // coarse. All at once; vertices on arcs do not move, so that rectangles know nothing of each other.
  void relax() {
    constexpr int most_rounds = 20000;
    constexpr double tolerance = 1e-14;
    double extent = 0;
    for (std::size_t a = 0; a < 3; ++a)
      extent = std::max(extent, layout_.planes[a].back() - layout_.planes[a].front());
    for (const Index v : free_) {
      const LayoutRectangle& r = rectangle_of(surface_.outgoing(v) / 3);
      image_[v] = 0.5 * (layout_.position(r.low) + layout_.position(r.high));
    }
    for (int round = 0; round < most_rounds; ++round) {
      host_.report(phase, 0, 0);
      const double factor = round % 20 == 19 ? 1.0 : 1.5;
      double moved = 0;
      for (std::size_t i = 0; i < free_.size(); ++i) {
        const Index v = free_[i];
        Vector3 mean = Vector3::Zero();
        for (Index k = row_begin_[i]; k < row_begin_[i + 1]; ++k)
          mean += weight_[k] * image_[column_[k]];
        const Vector3 step = factor * (mean - image_[v]);
        moved = std::max(moved, step.cwiseAbs().maxCoeff());
        image_[v] += step;
      }
      if (moved <= tolerance * extent) break;
    }
    // Exactly in the plane.
    for (const Index v : free_) {
      const LayoutRectangle& r = rectangle_of(surface_.outgoing(v) / 3);
      const int axis = axis_of(r.label);
      image_[v][axis] = layout_.position(r.low)[axis];
    }
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
  Array<Index> row_begin_, column_;  // their neighbours
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
