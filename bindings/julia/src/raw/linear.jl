# What <orbicube/linear.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_LINEAR_AUTO = Int32(0)
const OBC_LINEAR_EIGEN = Int32(1)
const OBC_LINEAR_CHOLMOD_SIMPLICIAL = Int32(2)
const OBC_LINEAR_CHOLMOD_SUPERNODAL = Int32(3)

const OBC_LINEAR_ITERATIVE_AUTO = Int32(0)
const OBC_LINEAR_GAUSS_SEIDEL = Int32(1)
const OBC_LINEAR_MULTIGRID = Int32(2)

struct obc_linear_matrix
    size::Csize_t
    row_begin::Ptr{Csize_t}
    columns::Ptr{UInt32}
    values::Ptr{Float64}
end

mutable struct obc_linear_direct_options <: CStruct
    struct_size::UInt32
    method::Int32
    obc_linear_direct_options() = zeroed!(new())
end

mutable struct obc_linear_iterative_options <: CStruct
    struct_size::UInt32
    method::Int32
    block_size::Int32
    max_iterations::UInt32
    tolerance::Float64
    obc_linear_iterative_options() = zeroed!(new())
end

mutable struct obc_linear_iterative_report <: CStruct
    struct_size::UInt32
    converged::Int32
    iterations::UInt64
    residual::Float64
    obc_linear_iterative_report() = zeroed!(new())
end

const address_obc_linear_direct_options_init = Ref(C_NULL)
obc_linear_direct_options_init(options, struct_size) =
    ccall(symbol(address_obc_linear_direct_options_init, :linear, :obc_linear_direct_options_init), Int32, (Ptr{obc_linear_direct_options}, Csize_t), options, struct_size)

const address_obc_linear_direct_create = Ref(C_NULL)
obc_linear_direct_create(matrix, options, host, out, error) =
    ccall(symbol(address_obc_linear_direct_create, :linear, :obc_linear_direct_create), Int32, (Ptr{obc_linear_matrix}, Ptr{obc_linear_direct_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), matrix, options, host, out, error)

const address_obc_linear_direct_destroy = Ref(C_NULL)
obc_linear_direct_destroy(factor) =
    ccall(symbol(address_obc_linear_direct_destroy, :linear, :obc_linear_direct_destroy), Cvoid, (Ptr{Cvoid},), factor)

const address_obc_linear_direct_refactor = Ref(C_NULL)
obc_linear_direct_refactor(factor, values, count, error) =
    ccall(symbol(address_obc_linear_direct_refactor, :linear, :obc_linear_direct_refactor), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{obc_error}), factor, values, count, error)

const address_obc_linear_direct_solve = Ref(C_NULL)
obc_linear_direct_solve(factor, columns, right, solution, error) =
    ccall(symbol(address_obc_linear_direct_solve, :linear, :obc_linear_direct_solve), Int32, (Ptr{Cvoid}, Csize_t, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), factor, columns, right, solution, error)

const address_obc_linear_direct_remove_row = Ref(C_NULL)
obc_linear_direct_remove_row(factor, row, error) =
    ccall(symbol(address_obc_linear_direct_remove_row, :linear, :obc_linear_direct_remove_row), Int32, (Ptr{Cvoid}, UInt32, Ptr{obc_error}), factor, row, error)

const address_obc_linear_direct_update = Ref(C_NULL)
obc_linear_direct_update(factor, rows, values, count, sign, error) =
    ccall(symbol(address_obc_linear_direct_update, :linear, :obc_linear_direct_update), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{Float64}, Csize_t, Int32, Ptr{obc_error}), factor, rows, values, count, sign, error)

const address_obc_linear_direct_entry_count = Ref(C_NULL)
obc_linear_direct_entry_count(factor) =
    ccall(symbol(address_obc_linear_direct_entry_count, :linear, :obc_linear_direct_entry_count), Csize_t, (Ptr{Cvoid},), factor)

const address_obc_linear_iterative_options_init = Ref(C_NULL)
obc_linear_iterative_options_init(options, struct_size) =
    ccall(symbol(address_obc_linear_iterative_options_init, :linear, :obc_linear_iterative_options_init), Int32, (Ptr{obc_linear_iterative_options}, Csize_t), options, struct_size)

const address_obc_linear_iterative_report_init = Ref(C_NULL)
obc_linear_iterative_report_init(report, struct_size) =
    ccall(symbol(address_obc_linear_iterative_report_init, :linear, :obc_linear_iterative_report_init), Int32, (Ptr{obc_linear_iterative_report}, Csize_t), report, struct_size)

const address_obc_linear_iterative_create = Ref(C_NULL)
obc_linear_iterative_create(matrix, options, host, out, error) =
    ccall(symbol(address_obc_linear_iterative_create, :linear, :obc_linear_iterative_create), Int32, (Ptr{obc_linear_matrix}, Ptr{obc_linear_iterative_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), matrix, options, host, out, error)

const address_obc_linear_iterative_destroy = Ref(C_NULL)
obc_linear_iterative_destroy(solver) =
    ccall(symbol(address_obc_linear_iterative_destroy, :linear, :obc_linear_iterative_destroy), Cvoid, (Ptr{Cvoid},), solver)

const address_obc_linear_iterative_solve = Ref(C_NULL)
obc_linear_iterative_solve(solver, right, solution, report, error) =
    ccall(symbol(address_obc_linear_iterative_solve, :linear, :obc_linear_iterative_solve), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_linear_iterative_report}, Ptr{obc_error}), solver, right, solution, report, error)

const address_obc_linear_version = Ref(C_NULL)
obc_linear_version() =
    ccall(symbol(address_obc_linear_version, :linear, :obc_linear_version), UInt32, ())
