# Maps of solids, and hexahedra.

"""
    positions, report = untangle(positions, tetrahedra; rest, fixed, ties, keep_best=false, options...)
    positions, report = untangle(positions, triangles; rest, fixed, ties, keep_best=false, options...)

Moves vertices until every tetrahedron (4 by m, from 1; positions 3 by n) is positive, or every triangle (3 by m) of a flat mesh (positions 2 by
n). rest: positions (3 by n) where each has its target shape, such as a surface whose map to the plane a flat mesh is. fixed: a flag a coordinate
or a vertex (n); default: boundary vertices are fixed. ties: a group a coordinate, from 1 to their number, of which all are to be equal, or 0.
Where some stay inverted an OrbicubeError is thrown or, with `keep_best`, the best is returned: `report.inverted` says how many. Options:
max_steps, max_polish_steps, free_boundary, volume_weight, tolerance.
"""
function untangle(positions::AbstractMatrix, elements::AbstractMatrix{<:Integer}; rest=nothing, fixed=nothing, ties=nothing,
                  keep_best=false, threads=0, progress=nothing, options...)
    problem, kept = untangle_problem(positions, elements, rest, fixed, ties)
    flat, axes, n = size(elements, 1) == 3, size(positions, 1), size(positions, 2)
    chosen = filled(Raw.obc_untangle_options, Raw.obc_untangle_options_init, values(options))
    report = filled(Raw.obc_untangle_report, Raw.obc_untangle_report_init, NamedTuple())
    result = Matrix{Float64}(undef, axes, n)
    try
        GC.@preserve kept hosted(threads=threads, progress=progress) do lent, error
            flat ? Raw.obc_untangle_triangles(problem, chosen, lent, result, report, error) :
                   Raw.obc_untangle_tetrahedra(problem, chosen, lent, result, report, error)
        end
    catch error
        keep_best && error isa OrbicubeError && error.status == Raw.OBC_NO_VALID_RESULT || rethrow()
    end
    result, report
end

# The problem of C, and the arrays that it is a view of.
function untangle_problem(positions, elements, rest, fixed, ties)
    flat = size(elements, 1) == 3
    axes = flat ? 2 : 3
    if flat
        n, m = columns(positions, 2, "positions"), size(elements, 2)
        all(v -> 1 <= v <= n, elements) || throw(ArgumentError("triangles: numbers of vertices from 1 to $n are needed"))
        places, cells = doubles(positions), UInt32.(elements .- 1)
        problem = filled(Raw.obc_untangle_triangles_problem, Raw.obc_untangle_triangles_problem_init, NamedTuple())
        problem.triangles, problem.triangle_count = pointer(cells), m
    else
        places, n, cells, m = solid_arrays(positions, elements)
        problem = filled(Raw.obc_untangle_tetrahedra_problem, Raw.obc_untangle_tetrahedra_problem_init, NamedTuple())
        problem.tetrahedra, problem.tetrahedron_count = pointer(cells), m
    end
    problem.positions, problem.vertex_count = pointer(places), n
    shape, flags, groups = zeros(0, 0), UInt8[], UInt32[]
    if rest !== nothing
        expect(columns(rest, 3, "rest"), n, "columns of rest")
        shape = doubles(rest)
        problem.rest = pointer(shape)
    end
    if fixed !== nothing
        expect(size(fixed, ndims(fixed)), n, "columns of fixed")
        flags = vec(UInt8.(fixed .!= 0))
        expect(length(flags), ndims(fixed) == 1 ? n : axes * n, "fixed")
        ndims(fixed) == 1 ? (problem.fixed = pointer(flags)) : (problem.fixed_coordinates = pointer(flags))
    end
    if ties !== nothing
        expect(length(ties), axes * n, "ties")
        groups = UInt32[group == 0 ? typemax(UInt32) : group - 1 for group in ties]
        problem.ties = pointer(groups)
    end
    problem, (places, cells, shape, flags, groups)
end

"""
A mesh whose elements were split where that is needed, vertices of the mesh before first: `positions` (2 or 3 by n), `elements` (3 or 4 by m,
from 1), `parents` (m), the elements of the mesh before that they are parts of, `origins` and `weights` (3 or 4 by n), the vertices there whose
mean each vertex is (0 with weight 0: none), and the `report`.
"""
struct RefinedMesh
    positions::Matrix{Float64}
    elements::Matrix{Int}
    parents::Vector{Int}
    origins::Matrix{Int}
    weights::Matrix{Float64}
    report::Any
end

"""
    refine_untangled(positions, elements; rest, fixed, ties, options...)

As untangle(), and splits elements where the mesh as it is has no solution, or none is found. A disk of triangles whose boundary is fixed to
a star-shaped polygon always has one.
"""
function refine_untangled(positions::AbstractMatrix, elements::AbstractMatrix{<:Integer}; rest=nothing, fixed=nothing, ties=nothing,
                          threads=0, progress=nothing, options...)
    problem, kept = untangle_problem(positions, elements, rest, fixed, ties)
    corners = size(elements, 1)
    chosen = filled(Raw.obc_untangle_options, Raw.obc_untangle_options_init, values(options))
    report = filled(Raw.obc_untangle_report, Raw.obc_untangle_report_init, NamedTuple())
    out = Ref(C_NULL)
    GC.@preserve kept hosted(threads=threads, progress=progress) do lent, error
        corners == 3 ? Raw.obc_untangle_refine_triangles(problem, chosen, lent, out, report, error) :
                       Raw.obc_untangle_refine_tetrahedra(problem, chosen, lent, out, report, error)
    end
    try
        n, m = Raw.obc_untangle_refined_vertex_count(out[]), Raw.obc_untangle_refined_element_count(out[])
        places, weights = Matrix{Float64}(undef, corners - 1, n), Matrix{Float64}(undef, corners, n)
        cells, parents, origins = Matrix{UInt32}(undef, corners, m), Vector{UInt32}(undef, m), Matrix{UInt32}(undef, corners, n)
        checked(error -> Raw.obc_untangle_refined_copy(out[], places, cells, parents, origins, weights, error))
        from_one(v) = v == typemax(UInt32) ? 0 : Int(v) + 1
        RefinedMesh(places, from_one.(cells), from_one.(parents), from_one.(origins), weights, report)
    finally
        Raw.obc_untangle_refined_destroy(out[])
    end
end

"A solid and the same on the polycube of its boundary: `positions`, `polycube` (3 by n), and `tetrahedra` of both (4 by m, from 1)."
struct SolidMap
    positions::Matrix{Float64}
    polycube::Matrix{Float64}
    tetrahedra::Matrix{Int}
end

"""
    map_to_polycube(positions, tetrahedra; options...)

Maps positive tetrahedra one to one to a polycube, splitting them where that is needed. Options: corners, seed.
"""
function map_to_polycube(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_volume_map_solid_options, Raw.obc_volume_map_solid_options_init, values(options))
    out = Ref(C_NULL)
    places, n, cells, m = solid_arrays(positions, tetrahedra)
    hosted(threads=threads, progress=progress) do lent, error
        Raw.obc_volume_map_solid_compute(places, n, cells, m, chosen, lent, out, error)
    end
    try
        n, m = Raw.obc_volume_map_solid_vertex_count(out[]), Raw.obc_volume_map_solid_tetrahedron_count(out[])
        places, polycube, cells = Matrix{Float64}(undef, 3, n), Matrix{Float64}(undef, 3, n), Matrix{UInt32}(undef, 4, m)
        checked(error -> Raw.obc_volume_map_solid_copy(out[], places, polycube, cells, error))
        SolidMap(places, polycube, Int.(cells) .+ 1)
    finally
        Raw.obc_volume_map_solid_destroy(out[])
    end
end

"""
A parameterization along frames: `parameters` (3 by 4 by m), and of each face, opposite a corner, `rotations`, `cut`, `labels` (4 by m) and
`gaps` (3 by 4 by m); `singular_edges` (2 by k, from 1), and the `report`.
"""
struct FrameMap
    parameters::Array{Float64,3}
    rotations::Matrix{UInt8}
    gaps::Array{Float64,3}
    cut::Matrix{UInt8}
    labels::Matrix{UInt8}
    singular_edges::Matrix{Int}
    report::Any
end

"""
    parameterize(positions, tetrahedra; frames=nothing, options...)

Coordinates whose gradients are the axes of the frames (4 by m; nothing: computed ones). Options: integer, cell_length, feature_angle.
"""
function parameterize(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}; frames=nothing, threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_volume_map_frame_map_options, Raw.obc_volume_map_frame_map_options_init, values(options))
    report = sized(Raw.obc_volume_map_frame_map_report)
    places, n, cells, m = solid_arrays(positions, tetrahedra)
    frames === nothing || expect(columns(frames, 4, "frames"), m, "columns of frames")
    quaternions = frames === nothing ? C_NULL : doubles(frames)
    out = Ref(C_NULL)
    hosted(threads=threads, progress=progress) do lent, error
        Raw.obc_volume_map_frame_map_compute(places, n, cells, m, quaternions, chosen, lent, report, out, error)
    end
    try
        edges = Matrix{UInt32}(undef, 2, Raw.obc_volume_map_frame_map_singular_edge_count(out[]))
        parameters, gaps = Array{Float64}(undef, 3, 4, m), Array{Float64}(undef, 3, 4, m)
        rotations, cut, labels = Matrix{UInt8}(undef, 4, m), Matrix{UInt8}(undef, 4, m), Matrix{UInt8}(undef, 4, m)
        checked(error -> Raw.obc_volume_map_frame_map_copy(out[], parameters, rotations, gaps, cut, labels, edges, error))
        FrameMap(parameters, rotations, gaps, cut, labels, Int.(edges) .+ 1, report)
    finally
        Raw.obc_volume_map_frame_map_destroy(out[])
    end
end

"Finds points in a mesh of tetrahedra: `locate(locator, points)`, `sample(locator, points, values)`."
mutable struct SolidLocator
    handle::Ptr{Cvoid}
    vertices::Int
end

function SolidLocator(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}; host...)
    places, n, cells, m = solid_arrays(positions, tetrahedra)
    out = Ref(C_NULL)
    hosted(; host...) do lent, error
        Raw.obc_volume_map_locator_create(places, n, cells, m, lent, out, error)
    end
    finalizer(it -> released(Raw.obc_volume_map_locator_destroy, it.handle), SolidLocator(out[], n))
end

# As C has them: from 0, and 2^32 - 1 where no tetrahedron has the point.
function located(locator::SolidLocator, points::AbstractArray; host...)
    n, asked = columns(points, 3, "points"), doubles(points)
    cells, weights = Vector{UInt32}(undef, n), Matrix{Float64}(undef, 4, n)
    GC.@preserve locator hosted(; host...) do lent, error
        Raw.obc_volume_map_locator_locate(locator.handle, asked, n, lent, cells, weights, error)
    end
    cells, weights
end

"The tetrahedron (from 1; 0: none) of each point, and its weights at the corners."
function locate(locator::SolidLocator, points::AbstractArray; host...)
    cells, weights = located(locator, points; host...)
    [cell == typemax(UInt32) ? 0 : Int(cell) + 1 for cell in cells], weights
end

"""
Values of the vertices, a column each, interpolated at points; NaN where no tetrahedron has the point. With the positions of the image as
values it is the map, and for a locator of the image, with those in space, its inverse.
"""
function sample(locator::SolidLocator, points::AbstractArray, values::AbstractMatrix; host...)
    expect(size(values, 2), locator.vertices, "columns of values")
    cells, weights = located(locator, points; host...)
    given, sampled = doubles(values), Matrix{Float64}(undef, size(values, 1), length(cells))
    GC.@preserve locator hosted(; host...) do lent, error
        Raw.obc_volume_map_locator_interpolate(locator.handle, cells, weights, length(cells), given, size(given, 1), lent, sampled, error)
    end
    sampled
end

"""
A certified mesh of hexahedra: `positions` (3 by n), `hexahedra` (8 by m, as MEDIT and VTK order their vertices), `quads` of the boundary
(4 by k, counter-clockwise seen from outside), `quad_patches`, the patch that each lies on (of the polycube, or of the features where they are embedded),
`regions`, the number of the region that each hexahedron is in, or 0, the features that are `missing` (corner or curve, its ends `first` and `last`, the `captured` fraction of its length, and `why`), and the `report`.
All count from 1.
"""
struct Hexes
    positions::Matrix{Float64}
    hexahedra::Matrix{Int}
    quads::Matrix{Int}
    quad_patches::Vector{Int}
    regions::Vector{Int}
    missing::Vector{NamedTuple}
    report::Any
end

function missing_features(handle)
    map(0:Int(Raw.obc_hexmesh_missing_count(handle))-1) do index
        found = sized(Raw.obc_hexmesh_missing)
        checked(error -> Raw.obc_hexmesh_get_missing(handle, index, found, error))
        (corner=found.corner != 0, first=collect(found.first), last=collect(found.last), captured=found.captured,
         why=unsafe_string(Raw.obc_hexmesh_missing_reason(handle, index)))
    end
end

# Calls f with the options that also have the tags, which count from 1.
function with_tags(f, chosen, tagged_edges, tagged_vertices)
    edges = tagged_edges === nothing ? UInt32[] : UInt32.(vec(tagged_edges) .- 1)
    vertices = tagged_vertices === nothing ? UInt32[] : UInt32.(tagged_vertices .- 1)
    chosen.tagged_edge_count = tagged_edges === nothing ? 0 : columns(tagged_edges, 2, "tagged_edges")
    chosen.tagged_vertex_count = length(vertices)
    GC.@preserve edges vertices begin
        chosen.tagged_edges, chosen.tagged_vertices = pointer(edges), pointer(vertices)
        f()
    end
end

# Of the call f(out), which hands out a handle.
function hexes(f, report)
    out = Ref(C_NULL)
    f(out)
    try
        k = Raw.obc_hexmesh_quad_count(out[])
        places = Matrix{Float64}(undef, 3, Raw.obc_hexmesh_vertex_count(out[]))
        cells = Matrix{UInt32}(undef, 8, Raw.obc_hexmesh_count(out[]))
        quads, faces = Matrix{UInt32}(undef, 4, k), Vector{UInt32}(undef, k)
        checked(error -> Raw.obc_hexmesh_copy(out[], places, cells, quads, faces, error))
        numbers = Vector{Int32}(undef, size(cells, 2))
        checked(error -> Raw.obc_hexmesh_copy_regions(out[], numbers, error))
        Hexes(places, Int.(cells) .+ 1, Int.(quads) .+ 1, Int.(faces) .+ 1, Int.(numbers), missing_features(out[]), report)
    finally
        Raw.obc_hexmesh_destroy(out[])
    end
end

"""
    fill_with_hexahedra(surface; options...)

Fills a closed surface: a `Hexes`. Options: method (`:auto`, `:polycube`, `:grid`, `:frames`), cells, padding (`:auto`, `:with`, `:without`), corners,
triangles, seed, rounds, max_hausdorff_percent, max_cells, feature_angle, features (`:off`, `:auto`, `:tags`, `:angles`) with `tagged_edges` (2 by n) and
`tagged_vertices`.
"""
function fill_with_hexahedra(surface::Surface; threads=0, progress=nothing, tagged_edges=nothing, tagged_vertices=nothing, options...)
    chosen = filled(Raw.obc_hexmesh_options, Raw.obc_hexmesh_options_init, values(options), "OBC_HEXMESH_")
    report = sized(Raw.obc_hexmesh_report)
    hexes(report) do out
        with_tags(chosen, tagged_edges, tagged_vertices) do
            with_surface(surface; threads=threads, progress=progress) do view, lent, error
                Raw.obc_hexmesh_compute(view, chosen, lent, report, out, error)
            end
        end
    end
end

"""
    fill_with_hexahedra(positions, tetrahedra, frames=nothing; options...)

Fills a solid of tetrahedra: a `Hexes`. The hexahedra follow the frames (quaternions w x y z, 4 by m, as of `frame_field`), if there are any;
with the method `:frames` and without frames a smooth field is made, and repaired. Options as for a surface, and `regions`, a number for each
tetrahedron: faces of hexahedra follow where they meet.
"""
function fill_with_hexahedra(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}, frames=nothing; threads=0, progress=nothing,
                             tagged_edges=nothing, tagged_vertices=nothing, regions=nothing, options...)
    chosen = filled(Raw.obc_hexmesh_options, Raw.obc_hexmesh_options_init, values(options), "OBC_HEXMESH_")
    report = sized(Raw.obc_hexmesh_report)
    places, n, cells, m = solid_arrays(positions, tetrahedra)
    numbers = regions === nothing ? Int32[] : Vector{Int32}(regions)
    regions === nothing || expect(length(numbers), m, "regions")
    chosen.region_count = length(numbers)
    frames === nothing || expect(columns(frames, 4, "frames"), m, "columns of frames")
    field = frames === nothing ? C_NULL : doubles(frames)
    GC.@preserve numbers hexes(report) do out
        chosen.regions = pointer(numbers)
        with_tags(chosen, tagged_edges, tagged_vertices) do
            hosted(threads=threads, progress=progress) do lent, error
                Raw.obc_hexmesh_compute_solid(places, n, cells, m, field, chosen, lent, report, out, error)
            end
        end
    end
end
