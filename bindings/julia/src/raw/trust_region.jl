# What <orbicube/trust_region.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_TRUST_REGION_TWO_RADII = Int32(0)
const OBC_TRUST_REGION_DISSERTATION = Int32(1)

const OBC_TRUST_REGION_AUTOMATIC = Int32(0)
const OBC_TRUST_REGION_CHAIN = Int32(1)
const OBC_TRUST_REGION_CROSS = Int32(2)

const OBC_TRUST_REGION_SUM_OF_SQUARES = Int32(0)
const OBC_TRUST_REGION_SUM_OF_MAGNITUDES = Int32(1)
const OBC_TRUST_REGION_MAX_MAGNITUDE = Int32(2)
const OBC_TRUST_REGION_MAX_VALUE = Int32(3)

const OBC_TRUST_REGION_NEED_VALUES = Int32(1)
const OBC_TRUST_REGION_ITERATION = Int32(2)
const OBC_TRUST_REGION_DONE = Int32(3)

const OBC_TRUST_REGION_RUNNING = Int32(0)
const OBC_TRUST_REGION_CONVERGED = Int32(1)
const OBC_TRUST_REGION_TARGET_REACHED = Int32(2)
const OBC_TRUST_REGION_EVALUATION_BUDGET = Int32(3)
const OBC_TRUST_REGION_NOISE_LIMIT = Int32(4)
const OBC_TRUST_REGION_STALLED = Int32(5)
const OBC_TRUST_REGION_CANCELLED = Int32(6)
const OBC_TRUST_REGION_EVALUATION_FAILED = Int32(7)
const OBC_TRUST_REGION_RESOLUTION_LIMIT = Int32(8)

const OBC_TRUST_REGION_CONTINUE = Int32(0)
const OBC_TRUST_REGION_STOP = Int32(1)
const OBC_TRUST_REGION_FAILED = Int32(2)

mutable struct obc_trust_region_problem <: CStruct
    struct_size::UInt32
    n::Csize_t
    residuals::Csize_t
    lower::Ptr{Float64}
    upper::Ptr{Float64}
    scale::Ptr{Float64}
    sign::Ptr{Float64}
    objective::Int32
    obc_trust_region_problem() = zeroed!(new())
end

mutable struct obc_trust_region_options <: CStruct
    struct_size::UInt32
    method::Int32
    start::Int32
    points::UInt64
    radius_begin::Float64
    radius_end::Float64
    target::Float64
    noise_absolute::Float64
    noise_relative::Float64
    restarts::UInt64
    max_evaluations::UInt64
    obc_trust_region_options() = zeroed!(new())
end

mutable struct obc_trust_region_result <: CStruct
    struct_size::UInt32
    stop::Int32
    value::Float64
    radius::Float64
    resolution::Float64
    evaluations::UInt64
    failed_evaluations::UInt64
    iterations::UInt64
    restarts::UInt64
    points::UInt64
    rebuilds::UInt64
    obc_trust_region_result() = zeroed!(new())
end

const address_obc_trust_region_problem_init = Ref(C_NULL)
obc_trust_region_problem_init(problem, struct_size) =
    ccall(symbol(address_obc_trust_region_problem_init, :trust_region, :obc_trust_region_problem_init), Int32, (Ptr{obc_trust_region_problem}, Csize_t), problem, struct_size)

const address_obc_trust_region_options_init = Ref(C_NULL)
obc_trust_region_options_init(options, struct_size) =
    ccall(symbol(address_obc_trust_region_options_init, :trust_region, :obc_trust_region_options_init), Int32, (Ptr{obc_trust_region_options}, Csize_t), options, struct_size)

const address_obc_trust_region_create = Ref(C_NULL)
obc_trust_region_create(problem, options, x0, host, out, error) =
    ccall(symbol(address_obc_trust_region_create, :trust_region, :obc_trust_region_create), Int32, (Ptr{obc_trust_region_problem}, Ptr{obc_trust_region_options}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), problem, options, x0, host, out, error)

const address_obc_trust_region_give = Ref(C_NULL)
obc_trust_region_give(solver, points, outputs, count, error) =
    ccall(symbol(address_obc_trust_region_give, :trust_region, :obc_trust_region_give), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{obc_error}), solver, points, outputs, count, error)

const address_obc_trust_region_step = Ref(C_NULL)
obc_trust_region_step(solver, points, count) =
    ccall(symbol(address_obc_trust_region_step, :trust_region, :obc_trust_region_step), Int32, (Ptr{Cvoid}, Ptr{Ptr{Float64}}, Ptr{Csize_t}), solver, points, count)

const address_obc_trust_region_tell = Ref(C_NULL)
obc_trust_region_tell(solver, outputs, error) =
    ccall(symbol(address_obc_trust_region_tell, :trust_region, :obc_trust_region_tell), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), solver, outputs, error)

const address_obc_trust_region_get_result = Ref(C_NULL)
obc_trust_region_get_result(solver, result, x, outputs, error) =
    ccall(symbol(address_obc_trust_region_get_result, :trust_region, :obc_trust_region_get_result), Int32, (Ptr{Cvoid}, Ptr{obc_trust_region_result}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), solver, result, x, outputs, error)

const address_obc_trust_region_save_size = Ref(C_NULL)
obc_trust_region_save_size(solver) =
    ccall(symbol(address_obc_trust_region_save_size, :trust_region, :obc_trust_region_save_size), Csize_t, (Ptr{Cvoid},), solver)

const address_obc_trust_region_save = Ref(C_NULL)
obc_trust_region_save(solver, blob, capacity, error) =
    ccall(symbol(address_obc_trust_region_save, :trust_region, :obc_trust_region_save), Int32, (Ptr{Cvoid}, Ptr{Cvoid}, Csize_t, Ptr{obc_error}), solver, blob, capacity, error)

const address_obc_trust_region_load = Ref(C_NULL)
obc_trust_region_load(problem, blob, size, host, out, error) =
    ccall(symbol(address_obc_trust_region_load, :trust_region, :obc_trust_region_load), Int32, (Ptr{obc_trust_region_problem}, Ptr{Cvoid}, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), problem, blob, size, host, out, error)

const address_obc_trust_region_destroy = Ref(C_NULL)
obc_trust_region_destroy(solver) =
    ccall(symbol(address_obc_trust_region_destroy, :trust_region, :obc_trust_region_destroy), Cvoid, (Ptr{Cvoid},), solver)

const address_obc_trust_region_minimize = Ref(C_NULL)
obc_trust_region_minimize(problem, options, f, user, x, result, host, error) =
    ccall(symbol(address_obc_trust_region_minimize, :trust_region, :obc_trust_region_minimize), Int32, (Ptr{obc_trust_region_problem}, Ptr{obc_trust_region_options}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_trust_region_result}, Ptr{obc_host}, Ptr{obc_error}), problem, options, f, user, x, result, host, error)

const address_obc_trust_region_stop_name = Ref(C_NULL)
obc_trust_region_stop_name(stop) =
    ccall(symbol(address_obc_trust_region_stop_name, :trust_region, :obc_trust_region_stop_name), Cstring, (Int32,), stop)

const address_obc_trust_region_version = Ref(C_NULL)
obc_trust_region_version() =
    ccall(symbol(address_obc_trust_region_version, :trust_region, :obc_trust_region_version), UInt32, ())
