# What <orbicube/sphere_optimizer.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY = Int32(0)
const OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN = Int32(1)
const OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE = Int32(2)
const OBC_SPHERE_OPTIMIZER_DISSERTATION = Int32(3)
const OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON = Int32(4)

const OBC_SPHERE_OPTIMIZER_NEED_FG = Int32(1)
const OBC_SPHERE_OPTIMIZER_ITERATION = Int32(2)
const OBC_SPHERE_OPTIMIZER_DONE = Int32(3)
const OBC_SPHERE_OPTIMIZER_NEED_PRODUCT = Int32(4)

const OBC_SPHERE_OPTIMIZER_RUNNING = Int32(0)
const OBC_SPHERE_OPTIMIZER_CONVERGED = Int32(1)
const OBC_SPHERE_OPTIMIZER_TARGET_REACHED = Int32(2)
const OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET = Int32(3)
const OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET = Int32(4)
const OBC_SPHERE_OPTIMIZER_STALLED = Int32(5)
const OBC_SPHERE_OPTIMIZER_CANCELLED = Int32(6)
const OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED = Int32(7)

const OBC_SPHERE_OPTIMIZER_CONTINUE = Int32(0)
const OBC_SPHERE_OPTIMIZER_STOP = Int32(1)
const OBC_SPHERE_OPTIMIZER_FAILED = Int32(2)

const OBC_SPHERE_OPTIMIZER_AUTOMATIC = Int32(0)
const OBC_SPHERE_OPTIMIZER_QUEUE = Int32(1)
const OBC_SPHERE_OPTIMIZER_SWEEPS = Int32(2)

mutable struct obc_sphere_optimizer_options <: CStruct
    struct_size::UInt32
    method::Int32
    memory::UInt32
    history::UInt32
    gradient_tolerance::Float64
    target::Float64
    max_evaluations::UInt64
    max_iterations::UInt64
    starts::UInt64
    seed::UInt64
    hessian_products::Int32
    obc_sphere_optimizer_options() = zeroed!(new())
end

mutable struct obc_sphere_optimizer_result <: CStruct
    struct_size::UInt32
    stop::Int32
    value::Float64
    gradient_norm::Float64
    evaluations::UInt64
    failed_evaluations::UInt64
    iterations::UInt64
    starts::UInt64
    best_start::UInt64
    products::UInt64
    obc_sphere_optimizer_result() = zeroed!(new())
end

mutable struct obc_sphere_optimizer_blocks <: CStruct
    struct_size::UInt32
    dimension::UInt32
    count::Csize_t
    neighbor_start::Ptr{Csize_t}
    neighbor::Ptr{UInt32}
    obc_sphere_optimizer_blocks() = zeroed!(new())
end

mutable struct obc_sphere_optimizer_relaxation_options <: CStruct
    struct_size::UInt32
    method::Int32
    second_order::Int32
    order::Int32
    gradient_tolerance::Float64
    relative_gain::Float64
    over_relaxation::Float64
    max_passes::UInt64
    obc_sphere_optimizer_relaxation_options() = zeroed!(new())
end

mutable struct obc_sphere_optimizer_relaxation_result <: CStruct
    struct_size::UInt32
    stop::Int32
    gain::Float64
    gradient_norm::Float64
    steps::UInt64
    evaluations::UInt64
    failed_steps::UInt64
    over_relaxation::Float64
    obc_sphere_optimizer_relaxation_result() = zeroed!(new())
end

const address_obc_sphere_optimizer_options_init = Ref(C_NULL)
obc_sphere_optimizer_options_init(options, struct_size) =
    ccall(symbol(address_obc_sphere_optimizer_options_init, :sphere_optimizer, :obc_sphere_optimizer_options_init), Int32, (Ptr{obc_sphere_optimizer_options}, Csize_t), options, struct_size)

const address_obc_sphere_optimizer_create = Ref(C_NULL)
obc_sphere_optimizer_create(count, dimension, options, x0, host, out, error) =
    ccall(symbol(address_obc_sphere_optimizer_create, :sphere_optimizer, :obc_sphere_optimizer_create), Int32, (Csize_t, Csize_t, Ptr{obc_sphere_optimizer_options}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), count, dimension, options, x0, host, out, error)

const address_obc_sphere_optimizer_step = Ref(C_NULL)
obc_sphere_optimizer_step(solver, x) =
    ccall(symbol(address_obc_sphere_optimizer_step, :sphere_optimizer, :obc_sphere_optimizer_step), Int32, (Ptr{Cvoid}, Ptr{Ptr{Float64}}), solver, x)

const address_obc_sphere_optimizer_tell = Ref(C_NULL)
obc_sphere_optimizer_tell(solver, value, gradient, error) =
    ccall(symbol(address_obc_sphere_optimizer_tell, :sphere_optimizer, :obc_sphere_optimizer_tell), Int32, (Ptr{Cvoid}, Float64, Ptr{Float64}, Ptr{obc_error}), solver, value, gradient, error)

const address_obc_sphere_optimizer_get_direction = Ref(C_NULL)
obc_sphere_optimizer_get_direction(solver, direction, error) =
    ccall(symbol(address_obc_sphere_optimizer_get_direction, :sphere_optimizer, :obc_sphere_optimizer_get_direction), Int32, (Ptr{Cvoid}, Ptr{Ptr{Float64}}, Ptr{obc_error}), solver, direction, error)

const address_obc_sphere_optimizer_tell_product = Ref(C_NULL)
obc_sphere_optimizer_tell_product(solver, product, error) =
    ccall(symbol(address_obc_sphere_optimizer_tell_product, :sphere_optimizer, :obc_sphere_optimizer_tell_product), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), solver, product, error)

const address_obc_sphere_optimizer_get_result = Ref(C_NULL)
obc_sphere_optimizer_get_result(solver, result, x, error) =
    ccall(symbol(address_obc_sphere_optimizer_get_result, :sphere_optimizer, :obc_sphere_optimizer_get_result), Int32, (Ptr{Cvoid}, Ptr{obc_sphere_optimizer_result}, Ptr{Float64}, Ptr{obc_error}), solver, result, x, error)

const address_obc_sphere_optimizer_get_shape = Ref(C_NULL)
obc_sphere_optimizer_get_shape(solver, count, dimension, error) =
    ccall(symbol(address_obc_sphere_optimizer_get_shape, :sphere_optimizer, :obc_sphere_optimizer_get_shape), Int32, (Ptr{Cvoid}, Ptr{Csize_t}, Ptr{Csize_t}, Ptr{obc_error}), solver, count, dimension, error)

const address_obc_sphere_optimizer_save_size = Ref(C_NULL)
obc_sphere_optimizer_save_size(solver) =
    ccall(symbol(address_obc_sphere_optimizer_save_size, :sphere_optimizer, :obc_sphere_optimizer_save_size), Csize_t, (Ptr{Cvoid},), solver)

const address_obc_sphere_optimizer_save = Ref(C_NULL)
obc_sphere_optimizer_save(solver, blob, capacity, error) =
    ccall(symbol(address_obc_sphere_optimizer_save, :sphere_optimizer, :obc_sphere_optimizer_save), Int32, (Ptr{Cvoid}, Ptr{Cvoid}, Csize_t, Ptr{obc_error}), solver, blob, capacity, error)

const address_obc_sphere_optimizer_load = Ref(C_NULL)
obc_sphere_optimizer_load(blob, size, host, out, error) =
    ccall(symbol(address_obc_sphere_optimizer_load, :sphere_optimizer, :obc_sphere_optimizer_load), Int32, (Ptr{Cvoid}, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), blob, size, host, out, error)

const address_obc_sphere_optimizer_destroy = Ref(C_NULL)
obc_sphere_optimizer_destroy(solver) =
    ccall(symbol(address_obc_sphere_optimizer_destroy, :sphere_optimizer, :obc_sphere_optimizer_destroy), Cvoid, (Ptr{Cvoid},), solver)

const address_obc_sphere_optimizer_minimize = Ref(C_NULL)
obc_sphere_optimizer_minimize(count, dimension, options, f, user, x, result, host, error) =
    ccall(symbol(address_obc_sphere_optimizer_minimize, :sphere_optimizer, :obc_sphere_optimizer_minimize), Int32, (Csize_t, Csize_t, Ptr{obc_sphere_optimizer_options}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_sphere_optimizer_result}, Ptr{obc_host}, Ptr{obc_error}), count, dimension, options, f, user, x, result, host, error)

const address_obc_sphere_optimizer_minimize_second_order = Ref(C_NULL)
obc_sphere_optimizer_minimize_second_order(count, dimension, options, f, product, user, x, result, host, error) =
    ccall(symbol(address_obc_sphere_optimizer_minimize_second_order, :sphere_optimizer, :obc_sphere_optimizer_minimize_second_order), Int32, (Csize_t, Csize_t, Ptr{obc_sphere_optimizer_options}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_sphere_optimizer_result}, Ptr{obc_host}, Ptr{obc_error}), count, dimension, options, f, product, user, x, result, host, error)

const address_obc_sphere_optimizer_blocks_init = Ref(C_NULL)
obc_sphere_optimizer_blocks_init(blocks, struct_size) =
    ccall(symbol(address_obc_sphere_optimizer_blocks_init, :sphere_optimizer, :obc_sphere_optimizer_blocks_init), Int32, (Ptr{obc_sphere_optimizer_blocks}, Csize_t), blocks, struct_size)

const address_obc_sphere_optimizer_relaxation_options_init = Ref(C_NULL)
obc_sphere_optimizer_relaxation_options_init(options, struct_size) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_options_init, :sphere_optimizer, :obc_sphere_optimizer_relaxation_options_init), Int32, (Ptr{obc_sphere_optimizer_relaxation_options}, Csize_t), options, struct_size)

const address_obc_sphere_optimizer_relax = Ref(C_NULL)
obc_sphere_optimizer_relax(blocks, options, f, user, x, result, host, error) =
    ccall(symbol(address_obc_sphere_optimizer_relax, :sphere_optimizer, :obc_sphere_optimizer_relax), Int32, (Ptr{obc_sphere_optimizer_blocks}, Ptr{obc_sphere_optimizer_relaxation_options}, Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_sphere_optimizer_relaxation_result}, Ptr{obc_host}, Ptr{obc_error}), blocks, options, f, user, x, result, host, error)

const address_obc_sphere_optimizer_relaxation_create = Ref(C_NULL)
obc_sphere_optimizer_relaxation_create(blocks, options, x0, host, out, error) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_create, :sphere_optimizer, :obc_sphere_optimizer_relaxation_create), Int32, (Ptr{obc_sphere_optimizer_blocks}, Ptr{obc_sphere_optimizer_relaxation_options}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), blocks, options, x0, host, out, error)

const address_obc_sphere_optimizer_relaxation_run = Ref(C_NULL)
obc_sphere_optimizer_relaxation_run(relaxation, f, user, steps, error) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_run, :sphere_optimizer, :obc_sphere_optimizer_relaxation_run), Int32, (Ptr{Cvoid}, Ptr{Cvoid}, Ptr{Cvoid}, UInt64, Ptr{obc_error}), relaxation, f, user, steps, error)

const address_obc_sphere_optimizer_relaxation_get_result = Ref(C_NULL)
obc_sphere_optimizer_relaxation_get_result(relaxation, result, x, error) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_get_result, :sphere_optimizer, :obc_sphere_optimizer_relaxation_get_result), Int32, (Ptr{Cvoid}, Ptr{obc_sphere_optimizer_relaxation_result}, Ptr{Float64}, Ptr{obc_error}), relaxation, result, x, error)

const address_obc_sphere_optimizer_relaxation_save_size = Ref(C_NULL)
obc_sphere_optimizer_relaxation_save_size(relaxation) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_save_size, :sphere_optimizer, :obc_sphere_optimizer_relaxation_save_size), Csize_t, (Ptr{Cvoid},), relaxation)

const address_obc_sphere_optimizer_relaxation_save = Ref(C_NULL)
obc_sphere_optimizer_relaxation_save(relaxation, blob, capacity, error) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_save, :sphere_optimizer, :obc_sphere_optimizer_relaxation_save), Int32, (Ptr{Cvoid}, Ptr{Cvoid}, Csize_t, Ptr{obc_error}), relaxation, blob, capacity, error)

const address_obc_sphere_optimizer_relaxation_load = Ref(C_NULL)
obc_sphere_optimizer_relaxation_load(blocks, blob, size, host, out, error) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_load, :sphere_optimizer, :obc_sphere_optimizer_relaxation_load), Int32, (Ptr{obc_sphere_optimizer_blocks}, Ptr{Cvoid}, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), blocks, blob, size, host, out, error)

const address_obc_sphere_optimizer_relaxation_destroy = Ref(C_NULL)
obc_sphere_optimizer_relaxation_destroy(relaxation) =
    ccall(symbol(address_obc_sphere_optimizer_relaxation_destroy, :sphere_optimizer, :obc_sphere_optimizer_relaxation_destroy), Cvoid, (Ptr{Cvoid},), relaxation)

const address_obc_sphere_optimizer_stop_name = Ref(C_NULL)
obc_sphere_optimizer_stop_name(stop) =
    ccall(symbol(address_obc_sphere_optimizer_stop_name, :sphere_optimizer, :obc_sphere_optimizer_stop_name), Cstring, (Int32,), stop)

const address_obc_sphere_optimizer_version = Ref(C_NULL)
obc_sphere_optimizer_version() =
    ccall(symbol(address_obc_sphere_optimizer_version, :sphere_optimizer, :obc_sphere_optimizer_version), UInt32, ())
