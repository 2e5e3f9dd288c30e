/* Orbicube: unit quaternions, rotations, the 24 rotations of the cube, and distances between frames up to them.
 *
 * Conventions. A quaternion is four doubles w x y z and stands for w + x i + y j + z k with Hamilton's product, i j = k. A
 * unit quaternion q is the rotation that takes a vector v to q v q^-1 (active): q = cos(a/2) + sin(a/2) axis turns by a
 * about its axis, counter-clockwise seen against it. The product p q turns by q first, as for matrices: the matrix of
 * p q is that of p times that of q. q and -q are the same rotation. Matrices are nine doubles by rows, R v = q v q^-1,
 * vectors are x y z. Angles are in radians.
 *
 * Functions of rotations expect quaternions of length 1 (obc_quaternion_normalize makes them so) and give rotations of
 * length 1, to some units of the last place.
 *
 * Arrays. count entries one after the other: 4 doubles a quaternion, 3 a vector, 9 a matrix. out may be the same array as
 * an input whose entries have the same size, else it does not overlap the inputs; outputs of the symmetric_... functions
 * overlap no input. Each entry gets the same bits as from the function for one. For very long arrays that must be
 * cancelled or shared among threads, call the function on parts.
 *
 * Nothing here allocates (but for the text of an error), needs a host, or keeps anything; every function may be called from
 * any number of threads at once. Functions without a status cannot fail: pointers must not be NULL, and what is not a
 * number in the input is not a number in the output.
 */
#ifndef ORBICUBE_QUATERNION_H
#define ORBICUBE_QUATERNION_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Arithmetic ---- */

/* out = p q (Hamilton), quaternions of any length; out may be p or q. */
OBC_API void obc_quaternion_multiply(const double *p, const double *q, double *out);

/* out = q^-1 = conjugate / |q|^2, of any length but zero (which gives what is not finite). */
OBC_API void obc_quaternion_inverse(const double *q, double *out);

/* out = q / |q|, also where |q|^2 would overflow or underflow. Zero gives what is not a number. */
OBC_API void obc_quaternion_normalize(const double *q, double *out);

/* out = e^q, of any quaternion. The rotation by |v| about v is the exponential of (0, v / 2). */
OBC_API void obc_quaternion_exponential(const double *q, double *out);

/* Principal logarithm: out = (log |q|, axis * angle), angle from 0 to pi, so that the exponential of it is q. Where q is
 * real and negative the axis is x. w is -infinity for zero. */
OBC_API void obc_quaternion_logarithm(const double *q, double *out);

/* Spherical linear interpolation (Shoemake 1985) along the shorter arc between the rotations: p at t = 0, q or -q (the same
 * rotation) at t = 1; t outside 0 to 1 goes on along the great circle. */
OBC_API void obc_quaternion_slerp(const double *p, const double *q, double t, double *out);

/* The mean rotation: mean (4 doubles) maximises sum w_i (mean . q_i)^2, the dominant eigenvector of sum w_i q_i q_i'
 * (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q_i do not matter; mean is on the side of the first q_i of positive
 * weight. weights: count of them, finite, not negative, not all zero; or NULL, all 1. *agreement (or NULL) is
 * sum w_i (mean . q_i)^2 / sum w_i, 1 where all agree. Errors: invalid argument; no valid result when the mean is not
 * unique, as of two opposite rotations. */
OBC_API obc_status obc_quaternion_average(const double *q, const double *weights, size_t count, double *mean,
                                          double *agreement, obc_error *error);

/* ---- Rotations in other forms ---- */

/* out turns v: out = q v q^-1. out may be v. */
OBC_API void obc_quaternion_rotate(const double *q, const double *v, double *out);

/* The rotation by angle about axis, which needs no unit length. Errors: invalid argument (axis zero or not finite). */
OBC_API obc_status obc_quaternion_from_axis_angle(const double *axis, double angle, double *out, obc_error *error);

/* Unit axis (3 doubles) and *angle from 0 to pi; (1, 0, 0) and 0 for no rotation. */
OBC_API void obc_quaternion_to_axis_angle(const double *q, double *axis, double *angle);

/* The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles. */
OBC_API void obc_quaternion_from_rotation_vector(const double *v, double *out);
OBC_API void obc_quaternion_to_rotation_vector(const double *q, double *out);

/* The matrix (9 doubles, by rows) of q. */
OBC_API void obc_quaternion_to_matrix(const double *q, double *out);

/* The quaternion, first component that is not zero positive, of a rotation matrix; accurate for every rotation (of the
 * four formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the unit
 * matrix to 1e-6 and R is no reflection. */
OBC_API obc_status obc_quaternion_from_matrix(const double *matrix, double *out, obc_error *error);

/* The rotation nearest to any 3x3 matrix in the Frobenius norm, also the one that maximises trace(R'M) (Davenport's
 * q-method): for a rotation with noise, or for vectors to be made orthonormal. Errors: no valid result when M is not
 * finite or two rotations are equally near. */
OBC_API obc_status obc_quaternion_nearest_to_matrix(const double *matrix, double *out, obc_error *error);

/* ---- The 24 rotations of the cube ----
 *
 * Each has a number: 0 none; 1 2 3 half turns about x y z; 4 .. 9 quarter turns about x -x y -y z -z; 10 .. 15 half turns
 * about the edges (1 1 0) (1 -1 0) (1 0 1) (1 0 -1) (0 1 1) (0 1 -1); 16 .. 23 turns by a third about the corners
 * (1 1 1) (-1 1 1) (1 -1 1) (-1 -1 1) (1 1 -1) (-1 1 -1) (1 -1 -1) (-1 -1 -1). */

/* How many there are, and the number that is none of them. */
enum {
  OBC_QUATERNION_CUBE_ORDER = 24,
  OBC_QUATERNION_CUBE_NONE = 255
};

/* Conjugacy classes: what is left of a rotation when the axes have no names. */
enum {
  OBC_QUATERNION_IDENTITY = 0,     /* 1 element */
  OBC_QUATERNION_FACE_HALF = 1,    /* 3: half turns about axes */
  OBC_QUATERNION_FACE_QUARTER = 2, /* 6: quarter turns about axes */
  OBC_QUATERNION_EDGE_HALF = 3,    /* 6: half turns about diagonals of faces */
  OBC_QUATERNION_CORNER_THIRD = 4  /* 8: third turns about diagonals of the cube */
};

/* The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
 * Errors: invalid argument for 24 and more. */
OBC_API obc_status obc_quaternion_cube_element(uint32_t number, double *out, obc_error *error);
OBC_API obc_status obc_quaternion_cube_matrix(uint32_t number, double *out, obc_error *error);

/* Number of the product a b (b first), and of the inverse of a, read from tables; OBC_QUATERNION_CUBE_NONE when a number is
 * out of range. */
OBC_API uint32_t obc_quaternion_cube_product(uint32_t a, uint32_t b);
OBC_API uint32_t obc_quaternion_cube_inverse(uint32_t a);

/* Conjugacy class of a number, or -1 when it is out of range. */
OBC_API int32_t obc_quaternion_cube_class(uint32_t number);

/* Number of the cube's rotation nearest to r (of any length but zero), without a search: of the sorted magnitudes
 * a1 >= a2 >= a3 >= a4 of its components the largest of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2 tells the kind,
 * the signs tell which. Of equally near ones, the first kind in this order, then the first components. */
OBC_API uint32_t obc_quaternion_cube_nearest(const double *r);

/* ---- Frames: rotations up to the cube's, q ~ q g ----
 *
 * The distance of frames p and q is the least angle of q^-1 p g over the 24 g. It is at most 62.8 degrees and the same for
 * p h and q k in place of p and q (h, k of the cube), and for r p and r q (any rotation r). */

/* The distance, in radians. Zero to the last bit for p = q, else accurate to a few 1e-16. */
OBC_API double obc_quaternion_symmetric_distance(const double *p, const double *q);

/* sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10). */
OBC_API double obc_quaternion_symmetric_sine_square(const double *p, const double *q);

/* Number of the g for which from g is nearest to the frame `to`: to ~ from g. */
OBC_API uint32_t obc_quaternion_symmetric_matching(const double *from, const double *to);

/* ---- Arrays ---- */

OBC_API void obc_quaternion_multiply_array(const double *p, const double *q, size_t count, double *out);    /* out[i] = p[i] q[i] */
OBC_API void obc_quaternion_normalize_array(const double *q, size_t count, double *out);
OBC_API void obc_quaternion_rotate_array(const double *q, const double *v, size_t count, double *out);      /* v[i] by q[i] */
OBC_API void obc_quaternion_slerp_array(const double *p, const double *q, const double *t, size_t count, double *out);
OBC_API void obc_quaternion_to_matrix_array(const double *q, size_t count, double *out);

/* Errors: invalid argument with the number of the first matrix that is no rotation; the quaternions before it are written. */
OBC_API obc_status obc_quaternion_from_matrix_array(const double *matrices, size_t count, double *out,
                                                    obc_error *error);

/* Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i]). */
OBC_API void obc_quaternion_symmetric_distance_array(const double *p, const double *q, size_t count, double *out);
OBC_API void obc_quaternion_symmetric_sine_square_array(const double *p, const double *q, size_t count, double *out);
OBC_API void obc_quaternion_symmetric_matching_array(const double *from, const double *to, size_t count,
                                                     uint8_t *out);

/* Number of the cube's rotation nearest to each r[i]. */
OBC_API void obc_quaternion_cube_nearest_array(const double *r, size_t count, uint8_t *out);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_quaternion_version(void);

#ifdef __cplusplus
}
#endif

#endif
