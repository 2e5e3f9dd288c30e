# What a call of the user's function costs through Julia; does what callbacks.c does.
#
#   ORBICUBE_LIBRARIES=build/capi julia --project=bindings/julia bench/bindings/callbacks.jl
using Orbicube

function rosenbrock!(g, x)
    sum = 0.0
    fill!(g, 0)
    for i in 1:length(x)-1
        a, b = x[i+1] - x[i] * x[i], 1 - x[i]
        sum = sum + (100 * a * a + b * b)
        g[i] -= 400 * x[i] * a + 2 * b
        g[i+1] += 200 * a
    end
    sum
end

struct Recorded
    values::Vector{Float64}
    gradients::Vector{Vector{Float64}}
end

mutable struct Replay
    recorded::Recorded
    next::Int
end

function (replay::Replay)(g, x)
    replay.next += 1
    copyto!(g, replay.recorded.gradients[replay.next])
    replay.recorded.values[replay.next]
end

function main()
    start = [isodd(i) ? -1.2 : 1.0 for i in 1:10]
    recorded = Recorded([], [])
    record(g, x) = (value = rosenbrock!(g, x); push!(recorded.values, value); push!(recorded.gradients, copy(g)); value)
    optimize(only_fg!(record), start, ProjectedGradient())
    best = Inf
    for _ in 1:1500
        spent = @elapsed optimize(only_fg!(Replay(recorded, 0)), start, ProjectedGradient())
        best = min(best, spent / length(recorded.values))
    end
    println("Julia: ", round(Int, 1e9 * best), " ns an evaluation, ", length(recorded.values), " evaluations a run")
end

main()
