model(x, i) = x[1] / (1 + x[2] * (0.5 * i)) + x[3]
const truth = (2.5, 0.7, 0.4)
function misfit!(r, x)
    for i in 0:7
        r[i+1] = model(x, i) - model(truth, i)
    end
end
const decay = (lower=[0.0, 0, -1], upper=[10.0, 2, 1])

const price, usual = (0.9, 0.3, 0.5, 1.4, 0.2), (0.2, 0.3, 0.2, 0.1, 0.2)
const weight = (2.0, 1.0, 3.0, 1.0, 4.0)
function cost!(g, x)
    sum = 0.0
    for j in 1:5
        away = x[j] - usual[j]
        sum = sum + (price[j] * x[j] + 0.5 * weight[j] * away * away)
        g[j] = price[j] + weight[j] * away
    end
    sum
end
const feeds = (lower=0, upper=0.6, A=[1 1 1 1 1; 0.12 0.09 0.35 0.44 0.05], b=[1, 0.2])

function charges!(g, x)
    sum = 0.0
    fill!(g, 0)
    for i in 1:12, j in 1:i-1
        away = (x[1, i] - x[1, j], x[2, i] - x[2, j], x[3, i] - x[3, j])
        term = 1 / (away[1] * away[1] + away[2] * away[2] + away[3] * away[3])
        sum = sum + term
        for k in 1:3
            pull = 2 * term * term * away[k]
            g[k, i] -= pull
            g[k, j] += pull
        end
    end
    sum
end
const scattered = reshape([(i * i * 7 % 37) / 37 - 0.5 for i in 0:35], 3, 12)

@testset "the bits of C, by functions and by reverse communication" begin
    r1 = least_squares(misfit!, 8, [1, 0.1, 0]; decay...)
    r2 = optimize(only_fg!(cost!), zeros(5), ProjectedGradient(); feeds...)
    r3 = optimize(only_fg!(charges!), scattered, SphereOptimizer())
    @test converged(r1) && converged(r2) && converged(r3)
    expected = from_c()
    if expected !== nothing
        for (name, r) in ("decay" => r1, "feeds" => r2, "icosahedron" => r3)
            @test expected[name] == (f_calls(r), bits(minimizer(r)))
        end
    end

    run, residuals = Run([1, 0.1, 0], TrustRegion(); residuals=8, decay...), zeros(8)
    while (x = ask!(run)) !== nothing
        misfit!(residuals, x)
        tell!(run, residuals)
        run = load(save(run), zeros(3), TrustRegion(); residuals=8, decay...)
    end
    @test bits(minimizer(result(run))) == bits(minimizer(r1))

    run, gradient = Run(zeros(5), ProjectedGradient(); feeds...), zeros(5)
    while (x = ask!(run)) !== nothing
        value = cost!(gradient, x)
        tell!(run, value, gradient)
        run = load(save(run), zeros(5), ProjectedGradient(); feeds...)
    end
    @test bits(minimizer(result(run))) == bits(minimizer(r2))
    cost!(gradient, minimizer(r2))
    @test abs(gradient[2] - multipliers(run)[1] - 0.09 * multipliers(run)[2]) < 1e-7 # gradient_tolerance is 1e-8

    run, gradient = Run(scattered, SphereOptimizer()), zeros(3, 12)
    while (x = ask!(run)) !== nothing
        value = charges!(gradient, x)
        tell!(run, value, gradient)
        run = load(save(run), zeros(3, 12), SphereOptimizer())
    end
    @test bits(minimizer(result(run))) == bits(minimizer(r3))
end

@testset "products of the Hessian" begin
    stiffness = [3.0, 1, 2, 5] # the minimum is 1
    quotient!(G, x) = (G .= 2 .* stiffness .* x; sum(stiffness .* x .^ 2))
    product!(Hv, x, v) = (Hv .= 2 .* stiffness .* v)
    r = optimize(only_fg_and_hv!(quotient!, product!), ones(4, 1), SphereOptimizer())
    @test converged(r) && abs(minimum(r) - 1) < 1e-12 && report(r).products > 0
    run, numbers = Run(ones(4, 1), SphereOptimizer(method=:truncated_newton, hessian_products=true)), zeros(4, 1)
    while (x = ask!(run)) !== nothing
        v = asked_direction(run)
        if v === nothing
            value = quotient!(numbers, x)
            tell!(run, value, numbers)
        else
            tell_product!(run, product!(numbers, x, v))
        end
    end
    @test bits(minimizer(result(run))) == bits(minimizer(r))
    @test_throws DomainError optimize(only_fg_and_hv!(quotient!, (Hv, x, v) -> throw(DomainError(1))), ones(4, 1), SphereOptimizer())
end

const others = [[j for j in 1:12 if j != i] for i in 1:12]
"The part of charges! that has one of them."
function charge!(G, H, block, place, points)
    value = 0.0
    G === nothing || fill!(G, 0)
    H === nothing || fill!(H, 0)
    for j in others[block]
        away = place .- @view points[:, j]
        term = 1 / sum(abs2, away)
        value += term
        G === nothing || (G .-= 2 * term^2 .* away)
        H === nothing || (H .+= 8 * term^3 .* away .* away' .- 2 * term^2 .* [a == b for a in 1:3, b in 1:3])
    end
    value
end

@testset "block by block" begin
    r = relax(charge!, scattered, others)
    @test converged(r) && charges!(zeros(3, 12), minimizer(r)) ≈ 39 && f_calls(r) >= iterations(r) > 12
    @test maximum(abs, sum(abs2, minimizer(r); dims=1) .- 1) < 1e-15
    @test occursin("converged", sprint(show, r)) && report(r).gain > 0
    @test_throws ArgumentError minimum(r) # only parts of it are known
    newton = relax(charge!, scattered, others; second_order=1, order=:sweeps)
    @test converged(newton) && charges!(zeros(3, 12), minimizer(newton)) ≈ 39
    calls = Ref(0)
    r = relax(scattered, others) do G, H, block, place, points
        (calls[] += 1) % 7 == 0 ? throw(EvaluationFailed()) : calls[] > 50 ? throw(StopRun()) : charge!(G, H, block, place, points)
    end
    @test stop_reason(r) == "cancelled"
    @test_throws DomainError relax((_...) -> throw(DomainError(1)), scattered, others)
    @test_throws ArgumentError relax(charge!, scattered, others; orders=:sweeps)
    @test_throws DimensionMismatch relax(charge!, scattered, others[2:end])
    @test_throws BoundsError relax(charge!, scattered, [[0] for _ in 1:12])
end

@testset "block by block in parts that are broken off, saved and loaded" begin
    whole = relax(charge!, scattered, others)
    relaxation = Relaxation(scattered, others)
    @test stop_reason(result(relaxation)) == "running"
    @test iterations(relax!(charge!, relaxation, 10)) == 10
    @test_throws DomainError relax!((_...) -> throw(DomainError(1)), relaxation, 10)
    @test stop_reason(relax!((_...) -> throw(StopRun()), relaxation, 10)) == "cancelled"
    again = load(save(relaxation), zeros(3, 12), others)
    for one in (relaxation, again)
        while stop_reason(relax!(charge!, one, 25)) == "running"
        end
        r = result(one)
        @test bits(minimizer(r)) == bits(minimizer(whole)) && report(r).gain === report(whole).gain
        @test (stop_reason(r), iterations(r)) == (stop_reason(whole), iterations(whole))
    end
    error = try load(save(relaxation), scattered, [Int[] for _ in 1:12]); nothing catch e; e end # other neighbors
    @test error isa OrbicubeError && error.status == Orbicube.Raw.OBC_INVALID_ARGUMENT
    error = try load(save(relaxation)[1:20], scattered, others); nothing catch e; e end
    @test error isa OrbicubeError && error.status == Orbicube.Raw.OBC_MALFORMED_FILE
    @test_throws InexactError relax!(charge!, relaxation, -1)
end

@testset "exceptions, failed evaluations, stops" begin
    @test_throws DomainError optimize(x -> throw(DomainError(1)), [0.0], TrustRegion())
    @test_throws DomainError optimize(only_fg!((g, x) -> throw(DomainError(1))), [0.0], ProjectedGradient())
    @test_throws DomainError optimize(only_fg!((g, x) -> throw(DomainError(1))), [1.0 0; 0 1], SphereOptimizer())
    calls = Ref(0)
    function f(x)
        calls[] += 1
        calls[] == 5 && throw(EvaluationFailed())
        calls[] == 7 && return NaN
        calls[] > 20 && throw(StopRun())
        (x[1] - 1)^2 + x[2]^2
    end
    r = optimize(f, [-1.2, 1], TrustRegion())
    @test stop_reason(r) == "cancelled" && report(r).failed_evaluations == 2
    @test minimum(r) == (minimizer(r)[1] - 1)^2 + minimizer(r)[2]^2
    distance(x) = sum(abs2, x .- 1)
    near(x) = distance(x) < 1e-3 ? throw(StopRun(distance(x))) : distance(x)
    slopes!(G, x) = (G .= 2 .* (x .- 1); near(x))
    near!(R, x) = (R .= x .- 1; distance(x) < 1e-3 && throw(StopRun()))
    for r in (optimize(near, [0.0, 0], TrustRegion()), optimize(only_fg!(slopes!), [0.0, 0], ProjectedGradient()),
              least_squares(near!, 2, [0.0, 0], TrustRegion()))
        @test stop_reason(r) == "cancelled" && minimum(r) < 1e-3 && minimum(r) ≈ distance(minimizer(r))
    end
    @test_throws OrbicubeError Run([NaN], TrustRegion())
    @test_throws OrbicubeError load(UInt8[1, 2, 3], [0.0], TrustRegion())
    @test_throws ArgumentError optimize(sum, [0.0], TrustRegion(radius=1))
    said(f) = try f(); "nothing" catch error; sprint(showerror, error) end
    @test occursin("no option radius_ende; did you mean :radius_end", said(() -> optimize(sum, [0.0], TrustRegion(radius_ende=1))))
    @test occursin("method = :two_radi: one of :two_radii, :dissertation is needed; did you mean :two_radii?",
                   said(() -> optimize(sum, [0.0], TrustRegion(method=:two_radi))))
    @test occursin("method = :cross: one of", said(() -> optimize(sum, [0.0], TrustRegion(method=:cross)))) # a word of `start`
    @test occursin("restarts = -1: out of range", said(() -> optimize(sum, [0.0], TrustRegion(restarts=-1))))
    @test occursin("restarts = \"many\": a number is needed", said(() -> optimize(sum, [0.0], TrustRegion(restarts="many"))))
    @test occursin("grid = :cub: one of :icosphere, :cube", said(() -> Orbicube.grid_of(:cub)))
    @test_throws DimensionMismatch optimize(sum, [0.0], TrustRegion(); lower=[1.0, 2])
    @test_throws OrbicubeError tell!(Run([0.0], TrustRegion()), 1.0)
    @test_throws MethodError tell!(Run([0.0], TrustRegion()), 1.0, [1.0]) # another solver's result
    @test_throws DimensionMismatch Run([1.0, 0], SphereOptimizer())
    @test_throws DimensionMismatch Run(zeros(2, 2, 2), SphereOptimizer())
    @test_throws ArgumentError Run([0.0, 0], ProjectedGradient(); A=[1 1])
end

@testset "the shape of Optim" begin
    r = optimize(x -> (x[1] - 3)^2 + x[2]^2, (g, x) -> (g[1] = 2 * (x[1] - 3); g[2] = 2 * x[2]), [0.0, 0], [1.0, 1], [0.5, 0.5],
                 ProjectedGradient())
    @test minimizer(r) == [1, 0] && minimum(r) == 4 && iterations(r) > 0
    r = optimize(x -> sum(abs2, x .- 0.3), [0.0, 0], [1.0, 1], [0.5, 0.5], TrustRegion())
    @test maximum(abs, minimizer(r) .- 0.3) < 1e-6 # radius_end is 1e-8, f is quadratic
    x, t = project([2.0, 2]; lower=0, A=[1 1], b=[1])
    @test x ≈ [0.5, 0.5] && t ≈ [-1.5]
end
