// What the C headers declare, with what their functions are told. Written by scripts/bindings.py; not to be edited.

/** An address in the module's memory. */
export type Pointer = number;

export const constants: {
  readonly OBC_OK: 0;
  readonly OBC_INVALID_ARGUMENT: -1;
  readonly OBC_MALFORMED_FILE: -2;
  readonly OBC_NOT_CLOSED: -3;
  readonly OBC_NOT_MANIFOLD: -4;
  readonly OBC_WRONG_GENUS: -5;
  readonly OBC_DEGENERATE: -6;
  readonly OBC_OUT_OF_MEMORY: -7;
  readonly OBC_CANCELLED: -8;
  readonly OBC_IO: -9;
  readonly OBC_UNSUPPORTED: -10;
  readonly OBC_NO_VALID_RESULT: -11;
  readonly OBC_INTERNAL: -12;
  readonly OBC_FRAME_FIELD_AUTO: 0;
  readonly OBC_FRAME_FIELD_IDENTITY: 1;
  readonly OBC_FRAME_FIELD_PROPAGATED: 2;
  readonly OBC_FRAME_FIELD_HARMONIC: 3;
  readonly OBC_FRAME_FIELD_DIFFUSION: 4;
  readonly OBC_FRAME_FIELD_GIVEN: 5;
  readonly OBC_FRAME_FIELD_SMOOTH: 0;
  readonly OBC_FRAME_FIELD_SEED: 1;
  readonly OBC_FRAME_FIELD_UNIFORM: 0;
  readonly OBC_FRAME_FIELD_GEOMETRIC: 1;
  readonly OBC_FRAME_FIELD_NO_REPAIR: 0;
  readonly OBC_FRAME_FIELD_REPAIR: 1;
  readonly OBC_FRAME_FIELD_SINGLE_AXIS: 2;
  readonly OBC_HARMONICS_AUTOMATIC: 0;
  readonly OBC_HARMONICS_DENSE: 1;
  readonly OBC_HARMONICS_ITERATIVE: 2;
  readonly OBC_HARMONICS_BY_ENDING: 0;
  readonly OBC_HARMONICS_SHTOOLS: 1;
  readonly OBC_HARMONICS_SPHARM_PDM: 2;
  readonly OBC_MESH_OBJ: 0;
  readonly OBC_MESH_OFF: 1;
  readonly OBC_MESH_PLY: 2;
  readonly OBC_MESH_STL: 3;
  readonly OBC_MESH_MEDIT: 4;
  readonly OBC_MESH_VTK: 5;
  readonly OBC_POLYCUBE_AUTO: 0;
  readonly OBC_POLYCUBE_LABELS: 1;
  readonly OBC_POLYCUBE_VOXELS: 2;
  readonly OBC_POLYCUBE_SURFACE_MEAN: 0;
  readonly OBC_POLYCUBE_FACE_MEAN: 1;
  readonly OBC_POLYCUBE_HARMONIC: 2;
  readonly OBC_POLYCUBE_TRUST_REGION: 0;
  readonly OBC_POLYCUBE_GRADIENT: 1;
  readonly OBC_PROJECTED_GRADIENT_FACE: 0;
  readonly OBC_PROJECTED_GRADIENT_SEED: 1;
  readonly OBC_PROJECTED_GRADIENT_LARGEST_OF_LAST: 0;
  readonly OBC_PROJECTED_GRADIENT_AVERAGE: 1;
  readonly OBC_PROJECTED_GRADIENT_NEED_FG: 1;
  readonly OBC_PROJECTED_GRADIENT_ITERATION: 2;
  readonly OBC_PROJECTED_GRADIENT_DONE: 3;
  readonly OBC_PROJECTED_GRADIENT_RUNNING: 0;
  readonly OBC_PROJECTED_GRADIENT_CONVERGED: 1;
  readonly OBC_PROJECTED_GRADIENT_TARGET_REACHED: 2;
  readonly OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET: 3;
  readonly OBC_PROJECTED_GRADIENT_ITERATION_BUDGET: 4;
  readonly OBC_PROJECTED_GRADIENT_STALLED: 5;
  readonly OBC_PROJECTED_GRADIENT_INFEASIBLE: 6;
  readonly OBC_PROJECTED_GRADIENT_CANCELLED: 7;
  readonly OBC_PROJECTED_GRADIENT_EVALUATION_FAILED: 8;
  readonly OBC_PROJECTED_GRADIENT_PROJECTION_FAILED: 9;
  readonly OBC_PROJECTED_GRADIENT_CONTINUE: 0;
  readonly OBC_PROJECTED_GRADIENT_STOP: 1;
  readonly OBC_PROJECTED_GRADIENT_FAILED: 2;
  readonly OBC_QUATERNION_CUBE_ORDER: 24;
  readonly OBC_QUATERNION_CUBE_NONE: 255;
  readonly OBC_QUATERNION_IDENTITY: 0;
  readonly OBC_QUATERNION_FACE_HALF: 1;
  readonly OBC_QUATERNION_FACE_QUARTER: 2;
  readonly OBC_QUATERNION_EDGE_HALF: 3;
  readonly OBC_QUATERNION_CORNER_THIRD: 4;
  readonly OBC_SPHERE_MAP_BALANCED: 0;
  readonly OBC_SPHERE_MAP_ANGLE_AREA: 1;
  readonly OBC_SPHERE_MAP_ISOMETRIC: 2;
  readonly OBC_SPHERE_MAP_STRETCH: 3;
  readonly OBC_SPHERE_MAP_CONFORMAL: 4;
  readonly OBC_SPHERE_MAP_SEED: 5;
  readonly OBC_SPHERE_MAP_ICOSPHERE: 0;
  readonly OBC_SPHERE_MAP_CUBE: 1;
  readonly OBC_SPHERE_MAP_LATITUDE: 2;
  readonly OBC_SPHERE_MAP_OCTAHEDRON: 3;
  readonly OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY: 0;
  readonly OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN: 1;
  readonly OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE: 2;
  readonly OBC_SPHERE_OPTIMIZER_SEED: 3;
  readonly OBC_SPHERE_OPTIMIZER_NEED_FG: 1;
  readonly OBC_SPHERE_OPTIMIZER_ITERATION: 2;
  readonly OBC_SPHERE_OPTIMIZER_DONE: 3;
  readonly OBC_SPHERE_OPTIMIZER_RUNNING: 0;
  readonly OBC_SPHERE_OPTIMIZER_CONVERGED: 1;
  readonly OBC_SPHERE_OPTIMIZER_TARGET_REACHED: 2;
  readonly OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET: 3;
  readonly OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET: 4;
  readonly OBC_SPHERE_OPTIMIZER_STALLED: 5;
  readonly OBC_SPHERE_OPTIMIZER_CANCELLED: 6;
  readonly OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED: 7;
  readonly OBC_SPHERE_OPTIMIZER_CONTINUE: 0;
  readonly OBC_SPHERE_OPTIMIZER_STOP: 1;
  readonly OBC_SPHERE_OPTIMIZER_FAILED: 2;
  readonly OBC_SPHERE_OPTIMIZER_AUTOMATIC: 0;
  readonly OBC_SPHERE_OPTIMIZER_QUEUE: 1;
  readonly OBC_SPHERE_OPTIMIZER_SWEEPS: 2;
  readonly OBC_TRUST_REGION_TWO_RADII: 0;
  readonly OBC_TRUST_REGION_SEED: 1;
  readonly OBC_TRUST_REGION_AUTOMATIC: 0;
  readonly OBC_TRUST_REGION_CHAIN: 1;
  readonly OBC_TRUST_REGION_CROSS: 2;
  readonly OBC_TRUST_REGION_NEED_VALUES: 1;
  readonly OBC_TRUST_REGION_ITERATION: 2;
  readonly OBC_TRUST_REGION_DONE: 3;
  readonly OBC_TRUST_REGION_RUNNING: 0;
  readonly OBC_TRUST_REGION_CONVERGED: 1;
  readonly OBC_TRUST_REGION_TARGET_REACHED: 2;
  readonly OBC_TRUST_REGION_EVALUATION_BUDGET: 3;
  readonly OBC_TRUST_REGION_NOISE_LIMIT: 4;
  readonly OBC_TRUST_REGION_STALLED: 5;
  readonly OBC_TRUST_REGION_CANCELLED: 6;
  readonly OBC_TRUST_REGION_EVALUATION_FAILED: 7;
  readonly OBC_TRUST_REGION_CONTINUE: 0;
  readonly OBC_TRUST_REGION_STOP: 1;
  readonly OBC_TRUST_REGION_FAILED: 2;
  readonly OBC_VOLUME_MAP_PADDING_AUTO: 0;
  readonly OBC_VOLUME_MAP_PADDING_WITH: 1;
  readonly OBC_VOLUME_MAP_PADDING_WITHOUT: 2;
  readonly OBC_VOLUME_MAP_METHOD_AUTO: 0;
  readonly OBC_VOLUME_MAP_METHOD_POLYCUBE: 1;
  readonly OBC_VOLUME_MAP_METHOD_VOXELS: 2;
};

export interface Layout {
  readonly size: number;
  readonly fields: Readonly<Record<string, readonly (string | number)[]>>;
}
export const layouts: {
  readonly obc_error: Layout;
  readonly obc_allocator: Layout;
  readonly obc_host: Layout;
  readonly obc_frame_field_solid: Layout;
  readonly obc_frame_field_options: Layout;
  readonly obc_frame_field_constraints: Layout;
  readonly obc_frame_field_report: Layout;
  readonly obc_gltf_read_options: Layout;
  readonly obc_gltf_morph_target: Layout;
  readonly obc_gltf_scene: Layout;
  readonly obc_harmonics_fit_options: Layout;
  readonly obc_harmonics_fit_report: Layout;
  readonly obc_harmonics_align_options: Layout;
  readonly obc_harmonics_alignment: Layout;
  readonly obc_surface: Layout;
  readonly obc_mesh_cells: Layout;
  readonly obc_mesh_tetrahedron_quality_report: Layout;
  readonly obc_mesh_read_options: Layout;
  readonly obc_mesh_write_options: Layout;
  readonly obc_mesh_topology_report: Layout;
  readonly obc_mesh_orient_report: Layout;
  readonly obc_polycube_certificate: Layout;
  readonly obc_polycube_options: Layout;
  readonly obc_polycube_domain_options: Layout;
  readonly obc_polycube_domain_report: Layout;
  readonly obc_polycube_corner_options: Layout;
  readonly obc_polycube_corner_report: Layout;
  readonly obc_polycube_feature_options: Layout;
  readonly obc_polycube_feature_report: Layout;
  readonly obc_polycube_places: Layout;
  readonly obc_polycube_quads_options: Layout;
  readonly obc_projected_gradient_problem: Layout;
  readonly obc_projected_gradient_options: Layout;
  readonly obc_projected_gradient_result: Layout;
  readonly obc_sphere_map_options: Layout;
  readonly obc_sphere_map_report: Layout;
  readonly obc_sphere_map_distance: Layout;
  readonly obc_sphere_optimizer_options: Layout;
  readonly obc_sphere_optimizer_result: Layout;
  readonly obc_sphere_optimizer_blocks: Layout;
  readonly obc_sphere_optimizer_relaxation_options: Layout;
  readonly obc_sphere_optimizer_relaxation_result: Layout;
  readonly obc_trust_region_problem: Layout;
  readonly obc_trust_region_options: Layout;
  readonly obc_trust_region_result: Layout;
  readonly obc_volume_map_tangle: Layout;
  readonly obc_volume_map_untangle_options: Layout;
  readonly obc_volume_map_untangle_report: Layout;
  readonly obc_volume_map_solid_options: Layout;
  readonly obc_volume_map_hexes_options: Layout;
  readonly obc_volume_map_hexes_report: Layout;
  readonly obc_volume_map_frame_options: Layout;
  readonly obc_volume_map_frame_report: Layout;
};
export const callbacks: Readonly<Record<string, string>>;
export const functions: Readonly<Record<keyof RawFunctions, string>>;

/** The C functions as they are. Functions and structs are given by their addresses. */
export interface RawFunctions {
  /** Fills a host with the defaults: nothing lent, one thread a core. */
  obc_host_init(host: Pointer, struct_size: number): number;
  /** Short English name of a status, such as "out of memory". Never NULL; a static string. */
  obc_status_name(status: number): Pointer;
  /** Version of the base library, major * 10000 + minor * 100 + patch. */
  obc_base_version(): number;
  /** Fill options, constraints and reports with the defaults, no constraints, and zeros. */
  obc_frame_field_options_init(options: Pointer, struct_size: number): number;
  /** Fill options, constraints and reports with the defaults, no constraints, and zeros. */
  obc_frame_field_constraints_init(constraints: Pointer, struct_size: number): number;
  /** Fill options, constraints and reports with the defaults, no constraints, and zeros. */
  obc_frame_field_report_init(report: Pointer, struct_size: number): number;
  /** Computes a field of small energy. frames: 4 * tetrahedron_count doubles, read with the start given, and written on success
   * only. options, constraints, host and report may be NULL. O(n), at most 1 KB a tetrahedron.
   * Errors: invalid argument (NULL, NaN, index out of range, options), degenerate (a repeated vertex), not manifold (a face of
   * three tetrahedra, neighbours on the same side of a face), out of memory, cancelled. */
  obc_frame_field_compute(solid: Pointer, options: Pointer, constraints: Pointer, host: Pointer, frames: Pointer, report: Pointer, error: Pointer): number;
  /** Figures of any field: frames, 4 * tetrahedron_count doubles, normalised before use. host may be NULL. O(n).
   * Errors: as _compute. */
  obc_frame_field_measure(solid: Pointer, frames: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** How the frames on both sides of the faces match: 4 * tetrahedron_count numbers, that at 4 t + k for the face of
   * tetrahedron t opposite its corner k: the rotation of the cube (its number in obc_quaternion_cube_element) that, in its own
   * axes, brings frame t next to that of the neighbour; 0 on the boundary. Errors: as _compute. O(n). */
  obc_frame_field_matchings(solid: Pointer, frames: Pointer, host: Pointer, matchings: Pointer, error: Pointer): number;
  /** The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
   * until _destroy. Errors: as _compute. O(n). */
  obc_frame_field_singularities_create(solid: Pointer, frames: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** The singular edges of a field and the curves that they form, in a handle. host may be NULL; its allocator must stay valid
   * until _destroy. Errors: as _compute. O(n). */
  obc_frame_field_singularities_destroy(singularities: Pointer): void;
  /** Numbers; 0 for NULL. */
  obc_frame_field_singular_edge_count(singularities: Pointer): number;
  /** Numbers; 0 for NULL. */
  obc_frame_field_singular_curve_count(singularities: Pointer): number;
  /** Numbers; 0 for NULL. */
  obc_frame_field_singular_node_count(singularities: Pointer): number;
  /** Copies to the caller's arrays, each of which may be NULL. Edges: two vertices each; their rotation of the cube around the
   * edge; their turn, 1 where hexahedra would meet in threes, -1 in fives, 2 for half turns, 0 where they cannot. Curves:
   * curve_begin (curve count + 1) says where each begins in curve_edges (edge count), the edges in order along it. Nodes: their
   * vertices. Errors: invalid argument. */
  obc_frame_field_singularities_copy(singularities: Pointer, edge_vertices: Pointer, edge_rotations: Pointer, edge_turns: Pointer, curve_begin: Pointer, curve_edges: Pointer, nodes: Pointer, error: Pointer): number;
  /** Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
   * vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
   * is locally meshable, and for NULL. */
  obc_frame_field_unmeshable_edge_count(singularities: Pointer): number;
  /** Where the field cannot be that of a hexahedral mesh: singular edges that are no quarter turns about an axis, and inner
   * vertices whose edges of threes and fives no hexahedral mesh has (turning points and nodes). Both counts are 0 when the field
   * is locally meshable, and for NULL. */
  obc_frame_field_unmeshable_vertex_count(singularities: Pointer): number;
  /** Copies them to the caller's arrays, each of which may be NULL: the edges as numbers of singular edges, the vertices as
   * indices of the solid's, both ascending. Errors: invalid argument. */
  obc_frame_field_unmeshable_copy(singularities: Pointer, edges: Pointer, vertices: Pointer, error: Pointer): number;
  /** Version of the library, major * 10000 + minor * 100 + patch. */
  obc_frame_field_version(): number;
  /** The defaults, which the members' comments give. */
  obc_gltf_read_options_init(options: Pointer, struct_size: number): number;
  /** Reads the file at `path` (bytes as the system takes them). options and host may be NULL; the host's allocator must stay
   * valid until _surface_destroy. Errors: io, malformed file (its kind says how: truncated, parse, index-range,
   * accessor-range, unsafe-path, ...), unsupported, degenerate (a transform or welding flattens everything), out of memory,
   * cancelled. O(n). */
  obc_gltf_read(path: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** The same from `size` bytes of a GLB or .gltf file, which are not kept; `folder` is where buffers in files of their own
   * lie, NULL refuses them. */
  obc_gltf_read_memory(bytes: Pointer, size: number, folder: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading. */
  obc_gltf_surface_vertex_count(surface: Pointer): number;
  /** Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading. */
  obc_gltf_surface_triangle_count(surface: Pointer): number;
  /** Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading. */
  obc_gltf_surface_welded_vertex_count(surface: Pointer): number;
  /** Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading. */
  obc_gltf_surface_note_count(surface: Pointer): number;
  /** The index-th note, UTF-8, of the surface's; NULL when there is none. */
  obc_gltf_surface_note(surface: Pointer, index: number): Pointer;
  /** Copies positions (3 * vertex_count, or NULL) and triangles (3 * triangle_count indices below vertex_count, or NULL;
   * counter-clockwise seen from outside) to the caller's arrays. Errors: invalid argument. */
  obc_gltf_surface_copy(surface: Pointer, positions: Pointer, triangles: Pointer, error: Pointer): number;
  /** Releases a surface; NULL is fine. */
  obc_gltf_surface_destroy(surface: Pointer): void;
  /** The defaults, which the members' comments give, and an empty surface. */
  obc_gltf_scene_init(scene: Pointer, struct_size: number): number;
  /** Writes to `path`: .gltf with the buffer inside when it ends so, GLB otherwise. The file appears once it is whole; after
   * an error the old one is still there. host may be NULL. Errors: invalid argument (sizes, indices, numbers that are not
   * finite, texts), unsupported (4 GiB or more), io, out of memory, cancelled. O(n). */
  obc_gltf_write(path: Pointer, scene: Pointer, host: Pointer, error: Pointer): number;
  /** A surface alone, with smooth normals: positions 3 * vertex_count, triangles 3 * triangle_count. */
  obc_gltf_write_surface(path: Pointer, positions: Pointer, vertex_count: number, triangles: Pointer, triangle_count: number, host: Pointer, error: Pointer): number;
  /** Morph targets to the bit. _delta is what is stored for a base and a wanted coordinate; _reconstructed is what a renderer
   * makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers. */
  obc_gltf_delta(base: number, wanted: number): number;
  /** Morph targets to the bit. _delta is what is stored for a base and a wanted coordinate; _reconstructed is what a renderer
   * makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers. */
  obc_gltf_reconstructed(base: number, delta: number): number;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_gltf_version(): number;
  /** Fills options with the defaults, and a report with zeros and its size. */
  obc_harmonics_fit_options_init(options: Pointer, struct_size: number): number;
  /** Fills options with the defaults, and a report with zeros and its size. */
  obc_harmonics_fit_report_init(report: Pointer, struct_size: number): number;
  /** (degree + 1)^2. */
  obc_harmonics_size(degree: number): number;
  /** Y_lm of every direction: rows, count * (degree+1)^2 doubles, a direction after the other. host may be NULL.
   * O(count * degree^2).
   * Errors: OBC_INVALID_ARGUMENT (NULL, not finite, length zero, degree), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_harmonics_evaluate(directions: Pointer, count: number, degree: number, host: Pointer, rows: Pointer, error: Pointer): number;
  /** The coefficients that fit values at scattered directions best: least squares with `weights`, one a direction and not
   * negative, or NULL for ones. For a surface, the weights of obc_harmonics_vertex_areas are the usual choice: each piece
   * counts by its own area.
   * options, host and report may be NULL. coefficients: written on success only. A rank-deficient fit is no error: see
   * report->rank.
   * Errors: as obc_harmonics_evaluate. */
  obc_harmonics_fit(directions: Pointer, weights: Pointer, values: Pointer, count: number, channels: number, options: Pointer, host: Pointer, coefficients: Pointer, report: Pointer, error: Pointer): number;
  /** The functions at the directions: values, count * channels doubles; and unless gradients is NULL, their gradients on the
   * sphere of radius 1, tangent vectors, 3 * count * channels doubles. O(count * degree^2 * channels).
   * Errors: as obc_harmonics_evaluate. */
  obc_harmonics_synthesize(coefficients: Pointer, degree: number, channels: number, directions: Pointer, count: number, host: Pointer, values: Pointer, gradients: Pointer, error: Pointer): number;
  /** A third of the area of its triangles for each vertex: areas, vertex_count doubles. Triangles are three vertex indices
   * each. O(n).
   * Errors: OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (kind index-range: no such vertex), OBC_OUT_OF_MEMORY. */
  obc_harmonics_vertex_areas(positions: Pointer, vertex_count: number, triangles: Pointer, triangle_count: number, host: Pointer, areas: Pointer, error: Pointer): number;
  /** The norm of each degree, sqrt(sum over m and the channels of the squares): norms, degree + 1 doubles. It does not change
   * when the sphere is turned, nor when the values of three channels are.
   * Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY. */
  obc_harmonics_degree_norms(coefficients: Pointer, degree: number, channels: number, norms: Pointer, error: Pointer): number;
  /** The distance D_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
   * difference of the norms; degrees that one of them does not have count as zero there. first = 0 is the dissertation's;
   * with first = 1 it does not matter where the shapes lie.
   * Errors: as obc_harmonics_degree_norms. */
  obc_harmonics_shape_distance(f: Pointer, f_degree: number, g: Pointer, g_degree: number, channels: number, first: number, last: number, distance: Pointer, error: Pointer): number;
  /** Filters in place: degrees from low to high stay, the others become zero, over `width` degrees outside of each end with a
   * raised cosine (0: at once). With keep_mean 1 degree 0 stays, which is where a shape lies.
   * Errors: as obc_harmonics_degree_norms. */
  obc_harmonics_filter(coefficients: Pointer, degree: number, channels: number, low: number, high: number, width: number, keep_mean: number, error: Pointer): number;
  /** The reconstruction error of section 3.3.2: e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the points of A of the
   * distance to the nearest point of B. O(n log n).
   * Errors: OBC_INVALID_ARGUMENT (NULL, no points, not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_harmonics_mean_distance(a: Pointer, a_count: number, b: Pointer, b_count: number, host: Pointer, distance: Pointer, error: Pointer): number;
  /** The functions turned with the sphere: what each has at direction v, it has at R v afterwards. rotation: the matrix R by
   * rows, 9 doubles. turned may be coefficients. The values are not turned: for a shape that turns in space, multiply the three
   * coefficients of each Y_lm by the matrix. O(degree^3).
   * Errors: OBC_INVALID_ARGUMENT (also: no rotation), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_harmonics_rotate(coefficients: Pointer, degree: number, channels: number, rotation: Pointer, host: Pointer, turned: Pointer, error: Pointer): number;
  /** Fills options with the defaults, and an alignment with zeros and its size. */
  obc_harmonics_align_options_init(options: Pointer, struct_size: number): number;
  /** Fills options with the defaults, and an alignment with zeros and its size. */
  obc_harmonics_alignment_init(alignment: Pointer, struct_size: number): number;
  /** The rotation that brings `moving` best into line with `fixed`: it maximises the sum over the channels of the integral of
   * fixed(u) * (Q moving)(R^-1 u), without degree 0. Found on a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
   * rotation group") and refined by Newton's method up to the lower of the two degrees. options and host may be NULL.
   * O(search_degree^4 + degree^3).
   * Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (one of them is constant), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_harmonics_align(fixed: Pointer, fixed_degree: number, moving: Pointer, moving_degree: number, channels: number, options: Pointer, host: Pointer, alignment: Pointer, error: Pointer): number;
  /** Writes a file, whole or not at all; read again, every number is the same to its last bits.
   * Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC_IO,
   * OBC_OUT_OF_MEMORY. The message starts with the path. */
  obc_harmonics_write(path: Pointer, format: number, coefficients: Pointer, degree: number, channels: number, error: Pointer): number;
  /** host may be NULL; its allocator must stay valid until _destroy. Nothing in a file is trusted.
   * Errors: OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with
   * the line), OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED, OBC_OUT_OF_MEMORY. The message starts with the path. */
  obc_harmonics_read(path: Pointer, format: number, host: Pointer, coefficients: Pointer, error: Pointer): number;
  /** 0 for NULL. */
  obc_harmonics_coefficients_degree(coefficients: Pointer): number;
  /** 0 for NULL. */
  obc_harmonics_coefficients_channels(coefficients: Pointer): number;
  /** Copies them out: (degree+1)^2 * channels doubles. Errors: OBC_INVALID_ARGUMENT. */
  obc_harmonics_coefficients_copy(coefficients: Pointer, values: Pointer, error: Pointer): number;
  /** NULL is fine. */
  obc_harmonics_coefficients_destroy(coefficients: Pointer): void;
  /** Version of the library, major * 10000 + minor * 100 + patch. */
  obc_harmonics_version(): number;
  /** A mesh of nothing. */
  obc_mesh_cells_init(cells: Pointer, struct_size: number): number;
  /** A mesh with copies of the arrays. host may be NULL; its allocator must stay valid until _destroy. Errors: invalid argument,
   * out of memory. O(n). */
  obc_mesh_create(cells: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** A closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc_mesh_shape_name lists them) of about
   * `triangle_count` triangles, two units in size; the seed varies it. Errors: invalid argument, out of memory, cancelled. O(n). */
  obc_mesh_make(shape: Pointer, triangle_count: number, seed: bigint, host: Pointer, out: Pointer, error: Pointer): number;
  /** Name of the index-th shape that obc_mesh_make knows, a static string; NULL beyond the last one. */
  obc_mesh_shape_name(index: number): Pointer;
  /** Releases a mesh; NULL is fine. */
  obc_mesh_destroy(mesh: Pointer): void;
  /** Numbers of a mesh; 0 for NULL. */
  obc_mesh_vertex_count(mesh: Pointer): number;
  /** Numbers of a mesh; 0 for NULL. */
  obc_mesh_triangle_count(mesh: Pointer): number;
  /** Numbers of a mesh; 0 for NULL. */
  obc_mesh_tetrahedron_count(mesh: Pointer): number;
  /** Numbers of a mesh; 0 for NULL. */
  obc_mesh_hexahedron_count(mesh: Pointer): number;
  /** Copies to the caller's arrays, each of which may be NULL. Errors: invalid argument. */
  obc_mesh_copy(mesh: Pointer, positions: Pointer, triangles: Pointer, tetrahedra: Pointer, hexahedra: Pointer, error: Pointer): number;
  /** A view of the mesh's own positions and triangles, valid until the mesh is destroyed. Errors: invalid argument. */
  obc_mesh_surface(mesh: Pointer, surface: Pointer, error: Pointer): number;
  /** Whether the tetrahedra and hexahedra fill a solid: distinct, positive by exact predicates (hexahedra at each corner), meeting
   * in whole faces, no face of three cells, no edge where parts only touch. OBC_OK, also without cells; or degenerate or not
   * manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
   * first place; out of memory, cancelled. O(n log n). */
  obc_mesh_check_cells(mesh: Pointer, host: Pointer, error: Pointer): number;
  /** The surface of the solid that the cells fill, looking outward, as a mesh of its own with the same vertices: the faces of one
   * cell only, those of hexahedra cut in two. Errors: invalid argument, not manifold (a face of three cells), out of memory,
   * cancelled. O(n log n). */
  obc_mesh_boundary(mesh: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** An empty report that knows its size. */
  obc_mesh_tetrahedron_quality_report_init(report: Pointer, struct_size: number): number;
  /** Measures the tetrahedra of a mesh, whatever they are. Errors: invalid argument, cancelled. O(n). */
  obc_mesh_tetrahedron_quality(mesh: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_mesh_read_options_init(options: Pointer, struct_size: number): number;
  /** Reads the file at `path` (bytes as the system takes them), its format by its ending: .obj .off .ply .stl .mesh .vtk.
   * Vertices keep their order unless they are joined; faces of more corners are cut into triangles; cells are checked as by
   * obc_mesh_check_cells. options and host may be NULL; the host's allocator must stay valid until _destroy. Nothing in a file
   * is trusted; memory is bounded by a multiple of its size. Errors: io, malformed file (the kind says how: truncated, parse,
   * index-range, non-finite, ...; the message where), the kinds of cells, unsupported, out of memory, cancelled. O(size). */
  obc_mesh_read(path: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** The same from `size` bytes of a file of the format OBC_MESH_...; they are not kept. */
  obc_mesh_read_memory(bytes: Pointer, size: number, format: number, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
   * joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
   * Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read. */
  obc_mesh_format(mesh: Pointer): Pointer;
  /** What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
   * joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
   * Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read. */
  obc_mesh_polygon_count(mesh: Pointer): number;
  /** What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
   * joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
   * Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read. */
  obc_mesh_welded_vertex_count(mesh: Pointer): number;
  /** What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
   * joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
   * Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read. */
  obc_mesh_note(mesh: Pointer, index: number): Pointer;
  /** The defaults, which the members' comments give. */
  obc_mesh_write_options_init(options: Pointer, struct_size: number): number;
  /** Writes to `path`, the format by its ending: triangles to OBJ, OFF, PLY and STL, cells too to MEDIT and VTK. What is read
   * again is the same mesh to the bit, but for STL, which has float32. The file appears once it is whole; after an error the
   * old one is still there. options and host may be NULL. Errors: invalid argument, unsupported (the ending, or cells that the
   * format cannot hold), io, out of memory, cancelled. O(n). */
  obc_mesh_write(path: Pointer, mesh: Pointer, options: Pointer, host: Pointer, error: Pointer): number;
  /** The same for a surface in the caller's arrays. */
  obc_mesh_write_surface(path: Pointer, surface: Pointer, options: Pointer, host: Pointer, error: Pointer): number;
  /** An empty report that knows its size. */
  obc_mesh_topology_report_init(report: Pointer, struct_size: number): number;
  /** Examines any set of triangles. host may be NULL. Errors: invalid argument, out of memory, cancelled. O(n log n) time, O(n)
   * for bounded valence (0.1 s for a million triangles), up to 100 bytes a triangle. */
  obc_mesh_topology(surface: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** Whether the surface is what sphere maps need: closed, connected, manifold, consistently oriented, of genus 0. OBC_OK, or not
   * closed, not manifold, wrong genus or degenerate with the kind and the first place in `error`; invalid argument, out of
   * memory, cancelled. Costs what obc_mesh_topology costs. */
  obc_mesh_check_closed_genus_zero(surface: Pointer, host: Pointer, error: Pointer): number;
  /** An empty report that knows its size. */
  obc_mesh_orient_report_init(report: Pointer, struct_size: number): number;
  /** Turns triangles in place so that neighbours agree, the fewer of each part, and then all of them when the surface is closed
   * and its volume negative. report may be NULL. Errors: invalid argument, not manifold (non-orientable; nothing is changed
   * then), out of memory, cancelled. O(n). */
  obc_mesh_orient(positions: Pointer, vertex_count: number, triangles: Pointer, triangle_count: number, host: Pointer, report: Pointer, error: Pointer): number;
  /** For each vertex the lowest vertex at its very position (-0 is 0), vertex_count entries. Errors: invalid argument, out of
   * memory, cancelled. O(n). */
  obc_mesh_first_at_same_position(positions: Pointer, vertex_count: number, host: Pointer, first: Pointer, error: Pointer): number;
  /** Pairs of triangles that have more in common than the vertices they share by number, decided by exact predicates: the first
   * `capacity` pairs in ascending order, two entries each, the lower triangle first; *count is how many were written. Triangles
   * without area are left out. Works on the host's threads. Errors: invalid argument, out of memory, cancelled. O(n log n +
   * pairs whose boxes overlap). */
  obc_mesh_intersections(surface: Pointer, host: Pointer, pairs: Pointer, capacity: number, count: Pointer, error: Pointer): number;
  /** Copies the surface. host may be NULL; its allocator must stay valid until _destroy. Errors: invalid argument (also: a coordinate
   * beyond 1e150, here and in points), out of memory, cancelled. O(n log n), about 200 bytes a triangle. */
  obc_mesh_search_create(surface: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Releases a search; NULL is fine. */
  obc_mesh_search_destroy(search: Pointer): void;
  /** For each of `count` points (3 * count doubles) the nearest vertex, the lowest of equals. Errors: invalid argument (also: a
   * point that is not finite, no vertices). O(log n) a point on average. */
  obc_mesh_search_vertices(search: Pointer, points: Pointer, count: number, vertices: Pointer, error: Pointer): number;
  /** For each of `count` points the nearest point of the surface: its triangle (the lowest of equals), its weights at the
   * triangle's corners (3 * count, none negative, sum 1), its position (3 * count) and its distance; each array may be NULL.
   * Errors: invalid argument (also: a point that is not finite, no triangles). O(log n) a point on average. */
  obc_mesh_search_surface(search: Pointer, points: Pointer, count: number, triangles: Pointer, weights: Pointer, positions: Pointer, distances: Pointer, error: Pointer): number;
  /** Sign of (b - a) x (c - a): 1 when the triangle a, b, c of the plane is counter-clockwise. */
  obc_mesh_orientation_2d(a: Pointer, b: Pointer, c: Pointer): number;
  /** Sign of det[b - a, c - a, d - a]: 1 when the tetrahedron a, b, c, d has positive volume. */
  obc_mesh_orientation_3d(a: Pointer, b: Pointer, c: Pointer, d: Pointer): number;
  /** Sign of det[p, q, r]: 1 when p, q, r are counter-clockwise seen from outside a sphere around the origin. */
  obc_mesh_orientation_from_origin(p: Pointer, q: Pointer, r: Pointer): number;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_mesh_version(): number;
  /** Certifies a map made elsewhere: `surface` in space, `polycube` where its vertices are to be on the polycube (x y z a vertex).
   * certificate may be NULL; it is filled whether the map is valid or not. Errors: invalid argument (an index out of range, a
   * position that is not finite), no valid result (the message is the reason), out of memory, cancelled. O(n log n) unless there
   * are thousands of corners. */
  obc_polycube_create(surface: Pointer, polycube: Pointer, host: Pointer, certificate: Pointer, out: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_polycube_options_init(options: Pointer, struct_size: number): number;
  /** Finds a polycube of a closed surface of any genus, and a map to it. Edges are split where that is needed; the vertices of
   * the surface come first. The polycube has about the size of the surface. What is tried depends on the surface and the options
   * alone, never on time.
   * Errors: invalid argument; not closed, not manifold, degenerate, malformed file (kind empty-mesh: no triangles); no valid
   * result with what became of each attempt; out of memory, cancelled. */
  obc_polycube_compute(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_polycube_domain_options_init(options: Pointer, struct_size: number): number;
  /** The polycube with the best proportions: distances between the planes of its faces that minimise the map's distortion, vertices
   * going with the planes beside them (the dissertation's section 4.3, by a projected gradient method over the logarithms of the
   * distances). Combinatorics, order of the planes and total area stay. The result is certified again; it is a copy of `map` to
   * the bit when nothing better is found. report may be NULL, here and below. Errors: invalid argument, out of memory, cancelled.
   * O(n log n). */
  obc_polycube_optimize_domain(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_polycube_corner_options_init(options: Pointer, struct_size: number): number;
  /** A less distorted map to the same polycube: what of the surface goes to its corners moves, in the map's own unfolding around
   * each, and with it the polycube's edges on the surface and all between (the dissertation's section 4.4). Edges of triangles
   * are split where the polycube's are drawn; added vertices that serve none any more may go. Certified again; a copy of `map`
   * to the bit when nothing better is found. Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_optimize_corners(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_polycube_feature_options_init(options: Pointer, struct_size: number): number;
  /** A map to the same polycube with features in their places, and all else as little distorted as that allows. Certified again.
   * Errors: invalid argument (a place that is not on the polycube, a vertex with two); no valid result, with what cannot be met;
   * out of memory, cancelled. */
  obc_polycube_meet_features(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** The energies of the optimisation that a map comes from: before it, then after each iteration; 0 for NULL and maps that come from
   * none. */
  obc_polycube_energy_count(map: Pointer): number;
  /** Copies them to the caller's array, which may be NULL. Errors: invalid argument. */
  obc_polycube_copy_energies(map: Pointer, energies: Pointer, error: Pointer): number;
  /** Releases a map; NULL is fine. */
  obc_polycube_destroy(map: Pointer): void;
  /** Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added. */
  obc_polycube_vertex_count(map: Pointer): number;
  /** Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added. */
  obc_polycube_triangle_count(map: Pointer): number;
  /** Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added. */
  obc_polycube_corner_count(map: Pointer): number;
  /** Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added. */
  obc_polycube_patch_count(map: Pointer): number;
  /** What found the map: OBC_POLYCUBE_LABELS or OBC_POLYCUBE_VOXELS; -1 for a map made elsewhere, and for NULL. */
  obc_polycube_construction(map: Pointer): number;
  /** Copies to the caller's arrays, each of which may be NULL: positions in space (x y z a vertex; the surface's vertices first, to
   * the bit), polycube positions, triangles (three vertices each). Errors: invalid argument. */
  obc_polycube_copy(map: Pointer, positions: Pointer, polycube: Pointer, triangles: Pointer, error: Pointer): number;
  /** Copies what is known of each triangle, each array may be NULL: the direction it looks in on the polycube (0 to 5 for +x, -x, +y,
   * -y, +z, -z), its face of the polycube, and the surface's triangle that it lies in. Errors: invalid argument. */
  obc_polycube_copy_triangles(map: Pointer, labels: Pointer, patches: Pointer, sources: Pointer, error: Pointer): number;
  /** Copies where each vertex comes from, three entries a vertex, each array may be NULL: vertices of one triangle of the surface
   * (UINT32_MAX where fewer than three are needed) and their weights, positive (0 where not needed) with the sum 1. Errors:
   * invalid argument. */
  obc_polycube_copy_sources(map: Pointer, corners: Pointer, weights: Pointer, error: Pointer): number;
  /** Maps a surface to a polycube that is given by its triangles, each in an axis-aligned plane. It is drawn on the surface, as
   * OBC_POLYCUBE_VOXELS does with its own: where it stands, its box stretched to that of the surface, or where the places say.
   * The handle's polycube has the very coordinates of the one given; the map is smoothed across its edges. places may be NULL.
   * Errors: those of obc_polycube_compute; invalid argument for places that do not exist or are given twice; unsupported when the
   * polycube is none, with the reason; wrong genus when the surface has another. */
  obc_polycube_compute_on(surface: Pointer, polycube: Pointer, places: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** One polycube for several shapes of one genus and kind (the dissertation's section 4.5): several polycubes of each are drawn on
   * all others, proportions and maps are optimised for the sum of energies, and the one with the least sum is kept. Maps between
   * shapes are compositions: what is at one point of the polycube corresponds. options are for each shape's own polycube, domain
   * for the energy. out is an array of `count` handles, in the order of the surfaces, all NULL after an error; made_for may be NULL
   * or gets the number of the shape that the polycube was made for. obc_polycube_copy_energies of each handle gives the sums,
   * which never rise. Errors: those of obc_polycube_compute, and wrong genus. */
  obc_polycube_compute_common(surfaces: Pointer, count: number, options: Pointer, domain: Pointer, host: Pointer, made_for: Pointer, out: Pointer, error: Pointer): number;
  /** obc_polycube_optimize_domain for several maps to one and the same polycube: the proportions with the least sum of energies.
   * out is an array of `count` handles, all NULL after an error. Errors: invalid argument (among them maps to different
   * polycubes), out of memory, cancelled. */
  obc_polycube_optimize_common_domain(maps: Pointer, count: number, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_graph_create(map: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Releases a graph; NULL is fine. */
  obc_polycube_graph_destroy(graph: Pointer): void;
  /** Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
   * from both ends. */
  obc_polycube_graph_corner_count(graph: Pointer): number;
  /** Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
   * from both ends. */
  obc_polycube_graph_edge_count(graph: Pointer): number;
  /** Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
   * from both ends. */
  obc_polycube_graph_patch_count(graph: Pointer): number;
  /** Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
   * from both ends. */
  obc_polycube_graph_loop_count(graph: Pointer): number;
  /** Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
   * from both ends. */
  obc_polycube_graph_link_count(graph: Pointer): number;
  /** Copies to the caller's arrays, each of which may be NULL, as in all these functions. Of each corner its position (x y z) and
   * its vertex of the map. Errors: invalid argument. */
  obc_polycube_graph_copy_corners(graph: Pointer, positions: Pointer, vertices: Pointer, error: Pointer): number;
  /** Of each edge: its two corners, the patches on the left and on the right of the way from the first to the second, seen from
   * outside, and whether the solid has one right angle there (1, convex) or three (0, concave). */
  obc_polycube_graph_copy_edges(graph: Pointer, corners: Pointer, patches: Pointer, convex: Pointer, error: Pointer): number;
  /** Of each patch, which has the number that obc_polycube_copy_triangles gives: the direction it looks in (0 to 5 for +x, -x, +y,
   * -y, +z, -z), the coordinate of its plane, and where its loops begin among all loops: first the one around it, then those
   * around its holes; loop_starts has an entry more than there are patches. */
  obc_polycube_graph_copy_patches(graph: Pointer, labels: Pointer, coordinates: Pointer, loop_starts: Pointer, error: Pointer): number;
  /** Of each loop where it begins among all darts, with an entry more than there are loops, and its darts, counter-clockwise around
   * the patch: dart 2 e is edge e from its first corner to its second, dart 2 e + 1 the way back. Each dart is in one loop. */
  obc_polycube_graph_copy_loops(graph: Pointer, starts: Pointer, darts: Pointer, error: Pointer): number;
  /** The dual graph: where the neighbours of each patch begin, with an entry more than there are patches, and the patches that
   * share an edge with it, ascending. */
  obc_polycube_graph_copy_dual(graph: Pointer, starts: Pointer, neighbours: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_polycube_quads_options_init(options: Pointer, struct_size: number): number;
  /** Makes the grid, with integer numbers of cells between neighbouring planes, and takes its vertices to the surface, each
   * in the triangle that has it by exact arithmetic. Depends on the polycube alone, but for positions: maps to one polycube give
   * the same quads. Errors: invalid argument (among them more than 10^8 quads), out of memory, cancelled. */
  obc_polycube_quads_create(map: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Releases quads; NULL is fine. */
  obc_polycube_quads_destroy(quads: Pointer): void;
  /** Numbers; 0 for NULL. */
  obc_polycube_quads_vertex_count(quads: Pointer): number;
  /** Numbers; 0 for NULL. */
  obc_polycube_quads_quad_count(quads: Pointer): number;
  /** Copies to the caller's arrays, each of which may be NULL: of each vertex its position on the surface and on the polycube (x y
   * z), of each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument. */
  obc_polycube_quads_copy(quads: Pointer, positions: Pointer, polycube: Pointer, corners: Pointer, patches: Pointer, error: Pointer): number;
  /** Of each vertex the triangle of the map that it is in and its weights at the three corners, none negative, with the sum 1. */
  obc_polycube_quads_copy_sources(quads: Pointer, triangles: Pointer, weights: Pointer, error: Pointer): number;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_polycube_version(): number;
  /** An empty problem: n = m = 0, no bounds. */
  obc_projected_gradient_problem_init(problem: Pointer, struct_size: number): number;
  /** The defaults, which the members' comments give. */
  obc_projected_gradient_options_init(options: Pointer, struct_size: number): number;
  /** Makes a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
   * host points at must stay valid until _destroy. Errors: invalid argument, out of memory. An empty feasible set is not an
   * error here: the first step ends the run as INFEASIBLE. */
  obc_projected_gradient_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Goes on to the next request: NEED_FG, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a defect.
   * *x (x may be NULL) is the point that is asked about, n entries of the solver's, valid until its next call. While a
   * request waits for _tell, and after DONE, the answer stays the same. */
  obc_projected_gradient_step(solver: Pointer, x: Pointer): number;
  /** Answers NEED_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be
   * NULL then. Errors: invalid argument when nothing was asked. */
  obc_projected_gradient_tell(solver: Pointer, value: number, gradient: Pointer, error: Pointer): number;
  /** What is known now, at any time: result (or NULL), and x (n entries, or NULL), which is the iterate that met the tolerance
   * if the run CONVERGED, else the lowest feasible point evaluated, and before that the projected start. */
  obc_projected_gradient_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer): number;
  /** Multipliers t of the rows (m entries) at the current iterate: at a solution gradient - A't is zero where
   * lower < x < upper, not negative at lower and not positive at upper. */
  obc_projected_gradient_multipliers(solver: Pointer, multipliers: Pointer, error: Pointer): number;
  /** After INFEASIBLE: m numbers c with c'A x < c'b for every x within the bounds (Farkas), where entries of A'c that are
   * rounding (1e-9 of the length of c) count as zero against an infinite bound. certificate_gap of the result is
   * c'b - max c'A x > 0. Invalid argument after any other end. */
  obc_projected_gradient_certificate(solver: Pointer, certificate: Pointer, error: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
   * (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
   * order. Errors: invalid argument (another problem), malformed file (damaged, or of another version). */
  obc_projected_gradient_save_size(solver: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
   * (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
   * order. Errors: invalid argument (another problem), malformed file (damaged, or of another version). */
  obc_projected_gradient_save(solver: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
   * (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
   * order. Errors: invalid argument (another problem), malformed file (damaged, or of another version). */
  obc_projected_gradient_load(problem: Pointer, blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Releases a solver; NULL is fine. */
  obc_projected_gradient_destroy(solver: Pointer): void;
  /** The loop over step with a callback: x (n entries) holds the start and gets what _get_result hands out; result may be
   * NULL. Answers OBC_OK however the run ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and result
   * are filled then as well. */
  obc_projected_gradient_minimize(problem: Pointer, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** The projection alone: x (n entries, not y) is the point of the feasible set nearest to y. Box: clipping. One row: a root
   * of a monotone piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh
   * 2018). multipliers (m entries, or NULL) gets t with x = clip(y + A't), up to a last correction along the free unknowns
   * where y is so large that t cannot resolve it. Of result (or NULL) stop, equality_residual, projection_passes and
   * certificate_gap are filled: stop is CONVERGED, PROJECTION_FAILED, or INFEASIBLE, when multipliers gets the certificate. */
  obc_projected_gradient_project(problem: Pointer, y: Pointer, x: Pointer, multipliers: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** English name of a stop, such as "evaluation budget". Never NULL; a static string. */
  obc_projected_gradient_stop_name(stop: number): Pointer;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_projected_gradient_version(): number;
  /** out = p q (Hamilton), quaternions of any length; out may be p or q. */
  obc_quaternion_multiply(p: Pointer, q: Pointer, out: Pointer): void;
  /** out = q^-1 = conjugate / |q|^2, of any length but zero (which gives what is not finite). */
  obc_quaternion_inverse(q: Pointer, out: Pointer): void;
  /** out = q / |q|, also where |q|^2 would overflow or underflow. Zero gives what is not a number. */
  obc_quaternion_normalize(q: Pointer, out: Pointer): void;
  /** out = e^q, of any quaternion. The rotation by |v| about v is the exponential of (0, v / 2). */
  obc_quaternion_exponential(q: Pointer, out: Pointer): void;
  /** Principal logarithm: out = (log |q|, axis * angle), angle from 0 to pi, so that the exponential of it is q. Where q is
   * real and negative the axis is x. w is -infinity for zero. */
  obc_quaternion_logarithm(q: Pointer, out: Pointer): void;
  /** Spherical linear interpolation (Shoemake 1985) along the shorter arc between the rotations: p at t = 0, q or -q (the same
   * rotation) at t = 1; t outside 0 to 1 goes on along the great circle. */
  obc_quaternion_slerp(p: Pointer, q: Pointer, t: number, out: Pointer): void;
  /** The mean rotation: mean (4 doubles) maximises sum w_i (mean . q_i)^2, the dominant eigenvector of sum w_i q_i q_i'
   * (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q_i do not matter; mean is on the side of the first q_i of positive
   * weight. weights: count of them, finite, not negative, not all zero; or NULL, all 1. *agreement (or NULL) is
   * sum w_i (mean . q_i)^2 / sum w_i, 1 where all agree. Errors: invalid argument; no valid result when the mean is not
   * unique, as of two opposite rotations. */
  obc_quaternion_average(q: Pointer, weights: Pointer, count: number, mean: Pointer, agreement: Pointer, error: Pointer): number;
  /** out turns v: out = q v q^-1. out may be v. */
  obc_quaternion_rotate(q: Pointer, v: Pointer, out: Pointer): void;
  /** The rotation by angle about axis, which needs no unit length. Errors: invalid argument (axis zero or not finite). */
  obc_quaternion_from_axis_angle(axis: Pointer, angle: number, out: Pointer, error: Pointer): number;
  /** Unit axis (3 doubles) and *angle from 0 to pi; (1, 0, 0) and 0 for no rotation. */
  obc_quaternion_to_axis_angle(q: Pointer, axis: Pointer, angle: Pointer): void;
  /** The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles. */
  obc_quaternion_from_rotation_vector(v: Pointer, out: Pointer): void;
  /** The rotation by |v| about v, and back with |v| at most pi. Accurate to the least angles. */
  obc_quaternion_to_rotation_vector(q: Pointer, out: Pointer): void;
  /** The matrix (9 doubles, by rows) of q. */
  obc_quaternion_to_matrix(q: Pointer, out: Pointer): void;
  /** The quaternion, first component that is not zero positive, of a rotation matrix; accurate for every rotation (of the
   * four formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the unit
   * matrix to 1e-6 and R is no reflection. */
  obc_quaternion_from_matrix(matrix: Pointer, out: Pointer, error: Pointer): number;
  /** The rotation nearest to any 3x3 matrix in the Frobenius norm, also the one that maximises trace(R'M) (Davenport's
   * q-method): for a rotation with noise, or for vectors to be made orthonormal. Errors: no valid result when M is not
   * finite or two rotations are equally near. */
  obc_quaternion_nearest_to_matrix(matrix: Pointer, out: Pointer, error: Pointer): number;
  /** The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
   * Errors: invalid argument for 24 and more. */
  obc_quaternion_cube_element(number: number, out: Pointer, error: Pointer): number;
  /** The unit quaternion (first component that is not zero positive) of a number; and its matrix, entries 0, 1 or -1 exactly.
   * Errors: invalid argument for 24 and more. */
  obc_quaternion_cube_matrix(number: number, out: Pointer, error: Pointer): number;
  /** Number of the product a b (b first), and of the inverse of a, read from tables; OBC_QUATERNION_CUBE_NONE when a number is
   * out of range. */
  obc_quaternion_cube_product(a: number, b: number): number;
  /** Number of the product a b (b first), and of the inverse of a, read from tables; OBC_QUATERNION_CUBE_NONE when a number is
   * out of range. */
  obc_quaternion_cube_inverse(a: number): number;
  /** Conjugacy class of a number, or -1 when it is out of range. */
  obc_quaternion_cube_class(number: number): number;
  /** Number of the cube's rotation nearest to r (of any length but zero), without a search: of the sorted magnitudes
   * a1 >= a2 >= a3 >= a4 of its components the largest of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2 tells the kind,
   * the signs tell which. Of equally near ones, the first kind in this order, then the first components. */
  obc_quaternion_cube_nearest(r: Pointer): number;
  /** The distance, in radians. Zero to the last bit for p = q, else accurate to a few 1e-16. */
  obc_quaternion_symmetric_distance(p: Pointer, q: Pointer): number;
  /** sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10). */
  obc_quaternion_symmetric_sine_square(p: Pointer, q: Pointer): number;
  /** Number of the g for which from g is nearest to the frame `to`: to ~ from g. */
  obc_quaternion_symmetric_matching(from: Pointer, to: Pointer): number;
  /** out[i] = p[i] q[i] */
  obc_quaternion_multiply_array(p: Pointer, q: Pointer, count: number, out: Pointer): void;
  /** out[i] = p[i] q[i] */
  obc_quaternion_normalize_array(q: Pointer, count: number, out: Pointer): void;
  /** v[i] by q[i] */
  obc_quaternion_rotate_array(q: Pointer, v: Pointer, count: number, out: Pointer): void;
  /** v[i] by q[i] */
  obc_quaternion_slerp_array(p: Pointer, q: Pointer, t: Pointer, count: number, out: Pointer): void;
  /** v[i] by q[i] */
  obc_quaternion_to_matrix_array(q: Pointer, count: number, out: Pointer): void;
  /** Errors: invalid argument with the number of the first matrix that is no rotation; the quaternions before it are written. */
  obc_quaternion_from_matrix_array(matrices: Pointer, count: number, out: Pointer, error: Pointer): number;
  /** Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i]). */
  obc_quaternion_symmetric_distance_array(p: Pointer, q: Pointer, count: number, out: Pointer): void;
  /** Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i]). */
  obc_quaternion_symmetric_sine_square_array(p: Pointer, q: Pointer, count: number, out: Pointer): void;
  /** Distance, sin^2 of half of it, and matching of each pair p[i], q[i] (from[i], to[i]). */
  obc_quaternion_symmetric_matching_array(from: Pointer, to: Pointer, count: number, out: Pointer): void;
  /** Number of the cube's rotation nearest to each r[i]. */
  obc_quaternion_cube_nearest_array(r: Pointer, count: number, out: Pointer): void;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_quaternion_version(): number;
  /** Fills options with the defaults. */
  obc_sphere_map_options_init(options: Pointer, struct_size: number): number;
  /** Fills a report with zeros and its size, which obc_sphere_map_compute and _measure need. */
  obc_sphere_map_report_init(report: Pointer, struct_size: number): number;
  /** Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. A surface that looks
   * inward is mapped as seen from outside: its triangles are then clockwise on the sphere. Vertices in no triangle get some
   * unit vector.
   * options, report and host may be NULL. directions: 3 * vertex_count doubles, written on success only.
   * O(n log n) time, at most 1 KB a vertex.
   * Errors: OBC_INVALID_ARGUMENT (NULL, NaN, index out of range, options), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD,
   * OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_compute(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, report: Pointer, error: Pointer): number;
  /** As obc_sphere_map_compute, and when that ends with OBC_NO_VALID_RESULT or OBC_CANCELLED, directions get what there is of the
   * map that came furthest: *placed vertices have places of their own, and their triangles are positive by exact arithmetic
   * (clockwise for a surface that looks inward); each other vertex is where the one is that it was merged into, so that its
   * triangles have no area. With *placed as many as there are vertices in triangles it is a bijection that is not optimised to
   * the end. *placed is 0, and directions are untouched, when the work did not come so far and for other errors. report is
   * written on success only; obc_sphere_map_measure measures partial maps.
   * Errors: as obc_sphere_map_compute. */
  obc_sphere_map_compute_partial(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, placed: Pointer, report: Pointer, error: Pointer): number;
  /** Measures a map: directions (3 * vertex_count doubles, normalised before use) of the surface. Only the weights of
   * options are used; options and host may be NULL. O(n).
   * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. A bad map is no error: see report->bijective. */
  obc_sphere_map_measure(surface: Pointer, directions: Pointer, options: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** Distortion of each triangle, for colouring: dilatation and area_ratio as in the report, triangle_count doubles each;
   * either may be NULL. Triangles without surface area have an infinite dilatation and the ratio 0. O(n).
   * Errors: as obc_sphere_map_measure. */
  obc_sphere_map_face_distortion(surface: Pointer, directions: Pointer, host: Pointer, dilatation: Pointer, area_ratio: Pointer, error: Pointer): number;
  /** Rounds a map to float32, the precision of engines and of GLB, and repairs the triangles that this turns over by moving
   * their vertices to nearby points. rounded: 3 * vertex_count floats, positive by exact arithmetic on success.
   * Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the map cannot be held in float32), OBC_CANCELLED,
   * OBC_OUT_OF_MEMORY. */
  obc_sphere_map_round_to_float(surface: Pointer, directions: Pointer, host: Pointer, rounded: Pointer, error: Pointer): number;
  /** From a map that is a bijection (every triangle positive by exact arithmetic, or every triangle negative), with directions
   * of length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its
   * allocator is kept until obc_sphere_map_locator_destroy. O(n) time, about 100 bytes a vertex.
   * Errors: OBC_INVALID_ARGUMENT (also for what is no bijection), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_DEGENERATE,
   * OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_locator_create(surface: Pointer, directions: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** NULL is fine. */
  obc_sphere_map_locator_destroy(locator: Pointer): void;
  /** For each direction the triangle that it lies in, exactly; on an edge or a vertex, the lowest of the triangles there. weights:
   * where the ray along the direction meets the flat triangle of the map, as shares of its three corners, not negative, with
   * the sum 1; exactly 0 where the direction lies on the opposite edge. triangles: count indices, or NULL; weights: 3 * count
   * doubles, or NULL. On the threads of the host (or NULL). On failure what is written is of no use.
   * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_locate(locator: Pointer, directions: Pointer, count: number, host: Pointer, triangles: Pointer, weights: Pointer, error: Pointer): number;
  /** Positions, normals, colours or other values of the vertices, interpolated where each direction lies. values: components *
   * vertex_count doubles; sampled: components * count. With unit 1 each result is scaled to length 1 (for normals), with 0
   * not. The direction of a vertex gives the vertex's own values.
   * Errors: as obc_sphere_map_locate. */
  obc_sphere_map_sample(locator: Pointer, directions: Pointer, count: number, values: Pointer, components: number, unit: number, host: Pointer, sampled: Pointer, error: Pointer): number;
  /** Unit normals of the vertices, 3 * vertex_count doubles: the triangles' normals weighted by their angles (Thuermer and
   * Wuethrich 1998). O(n).
   * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_vertex_normals(surface: Pointer, host: Pointer, normals: Pointer, error: Pointer): number;
  /** The triangulation alone, positions being unit vectors. *out is released with obc_mesh_destroy; host's allocator is kept until
   * then. O(size). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_grid(grid: number, resolution: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** The surface resampled on a triangulation: positions (3 * vertex_count doubles) at its directions. Else as
   * obc_sphere_map_grid. */
  obc_sphere_map_remesh(locator: Pointer, positions: Pointer, grid: number, resolution: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Fills a result with zeros and its size. */
  obc_sphere_map_distance_init(distance: Pointer, struct_size: number): number;
  /** On the threads of the host. O(n log n). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_surface_distance(first: Pointer, second: Pointer, host: Pointer, distance: Pointer, error: Pointer): number;
  /** Geometry images (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 * width * height doubles,
   * row by row from the top. OBC_SPHERE_MAP_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC_SPHERE_MAP_CUBE six tiles
   * of as many, 3 by 2: +x -x +y, below -y +z -z. Pixels that the cut tears apart are the same. resolution: at most 4096. */
  obc_sphere_map_image_size(layout: number, resolution: number, width: Pointer, height: Pointer, error: Pointer): number;
  /** positions: 3 * vertex_count doubles (or other vectors of the vertices). pixels: written on success only.
   * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_image(locator: Pointer, positions: Pointer, layout: number, resolution: number, host: Pointer, pixels: Pointer, error: Pointer): number;
  /** The closed surface back. seam_gap, or NULL: the greatest distance between pixels that are one vertex, which becomes their
   * mean. Errors: OBC_INVALID_ARGUMENT (also a pixel that is not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_image_surface(pixels: Pointer, layout: number, resolution: number, host: Pointer, out: Pointer, seam_gap: Pointer, error: Pointer): number;
  /** Files by the ending: .pfm (float32) or .png (16 bits a channel between the corners of the bounding box, which a text chunk
   * holds). Written whole or not at all. Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED,
   * OBC_OUT_OF_MEMORY. */
  obc_sphere_map_image_write(path: Pointer, pixels: Pointer, layout: number, resolution: number, host: Pointer, error: Pointer): number;
  /** Says what is in a file; with pixels not NULL, of `capacity` doubles, reads it too. PNG files without the chunk fill the cube
   * from 0 to 1. Errors: as for writing, and OBC_MALFORMED_FILE. */
  obc_sphere_map_image_read(path: Pointer, host: Pointer, layout: Pointer, resolution: Pointer, pixels: Pointer, capacity: number, error: Pointer): number;
  /** The rotation, row by row, that takes `from` nearest to `to` (least squares; Kabsch 1976): 3 * count doubles each, scaled
   * to length 1. What the pairs leave open is turned as little as can be. Errors: OBC_INVALID_ARGUMENT. */
  obc_sphere_map_best_rotation(from: Pointer, to: Pointer, count: number, rotation: Pointer, error: Pointer): number;
  /** from[i] goes to to[i]: 3 * count doubles each, of any length, no two of them nearer than 0.01. host's allocator is kept.
   * Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the ways of two landmarks meet), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_warp_create(from: Pointer, to: Pointer, count: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** NULL is fine. */
  obc_sphere_map_warp_destroy(warp: Pointer): void;
  /** Where each direction goes (backward 0) or comes from (backward 1): 3 * count doubles; moved may be directions itself.
   * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_warp_apply(warp: Pointer, directions: Pointer, count: number, backward: number, host: Pointer, moved: Pointer, error: Pointer): number;
  /** One triangulation of the sphere with the vertices of two maps: the second's are inserted into the triangles of the first,
   * whose edges stay; vertices at the same direction become one. Only triangles and counts of the surfaces are used. The first
   * vertices of *out (positions: unit vectors) are those of the first map, in its order; second_vertex, second's vertex_count
   * indices or NULL, says where those of the second are (UINT32_MAX: in no triangle). Every triangle is positive.
   * Errors: as obc_sphere_map_locator_create, for the first map. */
  obc_sphere_map_overlay(first: Pointer, first_directions: Pointer, second: Pointer, second_directions: Pointer, host: Pointer, out: Pointer, second_vertex: Pointer, error: Pointer): number;
  /** Version of the library, major * 10000 + minor * 100 + patch. */
  obc_sphere_map_version(): number;
  /** The defaults, which the members' comments give. */
  obc_sphere_optimizer_options_init(options: Pointer, struct_size: number): number;
  /** Makes a solver over count >= 1 spheres in dimension >= 2 that starts from x0 (count * dimension numbers, each block scaled
   * to length 1). options and host may be NULL; what the host points at must stay valid until _destroy. Errors: invalid
   * argument (also a block of x0 that is zero), out of memory. */
  obc_sphere_optimizer_create(count: number, dimension: number, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Goes on to the next request: NEED_FG, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a defect.
   * *x (x may be NULL) is the point that is asked about, the solver's, valid until its next call. While a request waits for
   * _tell, and after DONE, the answer stays the same. Does not allocate. */
  obc_sphere_optimizer_step(solver: Pointer, x: Pointer): number;
  /** Answers NEED_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be NULL
   * then. Errors: invalid argument when nothing was asked. */
  obc_sphere_optimizer_tell(solver: Pointer, value: number, gradient: Pointer, error: Pointer): number;
  /** What is known now, at any time: result (or NULL), and x (or NULL), which is the iterate that met the tolerance if the run
   * CONVERGED, else the lowest point evaluated, and before that the start. */
  obc_sphere_optimizer_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer): number;
  /** How many spheres, and of how many numbers each; each of count and dimension may be NULL. For runs that come from _load. */
  obc_sphere_optimizer_get_shape(solver: Pointer, count: Pointer, dimension: Pointer, error: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
   * the same byte order. Errors: invalid argument, malformed file (damaged, or of another version). */
  obc_sphere_optimizer_save_size(solver: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
   * the same byte order. Errors: invalid argument, malformed file (damaged, or of another version). */
  obc_sphere_optimizer_save(solver: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
   * the same byte order. Errors: invalid argument, malformed file (damaged, or of another version). */
  obc_sphere_optimizer_load(blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Releases a solver; NULL is fine. */
  obc_sphere_optimizer_destroy(solver: Pointer): void;
  /** The loop over step with a callback: x holds the start and gets what _get_result hands out; result may be NULL. Answers
   * OBC_OK however the run ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and result are filled then
   * as well. */
  obc_sphere_optimizer_minimize(count: number, dimension: number, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Empty: no blocks. And the defaults, which the members' comments give. */
  obc_sphere_optimizer_blocks_init(blocks: Pointer, struct_size: number): number;
  /** Empty: no blocks. And the defaults, which the members' comments give. */
  obc_sphere_optimizer_relaxation_options_init(options: Pointer, struct_size: number): number;
  /** Lowers f block by block: x (count * dimension numbers) holds the start, scaled to length 1, and gets the end. options, host
   * and result may be NULL. Answers OBC_OK however it ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and
   * result are filled then as well. Errors: invalid argument (also a neighbour out of range), out of memory. */
  obc_sphere_optimizer_relax(blocks: Pointer, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** The same in parts: _create copies blocks and x0 (scaled to length 1); what the host points at must stay valid until
   * _destroy. */
  obc_sphere_optimizer_relaxation_create(blocks: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** At most `steps` more steps of one block each, without an allocation; at the end of the relaxation its gradients are
   * measured. Answers OBC_OK however it ended; stop is RUNNING when steps are left to do, CANCELLED when f answered STOP.
   * OBC_CANCELLED: the host cancelled. However it was broken off, the step under way is as if it had not begun, and the next
   * _run goes on with the same bits as without the break. */
  obc_sphere_optimizer_relaxation_run(relaxation: Pointer, f: number, user: Pointer, steps: bigint, error: Pointer): number;
  /** What is known now: result (or NULL) and x (count * dimension numbers, or NULL). */
  obc_sphere_optimizer_relaxation_get_result(relaxation: Pointer, result: Pointer, x: Pointer, error: Pointer): number;
  /** The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
   * again (invalid argument if they are others), with the options of the saved one. */
  obc_sphere_optimizer_relaxation_save_size(relaxation: Pointer): number;
  /** The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
   * again (invalid argument if they are others), with the options of the saved one. */
  obc_sphere_optimizer_relaxation_save(relaxation: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
   * again (invalid argument if they are others), with the options of the saved one. */
  obc_sphere_optimizer_relaxation_load(blocks: Pointer, blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Releases a relaxation; NULL is fine. */
  obc_sphere_optimizer_relaxation_destroy(relaxation: Pointer): void;
  /** English name of a stop, such as "evaluation budget". Never NULL; a static string. */
  obc_sphere_optimizer_stop_name(stop: number): Pointer;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_sphere_optimizer_version(): number;
  /** An empty problem: n = 0, a scalar f, no bounds. */
  obc_trust_region_problem_init(problem: Pointer, struct_size: number): number;
  /** The defaults, which the members' comments give. */
  obc_trust_region_options_init(options: Pointer, struct_size: number): number;
  /** Makes a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL; what the host points at
   * must stay valid until _destroy. Errors: invalid argument, out of memory. */
  obc_trust_region_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Gives evaluations made before, `count` points (count x n, row by row, within the bounds) with their outputs (count, or
   * count x m): before the first step. They do not count against max_evaluations. The run begins at the lowest of them
   * instead of x0, and uses those near it in the place of evaluations of its own; of more than it can interpolate it keeps
   * the lowest. Errors: invalid argument (also for an output that is not finite). */
  obc_trust_region_give(solver: Pointer, points: Pointer, outputs: Pointer, count: number, error: Pointer): number;
  /** Goes on to the next request: NEED_VALUES, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a
   * defect. With NEED_VALUES, *points (may be NULL) is what is asked for: *count (may be NULL) rows of n entries, in the
   * solver's memory until its next call other than _tell. Rows may be evaluated at the same time; there is one, but at the
   * start of a CROSS. Until each is answered by _tell, and after DONE, the answer stays the same, less the rows told. */
  obc_trust_region_step(solver: Pointer, points: Pointer, count: Pointer): number;
  /** Answers NEED_VALUES at the first of the points asked for: f, or m residuals. Not finite, or outputs NULL: f cannot be
   * evaluated there. Errors: invalid argument when nothing was asked. */
  obc_trust_region_tell(solver: Pointer, outputs: Pointer, error: Pointer): number;
  /** What is known now, at any time: result (or NULL), and the lowest point evaluated, x (n entries, or NULL) with its outputs (1
   * or m, or NULL; NaN before the first value). Before the first value x is the start. */
  obc_trust_region_get_result(solver: Pointer, result: Pointer, x: Pointer, outputs: Pointer, error: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
   * options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
   * malformed file (damaged, or of another version). */
  obc_trust_region_save_size(solver: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
   * options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
   * malformed file (damaged, or of another version). */
  obc_trust_region_save(solver: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
   * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
   * options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
   * malformed file (damaged, or of another version). */
  obc_trust_region_load(problem: Pointer, blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Frees a solver; NULL is fine. */
  obc_trust_region_destroy(solver: Pointer): void;
  /** Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Errors:
   * invalid argument, out of memory, cancelled (by the host; x and result are filled). How the run ended is result's stop. */
  obc_trust_region_minimize(problem: Pointer, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Short English name of an end, such as "converged". Never NULL; a static string. */
  obc_trust_region_stop_name(stop: number): Pointer;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_trust_region_version(): number;
  /** A mesh of nothing; the defaults, which the members' comments give; zeros. */
  obc_volume_map_tangle_init(tangle: Pointer, struct_size: number): number;
  /** A mesh of nothing; the defaults, which the members' comments give; zeros. */
  obc_volume_map_untangle_options_init(options: Pointer, struct_size: number): number;
  /** A mesh of nothing; the defaults, which the members' comments give; zeros. */
  obc_volume_map_untangle_report_init(report: Pointer, struct_size: number): number;
  /** Moves vertices until all tetrahedra are positive: result gets x y z a vertex, fixed coordinates to the bit, tied ones the
   * same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be NULL; result may be
   * tangle->positions. About 700 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
   * Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
   * all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
   * not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
   * malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
   * rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled. */
  obc_volume_map_untangle(tangle: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_volume_map_solid_options_init(options: Pointer, struct_size: number): number;
  /** Finds a polycube of the boundary of a solid and a map of the solid to it: every tetrahedron is positive, on the polycube and
   * in space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive,
   * meeting in whole faces. Tetrahedra are split where the map needs that. options and host may be NULL; the allocator of the
   * host must stay valid until _destroy. Minutes for a hundred thousand tetrahedra.
   * A cavity gets a polycube within that of the outer wall; the polycubes of pieces stand side by side along x.
   * Errors: invalid argument; malformed file (index-range), degenerate, not manifold, not closed; no valid result with what stood
   * in the way; out of memory, cancelled. */
  obc_volume_map_solid_compute(positions: Pointer, vertex_count: number, tetrahedra: Pointer, tetrahedron_count: number, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_solid_destroy(solid: Pointer): void;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_solid_vertex_count(solid: Pointer): number;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_solid_tetrahedron_count(solid: Pointer): number;
  /** x y z a vertex in space, and on the polycube; four vertices a tetrahedron. Each may be NULL. Errors: invalid argument. */
  obc_volume_map_solid_copy(solid: Pointer, positions: Pointer, polycube: Pointer, tetrahedra: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_volume_map_hexes_options_init(options: Pointer, struct_size: number): number;
  /** Fills a closed surface with hexahedra: oriented, looking outward, of any genus, in one piece or in several that lie apart,
   * which get their parts of the cells by their volumes. Parts within a piece that look inward are the walls of cavities, which
   * stay empty. Hexahedra meet in whole faces, the boundary has the parts and the genus of the surface, each hexahedron has
   * positive corners by exact signs and a trilinear map that is certainly positive. In the report of several pieces, corners and
   * vertices are all of them, distance and volume_error the largest, in percent of its own piece. options, host and report may be
   * NULL; the allocator of the host must stay valid until _destroy.
   * Errors: invalid argument; not closed; not manifold (kinds self-intersection: parts that meet, inconsistent-orientation: parts
   * that look into the solid); degenerate; malformed file; no valid result with what stood in the way; out of memory, cancelled. */
  obc_volume_map_hexes_compute(surface: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_hexes_destroy(hexes: Pointer): void;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_hexes_vertex_count(hexes: Pointer): number;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_hexes_count(hexes: Pointer): number;
  /** NULL is fine, here and in the functions that count (0). */
  obc_volume_map_hexes_quad_count(hexes: Pointer): number;
  /** x y z a vertex; eight vertices a hexahedron, in the order of MEDIT and VTK; four vertices a quad of the boundary,
   * counter-clockwise seen from outside, and the face of the polycube that it lies on (0 by voxels). Each may be NULL. Errors: invalid
   * argument. */
  obc_volume_map_hexes_copy(hexes: Pointer, positions: Pointer, hexahedra: Pointer, quads: Pointer, quad_faces: Pointer, error: Pointer): number;
  /** The defaults, which the members' comments give. */
  obc_volume_map_frame_options_init(options: Pointer, struct_size: number): number;
  /** Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
   * Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, meeting in whole faces; frames: w x y z a
   * tetrahedron as in <orbicube/frame_field.h>, with an axis along the normal at the boundary, or NULL: several smooth fields are
   * made and repaired, until a map follows one. The faces of the result (obc_volume_map_hexes_copy) are the parts of the boundary
   * that lie in one plane of the map. Where their boundary is farther from that of the solid than asked for, it is held there, then
   * there are more cells, as in obc_volume_map_hexes_compute. options, host and report may be NULL; the allocator of the host must stay valid until _destroy.
   * Errors: invalid argument; malformed file (index-range), degenerate, not manifold; no valid result for a field that no such map
   * has, with the singular edge and its curve or the layer that would collapse, and for maps that stay inverted, with the place;
   * out of memory, cancelled. */
  obc_volume_map_frame_hexes_compute(positions: Pointer, vertex_count: number, tetrahedra: Pointer, tetrahedron_count: number, frames: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** Version of this library, major * 10000 + minor * 100 + patch. */
  obc_volume_map_version(): number;
}
