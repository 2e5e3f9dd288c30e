/* Orbicube: bijective, low-distortion maps of closed genus-0 triangle surfaces to the unit sphere.
 *
 * The surface is decimated to a tetrahedron, which is put on the sphere, and its vertices are inserted again into the
 * spherical kernels of their rings while a distortion energy is lowered (Praun and Hoppe 2003; the energy's terms and
 * the barrier against collapsing triangles are described in docs/sphere_map.md). Every triangle of a map that is answered
 * is positive by exact arithmetic.
 *
 * Arrays: positions and directions are x y z a vertex, 3 * vertex_count doubles; triangles are three vertex indices each,
 * 3 * triangle_count, counter-clockwise seen from outside. Nothing is kept after a call.
 *
 * Thread safety: every function may be called from any number of threads at once. Results are the same bits for any
 * number of threads.
 */
#ifndef ORBICUBE_SPHERE_MAP_H
#define ORBICUBE_SPHERE_MAP_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What is minimised. E_D and E_A are angle and area distortion as in obc_sphere_map_report. */
enum {
  OBC_SPHERE_MAP_BALANCED = 0,   /* angle_weight E_D + area_weight E_A and a barrier on the worst triangle */
  OBC_SPHERE_MAP_ANGLE_AREA = 1, /* angle_weight E_D + area_weight E_A alone, to a local optimum */
  OBC_SPHERE_MAP_ISOMETRIC = 2,  /* the symmetric Dirichlet energy; the weights are not used, as in the next two */
  OBC_SPHERE_MAP_STRETCH = 3,    /* the L2 stretch of Praun and Hoppe */
  OBC_SPHERE_MAP_CONFORMAL = 4,  /* E_D alone */
  OBC_SPHERE_MAP_SEED = 5        /* the dissertation's chapter 3 as printed, mended only where it would fail */
};

/* Told of the course of method seed (the dissertation's Figure 3.2) when a level ends, and at the end once in as many
 * iterations as there are vertices: iterations, its Algorithm 2 called for one vertex each; the vertices of the mesh as it is
 * refined so far; the energy of that mesh. iterations begin from 0 again when the map has to be begun anew. Called on the
 * thread that called the library. */
typedef void (*obc_sphere_map_trace_function)(uint64_t iterations, uint64_t vertices, double energy, void *user);

typedef struct obc_sphere_map_options {
  uint32_t struct_size;
  int32_t method;      /* OBC_SPHERE_MAP_...; balanced by default */
  double angle_weight; /* positive; 0.1 by default */
  double area_weight;  /* not negative; 1 by default */
  uint64_t seed;       /* varies the order of equally good decimation steps; 0 by default */
  obc_sphere_map_trace_function trace; /* of method seed; NULL by default: not wanted */
  void *trace_user;
} obc_sphere_map_options;

/* Figures of a map. The surface counts as scaled to the area of the unit sphere, 4 pi. sigma are the singular values of the
 * affine map from a surface triangle to its flat spherical triangle t, d is the distance of t from the origin. */
typedef struct obc_sphere_map_report {
  uint32_t struct_size;
  int32_t bijective;         /* 1: no triangle flipped or degenerate, by exact arithmetic, and degree 1; else 0 */
  int32_t mirrored;          /* 1: most triangles are clockwise on the sphere, as for a surface that looks inward */
  int32_t reserved;
  uint64_t flipped;          /* triangles oriented against the others, by exact arithmetic */
  uint64_t degenerate;       /* triangles without area on the sphere, by exact arithmetic */
  uint64_t zero_area_faces;  /* triangles without area on the surface: they have no distortion */
  double degree;             /* sum of the signed solid angles / 4 pi */
  double energy_angle;       /* E_D = sum d^-2 (cot a |a|^2 + cot b |b|^2 + cot c |c|^2); at least 16 pi */
  double energy_area;        /* E_A = sum d^-2 area(t)^2 / area(T); at least 4 pi */
  double energy;             /* angle_weight E_D + area_weight E_A */
  double dilatation_largest; /* sigma_1 / sigma_2 */
  double dilatation_mean;    /* weighted by surface area */
  double area_ratio_smallest, area_ratio_largest; /* solid angle / surface area of a triangle */
  double stretch_efficiency; /* 1 / mean of (sigma_1^-2 + sigma_2^-2) / 2, weighted by surface area (L2 stretch) */
  double isometric_mean;     /* mean of (sigma_1^2 + sigma_2^2 + sigma_1^-2 + sigma_2^-2) / 4, by surface area */
} obc_sphere_map_report;

/* Fills options with the defaults. */
OBC_API obc_status obc_sphere_map_options_init(obc_sphere_map_options *options, size_t struct_size);

/* Fills a report with zeros and its size, which obc_sphere_map_compute and _measure need. */
OBC_API obc_status obc_sphere_map_report_init(obc_sphere_map_report *report, size_t struct_size);

/* Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. A surface that looks
 * inward is mapped as seen from outside: its triangles are then clockwise on the sphere. Vertices in no triangle get some
 * unit vector.
 * options, report and host may be NULL. directions: 3 * vertex_count doubles, written on success only.
 * O(n log n) time, at most 1 KB a vertex.
 * Errors: OBC_INVALID_ARGUMENT (NULL, NaN, index out of range, options), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD,
 * OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_compute(const obc_surface *surface, const obc_sphere_map_options *options,
                                          const obc_host *host, double *directions, obc_sphere_map_report *report,
                                          obc_error *error);

/* As obc_sphere_map_compute, and when that ends with OBC_NO_VALID_RESULT or OBC_CANCELLED, directions get what there is of the
 * map that came furthest: *placed vertices have places of their own, and their triangles are positive by exact arithmetic
 * (clockwise for a surface that looks inward); each other vertex is where the one is that it was merged into, so that its
 * triangles have no area. With *placed as many as there are vertices in triangles it is a bijection that is not optimised to
 * the end. *placed is 0, and directions are untouched, when the work did not come so far and for other errors. report is
 * written on success only; obc_sphere_map_measure measures partial maps.
 * Errors: as obc_sphere_map_compute. */
OBC_API obc_status obc_sphere_map_compute_partial(const obc_surface *surface, const obc_sphere_map_options *options,
                                                  const obc_host *host, double *directions, size_t *placed,
                                                  obc_sphere_map_report *report, obc_error *error);

/* Measures a map: directions (3 * vertex_count doubles, normalised before use) of the surface. Only the weights of
 * options are used; options and host may be NULL. O(n).
 * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. A bad map is no error: see report->bijective. */
OBC_API obc_status obc_sphere_map_measure(const obc_surface *surface, const double *directions,
                                          const obc_sphere_map_options *options, const obc_host *host,
                                          obc_sphere_map_report *report, obc_error *error);

/* Distortion of each triangle, for colouring: dilatation and area_ratio as in the report, triangle_count doubles each;
 * either may be NULL. Triangles without surface area have an infinite dilatation and the ratio 0. O(n).
 * Errors: as obc_sphere_map_measure. */
OBC_API obc_status obc_sphere_map_face_distortion(const obc_surface *surface, const double *directions,
                                                  const obc_host *host, double *dilatation, double *area_ratio,
                                                  obc_error *error);

/* Rounds a map to float32, the precision of engines and of GLB, and repairs the triangles that this turns over by moving
 * their vertices to nearby points. rounded: 3 * vertex_count floats, positive by exact arithmetic on success.
 * Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the map cannot be held in float32), OBC_CANCELLED,
 * OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_round_to_float(const obc_surface *surface, const double *directions,
                                                 const obc_host *host, float *rounded, obc_error *error);

/* ---- The inverse: which triangle a direction lies in ----------------------------------------------------------------
 * The locator is a walk from triangle to triangle by exact determinants (Devillers, Pion and Teillaud 2002) that starts
 * near the direction; see docs/sphere_map_uses.md. A locator keeps copies of what it is made from. Any number of threads may
 * use one locator at once. Directions that are asked about are finite, not zero, and need not be of length 1: 3 * count
 * doubles. */
typedef struct obc_sphere_map_locator obc_sphere_map_locator;

/* From a map that is a bijection (every triangle positive by exact arithmetic, or every triangle negative), with directions
 * of length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its
 * allocator is kept until obc_sphere_map_locator_destroy. O(n) time, about 100 bytes a vertex.
 * Errors: OBC_INVALID_ARGUMENT (also for what is no bijection), OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_DEGENERATE,
 * OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_locator_create(const obc_surface *surface, const double *directions,
                                                 const obc_host *host, obc_sphere_map_locator **out, obc_error *error);

/* NULL is fine. */
OBC_API void obc_sphere_map_locator_destroy(obc_sphere_map_locator *locator);

/* For each direction the triangle that it lies in, exactly; on an edge or a vertex, the lowest of the triangles there. weights:
 * where the ray along the direction meets the flat triangle of the map, as shares of its three corners, not negative, with
 * the sum 1; exactly 0 where the direction lies on the opposite edge. triangles: count indices, or NULL; weights: 3 * count
 * doubles, or NULL. On the threads of the host (or NULL). On failure what is written is of no use.
 * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_locate(const obc_sphere_map_locator *locator, const double *directions, size_t count,
                                         const obc_host *host, uint32_t *triangles, double *weights, obc_error *error);

/* Positions, normals, colours or other values of the vertices, interpolated where each direction lies. values: components *
 * vertex_count doubles; sampled: components * count. With unit 1 each result is scaled to length 1 (for normals), with 0
 * not. The direction of a vertex gives the vertex's own values.
 * Errors: as obc_sphere_map_locate. */
OBC_API obc_status obc_sphere_map_sample(const obc_sphere_map_locator *locator, const double *directions, size_t count,
                                         const double *values, size_t components, int32_t unit, const obc_host *host,
                                         double *sampled, obc_error *error);

/* Unit normals of the vertices, 3 * vertex_count doubles: the triangles' normals weighted by their angles (Thuermer and
 * Wuethrich 1998). O(n).
 * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_vertex_normals(const obc_surface *surface, const obc_host *host, double *normals,
                                                 obc_error *error);

/* ---- Remeshing and geometry images ---------------------------------------------------------------------------------- */

/* Regular triangulations of the sphere, and what their resolution says. */
enum {
  OBC_SPHERE_MAP_ICOSPHERE = 0, /* how often triangles are cut in four, 0 to 10; 10 * 4^n + 2 vertices */
  OBC_SPHERE_MAP_CUBE = 1,      /* quads along an edge of the cube, 1 to 4096; 6 n^2 + 2 vertices */
  OBC_SPHERE_MAP_LATITUDE = 2,  /* bands from pole to pole, 2 to 8192; 2 n (n - 1) + 2 vertices */
  OBC_SPHERE_MAP_OCTAHEDRON = 3 /* quads along a side of the square, even, 2 to 8192; n^2 + 2 vertices */
};

/* The triangulation alone, positions being unit vectors. *out is released with obc_mesh_destroy; host's allocator is kept until
 * then. O(size). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_grid(int32_t grid, size_t resolution, const obc_host *host, obc_mesh **out,
                                       obc_error *error);

/* The surface resampled on a triangulation: positions (3 * vertex_count doubles) at its directions. Else as
 * obc_sphere_map_grid. */
OBC_API obc_status obc_sphere_map_remesh(const obc_sphere_map_locator *locator, const double *positions, int32_t grid,
                                         size_t resolution, const obc_host *host, obc_mesh **out, obc_error *error);

/* Distances from points of one surface (vertices and centroids) to the nearest point of the other, and back. */
typedef struct obc_sphere_map_distance {
  uint32_t struct_size;
  uint32_t reserved;
  double first_mean, first_root_mean_square, first_largest;    /* from the first surface */
  double second_mean, second_root_mean_square, second_largest; /* from the second one */
} obc_sphere_map_distance;

/* Fills a result with zeros and its size. */
OBC_API obc_status obc_sphere_map_distance_init(obc_sphere_map_distance *distance, size_t struct_size);

/* On the threads of the host. O(n log n). Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_surface_distance(const obc_surface *first, const obc_surface *second,
                                                   const obc_host *host, obc_sphere_map_distance *distance,
                                                   obc_error *error);

/* Geometry images (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 * width * height doubles,
 * row by row from the top. OBC_SPHERE_MAP_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC_SPHERE_MAP_CUBE six tiles
 * of as many, 3 by 2: +x -x +y, below -y +z -z. Pixels that the cut tears apart are the same. resolution: at most 4096. */
OBC_API obc_status obc_sphere_map_image_size(int32_t layout, size_t resolution, size_t *width, size_t *height,
                                             obc_error *error);

/* positions: 3 * vertex_count doubles (or other vectors of the vertices). pixels: written on success only.
 * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_image(const obc_sphere_map_locator *locator, const double *positions, int32_t layout,
                                        size_t resolution, const obc_host *host, double *pixels, obc_error *error);

/* The closed surface back. seam_gap, or NULL: the greatest distance between pixels that are one vertex, which becomes their
 * mean. Errors: OBC_INVALID_ARGUMENT (also a pixel that is not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_image_surface(const double *pixels, int32_t layout, size_t resolution,
                                                const obc_host *host, obc_mesh **out, double *seam_gap,
                                                obc_error *error);

/* Files by the ending: .pfm (float32) or .png (16 bits a channel between the corners of the bounding box, which a text chunk
 * holds). Written whole or not at all. Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED,
 * OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_image_write(const char *path, const double *pixels, int32_t layout, size_t resolution,
                                              const obc_host *host, obc_error *error);

/* Says what is in a file; with pixels not NULL, of `capacity` doubles, reads it too. PNG files without the chunk fill the cube
 * from 0 to 1. Errors: as for writing, and OBC_MALFORMED_FILE. */
OBC_API obc_status obc_sphere_map_image_read(const char *path, const obc_host *host, int32_t *layout, size_t *resolution,
                                             double *pixels, size_t capacity, obc_error *error);

/* ---- Correspondence of two shapes through their spheres ---------------------------------------------------------------- */

/* The rotation, row by row, that takes `from` nearest to `to` (least squares; Kabsch 1976): 3 * count doubles each, scaled
 * to length 1. What the pairs leave open is turned as little as can be. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_sphere_map_best_rotation(const double *from, const double *to, size_t count, double rotation[9],
                                                obc_error *error);

/* A smooth bijection of the sphere that carries landmarks onto landmarks: the flow of least energy (Joshi and Miller 2000;
 * Glaunes, Vaillant and Miller 2004) on the vertices of an icosphere, every triangle positive by exact arithmetic. Any number
 * of threads may use one warp at once. */
typedef struct obc_sphere_map_warp obc_sphere_map_warp;

/* from[i] goes to to[i]: 3 * count doubles each, of any length, no two of them nearer than 0.01. host's allocator is kept.
 * Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (the ways of two landmarks meet), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_warp_create(const double *from, const double *to, size_t count, const obc_host *host,
                                              obc_sphere_map_warp **out, obc_error *error);

/* NULL is fine. */
OBC_API void obc_sphere_map_warp_destroy(obc_sphere_map_warp *warp);

/* Where each direction goes (backward 0) or comes from (backward 1): 3 * count doubles; moved may be directions itself.
 * Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_sphere_map_warp_apply(const obc_sphere_map_warp *warp, const double *directions, size_t count,
                                             int32_t backward, const obc_host *host, double *moved, obc_error *error);

/* One triangulation of the sphere with the vertices of two maps: the second's are inserted into the triangles of the first,
 * whose edges stay; vertices at the same direction become one. Only triangles and counts of the surfaces are used. The first
 * vertices of *out (positions: unit vectors) are those of the first map, in its order; second_vertex, second's vertex_count
 * indices or NULL, says where those of the second are (UINT32_MAX: in no triangle). Every triangle is positive.
 * Errors: as obc_sphere_map_locator_create, for the first map. */
OBC_API obc_status obc_sphere_map_overlay(const obc_surface *first, const double *first_directions,
                                          const obc_surface *second, const double *second_directions,
                                          const obc_host *host, obc_mesh **out, uint32_t *second_vertex,
                                          obc_error *error);

/* Version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_sphere_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
