//! What `<orbicube/tetrahedra.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};
use crate::mesh::{obc_mesh, obc_surface};
use std::os::raw::{c_void};

/// A tetrahedral mesh.
#[repr(C)]
pub struct obc_tetrahedra {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Quality and size of tetrahedra. TetGen inserts vertices until the bounds are satisfied, except where the surface prevents it; its last
/// step, flips and moves for better angles, may exceed the bounds slightly at a few tetrahedra. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_tetrahedra_options {
    pub struct_size: u32,
    /// 1: every triangle is preserved; 0: TetGen may split edges and triangles, and, if no size
    /// is given, inserts at most 50,000 vertices and 20 for each vertex of the surface. Default: 1.
    pub keep_surface: i32,
    /// maximum ratio of circumradius to shortest edge, at least 1; 0: no vertices are inserted for quality. Default: 1.4.
    pub quality: f64,
    /// maximum volume, in the cubed unit of the surface; 0: no limit. Default: 0.
    pub max_volume: f64,
    /// approximate length of inner edges, in the unit of the surface; 0: that of the surface. Default: 0.
    pub edge_length: f64,
    /// Edge lengths at points, such as the vertices of the surface: the positive length size\_lengths\[i\] at the point x y z in
    /// size\_positions. The length elsewhere is the minimum over all points of length + size\_growth \* distance. The surface is not
    /// split for a size, even where it may be: beside it tetrahedra are as large as its triangles. obc\_tetrahedra\_fill reads the arrays
    /// and does not keep them; NULL is allowed for size\_count 0. Default: NULL.
    pub size_positions: *const f64,
    pub size_lengths: *const f64,
    /// number of points. Default: 0.
    pub size_count: usize,
    /// gradation: edge-length growth per unit distance, at least 0. Default: 0.3.
    pub size_growth: f64,
}

extern "C" {
    /// Fills options with the defaults.
    pub fn obc_tetrahedra_options_init(options: *mut obc_tetrahedra_options, struct_size: usize) -> i32;
    /// Fills a closed surface with tetrahedra. Its components may lie beside or within each other: points inside an odd number of them are
    /// solid, so that a component within a component bounds a cavity. The orientation of triangles has no effect. Vertices in no triangle remain
    /// without tetrahedra. Coordinates of any size and distance from the origin are allowed. options and host may be NULL; the
    /// allocator of the host must remain valid until \_destroy. Takes about 10 us and 1 KB a tetrahedron; the checks are O(n log n).
    /// Errors, found by exact arithmetic before TetGen runs: invalid argument; not closed; not manifold (kinds non-manifold-edge,
    /// non-manifold-vertex, duplicate-face, non-orientable, and self-intersection with the number of pairs and the first);
    /// degenerate (kinds degenerate-face, degenerate-geometry); malformed file (kind empty-mesh: no triangles). Others: no valid
    /// result (TetGen failed, with its reason, or its mesh failed the checks), unsupported, out of memory, cancelled.
    pub fn obc_tetrahedra_fill(surface: *const obc_surface, options: *const obc_tetrahedra_options, host: *const obc_host, out: *mut *mut obc_tetrahedra, error: *mut obc_error) -> i32;
    /// Fills a closed surface as obc\_tetrahedra\_fill does with the options max\_volume and else the defaults, into a mesh of \<orbicube/mesh.h\>: the
    /// function for options.fill of \<orbicube/hexmesh.h\>. user is unused and may be NULL; host may be NULL, its allocator must remain valid until
    /// obc\_mesh\_destroy. Errors: as obc\_tetrahedra\_fill.
    pub fn obc_tetrahedra_fill_mesh(surface: *const obc_surface, max_volume: f64, host: *const obc_host, out: *mut *mut obc_mesh, error: *mut obc_error, user: *mut c_void) -> i32;
    /// Destroys a mesh; NULL is allowed.
    pub fn obc_tetrahedra_destroy(solid: *mut obc_tetrahedra);
    /// Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    /// it was preserved), parts (components that share no face) and cavities; 0 for NULL.
    pub fn obc_tetrahedra_vertex_count(solid: *const obc_tetrahedra) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    /// it was preserved), parts (components that share no face) and cavities; 0 for NULL.
    pub fn obc_tetrahedra_count(solid: *const obc_tetrahedra) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    /// it was preserved), parts (components that share no face) and cavities; 0 for NULL.
    pub fn obc_tetrahedra_boundary_count(solid: *const obc_tetrahedra) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    /// it was preserved), parts (components that share no face) and cavities; 0 for NULL.
    pub fn obc_tetrahedra_part_count(solid: *const obc_tetrahedra) -> usize;
    /// Return the numbers of vertices (those of the surface, then inserted ones), tetrahedra, boundary triangles (those of the surface if
    /// it was preserved), parts (components that share no face) and cavities; 0 for NULL.
    pub fn obc_tetrahedra_cavity_count(solid: *const obc_tetrahedra) -> usize;
    /// Copies a mesh to arrays of the caller, each of which may be NULL: positions (x y z a vertex, bit-identical vertices of the surface
    /// first, in their order), tetrahedra (four vertices each, of positive volume by exact arithmetic), boundary (three vertices a
    /// triangle, outward-oriented; triangle i is triangle i of the surface, possibly reversed, if it was preserved) and
    /// boundary\_source (for each boundary triangle the surface triangle that contains it). Errors: invalid argument.
    pub fn obc_tetrahedra_copy(solid: *const obc_tetrahedra, positions: *mut f64, tetrahedra: *mut u32, boundary: *mut u32, boundary_source: *mut u32, error: *mut obc_error) -> i32;
    /// Checks whether a surface can be filled, as obc\_tetrahedra\_fill does first. Writes the first \`capacity\` pairs of intersecting triangles to
    /// pairs, two entries each, the lower triangle first, in ascending order; \*count is the number of all pairs, possibly more than
    /// capacity. pairs may be NULL for capacity 0, host may be NULL. Uses the threads of the host. O(n log n + pairs of overlapping
    /// boxes). Returns OBC\_OK or the errors of obc\_tetrahedra\_fill about the surface; pairs and count are also valid for the kind
    /// self-intersection, and count is 0 for all others.
    pub fn obc_tetrahedra_check_surface(surface: *const obc_surface, host: *const obc_host, pairs: *mut u32, capacity: usize, count: *mut usize, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
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
