/* Orbicube quaternion: unit quaternions, rotations, the 24 rotations of the cube, and distances between frames up to them.
 *
 * Conventions. A quaternion is four doubles w x y z for w + x i + y j + z k with Hamilton's product, i j = k. A unit quaternion q
 * is the active rotation v -> q v q^-1: q = cos(a/2) + sin(a/2) axis rotates by the angle a about the axis, counter-clockwise
 * seen against it. The product p q rotates by q first, as for matrices. q and -q are the same rotation. Matrices are nine
 * doubles by rows, vectors are x y z. Angles are in radians.
 *
 * Functions of rotations require quaternions of length 1 (see obc_quaternion_normalize) and return rotations of length 1, to some
 * units in the last place.
 *
 * Arrays have `count` consecutive entries: 4 doubles a quaternion, 3 a vector, 9 a matrix. `out` may be the same array as an input
 * with entries of the same size, and otherwise overlaps no input; outputs of symmetric_... functions overlap no input. Each entry has the
 * same bits as the function for one entry returns. To cancel or parallelize a very long array, call the function on parts of it.
 *
 * No function allocates (except for the text of an error), takes a host, or keeps anything. Functions without a status cannot
 * fail: NaN in the input is NaN in the output; with a NULL pointer they write nothing and return NaN or OBC_QUATERNION_CUBE_NONE.
 *
 * Thread safety: all functions may be called at the same time.
 *
 * Example: rotates a vector by a quarter turn about z.
 *
 *   #include <orbicube/quaternion.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     const double axis[] = {0, 0, 1}, v[] = {1, 0, 0};
 *     double q[4], rotated[3];
 *     if (obc_quaternion_from_axis_angle(axis, 1.5707963267948966, q, NULL) != OBC_OK) return 1;
 *     obc_quaternion_rotate(q, v, rotated);
 *     printf("%.3f %.3f %.3f\n", rotated[0], rotated[1], rotated[2]); // 0 1 0
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_QUATERNION_H
#define ORBICUBE_QUATERNION_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- arithmetic ------------------------------------------------------------------------------------------------------ */

/* Computes the Hamilton product out = p q of quaternions of any length. out may be p or q. */
OBC_API void obc_quaternion_multiply(const double *p, const double *q, double *out);

/* Computes the inverse out = conjugate(q) / |q|^2 of a quaternion of any length; entries are not finite for zero. */
OBC_API void obc_quaternion_inverse(const double *q, double *out);

/* Computes out = q / |q|, also where |q|^2 would overflow or underflow; NaN for zero. */
OBC_API void obc_quaternion_normalize(const double *q, double *out);

/* Computes out = e^q of any quaternion. The rotation by the angle |v| about v is the exponential of (0, v / 2). */
OBC_API void obc_quaternion_exponential(const double *q, double *out);

/* Computes the principal logarithm out = (log |q|, axis * angle), angle from 0 to pi, whose exponential is q. The axis is x for a negative
 * real q. w is -infinity for zero. */
OBC_API void obc_quaternion_logarithm(const double *q, double *out);

/* Interpolates rotations along the shorter great-circle arc (Shoemake 1985): p at t = 0, and at t = 1 q or -q, the same
 * rotation. A t outside 0 to 1 extrapolates along the great circle. */
OBC_API void obc_quaternion_slerp(const double *p, const double *q, double t, double *out);

/* Computes the mean rotation: the unit quaternion that maximizes sum w_i (mean . q_i)^2, the dominant eigenvector of
 * sum w_i q_i q_i' (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q_i have no effect; mean has a nonnegative scalar product
 * with the first q_i of positive weight. weights: `count` finite, nonnegative numbers, not all zero; NULL: all 1. *agreement (or
 * NULL) is sum w_i (mean . q_i)^2 / sum w_i, 1 for equal rotations. Errors: invalid argument; no valid result where
 * the mean is not unique, as for two opposite rotations. */
OBC_API obc_status obc_quaternion_average(const double *q, const double *weights, size_t count, double *mean,
                                          double *agreement, obc_error *error);

/* ---- rotations in other forms ---------------------------------------------------------------------------------------- */

/* Rotates a vector: out = q v q^-1. out may be v. */
OBC_API void obc_quaternion_rotate(const double *q, const double *v, double *out);

/* Computes the rotation by `angle` about `axis` of any length. Errors: invalid argument (axis zero or not finite). */
OBC_API obc_status obc_quaternion_from_axis_angle(const double *axis, double angle, double *out, obc_error *error);

/* Computes the unit axis (3 doubles) and *angle, 0 to pi, of a rotation; (1, 0, 0) and 0 for the identity. */
OBC_API void obc_quaternion_to_axis_angle(const double *q, double *axis, double *angle);

/* Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest. */
OBC_API void obc_quaternion_from_rotation_vector(const double *v, double *out);
OBC_API void obc_quaternion_to_rotation_vector(const double *q, double *out);

/* Computes the rotation matrix (9 doubles, by rows) of q. */
OBC_API void obc_quaternion_to_matrix(const double *q, double *out);

/* Computes the quaternion of a rotation matrix, its first nonzero component positive. Accurate for every rotation (of the four
 * formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the identity to 1e-6 and
 * R is not a reflection. */
OBC_API obc_status obc_quaternion_from_matrix(const double *matrix, double *out, obc_error *error);

/* Computes the rotation nearest to any 3x3 matrix M in the Frobenius norm, which also maximizes trace(R'M) (Davenport's q-method). Use it for
 * a rotation with noise or to orthonormalize vectors. Errors: no valid result where M is not finite or two rotations
 * are equally near. */
OBC_API obc_status obc_quaternion_nearest_to_matrix(const double *matrix, double *out, obc_error *error);

/* ---- the 24 rotations of the cube ------------------------------------------------------------------------------------ */

/* Numbers of the rotations: 0 identity; 1 2 3 half turns about x y z; 4 to 9 quarter turns about x -x y -y z -z; 10 to 15 half turns
 * about the edges (1 1 0) (1 -1 0) (1 0 1) (1 0 -1) (0 1 1) (0 1 -1); 16 to 23 third turns about the corners
 * (1 1 1) (-1 1 1) (1 -1 1) (-1 -1 1) (1 1 -1) (-1 1 -1) (1 -1 -1) (-1 -1 -1). */
enum {
  OBC_QUATERNION_CUBE_ORDER = 24, /* number of rotations */
  OBC_QUATERNION_CUBE_NONE = 255  /* no rotation */
};

/* Conjugacy classes of the rotations. */
enum {
  OBC_QUATERNION_IDENTITY = 0,     /* 1 element */
  OBC_QUATERNION_FACE_HALF = 1,    /* 3 half turns about axes */
  OBC_QUATERNION_FACE_QUARTER = 2, /* 6 quarter turns about axes */
  OBC_QUATERNION_EDGE_HALF = 3,    /* 6 half turns about face diagonals */
  OBC_QUATERNION_CORNER_THIRD = 4  /* 8 third turns about space diagonals */
};

/* Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
 * -1. Errors: invalid argument for numbers from 24 on. */
OBC_API obc_status obc_quaternion_cube_element(uint32_t number, double *out, obc_error *error);
OBC_API obc_status obc_quaternion_cube_matrix(uint32_t number, double *out, obc_error *error);

/* Return the number of the product a b (b first) and of the inverse of a, from tables; OBC_QUATERNION_CUBE_NONE for a number out of
 * range. */
OBC_API uint32_t obc_quaternion_cube_product(uint32_t a, uint32_t b);
OBC_API uint32_t obc_quaternion_cube_inverse(uint32_t a);

/* Returns the conjugacy class of a number, -1 for a number out of range. */
OBC_API int32_t obc_quaternion_cube_class(uint32_t number);

/* Returns the number of the cube rotation nearest to r, of any nonzero length. The sorted magnitudes a1 >= a2 >= a3 >= a4 of the
 * components decide its class by the maximum of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2, the signs its axis. Ties: the
 * first class in this order, then the first components. O(1). */
OBC_API uint32_t obc_quaternion_cube_nearest(const double *r);

/* ---- frames: rotations up to those of the cube, q ~ q g -------------------------------------------------------------- */

/* Returns the distance of the frames p and q in radians: the smallest angle of q^-1 p g over the 24 rotations g, at most 62.8
 * degrees. It is invariant under p h and q k with rotations h, k of the cube, and under r p and r q with any rotation r.
 * Exactly zero for p = q, otherwise accurate to a few 1e-16. */
OBC_API double obc_quaternion_symmetric_distance(const double *p, const double *q);

/* Returns sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10). */
OBC_API double obc_quaternion_symmetric_sine_square(const double *p, const double *q);

/* Returns the number of the g for which `from` g is nearest to the frame `to`. */
OBC_API uint32_t obc_quaternion_symmetric_matching(const double *from, const double *to);

/* ---- arrays ---------------------------------------------------------------------------------------------------------- */

/* Apply the function of the same name to each entry. */
OBC_API void obc_quaternion_multiply_array(const double *p, const double *q, size_t count, double *out);
OBC_API void obc_quaternion_normalize_array(const double *q, size_t count, double *out);
OBC_API void obc_quaternion_rotate_array(const double *q, const double *v, size_t count, double *out);
OBC_API void obc_quaternion_slerp_array(const double *p, const double *q, const double *t, size_t count, double *out);
OBC_API void obc_quaternion_to_matrix_array(const double *q, size_t count, double *out);

/* Converts rotation matrices. Errors: invalid argument with the index of the first matrix that is not a rotation; the quaternions before it are
 * written. */
OBC_API obc_status obc_quaternion_from_matrix_array(const double *matrices, size_t count, double *out,
                                                    obc_error *error);

/* Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]. */
OBC_API void obc_quaternion_symmetric_distance_array(const double *p, const double *q, size_t count, double *out);
OBC_API void obc_quaternion_symmetric_sine_square_array(const double *p, const double *q, size_t count, double *out);
OBC_API void obc_quaternion_symmetric_matching_array(const double *from, const double *to, size_t count,
                                                     uint8_t *out);

/* Computes the number of the cube rotation nearest to each r[i]. */
OBC_API void obc_quaternion_cube_nearest_array(const double *r, size_t count, uint8_t *out);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_quaternion_version(void);

#ifdef __cplusplus
}
#endif

#endif
