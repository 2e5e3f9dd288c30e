# Meshes, maps to the sphere, harmonics, frame fields. Positions are matrices with a column a vertex, cells have a
# column each and count from 1, as Julia does.

"A surface in arrays: positions (3 by n) and triangles (3 by m), counter-clockwise seen from outside, counted from 1."
struct Surface
    positions::Matrix{Float64}
    triangles::Matrix{UInt32} # counted from 0, as C does
    Surface(positions::Matrix{Float64}, triangles::Matrix{UInt32}, ::Val{:from_zero}) = new(positions, triangles)
end

function Surface(positions::AbstractMatrix, triangles::AbstractMatrix{<:Integer})
    columns(positions, 3, "positions")
    columns(triangles, 3, "triangles")
    all(i -> 1 <= i <= size(positions, 2), triangles) ||
        throw(ArgumentError("triangles: numbers of vertices from 1 to $(size(positions, 2)) are needed"))
    Surface(doubles(positions), UInt32.(triangles .- 1), Val(:from_zero))
end

positions(surface::Surface) = surface.positions
triangles(surface::Surface) = Int.(surface.triangles) .+ 1
vertex_count(surface::Surface) = size(surface.positions, 2)
viewed(surface::Surface) = Raw.obc_surface(pointer(surface.positions), size(surface.positions, 2), pointer(surface.triangles),
                                           size(surface.triangles, 2))
struct_pointer(it) = Base.unsafe_convert(Ptr{eltype(it)}, it)

# f(view, host, error) with a pointer to the obc_surface.
function with_surface(f, surface::Surface; host...)
    view = Ref(viewed(surface))
    GC.@preserve surface view hosted((lent, error) -> f(struct_pointer(view), lent, error); host...)
end

# What a function hands out as an obc_mesh, copied; the handle is released.
function taken(f; host...)
    out = Ref(C_NULL)
    hosted((lent, error) -> f(out, lent, error); host...)
    try
        places = Matrix{Float64}(undef, 3, Raw.obc_mesh_vertex_count(out[]))
        faces = Matrix{UInt32}(undef, 3, Raw.obc_mesh_triangle_count(out[]))
        checked(error -> Raw.obc_mesh_copy(out[], places, faces, C_NULL, C_NULL, error))
        Surface(places, faces, Val(:from_zero))
    finally
        Raw.obc_mesh_destroy(out[])
    end
end

"A closed surface by name, of about the given number of triangles."
make_surface(shape, count=10000; seed=0, host...) =
    taken((out, lent, error) -> Raw.obc_mesh_make(shape, count, seed, lent, out, error); host...)

"Reads a surface in the format of the ending (see `formats`); option weld_identical."
function read_surface(path; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_mesh_read_options, Raw.obc_mesh_read_options_init, values(options))
    taken((out, lent, error) -> Raw.obc_mesh_read(path, chosen, lent, out, error); threads=threads, progress=progress)
end

"Writes a surface in the format of the ending (see `formats`)."
write_surface(path, surface::Surface; host...) =
    with_surface((view, lent, error) -> Raw.obc_mesh_write_surface(path, view, C_NULL, lent, error), surface; host...)

"What kind of surface it is: an obc_mesh_topology_report."
function topology(surface::Surface; host...)
    report = filled(Raw.obc_mesh_topology_report, Raw.obc_mesh_topology_report_init, NamedTuple())
    with_surface((view, lent, error) -> Raw.obc_mesh_topology(view, lent, report, error), surface; host...)
    report
end

"""
    directions, report = sphere_map(surface; method=:balanced, angle_weight=0.1, threads=0, progress=nothing)

Unit vectors (3 by n) and the figures of the map. Options are the members of `obc_sphere_map_options`.
"""
function sphere_map(surface::Surface; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_sphere_map_options, Raw.obc_sphere_map_options_init, values(options), "OBC_SPHERE_MAP_")
    report = filled(Raw.obc_sphere_map_report, Raw.obc_sphere_map_report_init, NamedTuple())
    directions = similar(surface.positions)
    with_surface(surface; threads=threads, progress=progress) do view, lent, error
        Raw.obc_sphere_map_compute(view, chosen, lent, directions, report, error)
    end
    directions, report
end

"Figures of any map; a bad one is no error. Options: angle_weight, area_weight."
function measure_map(surface::Surface, directions::AbstractMatrix; threads=0, progress=nothing, options...)
    expect(length(directions), 3 * vertex_count(surface), "directions")
    chosen = filled(Raw.obc_sphere_map_options, Raw.obc_sphere_map_options_init, values(options), "OBC_SPHERE_MAP_")
    report = filled(Raw.obc_sphere_map_report, Raw.obc_sphere_map_report_init, NamedTuple())
    places = doubles(directions)
    with_surface(surface; threads=threads, progress=progress) do view, lent, error
        Raw.obc_sphere_map_measure(view, places, chosen, lent, report, error)
    end
    report
end

"The inverse of a map: `locate(locator, directions)`, `sample(locator, directions, values)`."
mutable struct Locator
    handle::Ptr{Cvoid}
    vertices::Int
end

function Locator(surface::Surface, directions::AbstractMatrix; host...)
    expect(length(directions), 3 * vertex_count(surface), "directions")
    out, places = Ref(C_NULL), doubles(directions)
    with_surface((view, lent, error) -> Raw.obc_sphere_map_locator_create(view, places, lent, out, error), surface; host...)
    finalizer(it -> released(Raw.obc_sphere_map_locator_destroy, it.handle), Locator(out[], vertex_count(surface)))
end

"The triangle (from 1) of each direction, and its weights at the corners."
function locate(locator::Locator, directions::AbstractArray; host...)
    n, asked = columns(directions, 3, "directions"), doubles(directions)
    faces, weights = Vector{UInt32}(undef, n), Matrix{Float64}(undef, 3, n)
    GC.@preserve locator hosted(; host...) do lent, error
        Raw.obc_sphere_map_locate(locator.handle, asked, n, lent, faces, weights, error)
    end
    Int.(faces) .+ 1, weights
end

"Values of the vertices, a column each, interpolated where each direction lies."
function sample(locator::Locator, directions::AbstractArray, values::AbstractMatrix; unit=false, host...)
    expect(size(values, 2), locator.vertices, "columns of values")
    n, asked, given = columns(directions, 3, "directions"), doubles(directions), doubles(values)
    sampled = Matrix{Float64}(undef, size(given, 1), n)
    GC.@preserve locator hosted(; host...) do lent, error
        Raw.obc_sphere_map_sample(locator.handle, asked, n, given, size(given, 1), unit, lent, sampled, error)
    end
    sampled
end

"The surface on a regular triangulation: :icosphere, :cube, :latitude or :octahedron."
function remesh(locator::Locator, positions::AbstractMatrix, grid::Symbol, resolution::Integer; host...)
    expect(length(positions), 3 * locator.vertices, "positions")
    given, kind = doubles(positions), grid_of(grid)
    GC.@preserve locator taken(; host...) do out, lent, error
        Raw.obc_sphere_map_remesh(locator.handle, given, kind, resolution, lent, out, error)
    end
end

"Coefficients (channels by (degree + 1)^2) that fit values (channels by n) at directions best, and a report."
function fit_harmonics(directions::AbstractMatrix, values::AbstractMatrix, weights=nothing; threads=0, progress=nothing, options...)
    n = columns(directions, 3, "directions")
    expect(size(values, 2), n, "columns of values")
    weights === nothing || expect(length(weights), n, "weights")
    chosen = filled(Raw.obc_harmonics_fit_options, Raw.obc_harmonics_fit_options_init, Base.values(options), "OBC_HARMONICS_")
    report = filled(Raw.obc_harmonics_fit_report, Raw.obc_harmonics_fit_report_init, NamedTuple())
    a = Matrix{Float64}(undef, size(values, 1), (Int(chosen.degree) + 1)^2)
    at, given, shares = doubles(directions), doubles(values), weights === nothing ? C_NULL : doubles(weights)
    hosted(threads=threads, progress=progress) do lent, error
        Raw.obc_harmonics_fit(at, shares, given, n, size(given, 1), chosen, lent, a, report, error)
    end
    a, report
end

degree_of(a::AbstractMatrix) = isqrt(size(a, 2)) - 1

# Channels by (degree + 1)^2, as C has them.
function coefficients(a::AbstractMatrix)
    (!isempty(a) && (degree_of(a) + 1)^2 == size(a, 2)) || throw(DimensionMismatch("coefficients: (degree + 1)^2 columns are needed"))
    doubles(a)
end

"The functions at the directions."
function synthesize(a::AbstractMatrix, directions::AbstractMatrix; host...)
    n = columns(directions, 3, "directions")
    given, at, values = coefficients(a), doubles(directions), Matrix{Float64}(undef, size(a, 1), n)
    hosted(; host...) do lent, error
        Raw.obc_harmonics_synthesize(given, degree_of(a), size(a, 1), at, n, lent, values, C_NULL, error)
    end
    values
end

# Positions and tetrahedra as C has them, and how many there are of each.
function solid_arrays(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer})
    n, m = columns(positions, 3, "positions"), columns(tetrahedra, 4, "tetrahedra")
    all(v -> 1 <= v <= n, tetrahedra) || throw(ArgumentError("tetrahedra: numbers of vertices from 1 to $n are needed"))
    doubles(positions), n, UInt32.(tetrahedra .- 1), m
end

"""
    frames, report = frame_field(positions, tetrahedra; options...)

Quaternions w x y z (4 by m) of a smooth frame field on tetrahedra (4 by m, from 1). start_frames: with `start=:given`. held_frames:
`(tetrahedra, frames)` or `(tetrahedra, frames, weights)`; held_axes: the same with a direction each. Options: members of
`obc_frame_field_options`.
"""
function frame_field(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}; start_frames=nothing, held_frames=nothing,
                     held_axes=nothing, threads=0, progress=nothing, options...)
    places, n, cells, m = solid_arrays(positions, tetrahedra)
    chosen = filled(Raw.obc_frame_field_options, Raw.obc_frame_field_options_init, values(options), "OBC_FRAME_FIELD_")
    report = filled(Raw.obc_frame_field_report, Raw.obc_frame_field_report_init, NamedTuple())
    wanted = filled(Raw.obc_frame_field_constraints, Raw.obc_frame_field_constraints_init, NamedTuple())
    frame_cells, frame_values, frame_weights = held_arrays(held_frames, 4, m, "held_frames")
    axis_cells, axis_values, axis_weights = held_arrays(held_axes, 3, m, "held_axes")
    wanted.frame_tetrahedra, wanted.frames, wanted.frame_count = pointer(frame_cells), pointer(frame_values), length(frame_cells)
    wanted.axis_tetrahedra, wanted.axes, wanted.axis_count = pointer(axis_cells), pointer(axis_values), length(axis_cells)
    isempty(frame_weights) || (wanted.frame_weights = pointer(frame_weights))
    isempty(axis_weights) || (wanted.axis_weights = pointer(axis_weights))
    start_frames === nothing || expect(columns(start_frames, 4, "start_frames"), m, "columns of start_frames")
    frames = start_frames === nothing ? zeros(4, m) : Matrix{Float64}(reshape(start_frames, 4, m))
    solid = Ref(Raw.obc_frame_field_solid(pointer(places), n, pointer(cells), m))
    GC.@preserve places cells solid frame_cells frame_values frame_weights axis_cells axis_values axis_weights begin
        hosted(threads=threads, progress=progress) do lent, error
            Raw.obc_frame_field_compute(struct_pointer(solid), chosen, wanted, lent, frames, report, error)
        end
    end
    frames, report
end

# Tetrahedra from 0, what is fixed there, and weights, of which there may be none.
function held_arrays(held, rows, m, what)
    held === nothing && return UInt32[], zeros(rows, 0), Float64[]
    all(t -> 1 <= t <= m, held[1]) || throw(ArgumentError("$what: numbers of tetrahedra from 1 to $m are needed"))
    expect(columns(held[2], rows, what), length(held[1]), what)
    weights = length(held) > 2 ? doubles(held[3]) : Float64[]
    length(held) > 2 && expect(length(weights), length(held[1]), "weights of $what")
    UInt32.(held[1] .- 1), doubles(held[2]), weights
end
