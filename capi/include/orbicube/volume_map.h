/* Orbicube volume map: maps of solids to polycubes without inverted tetrahedra.
 *
 * Method. A polycube of the boundary is extended to the solid, and inverted tetrahedra are untangled as by <orbicube/untangle.h>; see
 * docs/volume_map.md. Every result is certified: each tetrahedron has positive volume by exact arithmetic. Hexahedral meshes are in
 * <orbicube/hexmesh.h>.
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

/* ---- parameterizations along frames ---------------------------------------------------------------------------------- */

/* Coordinates f of a solid, a chart for each tetrahedron, that minimize sum of volume |grad f - X|^2 for frames X (eq. 5.3 of the
 * dissertation) subject to transitions f_j = M f_i + g across faces, M one of the 24 rotations of the cube. */
typedef struct obc_volume_map_frame_map obc_volume_map_frame_map;

/* Options of a parameterization. Fill with _init. */
typedef struct obc_volume_map_frame_map_options {
  uint32_t struct_size;
  int32_t integer;      /* 1: gaps, planes of the boundary and singular edges become integers; 0: real numbers. Default: 0. */
  double cell_length;   /* length in space of a step of 1 of the coordinates; 0: that of about 10000 cells. Default: 0. */
  double feature_angle; /* minimum dihedral angle, in degrees, of boundary edges that computed frames follow; 0: none. Default: 0. */
} obc_volume_map_frame_map_options;

/* Figures of a parameterization. */
typedef struct obc_volume_map_frame_map_report {
  uint32_t struct_size;
  int32_t integers_optimal; /* 1: the integers are proven to be the best */
  double energy;            /* eq. 5.3 of cell_length f, over the volume of the solid */
  double integer_cost;      /* what rounding added to it */
  double residual;          /* maximum violation of the transitions, and of the planes of the boundary, in steps of the coordinates */
  double cell_length;       /* as in the options, or what 0 became */
  uint64_t inverted;        /* number of tetrahedra that are not positive, by exact arithmetic */
  uint64_t integers;        /* number of independent gaps, planes and constants of singular edges */
  uint64_t patches;         /* number of planes of the boundary */
  uint64_t cut_faces;       /* number of faces with a transition */
  uint64_t singular_edges;  /* number of edges around which the frames turn */
  uint64_t solves;          /* number of linear systems solved */
} obc_volume_map_frame_map_report;

/* Fill options with the defaults, and a report with zeros. */
OBC_API obc_status obc_volume_map_frame_map_options_init(obc_volume_map_frame_map_options *options, size_t struct_size);
OBC_API obc_status obc_volume_map_frame_map_report_init(obc_volume_map_frame_map_report *report, size_t struct_size);

/* Computes the parameterization of a solid as it is: nothing is split or untangled, so that tetrahedra may be inverted. positions:
 * x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: w x y z a tetrahedron, units, or NULL for computed
 * ones. options, host and report may be NULL; the allocator of the host must remain valid until _destroy. Takes the time of a sparse
 * direct solver, about 10 s for a hundred thousand tetrahedra.
 * Errors: no valid result (frames that no map follows, with the place); invalid argument; malformed file (index-range); degenerate;
 * not manifold; out of memory; cancelled. */
OBC_API obc_status obc_volume_map_frame_map_compute(const double *positions, size_t vertex_count, const uint32_t *tetrahedra,
                                                    size_t tetrahedron_count, const double *frames,
                                                    const obc_volume_map_frame_map_options *options, const obc_host *host,
                                                    obc_volume_map_frame_map_report *report, obc_volume_map_frame_map **out,
                                                    obc_error *error);

/* Destroys a parameterization; NULL is allowed. */
OBC_API void obc_volume_map_frame_map_destroy(obc_volume_map_frame_map *map);

/* Return the number of tetrahedra and of singular edges; 0 for NULL. */
OBC_API size_t obc_volume_map_frame_map_tetrahedron_count(const obc_volume_map_frame_map *map);
OBC_API size_t obc_volume_map_frame_map_singular_edge_count(const obc_volume_map_frame_map *map);

/* Copies, each unless NULL: parameters, the coordinates of the corners (12 a tetrahedron); of each face 4 t + k, opposite corner k of
 * tetrahedron t: the number of the rotation M to the chart beyond (obc_quaternion_cube_element), the gap g (three), 1 where the face
 * is cut and 0 elsewhere, and 2 axis + (1 where the axis is outward-oriented) of the constant coordinate on the boundary; singular
 * edges, two vertices each.
 * Errors: invalid argument. */
OBC_API obc_status obc_volume_map_frame_map_copy(const obc_volume_map_frame_map *map, double *parameters, uint8_t *rotations,
                                                 double *gaps, uint8_t *cut, uint8_t *labels, uint32_t *singular_edges,
                                                 obc_error *error);

/* ---- maps as functions ----------------------------------------------------------------------------------------------- */

/* Finds points in a mesh of tetrahedra. With the positions in space the map f is a function of points, with those of the image its
 * inverse. */
typedef struct obc_volume_map_locator obc_volume_map_locator;

/* Creates a locator; it copies the mesh. The allocator of the host must remain valid until _destroy. host may be NULL.
 * Errors: invalid argument; malformed file (index-range); out of memory; cancelled. */
OBC_API obc_status obc_volume_map_locator_create(const double *positions, size_t vertex_count, const uint32_t *tetrahedra,
                                                 size_t tetrahedron_count, const obc_host *host, obc_volume_map_locator **out,
                                                 obc_error *error);

/* Destroys a locator; NULL is allowed. */
OBC_API void obc_volume_map_locator_destroy(obc_volume_map_locator *locator);

/* Finds the tetrahedron of each point (x y z), UINT32_MAX where there is none, and the four weights of its corners, which add up to 1
 * (zeros where there is none); each output may be NULL. Weights may be -1e-9 at the boundary. Where tetrahedra share a point, the one
 * that holds it deepest is found, of equals the first. O(log n) a point; the same for any number of threads. host may be NULL. A locator
 * may be used by several threads at once.
 * Errors: invalid argument; out of memory; cancelled. */
OBC_API obc_status obc_volume_map_locator_locate(const obc_volume_map_locator *locator, const double *points, size_t point_count,
                                                 const obc_host *host, uint32_t *tetrahedra, double *weights, obc_error *error);

/* Computes images of located points: the weighted sums of values at the corners, `components` numbers a vertex of the mesh. images
 * receives `components` numbers a point, NaN where there is no tetrahedron. host may be NULL.
 * Errors: invalid argument; out of memory; cancelled. */
OBC_API obc_status obc_volume_map_locator_interpolate(const obc_volume_map_locator *locator, const uint32_t *tetrahedra,
                                                      const double *weights, size_t point_count, const double *values,
                                                      size_t components, const obc_host *host, double *images, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_volume_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
