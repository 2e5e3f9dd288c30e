/* A bar of cubes is folded flat like a strip of paper, with one end held, and comes back without inverted tetrahedra.
 */
#include <math.h>
#include <orbicube/untangle.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  length = 8,
  width = 2,
  vertex_count = (length + 1) * (width + 1) * (width + 1),
  tetrahedron_count = 6 * length * width * width
};

static double rest[3 * vertex_count], positions[3 * vertex_count];
static uint8_t fixed[vertex_count];
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
        for (k = 0; k < 3; ++k) {
          rest[3 * v + (uint32_t)k] = corner[k];
          positions[3 * v + (uint32_t)k] = corner[k];
        }
        fixed[v] = corner[0] == 0;
        positions[3 * v] = fabs(corner[0] - 4.0 * floor(corner[0] / 4.0 + 0.5)); /* back and forth between 0 and 2 */
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

/* Six times the signed volume of a tetrahedron. */
static double six_volumes(const uint32_t* t) {
  double e[3][3];
  int i, k;
  for (i = 0; i < 3; ++i)
    for (k = 0; k < 3; ++k)
      e[i][k] = positions[3 * t[i + 1] + (uint32_t)k] - positions[3 * t[0] + (uint32_t)k];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

int main(void) {
  obc_untangle_tetrahedra_problem problem;
  obc_untangle_report report;
  obc_error error;
  size_t i, inverted = 0;

  make_bar();
  obc_untangle_tetrahedra_problem_init(&problem, sizeof problem);
  obc_untangle_report_init(&report, sizeof report);
  problem.positions = positions;
  problem.vertex_count = vertex_count;
  problem.tetrahedra = tetrahedra;
  problem.tetrahedron_count = tetrahedron_count;
  problem.rest = rest;
  problem.fixed = fixed;
  if (obc_untangle_tetrahedra(&problem, NULL, NULL, positions, &report, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  for (i = 0; i < tetrahedron_count; ++i)
    if (!(six_volumes(tetrahedra + 4 * i) > 0)) ++inverted;
  printf("%lu of %d tetrahedra were inverted, %lu are; volumes change by factors from %.3f to %.3f\n",
         (unsigned long)report.inverted_before, (int)tetrahedron_count, (unsigned long)inverted, report.min_determinant,
         report.max_determinant);
  return inverted == 0 && report.inverted_before > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
