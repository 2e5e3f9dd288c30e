# Meshes of cells, searches, exact signs, files of engines, and surfaces filled with tetrahedra.

# What f(0), f(1), ... return until there is no more.
function texts(f)
    found = String[]
    while (one = f(length(found))) != C_NULL
        push!(found, text(one))
    end
    found
end

"Names that `make_surface` knows."
shape_names() = texts(Raw.obc_mesh_shape_name)

"""
    formats()

Formats of `read_mesh` and `write_mesh`: `name` and `ending` of each, and whether its files hold `polygons` of shared vertices with exact
coordinates, `cells`, and `binary` contents.
"""
function formats()
    names, endings = texts(Raw.obc_mesh_format_name), texts(Raw.obc_mesh_format_ending)
    map(0:length(names)-1, names, endings) do number, name, ending
        holds(bit) = Raw.obc_mesh_format_contents(number) & UInt32(bit) != 0
        (name=name, ending=ending, polygons=holds(Raw.OBC_MESH_HOLDS_POLYGONS), cells=holds(Raw.OBC_MESH_HOLDS_CELLS),
         binary=holds(Raw.OBC_MESH_HOLDS_BINARY), regions=holds(Raw.OBC_MESH_HOLDS_REGIONS))
    end
end

"""
    Mesh(positions; triangles, tetrahedra, hexahedra, triangle_regions, tetrahedron_regions, hexahedron_regions)

Positions (3 by n) and cells of each kind (a column each, from 1, hexahedra as MEDIT and VTK order them); of a `Hexes` or a solid likewise.
Regions: for each triangle or cell the number of its region, 0 for none; empty where a kind has no regions.
"""
struct Mesh
    positions::Matrix{Float64}
    triangles::Matrix{Int}
    tetrahedra::Matrix{Int}
    hexahedra::Matrix{Int}
    triangle_regions::Vector{Int32}
    tetrahedron_regions::Vector{Int32}
    hexahedron_regions::Vector{Int32}
    function Mesh(positions::AbstractMatrix; triangles=zeros(Int, 3, 0), tetrahedra=zeros(Int, 4, 0), hexahedra=zeros(Int, 8, 0),
                  triangle_regions=Int32[], tetrahedron_regions=Int32[], hexahedron_regions=Int32[])
        n = columns(positions, 3, "positions")
        for (cells, corners, what, regions) in ((triangles, 3, "triangles", triangle_regions),
                                                (tetrahedra, 4, "tetrahedra", tetrahedron_regions),
                                                (hexahedra, 8, "hexahedra", hexahedron_regions))
            columns(cells, corners, what)
            all(v -> 1 <= v <= n, cells) || throw(ArgumentError("$what: numbers of vertices from 1 to $n are needed"))
            isempty(regions) || length(regions) == size(cells, 2) ||
                throw(ArgumentError("$(length(regions)) region numbers of $(size(cells, 2)) $what"))
        end
        new(doubles(positions), triangles, tetrahedra, hexahedra, triangle_regions, tetrahedron_regions, hexahedron_regions)
    end
end

Base.show(io::IO, mesh::Mesh) = print(io, "Mesh(", size(mesh.positions, 2), " vertices, ", size(mesh.triangles, 2), " triangles, ",
                                      size(mesh.tetrahedra, 2), " tetrahedra, ", size(mesh.hexahedra, 2), " hexahedra)")

# f(handle) with an obc_mesh of the same arrays.
function with_mesh(f, mesh::Mesh)
    cells = filled(Raw.obc_mesh_cells, Raw.obc_mesh_cells_init, NamedTuple())
    three, four, eight = UInt32.(mesh.triangles .- 1), UInt32.(mesh.tetrahedra .- 1), UInt32.(mesh.hexahedra .- 1)
    cells.positions, cells.vertex_count = pointer(mesh.positions), size(mesh.positions, 2)
    cells.triangles, cells.triangle_count = pointer(three), size(three, 2)
    cells.tetrahedra, cells.tetrahedron_count = pointer(four), size(four, 2)
    cells.hexahedra, cells.hexahedron_count = pointer(eight), size(eight, 2)
    given(regions) = isempty(regions) ? Ptr{Int32}(C_NULL) : pointer(regions)
    cells.triangle_regions, cells.tetrahedron_regions = given(mesh.triangle_regions), given(mesh.tetrahedron_regions)
    cells.hexahedron_regions = given(mesh.hexahedron_regions)
    out = Ref(C_NULL)
    GC.@preserve mesh three four eight hosted((lent, error) -> Raw.obc_mesh_create(cells, lent, out, error))
    try
        f(out[])
    finally
        Raw.obc_mesh_destroy(out[])
    end
end

# The mesh of the call f(out, host, error), and what is known of its file.
function taken_mesh(f; host...)
    out = Ref(C_NULL)
    hosted((lent, error) -> f(out, lent, error); host...)
    try
        places = Matrix{Float64}(undef, 3, Raw.obc_mesh_vertex_count(out[]))
        three = Matrix{UInt32}(undef, 3, Raw.obc_mesh_triangle_count(out[]))
        four = Matrix{UInt32}(undef, 4, Raw.obc_mesh_tetrahedron_count(out[]))
        eight = Matrix{UInt32}(undef, 8, Raw.obc_mesh_hexahedron_count(out[]))
        checked(error -> Raw.obc_mesh_copy(out[], places, three, four, eight, error))
        kinds = Raw.obc_mesh_region_kinds(out[])
        room(kind, cells) = Vector{Int32}(undef, kinds & kind == 0 ? 0 : size(cells, 2))
        of_three, of_four = room(Raw.OBC_MESH_TRIANGLE_REGIONS, three), room(Raw.OBC_MESH_TETRAHEDRON_REGIONS, four)
        of_eight = room(Raw.OBC_MESH_HEXAHEDRON_REGIONS, eight)
        lent(regions) = isempty(regions) ? Ptr{Int32}(C_NULL) : pointer(regions)
        GC.@preserve of_three of_four of_eight checked() do error
            Raw.obc_mesh_copy_regions(out[], lent(of_three), lent(of_four), lent(of_eight), error)
        end
        Mesh(places; triangles=Int.(three) .+ 1, tetrahedra=Int.(four) .+ 1, hexahedra=Int.(eight) .+ 1, triangle_regions=of_three,
             tetrahedron_regions=of_four, hexahedron_regions=of_eight),
        (format=text(Raw.obc_mesh_format(out[])), polygons=Int(Raw.obc_mesh_polygon_count(out[])),
         welded=Int(Raw.obc_mesh_welded_vertex_count(out[])), notes=texts(i -> Raw.obc_mesh_note(out[], i)))
    finally
        Raw.obc_mesh_destroy(out[])
    end
end

"""
    mesh, about = read_mesh(path)
    mesh, about = read_mesh(bytes, :ply)

Reads a file in the format of its ending with all cells, or bytes of a format, a name of `formats()` in lower case. `about` has `format`,
`polygons` (faces of more than three corners), `welded` vertices, and `notes`. Option: weld_identical.
"""
function read_mesh(path::AbstractString; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_mesh_read_options, Raw.obc_mesh_read_options_init, values(options))
    taken_mesh((out, lent, error) -> Raw.obc_mesh_read(path, chosen, lent, out, error); threads=threads, progress=progress)
end

function read_mesh(bytes::Vector{UInt8}, format::Symbol; threads=0, progress=nothing, options...)
    known = [Symbol(lowercase(one.name)) for one in formats()]
    format in known || throw(ArgumentError("format :$format: one of " * join(repr.(known), ", ")))
    chosen = filled(Raw.obc_mesh_read_options, Raw.obc_mesh_read_options_init, values(options))
    kind = findfirst(==(format), known) - 1
    taken_mesh(threads=threads, progress=progress) do out, lent, error
        Raw.obc_mesh_read_memory(bytes, length(bytes), kind, chosen, lent, out, error)
    end
end

"Writes a mesh in the format of the ending; those of `formats()` with `cells` hold tetrahedra and hexahedra, those with `regions` regions. Option: binary."
function write_mesh(path, mesh::Mesh; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_mesh_write_options, Raw.obc_mesh_write_options_init, values(options))
    with_mesh(mesh) do handle
        hosted((lent, error) -> Raw.obc_mesh_write(path, handle, chosen, lent, error); threads=threads, progress=progress)
    end
end

"Throws, with the place, unless tetrahedra and hexahedra fill a solid."
check_cells(mesh::Mesh; host...) =
    with_mesh(handle -> hosted((lent, error) -> Raw.obc_mesh_check_cells(handle, lent, error); host...), mesh)

"The surface of the solid that the cells fill, with the same vertices."
boundary(mesh::Mesh; host...) =
    with_mesh(handle -> taken((out, lent, error) -> Raw.obc_mesh_boundary(handle, lent, out, error); host...), mesh)

"Unit normals of the vertices."
function vertex_normals(surface::Surface; host...)
    normals = similar(surface.positions)
    with_surface((view, lent, error) -> Raw.obc_mesh_vertex_normals(view, lent, normals, error), surface; host...)
    normals
end

"A third of the area of its triangles for each vertex: the usual weights of a fit by harmonics."
function vertex_areas(surface::Surface; host...)
    areas = Vector{Float64}(undef, vertex_count(surface))
    with_surface((view, lent, error) -> Raw.obc_mesh_vertex_areas(view, lent, areas, error), surface; host...)
    areas
end

# f(first, second, host, error) with pointers to two obc_surfaces.
function with_surfaces(f, first::Surface, second::Surface; host...)
    a, b = Ref(viewed(first)), Ref(viewed(second))
    GC.@preserve first second a b hosted((lent, error) -> f(struct_pointer(a), struct_pointer(b), lent, error); host...)
end

"Distances between two surfaces, both ways: an obc_mesh_distance."
function surface_distance(first::Surface, second::Surface; host...)
    distance = filled(Raw.obc_mesh_distance, Raw.obc_mesh_distance_init, NamedTuple())
    with_surfaces((a, b, lent, error) -> Raw.obc_mesh_surface_distance(a, b, lent, distance, error), first, second; host...)
    distance
end

"The reconstruction error e(A, B) between points (3 by n)."
function mean_distance(a::AbstractMatrix, b::AbstractMatrix; host...)
    n, m, distance = columns(a, 3, "a"), columns(b, 3, "b"), Ref(0.0)
    one, other = doubles(a), doubles(b)
    hosted((lent, error) -> Raw.obc_mesh_mean_distance(one, n, other, m, lent, distance, error); host...)
    distance[]
end

"How well shaped tetrahedra are: an obc_mesh_tetrahedron_quality_report."
function tetrahedron_quality(mesh::Mesh; host...)
    report = filled(Raw.obc_mesh_tetrahedron_quality_report, Raw.obc_mesh_tetrahedron_quality_report_init, NamedTuple())
    with_mesh(handle -> hosted((lent, error) -> Raw.obc_mesh_tetrahedron_quality(handle, lent, report, error); host...), mesh)
    report
end

"Throws, with the place, unless the surface is what sphere maps need."
check_closed_genus_zero(surface::Surface; host...) =
    with_surface((view, lent, error) -> Raw.obc_mesh_check_closed_genus_zero(view, lent, error), surface; host...)

"The surface with triangles turned so that neighbors agree and a closed one is outward-oriented, and what was done."
function orient(surface::Surface; host...)
    report = filled(Raw.obc_mesh_orient_report, Raw.obc_mesh_orient_report_init, NamedTuple())
    turned = copy(surface.triangles)
    hosted(; host...) do lent, error
        Raw.obc_mesh_orient(surface.positions, vertex_count(surface), turned, size(turned, 2), lent, report, error)
    end
    Surface(surface.positions, turned, Val(:from_zero)), report
end

"The first pairs of triangles (2 by k) that have more in common than the vertices they share, decided exactly."
function intersections(surface::Surface, capacity=1000; host...)
    pairs, count = Matrix{UInt32}(undef, 2, capacity), Ref{Csize_t}(0)
    with_surface((view, lent, error) -> Raw.obc_mesh_intersections(view, lent, pairs, capacity, count, error), surface; host...)
    Int.(pairs[:, 1:count[]]) .+ 1
end

"For each vertex the lowest one at its very position."
function first_at_same_position(positions::AbstractMatrix; host...)
    n, places = columns(positions, 3, "positions"), doubles(positions)
    first = Vector{UInt32}(undef, n)
    hosted((lent, error) -> Raw.obc_mesh_first_at_same_position(places, n, lent, first, error); host...)
    Int.(first) .+ 1
end

"A surface made ready for searching: `nearest_vertices(search, points)`, `nearest_points(search, points)`."
mutable struct Search
    handle::Ptr{Cvoid}
end

function Search(surface::Surface; host...)
    out = Ref(C_NULL)
    with_surface((view, lent, error) -> Raw.obc_mesh_search_create(view, lent, out, error), surface; host...)
    finalizer(it -> released(Raw.obc_mesh_search_destroy, it.handle), Search(out[]))
end

"The vertex nearest to each point (3 by n)."
function nearest_vertices(search::Search, points::AbstractArray)
    n, asked = columns(points, 3, "points"), doubles(points)
    found = Vector{UInt32}(undef, n)
    GC.@preserve search checked(error -> Raw.obc_mesh_search_vertices(search.handle, asked, n, found, error))
    Int.(found) .+ 1
end

"Of the nearest points of the surface: `triangles`, `weights` at their corners (3 by n), `positions` (3 by n) and `distances`."
function nearest_points(search::Search, points::AbstractArray)
    n, asked = columns(points, 3, "points"), doubles(points)
    found, weights, places, away = Vector{UInt32}(undef, n), Matrix{Float64}(undef, 3, n), Matrix{Float64}(undef, 3, n), Vector{Float64}(undef, n)
    GC.@preserve search checked(error -> Raw.obc_mesh_search_surface(search.handle, asked, n, found, weights, places, away, error))
    (triangles=Int.(found) .+ 1, weights=weights, positions=places, distances=away)
end

function exact_sign(f, dimension, points...)
    foreach(point -> expect(length(point), dimension, "a point"), points)
    answer = f(map(doubles, points)...)
    answer == 2 && throw(ArgumentError("a coordinate is not finite, or there is no memory"))
    Int(answer)
end

"Exact sign of (b - a) x (c - a)."
orientation_2d(a, b, c) = exact_sign(Raw.obc_mesh_orientation_2d, 2, a, b, c)
"Exact sign of det[b - a, c - a, d - a]."
orientation_3d(a, b, c, d) = exact_sign(Raw.obc_mesh_orientation_3d, 3, a, b, c, d)
"Exact sign of det[p, q, r]."
orientation_from_origin(p, q, r) = exact_sign(Raw.obc_mesh_orientation_from_origin, 3, p, q, r)

# The surface of the call f(options, out, host, error), and its notes.
function taken_gltf(f, morph_target, weld_identical; host...)
    chosen, name = filled(Raw.obc_gltf_read_options, Raw.obc_gltf_read_options_init, (weld_identical=weld_identical,)), something(morph_target, "")
    out = Ref(C_NULL)
    GC.@preserve name begin
        morph_target === nothing || (chosen.morph_target = Base.unsafe_convert(Cstring, name))
        hosted((lent, error) -> f(chosen, out, lent, error); host...)
    end
    try
        places = Matrix{Float64}(undef, 3, Raw.obc_gltf_surface_vertex_count(out[]))
        faces = Matrix{UInt32}(undef, 3, Raw.obc_gltf_surface_triangle_count(out[]))
        checked(error -> Raw.obc_gltf_surface_copy(out[], places, faces, error))
        notes = [text(Raw.obc_gltf_surface_note(out[], i)) for i in 0:Int(Raw.obc_gltf_surface_note_count(out[]))-1]
        Surface(places, faces, Val(:from_zero)), (welded=Int(Raw.obc_gltf_surface_welded_vertex_count(out[])), notes=notes)
    finally
        Raw.obc_gltf_surface_destroy(out[])
    end
end

"""
    surface, about = read_gltf(path; morph_target=nothing, weld_identical=true)
    surface, about = read_gltf(bytes; folder=nothing)

Reads GLB and glTF in JSON in world coordinates; with the name of a morph target, that shape of it. Of bytes, buffers in files of their own lie in
`folder`; without one they are refused. `about` has the number of `welded` vertices, and `notes`.
"""
read_gltf(path::AbstractString; morph_target=nothing, weld_identical=true, host...) =
    taken_gltf((options, out, lent, error) -> Raw.obc_gltf_read(path, options, lent, out, error), morph_target, weld_identical; host...)

read_gltf(bytes::Vector{UInt8}; folder=nothing, morph_target=nothing, weld_identical=true, host...) =
    taken_gltf(morph_target, weld_identical; host...) do options, out, lent, error
        Raw.obc_gltf_read_memory(bytes, length(bytes), folder === nothing ? C_NULL : folder, options, lent, out, error)
    end

"""
    write_gltf(path, surface; morph_targets=["sphere" => directions], members...)

Writes GLB, or JSON with the ending `gltf`, in 32-bit floats. morph_targets: names, and where the vertices are (3 by n). normals (3 by n),
texture_coordinates (2 by n), colors (4 by n, 0 to 255), edges (2 by k, from 1), texture (bytes of a PNG or JPEG file), translation, base_color, name,
extras (JSON); members: smooth_normals (true unless normals are given), scale, checker_texture, morph_normals, morph_seconds.
"""
function write_gltf(path, surface::Surface; morph_targets=Pair{String,Matrix{Float64}}[], normals=nothing, texture_coordinates=nothing,
                    colors=nothing, edges=nothing, texture=nothing, name=nothing, extras=nothing, smooth_normals=normals === nothing,
                    threads=0, progress=nothing, members...)
    n = vertex_count(surface)
    scene = filled(Raw.obc_gltf_scene, Raw.obc_gltf_scene_init, merge((smooth_normals=smooth_normals,), values(members)))
    kept = Any[]
    keep(it) = (push!(kept, it); it)
    floats(values, rows, what) = (expect(length(values), rows * n, what); pointer(keep(convert(Array{Float32}, values))))
    scene.positions, scene.vertex_count = floats(surface.positions, 3, "positions"), n
    scene.triangles, scene.triangle_count = pointer(keep(surface.triangles)), size(surface.triangles, 2)
    normals === nothing || (scene.normals = floats(normals, 3, "normals"))
    texture_coordinates === nothing || (scene.texture_coordinates = floats(texture_coordinates, 2, "texture_coordinates"))
    if colors !== nothing
        expect(length(colors), 4 * n, "colors")
        scene.colors = pointer(keep(convert(Array{UInt8}, colors)))
    end
    if edges !== nothing
        scene.edge_count = columns(edges, 2, "edges")
        scene.edges = pointer(keep(UInt32.(edges .- 1)))
    end
    if texture !== nothing
        scene.texture, scene.texture_size = pointer(keep(convert(Vector{UInt8}, texture))), length(texture)
    end
    named(it) = Base.unsafe_convert(Cstring, keep(String(it)))
    targets = keep([Raw.obc_gltf_morph_target(named(title), floats(places, 3, title)) for (title, places) in morph_targets])
    isempty(targets) || (scene.morph_targets = pointer(targets); scene.morph_target_count = length(targets))
    name === nothing || (scene.name = named(name))
    extras === nothing || (scene.extras = named(extras))
    GC.@preserve kept surface hosted((lent, error) -> Raw.obc_gltf_write(path, scene, lent, error); threads=threads, progress=progress)
end

"""
    fill_with_tetrahedra(surface; size_positions, size_lengths, options...)

A closed surface filled by TetGen, whose license, the AGPL 3, binds programs that call this: `positions` (the surface's first), `tetrahedra`,
`boundary`, `boundary_source` (triangles of the surface), `parts` and `cavities`. Options: keep_surface, quality, max_volume, edge_length,
size_growth.
"""
function fill_with_tetrahedra(surface::Surface; size_positions=nothing, size_lengths=Float64[], threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_tetrahedra_options, Raw.obc_tetrahedra_options_init, values(options))
    places, lengths, out = doubles(something(size_positions, zeros(3, 0))), doubles(size_lengths), Ref(C_NULL)
    expect(length(lengths), columns(places, 3, "size_positions"), "size_lengths")
    if !isempty(lengths)
        chosen.size_positions, chosen.size_lengths, chosen.size_count = pointer(places), pointer(lengths), length(lengths)
    end
    GC.@preserve places lengths with_surface(surface; threads=threads, progress=progress) do view, lent, error
        Raw.obc_tetrahedra_fill(view, chosen, lent, out, error)
    end
    try
        positions = Matrix{Float64}(undef, 3, Raw.obc_tetrahedra_vertex_count(out[]))
        cells = Matrix{UInt32}(undef, 4, Raw.obc_tetrahedra_count(out[]))
        faces = Matrix{UInt32}(undef, 3, Raw.obc_tetrahedra_boundary_count(out[]))
        source = Vector{UInt32}(undef, size(faces, 2))
        checked(error -> Raw.obc_tetrahedra_copy(out[], positions, cells, faces, source, error))
        (positions=positions, tetrahedra=Int.(cells) .+ 1, boundary=Int.(faces) .+ 1, boundary_source=Int.(source) .+ 1,
         parts=Int(Raw.obc_tetrahedra_part_count(out[])), cavities=Int(Raw.obc_tetrahedra_cavity_count(out[])))
    finally
        Raw.obc_tetrahedra_destroy(out[])
    end
end

"Throws, with kind and place, unless `fill_with_tetrahedra` can work."
function check_fillable(surface::Surface; host...)
    count = Ref{Csize_t}(0)
    with_surface((view, lent, error) -> Raw.obc_tetrahedra_check_surface(view, lent, C_NULL, 0, count, error), surface; host...)
end

"""
    repaired = repair_surface(surface; options...)

Any triangles to a closed, oriented, manifold surface: `surface`, `vertex_source` and `triangle_source` (numbers in the input, 0: made by the repair),
`events` (what was done where: `action`, `count`, `place`, `size`) and `report`, with the certificate. Options: members of `obc_repair_options`.
"""
function repair_surface(surface::Surface; threads=0, progress=nothing, options...)
    chosen, out = filled(Raw.obc_repair_options, Raw.obc_repair_options_init, values(options)), Ref(C_NULL)
    with_surface(surface; threads=threads, progress=progress) do view, lent, error
        Raw.obc_repair_compute(view, chosen, lent, out, error)
    end
    try
        positions = Matrix{Float64}(undef, 3, Raw.obc_repair_vertex_count(out[]))
        faces = Matrix{UInt32}(undef, 3, Raw.obc_repair_triangle_count(out[]))
        vertices, triangles = Vector{UInt32}(undef, size(positions, 2)), Vector{UInt32}(undef, size(faces, 2))
        checked(error -> Raw.obc_repair_copy(out[], positions, faces, vertices, triangles, error))
        n = Raw.obc_repair_event_count(out[])
        actions, counts, places, sizes = Vector{Int32}(undef, n), Vector{UInt32}(undef, n), Matrix{Float64}(undef, 3, n), Vector{Float64}(undef, n)
        checked(error -> Raw.obc_repair_copy_events(out[], actions, counts, places, sizes, error))
        events = [(action=unsafe_string(Raw.obc_repair_action_name(actions[i])), count=Int(counts[i]), place=places[:, i], size=sizes[i]) for i in 1:n]
        report = filled(Raw.obc_repair_report, Raw.obc_repair_report_init, (;))
        checked(error -> Raw.obc_repair_get_report(out[], report, error))
        number(source) = source == typemax(UInt32) ? 0 : Int(source) + 1
        (surface=Surface(positions, Int.(faces) .+ 1), vertex_source=number.(vertices), triangle_source=number.(triangles), events=events,
         report=report)
    finally
        Raw.obc_repair_destroy(out[])
    end
end

"""
    made = surface_of_label(labels, to_world=nothing; options...)

The closed surface of a label of an image: `labels`, integers with three axes, and `to_world`, the 4x4 matrix from voxel numbers, counted from 0,
to positions; nothing: positions are these numbers. Returns `surface`, `label_report` and `report`, with the certificate. Options: members of
`obc_repair_label_options`.
"""
function surface_of_label(labels::AbstractArray{<:Integer,3}, to_world=nothing; threads=0, progress=nothing, options...)
    isnothing(to_world) || size(to_world) == (4, 4) || throw(ArgumentError("to_world: a 4x4 matrix is needed"))
    image, sizes = Array{Int32,3}(labels), collect(Csize_t, size(labels))
    matrix = isnothing(to_world) ? C_NULL : Vector{Float64}(vec(permutedims(to_world)))
    chosen, out = filled(Raw.obc_repair_label_options, Raw.obc_repair_label_options_init, values(options)), Ref(C_NULL)
    hosted(; threads=threads, progress=progress) do lent, error
        Raw.obc_repair_surface_of_label(image, sizes, matrix, chosen, lent, out, error)
    end
    try
        positions = Matrix{Float64}(undef, 3, Raw.obc_repair_vertex_count(out[]))
        faces = Matrix{UInt32}(undef, 3, Raw.obc_repair_triangle_count(out[]))
        checked(error -> Raw.obc_repair_copy(out[], positions, faces, C_NULL, C_NULL, error))
        report = filled(Raw.obc_repair_report, Raw.obc_repair_report_init, (;))
        label_report = filled(Raw.obc_repair_label_report, Raw.obc_repair_label_report_init, (;))
        checked(error -> Raw.obc_repair_get_report(out[], report, error))
        checked(error -> Raw.obc_repair_get_label_report(out[], label_report, error))
        (surface=Surface(positions, Int.(faces) .+ 1), label_report=label_report, report=report)
    finally
        Raw.obc_repair_destroy(out[])
    end
end
