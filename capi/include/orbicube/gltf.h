/* Orbicube gltf: surfaces from glTF 2.0 files and to them (Khronos, glTF 2.0 specification, 2021): GLB, and .gltf with
 * buffers inside as base64 or, when reading, in files of the same folder.
 *
 * Reading gives one triangle mesh: all triangles, strips and fans of all meshes of the file's scene, in world
 * coordinates, as doubles. Strided, sparse and quantised accessors (KHR_mesh_quantization) are understood; points, lines,
 * materials and skins are left out; Draco and meshopt compression are refused. No file is trusted: each index and each range
 * is checked before it is used, nothing outside the file's own folder is opened, memory is bounded by a multiple of what the
 * file holds.
 *
 * Writing takes 32-bit floats, which it stores bit for bit, with what engines show besides: morph targets, texture
 * coordinate and checker texture, colours, normals, edges. Files are written whole or not at all.
 *
 * Thread safety: all functions may be called at the same time; a surface may be read by several threads. All work is done
 * on the calling thread.
 */
#ifndef ORBICUBE_GLTF_H
#define ORBICUBE_GLTF_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A surface that was read. */
typedef struct obc_gltf_surface obc_gltf_surface;

/* Fill with _init. */
typedef struct obc_gltf_read_options {
  uint32_t struct_size;
  int32_t weld_identical;   /* 1: joins vertices at identical positions where triangles have no indices, or where the
                               surface is not closed as it stands (exporters split vertices along seams of normals and
                               texture coordinates); 0: vertices and their order are those of the file. Default 1 */
  const char *morph_target; /* name of a morph target that is applied in full (base + delta, added as doubles), or NULL */
} obc_gltf_read_options;

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_gltf_read_options_init(obc_gltf_read_options *options, size_t struct_size);

/* Reads the file at `path` (bytes as the system takes them). options and host may be NULL; the host's allocator must stay
 * valid until _surface_destroy. Errors: io, malformed file (its kind says how: truncated, parse, index-range,
 * accessor-range, unsafe-path, ...), unsupported, degenerate (a transform or welding flattens everything), out of memory,
 * cancelled. O(n). */
OBC_API obc_status obc_gltf_read(const char *path, const obc_gltf_read_options *options, const obc_host *host,
                                 obc_gltf_surface **out, obc_error *error);

/* The same from `size` bytes of a GLB or .gltf file, which are not kept; `folder` is where buffers in files of their own
 * lie, NULL refuses them. */
OBC_API obc_status obc_gltf_read_memory(const void *bytes, size_t size, const char *folder,
                                        const obc_gltf_read_options *options, const obc_host *host,
                                        obc_gltf_surface **out, obc_error *error);

/* Numbers of a surface; 0 for NULL. Notes are what was changed or left out in reading. */
OBC_API size_t obc_gltf_surface_vertex_count(const obc_gltf_surface *surface);
OBC_API size_t obc_gltf_surface_triangle_count(const obc_gltf_surface *surface);
OBC_API size_t obc_gltf_surface_welded_vertex_count(const obc_gltf_surface *surface);
OBC_API size_t obc_gltf_surface_note_count(const obc_gltf_surface *surface);

/* The index-th note, UTF-8, of the surface's; NULL when there is none. */
OBC_API const char *obc_gltf_surface_note(const obc_gltf_surface *surface, size_t index);

/* Copies positions (3 * vertex_count, or NULL) and triangles (3 * triangle_count indices below vertex_count, or NULL;
 * counter-clockwise seen from outside) to the caller's arrays. Errors: invalid argument. */
OBC_API obc_status obc_gltf_surface_copy(const obc_gltf_surface *surface, double *positions, uint32_t *triangles,
                                         obc_error *error);

/* Releases a surface; NULL is fine. */
OBC_API void obc_gltf_surface_destroy(obc_gltf_surface *surface);

/* Another shape of the same surface, for obc_gltf_scene. */
typedef struct obc_gltf_morph_target {
  const char *name;       /* UTF-8; stored in mesh.extras.targetNames, where engines look for it */
  const float *positions; /* 3 * vertex_count: where the vertices are, not deltas; stored as obc_gltf_delta says */
} obc_gltf_morph_target;

/* What to write. Fill with _init, then set what there is; nothing is kept after the call. */
typedef struct obc_gltf_scene {
  uint32_t struct_size;
  int32_t smooth_normals;           /* 1: makes area-weighted normals when `normals` is NULL. Default 0 */
  const float *positions;           /* 3 * vertex_count; stored bit for bit */
  size_t vertex_count;
  const uint32_t *triangles;        /* 3 * triangle_count */
  size_t triangle_count;
  const float *normals;             /* 3 * vertex_count unit vectors, or NULL */
  const float *texture_coordinates; /* 2 * vertex_count, v going down, or NULL */
  const uint8_t *colors;            /* 4 * vertex_count: linear red, green, blue, opacity; or NULL */
  const obc_gltf_morph_target *morph_targets; /* or NULL */
  size_t morph_target_count;
  const uint32_t *edges;            /* 2 * edge_count vertices, drawn as dark lines; or NULL */
  size_t edge_count;
  double translation[3];            /* of the node: world = translation + scale * position. Default 0 */
  double scale;                     /* positive. Default 1 */
  double base_color[4];             /* of the material: linear, 0 to 1. Default 0.8 grey, opaque */
  const void *texture;              /* bytes of a PNG file, or NULL; needs texture_coordinates */
  size_t texture_size;
  int32_t checker_texture;          /* 1: a checker pattern of 32 by 16 squares when `texture` is NULL. Default 0 */
  int32_t morph_normals;            /* 1: morph targets have normals as well; needs normals. Default 0 */
  const char *name;                 /* UTF-8, of node and mesh. Default "surface" */
  const char *extras;               /* a JSON object that the scene carries, or NULL */
  double morph_seconds;             /* above 0: an animation from the surface to each morph target in turn and back to it,
                                       so many seconds from one to the next. Default 0: none */
} obc_gltf_scene;

/* The defaults, which the members' comments give, and an empty surface. */
OBC_API obc_status obc_gltf_scene_init(obc_gltf_scene *scene, size_t struct_size);

/* Writes to `path`: .gltf with the buffer inside when it ends so, GLB otherwise. The file appears once it is whole; after
 * an error the old one is still there. host may be NULL. Errors: invalid argument (sizes, indices, numbers that are not
 * finite, texts), unsupported (4 GiB or more), io, out of memory, cancelled. O(n). */
OBC_API obc_status obc_gltf_write(const char *path, const obc_gltf_scene *scene, const obc_host *host, obc_error *error);

/* A surface alone, with smooth normals: positions 3 * vertex_count, triangles 3 * triangle_count. */
OBC_API obc_status obc_gltf_write_surface(const char *path, const float *positions, size_t vertex_count,
                                          const uint32_t *triangles, size_t triangle_count, const obc_host *host,
                                          obc_error *error);

/* Morph targets to the bit. _delta is what is stored for a base and a wanted coordinate; _reconstructed is what a renderer
 * makes of base and delta in float32, and is the wanted one whenever any delta gives it. Finite numbers. */
OBC_API float obc_gltf_delta(float base, float wanted);
OBC_API float obc_gltf_reconstructed(float base, float delta);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_gltf_version(void);

#ifdef __cplusplus
}
#endif

#endif
