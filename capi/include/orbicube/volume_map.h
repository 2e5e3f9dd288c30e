/* Orbicube volume map: maps of tetrahedral meshes without inverted tetrahedra.
 *
 * Method. Untangling follows Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov (2021, "Foldover-free maps in 50 lines of
 * code", ACM Transactions on Graphics 40(4)): Newton's method lowers an energy that is finite for inverted tetrahedra, while a
 * parameter forces their determinants to become positive; see docs/volume_map.md. Every result is certified: each tetrahedron has
 * positive volume by exact arithmetic. Hexahedral meshes are in <orbicube/hexmesh.h>.
 *
 * Arrays: as in <orbicube/mesh.h>. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 *
 * Example: maps a tetrahedron to a box.
 *
 *   #include <orbicube/volume_map.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     const double positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
 *     const uint32_t tetrahedron[] = {0, 1, 2, 3};
 *     obc_volume_map_solid *solid = NULL;
 *     obc_error error;
 *     if (obc_volume_map_solid_compute(positions, 4, tetrahedron, 1, NULL, NULL, &solid, &error) != OBC_OK)
 *       return puts(error.message), 1;
 *     printf("%zu tetrahedra\n", obc_volume_map_solid_tetrahedron_count(solid));
 *     obc_volume_map_solid_destroy(solid);
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

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_volume_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
