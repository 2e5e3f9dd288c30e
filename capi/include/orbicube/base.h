/* Orbicube: what every library's interface shares. Plain C99; no macro is needed to call anything.
 *
 * Status and error. Every function that can fail answers an obc_status, 0 for success and negative otherwise, and takes
 * as its last argument an obc_error that the caller owns (or NULL). Nothing is kept in globals or thread-local state.
 *
 * Host. Every computation takes an obc_host (or NULL for none): what the calling program lends to it, and how it is
 * told of progress and stops the work. One host may be given to several computations, one after the other; to run
 * computations at the same time, each may be given the same host if its callbacks can be called from several threads.
 *
 * Options and results start with struct_size. Fill options with the library's ..._options_init(&options, sizeof options)
 * and results' struct_size with their size: a program that was compiled against an older header keeps working.
 *
 * Thread safety: functions may be called from any number of threads at once as long as they do not share a handle or an
 * array that one of them writes.
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

typedef int32_t obc_status;

enum {
  OBC_OK = 0,
  OBC_INVALID_ARGUMENT = -1,  /* NULL, NaN or a wrong size where that is not allowed, or an unknown option */
  OBC_MALFORMED_FILE = -2,    /* the file is not what its format asks for */
  OBC_NOT_CLOSED = -3,        /* the surface has a boundary */
  OBC_NOT_MANIFOLD = -4,      /* edges, vertices or orientation are not those of one manifold */
  OBC_WRONG_GENUS = -5,       /* the method needs another genus */
  OBC_DEGENERATE = -6,        /* no area, no volume, or a cell without either */
  OBC_OUT_OF_MEMORY = -7,
  OBC_CANCELLED = -8,         /* the host's progress callback asked to stop */
  OBC_IO = -9,                /* a file could not be opened, read or written */
  OBC_UNSUPPORTED = -10,      /* legal, but not something that this library does */
  OBC_NO_VALID_RESULT = -11,  /* the method ended without a result that can be certified */
  OBC_INTERNAL = -12          /* a defect of the library */
};

/* Owned by the caller; filled when a function fails, cleared (status OBC_OK, empty texts) when it succeeds. */
typedef struct obc_error {
  obc_status status;
  char kind[28];     /* one word, as the orbicube command prints it: "not-closed", "index-range", ... */
  char message[480]; /* what is wrong and where; UTF-8, cut at the end if it is longer, always terminated */
} obc_error;

/* Memory for what the libraries allocate. allocate answers NULL on failure, which ends in OBC_OUT_OF_MEMORY; alignment is
 * a power of two. release gets the size and alignment of the allocation. Both may be called from several threads. */
typedef struct obc_allocator {
  void *(*allocate)(size_t size, size_t alignment, void *user);
  void (*release)(void *pointer, size_t size, size_t alignment, void *user);
  void *user;
} obc_allocator;

/* Progress of a computation: its phase, how much of it is done (total is 0 where it is not known) and the best value of
 * the objective so far (NaN where there is none). Answer 0 to go on, anything else to stop with OBC_CANCELLED. Called
 * on the thread that called the library, often enough to stop within 50 ms. */
typedef int32_t (*obc_progress_function)(const char *phase, uint64_t done, uint64_t total, double best, void *user);

/* One line for a log, without a line end. */
typedef void (*obc_log_function)(const char *line, void *user);

/* A host's job system: calls task(i, context) once for every i in [0, count), on any threads, and returns when all of
 * them are done. Results never depend on order or on the number of threads. */
typedef void (*obc_parallel_for_function)(size_t count, void (*task)(size_t index, void *context), void *context,
                                          void *user);

typedef struct obc_host {
  uint32_t struct_size;
  uint32_t thread_count;            /* 0: one a core; not used when parallel_for is given */
  obc_progress_function progress;   /* or NULL */
  void *progress_user;
  obc_log_function log;             /* or NULL: silent */
  void *log_user;
  obc_parallel_for_function parallel_for; /* or NULL: threads of our own */
  void *parallel_for_user;
  const obc_allocator *allocator;   /* or NULL; kept by handles until they are destroyed */
} obc_host;

/* Fills a host with the defaults: nothing lent, one thread a core. */
OBC_API obc_status obc_host_init(obc_host *host, size_t struct_size);

/* Short English name of a status, such as "out of memory". Never NULL; a static string. */
OBC_API const char *obc_status_name(obc_status status);

/* Version of the base library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_base_version(void);

#ifdef __cplusplus
}
#endif

#endif
