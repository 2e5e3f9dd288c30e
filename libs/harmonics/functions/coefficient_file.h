// Files of coefficients, in the conventions of two programs that others use:
//
// SHTOOLS (.sh, .shtools, .txt): lines "l, m, C, S" for m = 0 ... l and l = 0 ... L; real, 4 pi normalized (the
// integral
//   of the square of a basis function is 4 pi), no Condon-Shortley phase:
//     f = sum C_lm sqrt(4 pi) Y_lm + S_lm sqrt(4 pi) Y_l,-m   in the functions Y_lm of coefficients.h.
//   Lines that start with # are comments. Several functions, such as the coordinates of a shape, are a block each, one
//   after the other (SHTOOLS itself reads files of one block: write the channels to a file each for it). On reading, up
//   to two lines in front that start with no degree are passed over, as are columns of errors; a block may start at a
//   degree above 0, the ones below being zero.
//
// SPHARM-PDM (.coef): "{ count,{x, y, z}, ..., {x, y, z}}" for three channels and count = (L + 1)^2 triples; for each l
//   first that of m = 0, then those of the cosine and the sine for m = 1 ... l. As SPHARM-PDM evaluates them,
//   orthonormal with the Condon-Shortley phase:
//     f = sum over l of A_l0 K_l0 P_l0 + sum over m of (A_lm cos m phi + B_lm sin m phi) K_lm (-1)^m P_lm,
//   K_lm = N_lm of coefficients.h, so A_lm = (-1)^m sqrt 2 a_lm and B_lm = (-1)^m sqrt 2 a_l,-m for m > 0: twice the
//   real part of the coefficient of the complex harmonic, and minus twice its imaginary part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

enum class FileFormat : std::int32_t { by_ending = 0, shtools = 1, spharm_pdm = 2 };

// Throws Error "unsupported-format" for an ending that is none of the above.
FileFormat format_of_path(const std::filesystem::path& path);

// Text of a file that is read, or written; doubles are written so that they are read as the same ones. Throws Error:
// empty-file, bad-magic (no file of the format), parse, truncated, trailing-data, non-finite, each with the line;
// unsupported (a degree above largest_degree; channels that the format does not hold).
Coefficients parse_coefficients(std::span<const std::byte> bytes, FileFormat format, const base::Host& host);
std::string format_coefficients(const Coefficients& coefficients, FileFormat format);

// The same with a file, which is written whole or not at all. Throws also io and unsupported-format.
Coefficients read_coefficients(const std::filesystem::path& path, FileFormat format, const base::Host& host);
void write_coefficients(const std::filesystem::path& path, const Coefficients& coefficients, FileFormat format);

}  // namespace orbicube::harmonics
