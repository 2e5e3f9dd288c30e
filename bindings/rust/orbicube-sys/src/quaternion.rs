//! What `<orbicube/quaternion.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::obc_error;

pub const OBC_QUATERNION_CUBE_ORDER: i32 = 24;
pub const OBC_QUATERNION_CUBE_NONE: i32 = 255;

/// 1 element
pub const OBC_QUATERNION_IDENTITY: i32 = 0;
/// 3: half turns about axes
pub const OBC_QUATERNION_FACE_HALF: i32 = 1;
/// 6: quarter turns about axes
pub const OBC_QUATERNION_FACE_QUARTER: i32 = 2;
/// 6: half turns about diagonals of faces
pub const OBC_QUATERNION_EDGE_HALF: i32 = 3;
/// 8: third turns about diagonals of the cube
pub const OBC_QUATERNION_CORNER_THIRD: i32 = 4;

extern "C" {
    /// out = p q (Hamilton), quaternions of any length; out may be p or q.
    pub fn obc_quaternion_multiply(p: *const f64, q: *const f64, out: *mut f64);
    /// out = q^-1 = conjugate / |q|^2, of any length but zero (which gives what is not finite).
    pub fn obc_quaternion_inverse(q: *const f64, out: *mut f64);
    /// out = q / |q|, also where |q|^2 would overflow or underflow. Zero gives what is not a number.
    pub fn obc_quaternion_normalize(q: *const f64, out: *mut f64);
    /// out = e^q, of any quaternion. The rotation by |v| about v is the exponential of (0, v / 2).
    pub fn obc_quaternion_exponential(q: *const f64, out: *mut f64);
    /// Principal logarithm: out = (log |q|, axis \* angle), angle from 0 to pi, so that the exponential of it is q. Where q is
    /// real and negative the axis is x. w is -infinity for zero.
    pub fn obc_quaternion_logarithm(q: *const f64, out: *mut f64);
    /// Spherical linear interpolation (Shoemake 1985) along the shorter arc between the rotations: p at t = 0, q or -q (the same
    /// rotation) at t = 1; t outside 0 to 1 goes on along the great circle.
    pub fn obc_quaternion_slerp(p: *const f64, q: *const f64, t: f64, out: *mut f64);
    /// The mean rotation: mean (4 doubles) maximises sum w\_i (mean . q\_i)^2, the dominant eigenvector of sum w\_i q\_i q\_i'
    /// (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q\_i do not matter; mean is on the side of the first q\_i of positive
    /// weight. weights: count of them, finite, not negative, not all zero; or NULL, all 1. \*agreement (or NULL) is
    /// sum w\_i (mean . q\_i)^2 / sum w\_i, 1 where all agree. Errors: invalid argument; no valid result when the mean is not
    /// unique, as of two opposite rotations.
    pub fn obc_quaternion_average(q: *const f64, weights: *const f64, count: usize, mean: *mut f64, agreement: *mut f64, error: *mut obc_error) -> i32;
    /// out turns v: out = q v q^-1. out may be v.
    pub fn obc_quaternion_rotate(q: *const f64, v: *const f64, out: *mut f64);
    /// The rotation by angle about axis, which needs no unit length. Errors: invalid argument (axis zero or not finite).
    pub fn obc_quaternion_from_axis_angle(axis: *const f64, angle: f64, out: *mut f64, error: *mut obc_error) -> i32;
    /// Unit axis (3 doubles) and \*angle from 0 to pi; (1, 0, 0) and 0 for no rotation.
    pub fn obc_quaternion_to_axis_angle(q: *const f64, axis: *mut f64, angle: *mut f64);
    /// The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles.
    pub fn obc_quaternion_from_rotation_vector(v: *const f64, out: *mut f64);
    /// The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles.
    pub fn obc_quaternion_to_rotation_vector(q: *const f64, out: *mut f64);
    /// The matrix (9 doubles, by rows) of q.
    pub fn obc_quaternion_to_matrix(q: *const f64, out: *mut f64);
    /// The quaternion, first component that is not zero positive, of a rotation matrix; accurate for every rotation (of the
    /// four formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the unit
    /// matrix to 1e-6 and R is no reflection.
    pub fn obc_quaternion_from_matrix(matrix: *const f64, out: *mut f64, error: *mut obc_error) -> i32;
    /// The rotation nearest to any 3x3 matrix in the Frobenius norm, also the one that maximises trace(R'M) (Davenport's
    /// q-method): for a rotation with noise, or for vectors to be made orthonormal. Errors: no valid result when M is not
    /// finite or two rotations are equally near.
    pub fn obc_quaternion_nearest_to_matrix(matrix: *const f64, out: *mut f64, error: *mut obc_error) -> i32;
    /// The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
    /// Errors: invalid argument for 24 and more.
    pub fn obc_quaternion_cube_element(number: u32, out: *mut f64, error: *mut obc_error) -> i32;
    /// The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
    /// Errors: invalid argument for 24 and more.
    pub fn obc_quaternion_cube_matrix(number: u32, out: *mut f64, error: *mut obc_error) -> i32;
    /// Number of the product a b (b first), and of the inverse of a, read from tables; OBC\_QUATERNION\_CUBE\_NONE when a number is
    /// out of range.
    pub fn obc_quaternion_cube_product(a: u32, b: u32) -> u32;
    /// Number of the product a b (b first), and of the inverse of a, read from tables; OBC\_QUATERNION\_CUBE\_NONE when a number is
    /// out of range.
    pub fn obc_quaternion_cube_inverse(a: u32) -> u32;
    /// Conjugacy class of a number, or -1 when it is out of range.
    pub fn obc_quaternion_cube_class(number: u32) -> i32;
    /// Number of the cube's rotation nearest to r (of any length but zero), without a search: of the sorted magnitudes
    /// a1 \>= a2 \>= a3 \>= a4 of its components the largest of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2 tells the kind,
    /// the signs tell which. Of equally near ones, the first kind in this order, then the first components.
    pub fn obc_quaternion_cube_nearest(r: *const f64) -> u32;
    /// The distance, in radians. Zero to the last bit for p = q, else accurate to a few 1e-16.
    pub fn obc_quaternion_symmetric_distance(p: *const f64, q: *const f64) -> f64;
    /// sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10).
    pub fn obc_quaternion_symmetric_sine_square(p: *const f64, q: *const f64) -> f64;
    /// Number of the g for which from g is nearest to the frame \`to\`: to ~ from g.
    pub fn obc_quaternion_symmetric_matching(from: *const f64, to: *const f64) -> u32;
    /// out\[i\] = p\[i\] q\[i\]
    pub fn obc_quaternion_multiply_array(p: *const f64, q: *const f64, count: usize, out: *mut f64);
    /// out\[i\] = p\[i\] q\[i\]
    pub fn obc_quaternion_normalize_array(q: *const f64, count: usize, out: *mut f64);
    /// v\[i\] by q\[i\]
    pub fn obc_quaternion_rotate_array(q: *const f64, v: *const f64, count: usize, out: *mut f64);
    /// v\[i\] by q\[i\]
    pub fn obc_quaternion_slerp_array(p: *const f64, q: *const f64, t: *const f64, count: usize, out: *mut f64);
    /// v\[i\] by q\[i\]
    pub fn obc_quaternion_to_matrix_array(q: *const f64, count: usize, out: *mut f64);
    /// Errors: invalid argument with the number of the first matrix that is no rotation; the quaternions before it are written.
    pub fn obc_quaternion_from_matrix_array(matrices: *const f64, count: usize, out: *mut f64, error: *mut obc_error) -> i32;
    /// Distance, sin^2 of half of it, and matching of each pair p\[i\], q\[i\] (from\[i\], to\[i\]).
    pub fn obc_quaternion_symmetric_distance_array(p: *const f64, q: *const f64, count: usize, out: *mut f64);
    /// Distance, sin^2 of half of it, and matching of each pair p\[i\], q\[i\] (from\[i\], to\[i\]).
    pub fn obc_quaternion_symmetric_sine_square_array(p: *const f64, q: *const f64, count: usize, out: *mut f64);
    /// Distance, sin^2 of half of it, and matching of each pair p\[i\], q\[i\] (from\[i\], to\[i\]).
    pub fn obc_quaternion_symmetric_matching_array(from: *const f64, to: *const f64, count: usize, out: *mut u8);
    /// Number of the cube's rotation nearest to each r\[i\].
    pub fn obc_quaternion_cube_nearest_array(r: *const f64, count: usize, out: *mut u8);
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_quaternion_version() -> u32;
}
