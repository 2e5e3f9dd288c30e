# What <orbicube/repair.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_REPAIR_WELDED_VERTEX = Int32(0)
const OBC_REPAIR_REMOVED_DEGENERATE = Int32(1)
const OBC_REPAIR_REMOVED_DUPLICATE = Int32(2)
const OBC_REPAIR_COLLAPSED_EDGE = Int32(3)
const OBC_REPAIR_FLIPPED_EDGE = Int32(4)
const OBC_REPAIR_LEFT_NEAR_DEGENERATE = Int32(5)
const OBC_REPAIR_SPLIT_EDGE = Int32(6)
const OBC_REPAIR_SPLIT_CONTACT_EDGE = Int32(7)
const OBC_REPAIR_SPLIT_CONTACT_VERTEX = Int32(8)
const OBC_REPAIR_DROPPED_PART = Int32(9)
const OBC_REPAIR_FILLED_HOLE = Int32(10)
const OBC_REPAIR_LEFT_HOLE = Int32(11)
const OBC_REPAIR_CUT_HANDLE = Int32(12)

mutable struct obc_repair_options <: CStruct
    struct_size::UInt32
    weld::Int32
    clean::Int32
    slivers::Int32
    t_junctions::Int32
    orient::Int32
    contacts::Int32
    drop_parts::Int32
    cavities::Int32
    fill_holes::Int32
    fair::Int32
    find_intersections::Int32
    max_genus::Int32
    weld_distance::Float64
    sliver_ratio::Float64
    sliver_move::Float64
    t_junction_distance::Float64
    contact_gap::Float64
    min_area_percent::Float64
    keep_parts::Csize_t
    max_hole_edges::Csize_t
    max_handle_length::Float64
    wrap_offset::Float64
    obc_repair_options() = zeroed!(new())
end

mutable struct obc_repair_report <: CStruct
    struct_size::UInt32
    changed::Int32
    closed::Int32
    manifold::Int32
    oriented::Int32
    orientable::Int32
    welded_vertices::Csize_t
    weld_lost_triangles::Csize_t
    degenerate_faces::Csize_t
    duplicate_faces::Csize_t
    unused_vertices::Csize_t
    near_degenerate::Csize_t
    collapsed_edges::Csize_t
    flipped_edges::Csize_t
    left_near_degenerate::Csize_t
    t_junctions::Csize_t
    reversed_triangles::Csize_t
    contact_edges::Csize_t
    contact_vertices::Csize_t
    contact_added_vertices::Csize_t
    found_parts::Csize_t
    kept_parts::Csize_t
    cavity_parts::Csize_t
    dropped_triangles::Csize_t
    found_holes::Csize_t
    filled_holes::Csize_t
    patch_triangles::Csize_t
    patch_vertices::Csize_t
    cut_handles::Csize_t
    weld_move::Float64
    sliver_move::Float64
    t_junction_move::Float64
    handle_move::Float64
    longest_handle::Float64
    dropped_area_percent::Float64
    distance_from_input::Float64
    distance_from_result::Float64
    distance_of_patches::Float64
    parts::Csize_t
    genus::Int64
    boundary_loops::Csize_t
    self_intersections::Csize_t
    area::Float64
    volume::Float64
    obc_repair_report() = zeroed!(new())
end

mutable struct obc_repair_label_options <: CStruct
    struct_size::UInt32
    label::Int32
    cavities::Int32
    handles::Int32
    keep_parts::Csize_t
    smoothing::Float64
    max_slide::Float64
    obc_repair_label_options() = zeroed!(new())
end

mutable struct obc_repair_label_report <: CStruct
    struct_size::UInt32
    label::Int32
    voxels::Csize_t
    border_voxels::Csize_t
    found_parts::Csize_t
    kept_parts::Csize_t
    dropped_voxels::Csize_t
    cavities::Csize_t
    filled_voxels::Csize_t
    handles::Csize_t
    added_voxels::Csize_t
    removed_voxels::Csize_t
    centered_vertices::Csize_t
    largest_slide::Float64
    obc_repair_label_report() = zeroed!(new())
end

const address_obc_repair_options_init = Ref(C_NULL)
obc_repair_options_init(options, struct_size) =
    ccall(symbol(address_obc_repair_options_init, :repair, :obc_repair_options_init), Int32, (Ptr{obc_repair_options}, Csize_t), options, struct_size)

const address_obc_repair_report_init = Ref(C_NULL)
obc_repair_report_init(report, struct_size) =
    ccall(symbol(address_obc_repair_report_init, :repair, :obc_repair_report_init), Int32, (Ptr{obc_repair_report}, Csize_t), report, struct_size)

const address_obc_repair_compute = Ref(C_NULL)
obc_repair_compute(surface, options, host, out, error) =
    ccall(symbol(address_obc_repair_compute, :repair, :obc_repair_compute), Int32, (Ptr{obc_surface}, Ptr{obc_repair_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, options, host, out, error)

const address_obc_repair_destroy = Ref(C_NULL)
obc_repair_destroy(repaired) =
    ccall(symbol(address_obc_repair_destroy, :repair, :obc_repair_destroy), Cvoid, (Ptr{Cvoid},), repaired)

const address_obc_repair_vertex_count = Ref(C_NULL)
obc_repair_vertex_count(repaired) =
    ccall(symbol(address_obc_repair_vertex_count, :repair, :obc_repair_vertex_count), Csize_t, (Ptr{Cvoid},), repaired)

const address_obc_repair_triangle_count = Ref(C_NULL)
obc_repair_triangle_count(repaired) =
    ccall(symbol(address_obc_repair_triangle_count, :repair, :obc_repair_triangle_count), Csize_t, (Ptr{Cvoid},), repaired)

const address_obc_repair_event_count = Ref(C_NULL)
obc_repair_event_count(repaired) =
    ccall(symbol(address_obc_repair_event_count, :repair, :obc_repair_event_count), Csize_t, (Ptr{Cvoid},), repaired)

const address_obc_repair_copy = Ref(C_NULL)
obc_repair_copy(repaired, positions, triangles, vertex_source, triangle_source, error) =
    ccall(symbol(address_obc_repair_copy, :repair, :obc_repair_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), repaired, positions, triangles, vertex_source, triangle_source, error)

const address_obc_repair_copy_events = Ref(C_NULL)
obc_repair_copy_events(repaired, actions, counts, places, sizes, error) =
    ccall(symbol(address_obc_repair_copy_events, :repair, :obc_repair_copy_events), Int32, (Ptr{Cvoid}, Ptr{Int32}, Ptr{UInt32}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), repaired, actions, counts, places, sizes, error)

const address_obc_repair_get_report = Ref(C_NULL)
obc_repair_get_report(repaired, report, error) =
    ccall(symbol(address_obc_repair_get_report, :repair, :obc_repair_get_report), Int32, (Ptr{Cvoid}, Ptr{obc_repair_report}, Ptr{obc_error}), repaired, report, error)

const address_obc_repair_action_name = Ref(C_NULL)
obc_repair_action_name(action) =
    ccall(symbol(address_obc_repair_action_name, :repair, :obc_repair_action_name), Cstring, (Int32,), action)

const address_obc_repair_label_options_init = Ref(C_NULL)
obc_repair_label_options_init(options, struct_size) =
    ccall(symbol(address_obc_repair_label_options_init, :repair, :obc_repair_label_options_init), Int32, (Ptr{obc_repair_label_options}, Csize_t), options, struct_size)

const address_obc_repair_label_report_init = Ref(C_NULL)
obc_repair_label_report_init(report, struct_size) =
    ccall(symbol(address_obc_repair_label_report_init, :repair, :obc_repair_label_report_init), Int32, (Ptr{obc_repair_label_report}, Csize_t), report, struct_size)

const address_obc_repair_surface_of_label = Ref(C_NULL)
obc_repair_surface_of_label(labels, size, to_world, options, host, out, error) =
    ccall(symbol(address_obc_repair_surface_of_label, :repair, :obc_repair_surface_of_label), Int32, (Ptr{Int32}, Ptr{Csize_t}, Ptr{Float64}, Ptr{obc_repair_label_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), labels, size, to_world, options, host, out, error)

const address_obc_repair_get_label_report = Ref(C_NULL)
obc_repair_get_label_report(repaired, report, error) =
    ccall(symbol(address_obc_repair_get_label_report, :repair, :obc_repair_get_label_report), Int32, (Ptr{Cvoid}, Ptr{obc_repair_label_report}, Ptr{obc_error}), repaired, report, error)

const address_obc_repair_version = Ref(C_NULL)
obc_repair_version() =
    ccall(symbol(address_obc_repair_version, :repair, :obc_repair_version), UInt32, ())
