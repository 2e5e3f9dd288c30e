//! What `<orbicube/quaternion.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::obc_error;

/// number of rotations
pub const OBC_QUATERNION_CUBE_ORDER: i32 = 24;
/// no rotation
pub const OBC_QUATERNION_CUBE_NONE: i32 = 255;

/// 1 element
pub const OBC_QUATERNION_IDENTITY: i32 = 0;
/// 3 half turns about axes
pub const OBC_QUATERNION_FACE_HALF: i32 = 1;
/// 6 quarter turns about axes
pub const OBC_QUATERNION_FACE_QUARTER: i32 = 2;
/// 6 half turns about face diagonals
pub const OBC_QUATERNION_EDGE_HALF: i32 = 3;
/// 8 third turns about space diagonals
pub const OBC_QUATERNION_CORNER_THIRD: i32 = 4;

extern "C" {
    /// Computes the Hamilton product out = p q of quaternions of any length. out may be p or q.
    pub fn obc_quaternion_multiply(p: *const f64, q: *const f64, out: *mut f64);
    /// Computes the inverse out = conjugate(q) / |q|^2 of a quaternion of any length; entries are not finite for zero.
    pub fn obc_quaternion_inverse(q: *const f64, out: *mut f64);
    /// Computes out = q / |q|, also where |q|^2 would overflow or underflow; NaN for zero.
    pub fn obc_quaternion_normalize(q: *const f64, out: *mut f64);
    /// Computes out = e^q of any quaternion. The rotation by the angle |v| about v is the exponential of (0, v / 2).
    pub fn obc_quaternion_exponential(q: *const f64, out: *mut f64);
    /// Computes the principal logarithm out = (log |q|, axis \* angle), angle from 0 to pi, whose exponential is q. The axis is x for a negative
    /// real q. w is -infinity for zero.
    pub fn obc_quaternion_logarithm(q: *const f64, out: *mut f64);
    /// Interpolates rotations along the shorter great-circle arc (Shoemake 1985): p at t = 0, and at t = 1 q or -q, the same
    /// rotation. A t outside 0 to 1 extrapolates along the great circle.
    pub fn obc_quaternion_slerp(p: *const f64, q: *const f64, t: f64, out: *mut f64);
    /// Computes the mean rotation: the unit quaternion that maximizes sum w\_i (mean . q\_i)^2, the dominant eigenvector of
    /// sum w\_i q\_i q\_i' (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q\_i have no effect; mean has a nonnegative scalar product
    /// with the first q\_i of positive weight. weights: \`count\` finite, nonnegative numbers, not all zero; NULL: all 1. \*agreement (or
    /// NULL) is sum w\_i (mean . q\_i)^2 / sum w\_i, 1 for equal rotations. Errors: invalid argument; no valid result where
    /// the mean is not unique, as for two opposite rotations.
    pub fn obc_quaternion_average(q: *const f64, weights: *const f64, count: usize, mean: *mut f64, agreement: *mut f64, error: *mut obc_error) -> i32;
    /// Rotates a vector: out = q v q^-1. out may be v.
    pub fn obc_quaternion_rotate(q: *const f64, v: *const f64, out: *mut f64);
    /// Computes the rotation by \`angle\` about \`axis\` of any length. Errors: invalid argument (axis zero or not finite).
    pub fn obc_quaternion_from_axis_angle(axis: *const f64, angle: f64, out: *mut f64, error: *mut obc_error) -> i32;
    /// Computes the unit axis (3 doubles) and \*angle, 0 to pi, of a rotation; (1, 0, 0) and 0 for the identity.
    pub fn obc_quaternion_to_axis_angle(q: *const f64, axis: *mut f64, angle: *mut f64);
    /// Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest.
    pub fn obc_quaternion_from_rotation_vector(v: *const f64, out: *mut f64);
    /// Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest.
    pub fn obc_quaternion_to_rotation_vector(q: *const f64, out: *mut f64);
    /// Computes the rotation matrix (9 doubles, by rows) of q.
    pub fn obc_quaternion_to_matrix(q: *const f64, out: *mut f64);
    /// Computes the quaternion of a rotation matrix, its first nonzero component positive. Accurate for every rotation (of the four
    /// formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the identity to 1e-6 and
    /// R is not a reflection.
    pub fn obc_quaternion_from_matrix(matrix: *const f64, out: *mut f64, error: *mut obc_error) -> i32;
    /// Computes the rotation nearest to any 3x3 matrix M in the Frobenius norm, which also maximizes trace(R'M) (Davenport's q-method). Use it for
    /// a rotation with noise or to orthonormalize vectors. Errors: no valid result where M is not finite or two rotations
    /// are equally near.
    pub fn obc_quaternion_nearest_to_matrix(matrix: *const f64, out: *mut f64, error: *mut obc_error) -> i32;
    /// Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
    /// -1. Errors: invalid argument for numbers from 24 on.
    pub fn obc_quaternion_cube_element(number: u32, out: *mut f64, error: *mut obc_error) -> i32;
    /// Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
    /// -1. Errors: invalid argument for numbers from 24 on.
    pub fn obc_quaternion_cube_matrix(number: u32, out: *mut f64, error: *mut obc_error) -> i32;
    /// Return the number of the product a b (b first) and of the inverse of a, from tables; OBC\_QUATERNION\_CUBE\_NONE for a number out of
    /// range.
    pub fn obc_quaternion_cube_product(a: u32, b: u32) -> u32;
    /// Return the number of the product a b (b first) and of the inverse of a, from tables; OBC\_QUATERNION\_CUBE\_NONE for a number out of
    /// range.
    pub fn obc_quaternion_cube_inverse(a: u32) -> u32;
    /// Returns the conjugacy class of a number, -1 for a number out of range.
    pub fn obc_quaternion_cube_class(number: u32) -> i32;
    /// Returns the number of the cube rotation nearest to r, of any nonzero length. The sorted magnitudes a1 \>= a2 \>= a3 \>= a4 of the
    /// components decide its class by the maximum of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2, the signs its axis. Ties: the
    /// first class in this order, then the first components. O(1).
    pub fn obc_quaternion_cube_nearest(r: *const f64) -> u32;
    /// Returns the distance of the frames p and q in radians: the smallest angle of q^-1 p g over the 24 rotations g, at most 62.8
    /// degrees. It is invariant under p h and q k with rotations h, k of the cube, and under r p and r q with any rotation r.
    /// Exactly zero for p = q, otherwise accurate to a few 1e-16.
    pub fn obc_quaternion_symmetric_distance(p: *const f64, q: *const f64) -> f64;
    /// Returns sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10).
    pub fn obc_quaternion_symmetric_sine_square(p: *const f64, q: *const f64) -> f64;
    /// Returns the number of the g for which \`from\` g is nearest to the frame \`to\`.
    pub fn obc_quaternion_symmetric_matching(from: *const f64, to: *const f64) -> u32;
    /// Apply the function of the same name to each entry.
    pub fn obc_quaternion_multiply_array(p: *const f64, q: *const f64, count: usize, out: *mut f64);
    /// Apply the function of the same name to each entry.
    pub fn obc_quaternion_normalize_array(q: *const f64, count: usize, out: *mut f64);
    /// Apply the function of the same name to each entry.
    pub fn obc_quaternion_rotate_array(q: *const f64, v: *const f64, count: usize, out: *mut f64);
    /// Apply the function of the same name to each entry.
    pub fn obc_quaternion_slerp_array(p: *const f64, q: *const f64, t: *const f64, count: usize, out: *mut f64);
    /// Apply the function of the same name to each entry.
    pub fn obc_quaternion_to_matrix_array(q: *const f64, count: usize, out: *mut f64);
    /// Converts rotation matrices. Errors: invalid argument with the index of the first matrix that is not a rotation; the quaternions before it are
    /// written.
    pub fn obc_quaternion_from_matrix_array(matrices: *const f64, count: usize, out: *mut f64, error: *mut obc_error) -> i32;
    /// Compute distance, sin^2 of half of it, and matching of each pair p\[i\], q\[i\] or from\[i\], to\[i\].
    pub fn obc_quaternion_symmetric_distance_array(p: *const f64, q: *const f64, count: usize, out: *mut f64);
    /// Compute distance, sin^2 of half of it, and matching of each pair p\[i\], q\[i\] or from\[i\], to\[i\].
    pub fn obc_quaternion_symmetric_sine_square_array(p: *const f64, q: *const f64, count: usize, out: *mut f64);
    /// Compute distance, sin^2 of half of it, and matching of each pair p\[i\], q\[i\] or from\[i\], to\[i\].
    pub fn obc_quaternion_symmetric_matching_array(from: *const f64, to: *const f64, count: usize, out: *mut u8);
    /// Computes the number of the cube rotation nearest to each r\[i\].
    pub fn obc_quaternion_cube_nearest_array(r: *const f64, count: usize, out: *mut u8);
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_quaternion_version() -> u32;
}
