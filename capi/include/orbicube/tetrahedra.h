/* Orbicube tetrahedra: closed surfaces filled with tetrahedra by TetGen (Si 2015, "TetGen, a Delaunay-based quality
 * tetrahedral mesh generator", ACM Transactions on Mathematical Software 41(2)).
 *
 * Licence. TetGen is under the GNU Affero General Public License 3, which binds programs that link this library. No other
 * Orbicube library links it.
 *
 * Child process. obc_tetrahedra_fill forks: TetGen works in a child process, a copy of the calling one, and the mesh comes
 * back through a pipe. TetGen cannot be stopped, keeps its state in globals, prints, and crashes where it means to report an
 * error; in a child all of that stays away from the caller, and cancelling ends it at once. The child has standard files
 * that lead nowhere, no other open file, no signal handlers, leaves no core file and, on Linux, ends when its parent does.
 * It runs none of the caller's code but the handlers of pthread_atfork, and ends without those of atexit. The call waits for
 * the child itself; a host that also waits for children of any kind (waitpid(-1)) may take that from it without harm. Where
 * no child may be started (some sandboxes) the call ends in OBC_UNSUPPORTED.
 *
 * Arrays: as in <orbicube/mesh.h>. Inputs are not kept after a call.
 *
 * Thread safety: all functions may be called at the same time; handles may be read by several threads. Results are the same
 * bits in every run.
 */
#ifndef ORBICUBE_TETRAHEDRA_H
#define ORBICUBE_TETRAHEDRA_H

#include <orbicube/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A solid made of tetrahedra. */
typedef struct obc_tetrahedra obc_tetrahedra;

/* What tetrahedra should be like. TetGen adds vertices inside until they are, but where the surface stands in the way; its last
 * step, flips and moves for better angles, may overstep the bounds again by a little, in few places. Fill with _init. */
typedef struct obc_tetrahedra_options {
  uint32_t struct_size;
  int32_t keep_surface; /* 1: every triangle stays as it is; 0: TetGen may cut edges and triangles. Default 1 */
  double quality;       /* largest ratio of circumradius to shortest edge, at least 1; 0: no vertices for quality. Default 1.4 */
  double max_volume;    /* largest volume, in the units of the surface; 0: none. Default 0 */
  double edge_length;   /* edges inside about this long, in the units of the surface; 0: as the surface has it. Default 0 */
  /* Lengths like edge_length at some places only, as at the surface's vertices: size_lengths[i], positive, at x y z in
   * size_positions. From each place edges may get longer by size_growth in each unit of distance, and the shortest of all
   * lengths that apply counts. size_growth is at least 0, default 0.3; the arrays are read by obc_tetrahedra_fill and not kept,
   * and may be NULL when size_count is 0, the default. The surface is not cut for a size, also where it may be: beside it
   * tetrahedra are as large as its triangles make them. */
  const double *size_positions;
  const double *size_lengths;
  size_t size_count;
  double size_growth;
} obc_tetrahedra_options;

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_tetrahedra_options_init(obc_tetrahedra_options *options, size_t struct_size);

/* Fills a surface. Its components may lie beside or within each other: what an odd number of them surrounds is solid, what an
 * even number does is not, so a shell within a shell is a cavity. It does not matter which way triangles look. Vertices in no
 * triangle stay, in no tetrahedron. Coordinates of any size and at any distance from the origin are fine.
 * options and host may be NULL; the host's allocator must stay valid until _destroy.
 * Time and memory are TetGen's, about 10 us and 1 KB a tetrahedron; the checks are O(n log n).
 * Errors: invalid argument; not closed, not manifold (kinds non-manifold-edge, non-manifold-vertex, duplicate-face,
 * non-orientable, and self-intersection with the number of pairs of faces and the first), degenerate (kinds degenerate-face,
 * degenerate-geometry), malformed file (kind empty-mesh: no triangles), each found by exact arithmetic before TetGen runs; no
 * valid result (TetGen failed, the message says how, or what it made did not stand the checks), unsupported, out of memory,
 * cancelled. */
OBC_API obc_status obc_tetrahedra_fill(const obc_surface *surface, const obc_tetrahedra_options *options,
                                       const obc_host *host, obc_tetrahedra **out, obc_error *error);

/* Releases a solid; NULL is fine. */
OBC_API void obc_tetrahedra_destroy(obc_tetrahedra *solid);

/* Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
 * when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within. */
OBC_API size_t obc_tetrahedra_vertex_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_boundary_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_part_count(const obc_tetrahedra *solid);
OBC_API size_t obc_tetrahedra_cavity_count(const obc_tetrahedra *solid);

/* Copies to the caller's arrays, each of which may be NULL: positions (x y z a vertex; the surface's vertices come first, to
 * the bit and in its order), tetrahedra (four vertices each, of positive volume by exact arithmetic), boundary (three
 * vertices a triangle, looking outward; triangle i is the surface's triangle i, perhaps turned round, when it was kept) and
 * boundary_source (for each boundary triangle the surface's triangle that it lies in). Errors: invalid argument. */
OBC_API obc_status obc_tetrahedra_copy(const obc_tetrahedra *solid, double *positions, uint32_t *tetrahedra,
                                       uint32_t *boundary, uint32_t *boundary_source, obc_error *error);

/* Whether a surface can be filled, as obc_tetrahedra_fill asks it first. The first `capacity` pairs of triangles that meet where
 * they should not are written to pairs, two entries each, the lower triangle first, in ascending order; *count is how many there
 * are, which may be more. pairs may be NULL when capacity is 0. Runs on the host's threads; host may be NULL.
 * OBC_OK, or the errors of obc_tetrahedra_fill about the surface; pairs and count are also valid with the kind
 * self-intersection, and count is 0 with all others. O(n log n + pairs whose boxes overlap). */
OBC_API obc_status obc_tetrahedra_check_surface(const obc_surface *surface, const obc_host *host, uint32_t *pairs,
                                                size_t capacity, size_t *count, obc_error *error);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_tetrahedra_version(void);

#ifdef __cplusplus
}
#endif

#endif
