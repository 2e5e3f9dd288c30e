/* Orbicube volume map: maps of tetrahedral meshes without inverted tetrahedra, and hexahedral meshes.
 *
 * Method. Untangling follows Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov (2021, "Foldover-free maps in 50 lines of
 * code", ACM Transactions on Graphics 40(4)): Newton's method lowers an energy that is finite for inverted tetrahedra, while a
 * parameter forces their determinants to become positive; see docs/volume_map.md. Every result is certified: each tetrahedron has
 * positive volume by exact arithmetic, and each hexahedron has a trilinear map whose determinant is proven positive everywhere.
 *
 * Arrays: as in <orbicube/mesh.h>. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 *
 * Example: fills an L-shaped bar with about 1000 hexahedra.
 *
 *   #include <orbicube/volume_map.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_mesh *mesh = NULL;
 *     obc_surface surface;
 *     obc_volume_map_hexes_options options;
 *     obc_volume_map_hexes *hexes = NULL;
 *     obc_error error;
 *     obc_volume_map_hexes_options_init(&options, sizeof options);
 *     options.cells = 1000, options.max_hausdorff_percent = 0;
 *     if (obc_mesh_make("l-shape", 1000, 0, NULL, &mesh, &error) != OBC_OK) return 1;
 *     if (obc_mesh_surface(mesh, &surface, &error) != OBC_OK) return 1;
 *     if (obc_volume_map_hexes_compute(&surface, &options, NULL, NULL, &hexes, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%zu hexahedra\n", obc_volume_map_hexes_count(hexes));
 *     obc_volume_map_hexes_destroy(hexes);
 *     obc_mesh_destroy(mesh);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_VOLUME_MAP_H
#define ORBICUBE_VOLUME_MAP_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- untangling ------------------------------------------------------------------------------------------------------ */

/* A mesh to untangle, with its constraints: a view of arrays of the caller. Coordinate 3 * vertex + axis is that of an axis of a vertex. Fill with
 * _init. */
typedef struct obc_volume_map_untangle_problem {
  uint32_t struct_size;
  int32_t reserved;

  const double *positions;    /* initial positions, x y z a vertex. Default: NULL, which must be set. */
  size_t vertex_count;        /* number of vertices. Default: 0. */
  const uint32_t *tetrahedra; /* four vertices a tetrahedron; inverted ones have negative volume. Default: NULL, which must be set. */
  size_t tetrahedron_count;   /* number of tetrahedra. Default: 0. */

  /* Rest positions, x y z a vertex, in which each tetrahedron is positive and has its target shape, of any size; NULL: the target
   * shapes are regular tetrahedra of equal size. Default: NULL. */
  const double *rest;

  const uint8_t *fixed; /* one entry a coordinate, nonzero for a fixed one; NULL: all are free. Default: NULL. */

  /* Groups of equal coordinates: one entry a coordinate, the number of its group, below 3 * vertex_count, or UINT32_MAX for none;
   * NULL: no groups. A group with a fixed coordinate is fixed; any other group starts at its mean. Default: NULL. */
  const uint32_t *ties;
} obc_volume_map_untangle_problem;

/* Options of untangling. Fill with _init. */
typedef struct obc_volume_map_untangle_options {
  uint32_t struct_size;
  int32_t steps;        /* maximum number of Newton steps in each of three attempts, while tetrahedra are inverted. Default: 500. */
  int32_t polish_steps; /* maximum number of further steps that lower the distortion and keep all tetrahedra positive. Default: 20. */
  int32_t reserved;
  double volume_weight; /* weight of volume distortion relative to angle distortion, positive. Default: 1. */
} obc_volume_map_untangle_options;

/* Figures of untangling. Determinants are those of the maps from the target shapes, scaled so that 1 preserves the volume. */
typedef struct obc_volume_map_untangle_report {
  uint32_t struct_size;
  uint32_t first_inverted;            /* first tetrahedron that is not positive; UINT32_MAX: none */
  uint64_t inverted_before, inverted; /* number of tetrahedra that are not positive before and after, by exact arithmetic */
  uint64_t steps, polish_steps;       /* number of steps taken */
  double min_determinant, max_determinant; /* minimum and maximum determinant after */
  double energy; /* mean of |J|^2 / D^(2/3) + volume_weight (1 + D^2) / D; at least 5 with weight 1 */
} obc_volume_map_untangle_report;

/* Fill a mesh with no vertices, options with the defaults, and a report with zeros. */
OBC_API obc_status obc_volume_map_untangle_problem_init(obc_volume_map_untangle_problem *problem, size_t struct_size);
OBC_API obc_status obc_volume_map_untangle_options_init(obc_volume_map_untangle_options *options, size_t struct_size);
OBC_API obc_status obc_volume_map_untangle_report_init(obc_volume_map_untangle_report *report, size_t struct_size);

/* Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem->positions; fixed coordinates are
 * unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
 * NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients.
 * Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, for all other
 * errors they are unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
 * not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
 * malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
 * tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled. */
OBC_API obc_status obc_volume_map_untangle(const obc_volume_map_untangle_problem *problem,
                                           const obc_volume_map_untangle_options *options, const obc_host *host,
                                           double *result, obc_volume_map_untangle_report *report, obc_error *error);

/* ---- solids on polycubes --------------------------------------------------------------------------------------------- */

/* A bijective map of a solid to a polycube. */
typedef struct obc_volume_map_solid obc_volume_map_solid;

/* Options of a map of a solid. Fill with _init. */
typedef struct obc_volume_map_solid_options {
  uint32_t struct_size;
  int32_t reserved;
  size_t corners; /* maximum number of polycube corners per boundary component, as in obc_polycube_options; 0: no limit. Default: 100. */
  uint64_t seed;  /* seed of random choices. Default: 0. */
} obc_volume_map_solid_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_volume_map_solid_options_init(obc_volume_map_solid_options *options, size_t struct_size);

/* Computes a polycube of the boundary of a solid and a map of the solid to it. Every tetrahedron is positive on the polycube and in
 * space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming.
 * Tetrahedra are split where the map requires it. The polycube of a cavity lies within that of the outer boundary; polycubes of
 * several pieces stand side by side along x. options and host may be NULL; the allocator of the host must remain valid until
 * _destroy. Takes minutes for a hundred thousand tetrahedra.
 * Errors: invalid argument; malformed file (index-range); degenerate; not manifold; not closed; no valid result with the
 * obstacle; out of memory; cancelled. */
OBC_API obc_status obc_volume_map_solid_compute(const double *positions, size_t vertex_count, const uint32_t *tetrahedra,
                                                size_t tetrahedron_count, const obc_volume_map_solid_options *options,
                                                const obc_host *host, obc_volume_map_solid **out, obc_error *error);

/* Destroys a map; NULL is allowed. */
OBC_API void obc_volume_map_solid_destroy(obc_volume_map_solid *solid);

/* Return the number of vertices and of tetrahedra after splits; 0 for NULL. */
OBC_API size_t obc_volume_map_solid_vertex_count(const obc_volume_map_solid *solid);
OBC_API size_t obc_volume_map_solid_tetrahedron_count(const obc_volume_map_solid *solid);

/* Copies positions in space and on the polycube (x y z a vertex) and tetrahedra (four vertices each); each may be NULL.
 * Errors: invalid argument. */
OBC_API obc_status obc_volume_map_solid_copy(const obc_volume_map_solid *solid, double *positions, double *polycube,
                                             uint32_t *tetrahedra, obc_error *error);

/* ---- hexahedra ------------------------------------------------------------------------------------------------------- */

/* A certified hexahedral mesh. */
typedef struct obc_volume_map_hexes obc_volume_map_hexes;

/* Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches; where
 * the result is bad, it also tries none and all. */
enum { OBC_VOLUME_MAP_PADDING_AUTO = 0, OBC_VOLUME_MAP_PADDING_WITH = 1, OBC_VOLUME_MAP_PADDING_WITHOUT = 2 };

/* Methods. POLYCUBE: cells of a polycube of the surface. GRID (grid-based): inner cells of a grid over the bounding box with a layer
 * around them, which suits any shape but has more irregular edges; requires a layer, so that padding WITHOUT is an invalid
 * argument. AUTO: POLYCUBE, and GRID where the hexahedra of the polycube exceed `max_hausdorff_percent` with up to twice as many cells or have a
 * scaled Jacobian of 0.3 or less, or where there is no polycube or one with twofold angle distortion; with padding WITHOUT it is
 * POLYCUBE. */
enum { OBC_VOLUME_MAP_METHOD_AUTO = 0, OBC_VOLUME_MAP_METHOD_POLYCUBE = 1, OBC_VOLUME_MAP_METHOD_GRID = 2 };

/* Options of a hexahedral mesh. Fill with _init. */
typedef struct obc_volume_map_hexes_options {
  uint32_t struct_size;

  int32_t padding;  /* OBC_VOLUME_MAP_PADDING_AUTO, WITH or WITHOUT. Default: AUTO. */
  size_t cells;     /* approximate number of hexahedra, 1 to 10 million. Default: 10000. */
  size_t corners;   /* maximum number of polycube corners per boundary component, as in obc_polycube_options; 0: no limit. Default: 100. */
  size_t triangles; /* a surface of more than twice as many triangles is mapped through a coarse one of about that many; 0: never. Default: 6000. */
  uint64_t seed;    /* seed of random choices of the polycube. Default: 0. */
  int32_t rounds;   /* number of smoothing rounds, 0 to 1000. Default: 40. */
  int32_t method;   /* OBC_VOLUME_MAP_METHOD_AUTO, POLYCUBE or GRID. Default: AUTO. */

  /* Maximum two-sided distance to the surface, in percent of the bounding-box diagonal, and maximum volume error, in percent, 0 to
   * 100. While it is exceeded, the cell count is doubled, up to max_cells; the closest mesh is returned. 0 disables the check.
   * Default: 1. */
  double max_hausdorff_percent;

  size_t max_cells; /* approximate maximum cell count of doubling, up to 10 million; below `cells`: no doubling. Default: 100000. */

  /* Minimum dihedral angle of a sharp edge of the surface, in degrees, 0 to below 180. The mesh follows sharp edges near an edge of
   * the polycube, unless hexahedra there would be bad. 0: none. Default: 40. */
  double feature_angle;
} obc_volume_map_hexes_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_volume_map_hexes_options_init(obc_volume_map_hexes_options *options, size_t struct_size);

/* Figures of a hexahedral mesh. The scaled Jacobian of a hexahedron is the minimum over its corners of the determinant of the
 * three edges there over the product of their lengths: 1 for a box. The caller sets struct_size. */
typedef struct obc_volume_map_hexes_report {
  uint32_t struct_size;
  int32_t padded; /* 1: with a layer along the boundary or parts of it; 0: without */
  double min_scaled_jacobian, mean_scaled_jacobian; /* minimum and mean over the hexahedra */
  double volume;           /* total volume of the trilinear hexahedra */
  size_t polycube_corners; /* number of corners of the polycubes of all boundary components; 0: no polycube */
  size_t off_surface;      /* number of boundary vertices that could not be placed on the surface */

  /* Hausdorff distance of the boundary (quads split at their first vertex) and the surface, in percent of the bounding-box diagonal,
   * accurate to half a percent of itself, and volume error in percent, both of the whole solid. */
  double hausdorff_percent, volume_error_percent;

  int32_t follows_sharp_edges; /* 1: the mesh follows the sharp edges for which the polycube has edges; 0: it does not */
  int32_t grid_based;           /* 1: at least one piece is grid-based; 0: none */
} obc_volume_map_hexes_report;

/* Fills a closed, outward-oriented surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the
 * cells are divided by volume; inward-oriented components within a piece bound cavities. Hexahedra are conforming, the
 * boundary has the components and the genus of the surface, each hexahedron has positive corners by exact signs and a
 * trilinear map with proven positive determinant. options, host and report may be NULL; the allocator of the host must remain valid
 * until _destroy.
 * Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components
 * intersect; inconsistent-orientation: components oriented into the solid); degenerate; malformed file; no valid result with the
 * obstacle; out of memory; cancelled. */
OBC_API obc_status obc_volume_map_hexes_compute(const obc_surface *surface, const obc_volume_map_hexes_options *options,
                                                const obc_host *host, obc_volume_map_hexes_report *report,
                                                obc_volume_map_hexes **out, obc_error *error);

/* Destroys a mesh; NULL is allowed. */
OBC_API void obc_volume_map_hexes_destroy(obc_volume_map_hexes *hexes);

/* Return the number of vertices, hexahedra and boundary quads; 0 for NULL. */
OBC_API size_t obc_volume_map_hexes_vertex_count(const obc_volume_map_hexes *hexes);
OBC_API size_t obc_volume_map_hexes_count(const obc_volume_map_hexes *hexes);
OBC_API size_t obc_volume_map_hexes_quad_count(const obc_volume_map_hexes *hexes);

/* Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
 * counter-clockwise seen from outside) and the polycube patch of each quad (0 for grid-based ones); each may be NULL.
 * Errors: invalid argument. */
OBC_API obc_status obc_volume_map_hexes_copy(const obc_volume_map_hexes *hexes, double *positions, uint32_t *hexahedra,
                                             uint32_t *quads, uint32_t *quad_patches, obc_error *error);

/* ---- hexahedra along frames ------------------------------------------------------------------------------------------ */

/* Options of a frame-guided hexahedral mesh. Fill with _init. */
typedef struct obc_volume_map_frame_options {
  uint32_t struct_size;
  int32_t rounds; /* number of smoothing rounds, 0 to 1000. Default: 40. */
  size_t cells;   /* approximate number of hexahedra, 1 to 10 million. Default: 10000. */

  /* Minimum dihedral angle, in degrees, of boundary edges that an axis of the computed frames follows; unused for frames of the
   * caller. 0: none. Default: 0. */
  double feature_angle;

  double max_hausdorff_percent; /* as in obc_volume_map_hexes_options, relative to the boundary of the solid. Default: 1. */
  size_t max_cells;             /* as in obc_volume_map_hexes_options. Default: 100000. */
} obc_volume_map_frame_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_volume_map_frame_options_init(obc_volume_map_frame_options *options, size_t struct_size);

/* Figures of a frame-guided hexahedral mesh. The caller sets struct_size. */
typedef struct obc_volume_map_frame_report {
  uint32_t struct_size;
  int32_t integers_optimal; /* 1: the search proved the integers optimal; 0: it ended before */
  double min_scaled_jacobian, mean_scaled_jacobian; /* as in obc_volume_map_hexes_report */
  double volume;            /* total volume of the trilinear hexahedra */
  size_t off_surface;       /* number of boundary vertices that could not be placed on the surface */
  size_t singular_edges;    /* number of singular inner edges of the tetrahedra */
  size_t irregular_edges;   /* number of inner edges of the mesh with other than four hexahedra */
  size_t integers;          /* number of integer unknowns of the map */
  size_t tetrahedra;        /* number of tetrahedra of the map, after splits */
  size_t inverted_at_start; /* number of inverted tetrahedra after the choice of integers; the final map has none */
  size_t steps;             /* number of Newton steps of untangling and optimization */
  double hausdorff_percent, volume_error_percent; /* as in obc_volume_map_hexes_report */
} obc_volume_map_frame_report;

/* Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
 * Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: w x y z a tetrahedron as in
 * <orbicube/frame_field.h>, with an axis along the normal at the boundary, or NULL: several smooth fields are computed and repaired
 * until a map follows one. The patch numbers of obc_volume_map_hexes_copy are those of connected boundary regions in one
 * plane of the map. Where the boundary exceeds `max_hausdorff_percent`, it is fixed to the map's surface, then cells are added as in
 * obc_volume_map_hexes_compute. options, host and report may be NULL; the allocator of the host must remain valid until _destroy.
 * Errors: invalid argument; malformed file (index-range); degenerate; not manifold; no valid result for a field that no such map
 * follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted, with
 * the location; out of memory; cancelled. */
OBC_API obc_status obc_volume_map_frame_hexes_compute(const double *positions, size_t vertex_count,
                                                      const uint32_t *tetrahedra, size_t tetrahedron_count,
                                                      const double *frames, const obc_volume_map_frame_options *options,
                                                      const obc_host *host, obc_volume_map_frame_report *report,
                                                      obc_volume_map_hexes **out, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_volume_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
