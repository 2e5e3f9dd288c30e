// Morph targets in 32-bit floats: glTF stores what a target adds to the base, and a renderer's sum is what counts.
// These functions say to the bit what comes out, so that a caller can certify a target as it will be loaded.
#pragma once

namespace orbicube::gltf {

// What a renderer gets, in float32: base + delta rounded to the nearest float, ties to even (IEEE 754).
float reconstructed(float base, float delta);

// What a program gets that adds them as doubles: exact, unless they differ by more than a factor of about 2^29.
double reconstructed_in_double(float base, float delta);

// The delta to store so that base and target sum up to `wanted`: reconstructed(base, delta) == `wanted` whenever there
// is such a delta, and otherwise the delta whose sum is nearest to it. The writer stores exactly these. Inputs are
// finite.
float delta_for(float base, float wanted);

}  // namespace orbicube::gltf
