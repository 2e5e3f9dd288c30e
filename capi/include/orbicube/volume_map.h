/* Orbicube volume map: maps of tetrahedral meshes without inverted tetrahedra.
 *
 * Inverted tetrahedra are turned right by the method of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov (2021,
 * "Foldover-free maps in 50 lines of code", ACM Transactions on Graphics 40(4)): an energy that is finite where tetrahedra
 * are inverted is lowered by Newton's method while a parameter drives them back; docs/volume_map.md tells how. What leaves
 * this library is certified: the exact sign of each tetrahedron's volume is positive.
 *
 * Arrays: as in <orbicube/mesh.h>. Inputs are not kept after a call.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 */
#ifndef ORBICUBE_VOLUME_MAP_H
#define ORBICUBE_VOLUME_MAP_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A mesh to untangle: a view, kept by no function. Fill with _init, then set what there is. Coordinates are numbered
 * 3 * vertex + axis. */
typedef struct obc_volume_map_tangle {
  uint32_t struct_size;
  int32_t reserved;
  const double *positions;    /* x y z a vertex: where they are */
  size_t vertex_count;
  const uint32_t *tetrahedra; /* four vertices each; those of negative volume are inverted */
  size_t tetrahedron_count;
  const double *rest;         /* x y z a vertex, where each tetrahedron is positive and has the shape that it should have, of
                                 any size; NULL: all should be regular and of one size */
  const uint8_t *fixed;       /* one a coordinate, not 0 where it stays as it is; NULL: all are free */
  const uint32_t *ties;       /* one a coordinate: its group, a number below 3 * vertex_count, all of which are to be equal, or
                                 UINT32_MAX; NULL: none. A group with a fixed coordinate is fixed, any other starts at its mean */
} obc_volume_map_tangle;

/* Fill with _init. */
typedef struct obc_volume_map_untangle_options {
  uint32_t struct_size;
  int32_t steps;        /* of Newton's method at most, in each of three attempts, until no tetrahedron is inverted. Default 500 */
  int32_t polish_steps; /* then at most so many that lower the distortion and keep all positive. Default 20 */
  int32_t reserved;
  double volume_weight; /* how much changes of volume count beside those of angles, above 0. Default 1 */
} obc_volume_map_untangle_options;

/* Figures of a run. Determinants are those of the map from the wanted shapes, scaled so that 1 keeps the volume. */
typedef struct obc_volume_map_untangle_report {
  uint32_t struct_size;
  uint32_t first_inverted;          /* UINT32_MAX when there is none */
  uint64_t inverted_before, inverted; /* tetrahedra that are not positive, by exact arithmetic */
  uint64_t steps, polish_steps;     /* taken */
  double least_determinant, greatest_determinant;
  double energy;                    /* mean of |J|^2 / D^(2/3) + volume_weight (1 + D^2) / D; 5 at least with weight 1 */
} obc_volume_map_untangle_report;

/* A mesh of nothing; the defaults, which the members' comments give; zeros. */
OBC_API obc_status obc_volume_map_tangle_init(obc_volume_map_tangle *tangle, size_t struct_size);
OBC_API obc_status obc_volume_map_untangle_options_init(obc_volume_map_untangle_options *options, size_t struct_size);
OBC_API obc_status obc_volume_map_untangle_report_init(obc_volume_map_untangle_report *report, size_t struct_size);

/* Moves vertices until all tetrahedra are positive: result gets x y z a vertex, fixed coordinates to the bit, tied ones the
 * same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be NULL; result may be
 * tangle->positions. About 500 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
 * Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
 * all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
 * malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
 * rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled. */
OBC_API obc_status obc_volume_map_untangle(const obc_volume_map_tangle *tangle,
                                           const obc_volume_map_untangle_options *options, const obc_host *host,
                                           double *result, obc_volume_map_untangle_report *report, obc_error *error);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_volume_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
