"""
Orbicube: maps of surfaces to spheres and polycubes, harmonics, frame fields, and the solvers underneath. `Orbicube.Raw` has the C
functions as they are.
"""
module Orbicube

export OrbicubeError, EvaluationFailed, StopRun
export TrustRegion, ProjectedGradient, SphereOptimizer, optimize, least_squares, only_fg!, only_fg_and_hv!, project
export minimizer, converged, iterations, f_calls, stop_reason, report
export Run, ask!, tell!, asked_direction, tell_product!, result, multipliers, save, load
export relax, Relaxation, relax!
export LinearFactor, solve, refactor!, remove_row!, update!, entry_count, LinearIterations
export Surface, make_surface, read_surface, write_surface, topology, sphere_map, measure_map
export Mesh, formats, shape_names, read_mesh, write_mesh, check_cells, boundary, tetrahedron_quality, fill_with_tetrahedra, check_fillable
export repair_surface, surface_of_label
export check_closed_genus_zero, orient, intersections, first_at_same_position, Search, nearest_vertices, nearest_points
export vertex_normals, vertex_areas, surface_distance, mean_distance
export orientation_2d, orientation_3d, orientation_from_origin, read_gltf, write_gltf
export Locator, locate, sample, remesh, partial_sphere_map, face_distortion, round_to_float, sphere_grid
export image_size, geometry_image, image_surface, write_image, read_image, best_rotation, Warp, overlay
export fit_harmonics, refine_map, synthesize, evaluate_harmonics, harmonic_gradients, degree_norms, shape_distance, filter_harmonics
export rotate_harmonics, align_harmonics, write_harmonics, read_harmonics
export frame_field, measure_frames, frame_matchings, singularities, Quaternions
export PolycubeMap, polycube, polycube_on, certify_polycube, common_polycube, optimize_domain, optimize_corners, align_features
export energies, polycube_graph, polycube_quads, polycube_atlas
export Correspondence, blend, map_points
export untangle, refine_untangled, RefinedMesh, map_to_polycube, FrameMap, parameterize, SolidLocator, fill_with_hexahedra

using SparseArrays

include("raw.jl")
include("call.jl")
include("solvers.jl")
include("maps.jl")
include("meshes.jl")
include("spheres.jl")
include("frames.jl")
include("polycubes.jl")
include("correspondences.jl")
include("volumes.jl")
include("linear.jl")

end
