//! Unit quaternions w x y z, rotations, the 24 rotations of the cube, and distances of frames up to them.
//!
//! ```
//! use orbicube::quaternion::*;
//! let q = from_axis_angle([0.0, 0.0, 2.0], 0.5)?;
//! assert!((rotate(q, [1.0, 0.0, 0.0])[1] - 0.5f64.sin()).abs() < 1e-15);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{checked, expect_length, pointer, Error};
use crate::sys::quaternion::*;

pub type Quaternion = [f64; 4];
pub type Vector = [f64; 3];
/// By rows.
pub type Matrix = [f64; 9];

/// p q: turns by q first.
pub fn multiply(p: Quaternion, q: Quaternion) -> Quaternion {
    let mut out = [0.0; 4];
    unsafe { obc_quaternion_multiply(p.as_ptr(), q.as_ptr(), out.as_mut_ptr()) };
    out
}

macro_rules! of_one {
    ($($(#[$doc:meta])* $name:ident($from:ty) -> $to:ty = $zero:expr, $c:path;)*) => {
        $($(#[$doc])*
        pub fn $name(from: $from) -> $to {
            let mut out = $zero;
            unsafe { $c(from.as_ptr(), out.as_mut_ptr()) };
            out
        })*
    };
}

of_one! {
    inverse(Quaternion) -> Quaternion = [0.0; 4], obc_quaternion_inverse;
    /// Of length 1.
    normalize(Quaternion) -> Quaternion = [0.0; 4], obc_quaternion_normalize;
    exponential(Quaternion) -> Quaternion = [0.0; 4], obc_quaternion_exponential;
    logarithm(Quaternion) -> Quaternion = [0.0; 4], obc_quaternion_logarithm;
    from_rotation_vector(Vector) -> Quaternion = [0.0; 4], obc_quaternion_from_rotation_vector;
    to_rotation_vector(Quaternion) -> Vector = [0.0; 3], obc_quaternion_to_rotation_vector;
    to_matrix(Quaternion) -> Matrix = [0.0; 9], obc_quaternion_to_matrix;
}

/// q v q^-1.
pub fn rotate(q: Quaternion, v: Vector) -> Vector {
    let mut out = [0.0; 3];
    unsafe { obc_quaternion_rotate(q.as_ptr(), v.as_ptr(), out.as_mut_ptr()) };
    out
}

/// Along the shorter arc, p at t = 0 and q at t = 1.
pub fn slerp(p: Quaternion, q: Quaternion, t: f64) -> Quaternion {
    let mut out = [0.0; 4];
    unsafe { obc_quaternion_slerp(p.as_ptr(), q.as_ptr(), t, out.as_mut_ptr()) };
    out
}

pub fn from_axis_angle(axis: Vector, angle: f64) -> Result<Quaternion, Error> {
    let mut out = [0.0; 4];
    checked(|error| unsafe { obc_quaternion_from_axis_angle(axis.as_ptr(), angle, out.as_mut_ptr(), error) })?;
    Ok(out)
}

/// Unit axis, and angle from 0 to pi.
pub fn to_axis_angle(q: Quaternion) -> (Vector, f64) {
    let (mut axis, mut angle) = ([0.0; 3], 0.0);
    unsafe { obc_quaternion_to_axis_angle(q.as_ptr(), axis.as_mut_ptr(), &mut angle) };
    (axis, angle)
}

pub fn from_matrix(matrix: &Matrix) -> Result<Quaternion, Error> {
    let mut out = [0.0; 4];
    checked(|error| unsafe { obc_quaternion_from_matrix(matrix.as_ptr(), out.as_mut_ptr(), error) })?;
    Ok(out)
}

/// The rotation nearest to any matrix.
pub fn nearest_to_matrix(matrix: &Matrix) -> Result<Quaternion, Error> {
    let mut out = [0.0; 4];
    checked(|error| unsafe { obc_quaternion_nearest_to_matrix(matrix.as_ptr(), out.as_mut_ptr(), error) })?;
    Ok(out)
}

/// The mean rotation, and how much they agree (1: all). weights: one each, or none.
pub fn average(q: &[Quaternion], weights: &[f64]) -> Result<(Quaternion, f64), Error> {
    if !weights.is_empty() {
        expect_length(weights.len(), q.len(), "weights")?;
    }
    let (mut mean, mut agreement) = ([0.0; 4], 0.0);
    checked(|error| unsafe {
        obc_quaternion_average(q.as_ptr() as *const f64, pointer(weights), q.len(), mean.as_mut_ptr(), &mut agreement, error)
    })?;
    Ok((mean, agreement))
}

/// The quaternion of one of the cube's rotations.
pub fn cube_element(number: u32) -> Result<Quaternion, Error> {
    let mut out = [0.0; 4];
    checked(|error| unsafe { obc_quaternion_cube_element(number, out.as_mut_ptr(), error) })?;
    Ok(out)
}

pub fn cube_matrix(number: u32) -> Result<Matrix, Error> {
    let mut out = [0.0; 9];
    checked(|error| unsafe { obc_quaternion_cube_matrix(number, out.as_mut_ptr(), error) })?;
    Ok(out)
}

/// The number of a b, b first; `None` when a number is 24 or more.
pub fn cube_product(a: u32, b: u32) -> Option<u32> {
    let product = unsafe { obc_quaternion_cube_product(a, b) };
    if product == OBC_QUATERNION_CUBE_NONE as u32 { None } else { Some(product) }
}

/// `None` when the number is 24 or more.
pub fn cube_inverse(a: u32) -> Option<u32> {
    let inverse = unsafe { obc_quaternion_cube_inverse(a) };
    if inverse == OBC_QUATERNION_CUBE_NONE as u32 { None } else { Some(inverse) }
}

/// `OBC_QUATERNION_IDENTITY`, ...; `None` when the number is 24 or more.
pub fn cube_class(number: u32) -> Option<i32> {
    let class = unsafe { obc_quaternion_cube_class(number) };
    if class < 0 { None } else { Some(class) }
}

/// The number of the cube's rotation nearest to r.
pub fn cube_nearest(r: Quaternion) -> u32 {
    unsafe { obc_quaternion_cube_nearest(r.as_ptr()) }
}

/// The angle between frames, up to the cube's rotations.
pub fn symmetric_distance(p: Quaternion, q: Quaternion) -> f64 {
    unsafe { obc_quaternion_symmetric_distance(p.as_ptr(), q.as_ptr()) }
}

/// sin^2 of half of it.
pub fn symmetric_sine_square(p: Quaternion, q: Quaternion) -> f64 {
    unsafe { obc_quaternion_symmetric_sine_square(p.as_ptr(), q.as_ptr()) }
}

/// The number of the g for which from g is nearest to the frame `to`.
pub fn symmetric_matching(from: Quaternion, to: Quaternion) -> u32 {
    unsafe { obc_quaternion_symmetric_matching(from.as_ptr(), to.as_ptr()) }
}
