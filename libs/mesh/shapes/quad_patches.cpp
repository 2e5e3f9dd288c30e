#include "mesh/shapes/quad_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.h"
#include "mesh/topology/disjoint_sets.h"

namespace orbicube::mesh {
namespace {

// How many strips each half-edge's chord is cut into.
std::vector<Index> strips(const QuadComplex& complex, std::span<const Index> twins,
                          std::span<const double> side_lengths, std::size_t triangles,
                          std::pmr::memory_resource* memory) {
  const auto half_edges = static_cast<Index>(4 * complex.quads.size());
  DisjointSets chords(half_edges, memory);
  for (Index h = 0; h < half_edges; ++h) {
    chords.unite(h, twins[h]);
    chords.unite(h, h % 4 < 2 ? h + 2 : h - 2);
  }
  std::vector<double> length(half_edges, 0.0);
  std::vector<double> members(half_edges, 0.0);
  for (Index h = 0; h < half_edges; ++h) {
    length[chords.find(h)] += side_lengths[h];
    members[chords.find(h)] += 1;
  }
  const auto count = [&](Index half_edge, double density) {
    const Index chord = chords.find(half_edge);
    return static_cast<Index>(std::max(1L, std::lround(density * length[chord] / members[chord])));
  };
  const auto total = [&](double density) {
    double sum = 0;
    for (Index h = 0; h < half_edges; h += 4)
      sum += 2.0 * count(h, density) * count(h + 1, density);
    return sum;
  };
  const auto target = static_cast<double>(triangles);
  double low = 0;
  double high = 1;
  while (total(high) < target)
    high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (total(middle) < target ? low : high) = middle;
  }
  const double density = target - total(low) < total(high) - target ? low : high;
  std::vector<Index> result(half_edges);
  for (Index h = 0; h < half_edges; ++h)
    result[h] = count(h, density);
  return result;
}

// Numbers the vertices of all grids: corners first, then the inner points of the sides, then those of the patches.
class Numbering {
 public:
  Numbering(const QuadComplex& complex, std::span<const Index> twins, std::span<const Index> strips)
      : complex_(complex),
        twins_(twins),
        strips_(strips),
        first_on_side_(twins.size()),
        first_inside_(twins.size() / 4) {
    count_ = complex.corners.size();
    for (Index h = 0; h < twins.size(); ++h) {
      if (twins[h] < h) continue;
      first_on_side_[h] = count_;
      count_ += strips[h] - 1;
    }
    for (Index q = 0; q < first_inside_.size(); ++q) {
      first_inside_[q] = count_;
      count_ += std::size_t{strips[4 * q] - 1} * (strips[4 * q + 1] - 1);
    }
  }

  std::size_t count() const { return count_; }

  // Whether the points of this side are made with this quad, not with the one on the other side.
  bool makes(Index half_edge) const { return half_edge < twins_[half_edge]; }

  // The point at (i / columns, j / rows) of a patch.
  Index vertex(Index quad, Index i, Index j) const {
    const Index h = 4 * quad;
    const Index columns = strips_[h];
    const Index rows = strips_[h + 1];
    if (j == 0) return on_side(h, i);
    if (i == columns) return on_side(h + 1, j);
    if (j == rows) return on_side(h + 2, columns - i);
    if (i == 0) return on_side(h + 3, rows - j);
    return static_cast<Index>(first_inside_[quad] + std::size_t{j - 1} * (columns - 1) + (i - 1));
  }

 private:
  Index on_side(Index half_edge, Index step) const {
    const Index n = strips_[half_edge];
    if (step == 0) return complex_.quads[half_edge / 4][half_edge % 4];
    if (step == n) return on_side(next_in_quad(half_edge), 0);
    return static_cast<Index>(makes(half_edge) ? first_on_side_[half_edge] + step - 1
                                               : first_on_side_[twins_[half_edge]] + n - step - 1);
  }

  const QuadComplex& complex_;
  std::span<const Index> twins_;
  std::span<const Index> strips_;
  std::vector<std::size_t> first_on_side_;
  std::vector<std::size_t> first_inside_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<Index> twins_of(const QuadComplex& complex) {
  std::map<std::pair<Index, Index>, Index> by_ends;
  const auto start = [&](Index h) { return complex.quads[h / 4][h % 4]; };
  const auto half_edges = static_cast<Index>(4 * complex.quads.size());
  for (Index h = 0; h < half_edges; ++h)
    by_ends.insert({{start(h), start(next_in_quad(h))}, h});
  std::vector<Index> twins(half_edges);
  for (Index h = 0; h < half_edges; ++h) {
    const auto twin = by_ends.find({start(next_in_quad(h)), start(h)});
    if (twin == by_ends.end() || by_ends.size() != half_edges) {
      throw base::Error("internal", "the patches of a shape do not form a closed surface");
    }
    twins[h] = twin->second;
  }
  return twins;
}

Mesh mesh_patches(const QuadComplex& complex, PatchSurface& surface, std::span<const double> side_lengths,
                  std::size_t triangles, const base::Host& host) {
  const std::vector<Index> twins = twins_of(complex);
  const std::vector<Index> count = strips(complex, twins, side_lengths, triangles, host.memory);
  const Numbering numbering(complex, twins, count);
  Mesh mesh(host.memory);
  mesh.positions.resize(numbering.count());
  const auto quads = static_cast<Index>(complex.quads.size());
  std::size_t cells = 0;
  for (Index q = 0; q < quads; ++q) {
    const Index columns = count[4 * q];
    const Index rows = count[4 * q + 1];
    cells += std::size_t{columns} * rows;
    surface.select(q);
    for (Index j = 0; j <= rows; ++j) {
      host.report("making the shape", q, quads);
      for (Index i = 0; i <= columns; ++i) {
        const bool elsewhere = (j == 0 && !numbering.makes(4 * q)) || (i == columns && !numbering.makes(4 * q + 1)) ||
                               (j == rows && !numbering.makes(4 * q + 2)) || (i == 0 && !numbering.makes(4 * q + 3));
        const bool corner = (j == 0 || j == rows) && (i == 0 || i == columns);
        if (elsewhere && !corner) continue;
        mesh.positions[numbering.vertex(q, i, j)] =
            surface.at(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
      }
    }
  }
  mesh.triangles.reserve(2 * cells);
  for (Index q = 0; q < quads; ++q) {
    for (Index j = 0; j < count[4 * q + 1]; ++j) {
      host.report("making the shape", q, quads);
      for (Index i = 0; i < count[4 * q]; ++i) {
        const Quad cell = {numbering.vertex(q, i, j), numbering.vertex(q, i + 1, j), numbering.vertex(q, i + 1, j + 1),
                           numbering.vertex(q, i, j + 1)};
        const auto diagonal = [&](std::size_t from) {
          return (mesh.positions[cell[from + 2]] - mesh.positions[cell[from]]).squaredNorm();
        };
        if (diagonal(0) <= diagonal(1)) {
          mesh.triangles.push_back({cell[0], cell[1], cell[2]});
          mesh.triangles.push_back({cell[0], cell[2], cell[3]});
        } else {
          mesh.triangles.push_back({cell[0], cell[1], cell[3]});
          mesh.triangles.push_back({cell[1], cell[2], cell[3]});
        }
      }
    }
  }
  return mesh;
}

}  // namespace orbicube::mesh
