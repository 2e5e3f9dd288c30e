// The rotation of the sphere that brings one set of functions best into line with another: the maximum over SO(3) of
// their correlation. For two shapes with sphere maps, this is how their maps are turned to correspond.
//
// The correlation of band-limited functions is itself one on SO(3) (Kostelec and Rockmore 2008, "FFTs on the rotation
// group"): its values on a grid of Euler angles come from the Wigner functions d^l_mn and sums of exponentials. The
// best of the grid, taken at a moderate degree, are refined with Newton's method at the full degree.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"
#include "harmonics/rotations/rotation.h"

namespace orbicube::harmonics {

struct AlignmentOptions {
  // Whether the values may be turned too (three channels): shapes that lie differently in space. Otherwise they are
  // compared as they are.
  bool turn_values = false;
  // With turned values: among maxima that are about as good, the one that turns the values least, so that shapes with
  // symmetries, and unlike ones that stand alike, stay as they stand.
  bool prefer_standing = false;
  std::uint32_t search_degree = 12;  // of the search over all rotations; capped by the degree that both have
};

struct Alignment {
  Matrix3 rotation = Matrix3::Identity();  // R of rotation.h, to be applied to `moving`: directions v go to R v
  Matrix3 values = Matrix3::Identity();    // Q: what the values of `moving` are turned by, where requested
  double correlation =
      0;  // sum of the products of the coefficients of degree 1 and more, over their lengths: at most 1
};

// Maximizes sum over channels of the integral of fixed(u) . Q moving(R' u), without degree 0. Both have the same number
// of channels; a degree that one of them does not have does not matter.
// Throws Error: invalid-argument, cancelled, no-valid-result when one of them is constant.
Alignment align(const Coefficients& fixed, const Coefficients& moving, const AlignmentOptions& options,
                const base::Host& host);

}  // namespace orbicube::harmonics
