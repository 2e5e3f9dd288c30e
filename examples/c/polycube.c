/* A sphere's triangles on a cube: certified, and refused once one vertex is off by a hair. */
#include <orbicube/polycube.h>
#include <stdio.h>
#include <stdlib.h>

int main(void) {
  static const uint32_t triangles[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  double sphere[24], cube[24];
  const obc_surface surface = {sphere, 8, triangles, 12};
  obc_polycube_certificate certificate;
  obc_polycube* map;
  obc_error error;
  size_t i, corners;

  for (i = 0; i < 24; ++i) {
    cube[i] = (i / 3) >> (i % 3) & 1 ? 1 : -1;
    sphere[i] = cube[i] * 0.57735026918962584;
  }
  certificate.struct_size = sizeof certificate;
  if (obc_polycube_create(&surface, cube, NULL, &certificate, &map, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  corners = obc_polycube_corner_count(map);
  printf("%lu corners, %lu faces\n", (unsigned long)corners, (unsigned long)obc_polycube_patch_count(map));
  obc_polycube_destroy(map);

  cube[0] += 1e-12;
  if (obc_polycube_create(&surface, cube, NULL, &certificate, &map, &error) != OBC_NO_VALID_RESULT) return EXIT_FAILURE;
  printf("%s: %s\n", error.kind, certificate.reason);
  return corners == 8 ? EXIT_SUCCESS : EXIT_FAILURE;
}
