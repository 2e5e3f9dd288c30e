/* Orbicube trust region: minimises f(x), or a sum of squares sum_i sign_i r_i(x)^2 of residuals, subject to
 * lower <= x <= upper, from values alone: no derivatives.
 *
 * Method. Quadratics interpolate f (or each residual) at n + 2 to (n+1)(n+2)/2 points, with Hessians that change by the
 * least Frobenius norm (Powell 2004, 2006 NEWUOA, 2009 BOBYQA); residuals are modelled one by one (Zhang, Conn, Scheinberg
 * 2010 DFBOLS; Wild 2017 POUNDERS), squared and summed with their signs (the dissertation's eq. 4.15). Steps stay within a
 * trust-region radius; a second radius, the resolution, falls from radius_begin to radius_end and ends the run. SEED is
 * the dissertation's section 4.4.2 with its one radius; for comparison.
 *
 * Every x at which f is asked for satisfies the bounds to the bit. A value that is NaN or infinite counts as a failed
 * evaluation: the method goes on elsewhere.
 *
 * Use: fill a problem, then either call obc_trust_region_minimize with a callback, or make a solver and loop:
 *
 *   while ((request = obc_trust_region_step(solver, &x, &count)) > 0 && request != OBC_TRUST_REGION_DONE)
 *     if (request == OBC_TRUST_REGION_NEED_VALUES) obc_trust_region_tell(solver, outputs(x), NULL);
 *
 * Memory, n unknowns, m residuals (1 for f), p points: about 3 (n + p)^2 + m (2 n^2 + p) numbers, all of it allocated by
 * _create and _load. An iteration takes (n + p)^2 + p n^2 operations, with residuals m n^2 times some tens.
 *
 * Thread safety: a solver is used by one thread at a time; distinct solvers at the same time. Results do not depend on
 * threads: all work is done on the calling thread.
 */
#ifndef ORBICUBE_TRUST_REGION_H
#define ORBICUBE_TRUST_REGION_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A run of the method. */
typedef struct obc_trust_region obc_trust_region;

/* Which method. */
enum {
  OBC_TRUST_REGION_TWO_RADII = 0,
  OBC_TRUST_REGION_SEED = 1 /* the dissertation's radius rule */
};

/* The first points. */
enum {
  OBC_TRUST_REGION_AUTOMATIC = 0, /* CROSS for a scalar f with bounds, else CHAIN */
  OBC_TRUST_REGION_CHAIN = 1,     /* n + 1 points, each a step along an axis from the best so far */
  OBC_TRUST_REGION_CROSS = 2      /* x0 and steps to both sides along the axes, all asked for at once */
};

/* What a step wants. */
enum {
  OBC_TRUST_REGION_NEED_VALUES = 1, /* f, or the residuals, at each of count points; answer with _tell */
  OBC_TRUST_REGION_ITERATION = 2,   /* a step was taken into account; nothing to answer */
  OBC_TRUST_REGION_DONE = 3         /* see _get_result */
};

/* How a run ended. Names from obc_trust_region_stop_name. */
enum {
  OBC_TRUST_REGION_RUNNING = 0,
  OBC_TRUST_REGION_CONVERGED = 1, /* the resolution reached radius_end and no step improves the models */
  OBC_TRUST_REGION_TARGET_REACHED = 2,
  OBC_TRUST_REGION_EVALUATION_BUDGET = 3,
  OBC_TRUST_REGION_NOISE_LIMIT = 4, /* the values around the best point differ by less than the noise */
  OBC_TRUST_REGION_STALLED = 5,     /* no set of points that the arithmetic resolves */
  OBC_TRUST_REGION_CANCELLED = 6,   /* by the host's progress callback, or by the callback f */
  OBC_TRUST_REGION_EVALUATION_FAILED = 7 /* no value at x0 of a CHAIN, or more than 20 + 2n failures in a row */
};

/* What a callback f answers. */
enum {
  OBC_TRUST_REGION_CONTINUE = 0,
  OBC_TRUST_REGION_STOP = 1,  /* end the run as cancelled; the best point so far is handed out */
  OBC_TRUST_REGION_FAILED = 2 /* f has no value at x; the method goes on elsewhere */
};

/* f, or the residuals (one or `residuals` entries of outputs), at x. An entry that is not finite counts as FAILED. */
typedef int32_t (*obc_trust_region_function)(const double *x, size_t n, double *outputs, void *user);

/* What is minimised; what is pointed at is copied. Fill with _problem_init first. */
typedef struct obc_trust_region_problem {
  uint32_t struct_size;
  size_t n;            /* unknowns, at least 1 */
  size_t residuals;    /* m, or 0: a scalar f */
  const double *lower; /* n entries, or NULL: none; infinities allowed; equal bounds fix an unknown */
  const double *upper;
  const double *scale; /* n typical magnitudes of the unknowns, 1e-150 to 1e150, or NULL: 1. Radii are lengths of (x - y) / scale */
  const double *sign;  /* m entries, 1 or -1, or NULL: 1. With a -1, f may have no minimum: give bounds or a target */
} obc_trust_region_problem;

/* Fill with _options_init. */
typedef struct obc_trust_region_options {
  uint32_t struct_size;
  int32_t method;           /* TWO_RADII */
  int32_t start;            /* AUTOMATIC */
  uint64_t points;          /* interpolated at most, n + 2 to (n+1)(n+2)/2: 0, which is the larger of 6n + 1 and 45, with
                               residuals of 2n + 1 and 91, or all that a full quadratic has where that is less; SEED 2n + 1 */
  double radius_begin;      /* of steps at the start: 0, a tenth of max(1, |x0 / scale|inf) */
  double radius_end;        /* of the resolution at the end, about the accuracy wanted of x / scale: 1e-8 */
  double target;            /* stop once f <= target: -infinity */
  double noise_absolute;    /* f is known to max(noise_absolute, noise_relative |f|) only: 0 */
  double noise_relative;    /* 0 */
  uint64_t restarts;        /* times to begin again around the best point, with another radius: 0 */
  uint64_t max_evaluations; /* 0: 500 (n + 1) */
} obc_trust_region_options;

/* What is known of a run; set struct_size before asking for it. */
typedef struct obc_trust_region_result {
  uint32_t struct_size;
  int32_t stop;        /* OBC_TRUST_REGION_RUNNING, ... */
  double value;        /* f at the best point; NaN before the first value */
  double radius;       /* of steps, now; without bounds along the longest axis of a trust region that is an ellipsoid */
  double resolution;
  uint64_t evaluations;
  uint64_t failed_evaluations;
  uint64_t iterations;
  uint64_t restarts;
  uint64_t points;     /* interpolated now */
  uint64_t rebuilds;   /* of the interpolation from scratch, because of rounding or a far move */
} obc_trust_region_result;

/* An empty problem: n = 0, a scalar f, no bounds. */
OBC_API obc_status obc_trust_region_problem_init(obc_trust_region_problem *problem, size_t struct_size);

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_trust_region_options_init(obc_trust_region_options *options, size_t struct_size);

/* Makes a solver that starts at x0 (n entries, x0 / scale within 1e150), moved into the bounds. options and host may be NULL; what the host points at
 * must stay valid until _destroy. Errors: invalid argument, out of memory. */
OBC_API obc_status obc_trust_region_create(const obc_trust_region_problem *problem,
                                           const obc_trust_region_options *options, const double *x0,
                                           const obc_host *host, obc_trust_region **out, obc_error *error);

/* Gives evaluations made before, `count` points (count x n, row by row, within the bounds) with their outputs (count, or
 * count x m): before the first step. They do not count against max_evaluations. The run begins at the lowest of them
 * instead of x0, and uses those near it in the place of evaluations of its own; of more than it can interpolate it keeps
 * the lowest. Errors: invalid argument (also for an output that is not finite). */
OBC_API obc_status obc_trust_region_give(obc_trust_region *solver, const double *points, const double *outputs,
                                         size_t count, obc_error *error);

/* Goes on to the next request: NEED_VALUES, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a
 * defect. With NEED_VALUES, *points (may be NULL) is what is asked for: *count (may be NULL) rows of n entries, in the
 * solver's memory until its next call other than _tell. Rows may be evaluated at the same time; there is one, but at the
 * start of a CROSS. Until each is answered by _tell, and after DONE, the answer stays the same, less the rows told. */
OBC_API int32_t obc_trust_region_step(obc_trust_region *solver, const double **points, size_t *count);

/* Answers NEED_VALUES at the first of the points asked for: f, or m residuals. Not finite, or outputs NULL: f cannot be
 * evaluated there. Errors: invalid argument when nothing was asked. */
OBC_API obc_status obc_trust_region_tell(obc_trust_region *solver, const double *outputs, obc_error *error);

/* What is known now, at any time: result (or NULL), and the lowest point evaluated, x (n entries, or NULL) with its outputs (1
 * or m, or NULL; NaN before the first value). Before the first value x is the start. */
OBC_API obc_status obc_trust_region_get_result(const obc_trust_region *solver, obc_trust_region_result *result,
                                               double *x, double *outputs, obc_error *error);

/* A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
 * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run, the
 * options are those of the saved run. For machines of the same byte order. Errors: invalid argument (another problem),
 * malformed file (damaged, or of another version). */
OBC_API size_t obc_trust_region_save_size(const obc_trust_region *solver);
OBC_API obc_status obc_trust_region_save(const obc_trust_region *solver, void *blob, size_t capacity, obc_error *error);
OBC_API obc_status obc_trust_region_load(const obc_trust_region_problem *problem, const void *blob, size_t size,
                                         const obc_host *host, obc_trust_region **out, obc_error *error);

/* Frees a solver; NULL is fine. */
OBC_API void obc_trust_region_destroy(obc_trust_region *solver);

/* Runs to the end with a callback. x (n entries) is the start and receives the best point; result may be NULL. Errors:
 * invalid argument, out of memory, cancelled (by the host; x and result are filled). How the run ended is result's stop.
 */
OBC_API obc_status obc_trust_region_minimize(const obc_trust_region_problem *problem,
                                             const obc_trust_region_options *options, obc_trust_region_function f,
                                             void *user, double *x, obc_trust_region_result *result,
                                             const obc_host *host, obc_error *error);

/* Short English name of an end, such as "converged". Never NULL; a static string. */
OBC_API const char *obc_trust_region_stop_name(int32_t stop);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_trust_region_version(void);

#ifdef __cplusplus
}
#endif

#endif
