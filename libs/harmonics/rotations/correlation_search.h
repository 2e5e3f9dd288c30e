// The correlation of two sets of functions on a grid of all rotations, and the places on it from which a local search
// should start (Kostelec and Rockmore 2008).
#pragma once

#include <cstdint>
#include <vector>

#include "base/host.h"
#include "harmonics/rotations/rotation.h"

namespace orbicube::harmonics {

struct CorrelationPeak {
  Matrix3 rotation;
  double value;
};

// The best grid points in falling order, at most `most` of them and no two nearer than two steps of the grid, which has
// steps of pi / (2 degree): those of sum over channels of <f, R g> or, with turned values (three channels), of the
// largest sum over all rotations Q of the values. Coefficients of degree 1 to `degree` count. O(degree^4).
std::vector<CorrelationPeak> correlation_peaks(const Coefficients& f, const Coefficients& g, std::uint32_t degree,
                                               bool turn_values, std::size_t most, const base::Host& host);

// The rotation Q that maximizes sum Q_ij M_ij, and that sum.
Matrix3 best_rotation(const Matrix3& m, double& sum);

}  // namespace orbicube::harmonics
