// The basis functions at scattered points of the sphere: their values, and sums of them in both directions. Points are
// x y z each and are scaled to length 1 first; a length of zero, or what is not finite, is "invalid-argument".
#pragma once

#include <Eigen/Core>
#include <span>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"
#include "harmonics/functions/legendre.h"

namespace orbicube::harmonics {

using Vector3 = Eigen::Vector3d;

// directions / |directions|, checked.
Array<Vector3> unit_directions(std::span<const Vector3> directions, const base::Host& host);

// Y_lm of every direction: rows[i * basis_size(degree) + basis_index(l, m)]. O(points * degree^2).
void evaluate(std::span<const Vector3> directions, std::uint32_t degree, std::span<double> rows,
              const base::Host& host);

// The functions at the directions: values[i * channels + c] = sum a_lm,c Y_lm(direction i), the dissertation's
// reconstruction of section 3.3.1. O(points * degree^2).
void synthesise(const Coefficients& coefficients, std::span<const Vector3> directions, std::span<double> values,
                const base::Host& host);

// The same and the gradients on the sphere, gradients[i * channels + c]: tangent at direction i.
void synthesise_with_gradients(const Coefficients& coefficients, std::span<const Vector3> directions,
                               std::span<double> values, std::span<Vector3> gradients, const base::Host& host);

// The transpose: a_lm,c = sum over the points of weights[i] values[i * channels + c] Y_lm(direction i); `weights` may
// be empty, for ones. Added up in an order that depends on the sizes only. Reports progress as `phase`.
void analyse(std::span<const Vector3> directions, std::span<const double> weights, std::span<const double> values,
             Coefficients& coefficients, const char* phase, const base::Host& host);

}  // namespace orbicube::harmonics
