#include "mesh/shapes/subdivision_surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbicube::mesh {
namespace {

constexpr const char* subdivision_surface_phase = "making the shape";

// The four points from which a value between them is interpolated, and their weights (Lagrange).
struct Stencil {
  std::size_t first;
  std::array<double, 4> weight;
};

Stencil stencil(double x, std::size_t cells) {
  const auto cell = static_cast<std::size_t>(x);
  const std::size_t first = std::min(cell == 0 ? 0 : cell - 1, cells - 3);
  const double s = x - static_cast<double>(first);
  return {first,
          {(1 - s) * (2 - s) * (3 - s) / 6, s * (2 - s) * (3 - s) / 2, s * (s - 1) * (3 - s) / 2,
           s * (s - 1) * (s - 2) / 6}};
}

}  // namespace

SubdivisionSurface::SubdivisionSurface(const QuadComplex& control, int levels, const base::Host& host)
    : levels_(levels),
      cells_(std::size_t{1} << static_cast<unsigned>(levels)),
      points_(control.corners.begin(), control.corners.end(), host.memory),
      vertex_(host.memory),
      twin_(host.memory),
      edge_(host.memory),
      grid_((cells_ + 1) * (cells_ + 1), host.memory) {
  for (const Quad& quad : control.quads)
    vertex_.insert(vertex_.end(), quad.begin(), quad.end());
  const std::vector<Index> twins = twins_of(control);
  twin_.assign(twins.begin(), twins.end());
  edge_.resize(twin_.size());
  for (Index h = 0; h < twin_.size(); ++h) {
    if (h < twin_[h]) edge_[h] = edge_[twin_[h]] = static_cast<Index>(edge_count_++);
  }
  for (int level = 0; level < levels; ++level)
    refine(host);
}

void SubdivisionSurface::refine(const base::Host& host) {
  const auto half_edges = static_cast<Index>(vertex_.size());
  const auto vertices = static_cast<Index>(points_.size());
  const Index faces = half_edges / 4;
  const Index edge_points = vertices + faces;
  const auto edges = static_cast<Index>(edge_count_);

  const auto for_half_edges = [&](const auto& body) {
    for (Index h = 0; h < half_edges; ++h) {
      if (h % base::items_between_reports == 0) host.report(subdivision_surface_phase, 0, 0);
      body(h);
    }
  };
  Array<Vector3> points(std::size_t{edge_points} + edges, Vector3::Zero(), host.memory);
  for_half_edges([&](Index h) { points[vertices + h / 4] += 0.25 * points_[vertex_[h]]; });
  for_half_edges(
      [&](Index h) { points[edge_points + edge_[h]] += 0.25 * (points_[vertex_[h]] + points[vertices + h / 4]); });
  Array<Index> valence(vertices, 0, host.memory);
  for_half_edges([&](Index h) { ++valence[vertex_[h]]; });
  for_half_edges([&](Index h) {
    const double n = valence[vertex_[h]];
    points[vertex_[h]] +=
        (4 * points[edge_points + edge_[h]] - points[vertices + h / 4] + (n - 3) * points_[vertex_[h]]) / (n * n);
  });

  const std::size_t refined = 4 * std::size_t{half_edges};
  Array<Index> vertex(refined, host.memory);
  Array<Index> twin(refined, host.memory);
  Array<Index> edge(refined, host.memory);
  const auto half_of_edge = [&](Index h, bool start) { return 2 * edge_[h] + ((h > twin_[h]) == start ? 0 : 1); };
  for_half_edges([&](Index h) {
    const Index previous = previous_in_quad(h);
    const std::size_t r = 4 * std::size_t{h};
    vertex[r] = vertex_[h];
    vertex[r + 1] = edge_points + edge_[h];
    vertex[r + 2] = vertices + h / 4;
    vertex[r + 3] = edge_points + edge_[previous];
    twin[r] = 4 * next_in_quad(twin_[h]) + 3;
    twin[r + 1] = 4 * next_in_quad(h) + 2;
    twin[r + 2] = 4 * previous + 1;
    twin[r + 3] = 4 * twin_[previous];
    edge[r] = half_of_edge(h, true);
    edge[r + 1] = 2 * edges + h;
    edge[r + 2] = 2 * edges + previous;
    edge[r + 3] = half_of_edge(previous, false);
  });
  points_.swap(points);
  vertex_.swap(vertex);
  twin_.swap(twin);
  edge_.swap(edge);
  edge_count_ = 2 * std::size_t{edges} + half_edges;
}

// The face has refined children, one a corner. Each starts at its corner; its first side lies along the half-edge from
// there, its last along the half-edge to there.
void SubdivisionSurface::fill(Index face, int level, std::size_t corner, std::ptrdiff_t along_first_side,
                              std::ptrdiff_t along_last_side) {
  const std::ptrdiff_t length = std::ptrdiff_t{1} << static_cast<unsigned>(level);
  const std::array<std::ptrdiff_t, 4> along = {along_first_side, along_last_side, -along_first_side, -along_last_side};
  std::size_t at = corner;
  for (Index k = 0; k < 4; ++k) {
    if (level == 0) {
      grid_[at] = points_[vertex_[4 * std::size_t{face} + k]];
    } else {
      fill(4 * face + k, level - 1, at, along[k], along[(k + 1) % 4]);
    }
    at += static_cast<std::size_t>(along[k] * length);
  }
}

void SubdivisionSurface::select(std::size_t quad) {
  fill(static_cast<Index>(quad), levels_, 0, 1, static_cast<std::ptrdiff_t>(cells_ + 1));
}

Vector3 SubdivisionSurface::at(double u, double v) const {
  const Stencil columns = stencil(u * static_cast<double>(cells_), cells_);
  const Stencil rows = stencil(v * static_cast<double>(cells_), cells_);
  Vector3 sum = Vector3::Zero();
  for (std::size_t j = 0; j < 4; ++j) {
    const Vector3* row = grid_.data() + (rows.first + j) * (cells_ + 1) + columns.first;
    Vector3 on_row = Vector3::Zero();
    for (std::size_t i = 0; i < 4; ++i)
      on_row += columns.weight[i] * row[i];
    sum += rows.weight[j] * on_row;
  }
  return sum;
}

std::vector<double> SubdivisionSurface::side_lengths(const base::Host& host) {
  const std::size_t width = cells_ + 1;
  const std::array<std::size_t, 4> start = {0, cells_, width * width - 1, width * cells_};
  const std::array<std::ptrdiff_t, 4> step = {1, static_cast<std::ptrdiff_t>(width), -1,
                                              -static_cast<std::ptrdiff_t>(width)};
  std::vector<double> lengths;
  const std::size_t quads = vertex_.size() / 4 / (cells_ * cells_);
  for (std::size_t q = 0; q < quads; ++q) {
    host.report(subdivision_surface_phase, q, quads);
    select(q);
    for (std::size_t side = 0; side < 4; ++side) {
      double sum = 0;
      std::size_t at = start[side];
      for (std::size_t i = 0; i < cells_; ++i) {
        const std::size_t to = at + static_cast<std::size_t>(step[side]);
        sum += (grid_[to] - grid_[at]).norm();
        at = to;
      }
      lengths.push_back(sum);
    }
  }
  return lengths;
}

}  // namespace orbicube::mesh
