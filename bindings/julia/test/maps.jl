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

    atlas = polycube_atlas(map; size=64, padding=2)
    @test atlas.size == 64 && size(atlas.coordinates) == (2, 3, size(map.triangles, 2)) && atlas.texels_per_unit > 0
    texels = sample(atlas)
    @test all(sum(texels.weights; dims=1) .≈ 1) && extrema(texels.triangles)[1] >= 1
    inside = findall(texels.covered)
    middles = [sum(texels.weights[k, i] * atlas.coordinates[:, k, texels.triangles[i]] for k in 1:3) for i in inside]
    @test maximum(maximum(abs, 64 * m - [i[1] - 0.5, i[2] - 0.5]) for (m, i) in zip(middles, inside)) < 1e-9
    @test_throws OrbicubeError polycube_atlas(map; size=0)

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
