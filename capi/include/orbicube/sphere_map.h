/* Orbicube sphere map: bijective, low-distortion maps of closed genus-0 triangle surfaces to the unit sphere.
 *
 * Method. The surface is decimated to a tetrahedron, which is mapped to the sphere; its vertices are inserted again into the
 * spherical kernels of their rings while a distortion energy is minimized (Praun and Hoppe 2003; docs/sphere_map.md describes the
 * terms of the energy and the barrier against collapsing triangles). Every triangle of a returned map is positive by exact
 * arithmetic.
 *
 * Arrays: positions and directions are x y z a vertex, 3 * vertex_count doubles; triangles are three vertex indices each,
 * 3 * triangle_count, counter-clockwise seen from outside. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 *
 * Example: maps a generated surface and prints the maximum quasi-conformal distortion.
 *
 *   #include <orbicube/sphere_map.h>
 *   #include <stdio.h>
 *
 *   static double directions[3 * 10000];
 *
 *   int main(void) {
 *     obc_mesh *mesh = NULL;
 *     obc_surface surface;
 *     obc_sphere_map_report report;
 *     obc_error error;
 *     if (obc_mesh_make("creature", 2000, 0, NULL, &mesh, &error) != OBC_OK) return 1;
 *     if (obc_mesh_surface(mesh, &surface, &error) != OBC_OK || surface.vertex_count > 10000) return 1;
 *     obc_sphere_map_report_init(&report, sizeof report);
 *     if (obc_sphere_map_compute(&surface, NULL, NULL, directions, &report, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("bijective: %d, largest distortion %.2f\n", (int)report.bijective, report.max_quasi_conformal);
 *     obc_mesh_destroy(mesh);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_SPHERE_MAP_H
#define ORBICUBE_SPHERE_MAP_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- maps ------------------------------------------------------------------------------------------------------------ */

/* Methods, by what they minimize. E_D is angle and E_A area distortion, defined at obc_sphere_map_report. */
enum {
  OBC_SPHERE_MAP_BALANCED = 0,   /* angle_weight E_D + area_weight E_A and a barrier on the worst triangle */
  OBC_SPHERE_MAP_ANGLE_AREA = 1, /* angle_weight E_D + area_weight E_A alone, to a local minimum */
  OBC_SPHERE_MAP_ISOMETRIC = 2,  /* the symmetric Dirichlet energy; the weights are unused, as in the next two */
  OBC_SPHERE_MAP_STRETCH = 3,    /* the L2 stretch of Praun and Hoppe */
  OBC_SPHERE_MAP_CONFORMAL = 4,  /* E_D alone */
  OBC_SPHERE_MAP_DISSERTATION = 5        /* the dissertation's chapter 3 as printed, corrected only where it would fail */
};

/* Receives the convergence of OBC_SPHERE_MAP_DISSERTATION (the dissertation's Figure 3.2) at the end of a level, and during the last level once for each
 * vertex_count iterations: iterations, the number of calls of its Algorithm 2 for one vertex; vertices, the vertex count of the
 * refined mesh; energy, the energy of that mesh. iterations restarts at 0 when the map restarts. Runs on the thread that called
 * the library. */
typedef void (*obc_sphere_map_trace_function)(uint64_t iterations, uint64_t vertices, double energy, void *user);

/* Options of a map. Fill with _init. */
typedef struct obc_sphere_map_options {
  uint32_t struct_size;
  int32_t method;      /* OBC_SPHERE_MAP_BALANCED or another. Default: BALANCED. */
  double angle_weight; /* weight of E_D (lambda of the dissertation's eq. 3.5), nonnegative. Default: 0.1. */
  double area_weight;  /* weight of E_A (mu of eq. 3.5), nonnegative; one of the two weights is positive. Default: 1. */
  uint64_t seed;       /* seed of the order of equally good decimation steps. Default: 0. */

  obc_sphere_map_trace_function trace; /* receives the convergence of OBC_SPHERE_MAP_DISSERTATION; NULL: none. Default: NULL. */
  void *trace_user;                    /* passed to trace. Default: NULL. */

  /* Parameters of the dissertation's Algorithm 1, which OBC_SPHERE_MAP_DISSERTATION uses and the other methods do not. An optimization
   * ends when the mean gain of its last iterations (level_splits of them on a level, vertex_count at the end) is below tolerance * E
   * / vertices, or at its maximum number of iterations. The dissertation prints the first default only. */
  uint64_t level_splits;         /* eta: vertex splits between two optimizations, 1 to 1000000000. Default: 40. */
  double level_tolerance;        /* epsilon^eta, of the optimization of a level, nonnegative; 0: no such end. Default: 1e-4. */
  double final_tolerance;        /* epsilon^F, of the final optimization, nonnegative; 0: no such end. Default: 1e-4. */
  uint64_t max_level_iterations; /* Iter_max^eta, on a level; 0: 50 * level_splits. Default: 0. */
  uint64_t max_final_iterations; /* Iter_max^F, at the end; 0: 100 * vertex_count. Default: 0. */
} obc_sphere_map_options;

/* Figures of a map, for a surface scaled to the area of the unit sphere, 4 pi. sigma_1 >= sigma_2 are the singular values of the affine
 * map from a surface triangle T to its flat spherical triangle t, d is the distance of t from the origin. Vertices in no
 * triangle do not count. Energies, distortions, ratios and means leave out degenerate triangles, whose angles are rounding errors:
 * those with a height of at most 1e-6 of the longest side, or at most 4 rounding units of the largest coordinate (2^-24 of it where
 * all coordinates of the surface are float32 values, otherwise 2^-53). */
typedef struct obc_sphere_map_report {
  uint32_t struct_size;

  int32_t bijective; /* 1: no triangle is flipped or degenerate by exact arithmetic, and the degree is 1; 0: otherwise */
  int32_t mirrored;  /* 1: most triangles are clockwise on the sphere, as for an inward-oriented surface; 0: otherwise */
  int32_t reserved;

  uint64_t flipped;         /* number of triangles oriented against the majority, by exact arithmetic */
  uint64_t degenerate;      /* number of triangles with zero area on the sphere, by exact arithmetic */
  uint64_t zero_area_faces; /* number of degenerate triangles on the surface, as defined above */
  double degree;            /* sum of the signed solid angles / 4 pi */

  double energy_angle; /* E_D = sum d^-2 (cot a |a|^2 + cot b |b|^2 + cot c |c|^2); at least 16 pi */
  double energy_area;  /* E_A = sum d^-2 area(t)^2 / area(T); at least 4 pi in the limit of fine meshes, on coarse ones a little less */
  double energy;       /* angle_weight E_D + area_weight E_A */

  double max_quasi_conformal; /* maximum quasi-conformal distortion sigma_1 / sigma_2, at least 1 */
  double mean_quasi_conformal;    /* mean quasi-conformal distortion, weighted by surface area, at least 1 */
  double min_area_ratio, max_area_ratio; /* minimum and maximum of solid angle / surface area of a triangle */
  double stretch_efficiency; /* 1 / mean of (sigma_1^-2 + sigma_2^-2) / 2, weighted by surface area (L2 stretch), at most 1 */
  double isometric_mean;     /* mean of (sigma_1^2 + sigma_2^2 + sigma_1^-2 + sigma_2^-2) / 4, weighted by surface area, at least 1 */

  /* Energies of the dissertation as printed, with D = cot a |a|^2 + cot b |b|^2 + cot c |c|^2 for the angles a, b, c of T and the
   * opposite edges of t, and area(t) the area of the flat triangle t. Eq. 3.1 and 3.3 vanish under refinement, since D is an integral
   * over t already: energy_angle is eq. 3.3 with D as E_D(T) area(t), a density. */
  double equation_3_1; /* sum D area(t) */
  double equation_3_2; /* sum area(t)^2 / area(T) */
  double equation_3_3; /* sum d^-2 D area(t) */
  double equation_3_4; /* sum d^-2 area(t)^2 / area(T); equal to energy_area */
} obc_sphere_map_report;

/* Fills options with the defaults. */
OBC_API obc_status obc_sphere_map_options_init(obc_sphere_map_options *options, size_t struct_size);

/* Fills a report with zeros and its size, which obc_sphere_map_compute and _measure require. */
OBC_API obc_status obc_sphere_map_report_init(obc_sphere_map_report *report, size_t struct_size);

/* Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. An inward-oriented surface is
 * mapped as seen from outside, with triangles clockwise on the sphere. Vertices in no triangle receive some unit vector. options,
 * report and host may be NULL. directions: 3 * vertex_count doubles, written on success only. O(n log n) time, up to 1 KB a
 * vertex. Errors: OBC_INVALID_ARGUMENT (NULL, NaN, index out of range, options), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD,
 * OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_compute(const obc_surface *surface, const obc_sphere_map_options *options,
                                          const obc_host *host, double *directions, obc_sphere_map_report *report,
                                          obc_error *error);

/* Maps a surface as obc_sphere_map_compute does, and keeps a partial map after OBC_NO_VALID_RESULT or OBC_CANCELLED: *placed is the
 * number of vertices with directions of their own, whose triangles are positive by exact arithmetic (clockwise for an
 * inward-oriented surface). Every other vertex has the direction of the vertex it was merged into, so that its triangles have zero area. If
 * *placed is the number of vertices in triangles, the map is a bijection whose optimization is incomplete. After other errors, and
 * if the work ended early, *placed is 0 and directions are unchanged. report is written on success only;
 * obc_sphere_map_measure measures partial maps. Errors: as obc_sphere_map_compute. */
OBC_API obc_status obc_sphere_map_compute_partial(const obc_surface *surface, const obc_sphere_map_options *options,
                                                  const obc_host *host, double *directions, size_t *placed,
                                                  obc_sphere_map_report *report, obc_error *error);

/* Measures a map, valid or not: directions (3 * vertex_count doubles, normalized before use) of the surface. Of options only the weights
 * are used; options and host may be NULL. O(n). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. An invalid map is not
 * an error: see report->bijective. */
OBC_API obc_status obc_sphere_map_measure(const obc_surface *surface, const double *directions,
                                          const obc_sphere_map_options *options, const obc_host *host,
                                          obc_sphere_map_report *report, obc_error *error);

/* Computes the distortion of each triangle: quasi-conformal distortion and area ratio as in the report, triangle_count
 * doubles each; either array may be NULL. Degenerate triangles (see obc_sphere_map_report) have an infinite distortion and the ratio
 * 0. O(n). Errors: as obc_sphere_map_measure. */
OBC_API obc_status obc_sphere_map_face_distortion(const obc_surface *surface, const double *directions,
                                                  const obc_host *host, double *quasi_conformal, double *area_ratio,
                                                  obc_error *error);

/* Rounds a map to float32, the precision of GLB and of engines, and moves vertices of triangles that rounding flips to nearby points.
 * rounded: 3 * vertex_count floats; all triangles are positive by exact arithmetic on success. Errors: OBC_INVALID_ARGUMENT,
 * OBC_NO_VALID_RESULT (float32 cannot represent the map), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_round_to_float(const obc_surface *surface, const double *directions,
                                                 const obc_host *host, float *rounded, obc_error *error);

/* ---- inverse of a map ------------------------------------------------------------------------------------------------ */

/* Point location in a map: a walk between triangles by exact determinants (Devillers, Pion and Teillaud 2002) that starts near the
 * direction; see docs/sphere_map_uses.md. A locator keeps copies of its inputs. Several threads may use one locator at the same time.
 * Query directions are finite, nonzero and of any length: 3 * count doubles. */
typedef struct obc_sphere_map_locator obc_sphere_map_locator;

/* Creates a locator from a bijective map (every triangle positive by exact arithmetic, or every triangle negative), with directions of
 * length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its allocator is
 * used until obc_sphere_map_locator_destroy. O(n) time, about 100 bytes a vertex. Errors: OBC_INVALID_ARGUMENT (also for a map
 * that is not bijective), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_DEGENERATE, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_locator_create(const obc_surface *surface, const double *directions,
                                                 const obc_host *host, obc_sphere_map_locator **out, obc_error *error);

/* Destroys a locator; NULL is allowed. */
OBC_API void obc_sphere_map_locator_destroy(obc_sphere_map_locator *locator);

/* Finds for each direction the triangle that contains it, exactly; on an edge or a vertex the lowest adjacent triangle. weights are the
 * barycentric coordinates of the intersection of the ray with the flat triangle of the map, nonnegative with sum 1, and
 * exactly 0 for a direction on the opposite edge. triangles: count indices, or NULL; weights: 3 * count doubles, or NULL. Uses the
 * threads of the host (or NULL). After a failure the arrays are undefined. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED,
 * OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_locate(const obc_sphere_map_locator *locator, const double *directions, size_t count,
                                         const obc_host *host, uint32_t *triangles, double *weights, obc_error *error);

/* Interpolates values of the vertices, such as positions, normals or colors, at each direction. values: components * vertex_count
 * doubles; sampled: components * count. unit 1 scales each result to length 1 (for normals), 0 does not. The direction of a vertex
 * returns the values of the vertex. Errors: as obc_sphere_map_locate. */
OBC_API obc_status obc_sphere_map_sample(const obc_sphere_map_locator *locator, const double *directions, size_t count,
                                         const double *values, size_t components, int32_t unit, const obc_host *host,
                                         double *sampled, obc_error *error);

/* ---- remeshing and geometry images ----------------------------------------------------------------------------------- */

/* Regular triangulations of the sphere, with the meaning of their resolution. */
enum {
  OBC_SPHERE_MAP_ICOSPHERE = 0, /* number of 1-to-4 subdivisions, 0 to 10; 10 * 4^n + 2 vertices */
  OBC_SPHERE_MAP_CUBE = 1,      /* quads along an edge of the cube, 1 to 4096; 6 n^2 + 2 vertices */
  OBC_SPHERE_MAP_LATITUDE = 2,  /* bands from pole to pole, 2 to 8192; 2 n (n - 1) + 2 vertices */
  OBC_SPHERE_MAP_OCTAHEDRON = 3 /* quads along a side of the square, even, 2 to 8192; n^2 + 2 vertices */
};

/* Creates a regular triangulation with unit vectors for positions. *out is destroyed with obc_mesh_destroy; the allocator of the host is
 * used until then. O(size). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_grid(int32_t grid, size_t resolution, const obc_host *host, obc_mesh **out,
                                       obc_error *error);

/* Resamples a surface on a regular triangulation: positions (3 * vertex_count doubles) interpolated at its directions. Otherwise as
 * obc_sphere_map_grid. */
OBC_API obc_status obc_sphere_map_remesh(const obc_sphere_map_locator *locator, const double *positions, int32_t grid,
                                         size_t resolution, const obc_host *host, obc_mesh **out, obc_error *error);

/* Computes the size of a geometry image (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 * width *
 * height doubles, row by row from the top. OBC_SPHERE_MAP_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC_SPHERE_MAP_CUBE
 * six tiles of that size, 3 by 2: +x -x +y, below -y +z -z. Pixels on both sides of a cut are equal. resolution: up to
 * 4096. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_sphere_map_image_size(int32_t layout, size_t resolution, size_t *width, size_t *height,
                                             obc_error *error);

/* Computes a geometry image of positions (3 * vertex_count doubles) or other vectors of the vertices. pixels is written on success
 * only. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_image(const obc_sphere_map_locator *locator, const double *positions, int32_t layout,
                                        size_t resolution, const obc_host *host, double *pixels, obc_error *error);

/* Reconstructs the closed surface of a geometry image. seam_gap (or NULL) receives the maximum distance between pixels of one vertex, whose
 * position is their mean. Errors: OBC_INVALID_ARGUMENT (also a pixel that is not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_image_surface(const double *pixels, int32_t layout, size_t resolution,
                                                const obc_host *host, obc_mesh **out, double *seam_gap,
                                                obc_error *error);

/* Writes a geometry image in the format of the file ending: .pfm (float32) or .png (16 bits a channel, relative to the bounding box,
 * which a text chunk stores). The file is complete or does not appear. Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED,
 * OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_image_write(const char *path, const double *pixels, int32_t layout, size_t resolution,
                                              const obc_host *host, obc_error *error);

/* Reads layout and resolution of a geometry image, and its pixels into an array of `capacity` doubles unless pixels is NULL. A PNG file
 * without the text chunk has the unit cube for bounding box. Errors: as obc_sphere_map_image_write, and OBC_MALFORMED_FILE. */
OBC_API obc_status obc_sphere_map_image_read(const char *path, const obc_host *host, int32_t *layout, size_t *resolution,
                                             double *pixels, size_t capacity, obc_error *error);

/* ---- rotations, warps and overlays of maps --------------------------------------------------------------------------- */

/* Computes the rotation, row by row, that maps `from` nearest to `to` in the least-squares sense (Kabsch 1976): 3 * count doubles each,
 * scaled to length 1. Where the pairs do not determine it, the rotation of minimum angle. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_sphere_map_best_rotation(const double *from, const double *to, size_t count, double rotation[9],
                                                obc_error *error);

/* A smooth bijection of the sphere that maps landmarks onto landmarks: the flow of minimum energy (Joshi and Miller 2000; Glaunes,
 * Vaillant and Miller 2004) on the vertices of an icosphere, every triangle positive by exact arithmetic. Several threads may use
 * one warp at the same time. */
typedef struct obc_sphere_map_warp obc_sphere_map_warp;

/* Creates a warp that maps from[i] to to[i]: 3 * count doubles each, of any length, with a distance of at least 0.01 between landmarks.
 * The allocator of the host is used until the warp is destroyed. Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the paths of
 * two landmarks cross), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_warp_create(const double *from, const double *to, size_t count, const obc_host *host,
                                              obc_sphere_map_warp **out, obc_error *error);

/* Destroys a warp; NULL is allowed. */
OBC_API void obc_sphere_map_warp_destroy(obc_sphere_map_warp *warp);

/* Maps directions (3 * count doubles) by a warp (backward 0) or its inverse (backward 1); moved may be directions itself. Errors:
 * OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_warp_apply(const obc_sphere_map_warp *warp, const double *directions, size_t count,
                                             int32_t backward, const obc_host *host, double *moved, obc_error *error);

/* Computes one triangulation of the sphere with the vertices of two maps: those of the second are inserted into the triangles of the
 * first, whose edges are preserved; vertices at the same direction are merged. Only triangles and counts of the surfaces are used. *out
 * (positions: unit vectors) begins with the vertices of the first map, in its order. second_vertex (vertex_count of the second surface, or
 * NULL) receives the vertex of *out of each vertex of the second map (UINT32_MAX: in no triangle). Every triangle is positive. Errors: as
 * obc_sphere_map_locator_create, for the first map. */
OBC_API obc_status obc_sphere_map_overlay(const obc_surface *first, const double *first_directions,
                                          const obc_surface *second, const double *second_directions,
                                          const obc_host *host, obc_mesh **out, uint32_t *second_vertex,
                                          obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_sphere_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
