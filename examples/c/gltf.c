/* An ellipsoid with the unit sphere as a morph target, a texture coordinate and a checker texture: written as GLB,
 * which engines and viewers load as it is, and read again once as it stands and once as the sphere. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <orbicube/gltf.h>

enum { ROWS = 24, COLUMNS = 48, VERTICES = (ROWS + 1) * COLUMNS, TRIANGLES = 2 * ROWS * COLUMNS };

static float ellipsoid[3 * VERTICES], sphere[3 * VERTICES], texture[2 * VERTICES];
static uint32_t triangles[3 * TRIANGLES];

/* A grid with a column of vertices at each pole and a seam that is not split. */
static void make_grid(void) {
  const double pi = 3.14159265358979323846;
  uint32_t i, j, *t = triangles;
  for (i = 0; i <= ROWS; ++i) {
    for (j = 0; j < COLUMNS; ++j) {
      const double polar = pi * (i + 0.001) / (ROWS + 0.002), around = 2 * pi * j / COLUMNS;
      const uint32_t v = i * COLUMNS + j, right = i * COLUMNS + (j + 1) % COLUMNS;
      sphere[3 * v] = (float)(sin(polar) * cos(around));
      sphere[3 * v + 1] = (float)(sin(polar) * sin(around));
      sphere[3 * v + 2] = (float)cos(polar);
      ellipsoid[3 * v] = 3 * sphere[3 * v];
      ellipsoid[3 * v + 1] = 2 * sphere[3 * v + 1];
      ellipsoid[3 * v + 2] = sphere[3 * v + 2];
      texture[2 * v] = (float)j / COLUMNS;
      texture[2 * v + 1] = (float)i / ROWS;
      if (i == ROWS) continue;
      *t++ = v, *t++ = v + COLUMNS, *t++ = right;
      *t++ = right, *t++ = v + COLUMNS, *t++ = right + COLUMNS;
    }
  }
}

/* Largest distance of a vertex of the file's surface, or of its morph target, from the unit sphere; -1 on failure. */
static double distance_from_sphere(const char* path, const char* morph_target) {
  obc_gltf_read_options options;
  obc_gltf_surface* surface = NULL;
  obc_error error;
  double *positions, largest = -1;
  size_t count, v;
  obc_gltf_read_options_init(&options, sizeof options);
  options.morph_target = morph_target;
  if (obc_gltf_read(path, &options, NULL, &surface, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return -1;
  }
  count = obc_gltf_surface_vertex_count(surface);
  positions = malloc(3 * count * sizeof *positions);
  if (positions != NULL && obc_gltf_surface_copy(surface, positions, NULL, &error) == OBC_OK) {
    for (v = 0, largest = 0; v < count; ++v) {
      const double *p = positions + 3 * v, d = fabs(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) - 1);
      if (d > largest) largest = d;
    }
    printf("%s: %d vertices, %d triangles, at most %.7f from the unit sphere\n",
           morph_target != NULL ? morph_target : "surface", (int)count, (int)obc_gltf_surface_triangle_count(surface),
           largest);
  }
  free(positions);
  obc_gltf_surface_destroy(surface);
  return largest;
}

int main(int count, char** arguments) {
  const char* path = count > 1 ? arguments[1] : "ellipsoid.glb";
  obc_gltf_morph_target target;
  obc_gltf_scene scene;
  obc_error error;
  double surface, morphed;

  make_grid();
  target.name = "sphere";
  target.positions = sphere;
  obc_gltf_scene_init(&scene, sizeof scene);
  scene.positions = ellipsoid;
  scene.vertex_count = VERTICES;
  scene.triangles = triangles;
  scene.triangle_count = TRIANGLES;
  scene.smooth_normals = 1;
  scene.texture_coordinates = texture;
  scene.checker_texture = 1;
  scene.morph_targets = &target;
  scene.morph_target_count = 1;
  scene.name = "ellipsoid";
  if (obc_gltf_write(path, &scene, NULL, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  printf("wrote %s\n", path);

  surface = distance_from_sphere(path, NULL);
  morphed = distance_from_sphere(path, "sphere");
  /* The morph target is the sphere but for the rounding of float32. */
  return surface > 1.9 && morphed >= 0 && morphed < 1e-6 ? 0 : 1;
}
