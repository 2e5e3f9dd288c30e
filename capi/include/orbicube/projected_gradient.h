/* Orbicube projected gradient: minimizes f(x) subject to A x = b and lower <= x <= upper, for a smooth f with its gradient and a
 * sparse A, from one to millions of unknowns. Also projects points onto such a set.
 *
 * Methods. FACE (default): projected Barzilai-Borwein steps on a limited-memory quasi-Newton model of f find the active face
 * of the feasible set; the step is the exact minimizer of the model in this face (two phases of Hager and Zhang 2006, model of
 * Byrd, Lu, Nocedal, Zhu 1995, line search of Hager and Zhang 2005). DISSERTATION, for comparison: the projected Barzilai-Borwein
 * method of the dissertation, section 4.3.1 (eq. 4.11 to 4.13), with the nonmonotone searches of Grippo, Lampariello, Lucidi 1986
 * or of Zhang and Hager 2004.
 *
 * A quadratic f is recognized by its values and slopes. FACE then goes on from the minima along its steps without evaluating f there;
 * a run that ends as CONVERGED has evaluated f at its end.
 *
 * Every x at which f is evaluated satisfies the bounds exactly and A x = b to rounding.
 *
 * Use. Fill a problem. Then call obc_projected_gradient_minimize with a callback, or create a solver and evaluate f whenever
 * obc_projected_gradient_step requests it (reverse communication):
 *
 *   const double *x;
 *   while ((request = obc_projected_gradient_step(solver, &x)) > 0 && request != OBC_PROJECTED_GRADIENT_DONE)
 *     if (request == OBC_PROJECTED_GRADIENT_NEED_FG) obc_projected_gradient_tell(solver, f(x), gradient(x), NULL);
 *
 * Memory: about (14 + 2 memory) n numbers for FACE and 9 n for DISSERTATION; with rows 2 n more, A twice and the factor of A A'. All of
 * it is allocated by _create and _load. An iteration takes O(n (memory^2 + entries of A)) time. For n <= 4 memory with bounds only, FACE
 * keeps a full matrix of 3 memory pairs: (14 + 6 memory + 2 n) n numbers.
 *
 * Thread safety: a solver serves one thread at a time; distinct solvers may run at the same time. All work is done on the calling
 * thread.
 *
 * Example: minimizes (x0 - 3)^2 + (x1 - 1)^2 subject to x0 + x1 = 2 and 0 <= x <= 1.5.
 *
 *   #include <orbicube/projected_gradient.h>
 *   #include <stdio.h>
 *
 *   static int32_t f(const double *x, size_t n, double *value, double *gradient, void *user) {
 *     (void)n, (void)user;
 *     *value = (x[0] - 3) * (x[0] - 3) + (x[1] - 1) * (x[1] - 1);
 *     gradient[0] = 2 * (x[0] - 3), gradient[1] = 2 * (x[1] - 1);
 *     return OBC_PROJECTED_GRADIENT_CONTINUE;
 *   }
 *
 *   int main(void) {
 *     const double lower[] = {0, 0}, upper[] = {1.5, 1.5}, row[] = {1, 1}, b[] = {2};
 *     const size_t row_start[] = {0, 2};
 *     const uint32_t column[] = {0, 1};
 *     double x[] = {0, 0};
 *     obc_projected_gradient_problem problem;
 *     obc_projected_gradient_problem_init(&problem, sizeof problem);
 *     problem.n = 2, problem.lower = lower, problem.upper = upper;
 *     problem.m = 1, problem.row_start = row_start, problem.column = column, problem.value = row, problem.b = b;
 *     if (obc_projected_gradient_minimize(&problem, NULL, f, NULL, x, NULL, NULL, NULL) != OBC_OK) return 1;
 *     printf("%g %g\n", x[0], x[1]); // 1.5 0.5
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_PROJECTED_GRADIENT_H
#define ORBICUBE_PROJECTED_GRADIENT_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- constants ------------------------------------------------------------------------------------------------------- */

/* A run of the method. */
typedef struct obc_projected_gradient obc_projected_gradient;

/* Methods. */
enum {
  OBC_PROJECTED_GRADIENT_FACE = 0, /* active face of a quasi-Newton model */
  OBC_PROJECTED_GRADIENT_DISSERTATION = 1  /* the dissertation's section 4.3.1, for comparison */
};

/* Nonmonotone line searches of DISSERTATION. */
enum {
  OBC_PROJECTED_GRADIENT_MAX_OF_LAST = 0, /* Grippo, Lampariello, Lucidi: below the largest of the last values */
  OBC_PROJECTED_GRADIENT_AVERAGE = 1          /* Zhang and Hager: below a weighted mean of all values */
};

/* Requests of obc_projected_gradient_step. */
enum {
  OBC_PROJECTED_GRADIENT_NEED_FG = 1,   /* evaluate f and its gradient at x, then call _tell */
  OBC_PROJECTED_GRADIENT_ITERATION = 2, /* x is a new iterate, evaluated or interpolated; requires no action */
  OBC_PROJECTED_GRADIENT_DONE = 3       /* the run has ended; see _get_result */
};

/* Stop codes: how a run ended. obc_projected_gradient_stop_name has their names. */
enum {
  OBC_PROJECTED_GRADIENT_RUNNING = 0,            /* not ended */
  OBC_PROJECTED_GRADIENT_CONVERGED = 1,          /* |P(x - g) - x|inf <= gradient_tolerance */
  OBC_PROJECTED_GRADIENT_TARGET_REACHED = 2,     /* f <= target */
  OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET = 3,  /* max_evaluations reached */
  OBC_PROJECTED_GRADIENT_ITERATION_BUDGET = 4,   /* max_iterations reached */
  OBC_PROJECTED_GRADIENT_STALLED = 5,            /* no step that double precision resolves lowers f: f is at its rounding
                                                    floor, or the gradient is wrong; see _check_gradient */
  OBC_PROJECTED_GRADIENT_INFEASIBLE = 6,         /* no x satisfies the constraints; see _certificate */
  OBC_PROJECTED_GRADIENT_CANCELLED = 7,          /* by the host's progress callback or by the callback f */
  OBC_PROJECTED_GRADIENT_EVALUATION_FAILED = 8,  /* f is not finite at the start, or along two whole directions */
  OBC_PROJECTED_GRADIENT_PROJECTION_FAILED = 9,  /* the caller's projection failed, or the rows cannot be satisfied */
  OBC_PROJECTED_GRADIENT_UNBOUNDED = 10          /* f decreases without bound along a direction, or is below -1e200 */
};

/* Return values of a callback f. */
enum {
  OBC_PROJECTED_GRADIENT_CONTINUE = 0, /* value and gradient are set */
  OBC_PROJECTED_GRADIENT_STOP = 1,     /* end the run as CANCELLED with the best point so far. A finite value that is set as well
                                          counts; the gradient is unused */
  OBC_PROJECTED_GRADIENT_FAILED = 2    /* f is undefined at x; the method continues elsewhere */
};

/* ---- problem, options, result ---------------------------------------------------------------------------------------- */

/* Evaluates f at x: value and gradient (n entries). A value or entry that is not finite counts as FAILED. Returns one of the constants
 * above. */
typedef int32_t (*obc_projected_gradient_function)(const double *x, size_t n, double *value, double *gradient,
                                                   void *user);

/* Computes the point x (n entries) of a closed convex set nearest to y, which x does not overlap. The result must depend on y
 * alone. Returns 0, or another value on failure. */
typedef int32_t (*obc_projected_gradient_projection)(const double *y, size_t n, double *x, void *user);

/* The feasible set: either bounds and rows, or a projection of the caller. Arrays are copied. Fill with _problem_init, or with zeros
 * and struct_size, which is the same: in C99 {.struct_size = sizeof(obc_projected_gradient_problem), .n = 2}. */
typedef struct obc_projected_gradient_problem {
  uint32_t struct_size;

  size_t n; /* number of unknowns, at least 1. Default: 0, which must be set. */
  size_t m; /* number of rows of A; rows may be redundant. Default: 0. */

  const double *lower; /* n lower bounds, -infinity allowed; NULL: none. Starts and projected points are within 1e150. Default: NULL. */
  const double *upper; /* n upper bounds, infinity allowed; NULL: none. Default: NULL. */

  const size_t *row_start; /* m + 1 offsets into column and value: A by rows, each zero or of length 1e-150 to 1e150. Default: NULL. */
  const uint32_t *column;  /* column of each entry, below n; entries of one column in a row are summed. Default: NULL. */
  const double *value;     /* value of each entry, finite. Default: NULL. */
  const double *b;         /* right-hand side, m entries. Default: NULL. */

  obc_projected_gradient_projection project; /* projection in place of bounds and rows; NULL: none. Default: NULL. */
  void *project_user;                        /* passed to project. Default: NULL. */
} obc_projected_gradient_problem;

/* Options of a run. Fill with _options_init. */
typedef struct obc_projected_gradient_options {
  uint32_t struct_size;

  int32_t method;        /* OBC_PROJECTED_GRADIENT_FACE or DISSERTATION. Default: FACE. */
  int32_t line_search;   /* line search of DISSERTATION. Default: MAX_OF_LAST. */
  uint32_t memory;       /* number of pairs in the model of FACE, 1 to 1000; 3 times as many are kept for n <= 4 memory with bounds
                          * only. Default: 10. */
  uint32_t history;      /* number of values that MAX_OF_LAST considers. Default: 10. */
  double average_weight; /* eta of AVERAGE, 0 (monotone) to 1. Default: 0.85. */

  double gradient_tolerance; /* tolerance of |P(x - g) - x|inf, the projected gradient. Default: 1e-8. */
  double target;             /* ends the run at f <= target. Default: -infinity. */
  uint64_t max_evaluations;  /* maximum number of evaluations. Default: 100000. */
  uint64_t max_iterations;   /* maximum number of iterations. Default: 100000. */
} obc_projected_gradient_options;

/* State of a run. The caller sets struct_size. */
typedef struct obc_projected_gradient_result {
  uint32_t struct_size;
  int32_t stop; /* stop code, OBC_PROJECTED_GRADIENT_RUNNING or another */

  double value;              /* f at the returned point; NaN before the first value */
  double projected_gradient; /* |P(x - g) - x|inf at the current iterate, without the rounding of x - g for large x */
  double equality_residual;  /* maximum over the rows of |a'x - b| / (|b| + sum |a_j x_j|) at the returned point */

  uint64_t evaluations;        /* number of evaluations, including failed ones */
  uint64_t failed_evaluations; /* number of evaluations without a value */
  uint64_t iterations;         /* number of iterations */
  uint64_t projection_passes;  /* number of passes over the unknowns in all projections */
  double certificate_gap;      /* see _certificate */
} obc_projected_gradient_result;

/* Fills a problem with n = m = 0 and no bounds. */
OBC_API obc_status obc_projected_gradient_problem_init(obc_projected_gradient_problem *problem, size_t struct_size);

/* Fills options with the defaults. */
OBC_API obc_status obc_projected_gradient_options_init(obc_projected_gradient_options *options, size_t struct_size);

/* ---- a run by reverse communication ---------------------------------------------------------------------------------- */

/* Creates a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
 * host points to must remain valid until _destroy. An empty feasible set ends the run as INFEASIBLE at the first step.
 * Errors: invalid argument, out of memory. */
OBC_API obc_status obc_projected_gradient_create(const obc_projected_gradient_problem *problem,
                                                 const obc_projected_gradient_options *options, const double *x0,
                                                 const obc_host *host, obc_projected_gradient **out, obc_error *error);

/* Advances to the next request and returns it: NEED_FG, ITERATION or DONE, or a negative obc_status for NULL or after a defect. *x
 * (x may be NULL) is the point of the request, n entries in memory of the solver, valid until its next call. While a request
 * waits for _tell, and after DONE, the same request is returned. */
OBC_API int32_t obc_projected_gradient_step(obc_projected_gradient *solver, const double **x);

/* Supplies value and gradient for NEED_FG. An entry that is not finite means that f is undefined there; gradient may then be
 * NULL. Errors: invalid argument if no request waits. */
OBC_API obc_status obc_projected_gradient_tell(obc_projected_gradient *solver, double value, const double *gradient,
                                               obc_error *error);

/* Copies the current state at any time: result (or NULL), and x (n entries, or NULL). x is the iterate that satisfies the tolerance
 * if the run CONVERGED, otherwise the lowest feasible point evaluated, and before the first value the projected start.
 * Errors: invalid argument. */
OBC_API obc_status obc_projected_gradient_get_result(const obc_projected_gradient *solver,
                                                     obc_projected_gradient_result *result, double *x,
                                                     obc_error *error);

/* Copies the Lagrange multipliers t of the rows (m entries) at the current iterate. At a solution gradient - A't is zero where
 * lower < x < upper, nonnegative at lower and nonpositive at upper. Errors: invalid argument. */
OBC_API obc_status obc_projected_gradient_multipliers(const obc_projected_gradient *solver, double *multipliers,
                                                      obc_error *error);

/* Copies a certificate of infeasibility (Farkas) after INFEASIBLE: m numbers c with c'A x < c'b for every x within the bounds, where
 * entries of A'c below 1e-9 |c| count as zero against an infinite bound. certificate_gap of the result is c'b - max c'A x > 0.
 * Errors: invalid argument after any other end. */
OBC_API obc_status obc_projected_gradient_certificate(const obc_projected_gradient *solver, double *certificate,
                                                      obc_error *error);

/* Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
 * least that. load creates a solver that continues with the same bits and the saved options. The problem must be that of the
 * saved run; a projection of the caller is taken from it. Both machines need the same byte order.
 * Errors: invalid argument (another problem), malformed file (damaged, or of another version), out of memory. */
OBC_API size_t obc_projected_gradient_save_size(const obc_projected_gradient *solver);
OBC_API obc_status obc_projected_gradient_save(const obc_projected_gradient *solver, void *blob, size_t capacity,
                                               obc_error *error);
OBC_API obc_status obc_projected_gradient_load(const obc_projected_gradient_problem *problem, const void *blob,
                                               size_t size, const obc_host *host, obc_projected_gradient **out,
                                               obc_error *error);

/* Destroys a solver; NULL is allowed. */
OBC_API void obc_projected_gradient_destroy(obc_projected_gradient *solver);

/* ---- a run with a callback, projection, gradient check --------------------------------------------------------------- */

/* Runs to the end with a callback. x (n entries) is the start and receives the point of _get_result; result may be NULL.
 * Returns OBC_OK however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result
 * are filled in that case too. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_projected_gradient_minimize(const obc_projected_gradient_problem *problem,
                                                   const obc_projected_gradient_options *options,
                                                   obc_projected_gradient_function f, void *user, double *x,
                                                   obc_projected_gradient_result *result, const obc_host *host,
                                                   obc_error *error);

/* Computes the point x (n entries, not y) of the feasible set nearest to y. Bounds: clipping. One row: the root of a monotone
 * piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh 2018).
 * multipliers (m entries, or NULL) receives t with x = clip(y + A't), up to a last correction along the free unknowns
 * where y is too large for t to resolve it. result (or NULL) receives equality_residual, projection_passes, certificate_gap and
 * stop: CONVERGED, PROJECTION_FAILED, or INFEASIBLE, for which multipliers receives the certificate.
 * Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_projected_gradient_project(const obc_projected_gradient_problem *problem, const double *y,
                                                  double *x, double *multipliers,
                                                  obc_projected_gradient_result *result, const obc_host *host,
                                                  obc_error *error);

/* Comparison of a gradient with finite differences. The caller sets struct_size. */
typedef struct obc_projected_gradient_check {
  uint32_t struct_size;
  int32_t agrees; /* 1: each compared entry agrees to 1e-4 or to the accuracy of the differences; 0: some entry does not */

  size_t worst;       /* entry of the gradient with the largest error */
  double told;        /* this entry as f returns it */
  double difference;  /* this entry by differences of f */
  double error;       /* |`told` - `difference`|, less 5 uncertainties, over the larger of the two */
  double uncertainty; /* of `difference`, from two step lengths and the rounding of f */

  size_t compared;      /* number of compared entries; fixed unknowns, and entries where f is undefined on either side, are left out */
  uint64_t evaluations; /* number of evaluations of f: 1, and 4 to 8 an unknown */
} obc_projected_gradient_check;

/* Compares the gradient that f returns at x (n entries, moved into the bounds) with differences of its values along each axis,
 * within the bounds and without regard to rows. Use it after a run that ended as STALLED. Errors: invalid argument (also: f has
 * no value or gradient at x), cancelled (by the host or by STOP). */
OBC_API obc_status obc_projected_gradient_check_gradient(const obc_projected_gradient_problem *problem,
                                                         obc_projected_gradient_function f, void *user, const double *x,
                                                         obc_projected_gradient_check *check, const obc_host *host,
                                                         obc_error *error);

/* Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL. */
OBC_API const char *obc_projected_gradient_stop_name(int32_t stop);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_projected_gradient_version(void);

#ifdef __cplusplus
}
#endif

#endif
