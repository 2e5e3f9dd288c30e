# What <orbicube/polycube.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_POLYCUBE_AUTO = Int32(0)
const OBC_POLYCUBE_LABELS = Int32(1)
const OBC_POLYCUBE_VOXELS = Int32(2)
const OBC_POLYCUBE_DISSERTATION = Int32(3)

const OBC_POLYCUBE_SURFACE_MEAN = Int32(0)
const OBC_POLYCUBE_FACE_MEAN = Int32(1)
const OBC_POLYCUBE_HARMONIC = Int32(2)

const OBC_POLYCUBE_TRUST_REGION = Int32(0)
const OBC_POLYCUBE_GRADIENT = Int32(1)

mutable struct obc_polycube_certificate <: CStruct
    struct_size::UInt32
    valid::Int32
    genus::Int64
    corners::Csize_t
    patches::Csize_t
    reason::NTuple{256, UInt8}
    obc_polycube_certificate() = zeroed!(new())
end

mutable struct obc_polycube_options <: CStruct
    struct_size::UInt32
    construction::Int32
    corners::Csize_t
    seed::UInt64
    area_weight::Float64
    rounds::UInt32
    obc_polycube_options() = zeroed!(new())
end

mutable struct obc_polycube_domain_options <: CStruct
    struct_size::UInt32
    measure::Int32
    area_weight::Float64
    obc_polycube_domain_options() = zeroed!(new())
end

mutable struct obc_polycube_domain_report <: CStruct
    struct_size::UInt32
    converged::Int32
    energy_before::Float64
    energy::Float64
    evaluations::UInt64
    layers::Csize_t
    cells::Csize_t
    crossing::Csize_t
    angle_mean::Float64
    area_mean::Float64
    angle_weighted_mean::Float64
    area_weighted_mean::Float64
    obc_polycube_domain_report() = zeroed!(new())
end

mutable struct obc_polycube_corner_options <: CStruct
    struct_size::UInt32
    method::Int32
    area_weight::Float64
    domain::Int32
    rounds::Int32
    obc_polycube_corner_options() = zeroed!(new())
end

mutable struct obc_polycube_corner_report <: CStruct
    struct_size::UInt32
    converged::Int32
    energy_before::Float64
    energy::Float64
    evaluations::UInt64
    map_evaluations::Float64
    moves::Csize_t
    movable::Csize_t
    angle_mean::Float64
    area_mean::Float64
    angle_weighted_mean::Float64
    area_weighted_mean::Float64
    obc_polycube_corner_report() = zeroed!(new())
end

mutable struct obc_polycube_feature_options <: CStruct
    struct_size::UInt32
    point_count::Csize_t
    points::Ptr{UInt32}
    targets::Ptr{Float64}
    point_weights::Ptr{Float64}
    curve_count::Csize_t
    curve_starts::Ptr{UInt32}
    curve_vertices::Ptr{UInt32}
    curve_lines::Ptr{Float64}
    curve_weights::Ptr{Float64}
    feature_angle::Float64
    obc_polycube_feature_options() = zeroed!(new())
end

mutable struct obc_polycube_feature_report <: CStruct
    struct_size::UInt32
    distance_before::Float64
    distance::Float64
    sharp_length::Float64
    sharp_before::Float64
    sharp::Float64
    angle_mean::Float64
    area_mean::Float64
    angle_weighted_mean::Float64
    area_weighted_mean::Float64
    obc_polycube_feature_report() = zeroed!(new())
end

struct obc_polycube_constraints
    corners::Ptr{UInt32}
    vertices::Ptr{UInt32}
    points::Ptr{Float64}
    count::Csize_t
end

mutable struct obc_polycube_quads_options <: CStruct
    struct_size::UInt32
    quads::Csize_t
    edge_length::Float64
    obc_polycube_quads_options() = zeroed!(new())
end

mutable struct obc_polycube_atlas_options <: CStruct
    struct_size::UInt32
    size::UInt32
    padding::Float64
    obc_polycube_atlas_options() = zeroed!(new())
end

const address_obc_polycube_create = Ref(C_NULL)
obc_polycube_create(surface, polycube, host, certificate, out, error) =
    ccall(symbol(address_obc_polycube_create, :polycube, :obc_polycube_create), Int32, (Ptr{obc_surface}, Ptr{Float64}, Ptr{obc_host}, Ptr{obc_polycube_certificate}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, polycube, host, certificate, out, error)

const address_obc_polycube_options_init = Ref(C_NULL)
obc_polycube_options_init(options, struct_size) =
    ccall(symbol(address_obc_polycube_options_init, :polycube, :obc_polycube_options_init), Int32, (Ptr{obc_polycube_options}, Csize_t), options, struct_size)

const address_obc_polycube_compute = Ref(C_NULL)
obc_polycube_compute(surface, options, host, out, error) =
    ccall(symbol(address_obc_polycube_compute, :polycube, :obc_polycube_compute), Int32, (Ptr{obc_surface}, Ptr{obc_polycube_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, options, host, out, error)

const address_obc_polycube_domain_options_init = Ref(C_NULL)
obc_polycube_domain_options_init(options, struct_size) =
    ccall(symbol(address_obc_polycube_domain_options_init, :polycube, :obc_polycube_domain_options_init), Int32, (Ptr{obc_polycube_domain_options}, Csize_t), options, struct_size)

const address_obc_polycube_optimize_domain = Ref(C_NULL)
obc_polycube_optimize_domain(map, options, host, report, out, error) =
    ccall(symbol(address_obc_polycube_optimize_domain, :polycube, :obc_polycube_optimize_domain), Int32, (Ptr{Cvoid}, Ptr{obc_polycube_domain_options}, Ptr{obc_host}, Ptr{obc_polycube_domain_report}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), map, options, host, report, out, error)

const address_obc_polycube_corner_options_init = Ref(C_NULL)
obc_polycube_corner_options_init(options, struct_size) =
    ccall(symbol(address_obc_polycube_corner_options_init, :polycube, :obc_polycube_corner_options_init), Int32, (Ptr{obc_polycube_corner_options}, Csize_t), options, struct_size)

const address_obc_polycube_optimize_corners = Ref(C_NULL)
obc_polycube_optimize_corners(map, options, host, report, out, error) =
    ccall(symbol(address_obc_polycube_optimize_corners, :polycube, :obc_polycube_optimize_corners), Int32, (Ptr{Cvoid}, Ptr{obc_polycube_corner_options}, Ptr{obc_host}, Ptr{obc_polycube_corner_report}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), map, options, host, report, out, error)

const address_obc_polycube_feature_options_init = Ref(C_NULL)
obc_polycube_feature_options_init(options, struct_size) =
    ccall(symbol(address_obc_polycube_feature_options_init, :polycube, :obc_polycube_feature_options_init), Int32, (Ptr{obc_polycube_feature_options}, Csize_t), options, struct_size)

const address_obc_polycube_align_features = Ref(C_NULL)
obc_polycube_align_features(map, options, host, report, out, error) =
    ccall(symbol(address_obc_polycube_align_features, :polycube, :obc_polycube_align_features), Int32, (Ptr{Cvoid}, Ptr{obc_polycube_feature_options}, Ptr{obc_host}, Ptr{obc_polycube_feature_report}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), map, options, host, report, out, error)

const address_obc_polycube_energy_count = Ref(C_NULL)
obc_polycube_energy_count(map) =
    ccall(symbol(address_obc_polycube_energy_count, :polycube, :obc_polycube_energy_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_polycube_copy_energies = Ref(C_NULL)
obc_polycube_copy_energies(map, energies, error) =
    ccall(symbol(address_obc_polycube_copy_energies, :polycube, :obc_polycube_copy_energies), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{obc_error}), map, energies, error)

const address_obc_polycube_destroy = Ref(C_NULL)
obc_polycube_destroy(map) =
    ccall(symbol(address_obc_polycube_destroy, :polycube, :obc_polycube_destroy), Cvoid, (Ptr{Cvoid},), map)

const address_obc_polycube_vertex_count = Ref(C_NULL)
obc_polycube_vertex_count(map) =
    ccall(symbol(address_obc_polycube_vertex_count, :polycube, :obc_polycube_vertex_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_polycube_triangle_count = Ref(C_NULL)
obc_polycube_triangle_count(map) =
    ccall(symbol(address_obc_polycube_triangle_count, :polycube, :obc_polycube_triangle_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_polycube_corner_count = Ref(C_NULL)
obc_polycube_corner_count(map) =
    ccall(symbol(address_obc_polycube_corner_count, :polycube, :obc_polycube_corner_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_polycube_patch_count = Ref(C_NULL)
obc_polycube_patch_count(map) =
    ccall(symbol(address_obc_polycube_patch_count, :polycube, :obc_polycube_patch_count), Csize_t, (Ptr{Cvoid},), map)

const address_obc_polycube_construction = Ref(C_NULL)
obc_polycube_construction(map) =
    ccall(symbol(address_obc_polycube_construction, :polycube, :obc_polycube_construction), Int32, (Ptr{Cvoid},), map)

const address_obc_polycube_corner_points = Ref(C_NULL)
obc_polycube_corner_points(map, host, count, error) =
    ccall(symbol(address_obc_polycube_corner_points, :polycube, :obc_polycube_corner_points), Int32, (Ptr{Cvoid}, Ptr{obc_host}, Ptr{Csize_t}, Ptr{obc_error}), map, host, count, error)

const address_obc_polycube_copy = Ref(C_NULL)
obc_polycube_copy(map, positions, polycube, triangles, error) =
    ccall(symbol(address_obc_polycube_copy, :polycube, :obc_polycube_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{Float64}, Ptr{UInt32}, Ptr{obc_error}), map, positions, polycube, triangles, error)

const address_obc_polycube_copy_triangles = Ref(C_NULL)
obc_polycube_copy_triangles(map, labels, patches, sources, error) =
    ccall(symbol(address_obc_polycube_copy_triangles, :polycube, :obc_polycube_copy_triangles), Int32, (Ptr{Cvoid}, Ptr{UInt8}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), map, labels, patches, sources, error)

const address_obc_polycube_copy_sources = Ref(C_NULL)
obc_polycube_copy_sources(map, corners, weights, error) =
    ccall(symbol(address_obc_polycube_copy_sources, :polycube, :obc_polycube_copy_sources), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), map, corners, weights, error)

const address_obc_polycube_map_to_domain = Ref(C_NULL)
obc_polycube_map_to_domain(surface, polycube, constraints, host, out, error) =
    ccall(symbol(address_obc_polycube_map_to_domain, :polycube, :obc_polycube_map_to_domain), Int32, (Ptr{obc_surface}, Ptr{obc_surface}, Ptr{obc_polycube_constraints}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, polycube, constraints, host, out, error)

const address_obc_polycube_compute_common = Ref(C_NULL)
obc_polycube_compute_common(surfaces, count, options, domain, host, constructed_from, out, error) =
    ccall(symbol(address_obc_polycube_compute_common, :polycube, :obc_polycube_compute_common), Int32, (Ptr{obc_surface}, Csize_t, Ptr{obc_polycube_options}, Ptr{obc_polycube_domain_options}, Ptr{obc_host}, Ptr{Csize_t}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surfaces, count, options, domain, host, constructed_from, out, error)

const address_obc_polycube_optimize_common_domain = Ref(C_NULL)
obc_polycube_optimize_common_domain(maps, count, options, host, out, error) =
    ccall(symbol(address_obc_polycube_optimize_common_domain, :polycube, :obc_polycube_optimize_common_domain), Int32, (Ptr{Ptr{Cvoid}}, Csize_t, Ptr{obc_polycube_domain_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), maps, count, options, host, out, error)

const address_obc_polycube_graph_create = Ref(C_NULL)
obc_polycube_graph_create(map, host, out, error) =
    ccall(symbol(address_obc_polycube_graph_create, :polycube, :obc_polycube_graph_create), Int32, (Ptr{Cvoid}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), map, host, out, error)

const address_obc_polycube_graph_destroy = Ref(C_NULL)
obc_polycube_graph_destroy(graph) =
    ccall(symbol(address_obc_polycube_graph_destroy, :polycube, :obc_polycube_graph_destroy), Cvoid, (Ptr{Cvoid},), graph)

const address_obc_polycube_graph_corner_count = Ref(C_NULL)
obc_polycube_graph_corner_count(graph) =
    ccall(symbol(address_obc_polycube_graph_corner_count, :polycube, :obc_polycube_graph_corner_count), Csize_t, (Ptr{Cvoid},), graph)

const address_obc_polycube_graph_edge_count = Ref(C_NULL)
obc_polycube_graph_edge_count(graph) =
    ccall(symbol(address_obc_polycube_graph_edge_count, :polycube, :obc_polycube_graph_edge_count), Csize_t, (Ptr{Cvoid},), graph)

const address_obc_polycube_graph_patch_count = Ref(C_NULL)
obc_polycube_graph_patch_count(graph) =
    ccall(symbol(address_obc_polycube_graph_patch_count, :polycube, :obc_polycube_graph_patch_count), Csize_t, (Ptr{Cvoid},), graph)

const address_obc_polycube_graph_loop_count = Ref(C_NULL)
obc_polycube_graph_loop_count(graph) =
    ccall(symbol(address_obc_polycube_graph_loop_count, :polycube, :obc_polycube_graph_loop_count), Csize_t, (Ptr{Cvoid},), graph)

const address_obc_polycube_graph_link_count = Ref(C_NULL)
obc_polycube_graph_link_count(graph) =
    ccall(symbol(address_obc_polycube_graph_link_count, :polycube, :obc_polycube_graph_link_count), Csize_t, (Ptr{Cvoid},), graph)

const address_obc_polycube_graph_copy_corners = Ref(C_NULL)
obc_polycube_graph_copy_corners(graph, positions, vertices, error) =
    ccall(symbol(address_obc_polycube_graph_copy_corners, :polycube, :obc_polycube_graph_copy_corners), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{obc_error}), graph, positions, vertices, error)

const address_obc_polycube_graph_copy_edges = Ref(C_NULL)
obc_polycube_graph_copy_edges(graph, corners, patches, convex, error) =
    ccall(symbol(address_obc_polycube_graph_copy_edges, :polycube, :obc_polycube_graph_copy_edges), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt8}, Ptr{obc_error}), graph, corners, patches, convex, error)

const address_obc_polycube_graph_copy_patches = Ref(C_NULL)
obc_polycube_graph_copy_patches(graph, labels, coordinates, loop_starts, error) =
    ccall(symbol(address_obc_polycube_graph_copy_patches, :polycube, :obc_polycube_graph_copy_patches), Int32, (Ptr{Cvoid}, Ptr{UInt8}, Ptr{Float64}, Ptr{UInt32}, Ptr{obc_error}), graph, labels, coordinates, loop_starts, error)

const address_obc_polycube_graph_copy_loops = Ref(C_NULL)
obc_polycube_graph_copy_loops(graph, starts, darts, error) =
    ccall(symbol(address_obc_polycube_graph_copy_loops, :polycube, :obc_polycube_graph_copy_loops), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), graph, starts, darts, error)

const address_obc_polycube_graph_copy_dual = Ref(C_NULL)
obc_polycube_graph_copy_dual(graph, starts, neighbors, error) =
    ccall(symbol(address_obc_polycube_graph_copy_dual, :polycube, :obc_polycube_graph_copy_dual), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), graph, starts, neighbors, error)

const address_obc_polycube_quads_options_init = Ref(C_NULL)
obc_polycube_quads_options_init(options, struct_size) =
    ccall(symbol(address_obc_polycube_quads_options_init, :polycube, :obc_polycube_quads_options_init), Int32, (Ptr{obc_polycube_quads_options}, Csize_t), options, struct_size)

const address_obc_polycube_quads_create = Ref(C_NULL)
obc_polycube_quads_create(map, options, host, out, error) =
    ccall(symbol(address_obc_polycube_quads_create, :polycube, :obc_polycube_quads_create), Int32, (Ptr{Cvoid}, Ptr{obc_polycube_quads_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), map, options, host, out, error)

const address_obc_polycube_quads_destroy = Ref(C_NULL)
obc_polycube_quads_destroy(quads) =
    ccall(symbol(address_obc_polycube_quads_destroy, :polycube, :obc_polycube_quads_destroy), Cvoid, (Ptr{Cvoid},), quads)

const address_obc_polycube_quads_vertex_count = Ref(C_NULL)
obc_polycube_quads_vertex_count(quads) =
    ccall(symbol(address_obc_polycube_quads_vertex_count, :polycube, :obc_polycube_quads_vertex_count), Csize_t, (Ptr{Cvoid},), quads)

const address_obc_polycube_quads_quad_count = Ref(C_NULL)
obc_polycube_quads_quad_count(quads) =
    ccall(symbol(address_obc_polycube_quads_quad_count, :polycube, :obc_polycube_quads_quad_count), Csize_t, (Ptr{Cvoid},), quads)

const address_obc_polycube_quads_copy = Ref(C_NULL)
obc_polycube_quads_copy(quads, positions, polycube, corners, patches, error) =
    ccall(symbol(address_obc_polycube_quads_copy, :polycube, :obc_polycube_quads_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{Float64}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), quads, positions, polycube, corners, patches, error)

const address_obc_polycube_quads_copy_sources = Ref(C_NULL)
obc_polycube_quads_copy_sources(quads, triangles, weights, error) =
    ccall(symbol(address_obc_polycube_quads_copy_sources, :polycube, :obc_polycube_quads_copy_sources), Int32, (Ptr{Cvoid}, Ptr{UInt32}, Ptr{Float64}, Ptr{obc_error}), quads, triangles, weights, error)

const address_obc_polycube_atlas_options_init = Ref(C_NULL)
obc_polycube_atlas_options_init(options, struct_size) =
    ccall(symbol(address_obc_polycube_atlas_options_init, :polycube, :obc_polycube_atlas_options_init), Int32, (Ptr{obc_polycube_atlas_options}, Csize_t), options, struct_size)

const address_obc_polycube_atlas_create = Ref(C_NULL)
obc_polycube_atlas_create(map, options, host, out, error) =
    ccall(symbol(address_obc_polycube_atlas_create, :polycube, :obc_polycube_atlas_create), Int32, (Ptr{Cvoid}, Ptr{obc_polycube_atlas_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), map, options, host, out, error)

const address_obc_polycube_atlas_destroy = Ref(C_NULL)
obc_polycube_atlas_destroy(atlas) =
    ccall(symbol(address_obc_polycube_atlas_destroy, :polycube, :obc_polycube_atlas_destroy), Cvoid, (Ptr{Cvoid},), atlas)

const address_obc_polycube_atlas_size = Ref(C_NULL)
obc_polycube_atlas_size(atlas) =
    ccall(symbol(address_obc_polycube_atlas_size, :polycube, :obc_polycube_atlas_size), UInt32, (Ptr{Cvoid},), atlas)

const address_obc_polycube_atlas_triangle_count = Ref(C_NULL)
obc_polycube_atlas_triangle_count(atlas) =
    ccall(symbol(address_obc_polycube_atlas_triangle_count, :polycube, :obc_polycube_atlas_triangle_count), Csize_t, (Ptr{Cvoid},), atlas)

const address_obc_polycube_atlas_copy = Ref(C_NULL)
obc_polycube_atlas_copy(atlas, coordinates, texels_per_unit, coverage, error) =
    ccall(symbol(address_obc_polycube_atlas_copy, :polycube, :obc_polycube_atlas_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), atlas, coordinates, texels_per_unit, coverage, error)

const address_obc_polycube_atlas_sample = Ref(C_NULL)
obc_polycube_atlas_sample(atlas, host, triangles, weights, covered, error) =
    ccall(symbol(address_obc_polycube_atlas_sample, :polycube, :obc_polycube_atlas_sample), Int32, (Ptr{Cvoid}, Ptr{obc_host}, Ptr{UInt32}, Ptr{Float64}, Ptr{UInt8}, Ptr{obc_error}), atlas, host, triangles, weights, covered, error)

const address_obc_polycube_version = Ref(C_NULL)
obc_polycube_version() =
    ccall(symbol(address_obc_polycube_version, :polycube, :obc_polycube_version), UInt32, ())
