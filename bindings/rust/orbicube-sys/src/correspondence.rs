//! What `<orbicube/correspondence.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;

/// spheres: two to 100 surfaces of genus 0
pub const OBC_CORRESPONDENCE_SPHERE: i32 = 0;
/// one polycube: two to ten surfaces of one genus
pub const OBC_CORRESPONDENCE_POLYCUBE: i32 = 1;

/// to maximum correlation of the positions, for any poses of the surfaces
pub const OBC_CORRESPONDENCE_ALIGN_SHAPE: i32 = 0;
/// to maximum correlation of the positions, for equal poses
pub const OBC_CORRESPONDENCE_ALIGN_ROTATION: i32 = 1;
/// none
pub const OBC_CORRESPONDENCE_ALIGN_NONE: i32 = 2;

/// the vertices of all surfaces; with a polycube, its grid
pub const OBC_CORRESPONDENCE_GRID_BOTH: i32 = 0;
/// the triangles of the first surface; with a polycube, as its map splits them
pub const OBC_CORRESPONDENCE_GRID_FIRST: i32 = 1;
/// Grids of the sphere, of \`resolution\` as in obc\_sphere\_map\_grid; not with a polycube:
pub const OBC_CORRESPONDENCE_GRID_ICOSPHERE: i32 = 2;
pub const OBC_CORRESPONDENCE_GRID_CUBE: i32 = 3;
pub const OBC_CORRESPONDENCE_GRID_LATITUDE: i32 = 4;
pub const OBC_CORRESPONDENCE_GRID_OCTAHEDRON: i32 = 5;

/// as given
pub const OBC_CORRESPONDENCE_KEPT: i32 = 0;
/// translated and rotated to the least-squares fit with the first (Umeyama 1991)
pub const OBC_CORRESPONDENCE_TURNED: i32 = 1;
/// scaled as well
pub const OBC_CORRESPONDENCE_SCALED: i32 = 2;

/// Surfaces on one triangulation.
#[repr(C)]
pub struct obc_correspondence {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Options of a correspondence. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_correspondence_options {
    pub struct_size: u32,
    /// OBC\_CORRESPONDENCE\_SPHERE or POLYCUBE. Default: SPHERE.
    pub via: i32,
    /// OBC\_CORRESPONDENCE\_ALIGN\_SHAPE, ROTATION or NONE; unused with a polycube. Default: SHAPE.
    pub align: i32,
    /// OBC\_CORRESPONDENCE\_GRID\_BOTH, FIRST or a grid of the sphere. Default: BOTH.
    pub grid: i32,
    /// OBC\_CORRESPONDENCE\_KEPT, TURNED or SCALED. Default: KEPT.
    pub placement: i32,
    /// 0
    pub reserved: i32,
    /// maximum deviation of an edge of GRID\_BOTH from a further surface, in percent of the diagonal of that surface's
    /// bounding box; longer edges are bisected, up to three times the vertices; 0: no limit; unused with a polycube.
    /// Default: 0.2.
    pub tolerance: f64,
    /// number of quads of a polycube's grid, at most 100000000; 0: the maximum triangle count of the surfaces, 20000 to
    /// 400000. Default: 0.
    pub cells: usize,
    /// maximum number of polycube corners, at most 1000000; 0: no limit. Default: 0.
    pub corners: usize,
    /// seed of the maps. Default: 0.
    pub seed: u64,
    /// of a grid of the sphere. Default: 0.
    pub resolution: usize,
    /// number of landmarks of each surface; on spheres they replace \`align\`. Default: 0.
    pub landmark_count: usize,
    /// x y z of the landmarks of each surface, one surface after the other; landmarks of one number
    /// correspond. The nearest point of the surface counts. Default: NULL.
    pub landmarks: *const f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_correspondence_options_init(options: *mut obc_correspondence_options, struct_size: usize) -> i32;
    /// Brings closed surfaces onto one triangulation, whose vertex i is at corresponding points of all. Triangles are oriented consistently
    /// and outward first. options and host may be NULL. \*out is NULL after an error; the allocator of the host is used until the handle is
    /// destroyed. Errors: OBC\_INVALID\_ARGUMENT, OBC\_NOT\_CLOSED, OBC\_NOT\_MANIFOLD, OBC\_WRONG\_GENUS, OBC\_DEGENERATE, OBC\_MALFORMED\_FILE (kind
    /// empty-mesh: no triangles), OBC\_NO\_VALID\_RESULT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_correspondence_create(surfaces: *const obc_surface, count: usize, options: *const obc_correspondence_options, host: *const obc_host, out: *mut *mut obc_correspondence, error: *mut obc_error) -> i32;
    /// Destroys a correspondence; NULL is allowed.
    pub fn obc_correspondence_destroy(correspondence: *mut obc_correspondence);
    /// Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL.
    pub fn obc_correspondence_shape_count(correspondence: *const obc_correspondence) -> usize;
    /// Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL.
    pub fn obc_correspondence_vertex_count(correspondence: *const obc_correspondence) -> usize;
    /// Return the number of surfaces, and of vertices and triangles of the triangulation; 0 for NULL.
    pub fn obc_correspondence_triangle_count(correspondence: *const obc_correspondence) -> usize;
    /// Copies the triangulation to arrays of the caller, each of which may be NULL: positions on surface number \`shape\` (3 \* vertex count),
    /// and triangles (3 \* triangle count). Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_correspondence_copy(correspondence: *const obc_correspondence, shape: usize, positions: *mut f64, triangles: *mut u32, error: *mut obc_error) -> i32;
    /// Blends the surfaces: writes the sum of their positions times weights (\`count\` finite numbers, one a surface) to positions (3 \* vertex
    /// count). A weight of 1 for one surface and 0 for all others returns its positions. Errors: OBC\_INVALID\_ARGUMENT, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_correspondence_blend(correspondence: *const obc_correspondence, weights: *const f64, count: usize, positions: *mut f64, error: *mut obc_error) -> i32;
    /// Copies the positions of the vertices on the common sphere (unit vectors) or polycube (3 \* vertex count). Every triangle is positive
    /// there, by exact signs. Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_correspondence_copy_domain(correspondence: *const obc_correspondence, positions: *mut f64, error: *mut obc_error) -> i32;
    /// Returns the number of quads of the polycube's grid, of which triangles 2 q and 2 q + 1 are the halves; 0 for other triangulations
    /// and for NULL.
    pub fn obc_correspondence_quad_count(correspondence: *const obc_correspondence) -> usize;
    /// Copies the quads (four vertex indices each, counter-clockwise seen from outside). Errors: OBC\_INVALID\_ARGUMENT.
    pub fn obc_correspondence_copy_quads(correspondence: *const obc_correspondence, quads: *mut u32, error: *mut obc_error) -> i32;
    /// Returns the number of vertices of surface number \`shape\` as it was given; 0 if there is none.
    pub fn obc_correspondence_surface_vertex_count(correspondence: *const obc_correspondence, shape: usize) -> usize;
    /// Maps \`count\` points of surface \`from\` to surface \`to\`: the inverse of the map of \`to\` after the map of \`from\`, one to one. A point
    /// is a triangle of the surface as it was given and three weights at its corners, nonnegative with sum 1; results may overwrite the
    /// points. Options of placement do not matter. host may be NULL. Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_correspondence_map(correspondence: *const obc_correspondence, from: usize, to: usize, triangles: *const u32, weights: *const f64, count: usize, host: *const obc_host, mapped_triangles: *mut u32, mapped_weights: *mut f64, error: *mut obc_error) -> i32;
    /// The same for all vertices of surface \`from\` (obc\_correspondence\_surface\_vertex\_count); a vertex in no triangle gets UINT32\_MAX and
    /// weights of 0. Errors: OBC\_INVALID\_ARGUMENT, OBC\_CANCELLED, OBC\_OUT\_OF\_MEMORY.
    pub fn obc_correspondence_map_vertices(correspondence: *const obc_correspondence, from: usize, to: usize, host: *const obc_host, mapped_triangles: *mut u32, mapped_weights: *mut f64, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_correspondence_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_correspondence_options>(), align_of::<obc_correspondence_options>()), (80, 8));
        let it = MaybeUninit::<obc_correspondence_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_correspondence_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).via) } as usize - start as usize, 4, "obc_correspondence_options.via");
        assert_eq!(unsafe { addr_of!((*start).align) } as usize - start as usize, 8, "obc_correspondence_options.align");
        assert_eq!(unsafe { addr_of!((*start).grid) } as usize - start as usize, 12, "obc_correspondence_options.grid");
        assert_eq!(unsafe { addr_of!((*start).placement) } as usize - start as usize, 16, "obc_correspondence_options.placement");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 20, "obc_correspondence_options.reserved");
        assert_eq!(unsafe { addr_of!((*start).tolerance) } as usize - start as usize, 24, "obc_correspondence_options.tolerance");
        assert_eq!(unsafe { addr_of!((*start).cells) } as usize - start as usize, 32, "obc_correspondence_options.cells");
        assert_eq!(unsafe { addr_of!((*start).corners) } as usize - start as usize, 40, "obc_correspondence_options.corners");
        assert_eq!(unsafe { addr_of!((*start).seed) } as usize - start as usize, 48, "obc_correspondence_options.seed");
        assert_eq!(unsafe { addr_of!((*start).resolution) } as usize - start as usize, 56, "obc_correspondence_options.resolution");
        assert_eq!(unsafe { addr_of!((*start).landmark_count) } as usize - start as usize, 64, "obc_correspondence_options.landmark_count");
        assert_eq!(unsafe { addr_of!((*start).landmarks) } as usize - start as usize, 72, "obc_correspondence_options.landmarks");
    }
}
