# What <orbicube/harmonics.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_HARMONICS_AUTOMATIC = Int32(0)
const OBC_HARMONICS_DENSE = Int32(1)
const OBC_HARMONICS_ITERATIVE = Int32(2)

const OBC_HARMONICS_BY_ENDING = Int32(0)
const OBC_HARMONICS_SHTOOLS = Int32(1)
const OBC_HARMONICS_SPHARM_PDM = Int32(2)

mutable struct obc_harmonics_fit_options <: CStruct
    struct_size::UInt32
    degree::UInt32
    method::Int32
    reserved::Int32
    regularization::Float64
    obc_harmonics_fit_options() = zeroed!(new())
end

mutable struct obc_harmonics_fit_report <: CStruct
    struct_size::UInt32
    method::Int32
    unknowns::UInt64
    rank::UInt64
    condition::Float64
    residual::Float64
    iterations::UInt64
    obc_harmonics_fit_report() = zeroed!(new())
end

mutable struct obc_harmonics_refinement_report <: CStruct
    struct_size::UInt32
    rounds::UInt32
    residual_before::Float64
    residual::Float64
    obc_harmonics_refinement_report() = zeroed!(new())
end

mutable struct obc_harmonics_align_options <: CStruct
    struct_size::UInt32
    turn_values::Int32
    search_degree::UInt32
    reserved::UInt32
    obc_harmonics_align_options() = zeroed!(new())
end

mutable struct obc_harmonics_alignment <: CStruct
    struct_size::UInt32
    reserved::UInt32
    rotation::NTuple{9, Float64}
    values::NTuple{9, Float64}
    correlation::Float64
    obc_harmonics_alignment() = zeroed!(new())
end

const address_obc_harmonics_fit_options_init = Ref(C_NULL)
obc_harmonics_fit_options_init(options, struct_size) =
    ccall(symbol(address_obc_harmonics_fit_options_init, :harmonics, :obc_harmonics_fit_options_init), Int32, (Ptr{obc_harmonics_fit_options}, Csize_t), options, struct_size)

const address_obc_harmonics_fit_report_init = Ref(C_NULL)
obc_harmonics_fit_report_init(report, struct_size) =
    ccall(symbol(address_obc_harmonics_fit_report_init, :harmonics, :obc_harmonics_fit_report_init), Int32, (Ptr{obc_harmonics_fit_report}, Csize_t), report, struct_size)

const address_obc_harmonics_refinement_report_init = Ref(C_NULL)
obc_harmonics_refinement_report_init(report, struct_size) =
    ccall(symbol(address_obc_harmonics_refinement_report_init, :harmonics, :obc_harmonics_refinement_report_init), Int32, (Ptr{obc_harmonics_refinement_report}, Csize_t), report, struct_size)

const address_obc_harmonics_size = Ref(C_NULL)
obc_harmonics_size(degree) =
    ccall(symbol(address_obc_harmonics_size, :harmonics, :obc_harmonics_size), Csize_t, (UInt32,), degree)

const address_obc_harmonics_evaluate = Ref(C_NULL)
obc_harmonics_evaluate(directions, count, degree, host, rows, error) =
    ccall(symbol(address_obc_harmonics_evaluate, :harmonics, :obc_harmonics_evaluate), Int32, (Ptr{Float64}, Csize_t, UInt32, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), directions, count, degree, host, rows, error)

const address_obc_harmonics_fit = Ref(C_NULL)
obc_harmonics_fit(directions, weights, values, count, channels, options, host, coefficients, report, error) =
    ccall(symbol(address_obc_harmonics_fit, :harmonics, :obc_harmonics_fit), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Csize_t, Csize_t, Ptr{obc_harmonics_fit_options}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_harmonics_fit_report}, Ptr{obc_error}), directions, weights, values, count, channels, options, host, coefficients, report, error)

const address_obc_harmonics_refine_map = Ref(C_NULL)
obc_harmonics_refine_map(positions, vertex_count, triangles, triangle_count, weights, options, rounds, host, directions, report, error) =
    ccall(symbol(address_obc_harmonics_refine_map, :harmonics, :obc_harmonics_refine_map), Int32, (Ptr{Float64}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{Float64}, Ptr{obc_harmonics_fit_options}, UInt32, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_harmonics_refinement_report}, Ptr{obc_error}), positions, vertex_count, triangles, triangle_count, weights, options, rounds, host, directions, report, error)

const address_obc_harmonics_synthesize = Ref(C_NULL)
obc_harmonics_synthesize(coefficients, degree, channels, directions, count, host, values, gradients, error) =
    ccall(symbol(address_obc_harmonics_synthesize, :harmonics, :obc_harmonics_synthesize), Int32, (Ptr{Float64}, UInt32, Csize_t, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), coefficients, degree, channels, directions, count, host, values, gradients, error)

const address_obc_harmonics_analyze = Ref(C_NULL)
obc_harmonics_analyze(directions, weights, values, count, channels, degree, host, coefficients, error) =
    ccall(symbol(address_obc_harmonics_analyze, :harmonics, :obc_harmonics_analyze), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Csize_t, Csize_t, UInt32, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), directions, weights, values, count, channels, degree, host, coefficients, error)

const address_obc_harmonics_degree_norms = Ref(C_NULL)
obc_harmonics_degree_norms(coefficients, degree, channels, norms, error) =
    ccall(symbol(address_obc_harmonics_degree_norms, :harmonics, :obc_harmonics_degree_norms), Int32, (Ptr{Float64}, UInt32, Csize_t, Ptr{Float64}, Ptr{obc_error}), coefficients, degree, channels, norms, error)

const address_obc_harmonics_shape_distance = Ref(C_NULL)
obc_harmonics_shape_distance(f, f_degree, g, g_degree, channels, first, last, distance, error) =
    ccall(symbol(address_obc_harmonics_shape_distance, :harmonics, :obc_harmonics_shape_distance), Int32, (Ptr{Float64}, UInt32, Ptr{Float64}, UInt32, Csize_t, UInt32, UInt32, Ptr{Float64}, Ptr{obc_error}), f, f_degree, g, g_degree, channels, first, last, distance, error)

const address_obc_harmonics_filter = Ref(C_NULL)
obc_harmonics_filter(coefficients, degree, channels, low, high, width, keep_mean, error) =
    ccall(symbol(address_obc_harmonics_filter, :harmonics, :obc_harmonics_filter), Int32, (Ptr{Float64}, UInt32, Csize_t, UInt32, UInt32, UInt32, Int32, Ptr{obc_error}), coefficients, degree, channels, low, high, width, keep_mean, error)

const address_obc_harmonics_rotate = Ref(C_NULL)
obc_harmonics_rotate(coefficients, degree, channels, rotation, host, turned, error) =
    ccall(symbol(address_obc_harmonics_rotate, :harmonics, :obc_harmonics_rotate), Int32, (Ptr{Float64}, UInt32, Csize_t, Ptr{Float64}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), coefficients, degree, channels, rotation, host, turned, error)

const address_obc_harmonics_align_options_init = Ref(C_NULL)
obc_harmonics_align_options_init(options, struct_size) =
    ccall(symbol(address_obc_harmonics_align_options_init, :harmonics, :obc_harmonics_align_options_init), Int32, (Ptr{obc_harmonics_align_options}, Csize_t), options, struct_size)

const address_obc_harmonics_alignment_init = Ref(C_NULL)
obc_harmonics_alignment_init(alignment, struct_size) =
    ccall(symbol(address_obc_harmonics_alignment_init, :harmonics, :obc_harmonics_alignment_init), Int32, (Ptr{obc_harmonics_alignment}, Csize_t), alignment, struct_size)

const address_obc_harmonics_align = Ref(C_NULL)
obc_harmonics_align(fixed, fixed_degree, moving, moving_degree, channels, options, host, alignment, error) =
    ccall(symbol(address_obc_harmonics_align, :harmonics, :obc_harmonics_align), Int32, (Ptr{Float64}, UInt32, Ptr{Float64}, UInt32, Csize_t, Ptr{obc_harmonics_align_options}, Ptr{obc_host}, Ptr{obc_harmonics_alignment}, Ptr{obc_error}), fixed, fixed_degree, moving, moving_degree, channels, options, host, alignment, error)

const address_obc_harmonics_write = Ref(C_NULL)
obc_harmonics_write(path, format, coefficients, degree, channels, error) =
    ccall(symbol(address_obc_harmonics_write, :harmonics, :obc_harmonics_write), Int32, (Cstring, Int32, Ptr{Float64}, UInt32, Csize_t, Ptr{obc_error}), path, format, coefficients, degree, channels, error)

const address_obc_harmonics_read = Ref(C_NULL)
obc_harmonics_read(path, format, host, coefficients, error) =
    ccall(symbol(address_obc_harmonics_read, :harmonics, :obc_harmonics_read), Int32, (Cstring, Int32, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), path, format, host, coefficients, error)

const address_obc_harmonics_coefficients_degree = Ref(C_NULL)
obc_harmonics_coefficients_degree(coefficients) =
    ccall(symbol(address_obc_harmonics_coefficients_degree, :harmonics, :obc_harmonics_coefficients_degree), UInt32, (Ptr{Cvoid},), coefficients)

const address_obc_harmonics_coefficients_channels = Ref(C_NULL)
obc_harmonics_coefficients_channels(coefficients) =
    ccall(symbol(address_obc_harmonics_coefficients_channels, :harmonics, :obc_harmonics_coefficients_channels), Csize_t, (Ptr{Cvoid},), coefficients)

const address_obc_harmonics_coefficients_copy = Ref(C_NULL)
obc_harmonics_coefficients_copy(coefficients, values, error) =
    ccall(symbol(address_obc_harmonics_coefficients_copy, :harmonics, :obc_harmonics_coefficients_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), coefficients, values, error)

const address_obc_harmonics_coefficients_destroy = Ref(C_NULL)
obc_harmonics_coefficients_destroy(coefficients) =
    ccall(symbol(address_obc_harmonics_coefficients_destroy, :harmonics, :obc_harmonics_coefficients_destroy), Cvoid, (Ptr{Cvoid},), coefficients)

const address_obc_harmonics_version = Ref(C_NULL)
obc_harmonics_version() =
    ccall(symbol(address_obc_harmonics_version, :harmonics, :obc_harmonics_version), UInt32, ())
