/* Smooths a field that the program keeps in its own arrays: frames of a ball, turned at random about the axes of space.
 */
#include <math.h>
#include <orbicube/frame_field.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  cubes = 10,
  vertex_count = (cubes + 1) * (cubes + 1) * (cubes + 1),
  tetrahedron_count = 6 * cubes * cubes * cubes
};

static double positions[3 * vertex_count];
static uint32_t tetrahedra[4 * tetrahedron_count];
static double frames[4 * tetrahedron_count];

static uint32_t vertex_at(const int* p) {
  return (uint32_t)((p[0] * (cubes + 1) + p[1]) * (cubes + 1) + p[2]);
}

static double largest(double x, double y, double z) {
  return fmax(fabs(x), fmax(fabs(y), fabs(z)));
}

/* A cube of cubes, rounded; each small cube is cut into six tetrahedra about its diagonal. */
static void make_ball(void) {
  static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
  uint32_t* next = tetrahedra;
  int corner[3], p[3], i, k;
  for (corner[0] = 0; corner[0] <= cubes; ++corner[0]) {
    for (corner[1] = 0; corner[1] <= cubes; ++corner[1]) {
      for (corner[2] = 0; corner[2] <= cubes; ++corner[2]) {
        double* at = positions + 3 * vertex_at(corner);
        double length, scale;
        for (k = 0; k < 3; ++k)
          at[k] = 2.0 * corner[k] / cubes - 1;
        length = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
        scale = length > 0 ? 0.2 + 0.8 * largest(at[0], at[1], at[2]) / length : 1;
        for (k = 0; k < 3; ++k)
          at[k] *= scale;
        if (corner[0] == cubes || corner[1] == cubes || corner[2] == cubes) continue;
        for (i = 0; i < 6; ++i) {
          uint32_t t[4];
          for (k = 0; k < 3; ++k)
            p[k] = corner[k];
          t[0] = vertex_at(p);
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

int main(void) {
  const obc_frame_field_solid solid = {positions, vertex_count, tetrahedra, tetrahedron_count};
  obc_frame_field_options options;
  obc_frame_field_report before, after;
  obc_error error;
  uint32_t random = 1;
  size_t t;

  make_ball();
  for (t = 0; t < tetrahedron_count; ++t) {
    const double angle = (random >> 8) * (0.5 / (1 << 24)); /* up to half a radian */
    frames[4 * t] = cos(0.5 * angle);
    frames[4 * t + 1 + t % 3] = sin(0.5 * angle);
    random = random * 1664525u + 1013904223u;
  }
  obc_frame_field_report_init(&before, sizeof before);
  obc_frame_field_report_init(&after, sizeof after);
  obc_frame_field_options_init(&options, sizeof options);
  options.start = OBC_FRAME_FIELD_GIVEN;
  if (obc_frame_field_measure(&solid, frames, NULL, &before, &error) != OBC_OK ||
      obc_frame_field_compute(&solid, &options, NULL, NULL, frames, &after, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  printf("%d frames, %d boundary faces\n", (int)tetrahedron_count, (int)after.boundary_faces);
  printf("energy %.1f -> %.1f, angles %.2f -> %.2f degrees on average, at most %.1f\n", before.energy, after.energy,
         before.symmetric_mean, after.symmetric_mean, after.symmetric_max);
  printf("%.1e degrees off the normals, %d singular edges on %d curves, %d dead ends\n", after.one_face_max,
         (int)after.singular_edges, (int)after.curves, (int)after.dead_ends);
  return after.energy < 0.5 * before.energy && after.one_face_max < 1e-6 && after.dead_ends == 0 &&
                 after.boundary_index_quarters == 4 * after.euler_characteristic
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
