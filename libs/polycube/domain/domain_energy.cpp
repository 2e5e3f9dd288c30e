#include "polycube/domain/domain_energy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/infinity.h"
#include "mesh/topology/degenerate_triangles.h"
#include "polycube/surface/distortion.h"

namespace orbicube::polycube {
namespace {

constexpr const char* domain_energy_phase = "domain energy";
constexpr std::uint64_t across_layers = std::numeric_limits<std::uint64_t>::max();

double area_of(const std::array<std::array<double, 2>, 3>& p) {
  return 0.5 * ((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]));
}

// The part of the harmonic energy that one coordinate has.
double harmonic_of(const std::array<double, 3>& cotangents, const std::array<std::array<double, 2>, 3>& p,
                   std::size_t coordinate) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = p[(k + 1) % 3][coordinate] - p[(k + 2) % 3][coordinate];
    sum += cotangents[k] * side * side;
  }
  return sum;
}

}  // namespace

// What is known of triangles before their cells are.
struct DomainEnergy::Triangles {
  explicit Triangles(std::pmr::memory_resource* memory) : by_cell(memory), areas(memory) {}

  Array<std::pair<std::uint64_t, Index>> by_cell;  // the cell's key or across_layers, and the triangle; sorted
  Array<double> areas;                             // in space; 0 of degenerate ones
  std::size_t counted = 0;                         // triangles that are not degenerate
};

DomainEnergy::DomainEnergy(const SurfaceMap& map, const CoordinateLayers& layers, DomainMeasure measure,
                           double area_weight, const base::Host& host)
    : measure_(measure),
      area_weight_(area_weight),
      lengths_(host.memory),
      cells_(host.memory),
      crossing_(host.memory),
      start_(layers.intervals(), 0.0, host.memory),
      on_start_(layers.intervals(), 0.0, host.memory) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Array<double>& along = layers.positions[axis];
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
      lengths_.push_back(along[i + 1] - along[i]);
    axis_start_[axis + 1] = lengths_.size();
  }
  place(lengths_);
  add_triangles(map, layers, find_cells(map, layers, host), host);
}

// Triangles with the cell they are in, ordered by cell.
DomainEnergy::Triangles DomainEnergy::find_cells(const SurfaceMap& map, const CoordinateLayers& layers,
                                                 const base::Host& host) {
  Triangles found(host.memory);
  Array<double>& areas = found.areas;
  areas.resize(map.triangles.size());
  const double rounding = rounding_of_input(map);
  for (Index t = 0; t < map.triangles.size(); ++t) {
    if (t % 4096 == 0) host.report(domain_energy_phase, t, 2 * map.triangles.size());
    const auto& [a, b, c] = map.triangles[t];
    areas[t] = 0.5 * (map.positions[b] - map.positions[a]).cross(map.positions[c] - map.positions[a]).norm();
    if (mesh::is_degenerate(map.positions[a], map.positions[b], map.positions[c], rounding)) areas[t] = 0;
    surface_area_ += areas[t];
    found.counted += areas[t] > 0;
    const auto axis = static_cast<std::size_t>(axis_of(map.labels[t]));
    std::uint64_t key = axis;
    bool within = true;
    for (const std::size_t along : {(axis + 1) % 3, (axis + 2) % 3}) {
      const auto place = [&](Index v) { return layers.places[v][along]; };
      const Index least = std::min({place(a).layer, place(b).layer, place(c).layer});
      for (const Index v : {a, b, c})
        within = within && (place(v).layer == least || (place(v).layer == least + 1 && place(v).fraction == 0));
      key = key * lengths_.size() + axis_start_[along] + least;
    }
    found.by_cell.emplace_back(within ? key : across_layers, t);
  }
  std::sort(found.by_cell.begin(), found.by_cell.end());
  return found;
}

DomainEnergy::Crossing DomainEnergy::crossing(const SurfaceMap& map, const CoordinateLayers& layers, Index t,
                                              double area, double weight) const {
  const std::size_t axis = static_cast<std::size_t>(axis_of(map.labels[t]));
  const std::array<std::size_t, 2> along = {(axis + 1) % 3, (axis + 2) % 3};
  Crossing triangle{};
  triangle.area = area;
  if (area > 0) triangle.weight = weight;
  for (std::size_t k = 0; k < 3; ++k) {
    // Seen from outside the corners go round counter-clockwise.
    const std::size_t at = sign_of(map.labels[t]) > 0 ? k : 2 - k;
    const Index v = map.triangles[t][at], next = map.triangles[t][(at + 1) % 3],
                previous = map.triangles[t][(at + 2) % 3];
    if (area > 0)
      triangle.cotangents[k] =
          (map.positions[next] - map.positions[v]).dot(map.positions[previous] - map.positions[v]) / (8 * area);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [layer, fraction] = layers.places[v][along[i]];
      const bool end = layer == layers.intervals(along[i]);
      triangle.corner[k].interval[i] = axis_start_[along[i]] + layer - (end ? 1 : 0);
      triangle.corner[k].fraction[i] = end ? 1 : fraction;
    }
  }
  return triangle;
}

void DomainEnergy::add_triangles(const SurfaceMap& map, const CoordinateLayers& layers, const Triangles& found,
                                 const base::Host& host) {
  const std::uint64_t all = lengths_.size();
  std::uint64_t last = across_layers;
  std::size_t done = found.by_cell.size();
  for (const auto& [key, t] : found.by_cell) {
    if (done++ % 4096 == 0) host.report(domain_energy_phase, done, 2 * map.triangles.size());
    const double area = found.areas[t];
    const Crossing triangle =
        crossing(map, layers, t, area,
                 measure_ == DomainMeasure::face_mean ? 1 / static_cast<double>(found.counted) : area / surface_area_);
    if (key == across_layers) {
      if (flat(triangle, lengths_).area > 0) crossing_.push_back(triangle);
      continue;
    }
    if (cells_.empty() || key != last) {
      const std::uint64_t second = key % all, first = key / all % all;
      cells_.push_back({.first = static_cast<std::size_t>(first), .second = static_cast<std::size_t>(second)});
      last = key;
    }
    cells_.back().add(triangle);
  }
}

void DomainEnergy::Cell::add(const Crossing& triangle) {
  // Within a cell of unit lengths.
  std::array<std::array<double, 2>, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t from = i == 0 ? first : second;
      at[k][i] = triangle.corner[k].fraction[i] + (triangle.corner[k].interval[i] == from ? 0 : 1);
    }
  }
  const double flat_area = area_of(at);
  if (!(flat_area > 0)) return;
  const double along_first = harmonic_of(triangle.cotangents, at, 0),
               along_second = harmonic_of(triangle.cotangents, at, 1);
  whole += flat_area;
  if (!(triangle.area > 0)) return;
  area += flat_area;
  angle_first += triangle.weight * along_first / flat_area;
  angle_second += triangle.weight * along_second / flat_area;
  ratio += triangle.weight * flat_area / triangle.area;
  inverse += triangle.weight * triangle.area / flat_area;
  harmonic_first += along_first;
  harmonic_second += along_second;
  stretch += flat_area * flat_area / triangle.area;
}

void DomainEnergy::place(std::span<const double> lengths) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double at = 0;
    for (std::size_t i = axis_start_[axis]; i < axis_start_[axis + 1]; ++i) {
      start_[i] = at;
      at += lengths[i];
    }
  }
}

DomainEnergy::Flat DomainEnergy::flat(const Crossing& triangle, std::span<const double> lengths) const {
  Flat result{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t interval = triangle.corner[k].interval[i];
      result.at[k][i] = start_[interval] + triangle.corner[k].fraction[i] * lengths[interval];
    }
  }
  result.area = area_of(result.at);
  result.harmonic = harmonic_of(triangle.cotangents, result.at, 0) + harmonic_of(triangle.cotangents, result.at, 1);
  return result;
}

DomainEnergy::Totals DomainEnergy::totals(std::span<const double> lengths) const {
  place(lengths);
  Totals sum;
  for (const Cell& cell : cells_) {
    const double u = lengths[cell.first], v = lengths[cell.second];
    sum.whole += cell.whole * (u * v);
    sum.area += cell.area * (u * v);
    sum.angle += cell.angle_first * (u / v) + cell.angle_second * (v / u);
    sum.ratio += cell.ratio * (u * v);
    sum.inverse += cell.inverse / (u * v);
    sum.harmonic += cell.harmonic_first * (u * u) + cell.harmonic_second * (v * v);
    sum.stretch += cell.stretch * (u * v) * (u * v);
  }
  for (const Crossing& triangle : crossing_) {
    const Flat f = flat(triangle, lengths);
    if (!(f.area > 0)) return {.area = base::infinity};
    sum.whole += f.area;
    if (!(triangle.area > 0)) continue;
    sum.area += f.area;
    sum.angle += triangle.weight * f.harmonic / f.area;
    sum.ratio += triangle.weight * f.area / triangle.area;
    sum.inverse += triangle.weight * triangle.area / f.area;
    sum.harmonic += f.harmonic;
    sum.stretch += f.area * f.area / triangle.area;
  }
  return sum;
}

double DomainEnergy::energy(const Totals& t) const {
  if (!std::isfinite(t.area)) return base::infinity;
  const double scale = surface_area_ / t.area;  // of areas on the polycube
  if (measure_ == DomainMeasure::harmonic)
    return (t.harmonic * scale + area_weight_ * t.stretch * scale * scale) / surface_area_;
  return t.angle + area_weight_ / 2 * (t.ratio * scale + t.inverse / scale);
}

DomainEnergy::Totals DomainEnergy::slopes(const Totals& t) const {
  const double scale = surface_area_ / t.area, by_area = -scale / t.area;
  Totals slope;
  if (measure_ == DomainMeasure::harmonic) {
    slope.harmonic = scale / surface_area_;
    slope.stretch = area_weight_ * scale * scale / surface_area_;
    slope.area = (t.harmonic + area_weight_ * t.stretch * 2 * scale) / surface_area_ * by_area;
  } else {
    slope.angle = 1;
    slope.ratio = area_weight_ / 2 * scale;
    slope.inverse = area_weight_ / 2 / scale;
    slope.area = area_weight_ / 2 * (t.ratio - t.inverse / (scale * scale)) * by_area;
  }
  return slope;
}

double DomainEnergy::evaluate(std::span<const double> lengths, std::span<double> gradient) const {
  const Totals sums = totals(lengths);
  const double value = energy(sums);
  if (std::isfinite(value) && !gradient.empty()) add_gradient(slopes(sums), lengths, gradient);
  return value;
}

void DomainEnergy::add_gradient(const Totals& slope, std::span<const double> lengths,
                                std::span<double> gradient) const {
  std::fill(gradient.begin(), gradient.end(), 0.0);
  std::fill(on_start_.begin(), on_start_.end(), 0.0);
  for (const Cell& cell : cells_) {
    const double u = lengths[cell.first], v = lengths[cell.second], uv = u * v;
    // Along both at once: what depends on u v alone.
    const double product = slope.area * cell.area + slope.ratio * cell.ratio -
                           slope.inverse * cell.inverse / (uv * uv) + 2 * slope.stretch * cell.stretch * uv;
    const double shape = slope.angle * (cell.angle_first / v - cell.angle_second * v / (u * u));
    gradient[cell.first] += product * v + shape + 2 * slope.harmonic * cell.harmonic_first * u;
    gradient[cell.second] += product * u - shape * u / v + 2 * slope.harmonic * cell.harmonic_second * v;
  }
  for (const Crossing& triangle : crossing_) {
    if (!(triangle.area > 0)) continue;
    const Flat f = flat(triangle, lengths);
    const double by_harmonic = slope.angle * triangle.weight / f.area + slope.harmonic;
    const double by_area = slope.area + (-slope.angle * triangle.weight * f.harmonic / (f.area * f.area) +
                                         slope.ratio * triangle.weight / triangle.area -
                                         slope.inverse * triangle.weight * triangle.area / (f.area * f.area) +
                                         slope.stretch * 2 * f.area / triangle.area);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3, previous = (k + 2) % 3;
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t other = 1 - i;
        const double turn = (i == 0 ? 0.5 : -0.5) * (f.at[next][other] - f.at[previous][other]);
        const double pull = 2 * (triangle.cotangents[previous] * (f.at[k][i] - f.at[next][i]) +
                                 triangle.cotangents[next] * (f.at[k][i] - f.at[previous][i]));
        const double along = by_area * turn + by_harmonic * pull;
        const std::size_t interval = triangle.corner[k].interval[i];
        on_start_[interval] += along;
        gradient[interval] += along * triangle.corner[k].fraction[i];
      }
    }
  }
  // An interval begins where those before it end.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double behind = 0;
    for (std::size_t i = axis_start_[axis + 1]; i-- > axis_start_[axis];) {
      gradient[i] += behind;
      behind += on_start_[i];
    }
  }
}

}  // namespace orbicube::polycube
