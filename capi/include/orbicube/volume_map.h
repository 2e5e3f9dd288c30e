/* Orbicube volume map: maps of tetrahedral meshes without inverted tetrahedra, and hexahedral meshes.
 *
 * Inverted tetrahedra are turned right by the method of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov (2021,
 * "Foldover-free maps in 50 lines of code", ACM Transactions on Graphics 40(4)): an energy that is finite where tetrahedra
 * are inverted is lowered by Newton's method while a parameter drives them back; docs/volume_map.md tells how. What leaves
 * this library is certified: the exact sign of each tetrahedron's volume is positive, and hexahedra have a trilinear map that
 * is certainly positive everywhere.
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
 * tangle->positions. About 700 bytes a tetrahedron; a step is O(n) but for its conjugate gradients, 150 at most.
 * Errors: no valid result (some stay inverted: how many and the first; result and report then have the best that was found, on
 * all other errors nothing); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
 * not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
 * malformed file (kind index-range), degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a tetrahedron of
 * rest that is not positive; degenerate-geometry: no volume at all), out of memory, cancelled. */
OBC_API obc_status obc_volume_map_untangle(const obc_volume_map_tangle *tangle,
                                           const obc_volume_map_untangle_options *options, const obc_host *host,
                                           double *result, obc_volume_map_untangle_report *report, obc_error *error);

/* ---- solids on polycubes --------------------------------------------------------------------------------------------- */

/* A map of a solid to a polycube, one to one. */
typedef struct obc_volume_map_solid obc_volume_map_solid;

/* Fill with _init. */
typedef struct obc_volume_map_solid_options {
  uint32_t struct_size;
  int32_t reserved;
  size_t corners; /* of the polycube of a wall at most, as in obc_polycube_options. Default 100 */
  uint64_t seed;  /* of what is chosen at random. Default 0 */
} obc_volume_map_solid_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_volume_map_solid_options_init(obc_volume_map_solid_options *options, size_t struct_size);

/* Finds a polycube of the boundary of a solid and a map of the solid to it: every tetrahedron is positive, on the polycube and
 * in space, and the boundary covers the polycube once. positions: x y z a vertex; tetrahedra: four vertices each, positive,
 * meeting in whole faces. Tetrahedra are split where the map needs that. options and host may be NULL; the allocator of the
 * host must stay valid until _destroy. Minutes for a hundred thousand tetrahedra.
 * A cavity gets a polycube within that of the outer wall; the polycubes of pieces stand side by side along x.
 * Errors: invalid argument; malformed file (index-range), degenerate, not manifold, not closed; no valid result with what stood
 * in the way; out of memory, cancelled. */
OBC_API obc_status obc_volume_map_solid_compute(const double *positions, size_t vertex_count, const uint32_t *tetrahedra,
                                                size_t tetrahedron_count, const obc_volume_map_solid_options *options,
                                                const obc_host *host, obc_volume_map_solid **out, obc_error *error);
/* NULL is fine, here and in the functions that count (0). */
OBC_API void obc_volume_map_solid_destroy(obc_volume_map_solid *solid);
OBC_API size_t obc_volume_map_solid_vertex_count(const obc_volume_map_solid *solid);
OBC_API size_t obc_volume_map_solid_tetrahedron_count(const obc_volume_map_solid *solid);
/* x y z a vertex in space, and on the polycube; four vertices a tetrahedron. Each may be NULL. Errors: invalid argument. */
OBC_API obc_status obc_volume_map_solid_copy(const obc_volume_map_solid *solid, double *positions, double *polycube,
                                             uint32_t *tetrahedra, obc_error *error);

/* ---- hexahedra ------------------------------------------------------------------------------------------------------- */

/* A mesh of hexahedra, certified. */
typedef struct obc_volume_map_hexes obc_volume_map_hexes;

/* A layer of hexahedra along the boundary: where it serves, by the angles at the edges of the polycube (on all its faces, on some
 * or on none; where that turns out bad, none or all are tried, too); everywhere; nowhere. */
enum { OBC_VOLUME_MAP_PADDING_AUTO = 0, OBC_VOLUME_MAP_PADDING_WITH = 1, OBC_VOLUME_MAP_PADDING_WITHOUT = 2 };
/* What is filled with cells: a polycube of the surface; the box of the surface, of which the cells inside are taken, with a layer
 * around, which serves any shape but has more irregular edges; or the polycube, and the box where its hexahedra are not near to
 * the surface (distance, below), even twice as many, or poor (0.3 in scaled Jacobians), or where there is no polycube or one that
 * changes angles twofold. The box needs a layer: with padding without, auto is polycube, and voxels are an invalid argument. */
enum { OBC_VOLUME_MAP_METHOD_AUTO = 0, OBC_VOLUME_MAP_METHOD_POLYCUBE = 1, OBC_VOLUME_MAP_METHOD_VOXELS = 2 };
/* Fill with _init. */
typedef struct obc_volume_map_hexes_options {
  uint32_t struct_size;
  int32_t padding;  /* OBC_VOLUME_MAP_PADDING_...; auto by default */
  size_t cells;     /* about so many hexahedra, 1 to 10 million. Default 10000 */
  size_t corners;   /* of the polycube of a wall at most, as in obc_polycube_options. Default 100 */
  size_t triangles; /* a surface of more than twice as many is mapped by a coarser one of about so many; 0: never. Default 6000 */
  uint64_t seed;    /* of what the polycube chooses at random. Default 0 */
  int32_t rounds;   /* of smoothing. Default 40 */
  int32_t method;   /* OBC_VOLUME_MAP_METHOD_...; auto by default */
  /* In percent, 0 to 100: so far the boundary may be from the surface and the surface from the boundary, of the diagonal of its
   * box, and so much the volume may differ. Where that is not so, there are twice as many cells, and again, up to most_cells;
   * the nearest is answered. 0: nothing is asked for. Default 1 */
  double distance;
  size_t most_cells; /* about, 10 million at most; where less than cells, these are not changed. Default 100000 */
  /* Edges where the surface bends by so many degrees or more, 0 to below 180, are edges of hexahedra, where the polycube has edges
   * nearby, unless hexahedra there would be bad; 0: none. Default 40 */
  double sharp_angle;
} obc_volume_map_hexes_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_volume_map_hexes_options_init(obc_volume_map_hexes_options *options, size_t struct_size);

/* What was made. Fill struct_size. The scaled Jacobian of a hexahedron is the least, over its corners, of the determinant of the
 * three edges there over the product of their lengths: 1 for a box. */
typedef struct obc_volume_map_hexes_report {
  uint32_t struct_size;
  int32_t padded; /* 1: with a layer along the boundary or parts of it */
  double least_scaled_jacobian, mean_scaled_jacobian;
  double volume;           /* of the trilinear hexahedra */
  size_t polycube_corners; /* of the polycubes of all walls; 0 where there is none */
  size_t off_surface;      /* vertices of the boundary that could not be put where they belong */
  /* In percent, the farther of both ways, of points 1/400 of the diagonal apart at most, and of the volume of the surface. */
  double distance, volume_error;
  int32_t follows_sharp_edges; /* 1: those that the polycube has edges for */
  int32_t by_voxels;           /* 1: cells of the box, of one piece at least */
} obc_volume_map_hexes_report;

/* Fills a closed surface with hexahedra: oriented, looking outward, of any genus, in one piece or in several that lie apart,
 * which get their parts of the cells by their volumes. Parts within a piece that look inward are the walls of cavities, which
 * stay empty. Hexahedra meet in whole faces, the boundary has the parts and the genus of the surface, each hexahedron has
 * positive corners by exact signs and a trilinear map that is certainly positive. In the report of several pieces, corners and
 * vertices are all of them, distance and volume_error the largest, in percent of its own piece. options, host and report may be
 * NULL; the allocator of the host must stay valid until _destroy.
 * Errors: invalid argument; not closed; not manifold (kinds self-intersection: parts that meet, inconsistent-orientation: parts
 * that look into the solid); degenerate; malformed file; no valid result with what stood in the way; out of memory, cancelled. */
OBC_API obc_status obc_volume_map_hexes_compute(const obc_surface *surface, const obc_volume_map_hexes_options *options,
                                                const obc_host *host, obc_volume_map_hexes_report *report,
                                                obc_volume_map_hexes **out, obc_error *error);
/* NULL is fine, here and in the functions that count (0). */
OBC_API void obc_volume_map_hexes_destroy(obc_volume_map_hexes *hexes);
OBC_API size_t obc_volume_map_hexes_vertex_count(const obc_volume_map_hexes *hexes);
OBC_API size_t obc_volume_map_hexes_count(const obc_volume_map_hexes *hexes);
OBC_API size_t obc_volume_map_hexes_quad_count(const obc_volume_map_hexes *hexes);
/* x y z a vertex; eight vertices a hexahedron, in the order of MEDIT and VTK; four vertices a quad of the boundary,
 * counter-clockwise seen from outside, and the face of the polycube that it lies on (0 by voxels). Each may be NULL. Errors: invalid
 * argument. */
OBC_API obc_status obc_volume_map_hexes_copy(const obc_volume_map_hexes *hexes, double *positions, uint32_t *hexahedra,
                                             uint32_t *quads, uint32_t *quad_faces, obc_error *error);

/* ---- hexahedra along frames ------------------------------------------------------------------------------------------ */

/* Fill with _init. */
typedef struct obc_volume_map_frame_options {
  uint32_t struct_size;
  int32_t rounds;       /* of smoothing. Default 40 */
  size_t cells;         /* about so many hexahedra, 1 to 10 million. Default 10000 */
  double feature_angle; /* where frames are not given: an axis follows edges of the boundary that turn by more (radians);
                           0: none. Default 0 */
  /* As in obc_volume_map_hexes_options, of the boundary of the solid. Defaults 1 and 100000 */
  double distance;
  size_t most_cells;
} obc_volume_map_frame_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_volume_map_frame_options_init(obc_volume_map_frame_options *options, size_t struct_size);

/* What was made. Fill struct_size. Scaled Jacobians as in obc_volume_map_hexes_report. */
typedef struct obc_volume_map_frame_report {
  uint32_t struct_size;
  int32_t integers_optimal; /* 1: the search for the best integers came to its end */
  double least_scaled_jacobian, mean_scaled_jacobian;
  double volume;            /* of the trilinear hexahedra */
  size_t off_surface;       /* vertices of the boundary that could not be put where they belong */
  size_t singular_edges;    /* of the tetrahedra, inside */
  size_t irregular_edges;   /* of the hexahedra, inside: with other than four around */
  size_t integers;          /* unknown ones of the map */
  size_t tetrahedra;        /* of the map, after splits */
  size_t inverted_at_start; /* of these, when integers were chosen; none are in the end */
  size_t steps;             /* of Newton's method until there were none and the map was better */
  double distance, volume_error; /* as in obc_volume_map_hexes_report */
} obc_volume_map_frame_report;

/* Fills a solid with hexahedra that follow a frame field, with its singular edges inside (CubeCover: Nieser, Reitebuch and
 * Polthier 2011). positions: x y z a vertex; tetrahedra: four vertices each, positive, meeting in whole faces; frames: w x y z a
 * tetrahedron as in <orbicube/frame_field.h>, with an axis along the normal at the boundary, or NULL: several smooth fields are
 * made and repaired, until a map follows one. The faces of the result (obc_volume_map_hexes_copy) are the parts of the boundary
 * that lie in one plane of the map. Where their boundary is farther from that of the solid than asked for, it is held there, then
 * there are more cells, as in obc_volume_map_hexes_compute. options, host and report may be NULL; the allocator of the host must stay valid until _destroy.
 * Errors: invalid argument; malformed file (index-range), degenerate, not manifold; no valid result for a field that no such map
 * has, with the singular edge and its curve or the layer that would collapse, and for maps that stay inverted, with the place;
 * out of memory, cancelled. */
OBC_API obc_status obc_volume_map_frame_hexes_compute(const double *positions, size_t vertex_count,
                                                      const uint32_t *tetrahedra, size_t tetrahedron_count,
                                                      const double *frames, const obc_volume_map_frame_options *options,
                                                      const obc_host *host, obc_volume_map_frame_report *report,
                                                      obc_volume_map_hexes **out, obc_error *error);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_volume_map_version(void);

#ifdef __cplusplus
}
#endif

#endif
