/* Orbicube sphere optimizer: minimizes f over a product of N unit spheres in R^d: N blocks of d numbers, each of length 1 to within
 * 2 units in the last place wherever f is evaluated. Blocks are for example directions, quaternions (d = 4), rows of a factor of
 * a correlation matrix, or unit eigenvectors.
 *
 * All spheres at once, with value and gradient of f:
 *   LIMITED_MEMORY (default)  L-BFGS with parallel transport (Huang, Gallivan, Absil 2015), Wolfe search along geodesics
 *   BARZILAI_BORWEIN          nonmonotone Barzilai-Borwein steps (Iannazzo, Porcelli 2018); low memory
 *   GREAT_CIRCLE              the great-circle search of the dissertation's Algorithm 2 (section 3.1.4), corrected: it follows the
 *                             tangent gradient, starts from the length of the last step, and bisects the angle
 *   DISSERTATION              Algorithm 2 as printed, for comparison: the first arc ends at -G / |G| or its mirror image
 *   TRUNCATED_NEWTON          trust region with conjugate gradients that end early (Absil, Baker, Gallivan 2007), by products of the
 *                             Hessian that the host supplies, or by differences of gradients
 *
 *   const double *x;
 *   while ((request = obc_sphere_optimizer_step(solver, &x)) > 0 && request != OBC_SPHERE_OPTIMIZER_DONE)
 *     if (request == OBC_SPHERE_OPTIMIZER_NEED_FG) obc_sphere_optimizer_tell(solver, f(x), gradient(x), NULL);
 *
 * TRUNCATED_NEWTON is the fastest where a product of the Hessian costs no more than f and f is quadratic, such as relaxations of
 * max-cut; elsewhere LIMITED_MEMORY takes fewer evaluations than TRUNCATED_NEWTON takes evaluations and products.
 *
 * Block by block (obc_sphere_optimizer_relax, or _relaxation_run in parts), with the terms of f that contain one block: most promising
 * blocks first, then, when gains decrease slowly, in sweeps with over-relaxed steps (Young 1954). A step follows a great
 * circle or Newton's method. It suits an f that is a sum over neighbors with constraints on its values, or without a
 * gradient as a whole; all at once reaches high accuracy in fewer evaluations.
 *
 * Memory, in numbers, allocated by _create, _load and at the start of _relax: (7 + 2 memory) N d + 3 N for LIMITED_MEMORY,
 * 7 N d + 3 N for BARZILAI_BORWEIN and GREAT_CIRCLE, 9 N d + 3 N for DISSERTATION, 11 N d + 3 N for TRUNCATED_NEWTON, N d more for several starts; 18 bytes a block
 * for _relax. An iteration takes O(N d memory) time and usually 1.0 to 1.1 evaluations.
 *
 * Thread safety: a solver serves one thread at a time; distinct solvers may run at the same time. All work is done on the calling
 * thread.
 *
 * Example: finds the unit vector of minimum x^2 + 2 y^2 + 3 z^2.
 *
 *   #include <orbicube/sphere_optimizer.h>
 *   #include <stdio.h>
 *
 *   static int32_t f(const double *x, size_t count, size_t dimension, double *value, double *gradient, void *user) {
 *     (void)count, (void)dimension, (void)user;
 *     *value = x[0] * x[0] + 2 * x[1] * x[1] + 3 * x[2] * x[2];
 *     gradient[0] = 2 * x[0], gradient[1] = 4 * x[1], gradient[2] = 6 * x[2];
 *     return OBC_SPHERE_OPTIMIZER_CONTINUE;
 *   }
 *
 *   int main(void) {
 *     double x[] = {1, 1, 1}; // one block, scaled to length 1
 *     if (obc_sphere_optimizer_minimize(1, 3, NULL, f, NULL, x, NULL, NULL, NULL) != OBC_OK) return 1;
 *     printf("%.6f %.6f %.6f\n", x[0], x[1], x[2]); // 1 0 0
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_SPHERE_OPTIMIZER_H
#define ORBICUBE_SPHERE_OPTIMIZER_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- constants ------------------------------------------------------------------------------------------------------- */

/* A run of the all-at-once solver. */
typedef struct obc_sphere_optimizer obc_sphere_optimizer;

/* Methods, described at the top. */
enum {
  OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY = 0,
  OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN = 1,
  OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE = 2,
  OBC_SPHERE_OPTIMIZER_DISSERTATION = 3,
  OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON = 4
};

/* Requests of obc_sphere_optimizer_step. */
enum {
  OBC_SPHERE_OPTIMIZER_NEED_FG = 1,   /* evaluate f and its gradient at x, then call _tell */
  OBC_SPHERE_OPTIMIZER_ITERATION = 2, /* x is a new iterate; requires no action */
  OBC_SPHERE_OPTIMIZER_DONE = 3,      /* the run has ended; see _get_result */
  OBC_SPHERE_OPTIMIZER_NEED_PRODUCT = 4 /* compute the product of the Hessian of f at x and the vector of _get_direction, then call
                                           _tell_product. Only with the option hessian_products */
};

/* Stop codes: how a run ended. obc_sphere_optimizer_stop_name has their names. */
enum {
  OBC_SPHERE_OPTIMIZER_RUNNING = 0,           /* not ended */
  OBC_SPHERE_OPTIMIZER_CONVERGED = 1,         /* the tangent gradient of each block is at most gradient_tolerance long */
  OBC_SPHERE_OPTIMIZER_TARGET_REACHED = 2,    /* f <= target */
  OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET = 3, /* max_evaluations reached */
  OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET = 4,  /* max_iterations or max_passes reached */
  OBC_SPHERE_OPTIMIZER_STALLED = 5,           /* no step that double precision resolves lowers f, or lowers it by relative_gain */
  OBC_SPHERE_OPTIMIZER_CANCELLED = 6,         /* by the host's progress callback or by the callback f */
  OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED = 7  /* f is not finite at the start, or along two whole directions */
};

/* Return values of a callback. */
enum {
  OBC_SPHERE_OPTIMIZER_CONTINUE = 0, /* value and gradient are set */
  OBC_SPHERE_OPTIMIZER_STOP = 1,     /* end the run as CANCELLED with the best point so far. A finite value that is set as well
                                        counts; the gradient is unused */
  OBC_SPHERE_OPTIMIZER_FAILED = 2    /* f is undefined at x; the method continues elsewhere */
};

/* ---- options and result ---------------------------------------------------------------------------------------------- */

/* Options of an all-at-once run. Fill with _options_init. */
typedef struct obc_sphere_optimizer_options {
  uint32_t struct_size;

  int32_t method;   /* OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY or another. Default: LIMITED_MEMORY. */
  uint32_t memory;  /* number of pairs of LIMITED_MEMORY, 1 to 1000. Default: 16. */
  uint32_t history; /* number of values that BARZILAI_BORWEIN considers, 1 (monotone) to 1000000. Default: 10. */

  double gradient_tolerance; /* tolerance of the longest tangent gradient of a block. Default: 1e-8. */
  double target;             /* ends the run at f <= target. Default: -infinity. */
  uint64_t max_evaluations;  /* maximum number of evaluations. Default: 100000. */
  uint64_t max_iterations;   /* maximum number of iterations. Default: 100000. */

  uint64_t starts; /* number of points to start from, at least 1: x0, then random points. A run that CONVERGED, STALLED or failed at one
                      continues at the next; the lowest point of all is the result, and all limits are of the whole run. Default: 1. */
  uint64_t seed;   /* of the random points. Default: 0. */

  int32_t hessian_products; /* for TRUNCATED_NEWTON, 1: requests products of the Hessian (NEED_PRODUCT), 0: evaluates gradients nearby
                               and computes products from differences. Default: 0. */
} obc_sphere_optimizer_options;

/* State of a run. The caller sets struct_size. */
typedef struct obc_sphere_optimizer_result {
  uint32_t struct_size;
  int32_t stop; /* stop code, OBC_SPHERE_OPTIMIZER_RUNNING or another */

  double value;         /* f at the returned point; NaN before the first value */
  double gradient_norm; /* longest tangent gradient of a block at the current iterate; infinite before it is known */

  uint64_t evaluations;        /* number of evaluations, including failed ones */
  uint64_t failed_evaluations; /* number of evaluations without a value */
  uint64_t iterations;         /* number of iterations */

  uint64_t starts;     /* number of starts that have begun */
  uint64_t best_start; /* number of the start that led to the returned point, from 0 */

  uint64_t products; /* number of products of the Hessian, supplied or from differences */
} obc_sphere_optimizer_result;

/* Evaluates f at x (count blocks of dimension numbers, consecutive) and its gradient in the same order: the gradient in R^d of each
 * block, or any vector with the same tangential component. DISSERTATION uses the whole gradient; LIMITED_MEMORY takes the normal component as an
 * estimate of the stiffness of each block, which saves evaluations, and TRUNCATED_NEWTON with hessian_products needs the whole. A value or entry that is not finite counts as FAILED. Returns one
 * of the constants above. */
typedef int32_t (*obc_sphere_optimizer_function)(const double *x, size_t count, size_t dimension, double *value,
                                                 double *gradient, void *user);

/* Computes the product of the Hessian of f in R^(count dimension) at x with a direction, which is tangent to the spheres; x, direction and
 * product have count * dimension numbers. f was evaluated at the same x before. An entry that is not finite counts as FAILED, which ends
 * the search for a step, not the run. Returns one of the constants above. */
typedef int32_t (*obc_sphere_optimizer_product_function)(const double *x, const double *direction, size_t count,
                                                         size_t dimension, double *product, void *user);

/* Fills options with the defaults. */
OBC_API obc_status obc_sphere_optimizer_options_init(obc_sphere_optimizer_options *options, size_t struct_size);

/* ---- a run by reverse communication ---------------------------------------------------------------------------------- */

/* Creates a solver over count >= 1 spheres in dimension >= 2 that starts from x0 (count * dimension numbers, each block scaled to
 * length 1). options and host may be NULL; what the host points to must remain valid until _destroy. Errors: invalid argument
 * (also a zero block of x0), out of memory. */
OBC_API obc_status obc_sphere_optimizer_create(size_t count, size_t dimension,
                                               const obc_sphere_optimizer_options *options, const double *x0,
                                               const obc_host *host, obc_sphere_optimizer **out, obc_error *error);

/* Advances to the next request and returns it: NEED_FG, ITERATION or DONE, or a negative obc_status for NULL or after a defect. *x
 * (x may be NULL) is the point of the request, in memory of the solver, valid until its next call. While a request waits for
 * _tell, and after DONE, the same request is returned. Does not allocate. */
OBC_API int32_t obc_sphere_optimizer_step(obc_sphere_optimizer *solver, const double **x);

/* Supplies value and gradient for NEED_FG. An entry that is not finite means that f is undefined there; gradient may then be
 * NULL. Errors: invalid argument if no request waits. */
OBC_API obc_status obc_sphere_optimizer_tell(obc_sphere_optimizer *solver, double value, const double *gradient,
                                             obc_error *error);

/* Hands out the direction of a request NEED_PRODUCT, count * dimension numbers in memory of the solver, valid until its next call.
 * Errors: invalid argument if no product is requested. */
OBC_API obc_status obc_sphere_optimizer_get_direction(const obc_sphere_optimizer *solver, const double **direction,
                                                      obc_error *error);

/* Supplies the product of the Hessian and the direction, count * dimension numbers, for NEED_PRODUCT. NULL, or an entry that is not finite,
 * means that there is none at this point. Errors: invalid argument if no product is requested. */
OBC_API obc_status obc_sphere_optimizer_tell_product(obc_sphere_optimizer *solver, const double *product,
                                                     obc_error *error);

/* Copies the current state at any time: result (or NULL), and x (or NULL). x is the iterate that satisfies the tolerance if the
 * run CONVERGED, otherwise the lowest point evaluated, and before the first value the start. Errors: invalid argument. */
OBC_API obc_status obc_sphere_optimizer_get_result(const obc_sphere_optimizer *solver,
                                                   obc_sphere_optimizer_result *result, double *x, obc_error *error);

/* Returns the number of spheres and their dimension, for runs that _load created; count and dimension may be NULL.
 * Errors: invalid argument. */
OBC_API obc_status obc_sphere_optimizer_get_shape(const obc_sphere_optimizer *solver, size_t *count, size_t *dimension,
                                                  obc_error *error);

/* Save and restore a run between two calls. save_size returns the number of bytes, save writes them to blob, whose capacity is at
 * least that. load creates a solver that continues with the same bits and the saved options. Both machines need the same
 * byte order. Errors: invalid argument, malformed file (damaged, or of another version), out of memory. */
OBC_API size_t obc_sphere_optimizer_save_size(const obc_sphere_optimizer *solver);
OBC_API obc_status obc_sphere_optimizer_save(const obc_sphere_optimizer *solver, void *blob, size_t capacity,
                                             obc_error *error);
OBC_API obc_status obc_sphere_optimizer_load(const void *blob, size_t size, const obc_host *host,
                                             obc_sphere_optimizer **out, obc_error *error);

/* Destroys a solver; NULL is allowed. */
OBC_API void obc_sphere_optimizer_destroy(obc_sphere_optimizer *solver);

/* Runs to the end with a callback. x is the start and receives the point of _get_result; result may be NULL. Returns OBC_OK
 * however the run ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and result are filled in that case
 * too. Errors: invalid argument, out of memory, cancelled. */
OBC_API obc_status obc_sphere_optimizer_minimize(size_t count, size_t dimension,
                                                 const obc_sphere_optimizer_options *options,
                                                 obc_sphere_optimizer_function f, void *user, double *x,
                                                 obc_sphere_optimizer_result *result, const obc_host *host,
                                                 obc_error *error);

/* The same with TRUNCATED_NEWTON and products of the Hessian from a callback, whatever options->method and hessian_products are. */
OBC_API obc_status obc_sphere_optimizer_minimize_second_order(size_t count, size_t dimension,
                                                              const obc_sphere_optimizer_options *options,
                                                              obc_sphere_optimizer_function f,
                                                              obc_sphere_optimizer_product_function product, void *user,
                                                              double *x, obc_sphere_optimizer_result *result,
                                                              const obc_host *host, obc_error *error);

/* ---- block by block -------------------------------------------------------------------------------------------------- */

/* The spheres and their adjacency. Fill with _blocks_init. */
typedef struct obc_sphere_optimizer_blocks {
  uint32_t struct_size;
  uint32_t dimension; /* dimension of a block, 2 to 64; 3 and 4 have specialized code. Default: 0, which must be set. */
  size_t count;       /* number of blocks, below 4294967295. Default: 0, which must be set. */

  const size_t *neighbor_start; /* count + 1 offsets into the array of neighbors. Default: NULL. */
  const uint32_t *neighbor;     /* for each block, the blocks whose terms of f contain it. Default: NULL. */
} obc_sphere_optimizer_blocks;

/* Orders in which blocks are relaxed. */
enum {
  OBC_SPHERE_OPTIMIZER_AUTOMATIC = 0, /* QUEUE, then SWEEPS when gains decrease slowly */
  OBC_SPHERE_OPTIMIZER_QUEUE = 1,     /* the block first for which it or a neighbor gained most in the last step */
  OBC_SPHERE_OPTIMIZER_SWEEPS = 2     /* 0, 1, 2, ... repeatedly */
};

/* Options of a relaxation. Fill with _relaxation_options_init. */
typedef struct obc_sphere_optimizer_relaxation_options {
  uint32_t struct_size;

  int32_t method;       /* GREAT_CIRCLE, or DISSERTATION: Algorithm 2 as printed, in the order of eq. 3.6. Default: GREAT_CIRCLE. */
  int32_t second_order; /* 1: Newton steps, for which f returns Hessians; 0: first-order steps. Default: 0. */
  int32_t order;        /* AUTOMATIC, QUEUE or SWEEPS. Default: AUTOMATIC. */

  double gradient_tolerance; /* a block with a shorter tangent gradient does not move. Default: 1e-6. */
  double relative_gain;      /* ends when a pass gains at most this fraction of the total gain. Default: 0. */
  double over_relaxation;    /* step length relative to the minimizer along the step, from 1 to below 2; 0: chosen from the rate
                                at which gains decrease. Default: 0. */
  uint64_t max_passes;       /* maximum number of passes, each of `count` steps. Default: 10000. */
} obc_sphere_optimizer_relaxation_options;

/* A relaxation that runs in parts. */
typedef struct obc_sphere_optimizer_relaxation obc_sphere_optimizer_relaxation;

/* State of a relaxation. The caller sets struct_size. */
typedef struct obc_sphere_optimizer_relaxation_result {
  uint32_t struct_size;
  int32_t stop; /* CONVERGED, ITERATION_BUDGET, STALLED, CANCELLED, EVALUATION_FAILED (at the position of a block) or RUNNING */

  double gain;          /* total decrease of f */
  double gradient_norm; /* longest tangent gradient of a block, known at the end */

  uint64_t steps;         /* number of steps */
  uint64_t evaluations;   /* number of evaluations of terms of f */
  uint64_t failed_steps;  /* number of steps at which f was undefined along the whole search */
  double over_relaxation; /* value of the latest step */
} obc_sphere_optimizer_relaxation_result;

/* Evaluates the terms of f that contain `block`, with that block at `place` (dimension numbers) and all others as in `points` (all
 * blocks). With gradient not NULL (dimension numbers), place is the current position of the block; with hessian not NULL
 * (dimension squared, by rows) it returns second derivatives too. The result must depend on nothing else. A value that is not finite
 * counts as FAILED, by which the callback can also exclude positions. */
typedef int32_t (*obc_sphere_optimizer_block_function)(size_t block, const double *place, const double *points,
                                                       double *value, double *gradient, double *hessian, void *user);

/* Fill blocks with no blocks, and options with the defaults. */
OBC_API obc_status obc_sphere_optimizer_blocks_init(obc_sphere_optimizer_blocks *blocks, size_t struct_size);
OBC_API obc_status obc_sphere_optimizer_relaxation_options_init(obc_sphere_optimizer_relaxation_options *options,
                                                                size_t struct_size);

/* Lowers f block by block. x (count * dimension numbers) is the start, scaled to length 1, and receives the end. options, host and
 * result may be NULL. Returns OBC_OK however it ended (see result->stop), except OBC_CANCELLED where the host cancelled it; x and
 * result are filled in that case too. Errors: invalid argument (also a neighbor out of range), out of memory, cancelled. */
OBC_API obc_status obc_sphere_optimizer_relax(const obc_sphere_optimizer_blocks *blocks,
                                              const obc_sphere_optimizer_relaxation_options *options,
                                              obc_sphere_optimizer_block_function f, void *user, double *x,
                                              obc_sphere_optimizer_relaxation_result *result, const obc_host *host,
                                              obc_error *error);

/* Creates a relaxation that runs in parts. Copies blocks and x0 (scaled to length 1); what the host points to must remain valid until
 * _destroy. Errors: invalid argument, out of memory. */
OBC_API obc_status obc_sphere_optimizer_relaxation_create(const obc_sphere_optimizer_blocks *blocks,
                                                          const obc_sphere_optimizer_relaxation_options *options,
                                                          const double *x0, const obc_host *host,
                                                          obc_sphere_optimizer_relaxation **out, obc_error *error);

/* Relaxes up to `steps` more blocks without an allocation, and measures the gradients at the end of the relaxation. Returns OBC_OK
 * however it ended; stop is RUNNING where steps remain, CANCELLED where f returned STOP. After an interruption, also by the
 * host (OBC_CANCELLED), the current step is undone, and the next _run continues with the same bits as without the
 * interruption. Errors: invalid argument, cancelled. */
OBC_API obc_status obc_sphere_optimizer_relaxation_run(obc_sphere_optimizer_relaxation *relaxation,
                                                       obc_sphere_optimizer_block_function f, void *user,
                                                       uint64_t steps, obc_error *error);

/* Copies the current state: result (or NULL) and x (count * dimension numbers, or NULL). Errors: invalid argument. */
OBC_API obc_status obc_sphere_optimizer_relaxation_get_result(const obc_sphere_optimizer_relaxation *relaxation,
                                                              obc_sphere_optimizer_relaxation_result *result,
                                                              double *x, obc_error *error);

/* Save and restore a relaxation between two calls, like an all-at-once run. load takes the blocks of the saved relaxation (invalid
 * argument for others) and keeps its options. */
OBC_API size_t obc_sphere_optimizer_relaxation_save_size(const obc_sphere_optimizer_relaxation *relaxation);
OBC_API obc_status obc_sphere_optimizer_relaxation_save(const obc_sphere_optimizer_relaxation *relaxation, void *blob,
                                                        size_t capacity, obc_error *error);
OBC_API obc_status obc_sphere_optimizer_relaxation_load(const obc_sphere_optimizer_blocks *blocks, const void *blob,
                                                        size_t size, const obc_host *host,
                                                        obc_sphere_optimizer_relaxation **out, obc_error *error);

/* Destroys a relaxation; NULL is allowed. */
OBC_API void obc_sphere_optimizer_relaxation_destroy(obc_sphere_optimizer_relaxation *relaxation);

/* ---- names and version ----------------------------------------------------------------------------------------------- */

/* Returns the English name of a stop code, such as "evaluation budget"; a static string, never NULL. */
OBC_API const char *obc_sphere_optimizer_stop_name(int32_t stop);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_sphere_optimizer_version(void);

#ifdef __cplusplus
}
#endif

#endif
