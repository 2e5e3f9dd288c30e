"""
The C functions as they are, and their structs, written from the C headers. Structs that begin with their size are mutable and
passed as they are; arrays pass as pointers; the shared library of a function is loaded when it is first called.
"""
module Raw

using Libdl

abstract type CStruct end

function zeroed!(it)
    GC.@preserve it ccall(:memset, Ptr{Cvoid}, (Ptr{Cvoid}, Cint, Csize_t), pointer_from_objref(it), 0, sizeof(it))
    it
end

Base.cconvert(::Type{Ptr{T}}, it::T) where {T<:CStruct} = it
Base.unsafe_convert(::Type{Ptr{T}}, it::T) where {T<:CStruct} = Ptr{T}(pointer_from_objref(it))

function Base.show(io::IO, it::CStruct)
    members = [string(name, "=", getfield(it, name)) for name in fieldnames(typeof(it)) if !(name in (:struct_size, :reserved))]
    print(io, nameof(typeof(it)), "(", join(members, ", "), ")")
end

include("raw/libraries.jl")
include("raw/words.jl")

const loaded = Dict{Symbol,Ptr{Cvoid}}()

"""
The shared library of that name: in the folders of the variable ORBICUBE_LIBRARIES (as in PATH), then where the system looks.
"""
function library(name::Symbol)
    get!(loaded, name) do
        for used in Dict(libraries)[name]
            library(used)
        end
        base = "liborbicube-" * replace(string(name), "_" => "-")
        file = Sys.isapple() ? base * ".0.dylib" : Sys.iswindows() ? base[4:end] * "-0.dll" : base * ".so.0"
        folders = filter(!isempty, split(get(ENV, "ORBICUBE_LIBRARIES", ""), Sys.iswindows() ? ';' : ':'))
        for folder in folders
            path = joinpath(folder, file)
            ispath(path) && return dlopen(path)
        end
        handle = dlopen(file; throw_error=false)
        handle === nothing && error("$file was not found in $(isempty(folders) ? "no folder of ORBICUBE_LIBRARIES" : folders) " *
                                    "nor where the system looks")
        handle
    end
end

function symbol(address::Ref{Ptr{Cvoid}}, name::Symbol, function_name::Symbol)
    address[] == C_NULL && (address[] = dlsym(library(name), function_name))
    address[]
end

for (name, _) in libraries
    include("raw/$name.jl")
end

end
