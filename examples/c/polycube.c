/* A sphere's triangles on a cube: certified, written down as a graph, meshed with quads, and refused once one vertex is
 * off by a hair. */
#include <orbicube/polycube.h>
#include <stdio.h>
#include <stdlib.h>

/* The patches of the polycube with their neighbors, and how many edges are convex. Returns 0 unless all are. */
static int print_graph(const obc_polycube* map) {
  static const char* const directions[6] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  uint32_t starts[7], neighbors[24];
  uint8_t labels[6], convex[12];
  obc_polycube_graph* graph;
  size_t p, e, count = 0;
  uint32_t i;

  if (obc_polycube_graph_create(map, NULL, &graph, NULL) != OBC_OK) return 0;
  if (obc_polycube_graph_patch_count(graph) == 6 && obc_polycube_graph_edge_count(graph) == 12 &&
      obc_polycube_graph_copy_patches(graph, labels, NULL, NULL, NULL) == OBC_OK &&
      obc_polycube_graph_copy_edges(graph, NULL, NULL, convex, NULL) == OBC_OK &&
      obc_polycube_graph_copy_dual(graph, starts, neighbors, NULL) == OBC_OK) {
    for (p = 0; p < 6; ++p) {
      printf("%s beside", directions[labels[p]]);
      for (i = starts[p]; i < starts[p + 1]; ++i)
        printf(" %s", directions[labels[neighbors[i]]]);
      printf("\n");
    }
    for (e = 0; e < 12; ++e)
      count += convex[e];
  }
  obc_polycube_graph_destroy(graph);
  return count == 12;
}

/* Returns the number of quads with edges about a fifth of the cube's. */
static size_t count_quads(const obc_polycube* map) {
  obc_polycube_quads_options options;
  obc_polycube_quads* quads;
  size_t count;

  obc_polycube_quads_options_init(&options, sizeof options);
  options.edge_length = 0.4;
  if (obc_polycube_quads_create(map, &options, NULL, &quads, NULL) != OBC_OK) return 0;
  count = obc_polycube_quads_quad_count(quads);
  obc_polycube_quads_destroy(quads);
  return count;
}

int main(void) {
  static const uint32_t triangles[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                         2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  double sphere[24], cube[24];
  const obc_surface surface = {sphere, 8, triangles, 12};
  obc_polycube_certificate certificate;
  obc_polycube* map;
  obc_error error;
  size_t i, corners, quads;
  int convex;

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
  convex = print_graph(map);
  quads = count_quads(map);
  printf("%lu quads\n", (unsigned long)quads);
  obc_polycube_destroy(map);

  cube[0] += 1e-12;
  if (obc_polycube_create(&surface, cube, NULL, &certificate, &map, &error) != OBC_NO_VALID_RESULT) return EXIT_FAILURE;
  printf("%s: %s\n", error.kind, certificate.reason);
  return corners == 8 && convex && quads == 150 ? EXIT_SUCCESS : EXIT_FAILURE;
}
