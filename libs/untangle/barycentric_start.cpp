#include "untangle/barycentric_start.h"

#include <algorithm>
#include <array>
#include <utility>

#include "linear/iterative/iterative_solver.h"

namespace orbicube::untangle {
namespace {

// Of a start, in relation to the number of edges at a vertex: what is connected to nothing fixed stays in place.
constexpr double anchor = 1e-8;
constexpr double tolerance = 1e-10, max_residual = 1e-6;

using EdgeEnds = std::pair<Index, Index>;

template <class Element>
Array<EdgeEnds> edges_of(std::span<const Element> elements, const base::Host& host) {
  Array<EdgeEnds> edges(host.memory);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i % 8192 == 0) host.report("start", 0, 0);
    const Element& e = elements[i];
    for (std::size_t k = 1; k < e.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        edges.emplace_back(std::min(e[k], e[l]), std::max(e[k], e[l]));
  }
  host.report("start", 0, 0);
  std::sort(edges.begin(), edges.end());
  host.report("start", 0, 0);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The Laplacian of the graph of edges, by variables, and identity up to a multiple of `block` rows: its lower triangle
// by rows.
struct Laplacian {
  Array<std::size_t> row_begin;
  Array<Index> columns;
  Array<double> entries, right;

  Laplacian(std::span<const EdgeEnds> edges, const Variables& variables, std::span<const double> values, int block,
            const base::Host& host)
      : row_begin(variables.free() + 1, 0, host.memory),
        columns(host.memory),
        entries(host.memory),
        right(variables.free(), 0, host.memory) {
    const std::size_t free = variables.free();
    Array<EdgeEnds> below(host.memory);  // row, column; one for each edge that joins them
    Array<double> degree(free, 0, host.memory);
    for (const auto& [a, b] : edges) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Index i = variables.of(a, axis), j = variables.of(b, axis);
        if (i == j) continue;
        if (i < free) degree[i] += 1;
        if (j < free) degree[j] += 1;
        if (i < free && j < free)
          below.emplace_back(std::max(i, j), std::min(i, j));
        else if (i < free)
          right[i] += values[j];
        else if (j < free)
          right[j] += values[i];
      }
    }
    host.report("start", 0, 0);
    std::sort(below.begin(), below.end());
    host.report("start", 0, 0);
    std::size_t k = 0;
    for (Index row = 0; row < free; ++row) {
      while (k < below.size() && below[k].first == row) {
        const Index column = below[k].second;
        columns.push_back(column);
        entries.push_back(0);
        for (; k < below.size() && below[k].first == row && below[k].second == column; ++k)
          entries.back() -= 1;
      }
      columns.push_back(row);
      entries.push_back((1 + anchor) * degree[row] + (degree[row] > 0 ? 0 : 1));
      right[row] += degree[row] > 0 ? anchor * degree[row] * values[row] : values[row];
      row_begin[row + 1] = columns.size();
    }
    while (right.size() % static_cast<std::size_t>(block) != 0) {
      columns.push_back(static_cast<Index>(right.size()));
      entries.push_back(1);
      right.push_back(0);
      row_begin.push_back(columns.size());
    }
  }
};

template <class Element>
bool start(std::span<const Element> elements, const Variables& variables, std::span<double> values,
           const base::Host& host) {
  if (variables.free() == 0 || variables.free() == variables.size()) return false;
  // Blocks of the size that steps of the method have, too: one kind of solver in a program that has no triangles.
  constexpr int block = std::tuple_size_v<Element> == 4 ? 3 : 1;
  const Laplacian laplacian(edges_of(elements, host), variables, values, block, host);
  const auto solver = linear::make_block_solver<block>({laplacian.row_begin, laplacian.columns, laplacian.entries},
                                                       linear::IterativeMethod::automatic, host);
  Array<double> solution(laplacian.right.size(), 0, host.memory);
  if (!(solver->solve(laplacian.right, {.tolerance = tolerance}, solution).residual <= max_residual)) return false;
  std::copy_n(solution.begin(), variables.free(), values.begin());
  return true;
}

}  // namespace

bool start_barycentric(std::span<const Triangle> triangles, const Variables& variables, std::span<double> values,
                       const base::Host& host) {
  return start(triangles, variables, values, host);
}

bool start_barycentric(std::span<const Tetrahedron> tetrahedra, const Variables& variables, std::span<double> values,
                       const base::Host& host) {
  return start(tetrahedra, variables, values, host);
}

}  // namespace orbicube::untangle
