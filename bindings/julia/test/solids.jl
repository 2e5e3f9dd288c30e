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

@testset "elements without room" begin
    # Around an edge that passes outside of the triangle in the middle, and on both sides of a diagonal outside of a dart.
    places = [0.0 3 1 -0.5 -0.5; 0 0 0 0.75 -0.75; -1 1 0 0 0]
    solid = refine_untangled(places, [1 1 1; 2 2 2; 3 4 5; 4 5 3])
    @test solid.report.inverted_before == 2 && solid.report.inverted == 0
    @test solid.positions[:, 1:5] == places && size(solid.elements) == (4, 6) && sort(solid.parents) == [1, 1, 2, 2, 3, 3]
    @test solid.origins[:, 6] == [1, 2, 0, 0] && solid.weights[:, 6] == [0.5, 0.5, 0, 0]
    dart = [0.0 2 0 1; 0 1 4 1]
    flat = refine_untangled(dart, [1 1; 2 3; 3 4])
    @test flat.positions[:, 1:4] == dart
    @test all(1:4) do k
        a, b, c = (flat.positions[:, v] for v in flat.elements[:, k])
        (b[1] - a[1]) * (c[2] - a[2]) > (b[2] - a[2]) * (c[1] - a[1])
    end
    @test_throws OrbicubeError refine_untangled([0.0 1 1 0; 0 1 0 1], [1 1; 2 3; 3 4])
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
    numbered = fill_with_hexahedra(corners, cells; method=:frames, cells=8, regions=fill(3, size(cells, 2)))
    @test all(==(3), numbered.regions) && all(==(0), mesh.regions)
    @test_throws DimensionMismatch fill_with_hexahedra(corners, cells; regions=[1])

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
