# What <orbicube/volume_map.h> declares. Written by scripts/bindings.py; not to be edited.

mutable struct obc_volume_map_tangle <: CStruct
    struct_size::UInt32
    reserved::Int32
    positions::Ptr{Float64}
    vertex_count::Csize_t
    tetrahedra::Ptr{UInt32}
    tetrahedron_count::Csize_t
    rest::Ptr{Float64}
    fixed::Ptr{UInt8}
    ties::Ptr{UInt32}
    obc_volume_map_tangle() = zeroed!(new())
end

mutable struct obc_volume_map_untangle_options <: CStruct
    struct_size::UInt32
    steps::Int32
    polish_steps::Int32
    reserved::Int32
    volume_weight::Float64
    obc_volume_map_untangle_options() = zeroed!(new())
end

mutable struct obc_volume_map_untangle_report <: CStruct
    struct_size::UInt32
    first_inverted::UInt32
    inverted_before::UInt64
    inverted::UInt64
    steps::UInt64
    polish_steps::UInt64
    least_determinant::Float64
    greatest_determinant::Float64
    energy::Float64
    obc_volume_map_untangle_report() = zeroed!(new())
end

const address_obc_volume_map_tangle_init = Ref(C_NULL)
obc_volume_map_tangle_init(tangle, struct_size) =
    ccall(symbol(address_obc_volume_map_tangle_init, :volume_map, :obc_volume_map_tangle_init), Int32, (Ptr{obc_volume_map_tangle}, Csize_t), tangle, struct_size)

const address_obc_volume_map_untangle_options_init = Ref(C_NULL)
obc_volume_map_untangle_options_init(options, struct_size) =
    ccall(symbol(address_obc_volume_map_untangle_options_init, :volume_map, :obc_volume_map_untangle_options_init), Int32, (Ptr{obc_volume_map_untangle_options}, Csize_t), options, struct_size)

const address_obc_volume_map_untangle_report_init = Ref(C_NULL)
obc_volume_map_untangle_report_init(report, struct_size) =
    ccall(symbol(address_obc_volume_map_untangle_report_init, :volume_map, :obc_volume_map_untangle_report_init), Int32, (Ptr{obc_volume_map_untangle_report}, Csize_t), report, struct_size)

const address_obc_volume_map_untangle = Ref(C_NULL)
obc_volume_map_untangle(tangle, options, host, result, report, error) =
    ccall(symbol(address_obc_volume_map_untangle, :volume_map, :obc_volume_map_untangle), Int32, (Ptr{obc_volume_map_tangle}, Ptr{obc_volume_map_untangle_options}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_volume_map_untangle_report}, Ptr{obc_error}), tangle, options, host, result, report, error)

const address_obc_volume_map_version = Ref(C_NULL)
obc_volume_map_version() =
    ccall(symbol(address_obc_volume_map_version, :volume_map, :obc_volume_map_version), UInt32, ())
