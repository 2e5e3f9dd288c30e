/* Fits the decay y = a / (1 + b t) + c to eight measurements without derivatives, within bounds:
 *   min sum_i (a / (1 + b t_i) + c - y_i)^2.
 * First with a callback, then one evaluation at a time with a save and a load in the middle: both end in the same bits.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <orbicube/trust_region.h>

enum { UNKNOWNS = 3, MEASUREMENTS = 8 };

static const double truth[UNKNOWNS] = {2.5, 0.7, 0.4};

static double model(const double* x, size_t i) {
  return x[0] / (1 + x[1] * 0.5 * (double)i) + x[2];
}

static int32_t misfit(const double* x, size_t n, double* residuals, void* user) {
  size_t i;
  (void)n;
  (void)user;
  for (i = 0; i < MEASUREMENTS; ++i)
    residuals[i] = model(x, i) - model(truth, i);
  return OBC_TRUST_REGION_CONTINUE;
}

int main(void) {
  const double lower[UNKNOWNS] = {0, 0, -1}, upper[UNKNOWNS] = {10, 2, 1}, start[UNKNOWNS] = {1, 0.1, 0};
  double x[UNKNOWNS] = {1, 0.1, 0}, again[UNKNOWNS], residuals[MEASUREMENTS], worst = 0;
  obc_trust_region_problem problem;
  obc_trust_region_result result;
  obc_trust_region* solver = NULL;
  obc_error error;
  const double* points;
  size_t j, count, evaluations = 0;
  int32_t request;

  obc_trust_region_problem_init(&problem, sizeof problem);
  problem.n = UNKNOWNS;
  problem.residuals = MEASUREMENTS;
  problem.lower = lower;
  problem.upper = upper;
  result.struct_size = sizeof result;
  if (obc_trust_region_minimize(&problem, NULL, misfit, NULL, x, &result, NULL, &error) != OBC_OK) {
    fprintf(stderr, "%s: %s\n", error.kind, error.message);
    return 1;
  }
  printf("%s after %d evaluations: sum of squares %.1e\n", obc_trust_region_stop_name(result.stop),
         (int)result.evaluations, result.value);

  /* The same by requesting one evaluation at a time; after the fifth one the run goes through bytes. */
  if (obc_trust_region_create(&problem, NULL, start, NULL, &solver, &error) != OBC_OK) return 1;
  while ((request = obc_trust_region_step(solver, &points, &count)) > 0 && request != OBC_TRUST_REGION_DONE) {
    if (request != OBC_TRUST_REGION_NEED_VALUES) continue;
    misfit(points, UNKNOWNS, residuals, NULL);
    obc_trust_region_tell(solver, residuals, NULL);
    if (++evaluations == 5) {
      const size_t size = obc_trust_region_save_size(solver);
      void* blob = malloc(size);
      if (blob == NULL || obc_trust_region_save(solver, blob, size, &error) != OBC_OK) return 1;
      obc_trust_region_destroy(solver);
      if (obc_trust_region_load(&problem, blob, size, NULL, &solver, &error) != OBC_OK) return 1;
      free(blob);
    }
  }
  obc_trust_region_get_result(solver, &result, again, NULL, NULL);
  obc_trust_region_destroy(solver);

  for (j = 0; j < UNKNOWNS; ++j) {
    printf("  %.9f, true %.1f\n", again[j], truth[j]);
    if (fabs(again[j] - truth[j]) > worst) worst = fabs(again[j] - truth[j]);
  }
  printf("largest error %.1e\n", worst);
  return result.stop == OBC_TRUST_REGION_CONVERGED && worst < 1e-7 && memcmp(x, again, sizeof x) == 0 ? 0 : 1;
}
