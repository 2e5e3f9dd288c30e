# Surfaces on one triangulation, blends, and maps between surfaces. Numbers of shapes, vertices and triangles count from 1.

"""
    both = Correspondence([a, b]; landmarks=nothing, options...)

Closed surfaces on one triangulation, whose vertex i is at corresponding points of all: `triangles` (3 by m), `positions` (3 by n, on
each surface), `domain` (3 by n, on the common sphere or polycube) and `quads` (4 by q, of a polycube's grid). Options: via (`:sphere`,
`:polycube`), align, grid, placement, tolerance, cells, corners, seed, resolution. `landmarks`: for each surface points (3 by k) that
correspond.
"""
mutable struct Correspondence
    handle::Ptr{Cvoid}
    triangles::Matrix{Int}
    positions::Vector{Matrix{Float64}}
    domain::Matrix{Float64}
    quads::Matrix{Int}
end

# Owns the handle from the first line on.
function Correspondence(handle::Ptr{Cvoid})
    n, m = Int(Raw.obc_correspondence_vertex_count(handle)), Int(Raw.obc_correspondence_triangle_count(handle))
    shapes, q = Int(Raw.obc_correspondence_shape_count(handle)), Int(Raw.obc_correspondence_quad_count(handle))
    both = Correspondence(handle, Matrix{Int}(undef, 3, m), [Matrix{Float64}(undef, 3, n) for _ in 1:shapes],
                          Matrix{Float64}(undef, 3, n), Matrix{Int}(undef, 4, q))
    finalizer(it -> released(Raw.obc_correspondence_destroy, it.handle), both)
    faces, quads = Matrix{UInt32}(undef, 3, m), Matrix{UInt32}(undef, 4, q)
    for (i, at) in enumerate(both.positions)
        checked(error -> Raw.obc_correspondence_copy(handle, i - 1, at, faces, error))
    end
    checked(error -> Raw.obc_correspondence_copy_domain(handle, both.domain, error))
    checked(error -> Raw.obc_correspondence_copy_quads(handle, quads, error))
    both.triangles .= Int.(faces) .+ 1
    both.quads .= Int.(quads) .+ 1
    both
end

function Correspondence(surfaces::AbstractVector{Surface}; landmarks=nothing, threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_correspondence_options, Raw.obc_correspondence_options_init, values(options), "OBC_CORRESPONDENCE_")
    points = Matrix{Float64}(undef, 3, 0)
    if landmarks !== nothing
        expect(length(landmarks), length(surfaces), "landmarks")
        count = columns(first(landmarks), 3, "landmarks")
        foreach(each -> expect(columns(each, 3, "landmarks"), count, "columns of landmarks"), landmarks)
        points = reduce(hcat, doubles.(landmarks))
        chosen.landmark_count = count
    end
    views, out = viewed.(surfaces), Ref(C_NULL)
    GC.@preserve surfaces points begin
        isempty(points) || (chosen.landmarks = pointer(points))
        hosted(; threads=threads, progress=progress) do lent, error
            Raw.obc_correspondence_create(views, length(views), chosen, lent, out, error)
        end
    end
    Correspondence(out[])
end

Base.show(io::IO, both::Correspondence) = print(io, "Correspondence(", length(both.positions), " shapes, ", size(both.domain, 2), " vertices)")

"The sum of the positions on all surfaces times weights, one each."
function blend(both::Correspondence, weights::AbstractVector{<:Real})
    expect(length(weights), length(both.positions), "weights")
    result = similar(both.domain)
    given = Vector{Float64}(weights)
    GC.@preserve both checked(error -> Raw.obc_correspondence_blend(both.handle, given, length(given), result, error))
    result
end

shape_index(both::Correspondence, shape, name) =
    shape in 1:length(both.positions) ? shape - 1 : throw(ArgumentError("$name = $shape: 1 to $(length(both.positions)) is needed"))

"""
    triangles, weights = map_points(both, from, to[, triangles, weights])

Where points of one surface are on another: triangles, and weights at the three corners of each (3 by n). Without points those of all
vertices; a vertex in no triangle gets 0 and weights of 0.
"""
function map_points(both::Correspondence, from::Integer, to::Integer, triangles::AbstractVector{<:Integer}, weights::AbstractMatrix; host...)
    i, j = shape_index(both, from, "from"), shape_index(both, to, "to")
    n = length(triangles)
    expect(columns(weights, 3, "weights"), n, "columns of weights")
    all(t -> 1 <= t <= typemax(UInt32), triangles) || throw(ArgumentError("triangles: numbers from 1 on are needed"))
    of, at = UInt32.(triangles .- 1), Matrix{Float64}(doubles(weights))
    found, there = Vector{UInt32}(undef, n), Matrix{Float64}(undef, 3, n)
    GC.@preserve both hosted((lent, error) -> Raw.obc_correspondence_map(both.handle, i, j, of, at, n, lent, found, there, error); host...)
    Int.(found) .+ 1, there
end

function map_points(both::Correspondence, from::Integer, to::Integer; host...)
    i, j = shape_index(both, from, "from"), shape_index(both, to, "to")
    n = Int(Raw.obc_correspondence_surface_vertex_count(both.handle, i))
    found, there = Vector{UInt32}(undef, n), Matrix{Float64}(undef, 3, n)
    GC.@preserve both hosted((lent, error) -> Raw.obc_correspondence_map_vertices(both.handle, i, j, lent, found, there, error); host...)
    Int.(found .+ UInt32(1)), there # UINT32_MAX becomes 0
end
