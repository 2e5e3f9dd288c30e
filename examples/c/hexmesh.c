/* A closed surface in arrays is filled with hexahedra, which are copied into arrays and checked: each positive, all
 * meeting in whole faces, enclosing what the surface does.
 */
#include <math.h>
#include <orbicube/hexmesh.h>
#include <stdio.h>
#include <stdlib.h>

static int fail(const obc_error* error) {
  fprintf(stderr, "%s: %s\n", error->kind, error->message);
  return EXIT_FAILURE;
}

static double six_volumes(const obc_surface* s) {
  double sum = 0;
  size_t i;
  for (i = 0; i < s->triangle_count; ++i) {
    const double *a = s->positions + 3 * s->triangles[3 * i], *b = s->positions + 3 * s->triangles[3 * i + 1],
                 *c = s->positions + 3 * s->triangles[3 * i + 2];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

int main(void) {
  obc_mesh *shape = NULL, *filled = NULL;
  obc_surface surface;
  obc_hexmesh* hexes = NULL;
  obc_hexmesh_options options;
  obc_hexmesh_report report;
  obc_mesh_cells cells;
  obc_error error;
  double* positions;
  uint32_t* hexahedra;
  double volume;

  /* Any closed surface will do; this one is made. */
  if (obc_mesh_make("torus", 600, 0, NULL, &shape, &error) != OBC_OK) return fail(&error);
  obc_mesh_surface(shape, &surface, &error);
  obc_hexmesh_options_init(&options, sizeof options);
  options.cells = 600;
  options.max_hausdorff_percent = 3; /* percent; more cells where that is not so */
  report.struct_size = sizeof report;
  if (obc_hexmesh_compute(&surface, &options, NULL, &report, &hexes, &error) != OBC_OK) return fail(&error);

  positions = malloc(3 * obc_hexmesh_vertex_count(hexes) * sizeof *positions);
  hexahedra = malloc(8 * obc_hexmesh_count(hexes) * sizeof *hexahedra);
  if (positions == NULL || hexahedra == NULL) return EXIT_FAILURE;
  obc_hexmesh_copy(hexes, positions, hexahedra, NULL, NULL, &error);

  obc_mesh_cells_init(&cells, sizeof cells);
  cells.positions = positions;
  cells.vertex_count = obc_hexmesh_vertex_count(hexes);
  cells.hexahedra = hexahedra;
  cells.hexahedron_count = obc_hexmesh_count(hexes);
  if (obc_mesh_create(&cells, NULL, &filled, &error) != OBC_OK) return fail(&error);
  if (obc_mesh_check_cells(filled, NULL, &error) != OBC_OK) return fail(&error);
  volume = six_volumes(&surface) / 6;
  printf("%lu hexahedra, scaled Jacobians at least %.3f, %.3f on average, volume %.4f for %.4f\n",
         (unsigned long)cells.hexahedron_count, report.min_scaled_jacobian, report.mean_scaled_jacobian, report.volume,
         volume);
  free(positions);
  free(hexahedra);
  obc_mesh_destroy(filled);
  obc_mesh_destroy(shape);
  obc_hexmesh_destroy(hexes);
  return report.min_scaled_jacobian > 0 && fabs(report.volume / volume - 1) < 0.05 ? EXIT_SUCCESS : EXIT_FAILURE;
}
