# Polycubes of closed surfaces. Numbers of vertices, triangles, corners, edges and patches count from 1.

"""
A certified polycube map: `positions` in space and `polycube` (3 by n; the surface's vertices first), `triangles` (3 by m), numbers of
`corners` and `patches`, and the `report` of the optimization that it comes from, if it comes from one.
"""
mutable struct PolycubeMap
    handle::Ptr{Cvoid}
    positions::Matrix{Float64}
    polycube::Matrix{Float64}
    triangles::Matrix{Int}
    corners::Int
    patches::Int
    report::Any
end

# Owns the handle from the first line on.
function PolycubeMap(handle::Ptr{Cvoid}, report=nothing)
    n, m = Raw.obc_polycube_vertex_count(handle), Raw.obc_polycube_triangle_count(handle)
    map = PolycubeMap(handle, Matrix{Float64}(undef, 3, n), Matrix{Float64}(undef, 3, n), Matrix{Int}(undef, 3, m),
                      Raw.obc_polycube_corner_count(handle), Raw.obc_polycube_patch_count(handle), report)
    finalizer(it -> released(Raw.obc_polycube_destroy, it.handle), map)
    faces = Matrix{UInt32}(undef, 3, m)
    checked(error -> Raw.obc_polycube_copy(handle, map.positions, map.polycube, faces, error))
    map.triangles .= Int.(faces) .+ 1
    map
end

Base.show(io::IO, map::PolycubeMap) = print(io, "PolycubeMap(", map.corners, " corners, ", map.patches, " patches, ",
                                            size(map.positions, 2), " vertices)")

# A map of the call f(host, out, error).
function made(f, report=nothing; host...)
    out = Ref(C_NULL)
    hosted((lent, error) -> f(lent, out, error); host...)
    PolycubeMap(out[], report)
end

on_surface(f, surface::Surface; host...) =
    (view = Ref(viewed(surface)); GC.@preserve surface view made((lent, out, error) -> f(struct_pointer(view), lent, out, error); host...))

domain_options(given) = filled(Raw.obc_polycube_domain_options, Raw.obc_polycube_domain_options_init, given, "OBC_POLYCUBE_")

"""
A polycube of a closed surface of any genus; with `optimize_domain` the one with the best proportions. Options: construction (`:auto`,
`:labels`, `:voxels`, `:dissertation`), corners, seed; of `:dissertation` also area_weight and rounds.
"""
function polycube(surface::Surface; optimize_domain=true, threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_polycube_options, Raw.obc_polycube_options_init, values(options), "OBC_POLYCUBE_")
    map = on_surface(surface; threads=threads, progress=progress) do view, lent, out, error
        Raw.obc_polycube_compute(view, chosen, lent, out, error)
    end
    optimize_domain ? Orbicube.optimize_domain(map; threads=threads, progress=progress) : map
end

"""
Maps a surface to a polycube that is given as a surface, or by a map to it. Vertex `corners[i]` of the polycube is to be at vertex
`vertices[i]` of the surface or, where that is 0 or missing, nearest to column i of `points`.
"""
function polycube_on(surface::Surface, target::Surface; corners=nothing, vertices=nothing, points=nothing, threads=0, progress=nothing)
    constraints = C_NULL
    chosen, near, to = UInt32[], UInt32[], doubles(points === nothing ? zeros(3, 0) : points)
    if corners !== nothing
        chosen = UInt32.(corners .- 1)
        vertices === nothing || expect(length(vertices), length(chosen), "vertices")
        points === nothing || expect(columns(points, 3, "points"), length(chosen), "columns of points")
        near = vertices === nothing ? UInt32[] : UInt32[v == 0 ? typemax(UInt32) : v - 1 for v in vertices]
        nowhere(array) = isempty(array) ? Ptr{eltype(array)}(C_NULL) : pointer(array)
        constraints = Ref(Raw.obc_polycube_constraints(nowhere(chosen), nowhere(near), nowhere(to), length(chosen)))
    end
    other = Ref(viewed(target))
    GC.@preserve target other chosen near to constraints on_surface(surface; threads=threads, progress=progress) do view, lent, out, error
        Raw.obc_polycube_map_to_domain(view, struct_pointer(other), constraints === C_NULL ? C_NULL : struct_pointer(constraints), lent, out, error)
    end
end
polycube_on(surface::Surface, map::PolycubeMap; more...) = polycube_on(surface, Surface(map.polycube, map.triangles); more...)

"A map made elsewhere, `places` (3 by n) being where the vertices are on the polycube; an OrbicubeError says why it is none."
function certify_polycube(surface::Surface, places::AbstractMatrix; host...)
    expect(length(places), 3 * vertex_count(surface), "places")
    at = doubles(places)
    on_surface((view, lent, out, error) -> Raw.obc_polycube_create(view, at, lent, C_NULL, out, error), surface; host...)
end

# Several maps of the call f(host, out, error).
function made_together(f, count; host...)
    out = fill(C_NULL, count)
    hosted((lent, error) -> f(lent, out, error); host...)
    [PolycubeMap(handle) for handle in out]
end

"""
    maps, constructed_from = common_polycube(surfaces; domain=NamedTuple(), options...)

One polycube for several shapes: a map each, and the number of the shape that it was made for. `domain`: options of `optimize_domain`.
"""
function common_polycube(surfaces::AbstractVector{Surface}; domain=NamedTuple(), threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_polycube_options, Raw.obc_polycube_options_init, values(options), "OBC_POLYCUBE_")
    energy, views, constructed_from = domain_options(domain), viewed.(surfaces), Ref(Csize_t(0))
    maps = GC.@preserve surfaces made_together(length(views); threads=threads, progress=progress) do lent, out, error
        Raw.obc_polycube_compute_common(views, length(views), chosen, energy, lent, constructed_from, out, error)
    end
    maps, Int(constructed_from[]) + 1
end

"The best distances between the planes. Options: measure (`:surface_mean`, `:face_mean`, `:harmonic`), area_weight."
function optimize_domain(map::PolycubeMap; threads=0, progress=nothing, options...)
    chosen, report = domain_options(values(options)), sized(Raw.obc_polycube_domain_report)
    GC.@preserve map made(report; threads=threads, progress=progress) do lent, out, error
        Raw.obc_polycube_optimize_domain(map.handle, chosen, lent, report, out, error)
    end
end

"The same for maps to one polycube: the minimum sum of energies."
function optimize_domain(maps::AbstractVector{PolycubeMap}; threads=0, progress=nothing, options...)
    chosen, handles = domain_options(values(options)), [map.handle for map in maps]
    GC.@preserve maps made_together(length(maps); threads=threads, progress=progress) do lent, out, error
        Raw.obc_polycube_optimize_common_domain(handles, length(handles), chosen, lent, out, error)
    end
end

"Better positions of the corners on the surface. Options: method (`:trust_region`, `:gradient`), area_weight, domain, rounds."
function optimize_corners(map::PolycubeMap; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_polycube_corner_options, Raw.obc_polycube_corner_options_init, values(options), "OBC_POLYCUBE_")
    report = sized(Raw.obc_polycube_corner_report)
    GC.@preserve map made(report; threads=threads, progress=progress) do lent, out, error
        Raw.obc_polycube_optimize_corners(map.handle, chosen, lent, report, out, error)
    end
end

"""
    align_features(map; vertices, targets, weights, curves, feature_angle)

The same polycube with `vertices` of the map at `targets` on it (3 by count), each of the `curves` (vertices, from, to and perhaps a weight)
along a line, and edges of `feature_angle` degrees on edges of the polycube. Without weights all of that is met exactly.
"""
function align_features(map::PolycubeMap; vertices=Int[], targets=zeros(3, 0), weights=nothing, curves=(), feature_angle=0, threads=0,
                       progress=nothing)
    chosen = filled(Raw.obc_polycube_feature_options, Raw.obc_polycube_feature_options_init, (feature_angle=feature_angle,))
    points, at = UInt32[v - 1 for v in vertices], doubles(targets)
    expect(columns(at, 3, "targets"), length(points), "columns of targets")
    heavy = weights === nothing ? Float64[] : doubles(weights)
    weights === nothing || expect(length(heavy), length(points), "weights")
    starts, along, lines, bound = UInt32[0], UInt32[], Float64[], Float64[]
    for curve in curves
        append!(along, UInt32[v - 1 for v in curve[1]])
        push!(starts, length(along))
        expect(length(curve[2]), 3, "line"), expect(length(curve[3]), 3, "line")
        append!(append!(lines, curve[2]), curve[3])
        push!(bound, length(curve) > 3 ? curve[4] : 0)
    end
    chosen.point_count, chosen.points, chosen.targets = length(points), pointer(points), pointer(at)
    weights === nothing || (chosen.point_weights = pointer(heavy))
    chosen.curve_count, chosen.curve_starts, chosen.curve_vertices = length(bound), pointer(starts), pointer(along)
    chosen.curve_lines, chosen.curve_weights = pointer(lines), pointer(bound)
    report = sized(Raw.obc_polycube_feature_report)
    GC.@preserve map points at heavy starts along lines bound made(report; threads=threads, progress=progress) do lent, out, error
        Raw.obc_polycube_align_features(map.handle, chosen, lent, report, out, error)
    end
end

"Of the optimization that a map comes from; they never rise."
function energies(map::PolycubeMap)
    GC.@preserve map begin
        found = Vector{Float64}(undef, Raw.obc_polycube_energy_count(map.handle))
        checked(error -> Raw.obc_polycube_copy_energies(map.handle, found, error))
    end
    found
end

parts(starts, of) = [of[starts[i]+1:starts[i+1]] for i in 1:length(starts)-1]

"""
Corners (`corner_positions`, `corner_vertices` of the map), straight edges (`edge_corners`, `edge_patches` on the left and on the right,
`edge_convex`), patches (`patch_labels`, 0 to 5 for +x to -z, `patch_coordinates`), of each patch its `loops` of darts (dart 2 e - 1 is edge
e, 2 e the way back) and the `neighbors` that share an edge with it.
"""
function polycube_graph(map::PolycubeMap; host...)
    out = Ref(C_NULL)
    GC.@preserve map hosted((lent, error) -> Raw.obc_polycube_graph_create(map.handle, lent, out, error); host...)
    graph = out[]
    try
        corners, edges = Raw.obc_polycube_graph_corner_count(graph), Raw.obc_polycube_graph_edge_count(graph)
        patches, loops = Raw.obc_polycube_graph_patch_count(graph), Raw.obc_polycube_graph_loop_count(graph)
        numbers(size...) = Array{UInt32}(undef, size...)
        places, vertices = Matrix{Float64}(undef, 3, corners), numbers(corners)
        checked(error -> Raw.obc_polycube_graph_copy_corners(graph, places, vertices, error))
        ends, sides, convex = numbers(2, edges), numbers(2, edges), Vector{UInt8}(undef, edges)
        checked(error -> Raw.obc_polycube_graph_copy_edges(graph, ends, sides, convex, error))
        labels, coordinates, loops_of = Vector{UInt8}(undef, patches), Vector{Float64}(undef, patches), numbers(patches + 1)
        checked(error -> Raw.obc_polycube_graph_copy_patches(graph, labels, coordinates, loops_of, error))
        starts, darts = numbers(loops + 1), numbers(2 * edges)
        checked(error -> Raw.obc_polycube_graph_copy_loops(graph, starts, darts, error))
        dual, neighbors = numbers(patches + 1), numbers(Raw.obc_polycube_graph_link_count(graph))
        checked(error -> Raw.obc_polycube_graph_copy_dual(graph, dual, neighbors, error))
        (corner_positions=places, corner_vertices=Int.(vertices) .+ 1, edge_corners=Int.(ends) .+ 1, edge_patches=Int.(sides) .+ 1,
         edge_convex=convex .!= 0, patch_labels=Int.(labels), patch_coordinates=coordinates,
         loops=parts(loops_of, parts(starts, Int.(darts) .+ 1)), neighbors=parts(dual, Int.(neighbors) .+ 1))
    finally
        Raw.obc_polycube_graph_destroy(graph)
    end
end

"""
A mesh of quads on the surface: `positions` and `polycube` (3 by n), `quads` (4 by m), `patches`, and where vertices lie in the map:
`triangles` and `weights`. Options: quads, edge_length.
"""
function polycube_quads(map::PolycubeMap; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_polycube_quads_options, Raw.obc_polycube_quads_options_init, values(options))
    out = Ref(C_NULL)
    GC.@preserve map hosted(threads=threads, progress=progress) do lent, error
        Raw.obc_polycube_quads_create(map.handle, chosen, lent, out, error)
    end
    try
        n, m = Raw.obc_polycube_quads_vertex_count(out[]), Raw.obc_polycube_quads_quad_count(out[])
        places, cube, weights = Matrix{Float64}(undef, 3, n), Matrix{Float64}(undef, 3, n), Matrix{Float64}(undef, 3, n)
        cells, patches, faces = Matrix{UInt32}(undef, 4, m), Vector{UInt32}(undef, m), Vector{UInt32}(undef, n)
        checked(error -> Raw.obc_polycube_quads_copy(out[], places, cube, cells, patches, error))
        checked(error -> Raw.obc_polycube_quads_copy_sources(out[], faces, weights, error))
        (positions=places, polycube=cube, quads=Int.(cells) .+ 1, patches=Int.(patches) .+ 1, triangles=Int.(faces) .+ 1, weights=weights)
    finally
        Raw.obc_polycube_quads_destroy(out[])
    end
end

"""
A texture atlas of a map: `coordinates` (u and v, 0 to 1 from the top left, of the three corners of each triangle: 2 by 3 by m), `size` (texels
along each side), `texels_per_unit` of the polycube, and `coverage`, the fraction of the square in patches.
"""
mutable struct Atlas
    handle::Ptr{Cvoid}
    size::Int
    coordinates::Array{Float64,3}
    texels_per_unit::Float64
    coverage::Float64
end

Base.show(io::IO, atlas::Atlas) = print(io, "Atlas(", atlas.size, " x ", atlas.size, " texels, ", size(atlas.coordinates, 3), " triangles)")

"The patches of a polycube packed into a square, for textures. Options: size, padding (texels)."
function polycube_atlas(map::PolycubeMap; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_polycube_atlas_options, Raw.obc_polycube_atlas_options_init, values(options))
    out, scale, coverage = Ref(C_NULL), Ref(0.0), Ref(0.0)
    GC.@preserve map hosted(threads=threads, progress=progress) do lent, error
        Raw.obc_polycube_atlas_create(map.handle, chosen, lent, out, error)
    end
    atlas = Atlas(out[], Int(Raw.obc_polycube_atlas_size(out[])), Array{Float64}(undef, 2, 3, Raw.obc_polycube_atlas_triangle_count(out[])), 0, 0)
    finalizer(it -> released(Raw.obc_polycube_atlas_destroy, it.handle), atlas)
    checked(error -> Raw.obc_polycube_atlas_copy(atlas.handle, atlas.coordinates, scale, coverage, error))
    atlas.texels_per_unit, atlas.coverage = scale[], coverage[]
    atlas
end

"""
What each texel of an atlas shows; the first index goes from the left, the second from the top: `triangles` of the map (0 for none), `weights` of
their corners (3 by size by size), and whether they have the middle of the texel (`covered`); others show the nearest texel in a patch.
"""
function sample(atlas::Atlas; host...)
    n = atlas.size
    faces, weights, covered = Matrix{UInt32}(undef, n, n), Array{Float64}(undef, 3, n, n), Matrix{UInt8}(undef, n, n)
    GC.@preserve atlas hosted(; host...) do lent, error
        Raw.obc_polycube_atlas_sample(atlas.handle, lent, faces, weights, covered, error)
    end
    (triangles=[face == typemax(UInt32) ? 0 : Int(face) + 1 for face in faces], weights=weights, covered=covered .!= 0)
end
