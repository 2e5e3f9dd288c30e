/* Orbicube linear: solves sparse symmetric positive definite systems A x = b, with one unknown or 3 x 3 blocks.
 *
 * Two kinds of solvers:
 *
 * - obc_linear_direct factorizes A = L D L' once and solves for any number of right sides. The factor follows small changes
 *   of A in the time of the changed part: removed rows, added and subtracted matrices of rank one.
 * - obc_linear_iterative solves by conjugate gradients, preconditioned by symmetric Gauss-Seidel or by algebraic multigrid.
 *   Memory is linear in the number of entries of A, and with multigrid so is the time.
 *
 * Engines of direct factors. Eigen's simplicial factors are part of the library. CHOLMOD's factors are part of builds with
 * -Dcholmod_in_libraries=true, which the GPL covers.
 *
 * Determinism. Results are the same bits for any number of threads. Those of supernodal factors depend on the installed BLAS.
 *
 * Thread safety: a handle serves one thread at a time; distinct handles may be used at the same time. Several threads may call
 * obc_linear_direct_solve with one factor of Eigen while none of them changes it.
 *
 * Example: solves 2 x + y = 1, x + 3 y = 2, once by a factor and once by iterations.
 *
 *   #include <orbicube/linear.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     const size_t row_begin[] = {0, 1, 3}; // the lower triangle by rows
 *     const uint32_t columns[] = {0, 0, 1};
 *     const double values[] = {2, 1, 3}, b[] = {1, 2};
 *     const obc_linear_matrix a = {2, row_begin, columns, values};
 *     obc_linear_direct *factor;
 *     obc_linear_iterative *solver;
 *     double x[2], y[2];
 *     if (obc_linear_direct_create(&a, NULL, NULL, &factor, NULL) != OBC_OK) return 1;
 *     obc_linear_direct_solve(factor, 1, b, x, NULL);
 *     obc_linear_direct_destroy(factor);
 *     if (obc_linear_iterative_create(&a, NULL, NULL, &solver, NULL) != OBC_OK) return 1;
 *     obc_linear_iterative_solve(solver, b, y, NULL, NULL);
 *     obc_linear_iterative_destroy(solver);
 *     printf("%g %g, %g %g\n", x[0], x[1], y[0], y[1]); // 0.2 0.6, 0.2 0.6
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_LINEAR_H
#define ORBICUBE_LINEAR_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- matrix ---------------------------------------------------------------------------------------------------------- */

/* The lower triangle of a symmetric matrix in compressed rows: a view, which functions copy if they need it after they return.
 * Row i has the entries row_begin[i] to row_begin[i + 1] - 1. Its columns ascend; the last one is i, the diagonal. */
typedef struct obc_linear_matrix {
  size_t size;             /* Number of rows and columns, 0 to 2^31 - 1. */
  const size_t *row_begin; /* size + 1 numbers, the first 0, ascending; the last at most 2^31 - 1. */
  const uint32_t *columns; /* row_begin[size] numbers. */
  const double *values;    /* row_begin[size] finite numbers. */
} obc_linear_matrix;

/* ---- direct solution ------------------------------------------------------------------------------------------------- */

/* Engines of direct factors. */
enum {
  OBC_LINEAR_AUTO = 0,               /* CHOLMOD's supernodal factors if the build has them and the pattern promises a gain, else Eigen */
  OBC_LINEAR_EIGEN = 1,              /* simplicial factors, approximate minimum degree ordering */
  OBC_LINEAR_CHOLMOD_SIMPLICIAL = 2, /* simplicial factors (Chen, Davis, Hager and Rajamanickam 2008) */
  OBC_LINEAR_CHOLMOD_SUPERNODAL = 3  /* blocks of columns by BLAS */
};

/* Options of a factor. Fill with _init. */
typedef struct obc_linear_direct_options {
  uint32_t struct_size;

  int32_t method; /* Engine, OBC_LINEAR_AUTO to OBC_LINEAR_CHOLMOD_SUPERNODAL. Default: OBC_LINEAR_AUTO. */
} obc_linear_direct_options;

/* Fills options with the defaults. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_linear_direct_options_init(obc_linear_direct_options *options, size_t struct_size);

/* A factor of a matrix. */
typedef struct obc_linear_direct obc_linear_direct;

/* Factorizes a matrix. options and host may be NULL. The host's allocator must remain valid until _destroy; the factor itself
 * is not in its memory. A factorization reports no progress and cannot be cancelled. Release with obc_linear_direct_destroy.
 * Errors: OBC_INVALID_ARGUMENT (NULL, unsorted rows, no diagonal, not finite, unknown method), OBC_NO_VALID_RESULT (not positive
 * definite), OBC_UNSUPPORTED (the build has no CHOLMOD), OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_linear_direct_create(const obc_linear_matrix *matrix, const obc_linear_direct_options *options,
                                            const obc_host *host, obc_linear_direct **out, obc_error *error);

/* Destroys a factor; NULL is allowed. */
OBC_API void obc_linear_direct_destroy(obc_linear_direct *factor);

/* Factorizes other values in the pattern of the matrix that the factor was created from, in the order of its entries; removed
 * rows and updates end. count: row_begin[size]. Errors: OBC_INVALID_ARGUMENT; OBC_NO_VALID_RESULT (not positive definite: the
 * factor accepts other values, but no right side). */
OBC_API obc_status obc_linear_direct_refactor(obc_linear_direct *factor, const double *values, size_t count,
                                              obc_error *error);

/* Solves A X = B for `columns` right sides of `size` numbers each, one after the other. solution has the same length, and may be
 * `right`. Errors: OBC_INVALID_ARGUMENT (NULL, not finite, or the last refactor or update failed), OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_linear_direct_solve(obc_linear_direct *factor, size_t columns, const double *right,
                                           double *solution, obc_error *error);

/* Replaces row and column `row` of the factorized matrix by those of the identity, as for an unknown that becomes known (Davis
 * and Hager 2005). Errors: OBC_INVALID_ARGUMENT (row out of range, or the last refactor or update failed). */
OBC_API obc_status obc_linear_direct_remove_row(obc_linear_direct *factor, uint32_t row, obc_error *error);

/* Adds w w' to the factorized matrix (sign 1) or subtracts it (sign -1), for the vector w with the given entries (Davis and Hager
 * 1999). rows: count distinct rows; each pair of them must have an entry in the pattern. values: count finite numbers.
 * Errors: OBC_INVALID_ARGUMENT (NULL, out of range, repeated, not in the pattern); OBC_NO_VALID_RESULT (the result is not
 * positive definite: call obc_linear_direct_refactor before the next solution). */
OBC_API obc_status obc_linear_direct_update(obc_linear_direct *factor, const uint32_t *rows, const double *values,
                                            size_t count, int32_t sign, obc_error *error);

/* Returns the number of entries of L below its diagonal; 0 for NULL. */
OBC_API size_t obc_linear_direct_entry_count(const obc_linear_direct *factor);

/* ---- iterative solution ---------------------------------------------------------------------------------------------- */

/* Preconditioners. */
enum {
  OBC_LINEAR_ITERATIVE_AUTO = 0, /* multigrid from 20,000 blocks on, else Gauss-Seidel */
  OBC_LINEAR_GAUSS_SEIDEL = 1,   /* symmetric sweeps at the cost of one product an iteration (Eisenstat 1981) */
  OBC_LINEAR_MULTIGRID = 2       /* aggregation-based multigrid with Krylov cycles (Notay 2010) */
};

/* Options of an iterative solver. Fill with _init. */
typedef struct obc_linear_iterative_options {
  uint32_t struct_size;

  int32_t method;          /* Preconditioner, OBC_LINEAR_ITERATIVE_AUTO to OBC_LINEAR_MULTIGRID. Default: OBC_LINEAR_ITERATIVE_AUTO. */
  int32_t block_size;      /* Number of consecutive unknowns that form a block, as x, y, z of a point: 1, 2 or 3. Default: 1. */
  uint32_t max_iterations; /* Maximum number of iterations of a solution. Default: 1000. */
  double tolerance;        /* Requested relative residual |b - A x| / |b|, 0 to 1, exclusive. Default: 1e-8. */
} obc_linear_iterative_options;

/* Result of an iterative solution. Set struct_size, or fill with _init. */
typedef struct obc_linear_iterative_report {
  uint32_t struct_size;

  int32_t converged;   /* 1: the residual reached the tolerance; 0: max_iterations or rounding ended the iterations. */
  uint64_t iterations; /* Number of iterations, of all restarts together. */
  double residual;     /* |b - A x| / |b| of the solution, computed with A itself; 0 for b = 0. */
} obc_linear_iterative_report;

/* Fill options with the defaults, and a report with zeros and its size. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_linear_iterative_options_init(obc_linear_iterative_options *options, size_t struct_size);
OBC_API obc_status obc_linear_iterative_report_init(obc_linear_iterative_report *report, size_t struct_size);

/* A matrix with its preconditioner. */
typedef struct obc_linear_iterative obc_linear_iterative;

/* Copies a matrix and computes its preconditioner. options and host may be NULL. The solver keeps the host: each
 * obc_linear_iterative_solve uses its allocator and threads, reports to its progress callback and is cancelled by it. Whatever
 * the host points at (allocator, progress_user, fraction and others) must remain valid until obc_linear_iterative_destroy.
 * Precondition, not checked: the matrix is positive definite.
 * Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY, OBC_CANCELLED. */
OBC_API obc_status obc_linear_iterative_create(const obc_linear_matrix *matrix,
                                               const obc_linear_iterative_options *options, const obc_host *host,
                                               obc_linear_iterative **out, obc_error *error);

/* Destroys a solver; NULL is allowed. */
OBC_API void obc_linear_iterative_destroy(obc_linear_iterative *solver);

/* Solves A x = b from x = 0. right and solution have `size` numbers and do not overlap. report may be NULL. The solution is
 * written also where the tolerance was not reached: see report->converged. Progress goes to the host that the solver was created
 * with. Errors, with nothing written: OBC_INVALID_ARGUMENT (NULL, not finite), OBC_OUT_OF_MEMORY, OBC_CANCELLED. */
OBC_API obc_status obc_linear_iterative_solve(obc_linear_iterative *solver, const double *right, double *solution,
                                              obc_linear_iterative_report *report, obc_error *error);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_linear_version(void);

#ifdef __cplusplus
}
#endif

#endif
