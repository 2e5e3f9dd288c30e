/* Maps an ellipsoid with a bump to the unit sphere and prints how good the map is. */
#include <math.h>
#include <orbicube/sphere_map.h>
#include <stdio.h>
#include <stdlib.h>

enum { around = 64, rows = 31, vertex_count = around * rows + 2, triangle_count = 2 * around * rows };

static double positions[3 * vertex_count];
static uint32_t triangles[3 * triangle_count];
static double directions[3 * vertex_count];

static void set_position(uint32_t vertex, double x, double y, double z) {
  const double bump = 1 + exp(-8 * ((x - 1) * (x - 1) + y * y + z * z));
  positions[3 * vertex] = x * bump;
  positions[3 * vertex + 1] = 1.5 * y * bump;
  positions[3 * vertex + 2] = 2.5 * z * bump;
}

static uint32_t* add(uint32_t* to, uint32_t a, uint32_t b, uint32_t c) {
  to[0] = a;
  to[1] = b;
  to[2] = c;
  return to + 3;
}

/* Rows of latitude between two poles. */
static void make_surface(void) {
  const double pi = 3.14159265358979323846;
  const uint32_t south = around * rows;
  const uint32_t north = south + 1;
  uint32_t* next = triangles;
  uint32_t i, j;
  for (i = 0; i < rows; ++i) {
    for (j = 0; j < around; ++j) {
      const double latitude = pi * ((i + 1.0) / (rows + 1) - 0.5);
      const double longitude = 2 * pi * j / around;
      set_position(i * around + j, cos(latitude) * cos(longitude), cos(latitude) * sin(longitude), sin(latitude));
    }
  }
  set_position(south, 0, 0, -1);
  set_position(north, 0, 0, 1);
  for (j = 0; j < around; ++j) {
    const uint32_t k = (j + 1) % around;
    next = add(next, south, k, j);
    for (i = 0; i + 1 < rows; ++i) {
      const uint32_t row = i * around;
      next = add(next, row + j, row + k, row + around + k);
      next = add(next, row + j, row + around + k, row + around + j);
    }
    next = add(next, north, (rows - 1) * around + j, (rows - 1) * around + k);
  }
}

int main(void) {
  obc_surface surface = {positions, vertex_count, triangles, triangle_count};
  obc_sphere_map_report report;
  obc_error error;

  make_surface();
  obc_sphere_map_report_init(&report, sizeof report);
  if (obc_sphere_map_compute(&surface, NULL, NULL, directions, &report, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  printf("bijective: %s\n", report.bijective ? "yes" : "no");
  printf("angle energy %.2f (at least 50.27), area energy %.2f (at least 12.57)\n", report.energy_angle,
         report.energy_area);
  printf("largest quasi-conformal distortion %.2f, mean %.3f\n", report.max_quasi_conformal,
         report.mean_quasi_conformal);
  return report.bijective && report.energy < 20 ? EXIT_SUCCESS : EXIT_FAILURE;
}
