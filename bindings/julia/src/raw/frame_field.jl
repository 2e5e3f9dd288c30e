# What <orbicube/frame_field.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_FRAME_FIELD_AUTO = Int32(0)
const OBC_FRAME_FIELD_IDENTITY = Int32(1)
const OBC_FRAME_FIELD_PROPAGATED = Int32(2)
const OBC_FRAME_FIELD_HARMONIC = Int32(3)
const OBC_FRAME_FIELD_DIFFUSION = Int32(4)
const OBC_FRAME_FIELD_GIVEN = Int32(5)

const OBC_FRAME_FIELD_SMOOTH = Int32(0)
const OBC_FRAME_FIELD_DISSERTATION = Int32(1)

const OBC_FRAME_FIELD_UNIFORM = Int32(0)
const OBC_FRAME_FIELD_GEOMETRIC = Int32(1)

const OBC_FRAME_FIELD_NO_REPAIR = Int32(0)
const OBC_FRAME_FIELD_REPAIR = Int32(1)
const OBC_FRAME_FIELD_SINGLE_AXIS = Int32(2)

struct obc_frame_field_solid
    positions::Ptr{Float64}
    vertex_count::Csize_t
    tetrahedra::Ptr{UInt32}
    tetrahedron_count::Csize_t
end

mutable struct obc_frame_field_options <: CStruct
    struct_size::UInt32
    start::Int32
    method::Int32
    weighting::Int32
    align_boundary::Int32
    rounds::UInt32
    feature_angle::Float64
    relative_gain::Float64
    repair::Int32
    reserved::Int32
    obc_frame_field_options() = zeroed!(new())
end

mutable struct obc_frame_field_constraints <: CStruct
    struct_size::UInt32
    reserved::Int32
    frame_tetrahedra::Ptr{UInt32}
    frames::Ptr{Float64}
    frame_count::Csize_t
    axis_tetrahedra::Ptr{UInt32}
    axes::Ptr{Float64}
    axis_count::Csize_t
    frame_weights::Ptr{Float64}
    axis_weights::Ptr{Float64}
    obc_frame_field_constraints() = zeroed!(new())
end

mutable struct obc_frame_field_report <: CStruct
    struct_size::UInt32
    start::Int32
    energy::Float64
    symmetric_mean::Float64
    symmetric_deviation::Float64
    symmetric_median::Float64
    symmetric_p99::Float64
    symmetric_max::Float64
    plain_mean::Float64
    plain_deviation::Float64
    plain_median::Float64
    plain_p99::Float64
    plain_max::Float64
    inner_faces::UInt64
    boundary_faces::UInt64
    above_30::UInt64
    one_face_max::Float64
    several_best_max::Float64
    several_worst_max::Float64
    singular_edges::UInt64
    singular_quarter::UInt64
    singular_half::UInt64
    singular_third::UInt64
    singular_diagonal::UInt64
    curves::UInt64
    closed_curves::UInt64
    nodes::UInt64
    boundary_ends::UInt64
    dead_ends::UInt64
    singular_length::Float64
    edge_length::Float64
    boundary_index_quarters::Int64
    euler_characteristic::Int64
    smoothing_steps::UInt64
    solver_iterations::UInt64
    locally_meshable::UInt64
    improper_edges::UInt64
    turning_points::UInt64
    improper_nodes::UInt64
    fragments::UInt64
    repair_rounds::UInt64
    unmeshable_before::UInt64
    fragments_before::UInt64
    energy_before_repair::Float64
    obc_frame_field_report() = zeroed!(new())
end

const address_obc_frame_field_options_init = Ref(C_NULL)
obc_frame_field_options_init(options, struct_size) =
    ccall(symbol(address_obc_frame_field_options_init, :frame_field, :obc_frame_field_options_init), Int32, (Ptr{obc_frame_field_options}, Csize_t), options, struct_size)

const address_obc_frame_field_constraints_init = Ref(C_NULL)
obc_frame_field_constraints_init(constraints, struct_size) =
    ccall(symbol(address_obc_frame_field_constraints_init, :frame_field, :obc_frame_field_constraints_init), Int32, (Ptr{obc_frame_field_constraints}, Csize_t), constraints, struct_size)

const address_obc_frame_field_report_init = Ref(C_NULL)
obc_frame_field_report_init(report, struct_size) =
    ccall(symbol(address_obc_frame_field_report_init, :frame_field, :obc_frame_field_report_init), Int32, (Ptr{obc_frame_field_report}, Csize_t), report, struct_size)

const address_obc_frame_field_compute = Ref(C_NULL)
obc_frame_field_compute(solid, options, constraints, host, frames, report, error) =
    ccall(symbol(address_obc_frame_field_compute, :frame_field, :obc_frame_field_compute), Int32, (Ptr{obc_frame_field_solid}, Ptr{obc_frame_field_options}, Ptr{obc_frame_field_constraints}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_frame_field_report}, Ptr{obc_error}), solid, options, constraints, host, frames, report, error)

const address_obc_frame_field_measure = Ref(C_NULL)
obc_frame_field_measure(solid, frames, host, report, error) =
    ccall(symbol(address_obc_frame_field_measure, :frame_field, :obc_frame_field_measure), Int32, (Ptr{obc_frame_field_solid}, Ptr{Float64}, Ptr{obc_host}, Ptr{obc_frame_field_report}, Ptr{obc_error}), solid, frames, host, report, error)

const address_obc_frame_field_matchings = Ref(C_NULL)
obc_frame_field_matchings(solid, frames, host, matchings, error) =
    ccall(symbol(address_obc_frame_field_matchings, :frame_field, :obc_frame_field_matchings), Int32, (Ptr{obc_frame_field_solid}, Ptr{Float64}, Ptr{obc_host}, Ptr{UInt8}, Ptr{obc_error}), solid, frames, host, matchings, error)

const address_obc_frame_field_singularities_create = Ref(C_NULL)
obc_frame_field_singularities_create(solid, frames, host, out, error) =
    ccall(symbol(address_obc_frame_field_singularities_create, :frame_field, :obc_frame_field_singularities_create), Int32, (Ptr{obc_frame_field_solid}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), solid, frames, host, out, error)

const address_obc_frame_field_singularities_destroy = Ref(C_NULL)
obc_frame_field_singularities_destroy(singularities) =
    ccall(symbol(address_obc_frame_field_singularities_destroy, :frame_field, :obc_frame_field_singularities_destroy), Cvoid, (Ptr{Cvoid},), singularities)

const address_obc_frame_field_singular_edge_count = Ref(C_NULL)
obc_frame_field_singular_edge_count(singularities) =
    ccall(symbol(address_obc_frame_field_singular_edge_count, :frame_field, :obc_frame_field_singular_edge_count), Csize_t, (Ptr{Cvoid},), singularities)

const address_obc_frame_field_singular_curve_count = Ref(C_NULL)
obc_frame_field_singular_curve_count(singularities) =
    ccall(symbol(address_obc_frame_field_singular_curve_count, :frame_field, :obc_frame_field_singular_curve_count), Csize_t, (Ptr{Cvoid},), singularities)

const address_obc_frame_field_singular_node_count = Ref(C_NULL)
obc_frame_field_singular_node_count(singularities) =
    ccall(symbol(address_obc_frame_field_singular_node_count, :frame_field, :obc_frame_field_singular_node_count), Csize_t, (Ptr{Cvoid},), singularities)

const address_obc_frame_field_singularities_copy = Ref(C_NULL)
obc_frame_field_singularities_copy(singularities, edge_vertices, edge_rotations, edge_turns, curve_begin, curve_edges, nodes, error) =
    ccall(symbol(address_obc_frame_field_singularities_copy, :frame_field, :obc_frame_field_singularities_copy), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{UInt8}, Ptr{Int8}, Ptr{Csize_t}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), singularities, edge_vertices, edge_rotations, edge_turns, curve_begin, curve_edges, nodes, error)

const address_obc_frame_field_unmeshable_edge_count = Ref(C_NULL)
obc_frame_field_unmeshable_edge_count(singularities) =
    ccall(symbol(address_obc_frame_field_unmeshable_edge_count, :frame_field, :obc_frame_field_unmeshable_edge_count), Csize_t, (Ptr{Cvoid},), singularities)

const address_obc_frame_field_unmeshable_vertex_count = Ref(C_NULL)
obc_frame_field_unmeshable_vertex_count(singularities) =
    ccall(symbol(address_obc_frame_field_unmeshable_vertex_count, :frame_field, :obc_frame_field_unmeshable_vertex_count), Csize_t, (Ptr{Cvoid},), singularities)

const address_obc_frame_field_unmeshable_copy = Ref(C_NULL)
obc_frame_field_unmeshable_copy(singularities, edges, vertices, error) =
    ccall(symbol(address_obc_frame_field_unmeshable_copy, :frame_field, :obc_frame_field_unmeshable_copy), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), singularities, edges, vertices, error)

const address_obc_frame_field_version = Ref(C_NULL)
obc_frame_field_version() =
    ccall(symbol(address_obc_frame_field_version, :frame_field, :obc_frame_field_version), UInt32, ())
