# How a C function is called: errors are thrown, the host reports progress, what a closure throws passes around C.

"What a library refused or failed at: `status` (a number of `Orbicube.Raw`), `kind` (one word) and `message`."
struct OrbicubeError <: Exception
    status::Int32
    kind::String
    message::String
end

Base.showerror(io::IO, error::OrbicubeError) = print(io, "OrbicubeError: ", error.kind, ": ", error.message)

"Throw it in a function that a solver calls where it has no value: the method goes on elsewhere."
struct EvaluationFailed <: Exception end

"Throw it in a function that a solver calls: the run ends as cancelled, with the best point so far."
struct StopRun <: Exception end

text(characters::NTuple{N,UInt8}) where {N} = String(UInt8[c for c in Iterators.takewhile(!iszero, characters)])
text(string::Cstring) = string == C_NULL ? "" : unsafe_string(string)

function check(status::Int32, error::Raw.obc_error)
    status == Raw.OBC_OK || throw(OrbicubeError(status, text(error.kind), text(error.message)))
    nothing
end

"Calls `f(error)`, which answers a status."
function checked(f)
    error = Raw.obc_error()
    check(f(error), error)
end

# What a closure throws is kept, and thrown again when C has returned.
mutable struct Caught
    error::Any
    trace::Any
    Caught() = new(nothing, nothing)
end

function keep!(caught::Caught, error)
    caught.error === nothing && (caught.error = error; caught.trace = catch_backtrace())
    Int32(1)
end

rethrown(caught::Caught) = caught.error === nothing ? nothing : throw(caught.error)

mutable struct Report{F}
    f::F
    caught::Caught
end

function reported(phase::Cstring, done::UInt64, total::UInt64, best::Float64, report::Report)::Int32
    report.caught.error === nothing || return Int32(1)
    try
        report.f(text(phase), Int(done), Int(total), best) === false ? Int32(1) : Int32(0)
    catch error
        keep!(report.caught, error)
    end
end

progress_function(::F) where {F} = @cfunction(reported, Int32, (Cstring, UInt64, UInt64, Float64, Ref{Report{F}}))

"""
Calls `f(host, error)` with a host that has so many threads (0: one a core) and a function `progress(phase, done, total, best)`,
which cancels by answering `false`. An exception in it comes out.
"""
function hosted(f; threads::Integer=0, progress=nothing)
    host = Raw.obc_host()
    Raw.obc_host_init(host, sizeof(host))
    host.thread_count = threads
    progress === nothing && return checked(error -> f(host, error))
    report = Report(progress, Caught())
    GC.@preserve report begin
        host.progress = progress_function(progress)
        host.progress_user = pointer_from_objref(report)
        error = Raw.obc_error()
        status = f(host, error)
    end
    rethrown(report.caught)
    check(status, error)
end

"A struct with its defaults, then what is given by name; a symbol such as `:angle_area` is the constant PREFIX_ANGLE_AREA."
function filled(::Type{T}, init, given, prefix="") where {T}
    it = T()
    status = init(it, sizeof(it))
    status == Raw.OBC_OK || throw(OrbicubeError(status, "invalid-argument", string(T)))
    for (name, value) in pairs(given)
        (hasfield(T, name) && name != :struct_size) ||
            throw(ArgumentError("no option $name; there are $(join(fieldnames(T)[2:end], ", "))"))
        if value isa Symbol
            word = uppercase(string(value))
            constant = Symbol(prefix * uppercase(string(name)) * "_" * word)
            isdefined(Raw, constant) || (constant = Symbol(prefix * word))
            isdefined(Raw, constant) || throw(ArgumentError("$name = :$value: there is no $constant"))
            value = getfield(Raw, constant)
        end
        setfield!(it, name, convert(fieldtype(T, name), value))
    end
    it
end

function sized(::Type{T}) where {T}
    it = T()
    it.struct_size = sizeof(it)
    it
end

doubles(values) = values isa Array{Float64} ? values : convert(Array{Float64}, values)

"Columns of `rows` numbers: a matrix, or a vector of them one after the other."
function columns(values::AbstractArray, rows::Integer, what)
    (ndims(values) == 1 && length(values) % rows == 0) || (ndims(values) == 2 && size(values, 1) == rows) ||
        throw(DimensionMismatch("$what: $rows rows are needed, not $(size(values))"))
    length(values) ÷ rows
end

expect(length, wanted, what) =
    length == wanted || throw(DimensionMismatch("$what: $wanted numbers are needed, not $length"))
