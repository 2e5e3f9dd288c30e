#include "polycube/layout/layout_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "polycube/layout/planar_star.h"
#include "polycube/layout/rectangle_map.h"
#include "polycube/surface/added_vertices.h"
#include "polycube/surface/surface_decimation.h"

namespace orbicube::polycube {
namespace {

constexpr const char* layout_map_phase = "map";

class LayoutMap {
 public:
  LayoutMap(const Layout& layout, EditableSurface& surface, Drawing& drawing, const base::Host& host)
      : layout_(layout),
        surface_(surface),
        drawing_(drawing),
        host_(host),
        star_(host.memory),
        label_(host.memory),
        facet_(host.memory),
        image_(host.memory),
        active_(host.memory) {
    for (const Index r : drawing.rectangle) {
      label_.push_back(layout.rectangles[r].label);
      facet_.push_back(layout.rectangles[r].facet);
    }
    measure();
  }

  SurfaceMap run(const LayoutMapOptions& options) {
    constexpr std::size_t min_vertices = 300, vertices_a_node = 8;
    const Array<double> parameter = arc_parameters(surface_, drawing_, host_);
    const Array<Index> collapsed =
        decimate(layout_, surface_, drawing_, std::max(min_vertices, vertices_a_node * layout_.nodes.size()), host_);
    image_ = map_rectangles(layout_, drawing_, surface_, parameter, host_);
    for (Index v = 0; v < surface_.vertices(); ++v)
      if (surface_.outgoing(v) != no_index) active_.push_back(v);
    constexpr int coarse_sweeps = 100;
    smooth(coarse_sweeps, 1e-4);
    refine(collapsed);
    smooth(options.sweeps, 1e-4);
    // The fewer needles, the more smoothing reaches, and that lets more of them go.
    constexpr int removals = 10;
    for (int i = 0; i < removals && remove_added_vertices(surface_, view(), host_) > 0; ++i) {
      std::erase_if(active_, [&](Index v) { return surface_.outgoing(v) == no_index; });
      smooth(options.sweeps, 1e-4);
    }
    return result();
  }

 private:
  MapView view() { return {surface_, label_, facet_, image_, scale_, min_length_}; }

  void measure() {
    double in_space = 0, on_polycube = 0;
    Vector3 low = surface_.position[surface_.triangle[0][0]], high = low;
    for (const Triangle& t : surface_.triangle) {
      const Vector3 &a = surface_.position[t[0]], &b = surface_.position[t[1]], &c = surface_.position[t[2]];
      in_space += 0.5 * (b - a).cross(c - a).norm();
      low = low.cwiseMin(a);
      high = high.cwiseMax(a);
    }
    for (const LayoutRectangle& r : layout_.rectangles) {
      const Vector3 size = layout_.position(r.high) - layout_.position(r.low);
      const int axis = axis_of(r.label);
      on_polycube += size[(axis + 1) % 3] * size[(axis + 2) % 3];
    }
    scale_ = std::sqrt(on_polycube / in_space);
    min_length_ = 1e-6 * (high - low).norm();
  }

  // Steps of all active vertices, until a sweep gains less than a part of the energy.
  void smooth(int sweeps, double relative_gain) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      double gain = 0, energy = 0;
      const std::size_t count = active_.size();
      for (std::size_t i = 0; i < count; ++i) {
        if (i % 256 == 0) host_.report(layout_map_phase, 0, 0);
        star_.gather(view(), active_[sweep % 2 == 0 ? i : count - 1 - i]);
        gain += star_.improve(view());
        energy += star_.energy();
      }
      // Every triangle is in three stars.
      if (!(gain > relative_gain * energy / 3)) break;
    }
  }

  void improve(Index v) {
    star_.gather(view(), v);
    star_.improve(view());
  }

  void refine(std::span<const Index> collapsed) {
    constexpr double growth = 1.5;
    constexpr int level_sweeps = 8;
    double next_level = growth * static_cast<double>(active_.size());
    for (std::size_t i = collapsed.size(); i-- > 0;) {
      if (i % 64 == 0) host_.report(layout_map_phase, collapsed.size() - i, collapsed.size());
      insert(collapsed[i]);
      if (static_cast<double>(active_.size()) < next_level) continue;
      smooth(level_sweeps, 1e-4);
      next_level = growth * static_cast<double>(active_.size());
    }
  }

  void insert(Index h) {
    constexpr int max_attempts = 5;
    const Index v = surface_.start(h), w = surface_.end(h);
    for (int attempt = 0;; ++attempt) {
      surface_.undo_collapse(h);
      image_[v] = image_[w];
      star_.gather(view(), v);
      if (star_.place(view())) break;
      if (attempt == max_attempts) throw base::Error("no-valid-result", "a vertex finds no place on the polycube");
      // Its surroundings make room.
      surface_.collapse(h);
      for (int round = 0; round < 4 << attempt; ++round) {
        improve(w);
        surface_.for_each_outgoing(w, [&](Index x) { improve(surface_.end(x)); });
      }
    }
    active_.push_back(v);
    improve(v);
    surface_.for_each_outgoing(v, [&](Index x) { improve(surface_.end(x)); });
    improve(v);
  }

  SurfaceMap result() const {
    return map_of(
        surface_, image_, facet_, [&](Index f) { return label_[f]; }, host_.memory);
  }

  const Layout& layout_;
  EditableSurface& surface_;
  Drawing& drawing_;
  const base::Host& host_;
  PlanarStar star_;
  Array<AxisLabel> label_;
  Array<Index> facet_;
  Array<Vector3> image_;
  Array<Index> active_;  // vertices that are there
  double scale_ = 1, min_length_ = 0;
};

}  // namespace

SurfaceMap map_layout(const Layout& layout, EditableSurface& surface, Drawing& drawing, const LayoutMapOptions& options,
                      const base::Host& host) {
  return LayoutMap(layout, surface, drawing, host).run(options);
}

}  // namespace orbicube::polycube
