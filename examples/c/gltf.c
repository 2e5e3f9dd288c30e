/* An ellipsoid with the unit sphere as a morph target, a texture coordinate and a checker texture: written as GLB,
 * which engines and viewers load as it is, and read again once as it stands and once as the sphere. */
#include <stdio.h>
#include <stdlib.h>

#include <orbicube/gltf.h>

/* Rings of vertices 7.5 degrees apart, and the two poles. */
enum { RINGS = 23, COLUMNS = 48, SOUTH = RINGS * COLUMNS, NORTH, VERTICES, TRIANGLES = 2 * RINGS * COLUMNS };

static float ellipsoid[3 * VERTICES], sphere[3 * VERTICES], texture[2 * VERTICES];
static uint32_t triangles[3 * TRIANGLES];

/* Turns a direction in the plane by 7.5 degrees. */
static void turn(double* x, double* y) {
  const double cosine = 0.99144486137381041, sine = 0.13052619222005159, old = *x;
  *x = cosine * old - sine * *y;
  *y = sine * old + cosine * *y;
}

static void set_vertex(uint32_t v, double x, double y, double z, double column, double ring) {
  sphere[3 * v] = (float)x;
  sphere[3 * v + 1] = (float)y;
  sphere[3 * v + 2] = (float)z;
  ellipsoid[3 * v] = (float)(3 * x);
  ellipsoid[3 * v + 1] = (float)(2 * y);
  ellipsoid[3 * v + 2] = (float)z;
  texture[2 * v] = (float)(column / COLUMNS);
  texture[2 * v + 1] = (float)(ring / (RINGS + 1));
}

static void make_shapes(void) {
  double height = 1, radius = 0; /* of a ring */
  uint32_t i, j, *t = triangles;
  for (i = 0; i < RINGS; ++i) {
    double x = 1, y = 0;
    turn(&height, &radius);
    for (j = 0; j < COLUMNS; ++j, turn(&x, &y)) {
      const uint32_t v = i * COLUMNS + j, right = i * COLUMNS + (j + 1) % COLUMNS, down = COLUMNS;
      set_vertex(v, radius * x, radius * y, height, j, i + 1);
      if (i == 0) *t++ = NORTH, *t++ = v, *t++ = right;
      if (i + 1 == RINGS) {
        *t++ = v, *t++ = SOUTH, *t++ = right;
        continue;
      }
      *t++ = v, *t++ = v + down, *t++ = right;
      *t++ = right, *t++ = v + down, *t++ = right + down;
    }
  }
  set_vertex(NORTH, 0, 0, 1, COLUMNS / 2, 0);
  set_vertex(SOUTH, 0, 0, -1, COLUMNS / 2, RINGS + 1);
}

/* Maximum distance of the squared lengths of the vertices from 1, in the file's surface or its morph target; -1 on
 * failure. */
static double difference_from_sphere(const char* path, const char* morph_target) {
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
      const double *p = positions + 3 * v, d = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1;
      if (d > largest || -d > largest) largest = d > 0 ? d : -d;
    }
    printf("%s: %d vertices, %d triangles, |x|^2 within %.7f of 1\n", morph_target != NULL ? morph_target : "surface",
           (int)count, (int)obc_gltf_surface_triangle_count(surface), largest);
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

  make_shapes();
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

  surface = difference_from_sphere(path, NULL);
  morphed = difference_from_sphere(path, "sphere");
  /* The morph target is the sphere but for the rounding of float32. */
  return surface > 7.9 && morphed >= 0 && morphed < 1e-6 ? 0 : 1;
}
