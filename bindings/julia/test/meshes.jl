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
    @test turned.inward_oriented == 1 && topology(outside).volume ≈ -topology(inside).volume > 0
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
