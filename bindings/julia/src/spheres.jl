# What maps to the sphere are for: distortion, geometry images, warps, overlays; and functions on the sphere.

"""
    directions, placed, error = partial_sphere_map(surface; options...)

As `sphere_map`, and when that is cancelled or finds no valid result: what there is of the map, how many vertices have places of their own, and
the OrbicubeError (nothing when all went well).
"""
function partial_sphere_map(surface::Surface; threads=0, progress=nothing, options...)
    chosen = filled(Raw.obc_sphere_map_options, Raw.obc_sphere_map_options_init, values(options), "OBC_SPHERE_MAP_")
    directions, placed, failed = zeros(3, vertex_count(surface)), Ref{Csize_t}(0), nothing
    try
        with_surface(surface; threads=threads, progress=progress) do view, lent, error
            Raw.obc_sphere_map_compute_partial(view, chosen, lent, directions, placed, C_NULL, error)
        end
    catch error
        error isa OrbicubeError && error.status in (Raw.OBC_CANCELLED, Raw.OBC_NO_VALID_RESULT) || rethrow()
        failed = error
    end
    directions, Int(placed[]), failed
end

"Quasi-conformal distortion and area ratio of each triangle."
function face_distortion(surface::Surface, directions::AbstractMatrix; host...)
    expect(length(directions), 3 * vertex_count(surface), "directions")
    m, places = size(surface.triangles, 2), doubles(directions)
    quasi_conformal, ratio = Vector{Float64}(undef, m), Vector{Float64}(undef, m)
    with_surface((view, lent, error) -> Raw.obc_sphere_map_face_distortion(view, places, lent, quasi_conformal, ratio, error), surface; host...)
    quasi_conformal, ratio
end

"The map in 32-bit floats, repaired where rounding flips triangles."
function round_to_float(surface::Surface, directions::AbstractMatrix; host...)
    expect(length(directions), 3 * vertex_count(surface), "directions")
    places, rounded = doubles(directions), Matrix{Float32}(undef, 3, vertex_count(surface))
    with_surface((view, lent, error) -> Raw.obc_sphere_map_round_to_float(view, places, lent, rounded, error), surface; host...)
    rounded
end

const grids = [:icosphere => Raw.OBC_SPHERE_MAP_ICOSPHERE, :cube => Raw.OBC_SPHERE_MAP_CUBE,
               :latitude => Raw.OBC_SPHERE_MAP_LATITUDE, :octahedron => Raw.OBC_SPHERE_MAP_OCTAHEDRON]

grid_of(name::Symbol) = chosen_word(:grid, name, grids)

"A regular triangulation of the sphere: :icosphere, :cube, :latitude or :octahedron."
sphere_grid(grid::Symbol, resolution::Integer; host...) =
    taken((out, lent, error) -> Raw.obc_sphere_map_grid(grid_of(grid), resolution, lent, out, error); host...)

"Width and height of a geometry image, :octahedron or :cube."
function image_size(layout::Symbol, resolution::Integer)
    width, height = Ref{Csize_t}(0), Ref{Csize_t}(0)
    checked(error -> Raw.obc_sphere_map_image_size(grid_of(layout), resolution, width, height, error))
    Int(width[]), Int(height[])
end

"A geometry image, 3 by width by height, row by row from the top."
function geometry_image(locator::Locator, positions::AbstractMatrix, layout::Symbol, resolution::Integer; host...)
    expect(length(positions), 3 * locator.vertices, "positions")
    places, pixels = doubles(positions), Array{Float64}(undef, 3, image_size(layout, resolution)...)
    GC.@preserve locator hosted(; host...) do lent, error
        Raw.obc_sphere_map_image(locator.handle, places, grid_of(layout), resolution, lent, pixels, error)
    end
    pixels
end

function expect_image(pixels, layout, resolution)
    wanted = (3, image_size(layout, resolution)...)
    size(pixels) == wanted || throw(DimensionMismatch("pixels: $wanted are needed, not $(size(pixels))"))
    doubles(pixels)
end

"The closed surface of a geometry image, and the largest distance between pixels that are one vertex."
function image_surface(pixels::AbstractArray{<:Real,3}, layout::Symbol, resolution::Integer; host...)
    given, gap = expect_image(pixels, layout, resolution), Ref(0.0)
    surface = taken(; host...) do out, lent, error
        Raw.obc_sphere_map_image_surface(given, grid_of(layout), resolution, lent, out, gap, error)
    end
    surface, gap[]
end

"To .pfm or .png."
function write_image(path, pixels::AbstractArray{<:Real,3}, layout::Symbol, resolution::Integer; host...)
    given = expect_image(pixels, layout, resolution)
    hosted((lent, error) -> Raw.obc_sphere_map_image_write(path, given, grid_of(layout), resolution, lent, error); host...)
end

"Pixels, layout and resolution."
function read_image(path; host...)
    kind, resolution = Ref{Int32}(0), Ref{Csize_t}(0)
    hosted((lent, error) -> Raw.obc_sphere_map_image_read(path, lent, kind, resolution, C_NULL, 0, error); host...)
    layout = kind[] == Raw.OBC_SPHERE_MAP_CUBE ? :cube : :octahedron
    pixels = Array{Float64}(undef, 3, image_size(layout, resolution[])...)
    hosted((lent, error) -> Raw.obc_sphere_map_image_read(path, lent, kind, resolution, pixels, length(pixels), error); host...)
    pixels, layout, Int(resolution[])
end

"The rotation (3 by 3) that takes directions nearest to others: `rotation * from` is near to `to`."
function best_rotation(from::AbstractMatrix, to::AbstractMatrix)
    n = columns(from, 3, "from")
    expect(columns(to, 3, "to"), n, "columns of to")
    a, b, rows = doubles(from), doubles(to), Matrix{Float64}(undef, 3, 3)
    checked(error -> Raw.obc_sphere_map_best_rotation(a, b, n, rows, error))
    permutedims(rows)
end

"A smooth bijection of the sphere that carries landmarks onto landmarks: `warp(directions)`, and back with `backward=true`."
mutable struct Warp
    handle::Ptr{Cvoid}
end

function Warp(from::AbstractMatrix, to::AbstractMatrix; host...)
    n, out = columns(from, 3, "from"), Ref(C_NULL)
    expect(columns(to, 3, "to"), n, "columns of to")
    a, b = doubles(from), doubles(to)
    hosted((lent, error) -> Raw.obc_sphere_map_warp_create(a, b, n, lent, out, error); host...)
    finalizer(it -> released(Raw.obc_sphere_map_warp_destroy, it.handle), Warp(out[]))
end

function (warp::Warp)(directions::AbstractArray; backward=false, host...)
    n, asked = columns(directions, 3, "directions"), doubles(directions)
    moved = Matrix{Float64}(undef, 3, n)
    GC.@preserve warp hosted((lent, error) -> Raw.obc_sphere_map_warp_apply(warp.handle, asked, n, backward, lent, moved, error); host...)
    moved
end

"One triangulation of the sphere with the vertices of two maps, and where those of the second are in it (0: in no triangle)."
function overlay(first::Surface, first_directions::AbstractMatrix, second::Surface, second_directions::AbstractMatrix; host...)
    expect(length(first_directions), 3 * vertex_count(first), "first_directions")
    expect(length(second_directions), 3 * vertex_count(second), "second_directions")
    a, b, found = doubles(first_directions), doubles(second_directions), Vector{UInt32}(undef, vertex_count(second))
    one, other = Ref(viewed(first)), Ref(viewed(second))
    sphere = GC.@preserve first second one other taken(; host...) do out, lent, error
        Raw.obc_sphere_map_overlay(struct_pointer(one), a, struct_pointer(other), b, lent, out, found, error)
    end
    sphere, Int.(found .+ UInt32(1)) # UINT32_MAX becomes 0
end

# ---- harmonics

"Y_lm at each direction, (degree + 1)^2 by n, Y_lm in row l * l + l + m + 1."
function evaluate_harmonics(directions::AbstractArray, degree::Integer; host...)
    n, at = columns(directions, 3, "directions"), doubles(directions)
    rows = Matrix{Float64}(undef, (degree + 1)^2, n)
    hosted((lent, error) -> Raw.obc_harmonics_evaluate(at, n, degree, lent, rows, error); host...)
    rows
end

"Gradients of the functions on the unit sphere, 3 by channels by n."
function harmonic_gradients(a::AbstractMatrix, directions::AbstractArray; host...)
    n, at, given = columns(directions, 3, "directions"), doubles(directions), coefficients(a)
    unused, slopes = Matrix{Float64}(undef, size(a, 1), n), Array{Float64}(undef, 3, size(a, 1), n)
    hosted(; host...) do lent, error
        Raw.obc_harmonics_synthesize(given, degree_of(a), size(a, 1), at, n, lent, unused, slopes, error)
    end
    slopes
end

"""
    directions, report = refine_map(surface, directions, weights=nothing; rounds=10, degree=16)

A sphere map moved to where the surface of the degree comes nearest to the vertices. Options are those of `fit_harmonics`.
"""
function refine_map(surface::Surface, directions::AbstractMatrix, weights=nothing; rounds=10, threads=0, progress=nothing, options...)
    n, moved = vertex_count(surface), copy(doubles(directions))
    expect(columns(directions, 3, "directions"), n, "columns of directions")
    weights === nothing || expect(length(weights), n, "weights")
    shares = weights === nothing ? C_NULL : doubles(weights)
    chosen = filled(Raw.obc_harmonics_fit_options, Raw.obc_harmonics_fit_options_init, values(options), "OBC_HARMONICS_")
    report = filled(Raw.obc_harmonics_refinement_report, Raw.obc_harmonics_refinement_report_init, NamedTuple())
    hosted(; threads=threads, progress=progress) do lent, error
        Raw.obc_harmonics_refine_map(surface.positions, n, surface.triangles, size(surface.triangles, 2), shares, chosen, rounds, lent,
                                     moved, report, error)
    end
    moved, report
end

"The norm of each degree from 0, which rotations do not change."
function degree_norms(a::AbstractMatrix)
    given, norms = coefficients(a), Vector{Float64}(undef, degree_of(a) + 1)
    checked(error -> Raw.obc_harmonics_degree_norms(given, degree_of(a), size(a, 1), norms, error))
    norms
end

"The distance D_n between shapes, by the norms of their degrees from first to last."
function shape_distance(f::AbstractMatrix, g::AbstractMatrix; first=0, last=max(degree_of(f), degree_of(g)))
    expect(size(g, 1), size(f, 1), "channels")
    a, b, distance = coefficients(f), coefficients(g), Ref(0.0)
    checked(error -> Raw.obc_harmonics_shape_distance(a, degree_of(f), b, degree_of(g), size(f, 1), first, last, distance, error))
    distance[]
end

"A copy of which the degrees from low to high stay, with a transition over the given number of degrees."
function filter_harmonics(a::AbstractMatrix, low::Integer, high::Integer; width=0, keep_mean=false)
    kept = copy(coefficients(a))
    checked(error -> Raw.obc_harmonics_filter(kept, degree_of(a), size(a, 1), low, high, width, keep_mean, error))
    kept
end

"The functions turned with the sphere by a matrix."
function rotate_harmonics(a::AbstractMatrix, rotation::AbstractMatrix; host...)
    size(rotation) == (3, 3) || throw(DimensionMismatch("rotation: 3 by 3 is needed, not $(size(rotation))"))
    given, rows, turned = coefficients(a), doubles(permutedims(rotation)), Matrix{Float64}(undef, size(a))
    hosted((lent, error) -> Raw.obc_harmonics_rotate(given, degree_of(a), size(a, 1), rows, lent, turned, error); host...)
    turned
end

"""
    (rotation, values, correlation) = align_harmonics(fixed, moving; options...)

The rotation that brings `moving` best into line with `fixed`, and that of its values, matrices of 3 by 3. Options: turn_values, search_degree.
"""
function align_harmonics(fixed::AbstractMatrix, moving::AbstractMatrix; threads=0, progress=nothing, options...)
    expect(size(moving, 1), size(fixed, 1), "channels")
    chosen = filled(Raw.obc_harmonics_align_options, Raw.obc_harmonics_align_options_init, values(options))
    found = filled(Raw.obc_harmonics_alignment, Raw.obc_harmonics_alignment_init, NamedTuple())
    a, b = coefficients(fixed), coefficients(moving)
    hosted(threads=threads, progress=progress) do lent, error
        Raw.obc_harmonics_align(a, degree_of(fixed), b, degree_of(moving), size(fixed, 1), chosen, lent, found, error)
    end
    square(rows) = permutedims(reshape(collect(rows), 3, 3))
    (rotation=square(found.rotation), values=square(found.values), correlation=found.correlation)
end

harmonics_format(name::Symbol) = name in (:by_ending, :shtools, :spharm_pdm) ? getfield(Raw, Symbol("OBC_HARMONICS_", uppercase(string(name)))) :
                                 throw(ArgumentError("format :$name: :by_ending, :shtools or :spharm_pdm"))

"To a file of SHTOOLS (.sh .shtools .txt) or SPHARM-PDM (.coef)."
function write_harmonics(path, a::AbstractMatrix; format=:by_ending)
    given = coefficients(a)
    checked(error -> Raw.obc_harmonics_write(path, harmonics_format(format), given, degree_of(a), size(a, 1), error))
end

"Coefficients (channels by (degree + 1)^2) from such a file."
function read_harmonics(path; format=:by_ending, host...)
    out = Ref(C_NULL)
    hosted((lent, error) -> Raw.obc_harmonics_read(path, harmonics_format(format), lent, out, error); host...)
    try
        degree = Int(Raw.obc_harmonics_coefficients_degree(out[]))
        a = Matrix{Float64}(undef, Raw.obc_harmonics_coefficients_channels(out[]), (degree + 1)^2)
        checked(error -> Raw.obc_harmonics_coefficients_copy(out[], a, error))
        a
    finally
        Raw.obc_harmonics_coefficients_destroy(out[])
    end
end
