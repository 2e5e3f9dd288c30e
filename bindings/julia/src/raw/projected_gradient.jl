# What <orbicube/projected_gradient.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_PROJECTED_GRADIENT_FACE = Int32(0)
const OBC_PROJECTED_GRADIENT_DISSERTATION = Int32(1)

const OBC_PROJECTED_GRADIENT_MAX_OF_LAST = Int32(0)
const OBC_PROJECTED_GRADIENT_AVERAGE = Int32(1)

const OBC_PROJECTED_GRADIENT_NEED_FG = Int32(1)
const OBC_PROJECTED_GRADIENT_ITERATION = Int32(2)
const OBC_PROJECTED_GRADIENT_DONE = Int32(3)

const OBC_PROJECTED_GRADIENT_RUNNING = Int32(0)
const OBC_PROJECTED_GRADIENT_CONVERGED = Int32(1)
const OBC_PROJECTED_GRADIENT_TARGET_REACHED = Int32(2)
const OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET = Int32(3)
const OBC_PROJECTED_GRADIENT_ITERATION_BUDGET = Int32(4)
const OBC_PROJECTED_GRADIENT_STALLED = Int32(5)
const OBC_PROJECTED_GRADIENT_INFEASIBLE = Int32(6)
const OBC_PROJECTED_GRADIENT_CANCELLED = Int32(7)
const OBC_PROJECTED_GRADIENT_EVALUATION_FAILED = Int32(8)
const OBC_PROJECTED_GRADIENT_PROJECTION_FAILED = Int32(9)
const OBC_PROJECTED_GRADIENT_UNBOUNDED = Int32(10)

const OBC_PROJECTED_GRADIENT_CONTINUE = Int32(0)
const OBC_PROJECTED_GRADIENT_STOP = Int32(1)
const OBC_PROJECTED_GRADIENT_FAILED = Int32(2)

mutable struct obc_projected_gradient_problem <: CStruct
    struct_size::UInt32
    n::Csize_t
    m::Csize_t
    lower::Ptr{Float64}
    upper::Ptr{Float64}
    row_start::Ptr{Csize_t}
    column::Ptr{UInt32}
    value::Ptr{Float64}
    b::Ptr{Float64}
    project::Ptr{Cvoid}
    project_user::Ptr{Cvoid}
    obc_projected_gradient_problem() = zeroed!(new())
end

mutable struct obc_projected_gradient_options <: CStruct
    struct_size::UInt32
    method::Int32
    line_search::Int32
    memory::UInt32
    history::UInt32
    average_weight::Float64
    gradient_tolerance::Float64
    target::Float64
    max_evaluations::UInt64
    max_iterations::UInt64
    obc_projected_gradient_options() = zeroed!(new())
end

mutable struct obc_projected_gradient_result <: CStruct
    struct_size::UInt32
    stop::Int32
    value::Float64
    projected_gradient::Float64
    equality_residual::Float64
    evaluations::UInt64
    failed_evaluations::UInt64
    iterations::UInt64
    projection_passes::UInt64
    certificate_gap::Float64
    obc_projected_gradient_result() = zeroed!(new())
end

mutable struct obc_projected_gradient_check <: CStruct
    struct_size::UInt32
    agrees::Int32
    worst::Csize_t
    told::Float64
    difference::Float64
    error::Float64
    uncertainty::Float64
    compared::Csize_t
    evaluations::UInt64
    obc_projected_gradient_check() = zeroed!(new())
end

const address_obc_projected_gradient_problem_init = Ref(C_NULL)
obc_projected_gradient_problem_init(problem, struct_size) =
    ccall(symbol(address_obc_projected_gradient_problem_init, :projected_gradient, :obc_projected_gradient_problem_init), Int32, (Ptr{obc_projected_gradient_problem}, Csize_t), problem, struct_size)

const address_obc_projected_gradient_options_init = Ref(C_NULL)
obc_projected_gradient_options_init(options, struct_size) =
    ccall(symbol(address_obc_projected_gradient_options_init, :projected_gradient, :obc_projected_gradient_options_init), Int32, (Ptr{obc_projected_gradient_options}, Csize_t), options, struct_size)

const address_obc_projected_gradient_create = Ref(C_NULL)
obc_projected_gradient_create(problem, options, x0, host, out, error) =
    ccall(symbol(address_obc_projected_gradient_create, :projected_gradient, :obc_projected_gradient_create), Int32, (Ptr{obc_projected_gradient_problem}, Ptr{obc_projected_gradient_options}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), problem, options, x0, host, out, error)

const address_obc_projected_gradient_step = Ref(C_NULL)
obc_projected_gradient_step(solver, x) =
    ccall(symbol(address_obc_projected_gradient_step, :projected_gradient, :obc_projected_gradient_step), Int32, (Ptr{Cvoid}, Ptr{Ptr{Float64}}), solver, x)

const address_obc_projected_gradient_tell = Ref(C_NULL)
obc_projected_gradient_tell(solver, value, gradient, error) =
    ccall(symbol(address_obc_projected_gradient_tell, :projected_gradient, :obc_projected_gradient_tell), Int32, (Ptr{Cvoid}, Float64, Ptr{Float64}, Ptr{obc_error}), solver, value, gradient, error)

const address_obc_projected_gradient_get_result = Ref(C_NULL)
obc_projected_gradient_get_result(solver, result, x, error) =
    ccall(symbol(address_obc_projected_gradient_get_result, :projected_gradient, :obc_projected_gradient_get_result), Int32, (Ptr{Cvoid}, Ptr{obc_projected_gradient_result}, Ptr{Float64}, Ptr{obc_error}), solver, result, x, error)

const address_obc_projected_gradient_multipliers = Ref(C_NULL)
obc_projected_gradient_multipliers(solver, multipliers, error) =
    ccall(symbol(address_obc_projected_gradient_multipliers, :projected_gradient, :obc_projected_gradient_multipliers), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), solver, multipliers, error)

const address_obc_projected_gradient_certificate = Ref(C_NULL)
obc_projected_gradient_certificate(solver, certificate, error) =
    ccall(symbol(address_obc_projected_gradient_certificate, :projected_gradient, :obc_projected_gradient_certificate), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), solver, certificate, error)

const address_obc_projected_gradient_save_size = Ref(C_NULL)
obc_projected_gradient_save_size(solver) =
    ccall(symbol(address_obc_projected_gradient_save_size, :projected_gradient, :obc_projected_gradient_save_size), Csize_t, (Ptr{Cvoid},), solver)

const address_obc_projected_gradient_save = Ref(C_NULL)
obc_projected_gradient_save(solver, blob, capacity, error) =
    ccall(symbol(address_obc_projected_gradient_save, :projected_gradient, :obc_projected_gradient_save), Int32, (Ptr{Cvoid}, Ptr{Cvoid}, Csize_t, Ptr{obc_error}), solver, blob, capacity, error)

const address_obc_projected_gradient_load = Ref(C_NULL)
obc_projected_gradient_load(problem, blob, size, host, out, error) =
    ccall(symbol(address_obc_projected_gradient_load, :projected_gradient, :obc_projected_gradient_load), Int32, (Ptr{obc_projected_gradient_problem}, Ptr{Cvoid}, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), problem, blob, size, host, out, error)

const address_obc_projected_gradient_destroy = Ref(C_NULL)
obc_projected_gradient_destroy(solver) =
    ccall(symbol(address_obc_projected_gradient_destroy, :projected_gradient, :obc_projected_gradient_destroy), Cvoid, (Ptr{Cvoid},), solver)

const address_obc_projected_gradient_minimize = Ref(C_NULL)
obc_projected_gradient_minimize(problem, options, f, user, x, result, host, error) =
    ccall(symbol(address_obc_projected_gradient_minimize, :projected_gradient, :obc_projected_gradient_minimize), Int32, (Ptr{obc_projected_gradient_problem}, Ptr{obc_projected_gradient_options}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_projected_gradient_result}, Ptr{obc_host}, Ptr{obc_error}), problem, options, f, user, x, result, host, error)

const address_obc_projected_gradient_project = Ref(C_NULL)
obc_projected_gradient_project(problem, y, x, multipliers, result, host, error) =
    ccall(symbol(address_obc_projected_gradient_project, :projected_gradient, :obc_projected_gradient_project), Int32, (Ptr{obc_projected_gradient_problem}, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_projected_gradient_result}, Ptr{obc_host}, Ptr{obc_error}), problem, y, x, multipliers, result, host, error)

const address_obc_projected_gradient_check_gradient = Ref(C_NULL)
obc_projected_gradient_check_gradient(problem, f, user, x, check, host, error) =
    ccall(symbol(address_obc_projected_gradient_check_gradient, :projected_gradient, :obc_projected_gradient_check_gradient), Int32, (Ptr{obc_projected_gradient_problem}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_projected_gradient_check}, Ptr{obc_host}, Ptr{obc_error}), problem, f, user, x, check, host, error)

const address_obc_projected_gradient_stop_name = Ref(C_NULL)
obc_projected_gradient_stop_name(stop) =
    ccall(symbol(address_obc_projected_gradient_stop_name, :projected_gradient, :obc_projected_gradient_stop_name), Cstring, (Int32,), stop)

const address_obc_projected_gradient_version = Ref(C_NULL)
obc_projected_gradient_version() =
    ccall(symbol(address_obc_projected_gradient_version, :projected_gradient, :obc_projected_gradient_version), UInt32, ())
