"""What <orbicube/quaternion.h> declares. Written by scripts/bindings.py; not to be edited."""
from typing import Any

from .._library import Pointer, Struct

OBC_QUATERNION_CUBE_ORDER: int
OBC_QUATERNION_CUBE_NONE: int

OBC_QUATERNION_IDENTITY: int
OBC_QUATERNION_FACE_HALF: int
OBC_QUATERNION_FACE_QUARTER: int
OBC_QUATERNION_EDGE_HALF: int
OBC_QUATERNION_CORNER_THIRD: int

def obc_quaternion_multiply(p: Pointer, q: Pointer, out: Pointer) -> None:
    """out = p q (Hamilton), quaternions of any length; out may be p or q."""
    ...

def obc_quaternion_inverse(q: Pointer, out: Pointer) -> None:
    """out = q^-1 = conjugate / |q|^2, of any length but zero (which gives what is not finite)."""
    ...

def obc_quaternion_normalize(q: Pointer, out: Pointer) -> None:
    """out = q / |q|, also where |q|^2 would overflow or underflow. Zero gives what is not a number."""
    ...

def obc_quaternion_exponential(q: Pointer, out: Pointer) -> None:
    """out = e^q, of any quaternion. The rotation by |v| about v is the exponential of (0, v / 2)."""
    ...

def obc_quaternion_logarithm(q: Pointer, out: Pointer) -> None:
    """Principal logarithm: out = (log |q|, axis * angle), angle from 0 to pi, so that the exponential of it is q. Where q is
    real and negative the axis is x. w is -infinity for zero."""
    ...

def obc_quaternion_slerp(p: Pointer, q: Pointer, t: float, out: Pointer) -> None:
    """Spherical linear interpolation (Shoemake 1985) along the shorter arc between the rotations: p at t = 0, q or -q (the same
    rotation) at t = 1; t outside 0 to 1 goes on along the great circle."""
    ...

def obc_quaternion_average(q: Pointer, weights: Pointer, count: int, mean: Pointer, agreement: Pointer, error: Pointer) -> int:
    """The mean rotation: mean (4 doubles) maximises sum w_i (mean . q_i)^2, the dominant eigenvector of sum w_i q_i q_i'
    (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q_i do not matter; mean is on the side of the first q_i of positive
    weight. weights: count of them, finite, not negative, not all zero; or NULL, all 1. *agreement (or NULL) is
    sum w_i (mean . q_i)^2 / sum w_i, 1 where all agree. Errors: invalid argument; no valid result when the mean is not
    unique, as of two opposite rotations."""
    ...

def obc_quaternion_rotate(q: Pointer, v: Pointer, out: Pointer) -> None:
    """out turns v: out = q v q^-1. out may be v."""
    ...

def obc_quaternion_from_axis_angle(axis: Pointer, angle: float, out: Pointer, error: Pointer) -> int:
    """The rotation by angle about axis, which needs no unit length. Errors: invalid argument (axis zero or not finite)."""
    ...

def obc_quaternion_to_axis_angle(q: Pointer, axis: Pointer, angle: Pointer) -> None:
    """Unit axis (3 doubles) and *angle from 0 to pi; (1, 0, 0) and 0 for no rotation."""
    ...

def obc_quaternion_from_rotation_vector(v: Pointer, out: Pointer) -> None:
    """The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles."""
    ...

def obc_quaternion_to_rotation_vector(q: Pointer, out: Pointer) -> None:
    """The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles."""
    ...

def obc_quaternion_to_matrix(q: Pointer, out: Pointer) -> None:
    """The matrix (9 doubles, by rows) of q."""
    ...

def obc_quaternion_from_matrix(matrix: Pointer, out: Pointer, error: Pointer) -> int:
    """The quaternion, first component that is not zero positive, of a rotation matrix; accurate for every rotation (of the
    four formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the unit
    matrix to 1e-6 and R is no reflection."""
    ...

def obc_quaternion_nearest_to_matrix(matrix: Pointer, out: Pointer, error: Pointer) -> int:
    """The rotation nearest to any 3x3 matrix in the Frobenius norm, also the one that maximises trace(R'M) (Davenport's
    q-method): for a rotation with noise, or for vectors to be made orthonormal. Errors: no valid result when M is not
    finite or two rotations are equally near."""
    ...

def obc_quaternion_cube_element(number: int, out: Pointer, error: Pointer) -> int:
    """The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
    Errors: invalid argument for 24 and more."""
    ...

def obc_quaternion_cube_matrix(number: int, out: Pointer, error: Pointer) -> int:
    """The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
    Errors: invalid argument for 24 and more."""
    ...

def obc_quaternion_cube_product(a: int, b: int) -> int:
    """Number of the product a b (b first), and of the inverse of a, read from tables; OBC_QUATERNION_CUBE_NONE when a number is
    out of range."""
    ...

def obc_quaternion_cube_inverse(a: int) -> int:
    """Number of the product a b (b first), and of the inverse of a, read from tables; OBC_QUATERNION_CUBE_NONE when a number is
    out of range."""
    ...

def obc_quaternion_cube_class(number: int) -> int:
    """Conjugacy class of a number, or -1 when it is out of range."""
    ...

def obc_quaternion_cube_nearest(r: Pointer) -> int:
    """Number of the cube's rotation nearest to r (of any length but zero), without a search: of the sorted magnitudes
    a1 >= a2 >= a3 >= a4 of its components the largest of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2 tells the kind,
    the signs tell which. Of equally near ones, the first kind in this order, then the first components."""
    ...

def obc_quaternion_symmetric_distance(p: Pointer, q: Pointer) -> float:
    """The distance, in radians. Zero to the last bit for p = q, else accurate to a few 1e-16."""
    ...

def obc_quaternion_symmetric_sine_square(p: Pointer, q: Pointer) -> float:
    """sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10)."""
    ...

def obc_quaternion_symmetric_matching(from_: Pointer, to: Pointer) -> int:
    """Number of the g for which from g is nearest to the frame `to`: to ~ from g."""
    ...

def obc_quaternion_multiply_array(p: Pointer, q: Pointer, count: int, out: Pointer) -> None:
    """out[i] = p[i] q[i]"""
    ...

def obc_quaternion_normalize_array(q: Pointer, count: int, out: Pointer) -> None:
    """out[i] = p[i] q[i]"""
    ...

def obc_quaternion_rotate_array(q: Pointer, v: Pointer, count: int, out: Pointer) -> None:
    """v[i] by q[i]"""
    ...

def obc_quaternion_slerp_array(p: Pointer, q: Pointer, t: Pointer, count: int, out: Pointer) -> None:
    """v[i] by q[i]"""
    ...

def obc_quaternion_to_matrix_array(q: Pointer, count: int, out: Pointer) -> None:
    """v[i] by q[i]"""
    ...

def obc_quaternion_from_matrix_array(matrices: Pointer, count: int, out: Pointer, error: Pointer) -> int:
    """Errors: invalid argument with the number of the first matrix that is no rotation; the quaternions before it are written."""
    ...

def obc_quaternion_symmetric_distance_array(p: Pointer, q: Pointer, count: int, out: Pointer) -> None:
    """Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i])."""
    ...

def obc_quaternion_symmetric_sine_square_array(p: Pointer, q: Pointer, count: int, out: Pointer) -> None:
    """Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i])."""
    ...

def obc_quaternion_symmetric_matching_array(from_: Pointer, to: Pointer, count: int, out: Pointer) -> None:
    """Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i])."""
    ...

def obc_quaternion_cube_nearest_array(r: Pointer, count: int, out: Pointer) -> None:
    """Number of the cube's rotation nearest to each r[i]."""
    ...

def obc_quaternion_version() -> int:
    """Version of this library, major * 10000 + minor * 100 + patch."""
    ...
