using Test
using Orbicube
include("layouts.jl")

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

@testset "the bits of C, by functions and by questions and answers" begin
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
    @test_throws OrbicubeError Run([NaN], TrustRegion())
    @test_throws OrbicubeError load(UInt8[1, 2, 3], [0.0], TrustRegion())
    @test_throws ArgumentError optimize(sum, [0.0], TrustRegion(radius=1))
    @test_throws DimensionMismatch optimize(sum, [0.0], TrustRegion(); lower=[1.0, 2])
    @test_throws OrbicubeError tell!(Run([0.0], TrustRegion()), 1.0)
    @test_throws MethodError tell!(Run([0.0], TrustRegion()), 1.0, [1.0]) # another solver's answer
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

@testset "maps" begin
    shape = make_surface("creature", 400)
    told = Ref(0)
    directions, figures = sphere_map(shape; progress=(phase, done, total, best) -> (told[] += 1; true))
    @test figures.bijective == 1 && told[] > 3
    @test maximum(abs, sum(abs2, directions; dims=1) .- 1) < 1e-15
    expected = from_c()
    if expected !== nothing
        @test bits(directions[:, 1]) == expected["creature"][2][1:3]
        @test bits(directions[:, end]) == expected["creature"][2][4:6]
    end
    @test sphere_map(shape; threads=3)[1] == directions
    @test measure_map(shape, directions).energy == figures.energy
    error = try sphere_map(shape; progress=(_...) -> false); nothing catch e; e end
    @test error isa OrbicubeError && error.status == Orbicube.Raw.OBC_CANCELLED
    @test_throws DomainError sphere_map(shape; progress=(_...) -> throw(DomainError(1)))
    @test_throws ArgumentError sphere_map(shape; method=:quickest)

    locator = Locator(shape, directions)
    faces, weights = locate(locator, directions)
    @test all(w -> w >= 0, weights) && maximum(faces) <= size(Orbicube.triangles(shape), 2)
    @test maximum(abs, sample(locator, directions, Orbicube.positions(shape)) - Orbicube.positions(shape)) < 1e-12
    @test size(Orbicube.positions(remesh(locator, Orbicube.positions(shape), :icosphere, 3))) == (3, 642)
    a, fit = fit_harmonics(directions, Orbicube.positions(shape); degree=6)
    @test fit.rank == 49 && size(synthesize(a, directions)) == size(directions)

    mktempdir() do folder
        path = joinpath(folder, "creature.ply")
        write_surface(path, shape)
        again = read_surface(path)
        @test Orbicube.positions(again) == Orbicube.positions(shape) && Orbicube.triangles(again) == Orbicube.triangles(shape)
    end
    @test topology(make_surface("torus", 1000)).genus == 1
    open = Surface(Orbicube.positions(shape), Orbicube.triangles(shape)[:, 2:end])
    error = try sphere_map(open); nothing catch e; e end
    @test error.kind == "not-closed" && occursin("boundary", sprint(showerror, error))
    @test_throws ArgumentError Surface(zeros(3, 2), [1 2 3]')

    cube = polycube(make_surface("cube", 300))
    @test (cube.corners, cube.patches) == (8, 6)
    frames, field = frame_field([0.0 1 0 0; 0 0 1 0; 0 0 0 1], reshape([1, 2, 3, 4], 4, 1))
    @test size(frames) == (4, 1) && sum(abs2, frames) ≈ 1
end

@testset "polycubes" begin
    shape = make_surface("cube", 600)
    map = polycube(shape; optimize_domain=false)
    @test map.report === nothing && isempty(energies(map))
    better = optimize_domain(map; measure=:face_mean)
    @test better.report.energy <= better.report.energy_before && all(diff(energies(better)) .<= 0)
    @test optimize_corners(map; method=:gradient, rounds=1).corners == 8
    @test certify_polycube(Surface(map.positions, map.triangles), map.polycube).patches == 6
    error = try certify_polycube(shape, zeros(3, size(Orbicube.positions(shape), 2))); nothing catch e; e end
    @test error.status == Orbicube.Raw.OBC_NO_VALID_RESULT

    graph = polycube_graph(map)
    @test length(graph.corner_vertices) == 8 && size(graph.edge_corners, 2) == 12 && all(graph.edge_convex)
    @test graph.corner_positions == map.polycube[:, graph.corner_vertices]
    @test sort(reduce(vcat, reduce(vcat, graph.loops))) == 1:24
    @test all(length.(graph.neighbours) .== 4)
    mesh = polycube_quads(map; quads=200)
    at = [sum(mesh.weights[k, i] * map.polycube[:, map.triangles[k, mesh.triangles[i]]] for k in 1:3) for i in axes(mesh.weights, 2)]
    @test maximum(maximum(abs, at[i] - mesh.polycube[:, i]) for i in eachindex(at)) < 1e-12
    @test maximum(mesh.quads) == size(mesh.positions, 2) && sort(unique(mesh.patches)) == 1:6

    # A vertex within a patch to the middle of a triangle beside it.
    on_corner_planes(v) = count(k -> minimum(abs.(graph.corner_positions[k, :] .- map.polycube[k, v])) < 1e-9, 1:3)
    vertex = findfirst(v -> on_corner_planes(v) == 1, axes(map.polycube, 2))
    face = findfirst(t -> vertex in map.triangles[:, t], axes(map.triangles, 2))
    place = sum(map.polycube[:, v] for v in map.triangles[:, face]) / 3
    plane = findfirst(k -> minimum(abs.(graph.corner_positions[k, :] .- map.polycube[k, vertex])) < 1e-9, 1:3)
    place[plane] = map.polycube[plane, vertex]
    met = meet_features(map; vertices=[vertex], places=reshape(place, 3, 1))
    @test maximum(abs, met.polycube[:, vertex] - place) < 1e-12 && met.report.distance_before > 1e-3
    @test_throws OrbicubeError meet_features(map; vertices=[vertex], places=fill(100.0, 3, 1))
    @test_throws DimensionMismatch meet_features(map; vertices=[vertex])
    ends = graph.edge_corners[:, 1]
    along = findall(v -> count(map.polycube[:, v] .== graph.corner_positions[:, ends[1]] .== graph.corner_positions[:, ends[2]]) == 2,
                    axes(map.polycube, 2))
    sort!(along, by=v -> sum(abs, map.polycube[:, v] - graph.corner_positions[:, ends[1]]))
    curve = (along, graph.corner_positions[:, ends[1]], graph.corner_positions[:, ends[2]])
    @test meet_features(map; curves=[curve]).report.distance < 1e-12

    surface = Surface(map.positions, map.triangles)
    placed = polycube_on(surface, map; corners=graph.corner_vertices[1:2], vertices=[graph.corner_vertices[1], 0],
                         points=map.positions[:, graph.corner_vertices[1:2]])
    @test placed.corners == 8 && polycube_on(shape, map).corners == 8
    @test_throws OrbicubeError polycube_on(surface, map; corners=[size(map.positions, 2) + 1], points=zeros(3, 1))
    maps, made_for = common_polycube([shape, shape])
    @test length(maps) == 2 && made_for in 1:2
    @test all(m -> m.corners == 8, optimize_domain(maps))
    @test_throws OrbicubeError common_polycube(Surface[])
    told = Ref(0)
    cancelled = try polycube(make_surface("bracket", 3000); progress=(_...) -> (told[] += 1) < 3) catch e; e end
    @test cancelled.status == Orbicube.Raw.OBC_CANCELLED && told[] == 3
    map = placed = maps = met = better = nothing
    GC.gc()
end

@testset "inverted tetrahedra" begin
    # Four around a vertex that has left the one that they fill.
    places = [0.0 1 0 0 2; 0 0 1 0 2; 0 0 0 1 2]
    cells = [1 1 1 2; 2 3 4 4; 3 4 2 3; 5 5 5 5]
    fixed = [true, true, true, true, false]
    moved, report = untangle(places, cells; fixed=fixed)
    @test report.inverted_before > 0 && report.inverted == 0
    @test moved[:, 1:4] == places[:, 1:4] && all(moved[:, 5] .> 0) && sum(moved[:, 5]) < 1
    ties = zeros(Int, 3, 5)
    ties[:, 5] .= 7
    tied = untangle(places, cells; fixed=repeat(fixed', 3), ties=ties)[1]
    @test tied[1, 5] == tied[2, 5] == tied[3, 5]
    @test_throws OrbicubeError untangle(places, cells; fixed=trues(5))
    best, report = untangle(places, cells; fixed=trues(5), keep_best=true)
    @test best == places && report.inverted == report.inverted_before
    @test_throws DimensionMismatch untangle(places, cells; fixed=trues(3))
    @test_throws ArgumentError untangle(places, cells .+ 1)
    @test_throws OrbicubeError untangle(places, cells; steps=-1, keep_best=true)
end
