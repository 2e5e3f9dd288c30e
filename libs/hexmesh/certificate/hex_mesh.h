// Meshes of hexahedra with what is known of their boundary, and how good they are.
#pragma once

#include <array>
#include <span>

#include "base/host.h"
#include "hexmesh/types.h"

namespace orbicube::hexmesh {

using mesh::Hexahedron;
using Quad = std::array<Index, 4>;

struct HexMesh {
  explicit HexMesh(std::pmr::memory_resource* memory)
      : positions(memory), hexahedra(memory), quads(memory), quad_patches(memory) {}

  Array<Vector3> positions;
  Array<Hexahedron> hexahedra;
  // The boundary, counter-clockwise seen from outside, and of each quad the patch of the polycube that it lies on.
  Array<Quad> quads;
  Array<Index> quad_patches;
};

// Two triangles for each quad, beside each other.
Array<mesh::Triangle> halves_of(std::span<const Quad> quads, std::pmr::memory_resource* memory);

// Three neighbors of each corner, whose edges have a positive determinant in a good hexahedron.
inline constexpr std::array<std::array<std::uint8_t, 3>, 8> corner_neighbors = {
    {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
// The edges along each of the three directions.
inline constexpr std::array<std::array<std::array<std::uint8_t, 2>, 4>, 3> edges_along = {
    {{{{0, 1}, {3, 2}, {4, 5}, {7, 6}}}, {{{1, 2}, {0, 3}, {5, 6}, {4, 7}}}, {{{0, 4}, {1, 5}, {2, 6}, {3, 7}}}}};
// Faces, counter-clockwise seen from outside.
inline constexpr std::array<std::array<std::uint8_t, 4>, 6> hexahedron_faces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

// det of the three edges at a corner over the product of their lengths; 1 for a box.
double corner_jacobian(std::span<const Vector3> positions, const Hexahedron& h, std::size_t corner);
// The minimum of the eight.
double scaled_jacobian(std::span<const Vector3> positions, const Hexahedron& h);

// The determinant of the trilinear map as a polynomial of degree 2 in each parameter, in Bernstein form; the first
// parameter is the fastest index. The polynomial lies between the minimum and the largest coefficient.
std::array<double, 27> bezier_coefficients(std::span<const Vector3> positions, const Hexahedron& h);
// The minimum coefficient over the product of the longest edges along the three parameters: for searches.
double min_bezier(std::span<const Vector3> positions, const Hexahedron& h);
// Whether the determinant is certainly positive everywhere, rounding included: by the coefficients of the whole, or of
// its parts, halved until they tell.
bool certainly_positive(std::span<const Vector3> positions, const Hexahedron& h);

struct HexQuality {
  double min_scaled_jacobian = 1, mean_scaled_jacobian = 0;
  std::size_t inverted = 0;   // with a corner that is not positive, by exact signs
  std::size_t uncertain = 0;  // others whose trilinear map is not certainly positive
  Index first_bad = no_index;
  double volume = 0;  // of the trilinear cells
  // Pairs of boundary quads that intersect (mesh/search/intersections.h), boundary components on the wrong side of
  // others, and a position where the first of them is: without any, positive hexahedra do not lie over each other
  // anywhere.
  std::size_t intersections = 0, misplaced_parts = 0;
  Vector3 first_intersection = Vector3::Zero();
  bool positive() const { return inverted + uncertain == 0; }
  bool valid() const { return positive() && intersections + misplaced_parts == 0; }
};

HexQuality measure_hexahedra(std::span<const Vector3> positions, std::span<const Hexahedron> hexahedra,
                             const base::Host& host);

}  // namespace orbicube::hexmesh
