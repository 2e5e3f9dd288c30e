/* The cheapest mix of five feeds that reaches a given share of protein, with a penalty on strange mixes:
 *   min c'x + 0.5 sum w (x - usual)^2   subject to   sum x = 1,  p'x = 0.2,  0 <= x <= 0.6.
 * First with a callback, then one evaluation at a time with a save and a load in the middle: both end in the same bits.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <orbicube/projected_gradient.h>

enum { FEEDS = 5 };

static const double price[FEEDS] = {0.9, 0.3, 0.5, 1.4, 0.2};
static const double usual[FEEDS] = {0.2, 0.3, 0.2, 0.1, 0.2};
static const double weight[FEEDS] = {2, 1, 3, 1, 4};

static int32_t cost(const double* x, size_t n, double* value, double* gradient, void* user) {
  double sum = 0;
  size_t j;
  (void)user;
  for (j = 0; j < n; ++j) {
    const double away = x[j] - usual[j];
    sum += price[j] * x[j] + 0.5 * weight[j] * away * away;
    gradient[j] = price[j] + weight[j] * away;
  }
  *value = sum;
  return OBC_PROJECTED_GRADIENT_CONTINUE;
}

int main(void) {
  const double lower[FEEDS] = {0, 0, 0, 0, 0}, upper[FEEDS] = {0.6, 0.6, 0.6, 0.6, 0.6};
  const size_t row_start[3] = {0, FEEDS, 2 * FEEDS};
  const uint32_t column[2 * FEEDS] = {0, 1, 2, 3, 4, 0, 1, 2, 3, 4};
  const double value[2 * FEEDS] = {1, 1, 1, 1, 1, 0.12, 0.09, 0.35, 0.44, 0.05};
  const double b[2] = {1, 0.2};
  double x[FEEDS] = {0, 0, 0, 0, 0}, again[FEEDS], multipliers[2], worst = 0;
  const double start[FEEDS] = {0, 0, 0, 0, 0};
  obc_projected_gradient_problem problem;
  obc_projected_gradient_result result;
  obc_projected_gradient* solver = NULL;
  obc_error error;
  const double* point;
  int32_t request;
  size_t j, steps = 0;

  obc_projected_gradient_problem_init(&problem, sizeof problem);
  problem.n = FEEDS;
  problem.m = 2;
  problem.lower = lower;
  problem.upper = upper;
  problem.row_start = row_start;
  problem.column = column;
  problem.value = value;
  problem.b = b;
  result.struct_size = sizeof result;
  if (obc_projected_gradient_minimize(&problem, NULL, cost, NULL, x, &result, NULL, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  printf("%s after %d evaluations: f = %.12f, projected gradient %.1e, residual of the rows %.1e\n",
         obc_projected_gradient_stop_name(result.stop), (int)result.evaluations, result.value,
         result.projected_gradient, result.equality_residual);
  for (j = 0; j < FEEDS; ++j)
    printf("  feed %d: %.9f\n", (int)j, x[j]);

  /* The same by requesting one evaluation at a time; after the second one the run goes through bytes. */
  if (obc_projected_gradient_create(&problem, NULL, start, NULL, &solver, &error) != OBC_OK) return 1;
  while ((request = obc_projected_gradient_step(solver, &point)) > 0 && request != OBC_PROJECTED_GRADIENT_DONE) {
    double f, gradient[FEEDS];
    if (request != OBC_PROJECTED_GRADIENT_NEED_FG) continue;
    cost(point, FEEDS, &f, gradient, NULL);
    obc_projected_gradient_tell(solver, f, gradient, NULL);
    if (++steps == 2) {
      const size_t size = obc_projected_gradient_save_size(solver);
      void* blob = malloc(size);
      if (blob == NULL || obc_projected_gradient_save(solver, blob, size, &error) != OBC_OK) return 1;
      obc_projected_gradient_destroy(solver);
      if (obc_projected_gradient_load(&problem, blob, size, NULL, &solver, &error) != OBC_OK) return 1;
      free(blob);
    }
  }
  obc_projected_gradient_get_result(solver, &result, again, NULL);
  obc_projected_gradient_multipliers(solver, multipliers, NULL);
  obc_projected_gradient_destroy(solver);

  /* At the solution, price + weight (x - usual) - A't is zero strictly between the bounds and pushes outwards on them.
   */
  for (j = 0; j < FEEDS; ++j) {
    const double slope =
        price[j] + weight[j] * (again[j] - usual[j]) - multipliers[0] - multipliers[1] * value[FEEDS + j];
    const double breach = again[j] <= 0 ? -slope : again[j] >= 0.6 ? slope : fabs(slope);
    if (breach > worst) worst = breach;
  }
  printf("multipliers %.9f %.9f; optimality conditions hold to %.1e\n", multipliers[0], multipliers[1], worst);
  return result.stop == OBC_PROJECTED_GRADIENT_CONVERGED && worst < 1e-7 && memcmp(x, again, sizeof x) == 0 ? 0 : 1;
}
