//! What `<orbicube/sphere_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::{obc_mesh, obc_surface};
use std::os::raw::{c_char, c_void};

/// angle\_weight E\_D + area\_weight E\_A and a barrier on the worst triangle
pub const OBC_SPHERE_MAP_BALANCED: i32 = 0;
/// angle\_weight E\_D + area\_weight E\_A alone, to a local minimum
pub const OBC_SPHERE_MAP_ANGLE_AREA: i32 = 1;
/// the symmetric Dirichlet energy; the weights are unused, as in the next two
pub const OBC_SPHERE_MAP_ISOMETRIC: i32 = 2;
/// the L2 stretch of Praun and Hoppe
pub const OBC_SPHERE_MAP_STRETCH: i32 = 3;
/// E\_D alone
pub const OBC_SPHERE_MAP_CONFORMAL: i32 = 4;
/// the dissertation's chapter 3 as printed, corrected only where it would fail
pub const OBC_SPHERE_MAP_DISSERTATION: i32 = 5;

/// number of 1-to-4 subdivisions, 0 to 10; 10 \* 4^n + 2 vertices
pub const OBC_SPHERE_MAP_ICOSPHERE: i32 = 0;
/// quads along an edge of the cube, 1 to 4096; 6 n^2 + 2 vertices
pub const OBC_SPHERE_MAP_CUBE: i32 = 1;
/// bands from pole to pole, 2 to 8192; 2 n (n - 1) + 2 vertices
pub const OBC_SPHERE_MAP_LATITUDE: i32 = 2;
/// quads along a side of the square, even, 2 to 8192; n^2 + 2 vertices
pub const OBC_SPHERE_MAP_OCTAHEDRON: i32 = 3;

/// Point location in a map: a walk between triangles by exact determinants (Devillers, Pion and Teillaud 2002) that starts near the
/// direction; see docs/sphere\_map\_uses.md. A locator keeps copies of its inputs. Several threads may use one locator at the same time.
/// Query directions are finite, nonzero and of any length: 3 \* count doubles.
#[repr(C)]
pub struct obc_sphere_map_locator {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A smooth bijection of the sphere that maps landmarks onto landmarks: the flow of minimum energy (Joshi and Miller 2000; Glaunes,
/// Vaillant and Miller 2004) on the vertices of an icosphere, every triangle positive by exact arithmetic. Several threads may use
/// one warp at the same time.
#[repr(C)]
pub struct obc_sphere_map_warp {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Receives the convergence of OBC\_SPHERE\_MAP\_DISSERTATION (the dissertation's Figure 3.2) at the end of a level, and during the last level once for each
/// vertex\_count iterations: iterations, the number of calls of its Algorithm 2 for one vertex; vertices, the vertex count of the
/// refined mesh; energy, the energy of that mesh. iterations restarts at 0 when the map restarts. Runs on the thread that called
/// the library.
pub type obc_sphere_map_trace_function = Option<unsafe extern "C" fn(iterations: u64, vertices: u64, energy: f64, user: *mut c_void)>;

/// Options of a map. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_map_options {
    pub struct_size: u32,
    /// OBC\_SPHERE\_MAP\_BALANCED or another. Default: BALANCED.
    pub method: i32,
    /// weight of E\_D (lambda of the dissertation's eq. 3.5), nonnegative. Default: 0.1.
    pub angle_weight: f64,
    /// weight of E\_A (mu of eq. 3.5), nonnegative; one of the two weights is positive. Default: 1.
    pub area_weight: f64,
    /// seed of the order of equally good decimation steps. Default: 0.
    pub seed: u64,
    /// receives the convergence of OBC\_SPHERE\_MAP\_DISSERTATION; NULL: none. Default: NULL.
    pub trace: obc_sphere_map_trace_function,
    /// passed to trace. Default: NULL.
    pub trace_user: *mut c_void,
    /// Parameters of the dissertation's Algorithm 1, which OBC\_SPHERE\_MAP\_DISSERTATION uses and the other methods do not. An optimization
    /// ends when the mean gain of its last iterations (level\_splits of them on a level, vertex\_count at the end) is below tolerance \* E
    /// / vertices, or at its maximum number of iterations. The dissertation prints the first default only.
    /// eta: vertex splits between two optimizations, 1 to 1000000000. Default: 40.
    pub level_splits: u64,
    /// epsilon^eta, of the optimization of a level, nonnegative; 0: no such end. Default: 1e-4.
    pub level_tolerance: f64,
    /// epsilon^F, of the final optimization, nonnegative; 0: no such end. Default: 1e-4.
    pub final_tolerance: f64,
    /// Iter\_max^eta, on a level; 0: 50 \* level\_splits. Default: 0.
    pub max_level_iterations: u64,
    /// Iter\_max^F, at the end; 0: 100 \* vertex\_count. Default: 0.
    pub max_final_iterations: u64,
}

/// Figures of a map, for a surface scaled to the area of the unit sphere, 4 pi. sigma\_1 \>= sigma\_2 are the singular values of the affine
/// map from a surface triangle T to its flat spherical triangle t, d is the distance of t from the origin. Vertices in no
/// triangle do not count. Energies, distortions, ratios and means leave out degenerate triangles, whose angles are rounding errors:
/// those with a height of at most 1e-6 of the longest side, or at most 4 rounding units of the largest coordinate (2^-24 of it where
/// all coordinates of the surface are float32 values, otherwise 2^-53).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_map_report {
    pub struct_size: u32,
    /// 1: no triangle is flipped or degenerate by exact arithmetic, and the degree is 1; 0: otherwise
    pub bijective: i32,
    /// 1: most triangles are clockwise on the sphere, as for an inward-oriented surface; 0: otherwise
    pub mirrored: i32,
    pub reserved: i32,
    /// number of triangles oriented against the majority, by exact arithmetic
    pub flipped: u64,
    /// number of triangles with zero area on the sphere, by exact arithmetic
    pub degenerate: u64,
    /// number of degenerate triangles on the surface, as defined above
    pub zero_area_faces: u64,
    /// sum of the signed solid angles / 4 pi
    pub degree: f64,
    /// E\_D = sum d^-2 (cot a |a|^2 + cot b |b|^2 + cot c |c|^2); at least 16 pi
    pub energy_angle: f64,
    /// E\_A = sum d^-2 area(t)^2 / area(T); at least 4 pi in the limit of fine meshes, on coarse ones a little less
    pub energy_area: f64,
    /// angle\_weight E\_D + area\_weight E\_A
    pub energy: f64,
    /// maximum quasi-conformal distortion sigma\_1 / sigma\_2, at least 1
    pub max_quasi_conformal: f64,
    /// mean quasi-conformal distortion, weighted by surface area, at least 1
    pub mean_quasi_conformal: f64,
    /// minimum and maximum of solid angle / surface area of a triangle
    pub min_area_ratio: f64,
    /// minimum and maximum of solid angle / surface area of a triangle
    pub max_area_ratio: f64,
    /// 1 / mean of (sigma\_1^-2 + sigma\_2^-2) / 2, weighted by surface area (L2 stretch), at most 1
    pub stretch_efficiency: f64,
    /// mean of (sigma\_1^2 + sigma\_2^2 + sigma\_1^-2 + sigma\_2^-2) / 4, weighted by surface area, at least 1
    pub isometric_mean: f64,
    /// Energies of the dissertation as printed, with D = cot a |a|^2 + cot b |b|^2 + cot c |c|^2 for the angles a, b, c of T and the
    /// opposite edges of t, and area(t) the area of the flat triangle t. Eq. 3.1 and 3.3 vanish under refinement, since D is an integral
    /// over t already: energy\_angle is eq. 3.3 with D as E\_D(T) area(t), a density.
    /// sum D area(t)
    pub equation_3_1: f64,
    /// sum area(t)^2 / area(T)
    pub equation_3_2: f64,
    /// sum d^-2 D area(t)
    pub equation_3_3: f64,
    /// sum d^-2 area(t)^2 / area(T); equal to energy\_area
    pub equation_3_4: f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_sphere_map_options_init(options: *mut obc_sphere_map_options, struct_size: usize) -> i32;
    /// Fills a report with zeros and its size, which obc\_sphere\_map\_compute and \_measure require.
    pub fn obc_sphere_map_report_init(report: *mut obc_sphere_map_report, struct_size: usize) -> i32;
    /// Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. An inward-oriented surface is
    /// mapped as seen from outside, with triangles clockwise on the sphere. Vertices in no triangle receive some unit vector. options,
    /// report and host may be NULL. directions: 3 \* vertex\_count doubles, written on success only. O(n log n) time, up to 1 KB a
    /// vertex. Errors: OBC\_INVALID\_ARGUMENT (NULL, NaN, index out of range, options), OBC\_NOT\_CLOSED, OBC\_NOT\_MANIFOLD,
    /// OBC\_WRONG\_GENUS, OBC\_DEGENERATE, OBC\_NO\_VALID\_RESULT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_compute(surface: *const obc_surface, options: *const obc_sphere_map_options, host: *const obc_host, directions: *mut f64, report: *mut obc_sphere_map_report, error: *mut obc_error) -> i32;
    /// Maps a surface as obc\_sphere\_map\_compute does, and keeps a partial map after OBC\_NO\_VALID\_RESULT or OBC\_CANCELLED: \*placed is the
    /// number of vertices with directions of their own, whose triangles are positive by exact arithmetic (clockwise for an
    /// inward-oriented surface). Every other vertex has the direction of the vertex it was merged into, so that its triangles have zero area. If
    /// \*placed is the number of vertices in triangles, the map is a bijection whose optimization is incomplete. After other errors, and
    /// if the work ended early, \*placed is 0 and directions are unchanged. report is written on success only;
    /// obc\_sphere\_map\_measure measures partial maps. Errors: as obc\_sphere\_map\_compute.
    pub fn obc_sphere_map_compute_partial(surface: *const obc_surface, options: *const obc_sphere_map_options, host: *const obc_host, directions: *mut f64, placed: *mut usize, report: *mut obc_sphere_map_report, error: *mut obc_error) -> i32;
    /// Measures a map, valid or not: directions (3 \* vertex\_count doubles, normalized before use) of the surface. Of options only the weights
    /// are used; options and host may be NULL. O(n). Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY. An invalid map is not
    /// an error: see report-\>bijective.
    pub fn obc_sphere_map_measure(surface: *const obc_surface, directions: *const f64, options: *const obc_sphere_map_options, host: *const obc_host, report: *mut obc_sphere_map_report, error: *mut obc_error) -> i32;
    /// Computes the distortion of each triangle: quasi-conformal distortion and area ratio as in the report, triangle\_count
    /// doubles each; either array may be NULL. Degenerate triangles (see obc\_sphere\_map\_report) have an infinite distortion and the ratio
    /// 0. O(n). Errors: as obc\_sphere\_map\_measure.
    pub fn obc_sphere_map_face_distortion(surface: *const obc_surface, directions: *const f64, host: *const obc_host, quasi_conformal: *mut f64, area_ratio: *mut f64, error: *mut obc_error) -> i32;
    /// Rounds a map to float32, the precision of GLB and of engines, and moves vertices of triangles that rounding flips to nearby points.
    /// rounded: 3 \* vertex\_count floats; all triangles are positive by exact arithmetic on success. Errors: OBC\_INVALID\_ARGUMENT,
    /// OBC\_NO\_VALID\_RESULT (float32 cannot represent the map), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_round_to_float(surface: *const obc_surface, directions: *const f64, host: *const obc_host, rounded: *mut f32, error: *mut obc_error) -> i32;
    /// Creates a locator from a bijective map (every triangle positive by exact arithmetic, or every triangle negative), with directions of
    /// length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its allocator is
    /// used until obc\_sphere\_map\_locator\_destroy. O(n) time, about 100 bytes a vertex. Errors: OBC\_INVALID\_ARGUMENT (also for a map
    /// that is not bijective), OBC\_NOT\_CLOSED, OBC\_NOT\_MANIFOLD, OBC\_DEGENERATE, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_locator_create(surface: *const obc_surface, directions: *const f64, host: *const obc_host, out: *mut *mut obc_sphere_map_locator, error: *mut obc_error) -> i32;
    /// Destroys a locator; NULL is allowed.
    pub fn obc_sphere_map_locator_destroy(locator: *mut obc_sphere_map_locator);
    /// Finds for each direction the triangle that contains it, exactly; on an edge or a vertex the lowest adjacent triangle. weights are the
    /// barycentric coordinates of the intersection of the ray with the flat triangle of the map, nonnegative with sum 1, and
    /// exactly 0 for a direction on the opposite edge. triangles: count indices, or NULL; weights: 3 \* count doubles, or NULL. Uses the
    /// threads of the host (or NULL). After a failure the arrays are undefined. Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED,
    /// OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_locate(locator: *const obc_sphere_map_locator, directions: *const f64, count: usize, host: *const obc_host, triangles: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Interpolates values of the vertices, such as positions, normals or colors, at each direction. values: components \* vertex\_count
    /// doubles; sampled: components \* count. unit 1 scales each result to length 1 (for normals), 0 does not. The direction of a vertex
    /// returns the values of the vertex. Errors: as obc\_sphere\_map\_locate.
    pub fn obc_sphere_map_sample(locator: *const obc_sphere_map_locator, directions: *const f64, count: usize, values: *const f64, components: usize, unit: i32, host: *const obc_host, sampled: *mut f64, error: *mut obc_error) -> i32;
    /// Creates a regular triangulation with unit vectors for positions. \*out is destroyed with obc\_mesh\_destroy; the allocator of the host is
    /// used until then. O(size). Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_grid(grid: i32, resolution: usize, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Resamples a surface on a regular triangulation: positions (3 \* vertex\_count doubles) interpolated at its directions. Otherwise as
    /// obc\_sphere\_map\_grid.
    pub fn obc_sphere_map_remesh(locator: *const obc_sphere_map_locator, positions: *const f64, grid: i32, resolution: usize, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Computes the size of a geometry image (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 \* width \*
    /// height doubles, row by row from the top. OBC\_SPHERE\_MAP\_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC\_SPHERE\_MAP\_CUBE
    /// six tiles of that size, 3 by 2: +x -x +y, below -y +z -z. Pixels on both sides of a cut are equal. resolution: up to
    /// 4096. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_sphere_map_image_size(layout: i32, resolution: usize, width: *mut usize, height: *mut usize, error: *mut obc_error) -> i32;
    /// Computes a geometry image of positions (3 \* vertex\_count doubles) or other vectors of the vertices. pixels is written on success
    /// only. Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_image(locator: *const obc_sphere_map_locator, positions: *const f64, layout: i32, resolution: usize, host: *const obc_host, pixels: *mut f64, error: *mut obc_error) -> i32;
    /// Reconstructs the closed surface of a geometry image. seam\_gap (or NULL) receives the maximum distance between pixels of one vertex, whose
    /// position is their mean. Errors: OBC\_INVALID\_ARGUMENT (also a pixel that is not finite), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_image_surface(pixels: *const f64, layout: i32, resolution: usize, host: *const obc_host, out: *mut *mut obc_mesh, seam_gap: *mut f64, error: *mut obc_error) -> i32;
    /// Writes a geometry image in the format of the file ending: .pfm (float32) or .png (16 bits a channel, relative to the bounding box,
    /// which a text chunk stores). The file is complete or does not appear. Errors: OBC\_INVALID\_ARGUMENT, OBC\_UNSUPPORTED, OBC\_IO, OBC\_CANCELLED,
    /// OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_image_write(path: *const c_char, pixels: *const f64, layout: i32, resolution: usize, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Reads layout and resolution of a geometry image, and its pixels into an array of \`capacity\` doubles unless pixels is NULL. A PNG file
    /// without the text chunk has the unit cube for bounding box. Errors: as obc\_sphere\_map\_image\_write, and OBC\_MALFORMED\_FILE.
    pub fn obc_sphere_map_image_read(path: *const c_char, host: *const obc_host, layout: *mut i32, resolution: *mut usize, pixels: *mut f64, capacity: usize, error: *mut obc_error) -> i32;
    /// Computes the rotation, row by row, that maps \`from\` nearest to \`to\` in the least-squares sense (Kabsch 1976): 3 \* count doubles each,
    /// scaled to length 1. Where the pairs do not determine it, the rotation of minimum angle. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_sphere_map_best_rotation(from: *const f64, to: *const f64, count: usize, rotation: *mut f64, error: *mut obc_error) -> i32;
    /// Creates a warp that maps from\[i\] to to\[i\]: 3 \* count doubles each, of any length, with a distance of at least 0.01 between landmarks.
    /// The allocator of the host is used until the warp is destroyed. Errors: OBC\_INVALID\_ARGUMENT, OBC\_NO\_VALID\_RESULT (the paths of
    /// two landmarks cross), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_warp_create(from: *const f64, to: *const f64, count: usize, host: *const obc_host, out: *mut *mut obc_sphere_map_warp, error: *mut obc_error) -> i32;
    /// Destroys a warp; NULL is allowed.
    pub fn obc_sphere_map_warp_destroy(warp: *mut obc_sphere_map_warp);
    /// Maps directions (3 \* count doubles) by a warp (backward 0) or its inverse (backward 1); moved may be directions itself. Errors:
    /// OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_warp_apply(warp: *const obc_sphere_map_warp, directions: *const f64, count: usize, backward: i32, host: *const obc_host, moved: *mut f64, error: *mut obc_error) -> i32;
    /// Computes one triangulation of the sphere with the vertices of two maps: those of the second are inserted into the triangles of the
    /// first, whose edges are preserved; vertices at the same direction are merged. Only triangles and counts of the surfaces are used. \*out
    /// (positions: unit vectors) begins with the vertices of the first map, in its order. second\_vertex (vertex\_count of the second surface, or
    /// NULL) receives the vertex of \*out of each vertex of the second map (UINT32\_MAX: in no triangle). Every triangle is positive. Errors: as
    /// obc\_sphere\_map\_locator\_create, for the first map.
    pub fn obc_sphere_map_overlay(first: *const obc_surface, first_directions: *const f64, second: *const obc_surface, second_directions: *const f64, host: *const obc_host, out: *mut *mut obc_mesh, second_vertex: *mut u32, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_sphere_map_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_sphere_map_options>(), align_of::<obc_sphere_map_options>()), (88, 8));
        let it = MaybeUninit::<obc_sphere_map_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_map_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_sphere_map_options.method");
        assert_eq!(unsafe { addr_of!((*start).angle_weight) } as usize - start as usize, 8, "obc_sphere_map_options.angle_weight");
        assert_eq!(unsafe { addr_of!((*start).area_weight) } as usize - start as usize, 16, "obc_sphere_map_options.area_weight");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 24, "obc_sphere_map_options.seed");
        assert_eq!(unsafe { addr_of!((*start).trace) } as usize - start as usize, 32, "obc_sphere_map_options.trace");
        assert_eq!(unsafe { addr_of!((*start).trace_user) } as usize - start as usize, 40, "obc_sphere_map_options.trace_user");
        assert_eq!(unsafe { addr_of!((*start).level_splits) } as usize - start as usize, 48, "obc_sphere_map_options.level_splits");
        assert_eq!(unsafe { addr_of!((*start).level_tolerance) } as usize - start as usize, 56, "obc_sphere_map_options.level_tolerance");
        assert_eq!(unsafe { addr_of!((*start).final_tolerance) } as usize - start as usize, 64, "obc_sphere_map_options.final_tolerance");
        assert_eq!(unsafe { addr_of!((*start).max_level_iterations) } as usize - start as usize, 72, "obc_sphere_map_options.max_level_iterations");
        assert_eq!(unsafe { addr_of!((*start).max_final_iterations) } as usize - start as usize, 80, "obc_sphere_map_options.max_final_iterations");
        assert_eq!((size_of::<obc_sphere_map_report>(), align_of::<obc_sphere_map_report>()), (152, 8));
        let it = MaybeUninit::<obc_sphere_map_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_map_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).bijective) } as usize - start as usize, 4, "obc_sphere_map_report.bijective");
        assert_eq!(unsafe { addr_of!((*start).mirrored) } as usize - start as usize, 8, "obc_sphere_map_report.mirrored");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 12, "obc_sphere_map_report.reserved");
        assert_eq!(unsafe { addr_of!((*start).flipped) } as usize - start as usize, 16, "obc_sphere_map_report.flipped");
        assert_eq!(unsafe { addr_of!((*start).degenerate) } as usize - start as usize, 24, "obc_sphere_map_report.degenerate");
        assert_eq!(unsafe { addr_of!((*start).zero_area_faces) } as usize - start as usize, 32, "obc_sphere_map_report.zero_area_faces");
        assert_eq!(unsafe { addr_of!((*start).degree) } as usize - start as usize, 40, "obc_sphere_map_report.degree");
        assert_eq!(unsafe { addr_of!((*start).energy_angle) } as usize - start as usize, 48, "obc_sphere_map_report.energy_angle");
        assert_eq!(unsafe { addr_of!((*start).energy_area) } as usize - start as usize, 56, "obc_sphere_map_report.energy_area");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 64, "obc_sphere_map_report.energy");
        assert_eq!(unsafe { addr_of!((*start).max_quasi_conformal) } as usize - start as usize, 72, "obc_sphere_map_report.max_quasi_conformal");
        assert_eq!(unsafe { addr_of!((*start).mean_quasi_conformal) } as usize - start as usize, 80, "obc_sphere_map_report.mean_quasi_conformal");
        assert_eq!(unsafe { addr_of!((*start).min_area_ratio) } as usize - start as usize, 88, "obc_sphere_map_report.min_area_ratio");
        assert_eq!(unsafe { addr_of!((*start).max_area_ratio) } as usize - start as usize, 96, "obc_sphere_map_report.max_area_ratio");
        assert_eq!(unsafe { addr_of!((*start).stretch_efficiency) } as usize - start as usize, 104, "obc_sphere_map_report.stretch_efficiency");
        assert_eq!(unsafe { addr_of!((*start).isometric_mean) } as usize - start as usize, 112, "obc_sphere_map_report.isometric_mean");
        assert_eq!(unsafe { addr_of!((*start).equation_3_1) } as usize - start as usize, 120, "obc_sphere_map_report.equation_3_1");
        assert_eq!(unsafe { addr_of!((*start).equation_3_2) } as usize - start as usize, 128, "obc_sphere_map_report.equation_3_2");
        assert_eq!(unsafe { addr_of!((*start).equation_3_3) } as usize - start as usize, 136, "obc_sphere_map_report.equation_3_3");
        assert_eq!(unsafe { addr_of!((*start).equation_3_4) } as usize - start as usize, 144, "obc_sphere_map_report.equation_3_4");
    }
}
