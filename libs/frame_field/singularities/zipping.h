// Rearranges singular edges by changing the matchings of single faces (Li, Liu, Xu, Wang and Guo 2012, "All-hex meshing
// using singularity-restricted field"): a rotation of the cube that is put into the matching of a face multiplies what
// is around its three edges. So a third turn is zipped apart into two quarter turns, a loop around a face vanishes, and
// a curve that goes along two edges of a face takes the third.
//
// Each change is the one that is worth most at its face: edges cost more the less hexahedra can lie around them, and
// more where the axis of their rotation is not along them; inner vertices cost where no hexahedral mesh has such
// edges; the face costs what the frames on its sides would differ by. Frames are left alone: a field that has the new
// matchings is found afterwards (region_relaxation.h).
#pragma once

#include <cstddef>
#include <span>

#include "base/host.h"
#include "frame_field/singularities/faults.h"

namespace orbicube::frame_field {

// Changes matchings of faces between two tetrahedra that are both marked in `inside`, until no change of one face is
// worth it. `graph` is the singular graph of the matchings that are given. Returns the number of changes.
std::size_t zip(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                const FaultFinder& finder, std::span<const Quaternion> field, std::span<const std::uint8_t> inside,
                const SingularGraph& graph, const base::Host& host, Array<std::uint8_t>& matchings);

}  // namespace orbicube::frame_field
