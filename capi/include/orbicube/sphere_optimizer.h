/* Orbicube sphere optimizer: minimise f over a product of N unit spheres in R^d. Directions, quaternions (d = 4), rows of a
 * factor of a correlation matrix, unit eigenvectors: N blocks of d numbers, each of length 1 to within 2 units of the last
 * place wherever f is asked for.
 *
 * All at once, with value and gradient of f:
 *   LIMITED_MEMORY (default)  L-BFGS with parallel transport (Huang, Gallivan, Absil 2015), Wolfe search along the arcs
 *   BARZILAI_BORWEIN          nonmonotone Barzilai-Borwein steps (Iannazzo, Porcelli 2018); little memory
 *   GREAT_CIRCLE              the great-circle search of the dissertation's Algorithm 2 (section 3.1.4), its flaws mended: it
 *                             follows the tangent gradient, starts from the scale of the last step, and halves the angle
 *   SEED                      Algorithm 2 as printed: ends of the first arc at -G / |G| or the mirror image; for comparison
 *
 *   const double *x;
 *   while ((request = obc_sphere_optimizer_step(solver, &x)) > 0 && request != OBC_SPHERE_OPTIMIZER_DONE)
 *     if (request == OBC_SPHERE_OPTIMIZER_NEED_FG) obc_sphere_optimizer_tell(solver, f(x), gradient(x), NULL);
 *
 * Block by block, with the part of f that contains one block (obc_sphere_optimizer_relax, or _relaxation_run to do it in
 * parts): those first that promise most, then, when gains fall slowly, in sweeps with over-relaxed steps (Young 1954). Each
 * step is along a great circle or Newton's. Where f is a sum over neighbours and values must stay within limits, or f has no
 * gradient as a whole; all at once is better where the last digits are wanted.
 *
 * Memory: all of it is allocated by _create, _load and at the start of _relax. (7 + 2 memory) N d + 3 N numbers for LIMITED_MEMORY,
 * 7 N d + 3 N for BARZILAI_BORWEIN and GREAT_CIRCLE, 9 N d + 3 N for SEED, 18 bytes a block for _relax. An iteration takes time
 * proportional to N d memory, and asks for 1.0 to 1.1 evaluations as a rule.
 *
 * Thread safety: a solver is used by one thread at a time; distinct solvers at the same time. All work is done on the calling
 * thread; results are the same bits however many threads there are.
 */
#ifndef ORBICUBE_SPHERE_OPTIMIZER_H
#define ORBICUBE_SPHERE_OPTIMIZER_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A run of the all-at-once solver. */
typedef struct obc_sphere_optimizer obc_sphere_optimizer;

/* Which method. */
enum {
  OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY = 0,
  OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN = 1,
  OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE = 2,
  OBC_SPHERE_OPTIMIZER_SEED = 3
};

/* What a step wants. */
enum {
  OBC_SPHERE_OPTIMIZER_NEED_FG = 1,   /* value and gradient of f at x; answer with _tell */
  OBC_SPHERE_OPTIMIZER_ITERATION = 2, /* x is a new iterate; nothing to answer */
  OBC_SPHERE_OPTIMIZER_DONE = 3       /* see _get_result */
};

/* How a run ended. Names from obc_sphere_optimizer_stop_name. */
enum {
  OBC_SPHERE_OPTIMIZER_RUNNING = 0,
  OBC_SPHERE_OPTIMIZER_CONVERGED = 1,         /* every block's tangent gradient is at most gradient_tolerance long */
  OBC_SPHERE_OPTIMIZER_TARGET_REACHED = 2,    /* f <= target */
  OBC_SPHERE_OPTIMIZER_EVALUATION_BUDGET = 3,
  OBC_SPHERE_OPTIMIZER_ITERATION_BUDGET = 4,
  OBC_SPHERE_OPTIMIZER_STALLED = 5,           /* no step that the arithmetic resolves improves f, or gains as asked */
  OBC_SPHERE_OPTIMIZER_CANCELLED = 6,         /* by the host's progress callback, or by the callback f */
  OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED = 7  /* f not finite at the start, or all along two directions */
};

/* What a callback answers. */
enum {
  OBC_SPHERE_OPTIMIZER_CONTINUE = 0,
  OBC_SPHERE_OPTIMIZER_STOP = 1,  /* end the run as cancelled; the best point so far is handed out */
  OBC_SPHERE_OPTIMIZER_FAILED = 2 /* f has no value at x; the method goes on elsewhere */
};

/* Fill with _options_init. */
typedef struct obc_sphere_optimizer_options {
  uint32_t struct_size;
  int32_t method;            /* LIMITED_MEMORY */
  uint32_t memory;           /* pairs of LIMITED_MEMORY, 1 to 1000: 16 */
  uint32_t history;          /* values that BARZILAI_BORWEIN looks back on, 1 (monotone) to 1000000: 10 */
  double gradient_tolerance; /* on the longest tangent gradient of a block: 1e-8 */
  double target;             /* stop once f <= target: -infinity */
  uint64_t max_evaluations;  /* 100000 */
  uint64_t max_iterations;   /* 100000 */
} obc_sphere_optimizer_options;

/* What is known of a run; set struct_size before asking for it. */
typedef struct obc_sphere_optimizer_result {
  uint32_t struct_size;
  int32_t stop;         /* OBC_SPHERE_OPTIMIZER_RUNNING, ... */
  double value;         /* f at the point handed out; NaN before the first value */
  double gradient_norm; /* longest tangent gradient of a block at the current iterate; infinite before it is known */
  uint64_t evaluations;
  uint64_t failed_evaluations;
  uint64_t iterations;
} obc_sphere_optimizer_result;

/* Value of f at x (count blocks of dimension numbers, one after the other) and its gradient there, in the same order: that in
 * R^d of each block, or any vector with the same part tangent to the spheres: SEED looks at the whole, LIMITED_MEMORY takes
 * the rest as a hint of how stiff each block is, which saves evaluations. A value or entry that is not finite counts as
 * FAILED. */
typedef int32_t (*obc_sphere_optimizer_function)(const double *x, size_t count, size_t dimension, double *value,
                                                 double *gradient, void *user);

/* The defaults, which the members' comments give. */
OBC_API obc_status obc_sphere_optimizer_options_init(obc_sphere_optimizer_options *options, size_t struct_size);

/* Makes a solver over count >= 1 spheres in dimension >= 2 that starts from x0 (count * dimension numbers, each block scaled
 * to length 1). options and host may be NULL; what the host points at must stay valid until _destroy. Errors: invalid
 * argument (also a block of x0 that is zero), out of memory. */
OBC_API obc_status obc_sphere_optimizer_create(size_t count, size_t dimension,
                                               const obc_sphere_optimizer_options *options, const double *x0,
                                               const obc_host *host, obc_sphere_optimizer **out, obc_error *error);

/* Goes on to the next request: NEED_FG, ITERATION or DONE, or a negative obc_status when the solver is NULL or on a defect.
 * *x (x may be NULL) is the point that is asked about, the solver's, valid until its next call. While a request waits for
 * _tell, and after DONE, the answer stays the same. Does not allocate. */
OBC_API int32_t obc_sphere_optimizer_step(obc_sphere_optimizer *solver, const double **x);

/* Answers NEED_FG. A value or gradient entry that is not finite says that f cannot be evaluated there; gradient may be NULL
 * then. Errors: invalid argument when nothing was asked. */
OBC_API obc_status obc_sphere_optimizer_tell(obc_sphere_optimizer *solver, double value, const double *gradient,
                                             obc_error *error);

/* What is known now, at any time: result (or NULL), and x (or NULL), which is the iterate that met the tolerance if the run
 * CONVERGED, else the lowest point evaluated, and before that the start. */
OBC_API obc_status obc_sphere_optimizer_get_result(const obc_sphere_optimizer *solver,
                                                   obc_sphere_optimizer_result *result, double *x, obc_error *error);

/* How many spheres, and of how many numbers each; each of count and dimension may be NULL. For runs that come from _load. */
OBC_API obc_status obc_sphere_optimizer_get_shape(const obc_sphere_optimizer *solver, size_t *count, size_t *dimension,
                                                  obc_error *error);

/* A run as bytes, at any time between two calls: save_size gives their number, save writes them to blob (capacity at least
 * that). load makes a solver from them that goes on with the same bits, with the options of the saved run. For machines of
 * the same byte order. Errors: invalid argument, malformed file (damaged, or of another version). */
OBC_API size_t obc_sphere_optimizer_save_size(const obc_sphere_optimizer *solver);
OBC_API obc_status obc_sphere_optimizer_save(const obc_sphere_optimizer *solver, void *blob, size_t capacity,
                                             obc_error *error);
OBC_API obc_status obc_sphere_optimizer_load(const void *blob, size_t size, const obc_host *host,
                                             obc_sphere_optimizer **out, obc_error *error);

/* Releases a solver; NULL is fine. */
OBC_API void obc_sphere_optimizer_destroy(obc_sphere_optimizer *solver);

/* The loop over step with a callback: x holds the start and gets what _get_result hands out; result may be NULL. Answers
 * OBC_OK however the run ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and result are filled then
 * as well. */
OBC_API obc_status obc_sphere_optimizer_minimize(size_t count, size_t dimension,
                                                 const obc_sphere_optimizer_options *options,
                                                 obc_sphere_optimizer_function f, void *user, double *x,
                                                 obc_sphere_optimizer_result *result, const obc_host *host,
                                                 obc_error *error);

/* ---- Block by block ---- */

/* The spheres and who is whose neighbour; fill with _blocks_init. */
typedef struct obc_sphere_optimizer_blocks {
  uint32_t struct_size;
  uint32_t dimension;            /* 2 to 64; 3 and 4 are compiled for themselves */
  size_t count;                  /* less than 4294967295 */
  const size_t *neighbour_start; /* count + 1 offsets into neighbour */
  const uint32_t *neighbour;     /* the blocks whose part of f contains this one, for each block */
} obc_sphere_optimizer_blocks;

/* In which order blocks are taken. */
enum {
  OBC_SPHERE_OPTIMIZER_AUTOMATIC = 0, /* QUEUE, then SWEEPS when gains fall slowly */
  OBC_SPHERE_OPTIMIZER_QUEUE = 1,     /* the block first whose or whose neighbours' last step gained most */
  OBC_SPHERE_OPTIMIZER_SWEEPS = 2     /* 0, 1, 2, ... again and again */
};

/* Fill with _relaxation_options_init. */
typedef struct obc_sphere_optimizer_relaxation_options {
  uint32_t struct_size;
  int32_t method;            /* GREAT_CIRCLE, or SEED: Algorithm 2 as printed, in the order of eq. 3.6 */
  int32_t second_order;      /* 1: Newton's steps, f gives Hessians: 0 */
  int32_t order;             /* AUTOMATIC */
  double gradient_tolerance; /* a block with a shorter tangent gradient stays: 1e-6 */
  double relative_gain;      /* end when a pass gains at most this part of all that was gained: 0 */
  double over_relaxation;    /* how many times as far each step goes as its own energy asks, from 1 to below 2; 0: chosen from
                                the rate at which gains fall: 0 */
  uint64_t max_passes;       /* of as many steps as there are blocks: 10000 */
} obc_sphere_optimizer_relaxation_options;

/* A relaxation that is done in parts. */
typedef struct obc_sphere_optimizer_relaxation obc_sphere_optimizer_relaxation;

/* What a relaxation did; set struct_size before asking for it. */
typedef struct obc_sphere_optimizer_relaxation_result {
  uint32_t struct_size;
  int32_t stop;         /* CONVERGED, ITERATION_BUDGET, STALLED, CANCELLED, EVALUATION_FAILED (where a block is); RUNNING */
  double gain;          /* by how much f fell */
  double gradient_norm; /* longest tangent gradient of a block, known at the end */
  uint64_t steps;
  uint64_t evaluations; /* of parts of f */
  uint64_t failed_steps;
  double over_relaxation; /* of the latest step */
} obc_sphere_optimizer_relaxation_result;

/* The part of f that contains `block`, if that block was at `place` (dimension numbers) and all others where `points` (all
 * blocks) says. With gradient (dimension numbers, or NULL), place is where the block is; with hessian (dimension squared, or
 * NULL) second derivatives as well, by rows. Must depend on nothing else. A value that is not finite counts as FAILED; so the
 * callback also keeps a block from places where it must not be. */
typedef int32_t (*obc_sphere_optimizer_block_function)(size_t block, const double *place, const double *points,
                                                       double *value, double *gradient, double *hessian, void *user);

/* Empty: no blocks. And the defaults, which the members' comments give. */
OBC_API obc_status obc_sphere_optimizer_blocks_init(obc_sphere_optimizer_blocks *blocks, size_t struct_size);
OBC_API obc_status obc_sphere_optimizer_relaxation_options_init(obc_sphere_optimizer_relaxation_options *options,
                                                                size_t struct_size);

/* Lowers f block by block: x (count * dimension numbers) holds the start, scaled to length 1, and gets the end. options, host
 * and result may be NULL. Answers OBC_OK however it ended (result->stop), but OBC_CANCELLED when the host cancelled it; x and
 * result are filled then as well. Errors: invalid argument (also a neighbour out of range), out of memory. */
OBC_API obc_status obc_sphere_optimizer_relax(const obc_sphere_optimizer_blocks *blocks,
                                              const obc_sphere_optimizer_relaxation_options *options,
                                              obc_sphere_optimizer_block_function f, void *user, double *x,
                                              obc_sphere_optimizer_relaxation_result *result, const obc_host *host,
                                              obc_error *error);

/* The same in parts: _create copies blocks and x0 (scaled to length 1); what the host points at must stay valid until
 * _destroy. */
OBC_API obc_status obc_sphere_optimizer_relaxation_create(const obc_sphere_optimizer_blocks *blocks,
                                                          const obc_sphere_optimizer_relaxation_options *options,
                                                          const double *x0, const obc_host *host,
                                                          obc_sphere_optimizer_relaxation **out, obc_error *error);

/* At most `steps` more steps of one block each, without an allocation; at the end of the relaxation its gradients are
 * measured. Answers OBC_OK however it ended; stop is RUNNING when steps are left to do, CANCELLED when f answered STOP.
 * OBC_CANCELLED: the host cancelled. However it was broken off, the step under way is as if it had not begun, and the next
 * _run goes on with the same bits as without the break. */
OBC_API obc_status obc_sphere_optimizer_relaxation_run(obc_sphere_optimizer_relaxation *relaxation,
                                                       obc_sphere_optimizer_block_function f, void *user,
                                                       uint64_t steps, obc_error *error);

/* What is known now: result (or NULL) and x (count * dimension numbers, or NULL). */
OBC_API obc_status obc_sphere_optimizer_relaxation_get_result(const obc_sphere_optimizer_relaxation *relaxation,
                                                              obc_sphere_optimizer_relaxation_result *result,
                                                              double *x, obc_error *error);

/* The relaxation as bytes between two calls, like a run of the all-at-once solver. load takes the blocks of the saved one
 * again (invalid argument if they are others), with the options of the saved one. */
OBC_API size_t obc_sphere_optimizer_relaxation_save_size(const obc_sphere_optimizer_relaxation *relaxation);
OBC_API obc_status obc_sphere_optimizer_relaxation_save(const obc_sphere_optimizer_relaxation *relaxation, void *blob,
                                                        size_t capacity, obc_error *error);
OBC_API obc_status obc_sphere_optimizer_relaxation_load(const obc_sphere_optimizer_blocks *blocks, const void *blob,
                                                        size_t size, const obc_host *host,
                                                        obc_sphere_optimizer_relaxation **out, obc_error *error);

/* Releases a relaxation; NULL is fine. */
OBC_API void obc_sphere_optimizer_relaxation_destroy(obc_sphere_optimizer_relaxation *relaxation);

/* English name of a stop, such as "evaluation budget". Never NULL; a static string. */
OBC_API const char *obc_sphere_optimizer_stop_name(int32_t stop);

/* Version of this library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_sphere_optimizer_version(void);

#ifdef __cplusplus
}
#endif

#endif
