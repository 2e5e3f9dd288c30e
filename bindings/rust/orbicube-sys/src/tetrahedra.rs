//! What `<orbicube/tetrahedra.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::obc_surface;

/// A solid made of tetrahedra.
#[repr(C)]
pub struct obc_tetrahedra {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// What tetrahedra should be like. TetGen adds vertices inside until they are, but where the surface stands in the way; its last
/// step, flips and moves for better angles, may overstep the bounds again by a little, in few places. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_tetrahedra_options {
    pub struct_size: u32,
    /// 1: every triangle stays as it is; 0: TetGen may cut edges and triangles. Default 1
    pub keep_surface: i32,
    /// largest ratio of circumradius to shortest edge, at least 1; 0: no vertices for quality. Default 1.4
    pub quality: f64,
    /// largest volume, in the units of the surface; 0: none. Default 0
    pub max_volume: f64,
    /// edges inside about this long, in the units of the surface; 0: as the surface has it. Default 0
    pub edge_length: f64,
    /// Lengths like edge\_length at some places only, as at the surface's vertices: size\_lengths\[i\], positive, at x y z in
    /// size\_positions. From each place edges may get longer by size\_growth in each unit of distance, and the shortest of all
    /// lengths that apply counts. size\_growth is at least 0, default 0.3; the arrays are read by obc\_tetrahedra\_fill and not kept,
    /// and may be NULL when size\_count is 0, the default. The surface is not cut for a size, also where it may be: beside it
    /// tetrahedra are as large as its triangles make them.
    pub size_positions: *const f64,
    pub size_lengths: *const f64,
    pub size_count: usize,
    pub size_growth: f64,
}

extern "C" {
    /// The defaults, which the members' comments give.
    pub fn obc_tetrahedra_options_init(options: *mut obc_tetrahedra_options, struct_size: usize) -> i32;
    /// Fills a surface. Its components may lie beside or within each other: what an odd number of them surrounds is solid, what an
    /// even number does is not, so a shell within a shell is a cavity. It does not matter which way triangles look. Vertices in no
    /// triangle stay, in no tetrahedron. Coordinates of any size and at any distance from the origin are fine.
    /// options and host may be NULL; the host's allocator must stay valid until \_destroy.
    /// Time and memory are TetGen's, about 10 us and 1 KB a tetrahedron; the checks are O(n log n).
    /// Errors: invalid argument; not closed, not manifold (kinds non-manifold-edge, non-manifold-vertex, duplicate-face,
    /// non-orientable, and self-intersection with the number of pairs of faces and the first), degenerate (kinds degenerate-face,
    /// degenerate-geometry), malformed file (kind empty-mesh: no triangles), each found by exact arithmetic before TetGen runs; no
    /// valid result (TetGen failed, the message says how, or what it made did not stand the checks), unsupported, out of memory,
    /// cancelled.
    pub fn obc_tetrahedra_fill(surface: *const obc_surface, options: *const obc_tetrahedra_options, host: *const obc_host, out: *mut *mut obc_tetrahedra, error: *mut obc_error) -> i32;
    /// Releases a solid; NULL is fine.
    pub fn obc_tetrahedra_destroy(solid: *mut obc_tetrahedra);
    /// Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    /// when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within.
    pub fn obc_tetrahedra_vertex_count(solid: *const obc_tetrahedra) -> usize;
    /// Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    /// when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within.
    pub fn obc_tetrahedra_count(solid: *const obc_tetrahedra) -> usize;
    /// Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    /// when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within.
    pub fn obc_tetrahedra_boundary_count(solid: *const obc_tetrahedra) -> usize;
    /// Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    /// when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within.
    pub fn obc_tetrahedra_part_count(solid: *const obc_tetrahedra) -> usize;
    /// Numbers of a solid; 0 for NULL. Vertices: those of the surface, then those added. Boundary triangles: those of the surface
    /// when it was kept. Parts: of the solid, that share no face. Cavities: empty regions within.
    pub fn obc_tetrahedra_cavity_count(solid: *const obc_tetrahedra) -> usize;
    /// Copies to the caller's arrays, each of which may be NULL: positions (x y z a vertex; the surface's vertices come first, to
    /// the bit and in its order), tetrahedra (four vertices each, of positive volume by exact arithmetic), boundary (three
    /// vertices a triangle, looking outward; triangle i is the surface's triangle i, perhaps turned round, when it was kept) and
    /// boundary\_source (for each boundary triangle the surface's triangle that it lies in). Errors: invalid argument.
    pub fn obc_tetrahedra_copy(solid: *const obc_tetrahedra, positions: *mut f64, tetrahedra: *mut u32, boundary: *mut u32, boundary_source: *mut u32, error: *mut obc_error) -> i32;
    /// Whether a surface can be filled, as obc\_tetrahedra\_fill asks it first. The first \`capacity\` pairs of triangles that meet where
    /// they should not are written to pairs, two entries each, the lower triangle first, in ascending order; \*count is how many there
    /// are, which may be more. pairs may be NULL when capacity is 0. Runs on the host's threads; host may be NULL.
    /// OBC\_OK, or the errors of obc\_tetrahedra\_fill about the surface; pairs and count are also valid with the kind
    /// self-intersection, and count is 0 with all others. O(n log n + pairs whose boxes overlap).
    pub fn obc_tetrahedra_check_surface(surface: *const obc_surface, host: *const obc_host, pairs: *mut u32, capacity: usize, count: *mut usize, error: *mut obc_error) -> i32;
    /// Version of this library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_tetrahedra_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_tetrahedra_options>(), align_of::<obc_tetrahedra_options>()), (64, 8));
        let it = MaybeUninit::<obc_tetrahedra_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_tetrahedra_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).keep_surface) } as usize - start as usize, 4, "obc_tetrahedra_options.keep_surface");
        assert_eq!(unsafe { addr_of!((*start).quality) } as usize - start as usize, 8, "obc_tetrahedra_options.quality");
        assert_eq!(unsafe { addr_of!((*start).max_volume) } as usize - start as usize, 16, "obc_tetrahedra_options.max_volume");
        assert_eq!(unsafe { addr_of!((*start).edge_length) } as usize - start as usize, 24, "obc_tetrahedra_options.edge_length");
        assert_eq!(unsafe { addr_of!((*start).size_positions) } as usize - start as usize, 32, "obc_tetrahedra_options.size_positions");
        assert_eq!(unsafe { addr_of!((*start).size_lengths) } as usize - start as usize, 40, "obc_tetrahedra_options.size_lengths");
        assert_eq!(unsafe { addr_of!((*start).size_count) } as usize - start as usize, 48, "obc_tetrahedra_options.size_count");
        assert_eq!(unsafe { addr_of!((*start).size_growth) } as usize - start as usize, 56, "obc_tetrahedra_options.size_growth");
    }
}
