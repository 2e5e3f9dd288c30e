# Figures and singular curves of frame fields; quaternions and the rotations of the cube.

# f(solid, host, error) with a pointer to the obc_frame_field_solid, and the frames.
function with_field(f, positions, tetrahedra, frames; host...)
    places, n, cells, m = solid_arrays(positions, tetrahedra)
    expect(columns(frames, 4, "frames"), m, "columns of frames")
    solid, field = Ref(Raw.obc_frame_field_solid(pointer(places), n, pointer(cells), m)), doubles(frames)
    GC.@preserve places cells solid hosted((lent, error) -> f(struct_pointer(solid), field, lent, error); host...)
end

"Figures of any field: an obc_frame_field_report."
function measure_frames(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}, frames::AbstractMatrix; host...)
    report = filled(Raw.obc_frame_field_report, Raw.obc_frame_field_report_init, NamedTuple())
    with_field((solid, field, lent, error) -> Raw.obc_frame_field_measure(solid, field, lent, report, error), positions, tetrahedra,
               frames; host...)
    report
end

"For each tetrahedron and corner (4 by m), the rotation of the cube, from 0 as in `Quaternions`, across the face opposite."
function frame_matchings(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}, frames::AbstractMatrix; host...)
    found = Matrix{UInt8}(undef, 4, size(tetrahedra, 2))
    with_field((solid, field, lent, error) -> Raw.obc_frame_field_matchings(solid, field, lent, found, error), positions, tetrahedra,
               frames; host...)
    found
end

"""
Singular edges of a field and the curves that they form: `edges` (2 by k), `rotations`, `turns`, `curves` (numbers of edges in order), `nodes`,
and where no hexahedral mesh has such a field: `unmeshable_edges`, `unmeshable_vertices`. All count from 1.
"""
function singularities(positions::AbstractMatrix, tetrahedra::AbstractMatrix{<:Integer}, frames::AbstractMatrix; host...)
    out = Ref(C_NULL)
    with_field((solid, field, lent, error) -> Raw.obc_frame_field_singularities_create(solid, field, lent, out, error), positions,
               tetrahedra, frames; host...)
    try
        k = Raw.obc_frame_field_singular_edge_count(out[])
        edges, rotations, turns = Matrix{UInt32}(undef, 2, k), Vector{UInt8}(undef, k), Vector{Int8}(undef, k)
        starts, along = zeros(Csize_t, Raw.obc_frame_field_singular_curve_count(out[]) + 1), Vector{UInt32}(undef, k)
        nodes = Vector{UInt32}(undef, Raw.obc_frame_field_singular_node_count(out[]))
        checked(error -> Raw.obc_frame_field_singularities_copy(out[], edges, rotations, turns, starts, along, nodes, error))
        bad_edges = Vector{UInt32}(undef, Raw.obc_frame_field_unmeshable_edge_count(out[]))
        bad_vertices = Vector{UInt32}(undef, Raw.obc_frame_field_unmeshable_vertex_count(out[]))
        checked(error -> Raw.obc_frame_field_unmeshable_copy(out[], bad_edges, bad_vertices, error))
        (edges=Int.(edges) .+ 1, rotations=rotations, turns=turns,
         curves=[Int.(along[starts[i]+1:starts[i+1]]) .+ 1 for i in 1:length(starts)-1], nodes=Int.(nodes) .+ 1,
         unmeshable_edges=Int.(bad_edges) .+ 1, unmeshable_vertices=Int.(bad_vertices) .+ 1)
    finally
        Raw.obc_frame_field_singularities_destroy(out[])
    end
end

"""
Unit quaternions w x y z: vectors of four numbers, or matrices with a column each; of two arguments one may be a single one. The rotations of
the cube have the numbers 0 to 23.
"""
module Quaternions

using ..Orbicube: Raw, checked, expect, columns

# Each column of the arguments, which have the given number of rows; single ones repeatedly.
function each(f, rows, given, arrays...)
    counts = [columns(array, height, "an argument") for (array, height) in zip(arrays, given)]
    n = maximum(counts)
    all(count -> count in (1, n), counts) || throw(DimensionMismatch("columns: $(join(counts, " and "))"))
    wide = [convert(Matrix{Float64}, reshape(array, height, :)) for (array, height) in zip(arrays, given)]
    out = Matrix{Float64}(undef, rows, n)
    for i in 1:n
        GC.@preserve wide out f((pointer(array, size(array, 1) * (size(array, 2) == 1 ? 0 : i - 1) + 1) for array in wide)...,
                                pointer(out, rows * (i - 1) + 1), i)
    end
    all(array -> ndims(array) == 1, arrays) ? vec(out) : out
end

"p q, Hamilton's product: turns by q first."
multiply(p, q) = each((p, q, out, _) -> Raw.obc_quaternion_multiply(p, q, out), 4, (4, 4), p, q)
inverse(q) = each((q, out, _) -> Raw.obc_quaternion_inverse(q, out), 4, (4,), q)
"Of length 1."
normalize(q) = each((q, out, _) -> Raw.obc_quaternion_normalize(q, out), 4, (4,), q)
exponential(q) = each((q, out, _) -> Raw.obc_quaternion_exponential(q, out), 4, (4,), q)
logarithm(q) = each((q, out, _) -> Raw.obc_quaternion_logarithm(q, out), 4, (4,), q)
"Along the shorter arc, p at t = 0 and q at t = 1."
slerp(p, q, t::Real) = each((p, q, out, _) -> Raw.obc_quaternion_slerp(p, q, t, out), 4, (4, 4), p, q)
"q v q^-1."
rotate(q, v) = each((q, v, out, _) -> Raw.obc_quaternion_rotate(q, v, out), 3, (4, 3), q, v)
from_rotation_vector(v) = each((v, out, _) -> Raw.obc_quaternion_from_rotation_vector(v, out), 4, (3,), v)
to_rotation_vector(q) = each((q, out, _) -> Raw.obc_quaternion_to_rotation_vector(q, out), 3, (4,), q)
from_axis_angle(axis::AbstractVector, angle::Real) =
    each((axis, out, _) -> checked(error -> Raw.obc_quaternion_from_axis_angle(axis, angle, out, error)), 4, (3,), axis)

"Axis and angle of one quaternion."
function to_axis_angle(q::AbstractVector)
    expect(length(q), 4, "q")
    axis, angle = Vector{Float64}(undef, 3), Ref(0.0)
    Raw.obc_quaternion_to_axis_angle(convert(Vector{Float64}, q), axis, angle)
    axis, angle[]
end

function matrix(q::AbstractVector)
    rows = each((q, out, _) -> Raw.obc_quaternion_to_matrix(q, out), 9, (4,), q)
    permutedims(reshape(rows, 3, 3))
end

function of_matrix(f, matrix)
    size(matrix) == (3, 3) || throw(DimensionMismatch("a matrix of 3 by 3 is needed, not $(size(matrix))"))
    each((rows, out, _) -> checked(error -> f(rows, out, error)), 4, (9,), vec(permutedims(matrix)))
end
"Of a rotation matrix; an OrbicubeError for what is none."
from_matrix(matrix::AbstractMatrix) = of_matrix(Raw.obc_quaternion_from_matrix, matrix)
"The rotation nearest to any matrix."
nearest_to_matrix(matrix::AbstractMatrix) = of_matrix(Raw.obc_quaternion_nearest_to_matrix, matrix)

"The mean rotation of columns, and how much they agree (1: all)."
function average(q::AbstractMatrix, weights=nothing)
    n, mean, agreement = columns(q, 4, "q"), Vector{Float64}(undef, 4), Ref(0.0)
    weights === nothing || expect(length(weights), n, "weights")
    given, shares = convert(Matrix{Float64}, q), weights === nothing ? C_NULL : convert(Vector{Float64}, weights)
    checked(error -> Raw.obc_quaternion_average(given, shares, n, mean, agreement, error))
    mean, agreement[]
end

numbered(answer) = 0 <= answer < Raw.OBC_QUATERNION_CUBE_ORDER ? Int(answer) : throw(ArgumentError("the cube's rotations have the numbers 0 to 23"))

"The quaternion of one of the 24 rotations of the cube."
cube_element(number::Integer) = (out = Vector{Float64}(undef, 4); checked(error -> Raw.obc_quaternion_cube_element(numbered(number), out, error)); out)
function cube_matrix(number::Integer)
    rows = Matrix{Float64}(undef, 3, 3)
    checked(error -> Raw.obc_quaternion_cube_matrix(numbered(number), rows, error))
    permutedims(rows)
end
"The number of a b, b first."
cube_product(a::Integer, b::Integer) = numbered(Raw.obc_quaternion_cube_product(numbered(a), numbered(b)))
cube_inverse(a::Integer) = numbered(Raw.obc_quaternion_cube_inverse(numbered(a)))
"OBC_QUATERNION_IDENTITY, ... of `Orbicube.Raw`."
cube_class(number::Integer) = Raw.obc_quaternion_cube_class(numbered(number))
"The number of the cube's rotation nearest to each."
cube_nearest(r) = per_column((r, _...) -> Raw.obc_quaternion_cube_nearest(r), Int, r)
"The angle between frames, up to the 24 rotations of the cube."
symmetric_distance(p, q) = per_column(Raw.obc_quaternion_symmetric_distance, Float64, p, q)
"sin^2 of half of it."
symmetric_sine_square(p, q) = per_column(Raw.obc_quaternion_symmetric_sine_square, Float64, p, q)
"The number of the g for which p g is nearest to the frame q."
symmetric_matching(p, q) = per_column(Raw.obc_quaternion_symmetric_matching, Int, p, q)

# A number for each column, or for single ones that number.
function per_column(f, ::Type{T}, arrays...) where {T}
    found = T[]
    each((given...) -> push!(found, f(given[1:length(arrays)]...)), 1, ntuple(_ -> 4, length(arrays)), arrays...)
    all(array -> ndims(array) == 1, arrays) ? found[1] : found
end

end
