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

"""
    StopRun([value])

Throw it in a function that a solver calls: the run ends as cancelled, with the best point so far. A `value` at x counts, and of
residuals what was filled, if all of it was.
"""
struct StopRun <: Exception
    value::Float64
end
StopRun() = StopRun(NaN)

text(characters::NTuple{N,UInt8}) where {N} = String(UInt8[c for c in Iterators.takewhile(!iszero, characters)])
text(string::Cstring) = string == C_NULL ? "" : unsafe_string(string)

function check(status::Int32, error::Raw.obc_error)
    status == Raw.OBC_OK || throw(OrbicubeError(status, text(error.kind), text(error.message)))
    nothing
end

"Calls `f(error)`, which returns a status."
function checked(f)
    error = Raw.obc_error()
    check(f(error), error)
end

# Finalizers of all handles run when the program ends, also where another thread is inside of a call with one: what is left then,
# the system takes back.
const ending = Ref(false)
__init__() = atexit(() -> ending[] = true)
released(destroy, handle) = ending[] ? nothing : destroy(handle)

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
Calls `f(host, error)` with a host of the given number of threads (0: one a core) and a function `progress(phase, done, total, best)`,
which cancels by returning `false`. An exception in it comes out.
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

"Of the known names those most like a wrong one, as the end of a sentence."
function nearest(wrong, known)
    best = filter(name -> distance(string(wrong), string(name)) <= max(1, length(string(name)) ÷ 3), collect(known))
    isempty(best) ? "" : "; did you mean $(join(repr.(few(sort(best, by=name -> distance(string(wrong), string(name))), 2)), " or "))?"
end

few(values, count) = values[1:min(count, length(values))]

"The number of characters to insert, remove or replace."
function distance(a, b)
    row = collect(0:length(b))
    for (i, x) in enumerate(a)
        corner, row[1] = row[1], i
        for (j, y) in enumerate(b)
            corner, row[j+1] = row[j+1], min(row[j] + 1, row[j+1] + 1, corner + (x != y))
        end
    end
    row[end]
end

"The constant of a word among those allowed."
function chosen_word(name, word::Symbol, allowed)
    for (known, number) in allowed
        known == word && return number
    end
    throw(ArgumentError("$name = :$word: one of $(join(repr.(first.(allowed)), ", ")) is needed$(nearest(word, first.(allowed)))"))
end

"A number as a member of a struct has it."
function number_for(T, name, value)
    value isa Union{AbstractString,AbstractArray,Nothing} &&
        throw(ArgumentError("$name = $(repr(value)): a number is needed"))
    try
        convert(fieldtype(T, name), value)
    catch error
        error isa InexactError || rethrow()
        throw(ArgumentError("$name = $value: out of range, or no integer"))
    end
end

"A struct with its defaults, then what is given by name; a symbol such as `:angle_area` is one of the words of the option."
function filled(::Type{T}, init, given, prefix="") where {T}
    it = T()
    status = init(it, sizeof(it))
    status == Raw.OBC_OK || throw(OrbicubeError(status, "invalid-argument", string(T)))
    options = filter(name -> !(name in (:struct_size, :reserved)), collect(fieldnames(T)))
    for (name, value) in pairs(given)
        name in options || begin
            near = nearest(name, options)
            throw(ArgumentError("no option $name$(isempty(near) ? "." : near) There are: $(join(options, ", "))"))
        end
        if value isa Symbol
            allowed = get(Raw.words, (nameof(T), name), nothing)
            allowed === nothing && throw(ArgumentError("$name = :$value: a number is needed"))
            value = chosen_word(name, value, allowed)
        end
        setfield!(it, name, number_for(T, name, value))
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
