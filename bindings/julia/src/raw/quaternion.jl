# What <orbicube/quaternion.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_QUATERNION_CUBE_ORDER = Int32(24)
const OBC_QUATERNION_CUBE_NONE = Int32(255)

const OBC_QUATERNION_IDENTITY = Int32(0)
const OBC_QUATERNION_FACE_HALF = Int32(1)
const OBC_QUATERNION_FACE_QUARTER = Int32(2)
const OBC_QUATERNION_EDGE_HALF = Int32(3)
const OBC_QUATERNION_CORNER_THIRD = Int32(4)

const address_obc_quaternion_multiply = Ref(C_NULL)
obc_quaternion_multiply(p, q, out) =
    ccall(symbol(address_obc_quaternion_multiply, :quaternion, :obc_quaternion_multiply), Cvoid, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}), p, q, out)

const address_obc_quaternion_inverse = Ref(C_NULL)
obc_quaternion_inverse(q, out) =
    ccall(symbol(address_obc_quaternion_inverse, :quaternion, :obc_quaternion_inverse), Cvoid, (Ptr{Float64}, Ptr{Float64}), q, out)

const address_obc_quaternion_normalize = Ref(C_NULL)
obc_quaternion_normalize(q, out) =
    ccall(symbol(address_obc_quaternion_normalize, :quaternion, :obc_quaternion_normalize), Cvoid, (Ptr{Float64}, Ptr{Float64}), q, out)

const address_obc_quaternion_exponential = Ref(C_NULL)
obc_quaternion_exponential(q, out) =
    ccall(symbol(address_obc_quaternion_exponential, :quaternion, :obc_quaternion_exponential), Cvoid, (Ptr{Float64}, Ptr{Float64}), q, out)

const address_obc_quaternion_logarithm = Ref(C_NULL)
obc_quaternion_logarithm(q, out) =
    ccall(symbol(address_obc_quaternion_logarithm, :quaternion, :obc_quaternion_logarithm), Cvoid, (Ptr{Float64}, Ptr{Float64}), q, out)

const address_obc_quaternion_slerp = Ref(C_NULL)
obc_quaternion_slerp(p, q, t, out) =
    ccall(symbol(address_obc_quaternion_slerp, :quaternion, :obc_quaternion_slerp), Cvoid, (Ptr{Float64}, Ptr{Float64}, Float64, Ptr{Float64}), p, q, t, out)

const address_obc_quaternion_average = Ref(C_NULL)
obc_quaternion_average(q, weights, count, mean, agreement, error) =
    ccall(symbol(address_obc_quaternion_average, :quaternion, :obc_quaternion_average), Int32, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), q, weights, count, mean, agreement, error)

const address_obc_quaternion_rotate = Ref(C_NULL)
obc_quaternion_rotate(q, v, out) =
    ccall(symbol(address_obc_quaternion_rotate, :quaternion, :obc_quaternion_rotate), Cvoid, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}), q, v, out)

const address_obc_quaternion_from_axis_angle = Ref(C_NULL)
obc_quaternion_from_axis_angle(axis, angle, out, error) =
    ccall(symbol(address_obc_quaternion_from_axis_angle, :quaternion, :obc_quaternion_from_axis_angle), Int32, (Ptr{Float64}, Float64, Ptr{Float64}, Ptr{obc_error}), axis, angle, out, error)

const address_obc_quaternion_to_axis_angle = Ref(C_NULL)
obc_quaternion_to_axis_angle(q, axis, angle) =
    ccall(symbol(address_obc_quaternion_to_axis_angle, :quaternion, :obc_quaternion_to_axis_angle), Cvoid, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}), q, axis, angle)

const address_obc_quaternion_from_rotation_vector = Ref(C_NULL)
obc_quaternion_from_rotation_vector(v, out) =
    ccall(symbol(address_obc_quaternion_from_rotation_vector, :quaternion, :obc_quaternion_from_rotation_vector), Cvoid, (Ptr{Float64}, Ptr{Float64}), v, out)

const address_obc_quaternion_to_rotation_vector = Ref(C_NULL)
obc_quaternion_to_rotation_vector(q, out) =
    ccall(symbol(address_obc_quaternion_to_rotation_vector, :quaternion, :obc_quaternion_to_rotation_vector), Cvoid, (Ptr{Float64}, Ptr{Float64}), q, out)

const address_obc_quaternion_to_matrix = Ref(C_NULL)
obc_quaternion_to_matrix(q, out) =
    ccall(symbol(address_obc_quaternion_to_matrix, :quaternion, :obc_quaternion_to_matrix), Cvoid, (Ptr{Float64}, Ptr{Float64}), q, out)

const address_obc_quaternion_from_matrix = Ref(C_NULL)
obc_quaternion_from_matrix(matrix, out, error) =
    ccall(symbol(address_obc_quaternion_from_matrix, :quaternion, :obc_quaternion_from_matrix), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), matrix, out, error)

const address_obc_quaternion_nearest_to_matrix = Ref(C_NULL)
obc_quaternion_nearest_to_matrix(matrix, out, error) =
    ccall(symbol(address_obc_quaternion_nearest_to_matrix, :quaternion, :obc_quaternion_nearest_to_matrix), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), matrix, out, error)

const address_obc_quaternion_cube_element = Ref(C_NULL)
obc_quaternion_cube_element(number, out, error) =
    ccall(symbol(address_obc_quaternion_cube_element, :quaternion, :obc_quaternion_cube_element), Int32, (UInt32, Ptr{Float64}, Ptr{obc_error}), number, out, error)

const address_obc_quaternion_cube_matrix = Ref(C_NULL)
obc_quaternion_cube_matrix(number, out, error) =
    ccall(symbol(address_obc_quaternion_cube_matrix, :quaternion, :obc_quaternion_cube_matrix), Int32, (UInt32, Ptr{Float64}, Ptr{obc_error}), number, out, error)

const address_obc_quaternion_cube_product = Ref(C_NULL)
obc_quaternion_cube_product(a, b) =
    ccall(symbol(address_obc_quaternion_cube_product, :quaternion, :obc_quaternion_cube_product), UInt32, (UInt32, UInt32), a, b)

const address_obc_quaternion_cube_inverse = Ref(C_NULL)
obc_quaternion_cube_inverse(a) =
    ccall(symbol(address_obc_quaternion_cube_inverse, :quaternion, :obc_quaternion_cube_inverse), UInt32, (UInt32,), a)

const address_obc_quaternion_cube_class = Ref(C_NULL)
obc_quaternion_cube_class(number) =
    ccall(symbol(address_obc_quaternion_cube_class, :quaternion, :obc_quaternion_cube_class), Int32, (UInt32,), number)

const address_obc_quaternion_cube_nearest = Ref(C_NULL)
obc_quaternion_cube_nearest(r) =
    ccall(symbol(address_obc_quaternion_cube_nearest, :quaternion, :obc_quaternion_cube_nearest), UInt32, (Ptr{Float64},), r)

const address_obc_quaternion_symmetric_distance = Ref(C_NULL)
obc_quaternion_symmetric_distance(p, q) =
    ccall(symbol(address_obc_quaternion_symmetric_distance, :quaternion, :obc_quaternion_symmetric_distance), Float64, (Ptr{Float64}, Ptr{Float64}), p, q)

const address_obc_quaternion_symmetric_sine_square = Ref(C_NULL)
obc_quaternion_symmetric_sine_square(p, q) =
    ccall(symbol(address_obc_quaternion_symmetric_sine_square, :quaternion, :obc_quaternion_symmetric_sine_square), Float64, (Ptr{Float64}, Ptr{Float64}), p, q)

const address_obc_quaternion_symmetric_matching = Ref(C_NULL)
obc_quaternion_symmetric_matching(from, to) =
    ccall(symbol(address_obc_quaternion_symmetric_matching, :quaternion, :obc_quaternion_symmetric_matching), UInt32, (Ptr{Float64}, Ptr{Float64}), from, to)

const address_obc_quaternion_multiply_array = Ref(C_NULL)
obc_quaternion_multiply_array(p, q, count, out) =
    ccall(symbol(address_obc_quaternion_multiply_array, :quaternion, :obc_quaternion_multiply_array), Cvoid, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}), p, q, count, out)

const address_obc_quaternion_normalize_array = Ref(C_NULL)
obc_quaternion_normalize_array(q, count, out) =
    ccall(symbol(address_obc_quaternion_normalize_array, :quaternion, :obc_quaternion_normalize_array), Cvoid, (Ptr{Float64}, Csize_t, Ptr{Float64}), q, count, out)

const address_obc_quaternion_rotate_array = Ref(C_NULL)
obc_quaternion_rotate_array(q, v, count, out) =
    ccall(symbol(address_obc_quaternion_rotate_array, :quaternion, :obc_quaternion_rotate_array), Cvoid, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}), q, v, count, out)

const address_obc_quaternion_slerp_array = Ref(C_NULL)
obc_quaternion_slerp_array(p, q, t, count, out) =
    ccall(symbol(address_obc_quaternion_slerp_array, :quaternion, :obc_quaternion_slerp_array), Cvoid, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}), p, q, t, count, out)

const address_obc_quaternion_to_matrix_array = Ref(C_NULL)
obc_quaternion_to_matrix_array(q, count, out) =
    ccall(symbol(address_obc_quaternion_to_matrix_array, :quaternion, :obc_quaternion_to_matrix_array), Cvoid, (Ptr{Float64}, Csize_t, Ptr{Float64}), q, count, out)

const address_obc_quaternion_from_matrix_array = Ref(C_NULL)
obc_quaternion_from_matrix_array(matrices, count, out, error) =
    ccall(symbol(address_obc_quaternion_from_matrix_array, :quaternion, :obc_quaternion_from_matrix_array), Int32, (Ptr{Float64}, Csize_t, Ptr{Float64}, Ptr{obc_error}), matrices, count, out, error)

const address_obc_quaternion_symmetric_distance_array = Ref(C_NULL)
obc_quaternion_symmetric_distance_array(p, q, count, out) =
    ccall(symbol(address_obc_quaternion_symmetric_distance_array, :quaternion, :obc_quaternion_symmetric_distance_array), Cvoid, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}), p, q, count, out)

const address_obc_quaternion_symmetric_sine_square_array = Ref(C_NULL)
obc_quaternion_symmetric_sine_square_array(p, q, count, out) =
    ccall(symbol(address_obc_quaternion_symmetric_sine_square_array, :quaternion, :obc_quaternion_symmetric_sine_square_array), Cvoid, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}), p, q, count, out)

const address_obc_quaternion_symmetric_matching_array = Ref(C_NULL)
obc_quaternion_symmetric_matching_array(from, to, count, out) =
    ccall(symbol(address_obc_quaternion_symmetric_matching_array, :quaternion, :obc_quaternion_symmetric_matching_array), Cvoid, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{UInt8}), from, to, count, out)

const address_obc_quaternion_cube_nearest_array = Ref(C_NULL)
obc_quaternion_cube_nearest_array(r, count, out) =
    ccall(symbol(address_obc_quaternion_cube_nearest_array, :quaternion, :obc_quaternion_cube_nearest_array), Cvoid, (Ptr{Float64}, Csize_t, Ptr{UInt8}), r, count, out)

const address_obc_quaternion_version = Ref(C_NULL)
obc_quaternion_version() =
    ccall(symbol(address_obc_quaternion_version, :quaternion, :obc_quaternion_version), UInt32, ())
