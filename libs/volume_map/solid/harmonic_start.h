// Harmonic coordinates inside a mesh of tetrahedra whose boundary is given: the start of a map, which may have inverted
// tetrahedra.
#pragma once

#include "untangle/tetrahedra/block_assembly.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

// Moves the vertices that are not `held` (an entry a vertex) to the minimum of the sum of weight |J|^2 over elements,
// to 1e-8 of what the preconditioned residual was. With an engine, that solves the system.
void make_harmonic(std::span<const untangle::Element> elements, std::span<const std::uint8_t> held,
                   std::span<Vector3> positions, const base::Host& host, untangle::BlockEngine* engine = nullptr);

}  // namespace orbicube::volume_map
