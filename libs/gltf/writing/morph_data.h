// What is stored of the morph targets of a scene.
#pragma once

#include <span>

#include "base/array.h"
#include "base/host.h"
#include "gltf/writing/binary_buffer.h"
#include "gltf/writing/write.h"

namespace orbicube::gltf {

// The differences to store for numbers that a target has in the place of those of the base (morph.h). Throws Error
// "invalid-argument" when one is beyond float32.
base::Array<float> deltas_of(std::span<const float> base, std::span<const float> wanted, const base::Host& host);

// The times and weights of the animation: the surface, each target alone, the surface.
struct AnimationAccessors {
  int times, weights;
};
AnimationAccessors add_animation(BinaryBuffer& buffer, const Scene& scene, const base::Host& host);

}  // namespace orbicube::gltf
