// One axis label a triangle by graph cuts: labels that agree with normals, and patches with short boundaries.
//
// Energy and weights as in PolyCut (Livesu et al. 2013); minimized by alpha-expansion (Boykov, Veksler and Zabih 2001),
// each step a minimum cut (Dinic 1970) of the dual graph, whose arcs are the half-edges of the surface.
#pragma once

#include <array>
#include <span>

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

struct LabelCosts {
  explicit LabelCosts(std::pmr::memory_resource* memory) : data(memory), boundary(memory) {}

  void ban(Index triangle, AxisLabel label);

  Array<std::array<double, label_count>> data;  // of each triangle and label
  Array<double> boundary;                       // of each half-edge, when its two triangles are in different patches
};

// `normals` of triangles need not be those of the surface. `compactness` weighs boundaries of patches: with 0.08 a
// shape about gets the eight corners of a cube, with 0.02 some twenty.
LabelCosts label_costs(const Surface& surface, std::span<const Vector3> normals, double compactness,
                       const base::Host& host);

// How much a boundary between two labels counts.
inline double label_distance(AxisLabel a, AxisLabel b) {
  return a == b ? 0 : (axis_of(a) == axis_of(b) ? 2 : 1);
}

// Sum over triangles and edges.
double label_energy(const Surface& surface, const LabelCosts& costs, std::span<const AxisLabel> labels);

// The cheapest label of the data alone.
AxisLabel best_label(const LabelCosts& costs, Index triangle);

// Expands each label in turn until nothing changes or `sweeps` are done. Triangles with free[i] == 0 keep their labels;
// all are free when `free` is empty.
void expand_labels(const Surface& surface, const LabelCosts& costs, std::span<const std::uint8_t> free, int sweeps,
                   std::span<AxisLabel> labels, const base::Host& host);

}  // namespace orbicube::polycube
