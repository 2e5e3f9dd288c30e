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

typedef struct obc_sphere_map_options {
  uint32_t struct_size;
  int32_t method;      /* OBC_SPHERE_MAP_...; balanced by default */
  double angle_weight; /* positive; 0.1 by default */
  double area_weight;  /* not negative; 1 by default */
  uint64_t seed;       /* varies the order of equally good decimation steps; 0 by default */
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

/* Version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_sphere_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
