//! What `<orbicube/harmonics.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use std::os::raw::{c_char};

/// DENSE if count \* size^2 \<= 5e8 or there are fewer samples than unknowns, otherwise ITERATIVE
pub const OBC_HARMONICS_AUTOMATIC: i32 = 0;
/// Householder QR with column pivoting: O(count \* size^2) time
pub const OBC_HARMONICS_DENSE: i32 = 1;
/// conjugate gradients on the normal equations, refined: O(count \* size) time
pub const OBC_HARMONICS_ITERATIVE: i32 = 2;

/// .sh .shtools .txt: SHTOOLS; .coef: SPHARM-PDM
pub const OBC_HARMONICS_BY_ENDING: i32 = 0;
/// lines "l, m, C, S" for 0 \<= m \<= l, one block a channel: C = a\_lm / sqrt(4 pi),
/// S = a\_l,-m / sqrt(4 pi)
pub const OBC_HARMONICS_SHTOOLS: i32 = 1;
/// three channels, "{ count,{x, y, z}, ...}": for m \> 0 the cosine's (-1)^m sqrt 2 a\_lm,
/// then the sine's (-1)^m sqrt 2 a\_l,-m
pub const OBC_HARMONICS_SPHARM_PDM: i32 = 2;

/// Coefficients read from a file, with its degree. Immutable: several threads may read them.
#[repr(C)]
pub struct obc_harmonics_coefficients {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Options of a fit. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_harmonics_fit_options {
    pub struct_size: u32,
    /// maximum degree L, up to 1000. Default: 16.
    pub degree: u32,
    /// OBC\_HARMONICS\_AUTOMATIC, DENSE or ITERATIVE. Default: AUTOMATIC.
    pub method: i32,
    pub reserved: i32,
    /// Weight of the integral of the squared Laplacian of the fit, relative to the mean density of the weights, in the objective, for
    /// samples that do not determine the fit; nonnegative. Default: 0.
    pub regularization: f64,
}

/// Figures of a fit.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_harmonics_fit_report {
    pub struct_size: u32,
    /// algorithm used, DENSE or ITERATIVE
    pub method: i32,
    /// (L+1)^2
    pub unknowns: u64,
    /// Number of combinations of the unknowns that the samples determine. Below \`unknowns\` for a rank-deficient fit, which is then
    /// approximately the best one of minimum norm; 0 where the iterative method finds the fit too ill-conditioned to decide (degree above 40).
    pub rank: u64,
    /// estimated condition number of the weighted basis matrix, within the rank
    pub condition: f64,
    /// square root of the weighted mean of |value - fit|^2
    pub residual: f64,
    /// number of iterations of ITERATIVE
    pub iterations: u64,
}

/// Figures of a refinement of a map.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_harmonics_refinement_report {
    pub struct_size: u32,
    /// number of rounds that lowered the residual
    pub rounds: u32,
    /// residual of a fit, as in obc\_harmonics\_fit\_report, on the given map
    pub residual_before: f64,
    /// the same on the refined map, at most residual\_before
    pub residual: f64,
}

/// Options of an alignment. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_harmonics_align_options {
    pub struct_size: u32,
    /// 1: also rotates the values of three channels, for shapes in different poses; 0: does not. Default: 0.
    pub turn_values: i32,
    /// degree of the search over all rotations, 1 to 64. Default: 12.
    pub search_degree: u32,
    pub reserved: u32,
}

/// Result of an alignment.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_harmonics_alignment {
    pub struct_size: u32,
    pub reserved: u32,
    /// matrix R by rows: directions v of \`moving\` map to R v
    pub rotation: [f64; 9],
    /// matrix Q by rows: values of \`moving\` are multiplied by Q; the identity without turn\_values
    pub values: [f64; 9],
    /// correlation after the alignment, without degree 0; at most 1
    pub correlation: f64,
}

extern "C" {
    /// Fill options with the defaults, and a report with zeros and its size.
    pub fn obc_harmonics_fit_options_init(options: *mut obc_harmonics_fit_options, struct_size: usize) -> i32;
    /// Fill options with the defaults, and a report with zeros and its size.
    pub fn obc_harmonics_fit_report_init(report: *mut obc_harmonics_fit_report, struct_size: usize) -> i32;
    /// Fill options with the defaults, and a report with zeros and its size.
    pub fn obc_harmonics_refinement_report_init(report: *mut obc_harmonics_refinement_report, struct_size: usize) -> i32;
    /// Returns the number of coefficients up to a degree, (degree + 1)^2.
    pub fn obc_harmonics_size(degree: u32) -> usize;
    /// Evaluates all Y\_lm at each direction: rows, count \* (degree+1)^2 doubles, one direction after the other. host may be NULL.
    /// O(count \* degree^2). Errors: OBC\_INVALID\_ARGUMENT (NULL, not finite, zero length, degree), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_harmonics_evaluate(directions: *const f64, count: usize, degree: u32, host: *const obc_host, rows: *mut f64, error: *mut obc_error) -> i32;
    /// Fits coefficients to values at scattered directions by weighted least squares. weights: one nonnegative number a direction, or NULL
    /// for ones; those of obc\_mesh\_vertex\_areas, the usual choice for a surface, weight each piece by its area. options, host and
    /// report may be NULL. coefficients is written on success only. A rank-deficient fit is not an error: see report-\>rank. Errors: as
    /// obc\_harmonics\_evaluate.
    pub fn obc_harmonics_fit(directions: *const f64, weights: *const f64, values: *const f64, count: usize, channels: usize, options: *const obc_harmonics_fit_options, host: *const obc_host, coefficients: *mut f64, report: *mut obc_harmonics_fit_report, error: *mut obc_error) -> i32;
    /// Refines a sphere map for the expansion of its surface to the degree of the options: up to \`rounds\` times, fits the positions and moves each
    /// direction, by one damped Gauss-Newton step, towards the point of the fitted surface that is nearest to its vertex. directions (3 \*
    /// vertex\_count doubles, of any length) are changed to unit vectors, on success only. Triangles that are positive or negative on the
    /// sphere beyond rounding keep their orientation, so that a bijection remains one; vertices of others do not move. The angles and
    /// areas of the map are not controlled. weights as for obc\_harmonics\_fit; options, host and report may be NULL. O(rounds) fits.
    /// Errors: as obc\_harmonics\_evaluate, and OBC\_MALFORMED\_FILE (kind index-range).
    pub fn obc_harmonics_refine_map(positions: *const f64, vertex_count: usize, triangles: *const u32, triangle_count: usize, weights: *const f64, options: *const obc_harmonics_fit_options, rounds: u32, host: *const obc_host, directions: *mut f64, report: *mut obc_harmonics_refinement_report, error: *mut obc_error) -> i32;
    /// Evaluates the functions at directions: values, count \* channels doubles, and unless gradients is NULL their tangential gradients on the unit
    /// sphere, 3 \* count \* channels doubles. O(count \* degree^2 \* channels). Errors: as obc\_harmonics\_evaluate.
    pub fn obc_harmonics_synthesize(coefficients: *const f64, degree: u32, channels: usize, directions: *const f64, count: usize, host: *const obc_host, values: *mut f64, gradients: *mut f64, error: *mut obc_error) -> i32;
    /// Computes the transpose of obc\_harmonics\_synthesize: coefficients, (degree+1)^2 \* channels doubles, of which that of Y\_lm is the sum of
    /// weight \* value \* Y\_lm over the directions. For iterative methods of the caller; what fits values best is the result of
    /// obc\_harmonics\_fit. weights: one number a direction, or NULL for ones. The weights and values may be any numbers; sums with
    /// those that are not finite are not finite. O(count \* degree^2 \* channels), from degree 80 O((count + degree^3) \* channels).
    /// coefficients is written on success only. host may be NULL. Errors: as obc\_harmonics\_evaluate.
    pub fn obc_harmonics_analyze(directions: *const f64, weights: *const f64, values: *const f64, count: usize, channels: usize, degree: u32, host: *const obc_host, coefficients: *mut f64, error: *mut obc_error) -> i32;
    /// Computes the norm of each degree, the square root of the sum of squares over m and the channels: norms, degree + 1 doubles. It is
    /// invariant under rotations of the sphere, and of the values of three channels. Errors: OBC\_INVALID\_ARGUMENT, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_harmonics_degree_norms(coefficients: *const f64, degree: u32, channels: usize, norms: *mut f64, error: *mut obc_error) -> i32;
    /// Computes the distance D\_n(f, g) of the dissertation's section 3.3.3: the sum over the degrees from first to last of the squared
    /// differences of the norms; missing degrees count as zero. first = 0 is the dissertation's; with first = 1 the positions of the
    /// shapes have no effect. Errors: as obc\_harmonics\_degree\_norms.
    pub fn obc_harmonics_shape_distance(f: *const f64, f_degree: u32, g: *const f64, g_degree: u32, channels: usize, first: u32, last: u32, distance: *mut f64, error: *mut obc_error) -> i32;
    /// Filters in place: keeps degrees from low to high and sets the others to zero, with a raised-cosine transition over \`width\` degrees
    /// outside each end (0: none). keep\_mean 1 preserves degree 0, the position of a shape. Errors: as obc\_harmonics\_degree\_norms.
    pub fn obc_harmonics_filter(coefficients: *mut f64, degree: u32, channels: usize, low: u32, high: u32, width: u32, keep_mean: i32, error: *mut obc_error) -> i32;
    /// Rotates the functions with the sphere: the value at v moves to R v. rotation: the matrix R by rows, 9 doubles. turned may be
    /// coefficients. The values are not rotated: for a rotation of a shape in space, multiply the three coefficients of each Y\_lm by the
    /// matrix. O(degree^3). Errors: OBC\_INVALID\_ARGUMENT (also: not a rotation), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_harmonics_rotate(coefficients: *const f64, degree: u32, channels: usize, rotation: *const f64, host: *const obc_host, turned: *mut f64, error: *mut obc_error) -> i32;
    /// Fill options with the defaults, and an alignment with zeros and its size.
    pub fn obc_harmonics_align_options_init(options: *mut obc_harmonics_align_options, struct_size: usize) -> i32;
    /// Fill options with the defaults, and an alignment with zeros and its size.
    pub fn obc_harmonics_alignment_init(alignment: *mut obc_harmonics_alignment, struct_size: usize) -> i32;
    /// Computes the rotation that best aligns \`moving\` with \`fixed\`: it maximizes the sum over the channels of the integral of
    /// fixed(u) \* (Q moving)(R^-1 u), without degree 0, by a search over a grid of all rotations (Kostelec and Rockmore 2008, "FFTs on the
    /// rotation group") and Newton's method up to the lower of the two degrees. options and host may be NULL.
    /// O(search\_degree^4 + degree^3). Errors: OBC\_INVALID\_ARGUMENT, OBC\_NO\_VALID\_RESULT (one of them is constant), OBC\_CANCELLED,
    /// OBC\_OUT\_OF\_MEMORY.
    pub fn obc_harmonics_align(fixed: *const f64, fixed_degree: u32, moving: *const f64, moving_degree: u32, channels: usize, options: *const obc_harmonics_align_options, host: *const obc_host, alignment: *mut obc_harmonics_alignment, error: *mut obc_error) -> i32;
    /// Writes coefficients to a file, which is complete or does not appear; reading it returns the same numbers to their last bits. Errors:
    /// OBC\_INVALID\_ARGUMENT, OBC\_UNSUPPORTED (ending; channels other than 3 for SPHARM-PDM), OBC\_IO, OBC\_OUT\_OF\_MEMORY. The message starts
    /// with the path.
    pub fn obc_harmonics_write(path: *const c_char, format: i32, coefficients: *const f64, degree: u32, channels: usize, error: *mut obc_error) -> i32;
    /// Reads a file and checks all its contents. host may be NULL; its allocator must remain valid until \_destroy. Errors:
    /// OBC\_INVALID\_ARGUMENT, OBC\_MALFORMED\_FILE (empty-file, bad-magic, parse, truncated, trailing-data, non-finite, with the line),
    /// OBC\_UNSUPPORTED, OBC\_IO, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY. The message starts with the path.
    pub fn obc_harmonics_read(path: *const c_char, format: i32, host: *const obc_host, coefficients: *mut *mut obc_harmonics_coefficients, error: *mut obc_error) -> i32;
    /// Return the degree and the number of channels; 0 for NULL.
    pub fn obc_harmonics_coefficients_degree(coefficients: *const obc_harmonics_coefficients) -> u32;
    /// Return the degree and the number of channels; 0 for NULL.
    pub fn obc_harmonics_coefficients_channels(coefficients: *const obc_harmonics_coefficients) -> usize;
    /// Copies the coefficients: (degree+1)^2 \* channels doubles. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_harmonics_coefficients_copy(coefficients: *const obc_harmonics_coefficients, values: *mut f64, error: *mut obc_error) -> i32;
    /// Destroys coefficients; NULL is allowed.
    pub fn obc_harmonics_coefficients_destroy(coefficients: *mut obc_harmonics_coefficients);
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_harmonics_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_harmonics_fit_options>(), align_of::<obc_harmonics_fit_options>()), (24, 8));
        let it = MaybeUninit::<obc_harmonics_fit_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_harmonics_fit_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).degree) } as usize - start as usize, 4, "obc_harmonics_fit_options.degree");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 8, "obc_harmonics_fit_options.method");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 12, "obc_harmonics_fit_options.reserved");
        assert_eq!(unsafe { addr_of!((*start).regularization) } as usize - start as usize, 16, "obc_harmonics_fit_options.regularization");
        assert_eq!((size_of::<obc_harmonics_fit_report>(), align_of::<obc_harmonics_fit_report>()), (48, 8));
        let it = MaybeUninit::<obc_harmonics_fit_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_harmonics_fit_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_harmonics_fit_report.method");
        assert_eq!(unsafe { addr_of!((*start).unknowns) } as usize - start as usize, 8, "obc_harmonics_fit_report.unknowns");
        assert_eq!(unsafe { addr_of!((*start).rank) } as usize - start as usize, 16, "obc_harmonics_fit_report.rank");
        assert_eq!(unsafe { addr_of!((*start).condition) } as usize - start as usize, 24, "obc_harmonics_fit_report.condition");
        assert_eq!(unsafe { addr_of!((*start).residual) } as usize - start as usize, 32, "obc_harmonics_fit_report.residual");
        assert_eq!(unsafe { addr_of!((*start).iterations) } as usize - start as usize, 40, "obc_harmonics_fit_report.iterations");
        assert_eq!((size_of::<obc_harmonics_refinement_report>(), align_of::<obc_harmonics_refinement_report>()), (24, 8));
        let it = MaybeUninit::<obc_harmonics_refinement_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_harmonics_refinement_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).rounds) } as usize - start as usize, 4, "obc_harmonics_refinement_report.rounds");
        assert_eq!(unsafe { addr_of!((*start).residual_before) } as usize - start as usize, 8, "obc_harmonics_refinement_report.residual_before");
        assert_eq!(unsafe { addr_of!((*start).residual) } as usize - start as usize, 16, "obc_harmonics_refinement_report.residual");
        assert_eq!((size_of::<obc_harmonics_align_options>(), align_of::<obc_harmonics_align_options>()), (16, 4));
        let it = MaybeUninit::<obc_harmonics_align_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_harmonics_align_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).turn_values) } as usize - start as usize, 4, "obc_harmonics_align_options.turn_values");
        assert_eq!(unsafe { addr_of!((*start).search_degree) } as usize - start as usize, 8, "obc_harmonics_align_options.search_degree");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 12, "obc_harmonics_align_options.reserved");
        assert_eq!((size_of::<obc_harmonics_alignment>(), align_of::<obc_harmonics_alignment>()), (160, 8));
        let it = MaybeUninit::<obc_harmonics_alignment>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_harmonics_alignment.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_harmonics_alignment.reserved");
        assert_eq!(unsafe { addr_of!((*start).rotation) } as usize - start as usize, 8, "obc_harmonics_alignment.rotation");
        assert_eq!(unsafe { addr_of!((*start).values) } as usize - start as usize, 80, "obc_harmonics_alignment.values");
        assert_eq!(unsafe { addr_of!((*start).correlation) } as usize - start as usize, 152, "obc_harmonics_alignment.correlation");
    }
}
