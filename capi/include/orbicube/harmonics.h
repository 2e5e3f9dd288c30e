/* Orbicube: spherical harmonics of scattered samples and of shapes.
 *
 * A closed surface of genus 0 with a sphere map is three functions on the sphere, its coordinates; their expansion in
 * spherical harmonics smooths, compares and compresses the shape (section 3.3 of the dissertation that docs/harmonics.md
 * cites).
 *
 * Convention. The basis is real and orthonormal, without the Condon-Shortley phase (-1)^m:
 *
 *   Y_lm(x, y, z) = N_lm P_l|m|(z) * { sqrt 2 cos m phi (m > 0), 1 (m = 0), sqrt 2 sin |m| phi (m < 0) },
 *   N_lm = sqrt((2l+1)/(4 pi) (l-|m|)!/(l+|m|)!),  z = cos theta,  x + i y = sin theta e^(i phi),
 *
 * so the integral of Y_lm^2 over the sphere is 1 and Y_00 = 1/sqrt(4 pi). Files in the conventions of SHTOOLS (4 pi
 * normalised, no phase) and of SPHARM-PDM (orthonormal, with the phase) are converted on reading and writing.
 *
 * Arrays. Coefficients of `channels` functions up to a degree L (at most 1000): (L+1)^2 * channels doubles, that of Y_lm
 * in channel c at (l*l + l + m) * channels + c, with -l <= m <= l. Directions and points are x y z each; directions need
 * not have length 1. Values are `channels` numbers a direction. Nothing is kept after a call.
 *
 * Thread safety: every function may be called from any number of threads at once. Results are the same bits for any
 * number of threads.
 */
#ifndef ORBICUBE_HARMONICS_H
#define ORBICUBE_HARMONICS_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a fit is computed. */
enum {
  OBC_HARMONICS_AUTOMATIC = 0, /* dense when count * size^2 <= 5e8 or there are fewer samples than unknowns */
  OBC_HARMONICS_DENSE = 1,     /* Householder QR with column pivoting: O(count * size^2) time */
  OBC_HARMONICS_ITERATIVE = 2  /* conjugate gradients on the normal equations, refined: O(count * size) time */
};

typedef struct obc_harmonics_fit_options {
  uint32_t struct_size;
  uint32_t degree;  /* L, at most 1000; 16 by default */
  int32_t method;   /* OBC_HARMONICS_...; automatic by default */
  int32_t reserved;
  double smoothing; /* not negative; 0 by default. Adds smoothing * (mean density of the weights) * (integral of the squared
                       Laplacian of the fit) to what is minimised */
} obc_harmonics_fit_options;

typedef struct obc_harmonics_fit_report {
  uint32_t struct_size;
  int32_t method;      /* that was used: dense or iterative */
  uint64_t unknowns;   /* (L+1)^2 */
  uint64_t rank;       /* how many combinations of them the samples determine: fewer than `unknowns` when the fit is
                          rank-deficient (the answer is then about the shortest of the best), 0 when the iterative method
                          found the fit too ill-conditioned to tell (degree above 40) */
  double condition;    /* estimate of the condition of the weighted basis matrix, within the rank */
  double residual;     /* root of the weighted mean of |value - fit|^2 */
  uint64_t iterations; /* of the iterative method */
} obc_harmonics_fit_report;

/* Fills options with the defaults, and a report with zeros and its size. */
OBC_API obc_status obc_harmonics_fit_options_init(obc_harmonics_fit_options *options, size_t struct_size);
OBC_API obc_status obc_harmonics_fit_report_init(obc_harmonics_fit_report *report, size_t struct_size);

/* (degree + 1)^2. */
OBC_API size_t obc_harmonics_size(uint32_t degree);

/* Y_lm of every direction: rows, count * (degree+1)^2 doubles, a direction after the other. host may be NULL.
 * O(count * degree^2).
 * Errors: OBC_INVALID_ARGUMENT (NULL, not finite, length zero, degree), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_evaluate(const double *directions, size_t count, uint32_t degree, const obc_host *host,
                                          double *rows, obc_error *error);

/* The coefficients that fit values at scattered directions best: least squares with `weights`, one a direction and not
 * negative, or NULL for ones. For a surface, the weights of obc_harmonics_vertex_areas are the usual choice: each piece
 * counts by its own area.
 * options, host and report may be NULL. coefficients: written on success only. A rank-deficient fit is no error: see
 * report->rank.
 * Errors: as obc_harmonics_evaluate. */
OBC_API obc_status obc_harmonics_fit(const double *directions, const double *weights, const double *values, size_t count,
                                     size_t channels, const obc_harmonics_fit_options *options, const obc_host *host,
                                     double *coefficients, obc_harmonics_fit_report *report, obc_error *error);

/* The functions at the directions: values, count * channels doubles; and unless gradients is NULL, their gradients on the
 * sphere of radius 1, tangent vectors, 3 * count * channels doubles. O(count * degree^2 * channels).
 * Errors: as obc_harmonics_evaluate. */
OBC_API obc_status obc_harmonics_synthesize(const double *coefficients, uint32_t degree, size_t channels,
                                            const double *directions, size_t count, const obc_host *host, double *values,
                                            double *gradients, obc_error *error);

/* A third of the area of its triangles for each vertex: areas, vertex_count doubles. Triangles are three vertex indices
 * each. O(n).
 * Errors: OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (kind index-range: no such vertex), OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_vertex_areas(const double *positions, size_t vertex_count, const uint32_t *triangles,
                                              size_t triangle_count, const obc_host *host, double *areas,
                                              obc_error *error);

/* The norm of each degree, sqrt(sum over m and the channels of the squares): norms, degree + 1 doubles. It does not change
 * when the sphere is turned, nor when the values of three channels are.
 * Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_degree_norms(const double *coefficients, uint32_t degree, size_t channels, double *norms,
                                              obc_error *error);

/* The distance D_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
 * difference of the norms; degrees that one of them does not have count as zero there. first = 0 is the dissertation's;
 * with first = 1 it does not matter where the shapes lie.
 * Errors: as obc_harmonics_degree_norms. */
OBC_API obc_status obc_harmonics_shape_distance(const double *f, uint32_t f_degree, const double *g, uint32_t g_degree,
                                                size_t channels, uint32_t first, uint32_t last, double *distance,
                                                obc_error *error);

/* Filters in place: degrees from low to high stay, the others become zero, over `width` degrees outside of each end with a
 * raised cosine (0: at once). With keep_mean 1 degree 0 stays, which is where a shape lies.
 * Errors: as obc_harmonics_degree_norms. */
OBC_API obc_status obc_harmonics_filter(double *coefficients, uint32_t degree, size_t channels, uint32_t low,
                                        uint32_t high, uint32_t width, int32_t keep_mean, obc_error *error);

/* The reconstruction error of section 3.3.2: e(A, B) = max(d(A, B), d(B, A)), d(A, B) the mean over the points of A of the
 * distance to the nearest point of B. O(n log n).
 * Errors: OBC_INVALID_ARGUMENT (NULL, no points, not finite), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_mean_distance(const double *a, size_t a_count, const double *b, size_t b_count,
                                               const obc_host *host, double *distance, obc_error *error);

/* The functions turned with the sphere: what each has at direction v, it has at R v afterwards. rotation: the matrix R by
 * rows, 9 doubles. turned may be coefficients. The values are not turned: for a shape that turns in space, multiply the three
 * coefficients of each Y_lm by the matrix. O(degree^3).
 * Errors: OBC_INVALID_ARGUMENT (also: no rotation), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_rotate(const double *coefficients, uint32_t degree, size_t channels,
                                        const double *rotation, const obc_host *host, double *turned, obc_error *error);

typedef struct obc_harmonics_align_options {
  uint32_t struct_size;
  int32_t turn_values;    /* 1: the values of three channels may be turned too, for shapes that lie differently in space;
                             0 by default */
  uint32_t search_degree; /* of the search over all rotations, 1 to 64; 12 by default */
  uint32_t reserved;
} obc_harmonics_align_options;

typedef struct obc_harmonics_alignment {
  uint32_t struct_size;
  uint32_t reserved;
  double rotation[9]; /* R by rows: directions v of `moving` go to R v */
  double values[9];   /* Q by rows: values of `moving` are multiplied by Q; the identity without turn_values */
  double correlation; /* of what is found, without degree 0: at most 1 */
} obc_harmonics_alignment;

/* Fills options with the defaults, and an alignment with zeros and its size. */
OBC_API obc_status obc_harmonics_align_options_init(obc_harmonics_align_options *options, size_t struct_size);
OBC_API obc_status obc_harmonics_alignment_init(obc_harmonics_alignment *alignment, size_t struct_size);

/* The rotation that brings `moving` best into line with `fixed`: it maximises the sum over the channels of the integral of
 * fixed(u) * (Q moving)(R^-1 u), without degree 0. Found on a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
 * rotation group") and refined by Newton's method up to the lower of the two degrees. options and host may be NULL.
 * O(search_degree^4 + degree^3).
 * Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (one of them is constant), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_align(const double *fixed, uint32_t fixed_degree, const double *moving,
                                       uint32_t moving_degree, size_t channels,
                                       const obc_harmonics_align_options *options, const obc_host *host,
                                       obc_harmonics_alignment *alignment, obc_error *error);

/* Formats of files. Their conventions are converted: what is read or written here are coefficients as above. */
enum {
  OBC_HARMONICS_BY_ENDING = 0, /* .sh .shtools .txt: SHTOOLS; .coef: SPHARM-PDM */
  OBC_HARMONICS_SHTOOLS = 1,   /* lines "l, m, C, S" for 0 <= m <= l, one block a channel: C = a_lm / sqrt(4 pi),
                                  S = a_l,-m / sqrt(4 pi) */
  OBC_HARMONICS_SPHARM_PDM = 2 /* three channels, "{ count,{x, y, z}, ...}": for m > 0 the cosine's (-1)^m sqrt 2 a_lm,
                                  then the sine's (-1)^m sqrt 2 a_l,-m */
};

/* Writes a file, whole or not at all; read again, every number is the same to its last bits.
 * Errors: OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC_IO,
 * OBC_OUT_OF_MEMORY. The message starts with the path. */
OBC_API obc_status obc_harmonics_write(const char *path, int32_t format, const double *coefficients, uint32_t degree,
                                       size_t channels, obc_error *error);

/* Coefficients that were read from a file; the degree is that of the file. Read-only: may be shared between threads. */
typedef struct obc_harmonics_coefficients obc_harmonics_coefficients;

/* host may be NULL; its allocator must stay valid until _destroy. Nothing in a file is trusted.
 * Errors: OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with
 * the line), OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED, OBC_OUT_OF_MEMORY. The message starts with the path. */
OBC_API obc_status obc_harmonics_read(const char *path, int32_t format, const obc_host *host,
                                      obc_harmonics_coefficients **coefficients, obc_error *error);

/* 0 for NULL. */
OBC_API uint32_t obc_harmonics_coefficients_degree(const obc_harmonics_coefficients *coefficients);
OBC_API size_t obc_harmonics_coefficients_channels(const obc_harmonics_coefficients *coefficients);

/* Copies them out: (degree+1)^2 * channels doubles. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_harmonics_coefficients_copy(const obc_harmonics_coefficients *coefficients, double *values,
                                                   obc_error *error);

/* NULL is fine. */
OBC_API void obc_harmonics_coefficients_destroy(obc_harmonics_coefficients *coefficients);

/* Version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_harmonics_version(void);

#ifdef __cplusplus
}
#endif

#endif
