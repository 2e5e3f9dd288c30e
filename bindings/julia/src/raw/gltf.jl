# What <orbicube/gltf.h> declares. Written by scripts/bindings.py; not to be edited.

mutable struct obc_gltf_read_options <: CStruct
    struct_size::UInt32
    weld_identical::Int32
    morph_target::Cstring
    keep::Int32
    reserved::Int32
    obc_gltf_read_options() = zeroed!(new())
end

struct obc_gltf_morph_target
    name::Cstring
    positions::Ptr{Float32}
end

mutable struct obc_gltf_scene <: CStruct
    struct_size::UInt32
    smooth_normals::Int32
    positions::Ptr{Float32}
    vertex_count::Csize_t
    triangles::Ptr{UInt32}
    triangle_count::Csize_t
    normals::Ptr{Float32}
    texture_coordinates::Ptr{Float32}
    colors::Ptr{UInt8}
    morph_targets::Ptr{obc_gltf_morph_target}
    morph_target_count::Csize_t
    edges::Ptr{UInt32}
    edge_count::Csize_t
    translation::NTuple{3, Float64}
    scale::Float64
    base_color::NTuple{4, Float64}
    texture::Ptr{Cvoid}
    texture_size::Csize_t
    checker_texture::Int32
    morph_normals::Int32
    name::Cstring
    extras::Cstring
    morph_seconds::Float64
    kept::Ptr{Cvoid}
    kept_positions::Ptr{Float64}
    obc_gltf_scene() = zeroed!(new())
end

const address_obc_gltf_read_options_init = Ref(C_NULL)
obc_gltf_read_options_init(options, struct_size) =
    ccall(symbol(address_obc_gltf_read_options_init, :gltf, :obc_gltf_read_options_init), Int32, (Ptr{obc_gltf_read_options}, Csize_t), options, struct_size)

const address_obc_gltf_read = Ref(C_NULL)
obc_gltf_read(path, options, host, out, error) =
    ccall(symbol(address_obc_gltf_read, :gltf, :obc_gltf_read), Int32, (Cstring, Ptr{obc_gltf_read_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), path, options, host, out, error)

const address_obc_gltf_read_memory = Ref(C_NULL)
obc_gltf_read_memory(bytes, size, folder, options, host, out, error) =
    ccall(symbol(address_obc_gltf_read_memory, :gltf, :obc_gltf_read_memory), Int32, (Ptr{Cvoid}, Csize_t, Cstring, Ptr{obc_gltf_read_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), bytes, size, folder, options, host, out, error)

const address_obc_gltf_surface_vertex_count = Ref(C_NULL)
obc_gltf_surface_vertex_count(surface) =
    ccall(symbol(address_obc_gltf_surface_vertex_count, :gltf, :obc_gltf_surface_vertex_count), Csize_t, (Ptr{Cvoid},), surface)

const address_obc_gltf_surface_triangle_count = Ref(C_NULL)
obc_gltf_surface_triangle_count(surface) =
    ccall(symbol(address_obc_gltf_surface_triangle_count, :gltf, :obc_gltf_surface_triangle_count), Csize_t, (Ptr{Cvoid},), surface)

const address_obc_gltf_surface_welded_vertex_count = Ref(C_NULL)
obc_gltf_surface_welded_vertex_count(surface) =
    ccall(symbol(address_obc_gltf_surface_welded_vertex_count, :gltf, :obc_gltf_surface_welded_vertex_count), Csize_t, (Ptr{Cvoid},), surface)

const address_obc_gltf_surface_note_count = Ref(C_NULL)
obc_gltf_surface_note_count(surface) =
    ccall(symbol(address_obc_gltf_surface_note_count, :gltf, :obc_gltf_surface_note_count), Csize_t, (Ptr{Cvoid},), surface)

const address_obc_gltf_surface_note = Ref(C_NULL)
obc_gltf_surface_note(surface, index) =
    ccall(symbol(address_obc_gltf_surface_note, :gltf, :obc_gltf_surface_note), Cstring, (Ptr{Cvoid}, Csize_t), surface, index)

const address_obc_gltf_surface_keeps = Ref(C_NULL)
obc_gltf_surface_keeps(surface) =
    ccall(symbol(address_obc_gltf_surface_keeps, :gltf, :obc_gltf_surface_keeps), Int32, (Ptr{Cvoid},), surface)

const address_obc_gltf_surface_copy = Ref(C_NULL)
obc_gltf_surface_copy(surface, positions, triangles, error) =
    ccall(symbol(address_obc_gltf_surface_copy, :gltf, :obc_gltf_surface_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{obc_error}), surface, positions, triangles, error)

const address_obc_gltf_surface_destroy = Ref(C_NULL)
obc_gltf_surface_destroy(surface) =
    ccall(symbol(address_obc_gltf_surface_destroy, :gltf, :obc_gltf_surface_destroy), Cvoid, (Ptr{Cvoid},), surface)

const address_obc_gltf_scene_init = Ref(C_NULL)
obc_gltf_scene_init(scene, struct_size) =
    ccall(symbol(address_obc_gltf_scene_init, :gltf, :obc_gltf_scene_init), Int32, (Ptr{obc_gltf_scene}, Csize_t), scene, struct_size)

const address_obc_gltf_write = Ref(C_NULL)
obc_gltf_write(path, scene, host, error) =
    ccall(symbol(address_obc_gltf_write, :gltf, :obc_gltf_write), Int32, (Cstring, Ptr{obc_gltf_scene}, Ptr{obc_host}, Ptr{obc_error}), path, scene, host, error)

const address_obc_gltf_write_kept = Ref(C_NULL)
obc_gltf_write_kept(path, surface, host, error) =
    ccall(symbol(address_obc_gltf_write_kept, :gltf, :obc_gltf_write_kept), Int32, (Cstring, Ptr{Cvoid}, Ptr{obc_host}, Ptr{obc_error}), path, surface, host, error)

const address_obc_gltf_write_surface = Ref(C_NULL)
obc_gltf_write_surface(path, positions, vertex_count, triangles, triangle_count, host, error) =
    ccall(symbol(address_obc_gltf_write_surface, :gltf, :obc_gltf_write_surface), Int32, (Cstring, Ptr{Float32}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{obc_host}, Ptr{obc_error}), path, positions, vertex_count, triangles, triangle_count, host, error)

const address_obc_gltf_delta = Ref(C_NULL)
obc_gltf_delta(base, target) =
    ccall(symbol(address_obc_gltf_delta, :gltf, :obc_gltf_delta), Float32, (Float32, Float32), base, target)

const address_obc_gltf_reconstructed = Ref(C_NULL)
obc_gltf_reconstructed(base, delta) =
    ccall(symbol(address_obc_gltf_reconstructed, :gltf, :obc_gltf_reconstructed), Float32, (Float32, Float32), base, delta)

const address_obc_gltf_version = Ref(C_NULL)
obc_gltf_version() =
    ccall(symbol(address_obc_gltf_version, :gltf, :obc_gltf_version), UInt32, ())
