#include "polycube/dissertation/patch_map.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "mesh/topology/place_text.h"

namespace orbicube::polycube::dissertation {
namespace {

// Values at the paths' vertices, by arc length between the positions of their nodes.
void place_paths(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
                 std::span<Vector3> polycube) {
  for (Index arc = 0; arc < layout.arcs(); ++arc) {
    const auto path = drawn.path(arc);
    const Vector3 from = layout.node_position(layout.origin(2 * arc)),
                  to = layout.node_position(layout.target(2 * arc));
    double whole = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      whole += (surface.position[path[i + 1]] - surface.position[path[i]]).norm();
    double length = 0;
    polycube[path.front()] = from;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      length += (surface.position[path[i]] - surface.position[path[i - 1]]).norm();
      const double part = whole > 0 ? length / whole : static_cast<double>(i) / static_cast<double>(path.size() - 1);
      polycube[path[i]] = from + part * (to - from);
    }
    polycube[path.back()] = to;
  }
}

// Exactly in the planes of the rectangles.
void flatten(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
             std::span<const std::uint8_t> fixed, std::span<Vector3> polycube) {
  for (Index face = 0; face < surface.faces(); ++face) {
    const LayoutRectangle& r = layout.rectangles[drawn.rectangle[face]];
    const int axis = axis_of(r.label);
    for (Index k = 0; k < 3; ++k) {
      const Index v = surface.start(3 * face + k);
      if (fixed[v] == 0) polycube[v][axis] = layout.position(r.low)[axis];
    }
  }
}

double signed_area(AxisLabel label, const Vector3& a, const Vector3& b, const Vector3& c) {
  const int u = (axis_of(label) + 1) % 3, v = (axis_of(label) + 2) % 3;
  const Vector3 p = b - a, q = c - a;
  return sign_of(label) * (p[u] * q[v] - p[v] * q[u]) / 2;
}

// Splits edges off the paths that join two vertices of paths.
void split_chords(EditableSurface& surface, const Layout& layout, const Drawn& drawn) {
  for (Index arc = 0; arc < layout.arcs(); ++arc) {
    const auto path = drawn.path(arc);
    for (std::size_t i = 0; i < path.size(); ++i) {
      surface.occupied[path[i]] = 1;
      if (i > 0) surface.draw(surface.between(path[i - 1], path[i]), arc);
    }
  }
  const auto count = static_cast<Index>(3 * surface.faces());
  Array<std::array<Index, 2>> chords(surface.occupied.get_allocator().resource());
  for (Index h = 0; h < count; ++h) {
    const Index a = surface.start(h), b = surface.end(h);
    if (a < b && surface.arc[h] == no_index && surface.occupied[a] != 0 && surface.occupied[b] != 0)
      chords.push_back({a, b});
  }
  for (const auto& [a, b] : chords)
    surface.split_edge(surface.between(a, b), 0.5);
}

}  // namespace

double PatchMap::total(double area_weight) const {
  double sum = 0;
  for (const PatchEnergy& e : energy)
    sum += e.harmonic[0] + e.harmonic[1] + e.harmonic[2] + area_weight * e.stretch;
  return sum;
}

Array<std::uint8_t> boundary_flags(const EditableSurface& surface, const Drawn& drawn, const base::Host& host) {
  Array<std::uint8_t> fixed(surface.vertices(), 0, host.memory);
  for (const Index v : drawn.paths)
    fixed[v] = 1;
  return fixed;
}

void measure_patches(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
                     std::span<const double> weights, std::span<const std::uint8_t> fixed, PatchMap& map) {
  map.energy.assign(layout.rectangles.size(), PatchEnergy());
  map.flipped = 0;
  map.first_flipped = no_index;
  for (Index face = 0; face < surface.faces(); ++face) {
    const Triangle& t = surface.triangle[face];
    PatchEnergy& energy = map.energy[drawn.rectangle[face]];
    for (Index k = 0; k < 3; ++k) {
      // A triangle's share of each edge: half the sum of eq. 4.2, which counts an edge once.
      const Vector3 squares =
          (map.polycube[t[(k + 1) % 3]] - map.polycube[t[k]]).cwiseAbs2() * (weights[3 * face + k] / 2);
      for (std::size_t axis = 0; axis < 3; ++axis)
        energy.harmonic[axis] += squares[static_cast<Eigen::Index>(axis)];
      (weights[3 * face + k] > 0 ? energy.positive : energy.negative) += std::abs(squares.sum());
    }
    const Vector3& p = surface.position[t[0]];
    const double area = (surface.position[t[1]] - p).cross(surface.position[t[2]] - p).norm() / 2;
    const double image = signed_area(layout.rectangles[drawn.rectangle[face]].label, map.polycube[t[0]],
                                     map.polycube[t[1]], map.polycube[t[2]]);
    if (area > 0) energy.stretch += image * image / area;
    const bool on_boundary = fixed[t[0]] != 0 && fixed[t[1]] != 0 && fixed[t[2]] != 0;
    if (image > 0 || on_boundary) continue;
    if (map.flipped++ == 0) map.first_flipped = face;
  }
}

PatchMap map_patches(const Layout& layout, const EditableSurface& surface, const Drawn& drawn,
                     std::span<const double> weights, HarmonicSystem& system, const base::Host& host) {
  PatchMap map(host.memory);
  map.polycube.assign(surface.vertices(), Vector3::Zero());
  const Array<std::uint8_t> fixed = boundary_flags(surface, drawn, host);
  place_paths(layout, surface, drawn, map.polycube);
  if (!system.fix(fixed) || !system.solve(map.polycube))
    throw base::Error("no-valid-result", "the harmonic equations of the patches cannot be solved");
  flatten(layout, surface, drawn, fixed, map.polycube);
  measure_patches(layout, surface, drawn, weights, fixed, map);
  return map;
}

FinishedMap finish_map(const Layout& layout, const EditableSurface& base_surface, const Drawn& base_drawn,
                       const base::Host& host) {
  EditableSurface surface(base_surface.position, base_surface.triangle, host);
  Drawn drawn(host.memory);
  drawn.path_begin.assign(base_drawn.path_begin.begin(), base_drawn.path_begin.end());
  drawn.paths.assign(base_drawn.paths.begin(), base_drawn.paths.end());
  split_chords(surface, layout, drawn);
  find_patches(layout, surface, drawn, host);
  if (!drawn.valid()) throw base::Error("no-valid-result", drawn.first);
  const Array<double> weights = half_edge_weights(surface, host);
  HarmonicSystem system(surface, weights, host);
  PatchMap patches = map_patches(layout, surface, drawn, weights, system, host);
  FinishedMap result(host.memory);
  for (Index face = 0; face < surface.faces(); ++face) {
    const Triangle& t = surface.triangle[face];
    const AxisLabel label = layout.rectangles[drawn.rectangle[face]].label;
    result.map.labels.push_back(label);
    if (signed_area(label, patches.polycube[t[0]], patches.polycube[t[1]], patches.polycube[t[2]]) > 0) continue;
    if (result.flipped++ > 0) continue;
    result.first = "triangle " + std::to_string(surface.triangle_source[face]) + ", at " +
                   mesh::place_text(surface.position[t[0]]);
  }
  SurfaceMap& map = result.map;
  map.positions = std::move(surface.position);
  map.vertex_sources = std::move(surface.source);
  map.triangles = std::move(surface.triangle);
  map.triangle_sources = std::move(surface.triangle_source);
  map.polycube = std::move(patches.polycube);
  return result;
}

}  // namespace orbicube::polycube::dissertation
