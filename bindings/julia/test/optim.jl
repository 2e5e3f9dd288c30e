# The extension for Optim, on a package of that name with the functions that it extends. Julia before 1.9 does not load it by itself.
mktempdir() do folder
    write(joinpath(folder, "Optim.jl"), """
        module Optim
        export optimize, minimizer, converged, iterations, f_calls
        abstract type AbstractOptimizer end
        struct NelderMead <: AbstractOptimizer end
        struct Result end
        optimize(f, x0::AbstractArray; options...) = Result()
        optimize(f, x0::AbstractArray, method::AbstractOptimizer; options...) = Result()
        optimize(f, g, x0::AbstractArray; options...) = Result()
        optimize(f, g, x0::AbstractArray, method::AbstractOptimizer; options...) = Result()
        optimize(f, lower::AbstractArray, upper::AbstractArray, x0::AbstractArray, method::AbstractOptimizer; options...) = Result()
        minimizer(::Result) = zeros(1)
        converged(::Result) = false
        iterations(::Result) = 0
        f_calls(::Result) = 0
        end
        """)
    push!(LOAD_PATH, folder)
    # A program of Optim: its own names, and those of this package qualified.
    program = Module()
    Base.eval(program, :(using Test, Optim; import Orbicube))
    Base.eval(program, :(Base.include($program, $(joinpath(@__DIR__, "..", "ext", "OrbicubeOptimExt.jl")))))
    Base.eval(program, quote
        @testset "Optim" begin
            f(x) = sum(abs2, x .- 1)
            g!(G, x) = (G .= 2 .* (x .- 1))
            own = Orbicube.optimize(f, zeros(3), Orbicube.TrustRegion())
            found = optimize(f, zeros(3), Orbicube.TrustRegion())
            @test minimizer(found) == Orbicube.minimizer(own) && converged(found) && minimum(found) == minimum(own)
            @test f_calls(found) == Orbicube.f_calls(own) && iterations(found) == Orbicube.iterations(own)
            @test minimizer(optimize(f, fill(-1, 3), fill(0.5, 3), zeros(3), Orbicube.TrustRegion())) == fill(0.5, 3)
            @test minimizer(optimize(f, g!, zeros(3), Orbicube.ProjectedGradient())) ≈ ones(3)
            @test minimizer(optimize(f, g!, fill(-1, 3), fill(0.5, 3), zeros(3), Orbicube.ProjectedGradient())) == fill(0.5, 3)
            @test minimizer(optimize(f, g!, zeros(3), Orbicube.ProjectedGradient(); A=[1 1 1], b=[1])) ≈ fill(1 / 3, 3)
            @test optimize(f, zeros(3)) isa Optim.Result
            @test isempty(Test.detect_ambiguities(Optim))
        end
    end)
    pop!(LOAD_PATH)
end
