#include "hexmesh/grid/integer_domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "polycube/layout/given_polycube.h"

namespace orbicube::hexmesh {
namespace {

using polycube::VoxelSolid;

constexpr double max_cells = 1e8;  // of the box

// Two planes between which columns along the axis pass from one change of inside and outside to the next, and the area
// of these columns.
struct Passage {
  std::size_t from, to;
  double area;
};

// Planes of the solid are numbered from its second: the first and the last are margins.
Array<Passage> passages_of(const VoxelSolid& solid, std::size_t axis, std::pmr::memory_resource* memory) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto width = [&](std::size_t a, int i) {
    return solid.planes(a)[static_cast<std::size_t>(i) + 1] - solid.planes(a)[static_cast<std::size_t>(i)];
  };
  const auto planes = static_cast<std::size_t>(solid.count(axis) - 1);
  Array<double> area(planes * planes, 0, memory);
  Cell cell{};
  for (cell[u] = 1; cell[u] < solid.count(u) - 1; ++cell[u]) {
    for (cell[v] = 1; cell[v] < solid.count(v) - 1; ++cell[v]) {
      bool before = false;
      int last = -1;
      for (int i = 1; i < solid.count(axis); ++i) {
        cell[axis] = i;
        const bool now = i < solid.count(axis) - 1 && solid.inside(cell);
        if (now == before) continue;
        if (last >= 0) {
          area[static_cast<std::size_t>(last) * planes + static_cast<std::size_t>(i - 1)] +=
              width(u, cell[u]) * width(v, cell[v]);
        }
        last = i - 1;
        before = now;
      }
    }
  }
  Array<Passage> result(memory);
  for (std::size_t i = 0; i < planes; ++i) {
    for (std::size_t j = i + 1; j < planes; ++j) {
      if (area[i * planes + j] > 0) result.push_back({i, j, area[i * planes + j]});
    }
  }
  return result;
}

// Integers for ascending planes, in units of a cell: rounded upwards along the axis, then ranges of them moved by one
// as long as that costs less. Passages get at least `across` cells.
Array<int> numbers_for(std::span<const double> planes, std::span<const Passage> passages, double cell_length,
                       int across, const base::Host& host) {
  const std::size_t count = planes.size();
  Array<int> numbers(count, 0, host.memory);
  for (std::size_t i = 1; i < count; ++i) {
    const double target = (planes[i] - planes[0]) / cell_length;
    numbers[i] = std::max(static_cast<int>(std::lround(target)), numbers[i - 1] + 1);
    for (const Passage& p : passages) {
      if (p.to == i) numbers[i] = std::max(numbers[i], numbers[p.from] + across);
    }
  }
  const auto cost = [&](std::span<const int> k) {
    constexpr double any_passage = 0.1;
    double sum = 0;
    for (const Passage& p : passages) {
      if (k[p.to] - k[p.from] < across) return std::numeric_limits<double>::infinity();
      const double length = (planes[p.to] - planes[p.from]) / cell_length;
      const double error = k[p.to] - k[p.from] - length;
      sum += error * error * (p.area / (cell_length * cell_length * std::max(length, 1.0)) + any_passage);
    }
    return sum;
  };
  double best = cost(numbers);
  constexpr int max_rounds = 1000;
  bool better = true;
  for (int round = 0; better && round < max_rounds; ++round) {
    better = false;
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t j = i; j < count; ++j) {
        host.report("grid", 0, 0);
        for (const int by : {-1, 1}) {
          if (by < 0 && numbers[i] - numbers[i - 1] < 2) continue;
          if (by > 0 && j + 1 < count && numbers[j + 1] - numbers[j] < 2) continue;
          for (std::size_t k = i; k <= j; ++k)
            numbers[k] += by;
          const double now = cost(numbers);
          if (now < best - 1e-9 * std::abs(best)) {
            best = now;
            better = true;
            continue;
          }
          for (std::size_t k = i; k <= j; ++k)
            numbers[k] -= by;
        }
      }
    }
  }
  return numbers;
}

}  // namespace

IntegerDomain::IntegerDomain(const PatchGraph& graph, double cell_length, const base::Host& host, int across)
    : planes_{Array<double>(host.memory), Array<double>(host.memory), Array<double>(host.memory)},
      numbers_{Array<int>(host.memory), Array<int>(host.memory), Array<int>(host.memory)},
      inside_(host.memory) {
  base::require(cell_length > 0 && std::isfinite(cell_length), "the length of cells must be positive");
  const VoxelSolid solid = polycube::solid_of(graph, host);
  double box = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto all = solid.planes(a);
    planes_[a].assign(all.begin() + 1, all.end() - 1);
    box *= (planes_[a].back() - planes_[a].front()) / cell_length + static_cast<double>(planes_[a].size());
  }
  if (!(box < max_cells)) throw base::Error("invalid-argument", "more than 10^8 cells");
  for (std::size_t a = 0; a < 3; ++a) {
    host.report("grid", a, 3);
    numbers_[a] = numbers_for(planes_[a], passages_of(solid, a, host.memory), cell_length, across, host);
    size_[a] = numbers_[a].back();
  }
  if (static_cast<double>(size_[0]) * size_[1] * size_[2] > max_cells)
    throw base::Error("invalid-argument", "more than 10^8 cells");
  inside_.assign(
      static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(size_[2]), 0);
  // The interval of planes that each cell lies in, along each axis; the solid's cells are one further.
  std::array<Array<int>, 3> interval = {Array<int>(host.memory), Array<int>(host.memory), Array<int>(host.memory)};
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i + 1 < numbers_[a].size(); ++i)
      interval[a].resize(static_cast<std::size_t>(numbers_[a][i + 1]), static_cast<int>(i) + 1);
  }
  const auto interval_of = [&](std::size_t a, int i) { return interval[a][static_cast<std::size_t>(i)]; };
  Cell c{};
  for (c[0] = 0; c[0] < size_[0]; ++c[0]) {
    for (c[1] = 0; c[1] < size_[1]; ++c[1]) {
      host.report("grid", 0, 0);
      for (c[2] = 0; c[2] < size_[2]; ++c[2]) {
        const bool in = solid.inside(Cell{interval_of(0, c[0]), interval_of(1, c[1]), interval_of(2, c[2])});
        inside_[index(c)] = in;
        cells_ += in;
      }
    }
  }
  for (c[0] = 0; c[0] < size_[0]; ++c[0]) {
    for (c[1] = 0; c[1] < size_[1]; ++c[1]) {
      host.report("grid", 0, 0);
      for (c[2] = 0; c[2] < size_[2]; ++c[2]) {
        if (!inside(c)) continue;
        for (std::size_t a = 0; a < 3; ++a) {
          for (const int by : {-1, 1}) {
            Cell beside = c;
            beside[a] += by;
            faces_ += !inside(beside);
          }
        }
      }
    }
  }
}

Vector3 IntegerDomain::place(const Vector3& p) const {
  Vector3 result;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& planes = planes_[a];
    const double x = p[static_cast<Eigen::Index>(a)];
    const auto above = std::upper_bound(planes.begin(), planes.end(), x);
    const auto last = static_cast<std::ptrdiff_t>(planes.size()) - 2;
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - planes.begin() - 1, 0, last));
    const double part = (x - planes[i]) / (planes[i + 1] - planes[i]);
    // Exact at both ends.
    result[static_cast<Eigen::Index>(a)] = numbers_[a][i] * (1 - part) + numbers_[a][i + 1] * part;
  }
  return result;
}

IntegerDomain domain_of_cells(const PatchGraph& graph, std::size_t cells, double padded, const base::Host& host,
                              int across) {
  const VoxelSolid solid = polycube::solid_of(graph, host);
  double volume = 0;
  for (std::size_t i = 0; i < solid.size(); ++i) {
    if (!solid.inside(i)) continue;
    const Cell c = solid.cell(i);
    volume += (solid.position({c[0] + 1, c[1] + 1, c[2] + 1}) - solid.position(c)).prod();
  }
  // The number falls with the length but for rounding: halving, then the best that was met.
  const auto target = static_cast<double>(cells);
  double length = std::cbrt(volume / target), low = 0, high = 0;
  IntegerDomain best(graph, length, host, across);
  const auto count = [&](const IntegerDomain& d) {
    return static_cast<double>(d.cells()) + padded * static_cast<double>(d.faces());
  };
  const auto error = [&](const IntegerDomain& d) { return std::abs(std::log(count(d) / target)); };
  for (int k = 0; k < 14; ++k) {
    const IntegerDomain now(graph, length, host, across);
    if (error(now) < error(best)) best = now;
    (count(now) > target ? low : high) = length;
    if (low == 0)
      length *= 0.8;
    else if (high == 0)
      length *= 1.25;
    else
      length = 0.5 * (low + high);
  }
  return best;
}

}  // namespace orbicube::hexmesh
