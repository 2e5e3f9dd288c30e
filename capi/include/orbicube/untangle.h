/* Orbicube untangle: moves the vertices of a tetrahedral or a flat triangular mesh until no element is inverted.
 *
 * Method. Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov (2021, "Foldover-free maps in 50 lines of code", ACM
 * Transactions on Graphics 40(4)): Newton's method lowers an energy of the maps from target shapes to elements, which is finite for
 * inverted elements, while a parameter eps that falls to 0 makes them more and more expensive; see docs/untangle.md. Each result is
 * certified: every element is positive by exact arithmetic, and fixed coordinates are unchanged.
 *
 * A solution is not guaranteed where one exists: where no positions of the free vertices make all elements positive, the best positions
 * found are returned with the error. obc_untangle_refine_... split elements there; the other functions do not change the mesh.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 *
 * Example: four tetrahedra around a vertex that was moved out of their hull.
 *
 *   #include <orbicube/untangle.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     double positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 2, 2};
 *     const uint32_t tetrahedra[] = {0, 1, 2, 4, 0, 2, 3, 4, 0, 3, 1, 4, 1, 3, 2, 4}; // the inner vertex is the last one
 *     obc_untangle_tetrahedra_problem problem;
 *     obc_error error;
 *     obc_untangle_tetrahedra_problem_init(&problem, sizeof problem);
 *     problem.positions = positions;
 *     problem.vertex_count = 5;
 *     problem.tetrahedra = tetrahedra;
 *     problem.tetrahedron_count = 4;
 *     if (obc_untangle_tetrahedra(&problem, NULL, NULL, positions, NULL, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%g %g %g\n", positions[12], positions[13], positions[14]);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_UNTANGLE_H
#define ORBICUBE_UNTANGLE_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- options and figures --------------------------------------------------------------------------------------------- */

/* Options. Fill with _init. */
typedef struct obc_untangle_options {
  uint32_t struct_size;
  int32_t max_steps;        /* maximum number of Newton steps in each attempt, while elements are inverted. Default: 500. */
  int32_t max_polish_steps; /* maximum number of further steps that lower the distortion and keep all elements positive. Default: 20. */
  int32_t free_boundary;    /* 1: boundary vertices move unless they are in `fixed`; 0: they are fixed where no fixed ones are given. Default: 0. */
  double volume_weight;     /* weight of changes of volume, or of area, relative to changes of angles, positive. Default: 1. */
  double tolerance; /* polishing ends when a step lowers the energy by less than this fraction of it, 0 to below 1. Default: 1e-4. */
} obc_untangle_options;

/* Figures of a run. Determinants are those of the maps from the target shapes, scaled so that 1 preserves volume or area. */
typedef struct obc_untangle_report {
  uint32_t struct_size;
  uint32_t first_inverted;                 /* first element that is not positive; UINT32_MAX: none */
  uint64_t inverted_before, inverted;      /* number of elements that are not positive before and after, by exact arithmetic */
  uint64_t steps, polish_steps;            /* number of steps taken */
  double min_determinant, max_determinant; /* minimum and maximum determinant after */
  double energy; /* mean of |J|^2 / D^(2/d) + volume_weight (1 + D^2) / D in d dimensions; with weight 1 at least d + 2 */
} obc_untangle_report;

/* Fill options with the defaults, and a report with zeros. */
OBC_API obc_status obc_untangle_options_init(obc_untangle_options *options, size_t struct_size);
OBC_API obc_status obc_untangle_report_init(obc_untangle_report *report, size_t struct_size);

/* ---- tetrahedra ------------------------------------------------------------------------------------------------------ */

/* A tetrahedral mesh to untangle, with its constraints: a view of arrays of the caller. Coordinate 3 * vertex + axis is that of an axis
 * of a vertex. Fill with _init. */
typedef struct obc_untangle_tetrahedra_problem {
  uint32_t struct_size;
  int32_t reserved;

  const double *positions;    /* initial positions, x y z a vertex. Default: NULL, which must be set. */
  size_t vertex_count;        /* number of vertices. Default: 0. */
  const uint32_t *tetrahedra; /* four vertices a tetrahedron; inverted ones have negative volume. Default: NULL, which must be set. */
  size_t tetrahedron_count;   /* number of tetrahedra. Default: 0. */

  /* Rest positions, x y z a vertex, in which each tetrahedron is positive and has its target shape, of any size; NULL: the target
   * shapes are regular tetrahedra of equal size. Default: NULL. */
  const double *rest;

  const uint8_t *fixed; /* one entry a vertex, nonzero for a fixed one; NULL, unless fixed_coordinates is set or free_boundary is
                         * nonzero: boundary vertices are fixed. Default: NULL. */
  const uint8_t *fixed_coordinates; /* one entry a coordinate, nonzero for one that is fixed besides; NULL: none. Default: NULL. */

  /* Groups of equal coordinates: one entry a coordinate, the number of its group, below 3 * vertex_count, or UINT32_MAX for none;
   * NULL: no groups. A group with a fixed coordinate is fixed; any other group starts at its mean. Default: NULL. */
  const uint32_t *ties;
} obc_untangle_tetrahedra_problem;

/* Fills a problem with no vertices. */
OBC_API obc_status obc_untangle_tetrahedra_problem_init(obc_untangle_tetrahedra_problem *problem, size_t struct_size);

/* Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem->positions; fixed coordinates are
 * unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
 * NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients; up to six attempts.
 * Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
 * errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
 * not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
 * malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
 * tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled. */
OBC_API obc_status obc_untangle_tetrahedra(const obc_untangle_tetrahedra_problem *problem, const obc_untangle_options *options,
                                           const obc_host *host, double *result, obc_untangle_report *report, obc_error *error);

/* ---- triangles in the plane ------------------------------------------------------------------------------------------ */

/* A flat mesh of triangles to untangle, such as a map of a surface to the plane, with its constraints: a view of arrays of the caller.
 * Coordinate 2 * vertex + axis is that of an axis of a vertex. Fill with _init. */
typedef struct obc_untangle_triangles_problem {
  uint32_t struct_size;
  int32_t reserved;

  const double *positions;   /* initial positions, x y a vertex. Default: NULL, which must be set. */
  size_t vertex_count;       /* number of vertices. Default: 0. */
  const uint32_t *triangles; /* three vertices a triangle, counter-clockwise unless inverted. Default: NULL, which must be set. */
  size_t triangle_count;     /* number of triangles. Default: 0. */

  /* Rest positions, x y z a vertex, in which each triangle has its target shape, of any size: the surface that is mapped, or a flat mesh with
   * z = 0; NULL: the target shapes are equilateral triangles of equal size. Default: NULL. */
  const double *rest;

  const uint8_t *fixed; /* one entry a vertex, nonzero for a fixed one; NULL, unless fixed_coordinates is set or free_boundary is
                         * nonzero: boundary vertices are fixed. Default: NULL. */
  const uint8_t *fixed_coordinates; /* one entry a coordinate, nonzero for one that is fixed besides; NULL: none. Default: NULL. */

  /* Groups of equal coordinates: one entry a coordinate, the number of its group, below 2 * vertex_count, or UINT32_MAX for none;
   * NULL: no groups. A group with a fixed coordinate is fixed; any other group starts at its mean. Default: NULL. */
  const uint32_t *ties;
} obc_untangle_triangles_problem;

/* Fills a problem with no vertices. */
OBC_API obc_status obc_untangle_triangles_problem_init(obc_untangle_triangles_problem *problem, size_t struct_size);

/* Moves vertices in the plane until all triangles are positive, counter-clockwise. result receives x y a vertex and may be
 * problem->positions; fixed coordinates are unchanged and tied ones have the same bits. A mesh without inverted triangles is only polished.
 * Where the boundary is a polygon without self-intersections and is fixed, the triangles of the result cover it without overlap. options,
 * host and report may be NULL. Takes about 1 KB a triangle, and a sparse factor a step; up to six attempts.
 * Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
 * errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
 * not manifold (kinds non-manifold-edge and inconsistent-orientation: three triangles at an edge, or two on one side of it);
 * malformed file (kind index-range); degenerate (kind degenerate-face: a repeated vertex, a target shape without area;
 * degenerate-geometry: zero area); out of memory; cancelled. */
OBC_API obc_status obc_untangle_triangles(const obc_untangle_triangles_problem *problem, const obc_untangle_options *options,
                                          const obc_host *host, double *result, obc_untangle_report *report, obc_error *error);

/* ---- refinement ------------------------------------------------------------------------------------------------------ */

/* An untangled mesh whose elements were split where that is needed. */
typedef struct obc_untangle_refined obc_untangle_refined;

/* Untangle as obc_untangle_tetrahedra and obc_untangle_triangles do and, where the mesh as it is has no solution or none is found, split
 * elements: first all edges, faces and elements that join fixed vertices and are not in the boundary, then edges of elements that
 * remain inverted. New vertices are free, also between fixed ones inside; the boundary is not split, nor is a mesh without inverted elements.
 * A disk of triangles whose fixed boundary is a star-shaped polygon, all else being free and without ties, is always untangled, within the
 * precision of coordinates. Elements that become positive by rounding alone, with determinants below 1e-9, are split too. options,
 * host and report may be NULL; the allocator of the host must remain valid until _destroy. The report counts elements after splits, but
 * for inverted_before. Takes the time and memory of those functions for up to ten meshes, of up to about eight times the elements.
 * *out is NULL after an error. Errors: as those functions; after no valid result the report has the figures of the best mesh found. */
OBC_API obc_status obc_untangle_refine_tetrahedra(const obc_untangle_tetrahedra_problem *problem, const obc_untangle_options *options,
                                                  const obc_host *host, obc_untangle_refined **out, obc_untangle_report *report,
                                                  obc_error *error);
OBC_API obc_status obc_untangle_refine_triangles(const obc_untangle_triangles_problem *problem, const obc_untangle_options *options,
                                                 const obc_host *host, obc_untangle_refined **out, obc_untangle_report *report,
                                                 obc_error *error);

/* Destroys a mesh; NULL is allowed. */
OBC_API void obc_untangle_refined_destroy(obc_untangle_refined *refined);

/* Return the number of vertices, of which those of the problem are the first, and of elements; 0 for NULL. */
OBC_API size_t obc_untangle_refined_vertex_count(const obc_untangle_refined *refined);
OBC_API size_t obc_untangle_refined_element_count(const obc_untangle_refined *refined);

/* Copies the mesh to arrays of the caller, each of which may be NULL. d is 3 for tetrahedra and 2 for triangles. positions: d a vertex;
 * elements: d + 1 vertices each; parents: for each element the one of the problem that it is part of; origins and weights: d + 1 a
 * vertex, the vertices of the problem whose mean it is there, and their weights, which add up to 1 but for rounding; UINT32_MAX with
 * weight 0 for the rest. Errors: invalid argument. */
OBC_API obc_status obc_untangle_refined_copy(const obc_untangle_refined *refined, double *positions, uint32_t *elements,
                                             uint32_t *parents, uint32_t *origins, double *weights, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_untangle_version(void);

#ifdef __cplusplus
}
#endif

#endif
