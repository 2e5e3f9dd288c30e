/* Orbicube gltf: surfaces in glTF 2.0 files (Khronos, glTF 2.0 specification, 2021): GLB, and JSON with buffers embedded as base64 or,
 * for reading, in files of the same folder.
 *
 * Reading returns one triangle mesh in world coordinates, as doubles: all triangles, strips and fans of all meshes of the scene. Strided,
 * sparse and quantized accessors (KHR_mesh_quantization) are supported, EXT_meshopt_compression in builds with meshoptimizer; points and
 * lines are left out; Draco compression is refused. Materials, textures, texture coordinates, colors, nodes, skins, animations and extras are left out, or kept beside the
 * surface (option `keep`) for the file of another shape of it. Each index and each range is checked before use, no file outside the folder of the input is opened,
 * and memory is bounded by a multiple of the file size.
 *
 * Writing stores 32-bit floats bit for bit, with morph targets, texture coordinates, a checker texture, colors, normals and edges. A
 * file is complete or does not appear.
 *
 * Thread safety: all functions may be called at the same time; several threads may read one surface, one at a time may write with
 * what it keeps. All work is done on the calling
 * thread.
 *
 * Example: writes a tetrahedron to a GLB file and reads it.
 *
 *   #include <orbicube/gltf.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
 *     const uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
 *     obc_gltf_surface *surface = NULL;
 *     obc_error error;
 *     if (obc_gltf_write_surface("surface.glb", positions, 4, triangles, 4, NULL, &error) != OBC_OK) return puts(error.message), 1;
 *     if (obc_gltf_read("surface.glb", NULL, NULL, &surface, &error) != OBC_OK) return puts(error.message), 1;
 *     printf("%d triangles\n", (int)obc_gltf_surface_triangle_count(surface)); // 4
 *     obc_gltf_surface_destroy(surface);
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_GLTF_H
#define ORBICUBE_GLTF_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- reading --------------------------------------------------------------------------------------------------------- */

/* A surface read from a file. */
typedef struct obc_gltf_surface obc_gltf_surface;

/* Options of reading. Fill with _init. */
typedef struct obc_gltf_read_options {
  uint32_t struct_size;

  /* 1: welds vertices at identical positions where triangles have no indices or the surface is not closed as stored (exporters split
   * vertices along seams of normals and texture coordinates); 0: preserves the vertices and their order. Default: 1. */
  int32_t weld_identical;

  /* Name of a morph target to apply with weight 1 (base + delta, added as doubles); NULL: none. Default: NULL. */
  const char *morph_target;

  /* 1: keeps what the file has besides the surface in the handle, for obc_gltf_scene.kept and obc_gltf_write_kept; 0: leaves it out, with a note
   * that counts it. Default: 0. */
  int32_t keep;
  int32_t reserved;
} obc_gltf_read_options;

/* Fills options with the defaults. */
OBC_API obc_status obc_gltf_read_options_init(obc_gltf_read_options *options, size_t struct_size);

/* Reads the file at `path` (bytes in the encoding of the system). options and host may be NULL; the allocator of the host must remain valid
 * until _surface_destroy. O(n). Errors: io; malformed file (the kind says how: truncated, parse, index-range, accessor-range,
 * unsafe-path, ...); unsupported; degenerate (a transform or welding flattens everything); out of memory; cancelled. */
OBC_API obc_status obc_gltf_read(const char *path, const obc_gltf_read_options *options, const obc_host *host,
                                 obc_gltf_surface **out, obc_error *error);

/* Reads a GLB or JSON file from `size` bytes in memory, which are not kept. `folder` contains buffers in separate files; NULL refuses
 * them. Otherwise as obc_gltf_read. */
OBC_API obc_status obc_gltf_read_memory(const void *bytes, size_t size, const char *folder,
                                        const obc_gltf_read_options *options, const obc_host *host,
                                        obc_gltf_surface **out, obc_error *error);

/* Return the numbers of vertices, triangles, welded vertices, and notes on changed or omitted contents of a surface; 0 for NULL. */
OBC_API size_t obc_gltf_surface_vertex_count(const obc_gltf_surface *surface);
OBC_API size_t obc_gltf_surface_triangle_count(const obc_gltf_surface *surface);
OBC_API size_t obc_gltf_surface_welded_vertex_count(const obc_gltf_surface *surface);
OBC_API size_t obc_gltf_surface_note_count(const obc_gltf_surface *surface);

/* Returns the index-th note, UTF-8, valid until the surface is destroyed; NULL from the number of notes on. */
OBC_API const char *obc_gltf_surface_note(const obc_gltf_surface *surface, size_t index);

/* Returns 1 if the handle keeps what the file has besides the surface, 0 otherwise: without the option `keep`, for NULL, and where the file does
 * not allow it; a note gives the reason then. */
OBC_API int32_t obc_gltf_surface_keeps(const obc_gltf_surface *surface);

/* Copies positions (3 * vertex_count, or NULL) and triangles (3 * triangle_count indices, or NULL; counter-clockwise seen from outside)
 * to arrays of the caller. Errors: invalid argument. */
OBC_API obc_status obc_gltf_surface_copy(const obc_gltf_surface *surface, double *positions, uint32_t *triangles,
                                         obc_error *error);

/* Destroys a surface; NULL is allowed. */
OBC_API void obc_gltf_surface_destroy(obc_gltf_surface *surface);

/* ---- writing --------------------------------------------------------------------------------------------------------- */

/* Another shape of the same surface, for obc_gltf_scene. */
typedef struct obc_gltf_morph_target {
  const char *name;       /* name, UTF-8; stored in mesh.extras.targetNames, where engines find it */
  const float *positions; /* positions of the vertices, 3 * vertex_count; stored as deltas, see obc_gltf_delta */
} obc_gltf_morph_target;

/* Contents of a file. Arrays are not kept after the call. Fill with _init. */
typedef struct obc_gltf_scene {
  uint32_t struct_size;
  int32_t smooth_normals; /* 1: computes area-weighted normals if `normals` is NULL; 0: does not. Default: 0. */

  const float *positions;    /* 3 * vertex_count, stored bit for bit. Default: NULL. */
  size_t vertex_count;       /* number of vertices. Default: 0. */
  const uint32_t *triangles; /* 3 * triangle_count vertices. Default: NULL. */
  size_t triangle_count;     /* number of triangles. Default: 0. */

  const float *normals;             /* 3 * vertex_count, unit vectors; NULL: none. Default: NULL. */
  const float *texture_coordinates; /* 2 * vertex_count, v pointing down; NULL: none. Default: NULL. */
  const uint8_t *colors;            /* 4 * vertex_count, linear red, green, blue, opacity; NULL: none. Default: NULL. */

  const obc_gltf_morph_target *morph_targets; /* morph targets; NULL: none. Default: NULL. */
  size_t morph_target_count;                  /* number of morph targets. Default: 0. */

  const uint32_t *edges; /* 2 * edge_count vertices, drawn as dark lines; NULL: none. Default: NULL. */
  size_t edge_count;     /* number of edges. Default: 0. */

  double translation[3]; /* translation of the node: world = translation + scale * position. Default: 0. */
  double scale;          /* scale of the node, positive. Default: 1. */
  double base_color[4];  /* color of the material, linear, 0 to 1. Default: 0.8 gray, opaque. */

  const void *texture;     /* contents of a PNG file, requires texture_coordinates; NULL: none. Default: NULL. */
  size_t texture_size;     /* number of bytes of the PNG file. Default: 0. */
  int32_t checker_texture; /* 1: a checker pattern of 32 by 16 squares if `texture` is NULL; 0: none. Default: 0. */
  int32_t morph_normals;   /* 1: stores normals of morph targets, requires normals; 0: does not. Default: 0. */

  const char *name;   /* name of node and mesh, UTF-8; NULL: "surface". Default: "surface". */
  const char *extras; /* JSON object for the extras of the scene; NULL: none. Default: NULL. */

  /* Duration, in seconds, from one shape to the next of an animation from the surface to each morph target in turn and back; 0: no
   * animation. Default: 0. */
  double morph_seconds;

  /* Surface that keeps the rest of its file (obc_gltf_surface_keeps), with which the scene is written: materials, textures, texture
   * coordinates, colors, nodes, skins, animations, extras. It is not changed and must remain valid during the call. The scene has no
   * normals, colors, edges or extras of its own then, and its texture and base_color apply to parts without a material. Without
   * kept_positions, the triangles are those of the surface in their order, and the positions at least its vertices. NULL: none.
   * Default: NULL. */
  const obc_gltf_surface *kept;

  /* For other triangles than those of `kept`: the place of each vertex on the surface that was read, 3 * vertex_count, of which the nearest
   * point of the surface counts. Each triangle takes its material from the place of its centroid. NULL: the triangles of `kept`.
   * Default: NULL. */
  const double *kept_positions;
} obc_gltf_scene;

/* Fills a scene with the defaults and an empty surface. */
OBC_API obc_status obc_gltf_scene_init(obc_gltf_scene *scene, size_t struct_size);

/* Writes to `path`: JSON with an embedded buffer for the ending "gltf", otherwise GLB. The file appears when it is complete; after an error the
 * previous file remains. host may be NULL. O(n). Errors: invalid argument (sizes, indices, numbers that are not finite, texts),
 * unsupported (4 GiB or more), io, out of memory, cancelled. */
OBC_API obc_status obc_gltf_write(const char *path, const obc_gltf_scene *scene, const obc_host *host, obc_error *error);

/* Writes the file of a surface that keeps it again, with all that it has; buffers and images of separate files come into this one. Otherwise as
 * obc_gltf_write. Errors: also invalid argument (the surface keeps nothing). */
OBC_API obc_status obc_gltf_write_kept(const char *path, const obc_gltf_surface *surface, const obc_host *host,
                                       obc_error *error);

/* Writes a surface alone, with smooth normals: positions 3 * vertex_count, triangles 3 * triangle_count. Otherwise as obc_gltf_write. */
OBC_API obc_status obc_gltf_write_surface(const char *path, const float *positions, size_t vertex_count,
                                          const uint32_t *triangles, size_t triangle_count, const obc_host *host,
                                          obc_error *error);

/* Compute exact morph targets of finite numbers. _delta returns the stored delta for a base and a target coordinate; _reconstructed returns
 * base + delta in float32, as a renderer adds them, which equals the target whenever some delta reaches it. */
OBC_API float obc_gltf_delta(float base, float target);
OBC_API float obc_gltf_reconstructed(float base, float delta);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_gltf_version(void);

#ifdef __cplusplus
}
#endif

#endif
