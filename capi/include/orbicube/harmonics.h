/* Orbicube harmonics: spherical harmonics of scattered samples and of shapes.
 *
 * A closed genus-0 surface with a sphere map is three functions on the sphere, its coordinates. Their expansion in spherical harmonics
 * smooths, compares and compresses the shape (section 3.3 of the dissertation cited in docs/harmonics.md).
 *
 * Convention. The basis is real and orthonormal, without the Condon-Shortley phase (-1)^m:
 *
 *   Y_lm(x, y, z) = N_lm P_l|m|(z) * { sqrt 2 cos m phi (m > 0), 1 (m = 0), sqrt 2 sin |m| phi (m < 0) },
 *   N_lm = sqrt((2l+1)/(4 pi) (l-|m|)!/(l+|m|)!),  z = cos theta,  x + i y = sin theta e^(i phi).
 *
 * The integral of Y_lm^2 over the sphere is 1, and Y_00 = 1/sqrt(4 pi). Files in the conventions of SHTOOLS (4 pi normalized, no
 * phase) and of SPHARM-PDM (orthonormal, with the phase) are converted when read and written.
 *
 * Arrays. Coefficients of `channels` functions up to a degree L (at most 1000) are (L+1)^2 * channels doubles, that of Y_lm in
 * channel c at (l*l + l + m) * channels + c, with -l <= m <= l. Directions and points are x y z each; directions have any nonzero
 * length. Values are `channels` numbers a direction. No function keeps its inputs.
 *
 * Thread safety: all functions may be called at the same time. Results are the same bits for any number of threads.
 *
 * Example: fits the function z at six directions and prints the coefficient of Y_10.
 *
 *   #include <orbicube/harmonics.h>
 *   #include <stdio.h>
 *
 *   int main(void) {
 *     const double directions[] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
 *     const double values[] = {0, 0, 0, 0, 1, -1};
 *     double coefficients[4];
 *     obc_harmonics_fit_options options;
 *     obc_error error;
 *     obc_harmonics_fit_options_init(&options, sizeof options);
 *     options.degree = 1;
 *     if (obc_harmonics_fit(directions, NULL, values, 6, 1, &options, NULL, coefficients, NULL, &error) != OBC_OK) return 1;
 *     printf("%.6f\n", coefficients[2]); // sqrt(4 pi / 3) = 2.046653
 *     return 0;
 *   }
 */
#ifndef ORBICUBE_HARMONICS_H
#define ORBICUBE_HARMONICS_H

#include <orbicube/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- fits ------------------------------------------------------------------------------------------------------------ */

/* Algorithms of a fit. */
enum {
  OBC_HARMONICS_AUTOMATIC = 0, /* DENSE if count * size^2 <= 5e8 or there are fewer samples than unknowns, otherwise ITERATIVE */
  OBC_HARMONICS_DENSE = 1,     /* Householder QR with column pivoting: O(count * size^2) time */
  OBC_HARMONICS_ITERATIVE = 2  /* conjugate gradients on the normal equations, refined: O(count * size) time */
};

/* Options of a fit. Fill with _init. */
typedef struct obc_harmonics_fit_options {
  uint32_t struct_size;
  uint32_t degree; /* maximum degree L, up to 1000. Default: 16. */
  int32_t method;  /* OBC_HARMONICS_AUTOMATIC, DENSE or ITERATIVE. Default: AUTOMATIC. */
  int32_t reserved;

  /* Weight of the integral of the squared Laplacian of the fit, relative to the mean density of the weights, in the objective, for
   * samples that do not determine the fit; nonnegative. Default: 0. */
  double regularization;
} obc_harmonics_fit_options;

/* Figures of a fit. */
typedef struct obc_harmonics_fit_report {
  uint32_t struct_size;
  int32_t method;    /* algorithm used, DENSE or ITERATIVE */
  uint64_t unknowns; /* (L+1)^2 */

  /* Number of combinations of the unknowns that the samples determine. Below `unknowns` for a rank-deficient fit, which is then
   * approximately the best one of minimum norm; 0 where the iterative method finds the fit too ill-conditioned to decide (degree above 40). */
  uint64_t rank;

  double condition;    /* estimated condition number of the weighted basis matrix, within the rank */
  double residual;     /* square root of the weighted mean of |value - fit|^2 */
  uint64_t iterations; /* number of iterations of ITERATIVE */
} obc_harmonics_fit_report;

/* Figures of a refinement of a map. */
typedef struct obc_harmonics_refinement_report {
  uint32_t struct_size;
  uint32_t rounds;        /* number of rounds that lowered the residual */
  double residual_before; /* residual of a fit, as in obc_harmonics_fit_report, on the given map */
  double residual;        /* the same on the refined map, at most residual_before */
} obc_harmonics_refinement_report;

/* Fill options with the defaults, and a report with zeros and its size. */
OBC_API obc_status obc_harmonics_fit_options_init(obc_harmonics_fit_options *options, size_t struct_size);
OBC_API obc_status obc_harmonics_fit_report_init(obc_harmonics_fit_report *report, size_t struct_size);
OBC_API obc_status obc_harmonics_refinement_report_init(obc_harmonics_refinement_report *report, size_t struct_size);

/* Returns the number of coefficients up to a degree, (degree + 1)^2. */
OBC_API size_t obc_harmonics_size(uint32_t degree);

/* Evaluates all Y_lm at each direction: rows, count * (degree+1)^2 doubles, one direction after the other. host may be NULL.
 * O(count * degree^2). Errors: OBC_INVALID_ARGUMENT (NULL, not finite, zero length, degree), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_evaluate(const double *directions, size_t count, uint32_t degree, const obc_host *host,
                                          double *rows, obc_error *error);

/* Fits coefficients to values at scattered directions by weighted least squares. weights: one nonnegative number a direction, or NULL
 * for ones; those of obc_mesh_vertex_areas, the usual choice for a surface, weight each piece by its area. options, host and
 * report may be NULL. coefficients is written on success only. A rank-deficient fit is not an error: see report->rank. Errors: as
 * obc_harmonics_evaluate. */
OBC_API obc_status obc_harmonics_fit(const double *directions, const double *weights, const double *values, size_t count,
                                     size_t channels, const obc_harmonics_fit_options *options, const obc_host *host,
                                     double *coefficients, obc_harmonics_fit_report *report, obc_error *error);

/* Refines a sphere map for the expansion of its surface to the degree of the options: up to `rounds` times, fits the positions and moves each
 * direction, by one damped Gauss-Newton step, towards the point of the fitted surface that is nearest to its vertex. directions (3 *
 * vertex_count doubles, of any length) are changed to unit vectors, on success only. Triangles that are positive or negative on the
 * sphere beyond rounding keep their orientation, so that a bijection remains one; vertices of others do not move. The angles and
 * areas of the map are not controlled. weights as for obc_harmonics_fit; options, host and report may be NULL. O(rounds) fits.
 * Errors: as obc_harmonics_evaluate, and OBC_MALFORMED_FILE (kind index-range). */
OBC_API obc_status obc_harmonics_refine_map(const double *positions, size_t vertex_count, const uint32_t *triangles,
                                            size_t triangle_count, const double *weights,
                                            const obc_harmonics_fit_options *options, uint32_t rounds,
                                            const obc_host *host, double *directions,
                                            obc_harmonics_refinement_report *report, obc_error *error);

/* ---- reconstruction and comparison ----------------------------------------------------------------------------------- */

/* Evaluates the functions at directions: values, count * channels doubles, and unless gradients is NULL their tangential gradients on the unit
 * sphere, 3 * count * channels doubles. O(count * degree^2 * channels). Errors: as obc_harmonics_evaluate. */
OBC_API obc_status obc_harmonics_synthesize(const double *coefficients, uint32_t degree, size_t channels,
                                            const double *directions, size_t count, const obc_host *host, double *values,
                                            double *gradients, obc_error *error);

/* Computes the transpose of obc_harmonics_synthesize: coefficients, (degree+1)^2 * channels doubles, of which that of Y_lm is the sum of
 * weight * value * Y_lm over the directions. For iterative methods of the caller; what fits values best is the result of
 * obc_harmonics_fit. weights: one number a direction, or NULL for ones. The weights and values may be any numbers; sums with
 * those that are not finite are not finite. O(count * degree^2 * channels), from degree 80 O((count + degree^3) * channels).
 * coefficients is written on success only. host may be NULL. Errors: as obc_harmonics_evaluate. */
OBC_API obc_status obc_harmonics_analyze(const double *directions, const double *weights, const double *values, size_t count,
                                         size_t channels, uint32_t degree, const obc_host *host, double *coefficients,
                                         obc_error *error);

/* Computes the norm of each degree, the square root of the sum of squares over m and the channels: norms, degree + 1 doubles. It is
 * invariant under rotations of the sphere, and of the values of three channels. Errors: OBC_INVALID_ARGUMENT, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_degree_norms(const double *coefficients, uint32_t degree, size_t channels, double *norms,
                                              obc_error *error);

/* Computes the distance D_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
 * differences of the norms; missing degrees count as zero. first = 0 is the dissertation's; with first = 1 the positions of the
 * shapes have no effect. Errors: as obc_harmonics_degree_norms. */
OBC_API obc_status obc_harmonics_shape_distance(const double *f, uint32_t f_degree, const double *g, uint32_t g_degree,
                                                size_t channels, uint32_t first, uint32_t last, double *distance,
                                                obc_error *error);

/* Filters in place: keeps degrees from low to high and sets the others to zero, with a raised-cosine transition over `width` degrees
 * outside each end (0: none). keep_mean 1 preserves degree 0, the position of a shape. Errors: as obc_harmonics_degree_norms. */
OBC_API obc_status obc_harmonics_filter(double *coefficients, uint32_t degree, size_t channels, uint32_t low,
                                        uint32_t high, uint32_t width, int32_t keep_mean, obc_error *error);

/* ---- rotation and alignment ------------------------------------------------------------------------------------------ */

/* Rotates the functions with the sphere: the value at v moves to R v. rotation: the matrix R by rows, 9 doubles. turned may be
 * coefficients. The values are not rotated: for a rotation of a shape in space, multiply the three coefficients of each Y_lm by the
 * matrix. O(degree^3). Errors: OBC_INVALID_ARGUMENT (also: not a rotation), OBC_CANCELLED, OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_rotate(const double *coefficients, uint32_t degree, size_t channels,
                                        const double *rotation, const obc_host *host, double *turned, obc_error *error);

/* Options of an alignment. Fill with _init. */
typedef struct obc_harmonics_align_options {
  uint32_t struct_size;
  int32_t turn_values;    /* 1: also rotates the values of three channels, for shapes in different poses; 0: does not. Default: 0. */
  uint32_t search_degree; /* degree of the search over all rotations, 1 to 64. Default: 12. */
  uint32_t reserved;
} obc_harmonics_align_options;

/* Result of an alignment. */
typedef struct obc_harmonics_alignment {
  uint32_t struct_size;
  uint32_t reserved;
  double rotation[9]; /* matrix R by rows: directions v of `moving` map to R v */
  double values[9];   /* matrix Q by rows: values of `moving` are multiplied by Q; the identity without turn_values */
  double correlation; /* correlation after the alignment, without degree 0; at most 1 */
} obc_harmonics_alignment;

/* Fill options with the defaults, and an alignment with zeros and its size. */
OBC_API obc_status obc_harmonics_align_options_init(obc_harmonics_align_options *options, size_t struct_size);
OBC_API obc_status obc_harmonics_alignment_init(obc_harmonics_alignment *alignment, size_t struct_size);

/* Computes the rotation that best aligns `moving` with `fixed`: it maximizes the sum over the channels of the integral of
 * fixed(u) * (Q moving)(R^-1 u), without degree 0, by a search over a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
 * rotation group") and Newton's method up to the lower of the two degrees. options and host may be NULL.
 * O(search_degree^4 + degree^3). Errors: OBC_INVALID_ARGUMENT, OBC_NO_VALID_RESULT (one of them is constant), OBC_CANCELLED,
 * OBC_OUT_OF_MEMORY. */
OBC_API obc_status obc_harmonics_align(const double *fixed, uint32_t fixed_degree, const double *moving,
                                       uint32_t moving_degree, size_t channels,
                                       const obc_harmonics_align_options *options, const obc_host *host,
                                       obc_harmonics_alignment *alignment, obc_error *error);

/* ---- files ----------------------------------------------------------------------------------------------------------- */

/* File formats. Readers and writers convert between their conventions and the one above. */
enum {
  OBC_HARMONICS_BY_ENDING = 0, /* .sh .shtools .txt: SHTOOLS; .coef: SPHARM-PDM */
  OBC_HARMONICS_SHTOOLS = 1,   /* lines "l, m, C, S" for 0 <= m <= l, one block a channel: C = a_lm / sqrt(4 pi),
                                  S = a_l,-m / sqrt(4 pi) */
  OBC_HARMONICS_SPHARM_PDM = 2 /* three channels, "{ count,{x, y, z}, ...}": for m > 0 the cosine's (-1)^m sqrt 2 a_lm,
                                  then the sine's (-1)^m sqrt 2 a_l,-m */
};

/* Writes coefficients to a file, which is complete or does not appear; reading it returns the same numbers to their last bits. Errors:
 * OBC_INVALID_ARGUMENT, OBC_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC_IO, OBC_OUT_OF_MEMORY. The message starts
 * with the path. */
OBC_API obc_status obc_harmonics_write(const char *path, int32_t format, const double *coefficients, uint32_t degree,
                                       size_t channels, obc_error *error);

/* Coefficients read from a file, with its degree. Immutable: several threads may read them. */
typedef struct obc_harmonics_coefficients obc_harmonics_coefficients;

/* Reads a file and checks all its contents. host may be NULL; its allocator must remain valid until _destroy. Errors:
 * OBC_INVALID_ARGUMENT, OBC_MALFORMED_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with the line),
 * OBC_UNSUPPORTED, OBC_IO, OBC_CANCELLED, OBC_OUT_OF_MEMORY. The message starts with the path. */
OBC_API obc_status obc_harmonics_read(const char *path, int32_t format, const obc_host *host,
                                      obc_harmonics_coefficients **coefficients, obc_error *error);

/* Return the degree and the number of channels; 0 for NULL. */
OBC_API uint32_t obc_harmonics_coefficients_degree(const obc_harmonics_coefficients *coefficients);
OBC_API size_t obc_harmonics_coefficients_channels(const obc_harmonics_coefficients *coefficients);

/* Copies the coefficients: (degree+1)^2 * channels doubles. Errors: OBC_INVALID_ARGUMENT. */
OBC_API obc_status obc_harmonics_coefficients_copy(const obc_harmonics_coefficients *coefficients, double *values,
                                                   obc_error *error);

/* Destroys coefficients; NULL is allowed. */
OBC_API void obc_harmonics_coefficients_destroy(obc_harmonics_coefficients *coefficients);

/* Returns the version of the library, major * 10000 + minor * 100 + patch. */
OBC_API uint32_t obc_harmonics_version(void);

#ifdef __cplusplus
}
#endif

#endif
