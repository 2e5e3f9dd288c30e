# What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited.

mutable struct obc_volume_map_solid_options <: CStruct
    struct_size::UInt32
    reserved::Int32
    corners::Csize_t
    seed::UInt64
    obc_volume_map_solid_options() = zeroed!(new())
end

mutable struct obc_volume_map_frame_map_options <: CStruct
    struct_size::UInt32
    integer::Int32
    cell_length::Float64
    feature_angle::Float64
    obc_volume_map_frame_map_options() = zeroed!(new())
end

mutable struct obc_volume_map_frame_map_report <: CStruct
    struct_size::UInt32
    integers_optimal::Int32
    energy::Float64
    integer_cost::Float64
    residual::Float64
    cell_length::Float64
    inverted::UInt64
    integers::UInt64
    patches::UInt64
    cut_faces::UInt64
    singular_edges::UInt64
    solves::UInt64
    obc_volume_map_frame_map_report() = zeroed!(new())
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

const address_obc_volume_map_frame_map_options_init = Ref(C_NULL)
obc_volume_map_frame_map_options_init(options, struct_size) =
    ccall(symbol(address_obc_volume_map_frame_map_options_init, :volume_map, :obc_volume_map_frame_map_options_init), Int32, (Ptr{obc_volume_map_frame_map_options}, Csize_t), options, struct_size)

const address_obc_volume_map_frame_map_report_init = Ref(C_NULL)
obc_volume_map_frame_map_report_init(report, struct_size) =
    ccall(symbol(address_obc_volume_map_frame_map_report_init, :volume_map, :obc_volume_map_frame_map_report_init), Int32, (Ptr{obc_volume_map_frame_map_report}, Csize_t), report, struct_size)

const address_obc_volume_map_frame_map_compute = Ref(C_NULL)
obc_volume_map_frame_map_compute(positions, vertex_count, tetrahedra, tetrahedron_count, frames, options, host, report, out, error) =
    ccall(symbol(address_obc_volume_map_frame_map_compute, :volume_map, :obc_volume_map_frame_map_compute), Int32, (Ptr{Float64}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{Float64}, Ptr{obc_volume_map_frame_map_options}, Ptr{obc_host}, Ptr{obc_volume_map_frame_map_report}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), positions, vertex_count, tetrahedra, tetrahedron_count, frames, options, host, report, out, error)

const address_obc_volume_map_frame_map_destroy = Ref(C_NULL)
obc_volume_map_frame_map_destroy(map) =
    ccall(symbol(address_obc_volume_map_frame_map_destroy, :volume_map, :obc_volume_map_frame_map_destroy), Cvoid, (Ptr{Cvoid},), map)

const address_obc_volume_map_frame_map_tetrahedron_count = Ref(C_NULL)
obc_volume_map_frame_map_tetrahedron_count(map) =
    ccall(symbol(address_obc_volume_map_frame_map_tetrahedron_count, :volume_map, :obc_volume_map_frame_map_tetrahedron_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_volume_map_frame_map_singular_edge_count = Ref(C_NULL)
obc_volume_map_frame_map_singular_edge_count(map) =
    ccall(symbol(address_obc_volume_map_frame_map_singular_edge_count, :volume_map, :obc_volume_map_frame_map_singular_edge_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_volume_map_frame_map_copy = Ref(C_NULL)
obc_volume_map_frame_map_copy(map, parameters, rotations, gaps, cut, labels, singular_edges, error) =
    ccall(symbol(address_obc_volume_map_frame_map_copy, :volume_map, :obc_volume_map_frame_map_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt8}, Ptr{Float64}, Ptr{UInt8}, Ptr{UInt8}, Ptr{UInt32}, Ptr{obc_error}), map, parameters, rotations, gaps, cut, labels, singular_edges, error)

const address_obc_volume_map_locator_create = Ref(C_NULL)
obc_volume_map_locator_create(positions, vertex_count, tetrahedra, tetrahedron_count, host, out, error) =
    ccall(symbol(address_obc_volume_map_locator_create, :volume_map, :obc_volume_map_locator_create), Int32, (Ptr{Float64}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), positions, vertex_count, tetrahedra, tetrahedron_count, host, out, error)

const address_obc_volume_map_locator_destroy = Ref(C_NULL)
obc_volume_map_locator_destroy(locator) =
    ccall(symbol(address_obc_volume_map_locator_destroy, :volume_map, :obc_volume_map_locator_destroy), Cvoid, (Ptr{Cvoid},), locator)

const address_obc_volume_map_locator_locate = Ref(C_NULL)
obc_volume_map_locator_locate(locator, points, point_count, host, tetrahedra, weights, error) =
    ccall(symbol(address_obc_volume_map_locator_locate, :volume_map, :obc_volume_map_locator_locate), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), locator, points, point_count, host, tetrahedra, weights, error)

const address_obc_volume_map_locator_interpolate = Ref(C_NULL)
obc_volume_map_locator_interpolate(locator, tetrahedra, weights, point_count, values, components, host, images, error) =
    ccall(symbol(address_obc_volume_map_locator_interpolate, :volume_map, :obc_volume_map_locator_interpolate), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{Float64}, Csize_t, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), locator, tetrahedra, weights, point_count, values, components, host, images, error)

const address_obc_volume_map_version = Ref(C_NULL)
obc_volume_map_version() =
    ccall(symbol(address_obc_volume_map_version, :volume_map, :obc_volume_map_version), UInt32, ())
