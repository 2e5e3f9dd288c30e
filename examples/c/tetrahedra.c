/* Fills a box with a box-shaped cavity with tetrahedra, adds up their volumes, and shows how a surface that meets
 * itself is refused. */
#include <math.h>
#include <orbicube/tetrahedra.h>
#include <stdio.h>
#include <stdlib.h>

static double positions[3 * 16];
static uint32_t triangles[3 * 24];

/* The cube of that half size around (x, 0, 0) as the box of that number. */
static void set_box(uint32_t box, double half_size, double x) {
  static const uint32_t corners[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                       2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  uint32_t i;
  for (i = 0; i < 8; ++i) {
    positions[24 * box + 3 * i] = x + (i & 1 ? half_size : -half_size);
    positions[24 * box + 3 * i + 1] = i & 2 ? half_size : -half_size;
    positions[24 * box + 3 * i + 2] = i & 4 ? half_size : -half_size;
  }
  for (i = 0; i < 36; ++i)
    triangles[36 * box + i] = 8 * box + corners[i];
}

static double volume_of(const double* x, const uint32_t* t) {
  const double *a = x + 3 * t[0], *b = x + 3 * t[1], *c = x + 3 * t[2], *d = x + 3 * t[3];
  double u[3], v[3], w[3];
  int i;
  for (i = 0; i < 3; ++i) {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
    w[i] = d[i] - a[i];
  }
  return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
          u[2] * (v[0] * w[1] - v[1] * w[0])) /
         6;
}

int main(void) {
  const obc_surface surface = {positions, 16, triangles, 24};
  obc_tetrahedra_options options;
  obc_tetrahedra* solid;
  obc_error error;
  double *x, volume = 0;
  uint32_t *t, pair[2];
  size_t count, i;

  set_box(0, 1, 0);
  set_box(1, 0.5, 0);
  obc_tetrahedra_options_init(&options, sizeof options);
  options.max_volume = 0.01;
  if (obc_tetrahedra_fill(&surface, &options, NULL, &solid, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  count = obc_tetrahedra_count(solid);
  x = malloc(3 * sizeof *x * obc_tetrahedra_vertex_count(solid));
  t = malloc(4 * sizeof *t * count);
  if (x == NULL || t == NULL) return EXIT_FAILURE;
  obc_tetrahedra_copy(solid, x, t, NULL, NULL, &error);
  for (i = 0; i < count; ++i)
    volume += volume_of(x, t + 4 * i);
  printf("%lu tetrahedra, %lu cavity, volume %.6f\n", (unsigned long)count,
         (unsigned long)obc_tetrahedra_cavity_count(solid), volume);
  obc_tetrahedra_destroy(solid);
  free(x);
  free(t);

  set_box(1, 0.5, 0.75); /* through a wall of the other */
  if (obc_tetrahedra_check_surface(&surface, NULL, pair, 1, &count, &error) == OBC_OK || count == 0)
    return EXIT_FAILURE;
  printf("%s: %lu pairs, the first of faces %lu and %lu\n", error.kind, (unsigned long)count, (unsigned long)pair[0],
         (unsigned long)pair[1]);
  return fabs(volume - 7) < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
