// The elements of energies of hexahedra: the tetrahedra at their corners, weighted by how bad these are.
#pragma once

#include <algorithm>
#include <utility>

#include "hexmesh/certificate/hex_tetrahedra.h"

namespace orbicube::hexmesh {

// The lengths that each hexahedron should have along its three directions.
using BoxSizes = Array<std::array<double, 3>>;

// The mean lengths that a hexahedron has along its directions, not too far from the given ones. A box of these is a
// target shape that leaves lengths as they are: the scaled Jacobian does not depend on them.
std::array<double, 3> own_lengths(const HexMesh& mesh, Index hexahedron, const std::array<double, 3>& given);

// The corner tetrahedra of the chosen hexahedra, eight each, those of boxes of the given sizes.
Array<Element> corner_elements(const HexMesh& mesh, std::span<const Index> chosen, const BoxSizes& sizes,
                               const base::Host& host);

// Weighs corners by the square of how many times worse than good they are, between 1 and `most`.
void weigh_corners(std::span<const Vector3> positions, double most, Array<Element>& corners);

// For searches: the scaled Jacobian, or less where the determinant may not be positive between good corners.
double searched_quality(std::span<const Vector3> positions, const Hexahedron& hexahedron);
// The minimum of the chosen ones, at most 1.
double worst_searched_quality(const HexMesh& mesh, std::span<const Index> chosen);

// The vertices of the worst hexahedra, at most `most` of those that `rated` has with their quality, ascending.
Array<Index> vertices_of_worst(std::span<const Hexahedron> hexahedra, Array<std::pair<double, Index>> rated,
                               std::size_t most);

}  // namespace orbicube::hexmesh
