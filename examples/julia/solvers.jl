# The example problems of examples/c in Julia: a fit without derivatives, a mix of feeds, points that repel each other.
using Orbicube

"Fits a / (1 + b t) + c to eight measurements, within bounds."
function decay()
    t, truth = 0.5 .* (0:7), [2.5, 0.7, 0.4]
    model(x) = x[1] ./ (1 .+ x[2] .* t) .+ x[3]
    r = least_squares((r, x) -> r .= model(x) .- model(truth), 8, [1, 0.1, 0]; lower=[0, 0, -1], upper=[10, 2, 1])
    println("decay: ", stop_reason(r), " after ", f_calls(r), " evaluations, ", minimizer(r))
    @assert maximum(abs, minimizer(r) - truth) < 1e-7
end

"The cheapest mix of five feeds that reaches a given share of protein."
function feeds()
    price, usual = [0.9, 0.3, 0.5, 1.4, 0.2], [0.2, 0.3, 0.2, 0.1, 0.2]
    weight, protein = [2, 1, 3, 1, 4], [0.12, 0.09, 0.35, 0.44, 0.05]
    function cost!(g, x)
        away = x - usual
        g .= price .+ weight .* away
        sum(price .* x) + 0.5 * sum(weight .* away .^ 2)
    end
    r = optimize(only_fg!(cost!), zeros(5), ProjectedGradient(); lower=0, upper=0.6, A=[ones(5)'; protein'], b=[1, 0.2])
    println("feeds: ", stop_reason(r), " after ", f_calls(r), " evaluations, ", minimizer(r))
    @assert converged(r) && abs(sum(minimizer(r)) - 1) < 1e-14
end

"Twelve points on a sphere that repel each other settle at the corners of an icosahedron."
function charges()
    function energy!(g, x)
        value = 0.0
        fill!(g, 0)
        for i in 1:size(x, 2), j in 1:i-1
            away = x[:, i] - x[:, j]
            term = 1 / sum(abs2, away)
            value += term
            g[:, i] .-= 2 * term^2 .* away
            g[:, j] .+= 2 * term^2 .* away
        end
        value
    end
    r = optimize(only_fg!(energy!), reshape([(i * i * 7 % 37) / 37 - 0.5 for i in 0:35], 3, 12), SphereOptimizer())
    println("charges: ", stop_reason(r), " after ", f_calls(r), " evaluations, energy ", minimum(r))
    @assert abs(minimum(r) - 39) < 1e-9
end

decay()
feeds()
charges()
