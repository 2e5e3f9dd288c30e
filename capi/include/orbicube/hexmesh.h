/* Orbicube hexmesh: hexahedral meshes of closed surfaces and of tetrahedral solids.
 *
 * Method. A polycube of the surface is cut into cells that its map takes back into the solid; or the cells of a grid in space get a
 * layer along the surface; or cells follow a frame field on tetrahedra (CubeCover: Nieser, Reitebuch and Polthier 2011, "CubeCover -
 * parameterization of 3D volumes", Computer Graphics Forum 30(5)). The hexahedra are then smoothed with their boundary on the surface and
 * along its sharp edges; see docs/hexmesh.md. Every result is certified: hexahedra are conforming, the boundary has the components and the
 * genus of the surface and does not meet itself, each hexahedron has positive corners by exact signs and a trilinear map whose determinant
 * is proven positive everywhere. With the same options, the result has the same bits as that of the command `orbicube hex`.
 *
 * Arrays: as in <orbicube/mesh.h>. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 *
 * Example: fills an L-shaped bar with about 1000 hexahedra.
 *
 *   #include <orbicube/hexmesh.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_mesh *mesh = NULL;
 *     obc_surface surface;
 *     obc_hexmesh_options options;
 *     obc_hexmesh *hexes = NULL;
 *     obc_error error;
 *     obc_hexmesh_options_init(&options, sizeof options);
 *     options.cells = 1000, options.max_hausdorff_percent = 0;
 *     if (obc_mesh_make("l-shape", 1000, 0, NULL, &mesh, &error) != OBC_OK) return 1;
 *     if (obc_mesh_surface(mesh, &surface, &error) != OBC_OK) return 1;
 *     if (obc_hexmesh_compute(&surface, &options, NULL, NULL, &hexes, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%zu hexahedra\n", obc_hexmesh_count(hexes));
 *     obc_hexmesh_destroy(hexes);
 *     obc_mesh_destroy(mesh);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_HEXMESH_H
#define ORBICUBE_HEXMESH_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A certified hexahedral mesh. */
typedef struct obc_hexmesh obc_hexmesh;

/* Layers of hexahedra along the boundary. AUTO decides by the angles at the edges of the polycube: on all, some or none of its patches;
 * where the result is bad, it also tries none and all. With WITH and WITHOUT, method AUTO is POLYCUBE. */
enum { OBC_HEXMESH_PADDING_AUTO = 0, OBC_HEXMESH_PADDING_WITH = 1, OBC_HEXMESH_PADDING_WITHOUT = 2 };

/* Methods. POLYCUBE: cells of a polycube of the surface. GRID (grid-based): inner cells of a grid over the bounding box with a layer
 * around them, which suits any shape but has more irregular edges; requires a layer, so that padding WITHOUT is an invalid
 * argument. FRAMES: cells along a frame field on tetrahedra, with its singular edges inside; surfaces need `fill` for it. AUTO: FRAMES for
 * machined parts, whose edges of 40 degrees or more are at least half as long together as those of 10 to 40 degrees. For other
 * shapes, and where frames fail, exceed `max_hausdorff_percent` or leave a scaled Jacobian of 0.7 or less, POLYCUBE; then GRID where the
 * hexahedra of the polycube exceed `max_hausdorff_percent` with up to twice as many cells or have a scaled Jacobian of 0.3 or less, or where
 * there is no polycube or one with twofold angle distortion; FRAMES again where there is no other result. */
enum {
  OBC_HEXMESH_METHOD_AUTO = 0,
  OBC_HEXMESH_METHOD_POLYCUBE = 1,
  OBC_HEXMESH_METHOD_GRID = 2,
  OBC_HEXMESH_METHOD_FRAMES = 3
};

/* Sharp edges and corners of the surface that the mesh should have as chains of edges and as vertices. OFF: none in particular. AUTO: edges of
 * at least `feature_angle` and, of tagged edges, those at which the surface turns more than beside them. TAGS: all tagged edges and vertices and
 * no others. ANGLES: those of `feature_angle` alone. MACHINED: with methods AUTO and GRID and padding AUTO, as AUTO for machined parts, whose
 * edges of 40 degrees or more are at least half as long together as those of 10 to 40 or whose edges of `feature_angle` form lines, few of
 * which end or branch, and where edges or vertices are tagged; otherwise as OFF. Where the mesh of the method lacks some, a solid of one
 * piece is filled again by cells of a grid that have them embedded, with methods AUTO and GRID and without padding WITHOUT, and the mesh that
 * keeps more is returned. */
enum {
  OBC_HEXMESH_FEATURES_OFF = 0,
  OBC_HEXMESH_FEATURES_AUTO = 1,
  OBC_HEXMESH_FEATURES_TAGS = 2,
  OBC_HEXMESH_FEATURES_ANGLES = 3,
  OBC_HEXMESH_FEATURES_MACHINED = 4
};

/* Fills a closed surface with tetrahedra of at most max_volume, into a mesh whose first vertices are those of the surface, bit-identical and
 * in their order. Returns a status and fills *error as functions of Orbicube do; the caller destroys *out with obc_mesh_destroy. Called
 * by the thread that called Orbicube. */
typedef obc_status (*obc_hexmesh_fill_function)(const obc_surface *surface, double max_volume, const obc_host *host,
                                                obc_mesh **out, obc_error *error, void *user);

/* Options of a hexahedral mesh. Fill with _init. */
typedef struct obc_hexmesh_options {
  uint32_t struct_size;

  int32_t padding;  /* OBC_HEXMESH_PADDING_AUTO, WITH or WITHOUT. Default: AUTO. */
  size_t cells;     /* approximate number of hexahedra, 1 to 10 million. Default: 10000. */
  size_t corners;   /* maximum number of polycube corners per boundary component, as in obc_polycube_options; 0: no limit. Default: 100. */
  size_t triangles; /* a surface of more than twice as many triangles is mapped through a coarse one of about that many; 0: never. Default: 6000. */
  uint64_t seed;    /* seed of random choices of the polycube. Default: 0. */
  int32_t rounds;   /* number of smoothing rounds, 0 to 1000. Default: 40. */
  int32_t method;   /* OBC_HEXMESH_METHOD_AUTO, POLYCUBE, GRID or FRAMES. Default: AUTO. */

  /* Maximum two-sided distance to the surface, in percent of the bounding-box diagonal, and maximum volume error, in percent, 0 to
   * 100. While it is exceeded, the cell count is doubled, up to max_cells; the closest mesh is returned. 0 disables the check.
   * Default: 1. */
  double max_hausdorff_percent;

  size_t max_cells; /* approximate maximum cell count of doubling, up to 10 million; below `cells`: no doubling. Default: 100000. */

  /* Minimum dihedral angle, in degrees, 0 to below 180, of surface edges that the mesh follows: those near an edge of the polycube, unless
   * hexahedra there would be bad, or those along which an axis of computed frames lies. 0: none. -1: 35 with
   * `features` other than OFF, where there are some; else 40, but 0 for method FRAMES and for frames of the caller. Default: -1. */
  double feature_angle;

  int32_t features; /* OBC_HEXMESH_FEATURES_OFF, AUTO, TAGS, ANGLES or MACHINED. Default: MACHINED. */

  /* Edges, two vertices of the input each, and vertices that `features` AUTO and TAGS consider. Default: NULL. */
  const uint32_t *tagged_edges;
  size_t tagged_edge_count;        /* number of tagged edges. Default: 0. */
  const uint32_t *tagged_vertices; /* tagged vertices. Default: NULL. */
  size_t tagged_vertex_count;      /* number of tagged vertices. Default: 0. */

  /* Fills surfaces for frames: obc_tetrahedra_fill_mesh of <orbicube/tetrahedra.h> (TetGen, under the AGPL), or a function of the caller.
   * NULL: surfaces go by polycubes and grids only; method FRAMES then requires a tetrahedral solid. Default: NULL. */
  obc_hexmesh_fill_function fill;

  void *fill_user; /* passed to fill as user. Default: NULL. */

  /* Numbers of the regions of the tetrahedra of obc_hexmesh_compute_solid, one each, as of materials. Faces of the mesh are moved onto the
   * faces between regions, and each hexahedron gets the number of its region. NULL: no regions. Default: NULL. */
  const int32_t *regions;
  size_t region_count; /* number of entries of regions: that of the tetrahedra, or 0. Default: 0. */
} obc_hexmesh_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_hexmesh_options_init(obc_hexmesh_options *options, size_t struct_size);

/* Figures of a hexahedral mesh. The scaled Jacobian of a hexahedron is the minimum over its corners of the determinant of the
 * three edges there over the product of their lengths: 1 for a box. Members from integers_optimal to fields are about frames and 0 for other
 * methods; those after them are about features and 0 where none are kept. The caller sets struct_size. */
typedef struct obc_hexmesh_report {
  uint32_t struct_size;
  int32_t padded; /* 1: with a layer along the boundary or parts of it; 0: without */
  double min_scaled_jacobian, mean_scaled_jacobian; /* minimum and mean over the hexahedra */
  double volume;           /* total volume of the trilinear hexahedra */
  size_t polycube_corners; /* number of corners of the polycubes of all boundary components; 0: no polycube */
  size_t off_surface;      /* number of boundary vertices that could not be placed on the surface */

  /* Hausdorff distance of the boundary (quads split at their first vertex) and the surface, in percent of the bounding-box diagonal,
   * accurate to half a percent of itself, and volume error in percent, both of the whole solid. */
  double hausdorff_percent, volume_error_percent;

  int32_t follows_sharp_edges; /* 1: the mesh follows the sharp edges for which the polycube has edges; 0: it does not */
  int32_t grid_based;          /* 1: at least one piece is grid-based; 0: none */
  int32_t method;              /* OBC_HEXMESH_METHOD_POLYCUBE, GRID (at least one piece) or FRAMES */
  int32_t integers_optimal;    /* 1: the search proved the integers optimal; 0: it ended before */
  size_t singular_edges;       /* number of singular inner edges of the tetrahedra */
  size_t irregular_edges;      /* number of inner edges of the mesh with other than four hexahedra */
  size_t integers;             /* number of integer unknowns of the map */
  size_t tetrahedra;           /* number of tetrahedra of the map, after splits */
  size_t inverted_at_start;    /* number of inverted tetrahedra after the choice of integers; the final map has none */
  size_t steps;                /* number of Newton steps of untangling and optimization */
  size_t fields;               /* number of fields that were computed, the last being that of the mesh; 0 for frames of the caller */

  size_t feature_curves;        /* number of feature curves between corners */
  size_t feature_corners;       /* number of vertices where feature curves end, branch or bend */
  size_t missing_features;      /* number of these curves and corners that the mesh lacks */
  double captured;              /* fraction of the length of the curves with a mesh edge along it: within a tenth of the mean boundary edge,
                                   turned by at most 25 degrees; 1 without curves */
  double scaled_jacobian_bound; /* largest minimum scaled Jacobian that hexahedra at the features can have, two in each sector between curves */
  int32_t embedded;             /* 1: the cells of a grid with the features embedded; 0: the mesh of the method */

  int32_t conforming;              /* 1: faces of hexahedra are where regions of the solid meet; 0: they are not, or there are no regions */
  size_t region_quads;             /* number of faces between hexahedra of different regions, where conforming is 1 */
  double region_hausdorff_percent; /* Hausdorff distance of these and the faces between regions of the solid, by their vertices and
                                      centers, in percent of the bounding-box diagonal */
} obc_hexmesh_report;

/* A feature that the mesh lacks: a corner, or a curve with less than 95 % of its length captured. The caller sets struct_size. */
typedef struct obc_hexmesh_missing {
  uint32_t struct_size;
  int32_t corner;           /* 1: a corner; 0: a curve */
  double first[3], last[3]; /* ends of the curve; the position of the corner, twice */
  double captured;          /* captured fraction of the length of the curve; 0 for a corner */
} obc_hexmesh_missing;

/* Fills a closed surface of any genus with hexahedra. The surface may have several disjoint pieces, among which the cells are divided by
 * volume; components within a piece bound cavities. Triangles are reversed where neighbors disagree and where components are oriented
 * into their solid; the log of the host says so. A few triangles may intersect others of their component, up to a twentieth of them. The
 * volume of the result is infinite or 0 where the unit of the surface takes it out of the range of double. options, host and report
 * may be NULL; the allocator of the host must remain valid until _destroy. Takes from a second to many minutes.
 * Errors: invalid argument (also: more pieces than cells); not closed; not manifold (kinds self-intersection: components intersect;
 * non-orientable); degenerate; malformed file; not connected (method FRAMES: several pieces); unsupported (method FRAMES without
 * `fill`); no valid result with the obstacle; those of `fill`; out of memory; cancelled. */
OBC_API obc_status obc_hexmesh_compute(const obc_surface *surface, const obc_hexmesh_options *options, const obc_host *host,
                                       obc_hexmesh_report *report, obc_hexmesh **out, obc_error *error);

/* Fills a solid of tetrahedra with hexahedra. positions: x y z a vertex; tetrahedra: four vertices each, positive, conforming; frames: NULL,
 * or for the methods AUTO, which then is FRAMES, and FRAMES w x y z a tetrahedron as in <orbicube/frame_field.h>, with an axis along the
 * normal at the boundary. For method FRAMES without frames several smooth fields are computed and repaired until a map
 * follows one. The patch numbers of obc_hexmesh_copy are then those of connected boundary regions in one plane of the map. options, host
 * and report may be NULL; the allocator of the host must remain valid until _destroy.
 * Errors: as obc_hexmesh_compute for the boundary; malformed file (index-range); degenerate; not manifold; no valid result for a field
 * that no such map follows, with the singular edge and its curve or the layer that would collapse, and for maps that remain inverted,
 * with the location. */
OBC_API obc_status obc_hexmesh_compute_solid(const double *positions, size_t vertex_count, const uint32_t *tetrahedra,
                                             size_t tetrahedron_count, const double *frames,
                                             const obc_hexmesh_options *options, const obc_host *host,
                                             obc_hexmesh_report *report, obc_hexmesh **out, obc_error *error);

/* Destroys a mesh; NULL is allowed. */
OBC_API void obc_hexmesh_destroy(obc_hexmesh *hexes);

/* Return the number of vertices, hexahedra and boundary quads; 0 for NULL. */
OBC_API size_t obc_hexmesh_vertex_count(const obc_hexmesh *hexes);
OBC_API size_t obc_hexmesh_count(const obc_hexmesh *hexes);
OBC_API size_t obc_hexmesh_quad_count(const obc_hexmesh *hexes);

/* Copies positions (x y z a vertex), hexahedra (eight vertices each, in the order of MEDIT and VTK), boundary quads (four vertices each,
 * counter-clockwise seen from outside) and the patch of each quad: of the polycube, of the feature curves where they are embedded, or 0;
 * each may be NULL. Errors: invalid argument. */
OBC_API obc_status obc_hexmesh_copy(const obc_hexmesh *hexes, double *positions, uint32_t *hexahedra, uint32_t *quads,
                                    uint32_t *quad_patches, obc_error *error);

/* Copies the number of the region of each hexahedron, 0 where the solid had none. Errors: invalid argument. */
OBC_API obc_status obc_hexmesh_copy_regions(const obc_hexmesh *hexes, int32_t *regions, obc_error *error);

/* Returns the number of missing features; 0 for NULL. */
OBC_API size_t obc_hexmesh_missing_count(const obc_hexmesh *hexes);

/* Copies missing feature `index`, from 0. Errors: invalid argument. */
OBC_API obc_status obc_hexmesh_get_missing(const obc_hexmesh *hexes, size_t index, obc_hexmesh_missing *missing,
                                           obc_error *error);

/* Returns what was in the way of missing feature `index`, in words, until the mesh is destroyed; NULL for an index out of range and for
 * NULL. */
OBC_API const char *obc_hexmesh_missing_reason(const obc_hexmesh *hexes, size_t index);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_hexmesh_version(void);

#ifdef __cplusplus
}
#endif

#endif
