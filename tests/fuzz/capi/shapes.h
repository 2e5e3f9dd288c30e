// Small surfaces and solids for fuzz targets, most of them with a fault.
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "entries.h"
#include "orbicube/mesh.h"

namespace fuzz {

struct Shape {
  std::vector<double> positions;
  std::vector<std::uint32_t> cells;  // three or four vertices each
  std::size_t corners = 3;

  std::size_t vertex_count() const { return positions.size() / 3; }
  std::size_t cell_count() const { return cells.size() / corners; }
  obc_surface surface() const { return {positions.data(), vertex_count(), cells.data(), cell_count()}; }
};

// Splits each triangle into four, with the new vertices in the middle of the edges.
inline Shape refined(const Shape& from) {
  Shape result{from.positions, {}, 3};
  std::vector<std::pair<std::array<std::uint32_t, 2>, std::uint32_t>> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const std::array<std::uint32_t, 2> edge = {std::min(a, b), std::max(a, b)};
    for (const auto& [known, vertex] : middles) {
      if (known == edge) return vertex;
    }
    const auto vertex = static_cast<std::uint32_t>(result.vertex_count());
    for (std::size_t k = 0; k < 3; ++k)
      result.positions.push_back((from.positions[3 * a + k] + from.positions[3 * b + k]) / 2);
    middles.push_back({edge, vertex});
    return vertex;
  };
  for (std::size_t t = 0; t < from.cell_count(); ++t) {
    const std::uint32_t a = from.cells[3 * t], b = from.cells[3 * t + 1], c = from.cells[3 * t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::uint32_t v : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca})
      result.cells.push_back(v);
  }
  return result;
}

inline Shape torus(std::uint32_t around, std::uint32_t across) {
  Shape result;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = 6.283185307179586 * i / around, v = 6.283185307179586 * j / across;
      for (const double x : {(2 + std::cos(v)) * std::cos(u), (2 + std::cos(v)) * std::sin(u), std::sin(v)})
        result.positions.push_back(x);
      const std::uint32_t a = i * across + j, b = (i + 1) % around * across + j, c = i * across + (j + 1) % across,
                          d = (i + 1) % around * across + (j + 1) % across;
      for (const std::uint32_t w : {a, b, d, a, d, c})
        result.cells.push_back(w);
    }
  }
  return result;
}

// One, two or four faults, or none.
inline void spoil(Shape& shape, Input& input) {
  const std::size_t faults = input.below(5);
  for (std::size_t i = 0; i < faults && !shape.cells.empty(); ++i) {
    const std::size_t cell = input.bits() % shape.cell_count(),
                      corner = shape.corners * cell + input.below(shape.corners);
    switch (input.below(8)) {
      case 0:
        shape.positions[input.bits() % shape.positions.size()] = input.number();
        break;
      case 1:
        shape.cells[corner] = input.index(shape.vertex_count());
        break;
      case 2:
        std::swap(shape.cells[shape.corners * cell], shape.cells[shape.corners * cell + 1]);
        break;
      case 3:
        shape.cells.resize(shape.cells.size() - shape.corners);
        break;
      case 4:
        for (std::size_t k = 0; k < shape.corners; ++k)
          shape.cells.push_back(shape.cells[shape.corners * cell + k]);
        break;
      case 5: {
        const double scale = input.number();
        for (double& x : shape.positions)
          x *= scale;
        break;
      }
      case 6: {  // one vertex onto another
        const std::size_t a = input.bits() % shape.vertex_count(), b = input.bits() % shape.vertex_count();
        std::copy_n(shape.positions.begin() + static_cast<std::ptrdiff_t>(3 * a), 3,
                    shape.positions.begin() + static_cast<std::ptrdiff_t>(3 * b));
        break;
      }
      default:
        shape.positions.insert(shape.positions.end(), {input.number(), input.number(), input.number()});
    }
  }
}

// Closed surfaces of some triangles, shaken, then spoiled.
inline Shape surface(Input& input, bool may_spoil = true) {
  Shape shape;
  switch (input.below(4)) {
    case 0:
      shape = {{1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 3};
      break;
    case 1:
      shape = {{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
               {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5},
               3};
      break;
    case 2:
      shape = {
          {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 0, 0, 2, 2, 0, 2, 0, 2, 2, 2, 2, 2},
          {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5},
          3};
      break;
    default:
      shape = torus(5, 4);
  }
  if (input.one_in(3)) shape = refined(shape);
  if (input.one_in(2)) {
    for (double& x : shape.positions)
      x += input.moderate() / 16;
  }
  if (may_spoil) spoil(shape, input);
  return shape;
}

// Cubes of six tetrahedra each, in a row; shaken, then spoiled.
inline Shape solid(Input& input, bool may_spoil = true) {
  Shape shape;
  shape.corners = 4;
  const std::size_t cubes = 1 + input.below(3);
  for (std::size_t i = 0; i <= cubes; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (const double x : {double(i), double(j & 1), double(j >> 1)})
        shape.positions.push_back(x);
    }
  }
  static constexpr std::uint32_t cube[] = {0, 4, 5, 7, 0, 5, 1, 7, 0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7};
  for (std::uint32_t i = 0; i < cubes; ++i) {
    for (const std::uint32_t v : cube)
      shape.cells.push_back(4 * i + v);
  }
  if (input.one_in(2)) {
    for (double& x : shape.positions)
      x += input.moderate() / 16;
  }
  if (may_spoil) spoil(shape, input);
  return shape;
}

}  // namespace fuzz
