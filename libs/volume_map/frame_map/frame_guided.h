// Maps of solids to polycubes that a frame field guides, the experiment of the dissertation's section 5.2: positions on
// the boundary are those of a polycube map, transitions are identities without gaps, and inside eq. 5.3 has its
// minimum. Inverted tetrahedra are untangled then, by vertices of the boundary that slide within their patches too.
#pragma once

#include "quaternion/quaternion.h"
#include "volume_map/solid/volume_map.h"

namespace orbicube::volume_map {

// Energies are eq. 5.3 over the volume of the solid, for an image scaled to that volume.
struct GuidedFigures {
  double minimum_energy = 0;         // with the boundary of the map, where tetrahedra may be inverted
  double energy = 0;                 // of the map
  std::size_t mismatched_faces = 0;  // inner faces across which the frames match by another rotation than the identity
  double harmonic_energy = 0;        // of harmonic coordinates with the boundary of the map, to compare with
};

// `frames` has one unit a tetrahedron of the solid; those of the parts of one that is cut are its own. Each frame is
// named by the one of its 24 names that is nearest to the gradient of harmonic coordinates, since the transitions have
// to be identities. Throws what map_to_polycube() does, and Error "invalid-argument" for another number of frames.
VolumeMap map_to_polycube_by_frames(const PolycubeSolid& solid, std::span<const quaternion::Quaternion> frames,
                                    GuidedFigures& figures, const base::Host& host,
                                    untangle::BlockEngine* engine = nullptr);

// Returns eq. 5.3 of `image`, with frames named already, not divided by the volume; adds its derivative by the
// positions of the image to `gradient` unless that is empty. `scale` is the length of the frames' vectors.
double guided_energy(std::span<const Vector3> source, std::span<const Vector3> image,
                     std::span<const Tetrahedron> tetrahedra, std::span<const quaternion::Quaternion> frames,
                     double scale, std::span<Vector3> gradient = {});

}  // namespace orbicube::volume_map
