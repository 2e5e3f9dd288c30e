/* Orbicube polycube: polycubes of closed surfaces, and certified maps to them.
 *
 * A polycube is a solid whose faces lie in axis-aligned planes; a polycube map takes each triangle of a (possibly refined)
 * surface to a triangle on it, one to one (Tarini, Hormann, Cignoni and Montani 2004, "PolyCube-Maps").
 *
 * What is certified, by exact arithmetic on the coordinates that you get: the map has the genus of the surface, each triangle
 * lies exactly in an axis-aligned plane and is positively oriented, the triangles around each vertex turn once, the polycube
 * does not meet itself, touching included, and it looks outward. Then every point of it is covered once. A handle holds a
 * certified map; there is none otherwise.
 *
 * Arrays: as in <orbicube/mesh.h>. Inputs are not kept after a call. Options and hosts may be NULL everywhere; the allocator of a
 * host must stay valid until _destroy of what was made with it. Memory for linear systems is not the host's.
 *
 * Thread safety: all functions may be called at the same time; handles may be read by several threads. Results are the same
 * bits for any number of threads.
 */
#ifndef ORBICUBE_POLYCUBE_H
#define ORBICUBE_POLYCUBE_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A certified polycube map. */
typedef struct obc_polycube obc_polycube;

/* What certification finds. Fill struct_size. */
typedef struct obc_polycube_certificate {
  uint32_t struct_size;
  int32_t valid;   /* 1 or 0 */
  int64_t genus;   /* of the polycube; 0 when its triangles are no closed surface */
  size_t corners;  /* vertices where three faces of the polycube or more meet */
  size_t patches;  /* faces of the polycube: connected triangles in one plane */
  char reason[256]; /* what is wrong and where, UTF-8, ends with 0; empty when valid */
} obc_polycube_certificate;
/* Certifies a map made elsewhere: `surface` in space, `polycube` where its vertices are to be on the polycube (x y z a vertex).
 * certificate may be NULL; it is filled whether the map is valid or not. Errors: invalid argument (an index out of range, a
 * position that is not finite), no valid result (the message is the reason), out of memory, cancelled. O(n log n) unless there
 * are thousands of corners. */
OBC_API obc_status obc_polycube_create(const obc_surface *surface, const double *polycube, const obc_host *host,
                                       obc_polycube_certificate *certificate, obc_polycube **out, obc_error *error);

/* How a polycube is found. */
enum {
  OBC_POLYCUBE_AUTO = 0,   /* by labels, and by voxels unless the first map is nearly an isometry; the one of the valid maps with
                              the least sum of both distortions (means over triangles), fewer corners if about equal */
  OBC_POLYCUBE_LABELS = 1, /* axis labels of triangles (Livesu, Vining, Sheffer, Gregson and Scateni 2013, "PolyCut"; Garanzha
                              et al. 2021, "Foldover-free maps in 50 lines of code") */
  OBC_POLYCUBE_VOXELS = 2  /* voxels of the surface's genus, simplified to the corners allowed, drawn on the surface */
};
/* How a polycube is looked for. Fill with _init. */
typedef struct obc_polycube_options {
  uint32_t struct_size;
  int32_t construction; /* OBC_POLYCUBE_...; auto by default */
  size_t corners;       /* of the polycube at most, or 8 + 8 g for g handles if that is more; 0: any number. Default 0 */
  uint64_t seed;        /* of what labels choose at random. Default 0 */
} obc_polycube_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_polycube_options_init(obc_polycube_options *options, size_t struct_size);

/* Finds a polycube of a closed surface of any genus, and a map to it. Edges are split where that is needed; the vertices of
 * the surface come first. The polycube has about the size of the surface. What is tried depends on the surface and the options
 * alone, never on time.
 * Errors: invalid argument; not closed, not manifold, degenerate, malformed file (kind empty-mesh: no triangles); no valid
 * result with what became of each attempt; out of memory, cancelled. */
OBC_API obc_status obc_polycube_compute(const obc_surface *surface, const obc_polycube_options *options, const obc_host *host,
                                        obc_polycube **out, obc_error *error);

/* How the distortion is measured that the best proportions minimise. Values do not depend on the size of the polycube, and are
 * 1 + area_weight for an isometry. `angle` and `area` as in obc_polycube_domain_report. */
enum {
  OBC_POLYCUBE_SURFACE_MEAN = 0, /* mean over the surface of angle + area_weight * area */
  OBC_POLYCUBE_FACE_MEAN = 1,    /* mean over triangles of the same */
  OBC_POLYCUBE_HARMONIC = 2      /* harmonic energy + area_weight * area stretching, over the area */
};
/* Fill with _init. */
typedef struct obc_polycube_domain_options {
  uint32_t struct_size;
  int32_t measure;    /* OBC_POLYCUBE_SURFACE_MEAN or another. Default OBC_POLYCUBE_SURFACE_MEAN */
  double area_weight; /* of areas beside angles, not negative. Default 1 */
} obc_polycube_domain_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_polycube_domain_options_init(obc_polycube_domain_options *options, size_t struct_size);
/* What was found. Fill struct_size. The means are those of the result, each 1 for an isometry: `angle` the harmonic energy of a
 * triangle over its area on the polycube, `area` (r + 1/r) / 2 for the ratio r of areas, at equal areas of the whole. */
typedef struct obc_polycube_domain_report {
  uint32_t struct_size;
  int32_t converged;     /* 1: to the tolerance, or as far as rounding allows */
  double energy_before, energy; /* of the map that was given; of the result, not more */
  uint64_t evaluations;  /* of the energy with its gradient */
  size_t layers;         /* planes of faces, along all three axes */
  size_t cells;          /* rectangles between neighbouring layers, each evaluated at once */
  size_t crossing;       /* triangles across layers, each evaluated for itself */
  double angle_mean, area_mean, angle_weighted_mean, area_weighted_mean; /* over triangles; over the surface */
} obc_polycube_domain_report;

/* The polycube with the best proportions: distances between the planes of its faces that minimise the map's distortion, vertices
 * going with the planes beside them (the dissertation's section 4.3, by a projected gradient method over the logarithms of the
 * distances). Combinatorics, order of the planes and total area stay. The result is certified again; it is a copy of `map` to
 * the bit when nothing better is found. report may be NULL, here and below. Errors: invalid argument, out of memory, cancelled.
 * O(n log n). */
OBC_API obc_status obc_polycube_optimize_domain(const obc_polycube *map, const obc_polycube_domain_options *options,
                                                const obc_host *host, obc_polycube_domain_report *report,
                                                obc_polycube **out, obc_error *error);

/* How the best place of a corner is looked for: by values alone (the dissertation's section 4.4.2), or by gradients, in
 * fewer evaluations. */
enum { OBC_POLYCUBE_TRUST_REGION = 0, OBC_POLYCUBE_GRADIENT = 1 };
/* Fill with _init. */
typedef struct obc_polycube_corner_options {
  uint32_t struct_size;
  int32_t method;     /* OBC_POLYCUBE_TRUST_REGION or OBC_POLYCUBE_GRADIENT. Default OBC_POLYCUBE_TRUST_REGION */
  double area_weight; /* of areas beside angles, not negative. Default 1 */
  int32_t domain;     /* 1: the best proportions in turn (the dissertation's Algorithm 3); 0: the polycube stays. Default 0 */
  int32_t rounds;     /* at most, 1 or more. Default 6 */
} obc_polycube_corner_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_polycube_corner_options_init(obc_polycube_corner_options *options, size_t struct_size);
/* What was found. Fill struct_size. Energies are means over the surface of angle + area_weight * area, as in the domain report. */
typedef struct obc_polycube_corner_report {
  uint32_t struct_size;
  int32_t converged;            /* 1: another round gains next to nothing; 0: the rounds were used up */
  double energy_before, energy; /* of the map that was given; of the result, not more */
  uint64_t evaluations;         /* of a corner's surroundings, each time solved for the least distortion */
  double map_evaluations;       /* the same in maps: triangles that were solved, over those of the map */
  size_t moves, movable;        /* of corners, over all rounds; corners with room to move, in the first round */
  double angle_mean, area_mean, angle_weighted_mean, area_weighted_mean; /* over triangles; over the surface */
} obc_polycube_corner_report;

/* A less distorted map to the same polycube: what of the surface goes to its corners moves, in the map's own unfolding around
 * each, and with it the polycube's edges on the surface and all between (the dissertation's section 4.4). Edges of triangles
 * are split where the polycube's are drawn; added vertices that serve none any more may go. Certified again; a copy of `map`
 * to the bit when nothing better is found. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_optimize_corners(const obc_polycube *map, const obc_polycube_corner_options *options,
                                                 const obc_host *host, obc_polycube_corner_report *report,
                                                 obc_polycube **out, obc_error *error);

/* What must be mapped where. Weights are those of squared distances in parts of the polycube's area, beside a distortion that is 2
 * for an isometry; 0, or no weights, is for what must be met exactly. Fill with _init. */
typedef struct obc_polycube_feature_options {
  uint32_t struct_size;
  size_t point_count;            /* points: vertices of the map and their places on its polycube (x y z). Default 0 */
  const uint32_t *points;
  const double *places, *point_weights;
  size_t curve_count;            /* curves: of each where its vertices, two or more, begin (an entry more than curves), and a line
                                    along an axis in a face or an edge (x y z twice) for the first to the last. Default 0 */
  const uint32_t *curve_starts, *curve_vertices;
  const double *curve_lines, *curve_weights;
  double sharp_angle; /* where the surface bends by so many degrees, edges go to edges of the polycube nearby; 0: none. Default 0 */
} obc_polycube_feature_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_polycube_feature_options_init(obc_polycube_feature_options *options, size_t struct_size);
/* What was reached. Fill struct_size. Distances on the polycube, the largest of all features; the length of sharp edges on the
 * surface, and what of it lay and lies on edges of the polycube. */
typedef struct obc_polycube_feature_report {
  uint32_t struct_size;
  double distance_before, distance, sharp_length, sharp_before, sharp;
  double angle_mean, area_mean, angle_weighted_mean, area_weighted_mean; /* over triangles; over the surface */
} obc_polycube_feature_report;
/* A map to the same polycube with features in their places, and all else as little distorted as that allows. Certified again.
 * Errors: invalid argument (a place that is not on the polycube, a vertex with two); no valid result, with what cannot be met;
 * out of memory, cancelled. */
OBC_API obc_status obc_polycube_meet_features(const obc_polycube *map, const obc_polycube_feature_options *options,
                                              const obc_host *host, obc_polycube_feature_report *report, obc_polycube **out,
                                              obc_error *error);
/* The energies of the optimisation that a map comes from: before it, then after each iteration; 0 for NULL and maps that come from
 * none. */
OBC_API size_t obc_polycube_energy_count(const obc_polycube *map);
/* Copies them to the caller's array, which may be NULL. Errors: invalid argument. */
OBC_API obc_status obc_polycube_copy_energies(const obc_polycube *map, double *energies, obc_error *error);
/* Releases a map; NULL is fine. */
OBC_API void obc_polycube_destroy(obc_polycube *map);
/* Numbers of a map; 0 for NULL. Vertices: those of the surface, then those added. */
OBC_API size_t obc_polycube_vertex_count(const obc_polycube *map);
OBC_API size_t obc_polycube_triangle_count(const obc_polycube *map);
OBC_API size_t obc_polycube_corner_count(const obc_polycube *map);
OBC_API size_t obc_polycube_patch_count(const obc_polycube *map);
/* What found the map: OBC_POLYCUBE_LABELS or OBC_POLYCUBE_VOXELS; -1 for a map made elsewhere, and for NULL. */
OBC_API int32_t obc_polycube_construction(const obc_polycube *map);
/* Copies to the caller's arrays, each of which may be NULL: positions in space (x y z a vertex; the surface's vertices first, to
 * the bit), polycube positions, triangles (three vertices each). Errors: invalid argument. */
OBC_API obc_status obc_polycube_copy(const obc_polycube *map, double *positions, double *polycube, uint32_t *triangles,
                                     obc_error *error);
/* Copies what is known of each triangle, each array may be NULL: the direction it looks in on the polycube (0 to 5 for +x, -x, +y,
 * -y, +z, -z), its face of the polycube, and the surface's triangle that it lies in. Errors: invalid argument. */
OBC_API obc_status obc_polycube_copy_triangles(const obc_polycube *map, uint8_t *labels, uint32_t *patches, uint32_t *sources,
                                               obc_error *error);
/* Copies where each vertex comes from, three entries a vertex, each array may be NULL: vertices of one triangle of the surface
 * (UINT32_MAX where fewer than three are needed) and their weights, positive (0 where not needed) with the sum 1. Errors:
 * invalid argument. */
OBC_API obc_status obc_polycube_copy_sources(const obc_polycube *map, uint32_t *corners, double *weights, obc_error *error);

/* Places of corners, for obc_polycube_compute_on: corner i is vertex corners[i] of the polycube; it is to be at vertex
 * vertices[i] of the surface or, where that is UINT32_MAX or vertices is NULL, at the point of the surface that is nearest to
 * points[3 i], [3 i + 1], [3 i + 2]. */
typedef struct obc_polycube_places {
  const uint32_t *corners;
  const uint32_t *vertices; /* or NULL */
  const double *points;     /* or NULL, when all have vertices */
  size_t count;
} obc_polycube_places;
/* Maps a surface to a polycube that is given by its triangles, each in an axis-aligned plane. It is drawn on the surface, as
 * OBC_POLYCUBE_VOXELS does with its own: where it stands, its box stretched to that of the surface, or where the places say.
 * The handle's polycube has the very coordinates of the one given; the map is smoothed across its edges. places may be NULL.
 * Errors: those of obc_polycube_compute; invalid argument for places that do not exist or are given twice; unsupported when the
 * polycube is none, with the reason; wrong genus when the surface has another. */
OBC_API obc_status obc_polycube_compute_on(const obc_surface *surface, const obc_surface *polycube,
                                           const obc_polycube_places *places, const obc_host *host, obc_polycube **out,
                                           obc_error *error);

/* One polycube for several shapes of one genus and kind (the dissertation's section 4.5): several polycubes of each are drawn on
 * all others, proportions and maps are optimised for the sum of energies, and the one with the least sum is kept. Maps between
 * shapes are compositions: what is at one point of the polycube corresponds. options are for each shape's own polycube, domain
 * for the energy. out is an array of `count` handles, in the order of the surfaces, all NULL after an error; made_for may be NULL
 * or gets the number of the shape that the polycube was made for. obc_polycube_copy_energies of each handle gives the sums,
 * which never rise. Errors: those of obc_polycube_compute, and wrong genus. */
OBC_API obc_status obc_polycube_compute_common(const obc_surface *surfaces, size_t count, const obc_polycube_options *options,
                                               const obc_polycube_domain_options *domain, const obc_host *host,
                                               size_t *made_for, obc_polycube **out, obc_error *error);
/* obc_polycube_optimize_domain for several maps to one and the same polycube: the proportions with the least sum of energies.
 * out is an array of `count` handles, all NULL after an error. Errors: invalid argument (among them maps to different
 * polycubes), out of memory, cancelled. */
OBC_API obc_status obc_polycube_optimize_common_domain(const obc_polycube *const *maps, size_t count,
                                                       const obc_polycube_domain_options *options, const obc_host *host,
                                                       obc_polycube **out, obc_error *error);

/* The polycube of a map without its triangles: corners, the straight edges between them, and patches (its faces), as a graph
 * whose dual has a node a patch and a link an edge. Copies all; the map may be destroyed. */
typedef struct obc_polycube_graph obc_polycube_graph;
/* Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_polycube_graph_create(const obc_polycube *map, const obc_host *host, obc_polycube_graph **out,
                                             obc_error *error);
/* Releases a graph; NULL is fine. */
OBC_API void obc_polycube_graph_destroy(obc_polycube_graph *graph);
/* Numbers; 0 for NULL. Links: of the dual graph, where patches that share several edges are neighbours once, each link counted
 * from both ends. */
OBC_API size_t obc_polycube_graph_corner_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_edge_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_patch_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_loop_count(const obc_polycube_graph *graph);
OBC_API size_t obc_polycube_graph_link_count(const obc_polycube_graph *graph);
/* Copies to the caller's arrays, each of which may be NULL, as in all these functions. Of each corner its position (x y z) and
 * its vertex of the map. Errors: invalid argument. */
OBC_API obc_status obc_polycube_graph_copy_corners(const obc_polycube_graph *graph, double *positions, uint32_t *vertices,
                                                   obc_error *error);
/* Of each edge: its two corners, the patches on the left and on the right of the way from the first to the second, seen from
 * outside, and whether the solid has one right angle there (1, convex) or three (0, concave). */
OBC_API obc_status obc_polycube_graph_copy_edges(const obc_polycube_graph *graph, uint32_t *corners, uint32_t *patches,
                                                 uint8_t *convex, obc_error *error);
/* Of each patch, which has the number that obc_polycube_copy_triangles gives: the direction it looks in (0 to 5 for +x, -x, +y,
 * -y, +z, -z), the coordinate of its plane, and where its loops begin among all loops: first the one around it, then those
 * around its holes; loop_starts has an entry more than there are patches. */
OBC_API obc_status obc_polycube_graph_copy_patches(const obc_polycube_graph *graph, uint8_t *labels, double *coordinates,
                                                   uint32_t *loop_starts, obc_error *error);
/* Of each loop where it begins among all darts, with an entry more than there are loops, and its darts, counter-clockwise around
 * the patch: dart 2 e is edge e from its first corner to its second, dart 2 e + 1 the way back. Each dart is in one loop. */
OBC_API obc_status obc_polycube_graph_copy_loops(const obc_polycube_graph *graph, uint32_t *starts, uint32_t *darts,
                                                 obc_error *error);
/* The dual graph: where the neighbours of each patch begin, with an entry more than there are patches, and the patches that
 * share an edge with it, ascending. */
OBC_API obc_status obc_polycube_graph_copy_dual(const obc_polycube_graph *graph, uint32_t *starts, uint32_t *neighbours,
                                                obc_error *error);

/* A mesh of quads on the surface, from a regular grid on the polycube: every vertex inside a patch, or inside an edge, has four. */
typedef struct obc_polycube_quads obc_polycube_quads;
/* How fine. Fill with _init. */
typedef struct obc_polycube_quads_options {
  uint32_t struct_size;
  size_t quads;       /* about so many; each rectangle between neighbouring planes of patches has one at least. Default 10000 */
  double edge_length; /* of cells on the polycube, rather than their number, unless it is 0. Default 0 */
} obc_polycube_quads_options;
/* The defaults, which the members' comments give. */
OBC_API obc_status obc_polycube_quads_options_init(obc_polycube_quads_options *options, size_t struct_size);
/* Makes the grid, with integer numbers of cells between neighbouring planes, and takes its vertices to the surface, each
 * in the triangle that has it by exact arithmetic. Depends on the polycube alone, but for positions: maps to one polycube give
 * the same quads. Errors: invalid argument (among them more than 10^8 quads), out of memory, cancelled. */
OBC_API obc_status obc_polycube_quads_create(const obc_polycube *map, const obc_polycube_quads_options *options,
                                             const obc_host *host, obc_polycube_quads **out, obc_error *error);
/* Releases quads; NULL is fine. */
OBC_API void obc_polycube_quads_destroy(obc_polycube_quads *quads);
/* Numbers; 0 for NULL. */
OBC_API size_t obc_polycube_quads_vertex_count(const obc_polycube_quads *quads);
OBC_API size_t obc_polycube_quads_quad_count(const obc_polycube_quads *quads);
/* Copies to the caller's arrays, each of which may be NULL: of each vertex its position on the surface and on the polycube (x y
 * z), of each quad its four vertices, counter-clockwise seen from outside, and its patch. Errors: invalid argument. */
OBC_API obc_status obc_polycube_quads_copy(const obc_polycube_quads *quads, double *positions, double *polycube,
                                           uint32_t *corners, uint32_t *patches, obc_error *error);
/* Of each vertex the triangle of the map that it is in and its weights at the three corners, none negative, with the sum 1. */
OBC_API obc_status obc_polycube_quads_copy_sources(const obc_polycube_quads *quads, uint32_t *triangles, double *weights,
                                                   obc_error *error);
/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_polycube_version(void);

#ifdef __cplusplus
}
#endif

#endif
