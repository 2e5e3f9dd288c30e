# What <orbicube/mesh.h> declares. Written by scripts/bindings.py; not to be edited.

const OBC_MESH_TRIANGLE_REGIONS = Int32(1)
const OBC_MESH_TETRAHEDRON_REGIONS = Int32(2)
const OBC_MESH_HEXAHEDRON_REGIONS = Int32(4)

const OBC_MESH_OBJ = Int32(0)
const OBC_MESH_OFF = Int32(1)
const OBC_MESH_PLY = Int32(2)
const OBC_MESH_STL = Int32(3)
const OBC_MESH_MEDIT = Int32(4)
const OBC_MESH_VTK = Int32(5)
const OBC_MESH_MSH = Int32(6)
const OBC_MESH_FREESURFER = Int32(7)
const OBC_MESH_INP = Int32(8)
const OBC_MESH_VTP = Int32(9)
const OBC_MESH_VTU = Int32(10)
const OBC_MESH_GIFTI = Int32(11)

const OBC_MESH_HOLDS_SURFACES = Int32(1)
const OBC_MESH_HOLDS_POLYGONS = Int32(2)
const OBC_MESH_HOLDS_CELLS = Int32(4)
const OBC_MESH_HOLDS_BINARY = Int32(8)
const OBC_MESH_HOLDS_REGIONS = Int32(16)

struct obc_surface
    positions::Ptr{Float64}
    vertex_count::Csize_t
    triangles::Ptr{UInt32}
    triangle_count::Csize_t
end

mutable struct obc_mesh_cells <: CStruct
    struct_size::UInt32
    reserved::Int32
    positions::Ptr{Float64}
    vertex_count::Csize_t
    triangles::Ptr{UInt32}
    triangle_count::Csize_t
    tetrahedra::Ptr{UInt32}
    tetrahedron_count::Csize_t
    hexahedra::Ptr{UInt32}
    hexahedron_count::Csize_t
    triangle_regions::Ptr{Int32}
    tetrahedron_regions::Ptr{Int32}
    hexahedron_regions::Ptr{Int32}
    obc_mesh_cells() = zeroed!(new())
end

mutable struct obc_mesh_tetrahedron_quality_report <: CStruct
    struct_size::UInt32
    worst::UInt32
    tetrahedra::UInt64
    positive::UInt64
    flat::UInt64
    inverted::UInt64
    volume::Float64
    min_volume::Float64
    max_volume::Float64
    min_dihedral::Float64
    max_dihedral::Float64
    mean_min_dihedral::Float64
    min_radius_ratio::Float64
    mean_radius_ratio::Float64
    max_radius_edge::Float64
    mean_radius_edge::Float64
    min_edge_length::Float64
    max_edge_length::Float64
    dihedral_histogram::NTuple{18, UInt64}
    radius_ratio_histogram::NTuple{20, UInt64}
    obc_mesh_tetrahedron_quality_report() = zeroed!(new())
end

mutable struct obc_mesh_read_options <: CStruct
    struct_size::UInt32
    weld_identical::Int32
    obc_mesh_read_options() = zeroed!(new())
end

mutable struct obc_mesh_write_options <: CStruct
    struct_size::UInt32
    binary::Int32
    obc_mesh_write_options() = zeroed!(new())
end

mutable struct obc_mesh_topology_report <: CStruct
    struct_size::UInt32
    closed::Int32
    manifold::Int32
    orientable::Int32
    vertices::UInt64
    unreferenced_vertices::UInt64
    triangles::UInt64
    edges::UInt64
    components::UInt64
    boundary_edges::UInt64
    boundary_loops::UInt64
    longest_boundary_loop::UInt64
    non_manifold_edges::UInt64
    non_manifold_vertices::UInt64
    inconsistent_edges::UInt64
    degenerate_faces::UInt64
    duplicate_faces::UInt64
    zero_area_faces::UInt64
    coincident_vertices::UInt64
    euler_characteristic::Int64
    genus::Int64
    low::NTuple{3, Float64}
    high::NTuple{3, Float64}
    area::Float64
    volume::Float64
    first_boundary_edge::NTuple{2, UInt32}
    first_non_manifold_edge::NTuple{2, UInt32}
    first_inconsistent_edge::NTuple{2, UInt32}
    first_duplicate_faces::NTuple{2, UInt32}
    first_coincident_vertices::NTuple{2, UInt32}
    first_non_manifold_vertex::UInt32
    first_vertex_apart::UInt32
    first_degenerate_face::UInt32
    first_zero_area_face::UInt32
    obc_mesh_topology_report() = zeroed!(new())
end

mutable struct obc_mesh_orient_report <: CStruct
    struct_size::UInt32
    inward_oriented::Int32
    reversed_triangles::UInt64
    obc_mesh_orient_report() = zeroed!(new())
end

mutable struct obc_mesh_distance <: CStruct
    struct_size::UInt32
    reserved::UInt32
    first_mean::Float64
    first_root_mean_square::Float64
    first_max::Float64
    second_mean::Float64
    second_root_mean_square::Float64
    second_max::Float64
    obc_mesh_distance() = zeroed!(new())
end

const address_obc_mesh_cells_init = Ref(C_NULL)
obc_mesh_cells_init(cells, struct_size) =
    ccall(symbol(address_obc_mesh_cells_init, :mesh, :obc_mesh_cells_init), Int32, (Ptr{obc_mesh_cells}, Csize_t), cells, struct_size)

const address_obc_mesh_create = Ref(C_NULL)
obc_mesh_create(cells, host, out, error) =
    ccall(symbol(address_obc_mesh_create, :mesh, :obc_mesh_create), Int32, (Ptr{obc_mesh_cells}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), cells, host, out, error)

const address_obc_mesh_make = Ref(C_NULL)
obc_mesh_make(shape, triangle_count, seed, host, out, error) =
    ccall(symbol(address_obc_mesh_make, :mesh, :obc_mesh_make), Int32, (Cstring, Csize_t, UInt64, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), shape, triangle_count, seed, host, out, error)

const address_obc_mesh_shape_name = Ref(C_NULL)
obc_mesh_shape_name(index) =
    ccall(symbol(address_obc_mesh_shape_name, :mesh, :obc_mesh_shape_name), Cstring, (Csize_t,), index)

const address_obc_mesh_destroy = Ref(C_NULL)
obc_mesh_destroy(mesh) =
    ccall(symbol(address_obc_mesh_destroy, :mesh, :obc_mesh_destroy), Cvoid, (Ptr{Cvoid},), mesh)

const address_obc_mesh_vertex_count = Ref(C_NULL)
obc_mesh_vertex_count(mesh) =
    ccall(symbol(address_obc_mesh_vertex_count, :mesh, :obc_mesh_vertex_count), Csize_t, (Ptr{Cvoid},), mesh)

const address_obc_mesh_triangle_count = Ref(C_NULL)
obc_mesh_triangle_count(mesh) =
    ccall(symbol(address_obc_mesh_triangle_count, :mesh, :obc_mesh_triangle_count), Csize_t, (Ptr{Cvoid},), mesh)

const address_obc_mesh_tetrahedron_count = Ref(C_NULL)
obc_mesh_tetrahedron_count(mesh) =
    ccall(symbol(address_obc_mesh_tetrahedron_count, :mesh, :obc_mesh_tetrahedron_count), Csize_t, (Ptr{Cvoid},), mesh)

const address_obc_mesh_hexahedron_count = Ref(C_NULL)
obc_mesh_hexahedron_count(mesh) =
    ccall(symbol(address_obc_mesh_hexahedron_count, :mesh, :obc_mesh_hexahedron_count), Csize_t, (Ptr{Cvoid},), mesh)

const address_obc_mesh_copy = Ref(C_NULL)
obc_mesh_copy(mesh, positions, triangles, tetrahedra, hexahedra, error) =
    ccall(symbol(address_obc_mesh_copy, :mesh, :obc_mesh_copy), Int32, (Ptr{Cvoid}, Ptr{Float64}, Ptr{UInt32}, Ptr{UInt32}, Ptr{UInt32}, Ptr{obc_error}), mesh, positions, triangles, tetrahedra, hexahedra, error)

const address_obc_mesh_region_kinds = Ref(C_NULL)
obc_mesh_region_kinds(mesh) =
    ccall(symbol(address_obc_mesh_region_kinds, :mesh, :obc_mesh_region_kinds), UInt32, (Ptr{Cvoid},), mesh)

const address_obc_mesh_copy_regions = Ref(C_NULL)
obc_mesh_copy_regions(mesh, triangles, tetrahedra, hexahedra, error) =
    ccall(symbol(address_obc_mesh_copy_regions, :mesh, :obc_mesh_copy_regions), Int32, (Ptr{Cvoid}, Ptr{Int32}, Ptr{Int32}, Ptr{Int32}, Ptr{obc_error}), mesh, triangles, tetrahedra, hexahedra, error)

const address_obc_mesh_surface = Ref(C_NULL)
obc_mesh_surface(mesh, surface, error) =
    ccall(symbol(address_obc_mesh_surface, :mesh, :obc_mesh_surface), Int32, (Ptr{Cvoid}, Ptr{obc_surface}, Ptr{obc_error}), mesh, surface, error)

const address_obc_mesh_check_cells = Ref(C_NULL)
obc_mesh_check_cells(mesh, host, error) =
    ccall(symbol(address_obc_mesh_check_cells, :mesh, :obc_mesh_check_cells), Int32, (Ptr{Cvoid}, Ptr{obc_host}, Ptr{obc_error}), mesh, host, error)

const address_obc_mesh_boundary = Ref(C_NULL)
obc_mesh_boundary(mesh, host, out, error) =
    ccall(symbol(address_obc_mesh_boundary, :mesh, :obc_mesh_boundary), Int32, (Ptr{Cvoid}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), mesh, host, out, error)

const address_obc_mesh_tetrahedron_quality_report_init = Ref(C_NULL)
obc_mesh_tetrahedron_quality_report_init(report, struct_size) =
    ccall(symbol(address_obc_mesh_tetrahedron_quality_report_init, :mesh, :obc_mesh_tetrahedron_quality_report_init), Int32, (Ptr{obc_mesh_tetrahedron_quality_report}, Csize_t), report, struct_size)

const address_obc_mesh_tetrahedron_quality = Ref(C_NULL)
obc_mesh_tetrahedron_quality(mesh, host, report, error) =
    ccall(symbol(address_obc_mesh_tetrahedron_quality, :mesh, :obc_mesh_tetrahedron_quality), Int32, (Ptr{Cvoid}, Ptr{obc_host}, Ptr{obc_mesh_tetrahedron_quality_report}, Ptr{obc_error}), mesh, host, report, error)

const address_obc_mesh_format_ending = Ref(C_NULL)
obc_mesh_format_ending(format) =
    ccall(symbol(address_obc_mesh_format_ending, :mesh, :obc_mesh_format_ending), Cstring, (Int32,), format)

const address_obc_mesh_format_name = Ref(C_NULL)
obc_mesh_format_name(format) =
    ccall(symbol(address_obc_mesh_format_name, :mesh, :obc_mesh_format_name), Cstring, (Int32,), format)

const address_obc_mesh_format_contents = Ref(C_NULL)
obc_mesh_format_contents(format) =
    ccall(symbol(address_obc_mesh_format_contents, :mesh, :obc_mesh_format_contents), UInt32, (Int32,), format)

const address_obc_mesh_read_options_init = Ref(C_NULL)
obc_mesh_read_options_init(options, struct_size) =
    ccall(symbol(address_obc_mesh_read_options_init, :mesh, :obc_mesh_read_options_init), Int32, (Ptr{obc_mesh_read_options}, Csize_t), options, struct_size)

const address_obc_mesh_read = Ref(C_NULL)
obc_mesh_read(path, options, host, out, error) =
    ccall(symbol(address_obc_mesh_read, :mesh, :obc_mesh_read), Int32, (Cstring, Ptr{obc_mesh_read_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), path, options, host, out, error)

const address_obc_mesh_read_memory = Ref(C_NULL)
obc_mesh_read_memory(bytes, size, format, options, host, out, error) =
    ccall(symbol(address_obc_mesh_read_memory, :mesh, :obc_mesh_read_memory), Int32, (Ptr{Cvoid}, Csize_t, Int32, Ptr{obc_mesh_read_options}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), bytes, size, format, options, host, out, error)

const address_obc_mesh_format = Ref(C_NULL)
obc_mesh_format(mesh) =
    ccall(symbol(address_obc_mesh_format, :mesh, :obc_mesh_format), Cstring, (Ptr{Cvoid},), mesh)

const address_obc_mesh_polygon_count = Ref(C_NULL)
obc_mesh_polygon_count(mesh) =
    ccall(symbol(address_obc_mesh_polygon_count, :mesh, :obc_mesh_polygon_count), Csize_t, (Ptr{Cvoid},), mesh)

const address_obc_mesh_welded_vertex_count = Ref(C_NULL)
obc_mesh_welded_vertex_count(mesh) =
    ccall(symbol(address_obc_mesh_welded_vertex_count, :mesh, :obc_mesh_welded_vertex_count), Csize_t, (Ptr{Cvoid},), mesh)

const address_obc_mesh_note = Ref(C_NULL)
obc_mesh_note(mesh, index) =
    ccall(symbol(address_obc_mesh_note, :mesh, :obc_mesh_note), Cstring, (Ptr{Cvoid}, Csize_t), mesh, index)

const address_obc_mesh_write_options_init = Ref(C_NULL)
obc_mesh_write_options_init(options, struct_size) =
    ccall(symbol(address_obc_mesh_write_options_init, :mesh, :obc_mesh_write_options_init), Int32, (Ptr{obc_mesh_write_options}, Csize_t), options, struct_size)

const address_obc_mesh_write = Ref(C_NULL)
obc_mesh_write(path, mesh, options, host, error) =
    ccall(symbol(address_obc_mesh_write, :mesh, :obc_mesh_write), Int32, (Cstring, Ptr{Cvoid}, Ptr{obc_mesh_write_options}, Ptr{obc_host}, Ptr{obc_error}), path, mesh, options, host, error)

const address_obc_mesh_write_surface = Ref(C_NULL)
obc_mesh_write_surface(path, surface, options, host, error) =
    ccall(symbol(address_obc_mesh_write_surface, :mesh, :obc_mesh_write_surface), Int32, (Cstring, Ptr{obc_surface}, Ptr{obc_mesh_write_options}, Ptr{obc_host}, Ptr{obc_error}), path, surface, options, host, error)

const address_obc_mesh_topology_report_init = Ref(C_NULL)
obc_mesh_topology_report_init(report, struct_size) =
    ccall(symbol(address_obc_mesh_topology_report_init, :mesh, :obc_mesh_topology_report_init), Int32, (Ptr{obc_mesh_topology_report}, Csize_t), report, struct_size)

const address_obc_mesh_topology = Ref(C_NULL)
obc_mesh_topology(surface, host, report, error) =
    ccall(symbol(address_obc_mesh_topology, :mesh, :obc_mesh_topology), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{obc_mesh_topology_report}, Ptr{obc_error}), surface, host, report, error)

const address_obc_mesh_check_closed_genus_zero = Ref(C_NULL)
obc_mesh_check_closed_genus_zero(surface, host, error) =
    ccall(symbol(address_obc_mesh_check_closed_genus_zero, :mesh, :obc_mesh_check_closed_genus_zero), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{obc_error}), surface, host, error)

const address_obc_mesh_orient_report_init = Ref(C_NULL)
obc_mesh_orient_report_init(report, struct_size) =
    ccall(symbol(address_obc_mesh_orient_report_init, :mesh, :obc_mesh_orient_report_init), Int32, (Ptr{obc_mesh_orient_report}, Csize_t), report, struct_size)

const address_obc_mesh_orient = Ref(C_NULL)
obc_mesh_orient(positions, vertex_count, triangles, triangle_count, host, report, error) =
    ccall(symbol(address_obc_mesh_orient, :mesh, :obc_mesh_orient), Int32, (Ptr{Float64}, Csize_t, Ptr{UInt32}, Csize_t, Ptr{obc_host}, Ptr{obc_mesh_orient_report}, Ptr{obc_error}), positions, vertex_count, triangles, triangle_count, host, report, error)

const address_obc_mesh_first_at_same_position = Ref(C_NULL)
obc_mesh_first_at_same_position(positions, vertex_count, host, first, error) =
    ccall(symbol(address_obc_mesh_first_at_same_position, :mesh, :obc_mesh_first_at_same_position), Int32, (Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{UInt32}, Ptr{obc_error}), positions, vertex_count, host, first, error)

const address_obc_mesh_intersections = Ref(C_NULL)
obc_mesh_intersections(surface, host, pairs, capacity, count, error) =
    ccall(symbol(address_obc_mesh_intersections, :mesh, :obc_mesh_intersections), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{UInt32}, Csize_t, Ptr{Csize_t}, Ptr{obc_error}), surface, host, pairs, capacity, count, error)

const address_obc_mesh_vertex_normals = Ref(C_NULL)
obc_mesh_vertex_normals(surface, host, normals, error) =
    ccall(symbol(address_obc_mesh_vertex_normals, :mesh, :obc_mesh_vertex_normals), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), surface, host, normals, error)

const address_obc_mesh_vertex_areas = Ref(C_NULL)
obc_mesh_vertex_areas(surface, host, areas, error) =
    ccall(symbol(address_obc_mesh_vertex_areas, :mesh, :obc_mesh_vertex_areas), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), surface, host, areas, error)

const address_obc_mesh_distance_init = Ref(C_NULL)
obc_mesh_distance_init(distance, struct_size) =
    ccall(symbol(address_obc_mesh_distance_init, :mesh, :obc_mesh_distance_init), Int32, (Ptr{obc_mesh_distance}, Csize_t), distance, struct_size)

const address_obc_mesh_surface_distance = Ref(C_NULL)
obc_mesh_surface_distance(first, second, host, distance, error) =
    ccall(symbol(address_obc_mesh_surface_distance, :mesh, :obc_mesh_surface_distance), Int32, (Ptr{obc_surface}, Ptr{obc_surface}, Ptr{obc_host}, Ptr{obc_mesh_distance}, Ptr{obc_error}), first, second, host, distance, error)

const address_obc_mesh_mean_distance = Ref(C_NULL)
obc_mesh_mean_distance(a, a_count, b, b_count, host, distance, error) =
    ccall(symbol(address_obc_mesh_mean_distance, :mesh, :obc_mesh_mean_distance), Int32, (Ptr{Float64}, Csize_t, Ptr{Float64}, Csize_t, Ptr{obc_host}, Ptr{Float64}, Ptr{obc_error}), a, a_count, b, b_count, host, distance, error)

const address_obc_mesh_search_create = Ref(C_NULL)
obc_mesh_search_create(surface, host, out, error) =
    ccall(symbol(address_obc_mesh_search_create, :mesh, :obc_mesh_search_create), Int32, (Ptr{obc_surface}, Ptr{obc_host}, Ptr{Ptr{Cvoid}}, Ptr{obc_error}), surface, host, out, error)

const address_obc_mesh_search_destroy = Ref(C_NULL)
obc_mesh_search_destroy(search) =
    ccall(symbol(address_obc_mesh_search_destroy, :mesh, :obc_mesh_search_destroy), Cvoid, (Ptr{Cvoid},), search)

const address_obc_mesh_search_vertices = Ref(C_NULL)
obc_mesh_search_vertices(search, points, count, vertices, error) =
    ccall(symbol(address_obc_mesh_search_vertices, :mesh, :obc_mesh_search_vertices), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{UInt32}, Ptr{obc_error}), search, points, count, vertices, error)

const address_obc_mesh_search_surface = Ref(C_NULL)
obc_mesh_search_surface(search, points, count, triangles, weights, positions, distances, error) =
    ccall(symbol(address_obc_mesh_search_surface, :mesh, :obc_mesh_search_surface), Int32, (Ptr{Cvoid}, Ptr{Float64}, Csize_t, Ptr{UInt32}, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ptr{obc_error}), search, points, count, triangles, weights, positions, distances, error)

const address_obc_mesh_orientation_2d = Ref(C_NULL)
obc_mesh_orientation_2d(a, b, c) =
    ccall(symbol(address_obc_mesh_orientation_2d, :mesh, :obc_mesh_orientation_2d), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}), a, b, c)

const address_obc_mesh_orientation_3d = Ref(C_NULL)
obc_mesh_orientation_3d(a, b, c, d) =
    ccall(symbol(address_obc_mesh_orientation_3d, :mesh, :obc_mesh_orientation_3d), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}, Ptr{Float64}), a, b, c, d)

const address_obc_mesh_orientation_from_origin = Ref(C_NULL)
obc_mesh_orientation_from_origin(p, q, r) =
    ccall(symbol(address_obc_mesh_orientation_from_origin, :mesh, :obc_mesh_orientation_from_origin), Int32, (Ptr{Float64}, Ptr{Float64}, Ptr{Float64}), p, q, r)

const address_obc_mesh_version = Ref(C_NULL)
obc_mesh_version() =
    ccall(symbol(address_obc_mesh_version, :mesh, :obc_mesh_version), UInt32, ())
