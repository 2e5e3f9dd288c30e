using Test
using Orbicube
using SparseArrays
include("layouts.jl")
include("optim.jl")

bits(x) = reinterpret(UInt64, vec(x))

"name => (evaluations, bits) of the C program that solves the same problems."
function from_c()
    haskey(ENV, "ORBICUBE_PROBLEMS") || return nothing
    lines = split.(split(chomp(read(`$(ENV["ORBICUBE_PROBLEMS"])`, String)), '\n'))
    Dict(words[1] => (parse(Int, words[2]), parse.(UInt64, words[3:end], base=16)) for words in lines)
end

@testset "structs lie in memory as in C" begin
    for (type, size, offsets) in layouts
        @test sizeof(type) == size
        @test [Int(fieldoffset(type, i)) for i in 1:fieldcount(type)] == offsets
    end
end

include("solvers.jl")
include("maps.jl")
include("solids.jl")
include("meshes.jl")
include("linear.jl")
