# What <orbicube/correspondence.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_CORRESPONDENCE_SPHERE = Int32(0)
const OBC_CORRESPONDENCE_POLYCUBE = Int32(1)

const OBC_CORRESPONDENCE_ALIGN_SHAPE = Int32(0)
const OBC_CORRESPONDENCE_ALIGN_ROTATION = Int32(1)
const OBC_CORRESPONDENCE_ALIGN_NONE = Int32(2)

const OBC_CORRESPONDENCE_GRID_BOTH = Int32(0)
const OBC_CORRESPONDENCE_GRID_FIRST = Int32(1)
const OBC_CORRESPONDENCE_GRID_ICOSPHERE = Int32(2)
const OBC_CORRESPONDENCE_GRID_CUBE = Int32(3)
const OBC_CORRESPONDENCE_GRID_LATITUDE = Int32(4)
const OBC_CORRESPONDENCE_GRID_OCTAHEDRON = Int32(5)

const OBC_CORRESPONDENCE_KEPT = Int32(0)
const OBC_CORRESPONDENCE_TURNED = Int32(1)
const OBC_CORRESPONDENCE_SCALED = Int32(2)

mutable struct obc_correspondence_options <: CStruct
    struct_size::UInt32
    via::Int32
    align::Int32
    grid::Int32
    placement::Int32
    reserved::Int32
    tolerance::Float64
    cells::Csize_t
    corners::Csize_t
    seed::UInt64
    resolution::Csize_t
    landmark_count::Csize_t
    landmarks::Ptr{Float64}
    obc_correspondence_options() = zeroed!(new())
end

const address_obc_correspondence_options_init = Ref(C_NULL)
obc_correspondence_options_init(options, struct_size) =
    ccall(symbol(address_obc_correspondence_options_init, :correspondence, :obc_correspondence_options_init), Int32, (Ptr{obc_correspondence_options}, Csize_t), options, struct_size)

const address_obc_correspondence_create = Ref(C_NULL)
obc_correspondence_create(surfaces, count, options, host, out, error) =
    ccall(symbol(address_obc_correspondence_create, :correspondence, :obc_correspondence_create), Int32, (Ptr{obc_surface}, Csize_t, Ptr{obc_correspondence_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surfaces, count, options, host, out, error)

const address_obc_correspondence_destroy = Ref(C_NULL)
obc_correspondence_destroy(correspondence) =
    ccall(symbol(address_obc_correspondence_destroy, :correspondence, :obc_correspondence_destroy), Cvoid, (Ptr{Cvoid},), correspondence)

const address_obc_correspondence_shape_count = Ref(C_NULL)
obc_correspondence_shape_count(correspondence) =
    ccall(symbol(address_obc_correspondence_shape_count, :correspondence, :obc_correspondence_shape_count), Csize_t, (Ptr{Cvoid},), correspondence)

const address_obc_correspondence_vertex_count = Ref(C_NULL)
obc_correspondence_vertex_count(correspondence) =
    ccall(symbol(address_obc_correspondence_vertex_count, :correspondence, :obc_correspondence_vertex_count), Csize_t, (Ptr{Cvoid},), correspondence)

const address_obc_correspondence_triangle_count = Ref(C_NULL)
obc_correspondence_triangle_count(correspondence) =
    ccall(symbol(address_obc_correspondence_triangle_count, :correspondence, :obc_correspondence_triangle_count), Csize_t, (Ptr{Cvoid},), correspondence)

const address_obc_correspondence_copy = Ref(C_NULL)
obc_correspondence_copy(correspondence, shape, positions, triangles, error) =
    ccall(symbol(address_obc_correspondence_copy, :correspondence, :obc_correspondence_copy), Int32, (Ptr{Cvoid}, Csize_t, Ptr{Float64}, Ptr{UInt32}, Ptr{obc_error}), correspondence, shape, positions, triangles, error)

const address_obc_correspondence_blend = Ref(C_NULL)
obc_correspondence_blend(correspondence, weights, count, positions, error) =
    ccall(symbol(address_obc_correspondence_blend, :correspondence, :obc_correspondence_blend), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{Float64}, Ptr{obc_error}), correspondence, weights, count, positions, error)

const address_obc_correspondence_copy_domain = Ref(C_NULL)
obc_correspondence_copy_domain(correspondence, positions, error) =
    ccall(symbol(address_obc_correspondence_copy_domain, :correspondence, :obc_correspondence_copy_domain), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), correspondence, positions, error)

const address_obc_correspondence_quad_count = Ref(C_NULL)
obc_correspondence_quad_count(correspondence) =
    ccall(symbol(address_obc_correspondence_quad_count, :correspondence, :obc_correspondence_quad_count), Csize_t, (Ptr{Cvoid},), correspondence)

const address_obc_correspondence_copy_quads = Ref(C_NULL)
obc_correspondence_copy_quads(correspondence, quads, error) =
    ccall(symbol(address_obc_correspondence_copy_quads, :correspondence, :obc_correspondence_copy_quads), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{obc_error}), correspondence, quads, error)

const address_obc_correspondence_surface_vertex_count = Ref(C_NULL)
obc_correspondence_surface_vertex_count(correspondence, shape) =
    ccall(symbol(address_obc_correspondence_surface_vertex_count, :correspondence, :obc_correspondence_surface_vertex_count), Csize_t, (Ptr{Cvoid}, Csize_t), correspondence, shape)

const address_obc_correspondence_map = Ref(C_NULL)
obc_correspondence_map(correspondence, from, to, triangles, weights, count, host, mapped_triangles, mapped_weights, error) =
    ccall(symbol(address_obc_correspondence_map, :correspondence, :obc_correspondence_map), Int32, (Ptr{Cvoid}, Csize_t, Csize_t, Ptr{UInt32}, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), correspondence, from, to, triangles, weights, count, host, mapped_triangles, mapped_weights, error)

const address_obc_correspondence_map_vertices = Ref(C_NULL)
obc_correspondence_map_vertices(correspondence, from, to, host, mapped_triangles, mapped_weights, error) =
    ccall(symbol(address_obc_correspondence_map_vertices, :correspondence, :obc_correspondence_map_vertices), Int32, (Ptr{Cvoid}, Csize_t, Csize_t, Ptr{obc_host}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), correspondence, from, to, host, mapped_triangles, mapped_weights, error)

const address_obc_correspondence_version = Ref(C_NULL)
obc_correspondence_version() =
    ccall(symbol(address_obc_correspondence_version, :correspondence, :obc_correspondence_version), UInt32, ())
