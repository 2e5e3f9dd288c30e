# What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited.

mutable struct obc_volume_map_solid_options <: CStruct
    struct_size::UInt32
    reserved::Int32
    corners::Csize_t
    seed::UInt64
    obc_volume_map_solid_options() = zeroed!(new())
end

const address_obc_volume_map_solid_options_init = Ref(C_NULL)
obc_volume_map_solid_options_init(options, struct_size) =
    ccall(symbol(address_obc_volume_map_solid_options_init, :volume_map, :obc_volume_map_solid_options_init), Int32, (Ptr{obc_volume_map_solid_options}, Csize_t), options, struct_size)

const address_obc_volume_map_solid_compute = Ref(C_NULL)
obc_volume_map_solid_compute(positions, vertex_count, tetrahedra, tetrahedron_count, options, host, out, error) =
    ccall(symbol(address_obc_volume_map_solid_compute, :volume_map, :obc_volume_map_solid_compute), Int32, (Ptr{Float64}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{obc_volume_map_solid_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), positions, vertex_count, tetrahedra, tetrahedron_count, options, host, out, error)

const address_obc_volume_map_solid_destroy = Ref(C_NULL)
obc_volume_map_solid_destroy(solid) =
    ccall(symbol(address_obc_volume_map_solid_destroy, :volume_map, :obc_volume_map_solid_destroy), Cvoid, (Ptr{Cvoid},), solid)

const address_obc_volume_map_solid_vertex_count = Ref(C_NULL)
obc_volume_map_solid_vertex_count(solid) =
    ccall(symbol(address_obc_volume_map_solid_vertex_count, :volume_map, :obc_volume_map_solid_vertex_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_volume_map_solid_tetrahedron_count = Ref(C_NULL)
obc_volume_map_solid_tetrahedron_count(solid) =
    ccall(symbol(address_obc_volume_map_solid_tetrahedron_count, :volume_map, :obc_volume_map_solid_tetrahedron_count), Csize_t, (Ptr{Cvoid},), solid)

const address_obc_volume_map_solid_copy = Ref(C_NULL)
obc_volume_map_solid_copy(solid, positions, polycube, tetrahedra, error) =
    ccall(symbol(address_obc_volume_map_solid_copy, :volume_map, :obc_volume_map_solid_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{Float64}, Ptr{UInt32}, Ptr{obc_error}), solid, positions, polycube, tetrahedra, error)

const address_obc_volume_map_version = Ref(C_NULL)
obc_volume_map_version() =
    ccall(symbol(address_obc_volume_map_version, :volume_map, :obc_volume_map_version), UInt32, ())
