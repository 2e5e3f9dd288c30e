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
    """Computes the Hamilton product out = p q of quaternions of any length. out may be p or q."""
    ...

def obc_quaternion_inverse(q: Pointer, out: Pointer) -> None:
    """Computes the inverse out = conjugate(q) / |q|^2 of a quaternion of any length; entries are not finite for zero."""
    ...

def obc_quaternion_normalize(q: Pointer, out: Pointer) -> None:
    """Computes out = q / |q|, also where |q|^2 would overflow or underflow; NaN for zero."""
    ...

def obc_quaternion_exponential(q: Pointer, out: Pointer) -> None:
    """Computes out = e^q of any quaternion. The rotation by the angle |v| about v is the exponential of (0, v / 2)."""
    ...

def obc_quaternion_logarithm(q: Pointer, out: Pointer) -> None:
    """Computes the principal logarithm out = (log |q|, axis * angle), angle from 0 to pi, whose exponential is q. The axis is x for a negative
    real q. w is -infinity for zero."""
    ...

def obc_quaternion_slerp(p: Pointer, q: Pointer, t: float, out: Pointer) -> None:
    """Interpolates rotations along the shorter great-circle arc (Shoemake 1985): p at t = 0, and at t = 1 q or -q, the same
    rotation. A t outside 0 to 1 extrapolates along the great circle."""
    ...

def obc_quaternion_average(q: Pointer, weights: Pointer, count: int, mean: Pointer, agreement: Pointer, error: Pointer) -> int:
    """Computes the mean rotation: the unit quaternion that maximizes sum w_i (mean . q_i)^2, the dominant eigenvector of
    sum w_i q_i q_i' (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q_i have no effect; mean has a nonnegative scalar product
    with the first q_i of positive weight. weights: `count` finite, nonnegative numbers, not all zero; NULL: all 1. *agreement (or
    NULL) is sum w_i (mean . q_i)^2 / sum w_i, 1 for equal rotations. Errors: invalid argument; no valid result where
    the mean is not unique, as for two opposite rotations."""
    ...

def obc_quaternion_rotate(q: Pointer, v: Pointer, out: Pointer) -> None:
    """Rotates a vector: out = q v q^-1. out may be v."""
    ...

def obc_quaternion_from_axis_angle(axis: Pointer, angle: float, out: Pointer, error: Pointer) -> int:
    """Computes the rotation by `angle` about `axis` of any length. Errors: invalid argument (axis zero or not finite)."""
    ...

def obc_quaternion_to_axis_angle(q: Pointer, axis: Pointer, angle: Pointer) -> None:
    """Computes the unit axis (3 doubles) and *angle, 0 to pi, of a rotation; (1, 0, 0) and 0 for the identity."""
    ...

def obc_quaternion_from_rotation_vector(v: Pointer, out: Pointer) -> None:
    """Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest."""
    ...

def obc_quaternion_to_rotation_vector(q: Pointer, out: Pointer) -> None:
    """Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest."""
    ...

def obc_quaternion_to_matrix(q: Pointer, out: Pointer) -> None:
    """Computes the rotation matrix (9 doubles, by rows) of q."""
    ...

def obc_quaternion_from_matrix(matrix: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes the quaternion of a rotation matrix, its first nonzero component positive. Accurate for every rotation (of the four
    formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the identity to 1e-6 and
    R is not a reflection."""
    ...

def obc_quaternion_nearest_to_matrix(matrix: Pointer, out: Pointer, error: Pointer) -> int:
    """Computes the rotation nearest to any 3x3 matrix M in the Frobenius norm, which also maximizes trace(R'M) (Davenport's q-method). Use it for
    a rotation with noise or to orthonormalize vectors. Errors: no valid result where M is not finite or two rotations
    are equally near."""
    ...

def obc_quaternion_cube_element(number: int, out: Pointer, error: Pointer) -> int:
    """Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
    -1. Errors: invalid argument for numbers from 24 on."""
    ...

def obc_quaternion_cube_matrix(number: int, out: Pointer, error: Pointer) -> int:
    """Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
    -1. Errors: invalid argument for numbers from 24 on."""
    ...

def obc_quaternion_cube_product(a: int, b: int) -> int:
    """Return the number of the product a b (b first) and of the inverse of a, from tables; OBC_QUATERNION_CUBE_NONE for a number out of
    range."""
    ...

def obc_quaternion_cube_inverse(a: int) -> int:
    """Return the number of the product a b (b first) and of the inverse of a, from tables; OBC_QUATERNION_CUBE_NONE for a number out of
    range."""
    ...

def obc_quaternion_cube_class(number: int) -> int:
    """Returns the conjugacy class of a number, -1 for a number out of range."""
    ...

def obc_quaternion_cube_nearest(r: Pointer) -> int:
    """Returns the number of the cube rotation nearest to r, of any nonzero length. The sorted magnitudes a1 >= a2 >= a3 >= a4 of the
    components decide its class by the maximum of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2, the signs its axis. Ties: the
    first class in this order, then the first components. O(1)."""
    ...

def obc_quaternion_symmetric_distance(p: Pointer, q: Pointer) -> float:
    """Returns the distance of the frames p and q in radians: the smallest angle of q^-1 p g over the 24 rotations g, at most 62.8
    degrees. It is invariant under p h and q k with rotations h, k of the cube, and under r p and r q with any rotation r.
    Exactly zero for p = q, otherwise accurate to a few 1e-16."""
    ...

def obc_quaternion_symmetric_sine_square(p: Pointer, q: Pointer) -> float:
    """Returns sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10)."""
    ...

def obc_quaternion_symmetric_matching(from_: Pointer, to: Pointer) -> int:
    """Returns the number of the g for which `from` g is nearest to the frame `to`."""
    ...

def obc_quaternion_multiply_array(p: Pointer, q: Pointer, count: int, out: Pointer) -> None:
    """Apply the function of the same name to each entry."""
    ...

def obc_quaternion_normalize_array(q: Pointer, count: int, out: Pointer) -> None:
    """Apply the function of the same name to each entry."""
    ...

def obc_quaternion_rotate_array(q: Pointer, v: Pointer, count: int, out: Pointer) -> None:
    """Apply the function of the same name to each entry."""
    ...

def obc_quaternion_slerp_array(p: Pointer, q: Pointer, t: Pointer, count: int, out: Pointer) -> None:
    """Apply the function of the same name to each entry."""
    ...

def obc_quaternion_to_matrix_array(q: Pointer, count: int, out: Pointer) -> None:
    """Apply the function of the same name to each entry."""
    ...

def obc_quaternion_from_matrix_array(matrices: Pointer, count: int, out: Pointer, error: Pointer) -> int:
    """Converts rotation matrices. Errors: invalid argument with the index of the first matrix that is not a rotation; the quaternions before it are
    written."""
    ...

def obc_quaternion_symmetric_distance_array(p: Pointer, q: Pointer, count: int, out: Pointer) -> None:
    """Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]."""
    ...

def obc_quaternion_symmetric_sine_square_array(p: Pointer, q: Pointer, count: int, out: Pointer) -> None:
    """Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]."""
    ...

def obc_quaternion_symmetric_matching_array(from_: Pointer, to: Pointer, count: int, out: Pointer) -> None:
    """Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]."""
    ...

def obc_quaternion_cube_nearest_array(r: Pointer, count: int, out: Pointer) -> None:
    """Computes the number of the cube rotation nearest to each r[i]."""
    ...

def obc_quaternion_version() -> int:
    """Returns the version of the library, major * 10000 + minor * 100 + patch."""
    ...
