// Loops that the compiler turns into vector instructions. On x86 the ones that matter are compiled for AVX2 as well and
// chosen when the library is loaded; contraction to fused operations is off, so every variant gives the same bits.
#include "quaternion/batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/vector_variants.h"

#include "quaternion/frame_distance.h"
#include "quaternion/rotation.h"

namespace orbicube::quaternion {
namespace {

Quaternion load(const double* q) {
  return {q[0], q[1], q[2], q[3]};
}

void store(const Quaternion& q, double* out) {
  out[0] = q.w;
  out[1] = q.x;
  out[2] = q.y;
  out[3] = q.z;
}

}  // namespace

void multiply(const double* p, const double* q, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i)
    store(multiply(load(p + 4 * i), load(q + 4 * i)), out + 4 * i);
}

void normalize(const double* q, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i)
    store(normalized(load(q + 4 * i)), out + 4 * i);
}

void rotate(const double* q, const double* vectors, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const Vector v = rotate(load(q + 4 * i), {vectors[3 * i], vectors[3 * i + 1], vectors[3 * i + 2]});
    out[3 * i] = v.x;
    out[3 * i + 1] = v.y;
    out[3 * i + 2] = v.z;
  }
}

void slerp(const double* p, const double* q, const double* t, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i)
    store(slerp(load(p + 4 * i), load(q + 4 * i), t[i]), out + 4 * i);
}

void to_matrix(const double* q, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix m = to_matrix(load(q + 4 * i));
    std::copy(m.begin(), m.end(), out + 9 * i);
  }
}

void from_matrix(const double* matrices, std::size_t count, double* out) {
  for (std::size_t i = 0; i < count; ++i) {
    Matrix m;
    std::copy_n(matrices + 9 * i, 9, m.begin());
    try {
      store(from_matrix(m), out + 4 * i);
    } catch (const base::Error& error) {
      throw base::Error(error.kind(), "matrix " + std::to_string(i) + ": " + error.what());
    }
  }
}

ORBICUBE_VECTOR_VARIANTS
void symmetric_sine_square(const double* __restrict p, const double* __restrict q, std::size_t count,
                           double* __restrict out) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = symmetric_sine_square(load(p + 4 * i), load(q + 4 * i));
}

ORBICUBE_VECTOR_VARIANTS
void symmetric_distance(const double* __restrict p, const double* __restrict q, std::size_t count,
                        double* __restrict out) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = symmetric_distance(load(p + 4 * i), load(q + 4 * i));
}

void symmetric_matching(const double* from, const double* to, std::size_t count, std::uint8_t* out) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = static_cast<std::uint8_t>(symmetric_matching(load(from + 4 * i), load(to + 4 * i)));
}

void nearest_cube_rotation(const double* r, std::size_t count, std::uint8_t* out) {
  for (std::size_t i = 0; i < count; ++i)
    out[i] = static_cast<std::uint8_t>(nearest_cube_rotation(load(r + 4 * i)));
}

}  // namespace orbicube::quaternion
