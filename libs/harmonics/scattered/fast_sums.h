// Sums of basis functions by a scattered transform, where that takes less time.
#pragma once

#include "harmonics/functions/basis.h"

namespace orbicube::harmonics {

// As synthesise() and analyse() of basis.h with directions of length 1; return false, with nothing done, where the
// sums themselves take less time.
bool synthesise_fast(const Coefficients& coefficients, std::span<const Vector3> unit, std::span<double> values,
                     const char* phase, const base::Host& host);
bool analyse_fast(std::span<const Vector3> unit, std::span<const double> weights, std::span<const double> values,
                  Coefficients& coefficients, const char* phase, const base::Host& host);

}  // namespace orbicube::harmonics
