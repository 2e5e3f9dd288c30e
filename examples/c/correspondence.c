/* Brings an octahedron and a stretched one onto one triangulation and blends them half and half. */
#include <math.h>
#include <orbicube/correspondence.h>
#include <stdio.h>
#include <stdlib.h>

int main(void) {
  static const double round[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  static const uint32_t triangles[24] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  static const double weights[2] = {0.5, 0.5};
  double stretched[18], *half, longest = 0;
  obc_surface surfaces[2];
  obc_correspondence* both;
  obc_error error;
  size_t i, vertices;

  for (i = 0; i < 18; ++i)
    stretched[i] = i % 3 == 0 ? 3 * round[i] : round[i];
  for (i = 0; i < 2; ++i) {
    surfaces[i].positions = i == 0 ? round : stretched;
    surfaces[i].vertex_count = 6;
    surfaces[i].triangles = triangles;
    surfaces[i].triangle_count = 8;
  }
  if (obc_correspondence_create(surfaces, 2, NULL, NULL, &both, &error) != OBC_OK) {
    fprintf(stderr, "%s\n", error.message);
    return 1;
  }
  vertices = obc_correspondence_vertex_count(both);
  half = malloc(3 * vertices * sizeof *half);
  if (half == NULL || obc_correspondence_blend(both, weights, 2, half, &error) != OBC_OK) return 1;
  for (i = 0; i < 3 * vertices; i += 3) {
    if (fabs(half[i]) > longest) longest = fabs(half[i]);
  }
  printf("%lu vertices; halfway between half lengths 1 and 3: %.3f\n", (unsigned long)vertices, longest);
  free(half);
  obc_correspondence_destroy(both);
  return longest > 1.5 && longest < 2.5 ? 0 : 1;
}
