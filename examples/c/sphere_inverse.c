/* Maps a shape to the unit sphere, then goes the other way: for directions on a regular grid it finds the triangles of
 * the map and samples the shape there. */
#include <math.h>
#include <orbicube/sphere_map.h>
#include <stdio.h>
#include <stdlib.h>

enum { rows = 90, columns = 180, count = rows * columns };

static double directions[3 * count];
static uint32_t triangles[count];
static double weights[3 * count];
static double sampled[3 * count];

static int failed(const char* what, const obc_error* error) {
  fprintf(stderr, "%s: %s: %s\n", what, error->kind, error->message);
  return EXIT_FAILURE;
}

int main(void) {
  const double pi = 3.14159265358979323846;
  obc_mesh* mesh = NULL;
  obc_surface surface;
  double* map;
  obc_sphere_map_locator* locator = NULL;
  obc_error error;
  double farthest = 0;
  double wrong = 0;
  size_t i, k;

  if (obc_mesh_make("creature", 5000, 0, NULL, &mesh, &error) != OBC_OK ||
      obc_mesh_surface(mesh, &surface, &error) != OBC_OK)
    return failed("make", &error);
  map = malloc(3 * surface.vertex_count * sizeof *map);
  if (map == NULL || obc_sphere_map_compute(&surface, NULL, NULL, map, NULL, &error) != OBC_OK)
    return failed("map", &error);
  if (obc_sphere_map_locator_create(&surface, map, NULL, &locator, &error) != OBC_OK) return failed("locator", &error);

  for (i = 0; i < count; ++i) {
    const double latitude = pi * ((double)(i / columns) + 0.5) / rows;
    const double longitude = 2 * pi * (double)(i % columns) / columns;
    directions[3 * i] = sin(latitude) * cos(longitude);
    directions[3 * i + 1] = sin(latitude) * sin(longitude);
    directions[3 * i + 2] = cos(latitude);
  }
  if (obc_sphere_map_locate(locator, directions, count, NULL, triangles, weights, &error) != OBC_OK)
    return failed("locate", &error);
  if (obc_sphere_map_sample(locator, directions, count, surface.positions, 3, 0, NULL, sampled, &error) != OBC_OK)
    return failed("sample", &error);

  for (i = 0; i < count; ++i) {
    const uint32_t* corner = surface.triangles + 3 * triangles[i];
    double radius = 0;
    for (k = 0; k < 3; ++k) {
      /* What the sample is, by the triangle and the weights. */
      const double x = weights[3 * i] * surface.positions[3 * corner[0] + k] +
                       weights[3 * i + 1] * surface.positions[3 * corner[1] + k] +
                       weights[3 * i + 2] * surface.positions[3 * corner[2] + k];
      wrong = fmax(wrong, fabs(x - sampled[3 * i + k]));
      radius += sampled[3 * i + k] * sampled[3 * i + k];
    }
    farthest = fmax(farthest, sqrt(radius));
  }
  printf("%d directions, sampled on %lu triangles\n", count, (unsigned long)surface.triangle_count);
  printf("the farthest point is %.3f from the origin; samples and weights agree to %.1g\n", farthest, wrong);
  obc_sphere_map_locator_destroy(locator);
  obc_mesh_destroy(mesh);
  free(map);
  return wrong < 1e-12 && farthest > 0.5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
