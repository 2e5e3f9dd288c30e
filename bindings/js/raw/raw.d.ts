// What the C headers declare, with the parameters of their functions. Written by scripts/bindings.py; not to be edited.

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
  readonly OBC_FRAME_FIELD_DISSERTATION: 1;
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
  readonly OBC_HEXMESH_PADDING_AUTO: 0;
  readonly OBC_HEXMESH_PADDING_WITH: 1;
  readonly OBC_HEXMESH_PADDING_WITHOUT: 2;
  readonly OBC_HEXMESH_METHOD_AUTO: 0;
  readonly OBC_HEXMESH_METHOD_POLYCUBE: 1;
  readonly OBC_HEXMESH_METHOD_GRID: 2;
  readonly OBC_HEXMESH_METHOD_FRAMES: 3;
  readonly OBC_HEXMESH_FEATURES_OFF: 0;
  readonly OBC_HEXMESH_FEATURES_AUTO: 1;
  readonly OBC_HEXMESH_FEATURES_TAGS: 2;
  readonly OBC_HEXMESH_FEATURES_ANGLES: 3;
  readonly OBC_HEXMESH_FEATURES_MACHINED: 4;
  readonly OBC_MESH_TRIANGLE_REGIONS: 1;
  readonly OBC_MESH_TETRAHEDRON_REGIONS: 2;
  readonly OBC_MESH_HEXAHEDRON_REGIONS: 4;
  readonly OBC_MESH_OBJ: 0;
  readonly OBC_MESH_OFF: 1;
  readonly OBC_MESH_PLY: 2;
  readonly OBC_MESH_STL: 3;
  readonly OBC_MESH_MEDIT: 4;
  readonly OBC_MESH_VTK: 5;
  readonly OBC_MESH_MSH: 6;
  readonly OBC_MESH_FREESURFER: 7;
  readonly OBC_MESH_INP: 8;
  readonly OBC_MESH_VTP: 9;
  readonly OBC_MESH_VTU: 10;
  readonly OBC_MESH_GIFTI: 11;
  readonly OBC_MESH_HOLDS_SURFACES: 1;
  readonly OBC_MESH_HOLDS_POLYGONS: 2;
  readonly OBC_MESH_HOLDS_CELLS: 4;
  readonly OBC_MESH_HOLDS_BINARY: 8;
  readonly OBC_MESH_HOLDS_REGIONS: 16;
  readonly OBC_POLYCUBE_AUTO: 0;
  readonly OBC_POLYCUBE_LABELS: 1;
  readonly OBC_POLYCUBE_VOXELS: 2;
  readonly OBC_POLYCUBE_DISSERTATION: 3;
  readonly OBC_POLYCUBE_SURFACE_MEAN: 0;
  readonly OBC_POLYCUBE_FACE_MEAN: 1;
  readonly OBC_POLYCUBE_HARMONIC: 2;
  readonly OBC_POLYCUBE_TRUST_REGION: 0;
  readonly OBC_POLYCUBE_GRADIENT: 1;
  readonly OBC_PROJECTED_GRADIENT_FACE: 0;
  readonly OBC_PROJECTED_GRADIENT_DISSERTATION: 1;
  readonly OBC_PROJECTED_GRADIENT_MAX_OF_LAST: 0;
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
  readonly OBC_PROJECTED_GRADIENT_UNBOUNDED: 10;
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
  readonly OBC_SPHERE_MAP_DISSERTATION: 5;
  readonly OBC_SPHERE_MAP_ICOSPHERE: 0;
  readonly OBC_SPHERE_MAP_CUBE: 1;
  readonly OBC_SPHERE_MAP_LATITUDE: 2;
  readonly OBC_SPHERE_MAP_OCTAHEDRON: 3;
  readonly OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY: 0;
  readonly OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN: 1;
  readonly OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE: 2;
  readonly OBC_SPHERE_OPTIMIZER_DISSERTATION: 3;
  readonly OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON: 4;
  readonly OBC_SPHERE_OPTIMIZER_NEED_FG: 1;
  readonly OBC_SPHERE_OPTIMIZER_ITERATION: 2;
  readonly OBC_SPHERE_OPTIMIZER_DONE: 3;
  readonly OBC_SPHERE_OPTIMIZER_NEED_PRODUCT: 4;
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
  readonly OBC_TRUST_REGION_DISSERTATION: 1;
  readonly OBC_TRUST_REGION_AUTOMATIC: 0;
  readonly OBC_TRUST_REGION_CHAIN: 1;
  readonly OBC_TRUST_REGION_CROSS: 2;
  readonly OBC_TRUST_REGION_SUM_OF_SQUARES: 0;
  readonly OBC_TRUST_REGION_SUM_OF_MAGNITUDES: 1;
  readonly OBC_TRUST_REGION_MAX_MAGNITUDE: 2;
  readonly OBC_TRUST_REGION_MAX_VALUE: 3;
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
  readonly OBC_TRUST_REGION_RESOLUTION_LIMIT: 8;
  readonly OBC_TRUST_REGION_CONTINUE: 0;
  readonly OBC_TRUST_REGION_STOP: 1;
  readonly OBC_TRUST_REGION_FAILED: 2;
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
  readonly obc_harmonics_refinement_report: Layout;
  readonly obc_harmonics_align_options: Layout;
  readonly obc_harmonics_alignment: Layout;
  readonly obc_hexmesh_options: Layout;
  readonly obc_hexmesh_report: Layout;
  readonly obc_hexmesh_missing: Layout;
  readonly obc_surface: Layout;
  readonly obc_mesh_cells: Layout;
  readonly obc_mesh_tetrahedron_quality_report: Layout;
  readonly obc_mesh_read_options: Layout;
  readonly obc_mesh_write_options: Layout;
  readonly obc_mesh_topology_report: Layout;
  readonly obc_mesh_orient_report: Layout;
  readonly obc_mesh_distance: Layout;
  readonly obc_polycube_certificate: Layout;
  readonly obc_polycube_options: Layout;
  readonly obc_polycube_domain_options: Layout;
  readonly obc_polycube_domain_report: Layout;
  readonly obc_polycube_corner_options: Layout;
  readonly obc_polycube_corner_report: Layout;
  readonly obc_polycube_feature_options: Layout;
  readonly obc_polycube_feature_report: Layout;
  readonly obc_polycube_constraints: Layout;
  readonly obc_polycube_quads_options: Layout;
  readonly obc_polycube_atlas_options: Layout;
  readonly obc_projected_gradient_problem: Layout;
  readonly obc_projected_gradient_options: Layout;
  readonly obc_projected_gradient_result: Layout;
  readonly obc_projected_gradient_check: Layout;
  readonly obc_sphere_map_options: Layout;
  readonly obc_sphere_map_report: Layout;
  readonly obc_sphere_optimizer_options: Layout;
  readonly obc_sphere_optimizer_result: Layout;
  readonly obc_sphere_optimizer_blocks: Layout;
  readonly obc_sphere_optimizer_relaxation_options: Layout;
  readonly obc_sphere_optimizer_relaxation_result: Layout;
  readonly obc_trust_region_problem: Layout;
  readonly obc_trust_region_options: Layout;
  readonly obc_trust_region_result: Layout;
  readonly obc_untangle_options: Layout;
  readonly obc_untangle_report: Layout;
  readonly obc_untangle_tetrahedra_problem: Layout;
  readonly obc_untangle_triangles_problem: Layout;
  readonly obc_volume_map_solid_options: Layout;
  readonly obc_volume_map_frame_map_options: Layout;
  readonly obc_volume_map_frame_map_report: Layout;
};
export const callbacks: Readonly<Record<string, string>>;
export const functions: Readonly<Record<keyof RawFunctions, string>>;

/** The C functions as they are. Functions and structs are given by their addresses. */
export interface RawFunctions {
  /** Fills a host with the defaults. Errors: invalid argument (NULL, or a size that no version has). */
  obc_host_init(host: Pointer, struct_size: number): number;
  /** Returns a short English name of a status, such as "out of memory"; a static string, never NULL. */
  obc_status_name(status: number): Pointer;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_base_version(): number;
  /** Fill options with the defaults, constraints with none, and a report with zeros. */
  obc_frame_field_options_init(options: Pointer, struct_size: number): number;
  /** Fill options with the defaults, constraints with none, and a report with zeros. */
  obc_frame_field_constraints_init(constraints: Pointer, struct_size: number): number;
  /** Fill options with the defaults, constraints with none, and a report with zeros. */
  obc_frame_field_report_init(report: Pointer, struct_size: number): number;
  /** Computes a field of low energy. frames: 4 * tetrahedron_count doubles, read for OBC_FRAME_FIELD_GIVEN, and written on success only.
   * options, constraints, host and report may be NULL. O(n), up to 1 KB a tetrahedron. Errors: invalid argument (NULL, NaN, index out
   * of range, options), degenerate (a repeated vertex), not manifold (a face with three tetrahedra, neighbors on the same side of a
   * face), out of memory, cancelled. */
  obc_frame_field_compute(solid: Pointer, options: Pointer, constraints: Pointer, host: Pointer, frames: Pointer, report: Pointer, error: Pointer): number;
  /** Measures any field: frames, 4 * tetrahedron_count doubles, normalized before use. host may be NULL. O(n). Errors: as _compute. */
  obc_frame_field_measure(solid: Pointer, frames: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** Computes the matching of each face: 4 * tetrahedron_count numbers, entry 4 t + k for the face of tetrahedron t opposite its vertex k. It
   * is the rotation of the cube (numbered as in obc_quaternion_cube_element) that, in its own axes, brings frame t nearest to that of the
   * neighbor; 0 on the boundary. O(n). Errors: as _compute. */
  obc_frame_field_matchings(solid: Pointer, frames: Pointer, host: Pointer, matchings: Pointer, error: Pointer): number;
  /** Finds the singular edges and curves of a field. host may be NULL; its allocator must remain valid until _destroy. O(n). Errors: as
   * _compute. */
  obc_frame_field_singularities_create(solid: Pointer, frames: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys the singularities; NULL is allowed. */
  obc_frame_field_singularities_destroy(singularities: Pointer): void;
  /** Return the numbers of singular edges, curves and nodes; 0 for NULL. */
  obc_frame_field_singular_edge_count(singularities: Pointer): number;
  /** Return the numbers of singular edges, curves and nodes; 0 for NULL. */
  obc_frame_field_singular_curve_count(singularities: Pointer): number;
  /** Return the numbers of singular edges, curves and nodes; 0 for NULL. */
  obc_frame_field_singular_node_count(singularities: Pointer): number;
  /** Copies to arrays of the caller, each of which may be NULL: for each edge two vertices, the rotation of the cube around it, and its
   * turn: 1 for valence 3 of a hexahedral mesh, -1 for valence 5, 2 for a half turn, 0 where no hexahedral mesh exists. curve_begin (curve
   * count + 1) are offsets of the curves into curve_edges (edge count), the edges in order along each. nodes are vertices. Errors:
   * invalid argument. */
  obc_frame_field_singularities_copy(singularities: Pointer, edge_vertices: Pointer, edge_rotations: Pointer, edge_turns: Pointer, curve_begin: Pointer, curve_edges: Pointer, nodes: Pointer, error: Pointer): number;
  /** Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
   * singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL. */
  obc_frame_field_unmeshable_edge_count(singularities: Pointer): number;
  /** Return the numbers of unmeshable elements: singular edges that are not quarter turns about an axis, and inner vertices whose
   * singular edges no hexahedral mesh has (turning points and nodes). Both are 0 for a locally meshable field and for NULL. */
  obc_frame_field_unmeshable_vertex_count(singularities: Pointer): number;
  /** Copies the unmeshable elements to arrays of the caller, each of which may be NULL: edges as indices of singular edges, vertices as
   * indices of the solid, both ascending. Errors: invalid argument. */
  obc_frame_field_unmeshable_copy(singularities: Pointer, edges: Pointer, vertices: Pointer, error: Pointer): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_frame_field_version(): number;
  /** Fills options with the defaults. */
  obc_gltf_read_options_init(options: Pointer, struct_size: number): number;
  /** Reads the file at `path` (bytes in the encoding of the system). options and host may be NULL; the allocator of the host must remain valid
   * until _surface_destroy. O(n). Errors: io; malformed file (the kind says how: truncated, parse, index-range, accessor-range,
   * unsafe-path, ...); unsupported; degenerate (a transform or welding flattens everything); out of memory; cancelled. */
  obc_gltf_read(path: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Reads a GLB or JSON file from `size` bytes in memory, which are not kept. `folder` contains buffers in separate files; NULL refuses
   * them. Otherwise as obc_gltf_read. */
  obc_gltf_read_memory(bytes: Pointer, size: number, folder: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL. */
  obc_gltf_surface_vertex_count(surface: Pointer): number;
  /** Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL. */
  obc_gltf_surface_triangle_count(surface: Pointer): number;
  /** Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL. */
  obc_gltf_surface_welded_vertex_count(surface: Pointer): number;
  /** Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL. */
  obc_gltf_surface_note_count(surface: Pointer): number;
  /** Returns the index-th note, UTF-8, valid until the surface is destroyed; NULL from the number of notes on. */
  obc_gltf_surface_note(surface: Pointer, index: number): Pointer;
  /** Copies positions (3 * vertex_count, or NULL) and triangles (3 * triangle_count indices, or NULL; counter-clockwise seen from outside)
   * to arrays of the caller. Errors: invalid argument. */
  obc_gltf_surface_copy(surface: Pointer, positions: Pointer, triangles: Pointer, error: Pointer): number;
  /** Destroys a surface; NULL is allowed. */
  obc_gltf_surface_destroy(surface: Pointer): void;
  /** Fills a scene with the defaults and an empty surface. */
  obc_gltf_scene_init(scene: Pointer, struct_size: number): number;
  /** Writes to `path`: JSON with an embedded buffer for the ending "gltf", otherwise GLB. The file appears when it is complete; after an error the
   * previous file remains. host may be NULL. O(n). Errors: invalid argument (sizes, indices, numbers that are not finite, texts),
   * unsupported (4 GiB or more), io, out of memory, cancelled. */
  obc_gltf_write(path: Pointer, scene: Pointer, host: Pointer, error: Pointer): number;
  /** Writes a surface alone, with smooth normals: positions 3 * vertex_count, triangles 3 * triangle_count. Otherwise as obc_gltf_write. */
  obc_gltf_write_surface(path: Pointer, positions: Pointer, vertex_count: number, triangles: Pointer, triangle_count: number, host: Pointer, error: Pointer): number;
  /** Compute exact morph targets of finite numbers. _delta returns the stored delta for a base and a target coordinate; _reconstructed returns
   * base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it. */
  obc_gltf_delta(base: number, target: number): number;
  /** Compute exact morph targets of finite numbers. _delta returns the stored delta for a base and a target coordinate; _reconstructed returns
   * base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it. */
  obc_gltf_reconstructed(base: number, delta: number): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_gltf_version(): number;
  /** Fill options with the defaults, and a report with zeros and its size. */
  obc_harmonics_fit_options_init(options: Pointer, struct_size: number): number;
  /** Fill options with the defaults, and a report with zeros and its size. */
  obc_harmonics_fit_report_init(report: Pointer, struct_size: number): number;
  /** Fill options with the defaults, and a report with zeros and its size. */
  obc_harmonics_refinement_report_init(report: Pointer, struct_size: number): number;
  /** Returns the number of coefficients up to a degree, (degree + 1)^2. */
  obc_harmonics_size(degree: number): number;
  /** Evaluates all Y_lm at each direction: rows, count * (degree+1)^2 doubles, one direction after the other. host may be NULL.
   * O(count * degree^2). Errors: OBC_INVALID_ARGUMENT (NULL, not finite, zero length, degree), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_harmonics_evaluate(directions: Pointer, count: number, degree: number, host: Pointer, rows: Pointer, error: Pointer): number;
  /** Fits coefficients to values at scattered directions by weighted least squares. weights: one nonnegative number a direction, or NULL
   * for ones; those of obc_mesh_vertex_areas, the usual choice for a surface, weight each piece by its area. options, host and
   * report may be NULL. coefficients is written on success only. A rank-deficient fit is not an error: see report->rank. Errors: as
   * obc_harmonics_evaluate. */
  obc_harmonics_fit(directions: Pointer, weights: Pointer, values: Pointer, count: number, channels: number, options: Pointer, host: Pointer, coefficients: Pointer, report: Pointer, error: Pointer): number;
  /** Refines a sphere map for the expansion of its surface to the degree of the options: up to `rounds` times, fits the positions and moves each
   * direction, by one damped Gauss-Newton step, towards the point of the fitted surface that is nearest to its vertex. directions (3 *
   * vertex_count doubles, of any length) are changed to unit vectors, on success only. Triangles that are positive or negative on the
   * sphere beyond rounding keep their orientation, so that a bijection remains one; vertices of others do not move. The angles and
   * areas of the map are not controlled. weights as for obc_harmonics_fit; options, host and report may be NULL. O(rounds) fits.
   * Errors: as obc_harmonics_evaluate, and OBC_MALFORMED_FILE (kind index-range). */
  obc_harmonics_refine_map(positions: Pointer, vertex_count: number, triangles: Pointer, triangle_count: number, weights: Pointer, options: Pointer, rounds: number, host: Pointer, directions: Pointer, report: Pointer, error: Pointer): number;
  /** Evaluates the functions at directions: values, count * channels doubles, and unless gradients is NULL their tangential gradients on the unit
   * sphere, 3 * count * channels doubles. O(count * degree^2 * channels). Errors: as obc_harmonics_evaluate. */
  obc_harmonics_synthesize(coefficients: Pointer, degree: number, channels: number, directions: Pointer, count: number, host: Pointer, values: Pointer, gradients: Pointer, error: Pointer): number;
  /** Computes the transpose of obc_harmonics_synthesize: coefficients, (degree+1)^2 * channels doubles, of which that of Y_lm is the sum of
   * weight * value * Y_lm over the directions. For iterative methods of the caller; what fits values best is the result of
   * obc_harmonics_fit. weights: one number a direction, or NULL for ones. The weights and values may be any numbers; sums with
   * those that are not finite are not finite. O(count * degree^2 * channels), from degree 80 O((count + degree^3) * channels).
   * coefficients is written on success only. host may be NULL. Errors: as obc_harmonics_evaluate. */
  obc_harmonics_analyze(directions: Pointer, weights: Pointer, values: Pointer, count: number, channels: number, degree: number, host: Pointer, coefficients: Pointer, error: Pointer): number;
  /** Computes the norm of each degree, the square root of the sum of squares over m and the channels: norms, degree + 1 doubles. It is
   * invariant under rotations of the sphere, and of the values of three channels. Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY. */
  obc_harmonics_degree_norms(coefficients: Pointer, degree: number, channels: number, norms: Pointer, error: Pointer): number;
  /** Computes the distance D_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
   * differences of the norms; missing degrees count as zero. first = 0 is the dissertation's; with first = 1 the positions of the
   * shapes have no effect. Errors: as obc_harmonics_degree_norms. */
  obc_harmonics_shape_distance(f: Pointer, f_degree: number, g: Pointer, g_degree: number, channels: number, first: number, last: number, distance: Pointer, error: Pointer): number;
  /** Filters in place: keeps degrees from low to high and sets the others to zero, with a raised-cosine transition over `width` degrees
   * outside each end (0: none). keep_mean 1 preserves degree 0, the position of a shape. Errors: as obc_harmonics_degree_norms. */
  obc_harmonics_filter(coefficients: Pointer, degree: number, channels: number, low: number, high: number, width: number, keep_mean: number, error: Pointer): number;
  /** Rotates the functions with the sphere: the value at v moves to R v. rotation: the matrix R by rows, 9 doubles. turned may be
   * coefficients. The values are not rotated: for a rotation of a shape in space, multiply the three coefficients of each Y_lm by the
   * matrix. O(degree^3). Errors: OBC_INVALID_ARGUMENT (also: not a rotation), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_harmonics_rotate(coefficients: Pointer, degree: number, channels: number, rotation: Pointer, host: Pointer, turned: Pointer, error: Pointer): number;
  /** Fill options with the defaults, and an alignment with zeros and its size. */
  obc_harmonics_align_options_init(options: Pointer, struct_size: number): number;
  /** Fill options with the defaults, and an alignment with zeros and its size. */
  obc_harmonics_alignment_init(alignment: Pointer, struct_size: number): number;
  /** Computes the rotation that best aligns `moving` with `fixed`: it maximizes the sum over the channels of the integral of
   * fixed(u) * (Q moving)(R^-1 u), without degree 0, by a search over a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
   * rotation group") and Newton's method up to the lower of the two degrees. options and host may be NULL.
   * O(search_degree^4 + degree^3). Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (one of them is constant), OBC_CANCELLED,
   * OBC_OUT_OF_MEMORY. */
  obc_harmonics_align(fixed: Pointer, fixed_degree: number, moving: Pointer, moving_degree: number, channels: number, options: Pointer, host: Pointer, alignment: Pointer, error: Pointer): number;
  /** Writes coefficients to a file, which is complete or does not appear; reading it returns the same numbers to their last bits. Errors:
   * OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC_IO, OBC_OUT_OF_MEMORY. The message starts
   * with the path. */
  obc_harmonics_write(path: Pointer, format: number, coefficients: Pointer, degree: number, channels: number, error: Pointer): number;
  /** Reads a file and checks all its contents. host may be NULL; its allocator must remain valid until _destroy. Errors:
   * OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with the line),
   * OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED, OBC_OUT_OF_MEMORY. The message starts with the path. */
  obc_harmonics_read(path: Pointer, format: number, host: Pointer, coefficients: Pointer, error: Pointer): number;
  /** Return the degree and the number of channels; 0 for NULL. */
  obc_harmonics_coefficients_degree(coefficients: Pointer): number;
  /** Return the degree and the number of channels; 0 for NULL. */
  obc_harmonics_coefficients_channels(coefficients: Pointer): number;
  /** Copies the coefficients: (degree+1)^2 * channels doubles. Errors: OBC_INVALID_ARGUMENT. */
  obc_harmonics_coefficients_copy(coefficients: Pointer, values: Pointer, error: Pointer): number;
  /** Destroys coefficients; NULL is allowed. */
  obc_harmonics_coefficients_destroy(coefficients: Pointer): void;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_harmonics_version(): number;
  /** Fills options with the defaults. */
  obc_hexmesh_options_init(options: Pointer, struct_size: number): number;
  /** Fills a closed surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the cells are divided by
   * volume; components within a piece bound cavities. Triangles are reversed where neighbors disagree and where components are oriented
   * into their solid; the log of the host says so. A few triangles may intersect others of their component, up to a twentieth of them. The
   * volume of the result is infinite or 0 where the unit of the surface takes it out of the range of double. options, host and report
   * may be NULL; the allocator of the host must remain valid until _destroy. Takes from a second to many minutes.
   * Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components intersect;
   * non-orientable); degenerate; malformed file; not connected (method FRAMES: several pieces); unsupported (method FRAMES without
   * `fill`); no valid result with the obstacle; those of `fill`; out of memory; cancelled. */
  obc_hexmesh_compute(surface: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** Fills a solid of tetrahedra with hexahedra. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: NULL,
   * or for the methods AUTO, which then is FRAMES, and FRAMES w x y z a tetrahedron as in <orbicube/frame_field.h>, with an axis along the
   * normal at the boundary. For method FRAMES without frames several smooth fields are computed and repaired until a map
   * follows one. The patch numbers of obc_hexmesh_copy are then those of connected boundary regions in one plane of the map. options, host
   * and report may be NULL; the allocator of the host must remain valid until _destroy.
   * Errors: as obc_hexmesh_compute for the boundary; malformed file (index-range); degenerate; not manifold; no valid result for a field
   * that no such map follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted,
   * with the location. */
  obc_hexmesh_compute_solid(positions: Pointer, vertex_count: number, tetrahedra: Pointer, tetrahedron_count: number, frames: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a mesh; NULL is allowed. */
  obc_hexmesh_destroy(hexes: Pointer): void;
  /** Return the number of vertices, hexahedra and boundary quads; 0 for NULL. */
  obc_hexmesh_vertex_count(hexes: Pointer): number;
  /** Return the number of vertices, hexahedra and boundary quads; 0 for NULL. */
  obc_hexmesh_count(hexes: Pointer): number;
  /** Return the number of vertices, hexahedra and boundary quads; 0 for NULL. */
  obc_hexmesh_quad_count(hexes: Pointer): number;
  /** Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
   * counter-clockwise seen from outside) and the patch of each quad: of the polycube, of the feature curves where they are embedded, or 0;
   * each may be NULL. Errors: invalid argument. */
  obc_hexmesh_copy(hexes: Pointer, positions: Pointer, hexahedra: Pointer, quads: Pointer, quad_patches: Pointer, error: Pointer): number;
  /** Copies the number of the region of each hexahedron, 0 where the solid had none. Errors: invalid argument. */
  obc_hexmesh_copy_regions(hexes: Pointer, regions: Pointer, error: Pointer): number;
  /** Returns the number of missing features; 0 for NULL. */
  obc_hexmesh_missing_count(hexes: Pointer): number;
  /** Copies missing feature `index`, from 0. Errors: invalid argument. */
  obc_hexmesh_get_missing(hexes: Pointer, index: number, missing: Pointer, error: Pointer): number;
  /** Returns what was in the way of missing feature `index`, in words, until the mesh is destroyed; NULL for an index out of range and for
   * NULL. */
  obc_hexmesh_missing_reason(hexes: Pointer, index: number): Pointer;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_hexmesh_version(): number;
  /** Fills cells with an empty mesh. */
  obc_mesh_cells_init(cells: Pointer, struct_size: number): number;
  /** Creates a mesh with copies of the arrays. host may be NULL; its allocator must remain valid until _destroy. O(n). Errors: invalid
   * argument, out of memory. */
  obc_mesh_create(cells: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Generates a closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc_mesh_shape_name lists the names) of about
   * `triangle_count` triangles, two units in size; the seed varies its shape. O(n). Errors: invalid argument, out of memory,
   * cancelled. */
  obc_mesh_make(shape: Pointer, triangle_count: number, seed: bigint, host: Pointer, out: Pointer, error: Pointer): number;
  /** Returns the name of the index-th shape of obc_mesh_make, a static string; NULL from the number of shapes on. */
  obc_mesh_shape_name(index: number): Pointer;
  /** Destroys a mesh; NULL is allowed. */
  obc_mesh_destroy(mesh: Pointer): void;
  /** Return the numbers of vertices and cells of a mesh; 0 for NULL. */
  obc_mesh_vertex_count(mesh: Pointer): number;
  /** Return the numbers of vertices and cells of a mesh; 0 for NULL. */
  obc_mesh_triangle_count(mesh: Pointer): number;
  /** Return the numbers of vertices and cells of a mesh; 0 for NULL. */
  obc_mesh_tetrahedron_count(mesh: Pointer): number;
  /** Return the numbers of vertices and cells of a mesh; 0 for NULL. */
  obc_mesh_hexahedron_count(mesh: Pointer): number;
  /** Copies a mesh to arrays of the caller, each of which may be NULL. Errors: invalid argument. */
  obc_mesh_copy(mesh: Pointer, positions: Pointer, triangles: Pointer, tetrahedra: Pointer, hexahedra: Pointer, error: Pointer): number;
  /** Returns what has region numbers, bits OBC_MESH_..._REGIONS; 0 for NULL. */
  obc_mesh_region_kinds(mesh: Pointer): number;
  /** Copies the region number of each triangle and cell, 0 where it has none, to arrays of the caller, each of which may be NULL. Errors:
   * invalid argument. */
  obc_mesh_copy_regions(mesh: Pointer, triangles: Pointer, tetrahedra: Pointer, hexahedra: Pointer, error: Pointer): number;
  /** Returns a view of the positions and triangles of a mesh, valid until the mesh is destroyed. Errors: invalid argument. */
  obc_mesh_surface(mesh: Pointer, surface: Pointer, error: Pointer): number;
  /** Checks that the tetrahedra and hexahedra form a solid: distinct, positive by exact predicates (hexahedra at each corner),
   * conforming, no face with three cells, no edge at which parts touch. Returns OBC_OK, also without cells, or degenerate or not
   * manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
   * first location. O(n log n). Errors: those, out of memory, cancelled. */
  obc_mesh_check_cells(mesh: Pointer, host: Pointer, error: Pointer): number;
  /** Computes the outward-oriented boundary surface of the solid, a new mesh with the same vertices: the faces of exactly one cell, those of
   * hexahedra split in two. O(n log n). Errors: invalid argument, not manifold (a face with three cells), out of memory, cancelled. */
  obc_mesh_boundary(mesh: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Fills a report with zeros and its size. */
  obc_mesh_tetrahedron_quality_report_init(report: Pointer, struct_size: number): number;
  /** Measures the tetrahedra of a mesh, valid or not. O(n). Errors: invalid argument, cancelled. */
  obc_mesh_tetrahedron_quality(mesh: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
   * can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on. */
  obc_mesh_format_ending(format: number): Pointer;
  /** Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
   * can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on. */
  obc_mesh_format_name(format: number): Pointer;
  /** Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
   * can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on. */
  obc_mesh_format_contents(format: number): number;
  /** Fills options with the defaults. */
  obc_mesh_read_options_init(options: Pointer, struct_size: number): number;
  /** Reads the file at `path` (bytes in the encoding of the system) in the format of its ending, in upper or lower case.
   * Vertices keep their order unless they are welded; polygons are split into triangles; cells are checked as by
   * obc_mesh_check_cells. options and host may be NULL; the allocator of the host must remain valid until _destroy. All contents are
   * checked; memory is bounded by a multiple of the file size. O(size). Errors: io; malformed file (the kind says how:
   * truncated, parse, index-range, non-finite, ...; the message where); the kinds of cells; unsupported; out of memory; cancelled. */
  obc_mesh_read(path: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Reads a file of the format OBC_MESH_... from `size` bytes in memory, which are not kept; otherwise as obc_mesh_read. */
  obc_mesh_read_memory(bytes: Pointer, size: number, format: number, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
   * three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
   * the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read. */
  obc_mesh_format(mesh: Pointer): Pointer;
  /** Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
   * three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
   * the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read. */
  obc_mesh_polygon_count(mesh: Pointer): number;
  /** Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
   * three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
   * the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read. */
  obc_mesh_welded_vertex_count(mesh: Pointer): number;
  /** Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
   * three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
   * the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read. */
  obc_mesh_note(mesh: Pointer, index: number): Pointer;
  /** Fills options with the defaults. */
  obc_mesh_write_options_init(options: Pointer, struct_size: number): number;
  /** Writes to `path` in the format of its ending: triangles, and cells and region numbers in formats that hold them. Reading the file returns a
   * bit-identical mesh, except for STL, FreeSurfer and GIFTI, which have float32. The file appears when it is complete; after an error the
   * previous file remains. options and host may be NULL. O(n). Errors: invalid argument, unsupported (the ending, or cells that the
   * format does not have), io, out of memory, cancelled. */
  obc_mesh_write(path: Pointer, mesh: Pointer, options: Pointer, host: Pointer, error: Pointer): number;
  /** Writes a surface in arrays of the caller; otherwise as obc_mesh_write. */
  obc_mesh_write_surface(path: Pointer, surface: Pointer, options: Pointer, host: Pointer, error: Pointer): number;
  /** Fills a report with zeros and its size. */
  obc_mesh_topology_report_init(report: Pointer, struct_size: number): number;
  /** Analyzes any set of triangles. host may be NULL. O(n log n) time, O(n) for bounded valence (0.1 s for a million triangles), up to
   * 100 bytes a triangle. Errors: invalid argument, out of memory, cancelled. */
  obc_mesh_topology(surface: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** Checks the requirements of sphere maps: closed, connected, manifold, consistently oriented, genus 0. Returns OBC_OK, or not
   * closed, not manifold, wrong genus or degenerate with the kind and the first location in `error`. Costs as much as
   * obc_mesh_topology. Errors: those, invalid argument, out of memory, cancelled. */
  obc_mesh_check_closed_genus_zero(surface: Pointer, host: Pointer, error: Pointer): number;
  /** Fills a report with zeros and its size. */
  obc_mesh_orient_report_init(report: Pointer, struct_size: number): number;
  /** Reverses triangles in place until neighbors are consistently oriented, the minority of each component, and then all of them if the
   * surface is closed with negative volume. report may be NULL. O(n). Errors: invalid argument, not manifold (non-orientable;
   * nothing is changed), out of memory, cancelled. */
  obc_mesh_orient(positions: Pointer, vertex_count: number, triangles: Pointer, triangle_count: number, host: Pointer, report: Pointer, error: Pointer): number;
  /** Computes for each vertex the lowest vertex at exactly its position (-0 equals 0), vertex_count entries. O(n). Errors: invalid argument,
   * out of memory, cancelled. */
  obc_mesh_first_at_same_position(positions: Pointer, vertex_count: number, host: Pointer, first: Pointer, error: Pointer): number;
  /** Finds pairs of triangles that intersect in more than their shared vertices, by exact predicates: the first `capacity` pairs in
   * ascending order, two entries each, the lower triangle first. *count receives the number of pairs written. Triangles of zero area
   * are left out. Uses the threads of the host. O(n log n + pairs of overlapping boxes). Errors: invalid argument, out of memory,
   * cancelled. */
  obc_mesh_intersections(surface: Pointer, host: Pointer, pairs: Pointer, capacity: number, count: Pointer, error: Pointer): number;
  /** Computes unit vertex normals, 3 * vertex_count doubles: triangle normals weighted by angles (Thuermer and Wuethrich 1998); 0 0 1 where
   * they cancel and for vertices of no triangle. O(n). Errors: invalid argument, out of memory, cancelled. */
  obc_mesh_vertex_normals(surface: Pointer, host: Pointer, normals: Pointer, error: Pointer): number;
  /** Computes a third of the area of the adjacent triangles for each vertex: areas, vertex_count doubles, in the square of the surface's unit.
   * They sum up to the area. O(n). Errors: invalid argument (also: an area beyond the range of double), out of memory,
   * cancelled. */
  obc_mesh_vertex_areas(surface: Pointer, host: Pointer, areas: Pointer, error: Pointer): number;
  /** Fills a result with zeros and its size. */
  obc_mesh_distance_init(distance: Pointer, struct_size: number): number;
  /** Measures the distances between two surfaces (as Metro: Cignoni, Rocchini and Scopigno 1998). Uses the threads of the host.
   * O(n log n). Errors: invalid argument (also: no triangles), out of memory, cancelled. */
  obc_mesh_surface_distance(first: Pointer, second: Pointer, host: Pointer, distance: Pointer, error: Pointer): number;
  /** Computes the distance of two point sets (3 * a_count and 3 * b_count doubles), e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the
   * points of A of the distance to the nearest point of B: the reconstruction error of the dissertation's section 3.3.2. Uses the
   * threads of the host. O(n log n). Errors: invalid argument (also: no points, a coordinate beyond 1e150), out of memory,
   * cancelled. */
  obc_mesh_mean_distance(a: Pointer, a_count: number, b: Pointer, b_count: number, host: Pointer, distance: Pointer, error: Pointer): number;
  /** Creates a search structure from a copy of the surface. host may be NULL; its allocator must remain valid until _destroy.
   * O(n log n), about 200 bytes a triangle. Errors: invalid argument (also: a coordinate beyond 1e150, here and in points),
   * out of memory, cancelled. */
  obc_mesh_search_create(surface: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a search structure; NULL is allowed. */
  obc_mesh_search_destroy(search: Pointer): void;
  /** Finds the nearest vertex of each of `count` points (3 * count doubles), the lowest of equally near ones. O(log n) a point on
   * average. Errors: invalid argument (also: a point that is not finite, no vertices). */
  obc_mesh_search_vertices(search: Pointer, points: Pointer, count: number, vertices: Pointer, error: Pointer): number;
  /** Finds the nearest point of the surface to each of `count` points: its triangle (the lowest of equally near ones), its barycentric
   * coordinates (3 * count, nonnegative, sum 1), its position (3 * count) and its distance; each array may be NULL. O(log n) a
   * point on average. Errors: invalid argument (also: a point that is not finite, no triangles). */
  obc_mesh_search_surface(search: Pointer, points: Pointer, count: number, triangles: Pointer, weights: Pointer, positions: Pointer, distances: Pointer, error: Pointer): number;
  /** Returns the sign of (b - a) x (c - a): 1 if the triangle a, b, c in the plane is counter-clockwise. */
  obc_mesh_orientation_2d(a: Pointer, b: Pointer, c: Pointer): number;
  /** Returns the sign of det[b - a, c - a, d - a]: 1 if the tetrahedron a, b, c, d has positive volume. */
  obc_mesh_orientation_3d(a: Pointer, b: Pointer, c: Pointer, d: Pointer): number;
  /** Returns the sign of det[p, q, r]: 1 if p, q, r are counter-clockwise seen from outside a sphere around the origin. */
  obc_mesh_orientation_from_origin(p: Pointer, q: Pointer, r: Pointer): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_mesh_version(): number;
  /** Certifies a map of other origin: `surface` in space, `polycube` the positions of its vertices on the polycube (x y z a vertex).
   * certificate may be NULL; it is filled for valid and invalid maps. O(n log n) except for thousands of corners. Errors: invalid
   * argument (an index out of range, a position that is not finite), no valid result (the message is the reason), out of memory,
   * cancelled. */
  obc_polycube_create(surface: Pointer, polycube: Pointer, host: Pointer, certificate: Pointer, out: Pointer, error: Pointer): number;
  /** Fills options with the defaults. */
  obc_polycube_options_init(options: Pointer, struct_size: number): number;
  /** Computes a polycube of a closed surface of any genus and a map to it. Edges are split where required; the vertices of the surface
   * come first. The polycube has about the size of the surface. The attempts depend on the surface and the options
   * alone, never on time. Errors: invalid argument; not closed; not manifold; degenerate; malformed file (kind empty-mesh: no
   * triangles); no valid result with the outcome of each attempt; out of memory; cancelled. */
  obc_polycube_compute(surface: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Fills options with the defaults. */
  obc_polycube_domain_options_init(options: Pointer, struct_size: number): number;
  /** Optimizes the proportions of the polycube: distances between the planes of its patches that minimize the distortion of the map, with
   * vertices interpolated between the planes (the dissertation's section 4.3, by a projected gradient method over the logarithms of
   * the distances). Combinatorics, order of the planes and total area are preserved. The result is certified; without
   * improvement it is a bit-identical copy of `map`. O(n log n). Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_optimize_domain(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** Fills options with the defaults. */
  obc_polycube_corner_options_init(options: Pointer, struct_size: number): number;
  /** Lowers the distortion of a map to the same polycube: the preimages of its corners move on the surface, in the unfolding of the map
   * around each, and with them the edges of the polycube on the surface and the vertices between (the dissertation's section 4.4).
   * Triangle edges are split along polycube edges; inserted vertices that are no longer required may go. The result is
   * certified; without improvement it is a bit-identical copy of `map`. Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_optimize_corners(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** Fills options with the defaults. */
  obc_polycube_feature_options_init(options: Pointer, struct_size: number): number;
  /** Aligns features of a map to their targets on the same polycube, with minimum distortion otherwise. The result is certified. Errors:
   * invalid argument (a target that is not on the polycube, a vertex with two targets); no valid result with the conflicting
   * features; out of memory; cancelled. */
  obc_polycube_align_features(map: Pointer, options: Pointer, host: Pointer, report: Pointer, out: Pointer, error: Pointer): number;
  /** Returns the number of energies of the optimization that computed a map: one before it and one after each iteration; 0 for NULL and
   * for maps of other origin. */
  obc_polycube_energy_count(map: Pointer): number;
  /** Copies these energies to an array of the caller, which may be NULL. Errors: invalid argument. */
  obc_polycube_copy_energies(map: Pointer, energies: Pointer, error: Pointer): number;
  /** Destroys a map; NULL is allowed. */
  obc_polycube_destroy(map: Pointer): void;
  /** Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL. */
  obc_polycube_vertex_count(map: Pointer): number;
  /** Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL. */
  obc_polycube_triangle_count(map: Pointer): number;
  /** Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL. */
  obc_polycube_corner_count(map: Pointer): number;
  /** Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL. */
  obc_polycube_patch_count(map: Pointer): number;
  /** Returns the construction of a map: OBC_POLYCUBE_LABELS, VOXELS or DISSERTATION; -1 for a map of other origin and for NULL. */
  obc_polycube_construction(map: Pointer): number;
  /** Counts the corner points of a polycube in the dissertation's sense: vertices of the rectangles that its patches are cut into, at
   * least as many as its corners. O(c^3) for c corners in the worst case. Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_corner_points(map: Pointer, host: Pointer, count: Pointer, error: Pointer): number;
  /** Copies a map to arrays of the caller, each of which may be NULL: positions in space (x y z a vertex, bit-identical vertices of the
   * surface first), positions on the polycube, and triangles (three vertices each). Errors: invalid argument. */
  obc_polycube_copy(map: Pointer, positions: Pointer, polycube: Pointer, triangles: Pointer, error: Pointer): number;
  /** Copies data of each triangle, each array may be NULL: the direction of its normal on the polycube (0 to 5 for +x, -x, +y, -y, +z,
   * -z), its patch, and the surface triangle that contains it. Errors: invalid argument. */
  obc_polycube_copy_triangles(map: Pointer, labels: Pointer, patches: Pointer, sources: Pointer, error: Pointer): number;
  /** Copies the origin of each vertex, three entries a vertex, each array may be NULL: vertices of one surface triangle (UINT32_MAX
   * where fewer than three are needed) and their barycentric weights, positive (0 where not needed) with sum 1. Errors: invalid
   * argument. */
  obc_polycube_copy_sources(map: Pointer, corners: Pointer, weights: Pointer, error: Pointer): number;
  /** Maps a surface to a supplied polycube, whose triangles lie in axis-aligned planes. It is traced on the surface as with
   * OBC_POLYCUBE_VOXELS: at its position, with its bounding box stretched to that of the surface, or as the constraints require. The
   * polycube of the handle has the same coordinates; the map is smoothed across its edges. constraints may be NULL. Errors: those of
   * obc_polycube_compute; invalid argument for constraints that do not exist or occur twice; unsupported if the second surface is not a
   * polycube, with the reason; wrong genus if the genera differ. */
  obc_polycube_map_to_domain(surface: Pointer, polycube: Pointer, constraints: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Computes one polycube for several shapes of one genus and kind (the dissertation's section 4.5). Several polycubes of each shape are traced on
   * all others; proportions and maps are optimized for the sum of energies, and the polycube with the minimum sum is returned. Maps between
   * shapes are compositions: points with the same image on the polycube correspond. options are for the polycubes of single shapes, domain
   * for the energy. out is an array of `count` handles, 1 to 65536, in the order of the surfaces, all NULL after an error. constructed_from
   * (or NULL) receives the index of the shape from which the polycube was constructed. obc_polycube_copy_energies of each handle copies
   * the sums, which never increase. Errors: those of obc_polycube_compute, and wrong genus. */
  obc_polycube_compute_common(surfaces: Pointer, count: number, options: Pointer, domain: Pointer, host: Pointer, constructed_from: Pointer, out: Pointer, error: Pointer): number;
  /** Optimizes the proportions of one polycube for several maps to it: minimizes the sum of their energies, otherwise as
   * obc_polycube_optimize_domain. out is an array of `count` handles, all NULL after an error. Errors: invalid argument (also: maps
   * to different polycubes), out of memory, cancelled. */
  obc_polycube_optimize_common_domain(maps: Pointer, count: number, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Creates the graph of a map, which may be destroyed afterwards. Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_graph_create(map: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a graph; NULL is allowed. */
  obc_polycube_graph_destroy(graph: Pointer): void;
  /** Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
   * several edges have one link); 0 for NULL. */
  obc_polycube_graph_corner_count(graph: Pointer): number;
  /** Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
   * several edges have one link); 0 for NULL. */
  obc_polycube_graph_edge_count(graph: Pointer): number;
  /** Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
   * several edges have one link); 0 for NULL. */
  obc_polycube_graph_patch_count(graph: Pointer): number;
  /** Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
   * several edges have one link); 0 for NULL. */
  obc_polycube_graph_loop_count(graph: Pointer): number;
  /** Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
   * several edges have one link); 0 for NULL. */
  obc_polycube_graph_link_count(graph: Pointer): number;
  /** Copies for each corner its position (x y z) and its vertex of the map. Each array may be NULL, here and in the functions below.
   * Errors: invalid argument. */
  obc_polycube_graph_copy_corners(graph: Pointer, positions: Pointer, vertices: Pointer, error: Pointer): number;
  /** Copies for each edge its two corners, the patches on its left and right (from the first corner to the second, seen from outside),
   * and its convexity: 1 for an interior angle of 90 degrees, 0 for 270 degrees. Errors: invalid argument. */
  obc_polycube_graph_copy_edges(graph: Pointer, corners: Pointer, patches: Pointer, convex: Pointer, error: Pointer): number;
  /** Copies for each patch (numbered as in obc_polycube_copy_triangles) the direction of its normal (0 to 5 for +x, -x, +y, -y, +z,
   * -z), the coordinate of its plane, and the offset of its loops: the outer loop, then those around holes; loop_starts has
   * one entry more than there are patches. Errors: invalid argument. */
  obc_polycube_graph_copy_patches(graph: Pointer, labels: Pointer, coordinates: Pointer, loop_starts: Pointer, error: Pointer): number;
  /** Copies for each loop the offset of its darts, with one entry more than there are loops, and its darts, counter-clockwise around
   * the patch: dart 2 e is edge e from its first to its second corner, dart 2 e + 1 its reverse. Each dart is in one loop.
   * Errors: invalid argument. */
  obc_polycube_graph_copy_loops(graph: Pointer, starts: Pointer, darts: Pointer, error: Pointer): number;
  /** Copies the dual graph: the offset of the neighbors of each patch, with one entry more than there are patches, and the patches
   * that share an edge with it, ascending. Errors: invalid argument. */
  obc_polycube_graph_copy_dual(graph: Pointer, starts: Pointer, neighbors: Pointer, error: Pointer): number;
  /** Fills options with the defaults. */
  obc_polycube_quads_options_init(options: Pointer, struct_size: number): number;
  /** Creates a grid with integer numbers of cells between neighboring planes and maps its vertices to the surface, each in the triangle
   * that contains it by exact arithmetic. Connectivity depends on the polycube alone: maps to one polycube return the same quads.
   * Errors: invalid argument (also: more than 10^7 quads), out of memory, cancelled. */
  obc_polycube_quads_create(map: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a quad mesh; NULL is allowed. */
  obc_polycube_quads_destroy(quads: Pointer): void;
  /** Return the numbers of vertices and quads; 0 for NULL. */
  obc_polycube_quads_vertex_count(quads: Pointer): number;
  /** Return the numbers of vertices and quads; 0 for NULL. */
  obc_polycube_quads_quad_count(quads: Pointer): number;
  /** Copies to arrays of the caller, each of which may be NULL: for each vertex its positions on the surface and on the polycube (x y z),
   * for each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument. */
  obc_polycube_quads_copy(quads: Pointer, positions: Pointer, polycube: Pointer, corners: Pointer, patches: Pointer, error: Pointer): number;
  /** Copies for each vertex the triangle of the map that contains it and its barycentric weights, nonnegative with sum 1. Errors:
   * invalid argument. */
  obc_polycube_quads_copy_sources(quads: Pointer, triangles: Pointer, weights: Pointer, error: Pointer): number;
  /** Fills options with the defaults. */
  obc_polycube_atlas_options_init(options: Pointer, struct_size: number): number;
  /** Packs the patches of a map, which may be destroyed afterwards, at the largest scale that is found. The layout depends on the polycube
   * alone. Errors: invalid argument; unsupported (the square is too small for all patches with their padding); out of memory; cancelled. */
  obc_polycube_atlas_create(map: Pointer, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys an atlas; NULL is allowed. */
  obc_polycube_atlas_destroy(atlas: Pointer): void;
  /** Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL. */
  obc_polycube_atlas_size(atlas: Pointer): number;
  /** Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL. */
  obc_polycube_atlas_triangle_count(atlas: Pointer): number;
  /** Copies an atlas, each output may be NULL: texture coordinates of the corners of each triangle (u v of each of the three corners; 0 to
   * 1, u from the left and v from the top, as in glTF), the number of texels along a unit of the polycube, and the fraction of the square
   * that the patches cover (0 to 1). A vertex on an edge of the polycube has other coordinates in each of its patches. Errors: invalid
   * argument. */
  obc_polycube_atlas_copy(atlas: Pointer, coordinates: Pointer, texels_per_unit: Pointer, coverage: Pointer, error: Pointer): number;
  /** Samples an atlas: what each of its size * size texels shows, row by row from the top, so that any data of vertices becomes a texture.
   * Each array may be NULL: the triangle of the map, the barycentric weights of its three corners (nonnegative, sum 1), and whether the
   * middle of the texel is in that triangle (1). Beside the patches (0) texels show the point of the nearest texel in a patch, so that
   * filters and smaller copies of a texture mix nothing else into its patches; where no patch has the middle of any texel, all have triangle
   * UINT32_MAX and weights 0. O(texels + triangles). Errors: invalid argument, out of memory, cancelled. */
  obc_polycube_atlas_sample(atlas: Pointer, host: Pointer, triangles: Pointer, weights: Pointer, covered: Pointer, error: Pointer): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_polycube_version(): number;
  /** Fills a problem with n = m = 0 and no bounds. */
  obc_projected_gradient_problem_init(problem: Pointer, struct_size: number): number;
  /** Fills options with the defaults. */
  obc_projected_gradient_options_init(options: Pointer, struct_size: number): number;
  /** Creates a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
   * host points to must remain valid until _destroy. An empty feasible set ends the run as INFEASIBLE at the first step.
   * Errors: invalid argument, out of memory. */
  obc_projected_gradient_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Advances to the next request and returns it: NEED_FG, ITERATION or DONE, or a negative obc_status for NULL or after a defect. *x
   * (x may be NULL) is the point of the request, n entries in memory of the solver, valid until its next call. While a request
   * waits for _tell, and after DONE, the same request is returned. */
  obc_projected_gradient_step(solver: Pointer, x: Pointer): number;
  /** Supplies value and gradient for NEED_FG. An entry that is not finite means that f is undefined there; gradient may then be
   * NULL. Errors: invalid argument if no request waits. */
  obc_projected_gradient_tell(solver: Pointer, value: number, gradient: Pointer, error: Pointer): number;
  /** Copies the current state at any time: result (or NULL), and x (n entries, or NULL). x is the iterate that satisfies the tolerance
   * if the run CONVERGED, otherwise the lowest feasible point evaluated, and before the first value the projected start.
   * Errors: invalid argument. */
  obc_projected_gradient_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer): number;
  /** Copies the Lagrange multipliers t of the rows (m entries) at the current iterate. At a solution gradient - A't is zero where
   * lower < x < upper, nonnegative at lower and nonpositive at upper. Errors: invalid argument. */
  obc_projected_gradient_multipliers(solver: Pointer, multipliers: Pointer, error: Pointer): number;
  /** Copies a certificate of infeasibility (Farkas) after INFEASIBLE: m numbers c with c'A x < c'b for every x within the bounds, where
   * entries of A'c below 1e-9 |c| count as zero against an infinite bound. certificate_gap of the result is c'b - max c'A x > 0.
   * Errors: invalid argument after any other end. */
  obc_projected_gradient_certificate(solver: Pointer, certificate: Pointer, error: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
   * saved run; a projection of the caller is taken from it. Both machines need the same byte order.
   * Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory. */
  obc_projected_gradient_save_size(solver: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
   * saved run; a projection of the caller is taken from it. Both machines need the same byte order.
   * Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory. */
  obc_projected_gradient_save(solver: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
   * saved run; a projection of the caller is taken from it. Both machines need the same byte order.
   * Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory. */
  obc_projected_gradient_load(problem: Pointer, blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a solver; NULL is allowed. */
  obc_projected_gradient_destroy(solver: Pointer): void;
  /** Runs to the end with a callback. x (n entries) is the start and receives the point of _get_result; result may be NULL.
   * Returns OBC_OK however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result
   * are filled in that case too. Errors: invalid argument, out of memory, cancelled. */
  obc_projected_gradient_minimize(problem: Pointer, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Computes the point x (n entries, not y) of the feasible set nearest to y. Bounds: clipping. One row: the root of a monotone
   * piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh 2018).
   * multipliers (m entries, or NULL) receives t with x = clip(y + A't), up to a last correction along the free unknowns
   * where y is too large for t to resolve it. result (or NULL) receives equality_residual, projection_passes, certificate_gap and
   * stop: CONVERGED, PROJECTION_FAILED, or INFEASIBLE, for which multipliers receives the certificate.
   * Errors: invalid argument, out of memory, cancelled. */
  obc_projected_gradient_project(problem: Pointer, y: Pointer, x: Pointer, multipliers: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Compares the gradient that f returns at x (n entries, moved into the bounds) with differences of its values along each axis,
   * within the bounds and without regard to rows. Use it after a run that ended as STALLED. Errors: invalid argument (also: f has
   * no value or gradient at x), cancelled (by the host or by STOP). */
  obc_projected_gradient_check_gradient(problem: Pointer, f: number, user: Pointer, x: Pointer, check: Pointer, host: Pointer, error: Pointer): number;
  /** Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL. */
  obc_projected_gradient_stop_name(stop: number): Pointer;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_projected_gradient_version(): number;
  /** Computes the Hamilton product out = p q of quaternions of any length. out may be p or q. */
  obc_quaternion_multiply(p: Pointer, q: Pointer, out: Pointer): void;
  /** Computes the inverse out = conjugate(q) / |q|^2 of a quaternion of any length; entries are not finite for zero. */
  obc_quaternion_inverse(q: Pointer, out: Pointer): void;
  /** Computes out = q / |q|, also where |q|^2 would overflow or underflow; NaN for zero. */
  obc_quaternion_normalize(q: Pointer, out: Pointer): void;
  /** Computes out = e^q of any quaternion. The rotation by the angle |v| about v is the exponential of (0, v / 2). */
  obc_quaternion_exponential(q: Pointer, out: Pointer): void;
  /** Computes the principal logarithm out = (log |q|, axis * angle), angle from 0 to pi, whose exponential is q. The axis is x for a negative
   * real q. w is -infinity for zero. */
  obc_quaternion_logarithm(q: Pointer, out: Pointer): void;
  /** Interpolates rotations along the shorter great-circle arc (Shoemake 1985): p at t = 0, and at t = 1 q or -q, the same
   * rotation. A t outside 0 to 1 extrapolates along the great circle. */
  obc_quaternion_slerp(p: Pointer, q: Pointer, t: number, out: Pointer): void;
  /** Computes the mean rotation: the unit quaternion that maximizes sum w_i (mean . q_i)^2, the dominant eigenvector of
   * sum w_i q_i q_i' (Markley, Cheng, Crassidis, Oshman 2007). Signs of the q_i have no effect; mean has a nonnegative scalar product
   * with the first q_i of positive weight. weights: `count` finite, nonnegative numbers, not all zero; NULL: all 1. *agreement (or
   * NULL) is sum w_i (mean . q_i)^2 / sum w_i, 1 for equal rotations. Errors: invalid argument; no valid result where
   * the mean is not unique, as for two opposite rotations. */
  obc_quaternion_average(q: Pointer, weights: Pointer, count: number, mean: Pointer, agreement: Pointer, error: Pointer): number;
  /** Rotates a vector: out = q v q^-1. out may be v. */
  obc_quaternion_rotate(q: Pointer, v: Pointer, out: Pointer): void;
  /** Computes the rotation by `angle` about `axis` of any length. Errors: invalid argument (axis zero or not finite). */
  obc_quaternion_from_axis_angle(axis: Pointer, angle: number, out: Pointer, error: Pointer): number;
  /** Computes the unit axis (3 doubles) and *angle, 0 to pi, of a rotation; (1, 0, 0) and 0 for the identity. */
  obc_quaternion_to_axis_angle(q: Pointer, axis: Pointer, angle: Pointer): void;
  /** Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest. */
  obc_quaternion_from_rotation_vector(v: Pointer, out: Pointer): void;
  /** Convert between the rotation by |v| about v and its rotation vector v with |v| at most pi, accurate for angles down to the smallest. */
  obc_quaternion_to_rotation_vector(q: Pointer, out: Pointer): void;
  /** Computes the rotation matrix (9 doubles, by rows) of q. */
  obc_quaternion_to_matrix(q: Pointer, out: Pointer): void;
  /** Computes the quaternion of a rotation matrix, its first nonzero component positive. Accurate for every rotation (of the four
   * formulas of Shepperd 1978 the one with the largest component). Errors: invalid argument unless R'R is the identity to 1e-6 and
   * R is not a reflection. */
  obc_quaternion_from_matrix(matrix: Pointer, out: Pointer, error: Pointer): number;
  /** Computes the rotation nearest to any 3x3 matrix M in the Frobenius norm, which also maximizes trace(R'M) (Davenport's q-method). Use it for
   * a rotation with noise or to orthonormalize vectors. Errors: no valid result where M is not finite or two rotations
   * are equally near. */
  obc_quaternion_nearest_to_matrix(matrix: Pointer, out: Pointer, error: Pointer): number;
  /** Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
   * -1. Errors: invalid argument for numbers from 24 on. */
  obc_quaternion_cube_element(number: number, out: Pointer, error: Pointer): number;
  /** Return a rotation by its number: the unit quaternion, its first nonzero component positive, and the matrix, whose entries are exactly 0, 1 or
   * -1. Errors: invalid argument for numbers from 24 on. */
  obc_quaternion_cube_matrix(number: number, out: Pointer, error: Pointer): number;
  /** Return the number of the product a b (b first) and of the inverse of a, from tables; OBC_QUATERNION_CUBE_NONE for a number out of
   * range. */
  obc_quaternion_cube_product(a: number, b: number): number;
  /** Return the number of the product a b (b first) and of the inverse of a, from tables; OBC_QUATERNION_CUBE_NONE for a number out of
   * range. */
  obc_quaternion_cube_inverse(a: number): number;
  /** Returns the conjugacy class of a number, -1 for a number out of range. */
  obc_quaternion_cube_class(number: number): number;
  /** Returns the number of the cube rotation nearest to r, of any nonzero length. The sorted magnitudes a1 >= a2 >= a3 >= a4 of the
   * components decide its class by the maximum of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2, the signs its axis. Ties: the
   * first class in this order, then the first components. O(1). */
  obc_quaternion_cube_nearest(r: Pointer): number;
  /** Returns the distance of the frames p and q in radians: the smallest angle of q^-1 p g over the 24 rotations g, at most 62.8
   * degrees. It is invariant under p h and q k with rotations h, k of the cube, and under r p and r q with any rotation r.
   * Exactly zero for p = q, otherwise accurate to a few 1e-16. */
  obc_quaternion_symmetric_distance(p: Pointer, q: Pointer): number;
  /** Returns sin^2 of half the distance, 1 - max over g of (p . q g)^2: the dissertation's energy 1 - s0^2 (eq. 6.10). */
  obc_quaternion_symmetric_sine_square(p: Pointer, q: Pointer): number;
  /** Returns the number of the g for which `from` g is nearest to the frame `to`. */
  obc_quaternion_symmetric_matching(from: Pointer, to: Pointer): number;
  /** Apply the function of the same name to each entry. */
  obc_quaternion_multiply_array(p: Pointer, q: Pointer, count: number, out: Pointer): void;
  /** Apply the function of the same name to each entry. */
  obc_quaternion_normalize_array(q: Pointer, count: number, out: Pointer): void;
  /** Apply the function of the same name to each entry. */
  obc_quaternion_rotate_array(q: Pointer, v: Pointer, count: number, out: Pointer): void;
  /** Apply the function of the same name to each entry. */
  obc_quaternion_slerp_array(p: Pointer, q: Pointer, t: Pointer, count: number, out: Pointer): void;
  /** Apply the function of the same name to each entry. */
  obc_quaternion_to_matrix_array(q: Pointer, count: number, out: Pointer): void;
  /** Converts rotation matrices. Errors: invalid argument with the index of the first matrix that is not a rotation; the quaternions before it are
   * written. */
  obc_quaternion_from_matrix_array(matrices: Pointer, count: number, out: Pointer, error: Pointer): number;
  /** Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]. */
  obc_quaternion_symmetric_distance_array(p: Pointer, q: Pointer, count: number, out: Pointer): void;
  /** Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]. */
  obc_quaternion_symmetric_sine_square_array(p: Pointer, q: Pointer, count: number, out: Pointer): void;
  /** Compute distance, sin^2 of half of it, and matching of each pair p[i], q[i] or from[i], to[i]. */
  obc_quaternion_symmetric_matching_array(from: Pointer, to: Pointer, count: number, out: Pointer): void;
  /** Computes the number of the cube rotation nearest to each r[i]. */
  obc_quaternion_cube_nearest_array(r: Pointer, count: number, out: Pointer): void;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_quaternion_version(): number;
  /** Fills options with the defaults. */
  obc_sphere_map_options_init(options: Pointer, struct_size: number): number;
  /** Fills a report with zeros and its size, which obc_sphere_map_compute and _measure require. */
  obc_sphere_map_report_init(report: Pointer, struct_size: number): number;
  /** Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. An inward-oriented surface is
   * mapped as seen from outside, with triangles clockwise on the sphere. Vertices in no triangle receive some unit vector. options,
   * report and host may be NULL. directions: 3 * vertex_count doubles, written on success only. O(n log n) time, up to 1 KB a
   * vertex. Errors: OBC_INVALID_ARGUMENT (NULL, NaN, index out of range, options), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD,
   * OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_compute(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, report: Pointer, error: Pointer): number;
  /** Maps a surface as obc_sphere_map_compute does, and keeps a partial map after OBC_NO_VALID_RESULT or OBC_CANCELLED: *placed is the
   * number of vertices with directions of their own, whose triangles are positive by exact arithmetic (clockwise for an
   * inward-oriented surface). Every other vertex has the direction of the vertex it was merged into, so that its triangles have zero area. If
   * *placed is the number of vertices in triangles, the map is a bijection whose optimization is incomplete. After other errors, and
   * if the work ended early, *placed is 0 and directions are unchanged. report is written on success only;
   * obc_sphere_map_measure measures partial maps. Errors: as obc_sphere_map_compute. */
  obc_sphere_map_compute_partial(surface: Pointer, options: Pointer, host: Pointer, directions: Pointer, placed: Pointer, report: Pointer, error: Pointer): number;
  /** Measures a map, valid or not: directions (3 * vertex_count doubles, normalized before use) of the surface. Of options only the weights
   * are used; options and host may be NULL. O(n). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. An invalid map is not
   * an error: see report->bijective. */
  obc_sphere_map_measure(surface: Pointer, directions: Pointer, options: Pointer, host: Pointer, report: Pointer, error: Pointer): number;
  /** Computes the distortion of each triangle: quasi-conformal distortion and area ratio as in the report, triangle_count
   * doubles each; either array may be NULL. Degenerate triangles (see obc_sphere_map_report) have an infinite distortion and the ratio
   * 0. O(n). Errors: as obc_sphere_map_measure. */
  obc_sphere_map_face_distortion(surface: Pointer, directions: Pointer, host: Pointer, quasi_conformal: Pointer, area_ratio: Pointer, error: Pointer): number;
  /** Rounds a map to float32, the precision of GLB and of engines, and moves vertices of triangles that rounding flips to nearby points.
   * rounded: 3 * vertex_count floats; all triangles are positive by exact arithmetic on success. Errors: OBC_INVALID_ARGUMENT,
   * OBC_NO_VALID_RESULT (float32 cannot represent the map), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_round_to_float(surface: Pointer, directions: Pointer, host: Pointer, rounded: Pointer, error: Pointer): number;
  /** Creates a locator from a bijective map (every triangle positive by exact arithmetic, or every triangle negative), with directions of
   * length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its allocator is
   * used until obc_sphere_map_locator_destroy. O(n) time, about 100 bytes a vertex. Errors: OBC_INVALID_ARGUMENT (also for a map
   * that is not bijective), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_DEGENERATE, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_locator_create(surface: Pointer, directions: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a locator; NULL is allowed. */
  obc_sphere_map_locator_destroy(locator: Pointer): void;
  /** Finds for each direction the triangle that contains it, exactly; on an edge or a vertex the lowest adjacent triangle. weights are the
   * barycentric coordinates of the intersection of the ray with the flat triangle of the map, nonnegative with sum 1, and
   * exactly 0 for a direction on the opposite edge. triangles: count indices, or NULL; weights: 3 * count doubles, or NULL. Uses the
   * threads of the host (or NULL). After a failure the arrays are undefined. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED,
   * OBC_OUT_OF_MEMORY. */
  obc_sphere_map_locate(locator: Pointer, directions: Pointer, count: number, host: Pointer, triangles: Pointer, weights: Pointer, error: Pointer): number;
  /** Interpolates values of the vertices, such as positions, normals or colors, at each direction. values: components * vertex_count
   * doubles; sampled: components * count. unit 1 scales each result to length 1 (for normals), 0 does not. The direction of a vertex
   * returns the values of the vertex. Errors: as obc_sphere_map_locate. */
  obc_sphere_map_sample(locator: Pointer, directions: Pointer, count: number, values: Pointer, components: number, unit: number, host: Pointer, sampled: Pointer, error: Pointer): number;
  /** Creates a regular triangulation with unit vectors for positions. *out is destroyed with obc_mesh_destroy; the allocator of the host is
   * used until then. O(size). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_grid(grid: number, resolution: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Resamples a surface on a regular triangulation: positions (3 * vertex_count doubles) interpolated at its directions. Otherwise as
   * obc_sphere_map_grid. */
  obc_sphere_map_remesh(locator: Pointer, positions: Pointer, grid: number, resolution: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Computes the size of a geometry image (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 * width *
   * height doubles, row by row from the top. OBC_SPHERE_MAP_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC_SPHERE_MAP_CUBE
   * six tiles of that size, 3 by 2: +x -x +y, below -y +z -z. Pixels on both sides of a cut are equal. resolution: up to
   * 4096. Errors: OBC_INVALID_ARGUMENT. */
  obc_sphere_map_image_size(layout: number, resolution: number, width: Pointer, height: Pointer, error: Pointer): number;
  /** Computes a geometry image of positions (3 * vertex_count doubles) or other vectors of the vertices. pixels is written on success
   * only. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_image(locator: Pointer, positions: Pointer, layout: number, resolution: number, host: Pointer, pixels: Pointer, error: Pointer): number;
  /** Reconstructs the closed surface of a geometry image. seam_gap (or NULL) receives the maximum distance between pixels of one vertex, whose
   * position is their mean. Errors: OBC_INVALID_ARGUMENT (also a pixel that is not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_image_surface(pixels: Pointer, layout: number, resolution: number, host: Pointer, out: Pointer, seam_gap: Pointer, error: Pointer): number;
  /** Writes a geometry image in the format of the file ending: .pfm (float32) or .png (16 bits a channel, relative to the bounding box,
   * which a text chunk stores). The file is complete or does not appear. Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED,
   * OBC_OUT_OF_MEMORY. */
  obc_sphere_map_image_write(path: Pointer, pixels: Pointer, layout: number, resolution: number, host: Pointer, error: Pointer): number;
  /** Reads layout and resolution of a geometry image, and its pixels into an array of `capacity` doubles unless pixels is NULL. A PNG file
   * without the text chunk has the unit cube for bounding box. Errors: as obc_sphere_map_image_write, and OBC_MALFORMED_FILE. */
  obc_sphere_map_image_read(path: Pointer, host: Pointer, layout: Pointer, resolution: Pointer, pixels: Pointer, capacity: number, error: Pointer): number;
  /** Computes the rotation, row by row, that maps `from` nearest to `to` in the least-squares sense (Kabsch 1976): 3 * count doubles each,
   * scaled to length 1. Where the pairs do not determine it, the rotation of minimum angle. Errors: OBC_INVALID_ARGUMENT. */
  obc_sphere_map_best_rotation(from: Pointer, to: Pointer, count: number, rotation: Pointer, error: Pointer): number;
  /** Creates a warp that maps from[i] to to[i]: 3 * count doubles each, of any length, with a distance of at least 0.01 between landmarks.
   * The allocator of the host is used until the warp is destroyed. Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the paths of
   * two landmarks cross), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_warp_create(from: Pointer, to: Pointer, count: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a warp; NULL is allowed. */
  obc_sphere_map_warp_destroy(warp: Pointer): void;
  /** Maps directions (3 * count doubles) by a warp (backward 0) or its inverse (backward 1); moved may be directions itself. Errors:
   * OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
  obc_sphere_map_warp_apply(warp: Pointer, directions: Pointer, count: number, backward: number, host: Pointer, moved: Pointer, error: Pointer): number;
  /** Computes one triangulation of the sphere with the vertices of two maps: those of the second are inserted into the triangles of the
   * first, whose edges are preserved; vertices at the same direction are merged. Only triangles and counts of the surfaces are used. *out
   * (positions: unit vectors) begins with the vertices of the first map, in its order. second_vertex (vertex_count of the second surface, or
   * NULL) receives the vertex of *out of each vertex of the second map (UINT32_MAX: in no triangle). Every triangle is positive. Errors: as
   * obc_sphere_map_locator_create, for the first map. */
  obc_sphere_map_overlay(first: Pointer, first_directions: Pointer, second: Pointer, second_directions: Pointer, host: Pointer, out: Pointer, second_vertex: Pointer, error: Pointer): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_sphere_map_version(): number;
  /** Fills options with the defaults. */
  obc_sphere_optimizer_options_init(options: Pointer, struct_size: number): number;
  /** Creates a solver over count >= 1 spheres in dimension >= 2 that starts from x0 (count * dimension numbers, each block scaled to
   * length 1). options and host may be NULL; what the host points to must remain valid until _destroy. Errors: invalid argument
   * (also a zero block of x0), out of memory. */
  obc_sphere_optimizer_create(count: number, dimension: number, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Advances to the next request and returns it: NEED_FG, ITERATION or DONE, or a negative obc_status for NULL or after a defect. *x
   * (x may be NULL) is the point of the request, in memory of the solver, valid until its next call. While a request waits for
   * _tell, and after DONE, the same request is returned. Does not allocate. */
  obc_sphere_optimizer_step(solver: Pointer, x: Pointer): number;
  /** Supplies value and gradient for NEED_FG. An entry that is not finite means that f is undefined there; gradient may then be
   * NULL. Errors: invalid argument if no request waits. */
  obc_sphere_optimizer_tell(solver: Pointer, value: number, gradient: Pointer, error: Pointer): number;
  /** Hands out the direction of a request NEED_PRODUCT, count * dimension numbers in memory of the solver, valid until its next call.
   * Errors: invalid argument if no product is requested. */
  obc_sphere_optimizer_get_direction(solver: Pointer, direction: Pointer, error: Pointer): number;
  /** Supplies the product of the Hessian and the direction, count * dimension numbers, for NEED_PRODUCT. NULL, or an entry that is not finite,
   * means that there is none at this point. Errors: invalid argument if no product is requested. */
  obc_sphere_optimizer_tell_product(solver: Pointer, product: Pointer, error: Pointer): number;
  /** Copies the current state at any time: result (or NULL), and x (or NULL). x is the iterate that satisfies the tolerance if the
   * run CONVERGED, otherwise the lowest point evaluated, and before the first value the start. Errors: invalid argument. */
  obc_sphere_optimizer_get_result(solver: Pointer, result: Pointer, x: Pointer, error: Pointer): number;
  /** Returns the number of spheres and their dimension, for runs that _load created; count and dimension may be NULL.
   * Errors: invalid argument. */
  obc_sphere_optimizer_get_shape(solver: Pointer, count: Pointer, dimension: Pointer, error: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
   * byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory. */
  obc_sphere_optimizer_save_size(solver: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
   * byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory. */
  obc_sphere_optimizer_save(solver: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
   * byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory. */
  obc_sphere_optimizer_load(blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a solver; NULL is allowed. */
  obc_sphere_optimizer_destroy(solver: Pointer): void;
  /** Runs to the end with a callback. x is the start and receives the point of _get_result; result may be NULL. Returns OBC_OK
   * however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result are filled in that case
   * too. Errors: invalid argument, out of memory, cancelled. */
  obc_sphere_optimizer_minimize(count: number, dimension: number, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** The same with TRUNCATED_NEWTON and products of the Hessian from a callback, whatever options->method and hessian_products are. */
  obc_sphere_optimizer_minimize_second_order(count: number, dimension: number, options: Pointer, f: number, product: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Fill blocks with no blocks, and options with the defaults. */
  obc_sphere_optimizer_blocks_init(blocks: Pointer, struct_size: number): number;
  /** Fill blocks with no blocks, and options with the defaults. */
  obc_sphere_optimizer_relaxation_options_init(options: Pointer, struct_size: number): number;
  /** Lowers f block by block. x (count * dimension numbers) is the start, scaled to length 1, and receives the end. options, host and
   * result may be NULL. Returns OBC_OK however it ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and
   * result are filled in that case too. Errors: invalid argument (also a neighbor out of range), out of memory, cancelled. */
  obc_sphere_optimizer_relax(blocks: Pointer, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Creates a relaxation that runs in parts. Copies blocks and x0 (scaled to length 1); what the host points to must remain valid until
   * _destroy. Errors: invalid argument, out of memory. */
  obc_sphere_optimizer_relaxation_create(blocks: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Relaxes up to `steps` more blocks without an allocation, and measures the gradients at the end of the relaxation. Returns OBC_OK
   * however it ended; stop is RUNNING where steps remain, CANCELLED where f returned STOP. After an interruption, also by the
   * host (OBC_CANCELLED), the current step is undone, and the next _run continues with the same bits as without the
   * interruption. Errors: invalid argument, cancelled. */
  obc_sphere_optimizer_relaxation_run(relaxation: Pointer, f: number, user: Pointer, steps: bigint, error: Pointer): number;
  /** Copies the current state: result (or NULL) and x (count * dimension numbers, or NULL). Errors: invalid argument. */
  obc_sphere_optimizer_relaxation_get_result(relaxation: Pointer, result: Pointer, x: Pointer, error: Pointer): number;
  /** Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
   * argument for others) and keeps its options. */
  obc_sphere_optimizer_relaxation_save_size(relaxation: Pointer): number;
  /** Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
   * argument for others) and keeps its options. */
  obc_sphere_optimizer_relaxation_save(relaxation: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
   * argument for others) and keeps its options. */
  obc_sphere_optimizer_relaxation_load(blocks: Pointer, blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a relaxation; NULL is allowed. */
  obc_sphere_optimizer_relaxation_destroy(relaxation: Pointer): void;
  /** Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL. */
  obc_sphere_optimizer_stop_name(stop: number): Pointer;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_sphere_optimizer_version(): number;
  /** Fills a problem with n = 0, a scalar f and no bounds. */
  obc_trust_region_problem_init(problem: Pointer, struct_size: number): number;
  /** Fills options with the defaults. */
  obc_trust_region_options_init(options: Pointer, struct_size: number): number;
  /** Creates a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL;
   * what the host points to must remain valid until _destroy. Errors: invalid argument, out of memory. */
  obc_trust_region_create(problem: Pointer, options: Pointer, x0: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Supplies earlier evaluations before the first step: `count` points (count x n, row by row, within the bounds) with their outputs
   * (count, or count x m). They do not count against max_evaluations. The run starts at the lowest of them in place of x0 and
   * uses nearby ones in place of its own evaluations; of more points than it can interpolate it keeps the lowest.
   * Errors: invalid argument (also for an output that is not finite), out of memory. */
  obc_trust_region_give(solver: Pointer, points: Pointer, outputs: Pointer, count: number, error: Pointer): number;
  /** Advances to the next request and returns it: NEED_VALUES, ITERATION or DONE, or a negative obc_status for NULL or after a
   * defect. With NEED_VALUES, *points (points may be NULL) are *count (count may be NULL) rows of n entries in memory of the solver,
   * valid until its next call other than _tell. The rows may be evaluated in parallel; there is one, except at the start of a
   * CROSS. Until _tell has supplied all of them, and after DONE, the same request is returned, without the supplied rows. */
  obc_trust_region_step(solver: Pointer, points: Pointer, count: Pointer): number;
  /** Supplies f, or m residuals, at the first requested point. An entry that is not finite, or outputs NULL, means that f is
   * undefined there. Errors: invalid argument if no request waits. */
  obc_trust_region_tell(solver: Pointer, outputs: Pointer, error: Pointer): number;
  /** Copies the current state at any time: result (or NULL), and the lowest evaluated point, x (n entries, or NULL), with its outputs
   * (1 or m, or NULL; NaN before the first value). Before the first value x is the start. Errors: invalid argument. */
  obc_trust_region_get_result(solver: Pointer, result: Pointer, x: Pointer, outputs: Pointer, error: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
   * saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
   * or of another version), out of memory. */
  obc_trust_region_save_size(solver: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
   * saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
   * or of another version), out of memory. */
  obc_trust_region_save(solver: Pointer, blob: Pointer, capacity: number, error: Pointer): number;
  /** Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
   * least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
   * saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
   * or of another version), out of memory. */
  obc_trust_region_load(problem: Pointer, blob: Pointer, size: number, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a solver; NULL is allowed. */
  obc_trust_region_destroy(solver: Pointer): void;
  /** Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Returns OBC_OK
   * however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result are filled in that case
   * too. Errors: invalid argument, out of memory, cancelled. */
  obc_trust_region_minimize(problem: Pointer, options: Pointer, f: number, user: Pointer, x: Pointer, result: Pointer, host: Pointer, error: Pointer): number;
  /** Returns the English name of a stop code, such as "converged"; a static string, never NULL. */
  obc_trust_region_stop_name(stop: number): Pointer;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_trust_region_version(): number;
  /** Fill options with the defaults, and a report with zeros. */
  obc_untangle_options_init(options: Pointer, struct_size: number): number;
  /** Fill options with the defaults, and a report with zeros. */
  obc_untangle_report_init(report: Pointer, struct_size: number): number;
  /** Fills a problem with no vertices. */
  obc_untangle_tetrahedra_problem_init(problem: Pointer, struct_size: number): number;
  /** Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem->positions; fixed coordinates are
   * unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
   * NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients; up to six attempts.
   * Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
   * errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
   * not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
   * malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
   * tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled. */
  obc_untangle_tetrahedra(problem: Pointer, options: Pointer, host: Pointer, result: Pointer, report: Pointer, error: Pointer): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_untangle_version(): number;
  /** Fills options with the defaults. */
  obc_volume_map_solid_options_init(options: Pointer, struct_size: number): number;
  /** Computes a polycube of the boundary of a solid and a map of the solid to it. Every tetrahedron is positive on the polycube and in
   * space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming.
   * Tetrahedra are split where the map requires it. The polycube of a cavity lies within that of the outer boundary; polycubes of
   * several pieces stand side by side along x. options and host may be NULL; the allocator of the host must remain valid until
   * _destroy. Takes minutes for a hundred thousand tetrahedra.
   * Errors: invalid argument; malformed file (index-range); degenerate; not manifold; not closed; no valid result with the
   * obstacle; out of memory; cancelled. */
  obc_volume_map_solid_compute(positions: Pointer, vertex_count: number, tetrahedra: Pointer, tetrahedron_count: number, options: Pointer, host: Pointer, out: Pointer, error: Pointer): number;
  /** Destroys a map; NULL is allowed. */
  obc_volume_map_solid_destroy(solid: Pointer): void;
  /** Return the number of vertices and of tetrahedra after splits; 0 for NULL. */
  obc_volume_map_solid_vertex_count(solid: Pointer): number;
  /** Return the number of vertices and of tetrahedra after splits; 0 for NULL. */
  obc_volume_map_solid_tetrahedron_count(solid: Pointer): number;
  /** Copies positions in space and on the polycube (x y z a vertex) and tetrahedra (four vertices each); each may be NULL.
   * Errors: invalid argument. */
  obc_volume_map_solid_copy(solid: Pointer, positions: Pointer, polycube: Pointer, tetrahedra: Pointer, error: Pointer): number;
  /** Returns the version of the library, major * 10000 + minor * 100 + patch. */
  obc_volume_map_version(): number;
}

export const words: Readonly<Record<string, Readonly<Record<string, Readonly<Record<string, number>>>>>>;
