# What <orbicube/tetrahedra.h> declares. Written by scripts/bindings.py; not to be edited.

mutable struct obc_tetrahedra_options <: CStruct
    struct_size::UInt32
    keep_surface::Int32
    quality::Float64
    max_volume::Float64
    edge_length::Float64
    size_positions::Ptr{Float64}
    size_lengths::Ptr{Float64}
    size_count::Csize_t
    size_growth::Float64
    obc_tetrahedra_options() = zeroed!(new())
end

const address_obc_tetrahedra_options_init = Ref(C_NULL)
obc_tetrahedra_options_init(options, struct_size) =
    ccall(symbol(address_obc_tetrahedra_options_init, :tetrahedra, :obc_tetrahedra_options_init), Int32, (Ptr{obc_tetrahedra_options}, Csize_t), options, struct_size)

const address_obc_tetrahedra_fill = Ref(C_NULL)
obc_tetrahedra_fill(surface, options, host, out, error) =
    ccall(symbol(address_obc_tetrahedra_fill, :tetrahedra, :obc_tetrahedra_fill), Int32, (Ptr{obc_surface}, Ptr{obc_tetrahedra_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, options, host, out, error)

const address_obc_tetrahedra_fill_mesh = Ref(C_NULL)
obc_tetrahedra_fill_mesh(surface, max_volume, host, out, error, user) =
    ccall(symbol(address_obc_tetrahedra_fill_mesh, :tetrahedra, :obc_tetrahedra_fill_mesh), Int32, (Ptr{obc_surface}, Float64, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}, Ptr{Cvoid}), surface, max_volume, host, out, error, user)

const address_obc_tetrahedra_destroy = Ref(C_NULL)
obc_tetrahedra_destroy(solid) =
    ccall(symbol(address_obc_tetrahedra_destroy, :tetrahedra, :obc_tetrahedra_destroy), Cvoid, (Ptr{Cvoid},), solid)

const address_obc_tetrahedra_vertex_count = Ref(C_NULL)
obc_tetrahedra_vertex_count(solid) =
    ccall(symbol(address_obc_tetrahedra_vertex_count, :tetrahedra, :obc_tetrahedra_vertex_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_tetrahedra_count = Ref(C_NULL)
obc_tetrahedra_count(solid) =
    ccall(symbol(address_obc_tetrahedra_count, :tetrahedra, :obc_tetrahedra_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_tetrahedra_boundary_count = Ref(C_NULL)
obc_tetrahedra_boundary_count(solid) =
    ccall(symbol(address_obc_tetrahedra_boundary_count, :tetrahedra, :obc_tetrahedra_boundary_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_tetrahedra_part_count = Ref(C_NULL)
obc_tetrahedra_part_count(solid) =
    ccall(symbol(address_obc_tetrahedra_part_count, :tetrahedra, :obc_tetrahedra_part_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_tetrahedra_cavity_count = Ref(C_NULL)
obc_tetrahedra_cavity_count(solid) =
    ccall(symbol(address_obc_tetrahedra_cavity_count, :tetrahedra, :obc_tetrahedra_cavity_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_tetrahedra_copy = Ref(C_NULL)
obc_tetrahedra_copy(solid, positions, tetrahedra, boundary, boundary_source, error) =
    ccall(symbol(address_obc_tetrahedra_copy, :tetrahedra, :obc_tetrahedra_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), solid, positions, tetrahedra, boundary, boundary_source, error)

const address_obc_tetrahedra_check_surface = Ref(C_NULL)
obc_tetrahedra_check_surface(surface, host, pairs, capacity, count, error) =
    ccall(symbol(address_obc_tetrahedra_check_surface, :tetrahedra, :obc_tetrahedra_check_surface), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{UInt32}, Csize_t, Ptr{Csize_t}, Ptr{obc_error}), surface, host, pairs, capacity, count, error)

const address_obc_tetrahedra_version = Ref(C_NULL)
obc_tetrahedra_version() =
    ccall(symbol(address_obc_tetrahedra_version, :tetrahedra, :obc_tetrahedra_version), UInt32, ())
