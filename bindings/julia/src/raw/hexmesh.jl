# What <orbicube/hexmesh.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_HEXMESH_PADDING_AUTO = Int32(0)
const OBC_HEXMESH_PADDING_WITH = Int32(1)
const OBC_HEXMESH_PADDING_WITHOUT = Int32(2)

const OBC_HEXMESH_METHOD_AUTO = Int32(0)
const OBC_HEXMESH_METHOD_POLYCUBE = Int32(1)
const OBC_HEXMESH_METHOD_GRID = Int32(2)
const OBC_HEXMESH_METHOD_FRAMES = Int32(3)

const OBC_HEXMESH_FEATURES_OFF = Int32(0)
const OBC_HEXMESH_FEATURES_AUTO = Int32(1)
const OBC_HEXMESH_FEATURES_TAGS = Int32(2)
const OBC_HEXMESH_FEATURES_ANGLES = Int32(3)
const OBC_HEXMESH_FEATURES_MACHINED = Int32(4)

mutable struct obc_hexmesh_options <: CStruct
    struct_size::UInt32
    padding::Int32
    cells::Csize_t
    corners::Csize_t
    triangles::Csize_t
    seed::UInt64
    rounds::Int32
    method::Int32
    max_hausdorff_percent::Float64
    max_cells::Csize_t
    feature_angle::Float64
    features::Int32
    tagged_edges::Ptr{UInt32}
    tagged_edge_count::Csize_t
    tagged_vertices::Ptr{UInt32}
    tagged_vertex_count::Csize_t
    fill::Ptr{Cvoid}
    fill_user::Ptr{Cvoid}
    regions::Ptr{Int32}
    region_count::Csize_t
    obc_hexmesh_options() = zeroed!(new())
end

mutable struct obc_hexmesh_report <: CStruct
    struct_size::UInt32
    padded::Int32
    min_scaled_jacobian::Float64
    mean_scaled_jacobian::Float64
    volume::Float64
    polycube_corners::Csize_t
    off_surface::Csize_t
    hausdorff_percent::Float64
    volume_error_percent::Float64
    follows_sharp_edges::Int32
    grid_based::Int32
    method::Int32
    integers_optimal::Int32
    singular_edges::Csize_t
    irregular_edges::Csize_t
    integers::Csize_t
    tetrahedra::Csize_t
    inverted_at_start::Csize_t
    steps::Csize_t
    fields::Csize_t
    feature_curves::Csize_t
    feature_corners::Csize_t
    missing_features::Csize_t
    captured::Float64
    scaled_jacobian_bound::Float64
    embedded::Int32
    conforming::Int32
    region_quads::Csize_t
    region_hausdorff_percent::Float64
    obc_hexmesh_report() = zeroed!(new())
end

mutable struct obc_hexmesh_missing <: CStruct
    struct_size::UInt32
    corner::Int32
    first::NTuple{3, Float64}
    last::NTuple{3, Float64}
    captured::Float64
    obc_hexmesh_missing() = zeroed!(new())
end

const address_obc_hexmesh_options_init = Ref(C_NULL)
obc_hexmesh_options_init(options, struct_size) =
    ccall(symbol(address_obc_hexmesh_options_init, :hexmesh, :obc_hexmesh_options_init), Int32, (Ptr{obc_hexmesh_options}, Csize_t), options, struct_size)

const address_obc_hexmesh_compute = Ref(C_NULL)
obc_hexmesh_compute(surface, options, host, report, out, error) =
    ccall(symbol(address_obc_hexmesh_compute, :hexmesh, :obc_hexmesh_compute), Int32, (Ptr{obc_surface}, Ptr{obc_hexmesh_options}, Ptr{obc_host}, Ptr{obc_hexmesh_report}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, options, host, report, out, error)

const address_obc_hexmesh_compute_solid = Ref(C_NULL)
obc_hexmesh_compute_solid(positions, vertex_count, tetrahedra, tetrahedron_count, frames, options, host, report, out, error) =
    ccall(symbol(address_obc_hexmesh_compute_solid, :hexmesh, :obc_hexmesh_compute_solid), Int32, (Ptr{Float64}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{Float64}, Ptr{obc_hexmesh_options}, Ptr{obc_host}, Ptr{obc_hexmesh_report}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), positions, vertex_count, tetrahedra, tetrahedron_count, frames, options, host, report, out, error)

const address_obc_hexmesh_destroy = Ref(C_NULL)
obc_hexmesh_destroy(hexes) =
    ccall(symbol(address_obc_hexmesh_destroy, :hexmesh, :obc_hexmesh_destroy), Cvoid, (Ptr{Cvoid},), hexes)

const address_obc_hexmesh_vertex_count = Ref(C_NULL)
obc_hexmesh_vertex_count(hexes) =
    ccall(symbol(address_obc_hexmesh_vertex_count, :hexmesh, :obc_hexmesh_vertex_count), Csize_t, (Ptr{Cvoid},), hexes)

const address_obc_hexmesh_count = Ref(C_NULL)
obc_hexmesh_count(hexes) =
    ccall(symbol(address_obc_hexmesh_count, :hexmesh, :obc_hexmesh_count), Csize_t, (Ptr{Cvoid},), hexes)

const address_obc_hexmesh_quad_count = Ref(C_NULL)
obc_hexmesh_quad_count(hexes) =
    ccall(symbol(address_obc_hexmesh_quad_count, :hexmesh, :obc_hexmesh_quad_count), Csize_t, (Ptr{Cvoid},), hexes)

const address_obc_hexmesh_copy = Ref(C_NULL)
obc_hexmesh_copy(hexes, positions, hexahedra, quads, quad_patches, error) =
    ccall(symbol(address_obc_hexmesh_copy, :hexmesh, :obc_hexmesh_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), hexes, positions, hexahedra, quads, quad_patches, error)

const address_obc_hexmesh_copy_regions = Ref(C_NULL)
obc_hexmesh_copy_regions(hexes, regions, error) =
    ccall(symbol(address_obc_hexmesh_copy_regions, :hexmesh, :obc_hexmesh_copy_regions), Int32, (Ptr{Cvoid}, Ptr{Int32}, Ptr{obc_error}), hexes, regions, error)

const address_obc_hexmesh_missing_count = Ref(C_NULL)
obc_hexmesh_missing_count(hexes) =
    ccall(symbol(address_obc_hexmesh_missing_count, :hexmesh, :obc_hexmesh_missing_count), Csize_t, (Ptr{Cvoid},), hexes)

const address_obc_hexmesh_get_missing = Ref(C_NULL)
obc_hexmesh_get_missing(hexes, index, missing, error) =
    ccall(symbol(address_obc_hexmesh_get_missing, :hexmesh, :obc_hexmesh_get_missing), Int32, (Ptr{Cvoid}, Csize_t, Ptr{obc_hexmesh_missing}, Ptr{obc_error}), hexes, index, missing, error)

const address_obc_hexmesh_missing_reason = Ref(C_NULL)
obc_hexmesh_missing_reason(hexes, index) =
    ccall(symbol(address_obc_hexmesh_missing_reason, :hexmesh, :obc_hexmesh_missing_reason), Cstring, (Ptr{Cvoid}, Csize_t), hexes, index)

const address_obc_hexmesh_version = Ref(C_NULL)
obc_hexmesh_version() =
    ccall(symbol(address_obc_hexmesh_version, :hexmesh, :obc_hexmesh_version), UInt32, ())
