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

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_volume_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
