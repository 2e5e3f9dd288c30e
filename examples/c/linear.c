/* The temperature of a plate whose rim has temperature 0 and that is heated in the middle: one factor, then one of the
 * points becomes known as well, then the same by conjugate gradients. */
#include <math.h>
#include <orbicube/linear.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 60, COUNT = SIDE * SIDE };

static size_t row_begin[COUNT + 1];
static uint32_t columns[3 * COUNT];
static double values[3 * COUNT], heat[COUNT], warm[COUNT], held[COUNT], iterated[COUNT];

static obc_linear_matrix laplacian(void) {
  obc_linear_matrix matrix;
  size_t entries = 0;
  uint32_t i;
  for (i = 0; i < COUNT; ++i) {
    if (i >= SIDE) {
      columns[entries] = i - SIDE;
      values[entries++] = -1;
    }
    if (i % SIDE != 0) {
      columns[entries] = i - 1;
      values[entries++] = -1;
    }
    columns[entries] = i;
    values[entries++] = 4;
    row_begin[i + 1] = entries;
  }
  matrix.size = COUNT;
  matrix.row_begin = row_begin;
  matrix.columns = columns;
  matrix.values = values;
  return matrix;
}

int main(void) {
  const obc_linear_matrix matrix = laplacian();
  const uint32_t middle = SIDE / 2 * SIDE + SIDE / 2;
  obc_linear_direct* factor;
  obc_linear_iterative* solver;
  obc_linear_iterative_report report;
  obc_error error;
  double difference = 0;
  size_t i;

  heat[middle] = 1;
  if (obc_linear_direct_create(&matrix, NULL, NULL, &factor, &error) != OBC_OK ||
      obc_linear_direct_solve(factor, 1, heat, warm, &error) != OBC_OK ||
      obc_linear_direct_remove_row(factor, middle + 10, &error) != OBC_OK ||
      obc_linear_direct_solve(factor, 1, heat, held, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  printf("%.6f in the middle, %.6f where a point is fixed at %.1f\n", warm[middle], held[middle], held[middle + 10]);
  obc_linear_direct_destroy(factor);

  obc_linear_iterative_report_init(&report, sizeof report);
  if (obc_linear_iterative_create(&matrix, NULL, NULL, &solver, &error) != OBC_OK ||
      obc_linear_iterative_solve(solver, heat, iterated, &report, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return EXIT_FAILURE;
  }
  obc_linear_iterative_destroy(solver);
  for (i = 0; i < COUNT; ++i)
    difference = fmax(difference, fabs(iterated[i] - warm[i]));
  printf("the same by %d iterations to %.1e\n", (int)report.iterations, difference);
  return difference < 1e-6 && held[middle] < warm[middle] && held[middle + 10] == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
