/* Twelve points on a sphere that repel each other by 1 / distance^2 settle at the corners of an icosahedron, where the
 * energy is 39. First all at once with a callback, then one evaluation at a time with a save and a load in the middle,
 * which ends in the same bits; and point by point.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <orbicube/sphere_optimizer.h>

enum { POINTS = 12, UNKNOWNS = 3 * POINTS };

/* Energy of point i at `place` with all others; its gradient where requested. */
static int32_t one(size_t i, const double* place, const double* x, double* value, double* gradient, double* hessian,
                   void* user) {
  size_t j, k;
  (void)hessian;
  (void)user;
  *value = 0;
  for (k = 0; gradient != NULL && k < 3; ++k)
    gradient[k] = 0;
  for (j = 0; j < POINTS; ++j) {
    double away[3], square = 0, term;
    if (j == i) continue;
    for (k = 0; k < 3; ++k) {
      away[k] = place[k] - x[3 * j + k];
      square += away[k] * away[k];
    }
    term = 1 / square;
    *value += term;
    for (k = 0; gradient != NULL && k < 3; ++k)
      gradient[k] -= 2 * term * term * away[k];
  }
  return OBC_SPHERE_OPTIMIZER_CONTINUE;
}

static int32_t all(const double* x, size_t count, size_t dimension, double* value, double* gradient, void* user) {
  double sum = 0, part;
  size_t i;
  for (i = 0; i < count; ++i) {
    one(i, x + dimension * i, x, &part, gradient + dimension * i, NULL, user);
    sum += 0.5 * part;
  }
  *value = sum;
  return OBC_SPHERE_OPTIMIZER_CONTINUE;
}

int main(void) {
  double start[UNKNOWNS], x[UNKNOWNS], again[UNKNOWNS], apart[UNKNOWNS], gradient[UNKNOWNS], energy;
  size_t neighbor_start[POINTS + 1], i, j, steps = 0;
  uint32_t neighbor[POINTS * (POINTS - 1)];
  obc_sphere_optimizer_result result;
  obc_sphere_optimizer_blocks blocks;
  obc_sphere_optimizer* solver = NULL;
  obc_error error;
  const double* point;
  int32_t request;

  for (i = 0; i < UNKNOWNS; ++i)
    start[i] = (double)(i * i * 7 % 37) / 37 - 0.5;
  memcpy(x, start, sizeof x);
  result.struct_size = sizeof result;
  if (obc_sphere_optimizer_minimize(POINTS, 3, NULL, all, NULL, x, &result, NULL, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  printf("all at once: %s after %d evaluations, energy %.9f, gradient %.1e\n",
         obc_sphere_optimizer_stop_name(result.stop), (int)result.evaluations, result.value, result.gradient_norm);

  if (obc_sphere_optimizer_create(POINTS, 3, NULL, start, NULL, &solver, &error) != OBC_OK) return 1;
  while ((request = obc_sphere_optimizer_step(solver, &point)) > 0 && request != OBC_SPHERE_OPTIMIZER_DONE) {
    if (request != OBC_SPHERE_OPTIMIZER_NEED_FG) continue;
    all(point, POINTS, 3, &energy, gradient, NULL);
    obc_sphere_optimizer_tell(solver, energy, gradient, NULL);
    if (++steps == 10) {
      const size_t size = obc_sphere_optimizer_save_size(solver);
      void* blob = malloc(size);
      if (blob == NULL || obc_sphere_optimizer_save(solver, blob, size, &error) != OBC_OK) return 1;
      obc_sphere_optimizer_destroy(solver);
      if (obc_sphere_optimizer_load(blob, size, NULL, &solver, &error) != OBC_OK) return 1;
      free(blob);
    }
  }
  obc_sphere_optimizer_get_result(solver, &result, again, NULL);
  obc_sphere_optimizer_destroy(solver);
  printf("saved and loaded in the middle: %s\n", memcmp(x, again, sizeof x) == 0 ? "the same bits" : "different");

  steps = 0;
  for (i = 0; i < POINTS; ++i) {
    neighbor_start[i] = steps;
    for (j = 0; j < POINTS; ++j) {
      if (j != i) neighbor[steps++] = (uint32_t)j;
    }
  }
  neighbor_start[POINTS] = steps;
  obc_sphere_optimizer_blocks_init(&blocks, sizeof blocks);
  blocks.dimension = 3;
  blocks.count = POINTS;
  blocks.neighbor_start = neighbor_start;
  blocks.neighbor = neighbor;
  memcpy(apart, start, sizeof apart);
  if (obc_sphere_optimizer_relax(&blocks, NULL, one, NULL, apart, NULL, NULL, &error) != OBC_OK) return 1;
  all(apart, POINTS, 3, &energy, gradient, NULL);
  printf("point by point: energy %.9f\n", energy);
  return fabs(result.value - 39) < 1e-10 && fabs(energy - 39) < 1e-10 && memcmp(x, again, sizeof x) == 0 ? 0 : 1;
}
