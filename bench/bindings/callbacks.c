/* What a call of the user's function costs through C: a run of projected_gradient on the chained Rosenbrock function of
 * ten unknowns, again and again, with a function that only hands out what it has recorded in a first run. The programs
 * of the other languages do the same; what they take longer is theirs. Prints nanoseconds an evaluation. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <orbicube/projected_gradient.h>

enum { UNKNOWNS = 10, RUNS = 1500, MOST = 1000 };

struct recorded {
  size_t count, next;
  double values[MOST], gradients[MOST][UNKNOWNS];
};

static int32_t rosenbrock(const double* x, size_t n, double* value, double* gradient, void* user) {
  struct recorded* to = user;
  double sum = 0;
  size_t i;
  memset(gradient, 0, n * sizeof *gradient);
  for (i = 0; i + 1 < n; ++i) {
    const double a = x[i + 1] - x[i] * x[i], b = 1 - x[i];
    sum = sum + (100 * a * a + b * b);
    gradient[i] = gradient[i] - (400 * x[i] * a + 2 * b);
    gradient[i + 1] = gradient[i + 1] + 200 * a;
  }
  *value = sum;
  if (to->count == MOST) return OBC_PROJECTED_GRADIENT_STOP;
  to->values[to->count] = sum;
  memcpy(to->gradients[to->count++], gradient, n * sizeof *gradient);
  return OBC_PROJECTED_GRADIENT_CONTINUE;
}

static int32_t replay(const double* x, size_t n, double* value, double* gradient, void* user) {
  struct recorded* from = user;
  (void)x;
  if (from->next == from->count) return OBC_PROJECTED_GRADIENT_STOP;
  *value = from->values[from->next];
  memcpy(gradient, from->gradients[from->next++], n * sizeof *gradient);
  return OBC_PROJECTED_GRADIENT_CONTINUE;
}

static void run(obc_projected_gradient_function f, struct recorded* recorded) {
  obc_projected_gradient_problem problem;
  double x[UNKNOWNS];
  size_t i;
  obc_projected_gradient_problem_init(&problem, sizeof problem);
  problem.n = UNKNOWNS;
  for (i = 0; i < UNKNOWNS; ++i)
    x[i] = i % 2 == 0 ? -1.2 : 1;
  if (obc_projected_gradient_minimize(&problem, NULL, f, recorded, x, NULL, NULL, NULL) != OBC_OK) exit(1);
}

int main(void) {
  static struct recorded recorded;
  double best = 1e30;
  int i;
  run(rosenbrock, &recorded);
  for (i = 0; i < RUNS; ++i) {
    struct timespec begin, end;
    double spent;
    recorded.next = 0;
    clock_gettime(CLOCK_MONOTONIC, &begin);
    run(replay, &recorded);
    clock_gettime(CLOCK_MONOTONIC, &end);
    spent = 1e9 * (double)(end.tv_sec - begin.tv_sec) + (double)(end.tv_nsec - begin.tv_nsec);
    if (spent / (double)recorded.count < best) best = spent / (double)recorded.count;
  }
  printf("C: %.0f ns an evaluation, %d evaluations a run\n", best, (int)recorded.count);
  return recorded.next == recorded.count ? 0 : 1;
}
