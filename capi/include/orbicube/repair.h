/* Orbicube repair: any triangles to a closed, oriented, manifold surface, with a certificate of what was reached.
 *
 * Method. The steps are, in this order: open edges are welded; degenerate and repeated faces and unused vertices are removed;
 * near-degenerate triangles are collapsed or flipped; vertices on open edges split them (T-junctions); faces are oriented;
 * edges and vertices where sheets of the surface touch are split (Gueziec et al. 2001); the largest parts are kept; holes are
 * filled (Liepa 2003). On request, all parts are replaced by a surface around them, and handles and tunnels are cut. Each step
 * changes nothing where nothing is wrong: a clean surface comes back bit for bit. Labels of an image become closed surfaces of genus 0.
 *
 * Arrays: as in <orbicube/mesh.h>. Lengths are in the unit of the surface. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time; several threads may read one handle. Results are the same bits for
 * any number of threads.
 *
 * Example: closes a sphere of which a face is missing.
 *
 *   #include <orbicube/repair.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_mesh *mesh = NULL;
 *     obc_surface surface;
 *     obc_repair *repaired = NULL;
 *     obc_repair_report report;
 *     obc_error error;
 *     if (obc_mesh_make("sphere", 1000, 0, NULL, &mesh, &error) != OBC_OK) return 1;
 *     if (obc_mesh_surface(mesh, &surface, &error) != OBC_OK) return 1;
 *     surface.triangle_count -= 1;
 *     if (obc_repair_compute(&surface, NULL, NULL, &repaired, &error) != OBC_OK) return puts(error.message), 1;
 *     if (obc_repair_report_init(&report, sizeof report) != OBC_OK) return 1;
 *     if (obc_repair_get_report(repaired, &report, &error) != OBC_OK) return 1;
 *     printf("closed: %d, holes filled: %zu\n", report.closed, report.filled_holes);
 *     obc_repair_destroy(repaired);
 *     obc_mesh_destroy(mesh);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_REPAIR_H
#define ORBICUBE_REPAIR_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What was done at one place. */
enum {
  OBC_REPAIR_WELDED_VERTEX = 0,        /* size: distance from the vertex that it was welded to */
  OBC_REPAIR_REMOVED_DEGENERATE = 1,   /* a face with a repeated corner */
  OBC_REPAIR_REMOVED_DUPLICATE = 2,    /* a face on the corners of another */
  OBC_REPAIR_COLLAPSED_EDGE = 3,       /* of a near-degenerate triangle; size: length of the edge */
  OBC_REPAIR_FLIPPED_EDGE = 4,         /* the longest of a near-degenerate triangle; size: height of the triangle */
  OBC_REPAIR_LEFT_NEAR_DEGENERATE = 5, /* a near-degenerate triangle that stays; size: its height */
  OBC_REPAIR_SPLIT_EDGE = 6,           /* an edge split at a vertex on it; size: distance of the vertex from the edge */
  OBC_REPAIR_SPLIT_CONTACT_EDGE = 7,   /* count: faces at the edge; size: its length */
  OBC_REPAIR_SPLIT_CONTACT_VERTEX = 8, /* count: fans of faces at the vertex */
  OBC_REPAIR_DROPPED_PART = 9,         /* count: triangles; size: area */
  OBC_REPAIR_FILLED_HOLE = 10,         /* count: edges of the boundary loop; size: its length */
  OBC_REPAIR_LEFT_HOLE = 11,           /* the same of a hole that stays open */
  OBC_REPAIR_CUT_HANDLE = 12           /* count: edges of the loop; size: its length */
};

/* Options of a repair. Fill with _init. */
typedef struct obc_repair_options {
  uint32_t struct_size;
  int32_t weld;               /* 1: vertices of open edges are welded; 0: not. Default: 1. */
  int32_t clean;              /* 1: degenerate and repeated faces and unused vertices are removed; 0: not. Default: 1. */
  int32_t slivers;            /* 1: near-degenerate triangles are collapsed or flipped, if clean is 1; 0: not. Default: 1. */
  int32_t t_junctions;        /* 1: open edges are split at vertices on them; 0: not. Default: 1. */
  int32_t orient;             /* 1: faces are oriented consistently and outward; 0: not. Default: 1. */
  int32_t contacts;           /* 1: edges of more than two faces and vertices of more than one fan are split; 0: not. Default: 1. */
  int32_t drop_parts;         /* 1: parts are dropped by the members below; 0: not. Default: 1. */
  int32_t cavities;           /* 1: parts inside an odd number of others are kept and bound cavities; 0: they are dropped. Default: 0. */
  int32_t fill_holes;         /* 1: boundary loops are filled; 0: not. Default: 1. */
  int32_t fair;               /* 1: patches of holes are refined and bent to continue the surface; 0: not. Default: 1. */
  int32_t find_intersections; /* 1: the result is searched for intersecting triangles; 0: not. Default: 1. */
  int32_t max_genus;          /* handles and tunnels are cut, the shortest loops first, down to this genus, summed over the parts; negative: no
                                 limit. Default: -1. */
  double weld_distance;       /* maximum distance of welded vertices; 0: the same position and, while edges are open, 1e-6 of the diagonal of the
                                 bounding box. Default: 0. */
  double sliver_ratio;        /* maximum height of near-degenerate triangles over their longest side, below 0.5. Default: 1e-6. */
  double sliver_move;         /* bound of the movement of the surface by their removal; 0: 1e-5 of the diagonal. Default: 0. */
  double t_junction_distance; /* maximum distance of a vertex from the edge that it splits; 0: 1e-6 of the diagonal. Default: 0. */
  double contact_gap;         /* distance by which vertices of split contacts move into their own sheet's inner side. Default: 0. */
  double min_area_percent;    /* minimum area of a part, in percent of that of all; the largest stays. Default: 0. */
  size_t keep_parts;          /* number of parts to keep, the largest by area; 0: no limit. Default: 1. */
  size_t max_hole_edges;      /* maximum number of edges of a hole to fill; 0: no limit. Default: 0. */
  double max_handle_length;   /* maximum length of the loop of a handle or tunnel to cut; 0: no limit, and none is cut unless max_genus is set.
                                 Default: 0. */
  double wrap_offset;         /* distance of a surface around all parts that replaces them, free of self-intersections; 0: none. Default: 0. */
} obc_repair_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_repair_options_init(obc_repair_options *options, size_t struct_size);

/* Figures of a repair and the certificate of its result. Fill with _init. */
typedef struct obc_repair_report {
  uint32_t struct_size;
  int32_t changed;  /* 0: the surface is the input, bit for bit */
  int32_t closed;   /* certificate: no boundary */
  int32_t manifold; /* certificate: no edge of more than two faces, no vertex that joins parts, no degenerate or repeated face */
  int32_t oriented; /* certificate: each edge is passed once in each direction */
  int32_t orientable; /* 0: faces cannot be oriented consistently */

  size_t welded_vertices, weld_lost_triangles;
  size_t degenerate_faces, duplicate_faces, unused_vertices; /* removed; unused vertices include those that steps left without faces */
  size_t near_degenerate, collapsed_edges, flipped_edges, left_near_degenerate;
  size_t t_junctions; /* splits of an edge at a vertex */
  size_t reversed_triangles;
  size_t contact_edges, contact_vertices, contact_added_vertices;
  size_t found_parts, kept_parts, cavity_parts, dropped_triangles;
  size_t found_holes, filled_holes, patch_triangles, patch_vertices;
  size_t cut_handles;

  double weld_move, sliver_move, t_junction_move, handle_move; /* largest movement by these steps */
  double longest_handle;       /* length of the longest loop that was cut */
  double dropped_area_percent; /* of the area of all parts */
  double distance_from_input;  /* largest distance of changed triangles of the input from the result, without dropped parts */
  double distance_from_result; /* largest distance of changed triangles of the result from the input, without patches */
  double distance_of_patches;  /* largest distance of patches of holes from the input */

  size_t parts;              /* certificate: of the result */
  int64_t genus;             /* certificate: sum over the parts of a closed, oriented manifold; else 0 */
  size_t boundary_loops;     /* certificate */
  size_t self_intersections; /* certificate: pairs of triangles that intersect, by exact arithmetic; at most 10000 are counted */
  double area, volume;       /* of the result; volume 0 unless it is a closed, oriented manifold */
} obc_repair_report;

/* Fills a report with zeros and its struct_size. */
OBC_API obc_status obc_repair_report_init(obc_repair_report *report, size_t struct_size);

/* A repaired surface. */
typedef struct obc_repair obc_repair;

/* Repairs a surface: any triangles, which need not be connected, closed, oriented or manifold. options and host may be NULL. Whether a
 * closed, oriented, manifold surface was reached is in the report. *out is NULL after an error; the allocator of the host must
 * remain valid until _destroy. Takes O(n log n) and, for each hole of k edges, O(k * 150^2); a wrap needs
 * (size / wrap_offset)^3 bytes times five, at most 67 million nodes. Errors: OBC_INVALID_ARGUMENT,
 * OBC_MALFORMED_FILE (kind empty-mesh: no triangles), OBC_DEGENERATE (no triangle is left), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_repair_compute(const obc_surface *surface, const obc_repair_options *options, const obc_host *host,
                                      obc_repair **out, obc_error *error);

/* Destroys a repaired surface; NULL is allowed. */
OBC_API void obc_repair_destroy(obc_repair *repaired);

/* Return the numbers of vertices, triangles and events; 0 for NULL. */
OBC_API size_t obc_repair_vertex_count(const obc_repair *repaired);
OBC_API size_t obc_repair_triangle_count(const obc_repair *repaired);
OBC_API size_t obc_repair_event_count(const obc_repair *repaired);

/* Copies the surface to arrays of the caller, each of which may be NULL: positions (x y z a vertex), triangles (three vertices each), and
 * for each vertex and triangle its number in the input, or UINT32_MAX where the repair made it. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_repair_copy(const obc_repair *repaired, double *positions, uint32_t *triangles, uint32_t *vertex_source,
                                   uint32_t *triangle_source, obc_error *error);

/* Copies what was done, in the order in which it was, to arrays of the caller with an entry an event, each of which may be NULL: actions
 * (OBC_REPAIR_...), counts, places (x y z an event) and sizes. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_repair_copy_events(const obc_repair *repaired, int32_t *actions, uint32_t *counts, double *places,
                                          double *sizes, obc_error *error);

/* Fills a report. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_repair_get_report(const obc_repair *repaired, obc_repair_report *report, obc_error *error);

/* Returns the name of an action, as "filled-hole", or "unknown". */
OBC_API const char *obc_repair_action_name(int32_t action);

/* Options of the surface of a label. Fill with _init. */
typedef struct obc_repair_label_options {
  uint32_t struct_size;
  int32_t label;     /* label whose voxels are the object; 0: the only one besides 0. Default: 0. */
  int32_t cavities;  /* 1: cavities are kept, as surfaces inside, if handles is 1; 0: they are filled. Default: 0. */
  int32_t handles;   /* 1: handles and tunnels are kept; 0: they are removed, so that each part has genus 0. Default: 0. */
  size_t keep_parts; /* number of parts to keep, those with the largest number of voxels; 0: all. Default: 1. */
  double smoothing;  /* standard deviation of the Gaussian that smooths the object, in voxels, 0 to 10; 0: none. Default: 1. */
  double max_slide;  /* maximum distance of a vertex from the middle between two voxel centers, as a fraction of their distance, below 0.5.
                        Default: 0.45. */
} obc_repair_label_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_repair_label_options_init(obc_repair_label_options *options, size_t struct_size);

/* Figures of the surface of a label. Fill with _init. */
typedef struct obc_repair_label_report {
  uint32_t struct_size;
  int32_t label;            /* whose surface it is */
  size_t voxels;            /* of the label */
  size_t border_voxels;     /* of these at the border of the image, where the surface is closed */
  size_t found_parts;       /* connected through faces of voxels */
  size_t kept_parts;        /* of these; parts inside others are part of them where cavities are filled */
  size_t dropped_voxels;    /* of the other parts */
  size_t cavities;          /* filled */
  size_t filled_voxels;     /* of cavities */
  size_t handles;           /* handles and tunnels that were removed */
  size_t added_voxels;      /* to close tunnels */
  size_t removed_voxels;    /* to cut handles */
  size_t centered_vertices; /* moved back to the middle between two voxel centers, because triangles intersected */
  double largest_slide;     /* distance of a vertex from this middle, as a fraction of the distance of the centers */
} obc_repair_label_report;

/* Fills a report with zeros and its struct_size. */
OBC_API obc_status obc_repair_label_report_init(obc_repair_label_report *report, size_t struct_size);

/* Extracts the closed surface of a label of an image: labels of size[0] * size[1] * size[2] voxels, x fastest, and to_world, a 4x4 matrix,
 * row-major, from (x, y, z, 1) to positions, with voxel centers at whole numbers and the last row 0 0 0 1; NULL: positions are
 * voxel numbers. It is outward-oriented, also where to_world mirrors. The largest parts are kept, cavities filled, handles and tunnels
 * removed at their thinnest places by homotopic growth and shrinking; vertices lie between the centers of adjacent voxels where
 * the smoothed object ends. No triangles intersect, the centers of the object's voxels are inside and all others outside, and the
 * surface is within half a voxel of the sides of its voxels. options and host may be NULL. *out is NULL after an error; its
 * certificate is in the report of obc_repair_get_report, its sources are all UINT32_MAX, it has no events. Takes O(n log n) of the
 * voxels in the label's box and about 20 bytes for each of them. Errors: OBC_INVALID_ARGUMENT (sizes that overflow, a singular map, a
 * label that is not there, several labels and none chosen; the message lists those that are there), OBC_NO_VALID_RESULT (large
 * coordinates leave too few digits, so that triangles intersect), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_repair_surface_of_label(const int32_t *labels, const size_t *size, const double *to_world,
                                               const obc_repair_label_options *options, const obc_host *host, obc_repair **out,
                                               obc_error *error);

/* Fills a report of obc_repair_surface_of_label; zeros for other repairs. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_repair_get_label_report(const obc_repair *repaired, obc_repair_label_report *report, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_repair_version(void);

#ifdef __cplusplus
}
#endif

#endif
