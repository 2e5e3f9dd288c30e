/* Damages a sphere (a hole, flipped faces, a speck beside it), repairs it, and prints what was done and where. */
#include <math.h>
#include <orbicube/repair.h>
#include <stdio.h>
#include <stdlib.h>

int main(void) {
  obc_mesh* mesh = NULL;
  obc_repair* repaired = NULL;
  obc_repair_report report;
  obc_surface sphere, damaged;
  obc_error error;
  double *positions, *places, *sizes;
  uint32_t *triangles, *counts, swapped;
  int32_t* actions;
  size_t i, n;

  if (obc_mesh_make("sphere", 2000, 0, NULL, &mesh, &error) != OBC_OK) return EXIT_FAILURE;
  if (obc_mesh_surface(mesh, &sphere, &error) != OBC_OK) return EXIT_FAILURE;
  positions = malloc(3 * (sphere.vertex_count + 3) * sizeof *positions);
  triangles = malloc(3 * sphere.triangle_count * sizeof *triangles);
  if (positions == NULL || triangles == NULL) return EXIT_FAILURE;
  for (i = 0; i < 3 * sphere.vertex_count; ++i)
    positions[i] = sphere.positions[i];
  for (i = 0; i < 3 * sphere.triangle_count; ++i)
    triangles[i] = sphere.triangles[i];
  /* The last triangle becomes a speck, and leaves a hole; ten others are flipped. */
  n = sphere.vertex_count;
  for (i = 0; i < 9; ++i)
    positions[3 * n + i] = 5 + (i % 4 == 0 ? 0.01 : 0);
  for (i = 0; i < 3; ++i)
    triangles[3 * (sphere.triangle_count - 1) + i] = (uint32_t)(n + i);
  for (i = 0; i < 10; ++i) {
    swapped = triangles[30 * i];
    triangles[30 * i] = triangles[30 * i + 1];
    triangles[30 * i + 1] = swapped;
  }
  damaged.positions = positions;
  damaged.vertex_count = n + 3;
  damaged.triangles = triangles;
  damaged.triangle_count = sphere.triangle_count;
  if (obc_repair_compute(&damaged, NULL, NULL, &repaired, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  obc_repair_report_init(&report, sizeof report);
  obc_repair_get_report(repaired, &report, &error);
  n = obc_repair_event_count(repaired);
  actions = malloc((n + 1) * sizeof *actions);
  counts = malloc((n + 1) * sizeof *counts);
  places = malloc(3 * (n + 1) * sizeof *places);
  sizes = malloc((n + 1) * sizeof *sizes);
  if (actions == NULL || counts == NULL || places == NULL || sizes == NULL) return EXIT_FAILURE;
  obc_repair_copy_events(repaired, actions, counts, places, sizes, &error);
  for (i = 0; i < n; ++i)
    printf("%s at (%.3f, %.3f, %.3f): count %u, size %.3g\n", obc_repair_action_name(actions[i]), places[3 * i],
           places[3 * i + 1], places[3 * i + 2], counts[i], sizes[i]);
  printf("%d triangles turned; closed %d, manifold %d, oriented %d, genus %d, self-intersections %d\n",
         (int)report.reversed_triangles, report.closed, report.manifold, report.oriented, (int)report.genus,
         (int)report.self_intersections);
  i = report.reversed_triangles == 10 && report.closed && report.manifold && report.oriented && report.genus == 0 &&
      report.self_intersections == 0 && report.filled_holes == 1 && report.dropped_triangles == 1 &&
      obc_repair_triangle_count(repaired) == sphere.triangle_count;
  free(positions), free(triangles), free(actions), free(counts), free(places), free(sizes);
  obc_repair_destroy(repaired);
  obc_mesh_destroy(mesh);
  return i ? EXIT_SUCCESS : EXIT_FAILURE;
}
