//! What `<orbicube/sphere_map.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::{obc_mesh, obc_surface};
use std::os::raw::{c_char, c_void};

/// angle\_weight E\_D + area\_weight E\_A and a barrier on the worst triangle
pub const OBC_SPHERE_MAP_BALANCED: i32 = 0;
/// angle\_weight E\_D + area\_weight E\_A alone, to a local optimum
pub const OBC_SPHERE_MAP_ANGLE_AREA: i32 = 1;
/// the symmetric Dirichlet energy; the weights are not used, as in the next two
pub const OBC_SPHERE_MAP_ISOMETRIC: i32 = 2;
/// the L2 stretch of Praun and Hoppe
pub const OBC_SPHERE_MAP_STRETCH: i32 = 3;
/// E\_D alone
pub const OBC_SPHERE_MAP_CONFORMAL: i32 = 4;
/// the dissertation's chapter 3 as printed, mended only where it would fail
pub const OBC_SPHERE_MAP_SEED: i32 = 5;

/// how often triangles are cut in four, 0 to 10; 10 \* 4^n + 2 vertices
pub const OBC_SPHERE_MAP_ICOSPHERE: i32 = 0;
/// quads along an edge of the cube, 1 to 4096; 6 n^2 + 2 vertices
pub const OBC_SPHERE_MAP_CUBE: i32 = 1;
/// bands from pole to pole, 2 to 8192; 2 n (n - 1) + 2 vertices
pub const OBC_SPHERE_MAP_LATITUDE: i32 = 2;
/// quads along a side of the square, even, 2 to 8192; n^2 + 2 vertices
pub const OBC_SPHERE_MAP_OCTAHEDRON: i32 = 3;

/// ---- The inverse: which triangle a direction lies in ----------------------------------------------------------------
/// The locator is a walk from triangle to triangle by exact determinants (Devillers, Pion and Teillaud 2002) that starts
/// near the direction; see docs/sphere\_map\_uses.md. A locator keeps copies of what it is made from. Any number of threads may
/// use one locator at once. Directions that are asked about are finite, not zero, and need not be of length 1: 3 \* count
/// doubles.
#[repr(C)]
pub struct obc_sphere_map_locator {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// A smooth bijection of the sphere that carries landmarks onto landmarks: the flow of least energy (Joshi and Miller 2000;
/// Glaunes, Vaillant and Miller 2004) on the vertices of an icosphere, every triangle positive by exact arithmetic. Any number
/// of threads may use one warp at once.
#[repr(C)]
pub struct obc_sphere_map_warp {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Told of the course of method seed (the dissertation's Figure 3.2) when a level ends, and at the end once in as many
/// iterations as there are vertices: iterations, its Algorithm 2 called for one vertex each; the vertices of the mesh as it is
/// refined so far; the energy of that mesh. iterations begin from 0 again when the map has to be begun anew. Called on the
/// thread that called the library.
pub type obc_sphere_map_trace_function = Option<unsafe extern "C" fn(iterations: u64, vertices: u64, energy: f64, user: *mut c_void)>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_map_options {
    pub struct_size: u32,
    /// OBC\_SPHERE\_MAP\_...; balanced by default
    pub method: i32,
    /// positive; 0.1 by default
    pub angle_weight: f64,
    /// not negative; 1 by default
    pub area_weight: f64,
    /// varies the order of equally good decimation steps; 0 by default
    pub seed: u64,
    /// of method seed; NULL by default: not wanted
    pub trace: obc_sphere_map_trace_function,
    pub trace_user: *mut c_void,
}

/// Figures of a map. The surface counts as scaled to the area of the unit sphere, 4 pi. sigma are the singular values of the
/// affine map from a surface triangle to its flat spherical triangle t, d is the distance of t from the origin.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_map_report {
    pub struct_size: u32,
    /// 1: no triangle flipped or degenerate, by exact arithmetic, and degree 1; else 0
    pub bijective: i32,
    /// 1: most triangles are clockwise on the sphere, as for a surface that looks inward
    pub mirrored: i32,
    pub reserved: i32,
    /// triangles oriented against the others, by exact arithmetic
    pub flipped: u64,
    /// triangles without area on the sphere, by exact arithmetic
    pub degenerate: u64,
    /// triangles without area on the surface: they have no distortion
    pub zero_area_faces: u64,
    /// sum of the signed solid angles / 4 pi
    pub degree: f64,
    /// E\_D = sum d^-2 (cot a |a|^2 + cot b |b|^2 + cot c |c|^2); at least 16 pi
    pub energy_angle: f64,
    /// E\_A = sum d^-2 area(t)^2 / area(T); at least 4 pi
    pub energy_area: f64,
    /// angle\_weight E\_D + area\_weight E\_A
    pub energy: f64,
    /// sigma\_1 / sigma\_2
    pub dilatation_largest: f64,
    /// weighted by surface area
    pub dilatation_mean: f64,
    /// solid angle / surface area of a triangle
    pub area_ratio_smallest: f64,
    /// solid angle / surface area of a triangle
    pub area_ratio_largest: f64,
    /// 1 / mean of (sigma\_1^-2 + sigma\_2^-2) / 2, weighted by surface area (L2 stretch)
    pub stretch_efficiency: f64,
    /// mean of (sigma\_1^2 + sigma\_2^2 + sigma\_1^-2 + sigma\_2^-2) / 4, by surface area
    pub isometric_mean: f64,
}

/// Distances from points of one surface (vertices and centroids) to the nearest point of the other, and back.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_sphere_map_distance {
    pub struct_size: u32,
    pub reserved: u32,
    /// from the first surface
    pub first_mean: f64,
    /// from the first surface
    pub first_root_mean_square: f64,
    /// from the first surface
    pub first_largest: f64,
    /// from the second one
    pub second_mean: f64,
    /// from the second one
    pub second_root_mean_square: f64,
    /// from the second one
    pub second_largest: f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_sphere_map_options_init(options: *mut obc_sphere_map_options, struct_size: usize) -> i32;
    /// Fills a report with zeros and its size, which obc\_sphere\_map\_compute and \_measure need.
    pub fn obc_sphere_map_report_init(report: *mut obc_sphere_map_report, struct_size: usize) -> i32;
    /// Maps a closed, connected, oriented genus-0 surface to unit vectors, one a vertex in the same order. A surface that looks
    /// inward is mapped as seen from outside: its triangles are then clockwise on the sphere. Vertices in no triangle get some
    /// unit vector.
    /// options, report and host may be NULL. directions: 3 \* vertex\_count doubles, written on success only.
    /// O(n log n) time, at most 1 KB a vertex.
    /// Errors: OBC\_INVALID\_ARGUMENT (NULL, NaN, index out of range, options), OBC\_NOT\_CLOSED, OBC\_NOT\_MANIFOLD,
    /// OBC\_WRONG\_GENUS, OBC\_DEGENERATE, OBC\_NO\_VALID\_RESULT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_compute(surface: *const obc_surface, options: *const obc_sphere_map_options, host: *const obc_host, directions: *mut f64, report: *mut obc_sphere_map_report, error: *mut obc_error) -> i32;
    /// As obc\_sphere\_map\_compute, and when that ends with OBC\_NO\_VALID\_RESULT or OBC\_CANCELLED, directions get what there is of the
    /// map that came furthest: \*placed vertices have places of their own, and their triangles are positive by exact arithmetic
    /// (clockwise for a surface that looks inward); each other vertex is where the one is that it was merged into, so that its
    /// triangles have no area. With \*placed as many as there are vertices in triangles it is a bijection that is not optimised to
    /// the end. \*placed is 0, and directions are untouched, when the work did not come so far and for other errors. report is
    /// written on success only; obc\_sphere\_map\_measure measures partial maps.
    /// Errors: as obc\_sphere\_map\_compute.
    pub fn obc_sphere_map_compute_partial(surface: *const obc_surface, options: *const obc_sphere_map_options, host: *const obc_host, directions: *mut f64, placed: *mut usize, report: *mut obc_sphere_map_report, error: *mut obc_error) -> i32;
    /// Measures a map: directions (3 \* vertex\_count doubles, normalised before use) of the surface. Only the weights of
    /// options are used; options and host may be NULL. O(n).
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY. A bad map is no error: see report-\>bijective.
    pub fn obc_sphere_map_measure(surface: *const obc_surface, directions: *const f64, options: *const obc_sphere_map_options, host: *const obc_host, report: *mut obc_sphere_map_report, error: *mut obc_error) -> i32;
    /// Distortion of each triangle, for colouring: dilatation and area\_ratio as in the report, triangle\_count doubles each;
    /// either may be NULL. Triangles without surface area have an infinite dilatation and the ratio 0. O(n).
    /// Errors: as obc\_sphere\_map\_measure.
    pub fn obc_sphere_map_face_distortion(surface: *const obc_surface, directions: *const f64, host: *const obc_host, dilatation: *mut f64, area_ratio: *mut f64, error: *mut obc_error) -> i32;
    /// Rounds a map to float32, the precision of engines and of GLB, and repairs the triangles that this turns over by moving
    /// their vertices to nearby points. rounded: 3 \* vertex\_count floats, positive by exact arithmetic on success.
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_NO\_VALID\_RESULT (the map cannot be held in float32), OBC\_CANCELLED,
    /// OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_round_to_float(surface: *const obc_surface, directions: *const f64, host: *const obc_host, rounded: *mut f32, error: *mut obc_error) -> i32;
    /// From a map that is a bijection (every triangle positive by exact arithmetic, or every triangle negative), with directions
    /// of length 0.5 to 2. Only triangles and counts of the surface are used; its positions may be NULL. host may be NULL; its
    /// allocator is kept until obc\_sphere\_map\_locator\_destroy. O(n) time, about 100 bytes a vertex.
    /// Errors: OBC\_INVALID\_ARGUMENT (also for what is no bijection), OBC\_NOT\_CLOSED, OBC\_NOT\_MANIFOLD, OBC\_DEGENERATE,
    /// OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_locator_create(surface: *const obc_surface, directions: *const f64, host: *const obc_host, out: *mut *mut obc_sphere_map_locator, error: *mut obc_error) -> i32;
    /// NULL is fine.
    pub fn obc_sphere_map_locator_destroy(locator: *mut obc_sphere_map_locator);
    /// For each direction the triangle that it lies in, exactly; on an edge or a vertex, the lowest of the triangles there. weights:
    /// where the ray along the direction meets the flat triangle of the map, as shares of its three corners, not negative, with
    /// the sum 1; exactly 0 where the direction lies on the opposite edge. triangles: count indices, or NULL; weights: 3 \* count
    /// doubles, or NULL. On the threads of the host (or NULL). On failure what is written is of no use.
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_locate(locator: *const obc_sphere_map_locator, directions: *const f64, count: usize, host: *const obc_host, triangles: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Positions, normals, colours or other values of the vertices, interpolated where each direction lies. values: components \*
    /// vertex\_count doubles; sampled: components \* count. With unit 1 each result is scaled to length 1 (for normals), with 0
    /// not. The direction of a vertex gives the vertex's own values.
    /// Errors: as obc\_sphere\_map\_locate.
    pub fn obc_sphere_map_sample(locator: *const obc_sphere_map_locator, directions: *const f64, count: usize, values: *const f64, components: usize, unit: i32, host: *const obc_host, sampled: *mut f64, error: *mut obc_error) -> i32;
    /// Unit normals of the vertices, 3 \* vertex\_count doubles: the triangles' normals weighted by their angles (Thuermer and
    /// Wuethrich 1998). O(n).
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_vertex_normals(surface: *const obc_surface, host: *const obc_host, normals: *mut f64, error: *mut obc_error) -> i32;
    /// The triangulation alone, positions being unit vectors. \*out is released with obc\_mesh\_destroy; host's allocator is kept until
    /// then. O(size). Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_grid(grid: i32, resolution: usize, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// The surface resampled on a triangulation: positions (3 \* vertex\_count doubles) at its directions. Else as
    /// obc\_sphere\_map\_grid.
    pub fn obc_sphere_map_remesh(locator: *const obc_sphere_map_locator, positions: *const f64, grid: i32, resolution: usize, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error) -> i32;
    /// Fills a result with zeros and its size.
    pub fn obc_sphere_map_distance_init(distance: *mut obc_sphere_map_distance, struct_size: usize) -> i32;
    /// On the threads of the host. O(n log n). Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_surface_distance(first: *const obc_surface, second: *const obc_surface, host: *const obc_host, distance: *mut obc_sphere_map_distance, error: *mut obc_error) -> i32;
    /// Geometry images (Gu, Gortler and Hoppe 2002; Praun and Hoppe 2003): the surface as pixels x y z, 3 \* width \* height doubles,
    /// row by row from the top. OBC\_SPHERE\_MAP\_OCTAHEDRON is a square of (resolution + 1)^2 pixels, OBC\_SPHERE\_MAP\_CUBE six tiles
    /// of as many, 3 by 2: +x -x +y, below -y +z -z. Pixels that the cut tears apart are the same. resolution: at most 4096.
    pub fn obc_sphere_map_image_size(layout: i32, resolution: usize, width: *mut usize, height: *mut usize, error: *mut obc_error) -> i32;
    /// positions: 3 \* vertex\_count doubles (or other vectors of the vertices). pixels: written on success only.
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_image(locator: *const obc_sphere_map_locator, positions: *const f64, layout: i32, resolution: usize, host: *const obc_host, pixels: *mut f64, error: *mut obc_error) -> i32;
    /// The closed surface back. seam\_gap, or NULL: the greatest distance between pixels that are one vertex, which becomes their
    /// mean. Errors: OBC\_INVALID\_ARGUMENT (also a pixel that is not finite), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_image_surface(pixels: *const f64, layout: i32, resolution: usize, host: *const obc_host, out: *mut *mut obc_mesh, seam_gap: *mut f64, error: *mut obc_error) -> i32;
    /// Files by the ending: .pfm (float32) or .png (16 bits a channel between the corners of the bounding box, which a text chunk
    /// holds). Written whole or not at all. Errors: OBC\_INVALID\_ARGUMENT, OBC\_UNSUPPORTED, OBC\_IO, OBC\_CANCELLED,
    /// OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_image_write(path: *const c_char, pixels: *const f64, layout: i32, resolution: usize, host: *const obc_host, error: *mut obc_error) -> i32;
    /// Says what is in a file; with pixels not NULL, of \`capacity\` doubles, reads it too. PNG files without the chunk fill the cube
    /// from 0 to 1. Errors: as for writing, and OBC\_MALFORMED\_FILE.
    pub fn obc_sphere_map_image_read(path: *const c_char, host: *const obc_host, layout: *mut i32, resolution: *mut usize, pixels: *mut f64, capacity: usize, error: *mut obc_error) -> i32;
    /// The rotation, row by row, that takes \`from\` nearest to \`to\` (least squares; Kabsch 1976): 3 \* count doubles each, scaled
    /// to length 1. What the pairs leave open is turned as little as can be. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_sphere_map_best_rotation(from: *const f64, to: *const f64, count: usize, rotation: *mut f64, error: *mut obc_error) -> i32;
    /// from\[i\] goes to to\[i\]: 3 \* count doubles each, of any length, no two of them nearer than 0.01. host's allocator is kept.
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_NO\_VALID\_RESULT (the ways of two landmarks meet), OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_warp_create(from: *const f64, to: *const f64, count: usize, host: *const obc_host, out: *mut *mut obc_sphere_map_warp, error: *mut obc_error) -> i32;
    /// NULL is fine.
    pub fn obc_sphere_map_warp_destroy(warp: *mut obc_sphere_map_warp);
    /// Where each direction goes (backward 0) or comes from (backward 1): 3 \* count doubles; moved may be directions itself.
    /// Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_sphere_map_warp_apply(warp: *const obc_sphere_map_warp, directions: *const f64, count: usize, backward: i32, host: *const obc_host, moved: *mut f64, error: *mut obc_error) -> i32;
    /// One triangulation of the sphere with the vertices of two maps: the second's are inserted into the triangles of the first,
    /// whose edges stay; vertices at the same direction become one. Only triangles and counts of the surfaces are used. The first
    /// vertices of \*out (positions: unit vectors) are those of the first map, in its order; second\_vertex, second's vertex\_count
    /// indices or NULL, says where those of the second are (UINT32\_MAX: in no triangle). Every triangle is positive.
    /// Errors: as obc\_sphere\_map\_locator\_create, for the first map.
    pub fn obc_sphere_map_overlay(first: *const obc_surface, first_directions: *const f64, second: *const obc_surface, second_directions: *const f64, host: *const obc_host, out: *mut *mut obc_mesh, second_vertex: *mut u32, error: *mut obc_error) -> i32;
    /// Version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_sphere_map_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_sphere_map_options>(), align_of::<obc_sphere_map_options>()), (48, 8));
        let it = MaybeUninit::<obc_sphere_map_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_map_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).method) } as usize - start as usize, 4, "obc_sphere_map_options.method");
        assert_eq!(unsafe { addr_of!((*start).angle_weight) } as usize - start as usize, 8, "obc_sphere_map_options.angle_weight");
        assert_eq!(unsafe { addr_of!((*start).area_weight) } as usize - start as usize, 16, "obc_sphere_map_options.area_weight");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 24, "obc_sphere_map_options.seed");
        assert_eq!(unsafe { addr_of!((*start).trace) } as usize - start as usize, 32, "obc_sphere_map_options.trace");
        assert_eq!(unsafe { addr_of!((*start).trace_user) } as usize - start as usize, 40, "obc_sphere_map_options.trace_user");
        assert_eq!((size_of::<obc_sphere_map_report>(), align_of::<obc_sphere_map_report>()), (120, 8));
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
        assert_eq!(unsafe { addr_of!((*start).dilatation_largest) } as usize - start as usize, 72, "obc_sphere_map_report.dilatation_largest");
        assert_eq!(unsafe { addr_of!((*start).dilatation_mean) } as usize - start as usize, 80, "obc_sphere_map_report.dilatation_mean");
        assert_eq!(unsafe { addr_of!((*start).area_ratio_smallest) } as usize - start as usize, 88, "obc_sphere_map_report.area_ratio_smallest");
        assert_eq!(unsafe { addr_of!((*start).area_ratio_largest) } as usize - start as usize, 96, "obc_sphere_map_report.area_ratio_largest");
        assert_eq!(unsafe { addr_of!((*start).stretch_efficiency) } as usize - start as usize, 104, "obc_sphere_map_report.stretch_efficiency");
        assert_eq!(unsafe { addr_of!((*start).isometric_mean) } as usize - start as usize, 112, "obc_sphere_map_report.isometric_mean");
        assert_eq!((size_of::<obc_sphere_map_distance>(), align_of::<obc_sphere_map_distance>()), (56, 8));
        let it = MaybeUninit::<obc_sphere_map_distance>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_sphere_map_distance.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_sphere_map_distance.reserved");
        assert_eq!(unsafe { addr_of!((*start).first_mean) } as usize - start as usize, 8, "obc_sphere_map_distance.first_mean");
        assert_eq!(unsafe { addr_of!((*start).first_root_mean_square) } as usize - start as usize, 16, "obc_sphere_map_distance.first_root_mean_square");
        assert_eq!(unsafe { addr_of!((*start).first_largest) } as usize - start as usize, 24, "obc_sphere_map_distance.first_largest");
        assert_eq!(unsafe { addr_of!((*start).second_mean) } as usize - start as usize, 32, "obc_sphere_map_distance.second_mean");
        assert_eq!(unsafe { addr_of!((*start).second_root_mean_square) } as usize - start as usize, 40, "obc_sphere_map_distance.second_root_mean_square");
        assert_eq!(unsafe { addr_of!((*start).second_largest) } as usize - start as usize, 48, "obc_sphere_map_distance.second_largest");
    }
}
