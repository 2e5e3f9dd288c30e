/* Orbicube polycube: polycubes of closed surfaces, and certified maps to them.
 *
 * A polycube is a solid bounded by axis-aligned planar patches. A polycube map takes each triangle of a (possibly refined) surface to
 * a triangle on it, bijectively (Tarini, Hormann, Cignoni and Montani 2004, "PolyCube-Maps").
 *
 * Certificate. Exact arithmetic on the returned coordinates proves that the map has the genus of the surface, each triangle lies
 * exactly in an axis-aligned plane and is positively oriented, the triangles around each vertex wind once, and the polycube is
 * outward-oriented and neither intersects nor touches itself. The map then covers each point of the polycube once. Every handle
 * has passed it.
 *
 * Arrays: as in <orbicube/mesh.h>. No function keeps its inputs. Options, hosts and reports may be NULL everywhere; the allocator of a
 * host must remain valid until _destroy of the handle created with it. Memory for linear systems does not come from the host.
 *
 * Thread safety: all functions may be called at the same time; several threads may read one handle. Results are the same bits for
 * any number of threads.
 *
 * Example: computes the polycube of a generated L-shaped bar.
 *
 *   #include <orbicube/polycube.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_mesh *mesh = NULL;
 *     obc_surface surface;
 *     obc_polycube *map = NULL;
 *     obc_error error;
 *     if (obc_mesh_make("l-shape", 1000, 0, NULL, &mesh, &error) != OBC_OK) return 1;
 *     if (obc_mesh_surface(mesh, &surface, &error) != OBC_OK) return 1;
 *     if (obc_polycube_compute(&surface, NULL, NULL, &map, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%zu corners, %zu patches\n", obc_polycube_corner_count(map), obc_polycube_patch_count(map)); // 12, 8
 *     obc_polycube_destroy(map);
 *     obc_mesh_destroy(mesh);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_POLYCUBE_H
#define ORBICUBE_POLYCUBE_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- certified maps -------------------------------------------------------------------------------------------------- */

/* A certified polycube map. */
typedef struct obc_polycube obc_polycube;

/* Findings of the certification. The caller sets struct_size. */
typedef struct obc_polycube_certificate {
  uint32_t struct_size;
  int32_t valid;    /* 1: the map is certified; 0: it is not */
  int64_t genus;    /* genus of the polycube; 0 if its triangles are not a closed surface */
  size_t corners;   /* number of vertices with three or more patches */
  size_t patches;   /* number of patches: maximal connected sets of triangles in one plane */
  char reason[256]; /* defect and its location, UTF-8, terminated; empty for a valid map */
} obc_polycube_certificate;

/* Certifies a map of other origin: `surface` in space, `polycube` the positions of its vertices on the polycube (x y z a vertex).
 * certificate may be NULL; it is filled for valid and invalid maps. O(n log n) except for thousands of corners. Errors: invalid
 * argument (an index out of range, a position that is not finite), no valid result (the message is the reason), out of memory,
 * cancelled. */
OBC_API obc_status obc_polycube_create(const obc_surface *surface, const double *polycube, const obc_host *host,
                                       obc_polycube_certificate *certificate, obc_polycube **out, obc_error *error);

/* Construction methods. */
enum {
  OBC_POLYCUBE_AUTO = 0,   /* LABELS, and VOXELS unless the first map is nearly isometric; the valid map with the minimum sum of both
                              distortions (means over triangles), or with fewer corners if about equal */
  OBC_POLYCUBE_LABELS = 1, /* axis labels of triangles (Livesu, Vining, Sheffer, Gregson and Scateni 2013, "PolyCut"; Garanzha
                              et al. 2021, "Foldover-free maps in 50 lines of code") */
  OBC_POLYCUBE_VOXELS = 2, /* grid-based: voxels of the genus of the surface, simplified to the allowed corners, traced on the surface */
  OBC_POLYCUBE_DISSERTATION = 3 /* the dissertation's chapter 4 as printed: octree, shortest paths, harmonic maps, Algorithm 3; never
                                   chosen by AUTO. May have no valid result where paths cross or patches fold over.
                                   Not for obc_polycube_compute_common. */
};

/* Options of the construction. Fill with _init. */
typedef struct obc_polycube_options {
  uint32_t struct_size;
  int32_t construction; /* OBC_POLYCUBE_AUTO, LABELS, VOXELS or DISSERTATION. Default: AUTO. */
  size_t corners;       /* maximum number of corners, or 8 + 8 g for genus g if that is larger; 0: no limit. Of DISSERTATION the
                           maximum number of corner points (obc_polycube_corner_points); 0: 60. Default: 0. */
  uint64_t seed;        /* seed of random choices of LABELS. Default: 0. */
  double area_weight;   /* of DISSERTATION: weight of area relative to angle distortion (alpha of eq. 4.4), nonnegative. Default: 1. */
  uint32_t rounds;      /* of DISSERTATION: maximum number of rounds of Algorithm 3, each of which optimizes proportions and corner
                           points; 0: the initial map. Default: 40. */
} obc_polycube_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_polycube_options_init(obc_polycube_options *options, size_t struct_size);

/* Computes a polycube of a closed surface of any genus and a map to it. Edges are split where required; the vertices of the surface
 * come first. The polycube has about the size of the surface. The attempts depend on the surface and the options
 * alone, never on time. Errors: invalid argument; not closed; not manifold; degenerate; malformed file (kind empty-mesh: no
 * triangles); no valid result with the outcome of each attempt; out of memory; cancelled. */
OBC_API obc_status obc_polycube_compute(const obc_surface *surface, const obc_polycube_options *options, const obc_host *host,
                                        obc_polycube **out, obc_error *error);

/* ---- optimization of proportions and corners ------------------------------------------------------------------------- */

/* Distortion measures of the optimization of proportions. Values do not depend on the size of the polycube and are 1 + area_weight
 * for an isometry; angle and area distortion are defined at obc_polycube_domain_report. */
enum {
  OBC_POLYCUBE_SURFACE_MEAN = 0, /* mean over the surface of angle + area_weight * area distortion */
  OBC_POLYCUBE_FACE_MEAN = 1,    /* mean over triangles of the same */
  OBC_POLYCUBE_HARMONIC = 2      /* harmonic energy + area_weight * area stretch, over the area */
};

/* Options of the optimization of proportions. Fill with _init. */
typedef struct obc_polycube_domain_options {
  uint32_t struct_size;
  int32_t measure;    /* OBC_POLYCUBE_SURFACE_MEAN, FACE_MEAN or HARMONIC. Default: SURFACE_MEAN. */
  double area_weight; /* weight of area relative to angle distortion, nonnegative. Default: 1. */
} obc_polycube_domain_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_polycube_domain_options_init(obc_polycube_domain_options *options, size_t struct_size);

/* Figures of the optimization of proportions. Angle distortion is the harmonic energy over the area on the polycube, area distortion
 * (r + 1/r) / 2 for the ratio r of areas at equal total areas; their means, without degenerate triangles (see
 * obc_sphere_map_report), are 1 for an isometry. The caller sets struct_size. */
typedef struct obc_polycube_domain_report {
  uint32_t struct_size;
  int32_t converged;            /* 1: to the tolerance or the limit of rounding; 0: ended before */
  double energy_before, energy; /* of the input map and of the result, which is not larger */
  uint64_t evaluations;         /* number of evaluations of the energy with its gradient */
  size_t layers;                /* number of planes of patches along all three axes */
  size_t cells;                 /* number of rectangles between neighboring planes, each evaluated as one */
  size_t crossing;              /* number of triangles across planes, each evaluated alone */
  double angle_mean, area_mean, angle_weighted_mean, area_weighted_mean; /* means over triangles, and over the surface */
} obc_polycube_domain_report;

/* Optimizes the proportions of the polycube: distances between the planes of its patches that minimize the distortion of the map, with
 * vertices interpolated between the planes (the dissertation's section 4.3, by a projected gradient method over the logarithms of
 * the distances). Combinatorics, order of the planes and total area are preserved. The result is certified; without
 * improvement it is a bit-identical copy of `map`. O(n log n). Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_optimize_domain(const obc_polycube *map, const obc_polycube_domain_options *options,
                                                const obc_host *host, obc_polycube_domain_report *report,
                                                obc_polycube **out, obc_error *error);

/* Corner search: derivative-free (the dissertation's section 4.4.2), or gradient-based, which needs fewer evaluations. */
enum { OBC_POLYCUBE_TRUST_REGION = 0, OBC_POLYCUBE_GRADIENT = 1 };

/* Options of the optimization of corners. Fill with _init. */
typedef struct obc_polycube_corner_options {
  uint32_t struct_size;
  int32_t method;     /* OBC_POLYCUBE_TRUST_REGION or OBC_POLYCUBE_GRADIENT. Default: OBC_POLYCUBE_TRUST_REGION. */
  double area_weight; /* weight of area relative to angle distortion, nonnegative. Default: 1. */
  int32_t domain;     /* 1: alternates with the optimization of proportions (the dissertation's Algorithm 3); 0: the polycube is fixed. Default: 0. */
  int32_t rounds;     /* maximum number of rounds, at least 1. Default: 6. */
} obc_polycube_corner_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_polycube_corner_options_init(obc_polycube_corner_options *options, size_t struct_size);

/* Figures of the optimization of corners. Energies are means over the surface of angle + area_weight * area distortion, as in the
 * domain report. The caller sets struct_size. */
typedef struct obc_polycube_corner_report {
  uint32_t struct_size;
  int32_t converged;            /* 1: a further round gains almost nothing; 0: `rounds` was reached */
  double energy_before, energy; /* of the input map and of the result, which is not larger */
  uint64_t evaluations;         /* number of local solves around a corner */
  double map_evaluations;       /* triangles in all of them over triangles of the map */
  size_t moves, movable;        /* number of moves of corners in all rounds; number of corners that can move in the first round */
  double angle_mean, area_mean, angle_weighted_mean, area_weighted_mean; /* means over triangles, and over the surface */
} obc_polycube_corner_report;

/* Lowers the distortion of a map to the same polycube: the preimages of its corners move on the surface, in the unfolding of the map
 * around each, and with them the edges of the polycube on the surface and the vertices between (the dissertation's section 4.4).
 * Triangle edges are split along polycube edges; inserted vertices that are no longer required may go. The result is
 * certified; without improvement it is a bit-identical copy of `map`. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_optimize_corners(const obc_polycube *map, const obc_polycube_corner_options *options,
                                                 const obc_host *host, obc_polycube_corner_report *report,
                                                 obc_polycube **out, obc_error *error);

/* ---- features -------------------------------------------------------------------------------------------------------- */

/* Features: vertices and curves of the map with target positions on its polycube. A weight multiplies the squared distance, as a fraction of
 * the polycube's area, next to a distortion that is 2 for an isometry; weight 0, or no weights, enforces the target exactly. Fill with
 * _init. */
typedef struct obc_polycube_feature_options {
  uint32_t struct_size;

  size_t point_count;                   /* number of points. Default: 0. */
  const uint32_t *points;               /* vertex of the map of each point. Default: NULL. */
  const double *targets, *point_weights; /* target position of each point (x y z); weight of each point, or NULL. Default: NULL. */

  size_t curve_count;                                  /* number of curves. Default: 0. */
  const uint32_t *curve_starts, *curve_vertices;       /* curve_count + 1 offsets; the two or more vertices of each curve. Default: NULL. */
  const double *curve_lines, *curve_weights;           /* target of each curve, an axis-aligned segment in a patch or an edge (x y z
                                                          of both ends); weight of each curve, or NULL. Default: NULL. */

  double feature_angle; /* minimum dihedral angle, in degrees, of surface edges that are aligned to nearby polycube edges; 0: none. Default: 0. */
} obc_polycube_feature_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_polycube_feature_options_init(obc_polycube_feature_options *options, size_t struct_size);

/* Figures of the alignment. Lengths of sharp edges are lengths on the surface. The caller sets struct_size. */
typedef struct obc_polycube_feature_report {
  uint32_t struct_size;
  double distance_before, distance, sharp_length, sharp_before, sharp; /* maximum distance to the targets on the polycube before and after;
                                                                          length of sharp edges, and of those on polycube edges before and after */
  double angle_mean, area_mean, angle_weighted_mean, area_weighted_mean; /* means over triangles, and over the surface */
} obc_polycube_feature_report;

/* Aligns features of a map to their targets on the same polycube, with minimum distortion otherwise. The result is certified. Errors:
 * invalid argument (a target that is not on the polycube, a vertex with two targets); no valid result with the conflicting
 * features; out of memory; cancelled. */
OBC_API obc_status obc_polycube_align_features(const obc_polycube *map, const obc_polycube_feature_options *options,
                                              const obc_host *host, obc_polycube_feature_report *report, obc_polycube **out,
                                              obc_error *error);

/* ---- data of a map --------------------------------------------------------------------------------------------------- */

/* Returns the number of energies of the optimization that computed a map: one before it and one after each iteration; 0 for NULL and
 * for maps of other origin. */
OBC_API size_t obc_polycube_energy_count(const obc_polycube *map);

/* Copies these energies to an array of the caller, which may be NULL. Errors: invalid argument. */
OBC_API obc_status obc_polycube_copy_energies(const obc_polycube *map, double *energies, obc_error *error);

/* Destroys a map; NULL is allowed. */
OBC_API void obc_polycube_destroy(obc_polycube *map);

/* Return the numbers of vertices (those of the surface, then inserted ones), triangles, corners and patches of a map; 0 for NULL. */
OBC_API size_t obc_polycube_vertex_count(const obc_polycube *map);
OBC_API size_t obc_polycube_triangle_count(const obc_polycube *map);
OBC_API size_t obc_polycube_corner_count(const obc_polycube *map);
OBC_API size_t obc_polycube_patch_count(const obc_polycube *map);

/* Returns the construction of a map: OBC_POLYCUBE_LABELS, VOXELS or DISSERTATION; -1 for a map of other origin and for NULL. */
OBC_API int32_t obc_polycube_construction(const obc_polycube *map);

/* Counts the corner points of a polycube in the dissertation's sense: vertices of the rectangles that its patches are cut into, at
 * least as many as its corners. O(c^3) for c corners in the worst case. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_corner_points(const obc_polycube *map, const obc_host *host, size_t *count, obc_error *error);

/* Copies a map to arrays of the caller, each of which may be NULL: positions in space (x y z a vertex, bit-identical vertices of the
 * surface first), positions on the polycube, and triangles (three vertices each). Errors: invalid argument. */
OBC_API obc_status obc_polycube_copy(const obc_polycube *map, double *positions, double *polycube, uint32_t *triangles,
                                     obc_error *error);

/* Copies data of each triangle, each array may be NULL: the direction of its normal on the polycube (0 to 5 for +x, -x, +y, -y, +z,
 * -z), its patch, and the surface triangle that contains it. Errors: invalid argument. */
OBC_API obc_status obc_polycube_copy_triangles(const obc_polycube *map, uint8_t *labels, uint32_t *patches, uint32_t *sources,
                                               obc_error *error);

/* Copies the origin of each vertex, three entries a vertex, each array may be NULL: vertices of one surface triangle (UINT32_MAX
 * where fewer than three are needed) and their barycentric weights, positive (0 where not needed) with sum 1. Errors: invalid
 * argument. */
OBC_API obc_status obc_polycube_copy_sources(const obc_polycube *map, uint32_t *corners, double *weights, obc_error *error);

/* ---- maps to a supplied polycube ------------------------------------------------------------------------------------- */

/* Positional constraints of corners, for obc_polycube_map_to_domain. */
typedef struct obc_polycube_constraints {
  const uint32_t *corners;  /* vertex of the polycube of each constrained corner */
  const uint32_t *vertices; /* target vertex of the surface of each corner, UINT32_MAX for a target point; NULL: all have target points */
  const double *points;     /* target point of each corner (x y z), of which the nearest point of the surface counts; NULL: all have vertices */
  size_t count;             /* number of constrained corners */
} obc_polycube_constraints;

/* Maps a surface to a supplied polycube, whose triangles lie in axis-aligned planes. It is traced on the surface as with
 * OBC_POLYCUBE_VOXELS: at its position, with its bounding box stretched to that of the surface, or as the constraints require. The
 * polycube of the handle has the same coordinates; the map is smoothed across its edges. constraints may be NULL. Errors: those of
 * obc_polycube_compute; invalid argument for constraints that do not exist or occur twice; unsupported if the second surface is not a
 * polycube, with the reason; wrong genus if the genera differ. */
OBC_API obc_status obc_polycube_map_to_domain(const obc_surface *surface, const obc_surface *polycube,
                                           const obc_polycube_constraints *constraints, const obc_host *host, obc_polycube **out,
                                           obc_error *error);

/* Computes one polycube for several shapes of one genus and kind (the dissertation's section 4.5). Several polycubes of each shape are traced on
 * all others; proportions and maps are optimized for the sum of energies, and the polycube with the minimum sum is returned. Maps between
 * shapes are compositions: points with the same image on the polycube correspond. options are for the polycubes of single shapes, domain
 * for the energy. out is an array of `count` handles, 1 to 65536, in the order of the surfaces, all NULL after an error. constructed_from
 * (or NULL) receives the index of the shape from which the polycube was constructed. obc_polycube_copy_energies of each handle copies
 * the sums, which never increase. Errors: those of obc_polycube_compute, and wrong genus. */
OBC_API obc_status obc_polycube_compute_common(const obc_surface *surfaces, size_t count, const obc_polycube_options *options,
                                               const obc_polycube_domain_options *domain, const obc_host *host,
                                               size_t *constructed_from, obc_polycube **out, obc_error *error);

/* Optimizes the proportions of one polycube for several maps to it: minimizes the sum of their energies, otherwise as
 * obc_polycube_optimize_domain. out is an array of `count` handles, all NULL after an error. Errors: invalid argument (also: maps
 * to different polycubes), out of memory, cancelled. */
OBC_API obc_status obc_polycube_optimize_common_domain(const obc_polycube *const *maps, size_t count,
                                                       const obc_polycube_domain_options *options, const obc_host *host,
                                                       obc_polycube **out, obc_error *error);

/* ---- graph of a polycube --------------------------------------------------------------------------------------------- */

/* The polycube of a map without its triangles, as a graph: corners, the straight edges between them, and patches. Its dual has a node
 * for each patch and a link for each pair of neighboring patches. */
typedef struct obc_polycube_graph obc_polycube_graph;

/* Creates the graph of a map, which may be destroyed afterwards. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_graph_create(const obc_polycube *map, const obc_host *host, obc_polycube_graph **out,
                                             obc_error *error);

/* Destroys a graph; NULL is allowed. */
OBC_API void obc_polycube_graph_destroy(obc_polycube_graph *graph);

/* Return the numbers of corners, edges, patches, loops, and links of the dual graph (each counted from both ends; patches that share
 * several edges have one link); 0 for NULL. */
OBC_API size_t obc_polycube_graph_corner_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_edge_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_patch_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_loop_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_link_count(const obc_polycube_graph *graph);

/* Copies for each corner its position (x y z) and its vertex of the map. Each array may be NULL, here and in the functions below.
 * Errors: invalid argument. */
OBC_API obc_status obc_polycube_graph_copy_corners(const obc_polycube_graph *graph, double *positions, uint32_t *vertices,
                                                   obc_error *error);

/* Copies for each edge its two corners, the patches on its left and right (from the first corner to the second, seen from outside),
 * and its convexity: 1 for an interior angle of 90 degrees, 0 for 270 degrees. Errors: invalid argument. */
OBC_API obc_status obc_polycube_graph_copy_edges(const obc_polycube_graph *graph, uint32_t *corners, uint32_t *patches,
                                                 uint8_t *convex, obc_error *error);

/* Copies for each patch (numbered as in obc_polycube_copy_triangles) the direction of its normal (0 to 5 for +x, -x, +y, -y, +z,
 * -z), the coordinate of its plane, and the offset of its loops: the outer loop, then those around holes; loop_starts has
 * one entry more than there are patches. Errors: invalid argument. */
OBC_API obc_status obc_polycube_graph_copy_patches(const obc_polycube_graph *graph, uint8_t *labels, double *coordinates,
                                                   uint32_t *loop_starts, obc_error *error);

/* Copies for each loop the offset of its darts, with one entry more than there are loops, and its darts, counter-clockwise around
 * the patch: dart 2 e is edge e from its first to its second corner, dart 2 e + 1 its reverse. Each dart is in one loop.
 * Errors: invalid argument. */
OBC_API obc_status obc_polycube_graph_copy_loops(const obc_polycube_graph *graph, uint32_t *starts, uint32_t *darts,
                                                 obc_error *error);

/* Copies the dual graph: the offset of the neighbors of each patch, with one entry more than there are patches, and the patches
 * that share an edge with it, ascending. Errors: invalid argument. */
OBC_API obc_status obc_polycube_graph_copy_dual(const obc_polycube_graph *graph, uint32_t *starts, uint32_t *neighbors,
                                                obc_error *error);

/* ---- quad meshes ----------------------------------------------------------------------------------------------------- */

/* A quad mesh of the surface from a regular grid on the polycube: vertices inside a patch or an edge have four quads. */
typedef struct obc_polycube_quads obc_polycube_quads;

/* Resolution of a quad mesh. Fill with _init. */
typedef struct obc_polycube_quads_options {
  uint32_t struct_size;
  size_t quads;       /* approximate number of quads, up to 10^7, at least one a rectangle between neighboring planes. Default: 10000. */
  double edge_length; /* edge length on the polycube, in place of `quads`; 0: by `quads`. Default: 0. */
} obc_polycube_quads_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_polycube_quads_options_init(obc_polycube_quads_options *options, size_t struct_size);

/* Creates a grid with integer numbers of cells between neighboring planes and maps its vertices to the surface, each in the triangle
 * that contains it by exact arithmetic. Connectivity depends on the polycube alone: maps to one polycube return the same quads.
 * Errors: invalid argument (also: more than 10^7 quads), out of memory, cancelled. */
OBC_API obc_status obc_polycube_quads_create(const obc_polycube *map, const obc_polycube_quads_options *options,
                                             const obc_host *host, obc_polycube_quads **out, obc_error *error);

/* Destroys a quad mesh; NULL is allowed. */
OBC_API void obc_polycube_quads_destroy(obc_polycube_quads *quads);

/* Return the numbers of vertices and quads; 0 for NULL. */
OBC_API size_t obc_polycube_quads_vertex_count(const obc_polycube_quads *quads);
OBC_API size_t obc_polycube_quads_quad_count(const obc_polycube_quads *quads);

/* Copies to arrays of the caller, each of which may be NULL: for each vertex its positions on the surface and on the polycube (x y z),
 * for each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument. */
OBC_API obc_status obc_polycube_quads_copy(const obc_polycube_quads *quads, double *positions, double *polycube,
                                           uint32_t *corners, uint32_t *patches, obc_error *error);

/* Copies for each vertex the triangle of the map that contains it and its barycentric weights, nonnegative with sum 1. Errors:
 * invalid argument. */
OBC_API obc_status obc_polycube_quads_copy_sources(const obc_polycube_quads *quads, uint32_t *triangles, double *weights,
                                                   obc_error *error);

/* ---- texture atlas --------------------------------------------------------------------------------------------------- */

/* A texture atlas: the patches of a polycube packed into a square without overlap (in the manner of Levy, Petitjean, Ray and Maillot
 * 2002, "Least squares conformal maps for automatic texture atlas generation"). All patches have one scale, are upright or turned by a
 * quarter, and none is mirrored. */
typedef struct obc_polycube_atlas obc_polycube_atlas;

/* Options of an atlas. Fill with _init. */
typedef struct obc_polycube_atlas_options {
  uint32_t struct_size;
  uint32_t size;  /* number of texels along each side, 1 to 16384. Default: 1024. */
  double padding; /* minimum distance of two patches in texels, nonnegative; half of it is left at the border. Default: 4. */
} obc_polycube_atlas_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_polycube_atlas_options_init(obc_polycube_atlas_options *options, size_t struct_size);

/* Packs the patches of a map, which may be destroyed afterwards, at the largest scale that is found. The layout depends on the polycube
 * alone. Errors: invalid argument; unsupported (the square is too small for all patches with their padding); out of memory; cancelled. */
OBC_API obc_status obc_polycube_atlas_create(const obc_polycube *map, const obc_polycube_atlas_options *options,
                                             const obc_host *host, obc_polycube_atlas **out, obc_error *error);

/* Destroys an atlas; NULL is allowed. */
OBC_API void obc_polycube_atlas_destroy(obc_polycube_atlas *atlas);

/* Return the number of texels along each side, and the number of triangles, which is that of the map; 0 for NULL. */
OBC_API uint32_t obc_polycube_atlas_size(const obc_polycube_atlas *atlas);
OBC_API size_t obc_polycube_atlas_triangle_count(const obc_polycube_atlas *atlas);

/* Copies an atlas, each output may be NULL: texture coordinates of the corners of each triangle (u v of each of the three corners; 0 to
 * 1, u from the left and v from the top, as in glTF), the number of texels along a unit of the polycube, and the fraction of the square
 * that the patches cover (0 to 1). A vertex on an edge of the polycube has other coordinates in each of its patches. Errors: invalid
 * argument. */
OBC_API obc_status obc_polycube_atlas_copy(const obc_polycube_atlas *atlas, double *coordinates, double *texels_per_unit,
                                           double *coverage, obc_error *error);

/* Samples an atlas: what each of its size * size texels shows, row by row from the top, so that any data of vertices becomes a texture.
 * Each array may be NULL: the triangle of the map, the barycentric weights of its three corners (nonnegative, sum 1), and whether the
 * middle of the texel is in that triangle (1). Beside the patches (0) texels show the point of the nearest texel in a patch, so that
 * filters and smaller copies of a texture mix nothing else into its patches; where no patch has the middle of any texel, all have triangle
 * UINT32_MAX and weights 0. O(texels + triangles). Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_atlas_sample(const obc_polycube_atlas *atlas, const obc_host *host, uint32_t *triangles,
                                             double *weights, uint8_t *covered, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_polycube_version(void);

#ifdef __cplusplus
}
#endif

#endif
