/* Orbicube projected gradient: min f(x) subject to A x = b and lower <= x <= upper, for a smooth f with its gradient and a
 * sparse A, from one to millions of unknowns. Also the projection onto such a set alone.
 *
 * Methods. FACE (the default): projected Barzilai-Borwein steps on a limited-memory quasi-Newton model of f find the face
 * of the feasible set, the model's exact minimiser in that face is the step (the two phases of Hager and Zhang 2006 on
 * the model of Byrd, Lu, Nocedal, Zhu 1995; the line search of Hager and Zhang 2005). SEED: the projected
 * Barzilai-Borwein method of the dissertation's section 4.3.1 (eq. 4.11 to 4.13) with the nonmonotone searches of
 * Grippo, Lampariello, Lucidi 1986 or of Zhang and Hager 2004; for comparison.
 *
 * Every x at which f is asked for satisfies the bounds to the bit and A x = b to rounding.
 *
 * Use: fill a problem, then either call obc_projected_gradient_minimize with a callback, or make a solver and loop:
 *
 *   const double *x;
 *   while ((request = obc_projected_gradient_step(solver, &x)) > 0 && request != OBC_PROJECTED_GRADIENT_DONE)
 *     if (request == OBC_PROJECTED_GRADIENT_NEED_FG) obc_projected_gradient_tell(solver, f(x), gradient(x), NULL);
 *
 * Memory: about (14 + 2 memory) n numbers for FACE and 9 n for SEED, with rows 2 n more, A twice and the factor of A A'; all of it is
 * allocated by _create and _load. Each iteration takes time proportional to n (memory^2 + entries of A) at most.
 *
 * Thread safety: a solver is used by one thread at a time; distinct solvers at the same time. Results do not depend on
 * threads: all work is done on the calling thread.
 */
#ifndef ORBICUBE_PROJECTED_GRADIENT_H
#define ORBICUBE_PROJECTED_GRADIENT_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A run of the method. */
typedef struct obc_projected_gradient obc_projected_gradient;

/* Which method. */
enum {
  OBC_PROJECTED_GRADIENT_FACE = 0,
  OBC_PROJECTED_GRADIENT_SEED = 1
};

/* The nonmonotone line search of SEED. */
enum {
  OBC_PROJECTED_GRADIENT_LARGEST_OF_LAST = 0, /* Grippo, Lampariello, Lucidi: below the largest of the last values */
  OBC_PROJECTED_GRADIENT_AVERAGE = 1          /* Zhang and Hager: below a weighted mean of all values */
};

/* What a step wants. */
enum {
  OBC_PROJECTED_GRADIENT_NEED_FG = 1,   /* value and gradient of f at x; answer with _tell */
  OBC_PROJECTED_GRADIENT_ITERATION = 2, /* x is a new iterate; nothing to answer */
  OBC_PROJECTED_GRADIENT_DONE = 3       /* see _result */
};

/* How a run ended. Names from obc_projected_gradient_stop_name. */
enum {
  OBC_PROJECTED_GRADIENT_RUNNING = 0,
  OBC_PROJECTED_GRADIENT_CONVERGED = 1,          /* |P(x - g) - x|inf <= gradient_tolerance */
  OBC_PROJECTED_GRADIENT_TARGET_REACHED = 2,     /* f <= target */
  OBC_PROJECTED_GRADIENT_EVALUATION_BUDGET = 3,
  OBC_PROJECTED_GRADIENT_ITERATION_BUDGET = 4,
  OBC_PROJECTED_GRADIENT_STALLED = 5,            /* no step that the arithmetic resolves improves f */
  OBC_PROJECTED_GRADIENT_INFEASIBLE = 6,         /* no x satisfies the constraints; see _certificate */
  OBC_PROJECTED_GRADIENT_CANCELLED = 7,          /* by the host's progress callback, or by the callback f */
  OBC_PROJECTED_GRADIENT_EVALUATION_FAILED = 8,  /* f not finite at the start, or all along two directions */
  OBC_PROJECTED_GRADIENT_PROJECTION_FAILED = 9   /* the caller's projection failed, or the rows could not be met */
};

/* What a callback f answers. */
enum {
  OBC_PROJECTED_GRADIENT_CONTINUE = 0,
  OBC_PROJECTED_GRADIENT_STOP = 1,  /* end the run as cancelled; the best point so far is handed out */
  OBC_PROJECTED_GRADIENT_FAILED = 2 /* f has no value at x; the method goes on elsewhere */
};

/* Value and gradient (n entries) of f at x. A value or entry that is not finite counts as FAILED. */
typedef int32_t (*obc_projected_gradient_function)(const double *x, size_t n, double *value, double *gradient,
                                                   void *user);

/* The point x (n entries) of a closed convex set that is nearest to y; x and y do not overlap. Answers 0, or anything else
 * when it cannot. Must depend on y alone. */
typedef int32_t (*obc_projected_gradient_projection)(const double *y, size_t n, double *x, void *user);

/* The feasible set; what is pointed at is copied. Fill with _problem_init first. Either bounds and rows, or a projection
 * of the caller's own. Rows may be redundant. */
typedef struct obc_projected_gradient_problem {
  uint32_t struct_size;
  size_t n;                 /* unknowns, at least 1 */
  size_t m;                 /* rows of A, or 0 */
  const double *lower;      /* n entries, or NULL: none; infinities allowed. Starts and points to project are within 1e150 */
  const double *upper;
  const size_t *row_start;  /* m + 1 offsets into column and value: A by rows, each zero or of length 1e-150 to 1e150 */
  const uint32_t *column;   /* entries of the same column in a row are summed */
  const double *value;
  const double *b;          /* m entries */
  obc_projected_gradient_projection project; /* or NULL */
  void *project_user;
} obc_projected_gradient_problem;

/* Fill with _options_init. */
typedef struct obc_projected_gradient_options {
  uint32_t struct_size;
  int32_t method;            /* FACE */
  int32_t line_search;       /* of SEED: LARGEST_OF_LAST */
  uint32_t memory;           /* pairs of the model of FACE, 1 to 1000: 10 */
  uint32_t history;          /* values that LARGEST_OF_LAST looks back on: 10 */
  double average_weight;     /* eta of AVERAGE, 0 (monotone) to 1: 0.85 */
  double gradient_tolerance; /* on the projected gradient |P(x - g) - x|inf: 1e-8 */
  double target;             /* stop once f <= target: -infinity */
  uint64_t max_evaluations;  /* 100000 */
  uint64_t max_iterations;   /* 100000 */
} obc_projected_gradient_options;

/* What is known of a run; set struct_size before asking for it. */
typedef struct obc_projected_gradient_result {
  uint32_t struct_size;
  int32_t stop;              /* OBC_PROJECTED_GRADIENT_RUNNING, ... */
  double value;              /* f at the point handed out; NaN before the first value */
  double projected_gradient; /* |P(x - g) - x|inf at the current iterate */
  double equality_residual;  /* largest |a'x - b| / (|b| + sum |a_j x_j|) of a row at the point handed out */
  uint64_t evaluations;
  uint64_t failed_evaluations;
  uint64_t iterations;
  uint64_t projection_passes; /* over the unknowns, in all projections */
  double certificate_gap;     /* see _certificate */
} obc_projected_gradient_result;

/* An empty problem: n = m = 0, no bounds. */
OBC_API obc_status obc_projected_gradient_problem_init(obc_projected_gradient_problem *problem, size_t struct_size);

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_projected_gradient_options_init(obc_projected_gradient_options *options, size_t struct_size);

/* Makes a solver that starts from the feasible point nearest to x0 (n entries). options and host may be NULL; what the
 * host points at must stay valid until _destroy. Errors: invalid argument, out of memory. An empty feasible set is not an
 * error here: the first step ends the run as INFEASIBLE. */
OBC_API obc_status obc_projected_gradient_create(const obc_projected_gradient_problem *problem,
                                                 const obc_projected_gradient_options *options, const double *x0,
                                                 const obc_host *host, obc_projected_gradient **out, obc_error *error);

/* Goes on to the next request: NEED_FG, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a defect.
 * *x (x may be NULL) is the point that is asked about, n entries of the solver's, valid until its next call. While a
 * request waits for _tell, and after DONE, the answer stays the same. */
OBC_API int32_t obc_projected_gradient_step(obc_projected_gradient *solver, const double **x);

/* Answers NEED_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be
 * NULL then. Errors: invalid argument when nothing was asked. */
OBC_API obc_status obc_projected_gradient_tell(obc_projected_gradient *solver, double value, const double *gradient,
                                               obc_error *error);

/* What is known now, at any time: result (or NULL), and x (n entries, or NULL), which is the iterate that met the tolerance
 * if the run CONVERGED, else the lowest feasible point evaluated, and before that the projected start. */
OBC_API obc_status obc_projected_gradient_get_result(const obc_projected_gradient *solver,
                                                     obc_projected_gradient_result *result, double *x,
                                                     obc_error *error);

/* Multipliers t of the rows (m entries) at the current iterate: at a solution gradient - A't is zero where
 * lower < x < upper, not negative at lower and not positive at upper. */
OBC_API obc_status obc_projected_gradient_multipliers(const obc_projected_gradient *solver, double *multipliers,
                                                      obc_error *error);

/* After INFEASIBLE: m numbers c with c'A x < c'b for every x within the bounds (Farkas), where entries of A'c that are
 * rounding (1e-9 of the length of c) count as zero against an infinite bound. certificate_gap of the result is
 * c'b - max c'A x > 0. Invalid argument after any other end. */
OBC_API obc_status obc_projected_gradient_certificate(const obc_projected_gradient *solver, double *certificate,
                                                      obc_error *error);

/* A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
 * that). load makes a solver from them that goes on with the same bits; the problem must be the one of the saved run
 * (a projection of the caller's is taken from it). The options are those of the saved run. For machines of the same byte
 * order. Errors: invalid argument (another problem), malformed file (damaged, or of another version). */
OBC_API size_t obc_projected_gradient_save_size(const obc_projected_gradient *solver);
OBC_API obc_status obc_projected_gradient_save(const obc_projected_gradient *solver, void *blob, size_t capacity,
                                               obc_error *error);
OBC_API obc_status obc_projected_gradient_load(const obc_projected_gradient_problem *problem, const void *blob,
                                               size_t size, const obc_host *host, obc_projected_gradient **out,
                                               obc_error *error);

/* Releases a solver; NULL is fine. */
OBC_API void obc_projected_gradient_destroy(obc_projected_gradient *solver);

/* The loop over step with a callback: x (n entries) holds the start and gets what _get_result hands out; result may be
 * NULL. Answers OBC_OK however the run ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and result
 * are filled then as well. */
OBC_API obc_status obc_projected_gradient_minimize(const obc_projected_gradient_problem *problem,
                                                   const obc_projected_gradient_options *options,
                                                   obc_projected_gradient_function f, void *user, double *x,
                                                   obc_projected_gradient_result *result, const obc_host *host,
                                                   obc_error *error);

/* The projection alone: x (n entries, not y) is the point of the feasible set nearest to y. Box: clipping. One row: a root
 * of a monotone piecewise linear function (Dai and Fletcher 2006). More rows: semismooth Newton on the dual (Li, Sun, Toh
 * 2018). multipliers (m entries, or NULL) gets t with x = clip(y + A't), up to a last correction along the free unknowns
 * where y is so large that t cannot resolve it. Of result (or NULL) stop, equality_residual, projection_passes and
 * certificate_gap are filled: stop is CONVERGED, PROJECTION_FAILED, or INFEASIBLE, when multipliers gets the certificate. */
OBC_API obc_status obc_projected_gradient_project(const obc_projected_gradient_problem *problem, const double *y,
                                                  double *x, double *multipliers,
                                                  obc_projected_gradient_result *result, const obc_host *host,
                                                  obc_error *error);

/* English name of a stop, such as "evaluation budget". Never NULL; a static string. */
OBC_API const char *obc_projected_gradient_stop_name(int32_t stop);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_projected_gradient_version(void);

#ifdef __cplusplus
}
#endif

#endif
