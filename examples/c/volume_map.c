/* A bar of cubes, bent by 86 degrees, is mapped to a polycube: every tetrahedron is positive in space and there. */
#include <math.h>
#include <orbicube/volume_map.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  length = 8,
  width = 2,
  vertex_count = (length + 1) * (width + 1) * (width + 1),
  tetrahedron_count = 6 * length * width * width
};

static double positions[3 * vertex_count];
static uint32_t tetrahedra[4 * tetrahedron_count];

static uint32_t vertex_at(const int* p) {
  return (uint32_t)((p[0] * (width + 1) + p[1]) * (width + 1) + p[2]);
}

/* Each cube is cut into six tetrahedra about its diagonal. */
static void make_bar(void) {
  static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  uint32_t* next = tetrahedra;
  int corner[3], p[3], i, k;
  for (corner[0] = 0; corner[0] <= length; ++corner[0]) {
    for (corner[1] = 0; corner[1] <= width; ++corner[1]) {
      for (corner[2] = 0; corner[2] <= width; ++corner[2]) {
        const uint32_t v = vertex_at(corner);
        const double angle = 1.5 * corner[0] / length, radius = 8.0 - corner[1];
        positions[3 * v] = radius * sin(angle);
        positions[3 * v + 1] = -radius * cos(angle);
        positions[3 * v + 2] = corner[2];
        if (corner[0] == length || corner[1] == width || corner[2] == width) continue;
        for (i = 0; i < 6; ++i) {
          uint32_t t[4];
          for (k = 0; k < 3; ++k)
            p[k] = corner[k];
          t[0] = v;
          for (k = 0; k < 3; ++k) {
            ++p[order[i][k]];
            t[k + 1] = vertex_at(p);
          }
          /* The last three orders are odd: their tetrahedra would be negative. */
          next[0] = t[0];
          next[1] = t[1];
          next[2] = i < 3 ? t[2] : t[3];
          next[3] = i < 3 ? t[3] : t[2];
          next += 4;
        }
      }
    }
  }
}

/* Returns how many tetrahedra are not positive. */
static size_t count_inverted(const double* x, const uint32_t* cells, size_t count) {
  size_t i, inverted = 0;
  for (i = 0; i < count; ++i) {
    const uint32_t* t = cells + 4 * i;
    if (obc_mesh_orientation_3d(x + 3 * t[0], x + 3 * t[1], x + 3 * t[2], x + 3 * t[3]) != 1) ++inverted;
  }
  return inverted;
}

int main(void) {
  obc_volume_map_solid_options options;
  obc_volume_map_solid* solid = NULL;
  obc_error error;
  size_t vertices, cells, inverted;
  double *source, *polycube;
  uint32_t* mapped;

  make_bar();
  obc_volume_map_solid_options_init(&options, sizeof options);
  options.corners = 8;
  if (obc_volume_map_solid_compute(positions, vertex_count, tetrahedra, tetrahedron_count, &options, NULL, &solid,
                                   &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  vertices = obc_volume_map_solid_vertex_count(solid);
  cells = obc_volume_map_solid_tetrahedron_count(solid);
  source = malloc(3 * vertices * sizeof *source);
  polycube = malloc(3 * vertices * sizeof *polycube);
  mapped = malloc(4 * cells * sizeof *mapped);
  if (source == NULL || polycube == NULL || mapped == NULL ||
      obc_volume_map_solid_copy(solid, source, polycube, mapped, &error) != OBC_OK)
    return EXIT_FAILURE;
  inverted = count_inverted(source, mapped, cells) + count_inverted(polycube, mapped, cells);
  printf("%lu tetrahedra, %lu on the polycube; inverted: %lu\n", (unsigned long)tetrahedron_count, (unsigned long)cells,
         (unsigned long)inverted);
  obc_volume_map_solid_destroy(solid);
  free(source);
  free(polycube);
  free(mapped);
  return inverted == 0 && cells >= tetrahedron_count ? EXIT_SUCCESS : EXIT_FAILURE;
}
