// The same functions over arrays, entry by entry with the same bits: quaternions are w x y z each, vectors x y z,
// matrices nine numbers by rows. `out` may be one of the inputs of the same shape, else it overlaps none.
#pragma once

#include <cstddef>
#include <cstdint>

namespace orbicube::quaternion {

void multiply(const double* p, const double* q, std::size_t count, double* out);
void normalize(const double* q, std::size_t count, double* out);
// Vector i by rotation i.
void rotate(const double* q, const double* vectors, std::size_t count, double* out);
void slerp(const double* p, const double* q, const double* t, std::size_t count, double* out);
void to_matrix(const double* q, std::size_t count, double* out);
// Throws invalid-argument with the number of the first matrix that is no rotation.
void from_matrix(const double* matrices, std::size_t count, double* out);

void symmetric_sine_square(const double* p, const double* q, std::size_t count, double* out);
void symmetric_distance(const double* p, const double* q, std::size_t count, double* out);
void symmetric_matching(const double* from, const double* to, std::size_t count, std::uint8_t* out);
void nearest_cube_rotation(const double* r, std::size_t count, std::uint8_t* out);

}  // namespace orbicube::quaternion
