/* Orbicube mesh: triangle surfaces and meshes of tetrahedra and hexahedra, their files (OBJ, OFF, PLY, STL, MEDIT .mesh,
 * legacy VTK); what kind of surface one is, consistent orientation, searches, and exact predicates.
 *
 * Arrays are the caller's: positions are x y z a vertex (3 * vertex_count doubles, finite), triangles are three vertices
 * each (3 * triangle_count indices from 0, counter-clockwise seen from outside), tetrahedra four (the fourth on the side that
 * the first three look away from as a triangle: volume > 0), hexahedra eight (bottom counter-clockwise seen from inside,
 * then top, as in MEDIT and VTK files). Nothing is kept after a call unless the function says so. Indices and positions are
 * checked: what is out of range or not finite ends in OBC_INVALID_ARGUMENT.
 *
 * Thread safety: all functions may be called at the same time; handles may be read by several threads. All work is done on
 * the calling thread, but where a function says so. Results are the same bits for any number of threads.
 */
#ifndef ORBICUBE_MESH_H
#define ORBICUBE_MESH_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A surface as the caller holds it: a view, kept by no function. */
typedef struct obc_surface {
  const double *positions; /* x y z a vertex */
  size_t vertex_count;
  const uint32_t *triangles; /* three vertex indices each, counter-clockwise seen from outside */
  size_t triangle_count;
} obc_surface;

/* ---- meshes ---------------------------------------------------------------------------------------------------------- */

/* A mesh in the library's memory. */
typedef struct obc_mesh obc_mesh;

/* Cells in the caller's arrays, for obc_mesh_create. Fill with _init, then set what there is. */
typedef struct obc_mesh_cells {
  uint32_t struct_size;
  int32_t reserved;
  const double *positions;
  size_t vertex_count;
  const uint32_t *triangles;   /* or NULL, as tetrahedra and hexahedra */
  size_t triangle_count;
  const uint32_t *tetrahedra;
  size_t tetrahedron_count;
  const uint32_t *hexahedra;
  size_t hexahedron_count;
} obc_mesh_cells;

/* A mesh of nothing. */
OBC_API obc_status obc_mesh_cells_init(obc_mesh_cells *cells, size_t struct_size);

/* A mesh with copies of the arrays. host may be NULL; its allocator must stay valid until _destroy. Errors: invalid argument,
 * out of memory. O(n). */
OBC_API obc_status obc_mesh_create(const obc_mesh_cells *cells, const obc_host *host, obc_mesh **out, obc_error *error);

/* A closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc_mesh_shape_name lists them) of about
 * `triangle_count` triangles, two units in size; the seed varies it. Errors: invalid argument, out of memory, cancelled. O(n). */
OBC_API obc_status obc_mesh_make(const char *shape, size_t triangle_count, uint64_t seed, const obc_host *host,
                                 obc_mesh **out, obc_error *error);

/* Name of the index-th shape that obc_mesh_make knows, a static string; NULL beyond the last one. */
OBC_API const char *obc_mesh_shape_name(size_t index);

/* Releases a mesh; NULL is fine. */
OBC_API void obc_mesh_destroy(obc_mesh *mesh);

/* Numbers of a mesh; 0 for NULL. */
OBC_API size_t obc_mesh_vertex_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_triangle_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_tetrahedron_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_hexahedron_count(const obc_mesh *mesh);

/* Copies to the caller's arrays, each of which may be NULL. Errors: invalid argument. */
OBC_API obc_status obc_mesh_copy(const obc_mesh *mesh, double *positions, uint32_t *triangles, uint32_t *tetrahedra,
                                 uint32_t *hexahedra, obc_error *error);

/* A view of the mesh's own positions and triangles, valid until the mesh is destroyed. Errors: invalid argument. */
OBC_API obc_status obc_mesh_surface(const obc_mesh *mesh, obc_surface *surface, obc_error *error);

/* Whether the tetrahedra and hexahedra fill a solid: distinct, positive by exact predicates (hexahedra at each corner), meeting
 * in whole faces, no face of three cells, no edge where parts only touch. OBC_OK, also without cells; or degenerate or not
 * manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
 * first place; out of memory, cancelled. O(n log n). */
OBC_API obc_status obc_mesh_check_cells(const obc_mesh *mesh, const obc_host *host, obc_error *error);

/* The surface of the solid that the cells fill, looking outward, as a mesh of its own with the same vertices: the faces of one
 * cell only, those of hexahedra cut in two. Errors: invalid argument, not manifold (a face of three cells), out of memory,
 * cancelled. O(n log n). */
OBC_API obc_status obc_mesh_boundary(const obc_mesh *mesh, const obc_host *host, obc_mesh **out, obc_error *error);

/* How well shaped tetrahedra are. Ratios of inverted ones are negative, of flat ones 0; angles are in degrees. */
typedef struct obc_mesh_tetrahedron_quality_report {
  uint32_t struct_size, worst;                    /* the first one of the smallest radius ratio; 2^32 - 1: there are none */
  uint64_t tetrahedra, positive, flat, inverted;  /* all, and those by their exact signs */
  double volume, smallest_volume, largest_volume; /* of all together and of one; those of inverted ones negative */
  double smallest_dihedral, largest_dihedral, mean_smallest_dihedral; /* at the edges; the mean of each one's smallest */
  double smallest_radius_ratio, mean_radius_ratio;  /* 3 * inradius / circumradius: 1 for a regular tetrahedron */
  double largest_radius_edge, mean_radius_edge;     /* circumradius / shortest edge; infinite, and left out, for flat ones */
  double shortest_edge, longest_edge;
  uint64_t dihedral_histogram[18], radius_ratio_histogram[20]; /* six angles each, by 10 degrees; ratios by 0.05 */
} obc_mesh_tetrahedron_quality_report;

/* An empty report that knows its size. */
OBC_API obc_status obc_mesh_tetrahedron_quality_report_init(obc_mesh_tetrahedron_quality_report *report, size_t struct_size);

/* Measures the tetrahedra of a mesh, whatever they are. Errors: invalid argument, cancelled. O(n). */
OBC_API obc_status obc_mesh_tetrahedron_quality(const obc_mesh *mesh, const obc_host *host,
                                                obc_mesh_tetrahedron_quality_report *report, obc_error *error);

/* ---- files ------------------------------------------------------------------------------------------------------------ */

/* Formats, for files in memory. */
enum {
  OBC_MESH_OBJ = 0,
  OBC_MESH_OFF = 1,
  OBC_MESH_PLY = 2,  /* ASCII and binary of either byte order, triangle strips */
  OBC_MESH_STL = 3,  /* ASCII and binary */
  OBC_MESH_MEDIT = 4,
  OBC_MESH_VTK = 5   /* legacy, ASCII and binary */
};

/* Fill with _init. */
typedef struct obc_mesh_read_options {
  uint32_t struct_size;
  int32_t weld_identical; /* 1: joins vertices at identical positions when the surface is not closed as it stands. STL, which
                             has no shared vertices, is always joined. Default 0 */
} obc_mesh_read_options;

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_mesh_read_options_init(obc_mesh_read_options *options, size_t struct_size);

/* Reads the file at `path` (bytes as the system takes them), its format by its ending: .obj .off .ply .stl .mesh .vtk.
 * Vertices keep their order unless they are joined; faces of more corners are cut into triangles; cells are checked as by
 * obc_mesh_check_cells. options and host may be NULL; the host's allocator must stay valid until _destroy. Nothing in a file
 * is trusted; memory is bounded by a multiple of its size. Errors: io, malformed file (the kind says how: truncated, parse,
 * index-range, non-finite, ...; the message where), the kinds of cells, unsupported, out of memory, cancelled. O(size). */
OBC_API obc_status obc_mesh_read(const char *path, const obc_mesh_read_options *options, const obc_host *host,
                                 obc_mesh **out, obc_error *error);

/* The same from `size` bytes of a file of the format OBC_MESH_...; they are not kept. */
OBC_API obc_status obc_mesh_read_memory(const void *bytes, size_t size, int32_t format,
                                        const obc_mesh_read_options *options, const obc_host *host, obc_mesh **out,
                                        obc_error *error);

/* What was found in reading: the format, as "PLY, binary, big-endian"; polygons of more than three corners; vertices that were
 * joined to others; and notes on what was changed or left out, one line each, the index-th one, NULL when there is none.
 * Texts are UTF-8 and the mesh's. Empty and 0 for a mesh that was not read. */
OBC_API const char *obc_mesh_format(const obc_mesh *mesh);
OBC_API size_t obc_mesh_polygon_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_welded_vertex_count(const obc_mesh *mesh);
OBC_API const char *obc_mesh_note(const obc_mesh *mesh, size_t index);

/* Fill with _init. */
typedef struct obc_mesh_write_options {
  uint32_t struct_size;
  int32_t binary; /* 1: PLY, STL and VTK in binary; 0: as text. The other formats are text. Default 1 */
} obc_mesh_write_options;

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_mesh_write_options_init(obc_mesh_write_options *options, size_t struct_size);

/* Writes to `path`, the format by its ending: triangles to OBJ, OFF, PLY and STL, cells too to MEDIT and VTK. What is read
 * again is the same mesh to the bit, but for STL, which has float32. The file appears once it is whole; after an error the
 * old one is still there. options and host may be NULL. Errors: invalid argument, unsupported (the ending, or cells that the
 * format cannot hold), io, out of memory, cancelled. O(n). */
OBC_API obc_status obc_mesh_write(const char *path, const obc_mesh *mesh, const obc_mesh_write_options *options,
                                  const obc_host *host, obc_error *error);

/* The same for a surface in the caller's arrays. */
OBC_API obc_status obc_mesh_write_surface(const char *path, const obc_surface *surface,
                                          const obc_mesh_write_options *options, const obc_host *host,
                                          obc_error *error);

/* ---- topology -------------------------------------------------------------------------------------------------------- */

/* What kind of surface it is. The first place of a defect is given by vertices or faces, 2^32 - 1 where there is none. */
typedef struct obc_mesh_topology_report {
  uint32_t struct_size;
  int32_t closed;                        /* 1: there are triangles and no boundary; else 0 */
  int32_t manifold;                      /* 1: no non-manifold, duplicate or degenerate places; else 0 */
  int32_t orientable;                    /* 1: turning triangles round can make all edges consistent; else 0 */
  uint64_t vertices;
  uint64_t unreferenced_vertices;        /* in no triangle; they take no part in the other figures */
  uint64_t triangles;
  uint64_t edges;
  uint64_t components;                   /* connected through vertices */
  uint64_t boundary_edges;               /* with one triangle */
  uint64_t boundary_loops;               /* connected parts of the boundary */
  uint64_t longest_boundary_loop;        /* in edges */
  uint64_t non_manifold_edges;           /* with three triangles or more */
  uint64_t non_manifold_vertices;        /* whose triangles form more than one fan */
  uint64_t inconsistent_edges;           /* that both of their triangles pass in the same direction */
  uint64_t degenerate_faces;             /* with a repeated corner; they have no edges */
  uint64_t duplicate_faces;              /* with the corners of an earlier face, in any order */
  uint64_t zero_area_faces;              /* whose three different corners lie on one line, exactly */
  uint64_t coincident_vertices;          /* at the very position of an earlier vertex */
  int64_t euler_characteristic;          /* vertices - edges + triangles */
  int64_t genus;                         /* of a closed, connected, orientable manifold; -1 for others */
  double low[3], high[3];                /* bounding box of the triangles */
  double area, volume;                   /* volume < 0: looks inward. Infinite beyond the range of double */
  uint32_t first_boundary_edge[2];
  uint32_t first_non_manifold_edge[2];
  uint32_t first_inconsistent_edge[2];
  uint32_t first_duplicate_faces[2];
  uint32_t first_coincident_vertices[2];
  uint32_t first_non_manifold_vertex;
  uint32_t first_vertex_apart;           /* not connected with the first vertex */
  uint32_t first_degenerate_face;
  uint32_t first_zero_area_face;
} obc_mesh_topology_report;

/* An empty report that knows its size. */
OBC_API obc_status obc_mesh_topology_report_init(obc_mesh_topology_report *report, size_t struct_size);

/* Examines any set of triangles. host may be NULL. Errors: invalid argument, out of memory, cancelled. O(n log n) time, O(n)
 * for bounded valence (0.1 s for a million triangles), up to 100 bytes a triangle. */
OBC_API obc_status obc_mesh_topology(const obc_surface *surface, const obc_host *host,
                                     obc_mesh_topology_report *report, obc_error *error);

/* Whether the surface is what sphere maps need: closed, connected, manifold, consistently oriented, of genus 0. OBC_OK, or not
 * closed, not manifold, wrong genus or degenerate with the kind and the first place in `error`; invalid argument, out of
 * memory, cancelled. Costs what obc_mesh_topology costs. */
OBC_API obc_status obc_mesh_check_closed_genus_zero(const obc_surface *surface, const obc_host *host, obc_error *error);

/* What obc_mesh_orient did. */
typedef struct obc_mesh_orient_report {
  uint32_t struct_size;
  int32_t turned_outward;    /* 1: the closed surface looked inward, and all triangles were turned; else 0 */
  uint64_t triangles_turned; /* before that, to agree with their neighbours */
} obc_mesh_orient_report;

/* An empty report that knows its size. */
OBC_API obc_status obc_mesh_orient_report_init(obc_mesh_orient_report *report, size_t struct_size);

/* Turns triangles in place so that neighbours agree, the fewer of each part, and then all of them when the surface is closed
 * and its volume negative. report may be NULL. Errors: invalid argument, not manifold (non-orientable; nothing is changed
 * then), out of memory, cancelled. O(n). */
OBC_API obc_status obc_mesh_orient(const double *positions, size_t vertex_count, uint32_t *triangles,
                                   size_t triangle_count, const obc_host *host, obc_mesh_orient_report *report,
                                   obc_error *error);

/* For each vertex the lowest vertex at its very position (-0 is 0), vertex_count entries. Errors: invalid argument, out of
 * memory, cancelled. O(n). */
OBC_API obc_status obc_mesh_first_at_same_position(const double *positions, size_t vertex_count, const obc_host *host,
                                                   uint32_t *first, obc_error *error);

/* Pairs of triangles that have more in common than the vertices they share by number, decided by exact predicates: the first
 * `capacity` pairs in ascending order, two entries each, the lower triangle first; *count is how many were written. Triangles
 * without area are left out. Works on the host's threads. Errors: invalid argument, out of memory, cancelled. O(n log n +
 * pairs whose boxes overlap). */
OBC_API obc_status obc_mesh_intersections(const obc_surface *surface, const obc_host *host, uint32_t *pairs,
                                          size_t capacity, size_t *count, obc_error *error);

/* ---- searching ------------------------------------------------------------------------------------------------------- */

/* A surface made ready for searching: trees of bounding boxes over its vertices and triangles. */
typedef struct obc_mesh_search obc_mesh_search;

/* Copies the surface. host may be NULL; its allocator must stay valid until _destroy. Errors: invalid argument (also: a coordinate
 * beyond 1e150, here and in points), out of memory, cancelled. O(n log n), about 200 bytes a triangle. */
OBC_API obc_status obc_mesh_search_create(const obc_surface *surface, const obc_host *host, obc_mesh_search **out,
                                          obc_error *error);

/* Releases a search; NULL is fine. */
OBC_API void obc_mesh_search_destroy(obc_mesh_search *search);

/* For each of `count` points (3 * count doubles) the nearest vertex, the lowest of equals. Errors: invalid argument (also: a
 * point that is not finite, no vertices). O(log n) a point on average. */
OBC_API obc_status obc_mesh_search_vertices(const obc_mesh_search *search, const double *points, size_t count,
                                            uint32_t *vertices, obc_error *error);

/* For each of `count` points the nearest point of the surface: its triangle (the lowest of equals), its weights at the
 * triangle's corners (3 * count, none negative, sum 1), its position (3 * count) and its distance; each array may be NULL.
 * Errors: invalid argument (also: a point that is not finite, no triangles). O(log n) a point on average. */
OBC_API obc_status obc_mesh_search_surface(const obc_mesh_search *search, const double *points, size_t count,
                                           uint32_t *triangles, double *weights, double *positions, double *distances,
                                           obc_error *error);

/* ---- exact predicates ------------------------------------------------------------------------------------------------ */

/* Signs of determinants, exact for all finite doubles: a filter with a proven bound, then integers of any length. They answer -1,
 * 0 or 1; 2 for NULL, a coordinate that is not finite, and when there is no memory for the integers. Points are 2 or 3 doubles. */
/* Sign of (b - a) x (c - a): 1 when the triangle a, b, c of the plane is counter-clockwise. */
OBC_API int32_t obc_mesh_orientation_2d(const double *a, const double *b, const double *c);

/* Sign of det[b - a, c - a, d - a]: 1 when the tetrahedron a, b, c, d has positive volume. */
OBC_API int32_t obc_mesh_orientation_3d(const double *a, const double *b, const double *c, const double *d);

/* Sign of det[p, q, r]: 1 when p, q, r are counter-clockwise seen from outside a sphere around the origin. */
OBC_API int32_t obc_mesh_orientation_from_origin(const double *p, const double *q, const double *r);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_mesh_version(void);

#ifdef __cplusplus
}
#endif

#endif
