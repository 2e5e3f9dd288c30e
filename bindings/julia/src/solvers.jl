# The solvers: optimize with functions, as in Optim; and by reverse communication.

abstract type Method end

"Minimizes without derivatives, within bounds. Options are the members of `obc_trust_region_options`."
struct TrustRegion{O} <: Method
    options::O
end
TrustRegion(; options...) = TrustRegion(values(options))

"Minimizes with gradients, subject to bounds and `A x = b`. Options are the members of `obc_projected_gradient_options`."
struct ProjectedGradient{O} <: Method
    options::O
end
ProjectedGradient(; options...) = ProjectedGradient(values(options))

"Minimizes with gradients over unit vectors, the columns of x. Options are the members of `obc_sphere_optimizer_options`."
struct SphereOptimizer{O} <: Method
    options::O
end
SphereOptimizer(; options...) = SphereOptimizer(values(options))

"The end of a run; query it with `minimizer`, `minimum`, `converged`, `iterations`, `f_calls`, `stop_reason` and `report`."
struct Result{X,R}
    x::X
    report::R
    stop::String
end
minimizer(result::Result) = result.x
Base.minimum(result::Result) = result.report.value
converged(result::Result) = result.stop == "converged"
iterations(result::Result) = Int(result.report.iterations)
f_calls(result::Result) = Int(result.report.evaluations)
stop_reason(result::Result) = result.stop
report(result::Result) = result.report
Base.show(io::IO, result::Result) = print(io, "Result: ", result.stop, " after ", f_calls(result), " evaluations, minimum ",
                                          minimum(result), " at ", minimizer(result))

"A function that returns the value and fills the gradient: `fg!(G, x)`."
struct ValueAndGradient{F}
    fg!::F
end
only_fg!(fg!) = ValueAndGradient(fg!)

"The same, and a function that fills the product of the Hessian at x, as a function of all numbers of x, and v: `hv!(Hv, x, v)`."
struct ValueGradientAndProduct{F,H}
    fg!::F
    hv!::H
end
only_fg_and_hv!(fg!, hv!) = ValueGradientAndProduct(fg!, hv!)

# -- what C calls --------------------------------------------------------------------------------------------------------------

mutable struct Called{F,N}
    f::F
    x::Array{Float64,N}       # what the function is given, ours to the end of the run
    output::Array{Float64,N}  # what it fills
    caught::Caught
end

function answered(f, called, stopped=_ -> nothing)::Int32
    try
        f()
        Int32(0)
    catch error
        error isa EvaluationFailed && return Int32(2)
        if error isa StopRun
            stopped(error)
            return Int32(1)
        end
        keep!(called.caught, error)
    end
end

function value_called(x::Ptr{Float64}, n::Csize_t, output::Ptr{Float64}, called::Called)::Int32
    unsafe_copyto!(pointer(called.x), x, n)
    answered(() -> unsafe_store!(output, convert(Float64, called.f(called.x))), called, stop -> unsafe_store!(output, stop.value))
end

function residuals_called(x::Ptr{Float64}, n::Csize_t, output::Ptr{Float64}, called::Called)::Int32
    unsafe_copyto!(pointer(called.x), x, n)
    fill!(called.output, NaN)  # what is not filled before a StopRun does not count
    told(_=nothing) = unsafe_copyto!(output, pointer(called.output), length(called.output))
    answered(called, told) do
        called.f(called.output, called.x)
        told()
    end
end

function gradient_called(x::Ptr{Float64}, n::Csize_t, value::Ptr{Float64}, gradient::Ptr{Float64}, called::Called)::Int32
    unsafe_copyto!(pointer(called.x), x, n)
    answered(called, stop -> unsafe_store!(value, stop.value)) do
        unsafe_store!(value, convert(Float64, called.f(called.output, called.x)))
        unsafe_copyto!(gradient, pointer(called.output), length(called.output))
    end
end

spheres_called(x::Ptr{Float64}, count::Csize_t, dimension::Csize_t, value::Ptr{Float64}, gradient::Ptr{Float64},
               called::Called)::Int32 = gradient_called(x, count * dimension, value, gradient, called)

mutable struct CalledProduct{F,H}
    f::Called{F,2}
    hv!::H
    direction::Matrix{Float64}
end

product_value_called(x::Ptr{Float64}, count::Csize_t, dimension::Csize_t, value::Ptr{Float64}, gradient::Ptr{Float64},
                     called::CalledProduct)::Int32 = gradient_called(x, count * dimension, value, gradient, called.f)

function product_called(x::Ptr{Float64}, direction::Ptr{Float64}, count::Csize_t, dimension::Csize_t, product::Ptr{Float64},
                        called::CalledProduct)::Int32
    unsafe_copyto!(pointer(called.f.x), x, count * dimension)
    unsafe_copyto!(pointer(called.direction), direction, count * dimension)
    answered(called.f) do
        called.hv!(called.f.output, called.f.x, called.direction)
        unsafe_copyto!(product, pointer(called.f.output), length(called.f.output))
    end
end

product_value_function(::C) where {C} =
    @cfunction(product_value_called, Int32, (Ptr{Float64}, Csize_t, Csize_t, Ptr{Float64}, Ptr{Float64}, Ref{C}))
product_function(::C) where {C} =
    @cfunction(product_called, Int32, (Ptr{Float64}, Ptr{Float64}, Csize_t, Csize_t, Ptr{Float64}, Ref{C}))
value_function(::C) where {C} = @cfunction(value_called, Int32, (Ptr{Float64}, Csize_t, Ptr{Float64}, Ref{C}))
residuals_function(::C) where {C} = @cfunction(residuals_called, Int32, (Ptr{Float64}, Csize_t, Ptr{Float64}, Ref{C}))
gradient_function(::C) where {C} =
    @cfunction(gradient_called, Int32, (Ptr{Float64}, Csize_t, Ptr{Float64}, Ptr{Float64}, Ref{C}))
spheres_function(::C) where {C} =
    @cfunction(spheres_called, Int32, (Ptr{Float64}, Csize_t, Csize_t, Ptr{Float64}, Ptr{Float64}, Ref{C}))

# -- problems ------------------------------------------------------------------------------------------------------------------

entries(value::Nothing, n) = nothing
entries(value::Real, n) = fill(Float64(value), n)
function entries(value, n)
    array = doubles(value)
    expect(length(array), n, "bounds, scale or sign")
    array
end
place(value::Nothing) = Ptr{Float64}(C_NULL)
place(value) = pointer(value)

# A C struct with the arrays that it points at.
struct Problem{T}
    c::T
    kept::Vector{Any}
end

# What f is of residuals.
const objectives = [:sum_of_squares => Raw.OBC_TRUST_REGION_SUM_OF_SQUARES, :sum_of_magnitudes => Raw.OBC_TRUST_REGION_SUM_OF_MAGNITUDES,
                    :max_magnitude => Raw.OBC_TRUST_REGION_MAX_MAGNITUDE, :max_value => Raw.OBC_TRUST_REGION_MAX_VALUE]

function trust_region_problem(n, residuals; lower=nothing, upper=nothing, scale=nothing, sign=nothing,
                              objective=:sum_of_squares)
    c = filled(Raw.obc_trust_region_problem, Raw.obc_trust_region_problem_init, NamedTuple())
    c.objective = chosen_word(:objective, objective, objectives)
    kept = Any[entries(lower, n), entries(upper, n), entries(scale, n), entries(sign, residuals)]
    c.n, c.residuals = n, residuals
    c.lower, c.upper, c.scale, c.sign = place.(kept)
    Problem(c, kept)
end

function projected_gradient_problem(n; lower=nothing, upper=nothing, A=nothing, b=nothing)
    c = filled(Raw.obc_projected_gradient_problem, Raw.obc_projected_gradient_problem_init, NamedTuple())
    kept = Any[entries(lower, n), entries(upper, n)]
    c.n = n
    c.lower, c.upper = place.(kept)
    if A !== nothing
        size(A, 2) == n || throw(DimensionMismatch("A: $n columns are needed, not $(size(A))"))
        start, column, value = Csize_t[0], UInt32[], Float64[]
        for i in 1:size(A, 1)
            for j in 1:n
                if A[i, j] != 0
                    push!(column, j - 1)
                    push!(value, A[i, j])
                end
            end
            push!(start, length(column))
        end
        b === nothing && throw(ArgumentError("A without b"))
        right = entries(b, size(A, 1))
        append!(kept, Any[start, column, value, right])
        c.m = size(A, 1)
        c.row_start, c.column, c.value, c.b = pointer(start), pointer(column), pointer(value), pointer(right)
    end
    Problem(c, kept)
end

function finished(f, called, result, x, name)
    error = Raw.obc_error()
    status = GC.@preserve called f(error)
    rethrown(called.caught)
    check(status, error)
    Result(x, result, text(name(result.stop)))
end

# -- optimize ------------------------------------------------------------------------------------------------------------------

"""
    optimize(f, x0, TrustRegion(); lower, upper, scale)
    optimize(only_fg!(fg!), x0, ProjectedGradient(); lower, upper, A, b)
    optimize(f, g!, x0, ProjectedGradient(); ...)
    optimize(only_fg!(fg!), x0, SphereOptimizer())

The minimum value that is found from x0. `fg!(G, x)` fills the gradient and returns the value; `g!(G, x)` only fills it. The x that
functions are given is used again. For ProjectedGradient also `optimize(..., lower, upper, x0, method)`, as in Optim.
"""
function optimize(f, x0::AbstractVector, method::TrustRegion; problem...)
    x = Vector{Float64}(x0)
    options = filled(Raw.obc_trust_region_options, Raw.obc_trust_region_options_init, method.options, "OBC_TRUST_REGION_")
    set = trust_region_problem(length(x), 0; problem...)
    called = Called(f, similar(x), similar(x), Caught())
    result = sized(Raw.obc_trust_region_result)
    finished(called, result, x, Raw.obc_trust_region_stop_name) do error
        GC.@preserve set Raw.obc_trust_region_minimize(set.c, options, value_function(called), pointer_from_objref(called), x,
                                                       result, C_NULL, error)
    end
end

"""
    least_squares(r!, count, x0, TrustRegion(); lower, upper, scale, sign, objective=:sum_of_squares)

The minimum sum of squares of `count` residuals, which `r!(R, x)` fills, with signs 1 or -1 if they are given. With another `objective`,
`:sum_of_magnitudes`, `:max_magnitude` or `:max_value`, the minimum of that function of the residuals.
"""
function least_squares(r!, count::Integer, x0::AbstractVector, method::TrustRegion=TrustRegion(); problem...)
    count > 0 || throw(ArgumentError("no residuals"))
    x = Vector{Float64}(x0)
    options = filled(Raw.obc_trust_region_options, Raw.obc_trust_region_options_init, method.options, "OBC_TRUST_REGION_")
    set = trust_region_problem(length(x), count; problem...)
    called = Called(r!, similar(x), Vector{Float64}(undef, count), Caught())
    result = sized(Raw.obc_trust_region_result)
    finished(called, result, x, Raw.obc_trust_region_stop_name) do error
        GC.@preserve set Raw.obc_trust_region_minimize(set.c, options, residuals_function(called), pointer_from_objref(called), x,
                                                       result, C_NULL, error)
    end
end

function optimize(f::ValueAndGradient, x0::AbstractVector, method::ProjectedGradient; problem...)
    x = Vector{Float64}(x0)
    options = filled(Raw.obc_projected_gradient_options, Raw.obc_projected_gradient_options_init, method.options,
                     "OBC_PROJECTED_GRADIENT_")
    set = projected_gradient_problem(length(x); problem...)
    called = Called(f.fg!, similar(x), similar(x), Caught())
    result = sized(Raw.obc_projected_gradient_result)
    finished(called, result, x, Raw.obc_projected_gradient_stop_name) do error
        GC.@preserve set Raw.obc_projected_gradient_minimize(set.c, options, gradient_function(called),
                                                             pointer_from_objref(called), x, result, C_NULL, error)
    end
end

function optimize(f::ValueAndGradient, x0::AbstractMatrix, method::SphereOptimizer)
    x = Matrix{Float64}(x0)
    options = filled(Raw.obc_sphere_optimizer_options, Raw.obc_sphere_optimizer_options_init, method.options,
                     "OBC_SPHERE_OPTIMIZER_")
    called = Called(f.fg!, similar(x), similar(x), Caught())
    result = sized(Raw.obc_sphere_optimizer_result)
    finished(called, result, x, Raw.obc_sphere_optimizer_stop_name) do error
        Raw.obc_sphere_optimizer_minimize(size(x, 2), size(x, 1), options, spheres_function(called),
                                          pointer_from_objref(called), x, result, C_NULL, error)
    end
end

function optimize(f::ValueGradientAndProduct, x0::AbstractMatrix, method::SphereOptimizer)
    x = Matrix{Float64}(x0)
    options = filled(Raw.obc_sphere_optimizer_options, Raw.obc_sphere_optimizer_options_init, method.options,
                     "OBC_SPHERE_OPTIMIZER_")
    called = CalledProduct(Called(f.fg!, similar(x), similar(x), Caught()), f.hv!, similar(x))
    result = sized(Raw.obc_sphere_optimizer_result)
    finished(called.f, result, x, Raw.obc_sphere_optimizer_stop_name) do error
        GC.@preserve called Raw.obc_sphere_optimizer_minimize_second_order(
            size(x, 2), size(x, 1), options, product_value_function(called), product_function(called),
            pointer_from_objref(called), x, result, C_NULL, error)
    end
end

both(f, g!) = only_fg!((G, x) -> (g!(G, x); f(x)))
optimize(f, g!, x0::AbstractArray, method::Union{ProjectedGradient,SphereOptimizer}; problem...) =
    optimize(both(f, g!), x0, method; problem...)
optimize(f, g!, lower::AbstractVector, upper::AbstractVector, x0::AbstractVector, method::ProjectedGradient; problem...) =
    optimize(both(f, g!), x0, method; lower=lower, upper=upper, problem...)
optimize(f, lower::AbstractVector, upper::AbstractVector, x0::AbstractVector, method::Union{TrustRegion,ProjectedGradient};
         problem...) = optimize(f, x0, method; lower=lower, upper=upper, problem...)

"The point of the set that is nearest to y, and the multipliers of the rows."
function project(y::AbstractVector; threads=0, progress=nothing, problem...)
    set = projected_gradient_problem(length(y); problem...)
    point = Vector{Float64}(y)
    x, multipliers = similar(point), Vector{Float64}(undef, set.c.m)
    result = sized(Raw.obc_projected_gradient_result)
    hosted(threads=threads, progress=progress) do host, error
        GC.@preserve set Raw.obc_projected_gradient_project(set.c, point, x, multipliers, result, host, error)
    end
    x, multipliers
end

# -- by reverse communication --------------------------------------------------------------------------------------------------

"""
    Run(x0, method; ...)                    the arguments of optimize; residuals=count for least squares
    while (x = ask!(run)) !== nothing
        tell!(run, f(x))                    or tell!(run, residuals), or tell!(run, value, gradient)
    end
    result(run)

A run whose evaluations are made by whatever program. `save(run)` gives bytes, `load(bytes, x0, method; ...)` goes on from them.
"""
mutable struct Run{M,N}
    handle::Ptr{Cvoid}
    set::Any
    x::Array{Float64,N}
    outputs::Int
end

start(x0, ::TrustRegion; residuals=0, problem...) = trust_region_problem(length(x0), residuals; problem...)
start(x0, ::ProjectedGradient; problem...) = projected_gradient_problem(length(x0); problem...)
start(x0::AbstractMatrix, ::SphereOptimizer) = nothing
start(x0, ::SphereOptimizer) = throw(DimensionMismatch("x0: a column a sphere is needed, not $(size(x0))"))

function opened(handle, set, x, method::M, outputs) where {M}
    run = Run{M,ndims(x)}(handle, set, x, outputs)
    finalizer(run) do it
        released(M <: TrustRegion ? Raw.obc_trust_region_destroy :
                 M <: ProjectedGradient ? Raw.obc_projected_gradient_destroy : Raw.obc_sphere_optimizer_destroy, it.handle)
    end
end

function Run(x0::AbstractArray, method::Method; residuals=0, problem...)
    x = Array{Float64}(x0)
    set = residuals > 0 ? start(x, method; residuals=residuals, problem...) : start(x, method; problem...)
    out = Ref(C_NULL)
    if method isa TrustRegion
        options = filled(Raw.obc_trust_region_options, Raw.obc_trust_region_options_init, method.options, "OBC_TRUST_REGION_")
        checked(error -> GC.@preserve set Raw.obc_trust_region_create(set.c, options, x, C_NULL, out, error))
    elseif method isa ProjectedGradient
        options = filled(Raw.obc_projected_gradient_options, Raw.obc_projected_gradient_options_init, method.options,
                         "OBC_PROJECTED_GRADIENT_")
        checked(error -> GC.@preserve set Raw.obc_projected_gradient_create(set.c, options, x, C_NULL, out, error))
    else
        options = filled(Raw.obc_sphere_optimizer_options, Raw.obc_sphere_optimizer_options_init, method.options,
                         "OBC_SPHERE_OPTIMIZER_")
        checked(error -> Raw.obc_sphere_optimizer_create(size(x, 2), size(x, 1), options, x, C_NULL, out, error))
    end
    opened(out[], set, x, method, max(residuals, 1))
end

"Goes on with a run that was saved, of the same problem; of x0 only the size counts."
function load(bytes::Vector{UInt8}, x0::AbstractArray, method::Method; residuals=0, problem...)
    x = Array{Float64}(x0)
    set = residuals > 0 ? start(x, method; residuals=residuals, problem...) : start(x, method; problem...)
    out = Ref(C_NULL)
    if method isa TrustRegion
        checked(error -> GC.@preserve set Raw.obc_trust_region_load(set.c, bytes, length(bytes), C_NULL, out, error))
    elseif method isa ProjectedGradient
        checked(error -> GC.@preserve set Raw.obc_projected_gradient_load(set.c, bytes, length(bytes), C_NULL, out, error))
    else
        checked(error -> Raw.obc_sphere_optimizer_load(bytes, length(bytes), C_NULL, out, error))
        count, dimension = Ref(Csize_t(0)), Ref(Csize_t(0))
        checked(error -> Raw.obc_sphere_optimizer_get_shape(out[], count, dimension, error))
        x = Matrix{Float64}(undef, dimension[], count[])
    end
    opened(out[], set, x, method, max(residuals, 1))
end

step!(run::Run{<:TrustRegion}, x) = Raw.obc_trust_region_step(run.handle, x, C_NULL)
step!(run::Run{<:ProjectedGradient}, x) = Raw.obc_projected_gradient_step(run.handle, x)
step!(run::Run{<:SphereOptimizer}, x) = Raw.obc_sphere_optimizer_step(run.handle, x)

"The point that is queried, a copy; `nothing` when the run has ended."
function ask!(run::Run)
    x = Ref(Ptr{Float64}(C_NULL))
    GC.@preserve run while true
        request = step!(run, x) # of every solver: 1 evaluate, 2 a new iterate, 3 done, 4 a product of the Hessian
        (request == 1 || request == 4) && return copy(unsafe_wrap(Array, x[], size(run.x)))
        request == 3 && return nothing
        request < 0 && throw(OrbicubeError(request, "internal", "step"))
    end
end

"The value at the point; not finite: undefined."
function tell!(run::Run{<:TrustRegion}, outputs)
    values = outputs isa Real ? Float64[outputs] : doubles(outputs)
    expect(length(values), run.outputs, "outputs")
    GC.@preserve run checked(error -> Raw.obc_trust_region_tell(run.handle, values, error))
end
function tell!(run::Run{<:Union{ProjectedGradient,SphereOptimizer}}, value::Real, gradient::AbstractArray)
    slope = doubles(gradient)
    expect(length(slope), length(run.x), "gradient")
    GC.@preserve run checked() do error
        run isa Run{<:ProjectedGradient} ? Raw.obc_projected_gradient_tell(run.handle, value, slope, error) :
        Raw.obc_sphere_optimizer_tell(run.handle, value, slope, error)
    end
end

"The vector whose product with the Hessian at the point is queried, a copy; `nothing` where value and gradient are."
function asked_direction(run::Run{<:SphereOptimizer})
    found = Ref(Ptr{Float64}(C_NULL))
    GC.@preserve run begin
        Raw.obc_sphere_optimizer_get_direction(run.handle, found, C_NULL) == 0 || return nothing
        copy(unsafe_wrap(Array, found[], size(run.x)))
    end
end

"That product; not finite: undefined."
function tell_product!(run::Run{<:SphereOptimizer}, product::AbstractArray)
    given = doubles(product)
    expect(length(given), length(run.x), "product")
    GC.@preserve run checked(error -> Raw.obc_sphere_optimizer_tell_product(run.handle, given, error))
end

"What is known now."
function result(run::Run{M}) where {M}
    x = similar(run.x)
    GC.@preserve run if M <: TrustRegion
        report = sized(Raw.obc_trust_region_result)
        checked(error -> Raw.obc_trust_region_get_result(run.handle, report, x, C_NULL, error))
        Result(x, report, text(Raw.obc_trust_region_stop_name(report.stop)))
    elseif M <: ProjectedGradient
        report = sized(Raw.obc_projected_gradient_result)
        checked(error -> Raw.obc_projected_gradient_get_result(run.handle, report, x, error))
        Result(x, report, text(Raw.obc_projected_gradient_stop_name(report.stop)))
    else
        report = sized(Raw.obc_sphere_optimizer_result)
        checked(error -> Raw.obc_sphere_optimizer_get_result(run.handle, report, x, error))
        Result(x, report, text(Raw.obc_sphere_optimizer_stop_name(report.stop)))
    end
end

"The multipliers of the rows at the current iterate."
function multipliers(run::Run{<:ProjectedGradient})
    found = Vector{Float64}(undef, run.set.c.m)
    GC.@preserve run checked(error -> Raw.obc_projected_gradient_multipliers(run.handle, found, error))
    found
end

"The run as bytes."
function save(run::Run{M}) where {M}
    GC.@preserve run begin
        size, write = M <: TrustRegion ? (Raw.obc_trust_region_save_size, Raw.obc_trust_region_save) :
                      M <: ProjectedGradient ? (Raw.obc_projected_gradient_save_size, Raw.obc_projected_gradient_save) :
                      (Raw.obc_sphere_optimizer_save_size, Raw.obc_sphere_optimizer_save)
        bytes = Vector{UInt8}(undef, size(run.handle))
        checked(error -> write(run.handle, bytes, length(bytes), error))
        bytes
    end
end

# -- block by block ------------------------------------------------------------------------------------------------------------

mutable struct CalledPart{F}
    f::F
    place::Vector{Float64}     # ours, as Called
    gradient::Vector{Float64}
    hessian::Matrix{Float64}
    size::NTuple{2,Int}
    points::Matrix{Float64}    # the library's
    caught::Caught
end

CalledPart(f, (d, count)) =
    CalledPart(f, zeros(d), zeros(d), zeros(d, d), (Int(d), Int(count)), Matrix{Float64}(undef, 0, 0), Caught())

function part_called(block::Csize_t, place::Ptr{Float64}, points::Ptr{Float64}, value::Ptr{Float64}, gradient::Ptr{Float64},
                     hessian::Ptr{Float64}, called::CalledPart)::Int32
    unsafe_copyto!(pointer(called.place), place, called.size[1])
    pointer(called.points) == points || (called.points = unsafe_wrap(Array, points, called.size))
    G = gradient == C_NULL ? nothing : called.gradient
    H = hessian == C_NULL ? nothing : called.hessian
    answered(called) do
        unsafe_store!(value, convert(Float64, called.f(G, H, Int(block) + 1, called.place, called.points)))
        G === nothing || unsafe_copyto!(gradient, pointer(G), length(G))
        H === nothing || unsafe_copyto!(hessian, pointer(H), length(H))
    end
end

part_function(::C) where {C} =
    @cfunction(part_called, Int32, (Csize_t, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ref{C}))

function blocks(x0::AbstractMatrix, neighbors::AbstractVector)
    length(neighbors) == size(x0, 2) ||
        throw(DimensionMismatch("neighbors: $(size(x0, 2)) rows are needed, not $(length(neighbors))"))
    start, flat = Csize_t[0], UInt32[]
    for row in neighbors
        all(j -> 1 <= j <= length(neighbors), row) || throw(BoundsError(neighbors, row))
        append!(flat, UInt32.(row .- 1))
        push!(start, length(flat))
    end
    c = filled(Raw.obc_sphere_optimizer_blocks, Raw.obc_sphere_optimizer_blocks_init, NamedTuple())
    c.dimension, c.count = size(x0)
    c.neighbor_start, c.neighbor = pointer(start), pointer(flat)
    Problem(c, Any[start, flat])
end

relaxation_options(given) = filled(Raw.obc_sphere_optimizer_relaxation_options, Raw.obc_sphere_optimizer_relaxation_options_init,
                                   given, "OBC_SPHERE_OPTIMIZER_")

const Relaxed = Result{<:Any,Raw.obc_sphere_optimizer_relaxation_result}
iterations(result::Relaxed) = Int(result.report.steps)
Base.minimum(::Relaxed) = throw(ArgumentError("parts of f are known, not f: report(result).gain is by how much it fell"))
Base.show(io::IO, result::Relaxed) = print(io, "Result: ", result.stop, " after ", iterations(result), " steps, lower by ",
                                           result.report.gain, " at ", minimizer(result))

"""
    relax(part!, x0, neighbors; ...)

Lowers f over unit vectors, the columns of x, block by block. `part!(G, H, block, place, points)` returns the part of f that
contains this block if it were at `place` and all others as in `points`; it fills the gradient `G` and, with `second_order=1`, the
Hessian `H`, each `nothing` where it is not needed. `points` is the library's own and only there during the call: read it, and
copy what you keep. `neighbors[i]` are the blocks whose part of f contains block i. Options are the members of
`obc_sphere_optimizer_relaxation_options`.
"""
function relax(part!, x0::AbstractMatrix, neighbors::AbstractVector; options...)
    x = Matrix{Float64}(x0)
    set, chosen = blocks(x, neighbors), relaxation_options(values(options))
    called = CalledPart(part!, size(x))
    report = sized(Raw.obc_sphere_optimizer_relaxation_result)
    finished(called, report, x, Raw.obc_sphere_optimizer_stop_name) do error
        GC.@preserve set Raw.obc_sphere_optimizer_relax(set.c, chosen, part_function(called), pointer_from_objref(called), x,
                                                        report, C_NULL, error)
    end
end

"""
    Relaxation(x0, neighbors; ...)                                  the arguments of relax
    while stop_reason(relax!(part!, relaxation, 1000)) == "running"
    end
    result(relaxation)

A relaxation in parts, which ends in the bits of `relax`. `save(relaxation)` gives bytes, `load(bytes, x0, neighbors)` goes on from
them.
"""
mutable struct Relaxation
    handle::Ptr{Cvoid}
    size::NTuple{2,Int}
    function Relaxation(handle::Ptr{Cvoid}, size)
        finalizer(it -> released(Raw.obc_sphere_optimizer_relaxation_destroy, it.handle), new(handle, size))
    end
end

function Relaxation(x0::AbstractMatrix, neighbors::AbstractVector; options...)
    x, out = Matrix{Float64}(x0), Ref(C_NULL)
    set, chosen = blocks(x, neighbors), relaxation_options(values(options))
    checked(error -> GC.@preserve set Raw.obc_sphere_optimizer_relaxation_create(set.c, chosen, x, C_NULL, out, error))
    Relaxation(out[], size(x))
end

"Goes on with a relaxation that was saved, of the same neighbors; of x0 only the size counts."
function load(bytes::Vector{UInt8}, x0::AbstractMatrix, neighbors::AbstractVector)
    set, out = blocks(x0, neighbors), Ref(C_NULL)
    checked(error -> GC.@preserve set Raw.obc_sphere_optimizer_relaxation_load(set.c, bytes, length(bytes), C_NULL, out, error))
    Relaxation(out[], size(x0))
end

"""
    relax!(part!, relaxation, steps)

Relaxes up to the given number of further blocks, with `part!` as of `relax`; returns what is known then, whose `stop_reason` is
"running" when there is more to do. Whatever `part!` throws, `StopRun` too, the next call goes on as if it had not been broken off.
"""
function relax!(part!, relaxation::Relaxation, steps::Integer)
    called = CalledPart(part!, relaxation.size)
    error = Raw.obc_error()
    status = GC.@preserve relaxation called Raw.obc_sphere_optimizer_relaxation_run(
        relaxation.handle, part_function(called), pointer_from_objref(called), steps, error)
    rethrown(called.caught)
    check(status, error)
    result(relaxation)
end

function result(relaxation::Relaxation)
    x, report = Matrix{Float64}(undef, relaxation.size), sized(Raw.obc_sphere_optimizer_relaxation_result)
    GC.@preserve relaxation begin
        checked(error -> Raw.obc_sphere_optimizer_relaxation_get_result(relaxation.handle, report, x, error))
    end
    Result(x, report, text(Raw.obc_sphere_optimizer_stop_name(report.stop)))
end

"The relaxation as bytes."
function save(relaxation::Relaxation)
    GC.@preserve relaxation begin
        bytes = Vector{UInt8}(undef, Raw.obc_sphere_optimizer_relaxation_save_size(relaxation.handle))
        checked(error -> Raw.obc_sphere_optimizer_relaxation_save(relaxation.handle, bytes, length(bytes), error))
        bytes
    end
end
