/* Orbicube tetrahedra: tetrahedral meshes of closed surfaces by TetGen (Si 2015, "TetGen, a Delaunay-based quality tetrahedral mesh
 * generator", ACM Transactions on Mathematical Software 41(2)).
 *
 * License. TetGen is under the GNU Affero General Public License 3, which covers programs that link this library. No other
 * Orbicube library links it.
 *
 * Child process. obc_tetrahedra_fill forks: TetGen runs in a child process, a copy of the calling one, which returns the mesh
 * through a pipe. TetGen cannot be interrupted, keeps global state, prints, and crashes on some errors; the child keeps all of that
 * away from the caller, and cancellation kills it. The child has its standard files redirected to nothing, no other open file and no signal handlers,
 * leaves no core file and, on Linux, ends with its parent. It runs no code of the caller except the handlers of
 * pthread_atfork, and skips those of atexit. The call waits for the child itself; a host that waits for any child
 * (waitpid(-1)) may take it without harm. Where no child process can be started (some sandboxes) the call returns OBC_UNSUPPORTED.
 *
 * Arrays: as in <orbicube/mesh.h>. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time; several threads may read one handle. Results are the same bits in
 * every run.
 *
 * Example: fills a generated sphere and counts the tetrahedra.
 *
 *   #include <orbicube/tetrahedra.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_mesh *mesh = NULL;
 *     obc_surface surface;
 *     obc_tetrahedra *solid = NULL;
 *     obc_error error;
 *     if (obc_mesh_make("sphere", 1000, 0, NULL, &mesh, &error) != OBC_OK) return 1;
 *     if (obc_mesh_surface(mesh, &surface, &error) != OBC_OK) return 1;
 *     if (obc_tetrahedra_fill(&surface, NULL, NULL, &solid, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%zu tetrahedra\n", obc_tetrahedra_count(solid));
 *     obc_tetrahedra_destroy(solid);
 *     obc_mesh_destroy(mesh);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_TETRAHEDRA_H
#define ORBICUBE_TETRAHEDRA_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A tetrahedral mesh. */
typedef struct obc_tetrahedra obc_tetrahedra;

/* Quality and size of tetrahedra. TetGen inserts vertices until the bounds are satisfied, except where the surface prevents it; its last
 * step, flips and moves for better angles, may exceed the bounds slightly at a few tetrahedra. Fill with _init. */
typedef struct obc_tetrahedra_options {
  uint32_t struct_size;

  int32_t keep_surface; /* 1: every triangle is preserved; 0: TetGen may split edges and triangles, and, if no size
                         * is given, inserts at most 50,000 vertices and 20 for each vertex of the surface. Default: 1. */
  double quality;       /* maximum ratio of circumradius to shortest edge, at least 1; 0: no vertices are inserted for quality. Default: 1.4. */
  double max_volume;    /* maximum volume, in the cubed unit of the surface; 0: no limit. Default: 0. */
  double edge_length;   /* approximate length of inner edges, in the unit of the surface; 0: that of the surface. Default: 0. */

  /* Edge lengths at points, such as the vertices of the surface: the positive length size_lengths[i] at the point x y z in
   * size_positions. The length elsewhere is the minimum over all points of length + size_growth * distance. The surface is not
   * split for a size, even where it may be: beside it tetrahedra are as large as its triangles. obc_tetrahedra_fill reads the arrays
   * and does not keep them; NULL is allowed for size_count 0. Default: NULL. */
  const double *size_positions;
  const double *size_lengths;
  size_t size_count;  /* number of points. Default: 0. */
  double size_growth; /* gradation: edge-length growth per unit distance, at least 0. Default: 0.3. */
} obc_tetrahedra_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_tetrahedra_options_init(obc_tetrahedra_options *options, size_t struct_size);

/* Fills a closed surface with tetrahedra. Its components may lie beside or within each other: points inside an odd number of them are
 * solid, so that a component within a component bounds a cavity. The orientation of triangles has no effect. Vertices in no triangle remain
 * without tetrahedra. Coordinates of any size and distance from the origin are allowed. options and host may be NULL; the
 * allocator of the host must remain valid until _destroy. Takes about 10 us and 1 KB a tetrahedron; the checks are O(n log n).
 * Errors, found by exact arithmetic before TetGen runs: invalid argument; not closed; not manifold (kinds non-manifold-edge,
 * non-manifold-vertex, duplicate-face, non-orientable, and self-intersection with the number of pairs and the first);
 * degenerate (kinds degenerate-face, degenerate-geometry); malformed file (kind empty-mesh: no triangles). Others: no valid
 * result (TetGen failed, with its reason, or its mesh failed the checks), unsupported, out of memory, cancelled. */
OBC_API obc_status obc_tetrahedra_fill(const obc_surface *surface, const obc_tetrahedra_options *options,
                                       const obc_host *host, obc_tetrahedra **out, obc_error *error);

/* Fills a closed surface as obc_tetrahedra_fill does with the options max_volume and else the defaults, into a mesh of <orbicube/mesh.h>: the
 * function for options.fill of <orbicube/hexmesh.h>. user is unused and may be NULL; host may be NULL, its allocator must remain valid until
 * obc_mesh_destroy. Errors: as obc_tetrahedra_fill. */
OBC_API obc_status obc_tetrahedra_fill_mesh(const obc_surface *surface, double max_volume, const obc_host *host,
                                            obc_mesh **out, obc_error *error, void *user);

/* Destroys a mesh; NULL is allowed. */
OBC_API void obc_tetrahedra_destroy(obc_tetrahedra *solid);

/* Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
 * it was preserved), parts (components that share no face) and cavities; 0 for NULL. */
OBC_API size_t obc_tetrahedra_vertex_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_boundary_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_part_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_cavity_count(const obc_tetrahedra *solid);

/* Copies a mesh to arrays of the caller, each of which may be NULL: positions (x y z a vertex, bit-identical vertices of the surface
 * first, in their order), tetrahedra (four vertices each, of positive volume by exact arithmetic), boundary (three vertices a
 * triangle, outward-oriented; triangle i is triangle i of the surface, possibly reversed, if it was preserved) and
 * boundary_source (for each boundary triangle the surface triangle that contains it). Errors: invalid argument. */
OBC_API obc_status obc_tetrahedra_copy(const obc_tetrahedra *solid, double *positions, uint32_t *tetrahedra,
                                       uint32_t *boundary, uint32_t *boundary_source, obc_error *error);

/* Checks whether a surface can be filled, as obc_tetrahedra_fill does first. Writes the first `capacity` pairs of intersecting triangles to
 * pairs, two entries each, the lower triangle first, in ascending order; *count is the number of all pairs, possibly more than
 * capacity. pairs may be NULL for capacity 0, host may be NULL. Uses the threads of the host. O(n log n + pairs of overlapping
 * boxes). Returns OBC_OK or the errors of obc_tetrahedra_fill about the surface; pairs and count are also valid for the kind
 * self-intersection, and count is 0 for all others. */
OBC_API obc_status obc_tetrahedra_check_surface(const obc_surface *surface, const obc_host *host, uint32_t *pairs,
                                                size_t capacity, size_t *count, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_tetrahedra_version(void);

#ifdef __cplusplus
}
#endif

#endif
