/* Orbicube correspondence: maps between closed surfaces, and the surfaces on one triangulation, so that they can be blended.
 *
 * Method. Through spheres: each genus-0 surface is mapped to the sphere (orbicube/sphere_map.h), the spheres are rotated to maximum
 * correlation of the positions, and the vertices of all maps form one triangulation of the sphere. Through a polycube: one polycube
 * is constructed for all surfaces, which have any one genus (orbicube/polycube.h), and its grid is carried to each. Points with one
 * image correspond: obc_correspondence_map takes points of one surface to another. `orbicube morph` writes the same mesh, bit for bit (before it is stored in float32).
 *
 * Arrays: positions are x y z a vertex, triangles three vertex indices each. Lengths are in the unit of the surfaces. No function
 * keeps its inputs.
 *
 * Thread safety: several threads may read one handle at the same time. Results are the same bits for any number of threads.
 *
 * Example: blends two generated surfaces half and half.
 *
 *   #include <orbicube/correspondence.h>
 *   #include <stdio.h>
 *   #include <stdlib.h>
 *
 *   int main(void) {
 *     obc_mesh *a = NULL, *b = NULL;
 *     obc_surface shapes[2];
 *     obc_correspondence *both = NULL;
 *     const double weights[2] = {0.5, 0.5};
 *     if (obc_mesh_make("creature", 500, 0, NULL, &a, NULL) != OBC_OK || obc_mesh_make("creature", 500, 1, NULL, &b, NULL) != OBC_OK) return 1;
 *     if (obc_mesh_surface(a, &shapes[0], NULL) != OBC_OK || obc_mesh_surface(b, &shapes[1], NULL) != OBC_OK) return 1;
 *     if (obc_correspondence_create(shapes, 2, NULL, NULL, &both, NULL) != OBC_OK) return 1;
 *     double *half = malloc(3 * obc_correspondence_vertex_count(both) * sizeof *half);
 *     if (half == NULL || obc_correspondence_blend(both, weights, 2, half, NULL) != OBC_OK) return 1;
 *     printf("first vertex halfway: %g %g %g\n", half[0], half[1], half[2]);
 *     free(half), obc_correspondence_destroy(both), obc_mesh_destroy(a), obc_mesh_destroy(b);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_CORRESPONDENCE_H
#define ORBICUBE_CORRESPONDENCE_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the surfaces are mapped to. */
enum {
  OBC_CORRESPONDENCE_SPHERE = 0,  /* spheres: two to 100 surfaces of genus 0 */
  OBC_CORRESPONDENCE_POLYCUBE = 1 /* one polycube: two to ten surfaces of one genus */
};

/* Rotation of spheres. */
enum {
  OBC_CORRESPONDENCE_ALIGN_SHAPE = 0,    /* to maximum correlation of the positions, for any poses of the surfaces */
  OBC_CORRESPONDENCE_ALIGN_ROTATION = 1, /* to maximum correlation of the positions, for equal poses */
  OBC_CORRESPONDENCE_ALIGN_NONE = 2      /* none */
};

/* Triangulation. */
enum {
  OBC_CORRESPONDENCE_GRID_BOTH = 0, /* the vertices of all surfaces; with a polycube, its grid */
  OBC_CORRESPONDENCE_GRID_FIRST = 1, /* the triangles of the first surface; with a polycube, as its map splits them */
  /* Grids of the sphere, of `resolution` as in obc_sphere_map_grid; not with a polycube: */
  OBC_CORRESPONDENCE_GRID_ICOSPHERE = 2,
  OBC_CORRESPONDENCE_GRID_CUBE = 3,
  OBC_CORRESPONDENCE_GRID_LATITUDE = 4,
  OBC_CORRESPONDENCE_GRID_OCTAHEDRON = 5
};

/* Pose of the further surfaces. */
enum {
  OBC_CORRESPONDENCE_KEPT = 0,   /* as given */
  OBC_CORRESPONDENCE_TURNED = 1, /* translated and rotated to the least-squares fit with the first (Umeyama 1991) */
  OBC_CORRESPONDENCE_SCALED = 2  /* scaled as well */
};

/* Options of a correspondence. Fill with _init. */
typedef struct obc_correspondence_options {
  uint32_t struct_size;
  int32_t via;       /* OBC_CORRESPONDENCE_SPHERE or POLYCUBE. Default: SPHERE. */
  int32_t align;     /* OBC_CORRESPONDENCE_ALIGN_SHAPE, ROTATION or NONE; unused with a polycube. Default: SHAPE. */
  int32_t grid;      /* OBC_CORRESPONDENCE_GRID_BOTH, FIRST or a grid of the sphere. Default: BOTH. */
  int32_t placement; /* OBC_CORRESPONDENCE_KEPT, TURNED or SCALED. Default: KEPT. */
  int32_t reserved;  /* 0 */
  double tolerance;  /* maximum deviation of an edge of GRID_BOTH from a further surface, in percent of the diagonal of that surface's
                        bounding box; longer edges are bisected, up to three times the vertices; 0: no limit; unused with a polycube.
                        Default: 0.2. */
  size_t cells;      /* number of quads of a polycube's grid, at most 100000000; 0: the maximum triangle count of the surfaces, 20000 to
                        400000. Default: 0. */
  size_t corners;    /* maximum number of polycube corners, at most 1000000; 0: no limit. Default: 0. */
  uint64_t seed;     /* seed of the maps. Default: 0. */
  size_t resolution; /* of a grid of the sphere. Default: 0. */
  size_t landmark_count;   /* number of landmarks of each surface; on spheres they replace `align`. Default: 0. */
  const double *landmarks; /* x y z of the landmarks of each surface, one surface after the other; landmarks of one number
                              correspond. The nearest point of the surface counts. Default: NULL. */
} obc_correspondence_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_correspondence_options_init(obc_correspondence_options *options, size_t struct_size);

/* Surfaces on one triangulation. */
typedef struct obc_correspondence obc_correspondence;

/* Brings closed surfaces onto one triangulation, whose vertex i is at corresponding points of all. Triangles are oriented consistently
 * and outward first. options and host may be NULL. *out is NULL after an error; the allocator of the host is used until the handle is
 * destroyed. Errors: OBC_INVALID_ARGUMENT, OBC_NOT_CLOSED, OBC_NOT_MANIFOLD, OBC_WRONG_GENUS, OBC_DEGENERATE, OBC_MALFORMED_FILE (kind
 * empty-mesh: no triangles), OBC_NO_VALID_RESULT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_correspondence_create(const obc_surface *surfaces, size_t count, const obc_correspondence_options *options,
                                             const obc_host *host, obc_correspondence **out, obc_error *error);

/* Destroys a correspondence; NULL is allowed. */
OBC_API void obc_correspondence_destroy(obc_correspondence *correspondence);

/* Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL. */
OBC_API size_t obc_correspondence_shape_count(const obc_correspondence *correspondence);
OBC_API size_t obc_correspondence_vertex_count(const obc_correspondence *correspondence);
OBC_API size_t obc_correspondence_triangle_count(const obc_correspondence *correspondence);

/* Copies the triangulation to arrays of the caller, each of which may be NULL: positions on surface number `shape` (3 * vertex count),
 * and triangles (3 * triangle count). Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_correspondence_copy(const obc_correspondence *correspondence, size_t shape, double *positions,
                                           uint32_t *triangles, obc_error *error);

/* Blends the surfaces: writes the sum of their positions times weights (`count` finite numbers, one a surface) to positions (3 * vertex
 * count). A weight of 1 for one surface and 0 for all others returns its positions. Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_correspondence_blend(const obc_correspondence *correspondence, const double *weights, size_t count,
                                            double *positions, obc_error *error);

/* Copies the positions of the vertices on the common sphere (unit vectors) or polycube (3 * vertex count). Every triangle is positive
 * there, by exact signs. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_correspondence_copy_domain(const obc_correspondence *correspondence, double *positions, obc_error *error);

/* Returns the number of quads of the polycube's grid, of which triangles 2 q and 2 q + 1 are the halves; 0 for other triangulations
 * and for NULL. */
OBC_API size_t obc_correspondence_quad_count(const obc_correspondence *correspondence);

/* Copies the quads (four vertex indices each, counter-clockwise seen from outside). Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_correspondence_copy_quads(const obc_correspondence *correspondence, uint32_t *quads, obc_error *error);

/* Returns the number of vertices of surface number `shape` as it was given; 0 if there is none. */
OBC_API size_t obc_correspondence_surface_vertex_count(const obc_correspondence *correspondence, size_t shape);

/* Maps `count` points of surface `from` to surface `to`: the inverse of the map of `to` after the map of `from`, one to one. A point
 * is a triangle of the surface as it was given and three weights at its corners, nonnegative with sum 1; results may overwrite the
 * points. Options of placement do not matter. host may be NULL. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_correspondence_map(const obc_correspondence *correspondence, size_t from, size_t to, const uint32_t *triangles,
                                          const double *weights, size_t count, const obc_host *host, uint32_t *mapped_triangles,
                                          double *mapped_weights, obc_error *error);

/* The same for all vertices of surface `from` (obc_correspondence_surface_vertex_count); a vertex in no triangle gets UINT32_MAX and
 * weights of 0. Errors: OBC_INVALID_ARGUMENT, OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_correspondence_map_vertices(const obc_correspondence *correspondence, size_t from, size_t to,
                                                   const obc_host *host, uint32_t *mapped_triangles, double *mapped_weights,
                                                   obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_correspondence_version(void);

#ifdef __cplusplus
}
#endif

#endif
