/* Orbicube trust region: minimizes f(x), or a sum of squares sum_i sign_i r_i(x)^2, a sum of magnitudes or the largest of
 * residuals, subject to lower <= x <= upper, from values alone, without derivatives.
 *
 * Method. Quadratic models interpolate f (or each residual) at n + 2 to (n+1)(n+2)/2 points; their Hessians change with minimum
 * Frobenius norm (Powell 2004, 2006 NEWUOA, 2009 BOBYQA). Residuals are modeled one by one (Zhang, Conn, Scheinberg 2010 DFBOLS;
 * Wild 2017 POUNDERS), squared and summed with their signs (the dissertation's eq. 4.15); for the other objectives steps minimize
 * that function of the models (Grapiglia, Yuan, Yuan 2016). Steps stay within a trust-region
 * radius; a second radius, the resolution, decreases from radius_begin to radius_end and ends the run. DISSERTATION, for comparison, is
 * the dissertation's section 4.4.2 with its single radius.
 *
 * Every x at which f is evaluated satisfies the bounds exactly. A value that is NaN or infinite counts as a failed evaluation: planes
 * between failed and other points keep steps inside the domain of f, and steps get shorter. A value out of all proportion,
 * such as a penalty, counts as failed once it does not decrease with the step length.
 *
 * Use. Fill a problem. Then call obc_trust_region_minimize with a callback, or create a solver and evaluate f whenever
 * obc_trust_region_step requests it (reverse communication):
 *
 *   while ((request = obc_trust_region_step(solver, &x, &count)) > 0 && request != OBC_TRUST_REGION_DONE)
 *     if (request == OBC_TRUST_REGION_NEED_VALUES) obc_trust_region_tell(solver, outputs(x), NULL);
 *
 * Memory, for n unknowns, m residuals (1 for f) and p points, of which there are at most max_evaluations: about
 * 3 (n + p)^2 + m (2 n^2 + p) numbers, or (n + m) p where max_evaluations is at most n. All of it is allocated by _create
 * and _load, or by the first _give, which reserves memory for all points. An iteration takes (n + p)^2 + p n^2 operations,
 * with residuals m n^2 times some tens.
 *
 * Thread safety: a solver serves one thread at a time; distinct solvers may run at the same time. All work is done on the calling
 * thread.
 *
 * Example: minimizes Rosenbrock's function as a sum of two squares.
 *
 *   #include <orbicube/trust_region.h>
 *   #include <stdio.h>
 *
 *   static int32_t f(const double *x, size_t n, double *outputs, void *user) {
 *     (void)n, (void)user;
 *     outputs[0] = 10 * (x[1] - x[0] * x[0]);
 *     outputs[1] = 1 - x[0];
 *     return OBC_TRUST_REGION_CONTINUE;
 *   }
 *
 *   int main(void) {
 *     double x[] = {-1.2, 1};
 *     obc_trust_region_problem problem;
 *     obc_trust_region_problem_init(&problem, sizeof problem);
 *     problem.n = 2, problem.residuals = 2;
 *     if (obc_trust_region_minimize(&problem, NULL, f, NULL, x, NULL, NULL, NULL) != OBC_OK) return 1;
 *     printf("%.6f %.6f\n", x[0], x[1]); // 1 1
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_TRUST_REGION_H
#define ORBICUBE_TRUST_REGION_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- constants ------------------------------------------------------------------------------------------------------- */

/* A run of the method. */
typedef struct obc_trust_region obc_trust_region;

/* Methods. */
enum {
  OBC_TRUST_REGION_TWO_RADII = 0, /* radius of steps and resolution */
  OBC_TRUST_REGION_DISSERTATION = 1       /* the dissertation's radius rule, for comparison */
};

/* Initial interpolation points. */
enum {
  OBC_TRUST_REGION_AUTOMATIC = 0, /* CROSS for a scalar f with bounds, otherwise CHAIN */
  OBC_TRUST_REGION_CHAIN = 1,     /* n + 1 points, each one step along an axis from the best so far */
  OBC_TRUST_REGION_CROSS = 2      /* x0 and steps to both sides along the axes, all requested at once */
};

/* Objectives: f of the residuals. */
enum {
  OBC_TRUST_REGION_SUM_OF_SQUARES = 0,    /* sum_i sign_i r_i^2 */
  OBC_TRUST_REGION_SUM_OF_MAGNITUDES = 1, /* sum_i |r_i|: L1 fits */
  OBC_TRUST_REGION_MAX_MAGNITUDE = 2,     /* max_i |r_i|: Chebyshev fits */
  OBC_TRUST_REGION_MAX_VALUE = 3          /* max_i r_i: minimax problems */
};

/* Requests of obc_trust_region_step. */
enum {
  OBC_TRUST_REGION_NEED_VALUES = 1, /* evaluate f, or the residuals, at each of *count points, then call _tell */
  OBC_TRUST_REGION_ITERATION = 2,   /* a step is complete; requires no action */
  OBC_TRUST_REGION_DONE = 3         /* the run has ended; see _get_result */
};

/* Stop codes: how a run ended. obc_trust_region_stop_name has their names. */
enum {
  OBC_TRUST_REGION_RUNNING = 0,           /* not ended */
  OBC_TRUST_REGION_CONVERGED = 1,         /* the resolution reached radius_end, and no step improves the models */
  OBC_TRUST_REGION_TARGET_REACHED = 2,    /* f <= target */
  OBC_TRUST_REGION_EVALUATION_BUDGET = 3, /* max_evaluations reached */
  OBC_TRUST_REGION_NOISE_LIMIT = 4,       /* the values around the best point differ by less than the noise */
  OBC_TRUST_REGION_STALLED = 5,           /* no set of points that double precision resolves */
  OBC_TRUST_REGION_CANCELLED = 6,         /* by the host's progress callback or by the callback f */
  OBC_TRUST_REGION_EVALUATION_FAILED = 7, /* no value at x0 of a CHAIN, or more than 80 + 8n (DISSERTATION: 20 + 2n) failures in a row */
  OBC_TRUST_REGION_RESOLUTION_LIMIT = 8   /* the resolution reached radius_end while the models still have a descent direction: at the
                                             boundary of the domain of f, where f is not smooth, or where the given scale is
                                             far from the lengths over which f bends */
};

/* Return values of a callback f. */
enum {
  OBC_TRUST_REGION_CONTINUE = 0, /* outputs are set */
  OBC_TRUST_REGION_STOP = 1,     /* end the run as CANCELLED with the best point so far. Outputs that are set as well count if all
                                    of them are finite */
  OBC_TRUST_REGION_FAILED = 2    /* f is undefined at x; the method continues elsewhere */
};

/* ---- problem, options, result ---------------------------------------------------------------------------------------- */

/* Evaluates f, or the residuals, at x: 1 or `residuals` entries of outputs. An entry that is not finite counts as FAILED. Returns one
 * of the constants above. */
typedef int32_t (*obc_trust_region_function)(const double *x, size_t n, double *outputs, void *user);

/* The problem. Arrays are copied. Fill with _problem_init, or with zeros and struct_size, which is the same: in C99
 * {.struct_size = sizeof(obc_trust_region_problem), .n = 2}. */
typedef struct obc_trust_region_problem {
  uint32_t struct_size;

  size_t n;         /* number of unknowns, at least 1. Default: 0, which must be set. */
  size_t residuals; /* number m of residuals; 0: a scalar f. Default: 0. */

  const double *lower; /* n lower bounds, -infinity allowed; NULL: none. Equal bounds fix an unknown. Default: NULL. */
  const double *upper; /* n upper bounds, infinity allowed; NULL: none. Default: NULL. */

  /* Typical magnitudes of the unknowns, n entries from 1e-150 to 1e150; radii are lengths of (x - y) / scale. NULL: 1 for unknowns of
   * like magnitude. NULL where the widths of boxes differ by more than 10, one is below 0.01, or magnitudes of x0 differ by more
   * than 1e4: upper - lower, and for unknowns without two bounds the larger distance of x0 from 0 and from its bound. NULL
   * with a radius_begin: the width over that of the narrowest box, and 1 without two bounds. Default: NULL. */
  const double *scale;

  const double *sign; /* m signs of the squares, 1 or -1; NULL: 1. With a -1 f may have no minimum without bounds or a target. Default: NULL. */

  int32_t objective; /* OBC_TRUST_REGION_SUM_OF_SQUARES or another, which needs residuals and no sign. Default: SUM_OF_SQUARES. */
} obc_trust_region_problem;

/* Options of a run. Fill with _options_init. */
typedef struct obc_trust_region_options {
  uint32_t struct_size;

  int32_t method; /* OBC_TRUST_REGION_TWO_RADII or DISSERTATION. Default: TWO_RADII. */
  int32_t start;  /* initial points, OBC_TRUST_REGION_AUTOMATIC, CHAIN or CROSS. Default: AUTOMATIC. */

  /* Maximum number of interpolation points, n + 2 to (n+1)(n+2)/2. 0: the larger of 6n + 1 and 45, with residuals of 2n + 1 and
   * 91, limited to the number for a full quadratic; DISSERTATION 2n + 1. Default: 0. */
  uint64_t points;

  double radius_begin; /* initial radius of steps. 0: a tenth of max(1, |x0 / scale|inf), or of 1 for a scale by boxes. Default: 0. */
  double radius_end;   /* final resolution, about the accuracy of x / scale. Default: 1e-8. */

  double target;         /* ends the run at f <= target. Default: -infinity. */
  double noise_absolute; /* the error of f is up to max(noise_absolute, noise_relative |f|). Default: 0. */
  double noise_relative; /* see noise_absolute. Default: 0. */

  /* Number of restarts around the best point with another radius. At the boundary of the domain of f, and where noise or the
   * resolution limit ends it, a run also restarts as long as that lowers f by a thousandth and by the noise. Default: 0. */
  uint64_t restarts;

  uint64_t max_evaluations; /* maximum number of evaluations; 0: 500 (n + 1). Default: 0. */
} obc_trust_region_options;

/* State of a run. The caller sets struct_size. */
typedef struct obc_trust_region_result {
  uint32_t struct_size;
  int32_t stop; /* stop code, OBC_TRUST_REGION_RUNNING or another */

  double value;      /* f at the best point; NaN before the first value */
  double radius;     /* current radius of steps; without bounds along the longest axis of the trust-region ellipsoid */
  double resolution; /* current resolution */

  uint64_t evaluations;        /* number of evaluations, including failed ones */
  uint64_t failed_evaluations; /* number of evaluations without a value */
  uint64_t iterations;         /* number of iterations */
  uint64_t restarts;           /* number of restarts */
  uint64_t points;             /* current number of interpolation points */
  uint64_t rebuilds;           /* number of times the interpolation was rebuilt, because of rounding or a long move */
} obc_trust_region_result;

/* Fills a problem with n = 0, a scalar f and no bounds. */
OBC_API obc_status obc_trust_region_problem_init(obc_trust_region_problem *problem, size_t struct_size);

/* Fills options with the defaults. */
OBC_API obc_status obc_trust_region_options_init(obc_trust_region_options *options, size_t struct_size);

/* ---- a run by reverse communication ---------------------------------------------------------------------------------- */

/* Creates a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL;
 * what the host points to must remain valid until _destroy. Errors: invalid argument, out of memory. */
OBC_API obc_status obc_trust_region_create(const obc_trust_region_problem *problem,
                                           const obc_trust_region_options *options, const double *x0,
                                           const obc_host *host, obc_trust_region **out, obc_error *error);

/* Supplies earlier evaluations before the first step: `count` points (count x n, row by row, within the bounds) with their outputs
 * (count, or count x m). They do not count against max_evaluations. The run starts at the lowest of them in place of x0 and
 * uses nearby ones in place of its own evaluations; of more points than it can interpolate it keeps the lowest.
 * Errors: invalid argument (also for an output that is not finite), out of memory. */
OBC_API obc_status obc_trust_region_give(obc_trust_region *solver, const double *points, const double *outputs,
                                         size_t count, obc_error *error);

/* Advances to the next request and returns it: NEED_VALUES, ITERATION or DONE, or a negative obc_status for NULL or after a
 * defect. With NEED_VALUES, *points (points may be NULL) are *count (count may be NULL) rows of n entries in memory of the solver,
 * valid until its next call other than _tell. The rows may be evaluated in parallel; there is one, except at the start of a
 * CROSS. Until _tell has supplied all of them, and after DONE, the same request is returned, without the supplied rows. */
OBC_API int32_t obc_trust_region_step(obc_trust_region *solver, const double **points, size_t *count);

/* Supplies f, or m residuals, at the first requested point. An entry that is not finite, or outputs NULL, means that f is
 * undefined there. Errors: invalid argument if no request waits. */
OBC_API obc_status obc_trust_region_tell(obc_trust_region *solver, const double *outputs, obc_error *error);

/* Copies the current state at any time: result (or NULL), and the lowest evaluated point, x (n entries, or NULL), with its outputs
 * (1 or m, or NULL; NaN before the first value). Before the first value x is the start. Errors: invalid argument. */
OBC_API obc_status obc_trust_region_get_result(const obc_trust_region *solver, obc_trust_region_result *result,
                                               double *x, double *outputs, obc_error *error);

/* Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
 * least that. load creates a solver that continues with the same bits and the saved options; the problem must be that of the
 * saved run. Both machines need the same byte order. Errors: invalid argument (another problem), malformed file (damaged,
 * or of another version), out of memory. */
OBC_API size_t obc_trust_region_save_size(const obc_trust_region *solver);
OBC_API obc_status obc_trust_region_save(const obc_trust_region *solver, void *blob, size_t capacity, obc_error *error);
OBC_API obc_status obc_trust_region_load(const obc_trust_region_problem *problem, const void *blob, size_t size,
                                         const obc_host *host, obc_trust_region **out, obc_error *error);

/* Destroys a solver; NULL is allowed. */
OBC_API void obc_trust_region_destroy(obc_trust_region *solver);

/* ---- a run with a callback ------------------------------------------------------------------------------------------- */

/* Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Returns OBC_OK
 * however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result are filled in that case
 * too. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_trust_region_minimize(const obc_trust_region_problem *problem,
                                             const obc_trust_region_options *options, obc_trust_region_function f,
                                             void *user, double *x, obc_trust_region_result *result,
                                             const obc_host *host, obc_error *error);

/* Returns the English name of a stop code, such as "converged"; a static string, never NULL. */
OBC_API const char *obc_trust_region_stop_name(int32_t stop);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_trust_region_version(void);

#ifdef __cplusplus
}
#endif

#endif
