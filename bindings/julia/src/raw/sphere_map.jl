# What <orbicube/sphere_map.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_SPHERE_MAP_BALANCED = Int32(0)
const OBC_SPHERE_MAP_ANGLE_AREA = Int32(1)
const OBC_SPHERE_MAP_ISOMETRIC = Int32(2)
const OBC_SPHERE_MAP_STRETCH = Int32(3)
const OBC_SPHERE_MAP_CONFORMAL = Int32(4)
const OBC_SPHERE_MAP_DISSERTATION = Int32(5)

const OBC_SPHERE_MAP_ICOSPHERE = Int32(0)
const OBC_SPHERE_MAP_CUBE = Int32(1)
const OBC_SPHERE_MAP_LATITUDE = Int32(2)
const OBC_SPHERE_MAP_OCTAHEDRON = Int32(3)

mutable struct obc_sphere_map_options <: CStruct
    struct_size::UInt32
    method::Int32
    angle_weight::Float64
    area_weight::Float64
    seed::UInt64
    trace::Ptr{Cvoid}
    trace_user::Ptr{Cvoid}
    level_splits::UInt64
    level_tolerance::Float64
    final_tolerance::Float64
    max_level_iterations::UInt64
    max_final_iterations::UInt64
    obc_sphere_map_options() = zeroed!(new())
end

mutable struct obc_sphere_map_report <: CStruct
    struct_size::UInt32
    bijective::Int32
    mirrored::Int32
    reserved::Int32
    flipped::UInt64
    degenerate::UInt64
    zero_area_faces::UInt64
    degree::Float64
    energy_angle::Float64
    energy_area::Float64
    energy::Float64
    max_quasi_conformal::Float64
    mean_quasi_conformal::Float64
    min_area_ratio::Float64
    max_area_ratio::Float64
    stretch_efficiency::Float64
    isometric_mean::Float64
    equation_3_1::Float64
    equation_3_2::Float64
    equation_3_3::Float64
    equation_3_4::Float64
    obc_sphere_map_report() = zeroed!(new())
end

const address_obc_sphere_map_options_init = Ref(C_NULL)
obc_sphere_map_options_init(options, struct_size) =
    ccall(symbol(address_obc_sphere_map_options_init, :sphere_map, :obc_sphere_map_options_init), Int32, (Ptr{obc_sphere_map_options}, Csize_t), options, struct_size)

const address_obc_sphere_map_report_init = Ref(C_NULL)
obc_sphere_map_report_init(report, struct_size) =
    ccall(symbol(address_obc_sphere_map_report_init, :sphere_map, :obc_sphere_map_report_init), Int32, (Ptr{obc_sphere_map_report}, Csize_t), report, struct_size)

const address_obc_sphere_map_compute = Ref(C_NULL)
obc_sphere_map_compute(surface, options, host, directions, report, error) =
    ccall(symbol(address_obc_sphere_map_compute, :sphere_map, :obc_sphere_map_compute), Int32, (Ptr{obc_surface}, Ptr{obc_sphere_map_options}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_sphere_map_report}, Ptr{obc_error}), surface, options, host, directions, report, error)

const address_obc_sphere_map_compute_partial = Ref(C_NULL)
obc_sphere_map_compute_partial(surface, options, host, directions, placed, report, error) =
    ccall(symbol(address_obc_sphere_map_compute_partial, :sphere_map, :obc_sphere_map_compute_partial), Int32, (Ptr{obc_surface}, Ptr{obc_sphere_map_options}, Ptr{obc_host}, Ptr{Float64}, Ptr{Csize_t}, Ptr{obc_sphere_map_report}, Ptr{obc_error}), surface, options, host, directions, placed, report, error)

const address_obc_sphere_map_measure = Ref(C_NULL)
obc_sphere_map_measure(surface, directions, options, host, report, error) =
    ccall(symbol(address_obc_sphere_map_measure, :sphere_map, :obc_sphere_map_measure), Int32, (Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_sphere_map_options}, Ptr{obc_host}, Ptr{obc_sphere_map_report}, Ptr{obc_error}), surface, directions, options, host, report, error)

const address_obc_sphere_map_face_distortion = Ref(C_NULL)
obc_sphere_map_face_distortion(surface, directions, host, quasi_conformal, area_ratio, error) =
    ccall(symbol(address_obc_sphere_map_face_distortion, :sphere_map, :obc_sphere_map_face_distortion), Int32, (Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_host}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), surface, directions, host, quasi_conformal, area_ratio, error)

const address_obc_sphere_map_round_to_float = Ref(C_NULL)
obc_sphere_map_round_to_float(surface, directions, host, rounded, error) =
    ccall(symbol(address_obc_sphere_map_round_to_float, :sphere_map, :obc_sphere_map_round_to_float), Int32, (Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_host}, Ptr{Float32}, Ptr{obc_error}), surface, directions, host, rounded, error)

const address_obc_sphere_map_locator_create = Ref(C_NULL)
obc_sphere_map_locator_create(surface, directions, host, out, error) =
    ccall(symbol(address_obc_sphere_map_locator_create, :sphere_map, :obc_sphere_map_locator_create), Int32, (Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, directions, host, out, error)

const address_obc_sphere_map_locator_destroy = Ref(C_NULL)
obc_sphere_map_locator_destroy(locator) =
    ccall(symbol(address_obc_sphere_map_locator_destroy, :sphere_map, :obc_sphere_map_locator_destroy), Cvoid, (Ptr{Cvoid},), locator)

const address_obc_sphere_map_locate = Ref(C_NULL)
obc_sphere_map_locate(locator, directions, count, host, triangles, weights, error) =
    ccall(symbol(address_obc_sphere_map_locate, :sphere_map, :obc_sphere_map_locate), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), locator, directions, count, host, triangles, weights, error)

const address_obc_sphere_map_sample = Ref(C_NULL)
obc_sphere_map_sample(locator, directions, count, values, components, unit, host, sampled, error) =
    ccall(symbol(address_obc_sphere_map_sample, :sphere_map, :obc_sphere_map_sample), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{Float64}, Csize_t, Int32, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), locator, directions, count, values, components, unit, host, sampled, error)

const address_obc_sphere_map_grid = Ref(C_NULL)
obc_sphere_map_grid(grid, resolution, host, out, error) =
    ccall(symbol(address_obc_sphere_map_grid, :sphere_map, :obc_sphere_map_grid), Int32, (Int32, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), grid, resolution, host, out, error)

const address_obc_sphere_map_remesh = Ref(C_NULL)
obc_sphere_map_remesh(locator, positions, grid, resolution, host, out, error) =
    ccall(symbol(address_obc_sphere_map_remesh, :sphere_map, :obc_sphere_map_remesh), Int32, (Ptr{Cvoid}, Ptr{Float64}, Int32, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), locator, positions, grid, resolution, host, out, error)

const address_obc_sphere_map_image_size = Ref(C_NULL)
obc_sphere_map_image_size(layout, resolution, width, height, error) =
    ccall(symbol(address_obc_sphere_map_image_size, :sphere_map, :obc_sphere_map_image_size), Int32, (Int32, Csize_t, Ptr{Csize_t}, Ptr{Csize_t}, Ptr{obc_error}), layout, resolution, width, height, error)

const address_obc_sphere_map_image = Ref(C_NULL)
obc_sphere_map_image(locator, positions, layout, resolution, host, pixels, error) =
    ccall(symbol(address_obc_sphere_map_image, :sphere_map, :obc_sphere_map_image), Int32, (Ptr{Cvoid}, Ptr{Float64}, Int32, Csize_t, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), locator, positions, layout, resolution, host, pixels, error)

const address_obc_sphere_map_image_surface = Ref(C_NULL)
obc_sphere_map_image_surface(pixels, layout, resolution, host, out, seam_gap, error) =
    ccall(symbol(address_obc_sphere_map_image_surface, :sphere_map, :obc_sphere_map_image_surface), Int32, (Ptr{Float64}, Int32, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{Float64}, Ptr{obc_error}), pixels, layout, resolution, host, out, seam_gap, error)

const address_obc_sphere_map_image_write = Ref(C_NULL)
obc_sphere_map_image_write(path, pixels, layout, resolution, host, error) =
    ccall(symbol(address_obc_sphere_map_image_write, :sphere_map, :obc_sphere_map_image_write), Int32, (Cstring, Ptr{Float64}, Int32, Csize_t, Ptr{obc_host}, Ptr{obc_error}), path, pixels, layout, resolution, host, error)

const address_obc_sphere_map_image_read = Ref(C_NULL)
obc_sphere_map_image_read(path, host, layout, resolution, pixels, capacity, error) =
    ccall(symbol(address_obc_sphere_map_image_read, :sphere_map, :obc_sphere_map_image_read), Int32, (Cstring, Ptr{obc_host}, Ptr{Int32}, Ptr{Csize_t}, Ptr{Float64}, Csize_t, Ptr{obc_error}), path, host, layout, resolution, pixels, capacity, error)

const address_obc_sphere_map_best_rotation = Ref(C_NULL)
obc_sphere_map_best_rotation(from, to, count, rotation, error) =
    ccall(symbol(address_obc_sphere_map_best_rotation, :sphere_map, :obc_sphere_map_best_rotation), Int32, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{Float64}, Ptr{obc_error}), from, to, count, rotation, error)

const address_obc_sphere_map_warp_create = Ref(C_NULL)
obc_sphere_map_warp_create(from, to, count, host, out, error) =
    ccall(symbol(address_obc_sphere_map_warp_create, :sphere_map, :obc_sphere_map_warp_create), Int32, (Ptr{Float64}, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), from, to, count, host, out, error)

const address_obc_sphere_map_warp_destroy = Ref(C_NULL)
obc_sphere_map_warp_destroy(warp) =
    ccall(symbol(address_obc_sphere_map_warp_destroy, :sphere_map, :obc_sphere_map_warp_destroy), Cvoid, (Ptr{Cvoid},), warp)

const address_obc_sphere_map_warp_apply = Ref(C_NULL)
obc_sphere_map_warp_apply(warp, directions, count, backward, host, moved, error) =
    ccall(symbol(address_obc_sphere_map_warp_apply, :sphere_map, :obc_sphere_map_warp_apply), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Int32, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), warp, directions, count, backward, host, moved, error)

const address_obc_sphere_map_overlay = Ref(C_NULL)
obc_sphere_map_overlay(first, first_directions, second, second_directions, host, out, second_vertex, error) =
    ccall(symbol(address_obc_sphere_map_overlay, :sphere_map, :obc_sphere_map_overlay), Int32, (Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{UInt32}, Ptr{obc_error}), first, first_directions, second, second_directions, host, out, second_vertex, error)

const address_obc_sphere_map_version = Ref(C_NULL)
obc_sphere_map_version() =
    ccall(symbol(address_obc_sphere_map_version, :sphere_map, :obc_sphere_map_version), UInt32, ())
