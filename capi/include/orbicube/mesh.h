/* Orbicube mesh: triangle surfaces and meshes of tetrahedra and hexahedra: files (OBJ, OFF, PLY, STL, MEDIT, legacy VTK,
 * Gmsh, FreeSurfer, Abaqus, VTK XML, GIFTI), topology, consistent orientation, search, and exact predicates.
 *
 * Arrays are the caller's. Positions are x y z a vertex (3 * vertex_count finite doubles). Triangles are three vertex indices each
 * (from 0, counter-clockwise seen from outside). Tetrahedra are four, the fourth on the side from which the first three are clockwise, so
 * that the volume is positive. Hexahedra are eight (bottom counter-clockwise seen from inside, then top, as in MEDIT and VTK files). No
 * function keeps an array unless its description says so. An index out of range or a position that is not finite is an invalid
 * argument.
 *
 * Thread safety: all functions may be called at the same time; several threads may read one handle. Work is done on the calling
 * thread except where a description says otherwise. Results are the same bits for any number of threads.
 *
 * Example: writes a generated surface, reads it and prints its genus.
 *
 *   #include <orbicube/mesh.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_mesh *made = NULL, *read = NULL;
 *     obc_surface surface;
 *     obc_mesh_topology_report report;
 *     obc_error error;
 *     if (obc_mesh_make("torus", 2000, 0, NULL, &made, &error) != OBC_OK) return 1;
 *     if (obc_mesh_write("torus.ply", made, NULL, NULL, &error) != OBC_OK) return puts(error.message), 1;
 *     if (obc_mesh_read("torus.ply", NULL, NULL, &read, &error) != OBC_OK) return puts(error.message), 1;
 *     obc_mesh_topology_report_init(&report, sizeof report);
 *     if (obc_mesh_surface(read, &surface, &error) != OBC_OK) return 1;
 *     if (obc_mesh_topology(&surface, NULL, &report, &error) != OBC_OK) return 1;
 *     printf("genus %d\n", (int)report.genus); // 1
 *     obc_mesh_destroy(made), obc_mesh_destroy(read);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_MESH_H
#define ORBICUBE_MESH_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A triangle surface: a view of arrays of the caller. */
typedef struct obc_surface {
  const double *positions;   /* x y z a vertex */
  size_t vertex_count;       /* number of vertices */
  const uint32_t *triangles; /* three vertex indices each, counter-clockwise seen from outside */
  size_t triangle_count;     /* number of triangles */
} obc_surface;

/* ---- meshes ---------------------------------------------------------------------------------------------------------- */

/* A mesh in memory of the library. */
typedef struct obc_mesh obc_mesh;

/* Vertices and cells in arrays of the caller, for obc_mesh_create. Fill with _init. */
typedef struct obc_mesh_cells {
  uint32_t struct_size;
  int32_t reserved;

  const double *positions; /* x y z a vertex. Default: NULL. */
  size_t vertex_count;     /* number of vertices. Default: 0. */

  const uint32_t *triangles; /* three vertices each, or NULL. Default: NULL. */
  size_t triangle_count;     /* number of triangles. Default: 0. */

  const uint32_t *tetrahedra; /* four vertices each, or NULL. Default: NULL. */
  size_t tetrahedron_count;   /* number of tetrahedra. Default: 0. */

  const uint32_t *hexahedra; /* eight vertices each, or NULL. Default: NULL. */
  size_t hexahedron_count;   /* number of hexahedra. Default: 0. */

  const int32_t *triangle_regions;    /* region number of each triangle (0: none), or NULL. Default: NULL. */
  const int32_t *tetrahedron_regions; /* region number of each tetrahedron, or NULL. Default: NULL. */
  const int32_t *hexahedron_regions;  /* region number of each hexahedron, or NULL. Default: NULL. */
} obc_mesh_cells;

/* Fills cells with an empty mesh. */
OBC_API obc_status obc_mesh_cells_init(obc_mesh_cells *cells, size_t struct_size);

/* Creates a mesh with copies of the arrays. host may be NULL; its allocator must remain valid until _destroy. O(n). Errors: invalid
 * argument, out of memory. */
OBC_API obc_status obc_mesh_create(const obc_mesh_cells *cells, const obc_host *host, obc_mesh **out, obc_error *error);

/* Generates a closed surface by name ("creature", "torus", "cube", "sphere", "bracket", ...; obc_mesh_shape_name lists the names) of about
 * `triangle_count` triangles, two units in size; the seed varies its shape. O(n). Errors: invalid argument, out of memory,
 * cancelled. */
OBC_API obc_status obc_mesh_make(const char *shape, size_t triangle_count, uint64_t seed, const obc_host *host,
                                 obc_mesh **out, obc_error *error);

/* Returns the name of the index-th shape of obc_mesh_make, a static string; NULL from the number of shapes on. */
OBC_API const char *obc_mesh_shape_name(size_t index);

/* Destroys a mesh; NULL is allowed. */
OBC_API void obc_mesh_destroy(obc_mesh *mesh);

/* Return the numbers of vertices and cells of a mesh; 0 for NULL. */
OBC_API size_t obc_mesh_vertex_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_triangle_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_tetrahedron_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_hexahedron_count(const obc_mesh *mesh);

/* Copies a mesh to arrays of the caller, each of which may be NULL. Errors: invalid argument. */
OBC_API obc_status obc_mesh_copy(const obc_mesh *mesh, double *positions, uint32_t *triangles, uint32_t *tetrahedra,
                                 uint32_t *hexahedra, obc_error *error);

/* Parts of a mesh that have region numbers: bits of obc_mesh_region_kinds. */
enum {
  OBC_MESH_TRIANGLE_REGIONS = 1,    /* of triangles, such as the patches of a CAD model */
  OBC_MESH_TETRAHEDRON_REGIONS = 2, /* of tetrahedra, such as materials */
  OBC_MESH_HEXAHEDRON_REGIONS = 4   /* of hexahedra */
};

/* Returns what has region numbers, bits OBC_MESH_..._REGIONS; 0 for NULL. */
OBC_API uint32_t obc_mesh_region_kinds(const obc_mesh *mesh);

/* Copies the region number of each triangle and cell, 0 where it has none, to arrays of the caller, each of which may be NULL. Errors:
 * invalid argument. */
OBC_API obc_status obc_mesh_copy_regions(const obc_mesh *mesh, int32_t *triangles, int32_t *tetrahedra, int32_t *hexahedra,
                                         obc_error *error);

/* Returns a view of the positions and triangles of a mesh, valid until the mesh is destroyed. Errors: invalid argument. */
OBC_API obc_status obc_mesh_surface(const obc_mesh *mesh, obc_surface *surface, obc_error *error);

/* Checks that the tetrahedra and hexahedra form a solid: distinct, positive by exact predicates (hexahedra at each corner),
 * conforming, no face with three cells, no edge at which parts touch. Returns OBC_OK, also without cells, or degenerate or not
 * manifold with the kind (inverted-cell, degenerate-cell, duplicate-cell, non-manifold-face, non-manifold-edge) and the
 * first location. O(n log n). Errors: those, out of memory, cancelled. */
OBC_API obc_status obc_mesh_check_cells(const obc_mesh *mesh, const obc_host *host, obc_error *error);

/* Computes the outward-oriented boundary surface of the solid, a new mesh with the same vertices: the faces of exactly one cell, those of
 * hexahedra split in two. O(n log n). Errors: invalid argument, not manifold (a face with three cells), out of memory, cancelled. */
OBC_API obc_status obc_mesh_boundary(const obc_mesh *mesh, const obc_host *host, obc_mesh **out, obc_error *error);

/* Quality of tetrahedra. Ratios are negative for inverted tetrahedra and 0 for flat ones; angles are in degrees. */
typedef struct obc_mesh_tetrahedron_quality_report {
  uint32_t struct_size, worst;                    /* worst: first tetrahedron with the minimum radius ratio; 2^32 - 1: none */
  uint64_t tetrahedra, positive, flat, inverted;  /* numbers of all tetrahedra and of those with each exact sign */
  double volume, min_volume, max_volume; /* total, minimum and maximum signed volume */
  double min_dihedral, max_dihedral, mean_min_dihedral; /* dihedral angles; the mean is that of each tetrahedron's minimum */
  double min_radius_ratio, mean_radius_ratio; /* 3 * inradius / circumradius: 1 for a regular tetrahedron */
  double max_radius_edge, mean_radius_edge;    /* circumradius / shortest edge; infinite for flat tetrahedra, which the mean leaves out */
  double min_edge_length, max_edge_length;              /* edge lengths */
  uint64_t dihedral_histogram[18], radius_ratio_histogram[20]; /* six angles a tetrahedron in bins of 10 degrees; ratios in bins of 0.05 */
} obc_mesh_tetrahedron_quality_report;

/* Fills a report with zeros and its size. */
OBC_API obc_status obc_mesh_tetrahedron_quality_report_init(obc_mesh_tetrahedron_quality_report *report, size_t struct_size);

/* Measures the tetrahedra of a mesh, valid or not. O(n). Errors: invalid argument, cancelled. */
OBC_API obc_status obc_mesh_tetrahedron_quality(const obc_mesh *mesh, const obc_host *host,
                                                obc_mesh_tetrahedron_quality_report *report, obc_error *error);

/* ---- files ------------------------------------------------------------------------------------------------------------ */

/* File formats. */
enum {
  OBC_MESH_OBJ = 0,        /* text */
  OBC_MESH_OFF = 1,        /* text */
  OBC_MESH_PLY = 2,        /* text and binary of either byte order, triangle strips */
  OBC_MESH_STL = 3,        /* text and binary */
  OBC_MESH_MEDIT = 4,      /* text */
  OBC_MESH_VTK = 5,        /* legacy, text and binary */
  OBC_MESH_MSH = 6,        /* Gmsh, versions 2.2 and 4.1, text and binary; written as text of version 2.2 */
  OBC_MESH_FREESURFER = 7, /* surfaces of FreeSurfer, binary (with float32) and text; also read and written as lh.pial and the like */
  OBC_MESH_INP = 8,        /* Abaqus and CalculiX, linear elements; text */
  OBC_MESH_VTP = 9,        /* VTK XML, surfaces: text and binary, compressed in builds with zlib */
  OBC_MESH_VTU = 10,       /* VTK XML, unstructured grids; the same */
  OBC_MESH_GIFTI = 11      /* GIFTI surfaces: text and binary (with float32), compressed in builds with zlib */
};

/* What files of a format can hold: bits of obc_mesh_format_contents. */
enum {
  OBC_MESH_HOLDS_SURFACES = 1, /* triangles; all formats do */
  OBC_MESH_HOLDS_POLYGONS = 2, /* polygons of shared vertices, whose coordinates read back bit-identically */
  OBC_MESH_HOLDS_CELLS = 4,    /* tetrahedra and hexahedra */
  OBC_MESH_HOLDS_BINARY = 8,   /* binary contents; all formats may be text */
  OBC_MESH_HOLDS_REGIONS = 16  /* region numbers of triangles, and of cells where it holds them */
};

/* Return the ending of files of the format OBC_MESH_... in lower case, with its dot; the name of the format, such as "PLY"; and what its files
 * can hold, bits OBC_MESH_HOLDS_.... The texts are static. Formats are numbered from 0; NULL and 0 from the number of formats on. */
OBC_API const char *obc_mesh_format_ending(int32_t format);
OBC_API const char *obc_mesh_format_name(int32_t format);
OBC_API uint32_t obc_mesh_format_contents(int32_t format);

/* Options of readers. Fill with _init. */
typedef struct obc_mesh_read_options {
  uint32_t struct_size;

  /* 1: welds vertices at identical positions if the surface is not closed as read; 0: does not. STL has no shared vertices and is
   * always welded. Default: 0. */
  int32_t weld_identical;
} obc_mesh_read_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_mesh_read_options_init(obc_mesh_read_options *options, size_t struct_size);

/* Reads the file at `path` (bytes in the encoding of the system) in the format of its ending, in upper or lower case.
 * Vertices keep their order unless they are welded; polygons are split into triangles; cells are checked as by
 * obc_mesh_check_cells. options and host may be NULL; the allocator of the host must remain valid until _destroy. All contents are
 * checked; memory is bounded by a multiple of the file size. O(size). Errors: io; malformed file (the kind says how:
 * truncated, parse, index-range, non-finite, ...; the message where); the kinds of cells; unsupported; out of memory; cancelled. */
OBC_API obc_status obc_mesh_read(const char *path, const obc_mesh_read_options *options, const obc_host *host,
                                 obc_mesh **out, obc_error *error);

/* Reads a file of the format OBC_MESH_... from `size` bytes in memory, which are not kept; otherwise as obc_mesh_read. */
OBC_API obc_status obc_mesh_read_memory(const void *bytes, size_t size, int32_t format,
                                        const obc_mesh_read_options *options, const obc_host *host, obc_mesh **out,
                                        obc_error *error);

/* Return facts about the file that a mesh was read from: its format, such as "PLY, binary, big-endian"; the number of polygons with more than
 * three corners; the number of welded vertices; and the index-th note on changed or omitted contents, one line each, NULL from
 * the number of notes on. Texts are UTF-8 and valid until the mesh is destroyed. Empty and 0 for a mesh that was not read. */
OBC_API const char *obc_mesh_format(const obc_mesh *mesh);
OBC_API size_t obc_mesh_polygon_count(const obc_mesh *mesh);
OBC_API size_t obc_mesh_welded_vertex_count(const obc_mesh *mesh);
OBC_API const char *obc_mesh_note(const obc_mesh *mesh, size_t index);

/* Options of writers. Fill with _init. */
typedef struct obc_mesh_write_options {
  uint32_t struct_size;
  int32_t binary; /* 1: PLY, STL, VTK, VTP, VTU, FreeSurfer and GIFTI in binary; 0: as text. The other formats are text. Default: 1. */
} obc_mesh_write_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_mesh_write_options_init(obc_mesh_write_options *options, size_t struct_size);

/* Writes to `path` in the format of its ending: triangles, and cells and region numbers in formats that hold them. Reading the file returns a
 * bit-identical mesh, except for STL, FreeSurfer and GIFTI, which have float32. The file appears when it is complete; after an error the
 * previous file remains. options and host may be NULL. O(n). Errors: invalid argument, unsupported (the ending, or cells that the
 * format does not have), io, out of memory, cancelled. */
OBC_API obc_status obc_mesh_write(const char *path, const obc_mesh *mesh, const obc_mesh_write_options *options,
                                  const obc_host *host, obc_error *error);

/* Writes a surface in arrays of the caller; otherwise as obc_mesh_write. */
OBC_API obc_status obc_mesh_write_surface(const char *path, const obc_surface *surface,
                                          const obc_mesh_write_options *options, const obc_host *host,
                                          obc_error *error);

/* ---- topology -------------------------------------------------------------------------------------------------------- */

/* Topology of a surface. Defects have the indices of the first occurrence, 2^32 - 1 where there is none. */
typedef struct obc_mesh_topology_report {
  uint32_t struct_size;

  int32_t closed;     /* 1: there are triangles and no boundary; 0: otherwise */
  int32_t manifold;   /* 1: no non-manifold, duplicate or degenerate elements; 0: otherwise */
  int32_t orientable; /* 1: reversing triangles can make all edges consistent; 0: otherwise */

  uint64_t vertices;              /* number of vertices */
  uint64_t unreferenced_vertices; /* number of vertices in no triangle, which the other figures leave out */
  uint64_t triangles;             /* number of triangles */
  uint64_t edges;                 /* number of edges */
  uint64_t components;            /* number of components connected through vertices */

  uint64_t boundary_edges;        /* number of edges with one triangle */
  uint64_t boundary_loops;        /* number of connected components of the boundary */
  uint64_t longest_boundary_loop; /* maximum number of edges of one of them */

  uint64_t non_manifold_edges;    /* number of edges with three or more triangles */
  uint64_t non_manifold_vertices; /* number of vertices whose triangles form more than one fan */
  uint64_t inconsistent_edges;    /* number of edges that both triangles traverse in the same direction */
  uint64_t degenerate_faces;      /* number of triangles with a repeated vertex, which have no edges */
  uint64_t duplicate_faces;       /* number of triangles with the vertices of an earlier one, in any order */
  uint64_t zero_area_faces;       /* number of triangles whose three distinct vertices are exactly collinear */
  uint64_t coincident_vertices;   /* number of vertices at exactly the position of an earlier one */

  int64_t euler_characteristic; /* vertices - edges + triangles */
  int64_t genus;                /* genus of a closed, connected, orientable manifold; -1 for other surfaces */

  double low[3], high[3]; /* bounding box of the triangles */
  double area, volume;    /* volume is negative if inward-oriented. Out of range of double: infinite, or the smallest number of the sign */

  uint32_t first_boundary_edge[2];       /* two vertices */
  uint32_t first_non_manifold_edge[2];   /* two vertices */
  uint32_t first_inconsistent_edge[2];   /* two vertices */
  uint32_t first_duplicate_faces[2];     /* two triangles */
  uint32_t first_coincident_vertices[2]; /* two vertices */
  uint32_t first_non_manifold_vertex;    /* a vertex */
  uint32_t first_vertex_apart;           /* a vertex that is not connected to the first one */
  uint32_t first_degenerate_face;        /* a triangle */
  uint32_t first_zero_area_face;         /* a triangle */
} obc_mesh_topology_report;

/* Fills a report with zeros and its size. */
OBC_API obc_status obc_mesh_topology_report_init(obc_mesh_topology_report *report, size_t struct_size);

/* Analyzes any set of triangles. host may be NULL. O(n log n) time, O(n) for bounded valence (0.1 s for a million triangles), up to
 * 100 bytes a triangle. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_mesh_topology(const obc_surface *surface, const obc_host *host,
                                     obc_mesh_topology_report *report, obc_error *error);

/* Checks the requirements of sphere maps: closed, connected, manifold, consistently oriented, genus 0. Returns OBC_OK, or not
 * closed, not manifold, wrong genus or degenerate with the kind and the first location in `error`. Costs as much as
 * obc_mesh_topology. Errors: those, invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_mesh_check_closed_genus_zero(const obc_surface *surface, const obc_host *host, obc_error *error);

/* Changes by obc_mesh_orient. */
typedef struct obc_mesh_orient_report {
  uint32_t struct_size;
  int32_t inward_oriented;    /* 1: the closed surface was inward-oriented, and all triangles were reversed; 0: otherwise */
  uint64_t reversed_triangles; /* number of triangles reversed before that to agree with their neighbors */
} obc_mesh_orient_report;

/* Fills a report with zeros and its size. */
OBC_API obc_status obc_mesh_orient_report_init(obc_mesh_orient_report *report, size_t struct_size);

/* Reverses triangles in place until neighbors are consistently oriented, the minority of each component, and then all of them if the
 * surface is closed with negative volume. report may be NULL. O(n). Errors: invalid argument, not manifold (non-orientable;
 * nothing is changed), out of memory, cancelled. */
OBC_API obc_status obc_mesh_orient(const double *positions, size_t vertex_count, uint32_t *triangles,
                                   size_t triangle_count, const obc_host *host, obc_mesh_orient_report *report,
                                   obc_error *error);

/* Computes for each vertex the lowest vertex at exactly its position (-0 equals 0), vertex_count entries. O(n). Errors: invalid argument,
 * out of memory, cancelled. */
OBC_API obc_status obc_mesh_first_at_same_position(const double *positions, size_t vertex_count, const obc_host *host,
                                                   uint32_t *first, obc_error *error);

/* Finds pairs of triangles that intersect in more than their shared vertices, by exact predicates: the first `capacity` pairs in
 * ascending order, two entries each, the lower triangle first. *count receives the number of pairs written. Triangles of zero area
 * are left out. Uses the threads of the host. O(n log n + pairs of overlapping boxes). Errors: invalid argument, out of memory,
 * cancelled. */
OBC_API obc_status obc_mesh_intersections(const obc_surface *surface, const obc_host *host, uint32_t *pairs,
                                          size_t capacity, size_t *count, obc_error *error);

/* ---- vertices and distances -------------------------------------------------------------------------------------------- */

/* Computes unit vertex normals, 3 * vertex_count doubles: triangle normals weighted by angles (Thuermer and Wuethrich 1998); 0 0 1 where
 * they cancel and for vertices of no triangle. O(n). Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_mesh_vertex_normals(const obc_surface *surface, const obc_host *host, double *normals,
                                           obc_error *error);

/* Computes a third of the area of the adjacent triangles for each vertex: areas, vertex_count doubles, in the square of the surface's unit.
 * They sum up to the area. O(n). Errors: invalid argument (also: an area beyond the range of double), out of memory,
 * cancelled. */
OBC_API obc_status obc_mesh_vertex_areas(const obc_surface *surface, const obc_host *host, double *areas,
                                         obc_error *error);

/* Distances from sample points of one surface (vertices and centroids) to the nearest point of the other, in both directions, in the
 * unit of the surfaces. */
typedef struct obc_mesh_distance {
  uint32_t struct_size;
  uint32_t reserved;
  double first_mean, first_root_mean_square, first_max;    /* from the first surface: mean, root mean square, maximum */
  double second_mean, second_root_mean_square, second_max; /* from the second surface */
} obc_mesh_distance;

/* Fills a result with zeros and its size. */
OBC_API obc_status obc_mesh_distance_init(obc_mesh_distance *distance, size_t struct_size);

/* Measures the distances between two surfaces (as Metro: Cignoni, Rocchini and Scopigno 1998). Uses the threads of the host.
 * O(n log n). Errors: invalid argument (also: no triangles), out of memory, cancelled. */
OBC_API obc_status obc_mesh_surface_distance(const obc_surface *first, const obc_surface *second, const obc_host *host,
                                             obc_mesh_distance *distance, obc_error *error);

/* Computes the distance of two point sets (3 * a_count and 3 * b_count doubles), e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the
 * points of A of the distance to the nearest point of B: the reconstruction error of the dissertation's section 3.3.2. Uses the
 * threads of the host. O(n log n). Errors: invalid argument (also: no points, a coordinate beyond 1e150), out of memory,
 * cancelled. */
OBC_API obc_status obc_mesh_mean_distance(const double *a, size_t a_count, const double *b, size_t b_count,
                                          const obc_host *host, double *distance, obc_error *error);

/* ---- search ---------------------------------------------------------------------------------------------------------- */

/* Trees of bounding boxes over the vertices and triangles of a surface. */
typedef struct obc_mesh_search obc_mesh_search;

/* Creates a search structure from a copy of the surface. host may be NULL; its allocator must remain valid until _destroy.
 * O(n log n), about 200 bytes a triangle. Errors: invalid argument (also: a coordinate beyond 1e150, here and in points),
 * out of memory, cancelled. */
OBC_API obc_status obc_mesh_search_create(const obc_surface *surface, const obc_host *host, obc_mesh_search **out,
                                          obc_error *error);

/* Destroys a search structure; NULL is allowed. */
OBC_API void obc_mesh_search_destroy(obc_mesh_search *search);

/* Finds the nearest vertex of each of `count` points (3 * count doubles), the lowest of equally near ones. O(log n) a point on
 * average. Errors: invalid argument (also: a point that is not finite, no vertices). */
OBC_API obc_status obc_mesh_search_vertices(const obc_mesh_search *search, const double *points, size_t count,
                                            uint32_t *vertices, obc_error *error);

/* Finds the nearest point of the surface to each of `count` points: its triangle (the lowest of equally near ones), its barycentric
 * coordinates (3 * count, nonnegative, sum 1), its position (3 * count) and its distance; each array may be NULL. O(log n) a
 * point on average. Errors: invalid argument (also: a point that is not finite, no triangles). */
OBC_API obc_status obc_mesh_search_surface(const obc_mesh_search *search, const double *points, size_t count,
                                           uint32_t *triangles, double *weights, double *positions, double *distances,
                                           obc_error *error);

/* ---- exact predicates ------------------------------------------------------------------------------------------------ */

/* The predicates return the exact sign of a determinant, -1, 0 or 1, for all finite doubles (a filter with a proven bound, then
 * integers of any length); 2 for NULL, a coordinate that is not finite, or an allocation failure. Points are 2 or 3 doubles. */

/* Returns the sign of (b - a) x (c - a): 1 if the triangle a, b, c in the plane is counter-clockwise. */
OBC_API int32_t obc_mesh_orientation_2d(const double *a, const double *b, const double *c);

/* Returns the sign of det[b - a, c - a, d - a]: 1 if the tetrahedron a, b, c, d has positive volume. */
OBC_API int32_t obc_mesh_orientation_3d(const double *a, const double *b, const double *c, const double *d);

/* Returns the sign of det[p, q, r]: 1 if p, q, r are counter-clockwise seen from outside a sphere around the origin. */
OBC_API int32_t obc_mesh_orientation_from_origin(const double *p, const double *q, const double *r);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_mesh_version(void);

#ifdef __cplusplus
}
#endif

#endif
