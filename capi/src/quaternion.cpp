#include "orbicube/quaternion.h"

#include <algorithm>
#include <limits>
#include <span>

#include "base/version.h"
#include "capi/src/entry.h"
#include "quaternion/average.h"
#include "quaternion/batch.h"
#include "quaternion/frame_distance.h"
#include "quaternion/rotation.h"

using namespace orbicube;
namespace qn = orbicube::quaternion;

namespace {

qn::Quaternion quaternion_at(const double* q) {
  return {q[0], q[1], q[2], q[3]};
}

qn::Vector vector_at(const double* v) {
  return {v[0], v[1], v[2]};
}

void write(const qn::Quaternion& q, double* out) {
  out[0] = q.w;
  out[1] = q.x;
  out[2] = q.y;
  out[3] = q.z;
}

void write(const qn::Vector& v, double* out) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

qn::Matrix matrix_at(const double* m) {
  qn::Matrix matrix;
  std::copy_n(m, matrix.size(), matrix.begin());
  return matrix;
}

template <class... Pointers>
bool any_null(const Pointers*... pointers) {
  return (... || (pointers == nullptr));
}

}  // namespace

void obc_quaternion_multiply(const double* p, const double* q, double* out) {
  if (any_null(p, q, out)) return;
  write(qn::multiply(quaternion_at(p), quaternion_at(q)), out);
}

void obc_quaternion_inverse(const double* q, double* out) {
  if (any_null(q, out)) return;
  write(qn::inverse(quaternion_at(q)), out);
}

void obc_quaternion_normalize(const double* q, double* out) {
  if (any_null(q, out)) return;
  write(qn::normalized(quaternion_at(q)), out);
}

void obc_quaternion_exponential(const double* q, double* out) {
  if (any_null(q, out)) return;
  write(qn::exponential(quaternion_at(q)), out);
}

void obc_quaternion_logarithm(const double* q, double* out) {
  if (any_null(q, out)) return;
  write(qn::logarithm(quaternion_at(q)), out);
}

void obc_quaternion_slerp(const double* p, const double* q, double t, double* out) {
  if (any_null(p, q, out)) return;
  write(qn::slerp(quaternion_at(p), quaternion_at(q), t), out);
}

obc_status obc_quaternion_average(const double* q, const double* weights, size_t count, double* mean, double* agreement,
                                  obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(q != nullptr && mean != nullptr, "q or mean is NULL");
    const qn::Average average = qn::average(q, weights, count);
    write(average.mean, mean);
    if (agreement != nullptr) *agreement = average.agreement;
  });
}

void obc_quaternion_rotate(const double* q, const double* v, double* out) {
  if (any_null(q, v, out)) return;
  write(qn::rotate(quaternion_at(q), vector_at(v)), out);
}

obc_status obc_quaternion_from_axis_angle(const double* axis, double angle, double* out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(axis != nullptr && out != nullptr, "axis or out is NULL");
    write(qn::from_axis_angle(vector_at(axis), angle), out);
  });
}

void obc_quaternion_to_axis_angle(const double* q, double* axis, double* angle) {
  if (any_null(q, axis, angle)) return;
  const qn::AxisAngle turn = qn::to_axis_angle(quaternion_at(q));
  write(turn.axis, axis);
  *angle = turn.angle;
}

void obc_quaternion_from_rotation_vector(const double* v, double* out) {
  if (any_null(v, out)) return;
  write(qn::from_rotation_vector(vector_at(v)), out);
}

void obc_quaternion_to_rotation_vector(const double* q, double* out) {
  if (any_null(q, out)) return;
  write(qn::to_rotation_vector(quaternion_at(q)), out);
}

void obc_quaternion_to_matrix(const double* q, double* out) {
  if (any_null(q, out)) return;
  const qn::Matrix matrix = qn::to_matrix(quaternion_at(q));
  std::copy(matrix.begin(), matrix.end(), out);
}

obc_status obc_quaternion_from_matrix(const double* matrix, double* out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(matrix != nullptr && out != nullptr, "matrix or out is NULL");
    write(qn::from_matrix(matrix_at(matrix)), out);
  });
}

obc_status obc_quaternion_nearest_to_matrix(const double* matrix, double* out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(matrix != nullptr && out != nullptr, "matrix or out is NULL");
    write(qn::nearest_to_matrix(matrix_at(matrix)), out);
  });
}

obc_status obc_quaternion_cube_element(uint32_t number, double* out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(number < qn::cube_order && out != nullptr, "no rotation of the cube has this number, or out is NULL");
    write(qn::cube_group.element[number], out);
  });
}

obc_status obc_quaternion_cube_matrix(uint32_t number, double* out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(number < qn::cube_order && out != nullptr, "no rotation of the cube has this number, or out is NULL");
    const auto& matrix = qn::cube_group.matrix[number];
    std::copy(matrix.begin(), matrix.end(), out);
  });
}

uint32_t obc_quaternion_cube_product(uint32_t a, uint32_t b) {
  if (a >= qn::cube_order || b >= qn::cube_order) return OBC_QUATERNION_CUBE_NONE;
  return qn::cube_group.product[a][b];
}

uint32_t obc_quaternion_cube_inverse(uint32_t a) {
  return a < qn::cube_order ? qn::cube_group.inverse[a] : uint32_t{OBC_QUATERNION_CUBE_NONE};
}

int32_t obc_quaternion_cube_class(uint32_t number) {
  return number < qn::cube_order ? static_cast<int32_t>(qn::cube_group.conjugacy_class[number]) : -1;
}

uint32_t obc_quaternion_cube_nearest(const double* r) {
  if (any_null(r)) return OBC_QUATERNION_CUBE_NONE;
  return qn::nearest_cube_rotation(quaternion_at(r));
}

double obc_quaternion_symmetric_distance(const double* p, const double* q) {
  if (any_null(p, q)) return std::numeric_limits<double>::quiet_NaN();
  return qn::symmetric_distance(quaternion_at(p), quaternion_at(q));
}

double obc_quaternion_symmetric_sine_square(const double* p, const double* q) {
  if (any_null(p, q)) return std::numeric_limits<double>::quiet_NaN();
  return qn::symmetric_sine_square(quaternion_at(p), quaternion_at(q));
}

uint32_t obc_quaternion_symmetric_matching(const double* from, const double* to) {
  if (any_null(from, to)) return OBC_QUATERNION_CUBE_NONE;
  return qn::symmetric_matching(quaternion_at(from), quaternion_at(to));
}

void obc_quaternion_multiply_array(const double* p, const double* q, size_t count, double* out) {
  if (any_null(p, q, out)) return;
  qn::multiply(p, q, count, out);
}

void obc_quaternion_normalize_array(const double* q, size_t count, double* out) {
  if (any_null(q, out)) return;
  qn::normalize(q, count, out);
}

void obc_quaternion_rotate_array(const double* q, const double* v, size_t count, double* out) {
  if (any_null(q, v, out)) return;
  qn::rotate(q, v, count, out);
}

void obc_quaternion_slerp_array(const double* p, const double* q, const double* t, size_t count, double* out) {
  if (any_null(p, q, t, out)) return;
  qn::slerp(p, q, t, count, out);
}

void obc_quaternion_to_matrix_array(const double* q, size_t count, double* out) {
  if (any_null(q, out)) return;
  qn::to_matrix(q, count, out);
}

obc_status obc_quaternion_from_matrix_array(const double* matrices, size_t count, double* out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(count == 0 || (matrices != nullptr && out != nullptr), "matrices or out is NULL");
    qn::from_matrix(matrices, count, out);
  });
}

void obc_quaternion_symmetric_distance_array(const double* p, const double* q, size_t count, double* out) {
  if (any_null(p, q, out)) return;
  qn::symmetric_distance(p, q, count, out);
}

void obc_quaternion_symmetric_sine_square_array(const double* p, const double* q, size_t count, double* out) {
  if (any_null(p, q, out)) return;
  qn::symmetric_sine_square(p, q, count, out);
}

void obc_quaternion_symmetric_matching_array(const double* from, const double* to, size_t count, uint8_t* out) {
  if (any_null(from, to, out)) return;
  qn::symmetric_matching(from, to, count, out);
}

void obc_quaternion_cube_nearest_array(const double* r, size_t count, uint8_t* out) {
  if (any_null(r, out)) return;
  qn::nearest_cube_rotation(r, count, out);
}

uint32_t obc_quaternion_version(void) {
  return base::version_number;
}
