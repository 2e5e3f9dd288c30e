/* Makes a torus, writes it to a file and reads it again to the bit; breaks it, and prints the defect and its location:
 * topology, orientation, the nearest point, exact signs. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <orbicube/mesh.h>

static obc_mesh_topology_report examine(const char* what, const obc_surface* surface) {
  obc_mesh_topology_report report;
  obc_error error;
  obc_mesh_topology_report_init(&report, sizeof report);
  if (obc_mesh_topology(surface, NULL, &report, &error) != OBC_OK) printf("%s: %s\n", error.kind, error.message);
  printf("%s: %d vertices, %d edges, %d triangles; genus %d, %d boundary loops, %d inconsistent edges, volume %.3f\n",
         what, (int)report.vertices, (int)report.edges, (int)report.triangles, (int)report.genus,
         (int)report.boundary_loops, (int)report.inconsistent_edges, report.volume);
  return report;
}

int main(void) {
  const double above[3] = {0, 0, 5};
  const double a[3] = {0.1, 0.1, 0.1}, b[3] = {0.2, 0.2, 0.2}, c[3] = {0, 0, 1};
  const char* path = "mesh-example.ply";
  const char* cut = "OFF 3 1 0\n0 0 0\n1 0 0\n"; /* a vertex and a face are missing */
  obc_mesh *torus = NULL, *again = NULL;
  obc_mesh_search* search = NULL;
  obc_mesh_topology_report report;
  obc_mesh_orient_report turned;
  obc_surface surface, read;
  obc_error error;
  uint32_t *triangles, swapped, nearest;
  double distance, volume;
  int right = 1;

  if (obc_mesh_make("torus", 5000, 0, NULL, &torus, &error) != OBC_OK ||
      obc_mesh_surface(torus, &surface, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  report = examine("torus", &surface);
  right &= report.closed && report.genus == 1 && report.volume > 0;
  volume = report.volume;

  /* To a binary PLY file, and back. */
  if (obc_mesh_write(path, torus, NULL, NULL, &error) != OBC_OK ||
      obc_mesh_read(path, NULL, NULL, &again, &error) != OBC_OK || obc_mesh_surface(again, &read, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  printf("%s: %s, %d triangles\n", path, obc_mesh_format(again), (int)read.triangle_count);
  right &= read.vertex_count == surface.vertex_count && read.triangle_count == surface.triangle_count &&
           memcmp(read.positions, surface.positions, 3 * surface.vertex_count * sizeof(double)) == 0 &&
           memcmp(read.triangles, surface.triangles, 3 * surface.triangle_count * sizeof(uint32_t)) == 0;
  obc_mesh_destroy(again);
  remove(path);

  /* What is no file, or not what it should be, ends in a kind and a place. */
  right &= obc_mesh_read_memory(cut, strlen(cut), OBC_MESH_OFF, NULL, NULL, &again, &error) == OBC_MALFORMED_FILE;
  printf("%s: %s\n", error.kind, error.message);

  /* A torus has a handle: sphere maps refuse it, and say why. */
  right &= obc_mesh_check_closed_genus_zero(&surface, NULL, &error) == OBC_WRONG_GENUS;
  printf("%s: %s\n", error.kind, error.message);

  /* One triangle turned round, then turned back. */
  triangles = malloc(3 * surface.triangle_count * sizeof *triangles);
  if (triangles == NULL) return 1;
  memcpy(triangles, surface.triangles, 3 * surface.triangle_count * sizeof *triangles);
  surface.triangles = triangles;
  swapped = triangles[30];
  triangles[30] = triangles[31];
  triangles[31] = swapped;
  report = examine("one triangle turned", &surface);
  right &= report.inconsistent_edges == 3 && report.first_inconsistent_edge[0] != 0xFFFFFFFF;
  obc_mesh_orient_report_init(&turned, sizeof turned);
  if (obc_mesh_orient(surface.positions, surface.vertex_count, triangles, surface.triangle_count, NULL, &turned,
                      NULL) != OBC_OK)
    return 1;
  right &= turned.reversed_triangles == 1 && !turned.inward_oriented;
  report = examine("turned back", &surface);
  right &= report.inconsistent_edges == 0 && fabs(report.volume - volume) < 1e-12 * volume;

  /* Without its last triangle it has a hole. */
  surface.triangle_count -= 1;
  report = examine("a triangle missing", &surface);
  right &= !report.closed && report.boundary_loops == 1 && report.longest_boundary_loop == 3;

  /* The nearest point of the surface, as seen from above. */
  if (obc_mesh_search_create(&surface, NULL, &search, NULL) != OBC_OK ||
      obc_mesh_search_surface(search, above, 1, &nearest, NULL, NULL, &distance, NULL) != OBC_OK)
    return 1;
  printf("from (0, 0, 5) it is %.3f to triangle %u\n", distance, (unsigned)nearest);
  right &= distance > 3 && distance < 5.5;

  /* Three points in one plane with the origin: the sign is exactly 0, whatever rounding makes of the determinant. */
  right &= obc_mesh_orientation_from_origin(a, b, c) == 0;

  free(triangles);
  obc_mesh_search_destroy(search);
  obc_mesh_destroy(torus);
  return right ? 0 : 1;
}
