#include "polycube/outputs/quad_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/grouping.h"
#include "base/sums.h"
#include "polycube/outputs/inverse_map.h"
#include "polycube/outputs/patch_rectangles.h"

namespace orbicube::polycube {
namespace {

constexpr const char* quad_mesh_phase = "quads";
constexpr double max_quads = 1e7;

class GridSizes {
 public:
  GridSizes(const PatchGraph& graph, const base::Host& host) : grid_(host.memory), rectangles_(host.memory) {
    grid_.layers = layers_of(graph, host.memory);
    rectangles_ = rectangles_of(graph, grid_.layers, host);
  }

  PolycubeGrid choose(const GridOptions& options) {
    if (options.edge_length > 0) {
      set(options.edge_length);
      if (!(count() <= max_quads)) throw base::Error("invalid-argument", "cells so small make too many quads");
    } else {
      find(static_cast<double>(options.quads));
    }
    return std::move(grid_);
  }

 private:
  void set(double edge_length) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Array<double>& at = grid_.layers[axis];
      grid_.cells[axis].clear();
      for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        const double target = std::min((at[i + 1] - at[i]) / edge_length, 2 * max_quads);
        grid_.cells[axis].push_back(static_cast<Index>(std::max(1.0, std::round(target))));
      }
    }
  }

  double count() const {
    double sum = 0;
    for (const PatchRectangle& r : rectangles_)
      sum += static_cast<double>(grid_.cells[first_axis(r.label)][r.first]) *
             static_cast<double>(grid_.cells[second_axis(r.label)][r.second]);
    return sum;
  }

  double count_at(double edge_length) {
    set(edge_length);
    return count();
  }

  // The number of quads never grows with the edge length.
  void find(double quads) {
    double longest = 0;
    for (const Array<double>& at : grid_.layers)
      longest = std::max(longest, at.back() - at.front());
    double long_edge = 4 * longest, short_edge = long_edge;
    while (count_at(short_edge) < quads && short_edge > 1e-6 * longest)
      short_edge *= 0.5;
    for (int step = 0; step < 60; ++step) {
      const double middle = std::sqrt(long_edge * short_edge);
      (count_at(middle) < quads ? long_edge : short_edge) = middle;
    }
    const double fewer = count_at(long_edge), more = count_at(short_edge);
    if (quads - fewer < more - quads) set(long_edge);
  }

  PolycubeGrid grid_;
  Array<PatchRectangle> rectangles_;
};

// Positions of the lines along an axis, those on layers to the bit, and the line of each layer.
struct Lines {
  Array<double> at;
  Array<Index> of_layer;

  Lines(const Array<double>& layers, const Array<Index>& cells, std::pmr::memory_resource* memory)
      : at(memory), of_layer(memory) {
    for (std::size_t i = 0; i + 1 < layers.size(); ++i) {
      of_layer.push_back(static_cast<Index>(at.size()));
      for (Index k = 0; k < cells[i]; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(cells[i]);
        at.push_back(layers[i] + part * (layers[i + 1] - layers[i]));
      }
    }
    of_layer.push_back(static_cast<Index>(at.size()));
    at.push_back(layers.back());
  }
};

using Key = std::array<Index, 3>;  // numbers of lines

// In order, each once: by counting, an axis at a time from the last, so that the host hears of it.
Array<Key> sorted(Array<Key> keys, const std::array<Lines, 3>& lines, const base::Host& host) {
  Array<Key> other(keys.size(), host.memory);
  for (std::size_t axis = 3; axis-- > 0;) {
    Array<std::size_t> begin(lines[axis].at.size() + 1, host.memory);
    base::group_by_key(
        std::span(begin),
        [&](const auto& visit) {
          for (std::size_t i = 0; i < keys.size(); ++i) {
            if (i % base::items_between_reports == 0) host.report(quad_mesh_phase, 0, 0);
            visit(keys[i][axis], keys[i]);
          }
        },
        [](std::size_t) {}, [&](std::size_t at, const Key& key) { other[at] = key; });
    std::swap(keys, other);
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report(quad_mesh_phase, 0, 0);
    if (count == 0 || keys[i] != keys[count - 1]) keys[count++] = keys[i];
  }
  keys.resize(count);
  return keys;
}

}  // namespace

PolycubeGrid make_grid(const PatchGraph& graph, const GridOptions& options, const base::Host& host) {
  if (!(options.edge_length >= 0) || !std::isfinite(options.edge_length))
    throw base::Error("invalid-argument", "the edge length of cells must be a positive number");
  if (options.edge_length == 0 && (options.quads == 0 || static_cast<double>(options.quads) > max_quads))
    throw base::Error("invalid-argument", "the number of quads must be from 1 to 10^7");
  return GridSizes(graph, host).choose(options);
}

QuadMesh mesh_grid(const PatchGraph& graph, const PolycubeGrid& grid, const base::Host& host) {
  const Array<PatchRectangle> rectangles = rectangles_of(graph, grid.layers, host);
  std::array<Lines, 3> lines = {Lines(grid.layers[0], grid.cells[0], host.memory),
                                Lines(grid.layers[1], grid.cells[1], host.memory),
                                Lines(grid.layers[2], grid.cells[2], host.memory)};
  QuadMesh mesh(host.memory);
  Array<std::array<Key, 4>> corners(host.memory);
  Array<Key> keys(host.memory);
  for (const PatchRectangle& r : rectangles) {
    host.report(quad_mesh_phase, 0, 0);
    const auto axis = static_cast<std::size_t>(axis_of(r.label));
    const std::size_t u = first_axis(r.label), v = second_axis(r.label);
    for (Index j = lines[v].of_layer[r.second]; j < lines[v].of_layer[r.second + 1]; ++j) {
      for (Index i = lines[u].of_layer[r.first]; i < lines[u].of_layer[r.first + 1]; ++i) {
        if (corners.size() % base::items_between_reports == 0) host.report(quad_mesh_phase, 0, 0);
        std::array<Key, 4> quad{};
        constexpr std::array<std::array<Index, 2>, 4> around = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t k = 0; k < 4; ++k) {
          const auto& step = around[sign_of(r.label) > 0 ? k : (4 - k) % 4];
          quad[k][axis] = lines[axis].of_layer[r.plane];
          quad[k][u] = i + step[0];
          quad[k][v] = j + step[1];
          keys.push_back(quad[k]);
        }
        corners.push_back(quad);
        mesh.patches.push_back(Index{r.patch});
      }
    }
  }
  keys = sorted(std::move(keys), lines, host);
  for (const Key& key : keys)
    mesh.polycube.emplace_back(lines[0].at[key[0]], lines[1].at[key[1]], lines[2].at[key[2]]);
  for (std::size_t q = 0; q < corners.size(); ++q) {
    if (q % 4096 == 0) host.report(quad_mesh_phase, 0, 0);
    Quad quad{};
    for (std::size_t k = 0; k < 4; ++k)
      quad[k] = static_cast<Index>(std::lower_bound(keys.begin(), keys.end(), corners[q][k]) - keys.begin());
    mesh.quads.push_back(quad);
  }
  return mesh;
}

void sample_grid(const SurfaceMap& map, QuadMesh& mesh, const base::Host& host) {
  LocatedPoints located = locate(map, mesh.polycube, host);
  mesh.positions.clear();
  for (std::size_t i = 0; i < mesh.polycube.size(); ++i) {
    if (located.triangles[i] == no_index)
      throw base::Error("invalid-argument", "a point of the grid is in no triangle of the map");
    mesh.positions.push_back(interpolate(map, located.triangles[i], located.weights[i]));
  }
  mesh.triangles = std::move(located.triangles);
  mesh.weights = std::move(located.weights);
}

QuadQuality measure_quads(std::span<const Vector3> positions, std::span<const Quad> quads, const base::Host& host) {
  QuadQuality result;
  Array<Index> valence(positions.size(), 0, host.memory);
  base::CompensatedSum least_of_each, area;
  double largest = 0;
  result.min_scaled_jacobian = quads.empty() ? 0 : 1;
  for (std::size_t q = 0; q < quads.size(); ++q) {
    if (q % 4096 == 0) host.report(quad_mesh_phase, q, quads.size());
    const Quad& c = quads[q];
    const auto p = [&](std::size_t k) -> const Vector3& { return positions[c[k % 4]]; };
    const Vector3 normal = (p(2) - p(0)).cross(p(3) - p(1));
    const double size = normal.norm();
    double least = size > 0 ? 1 : 0;
    for (std::size_t k = 0; k < 4; ++k) {
      ++valence[c[k]];
      const Vector3 out = p(k + 1) - p(k), in = p(k + 3) - p(k);
      const double lengths = out.norm() * in.norm();
      least = std::min(least, lengths > 0 && size > 0 ? out.cross(in).dot(normal) / (lengths * size) : 0);
    }
    least_of_each.add(least);
    area.add(0.5 * size);
    largest = std::max(largest, 0.5 * size);
    result.min_scaled_jacobian = std::min(result.min_scaled_jacobian, least);
    result.not_convex += least <= 0;
  }
  for (const Index n : valence)
    result.irregular += n > 0 && n != 4;
  const auto count = static_cast<double>(std::max<std::size_t>(quads.size(), 1));
  result.mean_scaled_jacobian = least_of_each.value() / count;
  result.area_ratio = area.value() > 0 ? largest * count / area.value() : 0;
  return result;
}

}  // namespace orbicube::polycube
