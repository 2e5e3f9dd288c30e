/* Orbicube base: status, error, progress, memory and threads, shared by all libraries. Plain C99; calls need no macro.
 *
 * Status and error. A function that can fail returns an obc_status, 0 for success and negative otherwise. Its last parameter is
 * an obc_error of the caller, or NULL. No function keeps global or thread-local state.
 *
 * Host. A computation takes an obc_host, or NULL for the defaults: memory, threads and callbacks that the program provides. One host may serve
 * several computations in sequence. It may serve several at the same time if its callbacks are thread-safe and `fraction` is NULL.
 *
 * Options and results begin with struct_size. Options are filled by the library's ..._options_init(&options, sizeof options); the
 * caller sets struct_size of results. Members that a newer header adds keep their defaults for programs compiled earlier.
 *
 * Thread safety: all functions may be called at the same time, unless two calls share a handle or an array that one of them writes.
 *
 * Example: limits a computation to two threads.
 *
 *   #include <orbicube/base.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     obc_host host;
 *     if (obc_host_init(&host, sizeof host) != OBC_OK) return 1;
 *     host.thread_count = 2; // and pass &host to a computation
 *     printf("%s\n", obc_status_name(OBC_CANCELLED));
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_BASE_H
#define ORBICUBE_BASE_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define OBC_API __attribute__((visibility("default")))
#else
#define OBC_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- status and error ------------------------------------------------------------------------------------------------ */

/* Outcome of a call: OBC_OK or one of the negative values below. */
typedef int32_t obc_status;

/* Values of obc_status. */
enum {
  OBC_OK = 0,                 /* success */
  OBC_INVALID_ARGUMENT = -1,  /* an argument is NULL, not finite or out of range, or an option is unknown */
  OBC_MALFORMED_FILE = -2,    /* the contents violate the file format */
  OBC_NOT_CLOSED = -3,        /* the surface has a boundary */
  OBC_NOT_MANIFOLD = -4,      /* edges, vertices or orientation are not those of a manifold */
  OBC_WRONG_GENUS = -5,       /* the method requires another genus */
  OBC_DEGENERATE = -6,        /* the input has zero area or volume, or a degenerate cell */
  OBC_OUT_OF_MEMORY = -7,     /* an allocation failed; everything is released */
  OBC_CANCELLED = -8,         /* the host's progress callback requested the end */
  OBC_IO = -9,                /* a file cannot be opened, read or written */
  OBC_UNSUPPORTED = -10,      /* valid input that this library does not handle */
  OBC_NO_VALID_RESULT = -11,  /* the method ended without a result that can be certified */
  OBC_INTERNAL = -12          /* a defect of the library */
};

/* Description of a failure, in memory of the caller. A failing function fills it; a successful one clears it. */
typedef struct obc_error {
  obc_status status; /* the returned status */
  char kind[28];     /* one word for programs, such as "not-closed" or "index-range"; empty after success */
  char message[480]; /* sentence for people: what is wrong and where; UTF-8, truncated if longer, always terminated */
} obc_error;

/* ---- host ------------------------------------------------------------------------------------------------------------ */

/* Memory of the program for the allocations of the libraries. Both functions must be thread-safe. */
typedef struct obc_allocator {
  /* Returns `size` bytes at a multiple of `alignment`, a power of two, or NULL, which ends the call in OBC_OUT_OF_MEMORY. */
  void *(*allocate)(size_t size, size_t alignment, void *user);

  /* Releases an allocation; size and alignment are those of the allocation. */
  void (*release)(void *pointer, size_t size, size_t alignment, void *user);

  void *user; /* passed to both functions */
} obc_allocator;

/* Receives the progress of a computation: the name of the phase, the completed and the total amount of its work (total 0: unknown) and
 * the lowest objective value so far (NaN: none). obc_host.fraction has the fraction of the whole call. Returns 0 to continue, any
 * other value to end the call with OBC_CANCELLED. Runs on the thread that called the library, at intervals of at most 50 ms. */
typedef int32_t (*obc_progress_function)(const char *phase, uint64_t done, uint64_t total, double best, void *user);

/* Receives one line for a log, without a line end. */
typedef void (*obc_log_function)(const char *line, void *user);

/* Job system of the program. Calls task(i, context) once for each i in [0, count), on any threads and in any order, and returns after
 * the last one. Results do not depend on the order or the number of threads. */
typedef void (*obc_parallel_for_function)(size_t count, void (*task)(size_t index, void *context), void *context,
                                          void *user);

/* Resources of the program that a computation uses. Fill with obc_host_init. */
typedef struct obc_host {
  uint32_t struct_size;

  /* Number of threads, up to 1024; 0: one a core. Unused with parallel_for. Default: 0. */
  uint32_t thread_count;

  obc_progress_function progress; /* receives progress and can cancel; NULL: none. Default: NULL. */
  void *progress_user;            /* passed to progress. Default: NULL. */

  obc_log_function log; /* receives lines for a log; NULL: none. Default: NULL. */
  void *log_user;       /* passed to log. Default: NULL. */

  obc_parallel_for_function parallel_for; /* job system; NULL: threads of the library. Default: NULL. */
  void *parallel_for_user;                /* passed to parallel_for. Default: NULL. */

  /* Memory; NULL: the default of the library. A handle uses it until it is destroyed. Default: NULL. */
  const obc_allocator *allocator;

  /* Completed fraction of the whole call, 0 to 1, never decreasing, stored before each call of progress; NULL: not stored. It is an
   * estimate where the amount of work is unknown in advance. A host with it serves one call at a time. Default: NULL. */
  double *fraction;
} obc_host;

/* Fills a host with the defaults. Errors: invalid argument (NULL, or a size that no version has). */
OBC_API obc_status obc_host_init(obc_host *host, size_t struct_size);

/* ---- names and version ----------------------------------------------------------------------------------------------- */

/* Returns a short English name of a status, such as "out of memory"; a static string, never NULL. */
OBC_API const char *obc_status_name(obc_status status);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_base_version(void);

#ifdef __cplusplus
}
#endif

#endif
