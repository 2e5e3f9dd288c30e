using Test
using Orbicube
using SparseArrays
include("layouts.jl")
include("optim.jl")

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
    @test all(length.(graph.neighbors) .== 4)
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
    met = align_features(map; vertices=[vertex], targets=reshape(place, 3, 1))
    @test maximum(abs, met.polycube[:, vertex] - place) < 1e-12 && met.report.distance_before > 1e-3
    @test_throws OrbicubeError align_features(map; vertices=[vertex], targets=fill(100.0, 3, 1))
    @test_throws DimensionMismatch align_features(map; vertices=[vertex])
    ends = graph.edge_corners[:, 1]
    along = findall(v -> count(map.polycube[:, v] .== graph.corner_positions[:, ends[1]] .== graph.corner_positions[:, ends[2]]) == 2,
                    axes(map.polycube, 2))
    sort!(along, by=v -> sum(abs, map.polycube[:, v] - graph.corner_positions[:, ends[1]]))
    curve = (along, graph.corner_positions[:, ends[1]], graph.corner_positions[:, ends[2]])
    @test align_features(map; curves=[curve]).report.distance < 1e-12

    surface = Surface(map.positions, map.triangles)
    placed = polycube_on(surface, map; corners=graph.corner_vertices[1:2], vertices=[graph.corner_vertices[1], 0],
                         points=map.positions[:, graph.corner_vertices[1:2]])
    @test placed.corners == 8 && polycube_on(shape, map).corners == 8
    @test_throws OrbicubeError polycube_on(surface, map; corners=[size(map.positions, 2) + 1], points=zeros(3, 1))
    maps, constructed_from = common_polycube([shape, shape])
    @test length(maps) == 2 && constructed_from in 1:2
    @test all(m -> m.corners == 8, optimize_domain(maps))
    @test_throws OrbicubeError common_polycube(Surface[])
    longer = Surface([1.5 1 1]' .* Orbicube.positions(shape), Orbicube.triangles(shape))
    both = Correspondence([shape, longer]; via=:polycube, cells=200)
    @test length(both.positions) == 2 && size(both.triangles, 2) == 2 * size(both.quads, 2) && size(both.domain) == size(both.positions[1])
    @test blend(both, [0, 1]) == both.positions[2]
    there = map_points(both, 1, 2)
    back = map_points(both, 2, 1, there...)
    found = [sum(back[2][k, v] * Orbicube.positions(shape)[i, Orbicube.triangles(shape)[k, back[1][v]]] for k in 1:3) for i in 1:3, v in eachindex(back[1])]
    @test found ≈ Orbicube.positions(shape) atol = 1e-6
    @test_throws ArgumentError map_points(both, 1, 3)
    @test_throws DimensionMismatch blend(both, [1.0])
    marks = Orbicube.positions(shape)[:, [1, 20, 40, 60]]
    @test Correspondence([shape, shape]; landmarks=[marks, marks]) isa Correspondence
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
    @test_throws OrbicubeError untangle(places, cells; max_steps=-1, keep_best=true)
    # Four triangles around a vertex that has left the square that they fill.
    flat = [0.0 1 1 0 3; 0 0 1 1 2]
    moved, report = untangle(flat, [1 2 3 4; 2 3 4 1; 5 5 5 5])
    @test report.inverted_before > 0 && report.inverted == 0 && moved[:, 1:4] == flat[:, 1:4]
    @test all(abs.(moved[:, 5] .- 0.5) .< 0.01)
end

"The scaled Jacobian of each corner of hexahedra, by arithmetic of our own."
function scaled_jacobians(mesh)
    ends = ((2, 4, 5), (3, 1, 6), (4, 2, 7), (1, 3, 8), (8, 6, 1), (5, 7, 2), (6, 8, 3), (7, 5, 4))
    at(v) = mesh.positions[:, v]
    unit(v) = v ./ sqrt(sum(abs2, v))
    turn(a, b) = [a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1]]
    [sum(unit(at(cell[e[1]]) - at(cell[k])) .* turn(unit(at(cell[e[2]]) - at(cell[k])), unit(at(cell[e[3]]) - at(cell[k]))))
     for (k, e) in enumerate(ends), cell in eachcol(mesh.hexahedra)]
end

@testset "hexahedra, and solids on polycubes" begin
    corners = Float64[i >> k & 1 for k in 0:2, i in 0:7]
    ring = [2, 4, 3, 7, 5, 6]
    cells = reduce(hcat, [[1, ring[i], ring[i%6+1], 8] for i in 1:6])
    mesh = fill_with_hexahedra(corners, cells; method=:frames, cells=8)
    @test (size(mesh.hexahedra), size(mesh.positions), size(mesh.quads)) == ((8, 8), (3, 27), (4, 24))
    @test minimum(scaled_jacobians(mesh)) ≈ mesh.report.min_scaled_jacobian > 0.99
    @test mesh.report.volume ≈ 1 && mesh.report.irregular_edges == 0
    expected = from_c()
    expected === nothing || @test expected["cube"] == (8, bits(mesh.positions))
    frames, = frame_field(corners, cells)
    @test minimum(scaled_jacobians(fill_with_hexahedra(corners, cells, frames; cells=8))) > 0.99
    @test_throws DimensionMismatch fill_with_hexahedra(corners, cells, frames[:, 2:end])
    @test_throws OrbicubeError fill_with_hexahedra(corners, cells; cells=0)

    shape = make_surface("cube", 300)
    mesh = fill_with_hexahedra(shape; cells=27, padding=:without)
    @test (size(mesh.hexahedra, 2), size(mesh.positions, 2), size(mesh.quads, 2)) == (27, 64, 54)
    @test extrema(mesh.hexahedra) == extrema(mesh.quads) .+ (0, 64 - maximum(mesh.quads)) == (1, 64)
    @test minimum(scaled_jacobians(mesh)) ≈ mesh.report.min_scaled_jacobian > 0.99
    @test mesh.report.volume ≈ topology(shape).volume
    @test sort(unique(mesh.quad_patches)) == 1:6
    @test fill_with_hexahedra(shape; cells=64, method=:grid).report.grid_based == 1
    @test_throws OrbicubeError fill_with_hexahedra(shape; cells=27, progress=(_...) -> false)

    octahedron = Surface([1.0 -1 0 0 0 0; 0 0 1 -1 0 0; 0 0 0 0 1 -1], [1 3 2 4 3 2 4 1; 3 2 4 1 1 3 2 4; 5 5 5 5 6 6 6 6])
    mesh = fill_with_hexahedra(octahedron; cells=200, max_hausdorff_percent=0, method=:grid, features=:tags, tagged_edges=[1 3; 3 2; 2 4; 4 1]')
    @test mesh.report.embedded == 1 && mesh.report.captured ≈ 1 && isempty(mesh.missing)
    mesh = fill_with_hexahedra(octahedron; cells=200, max_hausdorff_percent=0, method=:polycube, features=:angles)
    @test mesh.report.captured < 0.9 && length(mesh.missing) == mesh.report.missing_features > 0
    @test all(found -> !isempty(found.why) && found.captured < 0.95, mesh.missing)

    solid = map_to_polycube(corners, cells)
    volume(places) = sum(cell -> let e = places[:, cell[2:4]] .- places[:, cell[1]]
            least = e[1, 1] * (e[2, 2] * e[3, 3] - e[3, 2] * e[2, 3]) - e[1, 2] * (e[2, 1] * e[3, 3] - e[3, 1] * e[2, 3]) +
                    e[1, 3] * (e[2, 1] * e[3, 2] - e[3, 1] * e[2, 2])
            @test least > 0
            least / 6
        end, eachcol(solid.tetrahedra))
    @test volume(solid.positions) ≈ 1 && volume(solid.polycube) > 0
    @test_throws OrbicubeError map_to_polycube(corners, cells[[2, 1, 3, 4], :])

    along = repeat([1.0, 0, 0, 0], 1, size(cells, 2))
    charts = parameterize(corners, cells; frames=along, cell_length=0.5, integer=1)
    @test (charts.report.inverted, charts.report.patches, size(charts.singular_edges, 2)) == (0, 6, 0)
    for (t, cell) in enumerate(eachcol(cells))
        @test charts.parameters[:, :, t] .- charts.parameters[:, 1, 1] ≈ 2 .* (corners[:, cell] .- corners[:, cells[1, 1]]) atol = 1e-6
    end
    @test_throws DimensionMismatch parameterize(corners, cells; frames=along[:, 2:end])

    forward, backward = SolidLocator(solid.positions, solid.tetrahedra), SolidLocator(solid.polycube, solid.tetrahedra)
    point = [0.25 0.5 0.875]'
    @test sample(backward, sample(forward, point, solid.polycube), solid.positions) ≈ point
    @test locate(forward, [2.0 0 0]')[1] == [0] && all(isnan, sample(forward, [2.0 0 0]', solid.polycube))
end

@testset "meshes of cells, searches and exact signs" begin
    corners = Float64[i >> k & 1 for k in 0:2, i in 0:7]
    ring = [2, 4, 3, 7, 5, 6]
    cells = reduce(hcat, [[1, ring[i], ring[i%6+1], 8] for i in 1:6])
    solid = Mesh(corners; tetrahedra=cells)
    check_cells(solid)
    @test tetrahedron_quality(solid).volume ≈ 1 && topology(boundary(solid)).genus == 0
    @test_throws OrbicubeError check_cells(Mesh(corners; tetrahedra=cells[[2, 1, 3, 4], :]))
    @test_throws ArgumentError Mesh(corners; tetrahedra=cells .+ 1)
    mktempdir() do folder
        path = joinpath(folder, "cube.vtk")
        write_mesh(path, solid)
        again, about = read_mesh(path)
        @test again.tetrahedra == cells && again.positions == corners && occursin("VTK", about.format)
        @test read_mesh(read(path), :vtk)[1].tetrahedra == cells
        @test isempty(again.tetrahedron_regions)
        write_mesh(path, Mesh(corners; tetrahedra=cells, tetrahedron_regions=[4, 4, 0, -1, 2, 2]))
        @test read_mesh(path)[1].tetrahedron_regions == [4, 4, 0, -1, 2, 2]
        @test_throws ArgumentError Mesh(corners; tetrahedra=cells, tetrahedron_regions=[4])
        @test_throws ArgumentError read_mesh(UInt8[], :doc)
    end
    shape = make_surface("creature", 400)
    @test [format.ending for format in formats() if format.cells] == [".mesh", ".vtk", ".msh", ".inp", ".vtu"]
    @test "torus" in shape_names() && check_closed_genus_zero(shape) === nothing
    @test_throws OrbicubeError check_closed_genus_zero(make_surface("torus", 400))
    inside = Surface(Orbicube.positions(shape), Orbicube.triangles(shape)[[2, 1, 3], :])
    outside, turned = orient(inside)
    @test turned.turned_outward == 1 && topology(outside).volume ≈ -topology(inside).volume > 0
    @test isempty(intersections(shape))
    crossing = Surface([0.0 2 0 0.2 0.2 0.2; 0 0 2 0.2 0.2 1; 0 0 0 -1 1 0], [1 4; 2 5; 3 6])
    @test sort(vec(intersections(crossing))) == [1, 2]
    @test first_at_same_position([0.0 1 0; 0 0 0; 0 0 0]) == [1, 2, 1]
    search = Search(shape)
    @test nearest_vertices(search, Orbicube.positions(shape)[:, 7:9]) == 7:9
    near = nearest_points(search, Orbicube.positions(shape)[:, 7:9])
    @test near.distances == zeros(3) && near.positions == Orbicube.positions(shape)[:, 7:9]
    @test orientation_2d([0, 0], [1, 0], [0, 1]) == 1 && orientation_3d([0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, -1]) == -1
    @test orientation_from_origin(fill(0.1, 3), fill(0.2, 3), [0, 0, 1]) == 0
    @test_throws ArgumentError orientation_2d([NaN, 0], [1, 0], [0, 1])
    has_tetrahedra = try Orbicube.Raw.library(:tetrahedra); true catch; false end
    if has_tetrahedra
        box = make_surface("cube", 300)
        check_fillable(box)
        filled = fill_with_tetrahedra(box; quality=1.6)
        check_cells(Mesh(filled.positions; tetrahedra=filled.tetrahedra))
        @test filled.positions[:, 1:size(Orbicube.positions(box), 2)] == Orbicube.positions(box)
        @test (filled.parts, filled.cavities) == (1, 0) && maximum(filled.boundary_source) <= size(Orbicube.triangles(box), 2)
        fine = fill_with_tetrahedra(box; size_positions=zeros(3, 1), size_lengths=[0.05])
        @test size(fine.tetrahedra, 2) > size(filled.tetrahedra, 2)
        @test_throws OrbicubeError check_fillable(Surface(Orbicube.positions(box), Orbicube.triangles(box)[:, 2:end]))
    end
end

@testset "repaired surfaces" begin
    positions = [1.0 -1 0 0 0 0; 0 0 1 -1 0 0; 0 0 0 0 1 -1]
    triangles = [3 2 4 3 2 4 1; 2 4 1 1 3 2 4; 5 5 5 6 6 6 6]
    repaired = repair_surface(Surface(positions, triangles))
    @test repaired.report.closed == 1 && repaired.report.filled_holes == 1
    @test repaired.surface.positions == positions && size(repaired.surface.triangles, 2) == 8
    @test repaired.triangle_source == [1:7; 0] && repaired.vertex_source == 1:6
    @test length(repaired.events) == 1 && repaired.events[1].action == "filled-hole"
    @test repair_surface(Surface(positions, triangles); fill_holes=0).report.boundary_loops == 1
    @test_throws OrbicubeError repair_surface(Surface(positions, triangles); weld_distance=-1.0)
end

@testset "surfaces of labels" begin
    labels = zeros(Int, 8, 7, 6)
    labels[2:6, 2:6, 2:5] .= 3
    labels[3, 3, :] .= 0
    made = surface_of_label(labels, [2.0 0 0 1; 0 1 0 0; 0 0 1 0; 0 0 0 1])
    @test made.report.closed == 1 && made.report.genus == 0 && made.label_report.handles == 1 && made.label_report.label == 3
    @test maximum(Orbicube.positions(made.surface)[1, :]) > 10
    @test surface_of_label(labels; handles=1).report.genus == 1
    @test_throws OrbicubeError surface_of_label(labels; label=2)
end

@testset "files of engines" begin
    shape = make_surface("creature", 400)
    directions, = sphere_map(shape)
    mktempdir() do folder
        path = joinpath(folder, "shape.glb")
        n = size(directions, 2)
        write_gltf(path, shape; morph_targets=["sphere" => directions], name="creature", scale=2, extras="{\"made\": 1}",
                   base_color=(1, 0, 0, 1), texture_coordinates=zeros(2, n), colors=fill(0xff, 4, n), checker_texture=true)
        surface, about = read_gltf(path; morph_target="sphere", weld_identical=false)
        @test about.welded == 0 && maximum(abs, sqrt.(sum(abs2, Orbicube.positions(surface); dims=1)) .- 2) < 1e-6
        @test Orbicube.triangles(read_gltf(read(path))[1]) == Orbicube.triangles(shape)
        @test_throws OrbicubeError read_gltf(path; morph_target="none")
        @test_throws DimensionMismatch write_gltf(path, shape; normals=zeros(3, n - 1))
    end
end

@testset "what maps to the sphere are for" begin
    shape = make_surface("creature", 400)
    places = Orbicube.positions(shape)
    directions, report = sphere_map(shape)
    same, placed, error = partial_sphere_map(shape)
    @test same == directions && placed == size(places, 2) && error === nothing
    @test partial_sphere_map(shape; progress=(_...) -> false)[3].status == Orbicube.Raw.OBC_CANCELLED
    quasi_conformal, ratio = face_distortion(shape, directions)
    @test maximum(quasi_conformal) ≈ report.max_quasi_conformal && all(ratio .> 0)
    @test measure_map(shape, Float64.(round_to_float(shape, directions))).bijective == 1
    @test vertex_normals(sphere_grid(:icosphere, 3)) ≈ Orbicube.positions(sphere_grid(:icosphere, 3)) atol = 0.02
    @test surface_distance(shape, shape).first_max < 1e-12
    locator = Locator(shape, directions)
    pixels = geometry_image(locator, places, :octahedron, 16)
    @test size(pixels) == (3, image_size(:octahedron, 16)...) == (3, 17, 17)
    surface, gap = image_surface(pixels, :octahedron, 16)
    @test gap == 0 && topology(surface).genus == 0
    mktempdir() do folder
        path = joinpath(folder, "image.pfm")
        write_image(path, pixels, :octahedron, 16)
        again, layout, resolution = read_image(path)
        @test (layout, resolution) == (:octahedron, 16) && again == Float32.(pixels)
        @test_throws DimensionMismatch write_image(path, pixels, :octahedron, 18)
    end
    quarter = [0.0 -1 0; 1 0 0; 0 0 1]
    @test best_rotation(directions, quarter * directions) ≈ quarter
    from, to = [1.0 0; 0 1; 0 0], [1 0.0; 0.2 1; 0 0.3]
    warp = Warp(from, to)
    @test warp(from) ≈ to ./ sqrt.(sum(abs2, to; dims=1)) atol = 1e-3
    @test warp(warp(directions); backward=true) ≈ directions atol = 1e-9
    sphere, found = overlay(shape, directions, shape, quarter * directions)
    @test Orbicube.positions(sphere)[:, 1:size(places, 2)] ≈ directions && topology(sphere).genus == 0
    @test all(1 .<= found .<= size(Orbicube.positions(sphere), 2))

    a, = fit_harmonics(directions, places, vertex_areas(shape); degree=6)
    moved, refinement = refine_map(shape, directions, vertex_areas(shape); degree=6, rounds=3)
    @test size(moved) == size(directions) && refinement.residual < refinement.residual_before
    @test evaluate_harmonics(directions, 6)' * a' ≈ synthesize(a, directions)'
    step = 1e-6 .* [0.3, -0.5, 0.2]
    slope = harmonic_gradients(a, [0.0 0 1]')[:, :, 1]
    # Differences along the sphere from the pole.
    @test slope' * [step[1], step[2], 0] ≈ synthesize(a, [step[1], step[2], 1][:, :]) - synthesize(a, [0.0 0 1]') atol = 1e-9
    turned = rotate_harmonics(a, quarter)
    @test synthesize(turned, quarter * directions) ≈ synthesize(a, directions)
    @test degree_norms(turned) ≈ degree_norms(a) && shape_distance(a, turned) < 1e-10
    @test degree_norms(filter_harmonics(a, 1, 2))[4:end] == zeros(4)
    aligned = align_harmonics(turned, a; turn_values=false)
    @test aligned.rotation ≈ quarter atol = 1e-6
    @test aligned.correlation ≈ 1
    @test mean_distance(places, places) == 0
    mktempdir() do folder
        path = joinpath(folder, "shape.coef")
        write_harmonics(path, a)
        @test read_harmonics(path) ≈ a
    end
    @test_throws DimensionMismatch degree_norms(a[:, 2:end])
end

@testset "quaternions, and figures of frames" begin
    Q = Quaternions
    q = Q.normalize([1.0 2 -0.5; 0.5 0 1; -1 0.3 2; 0.2 0.1 1])
    @test Q.multiply(q, Q.inverse(q)) ≈ [1 1 1; 0 0 0; 0 0 0; 0 0 0]
    @test Q.exponential(Q.logarithm(q)) ≈ q
    @test Q.rotate(q[:, 1], [1.0, 2, 3]) ≈ Q.matrix(q[:, 1]) * [1, 2, 3]
    @test Q.rotate(q, [1.0, 2, 3])[:, 2] ≈ Q.matrix(q[:, 2]) * [1, 2, 3]
    axis, angle = Q.to_axis_angle(q[:, 3])
    @test abs(sum(Q.from_axis_angle(axis, angle) .* q[:, 3])) ≈ 1
    @test Q.to_rotation_vector(Q.from_rotation_vector([0.1, 0.2, 0.3])) ≈ [0.1, 0.2, 0.3]
    @test Q.nearest_to_matrix(1.1 .* Q.matrix(q[:, 1])) ≈ Q.from_matrix(Q.matrix(q[:, 1]))
    @test Q.slerp(q[:, 1], q[:, 2], 0) ≈ q[:, 1]
    for g in 0:23
        element = Q.cube_element(g)
        @test Q.cube_nearest(element) == g && Q.cube_product(g, Q.cube_inverse(g)) == 0
        @test Q.cube_matrix(g) ≈ Q.matrix(element) atol = 1e-15
        @test Q.symmetric_distance(q[:, 1], Q.multiply(q[:, 1], element)) < 1e-7
        @test Q.symmetric_matching(q[:, 1], Q.multiply(q[:, 1], element)) == g
    end
    @test Q.cube_class(0) == Orbicube.Raw.OBC_QUATERNION_IDENTITY
    @test Q.symmetric_sine_square(q, q[:, 1])[1] < 1e-15
    @test Q.average(repeat(q[:, 1:1], 1, 3))[2] ≈ 1
    @test_throws ArgumentError Q.cube_product(24, 0)
    @test_throws OrbicubeError Q.from_matrix([2.0 0 0; 0 2 0; 0 0 2])
    @test_throws DimensionMismatch Q.multiply(q, q[:, 1:2])

    corners = Float64[i >> k & 1 for k in 0:2, i in 0:7]
    ring = [2, 4, 3, 7, 5, 6]
    cells = reduce(hcat, [[1, ring[i], ring[i%6+1], 8] for i in 1:6])
    frames, report = frame_field(corners, cells)
    @test all(Q.symmetric_distance(frames, [1.0, 0, 0, 0]) .< 1e-6)
    @test measure_frames(corners, cells, frames).inner_faces == report.inner_faces == 6
    @test size(frame_matchings(corners, cells, frames)) == (4, 6)
    none = singularities(corners, cells, frames)
    @test size(none.edges) == (2, 0) && isempty(none.curves) && isempty(none.unmeshable_edges)
    held = Q.from_axis_angle([0.0, 0, 1], 0.3)
    frames, = frame_field(corners, cells; held_frames=([4], held), align_boundary=0)
    @test Q.symmetric_distance(frames[:, 4], held) < 1e-7
    again, = frame_field(corners, cells; start=:given, start_frames=frames, align_boundary=0)
    @test size(again) == (4, 6)
    @test_throws ArgumentError frame_field(corners, cells; held_axes=([7], [0.0, 0, 1]))
end

"The Laplacian of an n by n grid plus 1/100."
function grid_matrix(n)
    path = spdiagm(-1 => -ones(n - 1), 0 => [1; fill(2, n - 2); 1], 1 => -ones(n - 1))
    unit = sparse(1.0 * (1:n .== (1:n)'))
    kron(path, unit) + kron(unit, path) + 0.01 * kron(unit, unit)
end

@testset "sparse symmetric systems by factors" begin
    A = grid_matrix(9)
    n = size(A, 1)
    b = [sin(3i + j) for i in 1:n, j in 1:3]
    factor = LinearFactor(A)
    @test A * (factor \ b) ≈ b atol = 1e-12
    @test solve(factor, b[:, 2]) == (factor \ b)[:, 2]
    @test size(factor) == (n, n) && entry_count(factor) >= nnz(A) ÷ 2 - n ÷ 2
    lower = sparse([A[i, j] for i in 1:n, j in 1:n] .* ((1:n) .>= (1:n)'))
    for same in (Matrix(A), lower, Matrix(lower))
        @test LinearFactor(same; method=:eigen) \ b == LinearFactor(A; method=:eigen) \ b
    end

    # A row that becomes known, and a matrix of rank one.
    remove_row!(factor, 41)
    held = copy(A)
    held[41, :] .= 0
    held[:, 41] .= 0
    held[41, 41] = 1
    @test held * (factor \ b) ≈ b atol = 1e-12
    @test (factor \ b)[41, :] == b[41, :]
    w = zeros(n)
    w[[12, 13]] = [3, -2]
    update!(factor, [12, 13], [3, -2])
    @test (held + w * w') * (factor \ b) ≈ b atol = 1e-11
    update!(factor, [13, 12], [-2, 3]; sign=-1)
    @test held * (factor \ b) ≈ b atol = 1e-11
    refactor!(factor, 2A)
    @test 2A * (factor \ b) ≈ b atol = 1e-12
    fewer = Matrix(A)
    fewer[2, 1] = fewer[1, 2] = 0
    @test fewer * (refactor!(factor, fewer) \ b) ≈ b atol = 1e-12

    @test_throws ArgumentError LinearFactor([2 1; 0.5 3])
    @test_throws ArgumentError LinearFactor([2 1; 0 3])
    @test_throws ArgumentError LinearFactor([2.0 0; 1 0])
    @test_throws DimensionMismatch LinearFactor([2.0 0 0; 1 0 0])
    @test_throws ArgumentError LinearFactor(A; method=:eigenvalues)
    @test_throws OrbicubeError LinearFactor([1.0 2; 2 1])
    @test_throws OrbicubeError LinearFactor([1.0 NaN; NaN 1])
    @test_throws ArgumentError remove_row!(factor, 0)
    @test_throws ArgumentError remove_row!(factor, n + 1)
    @test_throws ArgumentError update!(factor, [0], [1.0])
    @test_throws ArgumentError update!(factor, [1], [1.0]; sign=2)
    @test_throws OrbicubeError update!(factor, [1, n], [1.0, 1])
    @test_throws DimensionMismatch factor \ b[2:end, :]
    fuller = Matrix(A)
    fuller[n, 1] = fuller[1, n] = 0.1
    @test_throws ArgumentError refactor!(factor, fuller)
    @test_throws OrbicubeError update!(factor, [1], [100.0]; sign=-1)
    @test_throws OrbicubeError factor \ b
    @test A * (refactor!(factor, A) \ b) ≈ b atol = 1e-12
end

@testset "sparse symmetric systems by iterations" begin
    A = grid_matrix(150)
    n = size(A, 1)
    b = [sin(3.0i) for i in 1:n]
    length_of(v) = sqrt(sum(abs2, v))
    for method in (:auto, :gauss_seidel, :multigrid), block_size in (1, 3)
        x, report = solve(LinearIterations(A; method=method, block_size=block_size, tolerance=1e-10), b)
        reached = length_of(b - A * x) / length_of(b)
        @test report.converged == 1 && reached < 1.001e-10
        @test report.residual ≈ reached rtol = 1e-2
    end
    one, two = (solve(LinearIterations(A; threads=threads), b)[1] for threads in 1:2)
    @test bits(one) == bits(two)
    _, report = solve(LinearIterations(A; method=:gauss_seidel, max_iterations=2), b)
    @test report.converged == 0 && report.iterations == 2 && report.residual > 1e-8

    # Each call has a function of its own, also after a garbage collection.
    told = Dict(:made => 0, :solved => 0)
    solver = LinearIterations(A; progress=(at...) -> (told[:made] += 1; true))
    made = told[:made]
    GC.gc()
    x, _ = solve(solver, b; progress=(at...) -> (told[:solved] += 1; true))
    @test made > 0 && told[:made] == made && told[:solved] > 0
    cancelled = try solve(solver, b; progress=(at...) -> false) catch error; error end
    @test cancelled isa OrbicubeError && cancelled.kind == "cancelled"
    @test_throws DivideError solve(solver, b; progress=(at...) -> throw(DivideError()))
    @test bits(solve(solver, b)[1]) == bits(x)

    @test_throws DimensionMismatch solve(solver, b[2:end])
    @test_throws OrbicubeError LinearIterations(A; block_size=2)
    @test_throws OrbicubeError LinearIterations(A; tolerance=2)
    @test_throws ArgumentError LinearIterations([2 1; 0 3.0])
end
