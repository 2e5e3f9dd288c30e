//! What `<orbicube/untangle.h>` declares. Written by scripts/bindings.py; not to be edited.
#![allow(non_camel_case_types, non_upper_case_globals)]

use crate::base::{obc_error, obc_host};

/// An untangled mesh whose elements were split where that is needed.
#[repr(C)]
pub struct obc_untangle_refined {
    _private: [u8; 0],
    _marker: core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>,
}

/// Options. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_untangle_options {
    pub struct_size: u32,
    /// maximum number of Newton steps in each attempt, while elements are inverted. Default: 500.
    pub max_steps: i32,
    /// maximum number of further steps that lower the distortion and keep all elements positive. Default: 20.
    pub max_polish_steps: i32,
    /// 1: boundary vertices move unless they are in \`fixed\`; 0: they are fixed where no fixed ones are given. Default: 0.
    pub free_boundary: i32,
    /// weight of changes of volume, or of area, relative to changes of angles, positive. Default: 1.
    pub volume_weight: f64,
    /// polishing ends when a step lowers the energy by less than this fraction of it, 0 to below 1. Default: 1e-4.
    pub tolerance: f64,
}

/// Figures of a run. Determinants are those of the maps from the target shapes, scaled so that 1 preserves volume or area.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_untangle_report {
    pub struct_size: u32,
    /// first element that is not positive; UINT32\_MAX: none
    pub first_inverted: u32,
    /// number of elements that are not positive before and after, by exact arithmetic
    pub inverted_before: u64,
    /// number of elements that are not positive before and after, by exact arithmetic
    pub inverted: u64,
    /// number of steps taken
    pub steps: u64,
    /// number of steps taken
    pub polish_steps: u64,
    /// minimum and maximum determinant after
    pub min_determinant: f64,
    /// minimum and maximum determinant after
    pub max_determinant: f64,
    /// mean of |J|^2 / D^(2/d) + volume\_weight (1 + D^2) / D in d dimensions; with weight 1 at least d + 2
    pub energy: f64,
}

/// A tetrahedral mesh to untangle, with its constraints: a view of arrays of the caller. Coordinate 3 \* vertex + axis is that of an axis
/// of a vertex. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_untangle_tetrahedra_problem {
    pub struct_size: u32,
    pub reserved: i32,
    /// initial positions, x y z a vertex. Default: NULL, which must be set.
    pub positions: *const f64,
    /// number of vertices. Default: 0.
    pub vertex_count: usize,
    /// four vertices a tetrahedron; inverted ones have negative volume. Default: NULL, which must be set.
    pub tetrahedra: *const u32,
    /// number of tetrahedra. Default: 0.
    pub tetrahedron_count: usize,
    /// Rest positions, x y z a vertex, in which each tetrahedron is positive and has its target shape, of any size; NULL: the target
    /// shapes are regular tetrahedra of equal size. Default: NULL.
    pub rest: *const f64,
    /// one entry a vertex, nonzero for a fixed one; NULL, unless fixed\_coordinates is set or free\_boundary is
    /// nonzero: boundary vertices are fixed. Default: NULL.
    pub fixed: *const u8,
    /// one entry a coordinate, nonzero for one that is fixed besides; NULL: none. Default: NULL.
    pub fixed_coordinates: *const u8,
    /// Groups of equal coordinates: one entry a coordinate, the number of its group, below 3 \* vertex\_count, or UINT32\_MAX for none;
    /// NULL: no groups. A group with a fixed coordinate is fixed; any other group starts at its mean. Default: NULL.
    pub ties: *const u32,
}

/// A flat mesh of triangles to untangle, such as a map of a surface to the plane, with its constraints: a view of arrays of the caller.
/// Coordinate 2 \* vertex + axis is that of an axis of a vertex. Fill with \_init.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct obc_untangle_triangles_problem {
    pub struct_size: u32,
    pub reserved: i32,
    /// initial positions, x y a vertex. Default: NULL, which must be set.
    pub positions: *const f64,
    /// number of vertices. Default: 0.
    pub vertex_count: usize,
    /// three vertices a triangle, counter-clockwise unless inverted. Default: NULL, which must be set.
    pub triangles: *const u32,
    /// number of triangles. Default: 0.
    pub triangle_count: usize,
    /// Rest positions, x y z a vertex, in which each triangle has its target shape, of any size: the surface that is mapped, or a flat mesh with
    /// z = 0; NULL: the target shapes are equilateral triangles of equal size. Default: NULL.
    pub rest: *const f64,
    /// one entry a vertex, nonzero for a fixed one; NULL, unless fixed\_coordinates is set or free\_boundary is
    /// nonzero: boundary vertices are fixed. Default: NULL.
    pub fixed: *const u8,
    /// one entry a coordinate, nonzero for one that is fixed besides; NULL: none. Default: NULL.
    pub fixed_coordinates: *const u8,
    /// Groups of equal coordinates: one entry a coordinate, the number of its group, below 2 \* vertex\_count, or UINT32\_MAX for none;
    /// NULL: no groups. A group with a fixed coordinate is fixed; any other group starts at its mean. Default: NULL.
    pub ties: *const u32,
}

extern "C" {
    /// Fill options with the defaults, and a report with zeros.
    pub fn obc_untangle_options_init(options: *mut obc_untangle_options, struct_size: usize) -> i32;
    /// Fill options with the defaults, and a report with zeros.
    pub fn obc_untangle_report_init(report: *mut obc_untangle_report, struct_size: usize) -> i32;
    /// Fills a problem with no vertices.
    pub fn obc_untangle_tetrahedra_problem_init(problem: *mut obc_untangle_tetrahedra_problem, struct_size: usize) -> i32;
    /// Moves vertices until all tetrahedra are positive. result receives x y z a vertex and may be problem-\>positions; fixed coordinates are
    /// unchanged and tied ones have the same bits. A mesh without inverted tetrahedra is only polished. options, host and report may be
    /// NULL. Takes about 700 bytes a tetrahedron; a step is O(n) times up to 150 iterations of conjugate gradients; up to six attempts.
    /// Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
    /// errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    /// not manifold (kinds non-manifold-face and inconsistent-orientation: three tetrahedra at a face, or two on one side of it);
    /// malformed file (kind index-range); degenerate (kinds degenerate-cell and inverted-cell: a repeated vertex, a rest
    /// tetrahedron that is not positive; degenerate-geometry: zero volume); out of memory; cancelled.
    pub fn obc_untangle_tetrahedra(problem: *const obc_untangle_tetrahedra_problem, options: *const obc_untangle_options, host: *const obc_host, result: *mut f64, report: *mut obc_untangle_report, error: *mut obc_error) -> i32;
    /// Fills a problem with no vertices.
    pub fn obc_untangle_triangles_problem_init(problem: *mut obc_untangle_triangles_problem, struct_size: usize) -> i32;
    /// Moves vertices in the plane until all triangles are positive, counter-clockwise. result receives x y a vertex and may be
    /// problem-\>positions; fixed coordinates are unchanged and tied ones have the same bits. A mesh without inverted triangles is only polished.
    /// Where the boundary is a polygon without self-intersections and is fixed, the triangles of the result cover it without overlap. options,
    /// host and report may be NULL. Takes about 1 KB a triangle, and a sparse factor a step; up to six attempts.
    /// Errors: no valid result (some remain inverted: their number and the first; result and report then have the best mesh, all other
    /// errors leave result unchanged); invalid argument (NULL, not finite, options, ties that contradict each other or are out of range);
    /// not manifold (kinds non-manifold-edge and inconsistent-orientation: three triangles at an edge, or two on one side of it);
    /// malformed file (kind index-range); degenerate (kind degenerate-face: a repeated vertex, a target shape without area;
    /// degenerate-geometry: zero area); out of memory; cancelled.
    pub fn obc_untangle_triangles(problem: *const obc_untangle_triangles_problem, options: *const obc_untangle_options, host: *const obc_host, result: *mut f64, report: *mut obc_untangle_report, error: *mut obc_error) -> i32;
    /// Untangle as obc\_untangle\_tetrahedra and obc\_untangle\_triangles do and, where the mesh as it is has no solution or none is found, split
    /// elements: first all edges, faces and elements that join fixed vertices and are not in the boundary, then edges of elements that
    /// remain inverted. New vertices are free, also between fixed ones inside; the boundary is not split, nor is a mesh without inverted elements.
    /// A disk of triangles whose fixed boundary is a star-shaped polygon, all else being free and without ties, is always untangled, within the
    /// precision of coordinates. Elements that become positive by rounding alone, with determinants below 1e-9, are split too. options,
    /// host and report may be NULL; the allocator of the host must remain valid until \_destroy. The report counts elements after splits, but
    /// for inverted\_before. Takes the time and memory of those functions for up to ten meshes, of up to about eight times the elements.
    /// \*out is NULL after an error. Errors: as those functions; after no valid result the report has the figures of the best mesh found.
    pub fn obc_untangle_refine_tetrahedra(problem: *const obc_untangle_tetrahedra_problem, options: *const obc_untangle_options, host: *const obc_host, out: *mut *mut obc_untangle_refined, report: *mut obc_untangle_report, error: *mut obc_error) -> i32;
    /// Untangle as obc\_untangle\_tetrahedra and obc\_untangle\_triangles do and, where the mesh as it is has no solution or none is found, split
    /// elements: first all edges, faces and elements that join fixed vertices and are not in the boundary, then edges of elements that
    /// remain inverted. New vertices are free, also between fixed ones inside; the boundary is not split, nor is a mesh without inverted elements.
    /// A disk of triangles whose fixed boundary is a star-shaped polygon, all else being free and without ties, is always untangled, within the
    /// precision of coordinates. Elements that become positive by rounding alone, with determinants below 1e-9, are split too. options,
    /// host and report may be NULL; the allocator of the host must remain valid until \_destroy. The report counts elements after splits, but
    /// for inverted\_before. Takes the time and memory of those functions for up to ten meshes, of up to about eight times the elements.
    /// \*out is NULL after an error. Errors: as those functions; after no valid result the report has the figures of the best mesh found.
    pub fn obc_untangle_refine_triangles(problem: *const obc_untangle_triangles_problem, options: *const obc_untangle_options, host: *const obc_host, out: *mut *mut obc_untangle_refined, report: *mut obc_untangle_report, error: *mut obc_error) -> i32;
    /// Destroys a mesh; NULL is allowed.
    pub fn obc_untangle_refined_destroy(refined: *mut obc_untangle_refined);
    /// Return the number of vertices, of which those of the problem are the first, and of elements; 0 for NULL.
    pub fn obc_untangle_refined_vertex_count(refined: *const obc_untangle_refined) -> usize;
    /// Return the number of vertices, of which those of the problem are the first, and of elements; 0 for NULL.
    pub fn obc_untangle_refined_element_count(refined: *const obc_untangle_refined) -> usize;
    /// Copies the mesh to arrays of the caller, each of which may be NULL. d is 3 for tetrahedra and 2 for triangles. positions: d a vertex;
    /// elements: d + 1 vertices each; parents: for each element the one of the problem that it is part of; origins and weights: d + 1 a
    /// vertex, the vertices of the problem whose mean it is there, and their weights, which add up to 1 but for rounding; UINT32\_MAX with
    /// weight 0 for the rest. Errors: invalid argument.
    pub fn obc_untangle_refined_copy(refined: *const obc_untangle_refined, positions: *mut f64, elements: *mut u32, parents: *mut u32, origins: *mut u32, weights: *mut f64, error: *mut obc_error) -> i32;
    /// Returns the version of the library, major \* 10000 + minor \* 100 + patch.
    pub fn obc_untangle_version() -> u32;
}

#[cfg(all(test, target_pointer_width = "64"))]
mod layout {
    use super::*;
    use std::mem::{align_of, size_of, MaybeUninit};
    use std::ptr::addr_of;

    #[test]
    fn structs_lie_in_memory_as_in_c() {
        assert_eq!((size_of::<obc_untangle_options>(), align_of::<obc_untangle_options>()), (32, 8));
        let it = MaybeUninit::<obc_untangle_options>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_untangle_options.struct_size");
        assert_eq!(unsafe { addr_of!((*start).max_steps) } as usize - start as usize, 4, "obc_untangle_options.max_steps");
        assert_eq!(unsafe { addr_of!((*start).max_polish_steps) } as usize - start as usize, 8, "obc_untangle_options.max_polish_steps");
        assert_eq!(unsafe { addr_of!((*start).free_boundary) } as usize - start as usize, 12, "obc_untangle_options.free_boundary");
        assert_eq!(unsafe { addr_of!((*start).volume_weight) } as usize - start as usize, 16, "obc_untangle_options.volume_weight");
        assert_eq!(unsafe { addr_of!((*start).tolerance) } as usize - start as usize, 24, "obc_untangle_options.tolerance");
        assert_eq!((size_of::<obc_untangle_report>(), align_of::<obc_untangle_report>()), (64, 8));
        let it = MaybeUninit::<obc_untangle_report>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_untangle_report.struct_size");
        assert_eq!(unsafe { addr_of!((*start).first_inverted) } as usize - start as usize, 4, "obc_untangle_report.first_inverted");
        assert_eq!(unsafe { addr_of!((*start).inverted_before) } as usize - start as usize, 8, "obc_untangle_report.inverted_before");
        assert_eq!(unsafe { addr_of!((*start).inverted) } as usize - start as usize, 16, "obc_untangle_report.inverted");
        assert_eq!(unsafe { addr_of!((*start).steps) } as usize - start as usize, 24, "obc_untangle_report.steps");
        assert_eq!(unsafe { addr_of!((*start).polish_steps) } as usize - start as usize, 32, "obc_untangle_report.polish_steps");
        assert_eq!(unsafe { addr_of!((*start).min_determinant) } as usize - start as usize, 40, "obc_untangle_report.min_determinant");
        assert_eq!(unsafe { addr_of!((*start).max_determinant) } as usize - start as usize, 48, "obc_untangle_report.max_determinant");
        assert_eq!(unsafe { addr_of!((*start).energy) } as usize - start as usize, 56, "obc_untangle_report.energy");
        assert_eq!((size_of::<obc_untangle_tetrahedra_problem>(), align_of::<obc_untangle_tetrahedra_problem>()), (72, 8));
        let it = MaybeUninit::<obc_untangle_tetrahedra_problem>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_untangle_tetrahedra_problem.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_untangle_tetrahedra_problem.reserved");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_untangle_tetrahedra_problem.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 16, "obc_untangle_tetrahedra_problem.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).tetrahedra) } as usize - start as usize, 24, "obc_untangle_tetrahedra_problem.tetrahedra");
        assert_eq!(unsafe { addr_of!((*start).tetrahedron_count) } as usize - start as usize, 32, "obc_untangle_tetrahedra_problem.tetrahedron_count");
        assert_eq!(unsafe { addr_of!((*start).rest) } as usize - start as usize, 40, "obc_untangle_tetrahedra_problem.rest");
        assert_eq!(unsafe { addr_of!((*start).fixed) } as usize - start as usize, 48, "obc_untangle_tetrahedra_problem.fixed");
        assert_eq!(unsafe { addr_of!((*start).fixed_coordinates) } as usize - start as usize, 56, "obc_untangle_tetrahedra_problem.fixed_coordinates");
        assert_eq!(unsafe { addr_of!((*start).ties) } as usize - start as usize, 64, "obc_untangle_tetrahedra_problem.ties");
        assert_eq!((size_of::<obc_untangle_triangles_problem>(), align_of::<obc_untangle_triangles_problem>()), (72, 8));
        let it = MaybeUninit::<obc_untangle_triangles_problem>::uninit();
        let start = it.as_ptr();
        assert_eq!(unsafe { addr_of!((*start).struct_size) } as usize - start as usize, 0, "obc_untangle_triangles_problem.struct_size");
        assert_eq!(unsafe { addr_of!((*start).reserved) } as usize - start as usize, 4, "obc_untangle_triangles_problem.reserved");
        assert_eq!(unsafe { addr_of!((*start).positions) } as usize - start as usize, 8, "obc_untangle_triangles_problem.positions");
        assert_eq!(unsafe { addr_of!((*start).vertex_count) } as usize - start as usize, 16, "obc_untangle_triangles_problem.vertex_count");
        assert_eq!(unsafe { addr_of!((*start).triangles) } as usize - start as usize, 24, "obc_untangle_triangles_problem.triangles");
        assert_eq!(unsafe { addr_of!((*start).triangle_count) } as usize - start as usize, 32, "obc_untangle_triangles_problem.triangle_count");
        assert_eq!(unsafe { addr_of!((*start).rest) } as usize - start as usize, 40, "obc_untangle_triangles_problem.rest");
        assert_eq!(unsafe { addr_of!((*start).fixed) } as usize - start as usize, 48, "obc_untangle_triangles_problem.fixed");
        assert_eq!(unsafe { addr_of!((*start).fixed_coordinates) } as usize - start as usize, 56, "obc_untangle_triangles_problem.fixed_coordinates");
        assert_eq!(unsafe { addr_of!((*start).ties) } as usize - start as usize, 64, "obc_untangle_triangles_problem.ties");
    }
}
